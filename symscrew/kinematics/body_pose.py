"""A body's displacement by numbers that people give and read: angles about axes, tilt and azimuth, roll, pitch, yaw.

    {"tilt": 0.1, "z": 0.02} --pose_rows--> functions of (R, t) and their goals;    (R, t) --pose_read--> numbers

R and t are the rotation and translation from the reference configuration, absolute axes. The same functions run on
numbers of any kind, and on arrays of many poses, by the arithmetic that is handed in.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError

AXES = "xyz"
STRAIGHT = 1e-10
"""Half a rotation vector shorter than this [rad] is its quaternion's vector part, to better than rounding."""

Number = Any  # a double, a number of many digits, or an array of one for every pose
Reader = Callable[[Any], Number]  # R -> a number of it


class Arithmetic(Protocol):
    """Square root and angle of numbers: `math`, `numpy` with its names, or one of many digits."""

    def sqrt(self, value: Number, /) -> Number:
        """Square root."""

    def atan2(self, y: Number, x: Number, /) -> Number:
        """Angle of (x, y)."""


class Doubles:
    """NumPy under the names that poses use: all poses of an array at once."""

    sqrt, atan2 = staticmethod(np.sqrt), staticmethod(np.arctan2)


@dataclass(frozen=True)
class PoseRow:
    """A number of a pose (R, t) that is to be `goal`; `is_length`: it is in m."""

    of: Callable[[Any, Any], Number]
    goal: Number
    is_length: bool = False


def pose_rows(given: Mapping[str, Number], arithmetic: Arithmetic, tan: Callable[[Number], Number]) -> list[PoseRow]:
    """The rows of the parts of a pose that are given [m, rad]; `tan` is the arithmetic's tangent.

    Raises:
        DescriptionError: an azimuth without a tilt, or a tilt of half a turn or more.
    """
    if "azimuth" in given and "tilt" not in given:
        raise DescriptionError("azimuth is the direction of the axis of a tilt: give the tilt too")
    readers: dict[str, Reader] = {
        "roll": lambda r: roll_pitch_yaw(r, arithmetic)[0],
        "pitch": lambda r: roll_pitch_yaw(r, arithmetic)[1],
        "yaw": lambda r: roll_pitch_yaw(r, arithmetic)[2],
        "torsion": lambda r: torsion(r, arithmetic),
    }
    rows: list[PoseRow] = []
    for part, value in given.items():
        if part in AXES:
            rows.append(_moved_by(AXES.index(part), value))
        elif part == "tilt":
            rows += _tilted(value, given.get("azimuth", 0 * value), tan)
        elif part in readers:
            rows.append(_turned(readers[part], value))
        elif part != "azimuth":
            read = half_turn if part[0] == "q" else rotation_vector
            rows.append(_turned(_entry(read, AXES.index(part[1]), arithmetic), value))
    return rows


def _entry(read: Callable[[Any, Arithmetic], Sequence[Number]], k: int, arithmetic: Arithmetic) -> Reader:
    return lambda r: read(r, arithmetic)[k]


def _turned(read: Reader, goal: Number) -> PoseRow:
    return PoseRow(lambda r, _: read(r), goal)


def _moved_by(axis: int, goal: Number) -> PoseRow:
    return PoseRow(lambda _, t: t[axis], goal, True)


def _tilted(tilt: Number, azimuth: Number, tan: Callable[[Number], Number]) -> list[PoseRow]:
    """(cos a, sin a) tan(tilt / 2), cosine and sine of the azimuth a by its half angle's tangent."""
    largest = float(np.max(np.abs(tilt)))
    if not largest < math.pi:
        raise DescriptionError(f"tilt: expected less than half a turn, 180deg, got {largest:g} rad")
    half, slope = tan(tilt / 2), tan(azimuth / 2)
    size = half / (1 + slope * slope)
    goals = (size * (1 - slope * slope), size * 2 * slope)
    return [_turned(lambda r: half_tilt(r)[0], goals[0]), _turned(lambda r: half_tilt(r)[1], goals[1])]


def body_centre(mechanism: Mechanism, body: str) -> np.ndarray:
    """The centre of a body's joints in the reference configuration [m]: the place whose displacement is the body's."""
    points = [j.point for j in mechanism.joints.values() if body in (j.parent, j.child)]
    return np.asarray(np.mean([[float(mechanism.number(c)) for c in point] for point in points], axis=0))


def half_tilt(r: Any) -> tuple[Number, Number]:
    """(cos a, sin a) tan(tilt / 2), a the azimuth: smooth but for half a turn."""
    across = 1 + r[2][2]
    return -r[1][2] / across, r[0][2] / across


def torsion(r: Any, arithmetic: Arithmetic) -> Number:
    """Angle of the turn about z before the tilt [rad]."""
    return arithmetic.atan2(r[1][0] - r[0][1], r[0][0] + r[1][1])


def tilt_azimuth(r: Any, arithmetic: Arithmetic) -> tuple[Number, Number]:
    """Angle between z and where it is turned to, and the direction of the axis of that turn in the x-y plane [rad]."""
    x, y = -r[1][2], r[0][2]
    sine = arithmetic.sqrt(x * x + y * y)
    upright = sine < STRAIGHT  # then every axis is as good, and x is said
    return arithmetic.atan2(sine, r[2][2]), arithmetic.atan2((1 - upright) * y, (1 - upright) * x + upright)


def roll_pitch_yaw(r: Any, arithmetic: Arithmetic) -> tuple[Number, Number, Number]:
    """Angles of the turns about x, then y, then z, absolute axes: R = Rz Ry Rx [rad]."""
    along = arithmetic.sqrt(r[0][0] * r[0][0] + r[1][0] * r[1][0])
    return (
        arithmetic.atan2(r[2][1], r[2][2]), arithmetic.atan2(-r[2][0], along), arithmetic.atan2(r[1][0], r[0][0])
    )  # fmt: skip


def half_turn(r: Any, arithmetic: Arithmetic) -> list[Number]:
    """The vector part of a rotation's unit quaternion, whose scalar part is positive."""
    scalar = arithmetic.sqrt(1 + r[0][0] + r[1][1] + r[2][2]) / 2
    return [(r[(k + 2) % 3][(k + 1) % 3] - r[(k + 1) % 3][(k + 2) % 3]) / (4 * scalar) for k in range(3)]


def rotation_vector(r: Any, arithmetic: Arithmetic) -> list[Number]:
    """The rotation vector [rad], for angles below half a turn; at the identity by the limit of angle / sine."""
    half = half_turn(r, arithmetic)
    square = half[0] * half[0] + half[1] * half[1] + half[2] * half[2]
    small = square < STRAIGHT**2
    sine = arithmetic.sqrt(square + small * 1)  # nothing is divided by zero
    cosine = arithmetic.sqrt(1 + r[0][0] + r[1][1] + r[2][2]) / 2
    factor = small * 2 + (1 - small) * 2 * arithmetic.atan2(sine, cosine) / sine
    return [factor * c for c in half]


def pose_read(r: Any, t: Any, arithmetic: Arithmetic) -> dict[str, Number]:
    """Every part of a pose by name [m, rad]: what `pose_rows` takes."""
    found = dict(zip(AXES, t, strict=True))
    found |= zip(("rx", "ry", "rz"), rotation_vector(r, arithmetic), strict=True)
    found |= zip(("tilt", "azimuth"), tilt_azimuth(r, arithmetic), strict=True)
    found["torsion"] = torsion(r, arithmetic)
    found |= zip(("roll", "pitch", "yaw"), roll_pitch_yaw(r, arithmetic), strict=True)
    return found
