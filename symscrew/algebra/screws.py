"""Screws over any scalar: twists, wrenches, momentum screws, poses.

Everything is at the absolute origin O in absolute axes unless a name says otherwise. A scalar is anything
with + - *: a float, a SymPy expression, a node of the tape. Structural zeros and ones are the Python
integers 0 and 1. Twist and wrench are different types; adding one to the other is an error.

Orders: twist (omega ; v_O), wrench (f ; m_O), momentum screw (p ; L_O), as in the source paper, eqs. (1)-(9),
(28)-(32).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

Scalar = Any
Vector = tuple[Scalar, Scalar, Scalar]
Matrix = tuple[Vector, Vector, Vector]

ZERO: Vector = (0, 0, 0)  # structural: integers fold wherever they go
IDENTITY: Matrix = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def add(a: Vector, b: Vector) -> Vector:
    """a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(s: Scalar, a: Vector) -> Vector:
    """s a."""
    return (s * a[0], s * a[1], s * a[2])


def dot(a: Vector, b: Vector) -> Scalar:
    """a . b."""
    (x, y, z), (u, v, w) = a, b
    return x * u + y * v + z * w


def cross(a: Vector, b: Vector) -> Vector:
    """a x b.

    >>> cross((1, 0, 0), (0, 1, 0))
    (0, 0, 1)
    """
    (x, y, z), (u, v, w) = a, b
    return (y * w - z * v, z * u - x * w, x * v - y * u)


def transform(matrix: Matrix, a: Vector) -> Vector:
    """matrix a."""
    return (dot(matrix[0], a), dot(matrix[1], a), dot(matrix[2], a))


def transpose(matrix: Matrix) -> Matrix:
    """The transposed 3 x 3 matrix."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    return ((a, d, g), (b, e, h), (c, f, i))


def product(a: Matrix, b: Matrix) -> Matrix:
    """The matrix product a b."""
    columns = transpose(b)
    x, y, z = ((dot(row, columns[0]), dot(row, columns[1]), dot(row, columns[2])) for row in a)
    return (x, y, z)


@dataclass(frozen=True)
class Twist:
    """Velocity screw (omega ; v_O): angular velocity [rad/s], velocity of the body's point at O [m/s]."""

    angular: Vector
    linear: Vector

    def __add__(self, other: Twist) -> Twist:
        _same_type(self, other)
        return Twist(add(self.angular, other.angular), add(self.linear, other.linear))

    def __sub__(self, other: Twist) -> Twist:
        _same_type(self, other)
        return Twist(subtract(self.angular, other.angular), subtract(self.linear, other.linear))

    def __mul__(self, factor: Scalar) -> Twist:
        return Twist(scale(factor, self.angular), scale(factor, self.linear))

    __rmul__ = __mul__

    def bracket(self, other: Twist) -> Twist:
        """[V, S] = (omega x s ; omega x s_O + v x s): the rate of a screw S carried by a body of twist V."""
        return Twist(
            cross(self.angular, other.angular),
            add(cross(self.angular, other.linear), cross(self.linear, other.angular)),
        )

    def velocity_at(self, point: Vector) -> Vector:
        """Velocity v_O + omega x r of the body's point at r [m/s]."""
        return add(self.linear, cross(self.angular, point))

    @property
    def components(self) -> tuple[Scalar, ...]:
        """The six components, angular first."""
        return (*self.angular, *self.linear)


@dataclass(frozen=True)
class Wrench:
    """Force screw (f ; m_O): force [N] and moment about O [N m], eq. (32)."""

    force: Vector
    moment: Vector

    def __add__(self, other: Wrench) -> Wrench:
        _same_type(self, other)
        return Wrench(add(self.force, other.force), add(self.moment, other.moment))

    def __sub__(self, other: Wrench) -> Wrench:
        _same_type(self, other)
        return Wrench(subtract(self.force, other.force), subtract(self.moment, other.moment))

    def __mul__(self, factor: Scalar) -> Wrench:
        return Wrench(scale(factor, self.force), scale(factor, self.moment))

    __rmul__ = __mul__

    @property
    def components(self) -> tuple[Scalar, ...]:
        """The six components, force first."""
        return (*self.force, *self.moment)


@dataclass(frozen=True)
class Momentum:
    """Momentum screw (p ; L_O): linear momentum [kg m/s], angular momentum about O [kg m^2/s], eq. (31)."""

    linear: Vector
    angular: Vector

    def __add__(self, other: Momentum) -> Momentum:
        _same_type(self, other)
        return Momentum(add(self.linear, other.linear), add(self.angular, other.angular))

    def rate_along(self, twist: Twist) -> Wrench:
        """V x* M = (omega x p ; omega x L_O + v x p): the rate of a momentum carried along by a twist."""
        return Wrench(
            cross(twist.angular, self.linear),
            add(cross(twist.angular, self.angular), cross(twist.linear, self.linear)),
        )

    @property
    def components(self) -> tuple[Scalar, ...]:
        """The six components, linear first."""
        return (*self.linear, *self.angular)


def reciprocal(twist: Twist, wrench: Wrench) -> Scalar:
    """Reciprocal product omega . m + v . f: the power of the wrench on the twist [W], eq. (10).

    >>> reciprocal(revolute((0, 0, 1), (0, 0, 0)), force_at((0, 1, 0), (2, 0, 0)))
    2
    """
    return dot(twist.angular, wrench.moment) + dot(twist.linear, wrench.force)


def revolute(axis: Vector, point: Vector) -> Twist:
    """Unit screw (e ; r x e) of a revolute joint, eq. (5). `axis` must be a unit vector."""
    return Twist(axis, cross(point, axis))


def prismatic(axis: Vector) -> Twist:
    """Unit screw (0 ; e) of a prismatic joint, eq. (5). `axis` must be a unit vector."""
    return Twist(ZERO, axis)


def helical(axis: Vector, point: Vector, pitch: Scalar) -> Twist:
    """Unit screw (e ; r x e + h e) of a helical joint, pitch h [m/rad]."""
    return Twist(axis, add(cross(point, axis), scale(pitch, axis)))


def force_at(force: Vector, point: Vector) -> Wrench:
    """Wrench (F ; r x F) of a force at a point, eq. (32)."""
    return Wrench(force, cross(point, force))


def couple(moment: Vector) -> Wrench:
    """Wrench (0 ; m) of a pure couple."""
    return Wrench(ZERO, moment)


@dataclass(frozen=True)
class Pose:
    """`base_T_body`: maps body coordinates to base coordinates, x_base = rotation x_body + translation."""

    rotation: Matrix = IDENTITY
    translation: Vector = ZERO

    def __matmul__(self, other: Pose) -> Pose:
        return Pose(product(self.rotation, other.rotation), self.point(other.translation))

    def inverse(self) -> Pose:
        """`body_T_base`."""
        back = transpose(self.rotation)
        return Pose(back, scale(-1, transform(back, self.translation)))

    def point(self, at: Vector) -> Vector:
        """A point of the body in base coordinates."""
        return add(transform(self.rotation, at), self.translation)

    def direction(self, axis: Vector) -> Vector:
        """A direction of the body in base coordinates."""
        return transform(self.rotation, axis)

    def twist(self, twist: Twist) -> Twist:
        """A twist from body coordinates (at the body's origin) to base coordinates (at the base's)."""
        angular = self.direction(twist.angular)
        return Twist(angular, add(self.direction(twist.linear), cross(self.translation, angular)))

    def wrench(self, wrench: Wrench) -> Wrench:
        """A wrench from body coordinates (moment about the body's origin) to base coordinates."""
        force = self.direction(wrench.force)
        return Wrench(force, add(self.direction(wrench.moment), cross(self.translation, force)))


def _same_type(a: object, b: object) -> None:
    if type(a) is not type(b):
        raise TypeError(
            f"expected two screws of the same kind, got {type(a).__name__} and {type(b).__name__}: a twist "
            "and a wrench cannot be added; pair them with reciprocal(twist, wrench)"
        )


def as_vector(values: Sequence[Scalar]) -> Vector:
    """The three values as a vector; raises ValueError for any other length."""
    if len(values) != 3:
        raise ValueError(f"expected 3 components, got {len(values)}")
    x, y, z = values
    return (x, y, z)
