"""Obstacles: shapes fixed on bodies, given by named points, that other named points keep off by a distance.

obstacle, positions of its points and of a point that keeps off --> a value that has to reach a lower bound

A type of shape is an entry of `SHAPES` (its name stands in `symscrew.optimisation.problem.SHAPE_TYPES`). Distances are
squared where they are roots, so that they have slopes everywhere; inside a box the value is less than zero.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca


@dataclass(frozen=True)
class Shape:
    """A type of obstacle.

    `points`: what its named points are. `value` (their positions, position of the point that keeps off) -> a length, or
    its square where `squared`.
    """

    points: tuple[str, ...]
    value: Callable[[Sequence[Any], Any], Any]
    squared: bool = True

    def least(self, distance: float) -> float:
        """What the value is at a distance [m] from the shape."""
        return distance * distance if self.squared else distance


def _from_centre(at: Sequence[Any], point: Any) -> Any:
    off = point - at[0]
    return ca.dot(off, off)


def _above(at: Sequence[Any], point: Any) -> Any:
    """Along the direction from the plane's first point to its second one."""
    normal = at[1] - at[0]
    return ca.dot(point - at[0], normal) / ca.sqrt(ca.dot(normal, normal))


def _from_segment(at: Sequence[Any], point: Any) -> Any:
    along, off = at[1] - at[0], point - at[0]
    part = ca.fmin(ca.fmax(ca.dot(off, along) / ca.dot(along, along), 0), 1)
    nearest = off - part * along
    return ca.dot(nearest, nearest)


def _from_box(at: Sequence[Any], point: Any) -> Any:
    """From a box with a corner and its three neighbours; inside less than zero, by the square of the way out."""
    beyond = []
    for neighbour in at[1:]:
        edge, off = neighbour - at[0], point - at[0]
        size = ca.sqrt(ca.dot(edge, edge))
        beyond.append(ca.fabs(ca.dot(off, edge) / size - size / 2) - size / 2)
    outside = sum((ca.fmax(b, 0) ** 2 for b in beyond), start=ca.SX(0))
    inside = ca.fmin(ca.fmax(ca.fmax(beyond[0], beyond[1]), beyond[2]), 0)
    return outside - inside * inside


SHAPES: Mapping[str, Shape] = {
    "sphere": Shape(("centre",), _from_centre),
    "plane": Shape(("a point of it", "a point above it"), _above, squared=False),
    "capsule": Shape(("one end", "the other end"), _from_segment),
    "box": Shape(("a corner", "its neighbour", "its neighbour", "its neighbour"), _from_box),
}
