"""The text of a report for a terminal: whole where it is short, else cut where least is lost.

sections --long lines cut, then ever fewer lines a section--> at most `SHORT` letters, with what is missing said
"""

from __future__ import annotations

from collections.abc import Sequence

SHORT = 4500
"""Letters of a short text: with the head and the last line of the command under 5 kB, two screens."""
LINE = 240
"""Letters of a line that is longer: three lines of a terminal, in which a screw in words or a sum of six terms fits."""
HEADING = 120
"""Letters of a heading: of 30 names a dozen."""
FIRST = "Mobility"
"""The section that is never cut in lines: the answer itself."""
COUNTS = (40, 24, 16, 12, 8, 6, 4, 3, 2, 1)
"""Lines a section keeps, tried in this order until the whole is short; then section by section as many more as fit."""
BEHIND = "--full"
Sections = Sequence[tuple[str, Sequence[str]]]


def plain_lines(said: Sections) -> list[str]:
    """Headings, and their lines indented."""
    return [line for heading, facts in said for line in (heading, *(f"    {fact}" for fact in facts))]


def shortened(said: Sections) -> list[str]:
    """The lines of the text, at most `SHORT` letters of them as long as the first section has no more."""
    lines = plain_lines(said)
    if _size(lines) <= SHORT:
        return lines
    cut = [(_cut(heading, HEADING), [_cut(fact, LINE) for fact in facts]) for heading, facts in said]
    for place, count in enumerate(COUNTS):
        lines = plain_lines([_fewer(heading, facts, count) for heading, facts in cut])
        if _size(lines) <= SHORT:
            lines = _filled(cut, place)
            break
    else:
        lines = plain_lines([(heading, [_cut(fact, LINE // 2) for fact in facts]) for heading, facts in
                             (_fewer(heading, facts, 1) for heading, facts in cut)])  # fmt: skip
    return [*lines, f"Cut to fit; the whole with {BEHIND}, in documents (--out) and in the JSON"]


def _filled(said: Sections, place: int) -> list[str]:
    """The lines with `COUNTS[place]` lines a section, and more of those where they fit, the first sections first."""
    counts = [COUNTS[place]] * len(said)
    best: list[str] = []
    for larger in (COUNTS[place], *reversed(COUNTS[:place])):
        for k in range(len(said)):
            tried = [*counts[:k], max(larger, counts[k]), *counts[k + 1 :]]
            lines = plain_lines([_fewer(*section, count) for section, count in zip(said, tried, strict=True)])
            if _size(lines) <= SHORT:
                counts, best = tried, lines
    return best


def _fewer(heading: str, facts: Sequence[str], count: int) -> tuple[str, list[str]]:
    left = len(facts) - count
    if heading == FIRST or left <= 1:
        return heading, list(facts)
    return heading, [*facts[:count], f"... and {left} more lines ({BEHIND})"]


def _cut(text: str, most: int) -> str:
    """The text up to a space before `most` letters, with dots where it ends."""
    if len(text) <= most:
        return text
    kept = text[: most - 4].rsplit(" ", 1)[0]
    return f"{kept} ..."


def _size(lines: Sequence[str]) -> int:
    return sum(len(line.encode()) + 1 for line in lines)
