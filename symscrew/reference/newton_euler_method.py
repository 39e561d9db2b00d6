"""Method B of the source paper: Newton-Euler equations in maximal coordinates, with NumPy.

For every moving body, with the acceleration a_C of its centre of mass and its angular acceleration alpha,

    m a_C = sum of forces,        J alpha + omega x J omega = sum of moments about C.

The unknowns are all joint reactions and all drives at once. This is what momentum screws (method A) are
compared with; it uses the description and the states of the bodies, none of the symbolic derivation, and is
written to be obviously right rather than fast.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.description import Mechanism
from symscrew.reference.joint_motion import constraint_residuals, joint_displacements, joint_rates
from symscrew.reference.maximal_coordinates import (
    Array,
    BodyState,
    JointScrews,
    NumericMechanism,
    cross,
    freedom_screws,
    joint_screws,
    numeric,
    stack_states,
)
from symscrew.reference.tied_freedoms import tied_freedoms

__all__ = [
    "BodyState",
    "NewtonEulerSolution",
    "NumericMechanism",
    "constraint_residuals",
    "joint_displacements",
    "joint_rates",
    "newton_euler",
    "numeric",
]

RANK = 1e-9
"""Singular values below this fraction of the greatest count as zero (all columns are of order one).

Below are redundant constraints (1e-16): internal loads, of which the solution has the least norm. Above is a state near
a singularity, whose reactions are large and unique."""

CONDITION = 1e8
"""Up to this condition number of the reactions' columns a triangular factor solves, the cheaper way; above, and where
columns are dependent, singular values do, which tell the rank. Both give the same reactions, to rounding times this."""

CHUNK = 128
"""States solved at once; keeps the stacked matrices within a processor's cache and a few megabytes. More are solved one
chunk after the other, with the same result."""

INTERNAL_LOAD = 1e-7
"""A component of a unit internal load above this (moments over the length) makes the reaction not unique: rounding of a
null space from singular values of `RANK` is below it."""


@dataclass(frozen=True)
class NewtonEulerSolution:
    """Drives and joint reactions of one state, or of many (leading axes as in the states).

    Attributes:
        drives: (..., drives) driving force [N] or torque [N m] of each driven freedom, joints in the order of
            the description; positive extends a prismatic joint, turns the child positively about an axis.
        drive_joints: name of the joint of each drive.
        reactions: {joint: (..., 6)} wrench (f ; m_O) [N ; N m], absolute axes, from parent on child, without
            the drive's share.
        drive_wrenches: {joint: (..., 6)} the drive's share of the joint's wrench, for each driven joint.
        unique: {joint: (..., 6) bool} which components of `reactions` are the same in all solutions that have
            these drives; all are unless the mechanism is overconstrained.
        null_wrenches: {joint: (..., 6, n)} changes of the reactions by n independent internal loads, which
            leave all bodies in balance at the same drives; n is the greatest `reaction_redundancy`, columns
            are zero where a state has fewer. Reactions are determined up to combinations of these columns.
        drive_redundancy: (...) number of independent preloads: drives that only load the mechanism.
        reaction_redundancy: (...) number of independent internal loads of the reactions at given drives.
        residual: (...) norm of what stays unbalanced, relative to the norm of inertia and loads (forces, and
            moments divided by `NumericMechanism.length`). Not small means that the state is inconsistent, or
            that a freedom that nobody drives does not move as the dynamics would have it.
    """

    drives: Array
    drive_joints: tuple[str, ...]
    reactions: dict[str, Array]
    drive_wrenches: dict[str, Array]
    unique: dict[str, Array]
    null_wrenches: dict[str, Array]
    drive_redundancy: Array
    reaction_redundancy: Array
    residual: Array

    @property
    def redundancy(self) -> Array:
        """Dimension of the null space of all reactions and drives together (...)."""
        total: Array = self.drive_redundancy + self.reaction_redundancy
        return total

    def __repr__(self) -> str:
        states = int(np.prod(self.residual.shape, dtype=int))
        worst = float(np.max(self.residual, initial=0.0))
        return (
            f"<NewtonEulerSolution: {states} states, {len(self.drive_joints)} drives, {len(self.reactions)} joints, "
            f"residual at most {worst:.1e}>"
        )


def newton_euler(
    mechanism: Mechanism | NumericMechanism,
    states: Mapping[str, BodyState],
    *,
    gravity: Sequence[float] | Array = (0.0, 0.0, -9.81),
    loads: Mapping[str, Array] | None = None,
    weights: Sequence[float] | Array | None = None,
    preload: Sequence[float] | Array | None = None,
) -> NewtonEulerSolution:
    """Drives and all joint reactions of given states of motion (inverse dynamics by method B).

    Among all drives that move the bodies as stated, those with the smallest sum of weights * drives^2 are
    taken; `preload` adds its part that only loads the mechanism. Given the drives, the reactions are those of
    least norm, forces and moments about the joint's point divided by the characteristic length.

    Args:
        mechanism: the description, or its numbers from `numeric`, which saves time with many states.
        states: {body: `BodyState`} of all moving bodies; leading axes are many states. The ground may be
            left out (at rest) or moved.
        gravity: acceleration of free fall (3,) [m/s^2], absolute axes.
        loads: {body: (..., 6)} further wrenches (f ; m_O) [N ; N m] on bodies, moment about O.
        weights: (drives,) positive weights, default 1.
        preload: (drives,) drives [N or N m]; only their projection on the preloads (orthogonal in the
            weights) is added.

    Raises:
        ValueError: states or loads of unknown bodies, missing bodies, wrong shapes, numbers that are not
            finite, weights that are not positive.

    Warning: a load given at a point must be brought to O first, (F ; r x F + M).
    """
    numbers = numeric(mechanism)
    whole = stack_states(numbers, states)
    lead = whole.translation.shape[:-2]
    count, bodies = int(np.prod(lead, dtype=int)), len(numbers.bodies)
    flat = _in_a_row(whole, count, bodies)
    applied = np.broadcast_to(_stack_loads(numbers, loads or {}), (*lead, bodies, 6))
    applied = applied.reshape(count, bodies, 6)
    drive_weights = _checked_drives(numbers, weights, 1.0, "weights")
    wanted = _checked_drives(numbers, preload, 0.0, "preload")
    if not (drive_weights > 0).all():
        raise ValueError(f"expected positive weights of the drives, got {drive_weights.tolist()}")
    fall = np.asarray(gravity, dtype=float)
    root_weights = np.sqrt(drive_weights)
    pieces = []
    for start in range(0, max(count, 1), CHUNK):
        part = slice(start, start + CHUNK)
        some = BodyState(flat.rotation[part], flat.translation[part], flat.twist[part], flat.twist_rate[part])
        pieces.append(_solve(numbers, some, fall, applied[part], root_weights=root_weights, preload=wanted))
    return _joined(numbers, pieces, lead)


def _in_a_row(whole: BodyState, count: int, bodies: int) -> BodyState:
    """The states with their leading axes made one."""
    return BodyState(
        rotation=whole.rotation.reshape(count, bodies, 3, 3),
        translation=whole.translation.reshape(count, bodies, 3),
        twist=whole.twist.reshape(count, bodies, 6),
        twist_rate=whole.twist_rate.reshape(count, bodies, 6),
    )


@dataclass(frozen=True)
class _Piece:
    """The solution of a chunk of states as arrays, states first, joints next."""

    drives: Array
    reactions: Array
    shares: Array
    null: Array
    drive_redundancy: Array
    reaction_redundancy: Array
    residual: Array


def _solve(
    numbers: NumericMechanism,
    whole: BodyState,
    gravity: Array,
    loads: Array,
    *,
    root_weights: Array,
    preload: Array,
) -> _Piece:
    """Drives and reactions of a chunk of states; see `newton_euler`."""
    screws = joint_screws(numbers, whole)
    com = np.einsum("...ij,...j->...i", whole.rotation, numbers.com) + whole.translation
    needed = _needed(numbers, whole, com, gravity=gravity, loads=loads)
    supports = _supports(numbers, screws)
    drives = _efforts(numbers, screws, numbers.driven, [numbers.joints.index(name) for name in numbers.drive_joints])
    reaction_columns = _balance(numbers, screws, com, supports)
    if numbers.mechanism.couplings:
        tied = tied_freedoms(numbers, whole)
        on_freedoms = _balance(numbers, screws, com, _efforts(numbers, screws, tied.freedoms, tied.joints))
        reaction_columns = np.concatenate([reaction_columns, on_freedoms @ np.swapaxes(tied.slopes, -1, -2)], axis=-1)
    drive_columns = _balance(numbers, screws, com, drives)

    motions, inverse, null, reaction_redundancy = _split(reaction_columns)
    # Only the part along the mechanism's virtual motions involves the drives: reactions do no work there.
    back, preloads = _pseudo_inverse((motions @ drive_columns) / root_weights)
    demand = (motions @ needed[..., None])[..., 0]
    scaled = np.einsum("nij,nj->ni", back, demand) + np.einsum("nij,j->ni", preloads, preload * root_weights)
    force = scaled / root_weights
    rest = needed - np.einsum("nij,nj->ni", drive_columns, force)
    amount = np.einsum("nij,nj->ni", inverse, rest)
    unbalanced = rest - np.einsum("nij,nj->ni", reaction_columns, amount)
    size, count = np.linalg.norm(needed, axis=-1), len(supports.owners)
    return _Piece(
        drives=force,
        reactions=_totals(numbers, screws, supports, amount[:, :count, None])[..., 0],
        shares=_totals(numbers, screws, drives, force[..., None])[..., 0],
        null=_totals(numbers, screws, supports, null[:, :count]),
        drive_redundancy=np.rint(np.trace(preloads, axis1=-2, axis2=-1)).astype(int),
        reaction_redundancy=reaction_redundancy,
        residual=np.linalg.norm(unbalanced, axis=-1) / np.where(size > 0, size, 1.0),
    )


def _needed(numbers: NumericMechanism, whole: BodyState, com: Array, *, gravity: Array, loads: Array) -> Array:
    """What joints must give moving bodies: (m (a_C - g) - F ; (J alpha + omega x J omega - M_C)/length)."""
    omega, alpha = whole.twist[..., :3], whole.twist_rate[..., :3]
    force = numbers.mass[:, None] * (whole.acceleration_at(com) - gravity) - loads[..., :3]
    turned = whole.rotation @ numbers.inertia @ np.swapaxes(whole.rotation, -1, -2)
    momentum = np.einsum("...ij,...j->...i", turned, omega)
    moment = np.einsum("...ij,...j->...i", turned, alpha) + cross(omega, momentum)
    moment = moment - (loads[..., 3:] - cross(com, loads[..., :3]))
    both: Array = np.concatenate([force, moment / numbers.length], axis=-1)[:, 1:]
    return both.reshape(len(both), -1)


@dataclass(frozen=True)
class _UnitWrenches:
    """Unit wrenches (states, unknowns, 6), (f ; m / length) at the points of their `owners` (unknowns,)."""

    owners: Array
    wrenches: Array


def _supports(numbers: NumericMechanism, screws: JointScrews) -> _UnitWrenches:
    """For each joint the 6 - freedom orthonormal wrenches that do no work on its screws, eq. (10)."""
    states, joints = screws.point.shape[:2]
    paired = np.zeros((states, joints, 6, 6))
    owners: list[int] = []
    columns: list[int] = []
    for j, own in enumerate(numbers.freedoms):
        screw = freedom_screws(numbers, screws, j)
        paired[:, j, :3, : len(own)] = screw[:, 3:]
        paired[:, j, 3:, : len(own)] = screw[:, :3] * numbers.length
        owners += [j] * (6 - len(own))
        columns += range(len(own), 6)
    # The last columns of the orthogonal factor are orthogonal to all screws, dependent ones included.
    basis = np.swapaxes(np.linalg.qr(paired).Q, -1, -2)
    owner, column = np.array(owners, dtype=int), np.array(columns, dtype=int)
    return _UnitWrenches(owner, basis[:, owner, column])


def _efforts(
    numbers: NumericMechanism, screws: JointScrews, freedoms: Sequence[int], owners: Sequence[int]
) -> _UnitWrenches:
    """The wrench of a unit drive on each of these freedoms of joints `owners`: a force along or a couple about an axis.

    It does unit work on its own freedom and none on the joint's other freedoms.
    """
    wrenches = np.zeros((len(screws.axis), len(freedoms), 6))
    for k, (index, j) in enumerate(zip(freedoms, owners, strict=True)):
        turns = numbers.turns[index] > 0
        alike = numbers.freedoms[j][(numbers.turns[numbers.freedoms[j]] > 0) == turns]
        dual = screws.axis[:, index]
        if len(alike) > 1:
            dual = np.linalg.pinv(screws.axis[:, alike])[..., list(alike).index(index)]
        wrenches[:, k, slice(3, 6) if turns else slice(0, 3)] = dual / (numbers.length if turns else 1.0)
    return _UnitWrenches(np.array(owners, dtype=int), wrenches)


def _balance(numbers: NumericMechanism, screws: JointScrews, com: Array, units: _UnitWrenches) -> Array:
    """What unit wrenches at the joints do to the moving bodies: (states, 6 moving bodies, unknowns).

    Rows are forces, and moments about the centre of mass divided by the length; + on the child, - on the
    parent.
    """
    states, unknowns = units.wrenches.shape[:2]
    matrix = np.zeros((states, unknowns, len(numbers.bodies), 6))
    force, moment = units.wrenches[..., :3], units.wrenches[..., 3:]
    for ends, sign in ((numbers.children, 1.0), (numbers.parents, -1.0)):
        bodies = ends[units.owners]
        arm = (screws.point[:, units.owners] - com[:, bodies]) / numbers.length
        matrix[:, np.arange(unknowns), bodies, :3] = sign * force
        matrix[:, np.arange(unknowns), bodies, 3:] = sign * (moment + cross(arm, force))
    return np.swapaxes(matrix[:, :, 1:].reshape(states, unknowns, -1), -1, -2)


def _totals(numbers: NumericMechanism, screws: JointScrews, units: _UnitWrenches, amounts: Array) -> Array:
    """Wrenches (f ; m_O) of all joints (states, joints, 6, n) from amounts (states, unknowns, n)."""
    own = (np.arange(len(numbers.joints))[:, None] == units.owners).astype(float)
    each = np.einsum("nux,nuk->nukx", units.wrenches, amounts)
    at_point = np.tensordot(each, own, axes=(1, 1))
    force, moment = np.moveaxis(at_point, -1, 1)[..., :3], np.moveaxis(at_point, -1, 1)[..., 3:]
    moment = numbers.length * moment + cross(screws.point[:, :, None], force)
    return np.swapaxes(np.concatenate([force, moment], axis=-1), -1, -2)


def _split(columns: Array) -> tuple[Array, Array, Array, Array]:
    """Left null space, pseudo-inverse, null space and its dimension of matrices (states, rows, columns).

    The left null space of the reactions' columns are the mechanism's virtual motions. A triangular factor
    does when all columns are well independent; otherwise singular values decide (`RANK`). Rows of the left
    and columns of the right null space are zero where a state has fewer than another.
    """
    states, rows, count = columns.shape
    if rows >= count:
        q, r = np.linalg.qr(columns, mode="complete")
        r = r[:, :count]
        pivots = np.abs(np.diagonal(r, axis1=-2, axis2=-1))
        if count == 0 or pivots.min() > 1 / CONDITION:
            back = np.linalg.inv(r)
            if np.all(np.linalg.norm(back, axis=(-2, -1)) < CONDITION):
                inverse = back @ np.swapaxes(q[..., :count], -1, -2)
                left = np.swapaxes(q[..., count:], -1, -2)
                return left, inverse, np.zeros((states, count, 0)), np.zeros(states, dtype=int)
    u, s, v = np.linalg.svd(columns, full_matrices=True)
    rank = (s > RANK * s[:, :1]).sum(axis=-1)
    kept = np.arange(s.shape[-1]) < rank[:, None]
    values = np.where(kept, 1 / np.where(kept, s, 1.0), 0.0)
    width = s.shape[-1]
    inverse = np.swapaxes(v[:, :width], -1, -2) @ (values[..., None] * np.swapaxes(u[..., :width], -1, -2))
    least = int(rank.min())
    left = np.swapaxes(u[..., least:], -1, -2) * (np.arange(least, rows) >= rank[:, None])[..., None]
    null = np.swapaxes(v[:, least:], -1, -2) * (np.arange(least, count) >= rank[:, None])[:, None, :]
    return left, inverse, null, count - rank


def _pseudo_inverse(matrix: Array) -> tuple[Array, Array]:
    """Pseudo-inverse (states, columns, rows) and projector on the null space (states, columns, columns)."""
    if 0 in matrix.shape[1:]:
        inverse = np.zeros((len(matrix), matrix.shape[2], matrix.shape[1]))
    else:
        inverse = np.linalg.pinv(matrix, rcond=RANK)
    return inverse, np.eye(matrix.shape[2]) - inverse @ matrix


def _joined(numbers: NumericMechanism, pieces: list[_Piece], lead: tuple[int, ...]) -> NewtonEulerSolution:
    """The solution of all chunks, with the leading axes of the states and the names of the joints."""

    def all_of(arrays: list[Array]) -> Array:
        return np.concatenate(arrays).reshape((*lead, *arrays[0].shape[1:]))

    width = max(piece.null.shape[-1] for piece in pieces)
    padded = [np.pad(p.null, [(0, 0)] * 3 + [(0, width - p.null.shape[-1])]) for p in pieces]
    null, shares = all_of(padded), all_of([piece.shares for piece in pieces])
    reactions = all_of([piece.reactions for piece in pieces])
    size = np.concatenate([np.ones(3), np.full(3, numbers.length)])
    free: Array = np.any(np.abs(null) > INTERNAL_LOAD * size[:, None], axis=-1)
    names = dict(enumerate(numbers.joints))
    drive_joints = numbers.drive_joints
    return NewtonEulerSolution(
        drives=all_of([piece.drives for piece in pieces]),
        drive_joints=drive_joints,
        reactions={name: reactions[..., j, :] for j, name in names.items()},
        drive_wrenches={name: shares[..., j, :] for j, name in names.items() if name in drive_joints},
        unique={name: ~free[..., j, :] for j, name in names.items()},
        null_wrenches={name: null[..., j, :, :] for j, name in names.items()},
        drive_redundancy=all_of([piece.drive_redundancy for piece in pieces]),
        reaction_redundancy=all_of([piece.reaction_redundancy for piece in pieces]),
        residual=all_of([piece.residual for piece in pieces]),
    )


def _stack_loads(numbers: NumericMechanism, loads: Mapping[str, Array]) -> Array:
    """Wrenches (..., bodies, 6) in the order of the bodies, zero where none is given."""
    unknown = [name for name in loads if name not in numbers.bodies]
    if unknown:
        raise ValueError(f"expected loads on bodies of '{numbers.mechanism.name}', got {unknown}")
    listed = [np.asarray(loads.get(name, np.zeros(6)), dtype=float) for name in numbers.bodies]
    for name, load in zip(numbers.bodies, listed, strict=True):
        if load.shape[-1:] != (6,) or not np.isfinite(load).all():
            raise ValueError(f"expected finite wrenches (..., 6) on '{name}', got {load.tolist()}")
    return np.stack(np.broadcast_arrays(*listed), axis=-2)


def _checked_drives(
    numbers: NumericMechanism, values: Sequence[float] | Array | None, default: float, what: str
) -> Array:
    """One finite number per drive."""
    count = len(numbers.driven)
    array = np.full(count, default) if values is None else np.asarray(values, dtype=float)
    if array.shape != (count,) or not np.isfinite(array).all():
        raise ValueError(f"expected {count} finite {what}, one per drive, got {array.tolist()}")
    return array
