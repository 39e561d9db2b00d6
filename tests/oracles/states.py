"""Consistent random states of any mechanism without spanning tree or generated code.

The unknowns are the poses of all bodies. A state starts in the reference configuration, walks along a random
direction in the null space of the joints' constraints with Newton corrections, and gets a random admissible
velocity and acceleration.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from symscrew.description.mechanism import Mechanism
from symscrew.reference.joint_motion import constraint_residuals, joint_rates, rotation_about
from symscrew.reference.maximal_coordinates import (
    REST,
    BodyState,
    JointScrews,
    NumericMechanism,
    freedom_screws,
    joint_screws,
    numeric,
    stack_states,
)

Array = np.ndarray
States = dict[str, BodyState]
RANK = 1e-9


def random_state(mechanism: Mechanism | NumericMechanism, rng: np.random.Generator, amplitude: float = 0.3) -> States:
    """A random consistent state {body: BodyState} of the moving bodies.

    `amplitude` is roughly the largest joint displacement from the reference configuration, in rad and in
    characteristic lengths, and the scale of rates and accelerations. Raises RuntimeError without convergence.
    """
    numbers = numeric(mechanism)
    states = dict.fromkeys(numbers.bodies[1:], REST)
    rank = _rank(constraint_matrix(numbers, states)[0])
    direction = rng.standard_normal(6 * len(states))
    steps = max(1, int(np.ceil(amplitude / 0.2)))
    for _ in range(steps):
        free = _null(constraint_matrix(numbers, states)[0], rank)
        tangent = _normalised(numbers, states, free @ (free.T @ direction))
        states = _closed(numbers, _moved(numbers, states, tangent * amplitude / steps), rank)
    matrix, _ = constraint_matrix(numbers, states)
    free = _null(matrix, rank)
    velocity = free.T @ rng.standard_normal(6 * len(states))
    moving = _with_twists(numbers, states, amplitude * _normalised(numbers, states, free @ velocity))
    acceleration = free @ rng.standard_normal(free.shape[1])
    return with_acceleration(numbers, moving, amplitude * _normalised(numbers, moving, acceleration), rank)


def with_acceleration(numbers: NumericMechanism, states: States, wanted: Array, rank: int | None = None) -> States:
    """The `states` with the consistent twist rates nearest to `wanted` (6 bodies,), scaled."""
    matrix, drift = constraint_matrix(numbers, states)
    known = _rank(matrix) if rank is None else rank
    rates = wanted + _least_squares(matrix, drift - matrix @ wanted, known)
    return {
        name: replace(state, twist_rate=_to_origin(numbers, state, name, part))
        for (name, state), part in zip(states.items(), rates.reshape(-1, 6), strict=True)
    }


def constraint_matrix(numbers: NumericMechanism, states: Mapping[str, BodyState]) -> tuple[Array, Array]:
    """Constraints on the scaled twists of the moving bodies, and the right-hand side for their rates.

    Scaled coordinates of a body are (length * omega ; v at its centre); see `_centre`.
    """
    whole = stack_states(numbers, states)
    screws = joint_screws(numbers, whole)
    rates = joint_rates(numbers, states)
    rows, drifts = [], []
    for j, name in enumerate(numbers.joints):
        forbidden, scale = _forbidden(numbers, screws, j)
        row = np.zeros((len(forbidden), 6 * len(numbers.bodies)))
        for body, sign in ((numbers.children[j], 1.0), (numbers.parents[j], -1.0)):
            arm = screws.point[j] - _centre(numbers, whole, body)
            shift = np.eye(6)
            shift[3:, :3] = -_cross_matrix(arm) / numbers.length
            row[:, 6 * body : 6 * body + 6] = sign * forbidden @ shift
        own = numbers.freedoms[j]
        turning, sliding = rates[name] * numbers.turns[own], rates[name] * numbers.slides[own]
        axis_dot = screws.axis_dot[own]
        spin = turning @ screws.axis[own]
        joint_drift = np.concatenate(
            [turning @ axis_dot, sliding @ axis_dot + np.cross(screws.point_velocity[j], spin)]
        )
        # Rates of the scaled twists are taken at fixed points of space: no further terms.
        rows.append(row[:, 6:])
        drifts.append(forbidden @ (joint_drift * scale))
    return np.concatenate(rows), np.concatenate(drifts)


def _forbidden(numbers: NumericMechanism, screws: JointScrews, joint: int) -> tuple[Array, Array]:
    """Orthonormal scaled relative twists (6 - freedom, 6) that a joint forbids, and the scale (6,)."""
    scale = np.array([numbers.length] * 3 + [1.0] * 3)
    columns = freedom_screws(numbers, screws, joint) * scale[:, None]
    return np.linalg.qr(columns, mode="complete").Q[:, columns.shape[1] :].T, scale


def _closed(numbers: NumericMechanism, states: States, rank: int) -> States:
    for _ in range(30):
        residuals = constraint_residuals(numbers, states)
        whole = stack_states(numbers, states)
        screws = joint_screws(numbers, whole)
        gaps = []
        for j, name in enumerate(numbers.joints):
            forbidden, scale = _forbidden(numbers, screws, j)
            gaps.append(forbidden @ (residuals[name][0] * scale))
        gap = np.concatenate(gaps)
        if np.abs(gap).max(initial=0.0) < 1e-14 * max(1.0, numbers.length):
            return states
        matrix, _ = constraint_matrix(numbers, states)
        states = _moved(numbers, states, _least_squares(matrix, -gap, rank))
    if np.abs(gap).max() < 1e-12 * max(1.0, numbers.length):
        return states
    raise RuntimeError(f"{numbers.mechanism.name}: no closure, the largest gap is {np.abs(gap).max():.1e}")


def _moved(numbers: NumericMechanism, states: States, step: Array) -> States:
    """Bodies turned and shifted by a finite scaled step about their centres."""
    moved = {}
    for (name, state), part in zip(states.items(), step.reshape(-1, 6), strict=True):
        turn = rotation_about(part[:3] / numbers.length)
        centre = _body_centre(numbers, state, name)
        translation = turn @ (state.translation - centre) + centre + part[3:]
        rotation = turn @ state.rotation
        u, _, v = np.linalg.svd(rotation)  # back to orthogonal to rounding
        moved[name] = BodyState(u @ v, translation, np.zeros(6), np.zeros(6))
    return moved


def _with_twists(numbers: NumericMechanism, states: States, scaled: Array) -> States:
    return {
        name: replace(state, twist=_to_origin(numbers, state, name, part))
        for (name, state), part in zip(states.items(), scaled.reshape(-1, 6), strict=True)
    }


def _to_origin(numbers: NumericMechanism, state: BodyState, name: str, scaled: Array) -> Array:
    angular = scaled[:3] / numbers.length
    return np.concatenate([angular, scaled[3:] - np.cross(angular, _body_centre(numbers, state, name))])


def _normalised(numbers: NumericMechanism, states: States, scaled: Array) -> Array:
    """A scaled motion whose largest joint rate is 1 (in rad and characteristic lengths), or 0."""
    if not scaled.any():
        return scaled
    rates = joint_rates(numbers, _with_twists(numbers, states, scaled))
    sizes = []
    for name, own in zip(numbers.joints, numbers.freedoms, strict=True):
        sizes += list(np.abs(rates[name]) * np.where(numbers.turns[own] > 0, 1.0, 1 / numbers.length))
    return scaled / max(sizes) if max(sizes, default=0.0) > 0 else scaled


def _centre(numbers: NumericMechanism, whole: BodyState, body: int) -> Array:
    """Present place of the mean of the body's joint points (m)."""
    mine = (numbers.parents == body) | (numbers.children == body)
    return whole.rotation[body] @ numbers.points[mine].mean(axis=0) + whole.translation[body]


def _body_centre(numbers: NumericMechanism, state: BodyState, name: str) -> Array:
    body = numbers.bodies.index(name)
    mine = (numbers.parents == body) | (numbers.children == body)
    return state.rotation @ numbers.points[mine].mean(axis=0) + state.translation


def _rank(matrix: Array) -> int:
    values = np.linalg.svd(matrix, compute_uv=False)
    return int((values > RANK * values.max(initial=0.0)).sum())


def _null(matrix: Array, rank: int) -> Array:
    return np.linalg.svd(matrix)[2][rank:].T


def _least_squares(matrix: Array, right: Array, rank: int) -> Array:
    u, s, v = np.linalg.svd(matrix, full_matrices=False)
    return v[:rank].T @ ((u[:, :rank].T @ right) / s[:rank])


def _cross_matrix(a: Array) -> Array:
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
