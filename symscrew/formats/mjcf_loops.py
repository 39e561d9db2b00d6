"""Loops, couplings and drives of an MJCF file: <equality> and <actuator>.

    connect --> S;  two connects of the same bodies --> R;  weld --> fixed;  slide coupled to hinge --> H

A connect is a spherical joint between two bodies, two connects between the same bodies a revolute joint about
the line through their points, a weld a fixed joint. A coupling of a slide with a hinge makes a helical joint.
All must hold in the reference configuration, as MuJoCo makes them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

import mpmath

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import RawJoint
from symscrew.formats.file_names import fresh
from symscrew.formats.mjcf_settings import Settings
from symscrew.formats.rigid_displacements import (
    CONTEXT,
    Pose,
    Real,
    Triple,
    from_quaternion,
    length,
    minus,
    real,
    triple,
    unit,
)
from symscrew.formats.safe_xml import Element, attribute, elements, label, numbers

CLOSED = CONTEXT.mpf(10) ** -9
"""Gap [m, rad] of a loop that counts as closed: files have about ten digits, and MuJoCo itself closes loops softly. A
larger one is refused, because the joint would be at neither of its two places."""
ACTUATORS = (
    "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "general", "dcmotor",
)  # fmt: skip


@dataclass(frozen=True)
class Placed:
    """Poses of the bodies, sites as (body, place), and the name of the ground."""

    poses: Mapping[str, Pose]
    sites: Mapping[str, tuple[str, Triple]]
    ground: str


@dataclass(frozen=True)
class Coupling:
    """A slide that moves by `pitch` [m/rad] times its hinge."""

    slide: str
    hinge: str
    pitch: Real


def couplings(root: Element, settings: Settings) -> list[Coupling]:
    """The screws among the joint couplings; raises DescriptionError for any other active coupling."""
    found = []
    for element in _equalities(root, settings, "joint"):
        where = label(element)
        given = numbers(element.get("polycoef", "0 1 0 0 0"), f"{where}, polycoef")
        coefficients = [*given, *[Decimal(0)] * (5 - len(given))]
        if "joint2" not in element.attrib or any(coefficients[k] != 0 for k in (0, 2, 3, 4)):
            raise DescriptionError(
                f'{where} in <equality>: only the coupling of a slide to a hinge by polycoef="0 pitch 0 0 0" (a '
                'screw) is supported; remove it or make it active="false"'
            )
        found.append(Coupling(attribute(element, "joint1"), attribute(element, "joint2"), real(coefficients[1])))
    return found


def loops(root: Element, settings: Settings, placed: Placed) -> list[RawJoint]:
    """The joints that close loops; raises DescriptionError for what is not supported or does not close."""
    for section in elements(root, "equality"):
        for element in elements(section):
            if element.tag not in ("connect", "weld", "joint"):
                raise DescriptionError(f"{label(element)} in <equality>: only connect, weld and joint are supported")
    connects = [_connect(e, placed) for e in _equalities(root, settings, "connect")]
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
    result += [_weld(e, placed) for e in _equalities(root, settings, "weld")]
    names: list[str] = []
    for k, joint in enumerate(result):
        names.append(fresh(joint.name or f"loop_{k}", names))
    return [RawJoint(name, j.type, j.parent, j.child, j.point, j.axes) for name, j in zip(names, result, strict=True)]


def _twin(a: RawJoint, b: RawJoint) -> bool:
    """Whether two connects join the same bodies at different points."""
    return {a.parent, a.child} == {b.parent, b.child} and length(minus(a.point, b.point)) > CLOSED


def _equalities(root: Element, settings: Settings, tag: str) -> Iterator[Element]:
    """The active equalities of a kind."""
    kind = "couple" if tag == "joint" else tag
    for section in elements(root, "equality"):
        for element in elements(section, tag):
            chosen = settings.merged(element, kind, None)
            name = element.get("class") or "main"
            default = settings.defaults[name].get("equality", {})
            if {**default, **chosen}.get("active", "true") == "true":
                yield element


def _ends(element: Element, placed: Placed) -> tuple[str, str, Triple | None]:
    """Parent, child, and where two sites meet, if it is given by sites."""
    poses, sites, ground = placed.poses, placed.sites, placed.ground
    if "site1" in element.attrib:
        names = [attribute(element, key) for key in ("site1", "site2")]
        for name in names:
            if name not in sites:
                raise DescriptionError(
                    f"{label(element)}: there is no site {shorten(name)}; {did_you_mean(name, sites)}"
                )
        (first, one), (second, other) = (sites[name] for name in names)
        _check_gap(element, length(minus(one, other)), "m")
        return first, second, one
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
        meeting = placed.poses[placed.ground if owner == "world" else owner].point(anchor)
    return RawJoint(element.get("name") or "", "S", parent, child, meeting)


def _weld(element: Element, placed: Placed) -> RawJoint:
    if "site1" in element.attrib:
        raise DescriptionError(f"{label(element)}: a weld of sites is not supported; weld the bodies")
    parent, child, _ = _ends(element, placed)
    given = numbers(element.get("relpose", "0 1 0 0 0 0 0"), f"{label(element)}, relpose", 7)
    if any(value != 0 for value in given[3:]):
        # relpose is the pose of the second body (the world where there is none) in the first
        first = element.attrib["body1"]
        one, other = (placed.poses[placed.ground if n in (None, "world") else n] for n in (first, element.get("body2")))
        place = triple(given[:3])
        turn = [real(value) for value in given[3:]]
        wanted = Pose(from_quaternion(turn, f"{label(element)}, relpose"), place)
        found = one.inverse() @ other
        turned = max(length(minus(a, b)) for a, b in zip(wanted.rotation, found.rotation, strict=True))
        _check_gap(element, max(length(minus(wanted.translation, found.translation)), turned), "m or rad")
    return RawJoint(element.get("name") or "", "fixed", parent, child, placed.poses[child].translation)


def _check_gap(element: Element, gap: Real, unit_text: str) -> None:
    if gap > CLOSED:
        raise DescriptionError(
            f"{label(element)}: the loop does not close in the reference configuration: its two sides are "
            f"{mpmath.nstr(gap, 6)} {unit_text} apart; move the bodies, or leave out the relative pose"
        )


def driven_freedoms(root: Element) -> dict[str, tuple[int, ...]]:
    """Joint -> its freedoms that an actuator drives, by the gear where there are several."""
    found: dict[str, set[int]] = {}
    for section in elements(root, "actuator"):
        for element in elements(section):
            if element.tag not in ACTUATORS:
                raise DescriptionError(f"{label(element)} in <actuator>: only actuators of joints are supported")
            name = element.get("joint")
            if name is None:
                raise DescriptionError(
                    f"{label(element)} in <actuator>: only actuators with a joint are supported; remove it"
                )
            gear = numbers(element.get("gear", "1"), f"{label(element)}, gear")
            found.setdefault(name, set()).update(_geared(gear, label(element)))
    return {name: tuple(sorted(indices)) for name, indices in found.items()}


def _geared(gear: Sequence[object], where: str) -> list[int]:
    indices = [k for k, value in enumerate(gear) if value != 0]
    if len(indices) != 1:
        raise DescriptionError(f"{where}, gear: expected one entry that is not zero, got {len(indices)}")
    return indices
