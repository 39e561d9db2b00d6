"""How operations, code, compile time, memory and runs grow with limbs, serial joints and loops, with exponents."""

from __future__ import annotations

import os
import subprocess
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.accuracy.growth import GRAVITY, four_bars
from symscrew.compiled import FLAGS, SPILLS, find_compiler
from symscrew.effects import Gravity
from symscrew.generation import render
from symscrew.mechanism import Mechanism
from symscrew.model import Model, derive
from symscrew.simulation.native import Library
from symscrew.simulation.programs import plant

from .mechanisms import chain, platform
from .tables import exponent, table

LIMBS = (2, 4, 8, 16)
JOINTS = (6, 12, 25, 50, 100)
LOOPS = (2, 5, 10, 20, 40)
FUNCTIONS = ("body_poses", "body_twists", "inverse_dynamics", "joint_reactions", "forward_dynamics", "mass_matrix")
COSTS = ("nodes", "C kB", "derive s", "generate s", "compile s", "compile MB")
RUNS = ("compile run s", "run ms")
DURATION, TOLERANCE = 10.0, 1e-9


def operations(model: Model) -> dict[str, int]:
    """Operations of the functions whose growth is shown."""
    return {name: model.programs[name].operations["total"] for name in FUNCTIONS if name in model.programs}


def run(*, repeats: int = 3) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers; processor times, of deriving and compiling measured once."""
    texts, raw = [], {}
    series: dict[str, tuple[str, Callable[[int], Mechanism], tuple[int, ...]]] = {
        "platforms on S with n UPS limbs": ("limbs", platform, LIMBS),
        "serial chains of n revolute joints": ("joints", chain, JOINTS),
        "n four-bars in a row": ("loops", four_bars, LOOPS),
    }
    for title, (unit, make, sizes) in series.items():
        rows = [_costs(make(n), repeats, falling=unit == "loops") for n in sizes]
        columns = list(rows[0])
        found = {c: [row[c] for row in rows] for c in columns}
        exponents = {c: exponent(sizes, found[c]) for c in columns}
        lines: list[list[object]] = [
            [n, *(f"{row[c]:.4g}" for c in columns)] for n, row in zip(sizes, rows, strict=True)
        ]
        lines.append(["exponent", *(f"{exponents[c]:.2f}" for c in columns)])
        texts.append(f"{title} (exponents over the larger half)\n\n" + table([unit, *columns], lines))
        raw[title] = {"sizes": sizes, "values": found, "exponents": exponents}
    return "\n\n".join(texts), raw


def _costs(mechanism: Mechanism, repeats: int, *, falling: bool) -> dict[str, float]:
    """What a mechanism costs: operations, and COSTS; with `falling` also RUNS, of a fall through singular positions."""
    effects = (Gravity((0, f"-{GRAVITY}", 0)),) if falling else (Gravity(),)
    start = time.process_time()
    model = derive(mechanism, effects)
    derived = time.process_time()
    files = render(model)
    printed = time.process_time()
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        for file in (f"{model.name}.h", f"{model.name}.c"):
            (Path(folder) / file).write_bytes(files[file])
        seconds, megabytes = compiled(Path(folder) / f"{model.name}.c")
    values = (len(model.system.tape.nodes), len(files[f"{model.name}.c"]) / 1e3, derived - start, printed - derived)
    row: dict[str, float] = {**operations(model), **dict(zip(COSTS, (*values, seconds, megabytes), strict=True))}
    return row | dict(zip(RUNS, _fall(model, repeats), strict=True)) if falling else row


def compiled(source: Path) -> tuple[float, float]:
    """Processor time [s] and largest memory [MB] of the compiler for a file, as `symscrew.load` calls it."""
    compiler = find_compiler()
    if compiler is None:
        return float("nan"), float("nan")
    state = f"-D{source.stem.upper()}_STATE_BY_STATE"
    command = [compiler, *FLAGS, "-march=native", state, SPILLS, str(source), "-o", f"{source}.so", "-lm"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE)
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise RuntimeError(f"{compiler} refused {source.name}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1e3


def _fall(model: Model, repeats: int) -> tuple[float, float]:
    """Seconds to compile a run, and the least milliseconds of the run itself: 10 s from upright at 1 rad/s."""
    used = os.times()
    made = plant(model)
    library = Library(made)
    after = os.times()
    compiling = after.children_user - used.children_user
    labels = [c.label for c in model.system.tree.v]
    (unit,), _ = model("velocity", model.system.reference, np.ones(1))
    best = min(_once(library, model.system.reference, -unit / unit[labels.index("A0")]) for _ in range(repeats))
    return compiling, 1e3 * best


def _once(library: Library, q: np.ndarray, v: np.ndarray) -> float:
    """Processor time of a run [s]."""
    sizes, times = library.plant.sizes, np.linspace(0.0, DURATION, 11)
    samples: Sequence[np.ndarray] = [np.zeros((len(times), max(sizes[k], 1))) for k in "qvx"]
    written, met = np.zeros(1, dtype=np.uintp), np.zeros(1, dtype=np.uintp)
    crossings = np.zeros(1000, dtype=library.crossing)
    start = time.thread_time()
    outcome = library.start(0.0, q, v, np.zeros(sizes["x"]), method="dop853", h=0.0, rtol=TOLERANCE, atol=TOLERANCE,
                            longest=DURATION, budget=100_000)  # fmt: skip
    outcome = outcome or library.advance(100_000, times, written, *samples, crossings, met)
    taken = time.thread_time() - start
    if outcome:
        raise ArithmeticError(f"the run of {library.plant.model.name} ended with {outcome}")
    return taken
