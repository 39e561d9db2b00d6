"""Forces and limits of joints of a URDF, as effects and limits.

<dynamics damping friction>, <joint_properties> -> viscous and dry friction    <limit> -> limits
<transmission> with reduction and rotor inertia -> rotor_inertia
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from symscrew.formats.draft import Draft, Limits, RawEffect
from symscrew.formats.rigid_displacements import real
from symscrew.formats.safe_xml import Element, elements, label, number

SLIP = 1e-3
"""Rate [rad/s or m/s] below which dry friction of a file creeps: a URDF gives its level alone."""
MOVING = ("revolute", "continuous", "prismatic")


def joint_forces(draft: Draft, name: str, joint: Element) -> None:
    """Enter what a joint says of damping, friction and limits."""
    single = joint.get("type") in MOVING
    for element in elements(joint, "dynamics", "joint_properties"):
        where = f"{label(joint)}, {element.tag}"
        for key in ("damping", "friction"):
            value = float(number(element.get(key, "0"), f"{where}, {key}"))
            if value == 0:
                continue
            if not single:
                draft.ledger.passed(f"{key} of a {joint.get('type')} joint")
                continue
            more: dict[str, Any] = {"coefficient": value} if key == "damping" else {"coulomb": value, "velocity": SLIP}
            draft.effects.append(RawEffect(name, {"kind": key, **more}))
            draft.ledger.turned(key)
    for limit in elements(joint, "limit"):
        _limit(draft, name, joint, limit)


def _limit(draft: Draft, name: str, joint: Element, limit: Element) -> None:
    if joint.get("type") not in MOVING:
        return
    found = draft.limits.setdefault(name, Limits())
    for key in ("lower", "upper", "velocity", "effort"):
        if key in limit.attrib and not (key in ("lower", "upper") and joint.get("type") == "continuous"):
            setattr(found, key, real(number(limit.attrib[key], f"{label(joint)}, limit {key}")))
    draft.ledger.turned("limits")


def transmission_forces(draft: Draft, root: Element, joints: Mapping[str, Element]) -> None:
    """Enter reductions and inertias of rotors of the transmissions, in the forms of ROS and of Drake."""
    for transmission in elements(root, "transmission"):
        names = [j.get("name", "") for j in elements(transmission, "joint")]
        names = [name for name in names if name in joints]
        ratio = _number(transmission, ("mechanicalReduction", "gear_ratio", "mechanical_reduction"))
        inertia = _number(transmission, ("rotor_inertia", "rotorInertia", "motorInertia", "motor_inertia"))
        if inertia and len(names) == 1 and joints[names[0]].get("type") in MOVING:
            table = {"kind": "armature", "inertia": inertia, "ratio": ratio if ratio is not None else 1.0}
            draft.effects.append(RawEffect(names[0], table))
            draft.ledger.turned("rotor inertia of a transmission")
        elif inertia:
            draft.ledger.lost("rotor inertia of a transmission without one joint of its own")
        elif ratio is not None and ratio != 1:
            draft.ledger.turned("reduction of a transmission: drives act on the joint's side")


def _number(transmission: Element, tags: tuple[str, ...]) -> float | None:
    """The number of the first element with one of these tags, whatever its namespace."""
    for element in _below(transmission):
        tag = element.tag.rpartition("}")[2].rpartition(":")[2]
        if tag in tags:
            text = element.get("value") or (element.text or "").strip()
            return float(number(text, f"{label(transmission)}, {tag}"))
    return None


def _below(element: Element) -> Iterator[Element]:
    return (child for child in element.iter() if isinstance(child.tag, str))
