"""The graph of a mechanism with the screw of every freedom, in 60 digits and in units of its own size.

    Mechanism --network_of--> Network: bodies, joints, tree, chords --loop_rows--> sum of signed screws = 0

Everything that mobility needs to know of a mechanism: bodies, joints, a spanning tree and its chords, and for
each freedom its screw (omega ; v) at O in the reference configuration. Lengths are divided by a characteristic
length of the mechanism, so that no decision depends on the unit; results are multiplied back.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from symscrew.algebra import (
    CONTEXT,
    IDENTITY,
    Vector,
    cross,
    dot,
    high_precision,
    scale,
    subtract,
)
from symscrew.description import JOINT_TYPES, Joint, Mechanism, Motion, radius_of_gyration
from symscrew.kinematics import motion_screws
from symscrew.mobility.coupled_rates import Tie, ties_of
from symscrew.mobility.screw_systems import Real, Row, Screw

SAME_POINT = CONTEXT.mpf(10) ** -5
"""Joint points that lie closer together than this, relative to other lengths of the description, are meant to be one:
coordinates of six digits leave as much. Then the largest of these lengths is the mechanism's size instead."""
SMALLEST = CONTEXT.mpf(10) ** -7
"""Distances of points [m] below this are rounding where a description has nothing else that has a size: hinges meant to
meet in a point are apart by the eighth digit of a metre, and a mechanism of micrometres is larger."""
NOTHING = CONTEXT.mpf(10) ** -13
"""Other lengths [m] below this are none, as for the characteristic length: what doubles computed from metres leave.
Sizes and tolerances follow from these alone; ranks of what was typed do not."""
UNIT_ALREADY = CONTEXT.mpf(10) ** -55
"""An axis this close to unit length is one, as it was computed with 60 digits; others are divided by their length."""


TYPED = 40
"""Digits of numbers that are to be typed for special geometry: ranks take differences below 1e-27 for rounding, so that
with 30 or more the special geometry is typed, with 25 it is not."""


@dataclass(frozen=True)
class Edge:
    """A joint: its bodies, its elementary motions with their first columns and where its columns end.

    `point` is scaled; `screws` has one scaled screw per freedom, three for a spherical motion.
    """

    name: str
    type: str
    parent: str
    child: str
    point: Vector
    motions: tuple[tuple[Motion, int], ...]
    screws: tuple[Screw, ...]
    start: int

    def __repr__(self) -> str:
        return f"Edge({self.name!r}, {self.type} from {self.parent!r} to {self.child!r}, columns from {self.start})"

    @property
    def columns(self) -> range:
        """Columns of the joint's freedoms among those of the mechanism."""
        return range(self.start, self.start + len(self.screws))

    def pitch(self, column: int) -> Real:
        """The pitch of the screw in a column, scaled: the part of its velocity along its unit axis."""
        a, b, c, x, y, z = self.screws[column - self.start]
        return dot((a, b, c), (x, y, z))

    @property
    def slots(self) -> tuple[int, ...]:
        """Which of the joint's axes the description gives: all, of a planar joint its normal, of a free one none."""
        given = {self.slot(motion) for motion, _ in self.motions if motion.single}
        return tuple(sorted(slot for slot in given if slot is not None))

    def slot(self, motion: Motion) -> int | None:
        """The given axis that an elementary motion turns with; both directions in a plane do with its normal."""
        free = JOINT_TYPES[self.type].unconstrained
        return None if free else self.plane if self.plane is not None else motion.axis or 0

    @property
    def plane(self) -> int | None:
        """The slot of a planar joint's normal; None for other joints."""
        kind = JOINT_TYPES[self.type]
        return kind.turning[0] if kind.planar else None

    def axis(self, slot: int) -> Vector:
        """The unit axis in a slot."""
        columns = (column for motion, column in self.motions if motion.single and (motion.axis or 0) == slot)
        screw = self.screws[next(columns) - self.start]
        turning = any(screw[:3])
        return (screw[0], screw[1], screw[2]) if turning else (screw[3], screw[4], screw[5])

    def as_typed(self, length: Real) -> tuple[tuple[str, ...], tuple[tuple[str, ...], ...], str | None]:
        """(point [m], axes, pitch [m/rad] of a screw joint) in `TYPED` digits: what a description says of it.

        `length` is that of the network [m].
        """
        pitch = None
        for motion, column in self.motions:
            if motion.helical:
                pitch = CONTEXT.nstr(self.pitch(column) * length, TYPED)
        axes = [tuple(CONTEXT.nstr(c, TYPED) for c in self.axis(slot)) for slot in self.slots]
        return tuple(CONTEXT.nstr(c * length, TYPED) for c in self.point), tuple(axes), pitch


@dataclass(frozen=True)
class Network:
    """A mechanism as a graph. `tree`: (joint, +1 from parent to child or -1) in order from the ground.

    `chords`: the joints that close loops. `length`: the characteristic length [m] that lengths are divided by.
    `driven`: columns of the driven freedoms. `ties`: couplings of coordinates, whose rows follow those of the loops.
    """

    ground: str
    bodies: tuple[str, ...]
    edges: Mapping[str, Edge]
    tree: tuple[tuple[str, int], ...]
    chords: tuple[str, ...]
    length: Any
    driven: tuple[int, ...]
    ties: tuple[Tie, ...] = ()

    def __repr__(self) -> str:
        return f"<Network: {len(self.bodies)} bodies, {len(self.edges)} joints, {len(self.chords)} loops>"

    @property
    def freedoms(self) -> int:
        """Sum of the freedoms of all joints."""
        return sum(len(edge.screws) for edge in self.edges.values())

    @property
    def screws(self) -> tuple[Screw, ...]:
        """The scaled screws of all freedoms, in the order of the columns."""
        return tuple(screw for edge in self.edges.values() for screw in edge.screws)

    @property
    def kutzbach(self) -> int:
        """Kutzbach-Gruebler: sum of the joint freedoms - 6 times the number of independent loops - couplings."""
        return self.freedoms - 6 * len(self.chords) - len(self.ties)

    def path(self, body: str) -> tuple[tuple[str, int], ...]:
        """The tree's joints from the ground to `body`, with the sense in which each is passed."""
        reached = {self._end(name, sign)[1]: (name, sign) for name, sign in self.tree}
        steps: list[tuple[str, int]] = []
        while body != self.ground:
            name, sign = reached[body]
            steps.append((name, sign))
            body = self._end(name, sign)[0]
        return tuple(reversed(steps))

    def _end(self, name: str, sign: int) -> tuple[str, str]:
        edge = self.edges[name]
        return (edge.parent, edge.child) if sign > 0 else (edge.child, edge.parent)

    def loops(self) -> tuple[tuple[tuple[str, int], ...], ...]:
        """One independent loop per chord: ground to parent, the chord, child to ground; common parts cancel."""
        result = []
        for name in self.chords:
            edge = self.edges[name]
            out, back = self.path(edge.parent), self.path(edge.child)
            common = 0
            while common < min(len(out), len(back)) and out[common] == back[common]:
                common += 1
            result.append((*out[common:], (name, 1), *((n, -s) for n, s in reversed(back[common:]))))
        return tuple(result)

    def twist_rows(self, body: str) -> list[Row]:
        """The 6 x n matrix that maps the joint rates to the twist of `body`, along the tree."""
        return self._rows(self.path(body))

    def loop_rows(self) -> list[Row]:
        """Six rows per independent loop: the signed screws of its joints add up to zero; one per coupling."""
        return [*(row for loop in self.loops() for row in self._rows(loop)), *map(self._tie_row, self.ties)]

    def tied_column(self, joint: str, motion: int) -> int:
        """The column of a coupled coordinate."""
        return self.edges[joint].motions[motion][1]

    def _tie_row(self, tie: Tie) -> Row:
        row: Row = [CONTEXT.zero] * self.freedoms
        for term in tie.terms:
            row[self.tied_column(term.joint, term.motion)] += term.coefficients[0]
        return row

    def _rows(self, steps: Sequence[tuple[str, int]]) -> list[Row]:
        block: list[Row] = [[CONTEXT.zero] * self.freedoms for _ in range(6)]
        for name, sign in steps:
            edge = self.edges[name]
            for column, screw in zip(edge.columns, edge.screws, strict=True):
                for i in range(6):
                    block[i][column] = sign * screw[i]
        return block


def network_of(mechanism: Mechanism) -> Network:
    """The graph of the mechanism with scaled screws in 60 digits, in the reference configuration."""
    length = _characteristic_length(mechanism)
    edges: dict[str, Edge] = {}
    start = 0
    for joint in mechanism.joints.values():
        edge = edge_of(mechanism, joint, length, start)
        edges[joint.name] = edge
        start += len(edge.screws)
    bodies = tuple(dict.fromkeys((mechanism.ground, *mechanism.bodies)))
    tree = spanning_tree(mechanism.ground, edges)
    used = {name for name, _ in tree}
    driven = tuple(edges[joint.name].start + index for joint in mechanism.joints.values() for index in joint.driven)
    chords = tuple(name for name in edges if name not in used)
    return Network(mechanism.ground, bodies, edges, tree, chords, length, driven, ties_of(mechanism, length))


def screw_axes(
    joint: Joint, given: Sequence[Vector], root: Callable[[Real], Real], size: Callable[[Real], Real]
) -> tuple[Vector, ...]:
    """The joint's axes; those of a planar joint are completed to a triad, a free one has the absolute axes.

    `root` is the square root of the scalars in use, `size` a number to compare them by.
    """

    def across(normal: Vector) -> tuple[Vector, Vector]:
        sizes = [abs(size(c)) for c in normal]
        nearest = IDENTITY[sizes.index(min(sizes))]
        rest = subtract(nearest, scale(dot(nearest, normal), normal))
        first = scale(1 / root(dot(rest, rest)), rest)
        return first, cross(normal, first)

    return joint.kind.motion_axes(given, IDENTITY, across)


def edge_of(mechanism: Mechanism, joint: Joint, length: Any, start: int) -> Edge:
    """A joint with lengths divided by `length` [m] and columns from `start`."""
    point, screws = _screws(mechanism, joint, length)
    columns = [start + first for first in joint.kind.starts]
    motions = tuple(zip(joint.kind.motions, columns, strict=True))
    return Edge(joint.name, joint.type, joint.parent, joint.child, point, motions, tuple(screws), start)


def _screws(mechanism: Mechanism, joint: Joint, length: Any) -> tuple[Vector, list[Screw]]:
    point = scale(1 / length, _vector(mechanism, joint.point))
    given = [_unit(_vector(mechanism, axis)) for axis in joint.axes]
    axes = screw_axes(joint, given, CONTEXT.sqrt, lambda c: c)
    pitch = _number(mechanism, joint.pitch) / length if joint.pitch is not None else None
    made = motion_screws(joint.kind, axes, point, pitch)
    screws = [tuple(CONTEXT.mpf(c) for c in twist.components) for _, twists in made for twist in twists]
    return point, screws


def _number(mechanism: Mechanism, value: sympy.Expr) -> Real:
    return high_precision(mechanism.number(value))


def _vector(mechanism: Mechanism, values: Sequence[sympy.Expr]) -> Vector:
    x, y, z = (_number(mechanism, v) for v in values)
    return (x, y, z)


def _unit(axis: Vector) -> Vector:
    """Descriptions give unit vectors to 14 digits or more; here they get the unit length they mean."""
    size = CONTEXT.sqrt(dot(axis, axis))
    return axis if abs(size - 1) < UNIT_ALREADY else scale(1 / size, axis)


def _characteristic_length(mechanism: Mechanism) -> Any:
    """Root mean square distance of the joint points from their centre [m]; where they all but coincide, another length.

    Invariant under rigid motions, and proportional to the unit. Hinges through one point that rounding sets apart by
    1e-10 m make no mechanism of that size: theirs is a pitch, the distance of named points, of centres of mass, a
    radius of gyration, or the distance of the origin, else 1. Where these are no larger, it is a linkage of nanometres.
    """
    points = [_vector(mechanism, joint.point) for joint in mechanism.joints.values()]
    centre = tuple(sum(p[k] for p in points) / len(points) for k in range(3))
    spread = CONTEXT.sqrt(sum(_square(p, centre) for p in points) / len(points))
    named = [_vector(mechanism, point.at) for point in mechanism.points.values()]
    named += [_vector(mechanism, body.com) for body in mechanism.bodies.values() if body.com]
    own = [abs(_number(mechanism, j.pitch)) for j in mechanism.joints.values() if j.pitch is not None]
    own += [CONTEXT.sqrt(_square(p, centre)) for p in named]
    own += [CONTEXT.mpf(radius_of_gyration(mechanism, body)) for body in mechanism.bodies.values()]
    largest = max([*own, *(abs(c) for p in points for c in p)])
    rounding = NOTHING if max(own, default=NOTHING) > NOTHING else SMALLEST
    if spread > max(SAME_POINT * largest, rounding):
        return spread
    return largest if largest > rounding else CONTEXT.one


def _square(point: Vector, centre: Sequence[Real]) -> Real:
    """The squared distance of two points."""
    return sum((point[k] - centre[k]) ** 2 for k in range(3))


def spanning_tree(ground: str, edges: Mapping[str, Edge]) -> tuple[tuple[str, int], ...]:
    """(joint, sense), breadth first from the ground; fewest freedoms first, so that S joints close the loops."""
    reached = {ground}
    front = [ground]
    tree: list[tuple[str, int]] = []
    order = sorted(edges.values(), key=lambda edge: len(edge.screws))
    while front:
        body = front.pop(0)
        for edge in order:
            for near, far, sign in ((edge.parent, edge.child, 1), (edge.child, edge.parent, -1)):
                if near == body and far not in reached:
                    reached.add(far)
                    tree.append((edge.name, sign))
                    front.append(far)
    return tuple(tree)
