"""Bodies of an MJCF file: poses, inertias, joints with their forces, sites.

    <worldbody> --from the world outwards--> RawBody, RawJoint, points: absolute axes in the reference configuration

A joint whose coupling has an offset is displaced by it: the reference configuration obeys all couplings.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

from symscrew.description import JOINT_TYPES
from symscrew.errors import DescriptionError, shorten
from symscrew.formats.draft import AXES, Draft, RawBody, RawJoint, RawPicture
from symscrew.formats.drawn_meshes import placed
from symscrew.formats.file_names import fresh
from symscrew.formats.merged_joints import one_joint
from symscrew.formats.mesh_inertias import Meshes
from symscrew.formats.mjcf_composed import ATTACHED
from symscrew.formats.mjcf_couplings import Tied
from symscrew.formats.mjcf_forces import TimedSpring, joint_forces
from symscrew.formats.mjcf_geoms import Solid, round_form, solid, together
from symscrew.formats.mjcf_keyframes import Listed
from symscrew.formats.mjcf_settings import ORIENTATIONS, READ, UNSEEN, Attributes, Settings
from symscrew.formats.rigid_displacements import (
    UNITS,
    ZERO,
    Pose,
    Real,
    Rotation,
    Triple,
    about,
    apply,
    has_length_one,
    minus,
    real,
    scaled,
    triple,
    turned_inertia,
    unit,
)
from symscrew.formats.safe_xml import Element, check_attributes, elements, label, number, numbers

IN_BODY = ("body", "frame", "joint", "freejoint", "geom", "site", "inertial", "camera", "light", ATTACHED)


@dataclass
class Reading:
    """What has been read so far: the draft, poses of bodies and sites.

    `screws`: slide -> the coupling that may make a screw of it and its hinge; `values`: hinge or slide -> its
    coordinate in the reference configuration; `displaced`: joint -> by how much that differs from the file's; `rests`:
    the same joints' springref; `timed`: joint -> its springdamper;
    `listed`: joints in the order of the file's coordinates; `parts`: settings and meshes of the models in the file;
    `in_medium`: bodies have drag; `carried`: body -> share of its weight, `borne`: joints whose part of that is the
    actuators'; `stand_ins`: bodies with inertials where geoms are to say the mass and none does; `geoms`: those with
    names, and their bodies; `given`: names that bodies and joints of the file have, which none without gets.
    """

    settings: Settings
    screws: dict[str, Tied]
    driven: dict[str, tuple[int, ...]]
    result: Draft
    meshes: Meshes
    displaced: Mapping[str, Real] = field(default_factory=dict)
    poses: dict[str, Pose] = field(default_factory=dict)
    sites: dict[str, tuple[str, Pose]] = field(default_factory=dict)
    values: dict[str, Real] = field(default_factory=dict)
    rests: dict[str, Real] = field(default_factory=dict)
    timed: dict[str, TimedSpring] = field(default_factory=dict)
    seen: set[str] = field(default_factory=set)
    made_screws: set[str] = field(default_factory=set)
    listed: list[Listed] = field(default_factory=list)
    parts: Sequence[tuple[Settings, Meshes]] = ()
    in_medium: bool = False
    carried: dict[str, Real] = field(default_factory=dict)
    borne: list[str] = field(default_factory=list)
    bare: dict[str, Triple] = field(default_factory=dict)
    stand_ins: set[str] = field(default_factory=set)
    geoms: dict[str, tuple[str, Part]] = field(default_factory=dict)
    given: frozenset[str] = frozenset()

    def within(self, attached: Element) -> Reading:
        """The same reading with the units, classes and meshes of a model that is attached."""
        chosen, meshes = self.parts[int(attached.attrib["part"])]
        return replace(self, settings=chosen, meshes=meshes)


@dataclass(frozen=True)
class Place:
    """Where the reader is: in which body, at which pose, and the default class that is inherited there."""

    body: str
    pose: Pose
    childclass: str | None


@dataclass(frozen=True)
class Part:
    """A joint, geom or inertial of a body, with the class that it inherits and the pose that it refers to.

    `reading` has the settings of the model that it is of.
    """

    element: Element
    childclass: str | None
    pose: Pose
    reading: Reading

    @property
    def attributes(self) -> Attributes:
        """Its own over those of its class."""
        return self.reading.settings.merged(self.element, self.element.tag, self.childclass)


def read_children(reading: Reading, parent: Element, place: Place) -> None:
    """Bodies, sites and frames inside a body or frame."""
    for child in elements(parent):
        if child.tag not in IN_BODY:
            raise DescriptionError(f"{label(parent)}: the element <{child.tag}> of MJCF is not supported")
        if child.tag == "frame":
            check_attributes(child, READ["frame"])
            inner = place.pose @ reading.settings.pose(child.attrib, label(child))
            read_children(reading, child, Place(place.body, inner, child.get("childclass") or place.childclass))
        elif child.tag == ATTACHED:
            read_children(reading.within(child), child, replace(place, childclass=child.attrib["childclass"]))
        elif child.tag == "body":
            _read_body(reading, child, place)
        elif child.tag == "site":
            _read_site(reading, child, place)


def _read_body(reading: Reading, element: Element, outer: Place) -> None:
    where = label(element)
    check_attributes(element, READ["body"])
    if element.get("mocap", "false") != "false":
        reading.result.ledger.passed("motion of mocap bodies, which stand still here")
    inherited = element.get("childclass") or outer.childclass
    name = element.get("name")
    if name in reading.poses:
        raise DescriptionError(f"{where}: two bodies have this name")
    name = name or fresh("body", reading.poses.keys() | reading.given)
    pose = outer.pose @ reading.settings.pose(element.attrib, where)
    own, local = _own(reading, element, inherited, pose), reading.poses[outer.body].inverse() @ pose
    joints, moved = _joints(reading, outer.body, Place(name, pose, inherited), own)
    pose = moved @ pose
    own = [replace(part, pose=moved @ part.pose) for part in own]
    reading.poses[name] = pose
    place = Place(name, pose, inherited)
    reading.result.bodies.append(_body(reading, name, own))
    reading.bare[name] = pose.point(local.translation)  # where the engine has a mass that no element gives
    reading.carried[name] = real(number(element.get("gravcomp", "0"), f"{where}, gravcomp"))
    reading.result.joints += joints
    fused = reading.settings.fuses and element.get("fuse") != "false" and joints[-1].type == "fixed"
    if fused and reading.stand_ins & {name, outer.body}:
        reading.result.ledger.lost(f"fusestatic: the engine takes the geoms alone of {name} and {outer.body} for mass")
    read_children(reading, element, place)


def _own(reading: Reading, element: Element, inherited: str | None, pose: Pose) -> list[Part]:
    """Joints, geoms and inertials of a body, through its frames and what is attached to it."""
    found: list[Part] = []
    for child in elements(element):
        if child.tag == "frame":
            inner = pose @ reading.settings.pose(child.attrib, label(child))
            found += _own(reading, child, child.get("childclass") or inherited, inner)
        elif child.tag == ATTACHED:
            found += _own(reading.within(child), child, child.attrib["childclass"], pose)
        elif child.tag in ("joint", "freejoint", "geom", "inertial"):
            found.append(Part(child, inherited, pose, reading))
    return found


def name_geoms(reading: Reading, body: str, parts: Sequence[Part]) -> None:
    """Enter the geoms of a body that have names; of two with one name the first."""
    for part in parts:
        if part.element.tag == "geom" and "name" in part.element.attrib:
            reading.geoms.setdefault(part.element.attrib["name"], (body, part))


def round_geom(body: str, part: Part) -> tuple[str, str, Pose, Real]:
    """(body, "sphere" or "cylinder", pose, radius) of a geom that a tendon goes around; raises DescriptionError."""
    return body, *round_form(part.attributes, part.reading.settings, part.pose, label(part.element))


def of_world(reading: Reading, world: Element) -> None:
    """Enter what a <worldbody> has of its own."""
    name_geoms(reading, reading.result.ground, _own(reading, world, world.get("childclass"), Pose()))


def _body(reading: Reading, name: str, own: Sequence[Part]) -> RawBody:
    """The body's inertia, from its inertial element or its geoms."""
    chosen = reading.settings
    given = [part for part in own if part.element.tag == "inertial"]
    geoms = [part for part in own if part.element.tag == "geom"]
    name_geoms(reading, name, geoms)
    for part in geoms:
        attributes = part.attributes
        if attributes.get("contype", "1") != "0" or attributes.get("conaffinity", "1") != "0":
            reading.result.ledger.passed("contacts of geoms")
        for key in (key for key in UNSEEN if key in attributes):
            reading.result.ledger.passed(f"{key} of geoms")
        if {"pos", "fromto"} <= attributes.keys():
            reading.result.ledger.passed("pos of geoms whose fromto says where they are")
        if reading.in_medium and attributes.get("fluidshape", "none") != "none":
            reading.result.ledger.lost("fluidshape of geoms: a model of the medium of their own")
        if attributes.get("type") == "mesh" and "mesh" in attributes:
            read = partial(_triangles, part, f"<body name={name!r}>, {label(part.element)}")
            reading.result.pictures.append(RawPicture(name, part.pose, read))
    found: Solid | None = None
    if chosen.from_geoms == "true" or (chosen.from_geoms == "auto" and not given):
        solids = [
            solid(
                part.attributes,
                part.reading.settings,
                part.pose,
                where=f"<body name={name!r}>, {label(part.element)}",
                meshes=part.reading.meshes,
            )
            for part in geoms
        ]
        found = together([solid for solid in solids if solid is not None])
    if len(given) > 1:
        raise DescriptionError(f"<body name={name!r}>: expected one <inertial>, got {len(given)}")
    if given and found is None:  # also where geoms are to say it and none of those that may has mass
        found = _inertial(given[0], f"<body name={name!r}>, <inertial>")
        reading.stand_ins |= {name} if chosen.from_geoms == "true" else set()
    return RawBody(name) if found is None else RawBody(name, found.mass, found.com, found.inertia, found.axes)


def _triangles(part: Part, where: str) -> Any:
    """The triangles of a geom's mesh, in the frame that the geom is in."""
    attributes = part.attributes
    triangles = part.reading.meshes.triangles(attributes["mesh"], where)
    return placed(triangles, part.reading.settings.pose(attributes, where))


def _inertial(part: Part, where: str) -> Solid | None:
    element = part.element
    check_attributes(element, READ["inertial"], where)
    for key in ("mass", "pos"):
        if key not in element.attrib:
            raise DescriptionError(f"{where}: the attribute {key!r} is missing")
    mass = real(number(element.attrib["mass"], f"{where}, mass"))
    frame = part.pose @ part.reading.settings.pose(element.attrib, where)
    zero = ZERO[0]
    if "fullinertia" in element.attrib:
        both = [key for key in ("diaginertia", "quat", *ORIENTATIONS) if key in element.attrib]
        if both:
            raise DescriptionError(f"{where}: expected {both[0]} or fullinertia, got both")
        xx, yy, zz, xy, xz, yz = (real(v) for v in numbers(element.attrib["fullinertia"], f"{where}, fullinertia", 6))
    else:
        text = element.attrib.get("diaginertia", "0 0 0")
        xx, yy, zz = (real(v) for v in numbers(text, f"{where}, diaginertia", 3))
        xy = xz = yz = zero
    if mass == 0 and not any((xx, yy, zz, xy, xz, yz)):
        return None
    matrix: Rotation = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    axes = None if "fullinertia" in element.attrib else frame.rotation
    return Solid(mass, frame.translation, turned_inertia(frame.rotation, matrix), axes)


def _joints(reading: Reading, parent: str, place: Place, own: Sequence[Part]) -> tuple[list[RawJoint], Pose]:
    """The chain of joints from the parent to a body, over new bodies without mass where there are several.

    Also the displacement by which those of them that have one move the body from where the file has it.
    """
    body, pose = place.body, place.pose
    single, moved = [], Pose()
    for part in own:
        if part.element.tag in ("joint", "freejoint"):
            joint = _joint(reading, replace(part, pose=moved @ part.pose), moved @ pose)
            single.append(joint)
            moved = _displacement(joint, reading.displaced.get(joint.name)) @ moved
    parts = _screwed(reading, single)
    if not parts:
        name = fresh(f"{body}_fixed", reading.seen | reading.given)
        return [RawJoint(name, "fixed", parent, body, pose.translation)], moved
    links = [parent]
    for k in range(1, len(parts)):
        name = fresh(f"{body}_{k}", reading.poses.keys() | reading.given)
        reading.poses[name] = pose
        reading.result.bodies.append(RawBody(name))
        links.append(name)
    links.append(body)
    return [replace(part, parent=links[k], child=links[k + 1]) for k, part in enumerate(parts)], moved


def _displacement(joint: RawJoint, amount: Real | None) -> Pose:
    """What a hinge or slide does when it is displaced."""
    if amount is None or amount == 0:
        return Pose()
    if JOINT_TYPES[joint.type].slider:
        return Pose(UNITS, scaled(joint.axes[0], amount))
    turn = about(joint.axes[0], amount)
    return Pose(turn, minus(joint.point, apply(turn, joint.point)))


def _joint(reading: Reading, part: Part, body: Pose) -> RawJoint:
    """One joint of a body that is at the pose `body`; its ends are filled in later."""
    element, place, chosen = part.element, part.pose, part.reading.settings
    if element.tag == "freejoint":
        check_attributes(element, READ["freejoint"])
        if element.get("align", "false") not in ("false", "auto"):
            raise DescriptionError(f"{label(element)}: align is not supported")
        attributes: Attributes = {**element.attrib, "type": "free"}
    else:
        attributes = part.attributes
    kind = attributes.get("type", "hinge")
    name = element.get("name")
    if name in reading.seen:
        raise DescriptionError(f"{label(element)}: two joints have this name")
    name = name or fresh("joint", reading.seen | reading.given)
    reading.seen.add(name)
    where = label(element)
    if element.tag == "joint":
        timed = joint_forces(reading.result, chosen, name, attributes=attributes, kind=kind)
        reading.timed |= {name: timed} if timed is not None else {}
    driven = reading.driven.get(name, ())
    if attributes.get("actuatorgravcomp", "false") == "true":
        reading.borne.append(name)
    reading.listed.append(Listed(name, kind, body))
    if kind == "free":
        return RawJoint(name, "free", "", "", body.translation, driven=driven)
    if kind not in ("hinge", "slide", "ball"):
        raise DescriptionError(f"{where}: expected a type among hinge, slide, ball, free, got {shorten(kind)}")
    point = place.point(triple(numbers(attributes.get("pos", "0 0 0"), f"{where}, pos", 3)))
    if kind == "ball":
        return RawJoint(name, "S", "", "", point, driven=driven)
    given = triple(numbers(attributes.get("axis", "0 0 1"), f"{where}, axis", 3))
    axis = unit(given, f"{where}, axis")
    if not has_length_one(given):
        reading.result.ledger.passed(AXES)
    reference = number(attributes.get("ref", "0"), f"{where}, ref")
    value: Real = chosen.angle(reference) if kind == "hinge" else real(reference)
    value = value + reading.displaced.get(name, ZERO[0])
    reading.values[name] = value
    rest = number(attributes.get("springref", "0"), f"{where}, springref")
    reading.rests[name] = chosen.angle(rest) if kind == "hinge" else real(rest)
    letter = "R" if kind == "hinge" else "P"
    driven = tuple(index for index in driven if index == 0)  # the other entries of a gear have no freedom here
    return RawJoint(name, letter, "", "", point, (place.direction(axis),), driven=driven, reference=(value,))


def _screwed(reading: Reading, parts: list[RawJoint]) -> list[RawJoint]:
    """A slide and the hinge after it on one axis, coupled by a factor and neither displaced, as one helical joint."""
    result: list[RawJoint] = []
    for part in parts:
        before = result[-1] if result else None
        tied = reading.screws.get(before.name) if before else None
        chain = one_joint([before, part], part.name) if before and tied and part.name in tied.second else None
        if before is None or tied is None or chain is None or chain.type != "C" or before.driven:
            result.append(part)
            continue
        stem = part.name.removesuffix(".1") if before.name == part.name.removesuffix(".1") + ".0" else part.name
        result[-1] = replace(
            chain, name=stem, type="H", pitch=tied.powers[1], driven=part.driven, reference=part.reference
        )
        reading.seen.add(stem)
        reading.made_screws.add(before.name)
        for name in (before.name, part.name):
            reading.result.parts_of[name] = (stem, 0 if name == part.name else None)
    return result


def _read_site(reading: Reading, element: Element, outer: Place) -> None:
    attributes = reading.settings.merged(element, "site", outer.childclass)
    pose = outer.pose @ reading.settings.pose(attributes, label(element))
    if "fromto" in attributes:
        ends = numbers(attributes["fromto"], f"{label(element)}, fromto", 6)
        start, end = triple(ends[:3]), triple(ends[3:])
        middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, (start[2] + end[2]) / 2)
        pose = Pose(pose.rotation, outer.pose.point(middle))
    name = element.get("name")
    if name is None:
        return
    if name in reading.sites:
        raise DescriptionError(f"{label(element)}: two sites have this name")
    reading.sites[name] = (outer.body, pose)
    reading.result.points.append((name, outer.body, pose.translation))
