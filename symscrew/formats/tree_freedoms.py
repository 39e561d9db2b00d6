"""The single freedoms of a draft's tree of joints, in doubles: which carry a body, and the inertia against them.

draft --freedoms_of, ways_to--> turns and slides by body --mass_matrix--> M in the draft's own pose
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.description import JOINT_TYPES
from symscrew.formats.draft import Draft, RawJoint
from symscrew.formats.merged_joints import plane_axes
from symscrew.formats.rigid_displacements import UNITS, Triple

Array = np.ndarray[Any, Any]


@dataclass(frozen=True)
class Freedom:
    """A turn or slide of one joint, in the file's own pose; axis, point and cross products with the axis as doubles."""

    joint: int
    turns: bool
    axis: Triple
    point: Triple

    @cached_property
    def doubles(self) -> tuple[Array, Array, Array, Array]:
        """Axis, point, and the matrices of one and of two cross products with the axis."""
        axis, point = doubles(self.axis), doubles(self.point)
        hat = cross_matrix(axis)
        return axis, point, hat, hat @ hat


def freedoms_of(index: int, joint: RawJoint) -> list[Freedom]:
    """Those of the joint with this index in the draft; of a ball, turns about x, y, z."""
    kind = JOINT_TYPES[joint.type]
    axes = kind.motion_axes(joint.axes, UNITS, plane_axes)
    found: list[Freedom] = []
    for motion in kind.motions:
        along = UNITS if motion.spherical else (axes[motion.axis or 0],)
        found += [Freedom(index, motion.turns, axis, joint.point) for axis in along]
    return found


def ways_to(draft: Draft, freedoms: Sequence[Freedom]) -> dict[str, list[int]]:
    """Body -> indices of the freedoms that carry it, from the ground outwards."""
    own: dict[int, list[int]] = {}
    for k, freedom in enumerate(freedoms):
        own.setdefault(freedom.joint, []).append(k)
    ways = {draft.ground: list[int]()}
    waiting = list(enumerate(draft.joints))
    while waiting:
        ready = [(k, joint) for k, joint in waiting if joint.parent in ways]
        if not ready:
            break
        for k, joint in ready:
            ways[joint.child] = [*ways[joint.parent], *own.get(k, [])]
        waiting = [entry for entry in waiting if entry not in ready]
    return ways


def mass_matrix(draft: Draft, freedoms: Sequence[Freedom], ways: Mapping[str, Sequence[int]]) -> Array:
    """Inertia of the tree [kg, kg m, kg m^2] in the draft's pose, armatures of joints included, of tendons not."""
    total = np.zeros((len(freedoms), len(freedoms)))
    for body in draft.bodies:
        if body.mass is None or body.com is None or body.inertia is None or body.name not in ways:
            continue
        centre, inertia = doubles(body.com), np.array([doubles(row) for row in body.inertia])
        linear, angular = np.zeros((3, len(freedoms))), np.zeros((3, len(freedoms)))
        for k in ways[body.name]:
            axis, point, hat, _ = freedoms[k].doubles
            linear[:, k] = hat @ (centre - point) if freedoms[k].turns else axis
            angular[:, k] = axis if freedoms[k].turns else 0
        total += float(body.mass) * linear.T @ linear + angular.T @ inertia @ angular
    for k, freedom in enumerate(freedoms):
        name = draft.joints[freedom.joint].name
        here = (e for e in draft.effects if e.joint == name and e.tendon is None)
        own = (e.table for e in here if e.table["kind"] == "armature")
        total[k, k] += sum(float(table["inertia"]) for table in own)
    return total


def cross_matrix(vector: Array) -> Array:
    """The matrix of a cross product with a vector."""
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def doubles(vector: Triple) -> Array:
    """A vector in doubles."""
    return np.array([float(c) for c in vector])
