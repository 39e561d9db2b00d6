"""How the power that a motion needs along given rates changes along directions of the state.

Every link carries what its joint must supply: the rate of its momentum screw and what stands outboard, less loads
and the wrenches of cut joints. These are held in the axes of their hubs, where several of them meet, or of their tips
where the hub is the ground or slides: every choice is as good, as they do no work along consistent rates. What
effects add is differentiated on the tape.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from symscrew.algebra import (
    ZERO,
    Node,
    Vector,
    add,
    cross,
    differentiate,
    dot,
    named_wrench,
    scale,
    subtract,
    transform,
)
from symscrew.dynamics.derivatives.closure_variations import relative_turns
from symscrew.dynamics.derivatives.motion_variations import Variation, link_rotations
from symscrew.effects import Acting
from symscrew.kinematics import GROUND, Cut, Inertia, Link, Rates, own_screws, twists, universal_axes

Wrench = tuple[Vector, Vector]  # (force, moment)
VariedWrench = list[Wrench]
Columns = Sequence[Sequence[Node]]


def power_changes(
    variation: Variation, acting: Acting, *, multipliers: Mapping[int, Node], columns: Columns, forces: Columns
) -> list[list[Node]]:
    """Changes of S . W, summed over all freedoms with the rates of each column: [column][direction].

    `forces`: further generalised forces of all freedoms (for v) per direction.

    `columns` are consistent joint rates w; they, the multipliers of the cut joints (by row of the closure) and
    the drives in `acting` are held. Together they must be in equilibrium with the motion.
    """
    return _Powers(variation, acting, multipliers, columns, forces).run()


@dataclass(frozen=True)
class _Powers:
    variation: Variation
    acting: Acting
    multipliers: Mapping[int, Node]
    columns: Columns
    forces: Columns

    def run(self) -> list[list[Node]]:
        system, tape = self.variation.system, self.variation.system.tape
        total = [[tape.zero] * len(self.variation.directions) for _ in self.columns]
        in_v = [system.tree_rates(column) for column in self.columns]
        own, outer = self._wrenches()
        first = 0
        for cut, wrench in self._cut_wrenches():
            if cut.tip != GROUND:
                less = [(scale(-1, f), scale(-1, add(m, cross(cut.tip_point, f)))) for f, m in wrench]
                own[cut.tip] = _both(own.get(cut.tip), less)
            if self._held_in_hub(cut):
                own[cut.hub] = _both(own.get(cut.hub), self._on_hub(cut, wrench[0], first))
            elif cut.hub != GROUND:
                outer[cut.hub] = _both(outer.get(cut.hub), self._on_sliding_hub(cut, wrench[0]))
                self._turned_with_tip(total, in_v, cut, wrench)
            first += len(cut.rows)
        beside = {*self.acting.known_forces(system.inputs.a), *system.drive_rows()}
        for link in reversed(system.tree.links[1:]):
            here, frame = system.placed[link.index], system.frames[link.index]
            steps = [own_screws(link, frame, direction.step) for direction in self.variation.in_v]
            f0, m0 = own[link.index][0]
            turned = [(f0, m0)]
            for (f, m), step in zip(own[link.index][1:], steps, strict=True):
                turned.append((add(f, cross(step.angular, f0)), add(m, cross(step.angular, m0))))
            # All freedoms of a joint in the same axes, its child's if nothing stands in others: together they balance.
            apart = link.index in outer or not beside.isdisjoint(range(link.v.start, link.v.stop))
            self._collect(total, in_v, link, turned if apart else own[link.index], forces=self.forces)
            before = [(here.before(f), here.before(m)) for f, m in turned]
            for change, name in zip(turned, ("", *self.variation.names), strict=True):
                named_wrench(change, "force", system.tree.part(link.index), by=name)
            if link.index in outer:
                self._collect(total, self.columns, link, outer[link.index])
                before = _both(before, outer[link.index])
            if link.parent != GROUND:
                arrived = []
                for f, m in ((transform(here.rotation, f), transform(here.rotation, m)) for f, m in before):
                    arrived.append((f, add(m, cross(here.offset, f))))
                for k, step in enumerate(steps, start=1):
                    arrived[k] = (arrived[k][0], add(arrived[k][1], cross(step.linear, arrived[0][0])))
                own[link.parent] = _both(own.get(link.parent), arrived)
        self._less_joint_forces(total)
        return total

    def _collect(
        self, total: list[list[Node]], columns: Columns, link: Link, wrench: VariedWrench, *, forces: Columns = ()
    ) -> None:
        frame = self.variation.system.frames[link.index]
        for k, (f, m) in enumerate(wrench[1:]):
            values = link.pair.powers(frame, f, m)
            if forces:
                values = tuple(x + y for x, y in zip(values, forces[k][link.v], strict=True))
            for i, column in enumerate(columns):
                for rate, value in zip(column[link.v], values, strict=True):
                    total[i][k] = total[i][k] + rate * value

    def _less_joint_forces(self, total: list[list[Node]]) -> None:
        """What acts along single freedoms, for joint rates w."""
        variation = self.variation
        known = self.acting.known_forces(variation.system.inputs.a)
        keys = sorted(known)
        rows = differentiate(variation.system.tape, [known[k] for k in keys], variation.seeds, variation.names)
        for key, row in zip(keys, rows, strict=True):
            for i, column in enumerate(self.columns):
                total[i] = [t - column[key] * change for t, change in zip(total[i], row, strict=True)]

    def _wrenches(self) -> tuple[dict[int, VariedWrench], dict[int, VariedWrench]]:
        """Inertial wrenches in the links' own axes, loads in the axes before their motions, signs as supplied."""
        system, acting = self.variation.system, self.acting
        moving, lean = acting.link_rates(system.inputs.a), acting.lean_inertia()
        changes = self.variation.rate_changes(moving)
        own = {}
        for k in range(1, len(lean)):
            changed = [inertial_change(lean[k], moving[k].omega, change[k]) for change in changes]
            part = system.tree.part(k)
            pairs = zip(changed, self.variation.names, strict=True)
            by = [named_wrench(wrench, "momentum_rate", part, by=name) for wrench, name in pairs]
            own[k] = [acting.inertial_wrench(k, lean[k], moving), *by]
        outer = {}
        for k, load in acting.loads.items():
            f, m = (self.variation.differentiated(scale(-1, x)) for x in load)
            outer[k] = list(zip(f, m, strict=True))
        return own, outer

    # -- cut joints -----------------------------------------------------------------------------------------------

    def _held_in_hub(self, cut: Cut) -> bool:
        return cut.hub != GROUND and not cut.joint.kind.slides

    def _cut_wrenches(self) -> list[tuple[Cut, VariedWrench]]:
        """What every cut joint exerts on its tip, at its point, tip axes."""
        result, first = [], 0
        for cut in self.variation.system.cuts:
            force, couple = ZERO, ZERO
            for k, row in enumerate(cut.rows, start=first):
                if k in self.multipliers:
                    force = add(force, scale(self.multipliers[k], row.force))
                    couple = add(couple, scale(self.multipliers[k], row.couple))
            turns: list[Vector] = [ZERO] * len(self.variation.directions)
            if self._held_in_hub(cut):
                turns = relative_turns(self.variation, cut)
            forces, couples = ([x, *(cross(turn, x) for turn in turns)] for x in (force, couple))
            if cut.joint.kind.universal:
                couples = [couple, *self._universal(cut, first)[0]]
            first += len(cut.rows)
            result.append((cut, list(zip(forces, couples, strict=True))))
        return result

    def _universal(self, cut: Cut, first: int) -> tuple[list[Vector], list[Vector]]:
        """Changes of the couple of a universal joint, on the tip in its axes and from the hub in its axes.

        It stays across both axes, m e x h; with the hub turning by psi against the tip, in the tip's axes
        e x (psi x h) = (e . h) psi - (e . psi) h, in the hub's -(psi x e) x h = (e . h) psi - (h . psi) e.
        `first`: the cut joint's first row.
        """
        system = self.variation.system
        axes = universal_axes(cut, system.linkage)
        (e, h), sign = (axes, 1) if cut.tip_is_parent else (axes[::-1], -1)
        (amount,) = (self.multipliers.get(k, 0) for k, row in enumerate(cut.rows, start=first) if row.unit != "N")
        fixed = system.tape.settle(dot(cut.tip_axes[0], cut.tip_axes[1]))
        e_hub = system.linkage.carry(cut.tip, cut.hub, e)
        on_tip, on_hub = [], []
        for turn in relative_turns(self.variation, cut):
            at_tip, at_hub = (scale(-sign * amount * dot(turn, axis), other) for axis, other in ((e, h), (h, e_hub)))
            if fixed is not system.tape.zero:
                both = scale(sign * amount * fixed, turn)
                at_tip = add(at_tip, both)
                at_hub = add(at_hub, system.linkage.carry(cut.tip, cut.hub, both))
            on_tip.append(at_tip)
            on_hub.append(at_hub)
        return on_tip, on_hub

    def _on_hub(self, cut: Cut, wrench: Wrench, first: int) -> VariedWrench:
        """What a cut joint takes from its hub, hub axes: only the couple of a universal joint turns there."""
        system = self.variation.system
        force, couple = (system.linkage.carry(cut.tip, cut.hub, x) for x in wrench)
        couples: list[Vector] = [ZERO] * len(self.variation.directions)
        if cut.joint.kind.universal:
            couples = self._universal(cut, first)[1]
        return [(force, add(couple, cross(cut.contact, force))), *((ZERO, c) for c in couples)]

    def _on_sliding_hub(self, cut: Cut, wrench: Wrench) -> VariedWrench:
        """What a cut joint takes from its hub, in the axes before the hub's motion: as if its tip did not turn."""
        system = self.variation.system
        force, couple = (system.linkage.carry(cut.tip, cut.hub, x, before=True) for x in wrench)
        arm, *arms = self.variation.differentiated(system.placed[cut.hub].before(cut.contact))
        result = [(force, add(couple, cross(arm, force)))]
        for m, by in zip(self.variation.outer(cut.hub), arms, strict=True):
            turned = add(cross(m, couple), cross(arm, cross(m, force)))
            result.append((scale(-1, cross(m, force)), subtract(cross(by, force), turned)))
        return result

    def _turned_with_tip(self, total: list[list[Node]], in_v: Columns, cut: Cut, wrench: VariedWrench) -> None:
        """Power on a sliding hub of the change that a cut wrench takes with the axes of its tip."""
        system = self.variation.system
        (force, couple), changes = wrench[0], wrench[1:]
        turns = self.variation.turn(cut.tip)
        forces = [add(cross(n, force), f) for n, (f, _) in zip(turns, changes, strict=True)]
        couples = [add(cross(n, couple), m) for n, (_, m) in zip(turns, changes, strict=True)]
        for i, column in enumerate(in_v):
            hub = twists(system.linkage, column)[cut.hub]
            velocity = system.linkage.carry(cut.hub, cut.tip, hub.velocity_at(cut.contact))
            spin = link_rotations(system, column)[cut.hub]
            seen = system.linkage.carry(cut.hub, cut.tip, spin)
            for k, (f, m) in enumerate(zip(forces, couples, strict=True)):
                total[i][k] = total[i][k] + (dot(velocity, f) + dot(seen, m))


def inertial_change(inertia: Inertia, omega: Vector, change: Rates) -> Wrench:
    """Change of the rate of a link's momentum screw; see `symscrew.kinematics.recursion.inertial_wrench`."""
    by, alpha, matrix, spread = change.omega, change.alpha, change.matrix, inertia.second
    force = add(scale(inertia.mass, change.origin), transform(matrix, inertia.first))
    axial = []
    for x, y, z in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        value = (spread[y][y] + spread[z][z]) * alpha[x]
        value = value + (spread[y][y] - spread[z][z]) * (omega[y] * by[z] + omega[z] * by[y])
        value = value + (matrix[z][x] * spread[x][y] - matrix[y][x] * spread[x][z])
        axial.append(value + 2 * spread[y][z] * (omega[z] * by[z] - omega[y] * by[y]))
    return force, add((axial[0], axial[1], axial[2]), cross(inertia.first, change.origin))


def _both(a: VariedWrench | None, b: VariedWrench) -> VariedWrench:
    """The sum of two wrenches with their changes."""
    return list(b) if a is None else [(add(f, g), add(m, c)) for (f, m), (g, c) in zip(a, b, strict=True)]
