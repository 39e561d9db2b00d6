"""Made-up mechanisms against d'Alembert's principle in maximal coordinates, which knows no tree and no closure.

Six coordinates per body, and the constraints of every joint by the wrenches that it can take: accelerations are those
nearest to the free ones, in the metric of the masses, that all joints allow (Gauss's principle). Redundant constraints
of overconstrained loops change nothing in it. Poses are integrated by SciPy.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from support.invented_mechanisms import INVENTED, invented
from support.marks import slow
from support.model_states import body_states

from oracles.states import constraint_matrix
from symscrew.effects import Gravity
from symscrew.model import Model, derive
from symscrew.reference import newton_euler
from symscrew.reference.joint_motion import constraint_residuals, joint_rates
from symscrew.reference.maximal_coordinates import (
    BodyState,
    NumericMechanism,
    cross,
    joint_screws,
    numeric,
    stack_states,
)
from symscrew.scene import Scene
from symscrew.scene.contents import Initial
from symscrew.simulation import simulate

Array = np.ndarray
States = dict[str, BodyState]
DOWN = np.array([0.0, 0.0, -9.81])
RANK = 1e-8  # of singular values of all constraints, by the largest: of these mechanisms none is between 1e-13 and 1e-3
KINDS = {"R", "P", "H", "C", "U", "S", "E", "fixed", "free"}
DRIVE = 3.0


@cache
def model(name: str) -> Model:
    return derive(invented(name), [Gravity()])


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
    """Force and moment about O on the two bodies of the driven freedom."""
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


def test_they_are_twelve_and_more_with_every_joint_type() -> None:
    assert len(INVENTED) >= 12
    assert {joint[0] for joints in INVENTED.values() for joint in joints} == KINDS


QUICK = ("screw_press", "slide_cross_ball")


@pytest.mark.parametrize("name", [name if name in QUICK else slow(name) for name in INVENTED])
def test_accelerations_are_those_of_maximal_coordinates(name: str) -> None:
    """At random states: bodies fit their joints, and accelerate as Gauss's principle says; the drive is the one that
    Newton's and Euler's equations of every body need for that."""
    found = model(name)
    numbers = numeric(found.mechanism)
    q, v, _ = found.system.sample_states
    (a, *_), status = found("forward_dynamics", q, v, np.full((len(q), 1), DRIVE))
    assert np.all(np.asarray(status) <= 0)
    states = body_states(found, q, v, a)
    for residuals in constraint_residuals(numbers, states).values():
        assert max(np.abs(r).max() for r in residuals[:2]) < 1e-10 * max(1.0, numbers.length)
    for k in range(min(3, len(q))):
        one = at(states, k)
        expected = gauss(numbers, one, DRIVE)
        size = max(1.0, *(float(np.abs(rate).max()) for rate in expected.values()))
        for body, rate in expected.items():
            assert np.abs(one[body].twist_rate - rate).max() < 1e-8 * size, body
        if (
            abs(joint_rates(numbers, one)["J0"][0]) > 1e-6
        ):  # where the drive does no work, no motion says how large it is
            assert newton_euler(numbers, one, gravity=DOWN).drives == pytest.approx([DRIVE], abs=1e-7 * size)


@pytest.mark.parametrize(
    "name", [slow(n) for n in ("threads_in_a_ring", "thread_ball_cross", "two_loops", "table_and_flyer")]
)
def test_motions_are_those_of_maximal_coordinates(name: str) -> None:
    """A fall of 0.3 s from the reference configuration, integrated over 6 coordinates per body."""
    scene = Scene(name, invented(name), (Gravity(),), 0.3, 10.0, Initial(rates={}))
    run = simulate(scene)
    assert run.ok, run.status
    found = model(name)
    numbers = numeric(found.mechanism)
    last = at(body_states(found, run.q[-1:], run.v[-1:], 0 * run.v[-1:]), 0)
    bodies = numbers.bodies[1:]

    def states_of(y: Array) -> States:
        made = {}
        for k, body in enumerate(bodies):
            turned = y[12 * k : 12 * k + 9].reshape(3, 3)
            made[body] = BodyState(turned, y[12 * k + 9 : 12 * k + 12], y[12 * len(bodies) + 6 * k :][:6], np.zeros(6))
        return made

    def slopes(_: float, y: Array) -> Array:
        states = states_of(y)
        rates = gauss(numbers, states, 0.0)
        moved = [
            np.concatenate([cross(s.twist[None, :3], s.rotation.T).T.ravel(), s.velocity_at(s.translation)])
            for s in states.values()
        ]
        return np.concatenate([*moved, *(rates[body] for body in bodies)])

    start = np.concatenate([*(np.r_[np.eye(3).ravel(), np.zeros(3)] for _ in bodies), np.zeros(6 * len(bodies))])
    end = solve_ivp(slopes, (0.0, 0.3), start, method="DOP853", rtol=1e-9, atol=1e-11).y[:, -1]
    for body, state in states_of(end).items():
        assert np.abs(state.rotation - last[body].rotation).max() < 1e-7, body
        assert np.abs(state.translation - last[body].translation).max() < 1e-7, body
        assert np.abs(state.twist - last[body].twist).max() < 1e-6, body
