"""Runs by well-kept libraries, step by step from Python: SciPy's integrators, SUNDIALS through CasADi.

For stiff scenes, for contacts with events, for controllers that are Python functions, and where there is no
C compiler. One-step methods are projected onto the closure after every step, the others at every output, where they
start again.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from symscrew.effects import Contact
from symscrew.errors import DescriptionError
from symscrew.scene import Scene
from symscrew.simulation import contacts as contact
from symscrew.simulation.recording import History
from symscrew.simulation.scene_functions import Functions, RunError
from symscrew.simulation.state_programs import Plant

SINGLE_STEP = {"dop853": "DOP853", "radau": "Radau"}
RESTARTED = {"bdf": "BDF", "lsoda": "LSODA"}
MOST_EVENTS = 10_000


def integrate(
    scene: Scene,
    plant: Plant,
    start: tuple[np.ndarray, np.ndarray, np.ndarray],
    *,
    contacts: Sequence[Contact] = (),
    controller: Callable[..., Any] | None = None,
    compiled: bool = True,
    progress: Callable[[float], None] | None = None,
) -> History:
    """The run of a scene; see the module."""
    rules = contact.laws(plant.model, contacts)
    method = scene.integrator.method
    if rules and method not in SINGLE_STEP:
        raise DescriptionError(f"integrator.method: contacts with events need dop853 or radau, got {method}")
    if method == "cvodes":
        if controller is not None:
            raise DescriptionError("integrator.method: cvodes takes no Python controller; use radau or bdf")
        from symscrew.simulation.sundials import integrate as by_sundials

        return by_sundials(scene, plant, start, progress)
    functions = Functions(plant, list(scene.tables.values()), compiled=compiled)
    return _Marching(scene, functions, rules, controller, progress).run(start)


class _Marching:
    """State of one run: y = (q, v, x), the modes of the contacts, the samples so far."""

    def __init__(self, scene, functions: Functions, rules, controller, progress) -> None:  # type: ignore[no-untyped-def]
        self.scene, self.f, self.rules, self.controller, self.progress = scene, functions, rules, controller, progress
        self.modes = contact.Modes(())
        self.samples: list[tuple[float, np.ndarray]] = []
        self.events: list[str] = []
        self.steps = 0

    # -- slopes -----------------------------------------------------------------------------------------------

    def parts(self, y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        nq, nv = self.f.nq, self.f.nv
        return y[:nq], y[nq : nq + nv], y[nq + nv :]

    def commanded(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        if self.controller is None:
            return np.zeros(0)
        u = np.asarray(self.controller(t, np.array(q), np.array(v)), dtype=float).ravel()
        if u.shape != (self.f.nu,) or not np.isfinite(u).all():
            raise DescriptionError(f"controller: expected {self.f.nu} finite numbers at t = {t:g}, got {u!r:.80}")
        return u

    def accelerations(self, t: float, y: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
        q, v, x = self.parts(y)
        u = self.commanded(t, q, v)
        return lambda outside: self.f.slopes(t, q, v, x, u, outside)[0]

    def forces(self, t: float, y: np.ndarray) -> np.ndarray:
        if not self.rules:
            return np.zeros(0)
        return contact.forces(self.rules, self.modes, self.parts(y)[1], self.accelerations(t, y))

    def slopes(self, t: float, y: np.ndarray) -> np.ndarray:
        q, v, x = self.parts(y)
        a, x_dot = self.f.slopes(t, q, v, x, self.commanded(t, q, v), self.forces(t, y))
        return np.concatenate([self.f.coordinate_rates(q, v), a, x_dot])

    def settled(self, y: np.ndarray) -> np.ndarray:
        q, v, x = self.parts(y)
        q, v, _ = self.f.settle(q, v)
        return np.concatenate([q, v, x])

    # -- the run ------------------------------------------------------------------------------------------------

    def run(self, start: tuple[np.ndarray, np.ndarray, np.ndarray]) -> History:
        times, status, ok = self.scene.times, "completed", True
        y = self.settled(np.concatenate(start))
        if self.rules:
            q, v, _ = self.parts(y)
            self.modes = contact.start_modes(self.rules, q, v, self.f.plant.units, self.accelerations(0.0, y))
        self.sample(0.0, y)
        try:
            if self.scene.integrator.method in SINGLE_STEP:
                self.single_steps(y, times)
            elif self.scene.integrator.method in RESTARTED:
                self.restarted(y, times)
            else:
                self.fixed_steps(y, times)
        except RunError as error:
            ok, status = False, f"stopped at t = {self.samples[-1][0]:.9g} s: {error}"
        except FloatingPointError as error:
            ok, status = False, f"stopped at t = {self.samples[-1][0]:.9g} s: {error}"
        return self.history(ok, status)

    def sample(self, t: float, y: np.ndarray) -> None:
        self.samples.append((t, y))
        if self.progress is not None:
            self.progress(t / self.scene.duration)

    def history(self, ok: bool, status: str) -> History:
        t = np.array([t for t, _ in self.samples])
        y = np.array([y for _, y in self.samples])
        q, v, x = y[:, : self.f.nq], y[:, self.f.nq : self.f.nq + self.f.nv], y[:, self.f.nq + self.f.nv :]
        u = None
        if self.controller is not None:
            u = np.array([self.commanded(a, b, c) for a, b, c in zip(t, q, v, strict=True)]).reshape(len(t), self.f.nu)
        forces = np.array(self.recorded) if self.rules else None
        counters = {"steps": float(self.steps), "evaluations": float(self.f.evaluations)}
        return History(t, q, v, x, ok, status, "library", (), tuple(self.events), counters, u, forces)

    @property
    def recorded(self) -> list[np.ndarray]:
        """Contact forces at the samples."""
        return [force for _, force in self.kept]

    def tolerance(self) -> float:
        return max(1e-3 * self.scene.integrator.tolerance, 3e-14)

    def solver(self, name: str, t: float, y: np.ndarray, end: float) -> Any:
        integrate = _scipy()
        local = self.tolerance()
        longest = self.scene.integrator.longest_step or np.inf
        kind = getattr(integrate, name)
        return kind(self.slopes, t, y, end, rtol=max(local, 2.3e-14), atol=local, max_step=longest)

    def count(self) -> None:
        self.steps += 1
        if self.steps > self.scene.integrator.most_steps:
            raise RunError("more steps than most_steps allows")

    def single_steps(self, y: np.ndarray, times: np.ndarray) -> None:
        name, k = SINGLE_STEP[self.scene.integrator.method], 1
        self.kept = [(0.0, self.forces(0.0, y))] if self.rules else []
        t = 0.0
        while k < len(times):
            solver = self.solver(name, t, y, times[-1])
            before = self.margins(t, y)
            while k < len(times):
                message = solver.step()
                self.count()
                if solver.status == "failed":
                    raise RunError(f"the integrator gave up: {message}")
                dense, t, found = solver.dense_output(), solver.t, None
                if self.rules:
                    found = self.first_event(dense, solver.t_old, solver.t, before)
                    t = solver.t if found is None else found[0]
                while k < len(times) and times[k] <= t:
                    at = self.settled(dense(times[k]))
                    self.sample(float(times[k]), at)
                    if self.rules:
                        self.kept.append((float(times[k]), self.forces(float(times[k]), at)))
                    k += 1
                if found is not None:
                    y = self.changed(found, self.settled(dense(t)))
                    break
                y = self.settled(solver.y)
                solver.y = y
                if name == "DOP853":
                    solver.f = self.slopes(solver.t, y)
                if self.rules:
                    before = self.margins(solver.t, y)
                if solver.status == "finished":
                    break

    def margins(self, t: float, y: np.ndarray) -> np.ndarray:
        if not self.rules:
            return np.zeros(0)
        q, v, _ = self.parts(y)
        return contact.margins(self.rules, self.modes, q, v, self.forces(t, y))

    def first_event(self, dense: Any, left: float, right: float, before: np.ndarray) -> tuple[float, int] | None:
        """The first end of a mode within a step: its time and contact; the margins are watched at a few places."""
        places = np.linspace(left, right, 5)
        found: tuple[float, int] | None = None
        previous = before
        for a, b in pairwise(places):
            now = self.margins(b, dense(b))
            for k in np.flatnonzero(now <= 0):
                start = a if previous[k] > 0 else self.lifted(dense, int(k), a, b)
                time = a if start is None else self.root(dense, int(k), start, b)
                if found is None or time < found[0]:
                    found = (time, int(k))
            if found is not None:
                return found
            previous = now
        return None

    def lifted(self, dense: Any, k: int, left: float, right: float) -> float | None:
        """A time at which a contact that has just begun to hold its new mode does so: rounding hides the very start."""
        for halving in range(1, 50):
            t = left + (right - left) * 0.5**halving
            if self.margins(t, dense(t))[k] > 0:
                return t
        return None

    def root(self, dense: Any, k: int, left: float, right: float) -> float:
        """Where a margin ends, by bisection and regula falsi (Brent); just behind it, so that the new mode holds."""
        from scipy.optimize import brentq

        return float(brentq(lambda t: self.margins(t, dense(t))[k], left, right, xtol=1e-14, rtol=8.9e-16))

    def changed(self, found: tuple[float, int], y: np.ndarray) -> np.ndarray:
        """Rates and modes behind an event."""
        t, k = found
        if len(self.events) >= MOST_EVENTS:
            raise RunError(f"more than {MOST_EVENTS} changes of contact")
        rule, mode = self.rules[k], self.modes.values[k]
        q, v, x = self.parts(y)
        units, after = self.f.plant.units, self.accelerations(t, y)
        name = rule.contact.joint
        if rule.contact.kind == "friction" and mode != 0:
            text = f"{name} sticks"
            self.modes = contact.released(self.rules, self.modes.with_mode(k, 0), v, units, after)
            if self.modes.values[k] != 0:
                text = f"{name} turns back"
        elif rule.contact.kind == "friction":
            force = self.forces(t, y)
            self.modes = self.modes.with_mode(k, -int(np.sign(force[k])))
            text = f"{name} slips"
        elif mode == 0:
            end = 1 if rule.upper - q[rule.q] < q[rule.q] - rule.lower else -1
            v, self.modes = contact.impact(self.rules, k, end, self.modes, v, units, after)
            y = np.concatenate([q, v, x])
            self.modes = contact.released(self.rules, self.modes, v, units, self.accelerations(t, y))
            text = f"{name} meets its {'upper' if end > 0 else 'lower'} stop"
        else:
            self.modes = self.modes.with_mode(k, 0)
            text = f"{name} leaves its stop"
        self.events.append(f"t = {t:.9g} s: {text}")
        return y

    def restarted(self, y: np.ndarray, times: np.ndarray) -> None:
        name = RESTARTED[self.scene.integrator.method]
        for left, right in pairwise(times):
            solver = self.solver(name, float(left), y, float(right))
            while solver.status == "running":
                message = solver.step()
                self.count()
            if solver.status == "failed":
                raise RunError(f"the integrator gave up: {message}")
            y = self.settled(solver.y)
            self.sample(float(right), y)

    def fixed_steps(self, y: np.ndarray, times: np.ndarray) -> None:
        step = self.scene.integrator.step
        assert step is not None
        advance = {"euler": self.euler, "semi_implicit_euler": self.semi_implicit, "rk4": self.rk4, "rk8": self.rk8}[
            self.scene.integrator.method
        ]
        for left, right in pairwise(times):
            count = max(1, int(np.ceil((right - left) / step - 1e-9)))
            h = (right - left) / count
            for i in range(count):
                self.count()
                y = self.settled(advance(left + i * h, y, h))
            self.sample(float(right), y)

    def euler(self, t: float, y: np.ndarray, h: float) -> np.ndarray:
        q, v, x = self.parts(y)
        rates = self.slopes(t, y)
        _, a, x_dot = self.parts(rates)
        return np.concatenate([self.f.moved(q, h * v), v + h * a, x + h * x_dot])

    def semi_implicit(self, t: float, y: np.ndarray, h: float) -> np.ndarray:
        q, v, x = self.parts(y)
        _, a, x_dot = self.parts(self.slopes(t, y))
        v = v + h * a
        return np.concatenate([self.f.moved(q, h * v), v, x + h * x_dot])

    def rk4(self, t: float, y: np.ndarray, h: float) -> np.ndarray:
        k1 = self.slopes(t, y)
        k2 = self.slopes(t + h / 2, y + h / 2 * k1)
        k3 = self.slopes(t + h / 2, y + h / 2 * k2)
        k4 = self.slopes(t + h, y + h * k3)
        return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

    def rk8(self, t: float, y: np.ndarray, h: float) -> np.ndarray:
        from scipy.integrate import DOP853

        k = np.zeros((12, len(y)))
        for stage in range(12):
            k[stage] = self.slopes(t + DOP853.C[stage] * h, y + h * (DOP853.A[stage, :stage] @ k[:stage]))
        return y + h * (DOP853.B @ k)


def _scipy() -> Any:
    try:
        import scipy.integrate
    except ImportError as error:
        raise DescriptionError(
            'this integrator needs SciPy, which is not installed: pip install "symscrew[simulation]"'
        ) from error
    return scipy.integrate
