"""Obstacles: shapes fixed on bodies, given by named points, that points, segments and boxes keep off by a distance.

obstacle, positions of its points and of what keeps off --> a value that has to reach a lower bound

A type of shape is an entry of `SHAPES` (its name stands in `symscrew.optimisation.problem.SHAPE_TYPES`). Distances are
squared where they are roots, so that they have slopes everywhere; inside a box the value is less than zero.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import casadi as ca


class Kept(NamedTuple):
    """What keeps off: a `value` at the points of the mesh, and what is enclosed `between` them in its place (None: it).

    `between` need not tell what goes through a shape from what is beside it, as long as it falls to zero where they
    touch: a motion that is beside it at the points gets through at no other place.
    """

    value: Any
    between: Any = None


@dataclass(frozen=True)
class Shape:
    """A type of obstacle.

    `points`: what its named points are. `value` (their positions, position of the point that keeps off) -> a length, or
    its square where `squared`; `between` (their positions, both ends of a segment that does) -> the same; `boxes`
    (their positions, a corner of a box that does and its neighbours) -> the same of every part that can be nearest.
    """

    points: tuple[str, ...]
    value: Callable[[Sequence[Any], Any], Any]
    between: Callable[[Sequence[Any], Sequence[Any]], Kept]
    boxes: Callable[[Sequence[Any], Sequence[Any]], list[Kept]]
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


def _of_box(at: Sequence[Any], ends: Sequence[Any]) -> Kept:
    """From a box to a segment; less than zero where it goes through the box, by how deep the middle of that part is.

    The square of the distance along the segment is convex, of second degree between the places where it passes a plane
    of a side. Its slope there, on the left and on the right of zero, gives the nearest place by one division. Where
    that place is hardly known, as a range of times has it, it says little; between the points it is the least distance
    of ends from the box and of the segment from its edges.
    """
    offs = []  # position at one end, change to the other one, half of the size, along each edge
    for neighbour in at[1:]:
        edge = neighbour - at[0]
        size = ca.sqrt(ca.dot(edge, edge))
        offs.append((ca.dot(ends[0] - at[0], edge) / size - size / 2, ca.dot(ends[1] - ends[0], edge) / size, size / 2))

    def slope(s: Any) -> Any:
        places = ((start + s * change, change, half) for start, change, half in offs)
        return sum(((x - ca.fmin(ca.fmax(x, -half), half)) * change for x, change, half in places), start=ca.SX(0))

    along = ends[1] - ends[0]
    still = STANDING * ca.dot(along, along)
    planes = [(side * half - start) * change / (change * change + still) for start, change, half in offs
              for side in (-1, 1)]  # fmt: skip
    low, high = ca.SX(0), ca.SX(1)
    for s in (ca.SX(0), ca.SX(1), *(ca.fmin(ca.fmax(s, 0), 1) for s in planes)):
        here = slope(s)
        low = ca.if_else(here <= 0, ca.fmax(low, s), low)
        high = ca.if_else(here >= 0, ca.fmin(high, s), high)
    before, behind = slope(low), slope(high)
    flat = behind <= before  # no place of this part is nearer: the segment is parallel to a side, or inside
    part = ca.if_else(flat, 0.5, -before / ca.if_else(flat, 1, behind - before))
    apart = ca.fmin(_from_box(at, ends[0]), _from_box(at, ends[1]))
    for edge in _edges(at):
        apart = ca.fmin(apart, _of_segments(edge, ends))
    return Kept(_from_box(at, ends[0] + (low + (high - low) * part) * along), apart)


# Squares of changes along an edge, as a part of the segment's length, below which it does not move along that edge.
STANDING = 1e-24


def _edges(box: Sequence[Any]) -> list[list[Any]]:
    """Both ends of the twelve edges of a box, from a corner and its neighbours."""
    corner, sides = box[0], [neighbour - box[0] for neighbour in box[1:]]
    edges = []
    for k in range(3):
        one, other = sides[k - 2], sides[k - 1]
        edges += [[start, start + sides[k]] for start in (corner, corner + one, corner + other, corner + one + other)]
    return edges


def _of_boxes(at: Sequence[Any], box: Sequence[Any]) -> list[Kept]:
    """The widest gap of two boxes along normals of their sides and across pairs of their edges; with its sign, squared.

    It is their distance where a side of one or two edges are nearest, and less where corners are: on the safe side.
    Less than zero where they go through each other, by how far they had to be moved apart.
    Source: S. Gottschalk, M. C. Lin, D. Manocha, OBBTree, SIGGRAPH 1996.
    """
    one, other = ([neighbour - part[0] for neighbour in part[1:]] for part in (at, box))
    off = box[0] + sum(other, start=ca.SX.zeros(3)) / 2 - at[0] - sum(one, start=ca.SX.zeros(3)) / 2

    def gap(axis: Any, least: Any) -> Any:
        sizes = sum((ca.fabs(ca.dot(edge, axis)) for edge in (*one, *other)), start=ca.SX(0))
        return (ca.fabs(ca.dot(off, axis)) - sizes / 2) / ca.sqrt(ca.dot(axis, axis) + least)

    widest = gap(one[0], 0)
    for normal in (*one[1:], *other):
        widest = ca.fmax(widest, gap(normal, 0))
    for a in one:
        for b in other:
            across, size = ca.cross(a, b), ca.dot(a, a) * ca.dot(b, b)
            askew = ca.dot(across, across) > ALIGNED * size
            widest = ca.fmax(widest, ca.if_else(askew, gap(across, PARALLEL * size), -ca.sqrt(ca.dot(a, a))))
    return [Kept(widest * ca.fabs(widest))]


# Square of the sine below which two edges count as parallel: across them is no direction of its own, and what is left
# out, a gap wider by at most 1e-4 of the boxes' size than along the normals, is on the safe side.
ALIGNED = 1e-8


SHAPES: Mapping[str, Shape] = {
    "sphere": Shape(
        ("centre",), _from_centre, lambda at, ends: Kept(_from_segment(ends, at[0])),
        lambda at, box: [Kept(_from_box(box, at[0]))],
    ),
    "plane": Shape(
        ("a point of it", "a point above it"), _above, lambda at, ends: Kept(_below_both(at, ends)),
        lambda at, box: [Kept(_below_both(at, edge)) for edge in _edges(box)[:4]], squared=False,
    ),
    "capsule": Shape(
        ("one end", "the other end"), _from_segment, lambda at, ends: Kept(_of_segments(at, ends)),
        lambda at, box: [_of_box(box, at)],
    ),
    "box": Shape(("a corner", "its neighbour", "its neighbour", "its neighbour"), _from_box, _of_box, _of_boxes),
}  # fmt: skip
