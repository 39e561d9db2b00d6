"""Drives, end stops and load-dependent friction against hand formulas, brought to bodies as loads of method B."""

from __future__ import annotations

import numpy as np
import pytest
from support.effect_oracles import (
    CRANK,
    EXACT,
    G,
    call,
    drives,
    effect,
    input_of,
    inverse,
    oracle,
    relative,
    with_effects,
)

from symscrew import catalogue
from symscrew.effects.effect import Effect
from symscrew.effects.gravity import Gravity
from symscrew.reference.maximal_coordinates import BodyState

SMOOTH = 0.01  # m/s or rad/s: width of the smooth form of friction


def faded(rate: np.ndarray) -> np.ndarray:
    return -rate / np.sqrt(rate**2 + SMOOTH**2)


# -- end stops ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("exponent", [1, "1.5", 2])
@pytest.mark.parametrize("damping", [0, "0.4", 3])
def test_end_stop_pushes_back_and_never_pulls(exponent: object, damping: object) -> None:
    of, n, h = oracle(CRANK), float(exponent), float(damping)
    s, rate = of.displacement("slider_P"), of.rate("slider_P")
    lower, upper = (float(f"{np.quantile(s, x):.4f}") for x in (0.35, 0.65))
    stop = effect("EndStop", "slider_P", lower, upper, 1000, exponent, damping)
    found = inverse(CRANK, stop)
    force = np.zeros(len(s))
    for end, sign in ((lower, -1), (upper, 1)):
        depth = np.maximum(0, sign * (s - end))
        force -= sign * 1000 * depth**n * np.maximum(0, 1 + h * sign * rate)
    assert ((force > 0).any() and (force < 0).any()) and (force == 0).any()
    assert relative(drives(found), of.solve(of.along("slider_P", force)).drives) < EXACT


def test_end_stop_only_dissipates_and_a_bounce_loses_energy() -> None:
    """Against a compliant stop a body bounces back slower than it came, and comes free."""
    stop = effect("EndStop", "shoulder_pan_joint", upper=0, stiffness=400, damping="0.6")
    found = with_effects("ur5", stop)
    random = np.random.default_rng(3)
    q = 0.01 * random.uniform(-1, 1, (200, 6))
    v = random.uniform(-5, 5, (200, 6))
    power = found("effect_power", q, v)[0][0]
    assert (power <= 0).all() and (power < 0).any()
    assert (found("energy", q, v)[0][0][:, 1] >= 0).all()
    joint, rate, step, trace = 0.0, 1.0, 1e-3, []
    inertia = 2.0
    while joint >= 0:  # the stop's law alone on one inertia, from impact to release
        q, v = np.zeros(6), np.zeros(6)
        q[0], v[0] = joint, rate
        bias = found("bias", q, v)[0][0][0]  # of the stop alone: there is no gravity, and one joint turns
        rate -= step * bias / inertia
        joint += step * rate
        trace.append(bias)
    assert min(trace) >= 0, "the stop pulled"
    assert -0.95 < rate < 0 and len(trace) > 100


# -- drives -------------------------------------------------------------------------------------------------------


def test_rotor_inertia_adds_to_the_mass_matrix_and_to_the_kinetic_energy() -> None:
    inertia = 0.02 * 3**2
    plain, found = with_effects(CRANK), with_effects(CRANK, effect("RotorInertia", "crank_R", "0.02", 3))
    q, v, a = plain.system.sample_states
    k = found.system.tree.velocity_indices("crank_R")[0]
    of = oracle(CRANK)
    assert relative(drives(found), of.solve(of.along("crank_R", -inertia * a[:, k])).drives) < EXACT
    more = found("mass_matrix", q)[0][0] - plain("mass_matrix", q)[0][0]
    n = len(found.system.tree.v)
    assert np.allclose(more.reshape(-1, n, n), inertia * np.eye(n)[k] * np.eye(n)[:, [k]], atol=1e-15)
    gained = found("energy", q, v)[0][0] - plain("energy", q, v)[0][0]
    assert np.allclose(gained[:, 0], inertia * v[:, k] ** 2 / 2) and np.allclose(gained[:, 1], 0)


def test_screw_transmission_loses_what_its_efficiency_says() -> None:
    joint, lead, eta, back = "limb1_P", 0.005, 0.8, 0.7
    of = oracle("three_ups_upu_s")
    screw = effect("ScrewTransmission", joint, lead, eta, back, velocity=1e-9)
    found = inverse("three_ups_upu_s", Gravity(), screw)
    plain = inverse("three_ups_upu_s", Gravity())
    index = [p.name for p in found.programs["inverse_dynamics"].outputs].index("u")
    column = found.programs["inverse_dynamics"].outputs[index].labels.index(joint)
    force, rate = drives(plain)[:, column], of.rate(joint)
    driving = force * rate > 0
    moving = np.abs(rate) > 1e-3
    expected = force * lead / (2 * np.pi) * np.where(driving, 1 / eta, back)
    got = drives(found)
    assert driving[moving].any() and (~driving[moving]).any()
    assert np.abs(got[moving, column] / expected[moving] - 1).max() < 1e-9
    assert relative(np.delete(got, column, 1), np.delete(drives(plain), column, 1)) < EXACT
    assert found.programs["inverse_dynamics"].outputs[0].units[column] == "N m"


def test_motor_servo_and_elastic_leg() -> None:
    of, joint = oracle(CRANK), "slider_P"
    s, rate = of.displacement(joint), of.rate(joint)

    motor = with_effects(CRANK, effect("DcMotor", joint, "0.05", "1.2", "0.0008", 50))
    current = input_of(motor, "inverse_dynamics", "x")[:, 0]
    assert relative(drives(motor), of.solve(of.along(joint, 0.05 * 50 * current)).drives) < EXACT
    voltage = 24.0
    x = np.array([[2.5]])
    got = call(motor, "effect_state_rates", x=x, voltage_slider_P=voltage)[:, 0]
    assert np.allclose(got, (voltage - 1.2 * 2.5 - 0.05 * 50 * rate) / 0.0008, rtol=1e-12)

    for limit in (None, 2):
        servo = with_effects(CRANK, effect("PositionServo", joint, 40, 3, limit))
        target = input_of(servo, "inverse_dynamics", "servo_slider_P")
        force = 40 * (target[:, 0] - s) + 3 * (target[:, 1] - rate)
        clipped = force if limit is None else np.clip(force, -limit, limit)
        assert limit is None or (np.abs(force) > limit).any()
        assert relative(drives(servo), of.solve(of.along(joint, clipped)).drives) < EXACT

    leg = with_effects(CRANK, effect("LegCompliance", joint, 2e4, 4, "0.02"))
    x = np.array([0.003, 0.7])
    damping = 0.02 * np.sqrt(2e4 * 4)
    force = 2e4 * 0.003 + damping * (0.7 - rate)
    assert relative(drives(leg, x=x), of.solve(of.along(joint, force)).drives) < EXACT
    got = call(leg, "effect_state_rates", x=x, actuator_slider_P=11.0)
    assert np.allclose(got, np.stack([0.7 - rate, (11.0 - force) / 4], axis=1), rtol=1e-12)


def test_friction_spring_and_rotor_against_mujoco() -> None:
    """MuJoCo has damping, springs and armature in joints of a tree."""
    mujoco = pytest.importorskip("mujoco")
    from oracles.mujoco_engine import MujocoEngine

    joints = list(catalogue.load("ur5").joints)
    effects: list[Effect] = [Gravity()]
    for k, joint in enumerate(joints):
        effects += [effect("ViscousFriction", joint, k + 1), effect("RotorInertia", joint, f"0.{k + 1}", 3)]
        effects += [effect("JointSpring", joint, 10 * (k + 1), f"0.{k + 1}")]
    found = inverse("ur5", *effects)
    of = oracle("ur5")
    engine = MujocoEngine(found.mechanism)
    states = [
        {b: BodyState(s.rotation[n], s.translation[n], s.twist[n], s.twist_rate[n]) for b, s in of.states.items()}
        for n in range(len(of.q))
    ]
    dofs = []
    for k, joint in enumerate(joints):
        body = engine.index[found.mechanism.joints[joint].child]
        (dof,) = np.flatnonzero(engine.model.dof_bodyid == body)
        dofs.append(dof)
        engine.model.dof_damping[dof] = k + 1
        engine.model.dof_armature[dof] = (k + 1) / 10 * 9
        engine.model.jnt_stiffness[engine.model.dof_jntid[dof]] = 10 * (k + 1)
        engine.model.qpos_spring[engine.model.jnt_qposadr[engine.model.dof_jntid[dof]]] = (k + 1) / 10
    expected = []
    for state in states:
        engine.set_state(state)
        mujoco.mj_inverse(engine.model, engine.data)
        expected.append(engine.data.qfrc_inverse[dofs].copy())
    assert relative(drives(found), np.array(expected)) < 1e-9


# -- friction that depends on the load ---------------------------------------------------------------------------------


@pytest.mark.parametrize("name, joint", [(CRANK, "slider_P"), (CRANK, "slider_R"), ("three_ups_upu_s", "limb1_P")])
def test_friction_in_proportion_to_the_reaction(name: str, joint: str) -> None:
    of = oracle(name)
    friction = effect("DryFriction", joint, "0.3", load="0.2", velocity=SMOOTH)
    found = inverse(name, Gravity(), friction)
    without = of.solve(gravity=G)
    size = np.linalg.norm(without.reactions[joint][:, :3], axis=1)
    expected = of.solve(of.along(joint, faded(of.rate(joint)) * (0.3 + 0.2 * size)), gravity=G).drives
    assert relative(drives(found), expected) < 1e-9
    assert friction.depends_on == {"reactions"}


def test_forward_dynamics_takes_the_reactions_of_the_same_drives() -> None:
    """Accelerations under load-dependent friction are those under the friction that the reactions without it make."""
    friction = effect("DryFriction", "slider_P", load="0.2", velocity=SMOOTH)
    found, plain = with_effects(CRANK, Gravity(), friction), with_effects(CRANK, Gravity())
    q, v, _ = found.system.sample_states
    u = input_of(found, "forward_dynamics", "u")
    (_, reactions), status = plain("forward_dynamics_reactions", q, v, u)
    assert not status.any()
    k = list(plain.mechanism.joints).index("slider_P")
    size = np.linalg.norm(reactions[:, 6 * k : 6 * k + 3], axis=1)
    rate = oracle(CRANK).rate("slider_P")
    event = with_effects(CRANK, Gravity(), effect("DryFriction", "slider_P", mode="event"))
    force = 0.2 * size * faded(rate)
    expected = event("forward_dynamics", q, v, u, force[:, None])[0][0]
    assert relative(call(found, "forward_dynamics", q=q, v=v, u=u), expected) < EXACT


def test_passes_bring_forward_and_inverse_dynamics_together() -> None:
    """With more passes the friction of both becomes the friction of its own reactions; the error falls with each."""
    errors = []
    for passes in (1, 3, 6):
        friction = effect("DryFriction", "slider_P", load="0.2", velocity=SMOOTH, passes=passes)
        found = with_effects(CRANK, Gravity(), friction)
        q, v, a = found.system.sample_states
        u = call(found, "inverse_dynamics", q=q, v=v, a=a)
        errors.append(relative(call(found, "forward_dynamics", q=q, v=v, u=u), a))
    assert errors[1] < 0.2 * errors[0] and errors[2] < 0.02 * errors[0], errors
