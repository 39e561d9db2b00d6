"""Time of the whole command `symscrew generate NAME --out DIR`, from a cold start to files on disk.

A cold start is a new process of an installed package, whose modules are compiled to byte code already and whose cache
is empty: it is as the first run of a user. The second run finds what the first one made in the cache. Beside the times
stands what they should be; nothing asserts it.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from symscrew.description import to_toml
from symscrew.description.mechanism import Mechanism
from symscrew.studies.accuracy.growth_study import four_bars

from .mechanisms import chain, humanoid, platform
from .tables import exponent, table

COMMAND = "import sys; from symscrew.cli.parser import main; sys.exit(main())"  # what the script `symscrew` does
TARGETS = {"C": ["--target", "c"], "C, CasADi, NumPy": ["--target", "c", "casadi", "numpy"]}


@dataclass(frozen=True)
class Case:
    """What to generate: a name of the catalogue, or a mechanism that is made; and in how many seconds [s] its C."""

    name: str
    goal: float
    make: Callable[[], Mechanism] | None = None

    def argument(self, folder: Path) -> str:
        """What the command line takes."""
        if self.make is None:
            return self.name
        return _file(self.make(), folder)


def _file(mechanism: Mechanism, folder: Path) -> str:
    file = folder / f"{mechanism.name}.toml"
    file.write_text(to_toml(mechanism), encoding="utf-8")
    return str(file)


CASES = (
    Case("three_ups_upu_s", 2.0),
    Case("three_ups_upu_s_physical", 2.0),
    Case("stewart_6ups", 3.0),
    Case("delta", 3.0),
    Case("panda", 1.5),
    Case("humanoid", 5.0, humanoid),
    Case("chain_100", 6.0, lambda: chain(100)),
    Case("four_bars_40", 5.0, lambda: four_bars(40)),
)


GROWTH: dict[str, tuple[Callable[[int], Mechanism], tuple[int, ...]]] = {
    "serial joints": (chain, (12, 25, 50, 100)),
    "loops, four-bars in a row": (four_bars, (5, 10, 20, 40)),
    "limbs UPS of one platform": (platform, (2, 4, 8, 16)),
}
"""What of a mechanism grows, how it is made, and how many there are; exponents are those of the larger half."""


def run(*, repeats: int = 5) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    raw: dict[str, Any] = {}
    rows = []
    with tempfile.TemporaryDirectory(prefix="benchmark_") as name:
        folder = Path(name)
        cases = [(case, case.argument(folder), what) for case in CASES for what in TARGETS]
        with _cache(folder) as cache:
            _command(CASES[0].name, TARGETS["C"], folder, cache)  # compiles the modules
        times: dict[tuple[str, str], list[tuple[float, ...]]] = {}
        for _ in range(repeats):
            for case, argument, what in cases:
                with _cache(folder) as cache:
                    first = _command(argument, TARGETS[what], folder, cache)
                    again = _command(argument, TARGETS[what], folder, cache)
                times.setdefault((case.name, what), []).append((*first, again[0]))
    for case, _, what in cases:
        wall, used, again = (min(values) for values in zip(*times[case.name, what], strict=True))
        goal = f"{case.goal:g}" if what == "C" else ""
        rows.append([case.name, what, f"{wall:.2f}", f"{used:.2f}", goal, f"{again:.2f}"])
        raw[f"{case.name}: {what}"] = {"wall": wall, "processor": used, "goal": case.goal, "again": again}
    text = f"Least of {repeats} interleaved repeats; a busy machine shows in wall time first.\n\n"
    text += table(["mechanism", "targets", "wall s", "processor s", "goal s", "second run, wall s"], rows)
    growth = _growth(repeats)
    raw["growth"] = growth
    lines = [[what, *found["sizes"], f"{found['exponent']:.2f}"] for what, found in growth.items()]
    text += "\n\nProcessor time [s] of C, by size\n\n"
    return text + table(["what grows", *["size: s"] * 4, "exponent"], lines), raw


def _growth(repeats: int) -> dict[str, Any]:
    """Processor time of the command for C by size, with an exponent."""
    found: dict[str, Any] = {}
    with tempfile.TemporaryDirectory(prefix="benchmark_") as name:
        folder = Path(name)
        for what, (make, sizes) in GROWTH.items():
            files = [_file(make(n), folder) for n in sizes]
            rounds = [[_first(file, folder) for file in files] for _ in range(repeats)]
            times = [min(column) for column in zip(*rounds, strict=True)]
            found[what] = {
                "sizes": [f"{n}: {t:.2f}" for n, t in zip(sizes, times, strict=True)],
                "times": dict(zip(map(str, sizes), times, strict=True)),
                "exponent": exponent(sizes, times),
            }
    return found


def _first(argument: str, folder: Path) -> float:
    """Processor time [s] of the command for C, whose cache is empty."""
    with _cache(folder) as cache:
        return _command(argument, TARGETS["C"], folder, cache)[1]


def _cache(folder: Path) -> tempfile.TemporaryDirectory[str]:
    """An empty cache of a user."""
    return tempfile.TemporaryDirectory(prefix="cache_", dir=folder)


def _command(argument: str, targets: list[str], folder: Path, cache: str) -> tuple[float, float]:
    """Wall and processor time [s] of the command, whose cache is a folder."""
    with tempfile.TemporaryDirectory(prefix="generated_", dir=folder) as name:
        place = Path(name) / "out"
        arguments = ["-c", COMMAND, "generate", argument, "--out", str(place), *targets]
        compiled = str(folder / "compiled")
        environment = {**os.environ, "PYTHONPYCACHEPREFIX": compiled, "SYMSCREW_CACHE": cache}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        before, start = os.times(), time.perf_counter()
        subprocess.run([sys.executable, *arguments], check=True, capture_output=True, env=environment)
        took, after = time.perf_counter() - start, os.times()
        if not any(place.glob("*.c")):
            raise RuntimeError(f"generate {argument} ended without C")
    user, system = after.children_user - before.children_user, after.children_system - before.children_system
    return took, user + system
