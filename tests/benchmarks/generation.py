"""Time of the whole command `symscrew generate NAME --out DIR`, from a cold start to files on disk.

A cold start is a new process of an installed package, whose modules are compiled to byte code already. Beside the times
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

from .mechanisms import chain, humanoid
from .tables import table

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
        file = folder / f"{self.name}.toml"
        file.write_text(to_toml(self.make()), encoding="utf-8")
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


def run(*, repeats: int = 5) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    raw: dict[str, Any] = {}
    rows = []
    with tempfile.TemporaryDirectory(prefix="benchmark_") as name:
        folder = Path(name)
        cases = [(case, case.argument(folder), what) for case in CASES for what in TARGETS]
        _command(CASES[0].name, TARGETS["C"], folder)  # compiles the modules
        times: dict[tuple[str, str], list[tuple[float, float]]] = {}
        for _ in range(repeats):
            for case, argument, what in cases:
                times.setdefault((case.name, what), []).append(_command(argument, TARGETS[what], folder))
    for case, _, what in cases:
        wall, used = (min(values) for values in zip(*times[case.name, what], strict=True))
        goal = f"{case.goal:g}" if what == "C" else ""
        rows.append([case.name, what, f"{wall:.2f}", f"{used:.2f}", goal])
        raw[f"{case.name}: {what}"] = {"wall": wall, "processor": used, "goal": case.goal}
    text = f"Least of {repeats} interleaved repeats; a busy machine shows in wall time first.\n\n"
    return text + table(["mechanism", "targets", "wall s", "processor s", "goal s"], rows), raw


def _command(argument: str, targets: list[str], folder: Path) -> tuple[float, float]:
    """Wall and processor time [s] of the command."""
    with tempfile.TemporaryDirectory(prefix="generated_", dir=folder) as name:
        place = Path(name) / "out"
        arguments = ["-c", COMMAND, "generate", argument, "--out", str(place), *targets]
        environment = {**os.environ, "PYTHONPYCACHEPREFIX": str(folder / "compiled")}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        before, start = os.times(), time.perf_counter()
        subprocess.run([sys.executable, *arguments], check=True, capture_output=True, env=environment)
        took, after = time.perf_counter() - start, os.times()
        if not any(place.glob("*.c")):
            raise RuntimeError(f"generate {argument} ended without C")
    user, system = after.children_user - before.children_user, after.children_system - before.children_system
    return took, user + system
