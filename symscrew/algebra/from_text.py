"""Expressions of a description on the tape: from SymPy's tree of the grammar to nodes.

"2*length**2 + atan(gap)"  --description--> SymPy --expression_node--> add (mul 2 (mul l l)) (atan2 gap 1)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy

from symscrew.algebra.nodes import Node, Tape

MOST_FACTORS = 64  # of a power, written out as products; higher ones, an error, are typing errors or overflow anyway


def expression_node(tape: Tape, expression: sympy.Expr, symbols: Mapping[sympy.Symbol, Node]) -> Node:
    """A SymPy expression of the description as a node; `symbols` gives the run-time parameters.

    Raises:
        ValueError: a function or a power that the grammar does not have.
    """
    if not expression.free_symbols:
        return tape.constant(expression)
    if isinstance(expression, sympy.Symbol):
        return symbols[expression]
    args = [expression_node(tape, arg, symbols) for arg in expression.args]
    if expression.is_Add or expression.is_Mul:
        combine = tape.add if expression.is_Add else tape.mul
        total = args[0]
        for arg in args[1:]:
            total = combine(total, arg)
        return total
    if expression.is_Pow:
        return _power(tape, args[0], expression.exp)
    return _named(tape, type(expression).__name__, args)


def _named(tape: Tape, name: str, args: Sequence[Node]) -> Node:
    """A function of the grammar, or of its derivatives, in terms of the tape's operations."""
    x = args[0]
    if name in ("sqrt", "sin", "cos", "tan", "exp", "atan2"):
        return tape.function(name, *args)
    if name == "Abs":
        return tape.function("abs", x)
    if name == "cot":
        return tape.reciprocal(tape.function("tan", x))
    if name == "atan":
        return tape.function("atan2", x, tape.one)
    if name in ("asin", "acos"):
        other = tape.sqrt(tape.one - x * x)
        return tape.function("atan2", *((x, other) if name == "asin" else (other, x)))
    if name == "sign":
        positive = tape.function("select", tape.function("less", tape.zero, x), tape.one, tape.zero)
        return tape.function("select", tape.function("less", x, tape.zero), -tape.one, positive)
    raise ValueError(f"expected functions of the grammar, got {name}")


def _power(tape: Tape, base: Node, exponent: sympy.Expr) -> Node:
    if exponent.is_Rational and exponent.q in (1, 2) and abs(exponent.p) <= MOST_FACTORS:
        factor = base if exponent.q == 1 else tape.sqrt(base)
        result = factor
        for _ in range(abs(exponent.p) - 1):
            result = tape.mul(result, factor)
        return result if exponent.p > 0 else tape.reciprocal(result)
    raise ValueError(
        f"expected an integer or half-integer power up to {MOST_FACTORS} of a run-time parameter, got {exponent}"
    )
