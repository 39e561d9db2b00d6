"""Tables of a structure as constant arrays of C, and the order in which what is held places bodies."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.assembly.closure_structure import Structure
from symscrew.assembly.elementary_graph import Edge
from symscrew.export import decimal, wrapped

LINE = 110
"""Characters of a line of tables: as in the other C."""


@dataclass(frozen=True)
class Step:
    """How a body is displaced: as another one, behind a held joint passed in its sense or back."""

    near: str
    far: str
    edge: Edge | None = None
    sign: int = 1


def held_steps(structure: Structure) -> list[Step]:
    """The order of `Displacements`: from the ground, across the joints of the tree, then what nothing carries."""
    steps, placed = list[Step](), set[str]()

    def spread(body: str) -> None:
        front = [body]
        placed.add(body)
        while front:
            here = front.pop()
            for edge in structure.graph.held:
                for near, far, sign in ((edge.parent, edge.child, 1), (edge.child, edge.parent, -1)):
                    if near == here and far not in placed:
                        steps.append(Step(near, far, edge if edge.columns and edge.axis is not None else None, sign))
                        placed.add(far)
                        front.append(far)

    spread(structure.graph.ground)
    for group in structure.groups:
        if group.edge is not None:
            ends = (group.edge.parent, group.edge.child)
            near, far = ends if group.forward else ends[::-1]
            if near in placed and far not in placed:
                steps.append(Step(near, far))
                spread(far)
    for body in structure.graph.cluster:
        if body not in placed:
            spread(body)
    return steps


def c_array(kind: str, name: str, values: Iterable[Any]) -> list[str]:
    """A constant array; one without entries has one that nobody reads."""
    found = np.array(list(values), dtype=int if kind == "int" else float)
    found = found if found.size else np.zeros(1, dtype=found.dtype)
    text = f"static const {kind} {name}{''.join(f'[{n}]' for n in found.shape)} = {_nested(kind, found.tolist())};"
    return wrapped(text, later="    ", width=LINE)


def _nested(kind: str, values: Any) -> str:
    if isinstance(values, list):
        return "{" + ", ".join(_nested(kind, v) for v in values) + "}"
    return str(values) if kind == "int" else decimal(values).strip("()")
