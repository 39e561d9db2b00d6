"""The source paper's facts on the seed mechanism (Zhao, Sun, Wei, Machines 2023, 11(8), 840)."""

from __future__ import annotations

import dataclasses
import math

import mpmath
import numpy as np
import pytest
import sympy
from support.model_states import model, output, run

from symscrew import catalogue
from symscrew.effects.external_wrench import ExternalWrench
from symscrew.effects.gravity import Gravity
from symscrew.mobility.analysis import analyse_mobility
from symscrew.model import derive

SEED = "three_ups_upu_s"


@pytest.mark.parametrize("inner", ["1/2", "2/5", "3/4", "7/10"])
def test_constraint_of_limb_1(inner: str) -> None:
    """Eq. (13): force along y with moment -R + L/sin(theta) about z, for several inclinations of the limb."""
    mechanism = catalogue.load(SEED)
    radius = dataclasses.replace(mechanism.parameters["r"], value=sympy.Rational(inner))
    mechanism = dataclasses.replace(mechanism, parameters={**mechanism.parameters, "r": radius})
    R, r, H = 0.8, float(sympy.Rational(inner)), 0.3 * math.sqrt(3)
    length = math.hypot(R - r, H)
    sine = (R - r) / length
    found = analyse_mobility(mechanism)
    (wrench,) = found.limbs[0].constraints.basis
    assert [float(c) for c in wrench] == pytest.approx([0, 1, 0, 0, 0, -R + length / sine], abs=1e-14)


def test_constraints_and_freedoms_of_the_platform() -> None:
    """Eqs. (14)-(18): UPS limbs constrain nothing, S gives three forces through O, rank 4, rotations x and y."""
    found = analyse_mobility(catalogue.load(SEED))
    assert [len(limb.constraints.basis) for limb in found.limbs] == [1, 0, 0, 0, 3]
    assert {tuple(float(c) for c in w) for w in found.limbs[4].constraints.basis} == {
        (1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0), (0, 0, 1, 0, 0, 0)
    }  # fmt: skip
    assert found.constraints is not None and found.constraints.rank == 4
    assert found.freedoms is not None
    freedoms = mpmath.matrix([list(t) for t in found.freedoms.basis])
    assert freedoms.rows == 2 and found.dof == 2 and found.kutzbach == 2
    assert all(freedoms[i, j] == 0 for i in range(2) for j in (2, 3, 4, 5))


def test_upu_s_and_one_ups_have_the_same_freedoms() -> None:
    """Section 3.2: two of the three UPS limbs are not needed for the mobility."""
    mechanism = catalogue.load(SEED)
    dropped = ("limb2", "limb4")
    joints = {n: j for n, j in mechanism.joints.items() if not n.startswith(dropped)}
    bodies = {n: b for n, b in mechanism.bodies.items() if not n.startswith(dropped)}
    limbs = {n: limb for n, limb in mechanism.limbs.items() if n not in dropped}
    fewer = dataclasses.replace(mechanism, joints=joints, bodies=bodies, limbs=limbs)
    full, small = analyse_mobility(mechanism), analyse_mobility(fewer)
    assert full.freedoms is not None and small.freedoms is not None
    assert small.dof == 2
    stacked = np.array([[float(c) for c in t] for t in (*full.freedoms.basis, *small.freedoms.basis)])
    assert np.linalg.matrix_rank(stacked) == 2


def test_velocity_equation_of_the_whole_mechanism() -> None:
    """Eqs. (19)-(27): S is 30 x 26 and S w stacks the platform's twist at O five times."""
    found = model(SEED)
    q, v, _ = found.system.sample_states
    screws = run(SEED, "joint_screws", q).reshape(len(q), 26, 6).transpose(0, 2, 1)
    rates = run(SEED, "joint_rates", q, v)
    labels = found.programs["joint_rates"].outputs[0].labels
    platform = run(SEED, "platform_jacobian", q).reshape(len(q), -1, 6).transpose(0, 2, 1) @ v[..., None]
    stacked = np.zeros((len(q), 30, 26))
    for i, limb in enumerate(found.mechanism.limbs.values()):
        columns = [k for k, label in enumerate(labels) if label.split(".")[0] in limb.joints]
        assert len(columns) == (5, 6, 6, 6, 3)[i]
        stacked[:, 6 * i : 6 * i + 6, columns] = screws[:, :, columns]
    got = np.einsum("sij,sj->si", stacked, rates)
    assert np.abs(got - np.tile(platform[..., 0], 5)).max() < 1e-12


@pytest.mark.parametrize("name", [SEED, f"{SEED}_physical"])
def test_statics_under_the_load_of_section_5_2(name: str) -> None:
    """Minimum-norm drives (0, 500/(R cos 30 deg), 0, -500/(R cos 30 deg)) N at rest in the reference pose."""
    found = derive(catalogue.load(name), (Gravity(), ExternalWrench("E")))
    system = found.system
    zero = np.zeros(len(system.tree.v))
    load = np.array([0, 0, 1000.0, 1000.0, 0, 0])
    expected = 500 / (0.8 * math.cos(math.radians(30)))
    u = output(found, "inverse_dynamics", "u", system.reference, zero, zero, load)
    assert u == pytest.approx([0, expected, 0, -expected], rel=1e-12, abs=1e-9)
    assert expected == pytest.approx(721.688, abs=5e-4)
    u, reactions = found("joint_reactions", system.reference, zero, zero, load)[0]
    names = list(found.mechanism.joints)
    s_joint = reactions[6 * names.index("limb5_S") :][:6]
    weight = 9.81 * (2.87 + 8 * 1.42)
    bases = sum(reactions[6 * names.index(f"limb{k}_U") :][:6] for k in (1, 2, 3, 4))
    # All joints at the ground together carry the weight, less what the load lifts.
    assert (s_joint + bases)[:3] == pytest.approx([0, 0, weight - 1000], abs=1e-9)


def test_preload_loads_the_legs_without_moving_anything() -> None:
    found = model(SEED)
    q, v, a = found.system.sample_states
    u = run(SEED, "inverse_dynamics", q, v, a)
    ones = np.ones((len(q), 4))
    preload = np.tile([100.0, 0, 100.0, 0], (len(q), 1))
    loaded = run(SEED, "inverse_dynamics_preload", q, v, a, ones, preload)
    again = run(SEED, "inverse_dynamics_preload", q, v, a, ones, loaded)
    assert np.abs(again - loaded).max() < 1e-9 * np.abs(loaded).max()
    internal = loaded - u
    assert np.linalg.norm(internal, axis=1).min() > 50
    assert np.abs((internal * u).sum(axis=1)).max() < 1e-9 * np.abs(loaded).max() ** 2  # minimum norm: orthogonal
    # the internal part does no work on any admissible motion
    rates = run(SEED, "joint_rates", q, v)
    labels = found.programs["joint_rates"].outputs[0].labels
    columns = [labels.index(label) for label in found.programs["inverse_dynamics"].outputs[0].labels]
    assert np.abs((internal * rates[:, columns]).sum(axis=1)).max() < 1e-9 * np.abs(internal).max()


def test_constraint_singularity_is_reported_not_answered() -> None:
    """At L = R sin(theta) limb 1's constraint passes through O: near-singular, no number. Close to it: right.

    At rest under a moment M about x the drives of smallest norm are -+M/(2 R cos(theta)) in limbs 2 and 4.
    """
    mechanism = catalogue.load(SEED)
    parameters = {n: dataclasses.replace(p, run_time=True) for n, p in mechanism.parameters.items()}
    found = derive(dataclasses.replace(mechanism, parameters=parameters), (ExternalWrench("E"),))
    reference, zero = found.system.reference, np.zeros(len(found.system.tree.v))
    load = np.array([0, 0, 0, 1000.0, 0, 0])
    singular = np.array([0.8, 0.2, math.sqrt(3) / 5])  # R, r, H with theta = 60 deg, L = R sin(theta)
    (u,), status = found("inverse_dynamics", reference, zero, zero, load, singular)
    assert status == 1 and np.isnan(u).all()
    for distance in (1e-1, 1e-3, 1e-6):
        R, r, H = singular + np.array([0, distance, 0])
        (u,), status = found("inverse_dynamics", reference, zero, zero, load, np.array([R, r, H]))
        expected = 1000 / (2 * R * H / math.hypot(R - r, H))
        assert status == 0
        assert u == pytest.approx([0, expected, 0, -expected], rel=1e-12, abs=1e-9)
