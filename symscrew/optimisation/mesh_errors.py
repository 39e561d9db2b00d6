"""Errors of a motion between its points, and what they may have done to the cost.

The cost's error is estimated by the multipliers: with costates lambda of the rows, the residuals r of the dense
motion change the cost by about the integral of lambda r, of which the magnitudes of all intervals are added;
quadrature adds the difference to a finer one; and where the drives' polynomial is not the minimiser of the
Hamiltonian between the points (a switching inside an interval) the integral of the Hamiltonian's excess over its
minimum is added. To first order; the first part is doubled for safety.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.polynomial import legendre

from symscrew.optimisation.bounds_between import Violations, violations_of
from symscrew.optimisation.deviation import deviation_of, stacked
from symscrew.optimisation.followed_branch import Branch, Followed
from symscrew.optimisation.objectives import objectives_by_type
from symscrew.optimisation.planned_motion import PlannedMotion
from symscrew.optimisation.rows import PointFunction
from symscrew.optimisation.sparse import Family
from symscrew.optimisation.unseen_features import Unseen, unseen_by

SAFETY = 2.0  # the residuals' part is of first order: what higher orders may add is covered by doubling it
# An error may grow so much on its way to the end before it counts as what feedback has to mend: no mesh makes a motion
# repeatable whose errors grow by more, for rounding and a millionth in a mass would grow as well.
MOST_GROWTH = 100.0


@dataclass(frozen=True)
class Errors:
    """How far the motion is from obeying its equations between the points.

    `closure`: largest opening of the loops (without units) of the assembled configurations; `nodal_closure`: of the
    solver's own configurations at the points; `dynamic`: largest error of y_ddot against the drives'
    polynomial [1/s^2];
    `defects` (intervals,): what the error in an interval makes of the end of a replay, the larger of y and, times the
    duration, y_dot; `drift`: their sum, above which a replay does not end off the plan; `local` (intervals,): the
    same at the end of the interval itself; `cost`: estimated error
    of the cost, in its units; `pivot`: smallest pivot of the closure (0: the coordinates y are singular);
    `violation`: largest violation of a bound between the points as a part of its size, `violations` in detail: never
    less than that of the motion. `unseen`: where intervals are too long for what acts in them to be seen.
    """

    closure: float
    nodal_closure: float
    dynamic: float
    defects: np.ndarray
    drift: float
    cost: float
    pivot: float
    violation: float
    local: np.ndarray
    violations: Violations
    unseen: Unseen

    @property
    def judged(self) -> np.ndarray:
        """What counts of the defects (intervals,): growth on the way to the end only up to `MOST_GROWTH`."""
        return np.asarray(np.minimum(self.defects, MOST_GROWTH * self.local))

    @property
    def growth(self) -> float:
        """By how much errors grow on the way to the end."""
        total = float(self.local.sum())
        return self.drift / total if total > 0 else 1.0


def errors_of(motion: PlannedMotion, costates: np.ndarray, branch: Branch, followed: Followed) -> Errors:
    """The errors at Gauss points between the nodes; `costates` (points, rows) of the rows at the points."""
    mesh = motion.transcribed.mesh
    scheme = motion.transcribed.scheme
    per = (scheme.degree if scheme else 2) + 3
    nodes, weights = legendre.leggauss(per)
    steps = np.diff(mesh)
    tau = (mesh[:-1, None] + steps[:, None] * (1 + nodes) / 2).ravel()
    weight = (steps[:, None] * weights / 2).ravel()
    samples = motion.sampled(tau)
    blocks = {**motion.blocks(tau), "z": samples.z}
    closure = _closure(motion, samples.y, samples.z)
    nodal = _nodal_closure(motion)
    deviation = deviation_of(motion, blocks, tau)
    size = np.abs(deviation.acceleration).max(axis=1, initial=0.0)
    defects, local = deviation.at_the_end(steps, nodes, weights)
    bounds = violations_of(motion, branch, followed, motion.problem.violation)
    cost, beyond = (np.nan, np.nan) if scheme is None else _cost_error(motion, costates, blocks, tau=tau, weight=weight)
    failed = not samples.assembled.all()
    return Errors(
        closure=np.inf if failed else closure,
        nodal_closure=nodal,
        dynamic=float(size.max()),
        drift=float(defects.sum()),
        cost=cost,
        pivot=float(motion.kinematics.pivots(samples.q).min()),
        defects=defects,
        violation=max(bounds.largest, beyond),
        local=local,
        violations=bounds,
        unseen=unseen_by(motion, branch, followed),
    )


def _closure(motion: PlannedMotion, y: np.ndarray, z: np.ndarray) -> float:
    """Largest opening of the loops."""
    if not motion.model.equations.layout.closed and not motion.model.equations.layout.z:
        return 0.0
    return float(np.abs(motion.kinematics.closure(y, z)[1]).max(initial=0.0))


def _nodal_closure(motion: PlannedMotion) -> float:
    layout = motion.model.equations.layout
    y = motion.blocks(motion.transcribed.point_tau.ravel())["y"]
    return _closure(motion, y, motion.arrays["z"].reshape(len(y), len(layout.z)))


def costates_of(family: Family, multipliers: np.ndarray) -> np.ndarray:
    """Densities over relative time (points, rows) of the multipliers, of which the family's are the first."""
    count = len(family.function.rows)
    own = multipliers[: family.count * count].reshape(family.count, count)
    return np.asarray(own / family.weights[:, None])


def switching(motion: PlannedMotion, costates: np.ndarray) -> np.ndarray:
    """Slope of the Hamiltonian by every drive at the points: (points, drives).

    By Pontryagin's principle a drive stands on its lower bound where its slope is positive, on its upper one where
    it is negative; the bounds of other quantities and rates of drives left aside.
    """
    family = motion.transcribed.families[0]
    function = _hamiltonian(family.function).map(family.count)
    found = function(stacked(motion, family.function, motion.point_blocks(), family.tau), costates.T)
    return np.array(found[2]).T


def _hamiltonian(point: PointFunction) -> ca.Function:
    """(arguments, multipliers) -> rows, integrand, slope of the Hamiltonian by u, curvature of the integrand by u."""
    lam, u, integrand = ca.SX.sym("lam", len(point.rows)), point.blocks["u"], ca.SX(point.integrand)
    g = ca.vertcat(ca.SX(0, 1), *[r.value / r.scale for r in point.rows])
    slope = ca.gradient(ca.dot(lam, g) + integrand, u)
    curvature = ca.diag(ca.hessian(integrand, u)[0])
    return ca.Function("hamiltonian", [point.arguments, lam], [g, integrand, slope, curvature])


def _cost_error(
    motion: PlannedMotion,
    costates: np.ndarray,
    blocks: dict[str, np.ndarray],
    *,
    tau: np.ndarray,
    weight: np.ndarray,
) -> tuple[float, float]:
    """Estimated error of the cost, and how far drives leave their bounds between the points, scaled."""
    transcribed = motion.transcribed
    family, scheme = transcribed.families[0], transcribed.scheme
    assert scheme is not None
    rows, z = family.function.rows, family.function.arguments
    scale = np.array([r.scale for r in rows])
    low, high = (np.array([getattr(r, name) for r in rows]) / scale for name in ("lower", "upper"))
    integrand = ca.SX(family.function.integrand)
    function = _hamiltonian(family.function)
    n, per = len(tau), len(tau) // (len(transcribed.mesh) - 1)
    k = np.repeat(np.arange(len(transcribed.mesh) - 1), per)
    s = (tau - transcribed.mesh[k]) / np.diff(transcribed.mesh)[k]
    basis = scheme.basis(s)
    dense = np.einsum("nj,njm->nm", basis, costates.reshape(-1, scheme.degree, len(rows))[k])
    values, cost, slopes, curves = (
        np.array(x) for x in function.map(n)(stacked(motion, family.function, blocks, tau), dense.T)
    )
    over = np.maximum(np.maximum(low[:, None] - values, values - high[:, None]), 0.0)
    off = np.where(values < low[:, None], values - low[:, None], np.where(values > high[:, None], over, 0.0))
    per_interval = ((dense.T * off) * weight).reshape(len(rows), -1, per).sum(axis=2)
    residual_part = SAFETY * float(np.abs(per_interval).sum())
    at_nodes = stacked(motion, family.function, motion.point_blocks(), family.tau)
    coarse = np.array(ca.Function("cost", [z], [integrand]).map(family.count)(at_nodes)).ravel() @ family.weights
    quadrature = abs(float(cost.ravel() @ weight) - float(coarse))
    excess, beyond = _excess(motion, blocks["u"], slopes.T, np.broadcast_to(curves, slopes.shape).T)
    return residual_part + quadrature + float(excess @ weight), beyond


def _excess(motion: PlannedMotion, u: np.ndarray, slope: np.ndarray, curvature: np.ndarray) -> tuple[np.ndarray, float]:
    """How much the Hamiltonian exceeds its minimum over the drives' bounds (n,), and how far drives leave bounds."""
    total, beyond = np.zeros(len(u)), 0.0
    if (
        motion.problem.drive_rule != "free"
        or motion.problem.bounds.drive_rates
        or not all(made.pointwise for made, _ in objectives_by_type(motion.model))
    ):
        return total, beyond  # drives are tied to each other over time: no pointwise minimum
    for j, label in enumerate(motion.drive_labels):
        low, high = motion.model.drive_range(label)
        h, c = slope[:, j], curvature[:, j]
        with np.errstate(divide="ignore", invalid="ignore"):
            newton = np.where(c > 0, -h / np.where(c > 0, c, 1.0), np.where(h > 0, -np.inf, np.inf))
        step = np.clip(newton, low - u[:, j], high - u[:, j])
        step = np.where(np.isfinite(step), step, 0.0)
        total += np.abs(h * step + c * step**2 / 2)
        outside = np.maximum(np.maximum(low - u[:, j], u[:, j] - high), 0.0)
        beyond = max(beyond, float((outside / motion.model.scales.u[j]).max(initial=0.0)))
    return total, beyond
