"""Which limbs have drives but no closed form among the formulas, and what computes their drives instead."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.description import Mechanism
from symscrew.paper_formulas.formula import Part
from symscrew.paper_formulas.moved_rods import rod_of
from symscrew.paper_formulas.named_lengths import Lengths
from symscrew.paper_formulas.spokes import is_spoke


def unprinted_part(mechanism: Mechanism, limbs: Sequence[Sequence[str]], lengths: Lengths) -> Part | None:
    """A sentence on the drives that neither spokes nor moved rods lead to; None where there are none.

    A drive that one chain leads to in closed form needs no other one: a delta's arm moves two rods.
    """
    printed = {
        name for joints in limbs if is_spoke(mechanism, joints, lengths) or rod_of(mechanism, joints, lengths)
        for name in joints
    }  # fmt: skip
    missing: dict[int, list[str]] = {}
    said: set[str] = set()
    for number, joints in enumerate(limbs, 1):
        drives = [n for n in joints if mechanism.joints[n].driven and n not in printed and n not in said]
        if drives:
            missing[number] = drives
            said.update(drives)
    if not missing:
        return None
    listed = "; ".join(f"limb {number}: {', '.join(drives)}" for number, drives in missing.items())
    words = (
        f"For these drives no closed form is printed ({listed}): their limbs are neither a slider between two points "
        "nor a rod that a crank or a slider on the base moves. symscrew.inverse_kinematics(mechanism, ...).drives "
        "computes them from the platform's pose, in any mechanism; the generated function inverse_kinematics does "
        "where the mechanism has it, as manifest.json says."
    )
    return Part("Inverse kinematics that is not printed", words, ())
