"""A mechanism from a URDF: links, joints of all standard types, mimic joints, transmissions, loops.

Read: fixed, revolute, continuous, prismatic, planar and floating joints, Drake's ball and universal ones, with origin
and axis; inertial elements; mimic joints as couplings; transmissions and the command interfaces of ros2_control, whose
joints are driven (without any, all revolute, continuous and prismatic joints that mimic none are); damping,
friction, limits, reductions and rotor inertias as effects and limits beside the mechanism. Loops: <loop> elements,
<gazebo> joints and a Gepetto robot.yaml beside the file. The root link is the ground, or with `floating` moves
freely. Everything else is in the draft's ledger.

    links and joints, relative poses --products from the root--> Draft: absolute axes and points

Source: the URDF specification, https://wiki.ros.org/urdf/XML (angles in rad, rpy about fixed axes).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from symscrew.description import JOINT_TYPES
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import AXES, Draft, Ledger, RawBody, RawCoupling, RawJoint
from symscrew.formats.drawn_meshes import visuals
from symscrew.formats.exact_digits import with_exact_digits
from symscrew.formats.file_names import fresh
from symscrew.formats.import_options import ImportOptions
from symscrew.formats.near_words import note_near_words
from symscrew.formats.open_loops import Closing
from symscrew.formats.physical_inertias import left_open
from symscrew.formats.rigid_displacements import (
    UNITS,
    ZERO,
    Pose,
    Real,
    Rotation,
    Triple,
    about,
    from_quaternion,
    has_length_one,
    length,
    minus,
    product,
    real,
    scaled,
    triple,
    turned_inertia,
    unit,
)
from symscrew.formats.safe_xml import Element, attribute, check_attributes, elements, first, label, number, numbers
from symscrew.formats.urdf_forces import DYNAMICS, LIMITS, REDUCTION, ROTOR, joint_forces, transmission_forces
from symscrew.formats.urdf_gazebo import gazebo_forces, mujoco_settings
from symscrew.formats.urdf_loops import DRAKE, is_loop, loops
from symscrew.formats.urdf_mimics import MIMIC, SINGLE, Mimic, mimics_of, offsets_of

TYPES = {
    "fixed": "fixed", "revolute": "R", "continuous": "R", "prismatic": "P", "planar": "E", "floating": "free",
    "ball": "S", "spherical": "S", "universal": "U",
}  # fmt: skip
READ = (
    "link",
    "joint",
    "transmission",
    "ros2_control",
    "loop",
    "loop_joint",
    "gazebo",
    f"{DRAKE}joint",
    f"{DRAKE}ball_constraint",
)
WITH_INFLUENCE = ("include", "coupling", *(f"{DRAKE}{name}" for name in ("linear_bushing_rpy", "linear_spring_damper")))
# elements of a <joint> and a <link> that are known; others are listed
IN_JOINT = ("origin", "parent", "child", "axis", "limit", "dynamics", *MIMIC, "joint_properties")
ONCE = ("origin", "axis", "limit", "dynamics", "mimic", "joint_properties")
FIRST = ("inertial", "mass", "inertia")
"""Elements of a link, of which the first one counts for ROS."""
MIRRORED = ("iyx", "izx", "izy")
"""Entries of an inertia below its diagonal, which a URDF does not have, and which say nothing if they say the same."""
SEEN = ("visual", "collision")
SIDES = ("link", "xyz", "rpy")
ATTRIBUTES = {
    "robot": ("name",), "link": ("name",), "mass": ("value",), "parent": SIDES, "child": SIDES, "predecessor": SIDES,
    "successor": SIDES, "joint": ("name", "type"), "axis": ("xyz",), "origin": ("xyz", "rpy", "quat_xyzw"),
    "loop": ("name", "type"), "loop_joint": ("name", "type"), "transmission": ("name", "type"), "actuator": ("name",),
    "limit": LIMITS, "dynamics": DYNAMICS, "joint_properties": DYNAMICS,
}  # fmt: skip
CHILDREN = {
    "robot": READ, "link": ("inertial", *SEEN), "inertial": ("origin", "mass", "inertia"),
    "joint": (*IN_JOINT, "axis2"),
    "loop": ("predecessor", "successor", "axis", "limit", "dynamics"), "predecessor": ("origin",),
    "loop_joint": ("predecessor", "successor", "axis", "limit", "dynamics"), "successor": ("origin",),
    "transmission": ("type", "joint", "actuator", *REDUCTION, *ROTOR), "actuator": (*REDUCTION, *ROTOR),
}  # fmt: skip
"""Words that are read of elements and in them, for those that are nearly one of these."""
DEFINED = ("property", "arg", "macro")
"""Elements of xacro that do nothing by themselves."""
FREE_JOINT = "root_joint"
WORLD = "world"


def read_urdf(root: Element, path: Path, options: ImportOptions) -> Draft:
    """What a <robot> says; raises DescriptionError for what a mechanism cannot hold.

    Args:
        root: the file's root element.
        path: of the file: its name is in the mechanism's `source`, a robot.yaml beside it is read.
        options: what else is accepted.
    """
    ledger = Ledger()
    _check_expanded(root, ledger)
    root = with_exact_digits(root, ledger) if options.exact else root
    if any("quat_xyzw" in origin.attrib for origin in root.iter("origin")) and root.get("version") != "1.2":
        ledger.changed.append("quat_xyzw is read, which ROS reads where <robot> says version 1.2 only")
    links, joints = _parts(root, ledger)
    ground = _ground(links, joints)
    mimics = mimics_of(root, joints, ledger)
    offsets = offsets_of(mimics)
    poses = _poses(ground, joints, offsets)
    lost = next((name for name in links if name not in poses), None)
    if lost is not None:
        raise DescriptionError(f"{label(links[lost])}: no chain of joints leads to it from {shorten(ground)}")
    name = root.get("name") or "robot"
    result = Draft(name, ground, f"imported from the URDF {path.name}", f"robot {name}", ledger=ledger)
    driven, noted = _driven(root, joints, mimics, ledger)
    _check_mirrored(links.values(), ledger)
    _say_points(links.values(), ledger)
    result.bodies += [_body(link, poses[name]) for name, link in links.items() if name != ground]
    for link_name, link in links.items():
        result.pictures += visuals(link, poses[link_name], path=path, within=options.folder, origin=_origin)
    result.joints += [_joint(joint, poses, driven, offsets) for joint in joints.values()]
    _couple(result, mimics)
    weighs = bool(list(elements(links[ground], "inertial")))
    if options.floating or (weighs and not joints):
        _set_free(result, _body(links[ground], poses[ground]), joints)
    elif weighs:
        result.ledger.passed("inertia of the root link, which is the ground (--floating frees it)")
    for joint_name, joint in joints.items():
        joint_forces(result, joint_name, joint)
        moves = JOINT_TYPES[TYPES[attribute(joint, "type")]].axes > 0
        axes = [_triple(attribute(a, "xyz"), f"{label(joint)}, axis") for a in first(joint, "axis") if moves]
        if not all(map(has_length_one, axes)):
            result.ledger.passed(AXES)
    transmission_forces(result, root, joints)
    gazebo_forces(result, root, joints)
    mujoco_settings(result, root)
    points = [joint.point for joint in result.joints]
    result.frames = {name: poses[attribute(_one(joint, "child"), "link")] for name, joint in joints.items()}
    extent = max((length(minus(point, points[0])) for point in points), default=ZERO[0])
    closing = Closing(result.ledger, extent, options.snap, options.loosen)
    closed = loops(root, path, result, poses=poses, closing=closing)
    if closed.driven is not None:
        result.joints = [replace(j, driven=(0,) if j.name in closed.driven else ()) for j in result.joints]
        noted = []
    result.joints += closed.joints
    tips = [name for name in links if all(attribute(_one(j, "parent"), "link") != name for j in joints.values())]
    result.platform = tips[0] if len(tips) == 1 and joints and not closed.joints else None
    result.notes += noted
    _left_out(result, root, links.values(), joints.values())
    return result


def _parts(root: Element, ledger: Ledger) -> tuple[dict[str, Element], dict[str, Element]]:
    """Links and joints of the tree by name; the world where joints hang on it."""
    note_near_words(root, ledger, attributes=ATTRIBUTES, children=CHILDREN)
    links = _named(elements(root, "link"), "link")
    every = elements(root, "joint", f"{DRAKE}joint")
    joints = _named((joint for joint in every if not is_loop(joint)), "joint")
    if links and WORLD not in links and any(attribute(_one(j, "parent"), "link") == WORLD for j in joints.values()):
        links[WORLD] = Element("link", name=WORLD)
        ledger.changed.append(
            f"joints hang on a link {WORLD!r} that the file does not have: it is the ground, as for Drake"
        )
    if not links:
        raise DescriptionError("<robot>: expected links, found none (a xacro file that only defines macros gives none)")
    return links, joints


def _ground(links: Mapping[str, Element], joints: Mapping[str, Element]) -> str:
    """The one link that no joint carries."""
    carrier = _carriers(links, joints)
    roots = [name for name in links if name not in carrier]
    if len(roots) != 1:
        found = "none: the joints go in a circle" if not roots else ", ".join(shorten(name) for name in roots[:5])
        raise DescriptionError(f"<robot>: expected one link that is no joint's child, found {found}")
    return roots[0]


def _check_expanded(root: Element, ledger: Ledger) -> None:
    """Refuses macros and includes of xacro, of which only the expansion is a robot; what it writes is read as it is.

    So is a robot beside definitions that nothing in the file uses.
    """
    aside = {part for link in elements(root, "link") for seen in elements(link, *SEEN) for part in seen.iter()}
    defined = [child for child in elements(root) if _xacro(child) in DEFINED]
    aside |= {part for element in defined for part in element.iter()}
    left = next((element for element in root.iter() if _xacro(element) and element not in aside), None)
    used = (e for e in root.iter() if e not in aside and isinstance(e.tag, str) and _has_expression(e))
    what = f"<xacro:{_short(left)}>" if left is not None else next((f"<{_short(e)}>" for e in used if defined), None)
    if what is not None:
        raise DescriptionError(
            f"{what}: it is the source of a URDF, whose macros only xacro expands: "
            "pip install xacro; xacro FILE > robot.urdf (its expressions run as Python: of files that you trust only)"
        )
    if defined:
        ledger.passed("definitions of xacro that nothing uses", len(defined))


def _xacro(element: Element) -> str:
    """The name of an element of xacro's; empty for any other."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) and "xacro}" in element.tag else ""


def _has_expression(element: Element) -> bool:
    return any("${" in text or "$(arg" in text for text in (element.text or "", *element.attrib.values()))


def _couple(result: Draft, mimics: Mapping[str, Mimic]) -> None:
    for name, (other, multiplier, _) in mimics.items():
        terms = {name: (real(1),)} | ({other: (-multiplier,)} if multiplier != 0 else {})
        result.couplings.append(RawCoupling(f"{name}_mimic", terms))


def _set_free(result: Draft, root: RawBody, joints: Mapping[str, Element]) -> None:
    """The root on a joint with six freedoms, from a ground that is new."""
    taken = [result.ground, *(body.name for body in result.bodies)]
    ground = fresh(WORLD, taken)
    result.bodies.insert(0, root)
    place = ZERO if root.com is None else root.com
    result.joints.insert(0, RawJoint(fresh(FREE_JOINT, joints), "free", ground, result.ground, place))
    result.ground = ground
    result.ledger.changed.append(f"the root link {root.name} moves freely in space")


def _named(found: Iterable[Element], what: str) -> dict[str, Element]:
    result: dict[str, Element] = {}
    for element in found:
        name = attribute(element, "name")
        if name in result:
            raise DescriptionError(f"{label(element)}: two {what}s have this name")
        result[name] = element
    return result


def _one(parent: Element, tag: str, where: str | None = None) -> Element:
    """Its one element of a kind; of those that ROS takes the first of, that."""
    found = list(elements(parent, tag))
    if tag in FIRST and found:
        return found[0]
    if len(found) != 1:
        raise DescriptionError(f"{where or label(parent)}: expected one <{tag}>, found {len(found)}")
    return found[0]


def _carriers(links: Mapping[str, Element], joints: Mapping[str, Element]) -> dict[str, Element]:
    """Link -> the joint whose child it is."""
    carrier: dict[str, Element] = {}
    for joint in joints.values():
        for end in ("parent", "child"):
            name = attribute(_one(joint, end), "link")
            if name not in links:
                raise DescriptionError(f"{label(joint)}: no {end} link {shorten(name)}; {did_you_mean(name, links)}")
        child = attribute(_one(joint, "child"), "link")
        if child in carrier:
            raise DescriptionError(
                f"{label(links[child])}: it is the child of {label(carrier[child])} and of {label(joint)}; a URDF "
                "is a tree (<loop> elements close loops, or use MJCF or a TOML description)"
            )
        carrier[child] = joint
    return carrier


def _poses(ground: str, joints: Mapping[str, Element], offsets: Mapping[str, Real]) -> dict[str, Pose]:
    """Pose of every link that the ground leads to, all coordinates zero but those with offsets of mimic joints."""
    leaving: dict[str, list[Element]] = {}
    for joint in joints.values():
        leaving.setdefault(attribute(_one(joint, "parent"), "link"), []).append(joint)
    poses, front = {ground: Pose()}, [ground]
    while front:
        parent = front.pop()
        for joint in leaving.get(parent, []):
            child = attribute(_one(joint, "child"), "link")
            poses[child] = poses[parent] @ _origin(joint) @ _displacement(joint, offsets)
            front.append(child)
    return poses


def _displacement(joint: Element, offsets: Mapping[str, Real]) -> Pose:
    """What a mimic joint does at its offset, in its own frame."""
    amount = offsets.get(joint.get("name", ""), ZERO[0])
    if amount == 0:
        return Pose()
    axis = _axis(joint)
    return Pose(UNITS, scaled(axis, amount)) if joint.get("type") == "prismatic" else Pose(about(axis, amount))


def _axis(joint: Element) -> Triple:
    found = list(elements(joint, "axis"))
    text = attribute(found[0], "xyz") if found else "1 0 0"
    return unit(_triple(text, f"{label(joint)}, axis"), f"{label(joint)}, axis")


def _origin(element: Element) -> Pose:
    found = list(elements(element, "origin"))
    if not found:
        return Pose()
    origin, where = found[0], f"{label(element)}, origin"
    check_attributes(origin, ("xyz", "rpy", "quat_xyzw"), where)
    place = _triple(origin.get("xyz", "0 0 0"), f"{where}, xyz")
    if "quat_xyzw" in origin.attrib:
        if "rpy" in origin.attrib:
            raise DescriptionError(f"{where}: expected one orientation, got rpy and quat_xyzw")
        qx, qy, qz, qw = map(real, numbers(origin.attrib["quat_xyzw"], f"{where}, quat_xyzw", 4))
        return Pose(from_quaternion([qw, qx, qy, qz], f"{where}, quat_xyzw"), place)
    roll, pitch, yaw = _triple(origin.get("rpy", "0 0 0"), f"{where}, rpy")
    x, y, z = UNITS
    return Pose(product(about(z, yaw), product(about(y, pitch), about(x, roll))), place)


def _triple(text: str, where: str) -> Triple:
    return triple(numbers(text, where, 3))


def _say_points(links: Iterable[Element], ledger: Ledger) -> None:
    """Links with a mass and no element for moments of inertia are points, as for what reads URDFs in ROS."""
    for link in links:
        inertial = first(link, "inertial")
        if inertial and list(elements(inertial[0], "mass")) and not list(elements(inertial[0], "inertia")):
            ledger.changed.append(f"{label(link)}: a mass without <inertia>: a point, as for ROS")


def _check_mirrored(links: Iterable[Element], ledger: Ledger) -> None:
    """Say which inertias have other numbers below their diagonal than above it: these count, as in ROS."""
    for link in links:
        for moments in (m for inertial in elements(link, "inertial") for m in elements(inertial, "inertia")):
            for key in (key for key in MIRRORED if key in moments.attrib):
                above = f"{key[0]}{key[2]}{key[1]}"
                where = f"{label(link)}, inertia"
                own, other = (number(moments.get(k, "0"), f"{where}, {k}") for k in (key, above))
                if own != other:
                    ledger.changed.append(f"{where}: {key} is {own}, its mirror image {above} {other}, which counts")


def _body(link: Element, pose: Pose) -> RawBody:
    name = attribute(link, "name")
    if not list(elements(link, "inertial")):
        return RawBody(name)
    inertial = _one(link, "inertial")
    where = f"{label(link)}, inertial"
    mass = triple([number(attribute(_one(inertial, "mass", where), "value"), f"{where}, mass"), 0, 0])[0]
    found = list(elements(inertial, "inertia"))
    moments = found[0] if found else Element("inertia")  # a point, as `_say_points` says
    keys = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
    check_attributes(moments, (*keys, *MIRRORED), f"{where}, inertia")
    xx, xy, xz, yy, yz, zz = (number(moments.get(key, "0"), f"{where}, {key}") for key in keys)
    matrix: Rotation = (triple([xx, xy, xz]), triple([xy, yy, yz]), triple([xz, yz, zz]))
    if mass == 0 and not any(entry for row in matrix for entry in row):
        return RawBody(name)
    frame = pose @ _origin(inertial)
    slack = left_open([xx, yy, zz], [xy, xz, yz])
    return RawBody(name, mass, frame.translation, turned_inertia(frame.rotation, matrix), left_open=slack)


def _joint(joint: Element, poses: Mapping[str, Pose], driven: Sequence[str], offsets: Mapping[str, Real]) -> RawJoint:
    name = attribute(joint, "name")
    kind = attribute(joint, "type")
    if kind not in TYPES:
        raise DescriptionError(
            f"{label(joint)}: joints of type {shorten(kind)} are not supported; {did_you_mean(kind, TYPES)}"
        )
    parent, child = (attribute(_one(joint, end), "link") for end in ("parent", "child"))
    pose = poses[child]
    count = JOINT_TYPES[TYPES[kind]].axes
    axes = (pose.direction(_axis(joint)),) if count == 1 else tuple(pose.direction(u) for u in UNITS[:count])
    given = offsets.get(name, ZERO[0])
    return RawJoint(
        name, TYPES[kind], parent, child, pose.translation, axes, driven=(0,) if name in driven else (),
        reference=(given,) if given != 0 else (),
    )  # fmt: skip


def _driven(
    root: Element, joints: Mapping[str, Element], mimics: Mapping[str, object], ledger: Ledger
) -> tuple[list[str], list[str]]:
    """Names of the driven joints, and a note about how they were found."""
    single = [name for name, j in joints.items() if j.get("type") in SINGLE and name not in mimics]
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
    idle_joints = [name for name in single if name not in named]  # one of them may be meant by a name of nothing
    for name in [name for name in named if name not in joints]:
        if idle_joints:
            ledger.lost(f"drive of {shorten(name)}, which is no joint of the file ({did_you_mean(name, joints)})")
        else:
            ledger.passed(f"drive of {shorten(name)}, which is no joint of the file")
    named = [name for name in named if name in joints]
    idle = [name for name in named if name not in single]
    if idle:
        ledger.passed("drives of joints that have not one freedom or mimic another", len(idle))
    notes = ["not taken over: drives of joints that have not one freedom: " + ", ".join(idle)] if idle else []
    return [name for name in named if name in single], notes


def _left_out(result: Draft, root: Element, links: Iterable[Element], joints: Iterable[Element]) -> None:
    """What of the file a mechanism does not hold: pictures, contacts, sensors, plugins, and whatever is not known."""
    for element in elements(root):
        if element.tag in WITH_INFLUENCE:
            result.ledger.lost(f"<{_short(element)}>")
        elif element.tag not in READ:
            result.ledger.passed(f"<{_short(element)}>")
        elif element.tag == "gazebo" and not any(True for _ in elements(element, "joint")):
            result.ledger.passed("<gazebo>")
    for link in links:
        for element in elements(link):
            if element.tag != "inertial":
                result.ledger.passed(f"<{_short(element)}> of links")
        more = len(list(elements(link, "inertial"))) - 1
        if more > 0:
            result.ledger.passed("a second <inertial> of a link: the first one counts", more)
    for joint in joints:
        for tag in ONCE:
            more = len(list(elements(joint, tag))) - 1
            if more > 0:
                result.ledger.passed(f"a second <{tag}> of a joint: the first one counts", more)
        if joint.get("type") == "fixed" and any(True for _ in elements(joint, "mimic")):
            result.ledger.passed("<mimic> of fixed joints")
        for element in elements(joint):
            if element.tag not in IN_JOINT:
                result.ledger.passed(f"<{_short(element)}> of joints")


def _short(element: Element) -> str:
    return element.tag.rpartition("}")[2][:40]
