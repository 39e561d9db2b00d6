"""How many zeros meet in one, counted exactly: against multiplicities that are known."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from symscrew.assembly.exact_slots import Series, product
from symscrew.assembly.meeting_zeros import meeting_zeros

Polynomial = dict[tuple[int, ...], int]


class Polynomials:
    """Rows of polynomials, in place of a mechanism's."""

    def __init__(self, *rows: Polynomial) -> None:
        self.rows = rows

    @staticmethod
    def work(terms: int) -> int:
        return 0

    def values(self, z: Any, order: int) -> list[Series]:
        found = []
        for row in self.rows:
            total: Series = {}
            for exponents, factor in row.items():
                term: Series = {(0,) * len(next(iter(next(s for s in z if s)))): Fraction(factor)}
                for place, power in enumerate(exponents):
                    for _ in range(power):
                        term = product(term, z[place], order)
                for key, c in term.items():
                    total[key] = total.get(key, Fraction(0)) + c
            found.append({key: c for key, c in total.items() if c})
        return found


@pytest.mark.parametrize(
    ("rows", "meeting", "isolated"),
    [
        (({(1, 0): 1, (0, 2): 3}, {(0, 1): 2, (2, 0): 1}), 1, True),  # x + 3 y^2, 2 y + x^2
        (({(1, 0): 1, (0, 2): -1}, {(0, 3): 1}), 3, True),  # x - y^2, y^3
        (({(1, 0): 1, (0, 1): -1}, {(2, 0): 1, (0, 2): -1}), 9, False),  # a line of zeros: never an end
        (({(2, 0): 1}, {(0, 2): 1}), 4, True),
        (({(2, 0): 1, (0, 3): -1}, {(1, 1): 1}), 5, True),  # x^2 - y^3, x y
        (({(2, 0): 1, (1, 1): 2}, {(0, 2): 1, (1, 1): -1}), 4, True),  # two forms without a common factor
        (({(2, 0): 1, (0, 2): -1}, {(2, 0): 2, (0, 2): -2}), 13, False),  # x^2 = y^2: two lines
        (({(2, 0): 1}, {(1, 1): 1}, {(0, 2): 1}), 3, True),  # more rows than unknowns
        (({(2, 0, 0): 1, (0, 1, 1): 1}, {(0, 2, 0): 1, (1, 0, 1): 1}, {(0, 0, 2): 1, (1, 1, 0): 1}), 8, True),
    ],
)  # fmt: skip
def test_multiplicities_of_textbooks(rows: tuple[Polynomial, ...], meeting: int, isolated: bool) -> None:
    """All zeros at the origin, whose coordinates are 0; the first coordinate is 1 by choice and in no equation."""
    count = len(next(iter(rows[0])))
    shifted = [{(0, *key): c for key, c in row.items()} for row in rows]
    at = [Fraction(1), *[Fraction(0)] * count]
    found = meeting_zeros(Polynomials(*shifted), at, list(range(1, count + 1)))  # type: ignore[arg-type]
    assert found == (meeting, isolated)
