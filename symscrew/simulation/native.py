"""The compiled run: generated functions and the integration loop in one library, called once per portion of steps.

Plant, tables --run_source, C compiler--> Library --start, advance--> RunLog --> History
"""

from __future__ import annotations

import ctypes
import hashlib
import math
import tempfile
from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from symscrew.runtime import compile_c
from symscrew.scene import INTEGRATION_METHODS, UNCHANGING, Scene, TimeFeatures, features_in_time
from symscrew.simulation.landing import passed
from symscrew.simulation.native_contacts import MOST_EVENTS, NativeContacts
from symscrew.simulation.recording import History, Instant, Passage, State, shown_time
from symscrew.simulation.run_source import SPAN, contact_numbers, rules_of, sources, table_code
from symscrew.simulation.scene_functions import VAGUE
from symscrew.simulation.state_programs import Plant
from symscrew.simulation.verdict import estimated

NATIVE_FLAGS = ("-O3", "-fno-trapping-math")
NEAR_FLAGS = ("-O1",)  # of what a run calls near singular places only: compiled in a third of the time
NATIVE_METHODS = {name: m.kernel for name, m in INTEGRATION_METHODS.items() if m.kernel is not None}
GOING_ON = 1  # outcome of the compiled loop: its portion of steps is used up
EVENT = 8  # outcome of the compiled loop: the mode of a contact has ended
NEEDS_PRECISION = 11  # outcome of the compiled loop: it is near a singular configuration for the first time


MOST_CROSSINGS = 10_000  # singular configurations that a run records; it goes on beyond, and an event says so
LOCAL, LEAST = 1e-3, 3e-15  # local errors are a part of the error aimed at, but not below rounding of a step


@dataclass(frozen=True)
class RunLog:
    """Arrays that a compiled run fills: samples q, v, x (n, ...) at `times` (n,), singular configurations met.

    `written`, `met`: how many samples and crossings there are so far, a size_t each.
    """

    times: np.ndarray
    q: np.ndarray
    v: np.ndarray
    x: np.ndarray
    crossings: np.ndarray
    written: np.ndarray
    met: np.ndarray

    @staticmethod
    def empty(library: Library, times: np.ndarray, most_crossings: int | None = None) -> RunLog:
        """Room for samples at all times."""
        q, v, x = (np.zeros((len(times), max(library.plant.sizes[k], 1))) for k in "qvx")
        counts = (np.zeros(1, dtype=np.uintp) for _ in range(2))
        return RunLog(times, q, v, x, np.zeros(most_crossings or MOST_CROSSINGS, dtype=library.crossing), *counts)


class Library:
    """A compiled run: `start`, then `advance` until it is not going on."""

    def __init__(self, plant: Plant, tables: str = "", flags: Sequence[str] | None = None) -> None:
        self.plant = plant
        text, self._near_text = sources(plant, tables)
        self._near_flags = NEAR_FLAGS if flags is None else tuple(flags)
        self._made = _compiled(text, NATIVE_FLAGS if flags is None else flags)
        self.hash = hashlib.sha256(text.encode()).hexdigest()[:16]
        self._load()

    def another(self) -> Library:
        """The same loop once more, for another thread: with contacts, counters and parameters of its own."""
        made = copy(self)
        made._load()
        return made

    def _load(self) -> None:
        plant = self.plant
        self.code = _loaded(self._made)
        self._precise: ctypes.CDLL | None = None
        for name in ("simulation_size", "crossing_size"):
            getattr(self.code, name).restype = ctypes.c_size_t
        self.code.simulation_start.restype = self.code.simulation_advance.restype = ctypes.c_int
        self.state = np.zeros(self.code.simulation_size() // 8 + 8)
        nq, nv, nr = plant.sizes["q"], plant.sizes["v"], len(plant.rows)
        self.crossing = np.dtype(
            [("t", "f8"), ("pivot", "f8"), ("q", "f8", (max(nq, 1),)), ("v", "f8", (max(nv, 1),)), ("lost", "f8"),
             ("rows", "f8", (max(nr, 1),))]
        )  # fmt: skip
        assert self.crossing.itemsize == self.code.crossing_size()
        self.put(plant)

    def put(self, plant: Plant) -> None:
        """Other values of the run-time parameters, from the next start on; `plant` differs in nothing else."""
        self.plant = plant
        if len(plant.parameters):
            numbers = [number for rule in rules_of(plant) for number in contact_numbers(rule)]
            arrays = [np.ascontiguousarray(values, dtype=float) for values in (plant.parameters, numbers)]
            self.code.simulation_parameters(*map(_pointer, arrays))
            if self._precise is not None:
                self._precise.precise_parameters(*map(_pointer, arrays))

    def start(
        self, t: float, q: np.ndarray, v: np.ndarray, x: np.ndarray, *, method: str, h: float, rtol: float,
        atol: float, longest: float, budget: int, features: TimeFeatures = UNCHANGING,
    ) -> int:  # fmt: skip
        """Begin at a state, with steps of h [s] (0: chosen) or local tolerances; 0 where that is possible.

        `features`: what inputs do in time, by which steps are bounded.
        """
        d = ctypes.c_double
        self.features = features  # the loop reads these arrays as long as it runs
        arrays = [np.ascontiguousarray(a, dtype=float) for a in (q, v, x)]
        outcome = int(
            self.code.simulation_start(
                _pointer(self.state), d(t), *map(_pointer, arrays), ctypes.c_int(NATIVE_METHODS[method]), d(h), d(rtol),
                d(atol), d(longest), ctypes.c_long(budget), _pointer(features.edges), _pointer(features.lefts),
                ctypes.c_size_t(len(features.edges)),
            )
        )  # fmt: skip
        self._offer_precision()
        return outcome

    def _offer_precision(self) -> None:
        """Hand the loop the branch in extended precision, if it is compiled; else it says when it needs that."""
        found, rounding = self._precise, 1.0
        if found is not None:
            found.precise_rounding.restype = ctypes.c_double
            rounding = found.precise_rounding()
        names = ("precise_anchor", "precise_state")
        doors = [ctypes.c_void_p() if found is None else ctypes.cast(found[n], ctypes.c_void_p) for n in names]
        self.code.simulation_precision(_pointer(self.state), *doors, ctypes.c_double(rounding))

    def change(self, q: np.ndarray, v: np.ndarray, modes: Sequence[int]) -> int:
        """Go on from another state and other modes of the contacts; 0 where that is possible."""
        arrays = [np.ascontiguousarray(a, dtype=float) for a in (q, v, modes)]
        return int(self.code.simulation_change(_pointer(self.state), *map(_pointer, arrays)))

    def accelerations(self, t: float, state: State, forces: np.ndarray) -> np.ndarray:
        """Accelerations (nv,) by given forces of the contacts."""
        a = np.zeros(max(self.plant.sizes["v"], 1))
        arrays = [np.ascontiguousarray(part, dtype=float) for part in (*state, forces)]
        outcome = self.code.simulation_accelerations(ctypes.c_double(t), *map(_pointer, arrays), _pointer(a))
        return a[: self.plant.sizes["v"]] if outcome == 0 else np.full(self.plant.sizes["v"], np.nan)

    def advance(self, most: int, log: RunLog) -> int:
        """Go on for at most `most` steps, into the log; see simulation.c for the outcome.

        What is needed near singular configurations is compiled when the first run comes there.
        """
        outcome = int(
            self.code.simulation_advance(
                _pointer(self.state), ctypes.c_long(most), _pointer(log.times), ctypes.c_size_t(len(log.times)),
                _pointer(log.written), *map(_pointer, (log.q, log.v, log.x, log.crossings)),
                ctypes.c_size_t(len(log.crossings)), _pointer(log.met),
            )
        )  # fmt: skip
        if outcome == NEEDS_PRECISION:
            self._precise = _loaded(_compiled(self._near_text, self._near_flags))
            self.put(self.plant)
            self._offer_precision()
            return GOING_ON
        return outcome

    def fastest(self) -> Instant | None:
        """The state with the greatest rates at the end of a step so far; None: nothing moved."""
        sizes, t = self.plant.sizes, np.zeros(1)
        q, v, x = (np.zeros(max(sizes[k], 1)) for k in "qvx")
        moved = self.code.simulation_fastest(*map(_pointer, (self.state, t, q, v, x)))
        return Instant(float(t[0]), q[: sizes["q"]], v[: sizes["v"]], x[: sizes["x"]]) if moved else None

    def report(self) -> tuple[float, State, dict[str, float]]:
        """Time, (q, v, x) and counters now."""
        sizes = self.plant.sizes
        t, numbers = np.zeros(1), np.zeros(9)
        q, v, x = (np.zeros(max(sizes[k], 1)) for k in "qvx")
        self.code.simulation_report(*map(_pointer, (self.state, t, q, v, x, numbers)))
        names = ("steps", "rejected", "careful", "evaluations", "pivot", "h", "reason", "event", "unlooked")
        state = q[: sizes["q"]], v[: sizes["v"]], x[: sizes["x"]]
        return float(t[0]), state, dict(zip(names, numbers.tolist(), strict=False))


def _compiled(text: str, flags: Sequence[str]) -> bytes:
    """A C file as a library."""
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        file, library = Path(temporary) / "run.c", Path(temporary) / "run.so"
        file.write_text(text, encoding="utf-8")
        compile_c(file, library, flags=flags)
        return library.read_bytes()


def _loaded(library: bytes) -> ctypes.CDLL:
    """A library, with variables of its own every time; it stays mapped when its file is gone."""
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        file = Path(temporary) / "run.so"
        file.write_bytes(library)
        return ctypes.CDLL(str(file))


def _pointer(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


ENDINGS = {
    2: "the step had to become too small",
    3: "more steps than most_steps allows",
    4: "the loops could not be closed again",
    5: "the accelerations are not defined",
    9: f"more than {MOST_EVENTS} changes of contact",
    10: "the law of impact of the stops that are met there has no solution that was found",
    12: VAGUE,
    6: "at rest in a singular configuration, where several motions begin: none of them is singled out",
}
PORTION = 20_000  # steps between two looks at the progress, some milliseconds to a second
# A run that stops with its smallest pivot below this part of a regular one says that the closure is near-singular.
NEAR_SINGULAR = 0.25


def integrate_natively(
    scene: Scene, plant: Plant, start: State, progress: Callable[[float], None] | None = None
) -> History:
    """The run of a scene from (q, v, x) by the compiled loop, with an estimate of its error by runs with other steps;
    `progress` is called with the part done."""
    library = Library(plant, table_code(list(scene.tables.values())))
    found = run_natively(library, scene, start, progress)
    estimate = estimated(scene, plant.system, found, lambda other: run_natively(library, other, start))
    return replace(found, estimate=estimate)


def run_natively(
    library: Library,
    scene: Scene,
    start: State,
    progress: Callable[[float], None] | None = None,
    *,
    features: TimeFeatures | None = None,
) -> History:
    """The run of a scene by a compiled loop that is there already; `features` of its inputs, if they are known."""
    choice, log = scene.integrator, RunLog.empty(library, scene.times)
    local = max(LOCAL * choice.tolerance, LEAST)
    h = choice.step or 0.0
    if h:  # outputs fall on ends of steps
        h = 1.0 / scene.rate / max(1, math.ceil(1.0 / scene.rate / h - 1e-9))
    features = features_in_time(scene, library.plant.model) if features is None else features
    contacts = NativeContacts(library, scene, start)
    outcome = library.start(
        0.0, *start, method=choice.method, h=h, rtol=local, atol=local,
        longest=choice.longest_step or scene.duration, budget=choice.most_steps,
        features=features,
    )  # fmt: skip
    if outcome == 0:
        outcome = contacts.begun(GOING_ON)
    while outcome in (GOING_ON, EVENT):
        outcome = library.advance(PORTION, log)
        if outcome == EVENT:
            outcome = contacts.met(GOING_ON)
        if progress is not None:
            progress(float(log.times[max(int(log.written[0]) - 1, 0)]) / scene.duration)
    found = _history(library, log, outcome)
    forces = contacts.forces(found.t, found.q, found.v, found.x)
    unseen = features.passed(h, SPAN) if h else ()
    events = (*features.notices, *unseen, *contacts.events, *found.events)
    return replace(found, events=events, losses=contacts.losses, contact_forces=forces, passing=bool(unseen))


def _history(library: Library, log: RunLog, outcome: int) -> History:
    """What was logged, how far the run came, and the outcome in words."""
    plant, sizes = library.plant, library.plant.sizes
    t, last, counters = library.report()
    n = int(log.written[0])
    times, q, v, x = log.times[:n], log.q[:n, : sizes["q"]], log.v[:n, : sizes["v"]], log.x[:n, : sizes["x"]]
    if outcome != 0 and (n == 0 or t > times[-1]):
        times = np.append(times, t)
        q, v, x = (np.append(a, [b], axis=0) for a, b in zip((q, v, x), last, strict=True))
    text = "completed" if outcome == 0 else f"stopped at t = {shown_time(t)} s: {ENDINGS.get(outcome, 'unknown')}"
    if outcome != 0 and plant.closure is not None and counters["pivot"] < NEAR_SINGULAR * plant.pivot:
        text += (
            f"; the closure is near-singular there (smallest pivot {counters['pivot'] / plant.pivot:.2g} of regular)"
        )
    full = int(log.met[0]) == len(log.crossings)
    recorded = (f"{len(log.crossings)} singular configurations are recorded; later ones are not",) if full else ()
    events = (*recorded, *passed(counters["unlooked"]))
    passages = tuple(_passage(plant, c) for c in log.crossings[: int(log.met[0])])
    fastest = library.fastest()
    return History(times, q, v, x, outcome == 0, text, "c", passages, events, counters, fastest=fastest)


def _passage(plant: Plant, c: np.void) -> Passage:
    rows = tuple(int(k) for k in np.flatnonzero(c["rows"][: len(plant.rows)] > 0.5))
    return Passage(float(c["t"]), np.array(c["q"][: plant.sizes["q"]]), float(c["pivot"]), int(c["lost"]), rows)
