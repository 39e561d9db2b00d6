"""The last thing that happens to printed code: lines that are too long for a screen go on in further ones.

Lines are broken at blanks, never inside of a name or a number; strings are put together again by the language, lines of
the preprocessor go on behind a backslash, comments stay comments. What a compiler reads is the same.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping

MOST = 120  # characters of a line
WITHIN = 116  # of lines that are broken: a backslash fits behind them
STEP = "    "  # what further lines of a statement are indented by
ATOM = re.compile(r'(?:"(?:\\.|[^"\\])*"|[^\s"])+')  # what holds together: blanks in strings are no blanks
STRING = re.compile(r'"(?:\\.|[^"\\])*"')
COMMENT = re.compile(r"(?:/\*|\*(?= |$)|///?!?)")
# how a string goes on in another line: what ends its first part, and what begins the next
STRINGS: Mapping[str, tuple[str, str]] = {
    **dict.fromkeys(("c", "h", "hpp", "cpp", "cu", "js"), ('"', '"')), "rs": ("\\", ""), "mo": ('" +', '"'),
}  # fmt: skip


def within_width(file: str, text: str) -> str:
    """The text of a file; in a language whose lines can be broken, none of them is too long.

    >>> print(within_width("a.c", f"int a = {'one + ' * 30}two;").replace("one + ", ""))
    int a = one +
        two;
    """
    kind = file.rpartition(".")[2]
    if kind not in STRINGS or max(map(len, text.split("\n"))) <= MOST:
        return text
    found: list[str] = []
    inside = False  # a comment
    for line in text.split("\n"):
        spliced = line.lstrip().startswith("#") or (bool(found) and found[-1].endswith("\\"))
        if len(line) <= MOST:
            found.append(line)
        elif inside or COMMENT.match(line.lstrip()):
            found += _spliced(_comment(line, inside=inside)) if spliced else _comment(line, inside=inside)
        elif spliced:
            goes_on = line.endswith("\\")
            parts = _spliced(_code(line.rstrip("\\ "), *STRINGS[kind]))
            found += [*parts[:-1], f"{parts[-1]} \\" if goes_on else parts[-1]]
        else:
            found += _code(line, *STRINGS[kind])
        opened, closed = line.rfind("/*"), line.rfind("*/")
        inside = opened > closed if max(opened, closed) >= 0 else inside
    return "\n".join(found)


def _spliced(parts: list[str]) -> list[str]:
    """Parts of a line of the preprocessor, which goes on behind backslashes."""
    return [*(f"{part} \\" for part in parts[:-1]), parts[-1]]


def _comment(line: str, *, inside: bool) -> list[str]:
    text = line.lstrip()
    indent = line[: len(line) - len(text)]
    mark = COMMENT.match(text)
    later = "" if not mark or (inside and mark[0] != "*") else "   " if mark[0] == "/*" else f"{mark[0]} "
    wrapper = textwrap.TextWrapper(WITHIN, indent, indent + later, break_long_words=False, break_on_hyphens=False)
    return wrapper.wrap(text)


def _code(line: str, end: str, begin: str) -> list[str]:
    """A statement, and behind it what is said of it, in a line of its own where there is no room."""
    code, mark, said = line.rpartition(" /*") if line.endswith("*/") else (line, "", "")
    body = code.lstrip()
    later = code[: len(code) - len(body)] + STEP
    lines = [code[: len(code) - len(body)]]
    for atom in ATOM.findall(body):
        if not lines[-1].strip():
            lines[-1] += atom
        elif len(lines[-1]) + 1 + len(atom) <= WITHIN:
            lines[-1] += f" {atom}"
        else:
            lines.append(later + atom)
    lines = [part for text in lines for part in _strings(text, later, end, begin)]
    if not mark:
        return lines
    if len(lines[-1]) + len(mark) + len(said) <= WITHIN:
        return [*lines[:-1], lines[-1] + mark + said]
    return [*lines, *_comment(f"{later}/*{said}", inside=False)]


def _strings(line: str, later: str, end: str, begin: str) -> list[str]:
    """A line whose only fault is a long string, as lines with its parts."""
    found = STRING.search(line)
    if len(line) <= WITHIN or not found:
        return [line]
    at = line.rfind(" ", found.start() + 2, WITHIN - len(end))
    if at < 0:
        return [line]
    return [f"{line[: at + 1]}{end}", *_strings(f"{later}{begin}{line[at + 1 :]}", later, end, begin)]
