"""Exact numbers in sixty digits: each part of an expression is evaluated once, however many expressions it is in.

    cos(2 pi/9), 3/5 cos(2 pi/9), sqrt(17/25 - 6/5 cos(2 pi/9)) ...  --lowest parts first, each once-->  60 digits

SymPy's own evaluation begins anew for every expression, and raises its precision where terms cancel. Here more digits
are carried than are asked for, and what is lost of them is counted: where that is too much, or an operation is not
known, SymPy is asked.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import mpmath
import sympy

DIGITS = 60  # as many as the constants of the tape have
PRECISION = mpmath.libmp.dps_to_prec(DIGITS)  # bits of these
GUARD = 80  # bits more that are carried
LOST = 48  # of which so many may be lost: the others cover roundings, one of each operation
KEPT = 8192  # numbers; descriptions repeat lengths and angles

_CONTEXT = mpmath.mp.clone()
_CONTEXT.prec = PRECISION + GUARD
Digits = tuple[Any, int]
"""A number, and how many bits less than those carried are right of it."""


@lru_cache(maxsize=KEPT)
def sixty_digits(expression: sympy.Expr) -> sympy.Expr:
    """A constant expression with as many digits as the tape's constants."""
    found = _digits(expression)
    if found is None or found[1] > LOST:
        return sympy.N(expression, DIGITS)
    return sympy.Float._new(mpmath.libmp.mpf_pos(found[0]._mpf_, PRECISION, "n"), PRECISION)


@lru_cache(maxsize=KEPT)
def _digits(expression: sympy.Expr) -> Digits | None:
    """The number; None where SymPy must be asked."""
    if expression.is_Rational:
        return _CONTEXT.mpf(int(expression.p)) / int(expression.q), 0
    if expression is sympy.pi:
        return +_CONTEXT.pi, 0
    operation = OPERATIONS.get(type(expression))
    if operation is None:
        return None
    parts = [_digits(part) for part in expression.args]
    known = [part for part in parts if part is not None]
    return operation(expression, known) if len(known) == len(parts) else None


def _size(number: Any) -> int:
    """The least power of two above a number that is not 0."""
    return int(_CONTEXT.mag(number))


def _sum(_: sympy.Expr, terms: list[Digits]) -> Digits | None:
    total = _CONTEXT.fsum(term for term, _ in terms)
    if not total:  # every digit is lost
        return None
    worst = max(_size(term) + lost for term, lost in terms if term)
    return total, max(0, worst - _size(total)) + len(terms).bit_length()


def _product(_: sympy.Expr, factors: list[Digits]) -> Digits:
    return _CONTEXT.fprod(factor for factor, _ in factors), sum(lost + 1 for _, lost in factors)


def _power(expression: sympy.Expr, parts: list[Digits]) -> Digits | None:
    (base, lost), exponent = parts[0], expression.args[1]
    if not exponent.is_Rational or not base or (base < 0 and exponent.q != 1):
        return None
    p, q = int(exponent.p), int(exponent.q)
    root = base if q == 1 else _CONTEXT.sqrt(base) if q == 2 else _CONTEXT.root(base, q)
    return root**p, lost + abs(p).bit_length() + 1


def _exponential(_: sympy.Expr, parts: list[Digits]) -> Digits:
    ((x, lost),) = parts
    return _CONTEXT.exp(x), max(0, lost + (_size(x) if x else 0)) + 1


def _absolute(_: sympy.Expr, parts: list[Digits]) -> Digits:
    ((x, lost),) = parts
    return abs(x), lost


def _turn(function: Callable[[Any], Any]) -> Callable[[sympy.Expr, list[Digits]], Digits | None]:
    """Sine and cosine: near a zero as much is lost as the angle is larger than the result."""

    def turned(_: sympy.Expr, parts: list[Digits]) -> Digits | None:
        ((x, lost),) = parts
        value = function(x)
        return (value, max(0, lost + _size(x) - _size(value)) + 1) if x and value else None

    return turned


def _arc(_: sympy.Expr, parts: list[Digits]) -> Digits:
    ((x, lost),) = parts
    return _CONTEXT.atan(x), lost + 1


OPERATIONS: dict[type, Callable[[sympy.Expr, list[Digits]], Digits | None]] = {
    sympy.Add: _sum,
    sympy.Mul: _product,
    sympy.Pow: _power,
    sympy.exp: _exponential,
    sympy.Abs: _absolute,
    sympy.sin: _turn(_CONTEXT.sin),
    sympy.cos: _turn(_CONTEXT.cos),
    sympy.atan: _arc,
}
"""How much is lost of what: bits of the operands' own loss, of cancellation, and a rounding of the operation's."""
