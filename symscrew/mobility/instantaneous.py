"""Instantaneous mobility by reciprocal screws, eqs. (10)-(18), for any mechanism.

    loop rows A --null space--> motions --twist of a body--> its freedoms --reciprocal--> wrenches that hold it

The closure of all loops is written in the joint rates; its null space are the instantaneous motions. The freedoms
of a body are the image of the null space under the body's twist; what moves while the platform rests is
internal. For a limb the null space of S_limb^T N is its constraint system, the union over the limbs is the
platform's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_classes import ScrewClass, screw_class
from symscrew.mobility.screw_systems import (  # fmt: skip
    Real,
    Screw,
    ScrewSystem,
    combine,
    eliminate,
    normalised,
    null_space,
    span,
    swapped,
    unit_rows,
)
from symscrew.mobility.screw_text import describe_type


@dataclass(frozen=True)
class LimbMobility:
    """A limb: the names of its joints, its screws (omega ; v) and its constraints (f ; m), at O."""

    name: str
    joints: tuple[str, ...]
    screws: tuple[Screw, ...]
    constraints: ScrewSystem

    def __repr__(self) -> str:
        return f"<LimbMobility {self.name}: {len(self.screws)} freedoms, {len(self.constraints.basis)} constraints>"


@dataclass(frozen=True)
class BodyFreedoms:
    """Freedoms of a body: twists (omega ; v_O) [1, m], their type, and the wrenches reciprocal to all of them.

    `length`: of the mechanism [m].
    """

    body: str
    freedoms: ScrewSystem
    constraints: ScrewSystem
    rotations: int
    length: Real

    def __repr__(self) -> str:
        return f"<BodyFreedoms of {self.body}: {self.dof}, type {self.motion_type}>"

    @property
    def dof(self) -> int:
        """Dimension of the space of twists."""
        return len(self.freedoms.basis)

    @property
    def type(self) -> str:
        """`2R`, `3T`, `1R3T`, `0`: first the dimension of the angular-velocity projection, whatever the pitches."""
        return describe_type(self.dof, self.rotations)

    @cached_property
    def system(self) -> ScrewClass:
        """Their class as a screw system, with principal pitches [m], in 60 digits."""
        return screw_class(np.array(self.freedoms.basis, dtype=object).reshape(-1, 6), self.length)

    @property
    def motion_type(self) -> str:
        """The same with H for screw motions, whose pitch is not zero: `1H` of the coupler of a Bennett linkage."""
        return describe_type(self.dof, self.rotations, self.system.helical)


@dataclass(frozen=True)
class Instantaneous:
    """First-order mobility. `motions`: basis of the null space in the (scaled) joint rates.

    `closure`: the null space with its evidence; `redundant`: rank deficiency of the closure, the number of
    independent self-stresses; `dof_drives_locked`: None without drives.
    """

    closure: ScrewSystem
    rows: tuple[Screw, ...]
    kutzbach: int
    dof: int
    overconstraints: int
    dof_drives_locked: int | None

    def __repr__(self) -> str:
        return f"<Instantaneous: {self.dof} freedoms, Kutzbach {self.kutzbach}, {self.overconstraints} redundant>"

    @property
    def motions(self) -> tuple[Screw, ...]:
        """Basis of the instantaneous motions, one rate per freedom."""
        return self.closure.basis


def instantaneous_mobility(network: Network) -> Instantaneous:
    """Rank and null space of the velocity closure of all loops, in 60 digits."""
    rows = network.loop_rows()
    closure = null_space(rows, network.freedoms)
    dof = len(closure.basis)
    locked = None
    if network.driven:
        driven = [[motion[column] for motion in closure.basis] for column in network.driven]
        locked = dof - eliminate(driven, dof).rank
    return Instantaneous(closure, tuple(map(tuple, rows)), network.kutzbach, dof, dof - network.kutzbach, locked)


def body_freedoms(network: Network, found: Instantaneous, body: str) -> BodyFreedoms:
    """The twists that `body` can have; raises DescriptionError for an unknown body."""
    if body not in network.bodies:
        raise DescriptionError(f"expected the name of a body, got {body!r}; {did_you_mean(body, network.bodies)}")
    rows = network.twist_rows(body)
    twists = [combine(rows, motion) for motion in unit_rows(found.motions)]
    freedoms = span(twists, 6)
    rotations = eliminate([twist[:3] for twist in freedoms.basis], 3).rank
    constraints = null_space([swapped(twist) for twist in freedoms.basis], 6)
    length = network.length
    return BodyFreedoms(body, _to_metres(freedoms, length), _to_metres(constraints, length), rotations, length)


def limb_mobility(network: Network, name: str, joints: Sequence[str]) -> LimbMobility:
    """Screws and constraints of a limb: the wrench (f ; m) with omega . m + v . f = 0 for all its screws."""
    chain = [screw for joint in joints for screw in network.edges[joint].screws]
    system = null_space([swapped(screw) for screw in chain], 6)
    screws = tuple((*s[:3], *(c * network.length for c in s[3:])) for s in chain)
    return LimbMobility(name, tuple(joints), screws, _to_metres(system, network.length))


def limb_constraints(limbs: Sequence[LimbMobility], length: Real) -> ScrewSystem:
    """The union of the limbs' constraints as the platform's constraint system: all of them, and their rank.

    `length`: of the mechanism [m], by which moments are divided before ranks are taken.
    """
    wrenches = tuple(wrench for limb in limbs for wrench in limb.constraints.basis)
    found = eliminate(unit_rows([(*w[:3], *(c / length for c in w[3:])) for w in wrenches]), 6)
    return ScrewSystem(wrenches, found.rank, found.smallest, found.largest)


def moved_body(mechanism: Mechanism) -> str:
    """The platform of the description; without one the body that is farthest from the ground, in joints."""
    if mechanism.platform is not None:
        return mechanism.platform
    distance = {mechanism.ground: 0}
    front = [mechanism.ground]
    while front:
        body = front.pop(0)
        for joint in mechanism.joints.values():
            for near, far in ((joint.parent, joint.child), (joint.child, joint.parent)):
                if near == body and far not in distance:
                    distance[far] = distance[body] + 1
                    front.append(far)
    return max(distance, key=lambda body: distance[body])


def _to_metres(system: ScrewSystem, length: Real) -> ScrewSystem:
    """The basis in metres as unit screws: moments and velocities are times the mechanism's length."""
    basis = tuple(normalised((*s[:3], *(c * length for c in s[3:]))) for s in system.basis)
    return ScrewSystem(basis, system.rank, system.smallest_pivot, system.largest_zero)
