"""A draft as a validated mechanism: names that are none of ours are changed, chains become one joint where they can.

Draft --merged_joints--> bodies, joints --file_names--> names --MechanismBuilder--> Mechanism
"""

from __future__ import annotations

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.errors import DescriptionError
from symscrew.formats.draft import Draft
from symscrew.formats.file_names import mechanism_name, printable, safe_names
from symscrew.formats.merged_joints import merged
from symscrew.formats.rigid_displacements import ZERO, Real, Rotation, exact, exact_matrix, exact_vector

POINT_MASS = 1e-15
"""Inertia over mass [m^2] below which a body of a file is a point: what rounding leaves of a zero. A real body of that
size would be of 30 nm."""
LONGEST_TEXT = 4000
"""Letters of a description or source, as in descriptions; a file's longer ones are cut off."""


def mechanism(draft: Draft) -> Mechanism:
    """The validated mechanism; raises DescriptionError."""
    if not draft.joints:
        raise DescriptionError(f"{draft.origin}: it has no joints; expected at least one moving body")
    bodies, joints = merged(draft)
    named_bodies = safe_names([draft.ground, *(body.name for body in bodies)])
    named_joints = safe_names(joint.name for joint in joints)
    named_points = safe_names(name for name, _, _ in draft.points)
    renamed = [f"{old} -> {new}" for names in (named_bodies, named_joints) for old, new in names.items() if old != new]
    notes = [*draft.notes, *(["names: " + ", ".join(renamed)] if renamed else [])]
    builder = MechanismBuilder(
        mechanism_name(draft.name),
        ground=named_bodies[draft.ground],
        platform=named_bodies.get(draft.platform) if draft.platform else None,
        description=printable(draft.description)[:LONGEST_TEXT],
        source=printable("; ".join([draft.origin, *notes]))[:LONGEST_TEXT],
        characteristic_length=None if draft.characteristic_length is None else exact(draft.characteristic_length),
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
    for name, body_name, place in draft.points:
        builder.point(named_points[name], body=named_bodies[body_name], at=exact_vector(place))
    return builder.build()


def _without_rounding(mass: Real, inertia: Rotation) -> Rotation:
    """The inertia, or zero where it is what rounding leaves of that."""
    largest = max(abs(entry) for row in inertia for entry in row)
    return (ZERO, ZERO, ZERO) if 0 < largest < POINT_MASS * mass else inertia
