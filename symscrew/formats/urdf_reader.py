"""A mechanism from a URDF: links, joints of all standard types, transmissions.

Read: fixed, revolute, continuous, prismatic, planar and floating joints with origin and axis; inertial
elements; transmissions and the command interfaces of ros2_control, whose joints are driven (without any, all
revolute, continuous and prismatic joints are). The root link is the ground. Refused by name: mimic joints,
other joint types, links with two parents. Named in the mechanism's `source` and not taken over: limits,
damping, friction, safety controllers, elements of links that the format does not define.

    links and joints, relative poses --products from the root--> Draft: absolute axes and points

Source: the URDF specification, https://wiki.ros.org/urdf/XML (angles in rad, rpy about fixed axes).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import Draft, RawBody, RawJoint
from symscrew.formats.rigid_displacements import (
    UNITS,
    Pose,
    Rotation,
    Triple,
    about,
    product,
    triple,
    turned_inertia,
    unit,
)
from symscrew.formats.safe_xml import Element, attribute, check_attributes, elements, label, number, numbers

TYPES = {
    "fixed": "fixed", "revolute": "R", "continuous": "R", "prismatic": "P", "planar": "E", "floating": "free",
}  # fmt: skip
# elements of a <robot>, a <joint> and a <link> that are known; others are refused, or named in `source`
WITHOUT_MECHANICS = ("material", "gazebo", "ros2_control", "sensor")
IN_JOINT = ("origin", "parent", "child", "axis", "limit", "dynamics", "calibration", "safety_controller")
IN_LINK = ("inertial", "visual", "collision", "sensor", "contact", "collision_checking", "self_collision_checking")


def read_urdf(root: Element, file: str) -> Draft:
    """What a <robot> says; raises DescriptionError for what a mechanism cannot hold.

    Args:
        root: the file's root element.
        file: its name, for the mechanism's `source`.
    """
    for child in elements(root):
        if child.tag not in ("link", "joint", "transmission", *WITHOUT_MECHANICS):
            raise DescriptionError(f"{label(child)}: this element of a URDF is not supported; remove it")
    links = _named(elements(root, "link"), "link")
    joints = _named(elements(root, "joint"), "joint")
    if not links:
        raise DescriptionError("<robot>: expected links, found none")
    carrier = _carriers(links, joints)
    roots = [name for name in links if name not in carrier]
    if len(roots) != 1:
        found = "none: the joints go in a circle" if not roots else ", ".join(shorten(name) for name in roots[:5])
        raise DescriptionError(f"<robot>: expected one link that is no joint's child, found {found}")
    poses = _poses(roots[0], joints)
    lost = next((name for name in links if name not in poses), None)
    if lost is not None:
        raise DescriptionError(f"{label(links[lost])}: no chain of joints leads to it from {shorten(roots[0])}")
    driven, noted = _driven(root, joints)
    name = root.get("name") or "robot"
    result = Draft(name, roots[0], f"imported from the URDF {file}", f"robot {name}")
    result.bodies += [_body(link, poses[name]) for name, link in links.items() if name != roots[0]]
    result.joints += [_joint(joint, name, poses, driven) for name, joint in joints.items()]
    tips = [name for name in links if all(attribute(_one(j, "parent"), "link") != name for j in joints.values())]
    result.platform = tips[0] if len(tips) == 1 and joints else None
    result.notes += [*noted, *_left_out(links.values(), joints.values())]
    return result


def _named(found: Iterable[Element], what: str) -> dict[str, Element]:
    result: dict[str, Element] = {}
    for element in found:
        name = attribute(element, "name")
        if name in result:
            raise DescriptionError(f"{label(element)}: two {what}s have this name")
        result[name] = element
    return result


def _one(parent: Element, tag: str) -> Element:
    found = list(elements(parent, tag))
    if len(found) != 1:
        raise DescriptionError(f"{label(parent)}: expected one <{tag}>, found {len(found)}")
    return found[0]


def _carriers(links: Mapping[str, Element], joints: Mapping[str, Element]) -> dict[str, Element]:
    """Link -> the joint whose child it is."""
    carrier: dict[str, Element] = {}
    for joint in joints.values():
        for element in elements(joint):
            if element.tag == "mimic":
                raise DescriptionError(
                    f"{label(joint)}: mimic joints are not supported (a coordinate must move on its own); "
                    "remove the <mimic>, or make the joint fixed"
                )
            if element.tag not in IN_JOINT:
                raise DescriptionError(f"{label(joint)}: the element <{element.tag}> is not supported")
        for end in ("parent", "child"):
            name = attribute(_one(joint, end), "link")
            if name not in links:
                raise DescriptionError(f"{label(joint)}: no {end} link {shorten(name)}; {did_you_mean(name, links)}")
        child = attribute(_one(joint, "child"), "link")
        if child in carrier:
            raise DescriptionError(
                f"{label(links[child])}: it is the child of {label(carrier[child])} and of {label(joint)}; a URDF "
                "is a tree (use MJCF or a TOML description for loops)"
            )
        carrier[child] = joint
    return carrier


def _poses(ground: str, joints: Mapping[str, Element]) -> dict[str, Pose]:
    """Pose of every link that the ground leads to, all coordinates zero."""
    leaving: dict[str, list[Element]] = {}
    for joint in joints.values():
        leaving.setdefault(attribute(_one(joint, "parent"), "link"), []).append(joint)
    poses, front = {ground: Pose()}, [ground]
    while front:
        parent = front.pop()
        for joint in leaving.get(parent, []):
            child = attribute(_one(joint, "child"), "link")
            poses[child] = poses[parent] @ _origin(joint)
            front.append(child)
    return poses


def _origin(element: Element) -> Pose:
    found = list(elements(element, "origin"))
    if not found:
        return Pose()
    origin, where = found[0], f"{label(element)}, origin"
    check_attributes(origin, ("xyz", "rpy"), where)
    place = _triple(origin.get("xyz", "0 0 0"), f"{where}, xyz")
    roll, pitch, yaw = _triple(origin.get("rpy", "0 0 0"), f"{where}, rpy")
    x, y, z = UNITS
    return Pose(product(about(z, yaw), product(about(y, pitch), about(x, roll))), place)


def _triple(text: str, where: str) -> Triple:
    return triple(numbers(text, where, 3))


def _body(link: Element, pose: Pose) -> RawBody:
    name = attribute(link, "name")
    if not list(elements(link, "inertial")):
        return RawBody(name)
    inertial = _one(link, "inertial")
    where = f"{label(link)}, inertial"
    mass = triple([number(attribute(_one(inertial, "mass"), "value"), f"{where}, mass"), 0, 0])[0]
    moments = _one(inertial, "inertia")
    keys = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
    check_attributes(moments, keys, f"{where}, inertia")
    xx, xy, xz, yy, yz, zz = (number(moments.get(key, "0"), f"{where}, {key}") for key in keys)
    matrix: Rotation = (triple([xx, xy, xz]), triple([xy, yy, yz]), triple([xz, yz, zz]))
    if mass == 0 and not any(entry for row in matrix for entry in row):
        return RawBody(name)
    frame = pose @ _origin(inertial)
    return RawBody(name, mass, frame.translation, turned_inertia(frame.rotation, matrix))


def _joint(joint: Element, name: str, poses: Mapping[str, Pose], driven: Sequence[str]) -> RawJoint:
    kind = attribute(joint, "type")
    if kind not in TYPES:
        raise DescriptionError(
            f"{label(joint)}: joints of type {shorten(kind)} are not supported; {did_you_mean(kind, TYPES)}"
        )
    parent, child = (attribute(_one(joint, end), "link") for end in ("parent", "child"))
    pose = poses[child]
    axes: tuple[Triple, ...] = ()
    if TYPES[kind] in ("R", "P", "E"):
        found = list(elements(joint, "axis"))
        text = attribute(found[0], "xyz") if found else "1 0 0"
        axes = (pose.direction(unit(_triple(text, f"{label(joint)}, axis"), f"{label(joint)}, axis")),)
    return RawJoint(name, TYPES[kind], parent, child, pose.translation, axes, driven=(0,) if name in driven else ())


def _driven(root: Element, joints: Mapping[str, Element]) -> tuple[list[str], list[str]]:
    """Names of the driven joints, and a note about how they were found."""
    single = [name for name, j in joints.items() if j.get("type") in ("revolute", "continuous", "prismatic")]
    transmissions = list(elements(root, "transmission"))
    controls = list(elements(root, "ros2_control"))
    if not transmissions and not controls:
        return single, [
            "without transmissions and ros2_control: every revolute, continuous and prismatic joint is driven"
        ]
    named = [attribute(joint, "name") for t in transmissions for joint in elements(t, "joint")]
    commanded = [
        j for c in controls for j in elements(c, "joint") if any(True for _ in elements(j, "command_interface"))
    ]
    named += [attribute(joint, "name") for joint in commanded]
    for name in named:
        if name not in joints:
            raise DescriptionError(
                f"<transmission> or <ros2_control>: no joint {shorten(name)}; {did_you_mean(name, joints)}"
            )
    idle = [name for name in named if name not in single]
    notes = ["not taken over: drives of joints that have not one freedom: " + ", ".join(idle)] if idle else []
    return [name for name in named if name in single], notes


def _left_out(links: Iterable[Element], joints: Iterable[Element]) -> list[str]:
    """What of links and joints a mechanism does not hold: said, not used."""
    counts = {"limits": 0, "damping": 0, "friction": 0, "safety controllers": 0}
    for joint in joints:
        counts["limits"] += any(True for _ in elements(joint, "limit"))
        counts["safety controllers"] += any(True for _ in elements(joint, "safety_controller"))
        for dynamics in elements(joint, "dynamics"):
            for key in ("damping", "friction"):
                counts[key] += number(dynamics.get(key, "0"), f"{label(joint)}, {key}") != 0
    found = [f"{what} of {n} joint{'s' * (n > 1)}" for what, n in counts.items() if n]
    others = {element.tag for link in links for element in elements(link) if element.tag not in IN_LINK}
    found += [f"<{tag}> of links" for tag in sorted(others)]
    return ["not taken over: " + ", ".join(found)] if found else []
