"""Errors of a motion between its points, and what they may have done to the cost.

The cost's error is estimated by the multipliers: with costates lambda of the rows, the residuals r of the dense
motion change the cost by about the integral of lambda r, of which the magnitudes of all intervals are added;
quadrature adds the difference to a finer one; and where the drives' polynomial is not the minimiser of the
Hamiltonian between the points (a switching inside an interval) the integral of the Hamiltonian's excess over its
minimum is added. To first order; the first part is doubled for safety.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import casadi as ca
import numpy as np
from numpy.polynomial import legendre

from symscrew.optimisation.deviation import deviation_of, stacked
from symscrew.optimisation.result import Errors
from symscrew.optimisation.rows import PointFunction

if TYPE_CHECKING:
    from symscrew.optimisation.result import Trajectory


SAFETY = 2.0


def errors_of(trajectory: Trajectory) -> Errors:
    """The errors at Gauss points between the nodes."""
    mesh = trajectory.transcribed.mesh
    scheme = trajectory.transcribed.scheme
    per = (scheme.degree if scheme else 2) + 3
    nodes, weights = legendre.leggauss(per)
    steps = np.diff(mesh)
    tau = (mesh[:-1, None] + steps[:, None] * (1 + nodes) / 2).ravel()
    weight = (steps[:, None] * weights / 2).ravel()
    samples = trajectory.sampled(tau)
    blocks = {**trajectory.blocks(tau), "z": samples.z}
    closure = _closure(trajectory, samples.y, samples.z)
    nodal = _nodal_closure(trajectory)
    deviation = deviation_of(trajectory, blocks, tau)
    size = np.abs(deviation.acceleration).max(axis=1, initial=0.0)
    defects = deviation.at_the_end(steps, nodes, weights)
    cost, violation = (np.nan, np.nan) if scheme is None else _cost_error(trajectory, blocks, tau, weight)
    failed = not samples.assembled.all()
    return Errors(
        closure=np.inf if failed else closure,
        nodal_closure=nodal,
        dynamic=float(size.max()),
        drift=float(defects.sum()),
        cost=cost,
        pivot=float(trajectory.kinematics.pivots(samples.q).min()),
        defects=defects,
        violation=violation,
    )


def _closure(trajectory: Trajectory, y: np.ndarray, z: np.ndarray) -> float:
    if not trajectory.model.equations.layout.z:
        return 0.0
    return float(np.abs(np.array(trajectory._closure(*trajectory._with_parameters(y, z))[1])).max(initial=0.0))


def _nodal_closure(trajectory: Trajectory) -> float:
    layout = trajectory.model.equations.layout
    tau = trajectory.transcribed.point_tau.ravel()
    y = trajectory.blocks(tau)["y"]
    return _closure(trajectory, y, trajectory.arrays["z"].reshape(len(y), len(layout.z)))


def costates(trajectory: Trajectory) -> np.ndarray:
    """Multipliers of the rows at the points as functions of relative time: (points, rows)."""
    family = trajectory.transcribed.families[0]
    count = len(family.function.rows)
    own = trajectory.multipliers[: family.count * count] * trajectory.cost_scale
    return own.reshape(family.count, count) / family.weights[:, None]


def switching(trajectory: Trajectory) -> np.ndarray:
    """Slope of the Hamiltonian by every drive at the points: (points, drives).

    By Pontryagin's principle a drive stands on its lower bound where its slope is positive, on its upper one where
    it is negative; the bounds of other quantities and rates of drives left aside.
    """
    family = trajectory.transcribed.families[0]
    function = _hamiltonian(family.function).map(family.count)
    found = function(
        stacked(trajectory, family.function, trajectory.point_blocks(), family.tau), costates(trajectory).T
    )
    return np.array(found[2]).T


def _hamiltonian(point: PointFunction) -> ca.Function:
    """(arguments, multipliers) -> rows, integrand, slope of the Hamiltonian by u, curvature of the integrand by u."""
    lam, u, integrand = ca.SX.sym("lam", len(point.rows)), point.blocks["u"], ca.SX(point.integrand)
    g = ca.vertcat(ca.SX(0, 1), *[r.value / r.scale for r in point.rows])
    slope = ca.gradient(ca.dot(lam, g) + integrand, u)
    curvature = ca.diag(ca.hessian(integrand, u)[0])
    return ca.Function("hamiltonian", [point.arguments, lam], [g, integrand, slope, curvature])


def _cost_error(
    trajectory: Trajectory, blocks: dict[str, np.ndarray], tau: np.ndarray, weight: np.ndarray
) -> tuple[float, float]:
    """Estimated error of the cost, and the largest violation of a bound, scaled."""
    transcribed = trajectory.transcribed
    family, scheme = transcribed.families[0], transcribed.scheme
    assert scheme is not None
    rows, z = family.function.rows, family.function.arguments
    scale = np.array([r.scale for r in rows])
    low, high = (np.array([getattr(r, name) for r in rows]) / scale for name in ("lower", "upper"))
    integrand = ca.SX(family.function.integrand)
    function = _hamiltonian(family.function)
    n, per = len(tau), len(tau) // (len(transcribed.mesh) - 1)
    at_points = costates(trajectory)
    k = np.repeat(np.arange(len(transcribed.mesh) - 1), per)
    s = (tau - transcribed.mesh[k]) / np.diff(transcribed.mesh)[k]
    basis = scheme.basis(s)
    dense = np.einsum("nj,njm->nm", basis, at_points.reshape(-1, scheme.degree, len(rows))[k])
    values, cost, slopes, curves = (
        np.array(x) for x in function.map(n)(stacked(trajectory, family.function, blocks, tau), dense.T)
    )
    over = np.maximum(np.maximum(low[:, None] - values, values - high[:, None]), 0.0)
    off = np.where(values < low[:, None], values - low[:, None], np.where(values > high[:, None], over, 0.0))
    per_interval = ((dense.T * off) * weight).reshape(len(rows), -1, per).sum(axis=2)
    residual_part = SAFETY * float(np.abs(per_interval).sum())
    at_nodes = stacked(trajectory, family.function, trajectory.point_blocks(), family.tau)
    coarse = np.array(ca.Function("cost", [z], [integrand]).map(family.count)(at_nodes)).ravel() @ family.weights
    quadrature = abs(float(cost.ravel() @ weight) - float(coarse))
    excess, beyond = _excess(trajectory, blocks["u"], slopes.T, np.broadcast_to(curves, slopes.shape).T)
    return residual_part + quadrature + float(excess @ weight), max(float(over[low < high].max(initial=0.0)), beyond)


def _excess(
    trajectory: Trajectory, u: np.ndarray, slope: np.ndarray, curvature: np.ndarray
) -> tuple[np.ndarray, float]:
    """How much the Hamiltonian exceeds its minimum over the drives' bounds (n,), and how far drives leave bounds."""
    total, beyond = np.zeros(len(u)), 0.0
    if (
        trajectory.problem.drive_rule != "free"
        or trajectory.problem.bounds.drive_rates
        or "peak" in trajectory.model.kinds
    ):
        return total, beyond  # drives are tied to each other over time: no pointwise minimum
    for j, label in enumerate(trajectory.drive_labels):
        low, high = trajectory.model.drive_range(label)
        h, c = slope[:, j], curvature[:, j]
        with np.errstate(divide="ignore", invalid="ignore"):
            newton = np.where(c > 0, -h / np.where(c > 0, c, 1.0), np.where(h > 0, -np.inf, np.inf))
        step = np.clip(newton, low - u[:, j], high - u[:, j])
        step = np.where(np.isfinite(step), step, 0.0)
        total += np.abs(h * step + c * step**2 / 2)
        outside = np.maximum(np.maximum(low - u[:, j], u[:, j] - high), 0.0)
        beyond = max(beyond, float((outside / trajectory.model.scales.u[j]).max(initial=0.0)))
    return total, beyond
