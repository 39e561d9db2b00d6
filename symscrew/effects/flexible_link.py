"""A slender link that bends: a few assumed modes between its ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import mpmath
import numpy as np

from symscrew.algebra import CONTEXT, ZERO, Node, Vector, add, cross, dot, scale, subtract, transform, transpose
from symscrew.description import Mechanism, Point, Reader
from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import Values
from symscrew.effects.records import Bending, Passed
from symscrew.errors import DescriptionError, shorten
from symscrew.kinematics import GROUND

MOST = 8
"""Modes at most: the next one of a pinned rod is a hundred times stiffer than the first and moves by a thousandth."""


COUNTS = 0.01
"""Part of the buckling load from which on a run tells the axial force: the square of a frequency is off by that part,
and the deflections' truncation to few modes by 0.001 to 0.01."""
AGAIN = 0.08
"""The same with `geometric_stiffness`: what is still left out counts an eighth of it (3.7 % at 32 % of that load)."""
TYPED = 0.02
"""Part by which a rod may be heavier than the body that it belongs to, which few digits and a width of the rod make."""
BUCKLING = {"pinned": 1.0, "clamped": 0.25}
"""Euler's load by EI pi^2/L^2."""


@dataclass(frozen=True)
class _Mode:
    """A mode's name and link; axis, share and place; mass, spring and damper; deflection, its rate, what is carried."""

    label: str
    link: int
    felt: tuple[Vector, Node, Vector]
    law: tuple[Node, Node, Node]
    eta: Node
    rate: Node
    carried: Node


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
    description, the rod's included (less than the rod's is refused).
    With m_k, k_k the integrals of rho phi_k^2 and EI phi_k''^2, omega the body's
    angular velocity, and a(x) the acceleration of the undeflected rod less gravity,

        m_k eta_k_ddot = -k_k eta_k - 2 zeta sqrt(k_k m_k) eta_k_dot + m_k (omega^2 - (omega . e)^2) eta_k
                         - integral rho phi_k e . a(x) dx,                 zeta = `damping` of every mode, at least 0

    and the body's rate of momentum gets the inertial forces of w: those of w_ddot, of Coriolis, and the inertia of the
    deflected shape. Kinetic energy and momentum are exact for this motion of the points. Left out are what the ends
    come nearer by when the rod bends, rotary inertia, shear and, by default, the stiffness that an axial force gives or
    takes. A run says how large that force gets beside the rod's buckling load, where it is more than `COUNTS` of it:
    deflections are off by about as much, and more as they fall out of step. Points of joints stay where they are on
    the body.

    `geometric_stiffness = true` adds to m_k eta_k_ddot the force of the tension N(x) in the rod,

        - sum over j of eta_j integral N phi_j' phi_k' dx,    N = N(L) - integral from x to L of rho s . a(x) dx,

    s along the rod; N(L) is the force of the joints at `end`, 0 of a cantilever. It is that of the same state and
    drives (or accelerations) without this stiffness: exact to the square of eta/L. It takes all reactions, as
    friction by load does, and the rates of the states are then functions of the drives, too. The work of N on what
    the ends come nearer by is booked as `flexible_link_<name>_axial`: the mechanism's motion does not get it.

    States, per mode: eta_k, at first `initial`, and eta_k_dot + integral rho phi_k e . v(x) dx/m_k [m/s], the velocity
    that includes the body's own: so no rate needs an acceleration. They start with eta_dot = `initial_rate`, by default
    0. Stored: k_k eta_k^2/2.

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
    initial_rate: tuple[Number, ...] = ()
    geometric_stiffness: bool = False
    name: str = ""

    @property
    def label(self) -> str:
        """The name in states."""
        return self.name or self.end

    @property
    def depends_on(self) -> frozenset[str]:
        """The inertia: gravity and accelerations bend the body; reactions, where the axial force counts."""
        return frozenset({"inertia", "reactions"} if self.geometric_stiffness else {"inertia"})

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
        share = largest / load
        text = f"the rod from {self.start} to {self.end} bears {largest:.3g} N along it, {100 * share:.2g} % of "
        text += "its buckling load: "
        if self.geometric_stiffness:
            left = "what its ends come nearer by is left out, and deflections are off by about an eighth of that"
            return "" if share < AGAIN else text + left
        if share < COUNTS:
            return ""
        return (
            f"{text}what such a force does to the bending is left out, and deflections are off by about as much; "
            "'geometric_stiffness = true' takes it in"
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
        acting.require(lambda at: self._within(at, system.mechanism, (start, end), what))
        modes = []
        for k in range(self.modes):
            first, second, square, bent = self._integrals(acting, k + 1, what)
            share = tape.settle(density * length * first)
            place = system.geometry.settle(
                tuple(share * a + density * length * length * second * b for a, b in zip(local[0], along, strict=True))
            )
            mass = tape.settle(density * length * square)
            spring = tape.settle(stiffness * bent * (1 / (length * length * length)))
            damper = tape.settle(2 * zeta * tape.sqrt(spring * mass))
            modes.append(self._mode(acting, k, link, felt=(e, share, place), law=(mass, spring, damper)))
        pulls = self._pulls(acting, [mode.eta for mode in modes], (local[0], along, length, density), end)
        for mode, pull in zip(modes, pulls, strict=True):
            self._move(acting, mode, pull)

    def _mode(
        self, acting: Acting, k: int, link: int, *, felt: tuple[Vector, Node, Vector], law: tuple[Node, Node, Node]
    ) -> _Mode:
        """A mode's states: `felt` are axis, share and place, `law` mass, spring and damper."""
        tape, twist, label = acting.system.tape, acting.system.twist[link], f"{self.label}_{k + 1}"
        (e, share, place), mass = felt, law[0]
        carried = tape.node(share * dot(e, twist.linear) + dot(cross(place, e), twist.angular)) * (1 / mass)
        begin, rate = (given[k] if given else 0 for given in (self.initial, self.initial_rate))
        eta = acting.state(f"bend_{label}", "m", begin, f"deflection of mode {k + 1}")
        moved = acting.state(f"bend_rate_{label}", "m/s", rate, f"velocity of mode {k + 1}", carried=carried)
        return _Mode(label, link, felt, law, eta, moved - carried, carried)

    def _move(self, acting: Acting, mode: _Mode, pull: Node) -> None:
        """A mode's rates, energy and inertia; `pull` is the force of the rod's tension on it."""
        system, tape = acting.system, acting.system.tape
        (e, share, place), (mass, spring, damper) = mode.felt, mode.law
        link, eta, rate = mode.link, mode.eta, mode.rate
        omega, v = system.twist[link].angular, system.twist[link].linear
        aside = tape.node(dot(omega, e))
        loose = mass * (tape.node(dot(omega, omega)) - aside * aside) * eta
        drive = loose - spring * eta - damper * rate + pull
        turning = tape.node(dot(e, cross(omega, scale(share, v))) + dot(e, cross(omega, cross(omega, place))))
        ground = transform(transpose(system.pose[link].rotation), acting.ground.origin)
        weight = -(share * tape.node(dot(e, ground)))
        acting.state_rate(f"bend_{mode.label}", rate)
        acting.state_rate(f"bend_rate_{mode.label}", (drive + weight - turning) * (1 / mass))
        acting.bendings.append(Bending(link, e, share, place, mass, eta, rate, drive))
        acting.store(acting.half * spring * eta * eta)
        # of the deflected inertia beyond that of the body, and of the deflection's own motion
        spin = cross(omega, e)
        grown = share * eta * dot(v, spin) + eta * dot(cross(omega, place), spin)
        own = acting.half * mass * (eta * eta * dot(spin, spin) + rate * rate)
        acting.kinetic = acting.kinetic + tape.node(grown) + own + mass * rate * mode.carried
        fall = tape.node(dot(ground, scale(rate, e)) + dot(ground, scale(eta, spin)))
        acting.feed(f"flexible_link_{self.label}", -(share * fall) - damper * rate * rate)
        acting.feed(f"flexible_link_{self.label}_axial", pull * rate)

    def _pulls(
        self, acting: Acting, amounts: Sequence[Node], rod: tuple[Vector, Vector, Node, Node], end: Point
    ) -> list[Node]:
        """Forces [N] of the rod's tension on the modes: zeros without it. `rod`: start, direction, length, density."""
        system, tape = acting.system, acting.system.tape
        known = acting.estimate(1) if self.geometric_stiffness else None
        acting.rates_need_reactions |= self.geometric_stiffness
        if known is None:
            return [tape.zero] * self.modes
        start, along, length, density = rod
        link = system.tree.link_of_body[end.body]
        force: Vector = ZERO
        for joint in system.mechanism.joints.values() if self.shape == "pinned" else ():
            if end.body in (joint.parent, joint.child) and self._at(acting, joint.point, end):
                force = add(force, scale(1 if joint.child == end.body else -1, known.reactions[joint.name][0]))
        held = tape.node(dot(transform(transpose(system.pose[link].rotation), force), along))
        moving = known.rates[link]
        mass = density * length
        first = mass * tape.node(dot(along, moving.at(start)))
        second = mass * length * tape.node(dot(along, transform(moving.matrix, along))) * acting.half
        # N = held - first (1 - x) - second (1 - x^2), of x = 1 at the end, by powers of x
        powers = (held - first - second, first, second)
        shapes = [self._waves(k + 1) for k in range(self.modes)]
        pulls = []
        for one in shapes:
            total = tape.zero
            for other, amount in zip(shapes, amounts, strict=True):
                inner = [tape.constant(_slopes(one, other, n)) for n in range(len(powers))]
                total = total + sum((a * b for a, b in zip(powers, inner, strict=True)), start=tape.zero) * amount
            pulls.append(-(total * (1 / length)))
        return pulls

    def _at(self, acting: Acting, place: Sequence[Any], point: Point) -> bool:
        """Whether a place is that of a point."""
        geometry = acting.system.geometry
        away = geometry.settle(subtract(geometry.vector(place), geometry.vector(point.at)))
        return all(geometry.vanishes(c) for c in away)

    def _check(self, acting: Acting, points: tuple[Point, Point], what: str) -> None:
        start, end = points
        system = acting.system
        if start.body != end.body or start.at == end.at:
            raise DescriptionError(f"{what}: expected two points of one body, got {start.body!r} and {end.body!r}")
        if system.tree.link_of_body[start.body] == GROUND:
            raise DescriptionError(f"{what}: expected points of a body that moves, got the ground's")
        if isinstance(self.modes, bool) or not isinstance(self.modes, int) or not 1 <= self.modes <= MOST:
            raise DescriptionError(f"{what}: expected 1 to {MOST} modes, got {shorten(self.modes)}")
        if not isinstance(self.geometric_stiffness, bool):
            value = shorten(self.geometric_stiffness)
            raise DescriptionError(f"{what}: geometric_stiffness: expected true or false, got {value}")
        if self.shape not in ("pinned", "clamped"):
            raise DescriptionError(f"{what}: expected as shape 'pinned' or 'clamped', got {shorten(self.shape)}")
        if len(self.axis) != 3:
            raise DescriptionError(f"{what}: expected 3 entries of the axis, got {len(self.axis)}")
        for key, given in (("initial", self.initial), ("initial_rate", self.initial_rate)):
            if len(given) not in (0, self.modes):
                raise DescriptionError(f"{what}: expected {self.modes} entries of {key!r}, got {len(given)}")
        if acting.base is not None:
            raise DescriptionError(f"{what}: expected a base at rest; a moving base does not carry its deflection")
        held = (start,) if self.shape == "clamped" else points
        for joint in system.mechanism.joints.values():
            if start.body in (joint.parent, joint.child) and not any(self._at(acting, joint.point, p) for p in held):
                where = "its start" if self.shape == "clamped" else "its ends"
                raise DescriptionError(
                    f"{what}: joint {joint.name!r} stands where the body bends; expected its joints at {where} only"
                )

    def _within(self, at: Values, mechanism: Mechanism, points: tuple[Point, Point], what: str) -> None:
        """The rod is a part of its body: what is left of it without the rod has a mass and a moment about the axis."""
        if all(other.mass is None for other in mechanism.bodies.values()):
            return  # the effect alone is looked at, without any body's inertia
        body = mechanism.bodies[points[0].body]
        first, last = (np.array([at(c, what) for c in point.at]) for point in points)
        length, along = float(np.linalg.norm(last - first)), (last - first) / np.linalg.norm(last - first)
        axis = np.array([at(entry, what) for entry in self.axis])
        axis = axis - along * (along @ axis)
        axis /= np.linalg.norm(axis)
        rod = at(self.line_density, what) * length
        mass, moment = 0.0, 0.0
        if body.mass is not None and body.com is not None:
            mass = at(body.mass, what)
            away = np.cross(axis, [at(c, what) for c in body.com] - (first + last) / 2)
            rows = [[at(c, what) for c in row] for row in body.inertia or ()]
            moment = mass * float(away @ away) + (float(axis @ np.array(rows) @ axis) if rows else 0.0)
        for has, of_rod, text in ((mass, rod, "mass"), (moment, rod * length**2 / 12, "moment about its middle")):
            if has < of_rod * (1 - TYPED):
                unit = "kg" if text == "mass" else "kg m^2"
                raise DescriptionError(
                    f"{what}: expected a body that contains its rod, whose {text} is {of_rod:.6g} {unit} by "
                    f"'line_density'; {body.name!r} has {has:.6g} {unit}; a body's numbers include its rod's"
                )

    def _integrals(self, acting: Acting, k: int, what: str) -> tuple[Node, Node, Node, Node]:
        """Of phi, xi phi, phi^2 and phi''^2 over xi = x/L from 0 to 1."""
        tape = acting.system.tape
        if self.shape == "pinned":
            turns = acting.number(f"{k}*pi", what)
            first = tape.node(1 - (-1) ** k) / turns
            return first, tape.node(-((-1) ** k)) / turns, acting.half, acting.half * turns * turns * turns * turns
        beta, ratio = _cantilever(k)
        tip = 2 * (-1) ** (k + 1)
        found = (2 * ratio / beta / tip, 2 / beta**2 / tip, CONTEXT.mpf(1) / 4, beta**4 / 4)
        first, second, square, bent = (tape.constant(value) for value in found)
        return first, second, square, bent

    def _waves(self, k: int) -> list[tuple[Any, Any]]:
        """The shape phi as a sum of c exp(r xi): (c, r)."""
        if self.shape == "pinned":
            turns, half = CONTEXT.mpc(0, k * CONTEXT.pi), CONTEXT.mpc(0, -1) / 2
            return [(half, turns), (-half, -turns)]
        beta, ratio = _cantilever(k)
        size, turns = (-1) ** (k + 1) / CONTEXT.mpf(4), CONTEXT.mpc(0, beta)
        wave = CONTEXT.mpc(-1, -ratio) * size
        up, down = (1 - ratio) * size, (1 + ratio) * size
        return [(up, beta), (down, -beta), (wave, turns), (CONTEXT.conj(wave), -turns)]


def _cantilever(k: int) -> tuple[Any, Any]:
    """Root beta of cos x cosh x = -1, and sigma of the shape cosh - cos - sigma (sinh - sin), beta xi each.

    The root is rounded to the context's digits, so that beta and -beta add up to 0.
    """
    beta = +CONTEXT.findroot(lambda x: CONTEXT.cos(x) + 1 / CONTEXT.cosh(x), CONTEXT.pi * (k - mpmath.mpf("0.5")))
    return beta, (CONTEXT.cosh(beta) + CONTEXT.cos(beta)) / (CONTEXT.sinh(beta) + CONTEXT.sin(beta))


def _slopes(one: Sequence[tuple[Any, Any]], other: Sequence[tuple[Any, Any]], power: int) -> Any:
    """Integral of xi^power phi_j' phi_k' over xi from 0 to 1."""
    total = CONTEXT.mpc(0)
    for a, p in one:
        for b, r in other:
            rate = p + r
            if rate == 0:
                part = CONTEXT.mpf(1) / (power + 1)
            else:  # by parts: I_n = (exp(rate) - n I_(n-1))/rate
                part = (CONTEXT.exp(rate) - 1) / rate
                for n in range(1, power + 1):
                    part = (CONTEXT.exp(rate) - n * part) / rate
            total += a * p * b * r * part
    return total.real


def _same(mechanism: Mechanism, a: Sequence[object], b: Sequence[object]) -> bool:
    """Whether two points are one, to rounding."""
    one, other = (np.array([float(mechanism.number(c)) for c in place]) for place in (a, b))
    return bool(np.abs(one - other).max() <= 1e-12 * max(1.0, np.abs(one).max()))
