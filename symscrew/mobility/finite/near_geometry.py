"""Special geometry close to the one typed: the smallest change of joints with which what almost vanishes does vanish.

    ranks that are almost lower, configurations in which loops almost close --conditions--> unknown places and axes
    conditions --Gauss-Newton with the least change, residuals in 60 digits--> special geometry
    conditions at which it stalls --aligned_axes--> axes that nearly are parallel or meet made so, then as before
    conditions at which it still stalls --alike_links--> links that nearly are alike made so, then as before
    conditions at which it stalls without such --double_zeros--> special geometry where they vanish twice

The unknowns are the places and axes of all joints. The conditions are ranks that are lower in the reference
configuration (with their null vectors as further unknowns) and the closure of all loops in configurations along the
motions that nearly close (with these configurations as further unknowns). Whether the geometry found really moves is
left to the ordinary analysis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property, partial

import numpy as np

from symscrew.mobility.finite.aligned_axes import aligned, turned_together
from symscrew.mobility.finite.alike_links import Alike, alike
from symscrew.mobility.finite.almost_ranks import NEAR, LowRank, RankClaim, low_ranks, nearer
from symscrew.mobility.finite.approach import Approach, GivenUpError, NearGeometry, OtherJointsError, between
from symscrew.mobility.finite.branches import zeros_nearby
from symscrew.mobility.finite.local_solutions import (
    CLOSED,
    DISTINCT,
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
solves them."""
SHORTEST = STEP / 16
"""Where Newton's method does not solve a step, half of it is tried, down to this: a closure that comes near to losing
rank leaves it as little room as its singular value is small. 0.013 solved a step of 0.05, and none of 0.1."""
SPREAD = 0.4
"""How far apart the configurations are in which loops are to close. The longest motion has `MOTIONS` times that, long
enough that what a motion needs at high order shows: on a short piece of a curve ten conditions differ by less than the
rounding of doubles, and at half of this the last of the eight of two Bennett loops is a millionth of the first."""
FAR_FROM_SINGULAR = 0.05
"""A motion ends before its closure comes this much nearer to losing rank, where Newton's method may jump."""
MOTIONS = 8
"""Finite motions along which the loops are to close, both ways each: more conditions than any linkage has numbers."""
CLOSES = 1e4
"""A finite motion nearly closes if it is off by less than this times the small singular value: of order one times it
where the motion exists as meant, of the order of the step squared where it does not."""
ALMOST_ZERO = 100.0
"""Zeros on a sphere may be off by so many times the small singular value: of six digits `CLOSES` times it is what the
redundant equations are off by anywhere on the sphere."""
SAME = 1e-9
"""Change of coordinates with which a zero is the same one: those of a branch that leaves a singular configuration at
second order close with a change of 1e-12; of rounded numbers, that which closes them is as large as the zero is far."""
ROUNDED_ZERO = 1e-11
"""They may be off by this as well: rounding of doubles in zeros that are double ones."""
LEAST_NOISE = 1e-15
"""Rounding of doubles: what is smaller is not measured by them."""
ROUGH = 30.0
"""Angles and distances below so many times the small singular value are rounding; where that aligns nothing that moves,
those below `NEAR`."""
AMPLIFIED = 10.0
"""Links made alike are farther than they were off by one or two, for rings of twelve bars by four; two relations that
agree by chance and contradict the others were met after fifty."""
FIRST = 8
"""Configurations of each kind that are tried where twice as many are too many: conditions of which some hardly change
with the geometry. With these alone a branch of dimension two has been missed."""


def search_special(network: Network, claims: Sequence[RankClaim], *, moves: bool) -> tuple[NearGeometry, ...] | str:
    """`nearest_special`, or why it was given up, in words."""
    try:
        return nearest_special(network, claims, moves=moves)
    except GivenUpError as error:
        return str(error)


def nearest_special(network: Network, claims: Sequence[RankClaim], *, moves: bool) -> tuple[NearGeometry, ...]:
    """The nearest geometries in which what almost vanishes does: ranks alone, and with the motions.

    Empty where there is nothing that almost is, or none was found. `moves`: as typed it moves along all its
    instantaneous freedoms. Ranks that are low as typed stay so.

    Raises:
        GivenUpError: a search took too long, so that none is known.
    """
    near: float | None = NEAR
    while near is not None:
        try:
            return _nearest(network, claims, near, moves=moves)
        except OtherJointsError:  # fine pitches are no rounding: what is smaller than they is looked at
            near = nearer(network, claims, np.array(ClosureVariety(network).centre, dtype=object), near)
    return ()


def _nearest(network: Network, claims: Sequence[RankClaim], near: float, *, moves: bool) -> tuple[NearGeometry, ...]:
    """`nearest_special` with relative singular values below `near` counted as what almost vanishes."""
    coarse = ClosureVariety(network)
    low = low_ranks(network, claims, np.array(coarse.centre, dtype=object), near)
    almost = [one for one in low if one.almost]
    if not network.chords or (moves and not almost):
        return ()
    noise = max((LEAST_NOISE, *(one.size for one in almost)))
    closure = next((one for one in low if one.claim.name == "closure"), None)
    ranks = [(one.claim, one.rank) for one in low]
    points: list[tuple[Array, int]] = []
    astray, like = False, _Likeness(network, ranks, noise)
    if closure is not None:
        off = CLOSES * noise if almost else near
        here = local_at(coarse, np.zeros(coarse.columns), rank=closure.rank)
        if not almost and _astray_at_once(network, coarse, here, ranks, off=off):
            found = _by_alignment(network, low, noise)
            return () if found is None else (found,)
        points = _motions(coarse, here, off)
        if points and not almost and not _open(network, coarse, points):
            return ()  # what was typed moves so itself
        if points:
            approach, kept = Approach(network, points, ranks, noise=noise), turned_together(network)
            tries = [approach]
            if kept.shape[1] < len(approach.search.z):
                tries.insert(0, Approach(network, points, ranks, noise=noise, ways=kept))
            found = _first(tries[:1]) or _by_alignment(network, low, noise) or like.closing(closure.rank)
            found = found or _first(tries[1:]) or _twice(tries, like)
            if found is not None or not almost:  # else ranks alone are those of what was typed
                return () if found is None else (found,)
            astray = approach.astray  # then these motions are none that were meant
            if not astray:
                return tuple(replace(one, stalled=True) for one in like.ranks_alone())
        close = min(off, max(ALMOST_ZERO * noise, ROUNDED_ZERO))
        kinds = zeros_nearby(coarse, here, quadratic_forms(coarse, here), off=close, kind=partial(_rank, coarse, near))
        points = _open(network, coarse, [(zero, rank) for rank, zeros in kinds.items() for zero in zeros])
    alone = like.ranks_alone() if almost else ()
    moving = _through(network, points, ranks, noise, twice=like.found is None)
    if moving is None:
        return tuple(replace(one, stalled=bool(points or astray)) for one in alone)
    return (*alone, moving)


class _Likeness:
    """Geometry with the ranks whose links are alike that nearly are; sought when it is first asked for."""

    def __init__(self, network: Network, ranks: Sequence[tuple[RankClaim, int]], noise: float) -> None:
        self.network, self.ranks, self.noise = network, ranks, noise

    @cached_property
    def relations(self) -> Alike | None:
        return alike(self.network, min(NEAR, ROUGH * self.noise))

    @cached_property
    def found(self) -> NearGeometry | None:
        """With the ranks and the relations; None where the search stalls, or where there are no relations."""
        if self.relations is None:
            return None
        ways = turned_together(self.network)
        search = Approach(self.network, [], self.ranks, noise=self.noise, ways=ways, alike=self.relations)
        return self._near(search.found())

    def _near(self, found: NearGeometry | None) -> NearGeometry | None:
        """What is hardly farther than the relations and ranks are off: else they agree by chance."""
        off = 0.0 if self.relations is None else max(self.noise, self.relations.off)
        return found if found is not None and found.distance < AMPLIFIED * off else None

    def closing(self, rank: int) -> NearGeometry | None:
        """Where loops close along all motions as well, by hardly more than the relations."""
        if self.found is None:
            return None
        after = self.found.network
        coarse, ways = ClosureVariety(after), turned_together(after)
        points = _motions(coarse, local_at(coarse, np.zeros(coarse.columns), rank=rank), CLOSES * self.noise)
        if not points:
            return None
        closed = Approach(after, points, self.ranks, noise=LEAST_NOISE, ways=ways, alike=self.relations).found()
        return None if closed is None else self._near(between(self.network, closed.network, moves=True))

    def ranks_alone(self) -> tuple[NearGeometry, ...]:
        """The nearest with the ranks, and with the relations too: which moves as meant is left to the analysis."""
        nearest = Approach(self.network, [], self.ranks, noise=self.noise).found(twice=self.found is None)
        return tuple(one for one in (nearest, self.found) if one is not None)


def _first(tries: Sequence[Approach], *, twice: bool = False) -> NearGeometry | None:
    """The first that is found: with axes that are parallel as typed turned together, as those of a planar linkage are
    meant, then with all alone. The former has no double zeros of hinges that are tilted against each other."""
    return next((found for one in tries if (found := one.found(twice=twice)) is not None), None)


def _twice(tries: Sequence[Approach], like: _Likeness) -> NearGeometry | None:
    """`_first` with double zeros; None where that is given up and there is geometry with links alike to go by."""
    try:
        return _first(tries, twice=True)
    except GivenUpError:
        if like.found is None:
            raise
        return None


def _by_alignment(network: Network, low: Sequence[LowRank], noise: float) -> NearGeometry | None:
    """Axes made parallel, coaxial or concurrent that nearly are, where loops then close along all motions.

    Or where they do so in the nearest geometry of axes that stay parallel: those of a third leg in a plane, say.
    """
    closure = next(one for one in low if one.claim.name == "closure")
    ranks = [(one.claim, one.rank) for one in low]
    for tolerance in (min(NEAR, ROUGH * noise), NEAR):
        other = aligned(network, tolerance)
        if other is None:
            continue
        coarse = ClosureVariety(other)
        points = _motions(coarse, local_at(coarse, np.zeros(coarse.columns), rank=closure.rank), CLOSES * noise)
        found = Approach(other, points, ranks, noise=noise, ways=turned_together(other)).found() if points else None
        if found is not None:
            return between(network, found.network, moves=True)
    return None


def _astray_at_once(
    network: Network, coarse: ClosureVariety, here: Local, ranks: Sequence[tuple[RankClaim, int]], *, off: float
) -> bool:
    """Whether all finite motions begin by nearly closing, and to close along the first two of them leads astray.

    The least change that closes the loops along all of them is no smaller.
    """
    if any(_walked(coarse, here, STEP * sign * d, off) is None for d in flatten(here.dof, MOTIONS) for sign in (1, -1)):
        return False
    first = _motions(coarse, here, off, most=2)
    if len(_open(network, coarse, first)) < len(first):
        return False
    approach = Approach(network, first, ranks, noise=LEAST_NOISE)
    return approach.found(rounds=1) is None and approach.astray


def _motions(coarse: ClosureVariety, here: Local, off: float, most: int = MOTIONS) -> list[tuple[Array, int]]:
    """(configuration, rank there) along finite motions that all nearly close; none where one does not."""
    points = []
    for k, direction in enumerate(flatten(here.dof, most)):
        for length in (k + 1, -k - 1.5):  # all different: one freedom has one line
            q = _walked(coarse, here, SPREAD * length * direction, off)
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
        while trial is None and step > SHORTEST:
            step /= 2
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
    return [(q, rank) for q, rank in points if not _closes(coarse, fine, q, rank)]


def _closes(coarse: ClosureVariety, fine: ClosureVariety, q: Array, rank: int) -> bool:
    """Whether loops close there as typed: with the rank that is meant, or with all that is not rounding."""
    values = np.linalg.svd(coarse.slopes(q[None])[0], compute_uv=False)
    every = int((values > DISTINCT * values[0]).sum())
    if every > rank:
        point, left = refine(coarse, fine, q, every)
        if left <= CLOSED and float(abs(point.astype(float) - q).max()) < SAME:
            return True
    return refine(coarse, fine, q, rank)[1] <= CLOSED


def _rank(coarse: ClosureVariety, near: float, q: Array) -> int:
    values = np.linalg.svd(coarse.slopes(q[None])[0], compute_uv=False)
    return int((values > near * values[0]).sum())


def _through(
    network: Network,
    points: Sequence[tuple[Array, int]],
    ranks: Sequence[tuple[RankClaim, int]],
    noise: float,
    *,
    twice: bool,
) -> NearGeometry | None:
    """Geometry with these ranks whose loops close in the configurations: in all, or in the first ones of every kind.

    `twice`: double zeros as well.
    """
    if not points:
        return None
    kinds = [rank for _, rank in points]
    fewer = [point for k, point in enumerate(points) if kinds[:k].count(point[1]) < FIRST]
    every = Approach(network, points, ranks, noise=noise)
    found = every.found(twice=twice and len(fewer) == len(points))
    if found is None and len(fewer) < len(points):
        found = Approach(network, fewer, ranks, noise=noise).found(twice=twice)
    freedoms = frozenset(network.freedoms - rank for rank in kinds)
    return None if found is None else replace(found, freedoms=freedoms)
