"""Rotor inertia and damping that actuators of an MJCF file bring to what they act on.

    armature --> gear^2 armature about the joint, or along the tendon      damping --> gear^2 damping

The engine adds them with the first entry of the gear, to all freedoms of a ball or free joint, and also where the
actuator's group is off. Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#actuator-general; MuJoCo is
asked in the tests.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from symscrew.formats.draft import Draft, RawEffect
from symscrew.formats.mjcf_transmissions import BRANCHED, Transmissions, branched
from symscrew.formats.safe_xml import Element, label, numbers

FORCES = {"armature": ("armature", "inertia", None), "damping": ("damping", "coefficient", "damper")}
"""Attribute -> the effect, its number, and the flag of the options that takes it away."""


def rotors(
    draft: Draft,
    listed: Iterable[tuple[Element, Mapping[str, str]]],
    transmissions: Transmissions,
    off: Collection[str],
) -> None:
    """Enter rotor inertias and dampings of actuators.

    Args:
        draft: with its bodies and joints.
        listed: actuators with the attributes of their classes, those of groups that are off as well.
        transmissions: of the file.
        off: flags of the file by which forces do not act.
    """
    for element, given in listed:
        where = label(element)
        for key, (kind, number_of, flag) in FORCES.items():
            values = numbers(given.get(key, "0"), f"{where}, {key}")
            if flag in off or not any(values):
                continue
            target = transmissions.of(given, where)
            if target is None:
                draft.ledger.lost(f"{key} of actuators that act neither on a joint nor on a fixed tendon")
                continue
            if any(values[1:]):
                draft.ledger.lost(f"powers of {key} of actuators above the first")
            gear = numbers(given.get("gear", "1"), f"{where}, gear")
            factor = float(gear[0] if gear else 1) * float(target.factor)
            size = float(values[0]) * factor**2
            if size != 0:
                draft.effects.append(RawEffect(target.joint, {"kind": kind, number_of: size}, target.tendon))
                draft.ledger.turned(f"{key} of actuators, times the square of the gear")
                if key == "armature" and branched(draft, transmissions.coefficients(target)):
                    draft.ledger.turned(BRANCHED)
