"""Products that are squares, found by sums modulo 2: beside every product, and where primes are deceived."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import combinations
from math import prod

import pytest

from symscrew.mobility.symbols.square_classes import FIRST_PRIMES, SquareClasses, is_square

LETTERS = "abcd"


def _square_among(members: list[tuple[Fraction, frozenset[str]]]) -> bool:
    """Whether a product of some of them is a square: every one of the 2^n is looked at."""
    for size in range(1, len(members) + 1):
        for some in combinations(members, size):
            even = all(sum(letter in odd for _, odd in some) % 2 == 0 for letter in LETTERS)
            if even and is_square(prod((number for number, _ in some), start=Fraction(1))):
                return True
    return False


def test_as_every_product_says() -> None:
    chosen, refused = random.Random(3), 0
    for _ in range(40):
        classes, kept = SquareClasses(), []
        for _ in range(7):
            number = Fraction(chosen.choice((-6, -2, -1, 1, 2, 3, 6, 10, 35, 97 * 101)), chosen.choice((1, 4, 5, 13)))
            member = number, frozenset(chosen.sample(LETTERS, chosen.randrange(3)))
            independent = not _square_among([*kept, member])
            assert classes.added(*member) is independent
            kept += [member] if independent else []
            refused += not independent
    assert 10 < refused < 270


def test_a_number_that_looks_like_a_square_for_every_first_prime() -> None:
    deceives = 1
    for p in SquareClasses()._primes:
        deceives *= p
    deceives = Fraction(1 + 8 * deceives)
    assert not is_square(deceives)
    assert len(SquareClasses()._primes) == FIRST_PRIMES
    classes = SquareClasses()
    assert classes.added(deceives, "a")
    assert classes.added(Fraction(1), "a")
    assert len(classes._primes) == FIRST_PRIMES + 1
    assert not classes.added(deceives * 9, "")
    assert classes.added(Fraction(-1), "")


@pytest.mark.parametrize("number", [Fraction(4, 9), Fraction(10**80), Fraction(0)])
def test_squares(number: Fraction) -> None:
    assert is_square(number)
    assert not is_square(-number - 1)
    assert not is_square(number + 2)


def test_forty_roots_have_no_product_looked_at() -> None:
    classes = SquareClasses()
    assert all(classes.added(Fraction(10**30 + k * k + k + 1, 10**15), ()) for k in range(40))
