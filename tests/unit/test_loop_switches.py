"""Both sides of every number in loops, dynamics and functions that decides what is derived, seen in what comes out."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support.operation_modes import parallelogram

from symscrew import catalogue
from symscrew.algebra import Guard
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.dynamics import coriolis, free_motion
from symscrew.effects import ViscousFriction
from symscrew.functions import base_parameters, closing, derivative, identifiable
from symscrew.functions.forward import SINGULAR_NOTE
from symscrew.functions.identifiable import RankError
from symscrew.functions.ports import function, q_port
from symscrew.kinematics.system import System
from symscrew.loops import dependent_rates, modes
from symscrew.loops.modes import operation_mode
from symscrew.model import Model, derive
from symscrew.program import Port, evaluate, lower

pytestmark = pytest.mark.slow


@cache
def four_bar() -> Model:
    return derive(catalogue.load("four_bar"), derivatives=True)


def arm() -> Mechanism:
    builder = MechanismBuilder("arm")
    for k in (1, 2):
        builder.body(f"link{k}", mass=k, com=[k, 0, 0], inertia={"principal": [0, "1/9", "1/9"]})
        parent = "base" if k == 1 else "link1"
        builder.joint(f"J{k}", "R", parent=parent, child=f"link{k}", point=[k - 1, 0, 0], axes=[[0, 1, 0]], driven=True)
    return builder.build()


def same_accelerations(first: Model, second: Model) -> None:
    q, v, _ = first.system.states(5, 3)
    u = np.linspace(-1.0, 2.0, len(q) * len(first.system.drives)).reshape(len(q), -1)
    (expected, *_), status = first("forward_dynamics", q, v, u)
    (found, *_), again = second("forward_dynamics", q, v, u)
    assert not status.any() and not again.any()
    assert np.abs(found - expected).max() < 1e-10 * np.abs(expected).max()


def said(found: Model) -> list[str]:
    return [note for note in found.notes if "tried" in note]


# -- which ways are built --------------------------------------------------------------------------------------------


def test_beyond_small_only_the_first_ways_are_built_and_the_notes_say_so(monkeypatch: pytest.MonkeyPatch) -> None:
    freedoms = len(four_bar().system.tree.v)
    monkeypatch.setattr(dependent_rates, "SMALL", freedoms)
    assert said(derive(catalogue.load("four_bar"))) == said(four_bar()) == []
    monkeypatch.setattr(dependent_rates, "SMALL", freedoms - 1)
    found = derive(catalogue.load("four_bar"))
    assert said(found) == [
        f"{freedoms} freedoms of the tree: of the ways to write the loops, to order the elimination of forces and to "
        "solve for accelerations only the first was tried, others may take fewer operations"
    ]
    same_accelerations(four_bar(), found)


def test_long_trees_are_solved_by_articulated_bodies_and_the_notes_say_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(free_motion, "LONG", 2)
    by_mass_matrix = derive(arm())
    monkeypatch.setattr(free_motion, "LONG", 1)
    by_bodies = derive(arm())
    assert said(by_mass_matrix) == []
    assert said(by_bodies) == [
        "2 freedoms: forward dynamics is by articulated bodies; by the mass matrix was not tried"
    ]
    assert by_mass_matrix.programs["forward_dynamics"] != by_bodies.programs["forward_dynamics"]
    same_accelerations(by_mass_matrix, by_bodies)


def test_of_long_branches_the_recursion_is_taken_and_the_notes_say_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(coriolis, "SHORT", 1)
    found = derive(catalogue.load("four_bar"))
    assert said(found) == [
        "1 long branches on the ground: their forces at rest accelerations are by the recursion; by the derivatives "
        "of their mass matrix was not tried"
    ]
    same_accelerations(four_bar(), found)


def test_forward_dynamics_needs_an_inertia_that_is_not_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    assert "forward_dynamics" in four_bar().programs and SINGULAR_NOTE not in four_bar().notes
    monkeypatch.setattr(free_motion, "MASSLESS", 2.0)
    found = derive(catalogue.load("four_bar"))
    assert "forward_dynamics" not in found.programs and SINGULAR_NOTE in found.notes


# -- operation modes -------------------------------------------------------------------------------------------------


def followers(name: str, value: float, monkeypatch: pytest.MonkeyPatch) -> int:
    monkeypatch.setattr(modes, name, value)
    system = System(parallelogram())
    system.use_samples()
    return len(operation_mode(system, [0]).q)


@pytest.mark.parametrize("name, none, some", [("MOVES", 10.0, 0.01), ("SAME", 0.0, 1e-9)])
def test_what_moves_and_what_is_the_same(name: str, none: float, some: float, monkeypatch: pytest.MonkeyPatch) -> None:
    assert followers(name, none, monkeypatch) == 0
    assert followers(name, some, monkeypatch) == 2


@cache
def one_mode() -> Model:
    return derive(parallelogram(), one_mode=True)


def of_the_mode(off: float, rates_off: float, rate: float) -> bool:
    found = one_mode()
    q, v, _ = found.system.states(2, 3)
    followed = [f.index for f in operation_mode(found.system, [0]).q]
    q, v = q[1:], v[1:]  # without the reference, which is flat
    v = rate * v / np.abs(v).max(axis=1, keepdims=True)
    q[:, followed] += off
    v[:, followed[:1]] += rates_off
    u = np.ones((len(q), len(found.system.drives)))
    return bool((found("forward_dynamics", q, v, u)[1] == 0).all())


def test_states_off_the_mode_fail_beyond_a_millionth() -> None:
    assert of_the_mode(0.5 * modes.OFF, 0.0, 1.0)
    assert not of_the_mode(2.0 * modes.OFF, 0.0, 1.0)


def test_rates_off_the_mode_fail_beyond_a_millionth_of_the_independent_ones_and_beyond_rounding() -> None:
    assert of_the_mode(0.0, 0.1 * modes.OFF, 1.0)
    assert not of_the_mode(0.0, 10.0 * modes.OFF, 1.0)
    assert of_the_mode(0.0, 0.5 * modes.NOTHING, 0.0)
    assert not of_the_mode(0.0, 2.0 * modes.NOTHING, 0.0)


# -- pivots and steps ------------------------------------------------------------------------------------------------


def test_a_pivot_is_near_singular_below_its_threshold() -> None:
    system = System(arm())
    x = system.inputs.q[0]
    guards = closing.guarded([Guard(x, 0.5)])
    port = Port("x", (1,), ("1",), ("x",), "x")
    made = function(
        system, "pivot", "", inputs=[(q_port(system), system.inputs.q)], outputs=[(port, [x])], guards=guards
    )
    limit = closing.THRESHOLD / 0.5
    _, status = evaluate(lower(made), [np.array([[0.9 * limit, 0.0], [1.1 * limit, 0.0], [-0.9 * limit, 0.0]])])
    assert list(status) == [1, 0, 1]


def assembled(name: str, value: float, monkeypatch: pytest.MonkeyPatch) -> bool:
    monkeypatch.setattr(closing, name, value)
    found = derive(catalogue.load("four_bar"))
    q = found.system.reference[None, :]
    y = q[:, list(found.programs["assemble"].independent)] + 0.3  # type: ignore[union-attr]
    return bool(found("assemble", y, q)[1][0] == 0)


@pytest.mark.parametrize("name, refused, taken", [("NEWTON_THRESHOLD", 100.0, 1e-12), ("STEP_LIMIT", 1e-6, 0.5)])
def test_assembly(name: str, refused: float, taken: float, monkeypatch: pytest.MonkeyPatch) -> None:
    assert not assembled(name, refused, monkeypatch)
    assert assembled(name, taken, monkeypatch)


def test_derivatives_fail_sooner_than_what_they_are_of(monkeypatch: pytest.MonkeyPatch) -> None:
    def status(found: Model) -> tuple[int, int]:
        name = "forward_dynamics_independent"
        inputs = [x[1:2] for x in found.test_inputs[name]]
        return found(name, *inputs)[1][0], found(f"{name}_derivatives", *inputs)[1][0]

    assert status(four_bar()) == (0, 0)
    monkeypatch.setattr(derivative, "LOSING", 100.0)
    assert status(derive(catalogue.load("four_bar"), derivatives=True)) == (0, 1)


# -- base parameters -------------------------------------------------------------------------------------------------


Base = tuple[int, float, tuple[str, ...]]


@pytest.fixture(scope="module")
def base() -> Base:
    """How many there are, the least singular value that counts, and the parameters in words."""
    found = base_parameters(catalogue.load("four_bar"))
    return len(found), found.gap[0], found.words()


@pytest.mark.parametrize("name, value", [("FAINT", 2.0), ("FAR", 0.0)])
def test_nothing_is_identified_where_nothing_counts(
    name: str, value: float, base: Base, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(identifiable, name, value)
    assert base[0] == 8 and len(base_parameters(catalogue.load("four_bar"))) == 0


@pytest.mark.parametrize("name, value", [("CLEAR", 1e30), ("FLOOR", 1e-3)])
def test_a_gap_that_is_not_clear_is_an_error(name: str, value: float, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(identifiable, name, value)
    with pytest.raises(RankError, match="a clear gap"):
        base_parameters(catalogue.load("four_bar"))


@pytest.mark.parametrize("name, value", [("ROUNDS", 0), ("STEP", 1e-12), ("DEPENDENT", 2.0)])
def test_states_that_hardly_differ_tell_less(
    name: str, value: float, base: Base, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(identifiable, name, value)
    found = base_parameters(catalogue.load("four_bar"))
    assert len(found) == base[0] and found.gap[0] < base[1]


@pytest.mark.parametrize("name, value", [("ROUNDING", 10.0), ("TIED", 0.9)])
def test_which_columns_stand_for_a_combination(
    name: str, value: float, base: Base, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(identifiable, name, value)
    found = base_parameters(catalogue.load("four_bar"))
    assert len(found) == base[0] and found.words() != base[2]


@pytest.mark.parametrize("name, value", [("REACHED", 10.0), ("CARRIES", 1e9)])
def test_drives_that_hardly_push_have_no_regressor(name: str, value: float, monkeypatch: pytest.MonkeyPatch) -> None:
    from symscrew.functions import regressor

    effects = (ViscousFriction("J1", 1),)
    assert "regressor_drives" in derive(arm(), effects, regressor=True).programs
    monkeypatch.setattr(regressor, name, value)
    assert "regressor_drives" not in derive(arm(), effects, regressor=True).programs


# -- for people ------------------------------------------------------------------------------------------------------


def test_a_model_is_one_line() -> None:
    assert repr(one_mode()) == (
        "Model('parallelogram', 3 bodies, 4 joints, 1 freedom, "
        f"{len(one_mode().programs)} functions, one operation mode)"
    )


def test_base_parameters_are_one_line() -> None:
    found = repr(base_parameters(catalogue.load("four_bar")))
    assert found.startswith("BaseParameters(8 of 30, ") and "gap 1.1e-02 to " in found and "\n" not in found
