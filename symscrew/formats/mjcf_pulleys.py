"""Pulleys of an MJCF file that is written: fixed tendons again, as the file had them that was read.

    body without mass, joint, coupling s = sum c_i q_i, what acts on s  -->  <fixed>, its forces and actuators

As a body a pulley would need a mass, and MuJoCo holds a coupling by a soft constraint; a tendon has neither. What the
reader called so (`mjcf_transmissions`) is found by its names, and read back it is the same.
"""

from __future__ import annotations

from xml.etree.ElementTree import Element, SubElement

from symscrew.description import Coupling, Mechanism
from symscrew.formats.mjcf_transmissions import FORCES, pulley_body, pulley_coupling
from symscrew.formats.safe_xml import decimals

MOVED = (*FORCES, "actuatorfrcrange")
"""Attributes of the pulley's joint that a tendon has as well; `springref` is its springlength."""
ON_JOINT = {*MOVED, "springref", "name", "type", "axis", "ref", "pos"}


def as_tendons(root: Element, mechanism: Mechanism) -> set[str]:
    """Replace the pulleys in a file by tendons, in place; their bodies."""
    world, section = root.find("worldbody"), root.find("tendon")
    found: set[str] = set()
    for coupling in mechanism.couplings.values() if world is not None and section is not None else ():
        body = _pulley(root, mechanism, coupling)
        if body is None or not _acted_on(root, body):
            continue
        assert world is not None and section is not None
        _fold(root, coupling, body, section)
        world.remove(body)
        found.add(body.attrib["name"])
    return found


def _pulley(root: Element, mechanism: Mechanism, coupling: Coupling) -> Element | None:
    """The element of the pulley's body, if a coupling is one of a pulley with joints that are elements of the file."""
    if not coupling.linear:
        return None
    name = coupling.terms[0].joint
    joint = mechanism.joints[name]
    told = (joint.parent, joint.child, coupling.name) == (mechanism.ground, pulley_body(name), pulley_coupling(name))
    if not told or mechanism.number(coupling.terms[0].coefficients[0]) != 1:
        return None
    body = next((b for b in root.iterfind("worldbody/body") if b.get("name") == joint.child), None)
    others = [c for c in mechanism.couplings.values() if c is not coupling]
    used = any(term.joint == name for other in others for term in other.terms)
    bare = body is not None and {child.tag for child in body} <= {"inertial", "joint", "geom"}
    massless = mechanism.bodies[joint.child].mass is None
    return body if bare and massless and not used else None


def _acted_on(root: Element, body: Element) -> bool:
    """Whether something acts on a pulley that a tendon can have: without, nobody would read it as a pulley."""
    joint = next(body.iter("joint"))
    driven = any(element.get("joint") == joint.get("name") for element in root.iterfind("actuator/*"))
    return set(joint.attrib) <= ON_JOINT and (driven or any(key in joint.attrib for key in FORCES))


def _fold(root: Element, coupling: Coupling, body: Element, section: Element) -> None:
    joint, name = next(body.iter("joint")), coupling.terms[0].joint
    equality = next(e for e in root.iterfind("equality/tendon") if e.get("name") == coupling.name)
    tendon = next(t for t in section if t.get("name") == equality.get("tendon1"))
    made = SubElement(section, "fixed", {"name": name} | {k: v for k, v in joint.attrib.items() if k in MOVED})
    if "stiffness" in joint.attrib:
        made.set("springlength", decimals([float(joint.get("springref", "0"))] * 2))
    for term in tendon:
        if term.get("joint") != name:
            factor = decimals([-float(term.attrib["coef"])])
            SubElement(made, "joint", joint=term.attrib["joint"], coef=factor)
    section.remove(tendon)
    root.find("equality").remove(equality)  # type: ignore[union-attr]
    for element in root.iterfind("actuator/*"):
        if element.attrib.get("joint") == name:
            del element.attrib["joint"]
            element.set("tendon", name)
