"""The grammar of expressions: exact values, and hostile text ends in one clear error."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy
from support.work import calls_at_most

from symscrew.description.expressions import exact, numeric, parse, to_text
from symscrew.errors import DescriptionError

R = sympy.Symbol("R", real=True)
phi = sympy.Symbol("phi", real=True)
NAMES = {"R": R, "phi": phi}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("3*sqrt(3)/10", 3 * sympy.sqrt(3) / 10),
        ("0.1", sympy.Rational(1, 10)),
        ("1e-3", sympy.Rational(1, 1000)),
        (".5 + 2.", sympy.Rational(5, 2)),
        ("-2^2", -4),
        ("2^-3", sympy.Rational(1, 8)),
        ("2^3^2", 512),
        ("2**(1/2)", sympy.sqrt(2)),
        ("1 - 2 - 3", -4),
        ("8/4/2", 1),
        ("--3", 3),
        ("atan2(1, -1)", 3 * sympy.pi / 4),
        ("acos(1/2) + asin(1) + atan(1)", sympy.pi / 3 + sympy.pi / 2 + sympy.pi / 4),
        ("tan(pi/3)", sympy.sqrt(3)),
        ("exp(0)", 1),
        ("R*cos(phi)", R * sympy.cos(phi)),
        ("0." + "3" * 200, sympy.Rational(int("3" * 200), 10**200)),
    ],
)
def test_parse_gives_the_exact_value(text, value):
    assert parse(text, NAMES) == value


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (7, 7),
        (0.1, sympy.Rational(1, 10)),
        (1e-7, sympy.Rational(1, 10**7)),
        (np.float64(0.25), sympy.Rational(1, 4)),
        (np.int64(3), 3),
        (Fraction(1, 3), sympy.Rational(1, 3)),
        (Decimal("0.12345678901234567890123456789"), sympy.Rational(12345678901234567890123456789, 10**29)),
        (sympy.sqrt(2) / 2, sympy.sqrt(2) / 2),
    ],
)
def test_python_numbers_become_exact(value, expected):
    assert exact(value) == expected


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "got an empty text"),
        ("1 2", "expected an operator or the end, got '2'"),
        ("(1", r"expected '\)', got 'the end'"),
        ("1 +", r"expected a number, a name or '\(', got the end"),
        ("cos(1, 2)", "cos takes 1 argument, got 2"),
        ("atan2(1)", "atan2 takes 2 arguments, got 1"),
        ("Rr*2", "unknown name 'Rr'; did you mean 'R'"),
        ("cso(phi)", r"unknown name 'cso'; did you mean .*'cos'"),
        ("1/0", "division by zero"),
        ("1/(1-1)", "division by zero"),
        ("0^-1", "division by zero"),
        ("tan(pi/2)", "expected a finite number"),
        ("sqrt(-1)", "expected a real number"),
        ("nan", "unknown name 'nan'"),
        ("inf", "unknown name 'inf'"),
        ("9**9**9**9", "expected an exponent"),
        ("9**9**9", "expected an exponent that is a fraction with parts up to 64"),
        ("((((9^60)^60)^60)^60)", "too large or too long"),
        ("(((1+sqrt(2))^64)^64)^64", "expected exponents up to 64"),
        ("exp(exp(exp(100)))", "expected an argument of exp between"),
        ("2^R", "expected an exponent"),
        ("1e999999999", "too large or too long"),
        ("1e400*1e400*1e400*1e400*1e400*1e400*1e400*1e400*1e400*1e400*1e400", "too large or too long"),
        ("(" * 3000 + "1" + ")" * 1000, "nested more than 50 deep"),
        ("2^" * 1000 + "1", "nested more than 50 deep"),
        ("1+" * 5000 + "1", "has 10001 characters; at most 5000"),
        ("1" * 4400, "too large or too long"),
        ("__import__('os').system('x')", "cannot read"),
        ("(lambda: 0)()", "cannot read"),
        ("().__class__", r"expected a number, a name or '\('|cannot read"),
        ("[x for x in (1,)]", "cannot read"),
        ("R.free_symbols", "cannot read"),
        ("open(R)", "unknown name 'open'"),
        ("1;2", "cannot read"),
        ("٣", "cannot read"),
    ],
)
def test_bad_text_is_refused_at_once(text, message):
    with calls_at_most(200_000), pytest.raises(DescriptionError, match=message):
        parse(text, NAMES, where="joints.knee.point[0]")


def test_message_says_where():
    with pytest.raises(DescriptionError, match=r"^joints\.knee\.point\[0\]: .* \(in '1 \+'\)"):
        parse("1 +", where="joints.knee.point[0]")


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (True, "got the truth value True"),
        (float("nan"), "expected a finite number, got nan"),
        (float("inf"), "expected a finite number, got inf"),
        (Decimal("-Infinity"), "expected a finite number"),
        (None, "expected a number or a text"),
        ([1], "expected a number or a text"),
        pytest.param(10**6000, "too large", id="many digits"),
        (sympy.Float(0.1), "floating-point numbers in it"),
        (sympy.Symbol("Rx"), "unknown name 'Rx'"),
        (sympy.oo, "expected a finite number"),
        (1 + sympy.I, "expected a real number"),
    ],
)
def test_bad_values_are_refused(value, message):
    with pytest.raises(DescriptionError, match=message):
        exact(value, NAMES)


def test_numeric_has_sixty_digits_and_refuses_complex_values():
    assert abs(numeric(sympy.sqrt(2)) ** 2 - 2) < 1e-58
    with pytest.raises(DescriptionError, match="expected a real finite number"):
        numeric(parse("acos(2)"))


@pytest.mark.parametrize(
    "text",
    [
        "-(R-0.15*(R-phi)/sqrt((R-phi)^2+2))", "R*(R+1)*(phi+2)*3/7", "-(R+1)*(phi+2)", "1/(3*R)",
        "(R+phi)/R*3/4",
        "exp(1)", "sqrt(R^2)", "2^(1/3)*R/5", "-1/2", "1/R^2", "sqrt(2-sqrt(2))/2", "cos(pi/18)*R", "-R/3",
        "tan(R+pi/2)", "atan2(R, phi)", "(R-phi)^-3/2", "abs(R-phi)", "(1+R)^(-1/2)",
    ],
)  # fmt: skip
def test_text_reads_back_as_the_same_expression(text):
    value = parse(text, NAMES)
    assert parse(to_text(value), NAMES) == value


def test_random_expressions_read_back():
    rng = np.random.default_rng(7)

    def grow(depth):
        if depth == 0:
            return str(rng.choice(["R", "phi", "2", "1/3", "0.7", "sqrt(3)", "pi", "5"]))
        kind = rng.integers(6)
        a, b = grow(depth - 1), grow(depth - 1)
        return [f"({a}+{b})", f"({a}-{b})", f"({a})*({b})", f"({a})/({b}+11)", f"cos({a})", f"({a})^2"][kind]

    for _ in range(200):
        value = parse(grow(3), NAMES)
        assert parse(to_text(value), NAMES) == value
