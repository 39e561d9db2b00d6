"""Forces and limits of joints of a URDF, as effects and limits.

<dynamics damping friction>, <joint_properties> -> viscous and dry friction    <limit> -> limits
<transmission> with reduction and rotor inertia -> rotor_inertia
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from symscrew.errors import DescriptionError
from symscrew.formats.draft import Draft, Ledger, Limits, RawEffect
from symscrew.formats.rigid_displacements import real
from symscrew.formats.safe_xml import Element, elements, first, label, number

SLIP = 1e-3
"""Rate [rad/s or m/s] below which dry friction of a file creeps: a URDF gives its level alone."""
WIDE = 1000000
"""What a file gives as limit [m, rad, per s, N, N m] that it must give and that the mechanism does not have."""
DYNAMICS = ("damping", "friction", "armature", "spring_stiffness", "spring_reference")
LIMITS = ("lower", "upper", "velocity", "effort")
REDUCTION = ("mechanicalReduction", "gear_ratio", "mechanical_reduction")
ROTOR = ("rotor_inertia", "rotorInertia", "motorInertia", "motor_inertia")
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
    _other_attributes(draft, element, DYNAMICS)
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


def _other_attributes(draft: Draft, element: Element, known: Sequence[str]) -> None:
    other = sorted({key.rpartition("}")[2] for key in set(element.attrib) - set(known)})
    if other:
        draft.ledger.passed(f"attributes of <{element.tag}> that a URDF does not have: {', '.join(other)}")


def _limit(draft: Draft, name: str, joint: Element, limit: Element) -> None:
    if joint.get("type") not in MOVING:
        return
    found = draft.limits.setdefault(name, Limits())
    _other_attributes(draft, limit, LIMITS)
    for key in LIMITS:
        if key in limit.attrib and not (key in ("lower", "upper") and joint.get("type") == "continuous"):
            value = real(number(limit.attrib[key], f"{label(joint)}, limit {key}"))
            setattr(found, key, None if abs(value) == WIDE else value)
    draft.ledger.turned("limits")


def transmission_forces(draft: Draft, root: Element, joints: Mapping[str, Element]) -> None:
    """Enter reductions and inertias of rotors of the transmissions, in the forms of ROS, ros2_control and Drake."""
    of_controls = [t for control in elements(root, "ros2_control") for t in elements(control, "transmission")]
    for transmission in (*elements(root, "transmission"), *of_controls):
        names = [j.get("name", "") for j in elements(transmission, "joint")]
        names = [name for name in names if name in joints]
        single = len(names) == 1 and joints[names[0]].get("type") in MOVING
        for ratio, inertia in _rotors(transmission, draft.ledger):
            if inertia and ratio == 0:
                raise DescriptionError(f"{label(transmission)}: expected a reduction that is not 0, or none")
            if inertia and single:
                table = {"kind": "armature", "inertia": inertia, "ratio": ratio if ratio is not None else 1.0}
                draft.effects.append(RawEffect(names[0], table))
                draft.ledger.turned("rotor inertia of a transmission")
            elif inertia:
                draft.ledger.lost("rotor inertia of a transmission without one joint of its own")
            elif ratio is not None and ratio != 1:
                draft.ledger.turned("reduction of a transmission: drives act on the joint's side")


def _rotors(transmission: Element, ledger: Ledger) -> list[tuple[float | None, float | None]]:
    """(reduction, rotor's inertia) of every actuator; what it does not say itself, the transmission or its joint says.

    A joint's own reduction counts where no actuator has one, as in ROS. Without a rotor's inertia nothing depends on
    one, and one that is no number is passed over.
    """
    if not any(_tag(element) in ROTOR for element in _below(transmission)):
        try:
            return _ratios(transmission)
        except DescriptionError:
            ledger.passed("reductions of transmissions that are no numbers")
            return []
    return _ratios(transmission)


def _ratios(transmission: Element) -> list[tuple[float | None, float | None]]:
    beside = [child for child in elements(transmission) if child.tag != "actuator"]
    outside = {tags: _number(beside, transmission, tags) for tags in (REDUCTION, ROTOR)}
    own = [
        [_number([a], transmission, tags) for tags in (REDUCTION, ROTOR)] for a in elements(transmission, "actuator")
    ]
    found = [(ratio if ratio is not None else outside[REDUCTION], inertia) for ratio, inertia in own]
    if outside[ROTOR] is None:
        return found or [(outside[REDUCTION], None)]
    of_all = next((ratio for ratio, _ in found if ratio is not None), outside[REDUCTION])
    return [(of_all, outside[ROTOR]), *(pair for pair in found if pair[1] is not None)]


def _number(parts: Sequence[Element], transmission: Element, tags: tuple[str, ...]) -> float | None:
    """The number of the first element with one of these tags in some parts, whatever its namespace."""
    for element in (element for part in parts for element in _below(part)):
        if _tag(element) in tags:
            text = element.get("value") or (element.text or "").strip().strip("\"'")  # as files have it: "1"
            return float(number(text, f"{label(transmission)}, {_tag(element)}"))
    return None


def _tag(element: Element) -> str:
    return str(element.tag).rpartition("}")[2].rpartition(":")[2]


def _below(element: Element) -> Iterator[Element]:
    return (child for child in element.iter() if isinstance(child.tag, str))
