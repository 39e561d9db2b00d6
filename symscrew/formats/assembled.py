"""A tree of joints moved from the file's own pose to where its loops close.

Some files give the links in a pose in which the loops are open, and leave it to the reader to close them. What is said
of the closed pose are the displacements of the joints. What is then still open is for `open_loops` to judge.

    draft, displacements of its joints --> draft in the closed pose
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from symscrew.description import JOINT_TYPES
from symscrew.formats.closed_pose import Tree
from symscrew.formats.draft import Draft, RawBody, RawJoint
from symscrew.formats.rigid_displacements import (
    UNITS,
    Pose,
    Real,
    Triple,
    about,
    apply,
    minus,
    product,
    real,
    scaled,
    turned_inertia,
)
from symscrew.formats.tree_freedoms import Freedom

Array = np.ndarray[Any, Any]


def assembled(draft: Draft, tree: Tree, q: Array) -> dict[str, Pose]:
    """Displacement of every body by the displacements q of all freedoms; the draft is moved along, with 50 digits, and
    what was done is in its ledger."""
    freedoms, ways = tree.freedoms, tree.ways
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
    draft.pictures = [replace(p, pose=poses[p.body] @ p.pose) for p in draft.pictures]
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
    axes = None if body.axes is None else product(pose.rotation, body.axes)
    return replace(body, com=pose.point(body.com), inertia=turned_inertia(pose.rotation, body.inertia), axes=axes)


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
