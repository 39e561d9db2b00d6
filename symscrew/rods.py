"""Thin rods: bodies between a universal and a spherical joint that have no inertia about the line between them.

The motion of such a rod is that of its two ends. With x from 0 at one end to 1 at the other, its kinetic energy is
(alpha |p1'|^2 + 2 beta p1'.p2' + gamma |p2'|^2)/2 with alpha, beta, gamma the integrals of (1 - x)^2, (1 - x) x and
x^2 over its mass: two masses at the ends and one that couples them, exactly. All that it transmits besides is a
tension along n = p2 - p1. So the drives do not depend on the rod's angles but by its ends, which both lie on other
bodies: neither sines nor rates of the rods are needed, and one unknown per rod is left of three.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from symscrew.closure import Cut, carry, carry_point
from symscrew.effects import Acting
from symscrew.equilibrium import Bar, Wrench
from symscrew.recursion import Inertia, Rates, combined, regrouped
from symscrew.screws import ZERO, Matrix, Vector, add, cross, dot, product, scale, subtract, transform, transpose
from symscrew.system import System
from symscrew.tape import Node
from symscrew.tree import GROUND, Link


@dataclass(frozen=True)
class Rod:
    """A thin rod: its links, the point `near` of its parent and the point `far` of its hub (each in the coordinates of
    the link) between which it is, and its masses alpha, beta, gamma [kg]."""

    links: tuple[Link, Link]
    hub: int
    near: Vector
    far: Vector
    masses: tuple[Node, Node, Node]

    @property
    def parent(self) -> int:
        """The link that carries the rod."""
        return self.links[0].parent


def thin_rods(system: System, acting: Acting) -> dict[int, Rod]:
    """The rods of a system by the index of their cut joints: nothing but gravity and other bodies acts on them."""
    if "no_gyroscopic_terms" in acting.simplifications:  # part of a rod's rate of momentum is left out then
        return {}
    taken = {*acting.joint_forces, *acting.reflected_inertia, *system.drive_rows()}
    driven = system.cut_drives()
    found = {c: _rod(system, cut) for c, cut in enumerate(system.cuts) if c not in driven}
    return {
        c: rod
        for c, rod in found.items()
        if rod and not any(link.index in acting.loads or taken & {link.v.start} for link in rod.links)
    }


def _rod(system: System, cut: Cut) -> Rod | None:
    """The limb's last body, if it is a thin rod between crossing rotations and a cut spherical joint."""
    tree, settle, zero = system.tree, system.geometry.settle, system.tape.zero
    if cut.joint.type != "S" or len(tree.path(cut.tip)) < 2:
        return None
    second = tree.links[cut.tip]
    first = tree.links[second.parent]
    inside = {first.index, second.index}
    others = [link.parent for link in tree.links[1:] if link.index != second.index]
    others += [end for other in system.cuts if other is not cut for end in (other.tip, other.hub)]
    if (first.motion.kind, second.motion.kind) != ("R", "R") or inside & {cut.hub, *others}:
        return None
    outer, inertia, n = system.frames[second.index], system.inertia[second.index], cut.tip_point
    shorter = 1 / dot(n, n)
    mass, moment = inertia.mass, dot(inertia.first, n) * shorter
    spread = dot(n, transform(inertia.second, n)) * (shorter * shorter)
    conditions = (
        *(outer.offset[0], outer.offset[1], outer.axis[2]),  # both rotations through one point, at a right angle
        *(system.inertia[first.index].mass, *(c for row in system.inertia[first.index].second for c in row)),
        *settle(cross(inertia.first, n)),
        *(c - spread * n[i] * n[j] for i, row in enumerate(inertia.second) for j, c in enumerate(row)),
    )
    if any(system.tape.settle(c) is not zero for c in conditions):
        return None
    inner = system.frames[first.index]
    near = settle(add(inner.offset, transform(inner.rotation, outer.offset)))
    beta = system.tape.settle(moment - spread)
    alpha = system.tape.settle(mass - moment - beta)
    return Rod((first, second), cut.hub, near, cut.hub_point, (alpha, beta, system.tape.settle(spread)))


def with_end_masses(system: System, rods: Sequence[Rod]) -> tuple[Inertia, ...]:
    """Regrouped inertias of the links, with the masses of the rods at their ends in place of the rods themselves."""
    result = list(system.inertia)
    for rod in rods:
        for own in rod.links:
            result[own.index] = Inertia(system.tape.zero, ZERO, ((0, 0, 0),) * 3)
        for link, mass, at in ((rod.parent, rod.masses[0], rod.near), (rod.hub, rod.masses[2], rod.far)):
            if link != GROUND:
                result[link] = combined(system.geometry, result[link], _point_mass(mass, at))
    return regrouped(system.tree, system.frames, result, system.geometry)


def _point_mass(mass: Node, at: Vector) -> Inertia:
    first = scale(mass, at)
    return Inertia(mass, first, tuple(scale(x, first) for x in at))  # type: ignore[arg-type]


def bars(system: System, rods: Mapping[int, Rod], moving: Sequence[Rates]) -> dict[int, Bar]:
    """What the parent and the hub of every rod must supply for it, by its cut joint."""
    first: dict[tuple[int, int], tuple[Rod, Vector]] = {}
    result = {}
    for c, rod in rods.items():
        ends = rod.parent, rod.hub
        n = _parallel(system, rod, *first[ends]) if ends in first else _line(system, rod)
        first.setdefault(ends, (rod, n))
        result[c] = _bar(system, rod, n, moving)
    return result


def _line(system: System, rod: Rod) -> Vector:
    """From the near to the far end, in the axes before the parent's motion."""
    far = carry_point(system.tree, system.placed, rod.hub, rod.parent, rod.far, before=True)
    return subtract(far, _before(system, rod.parent, rod.near))


def _parallel(system: System, rod: Rod, other: Rod, line: Vector) -> Vector:
    """The same by the line of another rod between the same links: equal where both are parallel."""
    far = _before(system, rod.hub, subtract(rod.far, other.far))
    near = _before(system, rod.parent, subtract(rod.near, other.near))
    return add(line, subtract(_across(system, rod.hub, rod.parent, far), near))


def _bar(system: System, rod: Rod, n: Vector, moving: Sequence[Rates]) -> Bar:
    coupling = rod.masses[1]
    near, far = _before(system, rod.parent, rod.near), _before(system, rod.hub, rod.far)
    ends: dict[int, tuple[Wrench, Wrench]] = {}
    for link, other, at, beyond, pull in (
        (rod.parent, rod.hub, near, rod.far, scale(-1, n)),
        (rod.hub, rod.parent, far, rod.near, _across(system, rod.parent, rod.hub, n)),
    ):
        if link != GROUND:
            force = scale(coupling, _across(system, other, link, _acceleration(system, moving, other, beyond)))
            ends[link] = ((pull, cross(at, pull)), (force, cross(at, force)))
    return Bar(frozenset(link.index for link in rod.links), ends)


def _before(system: System, link: int, vector: Vector) -> Vector:
    return vector if link == GROUND else system.placed[link].before(vector)


def _across(system: System, source: int, target: int, vector: Vector) -> Vector:
    """A vector from the axes that one link has before its motion to those that another one has."""
    tree, placed = system.tree, system.placed
    if source != GROUND:
        vector = transform(placed[source].rotation, vector)
    return carry(tree, placed, tree.links[source].parent, target, vector, before=target != GROUND)


def _acceleration(system: System, moving: Sequence[Rates], link: int, point: Vector) -> Vector:
    """Acceleration of a link's point, in the axes before its motion: what rotates is turned once."""
    own, placed = moving[link], system.placed[link]
    if link == GROUND:
        return own.at(point)
    if system.tree.links[link].motion.kind not in "RS":
        return placed.before(own.at(point))
    carried = transform(transpose(placed.rotation), moving[system.tree.links[link].parent].at(placed.offset))
    turned: Matrix = product(placed.turn, own.matrix)
    return add(carried, transform(turned, point))
