"""Naming nodes by their origins, a line a vector: see `symscrew.algebra.origins`.

Each of these returns what it is given. Of structural zeros and ones, constants, SymPy expressions and floats nothing is
named, so that recursions over any scalar can name what they make.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from symscrew.algebra.nodes import Node
from symscrew.algebra.origins import Origin
from symscrew.algebra.screws import Matrix, Scalar, Twist, Vector

AXES = ("x", "y", "z")
CELLS = tuple(tuple(row + column for column in AXES) for row in AXES)


# A model has some hundred vectors of few parts, each of which is named anew in every function.
_origin = lru_cache(maxsize=4096)(Origin)


def named(value: Scalar, quantity: str, part: str = "", component: str = "", *, by: str = "") -> Scalar:
    """The value itself; a node is called so, unless it is a constant or has a name."""
    if type(value) is Node and value.value is None:
        negative = value.op == "neg"
        node = value.args[0] if negative else value
        origins = node.tape.origins
        if node.index not in origins:
            origins[node.index] = _origin(quantity, part, component, by, negative)
    return value


def named_vector(vector: Vector, quantity: str, part: str = "", *, prefix: str = "", by: str = "") -> Vector:
    """The vector itself, its components called x, y and z behind `prefix`."""
    for axis, value in zip(AXES, vector, strict=True):
        if _unnamed(value):
            named(value, quantity, part, prefix + axis, by=by)
    return vector


def named_matrix(matrix: Matrix, quantity: str, part: str = "", *, prefix: str = "", by: str = "") -> Matrix:
    """The matrix itself, its entries called xx, xy ... behind `prefix`, row first."""
    for cells, row in zip(CELLS, matrix, strict=True):
        for cell, value in zip(cells, row, strict=True):
            if _unnamed(value):
                named(value, quantity, part, prefix + cell, by=by)
    return matrix


def _unnamed(value: Scalar) -> bool:
    """Whether it is a node without a name: most vectors are made, and named, again and again."""
    if type(value) is not Node or value.value is not None:
        return False
    return (value.args[0] if value.op == "neg" else value).index not in value.tape.origins


def named_wrench(
    wrench: tuple[Vector, Vector], quantity: str, part: str = "", *, by: str = ""
) -> tuple[Vector, Vector]:
    """The (force, moment) itself, its components called force_x, ... moment_z."""
    named_vector(wrench[0], quantity, part, prefix="force_", by=by)
    named_vector(wrench[1], quantity, part, prefix="moment_", by=by)
    return wrench


def named_twist(twist: Twist, quantity: str, part: str = "", *, by: str = "") -> Twist:
    """The screw itself, its components called angular_x, ... linear_z."""
    named_vector(twist.angular, quantity, part, prefix="angular_", by=by)
    named_vector(twist.linear, quantity, part, prefix="linear_", by=by)
    return twist


def named_entries(values: Iterable[Scalar], quantity: str, labels: Iterable[str]) -> None:
    """Entries of an array, called by their labels `part` or `part.component`, of a coefficient `...|by`."""
    for value, label in zip(values, labels, strict=True):
        if _unnamed(value):
            place, _, by = label.partition("|")
            part, _, component = place.partition(".")
            named(value, quantity, part, component, by=by)


def handed_on(old: Node, new: Node) -> Node:
    """`new`, which stands for `old`, with its name if it has none."""
    if old is not new and new.value is None:
        inner, negative = (old.args[0], True) if old.op == "neg" else (old, False)
        origin = old.tape.origins.get(inner.index)
        if origin is not None:
            node, other = (new.args[0], True) if new.op == "neg" else (new, False)
            if node.index not in new.tape.origins:
                new.tape.origins[node.index] = origin if negative == other else origin.opposite
    return new
