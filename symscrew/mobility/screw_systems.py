"""Null spaces and ranks in 60 digits, with the evidence for every decision.

    rows A --eliminate--> pivots --null_space--> all x with A x = 0 (eq. (10): A of swapped screws, x reciprocal)

A number is taken for zero when it is below 1e-27 of the largest entry: far below any deviation that a
description means (1e-12 off is off, and so is its square), far above the rounding of 60 digits and of data
given to 30 digits or more.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from mpmath.libmp import from_man_exp

from symscrew.algebra import CONTEXT

Real = Any
"""A number of 60 digits, `CONTEXT.mpf`; mpmath has no types."""
Row = list[Real]
Screw = tuple[Real, ...]
"""Six numbers: a twist (omega ; v) or a wrench (f ; m)."""
Vectors = Sequence[Sequence[Real]]
Pair = tuple[int, int]
"""m, e of a number m 2^e; m is negative where it is."""

ZERO_BELOW = CONTEXT.mpf(10) ** -27
"""Of the largest entry: what is smaller is zero.

Smaller is rounding: of 60 digits through a few hundred operations (1e-55), or of a description with 30 digits (1e-30).
Larger is meant: a joint 1e-12 off is off, and so is the square of that, 1e-24. What lies just above is reported as
`smallest_pivot`, what lies below as `largest_zero`."""
READABLE_PIVOT = CONTEXT.mpf(10) ** -20
"""Entries below it are no pivots of the echelon basis that is shown: its entries are of order one, so a smaller one
would only be division by a remainder. The rank is not decided here."""


@dataclass(frozen=True)
class ScrewSystem:
    """A linear space of screws or motions, with the evidence for its dimension.

    Attributes:
        basis: its vectors: twists (omega ; v) [1, m], wrenches (f ; m) [1, m], or motions (one rate a freedom).
        rank: of the rows that it was found from.
        smallest_pivot: of the elimination, relative to the largest entry.
        largest_zero: the largest number that was taken for zero, relative to the largest entry.
    """

    basis: tuple[Screw, ...]
    rank: int
    smallest_pivot: float
    largest_zero: float

    def __repr__(self) -> str:
        count = f"{len(self.basis)} vector{'' if len(self.basis) == 1 else 's'}"
        return f"<ScrewSystem: {count}, rank {self.rank}, pivots >= {self.smallest_pivot:.1e}>"


@dataclass(frozen=True)
class Elimination:
    """Reduced rows with their pivot columns; `smallest` pivot and `largest` number taken for zero."""

    rows: tuple[Screw, ...]
    pivots: tuple[int, ...]
    smallest: float
    largest: float

    @property
    def rank(self) -> int:
        """Number of pivots."""
        return len(self.pivots)


def eliminate(rows: Vectors, columns: int) -> Elimination:
    """Gauss-Jordan elimination with full pivoting; pivots relative to the largest entry.

    On integers, mantissa and exponent, rounded digit by digit as mpmath rounds: the numbers around them take more time
    than they do. Of a row its entries that are not zero: of long chains they are few.
    """
    digits = int(CONTEXT._prec_rounding[0])
    matrix = [{k: _pair(c) for k, c in enumerate(CONTEXT.convert(c)._mpf_ for c in row) if c[1]} for row in rows]
    largest = _number(_largest(matrix, 0)[0]) or CONTEXT.one
    pivots: list[int] = []
    smallest, residue = float("inf"), 0.0
    for r in range(len(matrix)):
        found, i, j = _largest(matrix, r)
        size = _number(found)
        if size < ZERO_BELOW * largest:
            residue = float(size / largest)
            break
        smallest = min(smallest, float(size / largest))
        matrix[r], matrix[i] = matrix[i], matrix[r]
        pivot = _number(matrix[r][j])
        matrix[r] = {k: _pair((_number(c) / pivot)._mpf_) for k, c in matrix[r].items()}
        others = [(column, c) for column, c in matrix[r].items() if column != j]
        for k, other in enumerate(matrix):
            if k != r and (taken := other.pop(j, None)) is not None:
                _subtract(other, taken, others, digits)
        pivots.append(j)
    reduced = []
    for row in matrix[: len(pivots)]:
        whole = [CONTEXT.zero] * columns
        for k, c in row.items():
            whole[k] = _clean(_number(c))
        reduced.append(tuple(whole))
    return Elimination(tuple(reduced), tuple(pivots), smallest if pivots else float("nan"), residue)


def _subtract(row: dict[int, Pair], factor: Pair, others: Sequence[tuple[int, Pair]], digits: int) -> None:
    """Takes the factor times the others from a row, product and difference each rounded to so many binary digits."""
    factor_m, factor_e = factor
    for column, (other_m, other_e) in others:
        m, e = factor_m * other_m, factor_e + other_e
        if m.bit_length() > digits:
            m, e = _rounded(m, e, digits)
        own = row.get(column)
        if own is None:
            row[column] = -m, e
            continue
        shift = own[1] - e
        if shift >= 0:
            left = (own[0] << shift) - m
        else:
            left, e = own[0] - (m << -shift), own[1]
        if not left:
            del row[column]
        elif left.bit_length() > digits:
            row[column] = _rounded(left, e, digits)
        else:
            row[column] = left, e


def _rounded(m: int, e: int, digits: int) -> Pair:
    """m 2^e to the nearest with so many binary digits, to the even one of two."""
    more = m.bit_length() - digits
    twice = m >> (more - 1)
    up = twice & 1 and (twice & 2 or m & ((1 << (more - 1)) - 1))
    return (twice >> 1) + (1 if up else 0), e + more


def _pair(number: tuple[int, int, int, int]) -> Pair:
    """Mantissa and exponent of a number as mpmath holds it."""
    return (-int(number[1]) if number[0] else int(number[1])), int(number[2])


def _number(pair: Pair) -> Real:
    return CONTEXT.make_mpf(from_man_exp(*pair))


def _largest(matrix: Sequence[Mapping[int, Pair]], start: int) -> tuple[Pair, int, int]:
    """Size, row and column of the largest entry from a row on; of equals the first one of the first row.

    The columns of pivots have no entries there.
    """
    size, reach, i, j = (0, 0), None, start, 0
    for row in range(start, len(matrix)):
        for column, (m, e) in matrix[row].items():
            ends = m.bit_length() + e
            if reach is None or ends > reach:
                more = 1
            elif ends < reach:
                continue
            else:
                one, two = abs(m) << max(0, e - size[1]), size[0] << max(0, size[1] - e)
                more = (one > two) - (one < two)
            if more > 0 or (more == 0 and row == i and column < j):
                size, reach, i, j = (abs(m), e), ends, row, column
    return size, i, j


def null_space(rows: Vectors, columns: int) -> ScrewSystem:
    """All x with rows x = 0: a basis, the rank of the rows and its evidence.

    >>> null_space([[CONTEXT.mpf(1), CONTEXT.mpf(-1)]], 2).rank
    1
    """
    found = eliminate(rows, columns)
    basis = []
    for free in (j for j in range(columns) if j not in found.pivots):
        vector = [CONTEXT.zero] * columns
        vector[free] = CONTEXT.one
        for row, j in zip(found.rows, found.pivots, strict=True):
            vector[j] = -row[free]
        basis.append(tuple(vector))
    return ScrewSystem(tuple(basis), found.rank, found.smallest, found.largest)


def span(vectors: Vectors, columns: int) -> ScrewSystem:
    """An echelon basis of the space that the vectors span, first columns eliminated first; the rank's evidence."""
    found = eliminate(vectors, columns)
    order = _echelon([list(row) for row in found.rows], columns)
    return ScrewSystem(tuple(order), found.rank, found.smallest, found.largest)


def _echelon(rows: list[Row], columns: int) -> list[Screw]:
    """Reduced row echelon form of independent rows, a readable basis: leading ones, zeros above and below."""
    done = 0
    for column in range(columns):
        candidates = [(abs(rows[i][column]), i) for i in range(done, len(rows))]
        size, i = max(candidates, default=(CONTEXT.zero, 0))
        if size < READABLE_PIVOT:
            continue
        rows[done], rows[i] = rows[i], rows[done]
        pivot = rows[done][column]
        rows[done] = [c / pivot for c in rows[done]]
        for k in range(len(rows)):
            factor = rows[k][column]
            if k != done and factor:
                rows[k] = [_clean(a - factor * b) for a, b in zip(rows[k], rows[done], strict=True)]
        done += 1
    return [tuple(row) for row in rows]


def combine(rows: Vectors, vector: Sequence[Real]) -> Screw:
    """rows x vector; a sum that is rounding against its own terms is zero, so that it is never held against itself."""
    return tuple(_sum([a * b for a, b in zip(row, vector, strict=True) if a and b]) for row in rows)


def _sum(terms: Sequence[Real]) -> Real:
    total = sum(terms, CONTEXT.zero)
    return total if abs(total) > ZERO_BELOW * sum((abs(c) for c in terms), CONTEXT.zero) else CONTEXT.zero


def unit_rows(rows: Vectors) -> list[Row]:
    """Every row divided by its length, so that ranks do not depend on it; zero rows are left out."""
    sizes = [CONTEXT.sqrt(sum((c * c for c in row), CONTEXT.zero)) for row in rows]
    return [[c / size for c in row] for row, size in zip(rows, sizes, strict=True) if size]


def swapped(screw: Sequence[Real]) -> Row:
    """The two halves exchanged: x . swapped(y) is the reciprocal product, eq. (10)."""
    return [*screw[3:], *screw[:3]]


def normalised(screw: Sequence[Real]) -> Screw:
    """First half of unit length if it is not zero, else the second half; first nonzero entry positive."""
    for half in (screw[:3], screw[3:]):
        size = CONTEXT.sqrt(sum(c * c for c in half))
        if size > ZERO_BELOW:
            sign = next(1 if c > 0 else -1 for c in half if abs(c) > ZERO_BELOW * size)
            return tuple(c * sign / size for c in screw)
    return tuple(screw)


def _clean(value: Real) -> Real:
    return value if abs(value) > ZERO_BELOW else CONTEXT.zero
