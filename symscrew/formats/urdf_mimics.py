"""Joints of a URDF that follow another one, wherever the file says so.

    <mimic>, <drake:mimic> of a joint, <param name="mimic"> of ros2_control, a plugin of Gazebo with <mimicJoint>
        --> follower = multiplier * leader + offset

What the joint itself says counts before what others say of it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from symscrew.errors import DescriptionError, shorten
from symscrew.formats.draft import Ledger
from symscrew.formats.rigid_displacements import ZERO, Real, real
from symscrew.formats.safe_xml import Element, check_attributes, elements, first, label, number
from symscrew.formats.urdf_loops import DRAKE

SINGLE = ("revolute", "continuous", "prismatic")
MIMIC = ("mimic", f"{DRAKE}mimic")
"""Elements of a joint that say whom it follows."""
USUAL = {"multiplier": "1", "offset": "0"}

Mimic = tuple[str, Real, Real]
"""The joint that is followed, multiplier, offset."""


def mimics_of(root: Element, joints: Mapping[str, Element], ledger: Ledger) -> dict[str, Mimic]:
    """Joint -> whom it follows and how.

    Raises:
        DescriptionError: a joint follows itself, or one of the two has not one coordinate.
    """
    found: dict[str, Mimic] = {}
    for name, given, where in (*_of_joints(joints), *_of_others(root, joints, ledger)):
        if name in found:
            continue
        other = given.get("joint", "")
        if other == name:
            raise DescriptionError(f"{where}: expected another joint than itself")
        if other not in joints:
            ledger.lost(f"<mimic> of {shorten(name)}, which names no joint of the file: {shorten(other)}")
            continue
        for one in (name, other):
            if joints[one].get("type") not in SINGLE:
                raise DescriptionError(f"{where}: {shorten(one)} has not one coordinate: {', '.join(SINGLE)} have")
        multiplier, offset = (real(number(given.get(key, text), f"{where}, {key}")) for key, text in USUAL.items())
        found[name] = (other, multiplier, offset)
    return found


def _of_joints(joints: Mapping[str, Element]) -> Iterator[tuple[str, Mapping[str, str], str]]:
    """(joint, what it says of whom it follows, where it says that)."""
    for name, joint in joints.items():
        for tag in MIMIC if joint.get("type") != "fixed" else ():
            for mimic in first(joint, tag):
                where = f"{label(joint)}, mimic"
                check_attributes(mimic, ("joint", *USUAL), where)
                yield name, mimic.attrib, where


def _of_others(
    root: Element, joints: Mapping[str, Element], ledger: Ledger
) -> Iterator[tuple[str, Mapping[str, str], str]]:
    """The same of ros2_control's parameters and of Gazebo's plugins."""
    for control in elements(root, "ros2_control"):
        for joint in elements(control, "joint"):
            given = {p.get("name", ""): (p.text or "").strip() for p in elements(joint, "param")}
            name = joint.get("name", "")
            if "mimic" in given and name in joints and joints[name].get("type") != "fixed":
                ledger.turned("mimic joints of ros2_control: couplings")
                yield name, {"joint": given["mimic"], **_numbers(given)}, f"<ros2_control>, {label(joint)}"
    for section in elements(root, "gazebo"):
        for plugin in elements(section, "plugin"):
            said = {child.tag: (child.text or "").strip() for child in elements(plugin)}
            name = said.get("mimicJoint", "")
            if name in joints and joints[name].get("type") != "fixed":
                ledger.turned("mimic joints of plugins: couplings")
                yield name, {"joint": said.get("joint", ""), **_numbers(said)}, f"<gazebo>, {label(plugin)}"


def _numbers(given: Mapping[str, str]) -> dict[str, str]:
    return {key: given[key] for key in USUAL if given.get(key)}


def offsets_of(mimics: Mapping[str, Mimic]) -> dict[str, Real]:
    """Mimic joint -> its coordinate where all joints that mimic none are at 0."""
    found: dict[str, Real] = {}

    def of(name: str, way: tuple[str, ...]) -> Real:
        if name not in mimics:
            return ZERO[0]
        if name in way:
            raise DescriptionError(f"<joint name={shorten(name)}>: mimic joints follow each other in a circle")
        other, multiplier, offset = mimics[name]
        if name not in found:
            found[name] = multiplier * of(other, (*way, name)) + offset
        return found[name]

    for name in mimics:
        of(name, ())
    return found
