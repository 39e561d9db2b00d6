"""Runs against reference histories, conservation laws, other engines, and each other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.marks import slow
from support.runs import EXAMPLES, compiled, error_of, order, reference, run_of, scene_of, values_of

from symscrew.runtime.compiled import find_compiler
from symscrew.scene.scene_file import load_scene, parse_scene
from symscrew.simulation.motion import evaluated, prepare, simulate

pytestmark = pytest.mark.short_runs

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these runs would take minutes")


@pytest.mark.parametrize(
    "name, tolerance, error",
    [
        slow("bricard", 1e-7, 1e-9),
        slow("andrews", 1e-7, 1e-8),
        ("spatial_slider_crank", 1e-8, 1e-8),
        ("heavy_top", 1e-8, 1e-8),
        ("light_cart_pole", 1e-8, 1e-6),
        slow("delta", 1e-8, 1e-10),
        slow("flyball_governor", 1e-6, 1e-9),
    ],
)
@needs_compiler
def test_reference_histories(name: str, tolerance: float, error: float) -> None:
    run = run_of(name, scene_of(name, tolerance=tolerance))
    assert run.ok, run.status
    assert error_of(name, run) < error
    assert run.closure_error.max() < 1e-12
    assert run.energy_error < 1e-8


@needs_compiler
def test_the_body_that_flips_ends_where_quadruple_precision_ends() -> None:
    """Rates and attitude after 15 flips in 100 s: Lagrange's equations in 113 bits by extrapolation of order 24, whose
    rates agree with Jacobi's elliptic functions to 1e-16."""
    run = simulate(load_scene(EXAMPLES / "benchmarks" / "dzhanibekov.toml"))
    assert run.ok, run.status
    rates = [0.00242775275057238160, -4.99999951060163425775, 0.00162213680248325177]
    attitude = np.array(
        [-0.000423031708264368307, 0.970525493439945903, 0.0000467934560883237690, -0.240998102560364139]
    )
    assert run.v[-1] == pytest.approx(rates, abs=1e-6)
    assert run.q[-1] * np.sign(run.q[-1, 1]) == pytest.approx(attitude, abs=1e-6)
    assert run.energy_error < 1e-10


@needs_compiler
@pytest.mark.parametrize("method, steps, expected", [
    ("euler", (1e-4, 5e-5), 1), ("semi_implicit_euler", (1e-4, 5e-5), 1), ("rk4", (2e-3, 1e-3, 5e-4), 4),
    ("rk8", (4e-3, 2e-3), 8),
])  # fmt: skip
def test_orders_of_the_fixed_step_methods_with_quaternions(method: str, steps: tuple, expected: int) -> None:
    """The heavy top turns by quaternions: the Lie-group update keeps the order."""
    errors = []
    for step in steps:
        run = run_of("heavy_top", scene_of("heavy_top", until=0.2, method=method, step=step))
        assert np.abs(np.linalg.norm(run.q, axis=1) - 1).max() < 1e-15 * 4
        errors.append(error_of("heavy_top", run))
    assert order(steps, errors) == pytest.approx(expected, abs=0.15 * expected)


@needs_compiler
def test_orders_hold_with_loops_and_projection() -> None:
    steps = (8e-3, 4e-3, 2e-3)
    runs = [run_of("bricard", scene_of("bricard", until=4.0, method="rk4", step=step)) for step in steps]
    assert order(steps, [error_of("bricard", run) for run in runs]) == pytest.approx(4, abs=0.1)


@needs_compiler
def test_two_runs_have_the_same_bits() -> None:
    first, second = (run_of("andrews", scene_of("andrews")) for _ in range(2))
    for name in ("t", "q", "v", "u", "x", "energy", "closure_error", "energy_balance"):
        assert getattr(first, name).tobytes() == getattr(second, name).tobytes(), name


def test_the_loop_without_a_compiler_gives_the_same_motion() -> None:
    scene = scene_of("andrews", until=0.01, tolerance=1e-7)
    model, plant, _ = compiled("andrews")
    run = simulate(scene, prepared=(model, plant), backend="numpy")
    assert run.backend == "library"
    assert error_of("andrews", run) < 1e-8
    assert run.closure_error.max() < 1e-12


@pytest.mark.parametrize("method", ["radau", "bdf", "lsoda", "cvodes"])
def test_libraries_for_stiff_scenes(method: str) -> None:
    scene = scene_of("andrews", until=0.002, method=method, tolerance=1e-5)
    model, plant, _ = compiled("andrews")
    run = simulate(scene, prepared=(model, plant))
    assert run.ok, run.status
    assert error_of("andrews", run) < 1e-5
    assert run.closure_error.max() < 1e-12


DRIVEN = """
[scene]
mechanism = "four_bar"
duration = 0.3
rate = 100
[tables.pull]
times = [0, 0.1, 0.3]
values = [0, 2, -1]
interpolation = "cubic"
[signals]
wish = "0.1*sin(5*t) + filtered"
[states.filtered]
rate = "10*(q_A - filtered)"
initial = 0.05
[drives]
A = "20*(wish - q_A) - v_A + pull"
[[effects]]
type = "gravity"
[integrator]
tolerance = 1e-9
"""


@pytest.mark.slow
def test_controllers_with_states_signals_and_tables() -> None:
    """The scene's controller in the compiled loop, and the same controller as a Python function of SciPy's run."""
    from symscrew.scene.contents import Table

    scene = parse_scene(DRIVEN)
    run = simulate(scene)
    assert run.ok
    assert run.x_labels == ("filtered", "work")
    labels = [c.label for c in run.model.system.tree.q]
    a = labels.index("A")
    filtered, q, v = run.x[:, 0], run.q[:, a], run.v[:, a]
    table = Table("pull", (0.0, 0.1, 0.3), (0.0, 2.0, -1.0), "cubic")
    expected = 20 * (0.1 * np.sin(5 * run.t) + filtered - q) - v + table(run.t)
    assert np.abs(run.u[:, 0] - expected).max() < 1e-12
    assert run.energy_error < 1e-8
    slopes = np.gradient(filtered, run.t, edge_order=2)
    assert np.abs(slopes - 10 * (q - filtered))[2:-2].max() < 2e-2 * np.abs(slopes).max()
    other = simulate(scene, backend="numpy")
    assert np.abs(other.q - run.q).max() < 1e-8


def test_a_python_controller_and_what_it_may_return() -> None:
    from symscrew.errors import DescriptionError

    scene = parse_scene(DRIVEN.split("[tables")[0] + '[[effects]]\ntype = "gravity"')
    run = simulate(scene, controller=lambda t, q, v: [-0.5 * v[0]])
    assert run.u[:, 0] == pytest.approx(-0.5 * run.v[:, 0])
    assert run.energy_error < 1e-8
    with pytest.raises(DescriptionError, match="expected 1 finite numbers"):
        simulate(scene, controller=lambda t, q, v: [1, 2])


@pytest.mark.slow
def test_motion_under_inverse_dynamics_drives_is_the_prescribed_one() -> None:
    """Open loop: the drives of a prescribed motion of the platform, computed beforehand, give that motion."""
    scene = parse_scene(
        """
        [scene]
        mechanism = "three_ups_upu_s_physical"
        duration = 0.3
        rate = 20
        [[effects]]
        type = "gravity"
        [integrator]
        tolerance = 1e-8
        """
    )
    model, plant = prepare(scene, held=True)
    guess = model.system.reference

    def state(t: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        y = np.array([0.03 * (1 - np.cos(4 * t)), 0.02 * (1 - np.cos(6 * t))])
        y_dot = np.array([0.12 * np.sin(4 * t), 0.12 * np.sin(6 * t)])
        y_ddot = np.array([0.48 * np.cos(4 * t), 0.72 * np.cos(6 * t)])
        return y, y_dot, y_ddot

    def drives(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        y, y_dot, y_ddot = state(t)
        (at,), status = model("assemble", y, guess)
        assert status == 0
        return model("inverse_dynamics_independent", at, y_dot, y_ddot)[0][0]

    run = simulate(scene, controller=drives, prepared=(model, plant))
    expected = np.array([model("assemble", state(t)[0], guess)[0][0] for t in run.t])
    assert run.ok
    assert np.abs(run.q - expected).max() < 1e-8
    assert run.energy_error < 1e-8


@pytest.mark.slow
def test_reactions_at_every_output_balance_the_momentum_of_the_whole_system() -> None:
    """Rate of the total momentum screw = wrenches of the base on the system + weight, at every output."""
    scene = parse_scene(
        """
        [scene]
        mechanism = "three_ups_upu_s_physical"
        duration = 0.2
        rate = 50
        reactions = true
        [initial.rates]
        limb5_S.wx = 0.7
        limb5_S.wy = 0.3
        [[effects]]
        type = "gravity"
        """
    )
    run = simulate(scene)
    assert run.reactions is not None
    n = len(run.t)
    a = evaluated(run.model, "forward_dynamics", {"q": run.q, "v": run.v, "u": np.zeros((n, 4))})["a"]
    rates = evaluated(run.model, "momentum_rates", {"q": run.q, "v": run.v, "a": a})["momentum_rates"]
    total = rates.reshape(n, -1, 6).sum(axis=1)
    reactions = run.reactions.reshape(n, -1, 6)
    names = list(run.model.mechanism.joints)
    base = sum(reactions[:, names.index(j.name)] for j in run.model.mechanism.joints.values() if j.parent == "base")
    weight = np.zeros((n, 6))
    poses = evaluated(run.model, "body_poses", {"q": run.q})["poses"].reshape(n, -1, 12)
    bodies = [b for name, b in run.model.mechanism.bodies.items() if name != "base"]
    for k, body in enumerate(bodies):
        mass = float(run.model.mechanism.number(body.mass))
        com = np.array([float(run.model.mechanism.number(c)) for c in body.com])
        turn = poses[:, k, :9].reshape(n, 3, 3).transpose(0, 2, 1)
        at = turn @ com + poses[:, k, 9:]
        force = np.array([0.0, 0.0, -9.81 * mass])
        weight += np.concatenate([np.repeat(force[None], n, 0), np.cross(at, force)], 1)
    assert np.abs(total - base - weight).max() < 1e-10 * np.abs(weight).max()


@pytest.mark.slow
@needs_compiler
@pytest.mark.short_runs(False)
@pytest.mark.parametrize("name, duration", [("hanging_platform", 100.0), ("hanging_delta", 30.0)])
def test_energy_drift_over_a_long_time(name: str, duration: float) -> None:
    run = simulate(replace(load_scene(EXAMPLES / "scenes" / f"{name}.toml"), duration=duration))
    assert run.ok
    assert run.t[-1] == duration
    assert run.energy_error < 1e-8
    assert run.closure_error.max() < 1e-12


def test_a_run_that_ends_early_keeps_what_it_has() -> None:
    scene = scene_of("heavy_top", until=0.4, most_steps=60)
    run = run_of("heavy_top", scene) if find_compiler() else simulate(scene)
    assert not run.ok
    assert "stopped at t = " in run.status
    assert "more steps than most_steps allows" in run.status
    times, expected = reference("heavy_top")
    assert 2 < len(run.t) < len(times)
    assert np.abs(values_of("heavy_top", run)[:-1] - expected[: len(run.t) - 1]).max() < 1e-7
    assert replace(scene).times[-1] == 0.4
