"""Ranks over exact fields: numbers whose zero is decidable, and what the results say of their method."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import numpy as np
import pytest
import sympy
from mpmath.libmp import from_man_exp
from support.marks import slow
from support.reference_mechanisms import ENTRIES, build
from support.rewritten import four_bar_with
from sympy import Rational, cos, pi, sin, sqrt

from symscrew import catalogue
from symscrew.algebra import CONTEXT
from symscrew.mobility.analysis import analyse_mobility
from symscrew.mobility.screw_systems import _rounded, eliminate
from symscrew.mobility.symbols.common_divisor import divisor
from symscrew.mobility.symbols.exact_field import Field
from symscrew.mobility.symbols.exact_numbers import NotDecidableError, Number, expression, inverse, value
from symscrew.mobility.symbols.exact_ranks import exact_rank, null_vectors, rank_modulo

ZEROS = (
    sqrt(2) * sqrt(3) - sqrt(6),
    sqrt(5 + 2 * sqrt(6)) - sqrt(2) - sqrt(3),
    2 * sqrt(2 + sqrt(3)) - sqrt(6) - sqrt(2),
    sin(pi / 9) * sin(2 * pi / 9) * sin(4 * pi / 9) - sqrt(3) / 8,
    sqrt(1 + cos(pi / 9)) - sqrt(2) * cos(pi / 18),
    sqrt(Rational(27, 100)) - 3 * sqrt(3) / 10,
    1 / (sqrt(2) + cos(pi / 7)) - (cos(pi / 7) - sqrt(2)) / (cos(pi / 7) ** 2 - 2),
)


@pytest.mark.parametrize("zero", ZEROS, ids=str)
def test_zero_is_found(zero: sympy.Expr) -> None:
    assert not Field([zero]).read(zero)
    assert Field([zero]).read(zero + Rational(1, 10**40))


def test_numbers_keep_their_value() -> None:
    given = [sqrt(3) / 10, sqrt(5 - sqrt(5)) * cos(pi / 7), 1 / (1 + sqrt(2) + sqrt(3)), Rational(3, 7)]
    field = Field(given)
    for e in given:
        number = field.read(e)
        assert abs(value(number) - sympy.N(e, 60)) < 1e-50
        assert abs(sympy.N(expression(number) - e, 40)) < 1e-35
        assert number * inverse(number) == 1


@pytest.mark.parametrize("e", [sympy.cos(1), sympy.exp(1), sqrt(-2)], ids=str)
def test_no_field_is_said_so(e: sympy.Expr) -> None:
    with pytest.raises(NotDecidableError):
        Field([e]).read(e)


def test_directions_need_fewer_roots() -> None:
    field = Field()
    direction = field.direction([3 / sqrt(14), 1 / sqrt(14), 2 / sqrt(14)])
    assert direction == (1, Fraction(1, 3), Fraction(2, 3)) and field.degree == 1


def test_ranks_over_a_field() -> None:
    """(1, sqrt 2; sqrt 2, 2) is singular; 1e-40 off it is not, and no tolerance is in play."""
    field = Field()
    root = field.read(sqrt(2))
    singular = [[Fraction(1), root], [root, Fraction(2)]]
    regular = [[Fraction(1), root], [root, 2 + Fraction(1, 10**40)]]
    assert (exact_rank(singular, field), exact_rank(regular, field)) == (1, 2)
    assert rank_modulo(singular, field) == 1
    (vector,) = null_vectors(singular, 2, field)
    assert all(not (row[0] * vector[0] + row[1] * vector[1]) for row in singular)


@pytest.mark.parametrize("seed", range(6))
def test_random_ranks_agree_with_their_factors(seed: int) -> None:
    """A product of an n x r and an r x m matrix over Q(sqrt 2, sqrt 3) has rank r."""
    random = np.random.default_rng(seed)
    field = Field()
    roots = [Fraction(1), field.read(sqrt(2)), field.read(sqrt(3))]
    r = int(random.integers(1, 5))

    def matrix(n: int, m: int) -> list[list[object]]:
        return [
            [sum((Fraction(int(random.integers(-3, 4))) * g for g in roots), Fraction(0)) for _ in range(m)]
            for _ in range(n)
        ]

    a, b = matrix(6, r), matrix(r, 7)
    product = [[sum((x * b[k][j] for k, x in enumerate(row)), Fraction(0)) for j in range(7)] for row in a]  # type: ignore[operator]
    assert exact_rank(product, field) == rank_modulo(product, field) == r


@pytest.mark.parametrize("name", [*catalogue.names()])
def test_catalogue_is_exact(name: str) -> None:
    found = analyse_mobility(catalogue.load(name)).decisions
    assert found.exact and found.method.startswith("exact: "), found.method


@pytest.mark.parametrize(
    "name", ["planar_3rrr-type1", "3rps-mode_transition", "bennett_perturbed", slow("double_watt_cusp")]
)
def test_reference_is_exact(name: str) -> None:
    assert analyse_mobility(build(ENTRIES[name])).decisions.exact


def test_rounded_decimals_are_certified_numerically() -> None:
    """The Schatz linkage in 60 decimals: as exact numbers it is rigid by 1e-60; the result says how it decided."""
    found = analyse_mobility(build(ENTRIES["schatz_turbula"]))
    assert found.dof == 1 and found.method.startswith("certified numeric: ")
    assert "taken for rounding" in found.method and found.decisions.singular_values[1] < 1e-40


def test_almost_parallel_axes_are_named() -> None:
    off, cosine = "0.0000000000010000000000000000000000000000", "0.9999999999999999999999995000000000000000"
    found = four_bar_with([off, "0", cosine])
    assert found.dof == 0 and found.decisions.exact
    assert "axes of joints B and C are 1.0e-12 rad apart: not parallel" in found.nearly_parallel
    assert four_bar_with(["0", "0", "1"]).nearly_parallel == ()


def test_normal_forms_are_unique() -> None:
    field = Field()
    a, b = field.read(sqrt(2)), field.read(sqrt(3))
    assert isinstance(a * b, Number) and (a + b) * (b - a) == 1 and a * b == field.read(sqrt(6))


def test_elimination_rounds_as_mpmath_does() -> None:
    """Ties go to the even digit, of either sign: the numbers are those of the library, to the last digit."""
    random = Random(3)
    for m in (
        0b1011,
        0b1001,
        0b1101,
        0b10111,
        0b1000,
        0b11111,
        *(random.getrandbits(400) | 1 << 400 for _ in range(50)),
    ):
        for sign in (1, -1):
            digits = 3 if m < 64 else 200
            assert from_man_exp(*_rounded(sign * m, 5, digits)) == from_man_exp(sign * m, 5, digits, "n")
    third, one = CONTEXT.mpf(1) / 3, CONTEXT.one
    found = eliminate([[3 * third, third, CONTEXT.zero], [one, third, third * third]], 3)
    assert found.pivots == (0, 2) and found.rows[0][1] == third and found.rows[1][:2] == (0, 0)


def test_common_divisors_in_few_of_the_generators_are_those_of_sympy() -> None:
    """Also up to its unit: of what has only some generators in common, of one term, and where nothing is shared."""
    _, *gens = sympy.polys.rings.ring("w,c,s,a,b,h", sympy.QQ)
    w, c, s, a, b, h = gens
    length, many = 4 * h**2 + 9 * (a - b) ** 2, (w * c + 3 * s * a - c * b / 2) * (s + h)
    tops = [many * length**2, many * length * (a + b), many, 2 * a * many, length, (w + c) * (a + b) / 3, w + c]
    bottoms = [length, 2 * length**3 * (a + b), 6 * a * length, 4 * a, length * h - length * b, a + b, s + h]
    for top in tops:
        for bottom in bottoms:
            assert divisor(top, bottom) == top.gcd(bottom), (top, bottom)
