"""Obstacles: shapes fixed on bodies, given by named points, that other points and segments keep off by a distance.

obstacle, positions of its points and of what keeps off --> a value that has to reach a lower bound

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
    its square where `squared`; `between` (their positions, both ends of a segment that does) -> the same, None: points
    only.
    """

    points: tuple[str, ...]
    value: Callable[[Sequence[Any], Any], Any]
    squared: bool = True
    between: Callable[[Sequence[Any], Sequence[Any]], Any] | None = None

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


def _below_both(at: Sequence[Any], ends: Sequence[Any]) -> Any:
    return ca.fmin(_above(at, ends[0]), _above(at, ends[1]))


def _of_segments(at: Sequence[Any], ends: Sequence[Any]) -> Any:
    """From one segment to another: their ends from the other one, or the lines where both are nearest inside.

    With s and t on the lines, D = |a|^2 |b|^2 - (a.b)^2 of their directions: going from there along both lines until
    the first end costs at most D / |a|^2 and D / |b|^2, so that the ends are no farther off than that. This bounds the
    lines' part where they are almost parallel, D near 0, and their distance cannot be told from directions.
    """
    a, b, off = at[1] - at[0], ends[1] - ends[0], ends[0] - at[0]
    aa, bb, ab, oa, ob = (ca.dot(x, y) for x, y in ((a, a), (b, b), (a, b), (off, a), (off, b)))
    far = ca.fmin(
        ca.fmin(_from_segment(at, ends[0]), _from_segment(at, ends[1])),
        ca.fmin(_from_segment(ends, at[0]), _from_segment(ends, at[1])),
    )
    across = ca.cross(a, b)
    d = ca.dot(across, across)
    s, t = oa * bb - ob * ab, oa * ab - ob * aa  # times d
    inside = ca.logic_and(ca.logic_and(s > 0, s < d), ca.logic_and(t > 0, t < d))
    lines = ca.dot(off, across) ** 2 / (d + PARALLEL * aa * bb)
    lines = ca.fmax(lines, far - d / ca.fmax(aa, bb))
    return ca.fmin(far, ca.if_else(inside, lines, far))


# Beside D, as a part of |a|^2 |b|^2: so that derivatives are numbers where segments are parallel, squares of 1e-12 rad.
PARALLEL = 1e-24


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
    "sphere": Shape(("centre",), _from_centre, between=lambda at, ends: _from_segment(ends, at[0])),
    "plane": Shape(("a point of it", "a point above it"), _above, squared=False, between=_below_both),
    "capsule": Shape(("one end", "the other end"), _from_segment, between=_of_segments),
    "box": Shape(("a corner", "its neighbour", "its neighbour", "its neighbour"), _from_box),
}
