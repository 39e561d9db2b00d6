"""A mechanism from MJCF: the bodies and joints below <worldbody>, loops, actuators, sites.

    <worldbody> poses relative to the parent --products--> Draft in absolute axes; <equality> --mjcf_loops--> loops

Read: body, frame, inertial, joint (hinge, slide, ball, free; several on one body), freejoint, geoms of simple
shape where inertia comes from them, sites (as named points), default classes, compiler angle, eulerseq,
inertiafromgeom and inertiagrouprange, equality connect, weld and the joint coupling of a screw
(`symscrew.formats.mjcf_loops`), actuators of joints. Everything else that would change masses or
kinematics is refused by name. Forces (damping, stiffness, friction, contacts, limits) and gravity are not part
of a mechanism: they are named in its `source`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from symscrew.errors import DescriptionError, shorten
from symscrew.formats.draft import Draft, RawBody, RawJoint
from symscrew.formats.file_names import fresh
from symscrew.formats.merged_joints import one_joint
from symscrew.formats.mjcf_geoms import Solid, solid, together
from symscrew.formats.mjcf_loops import Coupling, Placed, couplings, driven_freedoms, loops
from symscrew.formats.mjcf_settings import READ, Attributes, Settings, settings
from symscrew.formats.rigid_displacements import ZERO, Pose, Real, Rotation, Triple, real, triple, turned_inertia, unit
from symscrew.formats.safe_xml import Element, check_attributes, elements, label, number, numbers

# elements of MJCF that are read, that hold no mechanics, and that a body may hold; others are refused by name
SECTIONS = ("compiler", "option", "default", "worldbody", "equality", "actuator")
WITHOUT_MECHANICS = ("size", "visual", "statistic", "custom", "asset", "contact", "sensor", "keyframe")
IN_BODY = ("body", "frame", "joint", "freejoint", "geom", "site", "inertial", "camera", "light")
# attributes of joints that are forces or limits: counted, and named in `source`
FORCES = ("stiffness", "damping", "frictionloss", "springdamper")
LIMITS = ("range", "actuatorfrcrange")
WORLD = "world"


@dataclass
class Reading:
    """What has been read so far: the draft, poses of bodies and sites, counts for the notes."""

    settings: Settings
    couplings: dict[str, Coupling]
    driven: dict[str, tuple[int, ...]]
    result: Draft
    poses: dict[str, Pose] = field(default_factory=dict)
    sites: dict[str, tuple[str, Triple]] = field(default_factory=dict)
    counts: dict[str, int] = field(default_factory=dict)
    seen: set[str] = field(default_factory=set)

    def count(self, what: str) -> None:
        """One more of something that a mechanism does not hold."""
        self.counts[what] = self.counts.get(what, 0) + 1


@dataclass(frozen=True)
class Place:
    """Where the reader is: in which body, at which pose, and the default class that is inherited there."""

    body: str
    pose: Pose
    childclass: str | None


@dataclass(frozen=True)
class Part:
    """A joint, geom or inertial of a body, with the class that it inherits and the pose that it refers to."""

    element: Element
    childclass: str | None
    pose: Pose


def read_mjcf(root: Element, file: str) -> Draft:
    """What a <mujoco> says; raises DescriptionError for what a mechanism cannot hold.

    Args:
        root: the file's root element.
        file: its name, for the mechanism's `source`.
    """
    check_attributes(root, ("model",))
    for child in elements(root):
        if child.tag not in (*SECTIONS, *WITHOUT_MECHANICS) and (len(child) or child.attrib):
            cure = "; save one file from MuJoCo (mj_saveLastXML)" if child.tag == "include" else "; remove it"
            raise DescriptionError(f"<{child.tag}>: this element of MJCF is not supported{cure}")
    chosen, notes = settings(root)
    model = root.get("model") or "mujoco_model"
    texts = {t.get("name"): t.get("data") or "" for c in elements(root, "custom") for t in elements(c, "text")}
    ground = texts.get("symscrew_ground", WORLD)
    result = Draft(model, ground, f"imported from the MJCF {file}", texts.get("symscrew_description", ""))
    result.notes += notes
    if "symscrew_characteristic_length" in texts:
        result.characteristic_length = real(number(texts["symscrew_characteristic_length"], "<custom>, length"))
    coupled = couplings(root, chosen)
    reading = Reading(chosen, {c.slide: c for c in coupled}, driven_freedoms(root), result)
    reading.poses[ground] = Pose()
    for world in elements(root, "worldbody"):
        check_attributes(world, ())
        _read_children(reading, world, Place(ground, Pose(), None))
    _check_all_found(reading)
    result.joints += loops(root, chosen, Placed(reading.poses, reading.sites, ground))
    platform = texts.get("symscrew_platform")
    parents = {joint.parent for joint in result.joints}
    tips = [body.name for body in result.bodies if body.name not in parents]
    chain = len(tips) == 1 and len(result.joints) == len(result.bodies)
    result.platform = platform if platform in reading.poses else (tips[0] if chain else None)
    if reading.counts:
        counted = ", ".join(f"{what} ({n})" for what, n in reading.counts.items())
        result.notes.append(f"not taken over: {counted}")
    return result


def _check_all_found(reading: Reading) -> None:
    names = {name for joint in reading.result.joints for name in (joint.name,)} | reading.seen
    for name in reading.driven:
        if name not in names:
            raise DescriptionError(f"<actuator>: there is no joint {shorten(name)}")
    for name in reading.couplings:
        if name not in names:
            raise DescriptionError(f"<equality>: there is no slide joint {shorten(name)} on one body with its hinge")


def _read_children(reading: Reading, parent: Element, place: Place) -> None:
    """Bodies, sites and frames inside a body or frame."""
    for child in elements(parent):
        if child.tag not in IN_BODY:
            raise DescriptionError(f"{label(parent)}: the element <{child.tag}> of MJCF is not supported")
        if child.tag == "frame":
            check_attributes(child, READ["frame"])
            inner = place.pose @ reading.settings.pose(child.attrib, label(child))
            _read_children(reading, child, Place(place.body, inner, child.get("childclass") or place.childclass))
        elif child.tag == "body":
            _read_body(reading, child, place)
        elif child.tag == "site":
            _read_site(reading, child, place)


def _read_body(reading: Reading, element: Element, outer: Place) -> None:
    where = label(element)
    check_attributes(element, READ["body"])
    if element.get("mocap", "false") != "false":
        raise DescriptionError(f"{where}: mocap bodies are not supported; remove the body or its mocap")
    if number(element.get("gravcomp", "0"), f"{where}, gravcomp") != 0:
        reading.count("gravcomp")
    inherited = element.get("childclass") or outer.childclass
    name = element.get("name")
    if name in reading.poses:
        raise DescriptionError(f"{where}: two bodies have this name")
    name = name or fresh("body", reading.poses)
    pose = outer.pose @ reading.settings.pose(element.attrib, where)
    reading.poses[name] = pose
    place = Place(name, pose, inherited)
    own = _own(element, inherited, pose, reading.settings)
    reading.result.bodies.append(_body(reading, name, own))
    reading.result.joints += _joints(reading, outer.body, place, own)
    _read_children(reading, element, place)


def _own(element: Element, inherited: str | None, pose: Pose, settings: Settings) -> list[Part]:
    """Joints, geoms and inertials of a body, through its frames."""
    found: list[Part] = []
    for child in elements(element):
        if child.tag == "frame":
            inner = pose @ settings.pose(child.attrib, label(child))
            found += _own(child, child.get("childclass") or inherited, inner, settings)
        elif child.tag in ("joint", "freejoint", "geom", "inertial"):
            found.append(Part(child, inherited, pose))
    return found


def _body(reading: Reading, name: str, own: Sequence[Part]) -> RawBody:
    """The body's inertia, from its inertial element or its geoms."""
    chosen = reading.settings
    given = [part for part in own if part.element.tag == "inertial"]
    geoms = [part for part in own if part.element.tag == "geom"]
    for part in geoms:
        attributes = chosen.merged(part.element, "geom", part.childclass)
        if attributes.get("contype", "1") != "0" or attributes.get("conaffinity", "1") != "0":
            reading.count("contacts of geoms")
    found: Solid | None = None
    if chosen.from_geoms == "true" or (chosen.from_geoms == "auto" and not given):
        solids = [
            solid(
                chosen.merged(part.element, "geom", part.childclass),
                chosen,
                part.pose,
                f"<body name={name!r}>, {label(part.element)}",
            )
            for part in geoms
        ]
        found = together([solid for solid in solids if solid is not None])
    elif given:
        found = _inertial(chosen, given[0].element, given[0].pose, f"<body name={name!r}>, <inertial>")
    return RawBody(name) if found is None else RawBody(name, found.mass, found.com, found.inertia)


def _inertial(chosen: Settings, element: Element, pose: Pose, where: str) -> Solid | None:
    check_attributes(element, READ["inertial"], where)
    for key in ("mass", "pos"):
        if key not in element.attrib:
            raise DescriptionError(f"{where}: the attribute {key!r} is missing")
    mass = real(number(element.attrib["mass"], f"{where}, mass"))
    frame = pose @ chosen.pose(element.attrib, where)
    zero = ZERO[0]
    if "fullinertia" in element.attrib:
        if "diaginertia" in element.attrib:
            raise DescriptionError(f"{where}: expected diaginertia or fullinertia, got both")
        xx, yy, zz, xy, xz, yz = (real(v) for v in numbers(element.attrib["fullinertia"], f"{where}, fullinertia", 6))
    else:
        text = element.attrib.get("diaginertia", "0 0 0")
        xx, yy, zz = (real(v) for v in numbers(text, f"{where}, diaginertia", 3))
        xy = xz = yz = zero
    if mass == 0 and not any((xx, yy, zz, xy, xz, yz)):
        return None
    matrix: Rotation = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    return Solid(mass, frame.translation, turned_inertia(frame.rotation, matrix))


def _joints(reading: Reading, parent: str, place: Place, own: Sequence[Part]) -> list[RawJoint]:
    """The chain of joints from the parent to a body, over new bodies without mass where there are several."""
    body, pose = place.body, place.pose
    single = [_joint(reading, part, pose) for part in own if part.element.tag in ("joint", "freejoint")]
    parts = _coupled(reading, single)
    if not parts:
        return [RawJoint(fresh(f"{body}_fixed", reading.seen), "fixed", parent, body, pose.translation)]
    links = [parent]
    for k in range(1, len(parts)):
        name = fresh(f"{body}_{k}", reading.poses)
        reading.poses[name] = pose
        reading.result.bodies.append(RawBody(name))
        links.append(name)
    links.append(body)
    return [replace(part, parent=links[k], child=links[k + 1]) for k, part in enumerate(parts)]


def _joint(reading: Reading, part: Part, body: Pose) -> RawJoint:
    """One joint of a body that is at the pose `body`; its ends are filled in later."""
    element, place, chosen = part.element, part.pose, reading.settings
    if element.tag == "freejoint":
        check_attributes(element, READ["freejoint"])
        if element.get("align", "false") not in ("false", "auto"):
            raise DescriptionError(f"{label(element)}: align is not supported")
        attributes: Attributes = {**element.attrib, "type": "free"}
    else:
        attributes = chosen.merged(element, "joint", part.childclass)
    kind = attributes.get("type", "hinge")
    name = element.get("name")
    if name in reading.seen:
        raise DescriptionError(f"{label(element)}: two joints have this name")
    name = name or fresh("joint", reading.seen)
    reading.seen.add(name)
    where = label(element)
    _check_forces(reading, attributes, where)
    driven = reading.driven.get(name, ())
    if kind == "free":
        return RawJoint(name, "free", "", "", body.translation, driven=driven)
    if kind not in ("hinge", "slide", "ball"):
        raise DescriptionError(f"{where}: expected a type among hinge, slide, ball, free, got {shorten(kind)}")
    point = place.point(triple(numbers(attributes.get("pos", "0 0 0"), f"{where}, pos", 3)))
    if kind == "ball":
        return RawJoint(name, "S", "", "", point, driven=driven)
    axis = unit(triple(numbers(attributes.get("axis", "0 0 1"), f"{where}, axis", 3)), f"{where}, axis")
    reference = number(attributes.get("ref", "0"), f"{where}, ref")
    value: Real = chosen.angle(reference) if kind == "hinge" else real(reference)
    letter = "R" if kind == "hinge" else "P"
    if any(index > 0 for index in driven):
        raise DescriptionError(f"{where}: it has one freedom, but an actuator's gear drives another")
    return RawJoint(name, letter, "", "", point, (place.direction(axis),), driven=driven, reference=(value,))


def _check_forces(reading: Reading, attributes: Attributes, where: str) -> None:
    """Refuses what adds inertia; counts forces and limits."""
    if number(attributes.get("armature", "0"), f"{where}, armature") != 0:
        raise DescriptionError(
            f"{where}: armature {attributes['armature']} adds inertia that a mechanism does not hold; set it to 0 "
            "(here or in the default class) to import the bodies, and name it as an effect of type rotor_inertia"
        )
    for key in FORCES:
        if any(value != 0 for value in numbers(attributes.get(key, "0"), f"{where}, {key}")):
            reading.count(key)
    if any(key in attributes for key in LIMITS):
        reading.count("limits")


def _coupled(reading: Reading, parts: list[RawJoint]) -> list[RawJoint]:
    """A slide and a hinge on one axis that an equality couples, as one helical joint."""
    result: list[RawJoint] = []
    for part in parts:
        before = result[-1] if result else None
        coupling = reading.couplings.get(before.name) if before else None
        if before is None or coupling is None:
            result.append(part)
            continue
        chain = one_joint([before, part], part.name) if coupling.hinge == part.name else None
        if chain is None or chain.type != "C" or before.driven:
            raise DescriptionError(
                f"<equality>: the joints {before.name!r} and {part.name!r} are coupled, but are not an undriven slide "
                "and then a hinge on one axis and body; only a screw is supported"
            )
        stem = part.name.removesuffix(".1") if before.name == part.name.removesuffix(".1") + ".0" else part.name
        result[-1] = replace(
            chain, name=stem, type="H", pitch=coupling.pitch, driven=part.driven, reference=part.reference
        )
        reading.seen.add(stem)
    return result


def _read_site(reading: Reading, element: Element, outer: Place) -> None:
    attributes = reading.settings.merged(element, "site", outer.childclass)
    place = (outer.pose @ reading.settings.pose(attributes, label(element))).translation
    if "fromto" in attributes:
        ends = numbers(attributes["fromto"], f"{label(element)}, fromto", 6)
        start, end = triple(ends[:3]), triple(ends[3:])
        place = outer.pose.point(((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, (start[2] + end[2]) / 2))
    name = element.get("name")
    if name is None:
        return
    if name in reading.sites:
        raise DescriptionError(f"{label(element)}: two sites have this name")
    reading.sites[name] = (outer.body, place)
    reading.result.points.append((name, outer.body, place))
