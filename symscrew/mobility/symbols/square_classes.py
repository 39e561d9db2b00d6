"""Whether a product of some of the given polynomials is a square: linear algebra over two elements.

    3 (a + b), 5 (a + b), 15  -->  their product (15 (a + b))^2 is one;  2, 3, 5, 7 ...: of 2^n products, none

A polynomial is a square where every irreducible factor is there an even number of times and its number is the square
of a rational. Both are sums modulo 2: of powers of factors, and for a number of its sign, its power of a prime p and
whether what is left of it is a square modulo p (Legendre's symbol). A number that is none for some p is no square, so
that rows without a relation prove that no product is one; a relation names the one product that is looked at in full.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from fractions import Fraction
from math import isqrt, prod

import sympy

FIRST_PRIMES = 24
"""Primes to begin with: of numbers that are no squares one in 2^24 looks like one, and then the next prime that tells
is looked for. More cost time, fewer a search, neither changes an answer."""


class SquareClasses:
    """Polynomials no product of which is a square, as numbers and sets of irreducible factors with an odd power."""

    def __init__(self) -> None:
        self._kept: list[tuple[Fraction, frozenset[Hashable]]] = []
        self._primes = [int(p) for p in sympy.primerange(3, sympy.prime(FIRST_PRIMES + 1) + 1)]

    def added(self, number: Fraction, odd: Iterable[Hashable]) -> bool:
        """Whether number * (product of the factors) joins them; False, and nothing is kept: a product is a square."""
        members = [*self._kept, (number, frozenset(odd))]
        while (product := self._like_a_square(members)) is not None:
            if is_square(product):
                return False
            self._primes.append(next(p for p in _primes_after(self._primes[-1]) if not _square_modulo(product, p)))
        self._kept = members
        return True

    def _like_a_square(self, members: list[tuple[Fraction, frozenset[Hashable]]]) -> Fraction | None:
        """The number of a product with the last of them that looks like a square; None: there is none."""
        rows: list[tuple[Hashable, frozenset[Hashable], frozenset[int]]] = []
        for k, (number, odd) in enumerate(members):
            left, among = odd | frozenset(self._seen(number)), frozenset({k})
            for lead, row, others in rows:  # no row has the lead of one before it, so once through them is enough
                if lead in left:
                    left, among = left ^ row, among ^ others
            if not left:
                return prod((members[i][0] for i in among), start=Fraction(1))
            rows.append((next(iter(left)), left, among))
        return None

    def _seen(self, number: Fraction) -> Iterator[tuple[str, int]]:
        """What is odd of a number: its sign, its power of a prime, what is left of it modulo that prime."""
        if number < 0:
            yield "sign", 0
        for p in self._primes:
            power, left = _without_prime(number, p)
            if power % 2:
                yield "power", p
            if not _square_modulo(left, p):
                yield "rest", p


def is_square(number: Fraction) -> bool:
    """Of a rational number."""
    parts = (number.numerator, number.denominator)
    return number >= 0 and all(isqrt(part) ** 2 == part for part in parts)


def _without_prime(number: Fraction, p: int) -> tuple[int, Fraction]:
    power = 0
    while number.numerator % p == 0:
        number, power = number / p, power + 1
    while number.denominator % p == 0:
        number, power = number * p, power - 1
    return power, number


def _square_modulo(number: Fraction, p: int) -> bool:
    """Legendre's symbol is 1; a number with the prime in it counts as a square."""
    return pow(number.numerator * number.denominator, (p - 1) // 2, p) in (0, 1)


def _primes_after(p: int) -> Iterator[int]:
    while True:
        p = int(sympy.nextprime(p))
        yield p
