"""Times that decompositions may take, and closures in several roots over one."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy

from symscrew.cli.parser import main
from symscrew.mobility.components import ClosureEquations, NotAlgebraicError, algebra_answer
from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.counted_poses import Counted
from symscrew.mobility.components.exact_parts import _named
from symscrew.mobility.components.one_root import over_one_root
from symscrew.mobility.components.polynomials import Polynomial
from symscrew.mobility.symbols import Field, exact_value


def test_time_runs_out_and_is_never_less_than_none() -> None:
    allowed = AllowedTime(0.05)
    assert 0 < allowed.left < 0.051 and allowed.at_most(0.01) <= 0.01 and not allowed.over()
    while not allowed.over():
        sum(range(1000))
    assert allowed.left == 0 == allowed.at_most(1.0) and allowed.over(0.5)


def test_without_time_no_program_is_begun() -> None:
    assert algebra_answer("this is no program; quit;", 0.0) in (None, ("", False))


@pytest.mark.parametrize("text", ["0", "-3", "nan"])
def test_no_time_is_refused(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mobility", "four_bar", "--components", f"--seconds={text}"]) == 2
    assert "--seconds: expected seconds above 0" in capsys.readouterr().err


def closure(*squares: int) -> ClosureEquations:
    """x times each root, plus all roots' product."""
    field = Field()
    roots = [field.read(sympy.sqrt(n)) for n in squares]
    whole = roots[0]
    for root in roots[1:]:
        whole = whole * root
    given = tuple(Polynomial({(1,): root + Fraction(1, 3), (0,): whole}) for root in roots)
    return ClosureEquations(("x",), given, (roots[0],), (), (), field, "a test")


@pytest.mark.parametrize("squares", [(2,), (2, 3), (115, 3), (2, 3, 5)])
def test_numbers_in_several_roots_are_the_same_in_one(squares: tuple[int, ...]) -> None:
    given = closure(*squares)
    found = over_one_root(given)
    (root,) = found.field.generators
    assert root.degree == 2 ** len(squares) and (found is given) == (len(squares) == 1)
    for one, two in zip(given.equations, found.equations, strict=True):
        assert all(abs(exact_value(one.terms[key]) - exact_value(two.terms[key])) < 1e-50 for key in one.terms)
    assert abs(exact_value(found.reference[0]) - exact_value(given.reference[0])) < 1e-50
    powers = [exact_value(c) * root.value**k for k, c in enumerate((*root.modulus, Fraction(1)))]
    assert abs(sum(powers)) < 1e-40 * max(map(abs, powers))
    name = _named(found, "a^2*v1")
    assert abs(sympy.N(sympy.sympify(name.replace("^", "**")).coeff(sympy.Symbol("x")) - root.value**2, 30)) < 1e-20


def test_too_many_roots_are_refused() -> None:
    with pytest.raises(NotAlgebraicError, match="of degree 16: expected 8 at most"):
        over_one_root(closure(2, 3, 5, 7))


def test_sums_of_degrees_are_those_that_all_primes_leave() -> None:
    found = Counted(0, frozenset(), 0).further([2, 2, 4]).further([1, 7])
    assert found.total == 8 and found.primes == 2 and found.sums == {0, 8}
