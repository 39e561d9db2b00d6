"""Functions that look whether what they are given is of the mechanism: named variants, `<function>_checked`.

A function of q, v or a takes more numbers than the mechanism has freedoms, and takes for granted that the loops are
closed, that the rates keep them closed and that the accelerations do. Its variant computes how far they open, and
fails with the status "not on the mechanism" where that is more than rounding: see `symscrew.functions.closing.CLOSED`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symscrew.algebra import Node
from symscrew.functions.closing import closed, squares
from symscrew.functions.ports import rotations
from symscrew.kinematics import Row, System
from symscrew.program import Function, NodeLimit

OPEN = ("closure", "close_position", "close_velocity")
"""Functions of loops that may be open (and those named after them): what they tell is how far, or the way back."""
SUFFIX = "_checked"


def checked_functions(system: System, functions: Sequence[Function]) -> list[Function]:
    """The variants of all functions that take more than the independent coordinates; none without loops."""
    if not system.cuts:
        return []
    found = []
    for function in functions:
        given = {node for nodes in function.arguments for node in nodes}
        of_open_loops = any(function.name == name or function.name.startswith(f"{name}_") for name in OPEN)
        limits = () if of_open_loops else on_mechanism(system, given)
        if limits:
            turns = rotations(list(zip(function.inputs, function.arguments, strict=False)), [n for n, *_ in limits])
            before = (*turns, *(limit for limit in function.limits if limit not in turns))
            found.append(replace(function, name=function.name + SUFFIX, limits=(*before, *limits)))
    return found


def on_mechanism(system: System, given: set[Node]) -> tuple[NodeLimit, ...]:
    """Limits of what is given of q, v and a: that the loops are closed, and stay so to first and to second order."""
    q, v, a = (set(nodes) <= given for nodes in (system.inputs.q, system.inputs.v, system.inputs.a))
    if not q:
        return ()
    rows = [row for cut in system.cuts for row in cut.rows]
    limits = closed(system, with_rows(system.residual, rows))
    if v:
        limits += closed(system, with_rows(system.opening_rates, rows), motion_size(system))
    if v and a:
        openings = system.bias(system.rates(system.inputs.a), system.inputs.a)
        limits += closed(system, with_rows(openings, rows), motion_size(system, second=True))
    return limits


def with_rows(values: Sequence[Node], rows: Sequence[Row]) -> list[tuple[Node, Row]]:
    """How far each row opens."""
    return list(zip(values, rows, strict=True))


def motion_size(system: System, *, second: bool = False) -> Node:
    """|v|^2 of the tree's rates, or |a|^2 + |v|^4 of the accelerations that come of them, without units."""
    lengths = [c.kind == "length" for c in system.tree.v]
    size = squares(system, list(zip(system.inputs.v, lengths, strict=True)))
    if not second:
        return size
    return squares(system, list(zip(system.inputs.a, lengths, strict=True))) + size * size
