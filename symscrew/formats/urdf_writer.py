"""A mechanism without loops as URDF.

    Mechanism --elementary_chains--> branches in order --a <joint> and a <link> each--> text

Every link has absolute axes in the configuration where all coordinates have their reference values, and its
origin at its joint. Coordinates keep their values: where the reference is not zero, the joint's origin is moved
back by it. A joint with several freedoms becomes a chain `name.0`, `name.1` ... over links without inertia;
a spherical joint three continuous joints about x, y, z (singular where the second is +-90 degrees).
Prismatic joints get wide limits, which the format demands. Driven joints get a transmission.
"""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from symscrew.description import NO_MOTION, Body, Coupling, Mechanism, rotation
from symscrew.errors import DescriptionError
from symscrew.formats.elementary_chains import Array, Branch, Step, chains, numbers, steps
from symscrew.formats.file_names import fresh
from symscrew.formats.imported import Beside
from symscrew.formats.mjcf_couplings import reference_value
from symscrew.formats.safe_xml import decimals, text_of
from symscrew.formats.urdf_effects import add_effects
from symscrew.formats.urdf_forces import WIDE
from symscrew.reference import rotation_about

UPRIGHT = 1e-12
"""Cosine of the pitch below which roll and yaw turn about the same axis: then roll is 0 and yaw takes both. Above it
both are well defined, to the digits that the cosine has."""
TYPES = {"R": "continuous", "P": "prismatic"}


def print_urdf(mechanism: Mechanism, beside: Beside | None = None) -> str:
    """The text of the URDF, with the forces and limits beside the mechanism where they are given.

    Raises:
        DescriptionError: the mechanism has loops, or a joint that the format does not know.
    """
    tree = chains(mechanism)
    if tree.cut:
        names = ", ".join(joint.name for joint in tree.cut)
        raise DescriptionError(f"{mechanism.name}: a URDF is a tree, but loops close at {names}; write MJCF (.xml)")
    root = Element("robot", name=mechanism.name)
    SubElement(root, "link", name=mechanism.ground)
    origins = {mechanism.ground: np.zeros(3)}
    used = list(mechanism.bodies)
    driven: list[str] = []
    for branch in tree.branches:
        origins[branch.body] = numbers(mechanism, branch.joint.point)
        shift = origins[branch.body] - origins[branch.parent]
        driven += _add_joint(root, mechanism, branch, shift=shift, used=used)
        _add_link(root, mechanism, mechanism.bodies[branch.body], origins[branch.body])
    for coupling in mechanism.couplings.values():
        _add_mimic(root, mechanism, coupling, driven)
    if not driven:  # a file without both would say that every joint is driven
        SubElement(root, "ros2_control", name="passive", type="system")
    for name in driven:
        transmission = SubElement(root, "transmission", name=f"drive_{name}")
        SubElement(transmission, "type").text = "transmission_interface/SimpleTransmission"
        SubElement(
            SubElement(transmission, "joint", name=name), "hardwareInterface"
        ).text = "hardware_interface/EffortJointInterface"
        SubElement(SubElement(transmission, "actuator", name=f"motor_{name}"), "mechanicalReduction").text = "1"
    if beside is not None:
        add_effects(root, mechanism, beside)
    head = [f"{mechanism.name}, {mechanism.description}", "Written by symscrew. Units m, kg, rad, s."]
    return text_of(root, head)


def _add_mimic(root: Element, mechanism: Mechanism, coupling: Coupling, driven: Sequence[str]) -> None:
    """One joint that mimics another, by a factor and what is left of its value in the reference configuration.

    Raises:
        DescriptionError: the coupling has another form, or both joints are driven or mimic others.
    """
    made = {joint.attrib["name"]: joint for joint in root if joint.tag == "joint"}
    names = [mechanism.joints[t.joint].kind.motion_names(t.joint)[t.motion] for t in coupling.terms]
    factors = [float(mechanism.number(t.coefficients[0])) for t in coupling.terms]
    free = [k for k, name in enumerate(names) if name not in driven and made[name].find("mimic") is None]
    if not coupling.linear or len(names) > 2 or not free or (len(names) == 2 and len(set(names)) == 1):
        raise DescriptionError(
            f"couplings.{coupling.name}: a URDF holds joints that mimic one other joint by a factor; write MJCF (.xml)"
        )
    k = free[-1]
    other = names[1 - k] if len(names) == 2 else next(name for name in made if name != names[k])
    factor = -factors[1 - k] / factors[k] if len(names) == 2 else 0.0
    values = [reference_value(mechanism, term) for term in coupling.terms]
    offset = values[k] - (factor * values[1 - k] if len(names) == 2 else 0.0)
    mimic = SubElement(made[names[k]], "mimic", joint=other, multiplier=decimals([factor]))
    if offset:
        mimic.set("offset", decimals([offset]))


def _add_joint(root: Element, mechanism: Mechanism, branch: Branch, *, shift: Array, used: list[str]) -> list[str]:
    """The joint or chain of joints that carries a body; the names of the driven ones.

    `shift`: from the parent's origin to the body's [m]; names of new links are added to `used`.
    """
    joint, driven = branch.joint, []
    if joint.kind.helical:
        raise DescriptionError(f"joints.{joint.name}: a URDF has no helical joint; write MJCF (.xml)")
    parts = _parts(mechanism, branch)
    link = branch.parent
    for k, step in enumerate(parts):
        name = branch.body
        if k + 1 < len(parts):
            name = fresh(f"{branch.body}_{step.name.replace('.', '_')}", used)
            used.append(name)
        whole = "floating" if joint.kind.unconstrained else "fixed"
        made = SubElement(root, "joint", name=step.name, type=TYPES.get(step.motion.kind, whole))
        place, turn = shift, np.zeros(3)
        if step.motion.prismatic:
            place = shift - step.reference * step.axis
        elif step.motion.revolute and step.reference:
            turn = _roll_pitch_yaw(rotation_about(-step.reference * step.axis))
        SubElement(made, "origin", xyz=decimals(place), rpy=decimals(turn))
        SubElement(made, "parent", link=link)
        SubElement(made, "child", link=name)
        if step.motion.kind in TYPES:
            SubElement(made, "axis", xyz=decimals(step.axis))
        if step.motion.prismatic:
            SubElement(made, "limit", lower=f"-{WIDE}", upper=f"{WIDE}", effort=f"{WIDE}", velocity=f"{WIDE}")
        if k + 1 < len(parts):
            SubElement(root, "link", name=name)
        driven += [step.name] if step.driven else []
        link, shift = name, np.zeros(3)
    return driven


def _parts(mechanism: Mechanism, branch: Branch) -> list[Step]:
    """The URDF joints of a joint, each with one freedom, or floating or fixed."""
    joint = branch.joint
    free = joint.kind.unconstrained
    if free or not joint.kind.freedom:
        if joint.driven:
            raise DescriptionError(f"joints.{joint.name}: a URDF cannot drive a floating joint; leave out 'driven'")
        if free and branch.inverted:
            raise DescriptionError(
                f"joints.{joint.name}: a floating joint must lead away from the ground; swap its ends"
            )
        return [Step(joint.name, NO_MOTION, np.zeros(3), 0.0, 0.0, ())]
    result = []
    for step in steps(mechanism, joint, inverted=branch.inverted):
        if step.motion.spherical:
            result += [
                Step(f"{joint.name}.{'xyz'[i]}", rotation(), axis, 0.0, 0.0, (0,) if i in step.driven else ())
                for i, axis in enumerate(np.eye(3))
            ]
        else:
            result.append(step)
    return result


def _add_link(root: Element, mechanism: Mechanism, body: Body, origin: Array) -> None:
    link = SubElement(root, "link", name=body.name)
    if body.mass is None or body.com is None or body.inertia is None:
        return
    inertial = SubElement(link, "inertial")
    SubElement(inertial, "origin", xyz=decimals(numbers(mechanism, body.com) - origin), rpy="0 0 0")
    SubElement(inertial, "mass", value=decimals([float(mechanism.number(body.mass))]))
    rows = [numbers(mechanism, row) for row in body.inertia]
    entries = {f"i{'xyz'[i]}{'xyz'[j]}": decimals([rows[i][j]]) for i in range(3) for j in range(i, 3)}
    SubElement(inertial, "inertia", entries)


def _roll_pitch_yaw(rotation: Array) -> Array:
    """Angles with rotation = Rz(yaw) Ry(pitch) Rx(roll); roll 0 where pitch is +-90 degrees."""
    pitch = np.arctan2(-rotation[2, 0], np.hypot(rotation[0, 0], rotation[1, 0]))
    if np.hypot(rotation[0, 0], rotation[1, 0]) < UPRIGHT:
        return np.array([0.0, pitch, np.arctan2(-rotation[0, 1], rotation[1, 1])])
    return np.array([np.arctan2(rotation[2, 1], rotation[2, 2]), pitch, np.arctan2(rotation[1, 0], rotation[0, 0])])
