"""How many zeros meet in a singular one, exactly.

    z + kernel of dF, c variables t --order by order, what dF can give is solved for--> g(t), what it cannot give
    g(t) = 0 at t = 0 --multiples of g by monomials, up to an order--> dimension of what they leave of all monomials

(A. M. Lyapunov, E. Schmidt; F. S. Macaulay, The algebraic theory of modular systems, 1916; B. Dayton, Z. Zeng, 2005.)
The dimension grows with the order until it is the number of zeros that meet; where it does not grow by one order it is
that. With one variable it is the order of g.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement
from math import comb

from symscrew.assembly.exact_slots import ExactEquations, Series, product
from symscrew.mobility import Exact

HIGHEST = {1: 8, 2: 6, 3: 5}
"""Order by the number of variables; of more variables the least number that can meet is said."""
MOST_WORK = 20_000_000
"""Products of numbers of one evaluation, those of a field counted by its degree squared: some seconds. A delta at the
limit of its reach takes a fortieth of it; where more would be needed the least number that can meet is said."""


def meeting_zeros(equations: ExactEquations, coordinates: Sequence[Exact], open_: Sequence[int]) -> tuple[int, bool]:
    """(how many zeros are in a zero, whether it is so many and isolated, else it is that many at least).

    Args:
        equations: of which it is a zero.
        coordinates: of the zero.
        open_: places of the coordinates that are not 1 by choice.
    """
    count = len(open_)
    moved: list[Series] = [{(0,) * count: c} if c else {} for c in coordinates]
    for k, place in enumerate(open_):
        moved[place] = {**moved[place], _unit(k, count): Fraction(1)}
    rows = equations.values(moved, 1)
    slopes = [[row.get(_unit(k, count), Fraction(0)) for k in range(count)] for row in rows]
    whole = [[*row, *(Fraction(int(i == k)) for k in range(len(slopes)))] for i, row in enumerate(slopes)]
    work, pivots = reduced(whole, count)
    free = [k for k in range(count) if k not in pivots]
    if not free:
        return 1, True
    return _Bent(equations, (coordinates, open_), (work, pivots, free)).meeting()


class _Bent:
    """The zero with the variables of the kernel, and the other coordinates as they follow from these."""

    def __init__(
        self,
        equations: ExactEquations,
        at: tuple[Sequence[Exact], Sequence[int]],
        solved: tuple[Sequence[Sequence[Exact]], Sequence[int], Sequence[int]],
    ) -> None:
        """`solved`: rows of (dF, 1) in reduced form, columns that are solved for, and that are not."""
        self.equations, (coordinates, self.open) = equations, at
        self.work, self.pivots, self.free = solved
        self.count = len(self.free)
        none = (0,) * self.count
        self.series: list[Series] = [{none: c} if c else {} for c in coordinates]
        for k, column in enumerate(self.free):
            self.series[self.open[column]][_unit(k, self.count)] = Fraction(1)
            for row, pivot in zip(self.work, self.pivots, strict=False):
                if row[column]:
                    self.series[self.open[pivot]][_unit(k, self.count)] = -row[column]

    def meeting(self) -> tuple[int, bool]:
        """As `meeting_zeros`."""
        before, highest = 1 + self.count, HIGHEST.get(self.count, 1)
        for order in range(2, highest + 1):
            if self.equations.work(comb(order + self.count, order)) > MOST_WORK:
                break
            values = self.equations.values(self.series, order)
            self._bend(values, order)
            here = self._dimension([self._left(values, row) for row in self.work[len(self.pivots) :]], order)
            if here == before:
                return here, True
            before = here
        return before, False

    def _bend(self, values: Sequence[Series], order: int) -> None:
        """The terms of this order of the coordinates that are solved for."""
        width = len(self.open)
        for key in {key for value in values for key in value if sum(key) == order}:
            rest = [value.get(key, Fraction(0)) for value in values]
            for row, pivot in zip(self.work, self.pivots, strict=False):
                if change := sum((a * b for a, b in zip(row[width:], rest, strict=True) if a and b), Fraction(0)):
                    self.series[self.open[pivot]][key] = -change

    def _left(self, values: Sequence[Series], row: Sequence[Exact]) -> Series:
        """What dF cannot give, along one vector."""
        total: Series = {}
        for factor, value in zip(row[len(self.open) :], values, strict=True):
            for key, c in value.items() if factor else ():
                total[key] = total.get(key, Fraction(0)) + factor * c
        return {key: c for key, c in total.items() if c}

    def _dimension(self, g: Sequence[Series], order: int) -> int:
        """Of the monomials up to an order, over the multiples of g."""
        keys = list(monomials(self.count, order))
        place = {key: k for k, key in enumerate(keys)}
        rows = list[list[Exact]]()
        for factor in monomials(self.count, order - 1):
            for value in g:
                row: list[Exact] = [Fraction(0)] * len(keys)
                for key, c in product({factor: Fraction(1)}, value, order).items():
                    row[place[key]] = c
                rows.append(row)
        return len(keys) - len(reduced(rows, len(keys))[1])


def monomials(count: int, order: int) -> Iterator[tuple[int, ...]]:
    """Exponents of so many variables, up to an order."""
    for degree in range(order + 1):
        for chosen in combinations_with_replacement(range(count), degree):
            yield tuple(chosen.count(k) for k in range(count))


def _unit(k: int, count: int) -> tuple[int, ...]:
    return tuple(int(i == k) for i in range(count))


def reduced(rows: Sequence[Sequence[Exact]], columns: int) -> tuple[list[list[Exact]], list[int]]:
    """(rows in reduced form by their first columns, pivot columns)."""
    work, pivots, top = [list(row) for row in rows], list[int](), 0
    for column in range(columns):
        place = next((k for k in range(top, len(work)) if work[k][column]), None)
        if place is None:
            continue
        work[top], work[place] = work[place], work[top]
        below = work[top][column]
        work[top] = [c / below for c in work[top]]
        for k, row in enumerate(work):
            if k != top and row[column]:
                factor = row[column]
                work[k] = [a - factor * b for a, b in zip(row, work[top], strict=True)]
        pivots.append(column)
        top += 1
    return work, pivots
