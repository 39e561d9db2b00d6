"""Shares of bodies' weights that an MJCF file has carried (gravcomp): forces at the centres of mass.

The engine gives joints with actuatorgravcomp their part of these forces through the actuators: within the joint's
actuatorfrcrange, and not at all where the file has no actuator. It carries nothing where no share is above zero.
Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#body-gravcomp; MuJoCo is asked in the tests.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from symscrew.formats.draft import Draft, RawBody, RawLoad
from symscrew.formats.file_names import fresh
from symscrew.formats.rigid_displacements import ZERO, Real, real

USUAL_GRAVITY = ("0", "0", "-9.81")


def carry(draft: Draft, carried: Mapping[str, Real], borne: Collection[str], *, actuated: bool) -> None:
    """Enter the forces that carry weights.

    Args:
        draft: with its bodies, joints and limits.
        carried: body -> share of its weight.
        borne: joints whose part is the actuators'.
        actuated: whether the file has an actuator.
    """
    shares = {name: share for name, share in carried.items() if share != 0}
    if not shares:
        return
    if all(share < 0 for share in shares.values()):
        draft.ledger.passed("gravcomp, of which none is above zero: the engine has no force then", len(shares))
        return
    for joint in borne:
        limits = draft.limits.get(joint)
        if not actuated:
            draft.ledger.lost("actuatorgravcomp without actuators: the engine leaves that part of gravcomp out")
        elif limits is not None and limits.push is not None:
            draft.ledger.lost(f"actuatorgravcomp of {joint} within its actuatorfrcrange")
    for body in draft.bodies:
        _carry(draft, body, shares.get(body.name, ZERO[0]))


def _carry(draft: Draft, body: RawBody, share: Real) -> None:
    if share == 0 or body.mass is None or body.com is None:
        return
    field = [real(c) for c in draft.gravity or USUAL_GRAVITY]
    if not any(field):
        return
    point = fresh(f"{body.name}_com", [name for name, _, _ in draft.points])
    draft.points.append((point, body.name, body.com))
    draft.loads.append(RawLoad(point, (*(-share * body.mass * c for c in field), *ZERO)))
    draft.ledger.turned("gravcomp: a force at the centre of mass")
