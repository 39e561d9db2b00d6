"""The closure equations around one configuration: range, null space, self-stresses, second order, refinement."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.mobility.screw_systems import eliminate
from symscrew.mobility.variety import Array, ClosureVariety
from symscrew.operations import CONTEXT

CLOSED = 1e-26
"""A residual below this, in units of the mechanism's size, is closed: as for ranks (`screw_systems`)."""

STEPS = (0.05, 0.02, 0.005, 0.001, 2e-4)
SEED = 20230811
LIMITS_OF_RANK = (1e-7, 1e-5)
DISTINCT = 1e-11


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


def local_refined(coarse: ClosureVariety, fine: ClosureVariety, q: Array) -> tuple[Local, float]:
    """(decomposition at a zero with the rank decided in 60 digits, closure residual of the refined zero).

    Singular values of a branch that leaves a singular configuration only at high order are small but not zero;
    they are told apart after the zero has been refined. Where it cannot be (a shaky branch), by the gap.
    """
    doubtful = local_at(coarse, q)
    values = np.linalg.svd(coarse.evaluate(q[None])[1][0], compute_uv=False)
    most = int((values > DISTINCT * max(values[0], 1e-300)).sum())
    if most == doubtful.rank:
        return doubtful, refine(coarse, fine, q, doubtful.rank)[1]
    point, residual = refine(coarse, fine, q, most)
    if residual > CLOSED:
        return doubtful, residual
    rank = eliminate(fine.evaluate(point[None])[1][0].tolist(), fine.columns).rank
    return local_at(coarse, point.astype(float), rank=rank), residual


def quadratic_forms(variety: ClosureVariety, here: Local) -> Array:
    """One symmetric matrix per self-stress: the second-order part of g on the instantaneous motions.

    g_k(u) = u^T Q_k u / 2 + ..., Q_k from the derivative of the Jacobian along each motion: the brackets
    [S_i, S_j] of the joint screws. Differentiated by central differences of the analytic Jacobian.
    """
    step = 1e-5
    points = np.concatenate([here.q + step * here.kernel.T, here.q - step * here.kernel.T])
    jacobians = variety.evaluate(points)[1]
    change = (jacobians[: here.dof] - jacobians[here.dof :]) / (2 * step)
    forms = np.einsum("kr,irc,cj->kij", here.stresses, change, here.kernel)
    forms = (forms + forms.transpose(0, 2, 1)) / 2
    size = np.abs(forms).max(initial=0.0)
    forms[np.abs(forms) < 1e-9 * max(1.0, size)] = 0.0
    return forms


def definite_stress(forms: Array) -> float | None:
    """Relative smallest eigenvalue of a definite combination of the forms, or None if none was found.

    Perceptron on the motions: as long as a motion gets no positive value, add its values to the combination.
    """
    used = [form / np.linalg.norm(form) for form in forms if np.abs(form).max() > 0]
    if not used:
        return None
    stack = np.array(used)
    weights = np.trace(stack, axis1=1, axis2=2)
    if not weights.any():
        weights = np.ones(len(stack))
    for _ in range(300):
        values, vectors = np.linalg.eigh(np.tensordot(weights / np.linalg.norm(weights), stack, axes=1))
        if values[0] > 1e-7 * max(abs(values[-1]), 1e-12):
            return float(values[0] / abs(values[-1]))
        motion = vectors[:, 0]
        gain = np.einsum("i,kij,j->k", motion, stack, motion)
        if np.linalg.norm(gain) < 1e-9:
            return None
        weights = weights + gain * np.linalg.norm(weights) / 4 / max(np.linalg.norm(gain), 1e-9)
    return None
