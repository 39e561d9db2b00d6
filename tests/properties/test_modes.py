"""Code for one operation mode: equal to the general code on the mode, and a failure off it."""

from __future__ import annotations

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model
from support.operation_counts import recorded
from support.operation_modes import PARALLELOGRAM, models, states

from symscrew import catalogue
from symscrew.description import toml_file
from symscrew.effects.gravity import Gravity
from symscrew.loops.modes import SOLVED
from symscrew.model import Model, derive

pytestmark = pytest.mark.slow


def crossed() -> np.ndarray:
    """A configuration of the parallelogram with its crank and rocker crossed."""
    general = models("parallelogram")[0]
    y = general.system.reference[None, list(general.programs["assemble"].independent)]
    random = np.random.default_rng(1)
    (reached, *_), _ = general("assemble", y, general.system.reference[None, :])
    for _ in range(50):
        guess = general.system.reference + random.uniform(-2, 2, general.system.reference.shape)
        (q, *_), status = general("assemble", y, guess[None, :])
        if status[0] == 0 and np.abs(np.sin((q - reached) / 2)).max() > 0.1:
            return q
    raise AssertionError("expected a second assembly")


def followers(found: Model) -> set[str]:
    note = next(n for n in found.notes if n.startswith("operation mode"))
    return set(note.split(" determine ")[1].split(";")[0].split(", "))


@pytest.mark.slow
def test_a_delta_s_platform_does_not_turn_and_its_rods_stay_parallel() -> None:
    expected = {f"rod{k}b_U.{i}" for k in (1, 2, 3) for i in (0, 1)} | {f"platform_pose.q{c}" for c in "wxyz"}
    assert followers(models("delta")[0]) == expected


@pytest.mark.slow
def test_opposite_limbs_of_the_seed_lean_alike() -> None:
    assert followers(models("three_ups_upu_s_physical")[1]) == {"limb3_U.0"}


@pytest.mark.parametrize("name", ["five_bar", "ur5"])
def test_where_nothing_follows_nothing_changes(name: str) -> None:
    general, alone = model(name), derive(catalogue.load(name), one_mode=True)
    assert not any("operation mode" in note for note in (*general.notes, *alone.notes))
    assert general.programs == alone.programs


@pytest.mark.parametrize("name", [slow("delta"), "parallelogram", slow("three_ups_upu_s_physical"), "sarrus"])
def test_on_the_mode_both_are_equal(name: str) -> None:
    general, alone = models(name, derivatives=name == "sarrus")
    compared = 0
    for function, program in general.programs.items():
        if function not in general.test_inputs:
            continue
        if not any(function == s or function.startswith(f"{s}_") for s in SOLVED):
            assert program.operations == alone.programs[function].operations, function
            continue
        inputs = states(general, function)
        (expected, status), (found, same) = general(function, *inputs), alone(function, *inputs)
        good = (np.asarray(status) == 0) & (np.asarray(same) == 0)
        assert good.sum() >= len(good) - 1, function
        for x, y in zip(expected, found, strict=True):
            size = max(1.0, np.abs(x[good]).max(initial=0.0))
            assert np.abs(x[good] - y[good]).max(initial=0.0) < 1e-9 * size, function
        compared += 1
    assert compared >= 6


@pytest.mark.slow
def test_the_mode_takes_a_part_of_the_operations_of_a_delta() -> None:
    general, alone = models("delta")
    shares = dict.fromkeys(("inverse_dynamics", "velocity", "acceleration", "forward_dynamics"), 1 / 3)
    limits = recorded("one mode", "delta")
    for name, share in shares.items():
        assert alone.programs[name].operations["total"] <= limits[name]
        count = alone.programs[name].operations["total"]
        assert count < share * general.programs[name].operations["total"]


def test_off_the_mode_functions_fail_or_take_the_second_path() -> None:
    general, alone = models("parallelogram")
    q = crossed()
    y_dot, zero = np.array([[0.7]]), np.zeros((1, 3))
    (v,), status = general("velocity", q, y_dot)
    assert status[0] == 0
    assert alone("velocity", q, y_dot)[1][0] == 1
    assert alone("inverse_dynamics", q, v, zero)[1][0] == 1
    assert np.isnan(alone("inverse_dynamics", q, v, zero)[0][0]).all()
    u = np.array([[0.3]])
    (expected,), status = general("forward_dynamics", q, v, u)
    (found,), second = alone("forward_dynamics", q, v, u)
    assert (status[0], second[0]) == (0, -1)
    assert np.allclose(found, expected, rtol=1e-9, atol=1e-9)


def test_the_mode_goes_on_where_it_meets_another_one() -> None:
    """In one line the parallelogram could cross its rods: a singularity, but not of either mode."""
    general, alone = models("parallelogram")
    q, _, _ = alone.system.states(2, 5)
    slope = np.round((q[1] - q[0]) / (q[1, 0] - q[0, 0]))  # +1 or -1
    flat = (alone.system.reference + slope * np.arctan2(0.3, 0.1))[None, :]
    assert np.abs(np.asarray(general("closure", flat)[0][0])).max() < 1e-12
    y_dot = np.array([[0.7]])
    assert general("velocity", flat, y_dot)[1][0] == 1
    (rates,), status = alone("velocity", flat, y_dot)
    assert status[0] == 0 and np.allclose(rates, 0.7 * slope, rtol=0, atol=1e-12)
    u = np.array([[0.3]])
    near = [flat + slope * h for h in (-1e-3, 1e-3)]
    (found,), status = alone("forward_dynamics", flat, rates, u)
    sides = [general("forward_dynamics", beside, rates, u) for beside in near]
    assert status[0] == 0 and all(s[0] == 0 for _, s in sides)
    assert np.allclose(found, (sides[0][0][0] + sides[1][0][0]) / 2, rtol=1e-5, atol=1e-5)


@pytest.mark.slow
def test_rates_off_the_mode_are_noticed() -> None:
    """At a configuration of the mode rates may still lead away from it."""
    _, alone = models("delta")
    q, v, a = (x.copy() for x in alone.system.states(3, 5))
    turn = [c.label for c in alone.system.tree.v].index("platform_pose.wx")
    for size, status in ((0.0, 0), (1e-9, 0), (1e-4, 1), (np.nan, 1)):
        v[2, turn] = size * np.abs(v[2]).max() if np.isfinite(size) else size
        assert alone("inverse_dynamics", q, v, a)[1][2] == status, size


def test_a_state_at_rest_is_of_the_mode() -> None:
    _, alone = models("delta")
    q, v, a = alone.system.states(3, 5)
    for rates in (np.zeros_like(v), np.full_like(v, 1e-15)):
        assert (alone("inverse_dynamics", q, rates, a)[1] == 0).all()


def test_run_time_parameters_have_no_modes() -> None:
    """What follows at the nominal lengths need not follow at others."""
    text = (
        PARALLELOGRAM.replace('mass = "1.2"', 'mass = "m"')
        + '\n[parameters]\nm = {value = "1.2", unit = "kg", run_time = true}\n'
    )
    found = derive(toml_file.parse_description(text), (Gravity(),), one_mode=True)
    assert not any("operation mode" in note for note in found.notes)
