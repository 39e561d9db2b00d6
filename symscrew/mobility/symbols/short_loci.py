"""Conditions as they are read: the expression without what cannot vanish, equal ones once.

    polynomial that is zero at a degeneration --condition--> without constant factors and powers; None: it never is

A constant factor, as the sqrt(3) of sqrt(3) H, and a power, as that of H^2, say nothing about where it is zero.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy

from symscrew.mobility.symbols.locus import Locus


def condition(expression: sympy.Expr) -> sympy.Expr | None:
    """What is zero exactly where `expression` is, shorter; None where it is a constant that is not zero."""
    if expression == 0:
        return expression
    if not expression.free_symbols:
        return None
    factors = sympy.Mul.make_args(sympy.factor_terms(expression, radical=True))
    kept = []
    for factor in factors:
        base, exponent = factor.as_base_exp()
        if factor.free_symbols:
            kept.append(base if exponent.is_Integer and exponent.is_positive else factor)
    return sympy.Mul(*kept)


def conditions(loci: Iterable[Locus]) -> tuple[Locus, ...]:
    """The loci with their conditions, without those that never hold and those said before."""
    found: dict[tuple[str, str, str], Locus] = {}
    for locus in loci:
        short = condition(locus.expression)
        if short is not None:
            found.setdefault((str(short), locus.where, locus.meaning), replace(locus, expression=short))
    return tuple(found.values())
