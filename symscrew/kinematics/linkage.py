"""The links of a tree where given coordinates put them: how vectors, points and wrenches get from one to another.

    q --Structure.linkage--> Linkage --carry--> a vector in the axes of another link
                                     --push---> the power of a wrench per joint rate, inwards from link to link

"Before" a link's motion are the axes that it would have at rest on its parent: there joint rates w and the
wrenches that arrive from outboard meet.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from symscrew.algebra import (
    ZERO,
    Node,
    Pose,
    Scalar,
    Twist,
    Vector,
    add,
    cross,
    named_matrix,
    named_vector,
    product,
    subtract,
    transform,
    transpose,
)
from symscrew.kinematics.link_quantities import Frame, Placement, Rates, Wrench
from symscrew.kinematics.tree import GROUND, Tree


@dataclass(frozen=True, eq=False)
class Linkage:
    """The tree's links, their frames and their placements, ground first; the coordinates q that place them."""

    tree: Tree
    frames: tuple[Frame, ...]
    placed: tuple[Placement, ...]
    q: tuple[Node, ...] = ()
    answers: dict[Hashable, Any] = field(default_factory=dict, init=False, repr=False)  # what was asked of it before

    def __repr__(self) -> str:
        return f"Linkage({len(self.tree.links)} links, {len(self.q)} coordinates)"

    @cached_property
    def poses(self) -> tuple[Pose, ...]:
        """absolute_T_link of every link."""
        result = [Pose()]
        for link in self.tree.links[1:]:
            here, parent = self.placed[link.index], result[link.parent]
            rotation = product(product(parent.rotation, here.rotation), here.turn)
            part = self.tree.part(link.index)
            position = named_vector(parent.point(here.offset), "position", part)
            result.append(Pose(named_matrix(rotation, "rotation", part), position))
        return tuple(result)

    def carry(self, source: int, target: int, vector: Vector, *, before: bool = False) -> Vector:
        """A vector from the axes of one link to those of another, along the tree's path between them.

        With `before` it ends in the axes that the target has before its own motion.
        """
        inwards, outwards = self._ways(source, target)
        for link in inwards:
            vector = self.placed[link].inwards(vector)
        if not outwards:
            return self.placed[target].before(vector) if before else vector
        for link in outwards:
            if before and link == target:
                return transform(transpose(self.placed[link].rotation), vector)
            vector = self.placed[link].outwards(vector)
        return vector

    def carry_point(self, source: int, target: int, point: Vector, *, before: bool = False) -> Vector:
        """A point from the coordinates of one link to those of another, along the tree's path between them.

        With `before` in the axes that the target has before its own motion.
        """
        inwards, outwards = self._ways(source, target)
        for link in inwards:
            point = add(self.placed[link].inwards(point), self.placed[link].offset)
        if not outwards:
            return self.placed[target].before(point) if before else point
        for link in outwards:
            if before and link == target:
                back = transpose(self.placed[link].rotation)
                return subtract(transform(back, point), transform(back, self.placed[link].offset))
            point = self.placed[link].outwards(subtract(point, self.placed[link].offset))
        return point

    def _ways(self, source: int, target: int) -> tuple[list[int], list[int]]:
        """Links whose motions a vector leaves on its way inwards from `source`, and those it enters to `target`."""
        down, up = self.tree.path(source), self.tree.path(target)
        common = set(down) & set(up)
        return [link for link in down if link not in common], [link for link in reversed(up) if link not in common]

    def carry_before(self, source: int, target: int, vector: Vector) -> Vector:
        """A vector from the axes that a link has before its own motion to the axes of another link outside it."""
        return self.carry(self.tree.links[source].parent, target, self.placed[source].from_before(vector))

    def carry_across(self, source: int, target: int, vector: Vector) -> Vector:
        """A vector from the axes that one link has before its motion to those that another one has."""
        if source == target:
            return vector
        if source != GROUND:
            vector = self.placed[source].from_before(vector)
        return self.carry(self.tree.links[source].parent, target, vector, before=target != GROUND)

    def seen_before(self, source: int, target: int, point: Vector) -> Vector:
        """A point of a link from another one's origin, in the axes that the latter has before its motion.

        It is the sum of where the link's origin is, which several of its points share, and of the point's turned place.
        """
        turned = point if source == GROUND else self.placed[source].before(point)
        origin = self.carry_point(source, target, ZERO, before=True)
        return add(origin, self.carry_across(source, target, turned))

    def velocity_across(self, twist: Twist, source: int, target: int, point: Vector) -> Vector:
        """Velocity of a link's point in the axes that another one has before its motion; `twist`: the link's own."""
        at = self.placed[source]
        spin = at.before(twist.angular)
        moved = add(at.before(twist.linear), cross(spin, at.before(point)))
        return self.carry_across(source, target, moved)

    def acceleration_across(self, rates: Rates, source: int, target: int, point: Vector) -> Vector:
        """Acceleration of a link's point in the axes that another one has before its motion; `rates`: its own."""
        at = self.placed[source]
        turned = transform(product(at.turn, rates.matrix), point)
        return self.carry_across(source, target, add(at.before(rates.origin), turned))

    def outwards(self, index: int, wrench: Wrench) -> Wrench:
        """A wrench at the origin of a link's parent as one at the link's, in the axes before its motion."""
        (force, moment), placed = wrench, self.placed[index]
        back = transpose(placed.rotation)
        return transform(back, force), transform(back, subtract(moment, cross(placed.offset, force)))

    def push(self, index: int, wrench: Wrench, inside: int) -> Iterator[tuple[int, Sequence[Scalar], Wrench]]:
        """Push a wrench from a link (its origin, axes before its motion) to link `inside`.

        Per link on the way: its index, the powers per joint rate, and the wrench at its parent's origin in the
        parent's axes.
        """
        force, moment = wrench
        while True:
            link, placed = self.tree.links[index], self.placed[index]
            powers = link.pair.powers(self.frames[index], force, moment)
            force = placed.from_before(force)
            moment = add(placed.from_before(moment), cross(placed.offset, force))
            yield index, powers, (force, moment)
            index = link.parent
            if index == inside:
                return
            force, moment = self.placed[index].before(force), self.placed[index].before(moment)

    def joint_rates(self, v: Sequence[Node]) -> list[Node]:
        """w from v: spherical rates turned into the axes before the rotation."""
        result = list(v)
        for link in self.tree.links[1:]:
            result[link.v] = link.pair.joint_rates(self.placed[link.index], v[link.v])
        return result

    def tree_rates(self, w: Sequence[Node]) -> list[Node]:
        """v from w."""
        result = list(w)
        for link in self.tree.links[1:]:
            result[link.v] = link.pair.tree_rates(self.placed[link.index], w[link.v])
        return result
