"""Every function of every model against identities and against method B."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from support.marks import slow
from support.model_states import ALL, body_states, by_joint, model, output, relative, run

from symscrew.algebra.screws import Wrench
from symscrew.kinematics.recursion import inertial_wrench
from symscrew.program.numpy_evaluation import evaluate
from symscrew.reference.newton_euler_method import (
    constraint_residuals,
    joint_displacements,
    joint_rates,
    newton_euler,
    numeric,
)

EXACT = 1e-9


@pytest.mark.parametrize("name", ALL)
def test_bodies_obey_every_joint(name: str) -> None:
    found = model(name)
    q, v, a = found.system.sample_states
    residuals = constraint_residuals(numeric(found.mechanism), body_states(found, q, v, a))
    for joint, levels in residuals.items():
        for level, order in zip(levels, ("position", "velocity", "acceleration"), strict=True):
            assert np.abs(level).max() < EXACT, (joint, order)


@pytest.mark.parametrize("name", ALL)
def test_rates_and_displacements_of_all_joints(name: str) -> None:
    found = model(name)
    q, v, a = found.system.sample_states
    states = body_states(found, q, v, a)
    numbers = numeric(found.mechanism)
    expected = np.concatenate(list(joint_rates(numbers, states).values()), axis=-1)
    assert relative(run(name, "joint_rates", q, v), expected) < EXACT
    expected = np.concatenate(list(joint_displacements(numbers, states).values()), axis=-1)
    assert relative(run(name, "joint_displacements", q), expected) < EXACT


@pytest.mark.parametrize("name", ALL)
def test_drives_and_reactions_equal_method_b(name: str) -> None:
    found = model(name)
    q, v, a = found.system.sample_states
    states = body_states(found, q, v, a)
    expected = newton_euler(numeric(found.mechanism), states)
    if found.system.drives:
        assert relative(run(name, "inverse_dynamics", q, v, a), expected.drives) < EXACT
    reactions = by_joint(output(found, "joint_reactions", "reactions", q, v, a), list(found.mechanism.joints))
    free = int(expected.reaction_redundancy.max())
    difference = np.concatenate([reactions[j] - expected.reactions[j] for j in reactions], axis=-1)
    scale = max(np.abs(expected.reactions[j]).max() for j in reactions)
    internal = np.concatenate([expected.null_wrenches[j] for j in reactions], axis=-2)
    for k in range(len(q)):
        basis, _ = np.linalg.qr(internal[k]) if free else (np.zeros((difference.shape[1], 0)), None)
        rest = difference[k] - basis @ (basis.T @ difference[k])
        assert np.abs(rest).max() < EXACT * scale, name
    note = " ".join(found.programs["joint_reactions"].notes)
    assert (f"overconstrained: {free} internal load" in note) == bool(free)


@pytest.mark.parametrize("name", ALL)
def test_components_reported_as_not_unique(name: str) -> None:
    found = model(name)
    q, v, a = found.system.sample_states
    expected = newton_euler(numeric(found.mechanism), body_states(found, q, v, a))
    labels = ("fx", "fy", "fz", "mx", "my", "mz")
    changing = {
        f"{joint}.{labels[k]}" for joint, mask in expected.unique.items() for k in range(6) if not mask[..., k].all()
    }
    reported = {
        f"{joint}.{component}"
        for note in found.programs["joint_reactions"].notes
        if "not unique: " in note
        for alike in note.split("not unique: ")[1].split("; ")
        for component, joint in itertools.product(*(part.split(", ") for part in alike.split(" of ")))
    }
    assert reported == changing


@pytest.mark.parametrize("name", ALL)
def test_closure_of_rates_and_accelerations(name: str) -> None:
    found = model(name)
    if not found.system.cuts:
        return
    q, v, a = found.system.sample_states
    n = v.shape[1]
    jacobian = run(name, "closure_jacobian", q).reshape(len(q), n, -1).transpose(0, 2, 1)
    bias = run(name, "closure_bias", q, v)
    assert np.abs(run(name, "closure", q)).max() < 1e-12
    assert np.abs(np.einsum("sij,sj->si", jacobian, v)).max() < 1e-11
    assert np.abs(np.einsum("sij,sj->si", jacobian, a) + bias).max() < 1e-10


@pytest.mark.parametrize("name", ALL)
def test_everything_follows_from_the_independent_coordinates(name: str) -> None:
    found = model(name)
    q, v, a = found.system.sample_states
    y_dot, y_ddot = independent_rates(found, q, v, a)
    assert relative(run(name, "velocity", q, y_dot), v) < EXACT
    assert relative(run(name, "acceleration", q, v, y_ddot), a) < EXACT


def independent_rates(found, q, v, a):
    """First and second rates of y by definition: entries of v, or quaternion kinematics."""
    labels = [c.label for c in found.system.tree.q]
    y = found.programs["velocity"].inputs[1].labels
    first, second = np.zeros((len(q), len(y))), np.zeros((len(q), len(y)))
    q_dot, q_ddot = np.zeros_like(q), np.zeros_like(q)
    for link in found.system.tree.links[1:]:
        if link.motion.kind != "S":
            q_dot[:, link.q], q_ddot[:, link.q] = v[:, link.v], a[:, link.v]
            continue
        for k in range(len(q)):
            q_dot[k, link.q] = 0.5 * times(q[k, link.q], v[k, link.v])
            q_ddot[k, link.q] = 0.5 * (times(q_dot[k, link.q], v[k, link.v]) + times(q[k, link.q], a[k, link.v]))
    for i, label in enumerate(y):
        first[:, i], second[:, i] = q_dot[:, labels.index(label)], q_ddot[:, labels.index(label)]
    return first, second


def times(quaternion, vector):
    """Quaternion product with a pure vector on the right (child axes)."""
    w, r = quaternion[0], quaternion[1:]
    return np.r_[-r @ vector, w * vector + np.cross(r, vector)]


@pytest.mark.parametrize("name", ALL)
def test_assembly_returns_to_the_sampled_configuration(name: str) -> None:
    found = model(name)
    if "assemble" not in found.programs:
        return
    y, guess = found.test_inputs["assemble"][:2]
    (q,), status = found("assemble", y, guess)
    assert np.all(status == 0)
    assert np.abs(run(name, "closure", q)).max() < 1e-12
    labels = [c.label for c in found.system.tree.q]
    index = [labels.index(label) for label in found.programs["assemble"].inputs[0].labels]
    assert np.abs(q[:, index] - y).max() < 1e-12


@pytest.mark.parametrize("name", ALL)
def test_kinetic_energy_mass_matrix_and_momentum_agree(name: str) -> None:
    found = model(name)
    q, v, _ = found.system.sample_states
    n = v.shape[1]
    mass = run(name, "mass_matrix", q).reshape(len(q), n, n)
    energy = run(name, "energy", q, v)[:, 0]
    assert np.allclose(mass, mass.transpose(0, 2, 1), rtol=0, atol=0)
    assert relative(0.5 * np.einsum("si,sij,sj->s", v, mass, v), energy) < EXACT
    momenta, total = found("momentum_screws", q, v)[0]
    assert relative(momenta.reshape(len(q), -1, 6).sum(axis=1), total) < EXACT
    twists = run(name, "body_twists", q, v).reshape(len(q), -1, 6)
    bodies = [b for b in found.mechanism.bodies if b != found.mechanism.ground]
    with_mass = [label.rsplit(".", 1)[0] for label in found.programs["momentum_screws"].outputs[0].labels[::6]]
    twists = twists[:, [bodies.index(b) for b in with_mass]]
    screws = momenta.reshape(len(q), -1, 6)
    power = (twists[..., :3] * screws[..., 3:]).sum((1, 2)) + (twists[..., 3:] * screws[..., :3]).sum((1, 2))
    assert relative(0.5 * power, energy) < EXACT


@pytest.mark.parametrize("name", ALL)
def test_power_balance(name: str) -> None:
    """d(kinetic + potential)/dt = power of the drives: by momentum rates, and by a step along the motion."""
    found = model(name)
    if not found.system.drives:
        return
    q, v, a = found.system.sample_states
    u = run(name, "inverse_dynamics", q, v, a)
    rates = run(name, "joint_rates", q, v)
    labels = found.programs["joint_rates"].outputs[0].labels
    columns = [labels.index(label) for label in found.programs["inverse_dynamics"].outputs[0].labels]
    power = (u * rates[:, columns]).sum(axis=1)
    h = 1e-5
    energies = []
    for sign in (1, -1):
        w = found.system.numeric(
            found.system.joint_rates(found.system.inputs.v),
            (found.system.inputs.q, q),
            (found.system.inputs.v, v),
        )
        w_dot = found.system.numeric(
            found.system.joint_rates(found.system.inputs.v),
            (found.system.inputs.q, q),
            (found.system.inputs.v, a),
        )
        moved = found.system.advance(q, sign * h * w + 0.5 * h * h * w_dot)
        energies.append(run(name, "energy", moved, v + sign * h * a).sum(axis=1))
    derivative = (energies[0] - energies[1]) / (2 * h)
    scale = np.abs(u * rates[:, columns]).sum(axis=1).max()
    assert np.abs(derivative - power).max() < 1e-6 * scale


SPOKED = (  # held below; asked of the models here, every process would derive all of them to know its tests
    "delta",
    "four_bar",
    "planar_3rrr",
    "slider_crank",
    "stewart_6ups",
    "three_ups_upu_s",
    "three_ups_upu_s_physical",
)


def test_assembly_turns_a_crank_all_the_way_round() -> None:
    found = model("four_bar")
    q = found.system.reference
    start = q[list(found.programs["assemble"].independent)]
    for angle in np.linspace(0, 2 * np.pi, 25)[1:]:
        (q,), status = found("assemble", start + angle, q)
        assert status == 0
        assert np.abs(run("four_bar", "closure", q)).max() < 1e-12
    expected = found.system.reference.copy()
    expected[list(found.programs["assemble"].independent)] += 2 * np.pi
    turns = (q - expected) / (2 * np.pi)
    assert np.abs(turns - np.round(turns)).max() < 1e-12


@pytest.mark.parametrize("name", ALL)
def test_which_mechanisms_have_closed_forms(name: str) -> None:
    assert ("inverse_kinematics" in model(name).programs) == (name in SPOKED)


@pytest.mark.parametrize("name", SPOKED)
def test_platform_functions_equal_those_of_the_tree(name: str) -> None:
    found = model(name)
    q, v, a = found.system.sample_states
    pose, rate, gain = found.test_inputs["inverse_dynamics_platform"]
    assert np.abs(run(name, "inverse_kinematics", pose) - q).max() < 1e-12
    assert relative(run(name, "inverse_velocity", pose, rate), v) < EXACT
    expected = run(name, "inverse_dynamics", q, v, a)
    assert relative(run(name, "inverse_dynamics_platform", pose, rate, gain), expected) < EXACT


@pytest.mark.parametrize("name", SPOKED)
def test_assembly_with_closed_forms_needs_few_steps_and_stays_on_the_branch(name: str) -> None:
    found = model(name)
    assemble = found.programs["assemble"]
    y, guess = found.test_inputs["assemble"][:2]
    q = guess.copy()
    for _ in range(6):
        (q, residual, step, _), status = evaluate(assemble.step, [q, y])
        assert np.all(status == 0)
    assert residual.max() < 1e-13 and step.max() < 1e-12
    turned = guess.copy()
    labels = [c.label for c in found.system.tree.q]
    angle = next(i for i, c in enumerate(found.system.tree.q) if c.kind == "angle" and i not in assemble.independent)
    turned[:, angle] += 2 * np.pi  # the same configuration, counted one turn further: stays there
    (q2,), status = found("assemble", y, turned)
    (q1,), _ = found("assemble", y, guess)
    assert np.all(status == 0), labels[angle]
    assert np.abs(q2 - q1 - (turned - guess)).max() < 1e-11


@pytest.mark.parametrize("name", ALL)
def test_inverse_dynamics_from_the_independent_coordinates(name: str) -> None:
    found = model(name)
    q, v, a = found.system.sample_states
    y_dot, y_ddot = independent_rates(found, q, v, a)
    expected = run(name, "inverse_dynamics", q, v, a)
    assert relative(run(name, "inverse_dynamics_independent", q, y_dot, y_ddot), expected) < EXACT


@pytest.mark.parametrize(
    "name", [slow(name) if name in ("delta", "three_ups_upu_s_physical") else name for name in ALL]
)
def test_states_far_from_those_used_while_deriving(name: str) -> None:
    """Other states than the samples that chose the pivots: assembled, consistent, equal to method B."""
    found = model(name)
    q, v, a = fresh_states(found, np.random.default_rng(len(name)), 6, 0.35)
    numbers = numeric(found.mechanism)
    states = body_states(found, q, v, a)
    for levels in constraint_residuals(numbers, states).values():
        assert max(np.abs(level).max() for level in levels) < EXACT
    expected = newton_euler(numbers, states)
    if found.system.drives:
        assert relative(run(name, "inverse_dynamics", q, v, a), expected.drives) < EXACT
    points = run(name, "joint_points", q).reshape(len(q), -1, 3)
    for k, joint in enumerate(found.mechanism.joints.values()):
        if joint.child == found.mechanism.ground:
            continue
        state = states[joint.child]
        place = np.array([float(found.mechanism.number(c)) for c in joint.point])
        assert np.abs(state.rotation @ place + state.translation - points[:, k]).max() < EXACT or joint.type in "PCEH"


def fresh_states(found, rng, count, amplitude):
    """Random consistent (q, v, a): y and its rates at random, the rest by the model's own functions."""
    system = found.system
    programs = found.programs
    y_port = programs["velocity"].inputs[1]
    labels = [c.label for c in system.tree.q]
    entries = [labels.index(label) for label in y_port.labels]
    q = np.repeat(system.reference[None, :], count, axis=0)
    step = amplitude * rng.uniform(-1, 1, (count, len(entries)))
    if "assemble" in programs:
        (q,), status = found("assemble", q[:, entries] + step, q)
        q = q[status == 0]
        assert len(q) >= count // 2, f"only {len(q)} of {count} states could be assembled"
    else:
        w = np.zeros((count, len(system.tree.v)))
        w += amplitude * rng.uniform(-1, 1, w.shape)
        q = system.advance(q, w)
    y_dot, y_ddot = (rng.uniform(-1, 1, (len(q), len(entries))) for _ in range(2))
    (v,), status = found("velocity", q, y_dot)
    assert np.all(status == 0)
    (a,), status = found("acceleration", q, v, y_ddot)
    assert np.all(status == 0)
    return q, v, a


@pytest.mark.parametrize("name", ALL)
def test_link_frames_and_absolute_screws_give_the_same_momentum_rates(name: str) -> None:
    """The recursion of the generated code against the paper's screws at O: one rate of momentum, two ways."""
    system = model(name).system
    if "momentum_rates" not in model(name).programs:
        return
    rates = system.rates(system.inputs.a)
    nodes, owners = [], []
    for link in system.tree.links[1:]:
        force, moment = inertial_wrench(system.inertia[link.index], rates[link.index])
        nodes += [system.tape.node(c) for c in system.pose[link.index].wrench(Wrench(force, moment)).components]
        owners.append(link.bodies)
    q, v, a = system.sample_states
    got = system.numeric(nodes, (system.inputs.q, q), (system.inputs.v, v), (system.inputs.a, a))
    expected = run(name, "momentum_rates", q, v, a).reshape(len(q), -1, 6)
    labels = [label.rsplit(".", 1)[0] for label in model(name).programs["momentum_rates"].outputs[0].labels[::6]]
    largest = np.abs(expected).max()
    for k, bodies in enumerate(owners):
        total = sum((expected[:, labels.index(b)] for b in bodies if b in labels), start=np.zeros((len(q), 6)))
        assert np.abs(got[:, 6 * k : 6 * k + 6] - total).max() < 1e-12 * largest


def test_assembly_keeps_the_branch_of_its_guess() -> None:
    """Open and crossed four-bar: the same crank angle, two configurations, each from its own neighbourhood."""
    found = model("four_bar")
    system = found.system
    y = system.reference[list(found.programs["assemble"].independent)]
    solutions = []
    random = np.random.default_rng(4)
    for _ in range(20):
        guess = system.reference + np.r_[0, random.uniform(-3, 3, 2)]
        (q,), status = found("assemble", y, guess)
        if status == 0:
            solutions.append(np.mod(q[1:] + np.pi, 2 * np.pi) - np.pi)
    distinct = np.unique(np.round(solutions, 9), axis=0)
    assert len(distinct) == 2
    for branch in distinct:
        start = np.r_[y, branch]
        (q,), status = found("assemble", y + 0.2, start)
        assert status == 0
        (back,), status = found("assemble", y, q)
        assert status == 0
        assert np.abs(back - start).max() < 1e-9


def test_assembly_out_of_reach_fails_and_says_so() -> None:
    found = model("five_bar")
    y, guess = (inputs[0] for inputs in found.test_inputs["assemble"][:2])
    failures = 0
    for angle in np.linspace(0, 2 * np.pi, 12):
        (q,), status = found("assemble", y + np.array([angle, -angle]), guess)
        if status:
            failures += 1
            assert status in (3, 4) and np.isnan(q).all()
        else:
            assert np.abs(run("five_bar", "closure", q)).max() < 1e-12
    assert failures > 0


@pytest.mark.parametrize("name", [slow("three_ups_upu_s"), "four_bar", "ur5"])
def test_no_function_answers_nan_or_infinite_input(name: str) -> None:
    """Each input in turn made NaN and infinite: never a number after that, in any function that uses it."""
    found = model(name)
    for function, inputs in found.test_inputs.items():
        state = [array[:1].copy() for array in inputs]
        (reference, status) = found(function, *state)
        assert np.all(status == 0)
        for k, array in enumerate(state):
            cases = [(entry, bad) for entry in range(array.shape[1]) for bad in (np.nan, np.inf)]
            poisoned = [np.repeat(a, len(cases), axis=0) for a in state]
            for row, (entry, bad) in enumerate(cases):
                poisoned[k][row, entry] = bad
            results, status = found(function, *poisoned)
            for row, case in enumerate(cases):
                unused = all(np.array_equal(x[row], y[0]) for x, y in zip(results, reference, strict=True))
                nothing = status[row] != 0 and all(np.isnan(r[row]).all() for r in results)
                assert unused or nothing, (function, k, case)
