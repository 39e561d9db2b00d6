"""Tilt and azimuth, torsion, roll, pitch and yaw of the platform over time, with first and second derivatives.

    wanted tilt(t), azimuth(t) --Jet--> what is to be met, and its derivatives
    R, angular velocity, its rate --Jet--> the same of a configuration that moves

The functions of a pose are those of `symscrew.kinematics.body_pose`; here they run on numbers that carry their
derivatives along.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.kinematics import PoseRow, pose_rows

Array = np.ndarray
PARTS = ("tilt", "azimuth", "torsion", "roll", "pitch", "yaw")


@dataclass(frozen=True)
class Jet:
    """Numbers (n,) with their first and second derivative by time."""

    value: Array
    first: Array
    second: Array

    __array_ufunc__ = None  # arrays leave products with jets to jets

    def __add__(self, other: Any) -> Jet:
        o = jet_of(other)
        return Jet(self.value + o.value, self.first + o.first, self.second + o.second)

    def __neg__(self) -> Jet:
        return Jet(-self.value, -self.first, -self.second)

    def __sub__(self, other: Any) -> Jet:
        return self + -jet_of(other)

    def __rsub__(self, other: Any) -> Jet:
        return jet_of(other) - self

    def __mul__(self, other: Any) -> Jet:
        o = jet_of(other)
        second = self.second * o.value + 2 * self.first * o.first + self.value * o.second
        return Jet(self.value * o.value, self.first * o.value + self.value * o.first, second)

    def __truediv__(self, other: Any) -> Jet:
        o = jet_of(other)
        return self * through(o, 1 / o.value, -1 / o.value**2, 2 / o.value**3)

    def __rtruediv__(self, other: Any) -> Jet:
        return jet_of(other) / self

    __radd__, __rmul__ = __add__, __mul__


def jet_of(value: Any) -> Jet:
    """A jet; of a number or an array one that rests."""
    return value if isinstance(value, Jet) else Jet(np.asarray(value, dtype=float), np.zeros(()), np.zeros(()))


def through(x: Jet, f: Array, slope: Array, bend: Array) -> Jet:
    """A function of a jet from its value and its first two derivatives there."""
    return Jet(f, slope * x.first, bend * x.first**2 + slope * x.second)


class _Arithmetic:
    """Roots and angles of jets, for `symscrew.kinematics.body_pose`."""

    def sqrt(self, value: Jet, /) -> Jet:
        """Square root."""
        root = np.sqrt(value.value)
        return through(value, root, 0.5 / root, -0.25 / root**3)

    def atan2(self, y: Jet, x: Jet, /) -> Jet:
        """Angle of (x, y): its rate is (x y' - y x') / (x^2 + y^2)."""
        square = x * x + y * y
        cross, change = x.value * y.first - y.value * x.first, x.value * y.second - y.value * x.second
        rate = cross / square.value
        return Jet(np.arctan2(y.value, x.value), rate, (change - rate * square.first) / square.value)


def wanted_rows(given: Mapping[str, Jet]) -> list[Jet]:
    """What parts of a pose are to be met by, in the order of `rows_of` of the same parts.

    Raises:
        DescriptionError: an azimuth without a tilt, or a tilt of half a turn or more.
    """
    made: list[Jet] = []
    for part, value in given.items():
        if part == "tilt":
            if (np.abs(value.value) >= math.pi).any():
                raise DescriptionError("tilt: expected less than half a turn, pi, at all times")
            half = 0.5 * value
            tangent = np.tan(half.value)
            square = 1 + tangent**2
            size = through(half, tangent, square, 2 * tangent * square)
            about = jet_of(given.get("azimuth", np.zeros(len(value.value))))
            sine, cosine = np.sin(about.value), np.cos(about.value)
            made += [size * through(about, cosine, -sine, -cosine), size * through(about, sine, cosine, -sine)]
        elif part != "azimuth":
            made.append(value)
    return made


def rows_of(parts: Sequence[str]) -> list[PoseRow]:
    """The functions of a pose that parts of it are met by."""
    return pose_rows(dict.fromkeys(parts, 0.0), _Arithmetic(), math.tan)


def met_rows(rows: Sequence[PoseRow], rotation: Array, spin: Array, gain: Array) -> list[Jet]:
    """Their values and derivatives: rotation (n, 3, 3), angular velocity and its rate (n, 3), absolute axes."""
    cross = _crosses(spin)
    first = cross @ rotation
    second = (_crosses(gain) + cross @ cross) @ rotation
    entries = [[Jet(rotation[:, i, j], first[:, i, j], second[:, i, j]) for j in range(3)] for i in range(3)]
    return [row.of(entries, None) for row in rows]


def _crosses(vectors: Array) -> Array:
    """(n, 3, 3) whose products with a vector are the vector products."""
    made = np.zeros((len(vectors), 3, 3))
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        made[:, j, i], made[:, i, j] = vectors[:, k], -vectors[:, k]
    return made
