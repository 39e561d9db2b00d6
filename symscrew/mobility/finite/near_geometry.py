"""Special geometry close to the one typed: the smallest change of joints with which what almost vanishes does vanish.

    ranks that are almost lower, configurations in which loops almost close --conditions--> unknown places and axes
    conditions --Gauss-Newton with the least change, residuals in 60 digits--> special geometry
    conditions at which it stalls --aligned_axes--> axes that nearly are parallel or meet made so, then as before
    conditions at which it still stalls --double_zeros--> special geometry where they vanish twice

The unknowns are the places and axes of all joints. The conditions are ranks that are lower in the reference
configuration (with their null vectors as further unknowns) and the closure of all loops in configurations along the
motions that nearly close (with these configurations as further unknowns). Whether the geometry found really moves is
left to the ordinary analysis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from symscrew.mobility.finite.alike_links import Alike, alike
from symscrew.mobility.finite.aligned_axes import aligned, turned_together
from symscrew.mobility.finite.almost_ranks import NEAR, LowRank, RankClaim, low_ranks, nearer
from symscrew.mobility.finite.branches import zeros_nearby
from symscrew.mobility.finite.double_zeros import double_directions, vertex
from symscrew.mobility.finite.geometry_search import Search
from symscrew.mobility.finite.joint_changes import loses_a_pitch, sizes
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
ROUNDED_ZERO = 1e-11
"""They may be off by this as well: rounding of doubles in zeros that are double ones."""
CUT_OFF = 30.0
"""Singular values of the conditions below so many times the small one of the closure are rounding as typed."""
LEAST_ROUGH = 1e-13
"""Rounding of doubles in the conditions, after the decompositions that make them."""
LARGEST_CUT = 0.1
"""Of rough numbers the clearest conditions count all the same."""
ROUNDS = 14
"""Steps of Gauss-Newton: linear with the ratio of the distance, so a handful for doubles and a dozen for six digits."""
LINEARISED = 3
"""Rounds that linearise anew whatever they gain; what is left then is mostly far below the distance."""
CONVERGED = 1e-40
"""Residual at which it has ended: far below what ranks take for zero, far above rounding of 60 digits."""
AT_VERTEX = 1e-22
"""Step to a double zero after which it is one: the conditions are of the order of its square."""
LINEAR = 1e-10
"""Step to a double zero that is short enough for derivatives to stay what they are."""
CLOSER = 1e-7
"""How much closer a step to a double zero comes: curvatures are known to eight digits."""
ENOUGH = 1e-28
"""Residual with which it may end where steps gain no more: what they cut off as rounding. Ranks take 1e-27 for zero."""
LITTLE = 1e-3
"""A round that leaves more than this takes slopes anew: small ones change by as much on the way as they are. Fresh ones
leave what doubles do not tell of the smallest slope, and that a thousandth or less."""
SLOW = 0.2
"""A round that leaves more than this was no step of Newton's method to a simple zero: to a double one it leaves 1/4."""
QUARTERS = (0.2, 0.3)
"""A round that leaves so much was half of the way to a double zero that has slopes beside it: the step once more is the
other half. Parallelograms side by side in six digits took fourteen such rounds and had not ended."""
LEAST_NOISE = 1e-15
"""Rounding of doubles: what is smaller is not measured by them."""
ROUGH = 30.0
"""Angles and distances below so many times the small singular value are rounding; where that aligns nothing that moves,
those below `NEAR`."""
FIRST = 8
"""Configurations of each kind that are tried where twice as many are too many: conditions of which some hardly change
with the geometry. With these alone a branch of dimension two has been missed."""
FARTHEST = 1e-3
"""Of the mechanism's size: farther geometry is another mechanism."""
ASTRAY = 1e-2
"""Of the mechanism's size: a search that has gone so far ends. Those that end within `FARTHEST` were never farther than
3e-6 on their way with six digits, those towards what does not exist go 3e-2 and more in their first step."""

FEW_DIGITS = 1e-9
"""Of the mechanism's size: farther geometry that has ranks alone may rest by rounding only. A cusp in six digits
is 1e-7 from such, and moves as meant; of five bars in line ten digits tell that they rest."""


@dataclass(frozen=True)
class NearGeometry:
    """The special geometry: its network, the largest change of a joint [1, the mechanism's size], and of which.

    `moves`: found from finite motions that close; else only ranks in the reference configuration are lost.
    `stalled`: loops do nearly close in other configurations, but the search for geometry with which they close did not
        converge.
    `freedoms`: how many there are where zeros of the closure as typed were found, on which it was to close.
    """

    network: Network
    distance: float
    changes: tuple[tuple[str, float], ...]
    moves: bool
    stalled: bool = False
    freedoms: frozenset[int] = frozenset()

    def in_metres(self, length: float) -> tuple[float, tuple[tuple[str, float], ...]]:
        """(the largest change, of every joint); `length`: the mechanism's size [m]."""
        return self.distance * length, tuple((name, size * length) for name, size in self.changes)

    @property
    def tells(self) -> bool:
        """Whether less mobility than as typed is believed of it: it is near, and nothing beside it was seen to move."""
        return not self.stalled and self.distance < FEW_DIGITS


MOST_LINEARISED = 720
"""Linearisations that a double zero is looked for with, times joints: a second of time for a hexapod's conditions each
dozen, of which a loop of six hinges takes a sixth. Eight cranks with their pins in line take thirty, Bricard's
threefold linkage ninety: there the surfaces of three kinds of linkages that move meet."""
GIVEN_UP = (
    "special geometry next to what was typed: the search for a double zero of its conditions was ended after "
    "{count} linearisations, so there may be such geometry that is not named"
)


class GivenUpError(ArithmeticError):
    """The search for special geometry has taken too long."""


class OtherJointsError(ArithmeticError):
    """What the search has come to has hinges or other screws where screws were typed."""


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
    astray = False
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
            approach, kept = _Approach(network, points, ranks, noise=noise), turned_together(network)
            tries = [approach]
            if kept.shape[1] < len(approach.search.z):
                tries.insert(0, _Approach(network, points, ranks, noise=noise, ways=kept))
            found = (
                _first(tries)
                or _by_alignment(network, low, noise)
                or _by_likeness(network, low, noise)
                or _first(tries, twice=True)
            )
            if found is not None or not almost:  # else ranks alone are those of what was typed
                return () if found is None else (found,)
            astray = approach.astray  # then these motions are none that were meant
            if not astray:
                alone = _Approach(network, [], ranks, noise=noise).found(twice=True)
                return () if alone is None else (replace(alone, stalled=True),)
        close = min(off, max(ALMOST_ZERO * noise, ROUNDED_ZERO))
        kinds = zeros_nearby(coarse, here, quadratic_forms(coarse, here), off=close, kind=partial(_rank, coarse, near))
        points = _open(network, coarse, [(zero, rank) for rank, zeros in kinds.items() for zero in zeros])
    moving = _through(network, points, ranks, noise)
    alone = _Approach(network, [], ranks, noise=noise).found(twice=True) if almost else None
    if alone is not None and (points or astray) and moving is None:
        alone = replace(alone, stalled=True)
    return tuple(one for one in (alone, moving) if one is not None)


def _first(tries: Sequence[_Approach], *, twice: bool = False) -> NearGeometry | None:
    """The first that is found: with axes that are parallel as typed turned together, as those of a planar linkage are
    meant, then with all alone. The former has no double zeros of hinges that are tilted against each other."""
    return next((found for one in tries if (found := one.found(twice=twice)) is not None), None)


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
        found = _Approach(other, points, ranks, noise=noise, ways=turned_together(other)).found() if points else None
        if found is not None:
            return _between(network, found.network, moves=True)
    return None


def _by_likeness(network: Network, low: Sequence[LowRank], noise: float) -> NearGeometry | None:
    """Lengths, angles and offsets of links made equal that nearly are, where loops then close along all motions."""
    closure = next(one for one in low if one.claim.name == "closure")
    ranks = [(one.claim, one.rank) for one in low]
    meant = alike(network, min(NEAR, ROUGH * noise))
    if meant is None:
        return None
    ways = turned_together(network)
    first = _Approach(network, [], ranks, noise=noise, ways=ways, alike=meant).found()
    if first is None:
        return None
    coarse = ClosureVariety(first.network)
    points = _motions(coarse, local_at(coarse, np.zeros(coarse.columns), rank=closure.rank), CLOSES * noise)
    if not points:
        return None
    ways = turned_together(first.network)
    found = _Approach(first.network, points, ranks, noise=LEAST_NOISE, ways=ways, alike=meant).found()
    return None if found is None else _between(network, found.network, moves=True)


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
    approach = _Approach(network, first, ranks, noise=LEAST_NOISE)
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
    return [(q, rank) for q, rank in points if refine(coarse, fine, q, rank)[1] > CLOSED]


def _rank(coarse: ClosureVariety, near: float, q: Array) -> int:
    values = np.linalg.svd(coarse.slopes(q[None])[0], compute_uv=False)
    return int((values > near * values[0]).sum())


def _through(
    network: Network, points: Sequence[tuple[Array, int]], ranks: Sequence[tuple[RankClaim, int]], noise: float
) -> NearGeometry | None:
    """Geometry with these ranks whose loops close in the configurations: in all, or in the first ones of every kind."""
    if not points:
        return None
    kinds = [rank for _, rank in points]
    fewer = [point for k, point in enumerate(points) if kinds[:k].count(point[1]) < FIRST]
    every = _Approach(network, points, ranks, noise=noise)
    found = every.found(twice=len(fewer) == len(points))
    if found is None and len(fewer) < len(points):
        found = _Approach(network, fewer, ranks, noise=noise).found(twice=True)
    freedoms = frozenset(network.freedoms - rank for rank in kinds)
    return None if found is None else replace(found, freedoms=freedoms)


class _Approach:
    """Gauss-Newton from what was typed towards the conditions; where it has stalled it can go on to a double zero.

    `astray`: it has left the numbers typed, so the conditions are not theirs: motions taken for real ones are not.
    """

    def __init__(
        self,
        network: Network,
        points: Sequence[tuple[Array, int]],
        ranks: Sequence[tuple[RankClaim, int]],
        *,
        noise: float,
        ways: Array | None = None,
        alike: Alike | None = None,
    ) -> None:
        self.search = Search(network, points, ranks, alike)
        self.search.ways = ways
        self.moves, self.noise, self.astray = bool(points), noise, False
        self._attempt, self._best, self._rough, self._fresh = 0, float("inf"), noise, True
        self._left: list[Array] = self.search.residuals()
        self._rest: Array | None = None

    def found(self, *, twice: bool = False, rounds: int = ROUNDS) -> NearGeometry | None:
        """The geometry; None where it stalls, or has not ended after so many rounds. `twice`: double zeros as well."""
        search = self.search
        while self._attempt < rounds and not self.astray:
            size = max(float(np.linalg.norm(r)) for r in self._left)
            if size < CONVERGED:
                return self._ended(search)
            slow = self._attempt >= LINEARISED and size > SLOW * self._best
            if slow and size < ENOUGH:
                return self._ended(search)
            if slow and self._rest is not None and QUARTERS[0] < size / self._best < QUARTERS[1]:
                search.move(self._rest)
                self._rest, self._best, self._left = None, float("inf"), search.settled().residuals()
                continue
            slow = slow and size > self._best / 2  # else rounds come to leave a quarter yet
            if slow and self._fresh:
                if not twice:
                    return None
                cut = min(LARGEST_CUT, CUT_OFF * max(LEAST_ROUGH, self.noise))
                double = _solved_twice(search.moved(np.zeros(0)), cut)
                if double is not None or size > self._best / 2:
                    return None if double is None else self._ended(double)
            self._fresh = self._attempt < LINEARISED or size > LITTLE * self._best
            if self._fresh:
                search.linearise()
                self._rough = max(LEAST_ROUGH, self._rough if self._attempt == 0 else size)
            self._best = size
            self._rest = search.step(self._left, min(LARGEST_CUT, CUT_OFF * self._rough))
            self._attempt += 1
            self.astray = bool(max(abs(c) for c in search.z) > ASTRAY)
            self._left = [] if self.astray else search.residuals()
        return None

    def _ended(self, search: Search) -> NearGeometry | None:
        return _between(search.network, search.after, moves=self.moves)


def _between(network: Network, after: Network, *, moves: bool) -> NearGeometry | None:
    changes = sizes(network, after)
    distance = max(size for _, size in changes)
    if loses_a_pitch(network, after):
        raise OtherJointsError
    return NearGeometry(after, distance, changes, moves) if distance < FARTHEST else None


def _solved_twice(search: Search, cut: float) -> Search | None:
    """The search ended in a double zero of conditions that linear steps hardly make smaller; None where it is none."""
    believed, best, length = float(max(abs(c) for c in search.z)), float("inf"), float("inf")
    left = most = MOST_LINEARISED // len(search.network.edges)
    for _ in range(ROUNDS):
        if believed > FARTHEST:
            return None
        if length > LINEAR:
            search.linearise()
            doubled, left = double_directions(search.without_slope(cut), left)
            if left < 0:
                raise GivenUpError(GIVEN_UP.format(count=most))
        if doubled is None:
            return None
        step = search.along_ways(vertex(search.without_slope(cut), doubled, believed))
        search.move(step)
        search.step(search.residuals(), cut)
        size = max(float(np.linalg.norm(r)) for r in search.residuals())
        length = float(np.linalg.norm(step))
        if size < CONVERGED and length < AT_VERTEX:
            return search
        if size > best / 2 and size > CONVERGED:
            return None
        best, believed = size, max(length * length, CLOSER * length)
    return None
