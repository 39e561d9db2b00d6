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

from symscrew.algebra import CONTEXT
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.dual_forms import CONJUGATE, PRODUCT, SIZE
from symscrew.assembly.slot_numbers import matrices

Array = np.ndarray[Any, Any]

BITS = 200
"""Of the fraction of fixed-point numbers: 60 digits."""
ONE = 1 << BITS
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
TERMS = [(k, i, j, int(PRODUCT[k, i, j])) for k in range(SIZE) for i in range(SIZE) for j in range(SIZE)
         if PRODUCT[k, i, j]]  # fmt: skip


class Rectangle:
    """Complex numbers between two corners, integers in units of 2^-200; a real interval has `imaginary` (0, 0)."""

    __slots__ = ("imaginary", "real")

    def __init__(self, real: tuple[int, int], imaginary: tuple[int, int] = (0, 0)) -> None:
        self.real, self.imaginary = real, imaginary

    def __add__(self, other: Rectangle | int) -> Rectangle:
        o = other if isinstance(other, Rectangle) else whole(other)
        (a, b), (c, d), (e, f), (g, h) = self.real, o.real, self.imaginary, o.imaginary
        return Rectangle((a + c, b + d), (e + g, f + h))

    __radd__ = __add__

    def __neg__(self) -> Rectangle:
        return Rectangle((-self.real[1], -self.real[0]), (-self.imaginary[1], -self.imaginary[0]))

    def __sub__(self, other: Rectangle | int) -> Rectangle:
        return self + -(other if isinstance(other, Rectangle) else whole(other))

    def __rsub__(self, other: int) -> Rectangle:
        return whole(other) - self

    def __mul__(self, other: Rectangle | int) -> Rectangle:
        if not isinstance(other, Rectangle):
            (a, b), (e, f), n = self.real, self.imaginary, int(other)
            one, two = (n * a, n * b), (n * e, n * f)
            return Rectangle(one, two) if n >= 0 else Rectangle(one[::-1], two[::-1])
        real = _times(self.real, other.real)
        if self.imaginary == (0, 0) and other.imaginary == (0, 0):
            return Rectangle(real)
        low = _times(self.imaginary, other.imaginary)
        one, two = _times(self.real, other.imaginary), _times(self.imaginary, other.real)
        return Rectangle((real[0] - low[1], real[1] - low[0]), (one[0] + two[0], one[1] + two[1]))

    __rmul__ = __mul__

    def inside(self, other: Rectangle) -> bool:
        """Whether it is in the inside of another."""
        (a, b), (c, d) = self.real, other.real
        if not c < a <= b < d:
            return False
        (a, b), (c, d) = self.imaginary, other.imaginary
        return c < a <= b < d or other.imaginary == (0, 0) == self.imaginary


def _times(a: tuple[int, int], b: tuple[int, int]) -> tuple[int, int]:
    if a == (0, 0) or b == (0, 0):
        return (0, 0)
    products = (a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1])
    return min(products) >> BITS, -(-max(products) >> BITS)


def whole(value: int) -> Rectangle:
    """An integer."""
    return Rectangle((int(value) << BITS, int(value) << BITS))


def exactly(value: complex) -> Rectangle:
    """A double, or two, with all their digits that are not below 2^-200."""
    parts = []
    for c in (complex(value).real, complex(value).imag):
        n, d = c.as_integer_ratio()
        parts.append(((n << BITS) // d, -((-n << BITS) // d)))
    return Rectangle(*parts)


def read(value: Any) -> Rectangle:
    """A number of 60 digits, right in its last but one."""
    scaled = CONTEXT.mpf(value) * ONE
    low = int(CONTEXT.floor(scaled))
    slack = max(1, abs(low) >> (BITS - 8))  # eight bits for what rounding to 60 digits leaves
    return Rectangle((low - slack, low + 1 + slack)) if value else Rectangle((0, 0))


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
            if self.equations.structure.planar:
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
            motion = np.vectorize(middle_of_box)(self.motions[factor.group]).astype(complex)
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
                product = _sum([row[m] * slopes[r][column] for m, r in enumerate(self.rows)])
                total = total + ((1 if i == j else 0) - product) * spread
            if not total.inside(spread):
                return False
        return True

    def _factors(self, z: Sequence[Rectangle]) -> list[list[Rectangle]]:
        result = []
        for motion, part in zip(self.motions, self.equations.parts, strict=True):
            own = z[part]
            result.append([_sum([_product(motion[i, j], own[j]) for j in range(len(own))]) for i in range(SIZE)])
        return result

    def _way(self, k: int, made: Sequence[Sequence[Rectangle]]) -> list[list[Rectangle]]:
        ways = self.equations.ways[k]
        return [[c * int(CONJUGATE[i]) if f.back else c for i, c in enumerate(made[f.group])] for f in ways]

    def _values(self, z: Sequence[Rectangle]) -> list[Rectangle]:
        made, result = self._factors(z), list[Rectangle]()
        for k, (square, linear) in enumerate(self.loops):
            g = _chain(self._way(k, made))
            for form in square:  # twice the form: rows are scaled alike below
                result.append(_sum([_product(form[i, j], g[i]) * g[j] for i in range(SIZE) for j in range(SIZE)]))
            result += [_sum([_product(row[i], g[i]) for i in range(SIZE)]) for row in linear]
        for place in self.equations.free:
            x = z[self.equations.parts[place]]
            result.append(_sum([x[i] * x[i + 4] for i in range(4)]))
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
            g = _chain(factors)
            both = [[_sum([_product(form[i, j], g[j]) for j in range(SIZE)]) for i in range(SIZE)] for form in square]
            both += [[_product(c, whole(1)) for c in row] for row in linear]
            block = [[zero] * self.equations.width for _ in both]
            for place, factor in enumerate(self.equations.ways[k]):
                motion, part = self.motions[factor.group], self.equations.parts[factor.group]
                for j in range(part.stop - part.start):
                    column = [_product(motion[i, j], whole(1)) * (int(CONJUGATE[i]) if factor.back else 1)
                              for i in range(SIZE)]  # fmt: skip
                    slope = _chain([*factors[:place], column, *factors[place + 1 :]])
                    for n, form in enumerate(both):
                        block[n][part.start + j] = _sum([a * b for a, b in zip(form, slope, strict=True)])
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
        self.step = [_sum([a * b for a, b in zip(row, residual, strict=True)]) for row in y]

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
                step = _sum([a * residual[r] for a, r in zip(self.y[i], self.rows, strict=True)])
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
        values = self._values([_finely(c) for c in z])
        return [_fine(values[k]) for k in self.rows]

    def slopes_at(self, z: Sequence[Any]) -> list[list[Any]]:
        """dF in 60 digits: rows that count, coordinates that are not 1."""
        slopes = self._slopes([_finely(c) for c in z])
        return [[_fine(slopes[r][k]) for k in self.open] for r in self.rows]

    @property
    def size(self) -> float:
        """The largest coefficient of the forms: dF is of this size where it is not nearly singular."""
        return max((abs(middle_of_box(c)) for loop in self.loops for m in loop for c in m.ravel()), default=1.0)

    def held(self, z: Sequence[Any], inverse: Sequence[Sequence[Any]], radii: Sequence[float]) -> float | None:
        """The first of these radii of a box around z that holds one zero, None where there is none."""
        self.at_middle = [_finely(c) for c in z]
        self.real = not any(c.imaginary != (0, 0) for c in self.at_middle)
        self.y = [[_finely(c) for c in row] for row in inverse]
        values = self._values(self.at_middle)
        residual = [values[k] for k in self.rows]
        self.step = [_sum([a * b for a, b in zip(row, residual, strict=True)]) for row in self.y]
        return next((radius for radius in radii if self.holds(radius)), None)


def fine_middle(z: Sequence[Rectangle]) -> list[Any]:
    """Middles in 60 digits."""
    return [_fine(c) for c in z]


def _fine(value: Rectangle) -> Any:
    return CONTEXT.mpc(CONTEXT.mpf(sum(value.real)) / (2 * ONE), CONTEXT.mpf(sum(value.imaginary)) / (2 * ONE))


def _finely(value: Any) -> Rectangle:
    """A point within 2^-200 of a number of 60 digits."""
    parts = [int(CONTEXT.floor(c * ONE)) for c in (value.real, value.imag)]
    return Rectangle((parts[0], parts[0]), (parts[1], parts[1]))


def _two_rows(block: Array) -> list[int]:
    """The rows of an antisymmetric matrix of rank two whose common entry is largest."""
    sizes = np.abs(np.vectorize(middle_of_box)(block[:, :4]).astype(complex))
    return sorted(int(k) for k in np.unravel_index(int(sizes.argmax()), sizes.shape))


def middle_of_box(value: Any) -> complex:
    """Of a rectangle; a number itself."""
    if not isinstance(value, Rectangle):
        return complex(value)
    return complex(sum(value.real) / 2 / ONE, sum(value.imaginary) / 2 / ONE)


def _product(a: Any, b: Rectangle) -> Rectangle:
    """A product of which the first factor may be an integer."""
    return b * (a if isinstance(a, Rectangle) else int(a))


def _sum(values: Sequence[Rectangle]) -> Rectangle:
    total = Rectangle((0, 0))
    for value in values:
        total = total + value
    return total


def _chain(factors: Sequence[Sequence[Rectangle]]) -> list[Rectangle]:
    """The product of dual quaternions."""
    result = list(factors[0])
    for factor in factors[1:]:
        after = [Rectangle((0, 0)) for _ in range(SIZE)]
        for k, i, j, sign in TERMS:
            product = result[i] * factor[j]
            after[k] = after[k] + (product if sign > 0 else -product)
        result = after
    return result
