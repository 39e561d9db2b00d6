"""How the power that a motion needs along given rates changes along directions of the state.

Every link carries what its joint must supply: the rate of its momentum screw and what stands outboard, less loads
and the wrenches of cut joints. These wrenches are held in the axes of their tips. What effects add is
differentiated on the tape.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from symscrew.closure import Cut, carry
from symscrew.closure_variations import slides, universal, universal_variation
from symscrew.differentiation import differentiate
from symscrew.effects.acting import Acting
from symscrew.recursion import Inertia, Rates, own_screws, twists
from symscrew.screws import ZERO, Twist, Vector, add, cross, dot, scale, subtract, transform
from symscrew.tape import Node
from symscrew.tree import GROUND, Link
from symscrew.tree_dynamics import projected
from symscrew.variations import Variation, Varied, link_rotations, seed, with_changes

Wrench = tuple[Vector, Vector]  # (force, moment)
VariedWrench = list[Wrench]
Columns = Sequence[Sequence[Node]]


def power_changes(
    variation: Variation, acting: Acting, multipliers: Mapping[int, Node], columns: Columns
) -> list[list[Node]]:
    """Changes of S . W, summed over all freedoms with the rates of each column: [column][direction].

    `columns` are consistent joint rates w; they, the multipliers of the cut joints (by row of the closure) and
    the drives in `acting` are held. Together they must be in equilibrium with the motion.
    """
    return _Powers(variation, acting, multipliers, columns).run()


@dataclass(frozen=True)
class _Powers:
    variation: Variation
    acting: Acting
    multipliers: Mapping[int, Node]
    columns: Columns

    def run(self) -> list[list[Node]]:
        system, tape = self.variation.system, self.variation.system.tape
        total = [[tape.zero] * len(self.variation.directions) for _ in self.columns]
        in_v = [system.tree_rates(column) for column in self.columns]
        own, outer = self._wrenches()
        for cut, wrench in self._cut_wrenches():
            if cut.tip != GROUND:
                less = [(scale(-1, f), scale(-1, add(m, cross(cut.tip_point, f)))) for f, m in wrench]
                own[cut.tip] = _both(own.get(cut.tip), less)
            if cut.hub != GROUND:
                outer[cut.hub] = _both(outer.get(cut.hub), self._on_hub(cut, wrench[0]))
                self._turned_with_tip(total, in_v, cut, wrench)
        for link in reversed(system.tree.links[1:]):
            here, frame = system.placed[link.index], system.frames[link.index]
            steps = [own_screws(link, frame, direction.step) for direction in self.variation.in_v]
            f0, m0 = own[link.index][0]
            turned = [(f0, m0)]
            for (f, m), step in zip(own[link.index][1:], steps, strict=True):
                turned.append((add(f, cross(step.angular, f0)), add(m, cross(step.angular, m0))))
            self._collect(total, in_v, link, turned)
            before = [(here.before(f), here.before(m)) for f, m in turned]
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

    def _collect(self, total: list[list[Node]], columns: Columns, link: Link, wrench: VariedWrench) -> None:
        tape, frame = self.variation.system.tape, self.variation.system.frames[link.index]
        for k, (f, m) in enumerate(wrench[1:]):
            values = projected(link, frame, f, m)
            for i, column in enumerate(columns):
                for rate, value in zip(column[link.v], values, strict=True):
                    total[i][k] = total[i][k] + rate * tape.node(value)

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
            by = (inertial_change(lean[k], moving[k].omega, change[k]) for change in changes)
            own[k] = [acting.inertial_wrench(k, lean[k], moving), *by]
        outer = {}
        for k, load in acting.loads.items():
            f, m = (self.variation.differentiated(scale(-1, x)) for x in load)
            outer[k] = list(zip(f, m, strict=True))
        return own, outer

    # -- cut joints -----------------------------------------------------------------------------------------------

    def _cut_wrenches(self) -> list[tuple[Cut, VariedWrench]]:
        """What every cut joint exerts on its tip, at its point; only the couple of a universal joint turns."""
        result, first = [], 0
        for cut in self.variation.system.cuts:
            force, couple = ZERO, ZERO
            for k, row in enumerate(cut.rows, start=first):
                if k in self.multipliers:
                    force = add(force, scale(self.multipliers[k], row.force))
                    couple = add(couple, scale(self.multipliers[k], row.couple))
            first += len(cut.rows)
            still: list[Vector] = [ZERO] * len(self.variation.directions)
            couples = self._universal(cut, couple) if universal(cut) else [couple, *still]
            result.append((cut, list(zip([force, *still], couples, strict=True))))
        return result

    def _universal(self, cut: Cut, couple: Vector) -> Varied:
        variation = self.variation
        seeds = with_changes(variation.seeds)
        for node in self.multipliers.values():
            seed(seeds, "", (node,), (0,))
        for axis in universal_variation(variation, cut):
            for name, by in zip(variation.names, axis[1:], strict=True):
                seed(seeds, name, axis[0], by)
        return variation.differentiated(couple, seeds)

    def _on_hub(self, cut: Cut, wrench: Wrench) -> VariedWrench:
        """What a cut joint takes from its hub, in the axes before the hub's motion: as if its tip did not turn."""
        system = self.variation.system
        force, couple = (carry(system.tree, system.placed, cut.tip, cut.hub, x, before=True) for x in wrench)
        arm = system.placed[cut.hub].before(cut.contact)
        moment = add(couple, cross(arm, force))
        result = [(force, moment)]
        if slides(cut):
            arms = self.variation.differentiated(arm)[1:]
            moved = [cross(by, force) for by in arms]
        else:
            lever = dot(arm, force)
            own = self.variation.own_turn(cut.hub)
            moved = [subtract(scale(dot(n, force), arm), scale(lever, n)) for n in own]  # (n x arm) x force
        for m, by in zip(self.variation.outer(cut.hub), moved, strict=True):
            turned = add(cross(m, couple), cross(arm, cross(m, force)))
            result.append((scale(-1, cross(m, force)), subtract(by, turned)))
        return result

    def _turned_with_tip(self, total: list[list[Node]], in_v: Columns, cut: Cut, wrench: VariedWrench) -> None:
        """Power on the hub of the change that a cut wrench takes with the axes of its tip."""
        system = self.variation.system
        (force, couple), changes = wrench[0], wrench[1:]
        turns = self.variation.turn(cut.tip)
        forces = [add(cross(n, force), f) for n, (f, _) in zip(turns, changes, strict=True)]
        couples = [add(cross(n, couple), m) for n, (_, m) in zip(turns, changes, strict=True)]
        for i, column in enumerate(in_v):
            velocity = self._velocity(cut, column)
            spin = link_rotations(system, column)[cut.hub]
            seen = carry(system.tree, system.placed, cut.hub, cut.tip, spin)
            for k, (f, m) in enumerate(zip(forces, couples, strict=True)):
                total[i][k] = total[i][k] + (dot(velocity, f) + dot(seen, m))

    def _velocity(self, cut: Cut, column: Sequence[Node]) -> Vector:
        """Velocity of the hub's point for consistent rates, tip axes: that of the tip's point, if they meet."""
        system = self.variation.system
        twist: Sequence[Twist] = twists(system.tree, system.frames, system.placed, column)
        if not slides(cut):
            return twist[cut.tip].velocity_at(cut.tip_point)
        return carry(system.tree, system.placed, cut.hub, cut.tip, twist[cut.hub].velocity_at(cut.contact))


def inertial_change(inertia: Inertia, omega: Vector, change: Rates) -> Wrench:
    """Change of the rate of a link's momentum screw; see `symscrew.recursion.inertial_wrench`."""
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
