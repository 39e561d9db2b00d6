"""The only motion of a loop as exact power series: rates whose closure stays shut to a given order.

    rows of the loop --a regular minor, inverted once--> per order: brackets, then the dependent rates

With rates u_k(t), joint screws follow dS_k/dt = [sum over j < k of S_j u_j, S_k], and the loop opens with the velocity
sum S_k u_k, whose coefficients of t are made zero one after the other.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from symscrew.mobility.proofs.proof_checker import bracket
from symscrew.mobility.symbols import Exact, NotDecidableError, exact_inverse

Row = list[Exact]
LONGEST = 20_000
"""Bits of a coefficient of the series: those of the linkages of the literature have a few thousand at order 16, and a
file of longer ones would be megabytes."""


def shut_arc(
    factors: Sequence[tuple[int, Row]], motion: Row, places: tuple[list[int], list[int]], orders: int
) -> list[Row] | None:
    """Rates that keep the loop shut to so many orders, beginning with `motion`; None where it opens before.

    Args:
        factors: (column, signed screw) around the loop.
        motion: the only motion of the joints.
        places: rows and columns of a regular minor as large as the rank.
        orders: coefficients of the rates.

    Raises:
        NotDecidableError: the numbers grow too long.
    """
    rows, columns = places
    by_column = dict(factors)
    square = [[by_column[j][i] for j in columns] for i in rows]
    inverse = _inverted(square)
    series = _Series(factors, motion)
    while len(series.rates) < orders:
        opened = series.advance()
        if sum(_bits(c) for c in opened) > LONGEST:
            raise NotDecidableError("the coefficients of the series are too long")
        rates: Row = [Fraction(0)] * len(motion)
        for j, row in zip(columns, inverse, strict=True):
            rates[j] = sum((-c * opened[i] for c, i in zip(row, rows, strict=True) if c and opened[i]), Fraction(0))
        if any(c + sum((by_column[j][i] * r for j, r in enumerate(rates) if r), Fraction(0))
               for i, c in enumerate(opened)):  # fmt: skip
            return None
        series.rates.append(rates)
    return series.rates


def _inverted(square: Sequence[Row]) -> list[Row]:
    """The inverse of a regular matrix over the field, by Gauss and Jordan."""
    size = len(square)
    left = [[*row, *(Fraction(int(i == k)) for k in range(size))] for i, row in enumerate(square)]
    for k in range(size):
        lead = next(i for i in range(k, size) if left[i][k])
        left[k], left[lead] = left[lead], left[k]
        back = exact_inverse(left[k][k])
        left[k] = [c * back for c in left[k]]
        for i in range(size):
            if i != k and (factor := left[i][k]):
                left[i] = [a - factor * b for a, b in zip(left[i], left[k], strict=True)]
    return [row[size:] for row in left]


class _Series:
    """Coefficients in t of the screws and of the twists that carry them."""

    def __init__(self, factors: Sequence[tuple[int, Row]], motion: Row) -> None:
        self.columns = [column for column, _ in factors]
        self.screws = [[screw] for _, screw in factors]
        self.carried: list[list[Row]] = [[] for _ in factors]
        self.rates = [motion]

    def advance(self) -> Row:
        """The next coefficient of the velocity at which the loop opens, without the next rates."""
        order = len(self.rates)
        self._carry(order - 1)
        total: Row = [Fraction(0)] * 6
        for own, column, carried in zip(self.screws, self.columns, self.carried, strict=True):
            grown: Row = [Fraction(0)] * 6
            for a in range(order):
                grown = [x + y for x, y in zip(grown, bracket(carried[a], own[order - 1 - a]), strict=True)]
            own.append([c * Fraction(1, order) for c in grown])
            for b in range(order):
                if rate := self.rates[b][column]:
                    total = [x + c * rate if c else x for x, c in zip(total, own[order - b], strict=True)]
        return total

    def _carry(self, order: int) -> None:
        """A coefficient of the twist that carries each screw, now that the rates of this order are known."""
        total: Row = [Fraction(0)] * 6
        for own, column, carried in zip(self.screws, self.columns, self.carried, strict=True):
            carried.append(total)
            for b in range(order + 1):
                if rate := self.rates[b][column]:
                    total = [x + c * rate if c else x for x, c in zip(total, own[order - b], strict=True)]


def _bits(number: Exact) -> int:
    """Of all coefficients of a number of the field."""
    if isinstance(number, (int, Fraction)):
        return abs(number.numerator).bit_length() + number.denominator.bit_length()
    return sum(_bits(c) for c in number.coefficients)
