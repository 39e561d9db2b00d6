"""Complex numbers between two corners, in integers: sums and products with rounding outwards.

    a double, a number of 60 digits --exactly, read, finely--> Rectangle --dot, chain--> Rectangle that holds the result

Ends are integers times 2^-200, so that nothing rests on doubles.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from symscrew.algebra import CONTEXT
from symscrew.assembly.dual_forms import PRODUCT, SIZE

BITS = 200
"""Of the fraction of fixed-point numbers: 60 digits."""
ONE = 1 << BITS
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
    """The product of two intervals; signs say which ends make its ends."""
    if a == (0, 0) or b == (0, 0):
        return (0, 0)
    (a0, a1), (b0, b1) = a, b
    if a0 >= 0:
        low, high = (a0 if b0 >= 0 else a1) * b0, (a1 if b1 >= 0 else a0) * b1
    elif a1 <= 0:
        low, high = (a0 if b1 >= 0 else a1) * b1, (a1 if b0 >= 0 else a0) * b0
    elif b0 >= 0:
        low, high = a0 * b1, a1 * b1
    elif b1 <= 0:
        low, high = a1 * b0, a0 * b0
    else:
        low, high = min(a0 * b1, a1 * b0), max(a0 * b0, a1 * b1)
    return low >> BITS, -(-high >> BITS)


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


def fine_middle(z: Sequence[Rectangle]) -> list[Any]:
    """Of many."""
    return [fine(c) for c in z]


def fine(value: Rectangle) -> Any:
    """The middle in 60 digits."""
    return CONTEXT.mpc(CONTEXT.mpf(sum(value.real)) / (2 * ONE), CONTEXT.mpf(sum(value.imaginary)) / (2 * ONE))


def finely(value: Any) -> Rectangle:
    """A point within 2^-200 of a number of 60 digits."""
    parts = [int(CONTEXT.floor(c * ONE)) for c in (value.real, value.imag)]
    return Rectangle((parts[0], parts[0]), (parts[1], parts[1]))


def middle_of_box(value: Any) -> complex:
    """Of a rectangle; a number itself."""
    if not isinstance(value, Rectangle):
        return complex(value)
    return complex(sum(value.real) / 2 / ONE, sum(value.imaginary) / 2 / ONE)


def product(a: Any, b: Rectangle) -> Rectangle:
    """A product of which the first factor may be an integer."""
    return b * (a if isinstance(a, Rectangle) else int(a))


def _absent(a: Any) -> bool:
    """Whether a factor is nothing: most entries of matrices are."""
    return a.real == (0, 0) == a.imaginary if isinstance(a, Rectangle) else not a


def dot(one: Sequence[Any], two: Sequence[Rectangle]) -> Rectangle:
    """The sum of products of which first factors may be integers."""
    low = high = left = right = 0
    for a, b in zip(one, two, strict=True):
        if not _absent(a) and not _absent(b):
            term = product(a, b)
            (p, q), (r, s) = term.real, term.imaginary
            low, high, left, right = low + p, high + q, left + r, right + s
    return Rectangle((low, high), (left, right))


def chain(factors: Sequence[Sequence[Rectangle]]) -> list[Rectangle]:
    """The product of dual quaternions."""
    result = list(factors[0])
    for factor in factors[1:]:
        there, after = [not _absent(b) for b in factor], [Rectangle((0, 0)) for _ in range(SIZE)]
        present = [not _absent(a) for a in result]
        for k, i, j, sign in TERMS:
            if present[i] and there[j]:
                term = result[i] * factor[j]
                after[k] = after[k] + term if sign > 0 else after[k] - term
        result = after
    return result
