"""Accelerations of mechanisms by Gauss's principle in maximal coordinates, which knows no tree and no closure.

Six coordinates per body, and the constraints of every joint by the wrenches that it can take: accelerations are those
nearest to the free ones, in the metric of the masses, that all joints allow. Redundant constraints of overconstrained
loops change nothing in it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from oracles.states import constraint_matrix

from support.model_states import body_states
from symscrew.model import Model
from symscrew.reference import newton_euler
from symscrew.reference.joint_motion import constraint_residuals, joint_rates
from symscrew.reference.maximal_coordinates import (
    BodyState,
    NumericMechanism,
    joint_screws,
    numeric,
    stack_states,
)

Array = np.ndarray
States = dict[str, BodyState]
DOWN = np.array([0.0, 0.0, -9.81])
RANK = 1e-8  # of singular values of all constraints, by the largest: of these mechanisms none is between 1e-13 and 1e-3
WORKS = 1e-6  # rate of the driven joint [rad/s, m/s] below which no motion says how large its drive is


@dataclass(frozen=True)
class Differences:
    """The largest at some states: `joints`, how far bodies are off their joints; `accelerations` and `drives`, by the
    largest acceleration or 1. `open_rows`: constraints of all joints that others hold already."""

    joints: float
    accelerations: float
    drives: float
    open_rows: int


def differences(found: Model, drive: float, states: int = 3) -> Differences:
    """Between a model's forward dynamics and Gauss's principle, under gravity and a force on the driven freedom; and
    between that force and the one that Newton's and Euler's equations of every body need for the motion."""
    numbers = numeric(found.mechanism)
    q, v, _ = found.system.sample_states
    (a, *_), status = found("forward_dynamics", q, v, np.full((len(q), 1), drive))
    assert np.all(np.asarray(status) <= 0)
    several = body_states(found, q, v, a)
    away = max(max(float(np.abs(r).max()) for r in residuals[:2])
               for residuals in constraint_residuals(numbers, several).values())  # fmt: skip
    gains, forces = [0.0], [0.0]
    for k in range(min(states, len(q))):
        one = at(several, k)
        expected = gauss(numbers, one, drive)
        size = max(1.0, *(float(np.abs(rate).max()) for rate in expected.values()))
        gains += [float(np.abs(one[body].twist_rate - rate).max()) / size for body, rate in expected.items()]
        if abs(joint_rates(numbers, one)["J0"][0]) > WORKS:
            forces.append(float(abs(newton_euler(numbers, one, gravity=DOWN).drives[0] - drive)) / size)
    matrix, _ = constraint_matrix(numbers, at(several, 0))
    values = np.linalg.svd(matrix, compute_uv=False)
    redundant = len(matrix) - int((values > RANK * values.max(initial=0.0)).sum())
    return Differences(away / max(1.0, numbers.length), max(gains), max(forces), redundant)


def gauss(numbers: NumericMechanism, states: Mapping[str, BodyState], drive: float) -> dict[str, Array]:
    """Twist rates (6,) of the bodies, (alpha ; d v_O/dt), under gravity and a force on the driven freedom."""
    matrix, drift = constraint_matrix(numbers, states)
    bodies = numbers.bodies[1:]
    count = len(bodies)
    mass, load, seen = np.zeros((6 * count, 6 * count)), np.zeros(6 * count), np.zeros((6 * count, 6 * count))
    pushed = _drive(numbers, states, drive)
    for k, name in enumerate(bodies):
        state, part = states[name], slice(6 * k, 6 * k + 6)
        com, omega = state.rotation @ numbers.com[k + 1] + state.translation, state.twist[:3]
        turned = state.rotation @ numbers.inertia[k + 1] @ state.rotation.T
        force, moment = pushed.get(name, (np.zeros(3), np.zeros(3)))
        mass[part, part][:3, :3], mass[part, part][3:, 3:] = turned, numbers.mass[k + 1] * np.eye(3)
        weight = numbers.mass[k + 1] * (DOWN - np.cross(omega, state.velocity_at(com)))
        load[part] = [*(moment - np.cross(com, force) - np.cross(omega, turned @ omega)), *(force + weight)]
        mine = (numbers.parents == k + 1) | (numbers.children == k + 1)
        centre = state.rotation @ numbers.points[mine].mean(axis=0) + state.translation
        arm = centre - com  # scaled twists count at the middle of the joints, these at the centre of mass
        seen[part, part][:3, :3], seen[part, part][3:, 3:] = numbers.length * np.eye(3), np.eye(3)
        seen[part, part][3:, :3] = -np.array([[0, -arm[2], arm[1]], [arm[2], 0, -arm[0]], [-arm[1], arm[0], 0]])
    allowed = matrix @ seen
    half = np.linalg.cholesky(np.linalg.inv(mass))
    free = np.linalg.solve(mass, load)
    u, s, v = np.linalg.svd(allowed @ half, full_matrices=False)
    kept = s > RANK * s.max(initial=0.0)
    pull = v[kept].T @ ((u[:, kept].T @ (drift - allowed @ free)) / s[kept])
    rates = (free + half @ pull).reshape(-1, 6)
    found = {}
    for k, name in enumerate(bodies):
        com = states[name].rotation @ numbers.com[k + 1] + states[name].translation
        found[name] = np.concatenate([rates[k, :3], rates[k, 3:] - np.cross(rates[k, :3], com)])
    return found


def _drive(numbers: NumericMechanism, states: Mapping[str, BodyState], size: float) -> dict[str, tuple[Array, Array]]:
    """Force and moment about O on the two bodies of the driven freedom; nothing where there is none."""
    if not numbers.driven:
        return {}
    screws = joint_screws(numbers, stack_states(numbers, states))
    index, joint = numbers.driven[0], 0
    axis, point = screws.axis[index], screws.point[joint]
    turning, sliding = numbers.turns[index], numbers.slides[index]
    force = axis * (sliding if not turning else 0.0)
    wrench = size * force, size * (np.cross(point, force) + axis * turning)
    ends = numbers.bodies[numbers.children[joint]], numbers.bodies[numbers.parents[joint]]
    return {ends[0]: wrench, ends[1]: (-wrench[0], -wrench[1])}


def at(several: States, k: int) -> States:
    parts = ("rotation", "translation", "twist", "twist_rate")
    return {name: BodyState(*(getattr(state, part)[k] for part in parts)) for name, state in several.items()}
