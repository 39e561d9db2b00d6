"""A limb's rows of the closure by the velocity of the point where it meets a hub that moves freely.

A row of the closure then asks for one component of this velocity in the axes of the limb's tip, where its own rates
have few entries. On the way there, from the axes before the hub's motion to the tip, every joint's turn mixes two
components: each of the new ones is an unknown with a row that defines it, so that an inertia at the tip arrives at the
hub through plane rotations and one lever arm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from symscrew.algebra import IDENTITY, ZERO, Affine, Column, Matrix, Node, cross, is_zero, transpose
from symscrew.description import JOINT_TYPES
from symscrew.kinematics import GROUND, Cut, System, on_hub


@dataclass
class ContactRows:
    """Rows of one cut, and the components (name, row) that they use."""

    rows: list[Affine]
    definitions: list[tuple[Column, Affine]]


def contact_rows(system: System, index: int, cut: Cut) -> ContactRows | None:
    """The rows of a cut joint whose points do not slide; None if a side carries the other, or a third carries both."""
    slides = any(m.kind in "PH" for m in JOINT_TYPES[cut.joint.type].motions)
    if cut.hub == GROUND or cut.tip == GROUND or slides or system.tree.common(cut.tip, cut.hub) != GROUND:
        return None
    tape, placed = system.tape, system.placed
    definitions: list[tuple[Column, Affine]] = []

    def seen(entries: Affine) -> Affine:
        """A component with a name of its own where it has several entries."""
        entries = {k: e for k, e in entries.items() if e is not tape.zero}
        if len(entries) < 2:
            return entries
        name = ("contact", index, len(definitions))
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
    return ContactRows(rows, used_definitions(rows, definitions))


def used_definitions(
    rows: Sequence[Affine], definitions: Sequence[tuple[Column, Affine]]
) -> list[tuple[Column, Affine]]:
    """Those components that rows use, directly or through later components."""
    used = {k for row in rows for k in row}
    kept = []
    for name, row in reversed(definitions):
        if name in used:
            kept.append((name, row))
            used |= set(row)
    return kept[::-1]


def _combined(tape: Any, components: list[Affine], factors: Any) -> Affine:
    total: Affine = {}
    for component, factor in zip(components, factors, strict=True):
        for k, entry in component.items():
            product = tape.node(factor) * entry
            if product is not tape.zero:
                total[k] = total[k] + product if k in total else product
    return total


def is_single(row: Sequence[Node | int]) -> bool:
    """Whether a row has one entry."""
    return sum(not is_zero(entry) for entry in row) == 1
