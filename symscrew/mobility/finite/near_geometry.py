"""Special geometry close to the one typed: the smallest change of joints with which what almost vanishes does vanish.

    ranks that are almost lower, configurations in which loops almost close --conditions--> unknown places and axes
    conditions --Gauss-Newton with the least change, residuals in 60 digits--> special geometry

The unknowns are the places and axes of all joints. The conditions are ranks that are lower in the reference
configuration (with their null vectors as further unknowns) and the closure of all loops in configurations along the
motions that nearly close (with these configurations as further unknowns). Whether the geometry found really moves is
left to the ordinary analysis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.finite.almost_ranks import NEAR, RankClaim, low_ranks
from symscrew.mobility.finite.branches import zeros_nearby
from symscrew.mobility.finite.joint_changes import (
    Slots,
    changed,
    closure_rates,
    count_of,
    screw_rates,
    sizes,
    slots_of,
)
from symscrew.mobility.finite.local_solutions import (
    CLOSED,
    Local,
    flatten,
    local_at,
    quadratic_forms,
    refine,
    solve_dependent,
)
from symscrew.mobility.finite.variety import DIGITS_60, Array, ClosureVariety
from symscrew.mobility.joint_network import Network

STEP = 0.2
"""Steps of the finite motions, in units of the mechanism's size and in radians: small enough that Newton's method
solves them. The longest has `MOTIONS` of them, large enough that what a motion needs at high order shows: on a short
piece of a curve ten conditions differ by less than the rounding of doubles."""
FAR_FROM_SINGULAR = 0.05
"""A motion ends before its closure comes this much nearer to losing rank, where Newton's method may jump."""
MOTIONS = 8
"""Finite motions along which the loops are to close, both ways each: more conditions than any linkage has numbers."""
CLOSES = 1e4
"""A finite motion nearly closes if it is off by less than this times the small singular value: of order one times it
where the motion exists as meant, of the order of the step squared where it does not."""
CUT_OFF = 30.0
"""Singular values of the conditions below so many times the small one of the closure are rounding as typed."""
LEAST_ROUGH = 1e-13
"""Rounding of doubles in the conditions, after the decompositions that make them."""
LARGEST_CUT = 0.1
"""Of rough numbers the clearest conditions count all the same."""
ROUNDS = 14
"""Steps of Gauss-Newton: linear with the ratio of the distance, so a handful for doubles and a dozen for six digits."""
LINEARISED = 3
"""Rounds that linearise anew; what is left then is far below the distance, so that the derivatives stay."""
CONVERGED = 1e-40
"""Residual at which it has ended: far below what ranks take for zero, far above rounding of 60 digits."""
LEAST_NOISE = 1e-15
"""Rounding of doubles: what is smaller is not measured by them."""
FARTHEST = 1e-3
"""Of the mechanism's size: farther geometry is another mechanism."""


@dataclass(frozen=True)
class NearGeometry:
    """The special geometry: its network, the largest change of a joint [1, the mechanism's size], and of which.

    `moves`: found from finite motions that close; else only ranks in the reference configuration are lost.
    """

    network: Network
    distance: float
    changes: tuple[tuple[str, float], ...]
    moves: bool


def nearest_special(network: Network, claims: Sequence[RankClaim], *, moves: bool) -> tuple[NearGeometry, ...]:
    """The nearest geometries in which what almost vanishes does: ranks alone, and with the motions.

    Empty where there is nothing that almost is, or none was found. `moves`: as typed it moves along all its
    instantaneous freedoms. Ranks that are low as typed stay so.
    """
    coarse = ClosureVariety(network)
    low = low_ranks(network, claims, np.array(coarse.centre, dtype=object))
    almost = [one for one in low if one.almost]
    if not network.chords or (moves and not almost):
        return ()
    noise = max((LEAST_NOISE, *(one.size for one in almost)))
    closure = next((one for one in low if one.claim.name == "closure"), None)
    ranks = [(one.claim, one.rank) for one in low]
    points: list[tuple[Array, int]] = []
    if closure is not None:
        off = CLOSES * noise if almost else NEAR
        here = local_at(coarse, np.zeros(coarse.columns), rank=closure.rank)
        points = _motions(coarse, here, off)
        if points and not almost and not _open(network, coarse, points):
            return ()  # what was typed moves so itself
        if points:
            found = _solved(network, points, ranks, noise)
            if found is None and almost:  # else ranks alone are those of what was typed
                found = _solved(network, [], ranks, noise)
            return () if found is None else (found,)
        zeros = zeros_nearby(coarse, here, quadratic_forms(coarse, here), off)
        points = _open(network, coarse, [(point, _rank(coarse, point)) for point in zeros])
    tried: list[list[tuple[Array, int]]] = [[]] if almost else []
    tried += [points] if points else []
    found_all = (_solved(network, given, ranks, noise) for given in tried)
    return tuple(one for one in found_all if one is not None)


def _motions(coarse: ClosureVariety, here: Local, off: float) -> list[tuple[Array, int]]:
    """(configuration, rank there) along finite motions that all nearly close; none where one does not."""
    points = []
    for k, direction in enumerate(flatten(here.dof, MOTIONS)):
        for length in (k + 1, -k - 1.5):  # all different: one freedom has one line
            q = _walked(coarse, here, STEP * length * direction, off)
            if q is None:
                return []
            points.append((q, here.rank))
    return points


def _walked(coarse: ClosureVariety, here: Local, motion: Array, off: float) -> Array | None:
    """Where a motion of this length ends, as far as it closes to `off`; None if its first step does not."""
    length = float(np.linalg.norm(motion))
    place, q, gone, direction = here, None, 0.0, motion / length
    while gone < length - STEP / 4:
        step = min(STEP, length - gone)
        trial = solve_dependent(coarse, place, place.q + place.kernel @ (step * direction))
        if trial is None or np.linalg.norm(coarse.residual(trial)) > off:
            return q
        after = local_at(coarse, trial, rank=here.rank)
        if after.gap[0] < FAR_FROM_SINGULAR * here.gap[0]:
            return trial if q is None else q
        ahead = after.kernel.T @ (place.kernel @ direction)
        place, q, direction, gone = after, trial, ahead / np.linalg.norm(ahead), gone + step
    return q


def _open(network: Network, coarse: ClosureVariety, points: Sequence[tuple[Array, int]]) -> list[tuple[Array, int]]:
    """Those of the configurations in which the loops do not close as typed, in 60 digits."""
    fine = ClosureVariety(network, DIGITS_60)
    return [(q, rank) for q, rank in points if refine(coarse, fine, q, rank)[1] > CLOSED]


def _rank(coarse: ClosureVariety, q: Array) -> int:
    values = np.linalg.svd(coarse.evaluate(q[None])[1][0], compute_uv=False)
    return int((values > NEAR * values[0]).sum())


@dataclass(frozen=True)
class _Linear:
    """A condition linearised: `left` are the parts that its own unknowns cannot make vanish, `by_z` of the geometry."""

    left: Array
    inverse: Array
    by_z: Array


class _Closes:
    """The loops close in a configuration, which may change a little."""

    def __init__(self, q: Array, rank: int) -> None:
        self.q, self.rank = _fine(q), rank

    def residual(self, _: Network, fine: ClosureVariety) -> Array:
        return fine.residual(self.q).astype(float)

    def step(self, change: Array) -> None:
        self.q = self.q - _fine(change)


class _Singular:
    """A vector stays in the null space of a claim's matrix; it may change a little across it."""

    def __init__(self, claim: RankClaim, rank: int, vector: Array) -> None:
        self.claim, self.rank, self.vector = claim, rank, _fine(vector)

    def residual(self, network: Network, fine: ClosureVariety) -> Array:
        found = self.claim.matrix(network, np.array(fine.centre, dtype=object)) @ self.vector
        return np.asarray(found).astype(float)

    def step(self, change: Array) -> None:
        self.vector = self.vector - _fine(change)


_Conditions = tuple[list[_Closes], list[_Singular]]


def _fine(values: Array) -> Array:
    return np.array([CONTEXT.mpf(float(c)) for c in values], dtype=object)


def _conditions(
    network: Network, points: Sequence[tuple[Array, int]], ranks: Sequence[tuple[RankClaim, int]]
) -> _Conditions:
    centre = np.array(ClosureVariety(network).centre, dtype=object)
    singular = []
    for claim, rank in ranks:
        vectors = np.linalg.svd(claim.matrix(network, centre).astype(float))[2][rank:]
        singular += [_Singular(claim, rank, vector) for vector in vectors]
    return [_Closes(q, rank) for q, rank in points], singular


def _linear(network: Network, slots: Slots, conditions: _Conditions) -> list[_Linear]:
    """All conditions linearised about the geometry and their own unknowns, in doubles."""
    coarse = ClosureVariety(network)
    centre = np.array(coarse.centre, dtype=object)
    closes, singular = conditions
    result = []
    if closes:
        batch = np.array([one.q.astype(float) for one in closes])
        for one, q, by_z in zip(closes, batch, closure_rates(coarse, slots, batch), strict=True):
            place = local_at(coarse, q, rank=one.rank)
            result.append(_Linear(place.stresses, place.inverse, by_z))
    rates = screw_rates(network, slots, centre.astype(float))
    decomposed = {}
    for vanishing in singular:
        claim, rank = vanishing.claim, vanishing.rank
        if claim.name not in decomposed:
            decomposed[claim.name] = np.linalg.svd(claim.matrix(network, centre).astype(float))
        u, s, vt = decomposed[claim.name]
        inverse = vt[:rank].T @ ((u[:, :rank] / s[:rank]).T)
        pulled = claim.pulled(network, rates, vanishing.vector.astype(float))
        result.append(_Linear(u[:, rank:].T, inverse, pulled))
    return result


def _solved(
    network: Network, points: Sequence[tuple[Array, int]], ranks: Sequence[tuple[RankClaim, int]], noise: float
) -> NearGeometry | None:
    slots = slots_of(network)
    both = _conditions(network, points, ranks)
    conditions: list[_Closes | _Singular] = [*both[0], *both[1]]
    z = np.array([CONTEXT.zero] * count_of(slots), dtype=object)
    best, after, rough = float("inf"), network, noise
    linear: list[_Linear] = []
    for attempt in range(ROUNDS):
        after = changed(network, slots, z)
        fine = ClosureVariety(after, DIGITS_60)
        residuals = [condition.residual(after, fine) for condition in conditions]
        size = max(float(np.linalg.norm(r)) for r in residuals)
        if size < CONVERGED:
            break
        if attempt >= LINEARISED and size > best / 2:
            return None
        if attempt < LINEARISED:
            linear = _linear(after, slots, both)
            rough = max(LEAST_ROUGH, rough if attempt == 0 else size)
        best = size
        matrix = np.concatenate([one.left @ one.by_z for one in linear])
        missing = np.concatenate([one.left @ r for one, r in zip(linear, residuals, strict=True)])
        dz = -np.linalg.lstsq(matrix, missing, rcond=min(LARGEST_CUT, CUT_OFF * rough))[0]
        z = z + np.array([CONTEXT.mpf(float(c)) for c in dz], dtype=object)
        for condition, one, r in zip(conditions, linear, residuals, strict=True):
            condition.step(one.inverse @ (r + one.by_z @ dz))
    else:
        return None
    changes = sizes(network, after)
    distance = max(size for _, size in changes)
    return NearGeometry(after, distance, changes, bool(points)) if distance < FARTHEST else None
