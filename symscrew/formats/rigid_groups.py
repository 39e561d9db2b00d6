"""Links of a file whose own inertia no body has, fixed to another link: what is rigid together has one inertia.

Numbers depend on the sum alone. Where a link has an inertia without mass, or principal moments that no body has, and
fixed joints lead to another link with mass, it hands its mass and inertia to that one and keeps none. What turns by
itself is left as it is, for `physical_inertias`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from symscrew.description import JOINT_TYPES
from symscrew.formats.draft import Draft, RawBody
from symscrew.formats.mjcf_geoms import Solid, together
from symscrew.formats.physical_inertias import impossible
from symscrew.formats.rigid_displacements import Rotation, plus


def settle_rigid_groups(draft: Draft) -> None:
    """Move such inertias of the draft along fixed joints; the ledger says which and where to."""
    bodies = {body.name: body for body in draft.bodies}
    waiting = list(bodies)
    while waiting:
        name = waiting.pop(0)
        body = bodies[name]
        weightless = body.mass == 0 and body.inertia is not None and any(map(any, body.inertia))
        target = _fixed_to(draft, bodies, name) if weightless or impossible(body) else None
        if target is None:
            continue
        bodies[name] = RawBody(name)
        if target != draft.ground:
            bodies[target] = _added(bodies[target], body)
            waiting.append(target)  # its own may be impossible still
        draft.ledger.changed.append(
            f"{name}: no body has its inertia alone; it is one with {target}, to which it is fixed, and counts there"
        )
    draft.bodies = list(bodies.values())


def _added(own: RawBody, other: RawBody) -> RawBody:
    assert own.mass is not None and own.com is not None and own.inertia is not None
    assert other.mass is not None and other.com is not None and other.inertia is not None
    if other.mass == 0:  # a moment without mass is the same about every point
        rows = [plus(a, b) for a, b in zip(own.inertia, other.inertia, strict=True)]
        total: Rotation = (rows[0], rows[1], rows[2])
        return replace(own, inertia=total)
    solids = [Solid(own.mass, own.com, own.inertia), Solid(other.mass, other.com, other.inertia)]
    whole = together(solids)
    assert whole is not None
    return replace(own, mass=whole.mass, com=whole.com, inertia=whole.inertia)


def _fixed_to(draft: Draft, bodies: Mapping[str, RawBody], start: str) -> str | None:
    """The nearest link with mass, or the ground, that fixed joints lead to."""
    front, seen = [start], {start}
    while front:
        here = front.pop(0)
        if here == draft.ground or (here != start and bodies[here].mass):
            return here
        for joint in draft.joints:
            if not JOINT_TYPES[joint.type].freedom and here in (joint.parent, joint.child):
                other = joint.child if here == joint.parent else joint.parent
                if other not in seen:
                    seen.add(other)
                    front.append(other)
    return None
