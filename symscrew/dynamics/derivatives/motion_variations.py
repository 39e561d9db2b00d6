"""How the rates of all links change along directions of the state, each vector in the axes of its link.

A vector y = E x that was carried from other axes changes by E (dx + m x x) - n x y, where m and n are the virtual
rotations of the axes before and after. So no rotation is ever differentiated: y, which is there already, serves
where sines, cosines and quaternions would have to be multiplied out (Carpentier and Mansard, Analytical
derivatives of rigid body dynamics algorithms, 2018; here along few directions instead of all joints).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from symscrew.algebra import (
    ZERO,
    Matrix,
    Node,
    Vector,
    add,
    cross,
    differentiate,
    dot,
    named_vector,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.kinematics import Link, Rates, System, own_screws, squared_length

Seeds = dict[Node, dict[str, Node]]
Varied = list[Vector]  # a vector, then its changes along all directions
STILL = Rates(ZERO, ZERO, ZERO, ((0, 0, 0),) * 3)


@dataclass(frozen=True)
class Direction:
    """A direction of the state in joint rates w: virtual displacement, change of w, change of dw/dt."""

    name: str
    step: Sequence[Node]
    rate: Sequence[Node]
    gain: Sequence[Node]


@dataclass(frozen=True)
class Variation:
    """A system at its nodes q, v, a, the same rates as w and dw/dt, and the directions along which it varies."""

    system: System
    w: Sequence[Node]
    w_dot: Sequence[Node]
    directions: Sequence[Direction] = ()

    @property
    def names(self) -> list[str]:
        """The directions' names."""
        return [direction.name for direction in self.directions]

    @cached_property
    def in_v(self) -> list[Direction]:
        """The directions with step, rate and gain as entries of v.

        A spherical joint's components stand in the child's axes, which turn by the step.
        """
        system, found = self.system, []
        for direction in self.directions:
            step, rate, gain = (system.tree_rates(x) for x in (direction.step, direction.rate, direction.gain))
            for link in system.tree.links[1:]:
                if link.motion.spherical:
                    n = three(step, link)
                    rate[link.v] = _nodes(system, add(three(rate, link), cross(three(system.inputs.v, link), n)))
                    gain[link.v] = _nodes(system, add(three(gain, link), cross(three(system.inputs.a, link), n)))
            found.append(Direction(direction.name, step, rate, gain))
        return found

    # -- rotations ----------------------------------------------------------------------------------------------

    @cached_property
    def turns(self) -> list[list[Vector]]:
        """Virtual rotation of every link, own axes, per direction."""
        found = [link_rotations(self.system, direction.step) for direction in self.in_v]
        for direction, turns in zip(self.directions, found, strict=True):
            for part, turn in zip(self.system.tree.parts, turns, strict=True):
                named_vector(turn, "turned", part, by=direction.name)
        return found

    def turn(self, link: int) -> list[Vector]:
        """Virtual rotations of one link, own axes."""
        return [turns[link] for turns in self.turns]

    def outer(self, link: int) -> list[Vector]:
        """Virtual rotations of the axes that a link has before its motion, in these axes."""
        back = transpose(self.system.placed[link].rotation)
        return [transform(back, turn) for turn in self.turn(self.system.tree.links[link].parent)]

    def own_turn(self, link: int) -> list[Vector]:
        """Virtual rotations of a link against its parent, in the axes before its motion."""
        system, joint = self.system, self.system.tree.links[link]
        if joint.motion.spherical:
            return [three(direction.step, joint) for direction in self.directions]
        return [own_screws(joint, system.frames[link], direction.step).angular for direction in self.in_v]

    # -- rates --------------------------------------------------------------------------------------------------

    def rate_changes(self, moving: Sequence[Rates]) -> list[list[Rates]]:
        """Changes of the rates of every link, own axes, per direction."""
        return [self._rate_changes(moving, direction) for direction in self.in_v]

    def _rate_changes(self, moving: Sequence[Rates], direction: Direction) -> list[Rates]:
        """The recursion of `symscrew.kinematics.recursion.rates`, line by line."""
        system, result = self.system, [STILL]
        for link in system.tree.links[1:]:
            frame, here = system.frames[link.index], system.placed[link.index]
            parent, change = moving[link.parent], result[link.parent]
            speed = own_screws(link, frame, system.inputs.v)
            step, rate, gain = (own_screws(link, frame, x) for x in (direction.step, direction.rate, direction.gain))
            carried = add(transform(change.matrix, here.offset), transform(parent.matrix, step.linear))
            carried = add(carried, cross(change.omega, scale(2, speed.linear)))
            carried = add(add(carried, cross(scale(2, parent.omega), rate.linear)), gain.linear)
            carried = add(carried, change.origin)  # last: what gravity adds is all that its frame has of its own
            part = system.tree.part(link.index)
            if not link.motion.turns:
                named_vector(carried, "acceleration", part, by=direction.name)
                result.append(Rates(change.omega, change.alpha, carried, change.matrix))
                continue
            before = here.outwards(parent.omega)
            turned = add(here.outwards(change.omega), cross(before, step.angular))
            omega = add(turned, rate.angular)
            alpha = add(here.outwards(change.alpha), cross(here.outwards(parent.alpha), step.angular))
            alpha = add(alpha, add(cross(turned, speed.angular), cross(before, rate.angular)))
            alpha = add(alpha, gain.angular)
            origin = add(here.outwards(carried), cross(moving[link.index].origin, step.angular))
            for vector, quantity in ((omega, "omega"), (alpha, "alpha"), (origin, "acceleration")):
                named_vector(vector, quantity, part, by=direction.name)
            result.append(Rates(omega, alpha, origin, matrix_change(moving[link.index].omega, omega, alpha)))
        return result

    # -- what only the tape knows ---------------------------------------------------------------------------------

    @cached_property
    def seeds(self) -> Seeds:
        """Changes of the entries of q, v and a; of a quaternion (w, r): (-r . n ; w n + r x n) / 2."""
        system = self.system
        seeds: Seeds = {}
        half = system.tape.reciprocal(system.tape.node(2))
        for direction in self.in_v:
            seed(seeds, direction.name, system.inputs.v, direction.rate)
            seed(seeds, direction.name, system.inputs.a, direction.gain)
            for link in system.tree.links[1:]:
                entries, steps = system.inputs.q[link.q], tuple(direction.step[link.v])
                if len(entries) == 4:
                    w, r = entries[0], (entries[1], entries[2], entries[3])
                    n = scale(half, (steps[0], steps[1], steps[2]))
                    steps = (-dot(r, n), *add(scale(w, n), cross(r, n)))
                    seeds[squared_length(entries)] = {}  # which no motion changes
                seed(seeds, direction.name, entries, steps)
        return seeds

    def differentiated(self, vector: Vector, seeds: Seeds | None = None) -> Varied:
        """A vector with its changes by the tape, down to what the seeds (default: the state's) give."""
        nodes = _nodes(self.system, vector)
        rows = differentiate(self.system.tape, nodes, self.seeds if seeds is None else seeds, self.names)
        return [vector, *((rows[0][k], rows[1][k], rows[2][k]) for k in range(len(self.directions)))]


def link_rotations(system: System, rates: Sequence[Node]) -> list[Vector]:
    """Angular velocities of all links in their own axes for rates of the tree (entries of v)."""
    result: list[Vector] = [ZERO]
    for link in system.tree.links[1:]:
        own = own_screws(link, system.frames[link.index], rates)
        result.append(add(system.placed[link.index].outwards(result[link.parent]), own.angular))
    return result


def matrix_change(omega: Vector, by: Vector, alpha: Vector) -> Matrix:
    """Change of U = [alpha]x + [omega]x^2 when omega changes by `by` and the angular acceleration by alpha."""
    (x, y, z), (dx, dy, dz) = omega, by
    xx, yy, zz = x * dx, y * dy, z * dz
    xy, xz, yz = x * dy + y * dx, x * dz + z * dx, y * dz + z * dy
    return (
        (-2 * (yy + zz), xy - alpha[2], xz + alpha[1]),
        (xy + alpha[2], -2 * (xx + zz), yz - alpha[0]),
        (xz - alpha[1], yz + alpha[0], -2 * (xx + yy)),
    )


def seed(seeds: Seeds, name: str, entries: Sequence[object], changes: Sequence[object]) -> None:
    """Note how nodes change; constants do not."""
    for entry, change in zip(entries, changes, strict=True):
        if isinstance(entry, Node) and entry.value is None:
            by = entry.tape.node(change)
            inner, by = (entry.args[0], -by) if entry.op == "neg" else (entry, by)
            columns = seeds.setdefault(inner, {})
            if by is not entry.tape.zero:
                columns[name] = by


def seed_rates(seeds: Seeds, name: str, rates: Rates, change: Rates) -> None:
    """Note how the rates of a link change."""
    pairs = zip((rates.omega, rates.alpha, rates.origin), (change.omega, change.alpha, change.origin), strict=True)
    for vector, by in (*pairs, *zip(rates.matrix, change.matrix, strict=True)):
        seed(seeds, name, vector, by)


def with_changes(seeds: Seeds) -> Seeds:
    """A copy, to be added to."""
    return {node: dict(columns) for node, columns in seeds.items()}


def three(values: Sequence[Node], link: Link) -> Vector:
    """The three entries of joint rates w (or v) that belong to a link with a spherical motion."""
    x, y, z = values[link.v]
    return (x, y, z)


def _nodes(system: System, values: Sequence[object]) -> list[Node]:
    return [system.tape.node(value) for value in values]


# -- arithmetic of vectors with their changes --------------------------------------------------------------------


def plus(a: Varied, b: Varied) -> Varied:
    """a + b."""
    return [add(x, y) for x, y in zip(a, b, strict=True)]


def minus(a: Varied, b: Varied) -> Varied:
    """a - b."""
    return [subtract(x, y) for x, y in zip(a, b, strict=True)]


def times(a: Varied, b: Varied) -> Varied:
    """a x b."""
    changes = (add(cross(x, b[0]), cross(a[0], y)) for x, y in zip(a[1:], b[1:], strict=True))
    return [cross(a[0], b[0]), *changes]
