"""Operation modes of a body where the whole does not decompose: sets of poses by exact algebra, judged by real motion.

    modes_of_axes --irreducible sets of poses--> configurations on each --ranks, screw systems--> modes with a witness
    configurations on none of these --mode_sampling--> what else there is, sampled

That a set is irreducible, its dimension and its degree are proved; so is that every configuration whose orientation
is of the kind lies on these. That the poses of a set are reached, all of them but thinner sets, and no other mode goes
through them, is by the rank of the closure at a witness: the body has as many freedoms there as the set has dimensions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.components.algebraic_closure import closure_equations
from symscrew.mobility.components.all_components import ON, on_part
from symscrew.mobility.components.closure_parts import ClosureEquations, NotAlgebraicError
from symscrew.mobility.components.component_parts import Part
from symscrew.mobility.components.mode_sampling import SampledModes, freedoms_at, sampled_modes
from symscrew.mobility.components.parallel_axes import SECONDS, modes_of_axes
from symscrew.mobility.components.real_configurations import body_pose, real_configurations
from symscrew.mobility.finite import ClosureVariety
from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions import Closures, ScrewClass, class_of_motions, seen_at

Array = np.ndarray[Any, Any]

LOOKED_AT = 12
"""Configurations of a mode whose ranks are taken; the witness is the one of them that is farthest from losing rank."""
STRAIGHT = 1e-6
"""Difference of unit vectors that is rounding of poses closed to 1e-12 and directions from singular vectors."""


@dataclass(frozen=True, eq=False)
class Motion:
    """What the body does at a witness of a mode.

    `q`: displacements of all joint freedoms [rad; sizes of the mechanism]; `residual`: of the closure there, in these
    units; `exact`: whether it closes and has as many freedoms in 60 digits, too; `freedoms`: of the mechanism;
    `system`: class of the body's freedoms; `axis`: direction, in the base, of all axes about which the body turns, the
    same at all configurations looked at, or None; `upright`: 1 where the body's line along it was so in the reference,
    -1 where it was the other way round, 0 where it was another line.
    """

    q: Array
    residual: float
    exact: bool
    freedoms: int
    system: ScrewClass
    axis: Array | None
    upright: int


@dataclass(frozen=True)
class PoseMode:
    """A mode: its poses, irreducible over the field; what the body does; how many configurations found are on it."""

    part: Part
    motion: Motion
    count: int


@dataclass(frozen=True)
class PoseModes:
    """The modes of `body` against `base`, and of how many configurations that were found.

    `unseen`: sets of poses on which no configuration was seen that moves with so many freedoms; `others`: modes of the
    configurations that are on none of the sets, sampled.
    """

    base: str
    body: str
    field: str
    modes: tuple[PoseMode, ...]
    unseen: tuple[Part, ...]
    others: SampledModes
    found: int


def pose_modes(mechanism: Mechanism, network: Network, seconds: float = SECONDS) -> PoseModes | str:
    """The modes in which outer axes of limbs stay parallel, and what else is seen; or why none are known.

    Exact algebra is given up after so many seconds of the processor.
    """
    try:
        closure = closure_equations(mechanism, network, fewest=True)
        if not closure.body:
            return "not decided: the closure is of the angles of all bodies"
        parts = modes_of_axes(mechanism, network, closure, seconds)
    except NotAlgebraicError as error:
        return f"not decided: {error}"
    if isinstance(parts, str):
        return f"not decided: {parts}"
    q = real_configurations(network)
    values = np.zeros((len(q), len(closure.variables)))
    values[:, -8:] = body_pose(network, ClosureVariety(network), q, closure.base, closure.body)
    modes, beside = [], np.ones(len(q), dtype=bool)
    for part in parts:
        on = on_part(part, values, np.full(len(q), ON))
        motion = _motion(network, closure, q[on], part.dimension)
        beside &= ~on
        if motion is not None:
            modes.append(PoseMode(part, motion, int(on.sum())))
    if not modes:
        return "not decided: no set of poses by exact algebra was seen to be a mode"
    others = sampled_modes(network, closure.body, q[beside])
    unseen = tuple(part for part in parts if all(part is not mode.part for mode in modes))
    return PoseModes(closure.base, closure.body, str(closure.field), tuple(modes), unseen, others, len(q))


def _motion(network: Network, closure: ClosureEquations, q: Array, dimension: int) -> Motion | None:
    """What the body does at a witness of so many dimensions; None where none of the configurations is one."""
    variety = ClosureVariety(network)
    seen = [freedoms_at(network, variety, one, (closure.base, closure.body)) for one in q[:LOOKED_AT]]
    whole = [k for k, one in enumerate(seen) if one.poses == dimension]
    if not whole:
        return None
    best = max(whole, key=lambda k: seen[k].gap)
    system, exact = class_of_motions(seen[best].twists, float(network.length)), False
    if closure.base == network.ground:
        fine = seen_at(Closures(network), q[best], seen[best].freedoms, closure.body)
        system, exact = (fine.system, fine.exact) if fine.exact else (system, False)
    poses = variety.forward(q[:LOOKED_AT])[1]
    base, body = (poses[name][0] for name in (closure.base, closure.body))
    axes = [_axis(base[k].T @ seen[k].twists[:3]) for k in whole]
    axis, upright = axes[0], 0
    if axis is not None and all(other is not None and _same_line(axis, other) for other in axes):
        lines = [body[k].T @ base[k] @ axis for k in whole]
        upright = next((s for s in (1, -1) if all(np.abs(line - s * axis).max() < STRAIGHT for line in lines)), 0)
    else:
        axis = None
    residual = float(np.abs(variety.evaluate(q[best][None])[0]).max())
    return Motion(q[best], residual, exact, seen[best].freedoms, system, axis, upright)


def _axis(turning: Array) -> Array | None:
    """The direction of all angular velocities, if there is one; its largest part is positive."""
    u, s, _ = np.linalg.svd(turning)
    if s[0] < STRAIGHT or s[1] > STRAIGHT * s[0]:
        return None
    axis = u[:, 0]
    return np.asarray(axis * np.sign(axis[np.abs(axis).argmax()]))


def _same_line(a: Array, b: Array) -> bool:
    return bool(np.abs(np.cross(a, b)).max() < STRAIGHT)
