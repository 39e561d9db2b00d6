"""A tree of joints moved from the file's own pose to where its loops close.

Some files give the links in a pose in which the loops are open, and leave it to the reader to close them. The joints
go the shortest way (least norm, Gauss-Newton with short steps) from that pose; what is said of it are their
displacements. What is then still open is for `open_loops` to judge.

    draft, sides of loops --displacements of the joints--> draft in the closed pose
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from symscrew.description import JOINT_TYPES
from symscrew.formats.draft import Draft, RawBody, RawJoint
from symscrew.formats.rigid_displacements import (
    UNITS,
    Pose,
    Real,
    Triple,
    about,
    apply,
    minus,
    real,
    scaled,
    turned_inertia,
)
from symscrew.formats.tree_freedoms import Freedom, cross_matrix, doubles, freedoms_of, ways_to
from symscrew.reference import rotation_vector

Array = np.ndarray[Any, Any]
Side = tuple[str, Pose]
LONGEST = 0.2
"""Of a step [rad, m]: a longer one may leave the way to the nearest closed pose."""
MOST_STEPS = 150
"""Of which few are used near the end; from half a turn away a step of `LONGEST` needs some twenty."""
STANDS_STILL = 1e-13
"""A step or a gap below this [rad, m] is rounding of doubles along a chain of links."""
DAMPING = 1e-10
"""Square of the singular values below which a direction is not used: redundant rows of loops have such."""


def assembled(draft: Draft, sides: Sequence[tuple[Side, Side, bool]]) -> dict[str, Pose]:
    """Displacement of every body that closes the loops best; the draft is moved along.

    `sides`: the two links of every loop with the pose of its frame in each, and whether it holds their turning, too.
    """
    freedoms = [f for k, joint in enumerate(draft.joints) for f in freedoms_of(k, joint)]
    ways = ways_to(draft, freedoms)
    q = np.zeros(len(freedoms))
    for _ in range(MOST_STEPS):
        residual, jacobian = _open(freedoms, ways, sides, q)
        if float(np.abs(residual).max(initial=0)) < STANDS_STILL:
            break
        u, s, vt = np.linalg.svd(jacobian, full_matrices=False)
        step = -vt.T @ ((s / (s * s + DAMPING)) * (u.T @ residual))
        size = float(np.abs(step).max(initial=0))
        if size < STANDS_STILL:
            break
        q = q + step * min(1.0, LONGEST / size)
    return _moved(draft, freedoms, ways, q)


def _open(
    freedoms: Sequence[Freedom],
    ways: Mapping[str, list[int]],
    sides: Sequence[tuple[Side, Side, bool]],
    q: Array,
) -> tuple[Array, Array]:
    """(how far every loop is open, its derivative by the freedoms) in doubles."""
    residuals: list[Array] = []
    rows: list[Array] = []
    for one, other, turning in sides:
        ends, slopes = [], []
        for link, pose in (one, other):
            rotation, shift, screws = _pushed(freedoms, ways[link], q)
            place = rotation @ doubles(pose.translation) + shift
            ends.append((rotation @ np.array([doubles(row) for row in pose.rotation]), place))
            slope, around = np.zeros((6, len(q))), cross_matrix(place)
            for k, (omega, linear) in screws.items():
                slope[:3, k], slope[3:, k] = linear - around @ omega, omega
            slopes.append(slope)
        (first, here), (second, there) = ends
        gap, by = here - there, slopes[0] - slopes[1]
        residuals.append(gap)
        rows.append(by[:3])
        if turning:
            residuals.append(rotation_vector(first @ second.T))
            rows.append(by[3:])
    return np.concatenate(residuals), np.concatenate(rows)


def _pushed(
    freedoms: Sequence[Freedom], way: Sequence[int], q: Array
) -> tuple[Array, Array, dict[int, tuple[Array, Array]]]:
    """Displacement of a body (rotation, shift), and the present screw (omega, v at O) of every freedom on its way."""
    rotation, shift = np.eye(3), np.zeros(3)
    screws: dict[int, tuple[Array, Array]] = {}
    for k in way:
        axis, point, hat, twice = freedoms[k].doubles
        there, at = rotation @ axis, rotation @ point + shift
        if freedoms[k].turns:
            screws[k] = (there, cross_matrix(at) @ there)
            turn = np.eye(3) + np.sin(q[k]) * hat + (1 - np.cos(q[k])) * twice
            shift = shift + rotation @ (point - turn @ point)
            rotation = rotation @ turn
        else:
            screws[k] = (np.zeros(3), there)
            shift = shift + there * q[k]
    return rotation, shift, screws


def _moved(draft: Draft, freedoms: Sequence[Freedom], ways: Mapping[str, list[int]], q: Array) -> dict[str, Pose]:
    """The draft's bodies, joints and points displaced, with 50 digits; what was done is in its ledger."""
    amounts = [real(repr(float(value))) for value in q]

    def after(way: Sequence[int]) -> Pose:
        total = Pose()
        for k in way:
            total = total @ _displacement(freedoms[k], amounts[k])
        return total

    poses = {body: after(way) for body, way in ways.items()}
    own: dict[int, list[int]] = {}
    for k, freedom in enumerate(freedoms):
        own.setdefault(freedom.joint, []).append(k)
    draft.bodies = [_body(body, poses[body.name]) for body in draft.bodies]
    draft.points = [(name, body, poses[body].point(at)) for name, body, at in draft.points]
    named = []
    for k, joint in enumerate(draft.joints):
        mine = own.get(k, [])
        first = after([*ways[joint.parent], *mine[:1]])
        draft.joints[k] = _joint(joint, poses, [amounts[j] for j in mine], first)
        named += [f"{joint.name} {float(amounts[j]):.3g}" for j in mine]
    draft.ledger.changed.append(
        f"joints moved from the file's pose to where its loops close [rad, m]: {', '.join(named)}"
    )
    return poses


def _displacement(freedom: Freedom, amount: Real) -> Pose:
    if not freedom.turns:
        return Pose(UNITS, scaled(freedom.axis, amount))
    turn = about(freedom.axis, amount)
    return Pose(turn, minus(freedom.point, apply(turn, freedom.point)))


def _body(body: RawBody, pose: Pose) -> RawBody:
    if body.com is None or body.inertia is None:
        return body
    return replace(body, com=pose.point(body.com), inertia=turned_inertia(pose.rotation, body.inertia))


def _joint(joint: RawJoint, poses: Mapping[str, Pose], amounts: Sequence[Real], first: Pose) -> RawJoint:
    """The joint where its bodies are now: `first` is the displacement after the first of its own motions."""
    kind = JOINT_TYPES[joint.type]
    parent, child = poses[joint.parent], poses[joint.child]
    if len(joint.axes) == 2:
        axes: tuple[Triple, ...] = (parent.direction(joint.axes[0]), first.direction(joint.axes[1]))
    else:
        axes = tuple(parent.direction(axis) for axis in joint.axes)
    reference = joint.reference
    if kind.references:
        before = joint.reference or (real(0),) * kind.references
        reference = tuple(a + b for a, b in zip(before, amounts, strict=True))
    return replace(joint, point=child.point(joint.point), axes=axes, reference=reference)
