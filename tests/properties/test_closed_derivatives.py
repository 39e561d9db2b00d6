"""Derivatives from the equations of motion against the differentiated program, also with effects."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.model_states import HAND_TYPED, relative
from sympy import Rational

from symscrew import catalogue
from symscrew import effects as known
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects.effect import Effect
from symscrew.effects.gravity import Gravity
from symscrew.functions import closed_derivative
from symscrew.kinematics.system import System
from symscrew.loops.dependent_rates import Loops
from symscrew.model import Model, derive

FUNCTIONS = tuple(f"{kind}_dynamics_independent_derivatives" for kind in ("inverse", "forward"))


def effect(name: str, *args: object, **fields: object) -> Effect:
    return getattr(known, name)(*args, **fields)


def skew_universal() -> Mechanism:
    """The seed with a cut universal joint whose axes are not perpendicular."""
    seed = catalogue.load("three_ups_upu_s_physical")
    joint = seed.joints["limb1_U2"]
    first, second = joint.axes
    tilted = tuple(Rational(3, 5) * a + Rational(4, 5) * b for a, b in zip(first, second, strict=True))
    return replace(seed, joints={**seed.joints, joint.name: replace(joint, axes=(first, tilted))})


def loaded(name: str) -> Mechanism:
    if name == "skew_universal":
        return skew_universal()
    return HAND_TYPED[name]() if name in HAND_TYPED else catalogue.load(name)


FORCES = (
    effect("JointSpring", "crank_R", stiffness=2, damping="0.3"),
    effect("RotorInertia", "crank_R", "0.4", 3),
    effect("DryFriction", "slider_P", coulomb=2, velocity="0.1"),
)
ROTOR = effect("RotorInertia", "limb2_P", "0.4")
CASES = [
    ("slider_crank", (Gravity(), *FORCES)),
    ("four_bar", (Gravity(), effect("BaseMotion"))),
    ("five_bar", (Gravity(), effect("ViscousFriction", "base_left", 3))),
    pytest.param("spatial_loop", (Gravity(),), marks=pytest.mark.slow),
    pytest.param("mixed_loop", (Gravity(),), marks=pytest.mark.slow),
    pytest.param("skew_universal", (effect("ExternalWrench", "E"), ROTOR), marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("name", "effects"), CASES)
def test_equal_to_the_differentiated_program(
    name: str, effects: tuple[Effect, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    found = derive(loaded(name), effects, derivatives=True)
    monkeypatch.setattr(closed_derivative, "covers", lambda system, acting: False)
    plain = derive(loaded(name), effects, derivatives=True)
    random = np.random.default_rng(1)
    q = found.system.sample_states[0][1:]
    for function in FUNCTIONS:
        program = found.programs[function]
        assert program.hash != plain.programs[function].hash, "both came the same way"
        assert program.inputs == plain.programs[function].inputs
        assert program.outputs == plain.programs[function].outputs
        given = [q, *(random.uniform(0.1, 1, (len(q), port.size)) for port in program.inputs[1:])]
        for got, expected in zip(called(found, function, given), called(plain, function, given), strict=True):
            assert relative(got, expected) < 1e-12


def called(found: Model, function: str, given: list[np.ndarray]) -> tuple[np.ndarray, ...]:
    results, status = found(function, *given)
    assert np.all(status == 0)
    return results


def test_multipliers_hold_the_dependent_rates() -> None:
    """J^T multipliers gives back the forces along all dependent joint rates, and uses every independent row."""
    system = System(catalogue.load("five_bar"))
    system.use_samples()
    loops = Loops(system)
    forces = [system.tape.constant(0.3 * k - 1) for k in range(len(system.tree.v))]
    found = closed_derivative.multipliers(loops, forces)
    assert set(found) == {row for row, *_ in loops.elimination.steps}
    for _, column, *_ in loops.elimination.steps:
        terms = [
            system.tape.sample(system.jacobian[row][column] * m)
            for row, m in found.items()
            if column in system.jacobian[row]
        ]
        assert relative(sum(terms), np.full(system.sample_states[0].shape[0], float(forces[column].value))) < 1e-12


def test_what_the_equations_do_not_cover_is_differentiated() -> None:
    """Transmissions, load-dependent friction and simplifications keep the differentiated program, with results."""
    for effects in (
        (Gravity(), effect("QuasiStatic")),
        (Gravity(), effect("DryFriction", "slider_P", coulomb=2, load="0.1", velocity="0.1")),
    ):
        found = derive(catalogue.load("slider_crank"), effects, derivatives=True)
        program = found.programs[FUNCTIONS[0]]
        given = found.test_inputs[FUNCTIONS[0]]
        _, status = found(FUNCTIONS[0], *given)
        assert np.all(status == 0) and program.outputs[0].name == "du_dy"


def test_where_nothing_moves_there_is_nothing_to_differentiate_along() -> None:
    """Three bars that hold each other: the derivatives of the tree are there, none along independent coordinates."""
    builder = MechanismBuilder("triangle")
    for name, place in (("left", [1, 1, 0]), ("right", [2, 1, 0])):
        builder.body(name, mass=1, com=place, inertia=["0.1", "0.1", "0.1"])
    builder.joint("A", "R", parent="base", child="left", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    builder.joint("B", "R", parent="base", child="right", point=[3, 0, 0], axes=[[0, 0, 1]])
    builder.joint("C", "R", parent="left", child="right", point=[1, 2, 0], axes=[[0, 0, 1]])
    found = derive(builder.build(), derivatives=True, second_derivatives=True)
    names = {name for name in found.programs if "derivatives" in name or name == "linearisation"}
    assert names == {"inverse_dynamics_derivatives"}
    (u, *_), status = found("inverse_dynamics_derivatives", *found.test_inputs["inverse_dynamics_derivatives"])
    assert np.all(status == 0) and np.isfinite(u).all()
