"""The closure equations around one configuration: range, null space, self-stresses, second order, refinement.

J = U S V^T at q: kernel (instantaneous motions) and dependent coordinates from V, self-stresses and range from U
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.finite.tangent_cone import second_order
from symscrew.mobility.finite.variety import Array, ClosureVariety
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import Real, Screw, eliminate, null_space

CLOSED = 1e-26
"""A residual below this, in units of the mechanism's size, is closed: as for ranks (`screw_systems`)."""

STEPS = (0.05, 0.02, 0.005, 0.001, 2e-4)
"""Sizes of the finite motion that is tried, in units of the mechanism's size: the largest on which Newton's method
converges is taken, because a redundant equation that is off by a k-th power of the step shows best there. After
the smallest a seventh power, 1e-26, would pass for closed; where none converges nothing is known (`Trial.solved`)."""
SEED = 20230811
"""Of the random directions: always the same, so that results repeat."""
LIMITS_OF_RANK = (1e-7, 1e-5)
"""Relative singular values below the first are zero and above the second are not; between them the widest gap decides.
On a sphere of radius 0.02 singular values of a branch are of the order of the radius or its powers up to the third."""
DISTINCT = 1e-11
"""A relative singular value above this is perhaps not zero, and is looked at again after the point has been refined to
60 digits; below it is rounding of double precision."""
DEFINITE = 1e-6
"""Smallest eigenvalue of a combination of unit forms that is worth proving definite with 60 digits: far above
rounding, far below what a definite form of a mechanism has."""
ROUNDS = 300
"""Rounds of the search for such a combination. It needs about (size / smallest eigenvalue)^2 of them; beyond it none
is said to have been found, and the branches are sampled instead, which decides as well but proves less."""
NO_GAIN = 1e-9
"""All unit forms vanish on a motion, up to rounding: no combination is definite, so that the search can end."""
ROUNDING = 1e-13
"""Entries of the forms below this, relative to the largest, are what double precision leaves of zero."""
CONVERGED = 1e-13
"""Newton's method in double precision has ended: its step is rounding."""
RESIDUAL = 1e-15
"""Rounding of the residual in double precision. Where the smallest singular value is below a hundredth, steps are this
divided by it at the end: of screws with a pitch of 0.1 mm/rad 1e-11, which never was as short as it had to be."""
LONGEST = 1e-10
"""No longer step ends it: a singular value that would ask for one is rounding itself, and steps that end would be those
of a method that still converges. What is left is this squared."""
EXACT = 1e-52
"""The closure residual of a point in 60 digits that is rounding."""
REFINEMENTS = 12
"""Steps to 60 digits: four do at a regular point (14 digits each); a double zero halves its error in each, and
is given back with the residual that is left."""
POSITIVE = CONTEXT.mpf(10) ** -20
"""A pivot of a Cholesky decomposition in 60 digits above this, relative to the largest entry, is positive."""


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
        return int(self.kernel.shape[1])


@dataclass(frozen=True)
class Trial:
    """A finite motion: does it close? `residual` after solving all equations but the redundant ones.

    The residual is not a number where no step was small enough for these to be solved: then nothing is known.
    """

    closed: bool
    residual: float
    step: float

    @property
    def solved(self) -> bool:
        """Whether the iteration converged at all."""
        return not np.isnan(self.residual)


def local_at(
    variety: ClosureVariety, q: Array, *, motions: Sequence[Screw] | None = None, rank: int | None = None
) -> Local:
    """The decomposition at q. The rank is that of the known `motions`, or given, or decided by the gap."""
    jacobian = variety.slopes(q[None])[0]
    u, s, vt = np.linalg.svd(jacobian)
    if motions is not None:
        rank = variety.columns - len(motions)
    if rank is None:
        rank = _rank(s)
    kept = np.where(s[:rank] > 0, s[:rank], np.inf)  # a rank that is not reached here leaves no steps along it
    inverse = vt[:rank].T @ ((u[:, :rank] / kept).T)
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
    values = np.linalg.svd(variety.slopes(q[None])[0], compute_uv=False)
    rank = int((values > DISTINCT * max(values[0], 1e-300)).sum())
    return rank + min(0.5, float(values[rank - 1])) if rank else 0.0


def flatten(dof: int, count: int = 3) -> Iterator[Array]:
    """Random unit directions among the instantaneous motions, always the same ones."""
    generator = np.random.default_rng(SEED)
    for _ in range(count):
        direction = generator.normal(size=dof)
        yield direction / np.linalg.norm(direction)


def vanishes(
    coarse: ClosureVariety, fine: ClosureVariety, here: Local, direction: Array, *, steps: Sequence[float] | None = None
) -> Trial:
    """The reduced closure g at one finite motion along `direction`: zero in 60 digits, or how far off.

    The step is reduced until the iteration for the dependent coordinates converges.
    """
    steps = STEPS if steps is None else steps
    for step in steps:
        q = here.q + here.kernel @ (step * direction)
        solved = solve_dependent(coarse, here, q)
        if solved is None:
            continue
        residual = refine(coarse, fine, solved, here.rank)[1]
        return Trial(residual < CLOSED, residual, step)
    return Trial(False, float("nan"), steps[-1])


def solve_dependent(variety: ClosureVariety, here: Local, q: Array) -> Array | None:
    """The displacement with the same independent coordinates that solves all but the redundant equations."""
    size = np.linalg.norm(q - here.q)
    start, enough = q, max(CONVERGED, min(LONGEST, RESIDUAL / here.gap[0])) if here.gap[0] else CONVERGED
    for _ in range(40):
        residual = variety.residual(q)
        step = here.inverse @ residual
        q = q - step
        if np.linalg.norm(q - start) > size:
            return None
        if np.linalg.norm(step) < enough:
            return q
    return None


def refine(coarse: ClosureVariety, fine: ClosureVariety, q: Array, rank: int) -> tuple[Array, float]:
    """(q in 60 digits, residual left) after Newton's method with the inverse in double precision.

    Each step of the double-precision inverse gains about 14 digits; only the residual needs 60.
    """
    local = local_at(coarse, q, rank=rank)
    point = np.array([CONTEXT.mpf(float(c)) for c in q], dtype=object)
    best = float("inf")
    for _ in range(REFINEMENTS):
        residual = fine.residual(point).astype(float)
        size = float(np.linalg.norm(residual))
        if size < EXACT or size > 0.5 * best:
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
    values = np.linalg.svd(coarse.slopes(q[None])[0], compute_uv=False)
    most = int((values > DISTINCT * max(values[0], 1e-300)).sum())
    if most == doubtful.rank:
        return doubtful, *refine(coarse, fine, q, doubtful.rank)
    point, residual = refine(coarse, fine, q, most)
    if residual > CLOSED:
        return doubtful, *refine(coarse, fine, q, doubtful.rank)
    rank = eliminate(fine.slopes(point[None])[0].tolist(), fine.columns).rank
    return local_at(coarse, point.astype(float), rank=rank), point, residual


def quadratic_forms(variety: ClosureVariety, here: Local) -> Array:
    """One symmetric matrix per self-stress: g_k(u) = u^T Q_k u / 2 + ... on the instantaneous motions.

    By screw brackets (`tangent_cone.second_order`); what is rounding becomes zero.
    """
    screws = variety.displaced(here.q[None])[0]
    forms = second_order(variety.network, screws, here.stresses, here.kernel, displaced=here.q)
    forms[np.abs(forms) < ROUNDING * max(1.0, float(np.abs(forms).max(initial=0.0)))] = 0.0
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
    for _ in range(ROUNDS):
        values, vectors = np.linalg.eigh(np.tensordot(weights / np.linalg.norm(weights), stack, axes=1))
        if values[0] > DEFINITE:
            sizes = np.array([np.linalg.norm(form) or 1.0 for form in forms])
            return np.asarray(weights / np.linalg.norm(weights) / sizes)
        motion = vectors[:, 0]
        gain = np.einsum("i,kij,j->k", motion, stack, motion)
        if np.linalg.norm(gain) < NO_GAIN:
            return None
        weights = weights + gain * np.linalg.norm(weights) / 4 / max(np.linalg.norm(gain), NO_GAIN)
    return None


def proved_definite(network: Network, motions: Sequence[Screw], stress: Array) -> Real | None:
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
    if not largest:  # what doubles saw of it was rounding
        return None
    smallest = None
    for k in range(len(form)):
        pivot = form[k, k] / largest
        if pivot < POSITIVE:
            return None
        smallest = pivot if smallest is None else min(smallest, pivot)
        form = form - np.outer(form[:, k], form[k, :]) / form[k, k]
    return smallest
