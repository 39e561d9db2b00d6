"""Made-up mechanisms against Gauss's principle in maximal coordinates (`support.gauss_principle`); poses are integrated
by SciPy."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from support.gauss_principle import at, differences, gauss
from support.invented_mechanisms import INVENTED, invented
from support.marks import slow
from support.model_states import body_states, output

from symscrew.effects import Gravity
from symscrew.model import Model, derive
from symscrew.reference import newton_euler
from symscrew.reference.maximal_coordinates import BodyState, cross, numeric
from symscrew.scene import Scene
from symscrew.scene.contents import Initial
from symscrew.simulation import simulate

Array = np.ndarray
States = dict[str, BodyState]
KINDS = {"R", "P", "H", "C", "U", "S", "E", "fixed", "free"}
DRIVE = 3.0


@cache
def model(name: str) -> Model:
    return derive(invented(name), [Gravity()])


def test_they_are_twelve_and_more_with_every_joint_type() -> None:
    assert len(INVENTED) >= 12
    assert {joint[0] for joints in INVENTED.values() for joint in joints} == KINDS


QUICK = ("screw_press", "slide_cross_ball")


@pytest.mark.parametrize("name", [name if name in QUICK else slow(name) for name in INVENTED])
def test_accelerations_are_those_of_maximal_coordinates(name: str) -> None:
    """At random states: bodies fit their joints, and accelerate as Gauss's principle says; the drive is the one that
    Newton's and Euler's equations of every body need for that."""
    found = differences(model(name), DRIVE)
    assert found.joints < 1e-10
    assert found.accelerations < 1e-8
    assert found.drives < 1e-7


OVERCONSTRAINED = ("screw_press", "crossed_slides", "tilted_four_bar", "folding_plate", "bennett_moved")


@pytest.mark.parametrize("name", [name if name == "screw_press" else slow(name) for name in OVERCONSTRAINED])
def test_internal_loads_of_least_norm_are_those_of_newton_and_euler(name: str) -> None:
    """Reactions that redundant constraints leave free, too: about the joints' own points, wherever links begin."""
    found = model(name)
    q, v, _ = found.system.sample_states
    (a,), status = found("forward_dynamics", q, v, np.full((len(q), 1), DRIVE))
    assert not np.any(status)
    (_, reactions), status = found("joint_reactions", q, v, a)
    assert not np.any(status)
    states = body_states(found, q, v, a)
    expected = newton_euler(found.mechanism, states)
    assert expected.reaction_redundancy.max() > 0
    points = output(found, "joint_points", "points", q).reshape(len(q), -1, 3)
    for k, (joint, wrench) in enumerate(expected.reactions.items()):
        size = max(1.0, float(np.abs(wrench).max()))
        assert np.abs(reactions[:, 6 * k : 6 * k + 6] - wrench).max() < 1e-9 * size
        child = states.get(found.mechanism.joints[joint].child)
        at = np.array(found.mechanism.joints[joint].point, dtype=float)
        carried = at if child is None else child.rotation @ at + child.translation
        assert np.abs(points[:, k] - carried).max() < 1e-12


@pytest.mark.parametrize("name", [slow("threads_in_a_ring"), slow("table_and_flyer")])
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
