"""Drag of a body in a medium, as that of a box."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import sympy

from symscrew.algebra import ZERO, Node, Vector, add, dot, scale, subtract, transform, transpose
from symscrew.description import Point
from symscrew.effects.acting import Acting, body_spin, point_velocity
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import Values
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.kinematics import GROUND

AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
SQUARE = 1e-6
"""Cosine of two axes of a box, and part of their length, up to which they are as texts of six digits write them: forces
are off by as much. Longer ones are divided by their length, others are no axes of a box."""


@dataclass(frozen=True, repr=False)
class FluidDrag(Effect):
    """Forces of a medium at rest, or in a wind, on a body that is a box about its centre of mass.

    With the velocity v of the centre against the medium and omega, both along the box's axes, and its `sides` a, b, c
    [m] there; `density` rho [kg/m^3] and `viscosity` mu [Pa s], at least 0, d = (a + b + c)/3:

        F_x = -3 pi d mu v_x - rho b c |v_x| v_x / 2  [N]
        M_x = -pi d^3 mu omega_x - rho a (b^4 + c^4) |omega_x| omega_x / 64  [N m]

    and so on in turn: Stokes's drag of a sphere as large and the drag of each face, as MuJoCo's inertia model has them.
    `axes`: directions of the box's sides, absolute in the reference configuration; `wind` [m/s]: the medium's velocity,
    absolute.
    Power: F . v + M . omega of the body [W]; at most 0 without wind. No energy is stored.

        [[effects]]
        type = "fluid_drag"
        body = "platform"
        sides = [0.3, 0.2, 0.05]
        density = 1.2
        viscosity = 1.8e-5
    """

    body: str
    sides: tuple[Number, ...]
    density: Number = 0
    viscosity: Number = 0
    wind: tuple[Number, ...] = (0, 0, 0)
    axes: tuple[tuple[Number, ...], ...] = AXES

    def act(self, acting: Acting) -> None:
        """Force and moment at the centre of mass, and what they feed."""
        system, tape, what = acting.system, acting.system.tape, f"drag of {self.body}"
        bodies = system.mechanism.bodies
        if self.body not in bodies:
            raise DescriptionError(
                f"{what}: expected a body, got {shorten(self.body)}; {did_you_mean(self.body, bodies)}"
            )
        com = bodies[self.body].com
        if com is None:
            raise DescriptionError(f"{what}: expected a body with a centre of mass, {self.body!r} has none")
        for key, values in (("sides", self.sides), ("wind", self.wind), ("axes", self.axes)):
            if len(values) != 3 or (key == "axes" and any(len(axis) != 3 for axis in self.axes)):
                raise DescriptionError(f"{what}: {key}: expected three of them, got {len(values)}")
        link = system.tree.link_of_body[self.body]
        if link == GROUND:
            return
        at, carried = Point(f"{self.body}_centre", self.body, com), system.frames[link].axes
        wind = self._vector(acting, self.wind, f"{what}: wind")
        turn = system.pose[link].rotation
        own = point_velocity(system, at), body_spin(system, self.body)
        back = transpose(turn)
        seen = [transform(carried, transform(back, v)) for v in (subtract(own[0], wind), own[1])]
        axes = self._box(acting, f"{what}: axes")
        force, moment = self._drag(acting, axes, seen, what)
        acting.push_in_body_axes(at, force, moment)
        moving = transform(carried, transform(back, own[0]))
        acting.feed(f"fluid_drag_{self.body}", tape.node(dot(force, moving) + dot(moment, seen[1])))

    def _box(self, acting: Acting, what: str) -> list[Vector]:
        """Unit vectors along the box's axes."""
        lengths: list[float] = []

        def square(at: Values) -> None:
            values = np.array([[at(c, what) for c in axis] for axis in self.axes])
            lengths[:] = np.linalg.norm(values, axis=1).tolist()
            cosines = np.triu(values @ values.T, 1) / np.outer(lengths, lengths) if all(lengths) else np.ones(1)
            if np.abs(cosines).max() > SQUARE:
                raise DescriptionError(f"{what}: expected three perpendicular directions, got {shorten(self.axes)}")

        acting.require(square)
        fixed = [not any(acting.varies(c, what) for c in axis) for axis in self.axes]
        unit = [constant and abs(length - 1) <= SQUARE for constant, length in zip(fixed, lengths, strict=True)]
        axes = [self._vector(acting, axis, what) for axis in self.axes]
        return [
            axis if already else scale(1 / acting.system.tape.sqrt(dot(axis, axis)), axis)
            for axis, already in zip(axes, unit, strict=True)
        ]

    def _vector(self, acting: Acting, values: tuple[Number, ...], what: str) -> Vector:
        x, y, z = (acting.number(value, what) for value in values)
        return (x, y, z)

    def _drag(self, acting: Acting, axes: list[Vector], seen: list[Vector], what: str) -> tuple[Vector, Vector]:
        """Force and moment for velocities in the axes that the body carries."""
        tape = acting.system.tape
        sides = [acting.number(side, f"{what}: sides", least=0) for side in self.sides]
        rho = acting.number(self.density, f"{what}: density", least=0)
        mu = acting.number(self.viscosity, f"{what}: viscosity", least=0)
        pi, third = tape.node(sympy.pi), tape.reciprocal(tape.node(3))
        slow = tape.reciprocal(tape.node(64))
        size = (sides[0] + sides[1] + sides[2]) * third
        force, moment = ZERO, ZERO
        for k, axis in enumerate(axes):
            a, b, c = sides[k], sides[(k + 1) % 3], sides[(k + 2) % 3]
            b2, c2 = b * b, c * c
            faces = tape.settle(acting.half * rho * b * c), tape.settle(rho * a * (b2 * b2 + c2 * c2) * slow)
            round_ = tape.settle(3 * pi * mu * size), tape.settle(pi * mu * size * size * size)
            along = [tape.node(dot(axis, v)) for v in seen]
            one, other = (_against(f, r, s) for f, r, s in zip(faces, round_, along, strict=True))
            force, moment = add(force, scale(one, axis)), add(moment, scale(other, axis))
        return force, moment


def _against(faces: Node, round_: Node, speed: Node) -> Node:
    """-(r + f |s|) s."""
    found: Node = -((round_ + faces * speed.tape.function("abs", speed)) * speed)
    return found
