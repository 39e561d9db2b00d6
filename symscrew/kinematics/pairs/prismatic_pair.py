"""A translation along an axis: the link keeps its parent's axes, and the force along the axis does work."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symscrew.algebra import (
    IDENTITY,
    ZERO,
    Node,
    Pose,
    Scalar,
    Tape,
    Twist,
    Vector,
    add,
    cross,
    dot,
    prismatic,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import NO_SPREAD, Frame, Inertia, Placement
from symscrew.kinematics.pairs.lower_pair import LowerPair, Site, Turn


class Prismatic(LowerPair):
    """P: offset + (q + phase) axis."""

    def frame(self, site: Site) -> Frame:
        """The parent's axes, at a point that costs nothing further out."""
        geometry, axis, reference = site.geometry, site.axis, site.reference
        local = geometry.settle(transform(transpose(site.parent.axes), axis))
        origin, phase = _origin(site, axis), geometry.tape.node(-reference)
        resting = site.resting_frame(origin)
        away = subtract(site.in_parent(site.point), resting.offset)
        arm = geometry.settle(subtract(away, scale(dot(away, local), local)))
        return replace(resting, axis=local, phase=phase, reference=reference, arm=arm)

    def placement(self, tape: Tape, frame: Frame, q: Sequence[Node], turn: Turn | None = None) -> Placement:
        """The origin slides along the axis."""
        # offset along the sliding direction and q are one sum: phase + q + constant
        return Placement(frame.rotation, IDENTITY, _slide(tape, frame, q[0] + frame.phase))

    def own_twist(self, frame: Frame, v: Sequence[Scalar]) -> Twist:
        """A velocity along the axis."""
        return Twist(ZERO, scale(v[0], frame.axis))

    def powers(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Scalar, ...]:
        """The force along the axis."""
        return (dot(frame.axis, force),)

    def unit_screws(self, frame: Frame) -> tuple[Twist, ...]:
        """(0 ; e): link axes are the parent's."""
        return (Twist(ZERO, frame.axis),)

    def absolute_screws(self, frame: Frame, placement: Placement, parent: Pose, own: Pose) -> tuple[Twist, ...]:
        """(0 ; e)."""
        return (prismatic(parent.direction(frame.axis)),)

    def screws(self, axis: Vector, point: Vector, pitch: Scalar) -> tuple[Twist, ...]:
        """(0 ; e)."""
        return (prismatic(axis),)

    def cleared(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Vector, Vector]:
        """Without the force along the axis, which acts on the line through the joint's point."""
        axis = frame.axis
        along = axis[0] * force[0] + axis[1] * force[1] + axis[2] * force[2]
        return subtract(force, scale(along, axis)), subtract(moment, scale(along, cross(frame.arm, axis)))

    def base_inertia(self, geometry: Geometry, frame: Frame, own: Inertia) -> tuple[Inertia, Inertia] | None:
        """The angular inertia is the parent's, with which the slider turns."""
        return Inertia(own.mass, own.first, NO_SPREAD), Inertia(geometry.tape.zero, ZERO, own.second, own.still)


def _origin(site: Site, axis: Vector) -> Vector:
    """Where the next joint of the slider is, if that lies on the line of sliding; else the parent's origin."""
    geometry, parent = site.geometry, site.parent
    for point in site.outboard_points():
        away = geometry.settle(cross(axis, subtract(point, parent.origin)))
        if all(geometry.vanishes(c) for c in away):
            return point
    return parent.origin


def _slide(tape: Tape, frame: Frame, along: Node) -> Vector:
    if all(tape.node(c).value is not None for c in (*frame.axis, *frame.offset)):
        # collect constants first, so that an offset along the axis costs no operation of its own
        start = dot(frame.offset, frame.axis)
        return add(subtract(frame.offset, scale(start, frame.axis)), scale(along + start, frame.axis))
    return add(frame.offset, scale(along, frame.axis))
