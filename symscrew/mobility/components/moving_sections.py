"""Points of a component on a linear section, followed while the section moves: many at once, each with its own steps.

    z on f = 0, A z = b  --A, b on a straight way through complex numbers--> z on f = 0, A1 z = b1

Of generic complex sections no point on the way is singular. A step is a Runge-Kutta step along the way and Newton's
corrections of it; where the first correction is not small the step is halved, so that a path does not come upon
another's. As many random combinations of the equations are followed as the component has codimension.
(A. Sommese, C. Wampler, The numerical solution of systems of polynomials, 2005.)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.mobility.components.many_points import ManyPoints

Array = np.ndarray[Any, Any]

FIRST_STEP, LEAST_STEP, LONGEST_STEP = 0.05, 1e-6, 0.25
"""Of the way, whose length is one; a path that needs shorter ones is near a singular point, and is given up."""
STEPS = 2000
"""Of a path: those of regular ones are ten to a hundred."""
PATIENCE = 3
"""Times as many steps as half of the paths took, after which those left are given up where not all are needed: a few
that pass near a singular point took half of all time, and come by another way on the next loop."""
NEAR = {False: 1e-4, True: 1e-6}
"""The first correction of a step at most, against the point; `True`: of a way that is followed again, to be sure."""
CORRECTIONS = 3
"""Of a step: Newton's method from a near guess has all digits by then, and from another is not waited for."""
CLOSE = 1e-10
"""A correction below this, against the point, ends a step: the next one would be rounding."""
GROWN = 3
"""Steps that went well, after which they are doubled."""
FAR = 1e7
"""Of variables near one: a path beyond it has left for infinity."""


@dataclass(frozen=True, eq=False)
class Section:
    """The linear equations A z = b; of one for each path, A is paths x equations x variables."""

    matrix: Array
    right: Array

    def of_each(self, count: int) -> Section:
        """The same for so many paths."""
        if self.matrix.ndim == 3:
            return self
        return Section(np.broadcast_to(self.matrix, (count, *self.matrix.shape)),
                       np.broadcast_to(self.right, (count, len(self.right))))  # fmt: skip

    def of(self, paths: Array) -> Section:
        """Those of some paths."""
        return Section(self.matrix[paths], self.right[paths])

    def another(self, random: np.random.Generator) -> Section:
        """A random one of the same kind: variables that are in none of its equations, or not in one, stay out of it.

        Equations that have no constant, by which ratios are fixed, have none.
        """
        numbers = complex_numbers(random, *self.matrix.shape) * (self.matrix != 0)
        return Section(numbers, complex_numbers(random, len(self.right)) * (self.right != 0))


@dataclass(frozen=True, eq=False)
class SquareSystem:
    """As many combinations of the polynomials as variables are left by sections of one dimension."""

    polynomials: ManyPoints
    mixing: Array

    @classmethod
    def of(cls, polynomials: ManyPoints, dimension: int, random: np.random.Generator) -> SquareSystem:
        """Random combinations; the polynomials themselves where they are as many."""
        count, wanted = len(polynomials.table), len(polynomials.sizes) - dimension
        if count == wanted:
            return cls(polynomials, np.eye(count))
        return cls(polynomials, complex_numbers(random, wanted, count) / np.sqrt(count))

    def at(self, z: Array) -> tuple[Array, Array]:
        """Values and derivatives."""
        values, slopes = self.polynomials.at(z)
        return values @ self.mixing.T, self.mixing @ slopes


def complex_numbers(random: np.random.Generator, *shape: int) -> Array:
    """Random complex numbers about one in size."""
    return np.asarray((random.normal(size=shape) + 1j * random.normal(size=shape)) / np.sqrt(2))


def short_numbers(random: np.random.Generator, count: int) -> Array:
    """Such numbers of 30 binary digits, whose sums are exact: parallel sections are as far apart as they are said."""
    return np.asarray(np.round(complex_numbers(random, count) * 2**30) / 2**30)


def moved_points(
    system: SquareSystem,
    z: Array,
    ends: tuple[Section, Section],
    spent: Callable[[], bool],
    *,
    sure: bool = False,
    patient: bool = True,
) -> tuple[Array, Array]:
    """(where points of the first section come to on the second, which have come there); all give up when time is.

    Without `patient` the slowest are given up.
    """
    first, last = (end.of_each(len(z)) for end in ends)
    z, t = z.astype(complex), np.zeros(len(z))
    step, well = np.full(len(z), FIRST_STEP), np.zeros(len(z), dtype=int)
    going = np.ones(len(z), dtype=bool)
    most = STEPS
    for k in range(STEPS):
        who = np.flatnonzero(going & (t < 1))
        if not len(who) or k > most or spent():
            break
        if not patient and most == STEPS and 2 * len(who) < len(z):
            most = PATIENCE * k
        h = np.minimum(step[who], 1 - t[who])
        way = (first.of(who), last.of(who))
        guess = _ahead(system, z[who], way, t[who], h=h)
        after, good = _corrected(system, guess, _between(way, t[who] + h), NEAR[sure])
        come, back = who[good], who[~good]
        z[come], t[come] = after[good], t[come] + h[good]
        well[come] += 1
        longer = come[well[come] >= GROWN]
        step[longer], well[longer] = np.minimum(2 * step[longer], LONGEST_STEP), 0
        step[back], well[back] = h[~good] / 2, 0
        t[come[t[come] > 1 - 1e-14]] = 1.0
        going[who] = (step[who] > LEAST_STEP) & (np.abs(z[who]).max(axis=1) < FAR)
    return z, going & (t == 1)


def _between(way: tuple[Section, Section], t: Array) -> Section:
    first, last = way
    s = t[:, None]
    matrix = first.matrix * (1 - s[..., None]) + last.matrix * s[..., None]
    return Section(matrix, first.right * (1 - s) + last.right * s)


def _ahead(system: SquareSystem, z: Array, way: tuple[Section, Section], t: Array, *, h: Array) -> Array:
    """A step of Runge and Kutta."""
    one = _velocity(system, z, way, t)
    two = _velocity(system, z + h[:, None] / 2 * one, way, t + h / 2)
    three = _velocity(system, z + h[:, None] / 2 * two, way, t + h / 2)
    four = _velocity(system, z + h[:, None] * three, way, t + h)
    return np.asarray(z + h[:, None] / 6 * (one + 2 * two + 2 * three + four))


def _velocity(system: SquareSystem, z: Array, way: tuple[Section, Section], t: Array) -> Array:
    section = _between(way, t)
    _, slopes = system.at(z)
    first, last = way
    change = (last.right - first.right) - np.einsum("pij,pj->pi", last.matrix - first.matrix, z)
    right = np.concatenate([np.zeros((len(z), slopes.shape[1])), change], axis=1)
    return solved(np.concatenate([slopes, section.matrix], axis=1), right)


def newton_step(system: SquareSystem, z: Array, section: Section) -> Array:
    """What Newton's method takes from each point."""
    values, slopes = system.at(z)
    across = np.einsum("pij,pj->pi", section.matrix, z) - section.right
    return solved(np.concatenate([slopes, section.matrix], axis=1), np.concatenate([values, across], axis=1))


def _corrected(system: SquareSystem, z: Array, section: Section, near: float) -> tuple[Array, Array]:
    """(corrected points, whether corrections were small from the first on, and ended in rounding)."""
    good = np.asarray(np.isfinite(z).all(axis=1))
    size = 1 + np.abs(z).max(axis=1)
    z = np.where(good[:, None], z, 0)
    for k in range(CORRECTIONS):
        correction = newton_step(system, z, section)
        length = np.abs(correction).max(axis=1) / size
        good &= length < (near if k == 0 else 1.0)
        z = np.where(good[:, None], z - correction, z)
        if (length[good] < CLOSE).all():
            break
    return z, good & (length < CLOSE)


def solved(matrix: Array, right: Array) -> Array:
    """Solutions of many systems; not numbers where one is singular."""
    try:
        return np.asarray(np.linalg.solve(matrix, right[..., None])[..., 0])
    except np.linalg.LinAlgError:
        found = np.full(right.shape, np.nan, dtype=complex)
        for k, (one, values) in enumerate(zip(matrix, right, strict=True)):
            try:
                found[k] = np.linalg.solve(one, values)
            except np.linalg.LinAlgError:
                continue
        return found
