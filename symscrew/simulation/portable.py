"""Runs by well-kept libraries, step by step from Python: SciPy's integrators, SUNDIALS through CasADi.

For stiff scenes, for contacts with events, for controllers that are Python functions, and where there is no
C compiler. One-step methods are projected onto the closure after every step, the others at every output, where they
start again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from symscrew.effects import Contact
from symscrew.errors import DescriptionError
from symscrew.scene import INTEGRATION_METHODS, Scene, features_in_time
from symscrew.simulation import contacts as contact
from symscrew.simulation.complementarity import UndecidedError
from symscrew.simulation.fixed_steps import FIXED_STEPS, cubic, scipy_integrate
from symscrew.simulation.landing import LANDINGS, SHORT, Corners, passed
from symscrew.simulation.mode_changes import Change, beginning, change, onto_stops
from symscrew.simulation.mode_ends import first_end
from symscrew.simulation.native_contacts import MOST_EVENTS
from symscrew.simulation.recording import History, Instant, State, faster, shown_time
from symscrew.simulation.run_source import SPAN
from symscrew.simulation.scene_functions import PlantFunctions, RunError
from symscrew.simulation.singular_watch import singular_watch
from symscrew.simulation.start_branch import OF_NO_BRANCH, impact_leaves_every_branch
from symscrew.simulation.state_programs import Plant

Controller = Callable[[float, np.ndarray, np.ndarray], object]
# Local errors are held to a thousandth of the error aimed at in the result, for they add up; not below what rounding
# leaves of a step (SciPy's own least relative tolerance is 100 units in the last place).
LOCAL, LEAST_ABSOLUTE, LEAST_RELATIVE = 1e-3, 3e-14, 2.3e-14


def integrate(
    scene: Scene,
    plant: Plant,
    start: State,
    *,
    contacts: Sequence[Contact] = (),
    controller: Controller | None = None,
    compiled: bool = True,
    progress: Callable[[float], None] | None = None,
) -> History:
    """The run of a scene from (q, v, x); see the module.

    Args:
        scene: with the integrator and the times of outputs.
        plant: its programs.
        start: closes the loops.
        contacts: what sticks or hits, with events.
        controller: (t, q, v) -> u (drives,) [N, N m] in place of the scene's drives.
        compiled: whether slopes are compiled; else they are evaluated on NumPy.
        progress: called with the part done, 0 to 1.

    Raises:
        DescriptionError: the method cannot have contacts or a controller, or SciPy is missing.
    """
    rules = contact.laws(plant.model, contacts, plant.parameters)
    method = scene.integrator.method
    marching = INTEGRATION_METHODS[method].marching
    if rules and marching != "projected":
        raise DescriptionError(f"integrator.method: contacts with events need dop853 or radau, got {method}")
    if marching == "sundials":
        if controller is not None:
            raise DescriptionError(f"integrator.method: {method} takes no Python controller; use radau or bdf")
        from symscrew.simulation.sundials import integrate as by_sundials  # casadi, which the others do not need

        return by_sundials(scene, plant, start, progress)
    functions = PlantFunctions(plant, list(scene.tables.values()), compiled=compiled)
    march = _Marching(scene, functions, rules=rules, controller=controller, progress=progress)
    return march.run(start)


class _Marching:
    """State of one run: y = (q, v, x), the modes of the contacts, the samples so far."""

    def __init__(
        self,
        scene: Scene,
        functions: PlantFunctions,
        *,
        rules: Sequence[contact.Law],
        controller: Controller | None,
        progress: Callable[[float], None] | None,
    ) -> None:
        self.scene, self.f, self.rules, self.controller, self.progress = scene, functions, rules, controller, progress
        self.method = INTEGRATION_METHODS[scene.integrator.method]
        self.features, self.latest = features_in_time(scene, functions.plant.model), np.inf
        step = scene.integrator.step
        unseen = self.features.passed(step, SPAN) if step else ()
        self.notices, self.passing = (*self.features.notices, *unseen), bool(unseen)
        self.modes = contact.Modes(())
        self.fresh = -1  # the contact whose mode has just changed
        self.contact_forces: list[np.ndarray] = []  # at the samples
        self.samples: list[tuple[float, np.ndarray]] = []
        self.events: list[str] = []
        self.losses: list[tuple[float, str, float]] = []  # energy that impacts take
        self.steps = 0
        self.fastest: Instant | None = None
        self.watch = singular_watch(functions, scene.duration)
        self.corners = (
            Corners(self.conditions, functions.state_units()) if functions.plant.switches is not None else None
        )

    # -- slopes -----------------------------------------------------------------------------------------------

    def parts(self, y: np.ndarray) -> State:
        nq, nv = self.f.nq, self.f.nv
        return y[:nq], y[nq : nq + nv], y[nq + nv :]

    def commanded(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        if self.controller is None:
            return np.zeros(0)
        u = np.asarray(self.controller(t, np.array(q), np.array(v)), dtype=float).ravel()
        if u.shape != (self.f.nu,) or not np.isfinite(u).all():
            raise DescriptionError(f"controller: expected {self.f.nu} finite numbers at t = {t:g}, got {u!r:.80}")
        return u

    def accelerations(self, t: float, y: np.ndarray) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
        """Accelerations by rates and forces of the contacts; the drives are those of the state."""
        q, v, x = self.parts(y)
        u = self.commanded(t, q, v)
        return lambda rates, outside: self.f.slopes(t, q, rates, x, u=u, outside=outside)[0]

    def contacts_at(self, t: float, y: np.ndarray) -> contact.ContactState:
        q, v, _ = self.parts(y)
        return contact.ContactState(self.rules, q, v, self.f.plant.units, self.accelerations(t, y))

    def forces(self, t: float, y: np.ndarray) -> np.ndarray:
        if not self.rules:
            return np.zeros(0)
        return contact.forces(self.contacts_at(t, y), self.modes)

    def slopes(self, t: float, y: np.ndarray) -> np.ndarray:
        q, v, x = self.parts(y)
        t = min(t, self.latest)
        a, x_dot = self.f.slopes(t, q, v, x, u=self.commanded(t, q, v), outside=self.forces(t, y))
        return np.concatenate([self.f.coordinate_rates(q, v), a, x_dot])

    def conditions(self, t: float, y: np.ndarray) -> np.ndarray:
        q, v, x = self.parts(y)
        return self.f.switches(min(t, self.latest), q, v, x, u=self.commanded(t, q, v))

    def settled(self, y: np.ndarray) -> np.ndarray:
        q, v, x = self.parts(y)
        q, v, _ = self.f.settle(q, v)
        return np.concatenate([q, v, x])

    def arrived(self, t: float, y: np.ndarray) -> np.ndarray:
        """The state after a step to t, on the loops, looked at for singular configurations."""
        q, v, x = self.parts(y)
        q, v, smallest = self.f.settle(q, v)
        if self.watch is not None:
            self.watch.seen(t, smallest)
        y = np.concatenate([q, v, x])
        self.look_how_fast(t, y)
        return y

    def look_how_fast(self, t: float, y: np.ndarray) -> None:
        """Remember the state if nothing was faster so far."""
        self.fastest = faster(self.fastest, Instant(float(t), *self.parts(y)), self.f.plant.units)

    # -- the run ------------------------------------------------------------------------------------------------

    def run(self, start: State) -> History:
        times, status, ok = self.scene.times, "completed", True
        y = np.concatenate(start)
        try:
            y = np.concatenate([*self.f.settled_start(start[0], start[1]), start[2]])
            if self.rules:
                self.modes = contact.start_modes(self.contacts_at(0.0, y))
                y = self.adopted(0.0, y, beginning(self.contacts_at(0.0, y), self.modes))
            self.sample(0.0, y)
            MARCHES[self.method.marching](self, y, times)
        except (RunError, UndecidedError, FloatingPointError) as error:
            if not self.samples:
                self.samples.append((0.0, y))
                self.contact_forces.append(np.zeros(len(self.rules)))
            ok, status = False, f"stopped at t = {shown_time(self.samples[-1][0])} s: {error}"
        return self.history(ok, status)

    def sample(self, t: float, y: np.ndarray) -> None:
        self.samples.append((t, y))
        if self.rules:
            self.contact_forces.append(self.forces(t, y))
        if self.progress is not None:
            self.progress(t / self.scene.duration)

    def history(self, ok: bool, status: str) -> History:
        t = np.array([t for t, _ in self.samples])
        y = np.array([y for _, y in self.samples])
        q, v, x = y[:, : self.f.nq], y[:, self.f.nq : self.f.nq + self.f.nv], y[:, self.f.nq + self.f.nv :]
        u = None
        if self.controller is not None:
            u = np.array([self.commanded(a, b, c) for a, b, c in zip(t, q, v, strict=True)]).reshape(len(t), self.f.nu)
        forces = np.array(self.contact_forces) if self.rules else None
        counters = {"steps": float(self.steps), "evaluations": float(self.f.evaluations)}
        if self.corners is not None:
            self.events += passed(self.corners.unlooked)
        return History(
            t, q, v, x, ok, status, "library", (), (*self.notices, *self.events), counters, u, forces,
            tuple(self.losses), doubts=() if self.watch is None else self.watch.doubts,
            fastest=self.fastest, passing=self.passing)  # fmt: skip

    def solver(self, t: float, y: np.ndarray, end: float, first: float | None = None) -> Any:
        """SciPy's integrator from t to `end`, or to the next time that what inputs do there asks for; `first`: step."""
        local = max(LOCAL * self.scene.integrator.tolerance, LEAST_ABSOLUTE)
        until, self.latest = self.features.ahead(t, end, SPAN)
        longest = self.scene.integrator.longest_step or np.inf
        made = getattr(scipy_integrate(), self.method.library)
        return made(
            self.slopes, t, y, until, rtol=max(local, LEAST_RELATIVE), atol=local, max_step=longest, first_step=first
        )

    def count(self) -> None:
        self.steps += 1
        if self.steps > self.scene.integrator.most_steps:
            raise RunError("more steps than most_steps allows")

    def single_steps(self, y: np.ndarray, times: np.ndarray) -> None:
        """One-step methods: projected after every step, begun anew where a contact changes."""
        t, k = 0.0, 1
        while k < len(times):
            solver = self.solver(t, y, times[-1])
            while k < len(times):
                message = solver.step()
                self.count()
                if solver.status == "failed":
                    raise RunError(f"the integrator gave up: {message}")
                if self.corners is not None:
                    solver = self.onto_corner(self.corners, solver, y)
                dense, t, found = solver.dense_output(), solver.t, None
                if self.rules:
                    found = self.first_event(dense, solver.t_old, solver.t)
                    t = solver.t if found is None else found[0]
                while k < len(times) and times[k] <= t:
                    self.sample(float(times[k]), self.settled(dense(times[k])))
                    k += 1
                if found is not None:
                    y = self.changed(found, self.settled(dense(t)))
                    break
                y = self.arrived(solver.t, solver.y)
                solver.y = y
                if self.method.stable is not None:  # explicit: its next step begins with the slope at the end of this
                    solver.f = self.slopes(solver.t, y)
                self.fresh = -1
                if solver.status == "finished":
                    break

    def onto_corner(self, corners: Corners, solver: Any, y: np.ndarray) -> Any:
        """The integrator behind a step from y that passes no corner: it is taken again where the first one does."""
        start, natural, aimed = float(solver.t_old), solver.t - solver.t_old, None
        takes = 0
        while True:
            found = corners.end(solver.dense_output(), start, solver.t, aimed)
            if found is None or takes == LANDINGS:
                break
            takes += 1
            shorter = self.solver(start, y, found[0], first=found[0] - start)
            if shorter.step() is not None:  # it gave up: the longer step stands
                break
            aimed = found[1] if shorter.t == found[0] else None
            solver = shorter
        corners.accept(short=takes > 0 and solver.t - start < SHORT * natural)
        return solver

    def first_event(self, dense: Any, left: float, right: float) -> tuple[float, int] | None:
        """The first end of a mode within a step: its time and contact."""

        def within(part: float) -> contact.ContactState:
            t = left + part * (right - left)
            return self.contacts_at(t, dense(t))

        blurred = float(np.spacing(right)) / (right - left)
        found = first_end(within, self.modes, self.f.plant.units, self.fresh, blurred=blurred)
        if found is None:
            return None
        t = left + found[0] * (right - left)
        if contact.holds(self.rules[found[1]], self.modes.values[found[1]]):
            t = min(t + contact.LATE * abs(t), right)
        return t, found[1]

    def changed(self, found: tuple[float, int], y: np.ndarray) -> np.ndarray:
        """Rates and modes behind an event."""
        t, k = found
        self.fresh = k
        if len(self.events) >= MOST_EVENTS:
            raise RunError(f"more than {MOST_EVENTS} changes of contact")
        return self.adopted(t, y, change(self.contacts_at(t, y), self.modes, k))

    def adopted(self, t: float, y: np.ndarray, found: Change) -> np.ndarray:
        """The state with the rates and modes of a change, which is recorded."""
        q, _, x = self.parts(y)
        if found.losses and impact_leaves_every_branch(self.f.plant, q, found.v):
            raise UndecidedError(OF_NO_BRANCH)
        q = onto_stops(self.contacts_at(t, y), found.modes.values, q)
        self.modes = found.modes
        if self.corners is not None:
            self.corners.anew()
        self.events += [f"t = {shown_time(t)} s: {text}" for text in found.texts]
        self.losses += [(t, name, loss) for name, loss in found.losses.items()]
        return np.concatenate([q, found.v, x])

    def restarted(self, y: np.ndarray, times: np.ndarray) -> None:
        """Multistep methods: from output to output, projected and begun anew at each."""
        for left, right in pairwise(times):
            t = float(left)
            while t < right:
                solver = self.solver(t, y, float(right))
                while solver.status == "running":
                    message = solver.step()
                    self.count()
                    self.look_how_fast(solver.t, np.array(solver.y))
                if solver.status == "failed":
                    raise RunError(f"the integrator gave up: {message}")
                t, y = solver.t, self.arrived(solver.t, solver.y)
            self.sample(float(right), y)

    def fixed_steps(self, y: np.ndarray, times: np.ndarray) -> None:
        """Steps of our own of the given length, or a little shorter so that outputs fall on their ends."""
        step = self.scene.integrator.step
        assert step is not None  # the reader of scenes asks for it
        for left, right in pairwise(times):
            t = float(left)
            while t < right:
                until, self.latest = self.features.ahead(t, float(right), 0)
                count = max(1, int(np.ceil((until - t) / step - 1e-9)))
                h = (until - t) / count
                for i in range(count):
                    y = self.fixed_step(t + i * h, y, t + (i + 1) * h)
                t = until
            self.sample(float(right), y)

    def fixed_step(self, t: float, y: np.ndarray, end: float) -> np.ndarray:
        """One step from t to `end` [s], or several, where corners lie between."""
        take = FIXED_STEPS[self.scene.integrator.method]
        corners = self.corners
        while t < end:
            goal, aimed, takes = end, None, 0
            while True:
                self.count()
                after = take(self, t, y, goal - t)
                found = None
                if corners is not None and takes < LANDINGS:
                    found = corners.end(cubic(self.slopes, (t, y), (goal, after)), t, goal, aimed)
                if found is None:
                    break
                (goal, aimed), takes = found, takes + 1
            if corners is not None:
                corners.accept(short=takes > 0 and goal - t < SHORT * (end - t))
            t, y = goal, self.arrived(goal, after)
        return y


# marching of `symscrew.scene.INTEGRATION_METHODS` -> how a run goes on; sundials goes its own way above
MARCHES: Mapping[str, Callable[[_Marching, np.ndarray, np.ndarray], None]] = {
    "projected": _Marching.single_steps,
    "restarted": _Marching.restarted,
    "fixed": _Marching.fixed_steps,
}
