"""A component's points on a generic section, from some of them: monodromy until the linear trace test closes.

    points on a section --the section moves round loops--> further points, and which ones are of one component
    these on three parallel sections --sum is linear--> all points of the component: as many as its degree

Loops of the section exchange the points of one irreducible component, and never lead to another; the sum of all its
points is linear in the section's place, that of some is not. Both are numerical evidence.
(A. Sommese, J. Verschelde, C. Wampler, SIAM J. Numer. Anal. 38 (2001) 2022-2046; 40 (2002) 2026-2046.)
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.mobility.components.moving_sections import (
    Section,
    SquareSystem,
    moved_points,
    short_numbers,
)

Array = np.ndarray[Any, Any]

SAME = 1e-6
"""Points that differ by less, against their size, are one: they are known to 1e-12."""
LINEAR = 1e-7
"""Second difference of a sum of points, against the sum of their ways, that counts as none: complete sets have 1e-11,
others 1e-2."""
QUIET = 2
"""Loops that bring nothing new, after which it is asked whether a set is complete; then after every one."""
LOOPS = 60
"""At most: a set of some hundred points is complete after ten to twenty."""
AGAIN = 8
"""Loops, at most, that have to join all points once more with shorter steps."""
MOST_POINTS = 1500
"""Of all sets together, beyond which it is given up: a loop takes half a minute."""


@dataclass(frozen=True, eq=False)
class WitnessSet:
    """Points of one component on a section, in units of the variables.

    `trace`: second difference of their sum over three parallel sections, relative; `closed`: whether it is none, so
    that the component has no other point; `sure`: loops, followed with shorter steps, that lead every point to another
    one and join all of them, 0 where that was not seen; `seeds`: which given points are of the component; `beside`: the
    same points on the sections `aside` of this one, before and behind; `sets`: of how many that are not closed it is
    made, which may be of one component.
    """

    points: Array
    trace: float
    closed: bool
    sure: int
    seeds: tuple[int, ...]
    beside: tuple[Array, Array] | None
    aside: Array
    sets: int = 1

    def parallel(self, section: Section, side: int) -> Section:
        """The section before (1) or behind (-1) the set's own."""
        return Section(section.matrix, section.right + side * self.aside)


def completed_sets(
    system: SquareSystem,
    section: Section,
    seeds: Array,
    times: tuple[Callable[[], bool], Callable[[], bool]],
    *,
    random: np.random.Generator,
) -> list[WitnessSet]:
    """The sets that seeds, points on the section, belong to; `times`: whether that of each half of the work is over."""
    spent = times[0]
    found = _Growing(system, section, random, spent)
    found.take(seeds)
    quiet = 0
    for _ in range(LOOPS):
        if spent() or not found.open().any() or len(found.points) > MOST_POINTS:
            break
        quiet = 0 if found.loop(patient=quiet >= QUIET) else quiet + 1
        if quiet >= QUIET or len(found.open()) == 1:
            found.test()
    found.spent = times[1]
    return [found.result(label, seeds) for label in dict.fromkeys(found.labels.tolist())]


def joined_sets(
    system: SquareSystem, section: Section, seeds: Array, total: int, *, random: np.random.Generator,
    spent: Callable[[], bool],
) -> tuple[list[tuple[Array, tuple[int, ...]]], int]:  # fmt: skip
    """(sets of points with the seeds they are from, loops since something was new), where `total` points are known.

    Of a section whose trace is not linear, so that another count says when no point is missing. No further loops where
    all are one set.
    """
    found = _Growing(system, section, random, spent)
    found.take(seeds)
    quiet = 0
    for _ in range(LOOPS):
        if spent() or (len(found.points) >= total and (quiet >= AGAIN or len(set(found.labels.tolist())) == 1)):
            break
        quiet = 0 if found.loop() else quiet + 1
    sets = []
    for label in dict.fromkeys(found.labels.tolist()):
        points = found.points[found.labels == label]
        sets.append((points, tuple(k for k, z in enumerate(seeds) if place_among(points, z) is not None)))
    return sets, quiet


def together(sets: Sequence[WitnessSet]) -> list[WitnessSet]:
    """The sets, those that are not closed as one: loops that have not joined them do not tell them apart."""
    closed, left = ([s for s in sets if s.closed == kind] for kind in (True, False))
    if len(left) > 1:
        points = np.concatenate([s.points for s in left])
        seeds = tuple(k for s in left for k in s.seeds)
        left = [replace(left[0], points=points, seeds=seeds, sets=len(left))]
    return [*closed, *left]


class _Growing:
    """Points of the section, with labels that are equal for those known to be of one component."""

    def __init__(
        self, system: SquareSystem, section: Section, random: np.random.Generator, spent: Callable[[], bool]
    ) -> None:
        self.system, self.section, self.random, self.spent = system, section, random, spent
        self.points = np.zeros((0, section.matrix.shape[1]), dtype=complex)
        self.labels = np.zeros(0, dtype=int)
        self.closed: dict[int, tuple[float, tuple[Array, Array] | None]] = {}
        self.aside = short_numbers(random, len(section.right))

    def take(self, points: Array) -> None:
        """Points of unknown components."""
        for point in points:
            if self.place(point) is None:
                self._add(point, self.labels.max(initial=-1) + 1)

    def _add(self, point: Array, label: int) -> None:
        self.points = np.concatenate([self.points, point[None]])
        self.labels = np.append(self.labels, label)

    def place(self, point: Array) -> int | None:
        """Which known point it is."""
        return place_among(self.points, point)

    def open(self) -> Array:
        """Points of sets that are not known to be complete."""
        return np.array([label not in self.closed for label in self.labels], dtype=bool)

    def loop(self, *, patient: bool = False) -> bool:
        """All points of open sets once round a loop, `patient` with slow paths; whether that brought something."""
        who = np.flatnonzero(self.open())
        moved, come = round_loop(
            self.system, self.section, self.points[who], self.spent, random=self.random, patient=patient
        )
        news = False
        for k, point, there in zip(who, moved, come, strict=True):
            if not there:
                continue
            other = self.place(point)
            if other is None:
                self._add(point, self.labels[k])
                news = True
            elif self.labels[other] != self.labels[k] and self.labels[other] not in self.closed:
                self.labels[self.labels == self.labels[other]] = self.labels[k]
                news = True
        return news

    def test(self) -> None:
        """The sums of points of each open set, on this section and two beside it."""
        who = np.flatnonzero(self.open())
        sides = [
            moved_points(self.system, self.points[who], (self.section, self._beside(side)), self.spent)
            for side in (1, -1)
        ]
        for label in set(self.labels[who].tolist()):
            own = self.labels[who] == label
            if all(come[own].all() for _, come in sides):
                beside = (sides[0][0][own], sides[1][0][own])
                trace = bend(self.points[who][own], beside)
                if trace < LINEAR:
                    self.closed[label] = (trace, beside)

    def _beside(self, side: int) -> Section:
        return Section(self.section.matrix, self.section.right + side * self.aside)

    def result(self, label: int, seeds: Array) -> WitnessSet:
        """The set, joined once more where it is complete."""
        points = self.points[self.labels == label]
        trace, beside = self.closed.get(label, (np.inf, None))
        own = tuple(k for k, seed in enumerate(seeds) if place_among(points, seed) is not None)
        sure = self._joined_again(points) if beside is not None else 0
        return WitnessSet(points, trace, beside is not None, sure, own, beside, self.aside)

    def _joined_again(self, points: Array) -> int:
        """After how many loops all points are joined; 0 where one leads two to the same, or astray, or time is over."""
        labels = np.arange(len(points))
        for count in range(1, AGAIN + 1):
            if self.spent():
                break
            moved, come = round_loop(self.system, self.section, points, self.spent, random=self.random, sure=True)
            to = {k: place_among(points, moved[k]) for k in np.flatnonzero(come).tolist()}
            known = {k: other for k, other in to.items() if other is not None}
            if len(known) < len(to) or len(set(known.values())) < len(known):
                return 0
            for k, other in known.items():
                labels[labels == labels[other]] = labels[k]
            if len(set(labels.tolist())) == 1:
                return count
        return 0


def round_loop(
    system: SquareSystem,
    section: Section,
    points: Array,
    spent: Callable[[], bool],
    *,
    random: np.random.Generator,
    sure: bool = False,
    patient: bool = False,
) -> tuple[Array, Array]:
    """Where points come to when the section goes by two random ones back to itself, and which have come there.

    `sure`: with shorter steps; `patient`, as then: the slowest are waited for.
    """
    corners = [section.another(random) for _ in range(2)]
    come = np.ones(len(points), dtype=bool)
    for ends in zip([section, *corners], [*corners, section], strict=True):
        points = points.copy()
        points[come], arrived = moved_points(system, points[come], ends, spent, sure=sure, patient=sure or patient)
        come[np.flatnonzero(come)[~arrived]] = False
    return points, come


def place_among(points: Array, point: Array) -> int | None:
    """Which of the points it is."""
    if not len(points):
        return None
    away = np.abs(points - point).max(axis=1)
    nearest = int(away.argmin())
    return nearest if away[nearest] < SAME * (1 + np.abs(point).max()) else None


def bend(points: Array, beside: tuple[Array, Array]) -> float:
    """Second difference of the sum of points, against the sum of the ways of each."""
    ways = sum(np.abs(side - points).sum(axis=0) for side in beside)
    second = np.abs((beside[0] + beside[1] - 2 * points).sum(axis=0))
    return float(second.max() / max(float(np.max(ways)), 1e-300))
