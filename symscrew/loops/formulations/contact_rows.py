"""A limb's rows of the closure by the velocity of the point where it meets a hub that moves freely.

A row of the closure then asks for one component of this velocity in the axes of the limb's tip, where its own rates
have few entries. On the way there, from the axes before the hub's motion to the tip, every joint's turn mixes two
components: each of the new ones is an unknown with a row that defines it, so that an inertia at the tip arrives at the
hub through plane rotations and one lever arm.
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import IDENTITY, ZERO, Affine, Matrix, Node, Tape, cross, named_entries, transpose
from symscrew.kinematics import GROUND, Cut, System, on_hub
from symscrew.loops.formulations.cut_rows import CutRows, Definition, is_single, unit_scales, used_definitions
from symscrew.loops.formulations.plain_rows import plain_rows


def contact_rows(system: System, cut: Cut) -> CutRows | None:
    """The rows of a cut joint whose points do not slide; None where they are no sparser than the plain ones.

    None also if one side of the joint carries the other, or a third link carries both.
    """
    apart = GROUND not in (cut.hub, cut.tip) and system.tree.common(cut.tip, cut.hub) == GROUND
    if cut.joint.kind.slides or not apart:
        return None
    tape, placed = system.tape, system.placed
    definitions: list[Definition] = []

    def seen(entries: Affine) -> Affine:
        """A component with a name of its own where it has several entries."""
        entries = {k: e for k, e in entries.items() if e is not tape.zero}
        if len(entries) < 2:
            return entries
        name = ("contact", cut.joint.name, len(definitions))
        labels = [system.tree.v[k].label if isinstance(k, int) else str(k[2]) for k in entries]
        named_entries(entries.values(), "contact_rate", [f"{cut.joint.name}.{name[2]}|{label}" for label in labels])
        definitions.append((name, {name: tape.one, **{k: -e for k, e in entries.items()}}))
        return {name: tape.one}

    def turned(components: list[Affine], matrix: Matrix) -> list[Affine]:
        """Components in the axes that are the rows of `matrix` in the present ones."""
        if all(is_single(row) for row in matrix):
            return [_combined(tape, components, row) for row in matrix]
        return [seen(_combined(tape, components, row)) for row in matrix]

    arm = placed[cut.hub].before(cut.contact)
    components = [seen(system.powers(cut.hub, axis, cross(arm, axis), GROUND)) for axis in IDENTITY]
    components = turned(components, placed[cut.hub].rotation)
    for link in system.tree.path(system.tree.links[cut.hub].parent):
        components = turned(turned(components, placed[link].turn), placed[link].rotation)
    for link in reversed(system.tree.path(cut.tip)):
        components = turned(turned(components, transpose(placed[link].rotation)), transpose(placed[link].turn))
    rows = []
    for wrench in cut.rows:
        limb, _ = system.closure.limb_wrenches(cut, wrench)
        hub = _combined(tape, components, wrench.force)
        couple = system.powers(cut.hub, *on_hub(cut, system.linkage, ZERO, wrench.couple), GROUND)
        total: Affine = dict(limb)
        for part in (hub, couple):
            for k, entry in part.items():
                total[k] = total[k] - entry if k in total else -entry
        rows.append({k: e for k, e in total.items() if e is not tape.zero})
    found = CutRows(
        cut=cut,
        rows=tuple(rows),
        scales=unit_scales(system, cut),
        definitions=used_definitions(rows, definitions),
    )
    return found if found.products < plain_rows(system, cut).products else None


def _combined(tape: Tape, components: Sequence[Affine], factors: Sequence[Node | int]) -> Affine:
    total: Affine = {}
    for component, factor in zip(components, factors, strict=True):
        for k, entry in component.items():
            product = tape.node(factor) * entry
            if product is not tape.zero:
                total[k] = total[k] + product if k in total else product
    return total
