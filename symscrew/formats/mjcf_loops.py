"""Loops and drives of an MJCF file: <equality> and <actuator>.

    connect --> S;  two connects of the same bodies --> R;  weld --> fixed, or S where its torquescale is zero

A connect is a spherical joint between two bodies, two connects between the same bodies a revolute joint about
the line through their points, a weld a fixed joint. All must hold in the reference configuration, as MuJoCo makes them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import RawJoint
from symscrew.formats.file_names import fresh
from symscrew.formats.mjcf_settings import Settings
from symscrew.formats.open_loops import CLOSED, Closing
from symscrew.formats.rigid_displacements import (
    ZERO,
    Pose,
    from_quaternion,
    length,
    minus,
    real,
    triple,
    unit,
)
from symscrew.formats.safe_xml import Element, attribute, elements, label, number, numbers

HELD = "fixed"
"""The joint of a weld that holds its bodies in turning as well."""


@dataclass(frozen=True)
class Placed:
    """Poses of the bodies, sites as (body, pose), the name of the ground, and how open loops may be.

    `own`: poses in the file's own configuration, in which equalities of bodies hold.
    """

    poses: Mapping[str, Pose]
    sites: Mapping[str, tuple[str, Pose]]
    ground: str
    closing: Closing
    own: Mapping[str, Pose]

    def moved(self, body: str) -> Pose:
        """From a body's own place to the one where couplings have it."""
        return self.poses[body] @ self.own[body].inverse()


def loops(root: Element, settings: Settings, placed: Placed) -> list[RawJoint]:
    """The joints that close loops; raises DescriptionError for what is not supported or does not close."""
    for section in elements(root, "equality"):
        for element in elements(section):
            if element.tag not in ("connect", "weld", "joint", "tendon"):
                raise DescriptionError(
                    f"{label(element)} in <equality>: only connect, weld, joint and tendon are supported"
                )
    connects = [_connect(e, placed) for e in equalities(root, settings, "connect")]
    welds = [_weld(e, placed) for e in equalities(root, settings, "weld")]
    connects += [weld for weld in welds if weld.type != HELD]
    welds = [weld for weld in welds if weld.type == HELD]
    result = []
    while connects:
        first = connects.pop(0)
        pair = next((c for c in connects if _twin(first, c)), None)
        if pair is None:
            result.append(first)
            continue
        connects.remove(pair)
        axis = unit(minus(pair.point, first.point), f"<connect name={first.name!r}>")
        stem = first.name.removesuffix(".0")
        name = stem if pair.name == f"{stem}.1" else first.name
        result.append(RawJoint(name, "R", first.parent, first.child, first.point, (axis,)))
    result += welds
    names: list[str] = []
    for k, joint in enumerate(result):
        names.append(fresh(joint.name or f"loop_{k}", names))
    return [RawJoint(name, j.type, j.parent, j.child, j.point, j.axes) for name, j in zip(names, result, strict=True)]


def _twin(a: RawJoint, b: RawJoint) -> bool:
    """Whether two connects join the same bodies at different points."""
    return {a.parent, a.child} == {b.parent, b.child} and length(minus(a.point, b.point)) > CLOSED


def idle_equalities(root: Element, settings: Settings) -> int:
    """How many are not active, of the kinds that are read."""
    return sum(
        1 for tag in ("connect", "weld", "joint", "tendon") for _ in equalities(root, settings, tag, active="false")
    )


def equalities(root: Element, settings: Settings, tag: str, active: str = "true") -> Iterator[Element]:
    """The active equalities of a kind, or the others."""
    kind = {"joint": "couple", "tendon": "tie"}.get(tag, tag)
    for section in elements(root, "equality"):
        for element in elements(section, tag):
            chosen = settings.merged(element, kind, None)
            name = element.get("class") or "main"
            default = settings.defaults[name].get("equality", {})
            given = {**default, **chosen}.get("active", "true")
            if given not in ("true", "false"):
                raise DescriptionError(f"{label(element)}, active: expected true or false, got {shorten(given)}")
            if given == active:
                yield element


def _ends(element: Element, placed: Placed) -> tuple[str, str, tuple[Pose, Pose] | None]:
    """Parent, child, and the poses of the two sites that meet, if it is given by sites."""
    poses, sites, ground = placed.poses, placed.sites, placed.ground
    if "site1" in element.attrib:
        names = [attribute(element, key) for key in ("site1", "site2")]
        for name in names:
            if name not in sites:
                raise DescriptionError(
                    f"{label(element)}: there is no site {shorten(name)}; {did_you_mean(name, sites)}"
                )
        (first, one), (second, other) = (sites[name] for name in names)
        return first, second, (one, other)
    one_body = attribute(element, "body1")
    other_body = element.get("body2")
    for end in (one_body, other_body):
        if end not in poses and end not in (None, "world"):
            raise DescriptionError(
                f"{label(element)}: there is no body {shorten(end)}; {did_you_mean(str(end), poses)}"
            )
    if other_body is None:
        return ground, one_body, None
    return (ground if one_body == "world" else one_body), (ground if other_body == "world" else other_body), None


def _connect(element: Element, placed: Placed) -> RawJoint:
    parent, child, meeting = _ends(element, placed)
    if meeting is None:
        anchor = triple(numbers(attribute(element, "anchor"), f"{label(element)}, anchor", 3))
        owner = element.attrib["body1"]
        at = placed.own[placed.ground if owner == "world" else owner].point(anchor)
        place = placed.closing.middle(label(element), placed.moved(parent).point(at), placed.moved(child).point(at))
    else:
        one, other = (pose.translation for pose in meeting)
        place = placed.closing.middle(label(element), one, other)
    return RawJoint(element.get("name") or "", "S", parent, child, place)


def _weld(element: Element, placed: Placed) -> RawJoint:
    """A weld; without a torque it holds the points alone, as a connect does."""
    parent, child, meeting = _ends(element, placed)
    given = numbers(element.get("relpose", "0 1 0 0 0 0 0"), f"{label(element)}, relpose", 7)
    if number(element.get("torquescale", "1"), f"{label(element)}, torquescale") == 0:
        return _held_point(element, placed, (parent, child, meeting), given)
    if meeting is not None:
        _check_weld(element, placed, *meeting)
    elif any(value != 0 for value in given[3:]):
        # relpose is the pose of the second body (the world where there is none) in the first, its place the anchor's
        first = element.attrib["body1"]
        one, other = (placed.poses[placed.ground if n in (None, "world") else n] for n in (first, element.get("body2")))
        turn = [real(value) for value in given[3:]]
        turned = Pose(from_quaternion(turn, f"{label(element)}, relpose"), ZERO)
        anchor = triple(numbers(element.get("anchor", "0 0 0"), f"{label(element)}, anchor", 3))
        wanted = Pose(turned.rotation, minus(triple(given[:3]), turned.point(anchor)))
        _check_weld(element, placed, wanted, one.inverse() @ other)
    else:
        own, now = (poses[parent].inverse() @ poses[child] for poses in (placed.own, placed.poses))
        _check_weld(element, placed, own, now)
    return RawJoint(element.get("name") or "", HELD, parent, child, placed.poses[child].translation)


def _held_point(
    element: Element, placed: Placed, ends: tuple[str, str, tuple[Pose, Pose] | None], relpose: Sequence[Decimal]
) -> RawJoint:
    """Where a weld without torque holds its bodies: the sites, or the anchor of the second body (the world where there
    is none) at the place of `relpose` in the first one where that is given, else where the file's own pose has it."""
    parent, child, meeting = ends
    if meeting is not None:
        one, other = (pose.translation for pose in meeting)
    else:
        anchor = triple(numbers(element.get("anchor", "0 0 0"), f"{label(element)}, anchor", 3))
        names = (element.attrib["body1"], element.get("body2"))
        first, second = (placed.ground if name in (None, "world") else str(name) for name in names)
        given = any(value != 0 for value in relpose[3:])
        at = triple(relpose[:3]) if given else (placed.own[first].inverse() @ placed.own[second]).point(anchor)
        one, other = placed.poses[first].point(at), placed.poses[second].point(anchor)
    place = placed.closing.middle(label(element), one, other)
    return RawJoint(element.get("name") or "", "S", parent, child, place)


def _check_weld(element: Element, placed: Placed, wanted: Pose, found: Pose) -> None:
    """That two poses are one, up to rounding: a fixed joint holds what the reference configuration has."""
    turned = max(length(minus(a, b)) for a, b in zip(wanted.rotation, found.rotation, strict=True))
    placed.closing.accept(label(element), max(length(minus(wanted.translation, found.translation)), turned))
