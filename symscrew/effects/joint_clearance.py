"""Clearance of a bearing: a pin that moves within its hole and strikes its wall."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import ZERO, Node, Vector, add, cross, dot, scale, subtract, transform, transpose
from symscrew.description import Point
from symscrew.effects.acting import Acting, between, body_spin
from symscrew.effects.contact_law import contact_law
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import Values
from symscrew.errors import DescriptionError
from symscrew.kinematics import GROUND


@dataclass(frozen=True, repr=False)
class JointClearance(Effect):
    """A pin with its centre at the point `pin`, in a hole with its centre at `hole`, of another body.

    It stands where the description has no joint. With the eccentricity e [m] from the hole's centre to the pin's, its
    size |e|, and the direction n = e/|e|, the pin is free while |e| is at most `clearance` c, the difference of the
    radii [m] above 0; beyond, at the depth d = |e| - c, the wall pushes it back (Hunt and Crossley; see
    `symscrew.effects.contact_law` for h from a coefficient of restitution):

        F = k d^n max(0, 1 + h d_dot)  [N] along -n,      `stiffness` k [N/m^n] above 0, `damping` h [s/m] at least 0

    and `exponent` n 1, 1.5 (default, Hertz) or 2. With `axis`, absolute in the reference configuration and carried by
    the hole's body, only what is across the axis counts: a cylindrical pin, free along its axis. Without, a ball in a
    socket; in a plane both are the same.

    `friction` mu at least 0: beside, the wall rubs with -mu F v_t/sqrt(v_t^2 + v0^2) where the pin touches it, v_t the
    velocity there of the pin's surface against the hole's, `radius` [m] of the pin (default 0), `velocity` v0 [m/s]
    above 0 as in dry_friction. Stored: k d^(n+1)/(n+1); what damping and friction take is never below 0.

        [[effects]]
        type = "joint_clearance"
        hole = "piston"
        pin = "rod_end"
        clearance = 5e-4
        stiffness = 6.6e10
        damping = 0.5
    """

    hole: str
    pin: str
    clearance: Number
    stiffness: Number
    exponent: Number = 1.5
    damping: Number = 0
    friction: Number = 0
    velocity: Number | None = None
    radius: Number = 0
    axis: tuple[Number, ...] = ()

    def act(self, acting: Acting) -> None:
        """The force of the wall on both bodies, and its friction."""
        tape = acting.system.tape
        what = f"clearance between {self.hole} and {self.pin}"
        hole, pin = acting.point(self.hole, what), acting.point(self.pin, what)
        if hole.body == pin.body:
            raise DescriptionError(f"{what}: expected points of two bodies, both are on {hole.body!r}")
        clearance = acting.number(self.clearance, f"{what}: clearance", above=0)
        law = contact_law(acting, self.stiffness, self.exponent, self.damping, what=what)
        real, speed = between(acting.system, hole, pin)
        away = real
        moved = speed
        if self.axis:
            away, moved = self._across(acting, hole, (real, speed), what)
        square = tape.node(dot(away, away))
        touching = tape.function("less", clearance * clearance, square)
        size = tape.sqrt(tape.function("select", touching, square, clearance * clearance))  # never 0: no pole within
        outwards = scale(1 / size, away)
        rate = tape.node(dot(outwards, moved))
        force, elastic, stored = law.at(tape, size - clearance, rate)
        acting.store(stored)
        acting.feed(f"joint_clearance_{self.pin}", (elastic - force) * rate)
        wall, arm = scale(-1 * force, outwards), ZERO
        mu = acting.number(self.friction, f"{what}: friction", least=0)
        if mu is not tape.zero:
            arm = scale(acting.number(self.radius, f"{what}: radius", least=0), outwards)
            lever = add(real, arm)  # from the hole's centre to where the pin touches
            surfaces = subtract(
                cross(body_spin(acting.system, pin.body), arm), cross(body_spin(acting.system, hole.body), lever)
            )
            wall = add(wall, self._rubbing(acting, outwards, add(speed, surfaces), mu * force))
        acting.push(pin, wall, cross(arm, wall))
        back = scale(-1, wall)
        acting.push(hole, back, cross(add(real, arm), back))

    def _across(self, acting: Acting, hole: Point, relative: tuple[Vector, Vector], what: str) -> tuple[Vector, Vector]:
        """Eccentricity across the axis, for a pin that is free along it, and what its size changes by."""
        system, (away, speed) = acting.system, relative
        if len(self.axis) != 3:
            raise DescriptionError(f"{what}: expected 3 entries of the axis, got {len(self.axis)}")
        x, y, z = (acting.number(entry, f"{what}: axis") for entry in self.axis)

        def directed(at: Values) -> None:
            if not any(at(entry, f"{what}: axis") for entry in self.axis):
                raise DescriptionError(f"{what}: expected an axis other than 0")

        acting.require(directed)
        axis = system.geometry.settle(scale(1 / system.tape.sqrt(x * x + y * y + z * z), (x, y, z)))
        link = system.tree.link_of_body[hole.body]
        if link != GROUND:
            axis = system.pose[link].direction(
                system.geometry.settle(transform(transpose(system.frames[link].axes), axis))
            )
        along = dot(axis, away)
        turning = cross(body_spin(system, hole.body), axis)
        return subtract(away, scale(along, axis)), subtract(speed, scale(along, turning))

    def _rubbing(self, acting: Acting, outwards: Vector, sliding: Vector, level: Node) -> Vector:
        """Friction of a level on the pin, against what its surface slides by across the normal."""
        tape, what = acting.system.tape, f"clearance between {self.hole} and {self.pin}"
        if self.velocity is None:
            raise DescriptionError(f"{what}: friction needs the key 'velocity', below which it fades")
        fade = acting.number(self.velocity, f"{what}: velocity", above=0)
        tangent = subtract(sliding, scale(dot(outwards, sliding), outwards))
        size = tape.sqrt(tape.node(dot(tangent, tangent)) + fade * fade)
        rub = scale(-1 * level * (1 / size), tangent)
        acting.feed(f"joint_clearance_{self.pin}", tape.node(dot(rub, tangent)))
        return rub
