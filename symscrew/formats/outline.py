"""What a file of another format says, before it becomes a `Mechanism`: bodies, elementary joints, points.

Everything is in absolute axes in the reference configuration, with 50 digits, under the file's own names.
`mechanism` turns it into a validated mechanism: names that are none of ours are changed, and chains of
elementary joints that `symscrew` writes for a joint with several freedoms (`hip.0`, `hip.1` ...) become that
joint again. Any other chain stays one, over bodies without mass.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from symscrew.description import RESERVED, Mechanism, MechanismBuilder, taken_as_file
from symscrew.errors import DescriptionError
from symscrew.formats.geometry import (
    UNITS,
    ZERO,
    Real,
    Rotation,
    Triple,
    cross,
    dot,
    exact,
    exact_matrix,
    exact_vector,
    length,
    minus,
    plus,
    scaled,
)

NEAR = 1e-12
"""Below this, lengths [m], sines of angles and differences of unit vectors count as zero."""
POINT_MASS = 1e-15
"""Inertia over mass [m^2] below which a body of a file is a point: what rounding leaves of a zero."""


@dataclass(frozen=True)
class RawBody:
    """A body: mass [kg], centre of mass [m] and inertia about it, or None for a body without mass."""

    name: str
    mass: Real | None = None
    com: Triple | None = None
    inertia: Rotation | None = None


@dataclass(frozen=True)
class RawJoint:
    """A joint of one of our types; `reference` are the coordinates' values in the reference configuration."""

    name: str
    type: str
    parent: str
    child: str
    point: Triple
    axes: tuple[Triple, ...] = ()
    pitch: Real | None = None
    driven: tuple[int, ...] = ()
    reference: tuple[Real, ...] = ()


@dataclass
class Outline:
    """The contents of a file; a reader fills it from top to bottom.

    `notes` say what the file holds that a mechanism does not: for people, nothing depends on them.
    """

    name: str
    ground: str
    origin: str
    description: str = ""
    platform: str | None = None
    characteristic_length: Real | None = None
    bodies: list[RawBody] = field(default_factory=list)
    joints: list[RawJoint] = field(default_factory=list)
    points: list[tuple[str, str, Triple]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def mechanism(outline: Outline) -> Mechanism:
    """The validated mechanism; raises DescriptionError."""
    if not outline.joints:
        raise DescriptionError(f"{outline.origin}: it has no joints; expected at least one moving body")
    bodies, joints = _merged(outline)
    named_bodies = safe_names([outline.ground, *(body.name for body in bodies)])
    named_joints = safe_names(joint.name for joint in joints)
    named_points = safe_names(name for name, _, _ in outline.points)
    renamed = [f"{old} -> {new}" for names in (named_bodies, named_joints) for old, new in names.items() if old != new]
    notes = [*outline.notes, *(["names: " + ", ".join(renamed)] if renamed else [])]
    builder = MechanismBuilder(
        _mechanism_name(outline.name),
        ground=named_bodies[outline.ground],
        platform=named_bodies.get(outline.platform) if outline.platform else None,
        description=printable(outline.description)[:4000],
        source=printable("; ".join([outline.origin, *notes]))[:4000],
        characteristic_length=None if outline.characteristic_length is None else exact(outline.characteristic_length),
    )
    for body in bodies:
        if body.mass is None or body.com is None or body.inertia is None:
            builder.body(named_bodies[body.name])
        else:
            builder.body(
                named_bodies[body.name],
                mass=exact(body.mass),
                com=exact_vector(body.com),
                inertia=exact_matrix(_without_rounding(body.mass, body.inertia)),
            )
    for joint in joints:
        builder.joint(
            named_joints[joint.name],
            joint.type,
            parent=named_bodies[joint.parent],
            child=named_bodies[joint.child],
            point=exact_vector(joint.point),
            axes=[exact_vector(axis) for axis in joint.axes] or None,
            pitch=None if joint.pitch is None else exact(joint.pitch),
            driven=joint.driven,
            reference=[exact(value) for value in joint.reference] if any(joint.reference) else None,
        )
    for name, body_name, place in outline.points:
        builder.point(named_points[name], body=named_bodies[body_name], at=exact_vector(place))
    return builder.build()


def _without_rounding(mass: Real, inertia: Rotation) -> Rotation:
    """The inertia, or zero where it is what rounding leaves of that."""
    largest = max(abs(entry) for row in inertia for entry in row)
    return (ZERO, ZERO, ZERO) if 0 < largest < POINT_MASS * mass else inertia


def safe_names(names: Iterable[str]) -> dict[str, str]:
    """A file's names -> ours: letters, digits and underscores, all different, no keywords.

    >>> safe_names(["hip-1", "hip_1", "2nd", "for"])
    {'hip-1': 'hip_1_2', 'hip_1': 'hip_1', '2nd': 'n2nd', 'for': 'for_'}
    """
    wanted = {name: _identifier(name) for name in names}
    taken = {name for name, new in wanted.items() if name == new}
    result = {}
    for name, new in wanted.items():
        chosen, count = new, 2
        while name != new and chosen in taken:
            chosen, count = f"{new[:55]}_{count}", count + 1
        taken.add(chosen)
        result[name] = chosen
    return result


def _identifier(name: str) -> str:
    text = re.sub(r"[^A-Za-z0-9_]", "_", name)[:60]
    text = text if re.match(r"[A-Za-z]", text) else f"n{text}"
    return f"{text}_" if text in RESERVED else text


def _mechanism_name(name: str) -> str:
    new = _identifier(name)
    return f"{new}_" if taken_as_file(new) else new


def printable(text: str) -> str:
    """A file's text as a description may hold it."""
    return re.sub(r"[\x00-\x1f\x7f\u2028\u2029\\]|\*/|/\*|\?\?", " ", text)


def fresh(name: str, used: Iterable[str]) -> str:
    """`name`, or with the first number that makes it differ from all used ones."""
    known = set(used)
    chosen, count = name, 2
    while chosen in known:
        chosen, count = f"{name}_{count}", count + 1
    return chosen


# -- chains that stand for a joint with several freedoms -----------------------------------------------


def _merged(outline: Outline) -> tuple[list[RawBody], list[RawJoint]]:
    """Bodies and joints, chains `stem.0`, `stem.1` ... over bodies without mass as one joint where they are one."""
    massless = {body.name for body in outline.bodies if body.mass is None}
    used = [end for joint in outline.joints for end in (joint.parent, joint.child)]
    marked = {body for _, body, _ in outline.points} | {outline.ground, outline.platform}
    inner = {name for name in massless if used.count(name) == 2 and name not in marked}
    after = {joint.parent: joint for joint in outline.joints if joint.parent in inner}
    dropped: set[str] = set()
    joints, removed = [], set()
    for joint in outline.joints:
        if joint.name in removed:
            continue
        chain = [joint]
        stem = joint.name.removesuffix(".0")
        while stem != joint.name and chain[-1].child in after:
            following = after[chain[-1].child]
            if following.name != f"{stem}.{len(chain)}":
                break
            chain.append(following)
        whole = one_joint(chain, stem) if len(chain) > 1 else None
        if whole is None:
            joints.append(joint)
            continue
        joints.append(whole)
        removed |= {part.name for part in chain}
        dropped |= {part.child for part in chain[:-1]}
    return [body for body in outline.bodies if body.name not in dropped], joints


def one_joint(chain: Sequence[RawJoint], name: str) -> RawJoint | None:
    """The joint of several freedoms that a chain of elementary joints is, or None."""
    kinds = "".join(joint.type for joint in chain)
    axes = [axis for joint in chain for axis in joint.axes]
    reference = tuple(value for joint in chain for value in joint.reference or (ZERO[0],))
    made = RawJoint(
        name, "", chain[0].parent, chain[-1].child, chain[-1].point,
        driven=tuple(k for k, joint in enumerate(chain) for _ in joint.driven), reference=reference,
    )  # fmt: skip
    if kinds == "RR" and _sine(axes[0], axes[1]) > NEAR:
        meeting = _meeting(chain[0].point, axes[0], chain[1].point, axes[1])
        return None if meeting is None else dataclasses.replace(made, type="U", point=meeting, axes=(axes[0], axes[1]))
    if kinds == "PR" and _sine(axes[0], axes[1]) < NEAR and dot(axes[0], axes[1]) > 0:
        return dataclasses.replace(made, type="C", axes=(axes[1],))
    if any(reference):
        return None
    if kinds == "PPR" and _same_triad(axes, (*plane_axes(axes[2]), axes[2])):
        return dataclasses.replace(made, type="E", axes=(axes[2],), reference=())
    if kinds == "PPPS" and _same_triad(axes, UNITS):
        spherical = tuple(3 + k for k in chain[3].driven)
        driven = tuple(k for k in made.driven if k < 3) + spherical
        return dataclasses.replace(made, type="free", driven=driven, reference=())
    return None


def plane_axes(normal: Triple) -> tuple[Triple, Triple]:
    """The two sliding axes of a planar joint: `symscrew.reference.maximal_coordinates.plane_axes` with 50 digits."""
    sizes = [abs(entry) for entry in normal]
    nearest = UNITS[sizes.index(min(sizes))]
    rest = minus(nearest, scaled(normal, dot(nearest, normal)))
    first = scaled(rest, 1 / length(rest))
    return first, cross(normal, first)


def _same_triad(axes: Sequence[Triple], wanted: Sequence[Triple]) -> bool:
    return all(length(minus(a, b)) < NEAR for a, b in zip(axes, wanted, strict=True))


def _sine(a: Triple, b: Triple) -> Real:
    return length(cross(a, b))


def _meeting(p: Triple, a: Triple, q: Triple, b: Triple) -> Triple | None:
    """Where the lines p + s a and q + t b meet, or None."""
    normal = cross(a, b)
    gap = minus(q, p)
    along = dot(cross(gap, b), normal) / dot(normal, normal)
    meeting = plus(p, scaled(a, along))
    miss = dot(gap, normal) / length(normal)
    return meeting if abs(miss) < NEAR * max(1, length(gap)) else None
