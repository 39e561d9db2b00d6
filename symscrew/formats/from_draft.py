"""A draft as a validated mechanism and what is beside it.

Names that are none of ours are changed, chains become one joint where they can.

Draft --merged_joints--> bodies, joints --file_names--> names --MechanismBuilder--> Mechanism
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.errors import DescriptionError
from symscrew.formats.beside import (
    account_of,
    check_forces,
    cords_of,
    drags_of,
    forces_of,
    limits_of,
    loads_of,
    starts_of,
    tendons_of,
)
from symscrew.formats.draft import Draft, RawBody, RawJoint
from symscrew.formats.file_names import fresh, mechanism_name, printable, safe_names
from symscrew.formats.held_platform import held_platform
from symscrew.formats.idle_spins import bars, spinning_rods
from symscrew.formats.import_options import ImportOptions
from symscrew.formats.imported import Imported
from symscrew.formats.merged_joints import merged
from symscrew.formats.physical_inertias import POINT_MASS, physical
from symscrew.formats.rigid_displacements import (
    ALL_DIGITS,
    DIGITS,
    ZERO,
    Real,
    Rotation,
    Triple,
    exact,
    exact_matrix,
    exact_vector,
)
from symscrew.formats.rigid_groups import settle_rigid_groups

LONGEST_TEXT = 4000
"""Letters of a description or source, as in descriptions; a file's longer ones are cut off."""


def imported(draft: Draft, options: ImportOptions) -> Imported:
    """The validated mechanism with what is beside it; raises DescriptionError."""
    if not draft.joints:
        raise DescriptionError(f"{draft.origin}: it has no joints; expected at least one moving body")
    settle_rigid_groups(draft)
    bodies, joints, parts = merged(draft)
    whole = {name: stem for name, (stem, _) in {**draft.parts_of, **parts}.items()}
    if options.bars:
        bodies, joints = bars(draft, bodies, joints, whole)
    rods = spinning_rods(draft, bodies, joints, whole)
    draft.platform = draft.platform or held_platform(draft.ground, joints)
    named_bodies = safe_names([draft.ground, *(body.name for body in bodies)])
    named_joints = safe_names(joint.name for joint in joints)
    renamed = [f"{old} -> {new}" for names in (named_bodies, named_joints) for old, new in names.items() if old != new]
    bodies = [physical(body, draft.ledger, repair=options.repair) for body in bodies]
    check_forces(draft)
    account = replace(account_of(draft), rods=tuple(named_bodies[name] for name in rods))
    if account.influence and not options.accept:
        raise DescriptionError(
            f"what numbers depend on would be left out: {', '.join(account.influence)}; accept that with --accept "
            "(symscrew convert FILE --accept --out NAME.toml), or remove it from the file"
        )
    notes = [*account.lines()[1:], *draft.notes, *(["names: " + ", ".join(renamed)] if renamed else [])]
    made = _mechanism(
        draft,
        bodies,
        joints,
        names=(named_bodies, named_joints),
        notes=notes,
        digits=ALL_DIGITS if options.bars else DIGITS,
    )
    places = {**{joint.name: (joint.name, None) for joint in joints}, **draft.parts_of, **parts}
    kinds = {joint.name: made.joints[named_joints[joint.name]].kind for joint in joints}

    def named(joint: str) -> tuple[str, int | None]:
        whole, freedom = places[joint]
        return named_joints[whole], freedom if kinds[whole].freedom > 1 else None

    return Imported(
        made,
        forces_of(draft, named)
        + loads_of(draft, safe_names(name for name, _, _ in draft.points))
        + drags_of(draft, named_bodies)
        + cords_of(draft, safe_names(name for name, _, _ in draft.points))
        + tendons_of(draft, safe_names(name for name, _, _ in draft.points)),
        {named(joint)[0]: limits_of(found) for joint, found in draft.limits.items() if joint in places},
        {name: tuple(map(float, values)) for name, values in draft.configurations.items()},
        account,
        None if draft.gravity is None else tuple(map(float, draft.gravity)),
        starts_of(draft.starts, named),
        starts_of(draft.start_rates, named),
    )


def _mechanism(
    draft: Draft,
    bodies: Sequence[RawBody],
    joints: Sequence[RawJoint],
    *,
    names: tuple[Mapping[str, str], Mapping[str, str]],
    notes: Sequence[str],
    digits: int,
) -> Mechanism:
    def number(value: Real) -> Decimal:
        return exact(value, digits=digits)

    def vector(values: Triple) -> list[Decimal]:
        return exact_vector(values, digits=digits)

    named_bodies, named_joints = names
    named_points = safe_names(name for name, _, _ in draft.points)
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
                mass=number(body.mass),
                com=vector(body.com),
                inertia=exact_matrix(_without_rounding(body.mass, body.inertia), digits=digits),
            )
    for joint in joints:
        builder.joint(
            named_joints[joint.name],
            joint.type,
            parent=named_bodies[joint.parent],
            child=named_bodies[joint.child],
            point=vector(joint.point),
            axes=[vector(axis) for axis in joint.axes] or None,
            pitch=None if joint.pitch is None else number(joint.pitch),
            driven=joint.driven,
            reference=[number(value) for value in joint.reference] if any(joint.reference) else None,
        )
    for name, body_name, place in draft.points:
        builder.point(named_points[name], body=named_bodies[body_name], at=vector(place))
    for coupling, name in zip(draft.couplings, _coupling_names(draft, named_joints.values()), strict=True):
        terms = {named_joints[joint]: [number(c) for c in powers] for joint, powers in coupling.terms.items()}
        builder.coupling(name, terms=terms)
    return builder.build()


def _coupling_names(draft: Draft, taken: Iterable[str]) -> list[str]:
    """A name for each coupling that no joint has."""
    wanted = [f"{c.name}_coupling" if c.name in set(taken) else c.name for c in draft.couplings]
    made: list[str] = []
    for name in wanted:
        made.append(fresh(next(iter(safe_names([name]).values())), [*made, *taken]))
    return made


def _without_rounding(mass: Real, inertia: Rotation) -> Rotation:
    """The inertia, or zero where it is what rounding leaves of that."""
    largest = max(abs(entry) for row in inertia for entry in row)
    return (ZERO, ZERO, ZERO) if 0 < largest < POINT_MASS * mass else inertia
