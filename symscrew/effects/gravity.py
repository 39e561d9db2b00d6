"""Gravity as a uniform field."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy

from symscrew.algebra import ZERO, Vector, add, cross, dot, scale, transform, transpose
from symscrew.description import check_range, exact
from symscrew.effects.acting import Acting
from symscrew.effects.effect import ALWAYS, Effect, Number
from symscrew.errors import DescriptionError, shorten
from symscrew.kinematics import System
from symscrew.program import Port


@dataclass(frozen=True, repr=False)
class Gravity(Effect):
    """Weight m g of every body at its centre of mass; `acceleration` g [m/s^2] in absolute axes.

    In the recursions the field enters as an acceleration -g of the ground, which gives every body the force
    screw (m g ; r_C x m g) without a term per body. Potential energy: -sum m g . r_C [J], conservative.

    `input` "switch" makes a factor of g a run-time input (`gravity_on`: 0 off, 1 on), "field" the field itself
    (`gravity_field`, 3 components [m/s^2] in the axes of the ground, for a base that moves on a vehicle). With
    either, and on a base whose attitude is prescribed, the field changes with time, so nothing is stored: its
    power is that of the weights, g . sum m v_C [W].

        [[effects]]
        type = "gravity"
        acceleration = [0, 0, "-9.81"]
        input = "switch"
    """

    acceleration: tuple[Number, ...] = field(default=(0, 0, "-9.81"), metadata=ALWAYS)
    input: str = ""

    @property
    def exact(self) -> tuple[sympy.Expr, sympy.Expr, sympy.Expr]:
        """The field as exact numbers (a float is read as its shortest decimal)."""
        if not isinstance(self.acceleration, tuple) or len(self.acceleration) != 3:
            raise DescriptionError(f"gravity: expected 3 components [m/s^2], got {shorten(self.acceleration)}")
        x, y, z = (_exact(c) for c in self.acceleration)
        return (x, y, z)

    def act(self, acting: Acting) -> None:
        """Accelerate the ground by -g; the potential is -sum g . (m o + R s) over all links."""
        system = acting.system
        given = system.geometry.vector(self.exact)
        if self.input == "field":
            port = Port("gravity_field", (3,), ("m/s^2",) * 3, ("x", "y", "z"), "field of gravity, axes of the ground")
            x, y, z = acting.input(port, "gravity, component")
            given = (x, y, z)
        elif self.input == "switch":
            port = Port("gravity_on", (1,), ("1",), ("",), "factor of gravity: 0 off, 1 on")
            (factor,) = acting.input(port, "factor of gravity")
            given = scale(factor, given)
        elif self.input:
            raise DescriptionError(f"gravity: expected as input 'switch' or 'field', got {shorten(self.input)}")
        turned = acting.ground_rotation if self.input != "field" else None
        seen = given if turned is None else transform(transpose(turned), given)
        acting.accelerate_ground(scale(-1, seen))
        if self.input or turned is not None:
            acting.feed("gravity", system.tape.node(dot(seen, _momentum(system))))
            return
        for pose, inertia in zip(system.pose[1:], system.inertia[1:], strict=True):
            moment = add(scale(inertia.mass, pose.translation), pose.direction(inertia.first))
            acting.store(-dot(given, moment))


def _exact(value: Number) -> sympy.Expr:
    try:
        number = exact(value, where="gravity")
        check_range(number, "gravity")
    except DescriptionError as error:
        raise DescriptionError(
            f"gravity: expected finite numbers [m/s^2], 0 or of a size from 1e-100 to 1e100, got {shorten(value)}"
        ) from error
    return number


def _momentum(system: System) -> Vector:
    """Momentum of all bodies against the ground [kg m/s], absolute axes."""
    total = ZERO
    for pose, inertia, twist in zip(system.pose[1:], system.inertia[1:], system.twist[1:], strict=True):
        own = add(scale(inertia.mass, twist.linear), cross(twist.angular, inertia.first))
        total = add(total, pose.direction(own))
    return total
