"""Rolling: a wheel, a disc or a ball on a plane or on a circle, held by friction where it touches."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import Node, Vector, add, cross, dot, scale, subtract, transform, transpose
from symscrew.description import Point
from symscrew.effects.acting import Acting, between, body_spin
from symscrew.effects.contact_law import contact_law
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import Values
from symscrew.errors import DescriptionError, shorten
from symscrew.kinematics import GROUND


@dataclass(frozen=True, repr=False)
class RollingContact(Effect):
    """A body with its centre at the point `wheel` and the radius r, `radius` [m], rolls on another one, at `ground`.

    With `axis`, absolute in the reference configuration and carried by the wheel's body, it is a thin disc across the
    axis, else a ball. It rolls on the plane through the point `ground` across `normal` (absolute in the reference
    configuration and carried by the point's body); or, with `circle` R [m], in the plane across the axis on the circle
    of that radius about the point `ground`, or within it for R < 0.

    It touches at its point nearest to the ground, at the arm r d from its centre, at the depth delta [m]. The normal
    force is N = k delta^n max(0, 1 + h delta_dot), as of an end stop (`stiffness` k above 0, `exponent` n 1.5 by
    default, `damping` h); or the constant `load` N [N], where joints keep the wheel where it is, as a rack's pinion.
    Along the ground, with the velocity s [m/s] of the wheel's surface against the ground's where they touch,

        F = -N (kappa z + sigma s),      z_dot = s - kappa |s| z / mu,

    z the deflection of the surfaces, a state per direction along the ground [m], at first `initial`. `grip` kappa [1/m]
    above 0 is the stiffness along the ground per normal force, `grip_damping` sigma [s/m] above 0. Without `friction`
    mu the wheel never slides: z is the whole way that its surface has slid, F/(kappa N) and no more however far it
    rolls. It errs by that elastic way against the ideal constraint, nothing else. With mu it slides where it would
    need more than mu N (P. Dahl's law, The Aerospace Corp. TOR-158, 1968): |kappa z| <= mu. Where it does not touch,
    F = 0 and z springs back with z_dot = -kappa z/sigma; so a wheel lifts off and comes down as the forces say.
    Stored: k delta^(n+1)/(n+1); fed beside: F s, and what the damping of the contact takes.

    Warning: a disc that lies flat on a plane touches it nowhere in particular: status 2.

        [[effects]]
        type = "rolling_contact"
        wheel = "hub"
        ground = "road"
        radius = 0.3
        axis = [0, 1, 0]
        stiffness = 2e6
        damping = 0.5
        grip = 500
        grip_damping = 0.5
    """

    wheel: str
    ground: str
    radius: Number
    grip: Number
    grip_damping: Number
    normal: tuple[Number, ...] = (0, 0, 1)
    axis: tuple[Number, ...] = ()
    circle: Number | None = None
    stiffness: Number | None = None
    exponent: Number = 1.5
    damping: Number = 0
    load: Number | None = None
    friction: Number | None = None
    initial: tuple[Number, ...] = (0, 0)
    name: str = ""

    @property
    def label(self) -> str:
        """The name in states."""
        return self.name or self.wheel

    def act(self, acting: Acting) -> None:
        """The force where the wheel touches, on both bodies, and the rates of the deflections."""
        system, tape, what = acting.system, acting.system.tape, f"rolling of {self.wheel} on {self.ground}"
        wheel, ground = acting.point(self.wheel, what), acting.point(self.ground, what)
        if wheel.body == ground.body:
            raise DescriptionError(f"{what}: expected points of two bodies, both are on {wheel.body!r}")
        away, speed = between(system, ground, wheel)
        at = (
            self._on_circle(acting, wheel, away, what)
            if self.circle is not None
            else self._on_plane(acting, ground, away, what)
        )
        lever = add(away, at.arm)
        turning = subtract(cross(body_spin(system, wheel.body), at.arm), cross(body_spin(system, ground.body), lever))
        sliding = add(speed, turning)
        normal, touching = self._pressed(acting, at, -tape.node(dot(at.normal, sliding)), what)
        slides = [tape.node(dot(direction, sliding)) for direction in at.along]
        held = self._held(acting, slides, touching, what)
        force = scale(normal, at.normal) if self.load is None else (tape.zero, tape.zero, tape.zero)
        for direction, slide, part in zip(at.along, slides, held, strict=True):
            force = add(force, scale(-1 * normal * part, direction))
            acting.feed(f"rolling_contact_{self.label}", -(normal * part * slide))
        acting.push(wheel, force, cross(at.arm, force))
        back = scale(-1, force)
        acting.push(ground, back, cross(lever, back))

    def _on_plane(self, acting: Acting, ground: Point, away: Vector, what: str) -> _Touch:
        geometry, tape = acting.system.geometry, acting.system.tape
        radius = acting.number(self.radius, f"{what}: radius", above=0)
        up = _direction(acting, self.normal, f"{what}: normal")
        axis = _direction(acting, self.axis, f"{what}: axis") if self.axis else None
        across = geometry.settle(cross(axis, up)) if axis else None
        if across and any(geometry.size(c) for c in across):  # the first direction is that in which the disc rolls
            along = geometry.unit(across)
        else:
            along = geometry.perpendicular(up)
        n, first, second = (_carried(acting, ground.body, v) for v in (up, along, geometry.settle(cross(up, along))))
        height = tape.node(dot(n, away))
        if axis is None:
            return _Touch(n, (first, second), scale(-1 * radius, n), radius - height)
        axle = _carried(acting, acting.system.mechanism.points[self.wheel].body, axis)
        lean = tape.node(dot(n, axle))
        rise = tape.sqrt(1 - lean * lean)
        down = scale(1 / rise, subtract(scale(lean, axle), n))
        return _Touch(n, (first, second), scale(radius, down), radius * rise - height)

    def _on_circle(self, acting: Acting, wheel: Point, away: Vector, what: str) -> _Touch:
        tape = acting.system.tape
        radius = acting.number(self.radius, f"{what}: radius", above=0)
        circle = acting.number(self.circle, f"{what}: circle")
        outside: list[bool] = []  # whether the wheel rolls on the circle's outside, which the code is for

        def round_it(at: Values) -> None:
            size = at(self.circle, what)
            if not (size > 0 or at(self.radius, what) < -size):
                raise DescriptionError(f"{what}: expected a circle with a radius above 0, or below minus the wheel's")
            if outside and outside[0] != (size > 0):
                side = "above" if outside[0] else "below"
                raise DescriptionError(f"{what}: expected a circle with a radius {side} 0 as derived, got {size:g}")
            outside[:] = [size > 0]

        acting.require(round_it)
        if not self.axis:
            raise DescriptionError(f"{what}: on a circle a wheel needs the key 'axis'")
        axle = _carried(acting, wheel.body, _direction(acting, self.axis, f"{what}: axis"))
        flat = subtract(away, scale(dot(axle, away), axle))
        distance = tape.sqrt(tape.node(dot(flat, flat)))
        outwards = scale(1 / distance, flat)
        n = outwards if outside[0] else scale(-1, outwards)
        depth = radius + circle - distance if outside[0] else radius + circle + distance
        return _Touch(n, (cross(axle, n), axle), scale(-1 * radius, n), depth)

    def _pressed(self, acting: Acting, at: _Touch, rate: Node, what: str) -> tuple[Node, Node]:
        """The normal force, and whether it touches."""
        tape = acting.system.tape
        if (self.load is None) == (self.stiffness is None):
            raise DescriptionError(f"{what}: expected one of 'stiffness', of the ground, and 'load', the normal force")
        if self.load is not None:
            return acting.number(self.load, f"{what}: load", above=0), tape.one
        law = contact_law(acting, self.stiffness, self.exponent, self.damping, what=what)
        force, elastic, stored = law.at(tape, at.depth, rate)
        acting.store(stored)
        acting.feed(f"rolling_contact_{self.label}", (elastic - force) * rate)
        return force, tape.function("less", 0, at.depth)

    def _held(self, acting: Acting, slides: Sequence[Node], touching: Node, what: str) -> list[Node]:
        """kappa z + sigma s per direction along the ground; none where nothing can ever slide."""
        tape = acting.system.tape
        kappa = acting.number(self.grip, f"{what}: grip", above=0)
        sigma = acting.number(self.grip_damping, f"{what}: grip_damping", above=0)
        if len(self.initial) != 2:
            raise DescriptionError(f"{what}: expected 2 entries of 'initial', got {len(self.initial)}")
        loss = tape.zero
        if self.friction is not None:
            speed = tape.sqrt(slides[0] * slides[0] + slides[1] * slides[1])
            loss = kappa * speed * (1 / acting.number(self.friction, f"{what}: friction", above=0))
        result = []
        for k, slide in enumerate(slides):
            if slide is tape.zero:  # across a plane motion
                result.append(tape.zero)
                continue
            name = f"roll_{self.label}_{k + 1}"
            z = acting.state(name, "m", self.initial[k], f"deflection where {self.wheel} rolls")
            acting.state_rate(name, tape.function("select", touching, slide - loss * z, -(kappa / sigma) * z))
            result.append(kappa * z + sigma * slide)
        return result


@dataclass(frozen=True)
class _Touch:
    """Where a wheel touches: normal of the ground, two directions along it, arm from the centre [m], depth [m]."""

    normal: Vector
    along: tuple[Vector, Vector]
    arm: Vector
    depth: Node


def _direction(acting: Acting, given: Sequence[Number], what: str) -> Vector:
    """A unit vector of numbers, absolute axes of the reference configuration."""

    def directed(at: Values) -> None:
        if len(given) != 3 or not any(at(entry, what) for entry in given):
            raise DescriptionError(f"{what}: expected 3 numbers, not all of them 0, got {shorten(given)}")

    acting.require(directed)
    x, y, z = (acting.number(entry, what) for entry in given)
    return acting.system.geometry.unit((x, y, z))


def _carried(acting: Acting, body: str, direction: Vector) -> Vector:
    """A direction that a body carries, absolute axes."""
    system = acting.system
    link = system.tree.link_of_body[body]
    if link == GROUND:
        return direction
    local = system.geometry.settle(transform(transpose(system.frames[link].axes), direction))
    return system.pose[link].direction(local)
