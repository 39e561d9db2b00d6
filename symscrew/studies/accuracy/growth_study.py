"""Study "growth": cost over the number of loops, on N square four-bars in a row (IFToMM benchmark library, A02).

All cranks stay parallel, so the exact motion is that of one pendulum of another inertia: J theta'' = c sin theta with
J = (N + 1)/3 + N and c = ((N + 1)/2 + N) g. The run passes singular positions, where all cranks are horizontal, about
ten times in 10 s. Two ways: fixed steps of RK4, positions and rates closed by the generated functions after every step,
and `symscrew simulate` as it is, which follows the branch through singular positions.
"""

from __future__ import annotations

import ctypes
import time
from collections.abc import Sequence
from importlib import resources
from pathlib import Path

import numpy as np

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.display import Progress
from symscrew.effects import Gravity
from symscrew.errors import DescriptionError
from symscrew.model import Model
from symscrew.runtime import find_compiler
from symscrew.scene import Initial, Integrator, Scene
from symscrew.simulation import NATIVE_FLAGS, Library, Plant, prepare
from symscrew.studies.accuracy.compiled_loops import compiled, one_file, pointer
from symscrew.studies.accuracy.forward_study import beginning, whole_run
from symscrew.studies.accuracy.measuring import Point, Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.run_history import read_reference
from symscrew.studies.accuracy.states import Subject

Array = np.ndarray
SIZES = (1, 2, 5, 10, 20, 40)  # numbers of loops; exponents are slopes over the larger half
DURATION, OUTPUTS, STEP = 10.0, 50, 0.005  # the benchmark's run [s] and outputs; the step of RK4 [s]
GRAVITY = 9.81  # [m/s^2], the benchmark's
FUNCTIONS = ("forward_dynamics", "close_position", "close_velocity")
FLAGS = ("-O1",)  # the longest of these functions take minutes at -O2
TOLERANCE = 1e-7  # of `symscrew simulate`, absolute and relative
FIXED, SIMULATED = "generated functions in fixed steps", "symscrew simulate"


def four_bars(count: int) -> Mechanism:
    """N square four-bars in a row: links of 1 m and 1 kg, cranks upwards."""
    builder = MechanismBuilder(f"n_four_bar_{count}")
    for k in range(count + 1):
        builder.body(
            f"crank{k}", mass=1, com=[k, "1/2", 0], inertia=[["1/12", 0, 0], [0, 0, 0], [0, 0, "1/12"]]
        )  # fmt: skip
    for k in range(count):
        builder.body(
            f"coupler{k}", mass=1, com=[f"{k} + 1/2", 1, 0], inertia=[[0, 0, 0], [0, "1/12", 0], [0, 0, "1/12"]]
        )
    ends = [(f"A{k}", "base", f"crank{k}", [k, 0, 0]) for k in range(count + 1)]
    for k in range(count):
        ends.append((f"B{k}", f"crank{k}", f"coupler{k}", [k, 1, 0]))
        ends.append((f"C{k}", f"coupler{k}", f"crank{k + 1}", [k + 1, 1, 0]))
    for name, parent, child, point in ends:
        builder.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 0, 1]])
    return builder.build()


def study(
    subject: Subject, progress: Progress, *, repeats: int, seconds: float, path: Path | None = None, full: bool = False
) -> Study:
    """Time per simulated second, operations, and seconds to derive and compile, for N = 1 ... 40, with exponents."""
    if not subject.model.name.startswith("n_four_bar"):
        raise DescriptionError(
            "--study growth: expected the scene of the N four-bar (examples/benchmarks/n_four_bar.toml)"
        )
    if find_compiler() is None:
        raise DescriptionError("--study growth: it is of generated C, and there is no C compiler")
    setups, rows = [], []
    watch = Stopwatch()
    for count in SIZES:
        own = Stopwatch()
        with progress.step(f"growth: derive and compile N = {count}"):
            scene = falling(count)
            model, plant = own("derive", prepare, scene)
            setups.append(_setup(model, count, own))
            setups.append(_simulated(scene, plant, setups[-1], own))
        for name, spent in own.seconds.items():
            watch.seconds[name] = watch.seconds.get(name, 0.0) + spent
        operations = [model.programs[name].operations["total"] for name in FUNCTIONS]
        rows.append([count, *operations, own.seconds["derive"], own.seconds["compile"]])
    points = measured(setups, repeats=repeats, seconds=seconds, progress=progress, text="growth")
    return Study(
        "growth",
        "Cost over the number of loops: N four-bars in a row",
        points,
        error_label="largest error of the cranks' angle [rad]",
        cost_label="time per simulated second",
        cost_unit="ms",
        reference="the pendulum of the same motion by DOP853 at 1e-13; its difference to a run at 1e-12",
        reference_error=max(float(s.facts["reference error"]) for s in setups if "reference error" in s.facts),
        preparation=watch.seconds,
        left_out=(),
        notes=(
            f"{DURATION:g} s through the singular positions. {FIXED}: RK4 with steps of {STEP:g} s, closed after every "
            f"step. {SIMULATED}: DOP853, tolerance {TOLERANCE:g}, its whole call. Compiled with {' '.join(FLAGS)}.",
            *_peers(path),
            "Exponents: slopes of log cost over log N over the larger half of the sizes; 1 is linear.",
        ),
        tables={"Growth with N": _table(rows, points)},
    )


def _table(rows: Sequence[Sequence[float]], points: Sequence[Point]) -> tuple[list[str], list[list[str]]]:
    """A row per N, and the exponents; `rows`: N, operations, seconds to derive and to compile."""
    header = ["N", *(f"operations {name}" for name in FUNCTIONS), "derive [s]", "compile [s]"]
    columns = np.array(rows, dtype=float)
    sizes, upper = columns[:, 0], slice(len(rows) // 2, None)
    table = [[*(f"{x:g}" for x in row[:4]), *(f"{x:.2f}" for x in row[4:])] for row in columns]
    last = ["exponent", *(f"{_exponent(sizes[upper], column[upper]):.2f}" for column in columns[:, 1:].T)]
    for series in (FIXED, SIMULATED):
        own = [p for p in points if p.facts["series"] == series]
        times = np.array([1e3 * p.cost.median if p.cost else np.nan for p in own])
        header += [f"{series}, 1 s [ms]", "error"]
        for row, spent, p in zip(table, times, own, strict=True):
            row += [f"{spent:.3g}", p.failure or f"{p.error:.1e}"]
        last += [f"{_exponent(sizes[upper], times[upper]):.2f}", ""]
    return header, [*table, last]


def falling(count: int) -> Scene:
    """The scene of the benchmark with N = `count`: cranks upright, their tips at 1 m/s."""
    start, tight = Initial(rates={"A0": -1.0}), Integrator(tolerance=TOLERANCE)
    mechanism, down = four_bars(count), (Gravity((0, f"-{GRAVITY}", 0)),)
    return Scene(mechanism.name, mechanism, down, DURATION, OUTPUTS / DURATION, start, integrator=tight)


def _simulated(scene: Scene, plant: Plant, fixed: Setup, watch: Stopwatch) -> Setup:
    """`symscrew simulate` of the same fall: its whole call, and the error of the same angle."""
    library = watch("compile", Library, plant, flags=(*NATIVE_FLAGS, *FLAGS))
    start = beginning(scene, plant.model, plant)
    crank = [c.label for c in plant.system.tree.q].index("A0")
    exact, _ = _exact(int(fixed.facts["N"]))

    def error(q: Array) -> float:
        return float(np.abs(-q[:, crank] - exact).max())

    facts = {"N": fixed.facts["N"], "operations": fixed.facts["operations"], "series": SIMULATED}
    curve = fixed.curve.replace(FIXED, SIMULATED)
    return whole_run(scene, library, start, error, curve=curve, setting=fixed.setting, facts=facts)


def _peers(path: Path | None) -> list[str]:
    """What other engines took for N = 40, from the reference beside the scene."""
    reference = read_reference(path) if path is not None else None
    return [note for note in reference.notes if note.startswith("Peers at N = 40")] if reference is not None else []


def _exponent(sizes: np.ndarray, values: np.ndarray) -> float:
    good = np.isfinite(values) & (values > 0)
    return float(np.polyfit(np.log(sizes[good]), np.log(values[good]), 1)[0]) if good.sum() > 1 else float("nan")


def _exact(count: int) -> tuple[np.ndarray, float]:
    """The cranks' angle from upright at all outputs, clockwise, and how well it is known."""
    from scipy.integrate import solve_ivp

    inertia, weight = (count + 1) / 3 + count, ((count + 1) / 2 + count) * GRAVITY
    times = np.linspace(0.0, DURATION, OUTPUTS + 1)
    found = [
        solve_ivp(
            lambda t, y: [y[1], weight / inertia * np.sin(y[0])], (0.0, DURATION), [0.0, 1.0], "DOP853", times,
            rtol=tolerance, atol=tolerance,
        ).y[0]
        for tolerance in (1e-13, 1e-12)
    ]  # fmt: skip
    return found[0], float(np.abs(found[0] - found[1]).max())


def _setup(model: Model, count: int, watch: Stopwatch) -> Setup:
    name, size = model.name, len(model.system.tree.v)
    text = watch("print", one_file, model, {f: model.programs[f] for f in FUNCTIONS})
    adapters = [
        f"#define NV {size}",
        f"#define accelerations_at(q, v, a) {name}_forward_dynamics(q, v, {_drives(model)}a)",
        f"#define close_q {name}_close_position",
        f"#define close_v {name}_close_velocity",
    ]
    kernel = resources.files("symscrew.studies.accuracy").joinpath("kernels/growth.c").read_text(encoding="utf-8")
    library = watch("compile", compiled, "\n".join(["#include <string.h>", text, *adapters, kernel]), FLAGS)
    crank = [c.label for c in model.system.tree.q].index("A0")
    exact, own = _exact(count)
    steps = round(DURATION / STEP)
    outputs = np.zeros((OUTPUTS + 1, size))
    labels = list(model.programs["velocity"].inputs[1].labels)
    rate = np.zeros(len(labels))
    (unit,), _ = model("velocity", model.system.reference, np.eye(len(labels))[0])
    rate[0] = -1.0 / float(unit[crank])
    (v,), _ = model("velocity", model.system.reference, rate)
    start = np.ascontiguousarray(np.concatenate([model.system.reference, v]))
    skipped = ctypes.c_long(0)

    def run() -> float:
        begin = time.thread_time()
        status = library.fall(
            ctypes.c_long(steps), ctypes.c_double(DURATION / steps), pointer(start), ctypes.c_long(steps // OUTPUTS),
            pointer(outputs), ctypes.byref(skipped),
        )  # fmt: skip
        taken = time.thread_time() - begin
        if status:
            raise ArithmeticError(f"status {status}")
        return taken

    def error() -> float:
        return float(np.abs(-outputs[:, crank] - exact).max())

    operations = model.programs["forward_dynamics"].operations["total"]
    facts: dict[str, object] = {"N": count, "operations": operations, "reference error": own, "series": FIXED}
    return Setup(f"{FIXED}, N = {count}", f"{size} joints", run, error, DURATION, facts)


def _drives(model: Model) -> str:
    return "NULL, " if any(p.name == "u" for p in model.programs["forward_dynamics"].inputs) else ""
