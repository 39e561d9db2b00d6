"""Prescribed motion of the base: six axes, as run-time inputs or as expressions of time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy

from symscrew.algebra import Matrix, Node, Vector, add, cross
from symscrew.effects.acting import Acting, power_of_wrench
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import TIME
from symscrew.errors import DescriptionError
from symscrew.kinematics import inertial_wrench, quaternion_matrix, rates
from symscrew.program import QUATERNION, Port

AXES = ("wx", "wy", "wz", "vx", "vy", "vz")
POSE = ("x", "y", "z", "roll", "pitch", "yaw")


@dataclass(frozen=True, repr=False)
class BaseMotion(Effect):
    """The ground moves: every result is then in the axes that the ground carries, and relative to it.

    With the ground's angular velocity omega and the velocity v of its point O, both in its own axes, the recursions
    start from omega, alpha = omega_dot and the acceleration v_dot + omega x v of O instead of from rest. Given

    - by nothing: as inputs `base_twist` (omega ; v) [rad/s ; m/s] and `base_twist_rate`, its rate by components;
      with `attitude` also `base_attitude`, the unit quaternion (w, x, y, z) that turns its axes to absolute ones;
    - by `twist`: six expressions of the time t for (omega ; v);
    - by `pose`: six expressions of t, x, y, z [m] and roll, pitch, yaw [rad], with absolute_R_ground =
      R_z(yaw) R_y(pitch) R_x(roll); differentiated exactly.

    With an attitude or a pose, gravity keeps its absolute direction. Kinetic energy is that of the motion against
    the ground; the power fed is that of the inertial forces: -integral (a_O + alpha x r + omega x (omega x r)) . v dm
    [W] (Coriolis forces do no work). The inertial forces grow with all masses, so it depends on what changes those.

        [[effects]]
        type = "base_motion"
        pose = ["0.1*sin(2*t)", 0, "0.05*cos(3*t)", "0.02*sin(t)", 0, 0]
    """

    twist: tuple[Number, ...] = ()
    pose: tuple[Number, ...] = ()
    attitude: bool = False

    @property
    def depends_on(self) -> frozenset[str]:
        """Gravity, where the attitude is known: the field turns in the axes of the ground."""
        return frozenset({"gravity"}) if self.pose or self.attitude else frozenset()

    def prepare(self, acting: Acting) -> None:
        """Move the ground, before gravity looks at its attitude."""
        what = "base motion"
        if bool(self.twist) + bool(self.pose) + self.attitude > 1:
            raise DescriptionError(f"{what}: expected one of 'twist', 'pose' and 'attitude', got several")
        for name, given in (("twist", self.twist), ("pose", self.pose)):
            if len(given) not in (0, 6):
                raise DescriptionError(f"{what}: expected 6 entries of {name!r}, got {len(given)}")
        if self.pose:
            omega, alpha, acceleration = self._from_pose(acting, what)
        else:
            twist, rate = self._from_twist(acting, what) if self.twist else _inputs(acting)
            omega, v = _halves(twist)
            alpha, v_dot = _halves(rate)
            acceleration = add(v_dot, cross(omega, v))
        if self.attitude:
            labels = ("w", "x", "y", "z")
            text = "attitude of the base: unit quaternion from its axes to absolute axes"
            port = Port("base_attitude", (4,), ("1",) * 4, labels, text, (QUATERNION,) * 4)
            w, x, y, z = acting.input(port, "attitude of the base")
            acting.ground_rotation = quaternion_matrix(w, x, y, z)
        acting.move_ground(omega, alpha, acceleration)

    def act(self, acting: Acting) -> None:
        """The power of the inertial forces."""
        system, ground = acting.system, acting.base
        still = [system.tape.zero] * len(system.tree.v)
        frozen = rates(system.linkage, still, still, ground=ground)
        for link in system.tree.links[1:]:
            force, moment = inertial_wrench(system.inertia[link.index], frozen[link.index])
            acting.feed("base_motion", -power_of_wrench(system, link.index, force, moment))

    def _from_twist(self, acting: Acting, what: str) -> tuple[tuple[Node, ...], tuple[Node, ...]]:
        given = [acting.time_expression(e, f"{what}: {n}") for e, n in zip(self.twist, AXES, strict=True)]
        twist = tuple(acting.of(e, {}, what) for e in given)
        return twist, tuple(acting.of(sympy.diff(e, TIME), {}, what) for e in given)

    def _from_pose(self, acting: Acting, what: str) -> tuple[Vector, Vector, Vector]:
        """Angular velocity, its rate and the acceleration of O in the ground's axes, from roll, pitch and yaw."""
        given = [acting.time_expression(e, f"{what}: {n}") for e, n in zip(self.pose, POSE, strict=True)]
        first = [sympy.diff(e, TIME) for e in given]
        second = [acting.of(sympy.diff(e, TIME), {}, what) for e in first]
        r, p, y = (acting.of(e, {}, what) for e in given[3:])
        dr, dp, dy = (acting.of(e, {}, what) for e in first[3:])
        ddr, ddp, ddy = second[3:]
        f = acting.system.tape.function
        cr, sr, cp, sp, cy, sy = f("cos", r), f("sin", r), f("cos", p), f("sin", p), f("cos", y), f("sin", y)
        rotation = (
            (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
            (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
            (-sp, cp * sr, cp * cr),
        )
        acting.ground_rotation = rotation
        omega = (dr - dy * sp, dp * cr + dy * cp * sr, dy * cp * cr - dp * sr)
        alpha = (
            ddr - ddy * sp - dy * dp * cp,
            ddp * cr - dp * dr * sr + ddy * cp * sr - dy * dp * sp * sr + dy * dr * cp * cr,
            ddy * cp * cr - dy * dp * sp * cr - dy * dr * cp * sr - ddp * sr - dp * dr * cr,
        )
        x, yy, z = (_back(rotation, k, second[:3]) for k in range(3))
        return omega, alpha, (x, yy, z)


def _halves(six: tuple[Node, ...]) -> tuple[Vector, Vector]:
    return (six[0], six[1], six[2]), (six[3], six[4], six[5])


def _back(rotation: Matrix, k: int, vector: Sequence[Node]) -> Node:
    """Component k of rotation^T vector."""
    column: list[Node] = [row[k] for row in rotation]
    return column[0] * vector[0] + column[1] * vector[1] + column[2] * vector[2]


def _inputs(acting: Acting) -> tuple[tuple[Node, ...], tuple[Node, ...]]:
    units = ("rad/s",) * 3 + ("m/s",) * 3
    text = "twist (omega ; v of O) of the base, its own axes"
    twist = acting.input(Port("base_twist", (6,), units, AXES, text), "base")
    port = Port("base_twist_rate", (6,), tuple(f"{u}^2" for u in units), AXES, "rate of base_twist by components")
    return twist, acting.input(port, "base, rate of")
