"""What the command line shows: text tables on stdout, progress on stderr."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TextIO

MISSING = ("not installed", "not found", "no")


def colours(stream: TextIO) -> bool:
    """Whether to write colours: on a terminal that has them, unless NO_COLOR is set (no-color.org)."""
    return stream.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def print_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table on stdout: coloured and as wide as the terminal there, in Markdown elsewhere."""
    if not colours(sys.stdout):
        print(aligned_table(header, rows))
        return
    from rich.box import SIMPLE_HEAD
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    made = Table(box=SIMPLE_HEAD, header_style="bold cyan", pad_edge=False)
    for k, title in enumerate(header):
        numbers = all(_is_number(row[k]) for row in rows)
        made.add_column(title, justify="right" if numbers else "left", style="bold" if k == 0 else "")
    for row in rows:
        made.add_row(*(Text(cell, style="red" if cell in MISSING else "") for cell in row))
    Console().print(made)


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

    def text(line: Sequence[str]) -> str:
        return "| " + " | ".join(str(c).ljust(w) for c, w in zip(line, widths, strict=True)) + " |"

    rule = "|" + "|".join("-" * (w + 2) for w in widths) + "|"
    return "\n".join([text(header), rule, *(text(row) for row in rows)])


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
