"""What expressions of a description are made of: parameters, angles and square roots, inner ones last.

sin(theta) * sqrt(r^2 + H^2)  -->  parameters H, r, theta; angle theta; root sqrt(r^2 + H^2)
"""

from __future__ import annotations

from collections.abc import Iterable

import sympy


def atoms_of(
    expressions: Iterable[sympy.Expr],
) -> tuple[list[sympy.Symbol], list[sympy.Expr], list[sympy.Expr]]:
    """(parameters, angles, square roots, inner ones last) in the expressions, sorted by name."""
    parameters: set[sympy.Symbol] = set()
    angles: set[sympy.Expr] = set()
    roots: set[sympy.Expr] = set()
    stack = list(expressions)
    while stack:
        e = stack.pop()
        if e.is_Symbol:
            parameters.add(e)
        elif isinstance(e, (sympy.sin, sympy.cos)):
            angles.add(e.args[0])
            parameters |= e.args[0].free_symbols
        elif e.is_Pow and e.exp.is_Rational and e.exp.q == 2:
            roots.add(sympy.sqrt(e.base))
            stack.append(e.base)
        else:
            stack += e.args
    outer_first = sorted(roots, key=lambda root: (-_nesting(root), str(root)))
    return sorted(parameters, key=str), sorted(angles, key=str), outer_first


def _nesting(e: sympy.Expr) -> int:
    own = int(e.is_Pow and e.exp.is_Rational and e.exp.q == 2)
    return own + max((_nesting(a) for a in e.args), default=0)
