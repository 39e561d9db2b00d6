"""Gravity as a uniform field."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

import sympy

from symscrew.effects.acting import Acting
from symscrew.effects.effect import ALWAYS, Effect
from symscrew.screws import add, dot, scale


@dataclass(frozen=True, repr=False)
class Gravity(Effect):
    """Weight m g of every body at its centre of mass; `acceleration` g [m/s^2] in absolute axes.

    In the recursions the field enters as an acceleration -g of the ground, which gives every body the force
    screw (m g ; r_C x m g) without a term per body. Potential energy: -sum m g . r_C [J], conservative.
    """

    acceleration: tuple[str | int | float | Fraction, ...] = field(default=(0, 0, "-9.81"), metadata=ALWAYS)

    @property
    def exact(self) -> tuple[sympy.Rational, sympy.Rational, sympy.Rational]:
        """The field as exact numbers (a float is read as its shortest decimal)."""
        if len(self.acceleration) != 3:
            raise ValueError(f"gravity: expected 3 components [m/s^2], got {len(self.acceleration)}")
        x, y, z = (_exact(c) for c in self.acceleration)
        return (x, y, z)

    def act(self, acting: Acting) -> None:
        """Accelerate the ground by -g; the potential is -sum g . (m o + R s) over all links."""
        system = acting.system
        field = system.geometry.vector(self.exact)
        acting.accelerate_ground(scale(-1, field))
        for pose, inertia in zip(system.pose[1:], system.inertia[1:], strict=True):
            moment = add(scale(inertia.mass, pose.translation), pose.direction(inertia.first))
            acting.store(-dot(field, moment))


def _exact(value: str | int | float | Fraction) -> sympy.Rational:
    try:
        fraction = Fraction(str(value))
    except ValueError as error:
        raise ValueError(f"gravity: expected finite numbers [m/s^2], got {value!r}") from error
    return sympy.Rational(fraction.numerator, fraction.denominator)
