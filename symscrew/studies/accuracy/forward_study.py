"""Study "forward": integrators, tolerances and formulations for a scene, beside measured points of other engines.

A file `<scene>.reference.json` beside a scene gives its reference history, the accuracy that is asked for and the
points of peers. Without one the reference is our own: the tightest run, whose error is its difference to a run
in minimal coordinates.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.display import Progress
from symscrew.errors import DescriptionError
from symscrew.model import Model
from symscrew.runtime import find_compiler
from symscrew.scene import Initial, Scene
from symscrew.simulation import (
    NATIVE_METHODS,
    Library,
    Plant,
    initial_state,
    initial_states,
    prepare,
    run_natively,
    table_code,
)
from symscrew.studies.accuracy.formulation_libraries import FORMULATIONS, TREE, Formulated, March, Start, formulated
from symscrew.studies.accuracy.measuring import Point, Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.run_history import Reference, read_reference
from symscrew.studies.accuracy.states import Subject
from symscrew.studies.accuracy.stiff import stiff_setups

Array = np.ndarray
TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)  # of the other formulations: a decade of error every half
OURS = (1e-2, 1e-4, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12)  # finer: the least time to reach a stated error
SUBSTEPS = (1, 2, 4, 8, 16, 32, 64, 128, 1024)  # the last for stiff scenes: explicit methods need it there
FULL_SUBSTEPS = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 4096)  # steps between two outputs, with `--full`
MOST = 150_000  # steps of a run, or as many as its fixed steps are; with more it stays in the table as failed
LEAST_SECONDS = 25.0  # of measuring: there are some hundred settings, and each is to have its three repeats
GAIN = 50.0  # Baumgarte's [1/s]; scenes shorter than 1 s have more, so that gaps fade within the scene
LONGEST = 1.0  # seconds: after a run that takes longer, finer settings of its curve are not run
OWN = "symscrew simulate"
ENGINES = {"exudyn": "Exudyn", "mujoco": "MuJoCo", "generatedC": "bare generated C"}


def study(
    subject: Subject, progress: Progress, *, repeats: int, seconds: float, path: Path | None = None, full: bool = False
) -> Study:
    """Error over time per simulated second of every integrator and formulation."""
    if find_compiler() is None:
        raise DescriptionError("--study forward: all its curves are of generated C, and there is no C compiler")
    if "forward_dynamics" not in subject.model.programs:
        raise DescriptionError(f"--study forward: {subject.model.name} has no forward dynamics")
    watch = Stopwatch()
    scene = subject.scene or falling(subject.model)
    reference = read_reference(path) if path is not None else None
    if reference is not None:
        scene = replace(scene, rate=1.0 / float(reference.times[1]), duration=float(reference.times[-1]))
    if scene.integrator.method not in NATIVE_METHODS:
        scene = replace(scene, integrator=replace(scene.integrator, method="dop853", step=None))
    with progress.step(f"forward: derive and compile {scene.name}"):
        model, plant = watch("derive", prepare, scene)
        start = beginning(scene, model, plant)
        library = watch("compile", Library, plant, table_code(list(scene.tables.values())))
        made = formulated(plant, scene, start, watch)
    if any(effect.contacts() for effect in scene.effects):
        raise DescriptionError("--study forward: contacts with events are not for these integrators")
    text, own, error_of = _judge(scene, reference, model, (library, made))
    stiff, missing = stiff_setups(scene, plant, start, error_of, watch=watch)
    setups = [*ours(scene, library, start, error_of), *_all_formulations(scene, made, error_of, full), *stiff]
    points = measured(
        setups, repeats=repeats, seconds=max(seconds, LEAST_SECONDS), progress=progress, text="forward", longest=LONGEST
    )
    notes, tables = (
        [f"Scene {scene.name}, {scene.duration:g} s, {len(scene.times)} outputs. {scene.description}".strip()],
        {},
    )
    if reference is not None:
        notes += reference.notes
        points = (*points, *reference.peer_points(scene.duration))
        tables["Stated accuracy, and the least time to reach an error, beside peers"] = beside(
            points, reference, scene.duration
        )
        if reference.published:
            tables["Published"] = reference.published_table()
    return Study(
        "forward",
        f"Simulation of {scene.name}",
        points,
        error_label=reference.error_label if reference is not None else "largest error of the coordinates [rad, m/m]",
        cost_label="time per simulated second",
        cost_unit="ms",
        reference=text,
        reference_error=own,
        preparation=watch.seconds,
        left_out=(*_missing(made), *missing),
        notes=tuple(notes),
        tables=tables,
    )  # fmt: skip


def falling(model: Model) -> Scene:
    """A scene for a mechanism without one: from the reference configuration under its effects, for 1 s."""
    system = model.system
    labels = [c.label for c in system.tree.v]
    if "velocity" in model.programs:
        entries = model.programs["velocity"].inputs[1].labels
        labels = [label.replace(".q", ".w") for label in entries]
    rates = {label: 0.2 * (-0.7) ** k for k, label in enumerate(labels)}
    return Scene(model.name, model.mechanism, model.effects, 1.0, 4.0, Initial({}, rates), description="From the "
                 "reference configuration, with rates of order 0.2 of the independent coordinates.")  # fmt: skip


def beginning(scene: Scene, model: Model, plant: Plant) -> Start:
    """q, v, x at the start."""
    q, v = initial_state(scene, model, plant.parameters)
    x = initial_states(scene, model, q, v)
    return q, v, np.concatenate([x, np.zeros(len(plant.x_labels) - len(x))])


def _missing(made: Formulated) -> list[str]:
    """Why curves of a closed chain are not there."""
    kinds = [kind for kind in FORMULATIONS if kind not in made.kinds and kind != TREE and TREE not in made.kinds]
    return [f"the formulation {kind}: this mechanism or scene does not have it" for kind in kinds]


def _judge(
    scene: Scene, reference: Reference | None, model: Model, made: tuple[Library, Formulated]
) -> tuple[str, float | None, Callable[[Array], float]]:
    """The reference in words, its own error, and the error of q (n, nq)."""
    if reference is not None:
        return reference.text, reference.own_error, reference.error_of(model)
    library, other = made
    units = _units(model)
    for kind in reversed(other.kinds):
        try:
            _, q, _ = other.run(kind, scene.times, March("DOP853", 1e-4 * scene.duration, 1e-14, 0.0, MOST))
            break
        except ArithmeticError as error:
            reason = str(error)
    else:
        raise DescriptionError(f"--study forward: no reference for {scene.name}: {reason}")
    tight = replace(scene, integrator=replace(scene.integrator, method="dop853", step=None, tolerance=1e-12))
    history = run_natively(library, tight, other.start)
    if not history.ok:
        raise DescriptionError(f"--study forward: no reference, {history.status}")
    own = float(np.abs((q - history.q) / units).max())
    text = f"DOP853 at a local tolerance of 1e-14, {kind}; its difference to {OWN} at the tightest tolerance"
    return text, own, lambda found: float(np.abs((found - q) / units).max())


def _units(model: Model) -> Array:
    return np.array([model.system.length if c.unit == "m" else 1.0 for c in model.system.tree.q])


def ours(scene: Scene, library: Library, start: Start, error_of: Callable[[Array], float]) -> list[Setup]:
    """`symscrew simulate` itself: DOP853 with dense output, projection and care near singular configurations."""
    setups = []
    for tolerance in OURS:
        chosen = replace(scene, integrator=replace(scene.integrator, method="dop853", step=None, tolerance=tolerance))
        setups.append(
            whole_run(
                chosen,
                library,
                start,
                error_of,
                curve=f"{OWN}: DOP853, projection",
                setting=f"tolerance {tolerance:g}",
                facts={"family": "DOP853"},
            )
        )
    return setups


def whole_run(
    scene: Scene,
    library: Library,
    start: Start,
    error_of: Callable[[Array], float],
    *,
    curve: str,
    setting: str,
    facts: Mapping[str, Any],
) -> Setup:
    """One call of `symscrew simulate`, in processor time; `error_of` takes q at all outputs, shape (outputs, nq).

    Calls raise ArithmeticError with the status of a run that does not reach its end.
    """
    found: list[Array] = []

    def run() -> float:
        begin = time.thread_time()
        history = run_natively(library, scene, start)
        taken = time.thread_time() - begin
        if not history.ok:
            raise ArithmeticError(history.status)
        found[:] = [history.q]
        return taken

    return Setup(curve, setting, run, lambda: error_of(found[0]), scene.duration, facts)


def _all_formulations(scene: Scene, made: Formulated, error_of: Callable[[Array], float], full: bool) -> list[Setup]:
    """Every formulation by RK4 at all numbers of steps between two outputs, and by DOP853 at all tolerances."""
    times = np.ascontiguousarray(scene.times)
    interval, gain = float(times[1]), GAIN / min(1.0, scene.duration)
    counts = FULL_SUBSTEPS if full else SUBSTEPS
    marches = [
        *(March("RK4", interval / n, 0.0, gain, max(MOST, len(times) * n + 10)) for n in counts),
        *(March("DOP853", 0.1 * interval, tolerance, gain, MOST) for tolerance in TOLERANCES),
    ]

    def setup(kind: str, march: March) -> Setup:
        found: list[Array] = []

        def run() -> float:
            taken, q, _ = made.run(kind, times, march)
            found[:] = [q]
            return taken

        facts = {"family": march.method}
        curve = f"{march.method}, {kind}"
        return Setup(curve, march.setting, run, lambda: error_of(found[0]), scene.duration, facts)

    return [setup(kind, march) for kind in made.kinds for march in marches]


def beside(
    points: Sequence[Point], reference: Reference, duration: float
) -> tuple[Sequence[str], Sequence[Sequence[str]]]:
    """Rows: error levels; columns: least time of a whole run of ours, of other formulations here, of each engine."""
    levels = sorted({*reference.levels, *((reference.stated,) if reference.stated else ())}, reverse=True)
    engines = list(dict.fromkeys(p.curve.split()[0] for p in points if p.facts.get("peer")))
    names = ["ours", "other formulations", *engines]
    rows = []
    for level in levels:
        row = [f"{level:g}" + (" (stated)" if level == reference.stated else "")]
        for name in names:
            row.append(_least(points, name, level, duration))
        rows.append(row)
    return ["error", *(f"{ENGINES.get(name, name)} [ms]" for name in names)], rows


def _least(points: Sequence[Point], name: str, level: float, duration: float) -> str:
    def belongs(point: Point) -> bool:
        if point.facts.get("peer"):
            return point.curve.split()[0] == name
        return name == ("ours" if point.curve.startswith(OWN) else "other formulations")

    fit = [p for p in points if belongs(p) and p.error is not None and p.error <= level]
    costs = [p.cost for p in fit if p.cost is not None]
    return f"{1e3 * duration * min(c.median for c in costs):.3g}" if costs else "-"
