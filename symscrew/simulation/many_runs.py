"""Many runs of one scene from other states and with other parameters, at once on the threads of this processor.

    scene, arrays --starts_of--> Starts --a compiled loop per thread--> histories --observed--> Run after Run --> Runs

Every run is that of `simulate` on the scene that it would have by itself: the same loop, the same second run that
judges it, the same verdict. A loop has its own copy of the library, for it keeps contacts and counters to itself.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from queue import LifoQueue

import numpy as np

from symscrew.array_archives import MAX_BYTES, MAX_TOGETHER
from symscrew.errors import DescriptionError, expect
from symscrew.model import Model
from symscrew.results import Columns
from symscrew.runtime import CompileError, find_compiler
from symscrew.scene import Scene, TimeFeatures, features_in_time
from symscrew.simulation.given_starts import Starts, off_the_loops, starts_of
from symscrew.simulation.initial import initial_states, initial_states_together
from symscrew.simulation.motion import ON_NUMPY, Run, integrated, judged, observed, one_line, prepare, told_at_start
from symscrew.simulation.native import NATIVE_METHODS, Library, run_natively
from symscrew.simulation.recording import Estimate, History, State
from symscrew.simulation.run_columns import columns_of
from symscrew.simulation.run_source import table_code
from symscrew.simulation.run_time_values import far_in_size
from symscrew.simulation.state_programs import Plant
from symscrew.simulation.verdict import estimated

# Runs that are observed together: functions are evaluated at all of their samples at once, which costs a few times as
# much as at one; more would only take more memory.
BLOCK = 256
COUNTERS = ("steps", "rejected", "careful", "evaluations")


@dataclass(frozen=True, repr=False)
class Runs:
    """Runs of one scene, n of them, at m outputs; behind the end of a run that ended early everything is NaN.

    t (m,) [s], q (n, m, nq), v (n, m, nv), u (n, m, drives), x (n, m, states), energy (n, m, 2) [J], closure_error and
    energy_balance (n, m), reactions (n, m, 6 joints) or None: as of a `Run`. parameters (n, np): values of the run-time
    parameters. ok (n,): whether a run came to its end and is as accurate as asked for; status: its verdict in words;
    end (n,) [s]: where it ended, NaN where it could not start; estimated_error (n,); counters: name -> (n,). events,
    crossings: of every run what happened, and times [s] of singular configurations. `backend`, `threads`: how it was
    computed.
    """

    scene: Scene
    model: Model
    t: np.ndarray
    q: np.ndarray
    v: np.ndarray
    u: np.ndarray
    x: np.ndarray
    energy: np.ndarray
    closure_error: np.ndarray
    energy_balance: np.ndarray
    reactions: np.ndarray | None
    parameters: np.ndarray
    ok: np.ndarray
    status: tuple[str, ...]
    end: np.ndarray
    estimated_error: np.ndarray
    counters: Mapping[str, np.ndarray]
    modes: tuple[tuple[str, str], ...]
    events: tuple[tuple[str, ...], ...]
    crossings: tuple[tuple[float, ...], ...]
    x_labels: tuple[str, ...]
    backend: str
    threads: int

    def __len__(self) -> int:
        return len(self.ok)

    def __repr__(self) -> str:
        return f"<Runs {self.scene.name}: {len(self)} runs of {len(self.t)} outputs, {int(self.ok.sum())} good>"

    @cached_property
    def all_ok(self) -> bool:
        """Whether every run came to its end and is as accurate as asked for."""
        return bool(self.ok.all())

    def columns(self, k: int) -> Columns:
        """Columns of run k by name over t, as those of a `Run`."""
        parts = {key: getattr(self, key)[k] for key in ("q", "v", "u", "x", "energy")}
        parts |= {key: getattr(self, key)[k] for key in ("closure_error", "energy_balance")}
        return columns_of(f"{self.scene.name} {k}", self.model, self.t, parts, x_labels=self.x_labels)


def simulate_many(
    scene: Scene,
    starts: Mapping[str, np.ndarray],
    *,
    threads: int | None = None,
    backend: str | None = None,
    progress: Callable[[int], None] | None = None,
    prepared: tuple[Model, Plant] | None = None,
) -> Runs:
    """Runs of a scene from many starts.

    Args:
        scene: what all runs have in common.
        starts: arrays by name, what differs: `initial.coordinates.LABEL`, `initial.rates.LABEL`, `parameters.NAME`
            (n,), or whole states `q`, `v`, `x` (n, size), in SI units.
        threads: default: one per processor. Results do not depend on it.
        backend: "c" (compiled) or "numpy"; default as of `simulate`.
        progress: called with the number of runs that are done.
        prepared: model and programs of an earlier `prepare(scene)`.

    Raises:
        DescriptionError: arrays that do not fit the scene, results that would not fit into memory and file, or no
            start from which the scene can begin.
        ValueError: an unknown backend, no thread.
    """
    expect(scene, Scene)
    if threads is not None and threads < 1:
        raise ValueError(f"expected at least one thread, got {threads}")
    if backend not in (None, "c", "numpy"):
        raise ValueError(f"expected the backend 'c' or 'numpy', got {backend!r}")
    model, plant = prepared or prepare(scene)
    found = starts_of(scene, model, plant, starts)
    made = _Packed(found, model, plant)
    useful = min(threads or os.cpu_count() or 1, max(found.count, 1), BLOCK)  # each has a copy of the library
    work = _Work(found, model, plant, threads=useful, backend=backend)
    for first in range(0, found.count, BLOCK):
        block = range(first, min(first + BLOCK, found.count))
        for k, run in work.of(block):
            made.put(k, run)
        if progress is not None:
            progress(block.stop)
    if not np.isfinite(made.end).any():
        raise DescriptionError(f"none of {found.count} runs can start; the first: {made.status[0]}")
    return made.whole(work)


@dataclass(frozen=True)
class _Begun:
    """A run that can start: its scene, its programs, its state, and what its inputs do in time."""

    scene: Scene
    plant: Plant
    start: State
    told: tuple[str, ...]
    features: TimeFeatures | None


class _Work:
    """Runs of a block: starts, then the loops in threads, then what is looked at."""

    def __init__(self, starts: Starts, model: Model, plant: Plant, *, threads: int, backend: str | None) -> None:
        self.starts, self.model, self.plant = starts, model, plant
        self.threads, self.backend, self.notice = threads, backend, ""
        self.unchanging: TimeFeatures | None = None
        self.loops: LifoQueue[Library] = LifoQueue()
        chosen = backend or ("c" if find_compiler() else "numpy")
        if chosen == "c" and starts.scene.integrator.method in NATIVE_METHODS:
            self._compile()
        self.compiled = not self.loops.empty()
        self.threads = self.threads if self.compiled else 1

    def _compile(self) -> None:
        try:
            first = Library(self.plant, table_code(list(self.starts.scene.tables.values())))
        except CompileError as error:
            if self.backend is not None:
                raise
            self.notice = f"{ON_NUMPY}, some hundred times slower than compiled: {one_line(error)}"
            return
        for loop in (first, *(first.another() for _ in range(self.threads - 1))):
            self.loops.put(loop)

    @property
    def told(self) -> str:
        """The backend in a word."""
        return "c" if self.compiled else "library"

    def of(self, block: Sequence[int]) -> Iterator[tuple[int, Run | str]]:
        """(number, run) of every run; of one that cannot start the reason."""
        begun = self._begun(block)
        ready = {k: start for k, start in begun.items() if isinstance(start, _Begun)}
        if self.threads > 1:
            with ThreadPoolExecutor(self.threads) as pool:
                done = dict(zip(ready, pool.map(self._tried, ready.values()), strict=True))
        else:
            done = {k: self._tried(start) for k, start in ready.items()}
        yield from ((k, text) for k, text in begun.items() if isinstance(text, str))
        yield from ((k, text) for k, text in done.items() if isinstance(text, str))
        good = {k: history for k, history in done.items() if isinstance(history, History)}
        of = [(ready[k].scene, ready[k].plant, history) for k, history in good.items()]
        for k, run in zip(good, observed(self.model, of), strict=True):
            yield k, judged(run)

    def _begun(self, block: Sequence[int]) -> dict[int, _Begun | str]:
        """The runs of a block that can start, and of the others why not."""
        scenes = {k: self.starts.scene_of(k) for k in block}
        plants = {k: self._plant(k) for k in block}
        if "q" in self.starts.whole:
            states = [self._checked(k, plants[k]) for k in block]
        else:
            asked = [(scenes[k], plants[k].parameters) for k in block]
            together = initial_states_together(self.model, asked)
            states = [found if isinstance(found, tuple) else str(found) for found in together]
        found: dict[int, _Begun | str] = {}
        for k, state in zip(block, states, strict=True):
            try:
                found[k] = state if isinstance(state, str) else self._with_states(k, scenes[k], plants[k], state)
            except DescriptionError as error:  # parameters that no mechanism has
                found[k] = str(error)
        return found

    def _plant(self, k: int) -> Plant:
        if not self.starts.parameters:
            return self.plant
        return replace(self.plant, parameters=self.starts.parameters_of(k, self.plant))

    def _checked(self, k: int, plant: Plant) -> tuple[np.ndarray, np.ndarray] | str:
        q, v = self.starts.whole_state(k)
        return off_the_loops(plant, q, v) or (q, v)

    def _with_states(self, k: int, scene: Scene, plant: Plant, state: tuple[np.ndarray, np.ndarray]) -> _Begun:
        given = self.starts.whole.get("x")
        if given is None or self.starts.parameters:  # which are looked at with the states of the scene
            x = initial_states(scene, self.model, *state)
        x = x if given is None else np.array(given[k])
        x = np.concatenate([x, np.zeros(len(plant.x_labels) - len(x))])
        told = () if "q" in self.starts.whole else told_at_start(scene, self.model, *state)
        features = self._features(scene) if self.compiled else None  # here: threads would share the tape
        return _Begun(scene, plant, (*state, x), told, features)

    def _tried(self, run: _Begun) -> History | str:
        try:
            found = self._natively(run) if self.compiled else self._slowly(run)
            return replace(found, events=(*run.told, *found.events))
        except DescriptionError as error:
            return str(error)

    def _natively(self, run: _Begun) -> History:
        features = run.features
        loop = self.loops.get()
        try:
            loop.put(run.plant)

            def go(scene: Scene) -> History:
                return run_natively(loop, scene, run.start, features=features)

            found = go(run.scene)
            return replace(found, estimate=estimated(run.scene, run.plant.system, found, go))
        finally:
            self.loops.put(loop)

    def _slowly(self, run: _Begun) -> History:
        contacts = [c for e in run.scene.effects for c in e.contacts()]
        found = integrated(run.scene, run.plant, run.start, contacts=contacts, backend=self.backend)
        return replace(found, events=(self.notice, *found.events)) if self.notice else found

    def _features(self, scene: Scene) -> TimeFeatures:
        """What inputs do in time, which only parameters can make another thing from run to run."""
        if self.starts.parameters:
            return features_in_time(scene, self.model)
        if self.unchanging is None:
            self.unchanging = features_in_time(scene, self.model)
        return self.unchanging


class _Packed:
    """Arrays of all runs, filled run by run."""

    def __init__(self, starts: Starts, model: Model, plant: Plant) -> None:
        """Room for all.

        Raises:
            DescriptionError: it is more than a file can hold that this package reads.
        """
        self.starts, self.model, self.plant = starts, model, plant
        self.t = starts.scene.times
        forward = {port.name: port.size for port in model.programs["forward_dynamics"].inputs}
        driven = forward.get("u", 0) if plant.inputs.outputs else 0
        joints = len(model.mechanism.joints) if starts.scene.reactions else 0
        columns = {key: plant.sizes[key] for key in ("q", "v", "x")} | {
            "u": driven,
            "energy": 2,
            "reactions": 6 * joints,
        }
        n, m = starts.count, len(self.t)
        self._check(n, m, [*columns.values(), 1, 1])
        self.arrays = {key: np.full((n, m, size), np.nan) for key, size in columns.items()}
        self.arrays |= {key: np.full((n, m), np.nan) for key in ("closure_error", "energy_balance")}
        self.ok, self.end, self.error = np.zeros(n, dtype=bool), np.full(n, np.nan), np.full(n, np.nan)
        self.status = [""] * n
        self.counters = {name: np.zeros(n) for name in COUNTERS}
        self.modes = [("", "")] * n
        self.events: list[tuple[str, ...]] = [()] * n
        self.crossings: list[tuple[float, ...]] = [()] * n
        self.x_labels = plant.x_labels

    def _check(self, runs: int, outputs: int, columns: Sequence[int]) -> None:
        double = np.dtype(float).itemsize
        largest, together = (double * runs * outputs * size for size in (max(columns), sum(columns)))
        if largest > MAX_BYTES or together > MAX_TOGETHER:
            raise DescriptionError(
                f"starts: {runs} runs of {outputs} outputs are {together / 1e9:.3g} GB, of which one array has "
                f"{largest / 1e9:.3g}; expected at most {MAX_TOGETHER / 1e9:g} and {MAX_BYTES / 1e9:g}: take a lower "
                "[scene] rate (the end is always an output), or several files of starts"
            )

    def put(self, k: int, run: Run | str) -> None:
        """Run k, or why it cannot start."""
        if isinstance(run, str):
            self.status[k] = f"not started: {run}{self._of_size(k)}"
            return
        count = int(np.count_nonzero(run.t[: len(self.t)] == self.t[: len(run.t)]))
        for key, array in self.arrays.items():
            values = getattr(run, key)
            if values is not None and array[k].size:
                array[k, :count] = values[:count]
        self.ok[k], self.status[k], self.end[k] = run.ok and run.accurate, run.verdict or run.status, run.t[-1]
        self.status[k] += "" if self.ok[k] else self._of_size(k)
        self.error[k] = (run.estimate or Estimate()).error
        for name in COUNTERS:
            self.counters[name][k] = run.counters.get(name, 0.0)
        self.modes[k], self.events[k] = run.modes, run.events
        self.crossings[k] = tuple(c.t for c in run.crossings)

    def _of_size(self, k: int) -> str:
        """Beside what went wrong: that the run's parameters make another size than the functions were derived for."""
        text = far_in_size(self.starts.scene_of(k), self.model)
        return f"; {text}" if text else ""

    def whole(self, work: _Work) -> Runs:
        """All of them."""
        starts, arrays = self.starts, self.arrays
        parameters = np.array([starts.parameters_of(k, self.plant) for k in range(starts.count)])
        reactions = arrays["reactions"] if starts.scene.reactions else None
        return Runs(
            starts.scene, self.model, self.t, arrays["q"], arrays["v"], arrays["u"], arrays["x"], arrays["energy"],
            arrays["closure_error"], arrays["energy_balance"], reactions, parameters, self.ok, tuple(self.status),
            self.end, self.error, self.counters, tuple(self.modes), tuple(self.events), tuple(self.crossings),
            self.x_labels, work.told, work.threads,
        )  # fmt: skip
