"""Benchmark problems and hard cases with their references, each as a scene and a measure of its error.

The benchmarks are the scenes of examples/benchmarks that have a reference history beside them; the hard cases have
closed forms, or histories in tests/data with their source.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
from hard.mechanisms import four_bars, swung

from symscrew.description import load_description
from symscrew.effects import Gravity
from symscrew.model import Model
from symscrew.scene import Scene, load_scene
from symscrew.scene.contents import Initial
from symscrew.simulation import native
from symscrew.simulation.initial import initial_state, initial_states
from symscrew.simulation.motion import prepare
from symscrew.simulation.recording import History, State
from symscrew.simulation.state_programs import Plant
from symscrew.studies.accuracy.run_history import read_reference

Array = np.ndarray
Measure = Callable[[Array], float]  # of q (outputs, nq)
TESTS = Path(__file__).parents[1]
BENCHMARKS = TESTS.parent / "examples" / "benchmarks"
OF_EFFECTS = ("ideal_disc", "loose_crank")  # a constraint of the rates; a law of contact that begins at once
ROUNDING = 2.0**-53
SEED = "hanging_platform"


@dataclass(frozen=True)
class Problem:
    """A scene, and what makes the measure of its error once its model is there."""

    name: str
    scene: Scene
    measure: Callable[[Model], Measure]


@dataclass(frozen=True)
class Compiled:
    """A problem whose loop is compiled."""

    problem: Problem
    model: Model
    plant: Plant
    library: native.Library
    start: State
    error: Measure

    def run(self, **integrator: object) -> History:
        """With another integrator."""
        scene = self.problem.scene
        chosen = replace(scene, integrator=replace(scene.integrator, **integrator))  # type: ignore[arg-type]
        return native.run_natively(self.library, chosen, self.start)

    def runs(self, count: int, **integrator: object) -> list[History]:
        """`count` runs whose starts differ by one unit in the last place each, the first from the start itself."""
        q, v, x = self.start
        factors = [1 + 2 * k * ROUNDING for k in range(count)]
        return [replace(self, start=(q * f, v * f, x)).run(**integrator) for f in factors]

    def usual_error(self, **integrator: object) -> float:
        """The median error of three such runs: that of one is a sample, and other instructions draw another one.

        Of steps that are given, of nine runs with steps up to a tenth shorter or longer: where in a step an impact's
        friction turns makes errors of one length some twenty times those of another. The loose crank's turns within
        0.01 m/s, a part of a step; that steps end where contacts begin does not help (with 1 m/s, or without friction,
        errors are 40 to 400 times smaller; landing on every corner leaves them as they are).
        """
        if "step" not in integrator:
            runs = self.runs(3, **integrator)
        else:
            step = float(str(integrator["step"]))
            runs = [self.run(**{**integrator, "step": step * f}) for f in np.linspace(0.9, 1.1, 9)]
        return float(np.median([self.error(run.q) if run.ok else np.inf for run in runs]))

    def noise(self, **integrator: object) -> float:
        """What rounding leaves of results: twice the usual (median) distance of five such runs from their middle.

        Not the largest distance, which is one run's: another machine's instructions take another one for it.
        """
        found = np.array([run.q for run in self.runs(5, **integrator)])
        return 2 * float(np.median(np.abs(found - np.median(found, axis=0)).max(axis=(1, 2))))

    def growth(self, places: int = 6) -> float:
        """By how much an error of the state grows at most: of q and v that are changed by 1e-8 of their size at the
        start and at `places` - 1 times between, at all outputs behind, by that change."""
        whole, times, largest = self.run(tolerance=1e-11), self.problem.scene.times, 1.0
        rng = np.random.default_rng(5)
        for k in np.linspace(0, len(times) - 1, places, endpoint=False).astype(int):
            state = whole.q[k], whole.v[k], whole.x[k]
            size = max(float(np.abs(state[1]).max()), 1.0)
            along = 1e-8 * size * rng.normal(size=len(state[1]))
            turned = self.plant.system.advance(state[0][None], along[None])[0]
            moved = turned, state[1] + along, state[2]
            one, other = (self._onwards(float(times[k]), s, k) for s in (state, moved))
            if len(one) == len(other) > 1:
                largest = max(largest, float(np.abs(one - other).max()) / (1e-8 * size))
        return largest

    def _onwards(self, t: float, state: State, first: int) -> Array:
        """q at the outputs from the given one on."""
        log = native.RunLog.empty(self.library, self.problem.scene.times[first:])
        scene = self.problem.scene
        features = native.features_in_time(scene, self.model)
        local = native.LOCAL * 1e-11
        if self.library.start(
            t, *state, method="dop853", h=0.0, rtol=local, atol=local, longest=scene.duration, budget=10**6,
            features=features,
        ):  # fmt: skip
            return np.zeros((0, 0))
        while self.library.advance(native.PORTION, log) == native.GOING_ON:
            pass
        return log.q[: int(log.written[0])]


def _benchmark(path: Path) -> Problem | None:
    reference = read_reference(path)
    if reference is None:
        return None
    scene = load_scene(path)
    scene = replace(scene, rate=1.0 / float(reference.times[1]), duration=float(reference.times[-1]))
    scene = replace(scene, integrator=replace(scene.integrator, method="dop853", step=None))
    return Problem(path.stem, scene, reference.error_of)


def _row(name: str, count: int, *, link: str = "1", coupler: str = "1", duration: float = 3.0) -> Problem:
    """`count` four-bars in a row, through their change points; the first crank against the closed form."""
    mechanism = four_bars(count, link=link, coupler=coupler)
    scene = Scene(name, mechanism, (Gravity((0, "-9.81", 0)),), duration, 20.0, Initial(rates={"A0": -1.0}))
    mass, other = float(link), float(coupler)
    inertia = (count + 1) * mass / 3 + count * other
    moment = ((count + 1) * mass / 2 + count * other) * 9.81

    def measure(model: Model) -> Measure:
        at = [c.label for c in model.system.tree.q].index("A0")
        return lambda q: float(np.abs(-q[:, at] - swung(inertia, moment, 1.0, scene.times)).max())

    return Problem(name, scene, measure)


def five_bar(until: float = 2.0) -> tuple[Scene, Array]:
    """The five-bar that passes near places where its distal rods align, and q at its outputs (outputs, 5).

    tests/data/README.md says where that comes from.
    """
    content = json.loads((TESTS / "data" / "dynamics" / "short_five_bar.json").read_text(encoding="utf-8"))
    start = Initial(rates=content["rates"])
    mechanism = load_description(TESTS / "data" / "short_five_bar.toml")
    times, values = np.array(content["times"]), np.array(content["values"], dtype=float)
    kept = times <= until
    return Scene("short_five_bar", mechanism, (Gravity(),), until, 1.0 / float(times[1]), start), values[kept]


def _five_bar() -> Problem:
    scene, expected = five_bar()
    return Problem("short_five_bar", scene, lambda model: lambda q: float(np.abs(q - expected).max()))


@cache
def problems() -> Mapping[str, Problem]:
    """All of them by name."""
    found = [p for path in sorted(BENCHMARKS.glob("*.toml")) if (p := _benchmark(path)) is not None]
    found += [p for name in OF_EFFECTS if (p := _benchmark(BENCHMARKS.parent / "effects" / f"{name}.toml")) is not None]
    found += [_row("change_point", 1), _row("row_of_four", 4), _row("light_coupler", 2, coupler="1e-9")]
    found += [_row("heavy_coupler", 2, coupler="1e9"), _five_bar()]
    return {p.name: p for p in found}


@cache
def compiled(name: str) -> Compiled:
    """A problem with its loop; the seed is one too."""
    if name != SEED:
        return compiled_of(problems()[name])
    case = compiled_of(Problem(SEED, _seed(), lambda model: lambda q: 0.0))
    expected = case.run(tolerance=1e-13).q
    return replace(case, error=lambda q: float(np.abs(q - expected).max()))


def compiled_of(problem: Problem) -> Compiled:
    """A problem with its loop."""
    scene = problem.scene
    model, plant = prepare(scene)
    q, v = initial_state(scene, model, plant.parameters)
    x = initial_states(scene, model, q, v)
    start = q, v, np.concatenate([x, np.zeros(len(plant.x_labels) - len(x))])
    library = native.Library(plant, native.table_code(list(scene.tables.values())))
    return Compiled(problem, model, plant, library, start, problem.measure(model))


def _seed() -> Scene:
    """The seed as a pendulum, which has no reference but itself."""
    return replace(load_scene(BENCHMARKS.parent / "scenes" / "hanging_platform.toml"), duration=10.0)
