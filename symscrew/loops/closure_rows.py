"""The rows of the closure as loops are solved with: a hub's motion is seen from where the limb's wrenches are sparsest.

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
    Column,
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
from symscrew.kinematics import GROUND, Cut, System, Wrench, closure_bias
from symscrew.loops.contact_rows import contact_rows, is_single, used_definitions
from symscrew.loops.rod_rows import RodRows, rod_rows


@dataclass(frozen=True)
class View:
    """A limb's rows as seen from one of its links.

    `moments` are those of its wrenches about the hub's centre in that link's axes, `limb` their powers per rate of
    the limb (index into v), `turn` leads to these axes from those before the hub's motion.
    """

    cut: Cut
    link: int
    moments: list[Vector]
    limb: list[dict[int, Node]]
    turn: Matrix

    @property
    def cost(self) -> int:
        """Products that an inertia takes on its way from the limb to the hub."""
        used = [i for i in range(3) if any(not is_zero(m[i]) for m in self.moments)]
        rows = [[c for c in m if not is_zero(c)] for m in self.moments]
        rows += [[c for c in self.turn[i] if not is_zero(c)] for i in used if not is_single(self.turn[i])]
        return sum(len(row) * (len(row) + 1) // 2 for row in rows)


@dataclass
class ClosureRows:
    """Rows {index into v, or a seen component: entry}: those of the closure in its order, then definitions.

    `defined`: index of a row -> the component that it defines. `views`: the view of every cut, None where the rows
    are plain; `rods`: the rods' rows in place of those of their cuts. `scales` make entries per rate without units.
    """

    rows: list[Affine]
    views: list[View | None]
    rods: dict[int, RodRows] = field(default_factory=dict)
    scales: list[float] = field(default_factory=list)
    defined: dict[int, Column] = field(default_factory=dict)


def closure_rows(system: System, *, by_contacts: bool, by_rods: bool = False) -> ClosureRows:
    """The rows of all cut joints in joint rates w and components of hubs' motions.

    `by_contacts`: limbs of freely moving hubs by the velocities of their contacts, where these rows have less entries.
    `by_rods`: rods by where their ends are; the rows are then others than those of the system, for the same rates.
    """
    result = ClosureRows([], [_view(system, cut) for cut in system.cuts])
    definitions: list[tuple[Column, Affine]] = []
    for c, (cut, view) in enumerate(zip(system.cuts, result.views, strict=True)):
        rod = rod_rows(system, cut) if by_rods else None
        if rod:
            result.rods[c] = rod
            result.rows += rod.rows
            result.scales += [1.0 / (system.length * size) for size in (rod.length, 1.0, 1.0)]
            continue
        result.scales += [1.0 / system.length if row.unit == "N" else 1.0 for row in cut.rows]
        if view is None:
            plain, contact = system.closure.cut_rows(cut), contact_rows(system, c, cut) if by_contacts else None
            if contact is None or _cost(plain) <= _cost([*contact.rows, *(row for _, row in contact.definitions)]):
                result.rows += plain
            else:
                result.rows += contact.rows
                definitions += contact.definitions
            continue
        hub = system.tree.links[cut.hub].v.start
        seen: list[Affine] = []
        for i, components in enumerate(view.turn):
            entries: Affine = {hub + j: system.tape.node(e) for j, e in enumerate(components) if not is_zero(e)}
            if len(entries) > 1:
                name = ("seen", c, i)
                definitions.append((name, {name: system.tape.one, **{k: -e for k, e in entries.items()}}))
                entries = {name: system.tape.one}
            seen.append(entries)
        for powers, moment in zip(view.limb, view.moments, strict=True):
            row: Affine = dict(powers)
            for value, entries in zip(moment, seen, strict=True):
                row |= {} if is_zero(value) else {k: -value * e for k, e in entries.items()}
            result.rows.append(row)
    for name, row in used_definitions(result.rows, definitions):
        result.defined[len(result.rows)] = name
        result.rows.append(row)
        result.scales.append(1.0)
    return result


def _cost(rows: Sequence[Affine]) -> int:
    """Products that an inertia takes on its way through rows, each with a pivot."""
    return sum(len(row) * (len(row) - 1) // 2 for row in rows)


def closure_rows_bias(closure: ClosureRows, moving: System) -> list[Node]:
    """(dJ/dt) v per row of the closure, for a system whose rates keep the loops closed.

    A row that is seen from a link of its limb is differentiated as it stands, J_l v_l - m . z with the components z
    of the hub's angular velocity in the link's axes: these turn, so that z' = T w' - omega x z.
    """
    result: list[Node] = []
    still = moving.rates([moving.tape.zero] * len(moving.tree.v))
    for c, (cut, view) in enumerate(zip(moving.cuts, closure.views, strict=True)):
        if c in closure.rods:
            result += closure.rods[c].bias(moving, still)
            continue
        plain = closure_bias(cut, moving.linkage, moving.twist, still)
        result += plain if view is None else _seen_bias(moving, view, plain)
    return result


def _seen_bias(moving: System, view: View, plain: Sequence[Node]) -> list[Node]:
    """Rows of a limb; the plain ones where entries depend on more than the limb's own coordinates."""
    tree, tape = moving.tree, moving.tape
    w = moving.joint_rates(moving.inputs.v)
    x, y, z = w[tree.links[view.cut.hub].v]
    spin = transform(view.turn, (x, y, z))
    turning = cross(moving.twist[view.link].angular, spin)
    speeds = {}
    for link in (tree.links[k] for k in tree.path(view.cut.tip)):
        if link.motion.kind in "RPH":
            speeds[moving.inputs.q[link.q.start]] = {"time": w[link.v.start]}
    given = all(q.op == "symbol" for q in speeds)  # else angles may stand in their cosines and sines only
    result = []
    for powers, moment, other in zip(view.limb, view.moments, plain, strict=True):
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


def _view(system: System, cut: Cut) -> View | None:
    """From the link of the limb where the rows are sparsest, if any is better than the ground."""
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
        views.append(View(cut, link, moments, limb, transpose((columns[0], columns[1], columns[2]))))
    best = min(views, key=lambda view: view.cost)
    return best if best.link != GROUND else None


def _about(centre: Vector, wrench: Wrench) -> Vector:
    force, moment = wrench
    return subtract(moment, cross(centre, force))
