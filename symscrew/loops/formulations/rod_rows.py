"""A rod's rows of the closure by where its ends are, in the axes of the body that carries it.

With n from the rod's centre to its tip, both where its carrier and its hub have them, e the first axis of the crossing
rotations there and b = e x n / s the second one, the tip's motion seen from the carrier, w, is split into

    n . w = 0,    b . w = s q1',    e . w = -s q2',    s = b . (e x n):

one row for the rod's length, without its own rates, and one for each of these. Of the rod's angles only the second
one's cosine or sine is needed, for s: how far the rod is from its first axis. The rows are combinations of those in the
axes of the rod's end, true for closed loops.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from symscrew.algebra import (
    Affine,
    Node,
    Vector,
    add,
    cross,
    dot,
    named,
    named_entries,
    named_vector,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.kinematics import GROUND, Cut, Rates, System
from symscrew.loops.formulations.cut_rows import CutRows
from symscrew.loops.limbs import RodLimb, rod_limb


@dataclass(frozen=True, kw_only=True)
class RodRows(CutRows):
    """The rows of one rod, for its length, its first and its second angle.

    `axis`, `across` and `n` are e, b and n in the axes that the rod's carrier has before its motion, `aside` is s.
    """

    limb: RodLimb
    axis: Vector = field(repr=False)
    across: Vector = field(repr=False)
    n: Vector = field(repr=False)
    aside: Node = field(repr=False)

    @property
    def of_system(self) -> bool:
        """No: they are combinations of the system's rows, equal for closed loops only."""
        return False

    @property
    def carrier(self) -> int:
        """The link that carries the rod."""
        return self.limb.first.parent

    def bias(self, moving: System, cut: Cut, still: Sequence[Rates]) -> Sequence[Node]:
        """(dJ/dt) v per row, by the acceleration of the rod's tip seen from its carrier."""
        tape, placed, limb = moving.tape, moving.placed, self.limb
        at, hub, point = placed[self.carrier], limb.cut.hub, limb.cut.hub_point
        gain = moving.linkage.acceleration_across(still[hub], hub, self.carrier, point)
        gain = seen = subtract(gain, at.before(still[self.carrier].at(limb.centre)))
        turning, tilting = (moving.inputs.v[link.v.start] for link in (limb.first, limb.second))
        along = dot(self.axis, self.n)
        side = self._along_crank(moving)
        if side:
            turning = turning + side * moving.inputs.v[moving.tree.links[self.carrier].v.start]
            square = tape.settle(dot(limb.tip, limb.tip))
            inwards = turning * turning * (self.aside * self.aside) + tilting * tilting * square
        else:
            own = moving.twist[self.carrier]
            far = moving.linkage.velocity_across(moving.twist[hub], hub, self.carrier, point)
            drift = subtract(far, at.before(own.velocity_at(limb.centre)))
            omega, alpha = at.before(own.angular), at.before(still[self.carrier].alpha)
            swept = cross(omega, self.n)
            rest = subtract(drift, swept)
            seen = subtract(subtract(seen, cross(alpha, self.n)), cross(omega, add(swept, add(rest, rest))))
            inwards = dot(drift, drift)
        both = along * (turning * tilting)
        values = (
            -(dot(self.n, gain) + inwards),
            both + both - dot(self.across, seen),
            -(dot(self.axis, seen) + along * (tilting * tilting)),
        )
        return [tape.node(value) for value in values]

    def _along_crank(self, system: System) -> int:
        """1 or -1 where the rod's first axis is along or against that of a crank on the ground, which carries it.

        Both turn about one axis then, which is at rest.
        """
        link = system.tree.links[self.carrier]
        if self.carrier == GROUND or link.parent != GROUND or not link.motion.revolute:
            return 0
        x, y, z = (system.tape.node(c).value for c in self.axis)
        return {(0, 0, 1): 1, (0, 0, -1): -1}.get((x, y, z), 0)


def rod_rows(system: System, cut: Cut) -> RodRows | None:
    """The rows of a cut spherical joint at the end of a rod, else None."""
    limb = _rod(system, cut) if cut.is_joint else None
    if limb is None:
        return None
    placed, frames = system.placed, system.frames
    carrier = limb.first.parent
    at = placed[carrier]
    arm = at.before(limb.centre)
    axis = at.before(transform(frames[limb.first.index].rotation, (0, 0, 1)))
    far = system.linkage.seen_before(cut.hub, carrier, cut.hub_point)
    n = subtract(far, arm)
    aside = _aside(system, limb)
    across = scale(1 / aside, cross(axis, n))
    own: tuple[Affine, ...] = ({}, {limb.first.v.start: aside}, {limb.second.v.start: -aside})
    rows = []
    for direction, tip, entries in zip((n, across, axis), (arm, far, far), own, strict=True):
        row = _difference(system, cut, carrier, at=tip, direction=direction) | entries
        rows.append({k: e for k, e in row.items() if e is not system.tape.zero})
    _name(system, limb, (n, across, aside), rows)
    size = system.tape.sqrt(system.tape.node(dot(limb.tip, limb.tip)))
    length = float(system.numeric([size], (system.inputs.q, system.reference))[0])
    return RodRows(
        cut=cut,
        rows=tuple(rows),
        scales=tuple(1.0 / (system.length * one) for one in (length, 1.0, 1.0)),
        limb=limb,
        axis=axis,
        across=across,
        n=n,
        aside=aside,
    )


def _name(system: System, limb: RodLimb, seen: tuple[Vector, Vector, Node], rows: Sequence[Affine]) -> None:
    """Call what the rows are made of so."""
    part, (n, across, aside) = system.tree.part(limb.second.index), seen
    named_vector(n, "rod", part)
    named_vector(across, "second_axis", part)
    named(aside, "aside", part)
    for name, row in zip(("length", "first", "second"), rows, strict=True):
        named_entries(row.values(), "closure", [f"{part}.{name}|{system.tree.v[k].label}" for k in row])


def _rod(system: System, cut: Cut) -> RodLimb | None:
    limb = rod_limb(system, cut)
    if limb is None or not cut.joint.kind.ball or limb.first.parent == cut.hub or cut.arm is not None:
        return None
    on_line = all(system.tape.settle(c) is system.tape.zero for c in subtract(limb.tip, cut.tip_point))
    return limb if on_line else None


def _aside(system: System, limb: RodLimb) -> Node:
    """s = (second axis) . (e x n): by the rod's second angle."""
    gx, gy, _ = transform(transpose(system.frames[limb.second.index].rotation), (0, 0, 1))
    x, y, _ = limb.tip
    turn = system.placed[limb.second.index].turn
    px, py, _ = transform(turn, (x, y, 0))
    return system.tape.node(gx * py - gy * px)


def _difference(system: System, cut: Cut, carrier: int, *, at: Vector, direction: Vector) -> Affine:
    """Velocity along a direction of the rod's tip as a point of the carrier, at `at`, less that of the hub's point.

    Per joint rate; `at` from the carrier's origin, in the axes before the carrier's motion as the direction is.
    """
    tree, placed = system.tree, system.placed
    common = tree.common(carrier, cut.hub)
    row: Affine = {}
    if carrier != common:
        row |= system.powers(carrier, direction, cross(at, direction), common)
    if cut.hub != common:
        force = system.linkage.carry_across(carrier, cut.hub, direction)
        moment = cross(placed[cut.hub].before(cut.hub_point), force)
        for k, entry in system.powers(cut.hub, force, moment, common).items():
            row[k] = row[k] - entry if k in row else -entry
    return row
