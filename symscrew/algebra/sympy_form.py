"""Nodes back as SymPy expressions: what people read of a model.

add (mul 2 (symbol x)) (symbol y)  --sympy_expression-->  2 x + y
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy

from symscrew.algebra.nodes import Node
from symscrew.algebra.operations import CONTEXT, IN_SYMPY


def sympy_expression(node: Node, named: Mapping[Node, sympy.Symbol] | None = None) -> sympy.Expr:
    """`node` as a SymPy expression of the inputs, stopping at the nodes in `named`.

    Constants are as they were given, or as they were folded from such: exact where the description is.
    """
    stop = {n.index: s for n, s in (named or {}).items()}
    done: dict[int, sympy.Expr] = {}
    stack = [node]
    while stack:
        current = stack[-1]
        if current.index in done:
            stack.pop()
            continue
        if current.index in stop:
            done[current.index] = stop[current.index]
            continue
        missing = [a for a in _definition(current)[1] if a.index not in done]
        if missing:
            stack.extend(missing)
        else:
            done[current.index] = _built(current, done)
    return done[node.index]


def _definition(node: Node) -> tuple[Any, tuple[Node, ...]]:
    """The operation and operands that define a node; a folded constant keeps how it was folded."""
    if node.op == "symbol":
        return node.op, ()
    if node.op == "const":
        how, sign = node.args[0], 1
        while isinstance(how, tuple) and how[0] == "neg_of":
            how, sign = how[1], -sign
        if isinstance(how, tuple):
            return (how[0], sign), tuple(how[1:])
        return (how, sign), ()
    return node.op, node.args


def _built(node: Node, done: Mapping[int, sympy.Expr]) -> sympy.Expr:
    op, operands = _definition(node)
    sign = 1
    if node.op == "symbol":
        return node.args[0].sympy
    if node.op == "const":
        op, sign = op
        if op is None:
            integer = CONTEXT.nint(node.value)
            return sympy.Integer(int(integer)) if integer == node.value else sympy.Float(node.value, 30)
        if isinstance(op, sympy.Basic):
            return sign * op
    return sign * IN_SYMPY[op](*(done[a.index] for a in operands))
