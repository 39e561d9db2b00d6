"""Closed forms for limbs: joint coordinates from where the platform holds the limb's tip.

A limb whose first three motions are two crossing rotations and a slide along a line through their point
(U-P, as in UPS and UPU) reaches a point with its tip in one way up to two signs. Cosine and sine of its
angles come out without trigonometry. The signs are those of a guess, or of the reference configuration.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.closure import Cut
from symscrew.recursion import placements, poses
from symscrew.screws import Vector, add, dot, scale, subtract, transform, transpose
from symscrew.system import System
from symscrew.tape import Node
from symscrew.tree import Link

Turn = tuple[Node, Node]


@dataclass(frozen=True)
class SpokeLimb:
    """A limb ground - R - R - P - tip with all axes and the tip on lines through one point of the ground."""

    cut: Cut
    first: Link
    second: Link
    slider: Link
    rest: Node  # distance of the tip from the centre at slider coordinate 0 along the slider's axis


@dataclass(frozen=True)
class LimbCoordinates:
    """q with the limbs' entries put in, and cosine and sine of the limbs' angles by link."""

    q: tuple[Node, ...]
    turns: dict[int, Turn]


def hub_links(system: System) -> tuple[Link, ...] | None:
    """The links of the platform's own joint, if it hangs on a single joint from the ground; else None."""
    platform = system.mechanism.platform
    if platform is None or platform not in system.tree.link_of_body or not system.cuts:
        return None
    links = tuple(system.tree.links[i] for i in reversed(system.tree.path(system.tree.link_of_body[platform])))
    return links if links and len({link.joint for link in links}) == 1 else None


def spoke_limbs(system: System) -> tuple[SpokeLimb, ...] | None:
    """All limbs, if the platform hangs on one joint and every other link belongs to such a limb; else None."""
    hub = hub_links(system)
    if hub is None:
        return None
    limbs = []
    covered = {link.index for link in hub}
    for cut in system.cuts:
        limb = _spoke(system, cut)
        if limb is None or cut.hub != hub[-1].index:
            return None
        limbs.append(limb)
        covered |= {limb.first.index, limb.second.index, limb.slider.index}
    return tuple(limbs) if len(covered) == len(system.tree.links) - 1 else None


def _spoke(system: System, cut: Cut) -> SpokeLimb | None:
    path = system.tree.path(cut.tip)
    if len(path) != 3:
        return None
    slider, second, first = (system.tree.links[i] for i in path)
    kinds = [link.motion.kind for link in (first, second, slider) if link.motion is not None]
    if kinds != ["R", "R", "P"] or any(row.unit == "N" for row in cut.rows[3:]):
        return None
    frames, settle = system.frames, system.geometry.settle
    tip = settle(add(frames[slider.index].offset, cut.tip_point))
    axis = frames[slider.index].axis
    rest = system.tape.settle(dot(tip, axis))
    zero = system.tape.zero
    conditions = (
        *frames[second.index].offset,  # both rotations through one point
        frames[second.index].axis[2],  # crossing at a right angle
        axis[2],  # the slide at a right angle to the second axis
        *settle(subtract(tip, scale(rest, axis))),  # the tip on the line of sliding
    )
    if any(system.tape.settle(c) is not zero for c in conditions):
        return None
    return SpokeLimb(cut, first, second, slider, rest + frames[slider.index].phase)


def limb_coordinates(
    system: System, limbs: Sequence[SpokeLimb], hub_q: dict[int, Node], guess: Sequence[Node] | None = None
) -> LimbCoordinates:
    """q for given coordinates of the platform's joint (index into q -> node); limbs in closed form.

    With a `guess` (nodes of q) angles are those nearest to it, on its branch; otherwise to the reference
    configuration. Leg lengths are positive.
    """
    zero = system.tape.zero
    q = [hub_q.get(k, zero) for k in range(len(system.tree.q))]
    placed = placements(system.tape, system.tree, system.frames, q, {i: (system.tape.one, zero) for i in _turning(system)})
    pose = poses(system.tree, placed)
    turns: dict[int, Turn] = {}
    for limb in limbs:
        target = pose[limb.cut.hub].point(limb.cut.hub_point)
        _solve(system, limb, target, q, turns, guess)
    return LimbCoordinates(tuple(q), turns)


def _turning(system: System) -> list[int]:
    return [link.index for link in system.tree.links[1:] if link.motion is not None and link.motion.kind in "RH"]


def _solve(
    system: System,
    limb: SpokeLimb,
    target: Vector,
    q: list[Node],
    turns: dict[int, Turn],
    guess: Sequence[Node] | None,
) -> None:
    """Angles and length of one limb; fills the caller's `q` and `turns`."""
    tape, frames = system.tape, system.frames
    first, second = frames[limb.first.index], frames[limb.second.index]
    d = transform(transpose(first.rotation), subtract(target, first.offset))
    across = d[0] * d[0] + d[1] * d[1]
    radius = tape.sqrt(across)
    length = tape.sqrt(across + d[2] * d[2])
    # The second axis b is perpendicular to d: turned by the first angle it is (-d_y, d_x)/radius.
    bx, by = second.axis[0], second.axis[1]
    cosine = (d[0] * by - d[1] * bx) / radius
    sine = (d[0] * bx + d[1] * by) / radius
    sign = _branch(system, limb, cosine, sine, guess)
    cosine, sine = sign * cosine, sign * sine
    turns[limb.first.index] = (cosine, sine)
    # In the axes after the first rotation, then before the second: the leg's direction in the plane across b.
    turned: Vector = (cosine * d[0] + sine * d[1], cosine * d[1] - sine * d[0], d[2])
    flat = transform(transpose(second.rotation), turned)
    ex, ey = frames[limb.slider.index].axis[0], frames[limb.slider.index].axis[1]
    inverse = 1 / length
    cosine2 = (flat[0] * ex + flat[1] * ey) * inverse
    sine2 = (flat[1] * ex - flat[0] * ey) * inverse
    turns[limb.second.index] = (cosine2, sine2)
    q[limb.first.q.start] = _angle(system, limb.first, cosine, sine, guess)
    q[limb.second.q.start] = _angle(system, limb.second, cosine2, sine2, guess)
    q[limb.slider.q.start] = length - limb.rest


def _branch(system: System, limb: SpokeLimb, cosine: Node, sine: Node, guess: Sequence[Node] | None) -> Node:
    """+1 or -1: which way round the first axis; a guess decides at run time, else the reference configuration."""
    tape = system.tape
    phase = system.frames[limb.first.index].phase
    if guess is not None:
        angle = guess[limb.first.q.start] + phase
        near = cosine * tape.function("cos", angle) + sine * tape.function("sin", angle)
        return tape.function("select", tape.function("less", near, tape.zero), -tape.one, tape.one)
    angle = system.frames[limb.first.index].reference + phase
    near = cosine * tape.function("cos", angle) + sine * tape.function("sin", angle)
    sample = float(system.numeric([near], (system.inputs.q, system.reference))[0])
    return tape.one if sample > 0 else -tape.one


def _angle(system: System, link: Link, cosine: Node, sine: Node, guess: Sequence[Node] | None) -> Node:
    """The joint's coordinate from cosine and sine of coordinate + phase."""
    tape, phase = system.tape, system.frames[link.index].phase
    near = tape.node(guess[link.q.start] if guess is not None else system.frames[link.index].reference)
    c, s = tape.function("cos", near + phase), tape.function("sin", near + phase)
    return near + tape.function("atan2", sine * c - cosine * s, cosine * c + sine * s)
