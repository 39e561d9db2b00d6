"""A slender link that bends: a few assumed modes between its ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import mpmath
import numpy as np

from symscrew.algebra import CONTEXT, Node, Vector, cross, dot, scale, subtract, transform, transpose
from symscrew.description import Mechanism, Point, Reader
from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.effects.records import Bending, Passed
from symscrew.errors import DescriptionError, shorten
from symscrew.kinematics import GROUND

MOST = 8
"""Modes at most: the next one of a pinned rod is a hundred times stiffer than the first and moves by a thousandth."""


COUNTS = 0.01
"""Part of the buckling load from which on a run tells the axial force: the square of a frequency is off by that part,
and the deflections' truncation to few modes by 0.001 to 0.01."""
BUCKLING = {"pinned": 1.0, "clamped": 0.25}
"""Euler's load by EI pi^2/L^2."""


@dataclass(frozen=True, repr=False)
class FlexibleLink(Effect):
    """A body bends as a uniform slender rod between its points `start` and `end`, L [m] apart, across its `axis`.

    The deflection w [m] along e, with e = axis x (direction from start to end), both carried by the body, is the sum
    of eta_k phi_k(x), k = 1 ... `modes`, x from the start:

    - `shape` "pinned" (default): phi_k = sin(k pi x/L), a rod of a closed loop, with a joint at either end whose
      bodies turn about parallels to the axis. eta_1 is about the deflection of the middle;
    - "clamped": those of a cantilever, over their value at the end: the last body of a chain, held at the start.
      eta_k add up to the deflection of the free end.

    `bending_stiffness` EI [N m^2] and `line_density` rho [kg/m] above 0; the body's mass and inertia are those of the
    description, the rod's included. With m_k, k_k the integrals of rho phi_k^2 and EI phi_k''^2, omega the body's
    angular velocity, and a(x) the acceleration of the undeflected rod less gravity,

        m_k eta_k_ddot = -k_k eta_k - 2 zeta sqrt(k_k m_k) eta_k_dot + m_k (omega^2 - (omega . e)^2) eta_k
                         - integral rho phi_k e . a(x) dx,                 zeta = `damping` of every mode, at least 0

    and the body's rate of momentum gets the inertial forces of w: those of w_ddot, of Coriolis, and the inertia of the
    deflected shape. Kinetic energy and momentum are exact for this motion of the points. Left out are what the ends
    come nearer by when the rod bends, and the stiffness that an axial force gives or takes, rotary inertia, and shear.
    A run says how large the axial force gets beside the rod's buckling load, where it is more than `COUNTS` of it:
    deflections are off by about as much, and more as they fall out of step. Points of joints stay where they are on
    the body.

    States, per mode: eta_k, at first `initial`, and eta_k_dot + integral rho phi_k e . v(x) dx/m_k [m/s], the velocity
    that includes the body's own: so no rate needs an acceleration. They start without eta_dot. Stored: k_k eta_k^2/2.

        [[effects]]
        type = "flexible_link"
        start = "crank_pin"
        end = "piston_pin"
        axis = [0, 0, 1]
        bending_stiffness = 12.7
        line_density = 0.22
        modes = 2
    """

    looks_back: ClassVar[bool] = True

    start: str
    end: str
    axis: tuple[Number, ...]
    bending_stiffness: Number
    line_density: Number
    modes: int = 2
    shape: str = "pinned"
    damping: Number = 0
    initial: tuple[Number, ...] = ()
    name: str = ""

    @property
    def label(self) -> str:
        """The name in states."""
        return self.name or self.end

    @property
    def depends_on(self) -> frozenset[str]:
        """The inertia: gravity and accelerations bend the body."""
        return frozenset({"inertia"})

    def seen(self, motion: Passed) -> str:
        """The largest axial force at either end, beside Euler's load."""
        mechanism = motion.mechanism
        start, end = (mechanism.points[name] for name in (self.start, self.end))
        along = motion.points[self.end] - motion.points[self.start]
        length = np.linalg.norm(along, axis=1, keepdims=True)
        pulled = [np.zeros(len(along))]
        for point in (start, end):
            total = np.zeros_like(along)
            for joint in mechanism.joints.values():
                if start.body in (joint.parent, joint.child) and _same(mechanism, joint.point, point.at):
                    total += (1 if joint.child == start.body else -1) * motion.forces[joint.name]
            pulled.append(np.abs((total * along / length).sum(axis=1)))
        reader = Reader(dict(mechanism.parameters))
        stiffness = float(mechanism.number(reader.number(self.bending_stiffness, "bending_stiffness")))
        load = BUCKLING[self.shape] * stiffness * float((np.pi / length[0, 0]) ** 2)
        largest = float(max(part.max() for part in pulled))
        if largest < COUNTS * load:
            return ""
        return (
            f"the rod from {self.start} to {self.end} bears {largest:.3g} N along it, {100 * largest / load:.2g} % of "
            "its buckling load: what such a force does to the bending is left out, and deflections are off by about as "
            "much"
        )

    def conclude(self, acting: Acting) -> None:
        """States, energy and inertia of every mode."""
        system, tape, what = acting.system, acting.system.tape, f"flexible link from {self.start} to {self.end}"
        start, end = acting.point(self.start, what), acting.point(self.end, what)
        self._check(acting, (start, end), what)
        link = system.tree.link_of_body[start.body]
        local = [system.local_point(link, system.geometry.vector(point.at)) for point in (start, end)]
        way = system.geometry.settle(subtract(local[1], local[0]))
        length = system.tape.settle(tape.sqrt(tape.node(dot(way, way))))
        along = scale(1 / length, way)
        given = [acting.number(entry, f"{what}: axis") for entry in self.axis]
        turned = transform(transpose(system.frames[link].axes), (given[0], given[1], given[2]))
        across = system.geometry.settle(cross(turned, along))
        if not any(system.geometry.size(c) for c in across):
            raise DescriptionError(f"{what}: expected an axis across the rod, got {shorten(self.axis)}")
        e = system.geometry.unit(across)
        density = acting.number(self.line_density, f"{what}: line_density", above=0)
        stiffness = acting.number(self.bending_stiffness, f"{what}: bending_stiffness", above=0)
        zeta = acting.number(self.damping, f"{what}: damping", least=0)
        for k in range(self.modes):
            first, second, square, bent = self._integrals(acting, k + 1, what)
            share = tape.settle(density * length * first)
            place = system.geometry.settle(
                tuple(share * a + density * length * length * second * b for a, b in zip(local[0], along, strict=True))
            )
            mass = tape.settle(density * length * square)
            spring = tape.settle(stiffness * bent * (1 / (length * length * length)))
            damper = tape.settle(2 * zeta * tape.sqrt(spring * mass))
            self._mode(acting, k, link, felt=(e, share, place), law=(mass, spring, damper))

    def _mode(
        self, acting: Acting, k: int, link: int, *, felt: tuple[Vector, Node, Vector], law: tuple[Node, Node, Node]
    ) -> None:
        """A mode's states, energy and inertia: `felt` are axis, share and place, `law` mass, spring and damper."""
        system, tape = acting.system, acting.system.tape
        (e, share, place), (mass, spring, damper) = felt, law
        twist, label = system.twist[link], f"{self.label}_{k + 1}"
        carried = tape.node(share * dot(e, twist.linear) + dot(cross(place, e), twist.angular)) * (1 / mass)
        begin = acting.value(self.initial[k], "flexible link: initial") if self.initial else 0.0
        eta = acting.state(f"bend_{label}", "m", begin, f"deflection of mode {k + 1}")
        moved = acting.state(f"bend_rate_{label}", "m/s", 0.0, f"velocity of mode {k + 1}", carried=carried)
        rate = moved - carried
        omega, v = twist.angular, twist.linear
        aside = tape.node(dot(omega, e))
        loose = mass * (tape.node(dot(omega, omega)) - aside * aside) * eta
        drive = loose - spring * eta - damper * rate
        turning = tape.node(dot(e, cross(omega, scale(share, v))) + dot(e, cross(omega, cross(omega, place))))
        ground = transform(transpose(system.pose[link].rotation), acting.ground.origin)
        weight = -(share * tape.node(dot(e, ground)))
        acting.state_rate(f"bend_{label}", rate)
        acting.state_rate(f"bend_rate_{label}", (drive + weight - turning) * (1 / mass))
        acting.bendings.append(Bending(link, e, share, place, mass, eta, rate, drive))
        acting.store(acting.half * spring * eta * eta)
        # of the deflected inertia beyond that of the body, and of the deflection's own motion
        spin = cross(omega, e)
        grown = share * eta * dot(v, spin) + eta * dot(cross(omega, place), spin)
        own = acting.half * mass * (eta * eta * dot(spin, spin) + rate * rate)
        acting.kinetic = acting.kinetic + tape.node(grown) + own + mass * rate * carried
        fall = tape.node(dot(ground, scale(rate, e)) + dot(ground, scale(eta, spin)))
        acting.feed(f"flexible_link_{self.label}", -(share * fall) - damper * rate * rate)

    def _check(self, acting: Acting, points: tuple[Point, Point], what: str) -> None:
        start, end = points
        system = acting.system
        if start.body != end.body or start.at == end.at:
            raise DescriptionError(f"{what}: expected two points of one body, got {start.body!r} and {end.body!r}")
        if system.tree.link_of_body[start.body] == GROUND:
            raise DescriptionError(f"{what}: expected points of a body that moves, got the ground's")
        if isinstance(self.modes, bool) or not isinstance(self.modes, int) or not 1 <= self.modes <= MOST:
            raise DescriptionError(f"{what}: expected 1 to {MOST} modes, got {shorten(self.modes)}")
        if self.shape not in ("pinned", "clamped"):
            raise DescriptionError(f"{what}: expected as shape 'pinned' or 'clamped', got {shorten(self.shape)}")
        if len(self.axis) != 3:
            raise DescriptionError(f"{what}: expected 3 entries of the axis, got {len(self.axis)}")
        if len(self.initial) not in (0, self.modes):
            raise DescriptionError(f"{what}: expected {self.modes} entries of 'initial', got {len(self.initial)}")
        if acting.base is not None:
            raise DescriptionError(f"{what}: expected a base at rest; a moving base does not carry its deflection")
        held = (start,) if self.shape == "clamped" else points
        for joint in system.mechanism.joints.values():
            ends = [system.geometry.settle(subtract(system.geometry.vector(joint.point), system.geometry.vector(p.at)))
                    for p in held]  # fmt: skip
            if start.body in (joint.parent, joint.child) and not any(
                all(system.geometry.size(c) == 0 for c in away) for away in ends
            ):
                where = "its start" if self.shape == "clamped" else "its ends"
                raise DescriptionError(
                    f"{what}: joint {joint.name!r} stands where the body bends; expected its joints at {where} only"
                )

    def _integrals(self, acting: Acting, k: int, what: str) -> tuple[Node, Node, Node, Node]:
        """Of phi, xi phi, phi^2 and phi''^2 over xi = x/L from 0 to 1."""
        tape = acting.system.tape
        if self.shape == "pinned":
            turns = acting.number(f"{k}*pi", what)
            first = tape.node(1 - (-1) ** k) / turns
            return first, tape.node(-((-1) ** k)) / turns, acting.half, acting.half * turns * turns * turns * turns
        beta = CONTEXT.findroot(lambda x: CONTEXT.cos(x) + 1 / CONTEXT.cosh(x), CONTEXT.pi * (k - mpmath.mpf("0.5")))
        ratio = (CONTEXT.cosh(beta) + CONTEXT.cos(beta)) / (CONTEXT.sinh(beta) + CONTEXT.sin(beta))
        tip = 2 * (-1) ** (k + 1)
        found = (2 * ratio / beta / tip, 2 / beta**2 / tip, CONTEXT.mpf(1) / 4, beta**4 / 4)
        first, second, square, bent = (tape.constant(value) for value in found)
        return first, second, square, bent


def _same(mechanism: Mechanism, a: Sequence[object], b: Sequence[object]) -> bool:
    """Whether two points are one, to rounding."""
    one, other = (np.array([float(mechanism.number(c)) for c in place]) for place in (a, b))
    return bool(np.abs(one - other).max() <= 1e-12 * max(1.0, np.abs(one).max()))
