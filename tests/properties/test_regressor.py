"""The regressor times the inertial parameters is the inverse dynamics; counts of base parameters."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy
from support.model_states import HAND_TYPED, relative

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.effects.external_wrench import ExternalWrench
from symscrew.effects.gravity import Gravity
from symscrew.functions.identifiable import PARAMETERS, RankError, base_parameters, inertial_parameters
from symscrew.model import Model, derive

pytestmark = pytest.mark.slow

Array = np.ndarray
LIKE_ANOTHER = ("stewart_6ups", "three_ups_upu_s")  # limbs are those of the seed with bodies
NAMES = [name for name in (*catalogue.names(), *HAND_TYPED) if name not in LIKE_ANOTHER]


@cache
def model(name: str) -> Model:
    return derive(HAND_TYPED[name]() if name in HAND_TYPED else catalogue.load(name), regressor=True)


def matrix(found: Model, function: str, *arguments: Array) -> Array:
    (values,), status = found(function, *arguments)
    assert np.all(status == 0)
    rows, columns = found.programs[function].outputs[0].shape
    return values.reshape(len(values), columns, rows).swapaxes(1, 2)


def first(found: Model, function: str, *arguments: Array) -> Array:
    results, status = found(function, *arguments)
    assert np.all(status == 0)
    return results[0]


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_regressor_times_parameters_is_inverse_dynamics(name: str) -> None:
    """Of the tree: mass matrix and bias; of the drives; and along the independent directions by virtual work."""
    found = model(name)
    q, v, a = found.system.sample_states
    pi = inertial_parameters(found.mechanism)
    assert found.programs["regressor"].outputs[0].shape == (v.shape[1], len(pi))
    n = v.shape[1]
    mass = first(found, "mass_matrix", q).reshape(-1, n, n)
    tree = np.einsum("sij,sj->si", mass, a) + first(found, "bias", q, v)
    assert relative(matrix(found, "regressor", q, v, a) @ pi, tree) < 1e-10
    u = first(found, "inverse_dynamics", q, v, a)
    assert relative(matrix(found, "regressor_drives", q, v, a) @ pi, u) < 1e-9
    if found.system.cuts:
        q = q[1:]
        count = found.programs["null_space"].outputs[0].shape[1]
        y_dot, y_ddot = np.random.default_rng(3).uniform(-1, 1, (2, len(q), count))
        v = first(found, "velocity", q, y_dot)
        a = first(found, "acceleration", q, v, y_ddot)
        null = first(found, "null_space", q).reshape(-1, count, n)
        along = np.einsum("skj,sjp->skp", null, matrix(found, "regressor", q, v, a))
        assert relative(matrix(found, "regressor_independent", q, y_dot, y_ddot), along) < 1e-9


def test_every_parameter_of_a_body_has_its_own_column() -> None:
    """Changing one inertial parameter of the description changes the torques by its column, exactly."""
    found = model("panda")
    q, v, a = found.system.sample_states
    pi = inertial_parameters(found.mechanism)
    bodies = [b for b in found.mechanism.bodies if b != found.mechanism.ground]
    name = bodies[3]
    body = found.mechanism.bodies[name]
    heavier = replace(
        body, mass=body.mass + 2, com=tuple(c + sympy.Rational(1, 10 + k) for k, c in enumerate(body.com))
    )
    other = replace(found.mechanism, bodies={**found.mechanism.bodies, name: heavier})
    changed = inertial_parameters(other)
    assert np.flatnonzero(changed != pi).tolist() == list(range(30, 40))
    expected = first(derive(other), "inverse_dynamics", q, v, a)
    assert relative(matrix(found, "regressor", q, v, a) @ changed, expected) < 1e-10


@pytest.mark.slow
def test_loads_are_no_part_of_it_and_gravity_is() -> None:
    mechanism = catalogue.load("three_ups_upu_s_physical")
    loaded = derive(mechanism, (Gravity(), ExternalWrench("E")), regressor=True)
    assert [p.name for p in loaded.programs["regressor"].inputs] == ["q", "v", "a"]
    q, v, _ = loaded.system.sample_states
    weightless = derive(mechanism, (), regressor=True)
    pi = inertial_parameters(mechanism)
    still = np.zeros_like(v)
    assert np.abs(matrix(weightless, "regressor", q, still, still)).max() == 0
    weight = first(loaded, "bias", q, still, np.zeros((len(q), 6)))
    assert relative(matrix(loaded, "regressor", q, still, still) @ pi, weight) < 1e-12


# Serial arms: Gautier and Khalil 1990; the Panda's 43: Gaz et al., Dynamic identification of the Franka Emika
# Panda robot, IEEE RA-L 2019. Planar loops, counted by hand: of the four planar parameters of a body, a grounded
# crank's mass never moves, and a link's mass between two pins moves to the pins' other bodies.
COUNTS = {
    "ur5": (True, 36),
    "panda": (True, 43),
    "four_bar": (True, 8),  # 12 - 2 cranks' masses - 2 coupler pins
    "slider_crank": (True, 6),  # crank 3, rod 4 - 2 pins, slider's mass
    "five_bar": (True, 11),  # 16 - 2 cranks' masses - 2 crank pins - 1 pin between the couplers
    "planar_3rrr": (True, 13),  # horizontal: cranks 1 each, couplers 4 - 2 pins each, platform 4
}


@pytest.mark.parametrize("name", COUNTS)
def test_number_of_base_parameters(name: str) -> None:
    gravity, count = COUNTS[name]
    found = base_parameters(catalogue.load(name), (Gravity(),) if gravity else ())
    assert len(found) == count
    assert found.gap[0] > 1e3 * found.gap[1] and found.gap[0] > 1e-6


def test_planar_two_link_arm_is_the_textbook_one() -> None:
    """Khalil and Dombre 2002: ZZ1R, ZZ2, MX2, MY2 in a horizontal plane, MX1R and MY1 more under gravity."""
    builder = MechanismBuilder("arm")
    for k, (start, parent) in enumerate([([0, 0, 0], "base"), (["1/2", 0, 0], "first")]):
        name = ("first", "second")[k]
        builder.body(name, mass=2, com=[f"{3 + 10 * k}/20", "1/10", 0], inertia=["0.01", "0.02", "0.03"])
        builder.joint(f"j{k}", "R", parent=parent, child=name, point=start, axes=[[0, 0, 1]], driven=True)
    arm = builder.build()
    horizontal = base_parameters(arm, ())
    assert [horizontal.labels[k] for k in horizontal.independent].count("first.m") == 0
    assert len(horizontal) == 4
    assert len(base_parameters(arm, (Gravity((0, -9.81, 0)),))) == 6
    pi = inertial_parameters(arm)
    base = horizontal.combination @ pi
    length, heavy, far = 0.5, 2.0, np.array([0.65 - 0.5, 0.1])
    inner = 0.03 + 2.0 * (0.15**2 + 0.1**2) + heavy * length**2  # ZZ1R
    outer = 0.03 + heavy * far @ far  # ZZ2
    found = derive(arm, (), regressor=True)
    q = np.zeros((1, 2))
    tau = matrix(found, "regressor", q, q, np.array([[1.0, 0.0]]))[:, :, horizontal.independent] @ base
    assert tau[0, 0] == pytest.approx(inner + outer + 2 * length * heavy * far[0], rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ur5", "three_ups_upu_s_physical", "mixed_loop"])
def test_base_parameters_predict_the_same_forces(name: str) -> None:
    """Y pi = Y[:, independent] combination pi at states that the rank was not found from."""
    found = model(name)
    mechanism = found.mechanism
    base = base_parameters(mechanism)
    q, v, a = found.system.sample_states
    regressor = matrix(found, "regressor_drives", q, v, a)
    random = np.random.default_rng(9).uniform(-1, 1, len(base.labels))  # any parameters, possible or not
    reduced = regressor[:, :, base.independent] @ (base.combination @ random)
    assert relative(reduced, regressor @ random) < 1e-6
    assert base.labels == tuple(f"{b}.{p}" for b in mechanism.bodies if b != mechanism.ground for p in PARAMETERS)


def test_base_parameters_in_words() -> None:
    words = base_parameters(catalogue.load("slider_crank")).words()
    assert len(words) == 6 and sum("slider.m" in w for w in words) >= 1
    assert not any("slider.Iyy" in w or "crank.Ixx" in w for w in words)


def test_too_few_states_are_refused() -> None:
    with pytest.raises(RankError, match="use more states"):
        base_parameters(catalogue.load("panda"), states=8)
