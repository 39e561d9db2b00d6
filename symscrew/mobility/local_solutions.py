"""The closure equations around one configuration: range, null space, self-stresses, second order, refinement."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import eliminate, null_space
from symscrew.mobility.tangent_cone import second_order
from symscrew.mobility.variety import Array, ClosureVariety

CLOSED = 1e-26
"""A residual below this, in units of the mechanism's size, is closed: as for ranks (`screw_systems`)."""

STEPS = (0.05, 0.02, 0.005, 0.001, 2e-4)
SEED = 20230811
LIMITS_OF_RANK = (1e-7, 1e-5)
DISTINCT = 1e-11
DEFINITE = 1e-6
"""Smallest eigenvalue of a combination of unit forms that is worth proving definite."""


@dataclass(frozen=True)
class Local:
    """A configuration with the singular value decomposition of its closure Jacobian.

    `kernel`: orthonormal instantaneous motions as columns, `dependent` their complement; `stresses`: orthonormal
    left null space as rows, `range_rows` its complement; `inverse`: pseudo-inverse; `gap`: (smallest used,
    largest neglected) singular value.
    """

    q: Array
    rank: int
    kernel: Array
    dependent: Array
    stresses: Array
    range_rows: Array
    inverse: Array
    gap: tuple[float, float]

    @property
    def dof(self) -> int:
        """Number of instantaneous freedoms."""
        return self.kernel.shape[1]


@dataclass(frozen=True)
class Trial:
    """A finite motion: does it close? `residual` after solving all equations but the redundant ones."""

    closed: bool
    residual: float
    step: float


def local_at(
    variety: ClosureVariety, q: Array, *, motions: Sequence[Sequence] | None = None, rank: int | None = None
) -> Local:
    """The decomposition at q. The rank is that of the known `motions`, or given, or decided by the gap."""
    jacobian = variety.evaluate(q[None])[1][0]
    u, s, vt = np.linalg.svd(jacobian)
    if motions is not None:
        rank = variety.columns - len(motions)
    if rank is None:
        rank = _rank(s)
    inverse = vt[:rank].T @ ((u[:, :rank] / s[:rank]).T)
    gap = (float(s[rank - 1]) if rank else float("inf"), float(s[rank]) if rank < len(s) else 0.0)
    return Local(q, rank, vt[rank:].T, vt[:rank].T, u[:, rank:].T, u[:, :rank].T, inverse, gap)


def _rank(values: Array) -> int:
    """Count of singular values above the widest gap between the two limits of doubt."""
    relative = values / max(values[0], 1e-300)
    low, high = LIMITS_OF_RANK
    sure = int((relative > high).sum())
    best, widest = sure, 0.0
    for k in range(sure, int((relative > low).sum()) + 1):
        above = relative[k - 1] if k else 1.0
        below = max(relative[k] if k < len(relative) else 0.0, 1e-16)
        if above / below > widest:
            best, widest = k, above / below
    return best


def coarse_rank(variety: ClosureVariety, q: Array) -> float:
    """Rank of the Jacobian in double precision, and of equal ranks the one with the larger smallest value."""
    values = np.linalg.svd(variety.evaluate(q[None])[1][0], compute_uv=False)
    rank = int((values > DISTINCT * max(values[0], 1e-300)).sum())
    return rank + min(0.5, float(values[rank - 1])) if rank else 0.0


def flatten(dof: int, count: int = 3) -> Iterator[Array]:
    """Random unit directions among the instantaneous motions, always the same ones."""
    generator = np.random.default_rng(SEED)
    for _ in range(count):
        direction = generator.normal(size=dof)
        yield direction / np.linalg.norm(direction)


def vanishes(
    coarse: ClosureVariety, fine: ClosureVariety, here: Local, direction: Array, steps: Sequence[float] = STEPS
) -> Trial:
    """The reduced closure g at one finite motion along `direction`: zero in 60 digits, or how far off.

    The step is reduced until the iteration for the dependent coordinates converges.
    """
    for step in steps:
        q = here.q + here.kernel @ (step * direction)
        solved = _solve_dependent(coarse, here, q)
        if solved is None:
            continue
        residual = refine(coarse, fine, solved, here.rank)[1]
        return Trial(residual < CLOSED, residual, step)
    return Trial(False, float("nan"), steps[-1])


def _solve_dependent(variety: ClosureVariety, here: Local, q: Array) -> Array | None:
    """The displacement with the same independent coordinates that solves all but the redundant equations."""
    size = np.linalg.norm(q - here.q)
    start = q
    for _ in range(40):
        residual = variety.residual(q)
        step = here.inverse @ residual
        q = q - step
        if np.linalg.norm(q - start) > size:
            return None
        if np.linalg.norm(step) < 1e-13:
            return q
    return None


def refine(coarse: ClosureVariety, fine: ClosureVariety, q: Array, rank: int) -> tuple[Array, float]:
    """(q in 60 digits, residual left) after Newton's method with the inverse in double precision.

    Each step of the double-precision inverse gains about 14 digits; only the residual needs 60.
    """
    local = local_at(coarse, q, rank=rank)
    point = np.array([CONTEXT.mpf(float(c)) for c in q], dtype=object)
    best = float("inf")
    for _ in range(12):
        residual = fine.residual(point).astype(float)
        size = float(np.linalg.norm(residual))
        if size < 1e-52 or size > 0.5 * best:
            return point, min(size, best)
        best = size
        point = point - np.array([CONTEXT.mpf(float(c)) for c in local.inverse @ residual], dtype=object)
    return point, best


def local_refined(coarse: ClosureVariety, fine: ClosureVariety, q: Array) -> tuple[Local, Array, float]:
    """(decomposition at a zero with the rank decided in 60 digits, the refined zero, its closure residual).

    Singular values of a branch that leaves a singular configuration only at high order are small but not zero;
    they are told apart after the zero has been refined. Where it cannot be (a shaky branch), by the gap.
    """
    doubtful = local_at(coarse, q)
    values = np.linalg.svd(coarse.evaluate(q[None])[1][0], compute_uv=False)
    most = int((values > DISTINCT * max(values[0], 1e-300)).sum())
    if most == doubtful.rank:
        return doubtful, *refine(coarse, fine, q, doubtful.rank)
    point, residual = refine(coarse, fine, q, most)
    if residual > CLOSED:
        return doubtful, *refine(coarse, fine, q, doubtful.rank)
    rank = eliminate(fine.evaluate(point[None])[1][0].tolist(), fine.columns).rank
    return local_at(coarse, point.astype(float), rank=rank), point, residual


def quadratic_forms(variety: ClosureVariety, here: Local) -> Array:
    """One symmetric matrix per self-stress: g_k(u) = u^T Q_k u / 2 + ... on the instantaneous motions.

    By screw brackets (`tangent_cone.second_order`); what is rounding becomes zero.
    """
    screws = variety.forward(here.q[None])[0][0]
    forms = second_order(variety.network, screws, here.stresses, here.kernel)
    forms[np.abs(forms) < 1e-13 * max(1.0, float(np.abs(forms).max(initial=0.0)))] = 0.0
    return forms


def definite_stress(forms: Array) -> Array | None:
    """Weights of a combination of the forms that is positive definite in double precision, or None if none was found.

    Perceptron on the motions: as long as a motion gets no positive value, add its values to the combination.
    """
    used = [form / np.linalg.norm(form) if form.any() else form for form in forms]
    if not forms.any():
        return None
    stack = np.array(used)
    weights = np.trace(stack, axis1=1, axis2=2)
    if not weights.any():
        weights = np.ones(len(stack))
    for _ in range(300):
        values, vectors = np.linalg.eigh(np.tensordot(weights / np.linalg.norm(weights), stack, axes=1))
        if values[0] > DEFINITE:
            sizes = np.array([np.linalg.norm(form) or 1.0 for form in forms])
            return weights / np.linalg.norm(weights) / sizes
        motion = vectors[:, 0]
        gain = np.einsum("i,kij,j->k", motion, stack, motion)
        if np.linalg.norm(gain) < 1e-9:
            return None
        weights = weights + gain * np.linalg.norm(weights) / 4 / max(np.linalg.norm(gain), 1e-9)
    return None


def proved_definite(network: Network, motions: Sequence[Sequence], stress: Array) -> Any:
    """Smallest pivot of a self-stress's form on the instantaneous motions, if it is positive definite in 60 digits.

    `stress` in double precision is replaced by the nearest combination of the self-stresses in 60 digits. The
    pivots are those of a Cholesky decomposition, relative to the largest entry; None if one is not positive.
    """
    rows = network.loop_rows()
    exact = null_space([list(column) for column in zip(*rows, strict=True)], len(rows)).basis
    basis = np.array(exact, dtype=object)
    weights = np.linalg.lstsq(basis.astype(float).T, stress, rcond=None)[0]
    combined = sum(CONTEXT.mpf(float(w)) * vector for w, vector in zip(weights, basis, strict=True))
    screws = np.array(network.screws, dtype=object)
    kernel = np.array(motions, dtype=object).T
    form = second_order(network, screws, np.array([combined], dtype=object), kernel)[0]
    largest = max(abs(c) for c in form.ravel())
    smallest = None
    for k in range(len(form)):
        pivot = form[k, k] / largest
        if pivot < CONTEXT.mpf(10) ** -20:
            return None
        smallest = pivot if smallest is None else min(smallest, pivot)
        form = form - np.outer(form[:, k], form[k, :]) / form[k, k]
    return smallest
