"""Momentum screws and their analytic rates, at O in absolute axes, over any scalar.

M = (p ; r_C x p + J_C omega), p = m v_C, eq. (31). Its rate needs no joint accelerations of its own: with
the body's twist V and twist rate, dM/dt = I dV/dt + V x* M, I the inertia about O in absolute axes.
"""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import Matrix, Momentum, Scalar, Twist, Vector, Wrench, add, cross, scale, transform
from symscrew.kinematics.screws_at_origin import BodyMotion


@dataclass(frozen=True)
class MassProperties:
    """A body's mass [kg], present centre of mass [m] and inertia about it [kg m^2], absolute axes."""

    mass: Scalar
    com: Vector
    inertia: Matrix


def momentum_screw(body: MassProperties, twist: Twist) -> Momentum:
    """Momentum screw of a body moving with `twist`, eq. (31)."""
    linear = scale(body.mass, twist.velocity_at(body.com))
    return Momentum(linear, add(cross(body.com, linear), transform(body.inertia, twist.angular)))


def momentum_rate(body: MassProperties, motion: BodyMotion) -> Wrench:
    """Rate of the momentum screw: the sum of all force screws on the body, eq. (35)."""
    carried = momentum_screw(body, motion.twist).rate_along(motion.twist)
    gained = momentum_screw(body, motion.rate)
    return Wrench(add(carried.force, gained.linear), add(carried.moment, gained.angular))
