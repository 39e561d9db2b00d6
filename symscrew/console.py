"""What the command line shows: text tables on stdout, progress on stderr, what is installed."""

from __future__ import annotations

import importlib.metadata
import platform
import shutil
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from tqdm import tqdm

PACKAGES = {
    "sympy": "deriving",
    "casadi": "CasADi functions; evaluation without a C compiler",
    "numpy": "evaluation",
    "tqdm": "progress",
    "matplotlib": "figures of demo and draw",
    "scipy": "simulate: stiff scenes, contacts with events, runs without a C compiler",
    "mujoco": "an oracle of the tests",
    "pytest": "tests",
    "pin": "an opponent of the benchmarks",
}
TOOLS = {
    "cc": "running the generated C from Python",
    "gcc": "check: all warnings as errors",
    "clang": "check: all warnings as errors",
    "valgrind": "a test of the generated C",
    "cmake": "building generated code the way its users do",
}


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table with aligned columns; it reads well as plain text too.

    >>> print(table(["name", "n"], [["seed", "2"]]))
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
        yield from tqdm(items, desc=text, leave=False, disable=not self.terminal, file=sys.stderr)

    @property
    def elapsed(self) -> float:
        """Seconds since the command began."""
        return time.perf_counter() - self._start


def installation() -> list[tuple[str, str, str]]:
    """(part, version or place, what for) of everything that the package can use."""
    rows = [("python", platform.python_version(), "everything")]
    rows += [(name, _version(name), text) for name, text in PACKAGES.items()]
    return rows + [(name, shutil.which(name) or "not found", text) for name, text in TOOLS.items()]


def _version(package: str) -> str:
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"
