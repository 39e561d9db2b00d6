"""Rates of the numbers by which a body's pose is given: of a rotation vector, a tilt, roll, pitch and yaw.

(R, t), (omega, velocity) of several motions --numbers with their slopes through `pose_read`--> {part: rates}
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from symscrew.kinematics.body_pose import STRAIGHT, half_turn, pose_read

Array = np.ndarray


class Sloped:
    """A number and its slopes (n,) along several motions, with the arithmetic that poses are read by."""

    def __init__(self, value: float, slope: Array) -> None:
        """`value` of the number, `slope` (n,) of it per unit of time."""
        self.value, self.slope = value, slope

    def __add__(self, other: Sloped | float) -> Sloped:
        return _combined(self, other, lambda a, b: (a + b, 1.0, 1.0))

    def __sub__(self, other: Sloped | float) -> Sloped:
        return _combined(self, other, lambda a, b: (a - b, 1.0, -1.0))

    def __rsub__(self, other: float) -> Sloped:
        return -self + other

    def __mul__(self, other: Sloped | float) -> Sloped:
        return _combined(self, other, lambda a, b: (a * b, b, a))

    def __truediv__(self, other: Sloped | float) -> Sloped:
        return _combined(self, other, lambda a, b: (a / b, 1 / b, -a / b**2))

    def __neg__(self) -> Sloped:
        return Sloped(-self.value, -self.slope)

    def __lt__(self, other: float) -> bool:
        return self.value < other

    __radd__, __rmul__ = __add__, __mul__


Rule = Callable[[float, float], tuple[float, float, float]]  # a, b -> the result, its slopes by a and by b


def _combined(one: Sloped, other: Sloped | float, rule: Rule) -> Sloped:
    if not isinstance(other, Sloped):
        other = Sloped(float(other), np.zeros_like(one.slope))
    value, first, second = rule(one.value, other.value)
    return Sloped(value, first * one.slope + second * other.slope)


class _Arithmetic:
    """Roots and angles of numbers with slopes; where they have none these are not numbers."""

    def sqrt(self, value: Any, /) -> Sloped:
        root = math.sqrt(max(value.value, 0.0))
        return Sloped(root, value.slope / (2 * root) if root else np.full_like(value.slope, np.nan))

    def atan2(self, y: Any, x: Any, /) -> Sloped:
        y, x = (v if isinstance(v, Sloped) else Sloped(float(v), np.zeros(1)) for v in (y, x))
        square = x.value**2 + y.value**2
        slope = (x.value * y.slope - y.value * x.slope) / square if square else np.full_like(y.slope, np.nan)
        return Sloped(math.atan2(y.value, x.value), slope)


def pose_rates(turn: Array, moved: Array, omega: Array, velocity: Array) -> dict[str, Array]:
    """Every part of a pose by name -> its rates (n,) [m/s, rad/s, 1/s] along n motions.

    Args:
        turn: rotation from the reference (3, 3), absolute axes.
        moved: displacement of the body's place [m] (3,).
        omega: angular velocities (n, 3) [rad/s], absolute axes.
        velocity: of the body's place (n, 3) [m/s].

    A rate that does not exist is not a number: that of the tilt and the azimuth of an upright body.
    """
    spun = np.cross(omega[:, None, :], turn.T[None]).transpose(2, 1, 0)  # dR/dt = omega x R, motions last
    r = [[Sloped(float(turn[i, k]), spun[i, k]) for k in range(3)] for i in range(3)]
    t = [Sloped(float(moved[k]), velocity[:, k]) for k in range(3)]
    arithmetic = _Arithmetic()
    found = pose_read(r, t, arithmetic)
    found |= zip(("qx", "qy", "qz"), half_turn(r, arithmetic), strict=True)
    rates = {part: np.asarray(number.slope, dtype=float) for part, number in found.items()}
    if found["tilt"].value < STRAIGHT:
        rates |= dict.fromkeys(("tilt", "azimuth"), np.full(len(omega), np.nan))
    return rates
