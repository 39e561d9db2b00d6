"""How operations, code, compile time, memory and runs grow with limbs, serial joints and loops, with exponents.

Every mechanism has a process of its own, and so has its compiler: peak memory is that of this size alone.
"""

from __future__ import annotations

import os
import resource
import subprocess
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.description.mechanism import Mechanism
from symscrew.effects.gravity import Gravity
from symscrew.export import SPILLS
from symscrew.export.c import print_c
from symscrew.generation.folder import render
from symscrew.model import Model, derive
from symscrew.runtime import FLAGS, find_compiler
from symscrew.simulation.native import Library, RunLog
from symscrew.simulation.state_programs import plant
from symscrew.studies.accuracy.growth_study import GRAVITY, four_bars

from .mechanisms import chain, platform
from .tables import exponent, table

LIMBS = (2, 4, 8, 16)
JOINTS = (6, 12, 25, 50, 100)
LOOPS = (2, 5, 10, 20, 40)
FUNCTIONS = ("body_poses", "body_twists", "inverse_dynamics", "joint_reactions", "forward_dynamics", "mass_matrix")
FAMILIES = (
    *("body_poses", "body_twists", "body_twist_rates", "joint_screws", "platform_jacobian", "velocity", "acceleration"),
    *("close_position", "close_velocity", "inverse_dynamics", "forward_dynamics"),
)
"""Kinematics, inverse and forward dynamics: what a user of a large model cannot do without."""
COSTS = ("nodes", "derive s", "print C s", "print all s", "generate MB", "C kB", "object kB", "compile s", "compile MB")
FEW = ("families: C kB", "families: object kB", "families: compile s", "families: compile MB")
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
        rows = [alone(_costs, make(n), repeats, falling=unit == "loops") for n in sizes]
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


def alone(call: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
    """The result of a call in a new process."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(call, *arguments, **named).result()


def _costs(mechanism: Mechanism, repeats: int, *, falling: bool) -> dict[str, float]:
    """What a mechanism costs: operations, COSTS, FEW; with `falling` RUNS, of a fall through singular positions."""
    effects = (Gravity((0, f"-{GRAVITY}", 0)),) if falling else (Gravity(),)
    start = time.process_time()
    model = derive(mechanism, effects)
    derived = time.process_time()
    sources = print_c(model)
    printed = time.process_time()
    render(model)
    rendered = time.process_time()
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3
    few = print_c(replace(model, programs={f: p for f, p in model.programs.items() if f in FAMILIES}))
    values = (len(model.system.tape.nodes), derived - start, printed - derived, rendered - printed, memory)
    row: dict[str, float] = {**operations(model), **dict(zip(COSTS, (*values, *_compiled(sources)), strict=True))}
    row |= dict(zip(FEW, _compiled(few), strict=True))
    return row | dict(zip(RUNS, _fall(model, repeats), strict=True)) if falling else row


def _compiled(sources: dict[str, str]) -> tuple[float, float, float, float]:
    """kB of C and of what is compiled, processor time [s] and largest memory [MB] of the compiler."""
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        for name, text in sources.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        source = Path(folder) / next(name for name in sources if name.endswith(".c"))
        seconds, megabytes = alone(compiled, source)
        made = Path(f"{source}.so")
        return source.stat().st_size / 1e3, made.stat().st_size / 1e3 if made.exists() else 0.0, seconds, megabytes


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
    log = RunLog.empty(library, times, most_crossings=1000)
    start = time.thread_time()
    outcome = library.start(0.0, q, v, np.zeros(sizes["x"]), method="dop853", h=0.0, rtol=TOLERANCE, atol=TOLERANCE,
                            longest=DURATION, budget=100_000)  # fmt: skip
    outcome = outcome or library.advance(100_000, log)
    taken = time.thread_time() - start
    if outcome:
        raise ArithmeticError(f"the run of {library.plant.model.name} ended with {outcome}")
    return taken
