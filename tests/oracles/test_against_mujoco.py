"""Generated functions against MuJoCo: drives, reactions and accelerations of the bodies, to rounding."""

from __future__ import annotations

import numpy as np
import pytest
from support.model_states import body_states, by_joint, model, output, relative, run

from oracles.mujoco_engine import MujocoEngine
from symscrew.reference.maximal_coordinates import BodyState
from symscrew.reference.newton_euler_method import newton_euler, numeric

NAMES = ("three_ups_upu_s", "three_ups_upu_s_physical", "stewart_6ups", "delta", "four_bar", "ur5", "panda")
EXACT = 1e-9  # MuJoCo's kinematics and recursions are exact; its soft constraints are not used


def at_state(states: dict[str, BodyState], k: int) -> dict[str, BodyState]:
    return {body: BodyState(s.rotation[k], s.translation[k], s.twist[k], s.twist_rate[k]) for body, s in states.items()}


@pytest.mark.parametrize("name", NAMES)
def test_drives_and_reactions(name: str) -> None:
    found = model(name)
    q, v, a = found.system.sample_states
    states = body_states(found, q, v, a)
    engine = MujocoEngine(found.mechanism)
    drives = run(name, "inverse_dynamics", q, v, a)
    expected = np.array([engine.inverse_dynamics(at_state(states, k)) for k in range(len(q))])
    assert relative(drives, expected) < EXACT
    joints = list(found.mechanism.joints)
    reactions = by_joint(output(found, "joint_reactions", "reactions", q, v, a), joints)
    # Internal loads of an overconstrained mechanism are not unique: only the rest is compared.
    internal = newton_euler(numeric(found.mechanism), states).null_wrenches
    for k in range(len(q)):
        wanted = engine.reactions(at_state(states, k))
        difference = np.concatenate([reactions[j][k] - wanted[j] for j in joints])
        columns = np.concatenate([internal[j][k] for j in joints], axis=-2)
        if columns.shape[1]:
            basis = np.linalg.qr(columns)[0]
            difference -= basis @ (basis.T @ difference)
        assert np.abs(difference).max() < EXACT * max(np.abs(wanted[j]).max() for j in joints)


@pytest.mark.parametrize("name", NAMES)
def test_accelerations_of_the_bodies(name: str) -> None:
    """MuJoCo's forward dynamics with our drives gives the accelerations that the drives were computed for."""
    found = model(name)
    q, v, a = found.system.sample_states
    states = body_states(found, q, v, a)
    engine = MujocoEngine(found.mechanism)
    drives = run(name, "inverse_dynamics", q, v, a)
    for k in range(len(q)):
        here = at_state(states, k)
        _, rates = engine.forward_acceleration(here, drives[k])
        got = np.concatenate([here[body].twist_rate for body in rates])
        assert relative(got, np.concatenate(list(rates.values()))) < EXACT


@pytest.mark.parametrize("name", NAMES)
def test_forward_dynamics(name: str) -> None:
    """Our accelerations under random drives are those that MuJoCo's own matrices give."""
    found = model(name)
    q, v, _ = found.system.sample_states
    drives = np.random.default_rng(6).uniform(-20, 20, (len(q), len(found.system.drives)))
    states = body_states(found, q, v, run(name, "forward_dynamics", q, v, drives))
    engine = MujocoEngine(found.mechanism)
    for k in range(len(q)):
        here = at_state(states, k)
        _, rates = engine.forward_acceleration(here, drives[k])
        got = np.concatenate([here[body].twist_rate for body in rates])
        assert relative(got, np.concatenate(list(rates.values()))) < EXACT


@pytest.mark.parametrize("name", NAMES)
def test_poses_and_twists_fit_the_engine_s_tree(name: str) -> None:
    """MuJoCo's own joints reach every pose, twist and twist rate; its twist rates are those of the model."""
    found = model(name)
    q, v, a = found.system.sample_states
    states = body_states(found, q, v, a)
    engine = MujocoEngine(found.mechanism)
    for k in range(len(q)):
        here = at_state(states, k)
        engine.set_state(here)
        rates = engine.twist_rates(engine.data.qacc.copy())
        for body, rate in rates.items():
            scale = max(1.0, np.abs(rate).max())
            assert np.abs(here[body].twist_rate - rate).max() < EXACT * scale, body
