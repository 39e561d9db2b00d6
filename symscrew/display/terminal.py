"""What the command line shows: text tables on stdout, progress on stderr."""

from __future__ import annotations

import os
import shutil
import sys
import textwrap
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Literal, TextIO

NARROW = 80
"""Columns of a terminal below which wide tables become paragraphs; from here on cells with several lines are read."""
PIPED = 60
"""Columns of what goes to a pipe or a file, where neither the shell (COLUMNS) nor a terminal says how many."""
MISSING = ("not installed", "not found", "no")


def colours(stream: TextIO) -> bool:
    """Whether to write colours: on a terminal that has them, unless NO_COLOR is set (no-color.org)."""
    return stream.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def print_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table on stdout: coloured and as wide as the terminal there, in Markdown's lines elsewhere.

    On a terminal too narrow for it every row is a paragraph, its words whole: names and commands can be copied.
    """
    if not colours(sys.stdout):
        print(fitting_table(header, rows))
        return
    wide = shutil.get_terminal_size().columns
    if wide < NARROW and wide < _natural_width(header, rows):
        print("\n".join(stacked(header, rows, wide)))
        return
    from rich.box import SIMPLE_HEAD
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    made = Table(box=SIMPLE_HEAD, header_style="bold cyan", pad_edge=False)
    for k, title in enumerate(header):
        numbers = all(_is_number(row[k]) for row in rows)
        side: Literal["right", "left"] = "right" if numbers else "left"
        made.add_column(title, justify=side, overflow="fold", style="bold" if k == 0 else "", no_wrap=k == 0)
    for row in rows:
        made.add_row(*(Text(cell, style="red" if cell in MISSING else "") for cell in row))
    Console().print(made)


def print_text(text: str) -> None:
    """Print words on stdout; on a terminal, and where COLUMNS says how wide, its lines are folded at blanks.

    Elsewhere lines stay whole: programs search them.
    """
    if sys.stdout.isatty() or os.environ.get("COLUMNS", "").isdecimal():
        text = folded(text, shutil.get_terminal_size().columns)
    print(text)


def folded(text: str, wide: int) -> str:
    """Lines of at most `wide` characters where blanks allow; what follows of a line stands deeper than its beginning.

    Rows of tables and words longer than that stay whole.

    >>> print(folded("  one two three", 10))
      one two
        three
    """
    lines = []
    for line in text.splitlines():
        indent = line[: len(line) - len(line.lstrip())]
        if len(line) <= wide or line.startswith("|"):
            lines.append(line)
            continue
        lines += textwrap.wrap(
            line.strip(), max(wide, len(indent) + 4), initial_indent=indent, subsequent_indent=f"{indent}  ",
            break_long_words=False, break_on_hyphens=False,
        )  # fmt: skip
    return "\n".join(lines)


def _natural_width(header: Sequence[str], rows: Sequence[Sequence[str]]) -> int:
    return max(map(len, aligned_table(header, rows).splitlines()))


def console_width() -> int:
    """Columns for text: of the terminal that reads it, at the end of a pipe as well; `PIPED` where there is none."""
    if not os.environ.get("COLUMNS", "").isdecimal():
        for stream in (sys.__stdout__, sys.__stderr__):
            try:
                return os.get_terminal_size(stream.fileno()).columns if stream else PIPED
            except (OSError, ValueError):  # no terminal; or none at all any more
                continue
    return shutil.get_terminal_size((PIPED, 24)).columns


def fitting_table(header: Sequence[str], rows: Sequence[Sequence[str]], wide: int | None = None) -> str:
    """`aligned_table` in at most `wide` columns (default: those of the console).

    Its cells are broken at blanks, those of the first column last; where words are too long, rows are paragraphs.

    >>> print(fitting_table(["name", "for"], [["seed", "two free turns"]], 19))
    | name | for      |
    |------|----------|
    | seed | two free |
    |      | turns    |
    """
    wide = console_width() if wide is None else wide
    lines = [header, *rows]
    widths = [max(len(line[k]) for line in lines) for k in range(len(header))]
    least = [max((len(word) for line in lines for word in line[k].split()), default=0) for k in range(len(header))]
    frame = 3 * len(header) + 1
    if sum(widths) + frame <= wide:
        return aligned_table(header, rows)
    if sum(least) + frame > wide:
        return "\n".join(stacked(header, rows, wide))
    while sum(widths) + frame > wide:
        wider = [k for k in range(len(widths)) if widths[k] > least[k]]
        widths[max(wider, key=lambda k: (k > 0, widths[k]))] -= 1
    made = [text for line in lines for text in _in_lines(line, widths)]
    made.insert(len(_in_lines(header, widths)), _rule(widths))
    return "\n".join(made)


def _in_lines(line: Sequence[str], widths: Sequence[int]) -> list[str]:
    """A row of a table whose cells are broken at blanks to these widths."""
    cells = [
        textwrap.wrap(cell, width, break_long_words=False, break_on_hyphens=False) if cell else []
        for cell, width in zip(line, widths, strict=True)
    ]
    high = max(1, *map(len, cells))
    return [_row([cell[k] if k < len(cell) else "" for cell in cells], widths) for k in range(high)]


def _row(cells: Sequence[str], widths: Sequence[int]) -> str:
    return "| " + " | ".join(str(cell).ljust(width) for cell, width in zip(cells, widths, strict=True)) + " |"


def _rule(widths: Sequence[int]) -> str:
    return "|" + "|".join("-" * (width + 2) for width in widths) + "|"


def stacked(header: Sequence[str], rows: Sequence[Sequence[str]], wide: int) -> list[str]:
    """A paragraph a row: its first cell, then the others with their titles, in lines of at most `wide` characters.

    >>> stacked(["part", "n", "of", "for"], [["gcc", "2", "3", "running the code"]], 16)
    ['gcc', '  n: 2, of: 3', '  for: running', '    the code']
    """
    lines = []
    for first, *rest in rows:
        lines += textwrap.wrap(first, wide, break_long_words=False, break_on_hyphens=False) or [""]
        alone = True  # whether the last line takes no further cell
        for title, cell in zip(header[1:], rest, strict=True):
            if not cell:
                continue
            text = f"{title}: {cell}"
            if not alone and len(lines[-1]) + 2 + len(text) <= wide:
                lines[-1] += f", {text}"
                continue
            made = textwrap.wrap(
                text, wide, initial_indent="  ", subsequent_indent="    ", break_long_words=False,
                break_on_hyphens=False,
            )  # fmt: skip
            alone = len(made) > 1
            lines += made
    return lines


def _is_number(text: str) -> bool:
    return text.lstrip("+-").replace(".", "", 1).isdigit()


def aligned_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table with aligned columns; it reads well as plain text too.

    >>> print(aligned_table(["name", "n"], [["seed", "2"]]))
    | name | n |
    |------|---|
    | seed | 2 |
    """
    lines = [header, *rows]
    widths = [max(len(str(line[k])) for line in lines) for k in range(len(header))]
    return "\n".join([_row(header, widths), _rule(widths), *(_row(row, widths) for row in rows)])


def one_line(message: object, limit: int = 600) -> str:
    """A message as one printable line: line breaks and control characters become blanks."""
    text = "".join(c if c.isprintable() else " " for c in str(message))
    text = " ".join(text.split())
    return text if len(text) <= limit else text[: limit - 3] + "..."


class Progress:
    """Steps of a long command on stderr: bars on a terminal, a plain line per step elsewhere.

    With `quiet` nothing is shown.
    """

    def __init__(self, *, quiet: bool = False) -> None:
        """Progress of one command, from now on."""
        self.quiet = quiet
        self.terminal = not quiet and sys.stderr.isatty()
        self._start = time.perf_counter()

    @contextmanager
    def step(self, text: str) -> Iterator[None]:
        """A step: its text, and how long it took."""
        start = time.perf_counter()
        if self.terminal:
            print(f"  ...    {text}", end="\r", file=sys.stderr, flush=True)
        yield
        if not self.quiet:
            print(f"{time.perf_counter() - start:6.2f} s {text}", file=sys.stderr, flush=True)

    def bar(self, items: Sequence[Any], text: str) -> Iterator[Any]:
        """Iterate over `items` with a bar on a terminal."""
        if not self.terminal:
            yield from items
            return
        from tqdm import tqdm  # takes as long to import as all of this room

        yield from tqdm(items, desc=text, leave=False, file=sys.stderr)

    @property
    def elapsed(self) -> float:
        """Seconds since the command began."""
        return time.perf_counter() - self._start


class _NoBar:
    """Counts as a bar does, and shows nothing."""

    n: float = 0.0

    def update(self, more: float = 1.0) -> None:
        self.n += more


@contextmanager
def bar_on_terminal(**how: Any) -> Iterator[Any]:
    """A bar with `update` and `n`, of tqdm's options; off a terminal it only counts, and tqdm, which takes longer to
    import than many commands take for the rest, is left out."""
    if not sys.stderr.isatty():
        yield _NoBar()
        return
    from tqdm import tqdm

    with tqdm(leave=False, file=sys.stderr, **how) as bar:
        yield bar
