"""Closed form of a spoke: two crossing rotations and a slide along a line through their point (U-P, as in UPS
and UPU)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from symscrew.algebra import Node, Vector, add, dot, named, named_vector, scale, subtract, transform, transpose
from symscrew.kinematics import Cut, Link, System, Turn
from symscrew.loops.limbs.limb_form import LimbForm


@dataclass(frozen=True)
class SpokeLimb(LimbForm):
    """A limb ground - R - R - P - tip with all axes and the tip on lines through one point of the ground."""

    cut: Cut
    first: Link
    second: Link
    slider: Link
    rest: Node  # distance of the tip from the centre at slider coordinate 0, along the slider's axis

    @property
    def links(self) -> tuple[Link, ...]:
        """The limb's links from the ground."""
        return (self.first, self.second, self.slider)

    def solve(self, system: System, target: Vector, guess: Sequence[Node]) -> tuple[dict[int, Turn], dict[int, Node]]:
        """Cosine and sine of both angles by link, the slide by its index into q; the length is positive."""
        frames = system.frames
        first = frames[self.first.index]
        d = transform(transpose(first.rotation), subtract(target, first.offset))
        ex, ey = frames[self.slider.index].axis[0], frames[self.slider.index].axis[1]
        turns, length = pointing(system, (self.first, self.second), d, pointer=(ex, ey), guess=guess)
        return turns, {self.slider.q.start: length - self.rest}


def pointing(
    system: System,
    links: tuple[Link, Link],
    d: Vector,
    *,
    pointer: Turn,
    guess: Sequence[Node],
    length: Node | None = None,
) -> tuple[dict[int, Turn], Node]:
    """Turns of two links on crossing axes by which a unit vector of the second is along d, and the length of d.

    `d` is in the axes before the first link's motion, `pointer` in the second's axes, across its own. `length`: that
    of d where it is known.
    """
    tape, (first, second) = system.tape, links
    outer = system.frames[second.index]
    across = d[0] * d[0] + d[1] * d[1]
    radius = tape.sqrt(across)
    length = tape.sqrt(across + d[2] * d[2]) if length is None else length
    part = system.tree.part(second.index)
    named_vector(d, "limb_target", part)
    named(length, "limb_length", part)
    # The second axis b is perpendicular to d: turned by the first angle it is (-d_y, d_x)/radius.
    bx, by = outer.axis[0], outer.axis[1]
    wanted = d[0] * by - d[1] * bx, d[0] * bx + d[1] * by
    side = side_of_guess(system, first, lambda turn: wanted[0] * turn[0] + wanted[1] * turn[1], guess)
    inverse, signed = side / radius, side * radius
    cosine, sine = wanted[0] * inverse, wanted[1] * inverse
    # After the first rotation, in the axes before the second: the direction in the plane across b.
    turned: Vector = (by * signed, -bx * signed, d[2])
    flat = transform(transpose(outer.rotation), turned)
    ex, ey = pointer
    shorter = 1 / length
    other = ((flat[0] * ex + flat[1] * ey) * shorter, (flat[1] * ex - flat[0] * ey) * shorter)
    return {first.index: (cosine, sine), second.index: other}, length


def spoke_limb(system: System, cut: Cut) -> SpokeLimb | None:
    """The cut joint's limb if it is a spoke, else None."""
    path = system.tree.path(cut.tip)
    if len(path) != 3:
        return None
    slider, second, first = (system.tree.links[i] for i in path)
    if not (first.motion.revolute and second.motion.revolute and slider.motion.prismatic):
        return None
    frames, settle = system.frames, system.geometry.settle
    tip = settle(add(frames[slider.index].offset, cut.tip_point))
    axis = frames[slider.index].axis
    rest = system.tape.settle(dot(tip, axis))
    conditions = (
        *frames[second.index].offset,  # both rotations through one point
        frames[second.index].axis[2],  # crossing at a right angle
        axis[2],  # the slide at a right angle to the second axis
        *settle(subtract(tip, scale(rest, axis))),  # the tip on the line of sliding
    )
    if any(system.tape.settle(c) is not system.tape.zero for c in conditions):
        return None
    return SpokeLimb(cut, first, second, slider, rest + frames[slider.index].phase)


def side_of_guess(system: System, link: Link, measure: Callable[[Turn], Node], guess: Sequence[Node]) -> Node:
    """+1 or -1: the sign of a measure of a link's turn at the guess; that in the reference if the guess is constant."""
    tape = system.tape
    angle = guess[link.q.start] + system.frames[link.index].phase
    c, s = tape.function("cos", angle), tape.function("sin", angle)
    near = measure((c, s))
    if c.value is not None and s.value is not None:
        # a fixed guess: decide now, so that the generated code does not have to
        positive = float(system.numeric([near], (system.inputs.q, system.reference))[0]) > 0
        return tape.one if positive else -tape.one
    return tape.function("select", tape.function("less", near, tape.zero), -tape.one, tape.one)
