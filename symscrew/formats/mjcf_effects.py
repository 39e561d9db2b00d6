"""Forces, limits and gravity of a mechanism as attributes of an MJCF's joints, and as its actuators.

armature, damping, friction, spring --> <joint armature damping frictionloss stiffness springref>
cord, tendon, muscle --> <spatial>, and <motor> or <muscle> on it
servo --> <position> in place of the motor          carried weight --> <body gravcomp>
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import count
from typing import Any
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.formats.imported import Beside, JointLimits
from symscrew.formats.mjcf_cords import add_cord, add_tendon
from symscrew.formats.mjcf_forces import SLIP
from symscrew.formats.safe_xml import decimals

CORDS = ("cord", "tendon", "muscle")
"""Kinds of forces that are tendons in space there."""
CARRIED = 1e-12
"""Of a weight: what rounding leaves of a force that carries a share of it."""


def held(mechanism: Mechanism, forces: Sequence[Mapping[str, Any]]) -> tuple[Mapping[str, Any], ...]:
    """The forces that MJCF holds beside each other: a ball has one friction for all its freedoms."""
    possible = [force for force in forces if _holds(mechanism, force)]
    frictions: dict[str, dict[int, float]] = {}
    for force in possible:
        if force["kind"] == "friction" and mechanism.joints[str(force["joint"])].kind.ball:
            per_freedom = frictions.setdefault(str(force["joint"]), dict.fromkeys(range(3), 0.0))
            per_freedom[force.get("freedom") or 0] += force["coulomb"]
    uneven = {joint for joint, found in frictions.items() if len(set(found.values())) > 1}
    return tuple(force for force in possible if force["kind"] != "friction" or force["joint"] not in uneven)


def _holds(mechanism: Mechanism, force: Mapping[str, Any]) -> bool:
    """Whether MJCF holds a force: a servo on a driven freedom, a wrench that carries a share of a body's weight."""
    if force["kind"] == "drag":
        return False
    if force["kind"] in CORDS:
        return True
    if force["kind"] == "servo":
        return (force.get("freedom") or 0) in mechanism.joints[str(force["joint"])].driven
    if force["kind"] == "load":
        point = mechanism.points[str(force["point"])]
        body = mechanism.bodies[point.body]
        return body.com == point.at and bool(body.mass) and not any(force["wrench"][3:])
    if force["kind"] == "friction" and force.get("velocity") != float(SLIP):  # which no file says
        return False
    if mechanism.joints[str(force["joint"])].kind.unconstrained:  # one number for all its freedoms
        alike = force["kind"] in ("armature", "damping") or bool(force.get("nearest"))
        return alike and force.get("freedom") is None
    return True


def joints_acted_on(beside: Beside) -> set[str]:
    """Joints that a force or limit names: they stay in the tree, where they have an element."""
    return {str(force["joint"]) for force in beside.forces if "joint" in force} | {
        name.partition(".")[0] for name in beside.limits
    }


def add_effects(root: Element, mechanism: Mechanism, beside: Beside, bodies: Mapping[str, str]) -> None:
    """Write what stands beside a mechanism into its MJCF; `bodies`: body -> its name in the file.

    Raises:
        DescriptionError: a force that MJCF does not hold.
    """
    made = {element.attrib["name"]: element for element in root.iter("joint") if "type" in element.attrib}
    made |= {element.attrib["name"]: element for element in root.iter("freejoint")}
    field = beside.gravity or (0.0, 0.0, -9.81)
    for option in root.iter("option"):
        option.set("gravity", decimals(field))
    for force in beside.forces:
        if force["kind"] in CORDS:
            (add_cord if force["kind"] == "cord" else add_tendon)(root, force)
            continue
        if force["kind"] == "load":
            _carry(root, mechanism, force, field=field, bodies=bodies)
            continue
        name = _element_name(mechanism, str(force["joint"]), force.get("freedom"))
        if made[name].tag == "freejoint":
            made[name].tag, made[name].attrib["type"] = "joint", "free"
        if force["kind"] == "servo":
            _servo(root, name, force)
        else:
            _attributes(made[name], force)
    coupled = {term.joint for coupling in mechanism.couplings.values() for term in coupling.terms}
    for label, limits in beside.limits.items():
        joint, _, freedom = label.partition(".")
        name = _element_name(mechanism, joint, int(freedom) if freedom else None)
        if name in made:
            drives = [m for m in root.iterfind("actuator/*") if m.get("joint") == name]
            _limit(made[name], limits, drives[0] if joint in coupled and len(drives) == 1 else None)


def _element_name(mechanism: Mechanism, joint: str, freedom: int | None) -> str:
    """The name of the file's joint with a freedom: of a screw that of its hinge."""
    kind = mechanism.joints[joint].kind
    if kind.unconstrained:
        return joint
    sizes = [motion.freedom for motion in kind.motions]
    index = next(k for k in range(len(sizes)) if (freedom or 0) < sum(sizes[: k + 1]))
    name = kind.motion_names(joint)[index]
    return f"{name}.1" if kind.motions[index].helical else name


def _attributes(element: Element, force: Mapping[str, Any]) -> None:
    def add(key: str, value: float) -> None:
        element.set(key, decimals([float(element.get(key, "0")) + value]))

    if force["kind"] == "armature":
        add("armature", force["inertia"] * force.get("ratio", 1.0) ** 2)
    elif force["kind"] == "damping":
        add("damping", force["coefficient"])
    elif force["kind"] == "friction":
        if force.get("freedom", 0) in (0, None) or element.get("type") != "ball":
            add("frictionloss", force["coulomb"])
    else:
        stiffness, there = force.get("stiffness", 0.0), float(element.get("stiffness", "0"))
        if stiffness:
            if element.get("type") != "ball":  # of two springs the sum is one, which rests where they balance
                rests = (float(element.get("springref", "0")), force.get("rest", 0.0))
                rest = (there * rests[0] + stiffness * rests[1]) / (there + stiffness) if there else rests[1]
                element.set("springref", decimals([rest]))
            add("stiffness", stiffness)
        if force.get("damping"):
            add("damping", force["damping"])


def _servo(root: Element, name: str, force: Mapping[str, Any]) -> None:
    """A position actuator, in place of the motor: read back, it drives the joint and has the servo beside it."""
    section = root.find("actuator")
    there = None if section is None else next((m for m in section if m.get("joint") == name), None)
    if section is None or there is None:
        raise DescriptionError(
            f"joints.{force['joint']}: a servo of a file drives its joint; expected a driven freedom"
        )
    taken = {element.get("name") for element in section}
    called = name
    if there.tag == "motor":
        section.remove(there)
    else:  # a further servo of the joint
        called = next(found for k in count(2) if (found := f"{name}.servo{k}") not in taken)
    made = SubElement(section, "position", name=called, joint=name, kp=decimals([force["stiffness"]]))
    if force.get("damping"):
        made.set("kv", decimals([force["damping"]]))
    if "limit" in force:
        made.set("forcerange", decimals([force.get("lowest", -force["limit"]), force["limit"]]))


def _limit(element: Element, limits: JointLimits, drive: Element | None) -> None:
    """The reach of a joint, and its effort: of a joint on which tendons may pull as well as that of its only drive."""
    if limits.lower is not None and limits.upper is not None and limits.lower < limits.upper:
        element.set("range", decimals([limits.lower, limits.upper]))
    if limits.effort is not None and limits.effort > 0:
        reach = decimals([-limits.effort, limits.effort])
        own = [] if drive is None else [abs(float(end)) for end in drive.get("forcerange", "").split()]
        if drive is not None and not own:
            drive.set("forcerange", reach)
        elif drive is None or max(own) > limits.effort:
            element.set("actuatorfrcrange", reach)


def _carry(
    root: Element,
    mechanism: Mechanism,
    force: Mapping[str, Any],
    *,
    field: tuple[float, ...],
    bodies: Mapping[str, str],
) -> None:
    """The share of a body's weight that a constant force at its centre of mass carries."""
    point = mechanism.points[str(force["point"])]
    body = mechanism.bodies[point.body]
    push, moment = np.array(force["wrench"][:3], dtype=float), np.array(force["wrench"][3:], dtype=float)
    weight = np.array(field) * (0.0 if body.mass is None else float(mechanism.number(body.mass)))
    square = float(weight @ weight)
    share = -float(push @ weight) / square if square else 0.0
    if body.com != point.at or moment.any() or np.abs(push + share * weight).max() > CARRIED * np.abs(weight).max():
        raise DescriptionError(
            f"points.{point.name}: MJCF holds forces that carry a share of a body's weight, at its centre of mass, "
            f"got {force['wrench']}"
        )
    element = next(e for e in root.iter("body") if e.get("name") == bodies[point.body])
    element.set("gravcomp", decimals([float(element.get("gravcomp", "0")) + share]))
    for site in [site for site in element.findall("site") if site.get("name") == point.name]:
        element.remove(site)  # the body's centre of mass: whoever reads the share names it again
