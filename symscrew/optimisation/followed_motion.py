"""Replay: the drives found, applied to the mechanism in a forward simulation of the tree, and where it ends.

The drives are the polynomials of the intervals, the accelerations those of `forward_dynamics`; every Runge-Kutta
step (order 4) ends with a step back onto the closure manifold. Halving the step until the end no longer changes
gives the error of the integration itself.
"""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError
from symscrew.functions import forward_functions
from symscrew.optimisation.casadi_graph import numeric_function, symbolic_outputs
from symscrew.optimisation.result import Replay, Trajectory
from symscrew.program import lower

STEPS = 4  # of a first replay, in every interval
# Then the steps are up to 256 per interval; what the last halving still changed is the replay's `integration`.
MOST_HALVINGS = 7
TOLERANCE = 1e-9  # [rad, m, rad/s, m/s] of the integration: well below what a plan is refined to


def replay(trajectory: Trajectory, *, tolerance: float = TOLERANCE) -> Replay:
    """Simulate the mechanism under the drives found, from the start of the motion.

    `tolerance`: change of the end [rad, m, rad/s, m/s] by halving the steps below which no more halving is tried.

    Raises:
        DescriptionError: accelerations do not follow from forces: without mass, or quasi-statically.
    """
    if not trajectory.model.equations.accelerates:
        raise DescriptionError("replay: accelerations do not follow from forces without mass, or quasi-statically")
    if trajectory.replayed is not None and tolerance == TOLERANCE:
        return trajectory.replayed
    stepper = Stepper(trajectory)
    states, change, steps = settled(stepper, tolerance=tolerance)
    entries = [e.q for e in trajectory.model.equations.loops.entries]
    mesh = trajectory.transcribed.mesh
    planned = trajectory.blocks(mesh)
    y = states[:, entries]
    rates = stepper.rates(states)
    off = np.abs(y - planned["y"])
    end = max(float(off[-1].max()), float(np.abs(rates[-1] * trajectory.duration - planned["y_1"][-1]).max()))
    local = stepper.local_errors(steps, planned)
    return Replay(
        mesh * trajectory.duration, y, planned["y"], end, float(off.max()), change, stepper.opening(states), local
    )


def settled(
    stepper: Stepper, start: np.ndarray | None = None, *, tolerance: float = TOLERANCE
) -> tuple[np.ndarray, float, int]:
    """States at the ends of the intervals, what halving the steps changed last at the end, steps in an interval.

    `start`: (q, v, x) to start from, default the plan's.
    """
    steps, change, before = STEPS, np.inf, None
    for _ in range(MOST_HALVINGS):
        states = stepper.run(steps, start)
        change = np.inf if before is None else float(np.abs(states[-1] - before[-1]).max())
        before = states
        if change < tolerance:
            break
        steps *= 2
    return states, change, steps


class Stepper:
    """Runge-Kutta steps of q, v and the effects' states with the drives of one interval."""

    def __init__(self, trajectory: Trajectory) -> None:
        self.trajectory, model = trajectory, trajectory.model
        self.system, self.equations = model.system, model.equations
        self.programs = {
            f.name: lower(f) for f in forward_functions(self.system, self.equations.effects, self.equations.loops)
        }
        self.nq, self.nv, self.nx = len(self.system.tree.q), len(self.system.tree.v), len(model.states)
        self.degree = trajectory.transcribed.scheme.degree if trajectory.transcribed.scheme else 1
        self.step = self._step()

    def _slope(self, state: Any, t: Any, u: Any, p: Any) -> Any:
        q, v, x = state[: self.nq], state[self.nq : self.nq + self.nv], state[self.nq + self.nv :]
        known = {"q": q, "v": v, "u": u, "x": x, "t": t, "p": p, **self._inputs()}
        a = symbolic_outputs(self.programs["forward_dynamics"], known)["a"]
        q_dot: list[Any] = [0] * self.nq
        for link in self.system.tree.links[1:]:
            rate = v[link.v.start : link.v.stop]
            if link.motion.spherical:
                w, r = q[link.q.start], q[link.q.start + 1 : link.q.stop]
                q_dot[link.q] = ca.vertsplit(ca.vertcat(-ca.dot(r, rate), w * rate + ca.cross(r, rate)) / 2)
            elif link.motion.single:
                q_dot[link.q.start] = rate[0]
        found = self.equations.effect_rates
        x_dot = symbolic_outputs(found, known)["x_dot"] if found else ca.SX(0, 1)
        return ca.vertcat(*q_dot, a, x_dot)

    def _inputs(self) -> dict[str, Any]:
        given = self.trajectory.problem.inputs
        ports = [port for port, _ in self.equations.acting.own_inputs]
        return {port.name: ca.DM(given.get(port.name, (0.0,) * port.size)) for port in ports}

    def _step(self) -> ca.Function:
        """(state, t, h, coefficients of u in the interval, start and length of the interval, p) -> state."""
        state = ca.SX.sym("state", self.nq + self.nv + self.nx)
        nu = len(self.trajectory.drive_labels)
        t, h, start, length = (ca.SX.sym(name) for name in ("t", "h", "start", "length"))
        values, p = ca.SX.sym("u", nu, self.degree), ca.SX.sym("p", len(self.trajectory.parameter_values))
        scheme = self.trajectory.transcribed.scheme

        def u(time: Any) -> Any:
            if scheme is None:
                return values
            s = (time - start) / length
            total = ca.SX.zeros(nu)
            for j, node in enumerate(scheme.nodes):
                basis = ca.SX(1)
                for other in np.delete(scheme.nodes, j):
                    basis = basis * (s - other) / (node - other)
                total = total + values[:, j] * basis
            return total

        k1 = self._slope(state, t, u(t), p)
        k2 = self._slope(state + h / 2 * k1, t + h / 2, u(t + h / 2), p)
        k3 = self._slope(state + h / 2 * k2, t + h / 2, u(t + h / 2), p)
        k4 = self._slope(state + h * k3, t + h, u(t + h), p)
        moved = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        return ca.Function("step", [state, t, h, values, start, length, p], [self._closed(moved, p)])

    def _closed(self, state: Any, p: Any) -> Any:
        q, v, x = state[: self.nq], state[self.nq : self.nq + self.nv], state[self.nq + self.nv :]
        for link in self.system.tree.links[1:]:
            if link.motion.spherical:
                part = q[link.q.start : link.q.stop]
                q[link.q.start : link.q.stop] = part / ca.sqrt(ca.dot(part, part))
        if "close_position" in self.programs:
            q = symbolic_outputs(self.programs["close_position"], {"q": q, "p": p})["q_next"]
            v = symbolic_outputs(self.programs["close_velocity"], {"q": q, "v": v, "p": p})["v_next"]
        return ca.vertcat(q, v, x)

    def run(self, steps: int, start: np.ndarray | None = None) -> np.ndarray:
        """States at the ends of the intervals: (intervals + 1, nq + nv + states), from the plan's start or another."""
        found = self.trajectory
        mesh = found.transcribed.mesh * found.duration
        planned = found.sampled(np.array([0.0]))
        state = np.concatenate([planned.q[0], planned.v[0], planned.x[0]]) if start is None else start
        states, p = [state], found.parameter_values
        folded, drives = self.step.mapaccum(steps), found.nodal_drives
        for k in range(len(mesh) - 1):
            length = mesh[k + 1] - mesh[k]
            t = mesh[k] + length * np.arange(steps) / steps
            values = np.tile(drives[k].T, (1, steps))
            many = [np.full((1, steps), x) for x in (length / steps, mesh[k], length)]
            moved = folded(state, t[None], many[0], values, many[1], many[2], np.repeat(p[:, None], steps, 1))
            state = np.array(moved)[:, -1]
            states.append(state)
        return np.array(states)

    def local_errors(self, steps: int, planned: dict[str, np.ndarray]) -> np.ndarray:
        """What intervals end off the plan, each from the plan at its start: (intervals,)."""
        found = self.trajectory
        mesh = found.transcribed.mesh * found.duration
        starts, n, p = found.sampled(found.transcribed.mesh[:-1]), len(mesh) - 1, found.parameter_values
        states = np.concatenate([starts.q, starts.v, starts.x], axis=1).T
        length, u = np.diff(mesh), found.nodal_drives
        t = mesh[:-1, None] + length[:, None] * np.arange(steps) / steps
        values = np.repeat(u.transpose(0, 2, 1)[:, :, None], steps, 2)  # (intervals, drives, steps, points)
        values = values.transpose(1, 0, 2, 3).reshape(u.shape[2], -1)
        many = [np.repeat(x, steps)[None] for x in (length / steps, mesh[:-1], length)]
        folded = self.step.mapaccum(steps).map(n)
        moved = folded(states, t.reshape(1, -1), many[0], values, many[1], many[2], np.repeat(p[:, None], steps * n, 1))
        ends = np.array(moved)[:, steps - 1 :: steps].T
        off = np.abs(ends[:, [e.q for e in self.equations.loops.entries]] - planned["y"][1:])
        rates = np.abs(self.rates(ends) * found.duration - planned["y_1"][1:])
        return np.asarray(np.maximum(off.max(axis=1), rates.max(axis=1)))

    def rates(self, states: np.ndarray) -> np.ndarray:
        """Rates of y of states."""
        result = []
        for entry in self.equations.loops.entries:
            if entry.component is None:
                result.append(states[:, self.nq + entry.v])
                continue
            link = entry.link
            w, r = states[:, link.q.start], states[:, link.q.start + 1 : link.q.stop]
            turn = states[:, self.nq + link.v.start : self.nq + link.v.stop]
            result.append((w[:, None] * turn + np.cross(r, turn))[:, entry.component] / 2)
        return np.array(result).T

    def opening(self, states: np.ndarray) -> float:
        """Largest opening of the loops without units."""
        if "close_position" not in self.programs:
            return 0.0
        function = numeric_function(self.programs["close_position"])
        arguments = [states[:, : self.nq].T]
        if len(self.trajectory.parameter_values):
            arguments.append(np.repeat(self.trajectory.parameter_values[:, None], len(states), 1))
        return float(np.array(function.map(len(states))(*arguments)[1]).max())
