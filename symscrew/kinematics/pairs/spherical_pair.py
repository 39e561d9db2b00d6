"""A rotation about a point: its coordinates are a unit quaternion, its rates an angular velocity in link axes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.algebra import (
    IDENTITY,
    ZERO,
    Matrix,
    Node,
    Pose,
    Scalar,
    Tape,
    Twist,
    Vector,
    cos,
    product,
    revolute,
    sin,
    transform,
    transpose,
)
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import Frame, Inertia, Placement
from symscrew.kinematics.pairs.lower_pair import Array, LowerPair, Site, Turn
from symscrew.kinematics.pairs.revolute_pair import line_on_axis

STILL = 1e-12
"""Below this angle [rad] sin(a/2)/a is its limit 1/2, to better than a double's last digit; above it is divided."""


ROUNDED = 1e-6
"""Squares of quaternions' lengths may differ from 1 by this much, and the quaternion is divided by its length: numbers
with eight digits are 1e-8 off, with seven or in single precision 3e-7. Beyond, nobody has rounded and it is refused;
dividing by the length is right to first order only, which leaves 2e-12 here."""


class Spherical(LowerPair):
    """S: w = turn v; the axes of w are the absolute ones of the reference configuration, carried by the parent."""

    def frame(self, site: Site) -> Frame:
        """The absolute axes of the reference configuration, at the joint's point."""
        point, rotation = site.point, transpose(site.parent.axes)
        return Frame(IDENTITY, point, rotation, site.in_parent(point), ZERO, site.geometry.tape.zero)

    def placement(self, tape: Tape, frame: Frame, q: Sequence[Node], turn: Turn | None = None) -> Placement:
        """The axes turn by the quaternion."""
        w, x, y, z = q
        return Placement(frame.rotation, quaternion_matrix(w, x, y, z), frame.offset)

    def own_twist(self, frame: Frame, v: Sequence[Scalar]) -> Twist:
        """The angular velocity."""
        x, y, z = v
        return Twist((x, y, z), ZERO)

    def powers(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Scalar, ...]:
        """The moment about the centre."""
        return moment

    def unit_screws(self, frame: Frame) -> tuple[Twist, ...]:
        """(e_k ; 0)."""
        return tuple(Twist(axis, ZERO) for axis in IDENTITY)

    def absolute_screws(self, frame: Frame, placement: Placement, parent: Pose, own: Pose) -> tuple[Twist, ...]:
        """Three through the centre, along the axes before the motion."""
        before = transpose(product(parent.rotation, placement.rotation))
        return tuple(revolute(axis, own.translation) for axis in before)

    def screws(self, axis: Vector, point: Vector, pitch: Scalar) -> tuple[Twist, ...]:
        """Three through the point."""
        return tuple(revolute(unit, point) for unit in IDENTITY)

    def cleared(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Vector, Vector]:
        """The force alone."""
        return force, ZERO

    def base_inertia(self, geometry: Geometry, frame: Frame, own: Inertia) -> tuple[Inertia, Inertia] | None:
        """The mass acts at the centre, which is the parent's point."""
        zero = geometry.tape.zero
        return Inertia(zero, own.first, own.second, own.still), line_on_axis(frame, own.mass, zero, zero)

    def reference(self, value: float) -> tuple[float, ...]:
        """No rotation."""
        return (1.0, 0.0, 0.0, 0.0)

    def moved(self, q: Array, step: Array) -> Array:
        """exp(step) * q, the rotation vector in the axes before the rotation; shapes (..., 4), (..., 3)."""
        angle = np.linalg.norm(step, axis=-1, keepdims=True)
        half = np.where(angle > STILL, sin(angle / 2) / np.where(angle > STILL, angle, 1.0), 0.5)
        c, d = cos(angle / 2), half * step
        w, r = q[..., :1], q[..., 1:]
        scalar = c * w - (d * r).sum(axis=-1, keepdims=True)
        return np.concatenate([scalar, c * r + w * d + np.cross(d, r)], axis=-1)

    def joint_rates(self, placement: Placement, v: Sequence[Node]) -> Sequence[Node]:
        """w = turn v."""
        x, y, z = v
        return transform(placement.turn, (x, y, z))

    def tree_rates(self, placement: Placement, w: Sequence[Node]) -> Sequence[Node]:
        """v = turn^T w."""
        x, y, z = w
        return transform(transpose(placement.turn), (x, y, z))


def squared_length(quaternion: Sequence[Node]) -> Node:
    """The sum of the squares of (w, x, y, z)."""
    w, x, y, z = quaternion
    return (w * w + x * x) + (y * y + z * z)


def quaternion_matrix(w: Node, x: Node, y: Node, z: Node) -> Matrix:
    """Rotation matrix of a quaternion, child axes to parent axes.

    With n = w^2 + x^2 + y^2 + z^2 the factor of the products is 2/n, to first order 4 - 2 n: right to 2 (n - 1)^2,
    which is 2e-12 where functions begin to refuse it (`ROUNDED`), without a division that all else would wait for.
    """
    four = w.tape.node(4)  # before the length: of a difference the tape takes the older term first, and moves signs out
    twice = four - 2 * squared_length((w, x, y, z))
    xx, yy, zz = x * x, y * y, z * z
    x2, y2, z2 = twice * x, twice * y, twice * z
    xy, xz, yz = x * y2, x * z2, y * z2
    wx, wy, wz = w * x2, w * y2, w * z2
    return (
        (1 - twice * (yy + zz), xy - wz, xz + wy),
        (xy + wz, 1 - twice * (xx + zz), yz - wx),
        (xz - wy, yz + wx, 1 - twice * (xx + yy)),
    )


def unit_quaternion(quaternion: Sequence[Node]) -> list[Node]:
    """A quaternion of nearly unit length divided by its length, to first order: right to 3/8 (n - 1)^2."""
    tape = quaternion[0].tape
    half = tape.reciprocal(tape.node(2))
    factor = 3 * half - half * squared_length(quaternion)
    return [factor * entry for entry in quaternion]
