"""Thin rods seen from what carries them: where they point and how they turn follows from the angles of their hinges.

With the masses alpha, beta, gamma of `symscrew.dynamics.rods` and n = p2 - p1 the energy of a rod is

    ((alpha + beta) |p1'|^2 + (beta + gamma) |p2'|^2 - beta |n'|^2)/2:

two masses at the ends, and a force beta n'' from end to end beside the tension. Of n'' only what is across n counts,
for the rest is tension. So neither end's acceleration is needed, nor gravity and what moves both alike: n'' = U n, with
U = [alpha]x + [omega]x^2 from the rates of the hinges and of what carries them. A hinge that is parallel to that of its
carrier, a crank, turns with it by the sum of the angles, and both are seen from what carries the crank.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from symscrew.algebra import (
    ZERO,
    Matrix,
    Node,
    Vector,
    add,
    cross,
    is_zero,
    named,
    named_vector,
    named_wrench,
    product,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.dynamics.hinge_powers import hinged_matrix
from symscrew.dynamics.rods import Rod
from symscrew.dynamics.setting import Bar, Wrench
from symscrew.kinematics import GROUND, Link, Linkage, Rates, System


def fanned(system: System, rods: Mapping[int, Rod]) -> bool:
    """Whether no two rods between the same links are parallel in the reference configuration.

    Parallel ones share their tension by `symscrew.dynamics.rods`, where the second's is a couple alone.
    """
    lines: dict[tuple[int, int], list[Vector]] = {}
    for rod in rods.values():
        line = transform(system.frames[rod.links[1].index].axes, rod.line)
        lines.setdefault((rod.parent, rod.hub), []).append(line)
    geometry = system.geometry
    pairs = [(one, other) for some in lines.values() for k, one in enumerate(some) for other in some[:k]]
    return not any(all(geometry.vanishes(c) for c in cross(one, other)) for one, other in pairs)


def heavier(rods: Mapping[int, Rod]) -> dict[int, Rod]:
    """The rods with the masses that their ends have where beta stands for their turning alone."""
    return {
        c: replace(rod, masses=(rod.masses[0] + rod.masses[1], rod.masses[1], rod.masses[1] + rod.masses[2]))
        for c, rod in rods.items()
    }


@dataclass(frozen=True)
class _Hinge:
    """A rotation about z: `rotation` to the axes before it, `turn`, its rate and second rate."""

    rotation: Matrix
    turn: Matrix
    rate: Node
    gain: Node

    def carried(self, vector: Vector) -> Vector:
        """From the axes of what carries the hinge to those behind it."""
        return transform(transpose(self.turn), transform(transpose(self.rotation), vector))


@dataclass(frozen=True)
class TurningRod:
    """A rod by its hinges; `moving` are the rates of all links."""

    system: System
    rod: Rod
    moving: Sequence[Rates]

    @cached_property
    def line(self) -> Vector:
        """n, from the near to the far end, in the axes before the motion of the link that carries the rod."""
        part = self.system.tree.part(self.rod.links[1].index)
        return named_vector(self._carried(self.rod.line), "rod", part)

    @cached_property
    def force(self) -> Vector:
        """beta n'' without a part along the rod, in these axes."""
        omega, alpha = self.moving[self._base].omega, self.moving[self._base].alpha
        first, second = (self.system.tree.part(link.index) for link in self.rod.links)
        inner, last = self._hinges
        omega, alpha = named_vector(inner.carried(omega), "omega", first, prefix="carried_"), inner.carried(alpha)
        alpha = add(add(alpha, (0, 0, inner.gain)), cross(omega, (0, 0, inner.rate)))
        omega, alpha = named_vector(add(omega, (0, 0, inner.rate)), "omega", first), named_vector(alpha, "alpha", first)
        omega = named_vector(last.carried(omega), "omega", second, prefix="carried_")
        alpha = named_vector(last.carried(alpha), "alpha", second, prefix="carried_")
        matrix = hinged_matrix(omega, alpha, last.rate, last.gain)
        x, y, z = named_vector(transform(matrix, scale(self.rod.masses[1], self.rod.line)), "momentum_rate", second)
        along = [not is_zero(c) for c in self.rod.line]
        across: Vector = (0, y, z) if along == [True, False, False] else (x, 0, z) if along[0] is False else (x, y, z)
        part = self.system.tree.part(self.rod.links[1].index)
        return named_vector(self._carried(across), "end_inertia", part)

    def far_end(self, on: int, origin: Vector = ZERO) -> Vector:
        """The far end in the coordinates of a link, from a place there."""
        parent, at = self.rod.parent, self.system.linkage
        if parent not in (on, GROUND) and at.tree.links[parent].parent == on:
            placed = at.placed[parent]
            foot = self.system.geometry.settle(subtract(placed.offset, origin))
            return add(add(placed.inwards(self.rod.near), foot), placed.from_before(self.line))
        near = subtract(at.carry_point(parent, on, self.rod.near), origin)
        if parent == GROUND:
            return add(near, at.carry(GROUND, on, self.line))
        if parent == on:
            return add(near, transform(transpose(at.placed[on].turn), self.line))
        return add(near, at.carry(at.tree.links[parent].parent, on, at.placed[parent].from_before(self.line)))

    def _carried(self, vector: Vector) -> Vector:
        """From the axes of the rod's second link to those before the motion of what carries the rod."""
        for hinge in self._hinges[:0:-1]:
            vector = transform(hinge.rotation, transform(hinge.turn, vector))
        inner = self._hinges[0]
        vector = transform(inner.turn, vector)
        if self._base != self.rod.parent:
            return vector
        vector = transform(inner.rotation, vector)
        return vector if self._base == GROUND else self.system.placed[self._base].before(vector)

    @cached_property
    def _base(self) -> int:
        """The link from which the hinges are seen: what carries the rod, or what carries its crank."""
        return self.rod.parent if self._joined is None else self.system.tree.links[self.rod.parent].parent

    @cached_property
    def _hinges(self) -> tuple[_Hinge, ...]:
        first, second = (self._hinge(link) for link in self.rod.links)
        if self._joined is None:
            return first, second
        inner, flipped = self._joined
        return inner, replace(second, rotation=product(flipped, second.rotation))

    def _hinge(self, link: Link) -> _Hinge:
        inputs, placed = self.system.inputs, self.system.placed[link.index]
        return _Hinge(placed.rotation, placed.turn, inputs.v[link.v.start], inputs.a[link.v.start])

    @cached_property
    def _joined(self) -> tuple[_Hinge, Matrix] | None:
        """The hinge of a crank and the rod's first one as one, and what is constant behind it, if they are parallel."""
        crank, first = self.system.tree.links[self.rod.parent], self.rod.links[0]
        if crank.index == GROUND or not crank.motion.revolute:
            return None
        geometry, (inner, outer) = self.system.geometry, (self.system.frames[k.index] for k in (crank, first))
        if not all(geometry.vanishes(c) for c in outer.axis[:2]) or None in (inner.phase.value, outer.phase.value):
            return None
        (c, _, _), (s, _, _), (_, _, sign) = outer.rotation
        function, q = self.system.tape.function, self.system.inputs.q
        back: Matrix = ((c, s, 0), (-s, c, 0), (0, 0, 1))
        flipped = geometry.settle_matrix(product(back, outer.rotation))
        sense = -1 if self.system.tape.node(sign).value < 0 else 1
        phase = inner.phase + function("atan2", s, c) + sense * outer.phase
        angle = q[crank.q.start] + sense * q[first.q.start]
        turn = crank.pair.placement(self.system.tape, replace(inner, phase=phase), [angle]).turn
        part = self.system.tree.part(first.index)
        (c, _, _), (s, _, _), _ = turn
        named(self.system.tape.node(c), "cos", part, "joined")
        named(self.system.tape.node(s), "sin", part, "joined")
        one, other = self._hinge(crank), self._hinge(first)
        hinge = _Hinge(one.rotation, turn, one.rate + sense * other.rate, one.gain + sense * other.gain)
        return hinge, flipped


def turning_bars(rods: Mapping[int, TurningRod], at: Linkage, ends: Mapping[int, Vector]) -> dict[int, Bar]:
    """What the parent and the hub of every rod must supply for it, by its cut joint.

    `at`: the tree, with links elsewhere perhaps; `ends`: places of rods' far ends from the hub's origin, in the axes
    before the hub's motion.
    """
    result = {}
    for c, turning in rods.items():
        rod, system = turning.rod, turning.system
        part, found = system.tree.part(rod.links[1].index), dict[int, tuple[Wrench, Wrench]]()
        for link, sign, name in ((rod.parent, -1, "near"), (rod.hub, 1, "far")):
            if link == GROUND:
                continue
            placed = at.placed[link]
            arm = placed.before(rod.near) if link == rod.parent else ends[c]
            pull, force = (
                scale(by, at.carry_across(rod.parent, link, vector))
                for by, vector in ((sign, turning.line), (-sign, turning.force))
            )
            pulled = named_wrench((pull, cross(arm, pull)), "pull", part, by=name)
            inertia = named_wrench((force, cross(arm, force)), "end_inertia", part, by=name)
            found[link] = pulled, inertia
        inside = None
        if rod.parent != GROUND and system.tree.links[rod.parent].parent != GROUND:
            on = system.tree.links[rod.parent].parent
            force = at.placed[rod.parent].from_before(turning.force)
            inside = rod.parent, on, (force, cross(at.carry_point(rod.parent, on, rod.near), force))
        result[c] = Bar(frozenset(link.index for link in rod.links), found, inside)
    return result
