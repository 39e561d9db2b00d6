"""Displacements and rates of all joints from the states of the bodies, and what does not fit.

    poses, twists, twist rates of bodies --least squares on joint screws, eq. (7)--> displacements, rates, residuals

This is a check of kinematics that knows no spanning tree, no loop closure and no generated code: a state of
all bodies is consistent when the relative motion at each joint lies in the joint's freedoms.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from symscrew.description import Mechanism
from symscrew.reference.maximal_coordinates import (
    Array,
    BodyState,
    JointScrews,
    NumericMechanism,
    freedom_screws,
    joint_screws,
    numeric,
    stack_states,
)


def joint_rates(mechanism: Mechanism | NumericMechanism, states: Mapping[str, BodyState]) -> dict[str, Array]:
    """Rates (..., freedom) of each joint [rad/s or m/s] from the twists of its two bodies.

    Least squares of the relative twist at the joint's point on the joint's unit screws, eq. (7) of the paper;
    exact when the states are consistent. The three rates of a spherical motion are the components of the
    relative angular velocity along the parent's axes (its axes that are absolute in the reference
    configuration).
    """
    numbers = numeric(mechanism)
    screws = joint_screws(numbers, stack_states(numbers, states))
    return {name: _fit(numbers, screws, j, screws.relative)[0] for j, name in enumerate(numbers.joints)}


def constraint_residuals(
    mechanism: Mechanism | NumericMechanism, states: Mapping[str, BodyState]
) -> dict[str, tuple[Array, Array, Array]]:
    """Position, velocity and acceleration residual of each joint: what its freedoms do not explain.

    Each residual (..., 6) is angular part first, at the joint's present point, absolute axes, in [rad ; m]
    and its rates: what is left of the relative pose, twist and twist rate after the best displacements, rates
    and accelerations of the joint. All are zero for consistent states.
    """
    numbers = numeric(mechanism)
    whole = stack_states(numbers, states)
    screws = joint_screws(numbers, whole)
    residuals = {}
    for j, name in enumerate(numbers.joints):
        rates, velocity = _fit(numbers, screws, j, screws.relative)
        own = numbers.freedoms[j]
        turning = rates * numbers.turns[own]
        drift = np.zeros_like(screws.relative_rate[..., j, :])
        drift[..., :3] = np.einsum("...k,...ki->...i", turning, screws.axis_dot[..., own, :])
        sliding = rates * numbers.slides[own]
        drift[..., 3:] = np.einsum("...k,...ki->...i", sliding, screws.axis_dot[..., own, :])
        spin = np.einsum("...k,...ki->...i", turning, screws.axis[..., own, :])
        drift[..., 3:] += np.cross(screws.point_velocity[..., j, :], spin)
        remaining = screws.relative_rate.copy()
        remaining[..., j, :] -= drift
        acceleration = _fit(numbers, screws, j, remaining)[1]
        residuals[name] = (_pose_residual(numbers, whole, j), velocity, acceleration)
    return residuals


def joint_displacements(mechanism: Mechanism | NumericMechanism, states: Mapping[str, BodyState]) -> dict[str, Array]:
    """Displacements (..., freedom) of each joint [rad or m] from the poses of its two bodies.

    Angles lie in (-pi, pi], a spherical motion is the rotation vector of the child relative to the parent (in
    the parent's axes), a helical angle counts full turns by its translation. The joint's `reference` values
    are added where the description has them.
    """
    numbers = numeric(mechanism)
    whole = stack_states(numbers, states)
    return {name: displacements_of(numbers, whole, name) for name in numbers.joints}


def displacements_of(numbers: NumericMechanism, whole: BodyState, joint: str) -> Array:
    """Displacements (..., freedom) of one joint from the stacked states of all bodies, as `joint_displacements`."""
    j = numbers.joints.index(joint)
    found = _displacements(numbers, j, *_relative_pose(numbers, whole, j))
    reference = numbers.references[j]
    total: Array = found + reference if reference.size == found.shape[-1] else found
    return total


def rotation_about(vector: Array) -> Array:
    """Rotation matrices (..., 3, 3) of rotation vectors (..., 3) [rad] (Rodrigues' formula)."""
    angle = np.linalg.norm(vector, axis=-1)[..., None, None]
    cross = _cross_matrix(vector)
    half = np.sinc(angle / (2 * np.pi))
    rotation: Array = np.eye(3) + np.sinc(angle / np.pi) * cross + 0.5 * half**2 * (cross @ cross)
    return rotation


def rotation_vector(rotation: Array) -> Array:
    """Rotation vectors (..., 3) [rad], of length at most pi, of rotation matrices (..., 3, 3)."""
    # The quaternion is the eigenvector to the eigenvalue 1 of this matrix: accurate near 0 and near pi.
    r = rotation
    trace = np.trace(r, axis1=-2, axis2=-1)
    outer = np.empty((*r.shape[:-2], 4, 4))
    outer[..., 0, 0] = 1 + trace
    outer[..., 0, 1:] = outer[..., 1:, 0] = _cross_vector(r)
    outer[..., 1:, 1:] = r + np.swapaxes(r, -1, -2) + (1 - trace)[..., None, None] * np.eye(3)
    best = np.argmax(np.diagonal(outer, axis1=-2, axis2=-1), axis=-1)
    quaternion = np.take_along_axis(outer, best[..., None, None], axis=-2)[..., 0, :]
    quaternion = quaternion / np.linalg.norm(quaternion, axis=-1, keepdims=True)
    quaternion = np.where(quaternion[..., :1] < 0, -quaternion, quaternion)
    sine = np.linalg.norm(quaternion[..., 1:], axis=-1)
    angle = 2 * np.arctan2(sine, quaternion[..., 0])
    factor = np.where(sine > 0, angle / np.where(sine > 0, sine, 1.0), 2.0)
    vector: Array = factor[..., None] * quaternion[..., 1:]
    return vector


def _fit(numbers: NumericMechanism, screws: JointScrews, joint: int, target: Array) -> tuple[Array, Array]:
    """Coefficients of the joint's screws nearest to `target` (..., joints, 6) and what is left of it."""
    columns = freedom_screws(numbers, screws, joint)
    goal = target[..., joint, :, None]
    scale = np.array([numbers.length] * 3 + [1.0] * 3)[:, None]
    coefficients = np.linalg.pinv(columns * scale) @ (goal * scale)
    return coefficients[..., 0], (goal - columns @ coefficients)[..., 0]


def _relative_pose(numbers: NumericMechanism, whole: BodyState, joint: int) -> tuple[Array, Array]:
    """Rotation and displacement of the joint's point of the child, seen from the parent's reference axes."""
    parent, child = numbers.parents[joint], numbers.children[joint]
    point = numbers.points[joint]
    back = np.swapaxes(whole.rotation[..., parent, :, :], -1, -2)
    present = whole.rotation[..., child, :, :] @ point + whole.translation[..., child, :]
    seen = np.einsum("...ij,...j->...i", back, present - whole.translation[..., parent, :]) - point
    return back @ whole.rotation[..., child, :, :], seen


def _displacements(numbers: NumericMechanism, joint: int, rotation: Array, shift: Array) -> Array:
    """Joint displacements that come nearest to a relative pose; see `joint_displacements`."""
    own = numbers.freedoms[joint]
    turning, axes = numbers.turns[own] > 0, numbers.axes[own]
    found = np.zeros((*shift.shape[:-1], len(own)))
    if (~turning).any():
        found[..., ~turning] = shift @ np.linalg.pinv(axes[~turning])
    if turning.sum() == 3:
        found[..., turning] = rotation_vector(rotation)
    elif turning.sum() == 2:
        first, second = axes[turning]
        back = np.swapaxes(rotation, -1, -2)
        pair = (_angle(first, second, rotation @ second), -_angle(second, first, back @ first))
        found[..., turning] = np.stack(pair, axis=-1)
    elif turning.sum() == 1:
        axis, pitch = axes[turning][0], float(numbers.slides[own][turning][0])
        sine = _cross_vector(rotation) @ axis / 2
        angle = np.arctan2(sine, (np.trace(rotation, axis1=-2, axis2=-1) - 1) / 2)
        if pitch:
            angle = angle + 2 * np.pi * np.round((shift @ axis / pitch - angle) / (2 * np.pi))
        found[..., turning] = angle[..., None]
    return found


def _pose_residual(numbers: NumericMechanism, whole: BodyState, joint: int) -> Array:
    """Rotation vector and shift (..., 6) from the pose that the displacements give to the present one."""
    rotation, shift = _relative_pose(numbers, whole, joint)
    own = numbers.freedoms[joint]
    found = _displacements(numbers, joint, rotation, shift)
    modelled = np.broadcast_to(np.eye(3), rotation.shape)
    if numbers.turns[own].sum() == 3:
        modelled = modelled @ rotation_about(found[..., numbers.turns[own] > 0])
    else:
        for k, index in enumerate(own):
            turned = numbers.turns[index] * numbers.axes[index]
            modelled = modelled @ rotation_about(found[..., k, None] * turned)
    gap = shift - (found * numbers.slides[own]) @ numbers.axes[own]
    base = whole.rotation[..., numbers.parents[joint], :, :]
    turn = rotation_vector(rotation @ np.swapaxes(modelled, -1, -2))
    both = np.stack([turn, gap], axis=-2) @ np.swapaxes(base, -1, -2)
    residual: Array = both.reshape(*both.shape[:-2], 6)
    return residual


def _angle(axis: Array, start: Array, end: Array) -> Array:
    """Angle about a unit axis from `start` (3,) to `end` (..., 3), in (-pi, pi]."""
    sine = np.cross(start, end) @ axis
    cosine = end @ start - (end @ axis) * (start @ axis)
    angle: Array = np.arctan2(sine, cosine)
    return angle


def _cross_matrix(vector: Array) -> Array:
    """Matrices (..., 3, 3) with [v] a = v x a."""
    return np.stack([np.cross(vector, unit) for unit in np.eye(3)], axis=-1)


def _cross_vector(matrix: Array) -> Array:
    """Twice the axial vector (..., 3) of the skew part of matrices (..., 3, 3)."""
    m = matrix
    pairs = ((2, 1), (0, 2), (1, 0))
    return np.stack([m[..., i, j] - m[..., j, i] for i, j in pairs], axis=-1)
