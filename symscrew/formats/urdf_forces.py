"""Forces and limits of joints of a URDF, as effects and limits.

<dynamics damping friction>, <joint_properties> -> viscous and dry friction    <limit> -> limits
<transmission> with reduction and rotor inertia -> rotor_inertia
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from symscrew.errors import DescriptionError
from symscrew.formats.draft import Draft, Limits, RawEffect
from symscrew.formats.rigid_displacements import real
from symscrew.formats.safe_xml import Element, elements, first, label, number

SLIP = 1e-3
"""Rate [rad/s or m/s] below which dry friction of a file creeps: a URDF gives its level alone."""
WIDE = 1000000
"""What a file gives as limit [m, rad, per s, N, N m] that it must give and that the mechanism does not have."""
DYNAMICS = ("damping", "friction", "armature", "spring_stiffness", "spring_reference")
MOVING = ("revolute", "continuous", "prismatic")


def joint_forces(draft: Draft, name: str, joint: Element) -> None:
    """Enter what a joint says of damping, friction and limits."""
    single = joint.get("type") in MOVING
    for tag in ("dynamics", "joint_properties"):
        for element in first(joint, tag):
            _dynamics(draft, name, joint, element, single=single)
    for limit in first(joint, "limit"):
        _limit(draft, name, joint, limit)


def _dynamics(draft: Draft, name: str, joint: Element, element: Element, *, single: bool) -> None:
    """What an element says of damping, friction, and in some dialects of a rotor and a spring."""
    where = f"{label(joint)}, {element.tag}"
    values = {key: float(number(element.get(key, "0"), f"{where}, {key}")) for key in DYNAMICS}
    other = sorted(set(element.attrib) - set(DYNAMICS))
    if other:
        draft.ledger.passed(f"attributes of <{element.tag}> that a URDF does not have: {', '.join(other)}")
    tables: dict[str, dict[str, Any]] = {
        "damping": {"kind": "damping", "coefficient": values["damping"]},
        "friction": {"kind": "friction", "coulomb": values["friction"], "velocity": SLIP},
        "armature": {"kind": "armature", "inertia": values["armature"]},
        "spring_stiffness": {
            "kind": "spring", "stiffness": values["spring_stiffness"], "rest": values["spring_reference"],
        },
    }  # fmt: skip
    for key, table in tables.items():
        if values[key] == 0:
            continue
        if single:
            draft.effects.append(RawEffect(name, table))
            draft.ledger.turned(key)
        elif joint.get("type") == "fixed":
            draft.ledger.passed(f"{key} of a fixed joint")
        else:
            draft.ledger.lost(f"{key} of a {joint.get('type')} joint")


def _limit(draft: Draft, name: str, joint: Element, limit: Element) -> None:
    if joint.get("type") not in MOVING:
        return
    found = draft.limits.setdefault(name, Limits())
    for key in ("lower", "upper", "velocity", "effort"):
        if key in limit.attrib and not (key in ("lower", "upper") and joint.get("type") == "continuous"):
            value = real(number(limit.attrib[key], f"{label(joint)}, limit {key}"))
            setattr(found, key, None if abs(value) == WIDE else value)
    draft.ledger.turned("limits")


def transmission_forces(draft: Draft, root: Element, joints: Mapping[str, Element]) -> None:
    """Enter reductions and inertias of rotors of the transmissions, in the forms of ROS and of Drake."""
    for transmission in elements(root, "transmission"):
        names = [j.get("name", "") for j in elements(transmission, "joint")]
        names = [name for name in names if name in joints]
        ratio = _number(transmission, ("mechanicalReduction", "gear_ratio", "mechanical_reduction"))
        inertia = _number(transmission, ("rotor_inertia", "rotorInertia", "motorInertia", "motor_inertia"))
        if inertia and ratio == 0:
            raise DescriptionError(f"{label(transmission)}: expected a reduction that is not 0, or none")
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
