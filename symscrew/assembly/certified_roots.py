"""A zero proved: Krawczyk's test in intervals of integers, of real and of complex zeros.

    zero in doubles, numbers of 60 digits --F at the zero, dF over a box around it--> K(box)
    K(box) inside the box: one zero of the equations lies in the box, and Newton's method converges to it

K(B) = m - Y F(m) + (1 - Y dF(B)) (B - m) with Y near the inverse of dF(m). (R. Krawczyk, 1969; R. Moore, 1977.)
Numbers are integers times 2^-200 with rounding outwards, so that nothing rests on doubles.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.dual_forms import CONJUGATE, PRODUCT, SIZE
from symscrew.assembly.rectangles import (
    ONE,
    Rectangle,
    chain,
    dot,
    exactly,
    fine,
    finely,
    middle_of_box,
    product,
    whole,
)
from symscrew.assembly.slot_numbers import matrices, spins_of

Array = np.ndarray[Any, Any]

RADII = (1e-7, 1e-10, 1e-13)
"""Of boxes around points whose largest coordinates are 1: the largest that is accepted says most of how far apart zeros
are; the smallest is a hundred times rounding."""
REAL_MIDDLE = 1e-9
"""Imaginary part of a point between two zeros that are real, or conjugate."""
REFINEMENTS = 3
"""Steps of eight digits or more each: boxes contract that much."""
TWICE = 2.0
"""A step of half the box leaves the other half for how the derivative varies in it."""
WIDE = 1.5
"""Least box of a step over the way of the zero in it, so that its ends lie inside."""


@dataclass(frozen=True)
class Certificate:
    """The radius of the box around a zero whose groups' largest coordinates are 1, in which there is one zero.

    `z`: the zero, refined in integers and then rounded. `kind`: "real", of a box of real points; "complex", where the
    box has no real point; else "". `beside`: another zero so near that doubles may be one, with a box apart from this.
    """

    radius: float
    z: Array
    kind: str
    beside: Array | None = None


def certified(equations: BatchEquations, slots: Sequence[Any], z: Array) -> Certificate | None:
    """The certificate of a zero of the mechanism with these rectangles as numbers; None where the test fails."""
    test = _Krawczyk(equations, slots, z)
    for radius in RADII:
        if test.holds(radius):
            return Certificate(radius, test.refined(), test.kind(radius))
    return None


def held_by_box(
    equations: BatchEquations,
    slots: Sequence[Any],
    z: Array,
    *,
    ends: Sequence[Array],
    past: float,
    rows: Sequence[int] | None = None,
) -> bool:
    """Whether for all numbers within these rectangles one zero lies in a box around z, and a regular one.

    The box reaches past the ends by half its radius and by `past`, and twice as far as a step of Newton's method with
    any of the numbers. `rows`: a zero of these alone, as many as coordinates; of all rows where it is None.
    """
    test = _Krawczyk(equations, slots, z, rows)
    longest = max((max(-s.real[0], s.real[1]) for s in test.step), default=0) / ONE
    return test.holds(max(WIDE * max(map(test.off, ends)) + past, TWICE * longest))


def held_within(
    equations: BatchEquations, slots: Sequence[Any], z: Array, radius: float, *, rows: Sequence[int] | None = None
) -> bool:
    """Whether one zero lies within this radius of z, scaled so that its groups' largest coordinates are 1.

    `rows`: as of `held_by_box`.
    """
    test = _Krawczyk(equations, slots, z, rows)
    return test.off(z) <= radius / 2 and test.holds(radius / 2)


class Chart:
    """The equations with the largest coordinate of each group made 1, as many as what is left."""

    def __init__(self, equations: BatchEquations, slots: Sequence[Any], z: Array) -> None:
        self.equations = equations
        self.motions, self.loops = matrices(equations.structure, slots)
        self.moving = [*self.motions, *spins_of(equations.structure)]
        self.fixed = [part.start + int(np.abs(z[part]).argmax()) for part in equations.parts]
        middle = np.array(z, dtype=complex)
        for part, place in zip(equations.parts, self.fixed, strict=True):
            middle[part] = middle[part] / middle[place]
            middle[place] = 1.0
        self.middle = middle
        self.open = [k for k in range(equations.width) if k not in self.fixed]
        self.rows = list[int]()
        self.y: list[list[Rectangle]] = []
        self.step: list[Rectangle] = []
        self.real = self.square = False
        self.at_middle: list[Rectangle] = []

    def numbers(self) -> list[Array]:
        """All matrices."""
        return [*self.motions, *(m for loop in self.loops for m in loop)]

    def _rows(self, z: Array) -> list[int]:
        """All rows but those that the others imply: of four of an axis that two bodies share, x w = u x, two, and of
        four of points that meet that of the largest part of x.

        The four of an axis are an antisymmetric matrix of rank two, as w and u are as long as one another: two rows
        whose common entry is not zero span all.
        """
        keep, row = list[int](), 0
        for k, loop in enumerate(self.equations.structure.loops):
            square, linear = self.loops[k]
            keep += range(row, row + len(square))
            row += len(square)
            if self.equations.structure.planar or loop.spins:
                keep += range(row, row + len(linear))
            else:
                drop = int(np.abs(self._between(k, z)[:4]).argmax())
                kinds = [form.kind for form in loop.forms if form.kind in ("meeting", "parallel")]
                for place, kind in enumerate(kinds):
                    block = linear[4 * place : 4 * place + 4]
                    stays = _two_rows(block) if kind == "parallel" else [i for i in range(4) if i != drop]
                    keep += [row + 4 * place + i for i in stays]
            row += len(linear)
        return [*keep, *range(row, row + len(self.equations.free))]

    def _between(self, k: int, z: Array) -> Array:
        """The displacement around a loop, in doubles."""
        g: Array = np.eye(SIZE)[0].astype(complex)
        for factor in self.equations.ways[k]:
            part = self.equations.parts[factor.group]
            motion = np.vectorize(middle_of_box)(self.moving[factor.motion]).astype(complex)
            f = motion @ z[part] * (CONJUGATE if factor.back else 1)
            g = np.asarray(np.einsum("kij,i,j->k", PRODUCT, g, f))
        return g

    def holds(self, radius: float) -> bool:
        """Whether the box of this radius maps into its inside."""
        if not self.square:
            return False
        size = exactly(radius).real[1]
        spread = Rectangle((-size, size), (0, 0) if self.real else (-size, size))
        box = [c if k in self.fixed else c + spread for k, c in enumerate(self.at_middle)]
        slopes = self._slopes(box)
        for i, row in enumerate(self.y):
            total = -self.step[i]
            for j, column in enumerate(self.open):
                near_one = dot(row, [slopes[r][column] for r in self.rows])
                total = total + ((1 if i == j else 0) - near_one) * spread
            if not total.inside(spread):
                return False
        return True

    def _factors(self, z: Sequence[Rectangle]) -> list[list[Rectangle]]:
        result = []
        for motion, part in zip(self.moving, self.equations.made_of, strict=True):
            own = z[part]
            result.append([dot(row, own) for row in motion])
        return result

    def _way(self, k: int, made: Sequence[Sequence[Rectangle]]) -> list[list[Rectangle]]:
        ways = self.equations.ways[k]
        return [[c * int(CONJUGATE[i]) if f.back else c for i, c in enumerate(made[f.motion])] for f in ways]

    def _values(self, z: Sequence[Rectangle]) -> list[Rectangle]:
        made, result = self._factors(z), list[Rectangle]()
        for k, (square, linear) in enumerate(self.loops):
            g = chain(self._way(k, made))
            for form in square:  # twice the form: rows are scaled alike below
                result.append(dot(g, [dot(row, g) for row in form]))
            result += [dot(row, g) for row in linear]
        for place in self.equations.free:
            x = z[self.equations.parts[place]]
            result.append(dot(x[:4], x[4:]))
        squares = self._squares()
        return [Rectangle(*((r[0] >> 1, -(-r[1] >> 1)) for r in (v.real, v.imaginary))) if k in squares else v
                for k, v in enumerate(result)]  # fmt: skip

    def _squares(self) -> set[int]:
        found, row = set[int](), 0
        for square, linear in self.loops:
            found |= set(range(row, row + len(square)))
            row += len(square) + len(linear)
        return found

    def _slopes(self, z: Sequence[Rectangle]) -> list[list[Rectangle]]:
        made, zero = self._factors(z), whole(0)
        rows: list[list[Rectangle]] = []
        for k, (square, linear) in enumerate(self.loops):
            factors = self._way(k, made)
            g = chain(factors)
            both = [[dot(row, g) for row in form] for form in square]
            both += [[product(c, whole(1)) for c in row] for row in linear]
            block = [[zero] * self.equations.width for _ in both]
            for place, factor in enumerate(self.equations.ways[k]):
                before = [chain(factors[:place])] if place else []
                motion, part = self.moving[factor.motion], self.equations.parts[factor.group]
                for j in range(part.stop - part.start):
                    column = [product(motion[i, j], whole(1)) * (int(CONJUGATE[i]) if factor.back else 1)
                              for i in range(SIZE)]  # fmt: skip
                    slope = chain([*before, column, *factors[place + 1 :]])
                    for n, form in enumerate(both):
                        block[n][part.start + j] += dot(form, slope)
            rows += block
        for place in self.equations.free:
            part, row = self.equations.parts[place], [zero] * self.equations.width
            x = z[part]
            row[part] = [*x[4:], *x[:4]]
            rows.append(row)
        return rows


class _Krawczyk(Chart):
    """The test of a zero in doubles."""

    def __init__(
        self, equations: BatchEquations, slots: Sequence[Any], z: Array, rows: Sequence[int] | None = None
    ) -> None:
        super().__init__(equations, slots, z)
        middle = self.middle
        if np.abs(middle.imag).max(initial=0.0) < max(RADII):
            middle = middle.real + 0j
        coefficients = np.array([middle_of_box(v) for m in self.numbers() for v in m.ravel()])
        for _ in range(3):  # what tracking leaves is 1e-11
            values, slopes = equations.evaluate(middle[None], coefficients[None])
            self.rows = self._rows(middle) if rows is None else list(rows)
            inverse = np.linalg.pinv(slopes[0][np.ix_(self.rows, self.open)])
            middle[self.open] -= inverse @ values[0][self.rows]
        self.real = not middle.imag.any()
        self.middle, self.inverse = middle, inverse
        self.square = inverse.shape[0] == inverse.shape[1]
        self.at_middle = [exactly(c) for c in middle]
        y = [[exactly(c) for c in row] for row in inverse]
        residual = [self._values(self.at_middle)[k] for k in self.rows]
        self.y = y
        self.step = [dot(row, residual) for row in y]

    def kind(self, radius: float) -> str:
        """What the zero in the box of this radius is."""
        return "real" if self.real else "complex" if np.abs(self.middle.imag).max() > 2 * radius else ""

    def off(self, z: Array) -> float:
        """How far a point is from the middle of the boxes."""
        scaled = np.array(z, dtype=complex)
        for part, place in zip(self.equations.parts, self.fixed, strict=True):
            scaled[part] = scaled[part] / scaled[place]
        return float(np.abs(scaled - self.middle).max())

    def refined(self) -> Array:
        """The zero to the last bit of doubles: Newton's steps with the same inverse, residuals in integers."""
        point = list(self.at_middle)
        for _ in range(REFINEMENTS):
            residual = self._values(point)
            for i, k in enumerate(self.open):
                step = dot(self.y[i], [residual[r] for r in self.rows])
                (a, b), (c, d) = (point[k] - step).real, (point[k] - step).imaginary
                point[k] = Rectangle(((a + b) // 2,) * 2, ((c + d) // 2,) * 2)
        return np.array([middle_of_box(c) for c in point])


class FineTest(Chart):
    """The test of zeros in 60 digits, in the chart of a point where zeros almost meet."""

    def __init__(self, equations: BatchEquations, slots: Sequence[Any], z: Array) -> None:
        super().__init__(equations, slots, z)
        self.rows = self._rows(self.middle)
        self.square = len(self.rows) == len(self.open)
        self.real = bool(np.abs(self.middle.imag).max(initial=0.0) < REAL_MIDDLE)
        self.at_middle = [exactly(c.real if self.real else c) for c in self.middle]

    def values_at(self, z: Sequence[Any]) -> list[Any]:
        """F in 60 digits, of the rows that count."""
        values = self._values([finely(c) for c in z])
        return [fine(values[k]) for k in self.rows]

    def slopes_at(self, z: Sequence[Any]) -> list[list[Any]]:
        """dF in 60 digits: rows that count, coordinates that are not 1."""
        slopes = self._slopes([finely(c) for c in z])
        return [[fine(slopes[r][k]) for k in self.open] for r in self.rows]

    @property
    def size(self) -> float:
        """The largest coefficient of the forms: dF is of this size where it is not nearly singular."""
        return max((abs(middle_of_box(c)) for loop in self.loops for m in loop for c in m.ravel()), default=1.0)

    def held(self, z: Sequence[Any], inverse: Sequence[Sequence[Any]], radii: Sequence[float]) -> float | None:
        """The first of these radii of a box around z that holds one zero, None where there is none."""
        self.at_middle = [finely(c) for c in z]
        self.real = not any(c.imaginary != (0, 0) for c in self.at_middle)
        self.y = [[finely(c) for c in row] for row in inverse]
        values = self._values(self.at_middle)
        residual = [values[k] for k in self.rows]
        self.step = [dot(row, residual) for row in self.y]
        return next((radius for radius in radii if self.holds(radius)), None)


def _two_rows(block: Array) -> list[int]:
    """The rows of an antisymmetric matrix of rank two whose common entry is largest."""
    sizes = np.abs(np.vectorize(middle_of_box)(block[:, :4]).astype(complex))
    return sorted(int(k) for k in np.unravel_index(int(sizes.argmax()), sizes.shape))
