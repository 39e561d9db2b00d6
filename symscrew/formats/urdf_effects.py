"""Forces and limits of a mechanism as elements of a URDF's joints and transmissions.

damping, friction --> <dynamics>    limits --> <limit>    armature --> rotor inertia and reduction of a transmission
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any
from xml.etree.ElementTree import Element, SubElement

from symscrew.description import Mechanism
from symscrew.formats.imported import Beside, JointLimits
from symscrew.formats.safe_xml import decimals
from symscrew.formats.urdf_forces import SLIP, WIDE


def held(mechanism: Mechanism, forces: Sequence[Mapping[str, Any]]) -> tuple[Mapping[str, Any], ...]:
    """The forces that a URDF holds: damping and friction, and rotors of driven joints; of none that is spherical."""
    return tuple(force for force in forces if _holds(mechanism, force))


def _holds(mechanism: Mechanism, force: Mapping[str, Any]) -> bool:
    if force["kind"] not in ("armature", "damping", "friction"):
        return False
    if force["kind"] == "friction" and force.get("velocity") != SLIP:  # which no file says
        return False
    joint = mechanism.joints[str(force["joint"])]
    driven = (force.get("freedom") or 0) in joint.driven
    return not joint.kind.spherical and (driven or force["kind"] != "armature")


def add_effects(root: Element, mechanism: Mechanism, beside: Beside) -> None:
    """Write what stands beside a mechanism into its URDF: forces that it holds, limits."""
    made = {element.attrib["name"]: element for element in root if element.tag == "joint"}
    for force in beside.forces:
        kind = mechanism.joints[str(force["joint"])].kind
        name = kind.motion_names(str(force["joint"]))[force.get("freedom") or 0]
        if force["kind"] == "armature":
            _armature(root, name, force)
            continue
        found = made[name].find("dynamics")
        element = SubElement(made[name], "dynamics") if found is None else found
        key, value = ("damping", "coefficient") if force["kind"] == "damping" else ("friction", "coulomb")
        element.set(key, decimals([float(element.get(key, "0")) + force[value]]))
    for label, limits in beside.limits.items():
        if label in made:  # a joint of one freedom, or one of a chain that stands for several
            _limit(made[label], limits)


def _armature(root: Element, name: str, force: Mapping[str, Any]) -> None:
    """In the transmission of the driven joint, which has one reduction: a further rotor turns as the first one."""
    ratio, inertia = float(force.get("ratio", 1.0)), float(force["inertia"])
    for transmission in root.findall("transmission") if ratio else ():
        joint, actuator = transmission.find("joint"), transmission.find("actuator")
        if joint is not None and actuator is not None and joint.get("name") == name:
            first, before = actuator.find("mechanicalReduction"), actuator.find("rotorInertia")
            if first is not None and before is None:
                first.text = repr(ratio)
            turns = float(first.text or 1) if first is not None else 1.0
            element = SubElement(actuator, "rotorInertia") if before is None else before
            element.text = repr(
                float(element.text or 0) + (inertia if turns == ratio else inertia * (ratio / turns) ** 2)
            )


def _limit(element: Element, limits: JointLimits) -> None:
    given = {"lower": limits.lower, "upper": limits.upper, "effort": limits.effort, "velocity": limits.velocity}
    for old in element.findall("limit"):
        element.remove(old)
    reach = limits.lower is not None or limits.upper is not None
    if element.get("type") == "continuous" and reach:
        element.set("type", "revolute")
    known = {key: value for key, value in given.items() if value is not None}
    if not known and element.get("type") not in ("revolute", "prismatic"):
        return
    wide = {"effort": WIDE, "velocity": WIDE}  # the format wants both, and of a slide a reach
    if element.get("type") == "prismatic" or (element.get("type") == "revolute" and reach):
        wide |= {"lower": -WIDE, "upper": WIDE}
    SubElement(element, "limit", {key: decimals([value]) for key, value in {**wide, **known}.items()})
