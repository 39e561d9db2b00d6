"""Method B by itself: textbook mechanisms in closed form, statics of the seed, and MuJoCo."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from functools import cache

import numpy as np
import pytest
from support.marks import slow

from oracles import mechanisms
from oracles.mujoco_engine import MujocoEngine
from oracles.states import random_state
from symscrew import catalogue
from symscrew.description.mechanism import Mechanism
from symscrew.reference.newton_euler_method import (
    BodyState,
    NewtonEulerSolution,
    constraint_residuals,
    joint_displacements,
    joint_rates,
    newton_euler,
    numeric,
)

Array = np.ndarray
TOLERANCE = 1e-9
HAND_TYPED = {"spatial_loop": mechanisms.spatial_loop, "mixed_loop": mechanisms.mixed_loop}
COUPLED = {"differential", "gear_train"}
LIKE_THE_SEED = {"stewart_6ups", "three_ups_upu_s_physical"}
ALL = [*HAND_TYPED, *(name for name in catalogue.names() if name not in COUPLED | LIKE_THE_SEED)]
# random states of bodies know joints, not couplings: method B with couplings is held against in test_model


def test_all_others_have_no_couplings() -> None:
    assert {name for name in catalogue.names() if catalogue.load(name).couplings} == COUPLED


@cache
def mechanism_named(name: str) -> Mechanism:
    return HAND_TYPED[name]() if name in HAND_TYPED else catalogue.load(name)


def seeded(name: str) -> np.random.Generator:
    return np.random.default_rng(list(name.encode()))


def random_loads(mechanism: Mechanism, rng: np.random.Generator) -> dict[str, Array]:
    return {b: 10 * rng.standard_normal(6) for b in mechanism.bodies if b != mechanism.ground}


def stacked(wrenches: Mapping[str, Array]) -> Array:
    return np.concatenate(list(wrenches.values()))


def at_rest(mechanism: Mechanism) -> dict[str, BodyState]:
    rest = BodyState(np.eye(3), np.zeros(3), np.zeros(6), np.zeros(6))
    return dict.fromkeys((b for b in mechanism.bodies if b != mechanism.ground), rest)


def moving_about(axis: Array, angle: tuple[float, float, float], start: Array, motion: Array) -> BodyState:
    """A body turned by an angle (with its two rates) about an axis; its point from `start` moves as `motion`.

    `motion` (3, 3) holds the point's present place, velocity and acceleration.
    """
    sine, cosine = math.sin(angle[0]), math.cos(angle[0])
    cross = np.cross(axis, np.eye(3)).T
    rotation = np.eye(3) + sine * cross + (1 - cosine) * cross @ cross
    place, velocity, acceleration = motion
    omega, alpha = angle[1] * axis, angle[2] * axis
    linear_rate = acceleration - np.cross(alpha, place) - np.cross(omega, velocity)
    return BodyState(
        rotation,
        place - rotation @ start,
        np.r_[omega, velocity - np.cross(omega, place)],
        np.r_[alpha, linear_rate],
    )


X, Y, Z = np.eye(3)
FIXED = np.zeros((3, 3))


def test_pendulum_torque_and_pivot_force() -> None:
    length, mass, inertia, angle, rate, acceleration = 1.2, 2.0, 0.3, 0.7, 1.9, -0.8
    pendulum = mechanisms.pendulum(mechanisms.exact(length), mass, inertia)
    states = {"rod": moving_about(X, (angle, rate, acceleration), np.zeros(3), FIXED)}
    found = newton_euler(pendulum, states)
    half = length / 2
    torque = (inertia + mass * half**2) * acceleration + mass * 9.81 * half * math.sin(angle)
    down = np.array([0, math.sin(angle), -math.cos(angle)])
    ahead = np.array([0, math.cos(angle), math.sin(angle)])
    force = mass * (half * acceleration * ahead - half * rate**2 * down + 9.81 * Z)
    assert found.drives == pytest.approx([torque], rel=1e-13)
    assert found.drive_wrenches["pivot"] == pytest.approx([0, 0, 0, torque, 0, 0], rel=1e-13)
    assert found.reactions["pivot"] == pytest.approx(np.r_[force, 0, 0, 0], rel=1e-13, abs=1e-13)
    assert found.redundancy == 0 and found.residual < 1e-14
    assert joint_displacements(pendulum, states)["pivot"] == pytest.approx([angle], rel=1e-14)


def test_screw_jack_counts_turns_and_lifts_with_its_pitch() -> None:
    pitch, mass, inertia, angle, rate, acceleration = 0.05, 3.0, 0.2, 17.0, 2.0, 5.0
    nut = mechanisms.body("nut", mass, (0, 0, 0), mechanisms.diagonal(inertia, inertia, inertia))
    screw = mechanisms.joint(
        "screw", "H", "ground", "nut", (0, 0, 0), (0, 0, 1), driven=(0,), pitch=mechanisms.exact(pitch)
    )
    jack = mechanisms.mechanism("jack", [nut], [screw])
    motion = pitch * np.array([angle, rate, acceleration])[:, None] * Z
    states = {"nut": moving_about(Z, (angle, rate, acceleration), np.zeros(3), motion)}
    torque = inertia * acceleration + pitch * mass * (9.81 + pitch * acceleration)
    assert newton_euler(jack, states).drives == pytest.approx([torque], rel=1e-13)
    assert joint_displacements(jack, states)["screw"] == pytest.approx([angle], rel=1e-14)
    assert np.abs(stacked({k: np.r_[v] for k, v in constraint_residuals(jack, states).items()})).max() < 1e-14


@pytest.mark.parametrize("angle", [0.4, 2.5, -1.2])
def test_slider_crank_of_the_textbook(angle: float) -> None:
    a, b, g, rate, acceleration = 0.2, 0.5, 9.81, 3.0, -7.0
    (m1, m2, m3), (i1, i2) = (1.1, 0.7, 2.3), (0.02, 0.03)
    crank = mechanisms.slider_crank(mechanisms.exact(a), mechanisms.exact(b), (m1, m2, m3), (i1, i2))
    sine, cosine = math.sin(angle), math.cos(angle)
    # Angle of the coupler: a sin(angle) + b sin(tilt) = 0, differentiated twice.
    tilt = math.asin(-a * sine / b)
    s, c = math.sin(tilt), math.cos(tilt)
    tilt_dot = -a * cosine * rate / (b * c)
    tilt_ddot = (a * sine * rate**2 - a * cosine * acceleration + b * s * tilt_dot**2) / (b * c)
    pin = a * np.array(
        [
            [cosine, sine, 0],
            [-sine * rate, cosine * rate, 0],
            [-cosine * rate**2 - sine * acceleration, -sine * rate**2 + cosine * acceleration, 0],
        ]
    )
    arm = b * np.array(
        [
            [c, s, 0],
            [-s * tilt_dot, c * tilt_dot, 0],
            [-c * tilt_dot**2 - s * tilt_ddot, -s * tilt_dot**2 + c * tilt_ddot, 0],
        ]
    )
    slider = pin + arm
    states = {
        "crank": moving_about(Z, (angle, rate, acceleration), np.zeros(3), FIXED),
        "coupler": moving_about(Z, (tilt, tilt_dot, tilt_ddot), np.array([a, 0, 0]), pin),
        "slider": moving_about(Z, (0, 0, 0), np.array([a + b, 0, 0]), slider),
    }
    for residuals in constraint_residuals(crank, states).values():
        assert np.abs(residuals).max() < 1e-13
    displacements, rates = joint_displacements(crank, states), joint_rates(crank, states)
    assert displacements["crank_pin"] == pytest.approx([tilt - angle], rel=1e-13)
    assert displacements["guide"] == pytest.approx([slider[0, 0] - a - b], rel=1e-13)
    assert rates["guide"] == pytest.approx([slider[1, 0]], rel=1e-13)

    centre = (pin + arm / 2)[2]
    x3 = m3 * slider[2, 0]
    x2 = x3 + m2 * centre[0]
    lift = m2 * (centre[1] + g)
    y3 = ((s * (x2 + x3) - 2 * i2 * tilt_ddot / b) / c - lift) / 2
    y2 = y3 + lift
    swing = (i1 + m1 * a**2 / 4) * acceleration + m1 * g * a / 2 * cosine
    torque = swing + a * (cosine * y2 - sine * x2)
    found = newton_euler(crank, states, gravity=(0, -g, 0))
    assert found.drives == pytest.approx([torque], rel=1e-12)
    bearing = [m1 * pin[2, 0] / 2 + x2, m1 * (pin[2, 1] / 2 + g) + y2]
    for joint, force in {
        "main": bearing,
        "crank_pin": [x2, y2],
        "wrist_pin": [x3, y3],
        "guide": [0, m3 * g - y3],
    }.items():
        assert found.reactions[joint][:2] == pytest.approx(force, rel=1e-12, abs=1e-12)
        assert found.unique[joint].tolist() == [True, True, False, False, False, True]
    assert (found.drive_redundancy, found.reaction_redundancy) == (0, 3)


@pytest.mark.parametrize("name", ["hand-typed", "three_ups_upu_s", "three_ups_upu_s_physical"])
def test_statics_of_the_seed_by_hand(name: str) -> None:
    seed = mechanisms.seed() if name == "hand-typed" else catalogue.load(name)
    platform = seed.platform or "platform"
    centre, force = np.array([0, 0, 0.3 * math.sqrt(3)]), np.array([0, 0, 1000.0])
    load = np.r_[force, np.cross(centre, force) + 1000.0 * X]
    found = newton_euler(seed, at_rest(seed), loads={platform: load})
    leg = 500 / (0.8 * math.cos(math.pi / 6))
    assert leg == pytest.approx(721.688, abs=5e-4)
    assert found.drives == pytest.approx([0, leg, 0, -leg], rel=1e-12, abs=1e-9)
    assert (found.drive_redundancy, found.reaction_redundancy) == (2, 0)


def compare(found: NewtonEulerSolution, engine: dict[str, Array], drives: Array) -> None:
    """Drives, the unique reaction components, and all reactions up to internal loads."""
    size = max(1.0, np.abs(drives).max(initial=0.0))
    assert np.abs(found.drives - drives).max(initial=0.0) < TOLERANCE * size
    size = max(size, np.abs(stacked(engine)).max())
    difference = stacked(engine) - stacked(found.reactions)
    assert np.abs(difference[stacked(found.unique)]).max(initial=0.0) < TOLERANCE * size
    internal = stacked(found.null_wrenches)
    if internal.shape[1]:
        difference = difference - internal @ np.linalg.lstsq(internal, difference, rcond=1e-9)[0]
    assert np.abs(difference).max() < TOLERANCE * size


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_agrees_with_mujoco(name: str) -> None:
    mechanism, rng = mechanism_named(name), seeded(name)
    numbers, engine = numeric(mechanism), MujocoEngine(mechanism)
    for amplitude in (0.1, 0.4):
        states, loads = random_state(numbers, rng, amplitude), random_loads(mechanism, rng)
        found = newton_euler(numbers, states, loads=loads)
        assert found.residual < TOLERANCE
        compare(found, engine.reactions(states, loads), engine.inverse_dynamics(states, loads))
        _, rates = engine.forward_acceleration(states, found.drives, loads)
        _, coasting = engine.forward_acceleration(states, np.zeros_like(found.drives), loads)
        for body, rate in rates.items():
            size = max(1.0, *(np.abs(c).max() for c in coasting.values()))
            assert np.abs(rate - states[body].twist_rate).max() < TOLERANCE * size


@pytest.mark.parametrize("name", [slow(name) if name in ("delta", "planar_3rrr", "andrews") else name for name in ALL])
def test_random_states_keep_all_joints_and_the_power_balance(name: str) -> None:
    mechanism, rng = mechanism_named(name), seeded(name)
    numbers = numeric(mechanism)
    states, loads = random_state(numbers, rng, 0.3), random_loads(mechanism, rng)
    for residuals in constraint_residuals(numbers, states).values():
        assert np.abs(residuals).max() < 1e-12 * max(1.0, numbers.length)
    found = newton_euler(numbers, states, loads=loads)
    power, size = 0.0, 0.0
    for i, body in enumerate(numbers.bodies[1:], start=1):
        state = states[body]
        com = state.rotation @ numbers.com[i] + state.translation
        turned = state.rotation @ numbers.inertia[i] @ state.rotation.T
        force = numbers.mass[i] * (state.acceleration_at(com) + 9.81 * Z)
        terms = [
            force @ state.velocity_at(com),
            state.twist[:3] @ turned @ state.twist_rate[:3],
            -(state.twist[3:] @ loads[body][:3] + state.twist[:3] @ loads[body][3:]),
        ]
        power, size = power + sum(terms), size + sum(map(abs, terms))
    rates = joint_rates(numbers, states)
    driven = np.concatenate([rates[j.name][list(j.driven)] for j in mechanism.joints.values() if j.driven])
    assert found.drives @ driven == pytest.approx(power, abs=TOLERANCE * max(size, 1.0))


def test_undriven_freedoms_move_as_the_engine_says() -> None:
    arm = catalogue.load("ur5")
    loose = list(arm.joints)[1::2]
    joints = {n: dataclasses.replace(j, driven=()) if n in loose else j for n, j in arm.joints.items()}
    arm = dataclasses.replace(arm, joints=joints)
    rng, engine = seeded("ur5"), MujocoEngine(arm)
    states = random_state(arm, rng, 0.5)
    drives = rng.standard_normal(len(numeric(arm).driven))
    assert newton_euler(arm, states).residual > 1e-3
    _, rates = engine.forward_acceleration(states, drives)
    moving = {name: dataclasses.replace(state, twist_rate=rates[name]) for name, state in states.items()}
    found = newton_euler(arm, moving)
    assert found.drives == pytest.approx(drives, abs=1e-9)
    assert found.residual < TOLERANCE


@pytest.mark.slow
def test_many_states_at_once_give_what_each_gives_alone() -> None:
    for name in ("three_ups_upu_s_physical", "four_bar"):
        mechanism, rng = catalogue.load(name), seeded(name)
        numbers = numeric(mechanism)
        several = [random_state(numbers, rng, 0.2) for _ in range(3)] * 50
        parts = ("rotation", "translation", "twist", "twist_rate")
        together = {
            body: BodyState(*(np.stack([getattr(s[body], part) for s in several]) for part in parts))
            for body in several[0]
        }
        batch = newton_euler(numbers, together)
        assert batch.drives.shape == (150, len(numbers.driven))
        for i in (0, 1, 2, 149):
            alone = newton_euler(mechanism, several[i])
            assert batch.drives[i] == pytest.approx(alone.drives, rel=1e-11, abs=1e-11)
            for joint, reaction in alone.reactions.items():
                assert batch.reactions[joint][i] == pytest.approx(reaction, rel=1e-9, abs=1e-9)
                assert batch.unique[joint][i].tolist() == alone.unique[joint].tolist()


def test_weights_and_preload_of_redundant_drives() -> None:
    seed, rng = catalogue.load("three_ups_upu_s_physical"), seeded("weights")
    numbers = numeric(seed)
    states, weights = random_state(numbers, rng, 0.3), np.array([1.0, 2.0, 5.0, 0.5])
    plain = newton_euler(numbers, states, weights=weights)
    tense = newton_euler(numbers, states, weights=weights, preload=[100.0, 0, 0, 0])
    change = tense.drives - plain.drives
    assert tense.residual < 1e-12 and np.linalg.norm(change) > 1
    # Least weighted norm: orthogonal in the weights to every drive that moves nothing.
    assert (weights * plain.drives) @ change == pytest.approx(0, abs=1e-9)
    assert np.linalg.norm(newton_euler(numbers, states).drives) < np.linalg.norm(plain.drives)


@pytest.mark.slow
def test_residuals_find_what_does_not_fit() -> None:
    numbers = numeric(catalogue.load("three_ups_upu_s"))
    states = random_state(numbers, seeded("fit"), 0.3)
    wrong = dict(states)
    body = numbers.bodies[numbers.children[0]]
    shifted = states[body].translation + 1e-3
    wrong[body] = dataclasses.replace(states[body], translation=shifted)
    position, _, _ = constraint_residuals(numbers, wrong)[numbers.joints[0]]
    assert np.linalg.norm(position[3:]) == pytest.approx(1e-3 * math.sqrt(3), rel=1e-6)
    rate = states[body].twist_rate + 1e-3 * np.eye(6)[3]
    wrong[body] = dataclasses.replace(states[body], twist_rate=rate)
    _, velocity, acceleration = constraint_residuals(numbers, wrong)[numbers.joints[0]]
    assert np.abs(velocity).max() < 1e-12
    assert np.linalg.norm(acceleration) > 1e-4


def test_bad_input_is_named() -> None:
    seed = catalogue.load("three_ups_upu_s")
    states = at_rest(seed)
    body = next(iter(states))
    with pytest.raises(ValueError, match=rf"missing: \['{body}'\]"):
        newton_euler(seed, {name: state for name, state in states.items() if name != body})
    with pytest.raises(ValueError, match=r"not in the mechanism: \['ghost'\]"):
        newton_euler(seed, {**states, "ghost": states[body]})
    with pytest.raises(ValueError, match=rf"twist of body '{body}' with last axes \(6,\), got shape \(5,\)"):
        newton_euler(seed, {**states, body: dataclasses.replace(states[body], twist=np.zeros(5))})
    with pytest.raises(ValueError, match=rf"finite numbers in translation of body '{body}'"):
        newton_euler(seed, {**states, body: dataclasses.replace(states[body], translation=np.nan * X)})
    with pytest.raises(ValueError, match=r"expected loads on bodies .* got \['ghost'\]"):
        newton_euler(seed, states, loads={"ghost": np.zeros(6)})
    with pytest.raises(ValueError, match="expected 4 finite weights, one per drive"):
        newton_euler(seed, states, weights=[1.0, 2.0])
    with pytest.raises(ValueError, match="expected positive weights"):
        newton_euler(seed, states, weights=[1.0, 2.0, 0.0, 1.0])


def test_engine_refuses_states_that_its_joints_forbid() -> None:
    mechanism = catalogue.load("four_bar")
    states = random_state(mechanism, seeded("four_bar"), 0.3)
    body = next(iter(states))
    wrong = dataclasses.replace(states[body], translation=states[body].translation + 1e-3 * Z)
    with pytest.raises(ValueError, match="off what its joint"):
        MujocoEngine(mechanism).set_state({**states, body: wrong})
