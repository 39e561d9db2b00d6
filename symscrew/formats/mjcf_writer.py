"""A mechanism as MJCF, loops as equality constraints.

    Mechanism --elementary_chains--> tree of bodies, cut joints --<body>, <equality>, <actuator>--> text

Bodies have absolute axes in the reference configuration and their origin at the joint that carries them.
Joints with several freedoms are several joints of one body: `name.0`, `name.1` ...; a helical joint is a slide
and a hinge coupled by an equality. The tree takes those joints first whose loop MuJoCo could not close by an
equality; of the others a spherical joint becomes a connect, a revolute joint two connects on its axis, a
fixed joint a weld. Where only other joints are left, or a driven one, the joint carries a copy of its child
without inertia that is welded to it.

Hinges and slides over bodies without mass that only carry the next one, called as the reader calls them, are joints of
one body. MuJoCo refuses other bodies without mass or with a singular inertia: theirs are raised to 1e-9 of the
mechanism's mass (and of mass times length^2), and the file's head names them. Driven freedoms get a motor, named points
a site. The thin capsules are for the viewer: they have neither mass nor contacts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from symscrew.description import Joint, Mechanism
from symscrew.formats.elementary_chains import Array, Branch, Chains, Step, chains, numbers, steps
from symscrew.formats.file_names import fresh
from symscrew.formats.imported import Beside
from symscrew.formats.mjcf_couplings import add_couplings, tied_joints
from symscrew.formats.mjcf_effects import add_effects, joints_acted_on
from symscrew.formats.mjcf_pulleys import as_tendons
from symscrew.formats.mjcf_settings import FIXED
from symscrew.formats.rigid_displacements import CONTEXT
from symscrew.formats.safe_xml import decimals, text_of
from symscrew.reference import NumericMechanism, numeric

SMALL = 1e-9
"""Of the mechanism's mass (and of mass times length^2): what lighter bodies are raised to, because MuJoCo refuses
bodies without mass. Small enough to be lost in the motion, large enough for its solver; the file's head names them."""
CAPSULE = 0.02
"""Radius of the capsules for the viewer, of the mechanism's size."""
SHORTEST_CAPSULE = 1e-3
"""Of the mechanism's size; shorter ones are not drawn, as MuJoCo refuses those of length zero."""
WORLD = "world"
RANKS = {"R": 1, "S": 2}
"""Order in which joints are left for closing loops; all others, rank 0, come into the tree first."""
TYPES = {"R": "hinge", "P": "slide", "S": "ball"}


@dataclass
class Writing:
    """The file so far: elements by body, their origins, sections, and which bodies got a small inertia."""

    mechanism: Mechanism
    numbers: NumericMechanism
    names: dict[str, str]
    elements: dict[str, Element]
    origins: dict[str, Array]
    equality: Element
    actuator: Element
    raised: list[str] = field(default_factory=list)

    @property
    def mass(self) -> float:
        """Mass of the whole mechanism, 1 if it has none [kg]."""
        return float(self.numbers.mass.sum()) or 1.0


def print_mjcf(mechanism: Mechanism, beside: Beside | None = None) -> str:
    """The text of the MJCF of any mechanism, with the forces and limits beside it where they are given."""
    root = Element("mujoco", model=mechanism.name)
    SubElement(root, "compiler", angle="radian", inertiafromgeom="false", autolimits="true")
    SubElement(root, "option", gravity="0 0 -9.81")
    custom = SubElement(root, "custom")
    for key, value in (("ground", mechanism.ground), ("platform", mechanism.platform)):
        if value:
            SubElement(custom, "text", name=f"symscrew_{key}", data=value)
    if mechanism.description:
        SubElement(custom, "text", name="symscrew_description", data=mechanism.description)
    if mechanism.characteristic_length is not None:
        length = decimals([float(mechanism.number(mechanism.characteristic_length))])
        SubElement(custom, "text", name="symscrew_characteristic_length", data=length)
    world = SubElement(root, "worldbody")
    equality, actuator = SubElement(root, "equality"), SubElement(root, "actuator")
    taken = [WORLD]
    names = {mechanism.ground: WORLD}
    for body in mechanism.bodies:
        if body != mechanism.ground:
            names[body] = fresh(body, taken)
            taken.append(names[body])
    origins = {mechanism.ground: np.zeros(3)}
    writing = Writing(mechanism, numeric(mechanism), names, {mechanism.ground: world}, origins, equality, actuator)
    tied = tied_joints(mechanism) | (joints_acted_on(beside) if beside else set())
    tree = chains(mechanism, lambda joint: -1 if joint.name in tied else _rank(joint))
    over = _over_nothing(mechanism, tree)
    inside = {branch.body for some in over.values() for branch in some}
    for branch in tree.branches:
        if branch.body not in inside:
            _add_body(writing, branch, over.get(branch.body, ()))
        if not branch.joint.kind.freedom and branch.joint.name != f"{names[branch.body]}_fixed":
            SubElement(custom, "text", name=f"{FIXED}{names[branch.body]}", data=branch.joint.name)
    for joint in tree.cut:
        _close(writing, joint)
    add_couplings(mechanism, root, equality)
    for body in writing.elements:
        _add_capsules(writing, body)
    for point in mechanism.points.values():
        place = numbers(mechanism, point.at) - writing.origins[point.body]
        SubElement(writing.elements[point.body], "site", name=point.name, pos=decimals(place))
    if beside is not None:
        add_effects(root, mechanism, beside, names)
        folded = as_tendons(root, mechanism)
        writing.raised = [body for body in writing.raised if names[body] not in folded]
    for section in (equality, actuator):
        if not len(section):
            root.remove(section)
    head = [f"{mechanism.name}, {mechanism.description}", "Written by symscrew. Units m, kg, rad, s."]
    if writing.raised:
        raised = ", ".join(writing.raised)
        head.append(f"Masses or moments raised to {SMALL:g} of the whole, because MuJoCo needs them: {raised}.")
    return text_of(root, head)


def _rank(joint: Joint) -> int:
    """Joints that no equality stands for come first into the tree, spherical ones last; none stands for a reference."""
    return 0 if joint.driven or _counted(joint) else RANKS.get(joint.type, 0)


def _counted(joint: Joint) -> bool:
    """Whether its coordinates do not count from zero in the reference configuration."""
    return any(value != 0 for value in joint.reference)


def _over_nothing(mechanism: Mechanism, tree: Chains) -> dict[str, list[Branch]]:
    """Body -> the branches inwards of its own that are joints of the same body in the file, outwards."""
    carried: dict[str, list[str]] = {}
    for branch in tree.branches:
        carried.setdefault(branch.parent, []).append(branch.body)
    seen = {point.body for point in mechanism.points.values()} | {mechanism.ground, mechanism.platform}
    seen |= {end for joint in tree.cut for end in (joint.parent, joint.child)}
    own = {branch.body: branch for branch in tree.branches}

    def simple(branch: Branch) -> bool:
        return (branch.joint.kind.hinge or branch.joint.kind.slider) and not branch.inverted

    found: dict[str, list[Branch]] = {}
    for branch in tree.branches:
        inner, at = list[Branch](), branch
        while simple(at) and at.parent in own and at.parent not in seen and carried[at.parent] == [at.body]:
            at = own[at.parent]
            if mechanism.bodies[at.body].mass is not None or not simple(at):
                break
            inner.insert(0, at)
        if inner and [b.body for b in inner] == [f"{branch.body}_{k}" for k in range(1, len(inner) + 1)]:
            found[branch.body] = inner
    return found


def _add_body(writing: Writing, branch: Branch, inner: Sequence[Branch]) -> None:
    """A body with its joint, and those of the branches inwards that are joints of the same body."""
    mechanism, parent = writing.mechanism, (inner[0] if inner else branch).parent
    point = numbers(mechanism, branch.joint.point)
    body = SubElement(writing.elements[parent], "body", name=writing.names[branch.body])
    body.set("pos", decimals(point - writing.origins[parent]))
    writing.elements[branch.body], writing.origins[branch.body] = body, point
    if mechanism.bodies[branch.body].mass is not None or branch.joint.kind.freedom:
        _add_inertial(writing, branch.body, point)  # without mass and fixed to another, it needs none
    for other in inner:
        _add_joints(writing, body, other.joint, inverted=False, floating=False)
        body[-1].set("pos", decimals(numbers(mechanism, other.joint.point) - point))
    alone = branch.joint.kind.unconstrained and branch.parent == mechanism.ground and not branch.inverted
    _add_joints(writing, body, branch.joint, inverted=branch.inverted, floating=alone)


def _add_joints(writing: Writing, body: Element, joint: Joint, *, inverted: bool, floating: bool) -> None:
    """The joints of one body, the motors of the driven ones, the coupling of a screw."""
    if floating:
        SubElement(body, "freejoint", name=joint.name)
        for index in joint.driven:
            _add_motor(writing, joint.name, index, 6)
        return
    for step in steps(writing.mechanism, joint, inverted=inverted):
        if step.motion.helical:
            _add_screw(writing, body, step)
            continue
        made = SubElement(body, "joint", name=step.name, type=TYPES[step.motion.kind])
        if step.motion.single:
            made.set("axis", decimals(step.axis))
        if step.reference:
            made.set("ref", decimals([step.reference]))
        for index in step.driven:
            _add_motor(writing, step.name, index, step.motion.freedom)


def _add_screw(writing: Writing, body: Element, step: Step) -> None:
    slide, hinge = f"{step.name}.0", f"{step.name}.1"
    SubElement(body, "joint", name=slide, type="slide", axis=decimals(step.axis))
    turning = SubElement(body, "joint", name=hinge, type="hinge", axis=decimals(step.axis))
    if step.reference:
        turning.set("ref", decimals([step.reference]))
    coefficients = decimals([0.0, step.pitch, 0.0, 0.0, 0.0])
    SubElement(writing.equality, "joint", name=step.name, joint1=slide, joint2=hinge, polycoef=coefficients)
    if step.driven:
        _add_motor(writing, hinge, 0, 1)


def _add_motor(writing: Writing, joint: str, index: int, size: int) -> None:
    name = f"{joint}_{index}" if size > 1 else joint
    where = {"jointinparent": joint} if size > 1 else {"joint": joint}  # of several freedoms as the parent carries them
    motor = SubElement(writing.actuator, "motor", {"name": name} | where)
    if size > 1:
        motor.set("gear", " ".join("1" if k == index else "0" for k in range(6)))


def _add_inertial(writing: Writing, body: str, origin: Array) -> None:
    index = writing.numbers.bodies.index(body)
    mass, com, inertia = (getattr(writing.numbers, key)[index] for key in ("mass", "com", "inertia"))
    least = SMALL * writing.mass
    largest = float(np.abs(inertia).max())
    axes = np.eye(3)
    principal = np.diag(inertia).copy()
    if np.abs(inertia - np.diag(principal)).max() > 0:
        principal, axes = _principal(inertia)
    com = com if mass > 0 else origin
    whole = np.sort(principal)
    # MuJoCo's own eigenvalues are good to an absolute 1e-12 only: principal moments are handed over
    floor = SMALL * largest if mass > 0 and largest > 0 else least * writing.numbers.length**2
    if mass < least or whole[0] < floor or whole[0] + whole[1] < whole[2]:
        writing.raised.append(body)
        mass, principal = max(mass, least), principal + floor
    inertial = SubElement(writing.elements[body], "inertial", pos=decimals(com - origin), mass=decimals([mass]))
    inertial.set("diaginertia", decimals(principal))
    if not np.array_equal(axes, np.eye(3)):
        inertial.set("quat", decimals(_quaternion(axes)))


def _principal(inertia: Array) -> tuple[Array, Array]:
    """Principal moments, ascending, and right-handed axes as columns; by long arithmetic the same on every machine."""
    moments, columns = CONTEXT.eigsy(CONTEXT.matrix(inertia.tolist()))
    axes = np.array(columns.tolist(), dtype=float).reshape(3, 3)
    return np.array([float(x) for x in moments]), axes * np.sign(np.linalg.det(axes))


def _quaternion(rotation: Array) -> Array:
    """The unit quaternion (w, x, y, z) of a rotation, accurate at every angle."""
    r = rotation
    trace = np.trace(r)
    outer = np.empty((4, 4))
    outer[0, 0] = 1 + trace
    outer[0, 1:] = outer[1:, 0] = [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]
    outer[1:, 1:] = r + r.T + (1 - trace) * np.eye(3)
    best = outer[np.argmax(np.diag(outer))]
    return np.asarray(best / np.sqrt((best * best).sum()))


def _close(writing: Writing, joint: Joint) -> None:
    """The equality that stands for a joint closing a loop."""
    point = numbers(writing.mechanism, joint.point)
    ends = [joint.parent, joint.child]
    kind = joint.kind
    if kind.freedom == 0:
        _add_equality(writing, "weld", joint.name, ends)
    elif kind.ball and not joint.driven:
        _add_equality(writing, "connect", joint.name, ends, anchor=point)
    elif kind.hinge and not joint.driven and not _counted(joint):
        # read back, the ground is the parent: the coordinate keeps its sign
        axis = numbers(writing.mechanism, joint.axes[0]) * (-1 if joint.child == writing.mechanism.ground else 1)
        for k, place in enumerate((point, point + writing.numbers.length * axis)):
            _add_equality(writing, "connect", f"{joint.name}.{k}", ends, anchor=place)
    else:
        copy = fresh(f"{joint.child}_copy", writing.names.values())
        writing.names[copy] = copy
        body = SubElement(writing.elements[joint.parent], "body", name=copy)
        body.set("pos", decimals(point - writing.origins[joint.parent]))
        writing.elements[copy], writing.origins[copy] = body, point
        least = SMALL * writing.mass
        moments = decimals([least * writing.numbers.length**2] * 3)
        SubElement(body, "inertial", pos="0 0 0", mass=decimals([least]), diaginertia=moments)
        writing.raised.append(copy)
        _add_joints(writing, body, joint, inverted=False, floating=False)
        _add_equality(writing, "weld", copy, [copy, joint.child])


def _add_equality(writing: Writing, kind: str, name: str, ends: Sequence[str], *, anchor: Array | None = None) -> None:
    """A connect at `anchor` [m, absolute], or a weld. Names of weld and bodies may be the same."""
    first, second = ends if writing.names[ends[0]] != WORLD else ends[::-1]
    made = SubElement(writing.equality, kind, name=name, body1=writing.names[first])
    if writing.names[second] != WORLD:
        made.set("body2", writing.names[second])
    if anchor is not None:
        made.set("anchor", decimals(anchor - writing.origins[first]))


def _add_capsules(writing: Writing, body: str) -> None:
    """Capsules from the body's origin to its other joints, for the viewer."""
    size = writing.numbers.length
    origin = writing.origins[body]
    for joint in writing.mechanism.joints.values():
        place = numbers(writing.mechanism, joint.point) - origin
        if body in (joint.parent, joint.child) and np.linalg.norm(place) > SHORTEST_CAPSULE * size:
            SubElement(
                writing.elements[body], "geom", type="capsule", size=decimals([CAPSULE * size]), mass="0", contype="0",
                conaffinity="0", fromto=decimals([0, 0, 0, *place]),
            )  # fmt: skip
