"""Rates of cranks from the lengths of their rods: what a platform's motion asks of a crank, without the rod's angles.

With n from the rod's centre c on the crank to its tip on the platform, all in the axes before the crank's motion,

    n . n' = 0    and    n . n'' + n' . n' = 0,    n' = (velocity of the tip) - q' z x c.

Each is one row of the closure with the crank's rate alone in it. It takes the place of that row of the cut joint that
is most along the rod, so that the rod's own rates are needed only for what turns with the rod.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import Node, Vector, dot, subtract
from symscrew.kinematics import Rates, System
from symscrew.loops.limbs.crank_limbs import CrankLimb


@dataclass(frozen=True)
class LengthRow:
    """n . (V_hub - V_crank) = 0, that a rod keeps its length: one row in the crank's rate alone, the platform's given.

    `index` is the row of the closure that it replaces, `entry` that of the crank's rate.

    `n` and `arm`, the rod and its centre seen from the crank's origin, are in the axes before the crank's motion.
    """

    index: int
    limb: CrankLimb
    n: Vector
    arm: Vector
    entry: Node

    @property
    def column(self) -> int:
        """The crank's index into v."""
        return int(self.limb.crank.v.start)

    def opening(self, system: System) -> Node:
        """How fast the platform's own motion, that of a system whose cranks are at rest, would shorten the rod."""
        return -system.tape.node(dot(self.n, _tip_velocity(system, self.limb)))

    def bias(self, system: System, hub: Rates) -> Node:
        """The same for accelerations; the system has all its rates, `hub` are the platform's with its accelerations."""
        rate = system.inputs.v[self.column]
        x, y, _ = self.arm
        swept = subtract(_tip_velocity(system, self.limb), (-y * rate, x * rate, 0))
        inwards = (rate * rate) * (self.n[0] * x + self.n[1] * y)
        result: Node = -(dot(self.n, _tip_acceleration(system, self.limb, hub)) + dot(swept, swept) + inwards)
        return result


def length_rows(system: System, cranks: Sequence[CrankLimb], guess: Sequence[Node]) -> tuple[LengthRow, ...]:
    """One row per crank, at the system's present nodes, which are those of its closed form for this guess."""
    first = {}
    count = 0
    for cut in system.cuts:
        first[cut.joint.name], count = count, count + len(cut.rows)
    rows = []
    for limb in cranks:
        cut, link = limb.cut, limb.crank.index
        far = system.linkage.seen_before(cut.hub, link, cut.hub_point)
        arm = system.placed[link].before(limb.rod.centre)
        n = subtract(far, arm)
        index = first[cut.joint.name] + limb.rod.left_open[0]
        rows.append(LengthRow(index, limb, n, arm, limb.lever(system, far, guess)))
    return tuple(rows)


def _tip_velocity(system: System, limb: CrankLimb) -> Vector:
    """Velocity of the hub's point at the rod's tip, axes before the crank's motion."""
    cut = limb.cut
    twist = system.twist[cut.hub]
    return system.linkage.velocity_across(twist, cut.hub, limb.crank.index, cut.hub_point)


def _tip_acceleration(system: System, limb: CrankLimb, hub: Rates) -> Vector:
    """Acceleration of the hub's point at the rod's tip, axes before the crank's motion."""
    cut = limb.cut
    return system.linkage.acceleration_across(hub, cut.hub, limb.crank.index, cut.hub_point)
