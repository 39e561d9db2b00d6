"""The approach to special geometry: steps of Gauss-Newton with the least change, and on to a double zero.

    conditions on the geometry --Approach--> the nearest geometry that satisfies them

Where it has stalled, `double_zeros` finds the directions in which conditions vanish twice.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.mobility.finite.alike_links import Alike
from symscrew.mobility.finite.almost_ranks import RankClaim
from symscrew.mobility.finite.double_zeros import double_directions, vertex
from symscrew.mobility.finite.geometry_search import Search
from symscrew.mobility.finite.joint_changes import loses_a_pitch, sizes
from symscrew.mobility.finite.variety import Array
from symscrew.mobility.joint_network import Network

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
SECOND_ORDER = 1e-18
"""Residual below which all that has a slope of first order is met: six digits leave 1e-6, their third power is 1e-18.
Conditions that hold to second order in the rounding have slopes of 1e-13, which doubles tell from none."""
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


class Approach:
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
        self._finer: float | None = None

    def found(self, *, twice: bool = False, rounds: int = ROUNDS) -> NearGeometry | None:
        """The geometry; None where it stalls, or has not ended after so many rounds. `twice`: double zeros as well."""
        search = self.search
        while self._attempt < rounds and not self.astray:
            size = max(float(np.linalg.norm(r)) for r in self._left)
            if size < CONVERGED:
                return self._ended(search)
            slow = self._attempt >= LINEARISED and size > SLOW * self._best
            if (slow or self._finer is not None) and size < ENOUGH:  # along small slopes rounds gain a hundredth each
                return self._ended(search)
            if slow and self._rest is not None and QUARTERS[0] < size / self._best < QUARTERS[1]:
                search.move(self._rest)
                self._rest, self._best, self._left = None, float("inf"), search.settled().residuals()
                continue
            slow = slow and size > self._best / 2  # else rounds come to leave a quarter yet
            if slow and self._fresh:
                if self._along_small_slopes(size):
                    continue
                if not twice:
                    return None
                cut = min(LARGEST_CUT, CUT_OFF * max(LEAST_ROUGH, self.noise))
                double = _solved_twice(search.moved(np.zeros(0)), cut)
                if double is not None or size > self._best / 2:
                    return None if double is None else self._ended(double)
            self._fresh = self._attempt < LINEARISED or size > LITTLE * self._best or self._finer is not None
            if self._fresh:
                search.linearise()
                self._rough = max(LEAST_ROUGH, self._rough if self._attempt == 0 else size)
            self._best = size
            cut = min(LARGEST_CUT, CUT_OFF * self._rough) if self._finer is None else self._finer
            self._rest = search.step(self._left, cut)
            self._attempt += 1
            self.astray = bool(max(abs(c) for c in search.z) > ASTRAY)
            self._left = [] if self.astray else search.residuals()
        return None

    def _along_small_slopes(self, size: float) -> bool:
        """Whether it goes on along slopes that were cut off, but stand clear of rounding, where nothing else is left.

        Where several axes are rounded a condition on one has a slope as small as the product of what others are off.
        """
        if self._finer is not None or size > SECOND_ORDER:
            return False
        self._finer = self.search.clear_below(CUT_OFF * LEAST_ROUGH)
        if self._finer is not None:
            self.search.step(self._left, self._finer)
            self._best, self._left = float("inf"), self.search.settled().residuals()
            self._attempt += 1
        return self._finer is not None

    def _ended(self, search: Search) -> NearGeometry | None:
        return between(search.network, search.after, moves=self.moves)


def between(network: Network, after: Network, *, moves: bool) -> NearGeometry | None:
    """What was changed from one to the other; None where that is another mechanism.

    Raises:
        OtherJointsError: a screw has become a hinge, or another screw.
    """
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
