"""A frame for every link, chosen so that its constants are mostly zeros and ones.

A revolute link's z is its joint axis and its x points where the next joint, or the tip, lies; a prismatic
link keeps its parent's axes; a spherical link keeps the absolute axes of the reference configuration. The
constants are nodes of the tape: numbers where the geometry is baked, expressions of run-time parameters
otherwise. What is structurally zero here is what the generated code does not compute.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import mpmath
import numpy as np

from symscrew.algebra import (
    CONTEXT,
    IDENTITY,
    ZERO,
    Matrix,
    Node,
    Tape,
    Vector,
    cross,
    dot,
    expression_node,
    high_precision,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.description import JOINT_TYPES, Joint, Mechanism, Motion
from symscrew.kinematics.tree import GROUND, Link, Tree

UNITS: tuple[Vector, Vector, Vector] = IDENTITY


@dataclass(frozen=True)
class Frame:
    """Constants of a link.

    `axes`: absolute_R_link in the reference configuration. `origin`: absolute, in the reference
    configuration. `rotation`: parent_R_link before the joint's own motion. `offset`: of the origin from the
    parent's, parent's axes, in the reference configuration. `axis`: the joint axis in the parent's axes.
    `reference`: the joint's coordinate in the reference configuration.
    `phase`: the motion is a rotation about z by q + phase (R, H) or a translation by q + phase along `axis`.
    """

    axes: Matrix
    origin: Vector
    rotation: Matrix
    offset: Vector
    axis: Vector
    phase: Node
    reference: Node | int = 0
    start: tuple[Node, Node] | None = None  # cosine and sine of the angle at the reference configuration
    pitch: Node | None = None


class Geometry:
    """The description's numbers as nodes: parameters, points and axes; run-time parameters are inputs."""

    def __init__(self, mechanism: Mechanism, tape: Tape) -> None:
        self.mechanism, self.tape = mechanism, tape
        self.parameters = {
            p.symbol: tape.symbol(p.name, p.unit, p.description or f"parameter {p.name}")
            for p in mechanism.parameters.values()
            if p.run_time
        }
        self._scalars: dict[object, Node] = {}
        trials = []
        for k in range(3 if self.parameters else 0):
            # Trial 0 is the nominal value; the others are off it by factors that no identity survives.
            trial = {}
            for i, p in enumerate(p for p in mechanism.parameters.values() if p.run_time):
                nominal = high_precision(p.value)
                shift = CONTEXT.mpf(k) * CONTEXT.sqrt(i + 2) / 97
                trial[self.parameters[p.symbol]] = nominal * (1 + shift) + shift / 89
            trials.append(trial)
        tape.set_parameter_trials(trials)

    def scalar(self, expression: object) -> Node:
        """A number of the description as a node; 60 digits of the same expression are computed once."""
        if expression not in self._scalars:
            node = expression_node(self.tape, self.mechanism.baked(expression), self.parameters)  # type: ignore[arg-type]
            self._scalars[expression] = self.tape.settle(node)
        return self._scalars[expression]

    def vector(self, values: tuple) -> Vector:
        """A vector of the description as nodes."""
        x, y, z = (self.scalar(v) for v in values)
        return (x, y, z)

    def settle(self, values: Vector) -> Vector:
        """A vector of constants with hidden identities folded (see `Tape.settle`)."""
        x, y, z = (self.tape.settle(v) for v in values)
        return (x, y, z)

    def settle_matrix(self, matrix: Matrix) -> Matrix:
        """A matrix of constants with hidden identities folded."""
        a, b, c = (self.settle(row) for row in matrix)
        return (a, b, c)

    def unit(self, values: Vector) -> Vector:
        """The vector divided by its length."""
        length = self.tape.sqrt(self.tape.settle(dot(values, values)))
        return self.settle(scale(1 / self.tape.settle(length), values))

    def size(self, node: object) -> float:
        """Magnitude of a constant at the nominal parameters."""
        node = self.tape.settle(node)
        if node.value is not None:
            return abs(float(node.value))
        self.tape.set_samples(
            {n: np.array([float(self.mechanism.parameters[n.args[0].name].value)]) for n in self.parameters.values()}
        )
        return abs(float(self.tape.sample(node)[0]))

    def motion_axes(self, joint: Joint) -> tuple[Vector, ...]:
        """Axes to which the motions of a joint refer, absolute, in the reference configuration."""
        if joint.type == "free":
            return UNITS
        given = tuple(self.vector(axis) for axis in joint.axes)
        if joint.type != "E":
            return given
        normal = given[0]
        first = self.perpendicular(normal)
        return (first, self.settle(cross(normal, first)), normal)

    def perpendicular(self, axis: Vector, towards: Vector | None = None) -> Vector:
        """A unit vector perpendicular to `axis`: the component of `towards`, or of an absolute axis."""
        if towards is not None:
            rest = self.settle(subtract(towards, scale(dot(towards, axis), axis)))
            if max(self.size(c) for c in rest) > 1e-9 * max(self.size(c) for c in towards):
                return self.unit(rest)
        sizes = [self.size(c) for c in axis]
        nearest = UNITS[sizes.index(min(sizes))]
        return self.unit(subtract(nearest, scale(dot(nearest, axis), axis)))


def link_frames(mechanism: Mechanism, tree: Tree, geometry: Geometry) -> tuple[Frame, ...]:
    """The frame of every link of the tree."""
    tape = geometry.tape
    frames: list[Frame] = [Frame(IDENTITY, ZERO, IDENTITY, ZERO, ZERO, tape.zero)]
    for link in tree.links[1:]:
        parent = frames[link.parent]
        joint, motion = tree.joints[link.joint], link.motion
        point = geometry.vector(joint.point)
        if motion.kind == "S":
            frames.append(_place(geometry, parent, IDENTITY, point, transpose(parent.axes), ZERO, tape.zero))
            continue
        if motion.kind == "F":
            frames.append(_place(geometry, parent, parent.axes, point, IDENTITY, ZERO, tape.zero))
            continue
        axis = geometry.motion_axes(joint)[motion.axis or 0]
        axis = scale(-1, axis) if link.inverted else axis
        reference = _reference(geometry, joint, motion)
        local = geometry.settle(transform(transpose(parent.axes), axis))
        if motion.kind == "P":
            origin = _prismatic_origin(mechanism, tree, geometry, link, parent, axis)
            frames.append(_place(geometry, parent, parent.axes, origin, IDENTITY, local, -reference, reference))
            continue
        origin = _revolute_origin(mechanism, tree, geometry, link, parent, axis, point)
        before = _sparse_triad(geometry, local)
        start = geometry.settle_matrix(transpose(_matmul(parent.axes, before)))  # rows: x', y', z absolute
        x = geometry.perpendicular(axis, _direction_outwards(mechanism, tree, geometry, link, axis, origin))
        cosine = tape.settle(dot(start[0], x))
        sine = tape.settle(dot(start[1], x))
        phase = tape.settle(tape.function("atan2", sine, cosine) - reference)
        axes = transpose((x, geometry.settle(cross(axis, x)), axis))
        placed = _place(geometry, parent, axes, origin, before, local, phase, reference)
        pitch = geometry.scalar(joint.pitch) if motion.kind == "H" else None
        frames.append(replace(placed, start=(cosine, sine), pitch=pitch))
    return tuple(frames)


def _place(
    geometry: Geometry,
    parent: Frame,
    axes: Matrix,
    origin: Vector,
    rotation: Matrix,
    axis: Vector,
    phase: Node,
    reference: Node | int = 0,
) -> Frame:
    offset = geometry.settle(transform(transpose(parent.axes), subtract(origin, parent.origin)))
    return Frame(axes, origin, rotation, offset, axis, geometry.tape.node(phase), reference)


def _matmul(a: Matrix, b: Matrix) -> Matrix:
    columns = transpose(b)
    return transpose((transform(a, columns[0]), transform(a, columns[1]), transform(a, columns[2])))


def _reference(geometry: Geometry, joint: Joint, motion: Motion) -> Node:
    if not joint.reference:
        return geometry.tape.zero
    return geometry.scalar(joint.reference[JOINT_TYPES[joint.type].motions.index(motion)])


def _sparse_triad(geometry: Geometry, axis: Vector) -> Matrix:
    """A rotation matrix whose third column is `axis`, with as many zeros and ones as can be had."""
    sizes = [geometry.size(c) for c in axis]
    zeros = [k for k in range(3) if sizes[k] == 0]
    if len(zeros) == 2:
        main = sizes.index(max(sizes))
        first: Vector = UNITS[(main + 1) % 3]
    elif zeros:
        first = geometry.settle(cross(UNITS[zeros[0]], axis))
    else:
        first = geometry.unit(cross(UNITS[sizes.index(min(sizes))], axis))
    return transpose((first, geometry.settle(cross(axis, first)), axis))


def _revolute_origin(
    mechanism: Mechanism,
    tree: Tree,
    geometry: Geometry,
    link: Link,
    parent: Frame,
    axis: Vector,
    point: Vector,
) -> Vector:
    """A point of the axis: the given one, or the foot of the perpendicular from the parent's origin if that
    leaves fewer numbers in the offsets to the parent and to the joints further out, of equals in the former: what
    arrives from outboard passes there. Nothing passes on to the ground."""
    away = geometry.settle(subtract(point, parent.origin))
    foot = geometry.settle(subtract(point, scale(dot(away, axis), axis)))

    def numbers(origin: Vector) -> tuple[int, int]:
        local = geometry.settle(transform(transpose(parent.axes), subtract(origin, parent.origin)))
        count = sum(geometry.size(c) != 0 for c in local)
        outboard = list(_outboard_points(mechanism, tree, geometry, link))
        along = (geometry.tape.settle(dot(subtract(p, origin), axis)) for p in outboard)
        return count + sum(geometry.size(c) != 0 for c in along), count if link.parent != GROUND else 0

    return foot if numbers(foot) < numbers(point) else point


def _prismatic_origin(
    mechanism: Mechanism, tree: Tree, geometry: Geometry, link: Link, parent: Frame, axis: Vector
) -> Vector:
    """Where the next joint of the slider is, if that lies on the line of sliding; else the parent's origin."""
    for point in _outboard_points(mechanism, tree, geometry, link):
        away = geometry.settle(cross(axis, subtract(point, parent.origin)))
        if all(geometry.size(c) == 0 for c in away):
            return point
    return parent.origin


def _outboard_joints(mechanism: Mechanism, tree: Tree, link: Link) -> Iterator[tuple[Joint, int | None]]:
    """(joint, index of its first axis seen from the link) for the joints that leave a link outwards."""
    if not link.bodies:  # inside a compound joint: its next motion
        following = next(other for other in tree.links if other.parent == link.index)
        yield tree.joints[link.joint], following.motion.axis
        return
    for child in tree.links:
        if child.parent == link.index:
            yield tree.joints[child.joint], child.motion.axis
    for joint in tree.cut:
        for body, position in ((joint.parent, 0), (joint.child, -1)):
            if body in link.bodies:
                yield joint, (position if joint.axes else None)


def _outboard_points(mechanism: Mechanism, tree: Tree, geometry: Geometry, link: Link) -> Iterator[Vector]:
    for joint, _ in _outboard_joints(mechanism, tree, link):
        yield geometry.vector(joint.point)
    for body in link.bodies:
        com = mechanism.bodies[body].com
        if com is not None:
            yield geometry.vector(com)


def _direction_outwards(
    mechanism: Mechanism, tree: Tree, geometry: Geometry, link: Link, axis: Vector, origin: Vector
) -> Vector | None:
    """What x of a revolute link turns to: the next axis, else the next joint's point, else the centre of mass."""
    candidates = [
        geometry.motion_axes(joint)[index]
        for joint, index in _outboard_joints(mechanism, tree, link)
        if index is not None and joint.axes
    ]
    candidates += [subtract(p, origin) for p in _outboard_points(mechanism, tree, geometry, link)]
    for candidate in candidates:
        across = geometry.settle(cross(axis, candidate))
        if max(geometry.size(c) for c in across) > 1e-9:
            return candidate
    return None


def quarter_turns(phase: Node) -> int | None:
    """How many quarter turns a constant phase is, or None."""
    if phase.value is None:
        return None
    turns = phase.value / (CONTEXT.pi / 2)
    nearest = CONTEXT.nint(turns)
    return int(nearest) % 4 if abs(turns - nearest) < mpmath.mpf(10) ** -40 else None


__all__ = ["GROUND", "Frame", "Geometry", "link_frames", "quarter_turns"]
