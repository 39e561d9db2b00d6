"""Coordinates of a motion by the names that people type: of joints, of the platform, of any body.

    "tilt", "limb2_S.rx", "platform.z" --at a point of the motion--> a CasADi expression of its unknowns
    {"tilt": 0.2, "azimuth": 1.0} --rows--> what is to be met there, smooth where the pose is upright

Names and what they mean: `symscrew.kinematics.coordinate_names`. Poses are those of `symscrew.kinematics.body_pose`,
with CasADi's functions for its arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping
from typing import Any

import casadi as ca

from symscrew.description import Mechanism, to_text
from symscrew.errors import DescriptionError
from symscrew.kinematics import half_turn, pose_read, pose_rows, virtual_joint
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.problem import Range
from symscrew.optimisation.rows import INFINITY
from symscrew.optimisation.terms import expression
from symscrew.optimisation.typed_names import label_of

AXES = "xyz"
NEAR = 0.1  # square of the sine of half an angle: 37 degrees; below, the arc sine is summed as a series
TERMS = 16  # of it: the next one is 0.1^16 / 300 at most, below rounding
STRAIGHT = 1e-20  # square of a rotation vector [rad^2] whose sine is itself to the last digit
NOT_BOUNDED = ("azimuth", "turn")  # an upright pose has every azimuth, and a turn is three numbers


class _Arithmetic:
    """The arithmetic of `symscrew.kinematics.body_pose` on expressions."""

    def sqrt(self, value: Any, /) -> Any:
        return ca.sqrt(value)

    def atan2(self, y: Any, x: Any, /) -> Any:
        return ca.atan2(y, x)


ARITHMETIC = _Arithmetic()


def coordinate(at: MotionQuantities, typed: str) -> Any:
    """The value of a coordinate at a point of the motion [rad, m]."""
    mechanism = at.model.system.mechanism
    label = label_of(mechanism, typed)
    if label in at.coordinates:
        return at.coordinates[label]
    owner, _, part = label.rpartition(".")
    if owner in mechanism.joints:  # an entry of a quaternion that the tree does not carry
        vector = [at.coordinates[f"{owner}.{c}"] for c in AXES]
        square = sum((c * c for c in vector), start=ca.SX(0))
        straight = square < STRAIGHT
        angle = ca.sqrt(square + straight)
        return vector[AXES.index(part[1])] * (straight * 0.5 + (1 - straight) * ca.sin(angle / 2) / angle)
    virtual = virtual_joint(mechanism)
    if virtual is not None and owner == virtual.name:  # on which the package hangs the platform
        owner = virtual.child
    if owner not in mechanism.bodies:
        raise DescriptionError(
            f"{typed}: this coordinate is none of the tree's; name the platform's, such as z or tilt"
        )
    return _read(part, *_pose(at, owner))


def coordinate_rate(at: MotionQuantities, typed: str) -> Any:
    """The rate of a coordinate at a point of the motion [rad/s, m/s]."""
    model = at.model
    label = label_of(model.system.mechanism, typed)
    if label in model.rate_labels:
        return at.rate(label)
    body, _, part = label.rpartition(".")
    turn, moved = _pose(at, body)
    known = ca.vertcat(*[turn[i][k] for i in range(3) for k in range(3)], *moved)
    pose = ca.SX.sym("pose", 12)
    value = _read(part, [[pose[3 * i + k] for k in range(3)] for i in range(3)], [pose[9 + k] for k in range(3)])
    slope = ca.substitute(ca.jacobian(value, pose), pose, known)
    twist = at.body_twist(body)
    spun = ca.skew(twist[:3]) @ ca.vertcat(*[ca.horzcat(*row) for row in turn])
    place = ca.vertcat(*moved) + _centre(at, body)
    velocity = twist[3:] + ca.cross(twist[:3], place)
    return slope @ ca.vertcat(ca.vec(spun.T), velocity)


def _read(part: str, turn: list[list[Any]], moved: list[Any]) -> Any:
    """A part of a pose."""
    if part[0] == "q":
        return half_turn(turn, ARITHMETIC)[AXES.index(part[1])]
    if part[0] == "r" and part[1:] in AXES:
        return _rotation_vector(turn)[AXES.index(part[1])]
    return pose_read(turn, moved, ARITHMETIC)[part]


def _rotation_vector(turn: list[list[Any]]) -> list[Any]:
    """The rotation vector as a smooth function: by a series where the angle is small, so that it can be enclosed."""
    half = half_turn(turn, ARITHMETIC)  # sine of half the angle, along the axis
    square = sum((c * c for c in half), start=ca.SX(0))
    series, term = ca.SX(0), ca.SX(1)
    for n in range(TERMS):
        series += math.comb(2 * n, n) / (4**n * (2 * n + 1)) * term
        term *= square
    near = square < NEAR
    sine = ca.sqrt(ca.if_else(near, 1, square))
    factor = ca.if_else(near, series, ca.asin(sine) / sine)
    return [2 * factor * c for c in half]


def _pose(at: MotionQuantities, body: str) -> tuple[list[list[Any]], list[Any]]:
    """Rotation of a body from the reference, and the displacement of the centre of its joints."""
    turn, translation = at.body_pose(body)
    centre = _centre(at, body)
    moved = turn @ centre + translation - centre
    return [[turn[i, k] for k in range(3)] for i in range(3)], [moved[k] for k in range(3)]


def _centre(at: MotionQuantities, body: str) -> ca.SX:
    """The centre of a body's joints in the reference configuration."""
    mechanism = at.model.system.mechanism
    points = [j.point for j in mechanism.joints.values() if body in (j.parent, j.child)]
    centre = ca.SX(3, 1)
    for k in range(3):
        middle = sum(point[k] for point in points) / len(points)
        baked = {p.symbol: p.value for name, p in mechanism.parameters.items() if name not in at.parameters}
        centre[k] = expression(to_text(middle.xreplace(baked)), at.parameters, where=f"centre of {body}")
    return centre


def poses_of(mechanism: Mechanism, given: Mapping[str, float], labels: Collection[str]) -> dict[str, dict[str, str]]:
    """Body -> part of its pose -> the name as it was typed; parts in one order. Not what is a label of a joint."""
    found: dict[str, dict[str, str]] = {}
    for typed in given:
        label = label_of(mechanism, typed)
        owner, _, part = label.rpartition(".")
        if label not in labels and owner in mechanism.bodies:
            found.setdefault(owner, {})[part] = typed
    return {body: dict(sorted(parts.items())) for body, parts in found.items()}


def pose_conditions(
    at: MotionQuantities, body: str, parts: Mapping[str, str]
) -> list[tuple[str, Any, Callable[[Mapping[str, float]], float], bool]]:
    """(what it is, the expression, its goal from values by typed name, whether it is a length) of parts of a pose."""
    turn, moved = _pose(at, body)

    def goals(given: Mapping[str, float]) -> list[float]:
        return [float(row.goal) for row in rows({part: given[typed] for part, typed in parts.items()})]

    def rows(values: Mapping[str, float]) -> list[Any]:
        return pose_rows(values, ARITHMETIC, math.tan)

    upright = dict.fromkeys(parts, 0.0)
    names = [name for part, typed in parts.items() if part != "azimuth" for name in _rows_named(part, typed)]

    def goal(k: int) -> Callable[[Mapping[str, float]], float]:
        return lambda given: goals(given)[k]

    return [
        (name, row.of(turn, moved), goal(k), row.is_length)
        for k, (name, row) in enumerate(zip(names, rows(upright), strict=True))
    ]


def _rows_named(part: str, typed: str) -> list[str]:
    """What the rows of a part of a pose are called: a tilt with its direction is two."""
    return [f"{typed}, about x", f"{typed}, about y"] if part == "tilt" else [typed]


def bounded(at: MotionQuantities, typed: str, limits: Range) -> tuple[Any, Callable[[Range], Range], float | None]:
    """(the expression, its range from that of the coordinate, what a violation is measured by) of a bound.

    Of a tilt that is 1 - cos(tilt), which is smooth where the body is upright.

    Raises:
        DescriptionError: a coordinate that has no bounds.
    """
    label = label_of(at.model.system.mechanism, typed)
    owner, _, part = label.rpartition(".")
    pose = label not in at.coordinates and owner in at.model.system.mechanism.bodies
    if pose and part in NOT_BOUNDED:
        raise DescriptionError(f"bounds.joints: {typed} cannot be bounded; bound tilt, rx, ry, rz, roll, pitch or yaw")
    if not pose or part != "tilt":
        return coordinate(at, typed), lambda given: given, None
    turn, _ = _pose(at, owner)

    def risen(given: Range) -> Range:
        low, high = given
        least = 1 - math.cos(min(low, math.pi)) if low > 0 else -INFINITY
        return least, 1 - math.cos(high) if 0 <= high < math.pi else (INFINITY if high > 0 else -1.0)

    size = max((abs(x) for x in risen(limits) if math.isfinite(x) and x), default=1.0)
    return 1 - turn[2][2], risen, size
