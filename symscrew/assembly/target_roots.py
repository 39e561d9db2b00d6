"""Zeros of a given mechanism from those of a general member of its family, with an account of every path.

    start system --paths--> regular ends: real, complex, at infinity;  singular ends --around s = 1--> where they lie
    paths that end in one regular point --again, with shorter steps--> apart
    a path that stays behind, at a singular place of the way or far out before its end --all of them again, on another
    way--> ends

At infinity: the ends at which a group is no displacement, |x|^2 = 0. Several paths in one finite point: a multiple
zero, or a point of a curve of zeros, along which Newton's method can be led.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import Certificate
from symscrew.assembly.exact_roots import ExactRoot
from symscrew.assembly.families import Family
from symscrew.assembly.path_tracking import CORRECTION, NEARLY, Coefficients, Ends, Tracker
from symscrew.assembly.start_system import StartSystem, together

Array = np.ndarray[Any, Any]

SINGULAR = 1e-9
"""Relative singular value of a singular end: rounding of doubles, squared root of it where two zeros meet."""
NO_DISPLACEMENT = 1e-7
"""|x|^2 of singular points of length one at infinity: they have 1e-9 by the mean around."""
ROUNDING = 1e-14
"""The same of regular ones, over the smallest singular value: what rounding leaves. Solutions a thousand sizes of the
mechanism away, as almost singular mechanisms have them, are 1e-6 and more."""
APART = 1 - 1e-13
"""Regular ends of length one whose product is above this are one: tracked to 1e-11, those far away are 1e-5 apart."""
REAL = 1e-9
"""Imaginary part of a real zero that is regular."""
RADII = (1e-5, 1e-7, 1e-9)
"""Of the circle around s = 1: no other singular s lies inside but for almost singular mechanisms, which the smaller
ones are for. About the smallest, points still are 3e-5 from where two zeros meet."""
AT_ZERO = 1e-11
"""Residual of the mean around s = 1: of a right one it is rounding, of one around two singular s more."""
TURNS = 12
"""Most rounds until a path comes back: as many as zeros that meet."""
ARCS = 16
"""Pieces of a round: the mean of as many points is right to the radius to this power over the rounds."""
BACK = 1e-7
"""Distance at which a path has come back to where its round began."""
BENDS = (0.0, 0.4, -0.4, 0.8)
"""How far ways go round through complex s: on another way singular places are others, so that paths get past them."""
BEHIND = 1e-2
"""Part of the way that is left of a path that stays behind: one that comes to a singular end has 3e-3 and less."""
PASSING = 2e-3
"""The same of a path that may pass infinity, and end elsewhere: those that end there come to 1.4e-3 and nearer."""
TIGHTER = (1e-2, 1e-4)
"""Of the correction's length, where two paths have ended in one point: one of them jumped."""
ALONG = (1e-2, 1e-3)
"""Steps along a null vector, of points of length one, on which a curve of zeros is told from a multiple zero."""
FLAT = 1e-13
"""Residual at which a point beside a singular zero is a zero too."""
CLOSE = 1e-5
"""Distance of singular ends that are one: half the digits, and less where three and more zeros meet."""


@dataclass(frozen=True)
class End:
    """Where paths end: coordinates, "real", "complex", "infinity" or "lost", how many paths (0: Newton's method from a
    random place came there), whether it is regular.

    `curve`: whether more zeros are beside it, without end. `proof`: of one told apart from another in 60 digits;
    `exact`: of one known in exact numbers.
    """

    z: Array
    kind: str
    paths: int = 1
    regular: bool = True
    curve: bool = False
    proof: Certificate | None = None
    exact: ExactRoot | None = None


@dataclass(frozen=True)
class Account:
    """All ends; how many paths there were, how often some were followed again."""

    ends: tuple[End, ...]
    paths: int
    again: int

    def count(self, kind: str) -> int:
        """Of the paths that end so."""
        return sum(end.paths for end in self.ends if end.kind == kind)

    @property
    def from_random_places(self) -> int:
        """Of the solutions to which no path leads: Newton's method came to them."""
        return sum(not end.paths and end.regular for end in self.ends)


def target_roots(family: Family, start: StartSystem, member: Sequence[Any]) -> Account:
    """The ends of all paths from the start system to a member of its family."""
    straight = family.way(start.member, member).at
    tried: list[tuple[int, Account]] = []
    for bend in BENDS:
        roots = _Roots(family.equations, start, _bent(straight, bend))
        ends = roots.followed()
        account = roots.account(ends)
        tried.append((int(_behind(ends).sum()) + roots.open, account))
        if not tried[-1][0]:
            break
    _, account = min(tried, key=lambda pair: pair[0])
    return replace(account, again=account.again + len(tried) - 1)


def reference_end(family: Family, start: StartSystem, member: Sequence[Any], known: Array) -> End:
    """The zero of the reference as an end to which no path leads."""
    roots = _Roots(family.equations, start, family.way(member, member).at)
    z = realised(family.equations, family.equations.scaled(known[None])[0])
    regular = bool(roots.smallest(z[None])[0] > SINGULAR)
    return End(z, "real", paths=0, regular=regular, curve=not regular and roots.curve(z))


def _behind(ends: Ends) -> Array:
    return np.asarray(~ends.reached & (ends.s < 1 - BEHIND))


def _bent(way: Coefficients, bend: float) -> Coefficients:
    return lambda s: way(s + 1j * bend * s * (1 - s)) if bend else way(s)


class _Roots:
    """`open`: paths far out that may pass infinity, so that their ends are not seen."""

    def __init__(self, equations: BatchEquations, start: StartSystem, way: Coefficients) -> None:
        self.equations, self.start, self.way = equations, start, way
        self.goal = way(np.ones(1))
        self.again = self.open = 0

    def followed(self) -> Ends:
        """All paths as far as they come."""
        ends = Tracker(self.equations).follow(self.start.zeros, self.way)
        late = np.flatnonzero(~ends.reached)
        if len(late):
            more = Tracker(self.equations, nearly=NEARLY[1]).follow(self.start.zeros[late], self.way)
            for one, two in ((ends.z, more.z), (ends.s, more.s), (ends.reached, more.reached)):
                one[late] = two
        return ends

    def account(self, ends: Ends) -> Account:
        """Regular ends first, then what the others come to."""
        count = len(self.start.zeros)
        z, behind = ends.z.copy(), _behind(ends)
        good = ends.reached & (self.smallest(z) > SINGULAR)
        for tighter in TIGHTER:
            doubled = self._doubled(z, good)
            if not len(doubled):
                break
            self.again += 1
            more = Tracker(self.equations, tighter * CORRECTION).follow(self.start.zeros[doubled], self.way)
            z[doubled], good[doubled] = more.z, more.reached & (self.smallest(more.z) > SINGULAR)
        least = self.smallest(z)
        found = [self._regular(z[k], float(least[k])) for k in np.flatnonzero(good)]
        found += [End(place, "lost", regular=False) for place in z[behind]]
        found += self._singular(np.flatnonzero(~good & ~behind), z, 1 - ends.s)
        return Account(tuple(found), count, self.again)

    def smallest(self, z: Array) -> Array:
        """Relative smallest singular values of the derivative across the groups."""
        if not len(z):
            return np.zeros(0)
        _, slopes = self.equations.evaluate(z, self.goal)
        whole = np.concatenate([slopes, self.equations.patches(z)], axis=1)
        values = np.linalg.svd(np.nan_to_num(whole), compute_uv=False)
        return np.asarray(values[:, self.equations.width - 1] / values[:, 0])

    def _doubled(self, z: Array, good: Array) -> Array:
        """Paths that end where another one does."""
        places = np.flatnonzero(good)
        return np.array([k for k in places if together(self.equations, z[places], z[k], APART).sum() > 1], dtype=int)

    def _regular(self, z: Array, smallest: float) -> End:
        if self.equations.norms(z[None]).min() < min(NO_DISPLACEMENT, ROUNDING / smallest):
            return End(z, "infinity")
        turned = realised(self.equations, z)
        return End(turned, "real" if np.abs(turned.imag).max() < REAL else "complex")

    def _singular(self, places: Array, z: Array, left: Array) -> list[End]:
        """What paths come to that do not end in regular points; `left`: of their ways."""
        result: list[End] = []
        if not len(places):
            return result
        centres, back = self._around(places)
        for k, place in enumerate(places):
            z_end = centres[k] if back[k] else z[place]
            if not back[k] and left[place] > 0:
                away = self.equations.norms(z[place][None]).min() < NO_DISPLACEMENT**0.5
                self.open += away and left[place] > PASSING
                result.append(End(z[place], "infinity" if away else "lost", regular=False))
            elif self.equations.norms(z_end[None]).min() < NO_DISPLACEMENT:
                result.append(End(z_end, "infinity", regular=False))
            else:
                turned = realised(self.equations, z_end)
                kind = "real" if np.abs(turned.imag).max() < CLOSE else "complex"
                _gather(result, End(turned, kind, regular=False, curve=self.curve(turned)))
        return result

    def _around(self, places: Array) -> tuple[Array, Array]:
        """(the means of paths around s = 1, whether they came back), on the largest circle with a zero as its mean."""
        centres, back, there = self._means(places, RADII[0])
        for radius in RADII[1:]:
            value = self.equations.values(centres, self.goal)
            late = np.flatnonzero(there & (~back | ~(np.abs(value).max(axis=1, initial=0.0) < AT_ZERO)))
            if not len(late):
                break
            again, good, there[late] = self._means(places[late], radius)
            value = self.equations.values(again, self.goal)
            good &= np.abs(value).max(axis=1, initial=0.0) < AT_ZERO
            centres[late[good]], back[late[good]] = again[good], True
        return centres, back

    def _means(self, places: Array, radius: float) -> tuple[Array, Array, Array]:
        """(the means of paths around s = 1 on a circle, whether they came back, whether they came to the circle)."""
        tracker = Tracker(self.equations, nearly=radius)
        ends = tracker.follow(self.start.zeros[places], self.way, until=1 - radius)
        z = self._fixed(ends.z, ends.z)
        begin, total = z.copy(), np.zeros_like(z)
        centres, back = z.copy(), np.zeros(len(places), dtype=bool)
        good = ends.reached.copy()
        for turn in range(1, TURNS + 1):
            for arc in range(ARCS):
                on = np.flatnonzero(good & ~back)
                if not len(on):
                    break
                total[on] += z[on]
                angle = 2 * np.pi * (np.arange(2) + arc) / ARCS
                piece = tracker.follow(z[on], self._arc(radius, angle[0], angle[1]))
                z[on] = self._fixed(piece.z, begin[on])
                good[on] = piece.reached
            closed = good & ~back & (np.abs(z - begin).max(axis=1) < BACK)
            centres[closed] = total[closed] / (ARCS * turn)
            back |= closed
        return self.equations.scaled(centres), back, ends.reached

    def _arc(self, radius: float, start: float, end: float) -> Coefficients:
        """Coefficients on an arc around s = 1."""
        return lambda t: self.way(1 - radius * np.exp(1j * (start + t * (end - start))))

    def _fixed(self, z: Array, like: Array) -> Array:
        """Points with the coordinate of each group that is largest in `like` made 1."""
        result = z.copy()
        rows = np.arange(len(z))
        for part in self.equations.parts:
            largest = part.start + np.abs(like[:, part]).argmax(axis=1)
            result[:, part] /= z[rows, largest][:, None]
        return result

    def curve(self, z: Array) -> bool:
        """Whether zeros go on along a null vector, as far as a step of twice the length goes twice as far."""
        _, slopes = self.equations.evaluate(z[None], self.goal)
        whole = np.concatenate([slopes, self.equations.patches(z[None])], axis=1)[0]
        _, values, rows = np.linalg.svd(whole)
        rank = int((values > CLOSE * values[0]).sum())
        kernel = rows[rank:].conj()
        if not len(kernel):
            return False
        random = np.random.default_rng(0).normal(size=len(kernel))
        for step in ALONG:
            there = z + step * (random @ kernel) / np.linalg.norm(random)
            for _ in range(8):  # Newton's method from beside a curve takes three
                value, slope = self.equations.evaluate(there[None], self.goal)
                matrix = np.concatenate([slope, self.equations.patches(there[None])], axis=1)[0]
                right = np.concatenate([value[0], np.zeros(len(self.equations.parts))])
                if not np.isfinite(matrix).all():
                    return False
                there = there - np.linalg.pinv(matrix, rcond=CLOSE) @ right
            value = self.equations.values(there[None], self.goal)
            if np.abs(value).max() > FLAT or not 0.5 * step < np.linalg.norm(there - z) < 2 * step:
                return False
        return True


def _gather(ends: list[End], new: End) -> None:
    """Puts an end to the one that it is at, or beside them."""
    for k, end in enumerate(ends):
        if end.kind == new.kind and np.abs(end.z - new.z).max() < CLOSE:
            ends[k] = End(end.z, end.kind, end.paths + 1, end.regular, end.curve or new.curve)
            return
    ends.append(new)


def realised(equations: BatchEquations, z: Array) -> Array:
    """The same point with real coordinates, if it has such: the largest of each group is positive."""
    result = z.copy()
    for part in equations.parts:
        largest = z[part][np.abs(z[part]).argmax()]
        result[part] = z[part] * np.conj(largest) / np.abs(largest)
        first = next((c for c in result[part] if abs(c) > CLOSE), 1.0)
        result[part] *= np.sign(first.real) or 1.0
    return result
