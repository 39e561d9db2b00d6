"""Sixty digits of exact numbers, part by part, are those of SymPy's own evaluation."""

from __future__ import annotations

import random

import pytest
import sympy

from symscrew.description import digits, exact, sixty_digits
from symscrew.description.digits import DIGITS

HALF_AN_ULP = sympy.Float(10, DIGITS) ** -DIGITS

TAME = [
    "sqrt(rb^2 + 9/25 - 6/5*rb*cos(2*pi/9))",
    "cos(7*pi/9)*sin(-10*pi/180)/sqrt(1 + tan(1))",
    "atan(3/7)^3/(1 - exp(-2))",
    "abs(-sqrt(3)/10)^(-5)",
    "5^(1/3) - 1.70997594667669698935310887254386010986805511054305492438286",
]
HIDDEN = [  # zero, and cancelling nearly all, where more digits are needed than are carried
    "sqrt(2)*sqrt(3) - sqrt(6)*(sin(1)^2 + cos(1)^2)",
    "sqrt(10^40 + 1) - 10^20",
    "sin(1)^2 + cos(1)^2 - 1 + 1e-70",
    "cos(pi/2 - 1e-40) - 1e-40",
]


def expressions() -> list[sympy.Expr]:
    """Those above, and sums of products of random parts."""
    draw = random.Random(3)
    parts = ["sqrt(7)", "cos(3*pi/11)", "sin(1/3)", "2/3", "-0.4", "pi", "exp(1/5)", "atan(2)"]
    made = [
        " + ".join(
            f"{draw.randint(-9, 9)}*{draw.choice(parts)}^{draw.choice([1, 2, '(1/2)', '(-1)'])}*{draw.choice(parts)}"
            for _ in range(4)
        ).replace("(-0.4)^(1/2)", "0.4").replace("-0.4^", "0.4^")
        for _ in range(40)
    ]  # fmt: skip
    return [exact(text, {"rb": sympy.Rational(11, 10)}) for text in (*TAME, *HIDDEN, *made)]


def test_they_are_sympys_to_half_a_unit_in_the_last_place() -> None:
    for expression in expressions():
        found, expected = sixty_digits(expression), sympy.N(expression, DIGITS)
        assert type(found) is type(expected)
        if expected.is_zero or abs(expected) < sympy.Float(10, DIGITS) ** -100:  # what SymPy itself cannot tell from 0
            assert abs(found) < sympy.Float(10, DIGITS) ** -90
        else:
            assert found._prec == expected._prec
            assert abs(found - expected) <= 4 * HALF_AN_ULP * abs(expected)


@pytest.mark.parametrize("text", HIDDEN)
def test_where_digits_are_lost_sympy_is_asked(text: str) -> None:
    found = digits._digits(exact(text))
    assert found is None or found[1] > digits.LOST


@pytest.mark.parametrize("text", ["asin(1/2)", "acos(1/3)", "tan(1)", "sqrt(3)*acos(2/5)"])
def test_what_is_not_known_sympy_evaluates(text: str) -> None:
    assert sixty_digits(exact(text)) == sympy.N(exact(text), DIGITS)


def test_parts_are_evaluated_once() -> None:
    digits._digits.cache_clear()
    angle = sympy.cos(2 * sympy.pi / 9)
    sixty_digits(3 * angle + 5)
    before = digits._digits.cache_info().misses
    sixty_digits(3 * angle + 7)
    assert digits._digits.cache_info().misses - before == 2  # the sum, and the 7
