"""Closed forms of rods and of cranks with a rod: U-S and R-U-S, as in rotary hexapods and deltas.

A rod is two crossing rotations and a tip across the second: it points from their centre to where the platform holds
its tip. The rod's length tells how far a crank has turned: in the plane across the crank's axis the tip seen from
the crank and the rod's centre are sides of a triangle. Further rods of the same crank have their directions left to
find; that their lengths fit is the closure's affair, as it is with a rod on the ground. Vectors in the plane are
treated as complex numbers. Out of the rod's reach a radicand is negative, and the result is not a number.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import Node, Vector, add, dot, scale, subtract, transform, transpose
from symscrew.kinematics import Cut, Link, Linkage, System, Turn
from symscrew.loops.limbs.limb_form import LimbForm
from symscrew.loops.limbs.planar_limbs import over, square, times
from symscrew.loops.limbs.spoke_limbs import pointing, side_of_guess


@dataclass(frozen=True)
class RodLimb(LimbForm):
    """A rod on two crossing rotations: `centre` in coordinates of the link that carries it, `tip` from there.

    The tip is in the second link's axes, across its own. `left_open`: the component of the tip's place, in these axes,
    that the closed form leaves to the closure, as a tuple: the one most along the rod.
    """

    cut: Cut
    first: Link
    second: Link
    centre: Vector
    tip: Vector
    left_open: tuple[int, ...]

    through_rods = True

    @property
    def links(self) -> tuple[Link, ...]:
        """The rod's links, from the one that carries it."""
        return (self.first, self.second)

    def solve(self, system: System, target: Vector, guess: Sequence[Node]) -> tuple[dict[int, Turn], dict[int, Node]]:
        """Cosine and sine of both angles by link; where the rod does not reach it points there all the same."""
        return self.along(system, subtract(target, self.centre), guess), {}

    def opening(self, system: System, target: Vector) -> Node | None:
        """By how much the rod is too short for where it points, to first order: from the squares of both lengths."""
        tape, n = system.tape, subtract(target, self.centre)
        x, y, z = transform(transpose(system.frames[self.first.index].rotation), n)
        square = tape.settle(dot(self.tip, self.tip))
        twice = tape.settle(2 * tape.sqrt(square))
        short: Node = (x * x + y * y + z * z - square) * tape.settle(1 / twice)
        return short

    def along(self, system: System, n: Vector, guess: Sequence[Node], length: Node | None = None) -> dict[int, Turn]:
        """The turns by which the rod is along n, given in axes of the link that carries it; `length`: that of n."""
        before = transform(transpose(system.frames[self.first.index].rotation), n)
        x, y, _ = system.geometry.unit(self.tip)
        return pointing(system, (self.first, self.second), before, pointer=(x, y), guess=guess, length=length)[0]


@dataclass(frozen=True)
class CrankLimb(LimbForm):
    """A crank and its rod."""

    cut: Cut
    crank: Link
    rod: RodLimb

    through_rods = True

    @property
    def links(self) -> tuple[Link, ...]:
        """The limb's links, from the one that carries the crank."""
        return (self.crank, *self.rod.links)

    def target(self, linkage: Linkage) -> Vector:
        """Where the platform holds the tip [m], as the crank sees it before its motion."""
        return linkage.seen_before(self.cut.hub, self.crank.index, self.cut.hub_point)

    def solve(self, system: System, target: Vector, guess: Sequence[Node]) -> tuple[dict[int, Turn], dict[int, Node]]:
        """Cosine and sine by link, on the guess's side of the dead centre.

        The target is seen from the crank's origin, in the axes before its motion.
        """
        tape, geometry = system.tape, system.geometry
        c, t = self.rod.centre, self.rod.tip
        d: Turn = (target[0], target[1])
        x, y = self._triangle(system, target, guess)
        ex, ey, _ = geometry.unit((c[0], c[1], 0))
        inverse = 1 / square(d)
        turn = over(times(d, (x * inverse, y * inverse)), (ex, ey))
        flat = times((ex, ey), (x - self._arm(system), -y))  # the rod, from its centre, in the crank's axes
        length = tape.settle(tape.sqrt(tape.settle(dot(t, t))))
        return {
            self.crank.index: turn,
            **self.rod.along(system, (flat[0], flat[1], target[2] - c[2]), guess, length),
        }, {}

    def lever(self, system: System, target: Vector, guess: Sequence[Node]) -> Node:
        """c x n along the crank's axis, with n the rod: how the crank's rate stretches it."""
        return -(self._arm(system) * self._triangle(system, target, guess)[1])

    def _triangle(self, system: System, target: Vector, guess: Sequence[Node]) -> Turn:
        """x and y with d conj(e^(i phi) c) = |c| (x - i y).

        d is the tip and c the rod's centre seen from the crank's origin, along and across its axis z, and t the rod:
        |d - e^(i phi) c|^2 + (d_z - c_z)^2 = |t|^2.
        """
        tape = system.tape
        c, t = self.rod.centre, self.rod.tip
        d: Turn = (target[0], target[1])
        ex, ey, _ = system.geometry.unit((c[0], c[1], 0))
        shorter = tape.settle(1 / self._arm(system))
        half = tape.settle(shorter * tape.reciprocal(tape.node(2)))
        across, rest = square(d), tape.settle(dot(c, c) - dot(t, t))
        x = (across + target[2] * target[2] + rest) * half - target[2] * tape.settle(c[2] * shorter)
        y = tape.sqrt(across - x * x)

        def beyond(turn: Turn) -> Node:
            along = times(turn, (ex, ey))
            return d[0] * along[1] - d[1] * along[0]

        return x, side_of_guess(system, self.crank, beyond, guess) * y

    def _arm(self, system: System) -> Node:
        """|c| across the crank's axis."""
        c = self.rod.centre
        return system.tape.sqrt(system.tape.settle(square((c[0], c[1]))))


def rod_limb(system: System, cut: Cut) -> RodLimb | None:
    """The last two motions of the cut joint's limb if they are those of a rod, else None."""
    path = system.tree.path(cut.tip)
    if len(path) < 2:
        return None
    second, first = (system.tree.links[i] for i in path[:2])
    if not (first.motion.revolute and second.motion.revolute):
        return None
    inner, outer = system.frames[first.index], system.frames[second.index]
    settle = system.geometry.settle
    # The second link's origin is anywhere on its axis: the centre is where that crosses the first link's.
    aside = system.tape.settle(dot(outer.offset, outer.axis))
    centre = settle(subtract(outer.offset, scale(aside, outer.axis)))
    tip = settle(add(cut.tip_point, (0, 0, aside)))
    conditions = (centre[0], centre[1], outer.axis[2], tip[2])
    if any(system.tape.settle(c) is not system.tape.zero for c in conditions) or _nothing(system, tip):
        return None
    centre = settle(add(inner.offset, transform(inner.rotation, centre)))
    x, y = abs(system.numeric([system.tape.node(c) for c in tip[:2]], (system.inputs.q, system.reference)))
    return RodLimb(cut, first, second, centre, tip, (int(y > x),))


def crank_limb(system: System, cut: Cut) -> CrankLimb | None:
    """The cut joint's limb if it is a crank with a rod, else None."""
    path, rod = system.tree.path(cut.tip), rod_limb(system, cut)
    if rod is None or len(path) != 3 or not system.tree.links[path[2]].motion.revolute:
        return None
    if _nothing(system, (rod.centre[0], rod.centre[1], 0)):
        return None
    return CrankLimb(cut, system.tree.links[path[2]], rod)


def _nothing(system: System, vector: Vector) -> bool:
    return all(system.tape.settle(c) is system.tape.zero for c in vector)
