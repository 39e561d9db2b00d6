"""Motion through singular configurations: passed on the right branch, reported with time and place; or stopped."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import ellipk
from support.four_bars_in_a_row import crank_angle, crossing_times, n_four_bar
from support.marks import slow
from support.runs import EXAMPLES, error_of, run_of, scene_of

from symscrew.effects.gravity import Gravity
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Scene
from symscrew.scene.scene_file import load_scene, parse_scene
from symscrew.simulation.motion import simulate

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: crossings are the compiled loop's")


def test_the_closed_form_is_that_of_the_reference() -> None:
    from support.runs import reference

    times, values = reference("n_four_bar")
    assert ellipk(0.5) > 0
    assert np.abs(crank_angle(2, times) - values[:, 0]).max() < 1e-9


@pytest.mark.parametrize("step", [1e-3, slow(7e-4)])
def test_rk4_through_ten_singular_positions(step: float) -> None:
    run = run_of("n_four_bar", scene_of("n_four_bar", method="rk4", step=step))
    assert run.ok
    assert error_of("n_four_bar", run) < 1e-8
    assert run.closure_error.max() < 1e-12
    assert [c.t for c in run.crossings] == pytest.approx(crossing_times(2, 10.0), abs=1e-6)


def test_adaptive_steps_through_ten_singular_positions() -> None:
    """At most 1e-6 at every tolerance from 1e-6 down, not growing when it is tightened, every crossing reported."""
    expected, before = crossing_times(2, 10.0), 1e-6
    assert len(expected) == 10
    for tolerance in (1e-6, 1e-8, 1e-10, 1e-12):
        run = run_of("n_four_bar", scene_of("n_four_bar", tolerance=tolerance))
        assert run.ok
        error = error_of("n_four_bar", run)
        assert error < max(before, 1e-8)  # ten crossings cost digits: a few 1e-9 are what is left
        before = error
        assert run.closure_error.max() < 1e-12
        assert [c.t for c in run.crossings] == pytest.approx(expected, abs=1e-5)
        for crossing in run.crossings:
            assert crossing.lost == 2
            assert np.abs(np.cos(crossing.q[0])) < 1e-6
            assert all(row.split(".")[0] in ("B0", "B1", "C0", "C1") for row in crossing.rows)


@pytest.mark.slow
def test_another_number_of_four_bars() -> None:
    count = 4
    scene = Scene(f"row{count}", n_four_bar(count), (Gravity((0, "-9.81", 0)),), 3.0, 20.0, Initial(rates={"A0": -1.0}))
    run = simulate(scene)
    angle = -run.q[:, [c.label for c in run.model.system.tree.q].index("A0")]
    assert run.ok
    assert np.abs(angle - crank_angle(count, run.t)).max() < 1e-7
    expected = crossing_times(count, 3.0)
    assert [c.t for c in run.crossings] == pytest.approx(expected, abs=1e-6)
    assert {c.lost for c in run.crossings} == {count}


@pytest.mark.slow
def test_the_falling_platform_passes_and_reports_its_singular_configurations() -> None:
    scene = load_scene(EXAMPLES / "scenes" / "falling_platform.toml")
    scene = replace(scene, duration=2.5, initial=Initial(rates={"limb5_S.wx": 0.2, "limb5_S.wy": 0.1}))
    run = simulate(scene)
    assert run.ok
    assert run.energy_error < 1e-7
    assert run.closure_error.max() < 1e-12
    # The times do not depend on the tolerance (1e-6 to 1e-10); independently: the closure's singular values there.
    assert [c.t for c in run.crossings] == pytest.approx([1.525665766, 2.047976801, 2.264804804], abs=1e-7)
    for crossing in run.crossings:
        (jacobian,), _ = run.model("closure_jacobian", crossing.q)
        values = np.linalg.svd(jacobian.reshape(15, 13), compute_uv=False)
        assert values[-1] < 1e-6 < 1e-3 < values[-2]
        assert crossing.lost == 1
        assert all(row.startswith("limb1_U2") for row in crossing.rows)


@pytest.mark.slow
def test_at_rest_in_a_singular_configuration_the_run_says_so() -> None:
    scene = parse_scene(
        """
        [scene]
        mechanism = "examples/benchmarks/mechanisms/n_four_bar.toml"
        duration = 1
        [initial.coordinates]
        A0 = "-pi/2"
        A1 = "-pi/2"
        A2 = "-pi/2"
        [[effects]]
        type = "gravity"
        acceleration = [0, "-9.81", 0]
        """,
        folder=EXAMPLES.parent,
    )
    run = simulate(scene)
    assert not run.ok
    assert "at rest in a singular configuration" in run.status
    assert len(run.t) == 1


@pytest.mark.slow
def test_states_of_effects_through_singular_configurations() -> None:
    """The motor's current follows its own law on the second path too; every joule is accounted for."""
    from symscrew.effects import DcMotor
    from symscrew.program.numpy_evaluation import evaluate
    from symscrew.simulation.motion import prepare
    from symscrew.simulation.scene_functions import PlantFunctions

    motor = DcMotor("A0", torque_constant="0.5", resistance=2, inductance="0.1", current="0.3")
    effects = (Gravity((0, "-9.81", 0)), motor)
    scene = Scene("motor", n_four_bar(1), effects, 3.0, 20.0, Initial(rates={"A0": -1.0}))
    prepared = prepare(scene)
    model, plant = prepared
    q, v = np.array([-np.pi / 2, -np.pi / 2, np.pi / 2]), np.array([-3.0, -3.0, 3.0])
    places = [("A0", "A1", "B0").index(c.label) for c in model.system.tree.q]
    q, v = q[places], v[places]
    x = np.array([0.3, 0.0])
    assert abs(model("closure", q)[0][0]).max() < 1e-12
    at_once = [np.zeros(1), q, v, x, np.zeros(0), np.zeros(0), plant.parameters]
    assert evaluate(plant.slopes, at_once)[1] == 1  # a pivot is small
    for compiled in (False, True):
        _, rates = PlantFunctions(plant, [], compiled=compiled).slopes(0.0, q, v, x, u=np.zeros(0), outside=np.zeros(0))
        expected = (0 - 2 * 0.3 - 0.5 * -3.0) / 0.1
        assert rates[0] == pytest.approx(expected, rel=1e-12)
    run = simulate(scene, prepared=prepared)
    assert run.ok, run.status
    assert len(run.crossings) >= 3
    assert run.energy_error < 1e-7
    assert np.abs(run.x[:, 0]).max() > 0.1
