"""How far a replay of the drives leaves the planned motion, to first order.

Between the points the motion misses its equations by an error of y''. A deviation of the replay obeys the equations
of motion linearised along the plan, with that error as what drives it,

    d'' = A d + B d' - error,

so what an interval contributes at the end is the integral of its error carried there by the transition matrices, those
within the interval included.
The states of effects are left aside.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.planned_motion import PlannedMotion
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.rows import PointFunction


@dataclass(frozen=True)
class Deviation:
    """At samples (n) of a motion: the error of y_ddot (n, d) [1/s^2], A and B (n, d, d) by relative time."""

    acceleration: np.ndarray
    place: np.ndarray
    rate: np.ndarray
    duration: float

    def at_the_end(self, steps: np.ndarray, nodes: np.ndarray, weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """What the error in every interval makes of y and, times the duration, of y_dot: (intervals,) twice.

        First at the end of the motion, then at the end of the interval itself.

        `steps`: relative lengths of the intervals; `nodes`, `weights`: Gauss-Legendre rule on [-1, 1] of the samples.
        """
        n, d = len(steps), self.acceleration.shape[1]
        h, weights = steps[:, None], weights / 2
        error = self.acceleration.reshape(n, -1, d) * self.duration**2
        mean = [np.einsum("kpij,p->kij", m.reshape(n, -1, d, d), weights) for m in (self.place, self.rate)]
        flow = np.zeros((n, 2 * d, 2 * d))
        flow[:, :d, d:] = np.eye(d)
        flow[:, d:, :d], flow[:, d:, d:] = mean
        # carried within the interval as well: collocation leaves errors whose plain integrals all but vanish
        left = flow[:, None] * (h * (1 - nodes) / 2)[:, :, None, None]
        own = np.einsum("kpij,kpj,p->ki", _exponential(left)[..., d:], error, weights) * h
        transition = _exponential(flow * steps[:, None, None])
        carried, result = np.eye(2 * d), np.zeros(n)
        for k in reversed(range(n)):
            result[k] = np.abs(carried @ own[k]).max(initial=0.0)
            carried = carried @ transition[k]
        return np.nan_to_num(result, nan=np.inf), np.nan_to_num(np.abs(own).max(axis=1, initial=0.0), nan=np.inf)


def deviation_of(motion: PlannedMotion, blocks: dict[str, np.ndarray], tau: np.ndarray) -> Deviation:
    """The deviation's equation at relative times tau, where the motion has the given unknowns."""
    model = motion.model
    symbols = point_symbols(model, moving=True)
    at = MotionQuantities(model, symbols)
    residual = symbolic_outputs(model.equations.dynamics, at.known)["residual"]
    closure = symbolic_outputs(model.equations.closure, at.known)["closure"]
    y, z = symbols["y"], symbols["z"]
    matrices = [ca.jacobian(residual, symbols[name]) for name in ("y_2", "y", "y_1", "z")]
    matrices += [ca.jacobian(closure, y), ca.jacobian(closure, z)]
    function = PointFunction(symbols, ())
    made = ca.Function("deviation", [function.arguments], [residual, *(ca.densify(m) for m in matrices)])
    n = len(tau)
    values, *found = made.map(n)(stacked(motion, function, blocks, tau))
    error = np.array(values).T
    inertia, by_y, by_rate, by_z, closed_y, closed_z = (
        np.array(m).reshape(s.size1(), n, s.size2()).transpose(1, 0, 2) for m, s in zip(found, matrices, strict=True)
    )
    place, rate = np.full_like(inertia, np.nan), np.full_like(inertia, np.nan)
    for k in range(n):
        every = [part[k] for part in (error, inertia, by_y, by_rate, by_z, closed_y, closed_z)]
        if not all(np.isfinite(part).all() for part in every):
            error[k] = np.inf
            continue
        along = by_y[k] - by_z[k] @ np.linalg.lstsq(closed_z[k], closed_y[k], rcond=None)[0]
        right = np.column_stack([error[k], along, by_rate[k]])
        solved = np.linalg.lstsq(inertia[k], right, rcond=None)[0]
        error[k], place[k], rate[k] = solved[:, 0], -solved[:, 1 : 1 + model.d], -solved[:, 1 + model.d :]
    return Deviation(error / motion.duration**2, place, rate, motion.duration)


def stacked(
    motion: PlannedMotion, function: PointFunction, blocks: dict[str, np.ndarray], tau: np.ndarray
) -> np.ndarray:
    """Arguments of a point function at samples: (arguments, n)."""
    n = len(tau)
    known = {**blocks, "tau": tau[:, None]}
    if "T" in motion.arrays:
        known["T"] = np.full((n, 1), motion.duration)
    if "p" in motion.arrays:
        known["p"] = np.repeat(motion.arrays["p"][None], n, 0)
    parts = [known[name].T if symbol.numel() else np.zeros((0, n)) for name, symbol in function.blocks.items()]
    return np.concatenate(parts)


def _exponential(x: np.ndarray) -> np.ndarray:
    """Exponentials of matrices (..., m, m) that are not large: the Taylor series of order 6 by Horner's rule."""
    unit = np.eye(x.shape[-1])
    total = unit + x / 6
    for k in (5, 4, 3, 2, 1):
        total = unit + x @ total / k
    return total
