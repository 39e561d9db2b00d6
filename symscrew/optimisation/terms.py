"""User expressions of a cost or bound, on CasADi expressions.

text --parser of descriptions--> SymPy tree --node by node--> CasADi;  nothing is evaluated as code
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import casadi as ca
import sympy

from symscrew.description import parse
from symscrew.errors import DescriptionError

UNARY: Mapping[str, Callable[[Any], Any]] = {
    "sin": ca.sin, "cos": ca.cos, "tan": ca.tan, "asin": ca.asin, "acos": ca.acos, "atan": ca.atan, "exp": ca.exp,
    "Abs": ca.fabs, "cot": lambda x: 1 / ca.tan(x),
}  # fmt: skip


def expression(text: str, names: Mapping[str, Any], *, where: str) -> ca.SX:
    """The CasADi expression of a text in the given names."""
    symbols = {name: sympy.Symbol(name, real=True) for name in names}
    parsed = parse(text, symbols, where=where)
    return ca.SX(_made(parsed, {symbols[name]: value for name, value in names.items()}, where))


def _made(node: sympy.Expr, values: Mapping[sympy.Symbol, Any], where: str) -> Any:
    if node in values:
        return ca.SX(values[node])
    if not node.free_symbols:
        return ca.SX(float(node))
    args = [_made(arg, values, where) for arg in node.args]
    if node.is_Add or node.is_Mul:
        total = args[0]
        for arg in args[1:]:
            total = total + arg if node.is_Add else total * arg
        return total
    if node.is_Pow:
        exponent = node.args[1]
        if exponent == sympy.Rational(1, 2):
            return ca.sqrt(args[0])
        if exponent.is_Integer and 0 < int(exponent) <= 4:
            product = args[0]
            for _ in range(int(exponent) - 1):
                product = product * args[0]
            return product
        return args[0] ** args[1]
    kind = type(node).__name__
    if kind in UNARY:
        return UNARY[kind](args[0])
    if kind == "atan2":
        return ca.atan2(*args)
    raise DescriptionError(f"{where}: the function {kind} cannot stand in a cost")
