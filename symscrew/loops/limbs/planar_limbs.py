"""Closed forms of limbs with two planar motions: R-R, P-R and R-P, as in RRR, RRS, PRS and RPS.

The plane is that of the limb's revolute axes; what the platform's point does across it is left to the
closure. Vectors in the plane are treated as complex numbers. A radicand that becomes negative means that
the point cannot be reached; the result is then not a number and the status says so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import Node, Vector, add, dot, scale, subtract, transform, transpose
from symscrew.kinematics import Cut, Link, System, Turn
from symscrew.loops.limbs.limb_form import LimbForm

Complex = tuple[Node, Node]


def times(a: Complex, b: Complex) -> Complex:
    """a b."""
    return (a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0])


def over(a: Complex, b: Complex) -> Complex:
    """a conj(b): the rotation from b to a, times the product of their lengths."""
    return (a[0] * b[0] + a[1] * b[1], a[1] * b[0] - a[0] * b[1])


def square(a: Complex) -> Node:
    """|a|^2."""
    return a[0] * a[0] + a[1] * a[1]


def same_side(like: Node, sign_of: Node) -> Node:
    """`like` with the sign of `sign_of` (`like` is not negative)."""
    tape = like.tape
    return tape.function("select", tape.function("less", sign_of, tape.zero), -like, like)


@dataclass(frozen=True)
class PlanarLimb(LimbForm):
    """A limb of two planar motions; `kinds` is "RR", "PR" or "RP"."""

    cut: Cut
    first: Link
    second: Link
    kinds: str

    left_open = (2,)  # across the plane

    @property
    def links(self) -> tuple[Link, ...]:
        """The limb's links from the ground."""
        return (self.first, self.second)

    def solve(self, system: System, target: Vector, guess: Sequence[Node]) -> tuple[dict[int, Turn], dict[int, Node]]:
        """Cosine and sine by link, and slider coordinates by index into q, on the branch of the guess."""
        return {"RR": _two_turns, "PR": _slide_turn, "RP": _turn_slide}[self.kinds](system, self, target, guess)


def planar_limb(system: System, cut: Cut) -> PlanarLimb | None:
    """The cut joint's limb if it is planar with two motions, else None."""
    path = system.tree.path(cut.tip)
    if len(path) != 2:
        return None
    second, first = (system.tree.links[i] for i in path)
    kinds = first.motion.kind + second.motion.kind
    axis = system.frames[second.index].axis
    tape = system.tape
    if kinds == "RR":
        planar = all(tape.settle(c) is tape.zero for c in axis[:2])
    elif kinds == "RP":
        planar = tape.settle(axis[2]) is tape.zero
    elif kinds == "PR":
        planar = tape.settle(dot(axis, system.frames[first.index].axis)) is tape.zero
    else:
        return None
    return PlanarLimb(cut, first, second, kinds) if planar else None


def _present(system: System, link: Link, guess: Sequence[Node]) -> Turn:
    """Cosine and sine of a link's angle at the guess."""
    angle = system.tape.node(guess[link.q.start]) + system.frames[link.index].phase
    return system.tape.function("cos", angle), system.tape.function("sin", angle)


def _two_turns(
    system: System, limb: PlanarLimb, target: Vector, guess: Sequence[Node]
) -> tuple[dict[int, Turn], dict[int, Node]]:
    """d = e^(i a) (o + w), w = B e^(i b) t with known lengths: the law of cosines."""
    first, second = system.frames[limb.first.index], system.frames[limb.second.index]
    d3 = transform(transpose(first.rotation), subtract(target, first.offset))
    d, o, t = (
        (d3[0], d3[1]),
        (second.offset[0], second.offset[1]),
        (limb.cut.tip_point[0], limb.cut.tip_point[1]),
    )
    tape = system.tape
    half = tape.reciprocal(tape.node(2))
    inner = half * (square(d) - (square(o) + square(t)))
    outer = tape.sqrt(square(o) * square(t) - inner * inner)
    present = times(_present(system, limb.second, guess), t)
    now = transform(second.rotation, (present[0], present[1], 0))
    outer = same_side(outer, o[0] * now[1] - o[1] * now[0])
    factor = 1 / square(o)
    w: Complex = (factor * (o[0] * inner - o[1] * outer), factor * (o[1] * inner + o[0] * outer))
    inverse = 1 / square(d)
    turn = over(d, (o[0] + w[0], o[1] + w[1]))
    back = transform(transpose(second.rotation), (w[0], w[1], 0))
    other = over((back[0], back[1]), t)
    shorter = 1 / square(t)
    return {
        limb.first.index: (turn[0] * inverse, turn[1] * inverse),
        limb.second.index: (other[0] * shorter, other[1] * shorter),
    }, {}


def _slide_turn(
    system: System, limb: PlanarLimb, target: Vector, guess: Sequence[Node]
) -> tuple[dict[int, Turn], dict[int, Node]]:
    """d = e s + e^(i b) t: the point on the slide at the arm's length from d."""
    first, second = system.frames[limb.first.index], system.frames[limb.second.index]
    tape = system.tape
    back = transpose(second.rotation)
    start = add(first.offset, second.offset)
    d3, e3 = transform(back, subtract(target, start)), system.geometry.settle(transform(back, first.axis))
    d, e, t = (d3[0], d3[1]), (e3[0], e3[1]), (limb.cut.tip_point[0], limb.cut.tip_point[1])
    along, across = d[0] * e[0] + d[1] * e[1], e[0] * d[1] - e[1] * d[0]
    arm = tape.sqrt(square(t) - across * across)
    present = times(_present(system, limb.second, guess), t)
    arm = same_side(arm, present[0] * e[0] + present[1] * e[1])
    slide = along - arm
    turn = over((d[0] - e[0] * slide, d[1] - e[1] * slide), t)
    shorter = 1 / square(t)
    return {limb.second.index: (turn[0] * shorter, turn[1] * shorter)}, {limb.first.q.start: slide - first.phase}


def _turn_slide(
    system: System, limb: PlanarLimb, target: Vector, guess: Sequence[Node]
) -> tuple[dict[int, Turn], dict[int, Node]]:
    """d = e^(i a) (e r + h): the slide's length from the distance, h the constant offset across it."""
    first, second = system.frames[limb.first.index], system.frames[limb.second.index]
    tape = system.tape
    d3 = transform(transpose(first.rotation), subtract(target, first.offset))
    d = (d3[0], d3[1])
    tip = system.geometry.settle(add(second.offset, limb.cut.tip_point))
    rest = tape.settle(dot(tip, second.axis))
    h = system.geometry.settle(subtract(tip, scale(rest, second.axis)))
    present = tape.node(guess[limb.second.q.start]) + second.phase + rest
    length = same_side(tape.sqrt(square(d) - square((h[0], h[1]))), present)
    turn = over(d, (second.axis[0] * length + h[0], second.axis[1] * length + h[1]))
    inverse = 1 / square(d)
    slide = length - (rest + second.phase)
    return {limb.first.index: (turn[0] * inverse, turn[1] * inverse)}, {limb.second.q.start: slide}
