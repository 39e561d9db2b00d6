"""A limb's rows with its hub's turning seen from where the limb's wrenches are sparsest.

A limb whose hub turns about a fixed point meets the hub's angular velocity in the moments of its reciprocal wrenches
about that point. In the axes of a link of the limb these moments may have fewer entries than in the hub's, so that
components of the angular velocity along such axes become unknowns of their own,

    seen_i = sum of T_ij w_j,

with rows that define them. They cost one projection, and every row of the limb, its inertia and its forces use them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from symscrew.algebra import (
    IDENTITY,
    Affine,
    Matrix,
    Node,
    Vector,
    cross,
    differentiate,
    dot,
    is_zero,
    subtract,
    transform,
    transpose,
)
from symscrew.kinematics import GROUND, Cut, Rates, System, Wrench
from symscrew.loops.formulations.cut_rows import CutRows, Definition, unit_scales, used_definitions


@dataclass(frozen=True, kw_only=True)
class SeenRows(CutRows):
    """A limb's rows as seen from its link `link`.

    `moments` are those of its wrenches about the hub's centre in that link's axes, `limb` their powers per rate of
    the limb (index into v), `turn` leads to these axes from those before the hub's motion.
    """

    link: int
    moments: Sequence[Vector] = field(repr=False)
    limb: Sequence[Affine] = field(repr=False)
    turn: Matrix = field(repr=False)

    def bias(self, moving: System, cut: Cut, still: Sequence[Rates]) -> Sequence[Node]:
        """Every row differentiated as it stands, J_l v_l - m . z with the components z of the hub's angular velocity.

        These turn with the link's axes: z' = T w' - omega x z. Rows whose entries depend on more than the limb's own
        coordinates have the bias of the system's rows.
        """
        plain = super().bias(moving, cut, still)
        tree, tape = moving.tree, moving.tape
        w = moving.joint_rates(moving.inputs.v)
        x, y, z = w[tree.links[cut.hub].v]
        spin = transform(self.turn, (x, y, z))
        turning = cross(moving.twist[self.link].angular, spin)
        speeds = {}
        for link in (tree.links[k] for k in tree.path(cut.tip)):
            if link.motion.single:
                speeds[moving.inputs.q[link.q.start]] = {"time": w[link.v.start]}
        given = all(q.op == "symbol" for q in speeds)  # else angles may stand in their cosines and sines only
        result = []
        for powers, moment, other in zip(self.limb, self.moments, plain, strict=True):
            entries = [*powers.values(), *(tape.node(m) for m in moment)]
            if not (given and _depends_only_on(entries, set(speeds) | set(moving.parameters))):
                result.append(other)
                continue
            rates = [row[0] for row in differentiate(tape, entries, speeds, ["time"], order="forward")]
            total = tape.node(dot(moment, turning))
            for k, rate in zip(powers, rates, strict=False):
                total = total + rate * w[k]
            for component, rate in zip(spin, rates[len(powers) :], strict=True):
                total = total - rate * component
            result.append(total)
        return result


def seen_rows(system: System, cut: Cut) -> SeenRows | None:
    """From the link of the limb where the rows are sparsest; None if that is the ground, where they are plain."""
    tree, placed = system.tree, system.placed
    if cut.arm is None or tree.links[cut.hub].parent != GROUND:
        return None
    pushed = [system.closure.limb_wrenches(cut, row) for row in cut.rows]
    limb = [{k: e for k, e in powers.items() if e is not system.tape.zero} for powers, _ in pushed]
    views = []
    for link in (GROUND, *reversed(tree.path(cut.tip))):
        centre = system.linkage.carry_point(GROUND, link, placed[cut.hub].offset)
        moments = [_about(centre, wrenches[link]) for _, wrenches in pushed]
        columns = [system.linkage.carry_before(cut.hub, link, axis) for axis in IDENTITY]
        turn = transpose((columns[0], columns[1], columns[2]))
        views.append(_from_link(system, cut, link, moments=moments, limb=limb, turn=turn))
    best = min(views, key=lambda view: view.products)
    return best if best.link != GROUND else None


def _from_link(
    system: System, cut: Cut, link: int, *, moments: Sequence[Vector], limb: Sequence[Affine], turn: Matrix
) -> SeenRows:
    tape, hub = system.tape, system.tree.links[cut.hub].v.start
    definitions: list[Definition] = []
    seen: list[Affine] = []
    for i, components in enumerate(turn):
        entries: Affine = {hub + j: tape.node(e) for j, e in enumerate(components) if not is_zero(e)}
        if len(entries) > 1:
            name = ("seen", cut.joint.name, i)
            definitions.append((name, {name: tape.one, **{k: -e for k, e in entries.items()}}))
            entries = {name: tape.one}
        seen.append(entries)
    rows = []
    for powers, moment in zip(limb, moments, strict=True):
        row: Affine = dict(powers)
        for value, entries in zip(moment, seen, strict=True):
            row |= {} if is_zero(value) else {k: -value * e for k, e in entries.items()}
        rows.append(row)
    return SeenRows(
        cut=cut,
        rows=tuple(rows),
        scales=unit_scales(system, cut),
        definitions=used_definitions(rows, definitions),
        link=link,
        moments=moments,
        limb=limb,
        turn=turn,
    )


def _depends_only_on(nodes: Sequence[Node], known: set[Node]) -> bool:
    """Whether no other inputs stand behind the nodes."""
    stack, seen = list(nodes), set()
    while stack:
        node = stack.pop()
        if node.index in seen or node in known or node.value is not None:
            continue
        if node.op == "symbol":
            return False
        seen.add(node.index)
        stack += node.args
    return True


def _about(centre: Vector, wrench: Wrench) -> Vector:
    force, moment = wrench
    return subtract(moment, cross(centre, force))
