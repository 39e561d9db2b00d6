"""What the command line shows: text tables on stdout, progress on stderr, what is installed."""

from __future__ import annotations

import importlib.metadata
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TextIO

from tqdm import tqdm

PACKAGES = {
    "sympy": ("deriving", "pip install sympy"),
    "casadi": ("CasADi functions; evaluation without a C compiler; optimise", "pip install casadi"),
    "numpy": ("evaluation", "pip install numpy"),
    "tqdm": ("progress", "pip install tqdm"),
    "rich": ("tables in colour on a terminal", "pip install rich"),
    "matplotlib": ("figures of demo, draw, cost, simulate, report, workspace", 'pip install "symscrew[plot]"'),
    "scipy": ("simulate: stiff scenes, events, runs without a C compiler", 'pip install "symscrew[simulation]"'),
    "distributed": ("workspace on a Dask cluster", 'pip install "symscrew[dask]"'),
    "argcomplete": ("completion in the shell", 'pip install "symscrew[completion]"'),
    "mkdocs": ("building the documentation", 'pip install "symscrew[docs]"'),
    "mujoco": ("an oracle of the tests", 'pip install "symscrew[test]"'),
    "pytest": ("tests", 'pip install "symscrew[test]"'),
    "pin": ("an opponent of the benchmarks", 'pip install "symscrew[benchmark]"'),
}
"""Package -> what it is for, and how to get it."""
TOOLS = {
    "cc": ("running the generated C from Python", "apt install gcc"),
    "gcc": ("check: all warnings as errors", "apt install gcc"),
    "clang": ("check: all warnings as errors", "apt install clang"),
    "valgrind": ("a test of the generated C", "apt install valgrind"),
    "cmake": ("building generated code the way its users do", "apt install cmake"),
    "chromium": ("tests of the pages of view and report", "apt install chromium"),
    "node": ("a test of the generated JavaScript", "apt install nodejs"),
    "arm-none-eabi-gcc": ("embedded: cost on a microcontroller", "apt install gcc-arm-none-eabi"),
    "qemu-system-arm": ("embedded: cost on a microcontroller", "apt install qemu-system-arm"),
}
"""Command -> what it is for, and how to get it (Debian's names)."""
SOLVERS = ("ipopt", "fatrop", "sqpmethod")
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
        yield from tqdm(items, desc=text, leave=False, disable=not self.terminal, file=sys.stderr)

    @property
    def elapsed(self) -> float:
        """Seconds since the command began."""
        return time.perf_counter() - self._start


def installation() -> list[tuple[str, str, str, str]]:
    """(part, version or place, what for, how to get it if it is missing) of everything that the package can use."""
    rows = [("python", platform.python_version(), "everything", "")]
    for name, (text, cure) in PACKAGES.items():
        found = _version(name)
        rows.append((name, found, text, cure if found in MISSING else ""))
    for name, (text, cure) in TOOLS.items():
        place = shutil.which(name) or "not found"
        rows.append((name, place, text, cure if place in MISSING else ""))
    openmp = _openmp()
    rows.append(
        ("OpenMP", "yes" if openmp else "no", "batches on several threads", "" if openmp else "apt install gcc")
    )
    for solver in SOLVERS:
        has = _solver(solver)
        rows.append((f"casadi: {solver}", "yes" if has else "no", "optimise", "" if has else "pip install -U casadi"))
    return rows


def _openmp() -> bool:
    """Whether the C compiler makes libraries with OpenMP: one is made and thrown away."""
    compiler = next((c for c in ("cc", "gcc", "clang") if shutil.which(c)), None)
    if compiler is None:
        return False
    with tempfile.TemporaryDirectory(prefix="symscrew_") as folder:
        source = Path(folder) / "openmp.c"
        source.write_text("#include <omp.h>\nint threads(void) { return omp_get_max_threads(); }\n")
        command = [compiler, "-fopenmp", "-shared", "-fPIC", str(source), "-o", str(Path(folder) / "openmp.so")]
        try:
            return subprocess.run(command, capture_output=True, timeout=60).returncode == 0
        except (OSError, subprocess.TimeoutExpired):
            return False


def _solver(name: str) -> bool:
    try:
        import casadi
    except ImportError:
        return False
    return bool(casadi.has_nlpsol(name))


def _version(package: str) -> str:
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"
