"""What the effects of a scene put on a mechanism: motion of the ground, wrenches on links, joint forces, states.

    effects --push, drive, store, feed, state, input, ...--> Acting --read--> dynamics, functions, simulation

Effects write into an `Acting` through its methods, the dynamics read it. Wrenches are kept per link, in the
axes before the link's motion, at its origin: where the recursions take them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, Protocol

from symscrew.algebra import ZERO, Matrix, Node, Vector, add, cross, dot, named_wrench, scale, subtract
from symscrew.description import Point
from symscrew.effects.parts import Parts
from symscrew.effects.records import AddedInertia, Bending, Estimate, State, Transmission
from symscrew.errors import DescriptionError
from symscrew.kinematics import (
    GROUND,
    Inertia,
    Rates,
    System,
    acceleration_matrix,
    drive_row,
    inertial_wrench,
    on_hub,
    rates,
    regrouped,
    without_gyroscopic_moment,
)
from symscrew.program import Port

Loads = dict[int, tuple[Vector, Vector]]


class Acts(Protocol):
    """What puts something on a system: an `Effect`."""

    def prepare(self, acting: Acting) -> None:
        """Before anything acts."""

    @property
    def leaves_out(self) -> bool:
        """Whether it is a simplification."""

    @property
    def keeps_motion(self) -> bool:
        """Whether rates and accelerations enter the inertial forces."""

    def keeps_gyroscopic_moment(self, body: str) -> bool:
        """Whether omega x J omega of a body does."""

    def act(self, acting: Acting) -> None:
        """Add what it contributes."""

    def conclude(self, acting: Acting) -> None:
        """After all have acted."""


class Acting(Parts):
    """The sum of what all effects contribute to one system at its present nodes.

    `estimate` is what load-dependent effects are to use; without it these effects do nothing, and `needs_reactions`
    tells, `rates_need_reactions` of those whose states' rates depend on it.
    """

    def __init__(self, system: System, effects: Sequence[Acts], estimate: Estimate | None = None) -> None:
        super().__init__(system)
        tape = system.tape
        self.ground = Rates(ZERO, ZERO, ZERO, ((0, 0, 0),) * 3)
        self.base: Rates | None = None  # the ground's own motion, without gravity
        self.ground_rotation: Matrix | None = None  # from the axes of the ground to absolute axes
        self.loads: Loads = {}
        self.joint_forces: dict[int, Node] = {}  # index into v -> generalised force along that freedom
        self.reflected_inertia: dict[int, Node] = {}  # index into v -> inertia that moves with that freedom
        self.bendings: list[Bending] = []
        self.own_inputs: list[tuple[Port, tuple[Node, ...]]] = []
        self.potential: Node = tape.zero
        self.kinetic: Node = tape.zero
        self.powers: dict[str, Node] = {}
        self.states: list[State] = []
        self.state_rates: dict[str, Node] = {}
        self.effects = tuple(effects)
        self.simplified = any(effect.leaves_out for effect in effects)
        self.keeps_motion = all(effect.keeps_motion for effect in effects)
        self.keeps_gyroscopic_moments = all(
            e.keeps_gyroscopic_moment(b) for e in effects for b in system.mechanism.bodies
        )
        self.transmissions: dict[int, Transmission] = {}
        self.needs_reactions = self.rates_need_reactions = False
        self.passes = 1
        self._estimate = estimate
        for effect in effects:  # all of them first: gravity has to know the attitude that another effect gives the base
            effect.prepare(self)
        for effect in effects:
            effect.act(self)
        for effect in effects:  # what needs to know all that acts on the ground
            effect.conclude(self)
        forgotten = [s.name for s in self.states if s.name not in self.state_rates]
        assert not forgotten, f"effects give no rate of their states {forgotten}"

    def __repr__(self) -> str:
        names = [port.name for port, _ in self.inputs]
        return f"Acting({self.system.mechanism.name}: {len(self.loads)} loads, inputs {', '.join(names) or 'none'})"

    # -- what the ground does -----------------------------------------------------------------------------

    def accelerate_ground(self, acceleration: Vector) -> None:
        """Add a uniform acceleration of the ground [m/s^2], absolute axes."""
        self.ground = replace(self.ground, origin=add(self.ground.origin, acceleration))

    def move_ground(self, omega: Vector, alpha: Vector, acceleration: Vector) -> None:
        """Turn and accelerate the ground: omega [rad/s], alpha [rad/s^2], acceleration of O [m/s^2], its own axes."""
        if self.base is not None:
            raise DescriptionError("base motion: expected one prescribed motion of the base, got a second one")
        matrix = acceleration_matrix(omega, alpha)
        self.base = Rates(omega, alpha, acceleration, matrix)
        self.ground = Rates(omega, alpha, add(self.ground.origin, acceleration), matrix)

    def link_rates(self, a: Sequence[Node]) -> tuple[Rates, ...]:
        """Rates of every link for given accelerations of the tree, the ground's motion and gravity included."""
        system = self.system
        v = system.inputs.v
        if not self.keeps_motion:
            a = v = (system.tape.zero,) * len(system.tree.v)
        return rates(system.linkage, v, a, ground=self.ground)

    # -- inertia ---------------------------------------------------------------------------------------------

    @cached_property
    def inertia(self) -> tuple[Inertia, ...]:
        """Inertias of the links, with what is left out of their moments in omega."""
        if self.keeps_gyroscopic_moments:
            return tuple(self.added_inertia.grown(self.system.inertia)) if self.bendings else self.system.inertia
        links, geometry = self.system.tree.links, self.system.geometry
        spinless = [any(not e.keeps_gyroscopic_moment(b) for e in self.effects for b in link.bodies) for link in links]
        pairs = zip(self.system.inertia, spinless, strict=True)
        kept = [without_gyroscopic_moment(own, geometry) if left_out else own for own, left_out in pairs]
        return tuple(self.added_inertia.grown(kept))

    @property
    def added_inertia(self) -> AddedInertia:
        """Inertia beside the bodies'."""
        return AddedInertia(self.reflected_inertia, tuple(self.bendings))

    def lean_inertia(self) -> tuple[Inertia, ...]:
        """Regrouped inertias: right for drives and cut joints, not inside the tree."""
        system = self.system
        return regrouped(system.tree, system.frames, self.inertia, system.geometry)

    def inertial_wrench(self, link: int, inertia: Inertia, moving: Sequence[Rates]) -> tuple[Vector, Vector]:
        """Rate of the link's momentum screw at its origin, link axes, with the declared simplifications."""
        key, known = ("inertial_wrench", inertia, moving[link]), self.system.linkage.answers
        if key not in known:
            known[key] = inertial_wrench(inertia, moving[link])
        force, moment = known[key]
        for bending in self.bendings:
            if bending.link == link:
                more, couple = bending.wrench(moving[link])
                force, moment = add(force, more), add(moment, couple)
        return named_wrench((force, moment), "momentum_rate", self.system.tree.part(link))

    def inertial_wrenches(self, a: Sequence[Node]) -> Loads:
        """Inertial wrench of every link with regrouped inertias, for given accelerations of the tree."""
        moving, lean = self.link_rates(a), self.lean_inertia()
        return {k: self.inertial_wrench(k, lean[k], moving) for k in range(1, len(lean))}

    def reflect(self, joint: str, freedom: int, inertia: Node, what: str) -> None:
        """An inertia [kg or kg m^2] that moves with a freedom of the spanning tree only: force -inertia * rate."""
        index = self.tree_index(joint, freedom, what)
        self.reflected_inertia[index] = self.reflected_inertia.get(index, self.system.tape.zero) + inertia
        rate = self.system.inputs.v[index]
        self.kinetic = self.kinetic + inertia * rate * rate * self.half

    def known_forces(self, a: Sequence[Node]) -> dict[int, Node]:
        """Forces along joint rates w of the tree, those of reflected inertias at accelerations a (of v) included."""
        known = dict(self.joint_forces)
        if self.keeps_motion and self.reflected_inertia:
            along = self.system.joint_rates(a)
            for index, inertia in self.reflected_inertia.items():
                known[index] = known.get(index, self.system.tape.zero) - inertia * along[index]
        return known

    # -- energy and power --------------------------------------------------------------------------------------

    def store(self, energy: Node) -> None:
        """Add potential energy [J]."""
        self.potential = self.potential + energy

    def feed(self, label: str, power: Node) -> None:
        """Power [W] that an effect feeds into the mechanism beyond what it takes from its stored energy."""
        if power is not self.system.tape.zero:
            known = self.powers.get(label)
            self.powers[label] = power if known is None else known + power

    # -- inputs and states ---------------------------------------------------------------------------------------

    @property
    def inputs(self) -> list[tuple[Port, tuple[Node, ...]]]:
        """Further inputs of all functions that depend on loads: x (states), t (time), then the effects' own."""
        result = [(self.state_port("x", "states of the effects"), self.state_nodes)] if self.states else []
        if self._time is not None:
            result.append((Port("t", (1,), ("s",), ("t",), "time"), (self._time,)))
        return result + self.own_inputs

    def inputs_of(self, nodes: Sequence[Node]) -> list[tuple[Port, tuple[Node, ...]]]:
        """Those of the further inputs on which the nodes depend."""
        found, seen, stack = set(), set(), list(nodes)
        while stack:
            node = stack.pop()
            if node.index in seen or node.op == "const":
                continue
            seen.add(node.index)
            if node.op == "symbol":
                found.add(node.index)
            else:
                stack.extend(node.args)
        return [(port, entries) for port, entries in self.inputs if any(e.index in found for e in entries)]

    def input(self, port: Port, description: str) -> tuple[Node, ...]:
        """Symbols for a further input of all functions that depend on loads."""
        if any(port.name == other.name for other, _ in self.inputs):
            raise DescriptionError(
                f"effects: two of them have the input {port.name!r}; give one of them another name (key 'name')"
            )
        nodes = tuple(
            self.sampled(f"{port.name}_{label}" if label else port.name, unit, f"{description} {label}".strip())
            for label, unit in zip(port.labels, port.units, strict=True)
        )
        self.own_inputs.append((port, nodes))
        return nodes

    def state(self, name: str, unit: str, initial: Any, description: str, *, carried: Node | None = None) -> Node:
        """A further state; its rate must be given by `state_rate`.

        It starts at `initial`, a number or a text of the parameters, and at `carried` more, which is of q and v, where
        that is given.
        """
        if any(name == other.name for other in self.states):
            raise DescriptionError(f"effects: two of them have the state {name!r}; give one another name (key 'name')")
        node = self.sampled(f"x_{name}", unit, description)
        start = self._reader.number(initial, f"{description} at the start")
        self.states.append(State(name, unit, self._default(start, name), node, carried, start))
        return node

    def state_rate(self, name: str, rate: Node) -> None:
        """The rate of a state."""
        self.state_rates[name] = rate

    @property
    def state_nodes(self) -> tuple[Node, ...]:
        """Symbols of all states."""
        return tuple(s.node for s in self.states)

    def state_port(self, name: str, description: str, suffix: str = "") -> Port:
        """A port with one entry per state."""
        units = tuple(s.unit + suffix if s.unit != "1" or not suffix else "1" + suffix for s in self.states)
        return Port(name, (len(self.states),), units, tuple(s.name for s in self.states), description)

    @property
    def state_rate_output(self) -> list[tuple[Port, tuple[Node, ...]]]:
        """The further output x_dot of forward dynamics; none without states."""
        if not self.states:
            return []
        port = self.state_port("x_dot", "rates of the effects' states", "/s")
        return [(port, tuple(self.state_rates[s.name] for s in self.states))]

    # -- forces ------------------------------------------------------------------------------------------------

    def reaction(self, joint: str, passes: int) -> tuple[Vector, Vector] | None:
        """The joint's reaction (f ; m_O) for a load-dependent effect; None while it is not known yet.

        `passes` says how many times reactions and what depends on them are to be computed in turn.
        """
        found = self.estimate(passes)
        return None if found is None else found.reactions[joint]

    def estimate(self, passes: int) -> Estimate | None:
        """All reactions and the rates of the links, in the same way."""
        self.needs_reactions = True
        self.passes = max(self.passes, passes)
        return self._estimate

    def push(self, point: Point, force: Vector, moment: Vector = ZERO) -> None:
        """A force [N] at a point of a body and a moment [N m], absolute axes."""
        system = self.system
        link = system.tree.link_of_body[point.body]
        if link == GROUND:
            return
        f, m = (system.linkage.carry(GROUND, link, vector, before=True) for vector in (force, moment))
        arm = system.placed[link].before(system.local_point(link, system.geometry.vector(point.at)))
        self._load(link, f, add(m, cross(arm, f)))

    def push_in_body_axes(self, point: Point, force: Vector, moment: Vector = ZERO) -> None:
        """A force [N] at a point of a body and a moment [N m], in axes that the body carries.

        They are the absolute axes in the reference configuration.
        """
        system = self.system
        link = system.tree.link_of_body[point.body]
        if link == GROUND:
            return
        back = system.frames[link].axes
        place = system.local_point(link, system.geometry.vector(point.at))
        f, m = (tuple(dot(column, v) for column in zip(*back, strict=True)) for v in (force, moment))
        placed = system.placed[link]
        self._load(link, placed.before(f), placed.before(add(m, cross(place, f))))

    def drive(self, joint: str, freedom: int, force: Node) -> None:
        """A generalised force on a joint's freedom, like a drive: > 0 pushes the child along its screw."""
        system = self.system
        if joint in system.tree.joints:
            index = system.tree.velocity_indices(joint)[freedom]
            self.joint_forces[index] = self.joint_forces.get(index, system.tape.zero) + force
            return
        # a joint that closes a loop has no rate of its own in v: its force acts as a pair of wrenches on tip and hub
        cut = next(c for c in system.cuts if c.joint.name == joint)
        row = drive_row(cut, freedom, system.linkage)
        factor = -force if cut.tip_is_parent else force
        f, couple = scale(factor, row.force), scale(factor, row.couple)
        placed = system.placed
        if cut.tip != GROUND:
            tip = placed[cut.tip]
            self._load(cut.tip, tip.before(f), tip.before(add(couple, cross(cut.tip_point, f))))
        if cut.hub != GROUND:
            f, m = on_hub(cut, system.linkage, scale(-1, f), scale(-1, couple))
            self._load(cut.hub, f, m)

    def _load(self, link: int, force: Vector, moment: Vector) -> None:
        f, m = self.loads.get(link, (ZERO, ZERO))
        self.loads[link] = named_wrench((add(f, force), add(m, moment)), "load", self.system.tree.part(link))

    # -- drives --------------------------------------------------------------------------------------------------

    def transmit(self, joint: str, freedom: int, transmission: Transmission, what: str) -> None:
        """Put a transmission between a drive and its joint: the entry of u is the motor's side then."""
        drive = self.drive_index(joint, freedom, what)
        if drive in self.transmissions:
            raise DescriptionError(f"{what}: this drive has a transmission already; expected one")
        self.transmissions[drive] = transmission

    def drive_force(self, drive: int, command: Node) -> Node:
        """Force or torque on the joint from an entry of u."""
        return self.transmissions[drive].force(command) if drive in self.transmissions else command

    def drive_commands(self, forces: Sequence[Node]) -> tuple[Node, ...]:
        """Entries of u from the forces and torques on the joints."""
        return tuple(self.transmissions[k].command(f) if k in self.transmissions else f for k, f in enumerate(forces))

    def drive_port(self, port: Port) -> Port:
        """The port of u with the units of the motors' sides."""
        units = tuple(self.transmissions[k].unit if k in self.transmissions else u for k, u in enumerate(port.units))
        return port if units == port.units else replace(port, units=units)


def power_of_wrench(system: System, link: int, force: Vector, moment: Vector) -> Node:
    """Power of a wrench on a link (link axes, at its origin) in the link's motion against the ground [W]."""
    twist = system.twist[link]
    return system.tape.node(dot(force, twist.linear) + dot(moment, twist.angular))


def point_position(system: System, point: Point) -> Vector:
    """Present place of a named point [m], absolute axes."""
    link = system.tree.link_of_body[point.body]
    at = system.geometry.vector(point.at)
    return at if link == GROUND else system.pose[link].point(system.local_point(link, at))


def point_velocity(system: System, point: Point) -> Vector:
    """Velocity of a named point against the ground [m/s], absolute axes."""
    link = system.tree.link_of_body[point.body]
    if link == GROUND:
        return ZERO
    local = system.local_point(link, system.geometry.vector(point.at))
    return system.pose[link].direction(system.twist[link].velocity_at(local))


def body_spin(system: System, body: str) -> Vector:
    """Angular velocity of a body against the ground [rad/s], absolute axes."""
    link = system.tree.link_of_body[body]
    return ZERO if link == GROUND else system.pose[link].direction(system.twist[link].angular)


def between(system: System, a: Point, b: Point) -> tuple[Vector, Vector]:
    """Where b is from a, and at which velocity: absolute axes."""
    away = subtract(point_position(system, b), point_position(system, a))
    return away, subtract(point_velocity(system, b), point_velocity(system, a))
