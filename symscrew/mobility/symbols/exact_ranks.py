"""Ranks decided in an exact field: those that mobility in the reference configuration rests on.

    rank modulo p <= rank <= number of rows or columns;  equal ends decide, else elimination over the field

A homomorphism to a field of p elements never raises a rank, so a rank modulo p is a proved lower bound; where it
is the number of rows or columns, it is the rank. Other ranks are found by elimination over the field itself, as
long as that is of reasonable size.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

import sympy

from symscrew.mobility.symbols.exact_field import Field
from symscrew.mobility.symbols.exact_numbers import Exact, NotDecidableError, Number, inverse
from symscrew.mobility.symbols.exact_screws import Row

MOST_WORK = 200_000
"""Products of rational numbers in one elimination: a few seconds at most. Beyond it the rank stands on 60 digits alone,
and the result says so."""
LONGEST = 6000
"""Bits of a number; beyond it elimination stops: its numbers double in length with every pivot from there."""
FIRST_PRIME = 2**61
"""Of the primes for lower bounds: an accident (a minor that is divisible by it) has the odds of 1 : 2^61, and
products still fit the fast integers of most machines twice over. It would only cost an elimination."""


class EliminationTooLongError(NotDecidableError):
    """Elimination over the field would take too long."""


def exact_rank(rows: Sequence[Row], field: Field) -> int:
    """The rank over the field."""
    rows = [row for row in rows if any(row)]
    columns = [j for j in range(len(rows[0])) if any(row[j] for row in rows)] if rows else []
    rows = [[row[j] for j in columns] for row in rows]
    if not rows:
        return 0
    least = rank_modulo(rows, field)
    if least == min(len(rows), len(columns)):
        return least
    rank = len(reduced(rows, field)[1])
    assert rank >= least
    return rank


def reduced(rows: Sequence[Row], field: Field) -> tuple[list[Row], list[int]]:
    """(rows in reduced echelon form, pivot columns), sparsest pivots first."""
    matrix = [list(row) for row in rows if any(row)]
    done: list[Row] = []
    pivots: list[int] = []
    work = 0
    while matrix:
        matrix.sort(key=lambda row: sum(1 for c in row if c))
        row = matrix.pop(0)
        counts = {j: sum(1 for other in matrix if other[j]) for j, c in enumerate(row) if c}
        lead = min(counts, key=lambda j: (_length(row[j]), counts[j]))
        factor = inverse(row[lead])
        row = [c * factor if c else c for c in row]
        support = [j for j, c in enumerate(row) if c]
        if max(_length(row[j]) for j in support) > LONGEST:
            raise EliminationTooLongError("the numbers of the elimination grow too long")
        for other in (*matrix, *done):
            if factor := other[lead]:
                work += len(support) * field.degree**2
                if work > MOST_WORK:
                    raise EliminationTooLongError(f"elimination over {field} is too long")
                for j in support:
                    other[j] = other[j] - factor * row[j]
        done.append(row)
        pivots.append(lead)
        matrix = [other for other in matrix if any(other)]
    return done, pivots


def null_vectors(rows: Sequence[Row], columns: int, field: Field) -> list[tuple[Exact, ...]]:
    """A basis of the null space, one vector per free column."""
    echelon, pivots = reduced(rows, field)
    result = []
    for free in (j for j in range(columns) if j not in pivots):
        vector: list[Exact] = [Fraction(0)] * columns
        vector[free] = Fraction(1)
        for row, j in zip(echelon, pivots, strict=True):
            vector[j] = -row[free]
        result.append(tuple(vector))
    return result


def _length(x: Exact) -> int:
    if isinstance(x, Number):
        return sum(_length(c) for c in x.coefficients)
    return int(x.numerator).bit_length() + int(x.denominator).bit_length()


def rank_modulo(rows: Sequence[Row], field: Field) -> int:
    """Rank of the image in a field of p elements: at most the rank."""
    for p, images in _homomorphisms(field):
        try:
            matrix = [[_image(c, p, images) for c in row] for row in rows]
        except ZeroDivisionError:  # p divides a denominator
            continue
        return _rank_of_residues(matrix, p)
    raise AssertionError("there are primes without end")


def _rank_of_residues(matrix: list[list[int]], p: int) -> int:
    rank = 0
    for j in range(len(matrix[0])):
        lead = next((i for i in range(rank, len(matrix)) if matrix[i][j]), None)
        if lead is None:
            continue
        matrix[rank], matrix[lead] = matrix[lead], matrix[rank]
        back = pow(matrix[rank][j], -1, p)
        top = [c * back % p for c in matrix[rank]]
        for i in range(rank + 1, len(matrix)):
            if factor := matrix[i][j]:
                matrix[i] = [(a - factor * b) % p for a, b in zip(matrix[i], top, strict=True)]
        rank += 1
    return rank


def _homomorphisms(field: Field) -> Iterator[tuple[int, dict[object, int]]]:
    """(p, images of the generators) for primes at which all generators have one."""
    unit = field.unit
    p = FIRST_PRIME // unit * unit + 1
    while True:
        p += unit
        if not sympy.isprime(p):
            continue
        images: dict[object, int] = {}
        for generator in field.generators:
            try:
                if generator.conjugates:
                    images[generator] = _cosine_modulo(unit, p)
                    continue
                square = -_image(generator.modulus[0], p, images) % p
            except ZeroDivisionError:
                break
            root = sympy.sqrt_mod(square, p) if square else None
            if root is None:
                break
            images[generator] = int(root)
        else:
            yield p, images


def _cosine_modulo(n: int, p: int) -> int:
    """2 cos(2 pi / n) modulo p: zeta + 1 / zeta for a primitive n-th root of unity."""
    base = 2
    while True:
        zeta = pow(base, (p - 1) // n, p)
        if all(pow(zeta, n // int(q), p) != 1 for q in sympy.primefactors(n)):
            return (zeta + pow(zeta, -1, p)) % p
        base += 1


def _image(x: Exact, p: int, images: Mapping[object, int]) -> int:
    if isinstance(x, Number):
        total = 0
        for c in reversed(x.coefficients):
            total = (total * images[x.generator] + _image(c, p, images)) % p
        return total
    if not x:
        return 0
    if x.denominator % p == 0:
        raise ZeroDivisionError
    return int(x.numerator) * pow(int(x.denominator), -1, p) % p
