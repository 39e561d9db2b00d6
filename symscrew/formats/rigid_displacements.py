"""Rigid displacements with 50 digits: from the angles and quaternions of a file to axes and points.

    x_outer = R x_inner + t,   Pose(R, t) @ Pose(R', t') = Pose(R R', R t' + t)

A file gives a body relative to its parent, with angles; a description wants absolute axes and points. They
are computed with 50 digits and handed on with 25, and an entry of an elementary rotation within 5e-15 of
0, 1/2, sqrt(1/2), sqrt(3)/2 or 1 counts as that number: it is how files write a right angle in 15 digits,
and a zero that is one makes shorter code.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

import mpmath

from symscrew.errors import DescriptionError

CONTEXT = mpmath.mp.clone()
CONTEXT.dps = 50
DIGITS = 25
"""Digits that are handed on: half of those that are computed with, more than any file has."""
ALL_DIGITS = 48
"""Digits that are handed on where what was computed must be recognised: a zero there is one to 45 digits."""
FLOOR = CONTEXT.mpf(10) ** -22
"""Coordinates [m] and components of axes below this are zero: what sums of numbers of 25 digits leave. Larger ones, as
a file's 1e-17 for zero, are kept; those of rotations are snapped."""
ALL_FLOOR = CONTEXT.mpf(10) ** -45
"""The same where all digits are handed on: nearer to zero nothing is recognised as more than zero."""
SNAP = CONTEXT.mpf(5) * CONTEXT.mpf(10) ** -15
"""An entry of an elementary rotation this close to a round value is that: half a unit of the 15th digit of a right
angle in a file. Further off it stays what the file says, which is a different mechanism by that much."""
UNIT = CONTEXT.mpf(10) ** -40
"""Square of a row's length less 1 beyond which round entries do not belong together: others are exact to 50 digits."""
NO_DIRECTION = CONTEXT.mpf(10) ** -12
"""A vector shorter than this gives no direction: it is refused, since its digits would be rounding of a zero."""
NO_QUATERNION = CONTEXT.mpf(10) ** -20
"""Square of a quaternion's length below which it gives no rotation: it is refused."""
NOTHING = CONTEXT.mpf(10) ** -20
"""An entry of an inertia below this, relative to its largest, is zero: what the turning of a diagonal one leaves."""

Real = Any
"""A number of CONTEXT."""

Triple = tuple[Real, Real, Real]
Rotation = tuple[Triple, Triple, Triple]

_ROUND = tuple(CONTEXT.sqrt(CONTEXT.mpf(n)) / 2 for n in range(5))  # 0, 1/2, sqrt(1/2), sqrt(3)/2, 1


def real(value: Decimal | float | str) -> Real:
    """A decimal with 50 digits."""
    return CONTEXT.mpf(str(value))


def triple(values: Sequence[Decimal | float | str]) -> Triple:
    """Three decimals with 50 digits."""
    x, y, z = (real(v) for v in values)
    return (x, y, z)


ZERO = triple("000")
UNITS: Rotation = (triple("100"), triple("010"), triple("001"))


@dataclass(frozen=True)
class Pose:
    """A displacement: x_outer = rotation x_inner + translation; the rotation as rows."""

    rotation: Rotation = UNITS
    translation: Triple = ZERO

    def __matmul__(self, inner: Pose) -> Pose:
        """This displacement after `inner`: the pose of what `inner` places in the frame of this one."""
        return Pose(product(self.rotation, inner.rotation), self.point(inner.translation))

    def direction(self, vector: Triple) -> Triple:
        """A direction given in the inner frame, in the outer one."""
        return apply(self.rotation, vector)

    def point(self, place: Triple) -> Triple:
        """A point given in the inner frame, in the outer one."""
        return plus(self.direction(place), self.translation)

    def inverse(self) -> Pose:
        """The displacement back."""
        back = transposed(self.rotation)
        return Pose(back, scaled(apply(back, self.translation), -1))


def dot(a: Triple, b: Triple) -> Real:
    """a . b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Triple, b: Triple) -> Triple:
    """a x b."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plus(a: Triple, b: Triple) -> Triple:
    """a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def minus(a: Triple, b: Triple) -> Triple:
    """a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(a: Triple, factor: Real | int) -> Triple:
    """a times a number."""
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def length(a: Triple) -> Real:
    """|a|."""
    return CONTEXT.sqrt(dot(a, a))


def unit(a: Triple, where: str) -> Triple:
    """a / |a|; refuses the zero vector."""
    size = length(a)
    if size < NO_DIRECTION:
        raise DescriptionError(f"{where}: expected a direction, got a vector of length {mpmath.nstr(size, 5)}")
    return scaled(a, 1 / size)


def has_length_one(a: Triple) -> bool:
    """Whether a direction is a unit vector in the digits of doubles."""
    return bool(abs(length(a) - 1) < NO_DIRECTION)


def apply(rotation: Rotation, vector: Triple) -> Triple:
    """A matrix times a vector."""
    return (dot(rotation[0], vector), dot(rotation[1], vector), dot(rotation[2], vector))


def transposed(rotation: Rotation) -> Rotation:
    """A matrix transposed."""
    x, y, z = zip(*rotation, strict=True)
    return (x, y, z)


def product(a: Rotation, b: Rotation) -> Rotation:
    """The product of two matrices."""
    columns = transposed(b)
    return transposed((apply(a, columns[0]), apply(a, columns[1]), apply(a, columns[2])))


def turned_inertia(rotation: Rotation, inertia: Rotation) -> Rotation:
    """R J R^T: an inertia given in inner axes, in outer ones."""
    return product(product(rotation, inertia), transposed(rotation))


def about(axis: Triple, angle: Real) -> Rotation:
    """The rotation by an angle [rad] about a unit axis (Rodrigues)."""
    c, s = CONTEXT.cos(angle), CONTEXT.sin(angle)
    columns = [plus(plus(scaled(e, c), scaled(cross(axis, e), s)), scaled(axis, (1 - c) * dot(axis, e))) for e in UNITS]
    return snapped(transposed((columns[0], columns[1], columns[2])))


def from_quaternion(quaternion: Sequence[Real], where: str) -> Rotation:
    """The rotation of a quaternion (w, x, y, z) of any length but zero."""
    w, x, y, z = quaternion
    size = w * w + x * x + y * y + z * z
    if size < NO_QUATERNION:
        raise DescriptionError(f"{where}: expected a quaternion, got one of length zero")
    return snapped(
        (
            (1 - 2 * (y * y + z * z) / size, 2 * (x * y - w * z) / size, 2 * (x * z + w * y) / size),
            (2 * (x * y + w * z) / size, 1 - 2 * (x * x + z * z) / size, 2 * (y * z - w * x) / size),
            (2 * (x * z - w * y) / size, 2 * (y * z + w * x) / size, 1 - 2 * (x * x + y * y) / size),
        )
    )


def to_quaternion(rotation: Rotation) -> tuple[Real, Real, Real, Real]:
    """The unit quaternion (w, x, y, z) of a rotation, with its largest entry positive, accurate at every angle."""
    (a, b, c), (d, e, f), (g, h, i) = rotation
    outer = (
        (1 + a + e + i, h - f, c - g, d - b),
        (h - f, 1 + a - e - i, b + d, c + g),
        (c - g, b + d, 1 - a + e - i, f + h),
        (d - b, c + g, f + h, 1 - a - e + i),
    )
    w, x, y, z = max((row for row in enumerate(outer)), key=lambda pair: pair[1][pair[0]])[1]
    size = CONTEXT.sqrt(w * w + x * x + y * y + z * z)
    return w / size, x / size, y / size, z / size


def snapped(rotation: Rotation) -> Rotation:
    """A rotation whose entries near round values are these, where its rows then are unit vectors.

    A cosine is near 1 up to angles of 1e-7, whose sines are no rounding: such rows stay as they are.
    """
    rows = [tuple(_snap(entry) for entry in row) for row in rotation]
    if any(abs(dot(row, row) - 1) > UNIT for row in rows):
        return rotation
    return (rows[0], rows[1], rows[2])


def _snap(entry: Real) -> Real:
    near = next((value for value in _ROUND if abs(abs(entry) - value) < SNAP), None)
    if near is None:
        return entry
    return -near if entry < 0 else near


def floored(vector: Triple) -> Triple:
    """A vector without the components that are rounding of zero."""
    x, y, z = (CONTEXT.mpf(0) if abs(entry) < FLOOR else entry for entry in vector)
    return (x, y, z)


def exact(value: Real, floor: Real | None = None, *, digits: int = DIGITS) -> Decimal:
    """A number with so many digits; 0 below `floor`, by default where it is rounding of that."""
    if abs(value) < (floor if floor is not None else FLOOR if digits <= DIGITS else ALL_FLOOR):
        return Decimal(0)
    return Decimal(mpmath.nstr(value, digits, min_fixed=-30, max_fixed=30, strip_zeros=True))


def exact_vector(vector: Triple, *, digits: int = DIGITS) -> list[Decimal]:
    """A vector with so many digits."""
    return [exact(entry, digits=digits) for entry in vector]


def exact_matrix(matrix: Rotation, *, digits: int = DIGITS) -> list[list[Decimal]]:
    """A symmetric matrix with so many digits; entries below 1e-30, or 1e-20 of the largest, are 0.

    Where all digits are handed on, entries that are small because an axis is almost along another are kept.
    """
    largest = max(abs(entry) for row in matrix for entry in row)
    floor = max(largest * NOTHING, CONTEXT.mpf(10) ** -30) if digits <= DIGITS else largest * ALL_FLOOR
    return [[exact((matrix[i][j] + matrix[j][i]) / 2, floor, digits=digits) for j in range(3)] for i in range(3)]
