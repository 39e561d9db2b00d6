"""Trajectory optimisation of closed chains and robots: the examples, and what must hold of every optimum."""

from __future__ import annotations

import importlib.util
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import sympy
from support.marks import slow
from support.optimal_problems import MINIMUM_TIME, SEED_DRIVES, rest_to_rest, seed

from symscrew import catalogue
from symscrew.effects import Gravity
from symscrew.model import derive
from symscrew.optimisation.followed_motion import replay
from symscrew.optimisation.mesh_errors import switching
from symscrew.optimisation.motion_equations import PointEquations
from symscrew.optimisation.problem import Objective, TrajectoryProblem, Transcription
from symscrew.optimisation.problem_file import load_problem
from symscrew.optimisation.result import Trajectory
from symscrew.optimisation.solution import prepare, solve
from symscrew.program.numpy_evaluation import evaluate

EXAMPLES = Path(__file__).parents[2] / "examples" / "optimisation"
COARSE = Transcription("radau", 3, 20)


def example(name: str, **changes: object) -> TrajectoryProblem:
    return replace(load_problem(EXAMPLES / f"{name}.toml"), **changes)


def power(found: Trajectory) -> tuple[np.ndarray, np.ndarray]:
    """Times and power of every drive."""
    samples = found.sample(count=401)
    return samples.t, samples.u * found.of_tree("drive_rates", samples)


def test_least_effort_of_the_seed() -> None:
    found = solve(example("seed_rest_to_rest"))
    assert found.ok
    assert found.cost == pytest.approx(86.321433, abs=2e-6)
    assert found.errors.closure < 1e-9
    assert found.errors.nodal_closure < 1e-9
    assert found.errors.drift < 1e-8
    played = replay(found)
    assert played.end_error < 1e-6 and played.integration < 1e-8 and played.closure < 1e-9


@pytest.mark.slow
def test_least_effort_obeys_inverse_dynamics_and_the_power_balance() -> None:
    """Independent of the optimiser's equations: the model's inverse dynamics and energy along the motion."""
    found = solve(seed(transcription=COARSE))
    model = derive(found.problem.mechanism, found.problem.effects)
    at = found.sample(count=101)
    (least,), status = model("inverse_dynamics", at.q, at.v, at.a)
    assert (status == 0).all()
    assert at.u == pytest.approx(least, abs=2e-3)  # least squares is what effort asks for where no bound acts
    t, each = power(found)
    end = found.sample(np.array([0.0, found.duration]))
    (energy,), _ = model("energy", end.q, end.v)
    assert np.trapezoid(each.sum(axis=1), t) == pytest.approx(float(np.diff(energy.sum(axis=1))[0]), abs=1e-5)


@pytest.mark.slow
def test_halving_the_mesh_changes_less_than_the_reported_error() -> None:
    costs = [solve(seed(transcription=Transcription("radau", 3, n))) for n in (10, 20)]
    assert abs(costs[0].cost - costs[1].cost) < costs[0].errors.cost
    costs = [solve(seed(**MINIMUM_TIME, transcription=Transcription("radau", 3, n))) for n in (12, 24)]
    assert abs(costs[0].cost - costs[1].cost) < costs[0].errors.cost


@pytest.mark.slow
def test_transcriptions_agree() -> None:
    known = 86.321433  # of the example above, whose mesh is refined
    for other in (
        Transcription("gauss", 3, 12),
        Transcription("gauss", 3, 12, second_order=False),
        Transcription("radau", 3, 12, formulation="forward"),
    ):
        found = solve(seed(transcription=other))
        assert found.ok and found.cost == pytest.approx(known, abs=1e-5)
    shot = [solve(seed(transcription=Transcription("shooting", 1, n))).cost - known for n in (5, 10)]
    assert 3.5 < shot[0] / shot[1] < 4.5  # constant drives: an error of second order


@pytest.mark.parametrize("preload", [slow(0.0), 20.0])
def test_least_time_of_the_seed(preload: float) -> None:
    """Drives stand on the bound that their switching function asks for, except in the interval of a switching."""
    rule = {"drive_rule": "least_squares", "preload": dict.fromkeys(SEED_DRIVES, preload)} if preload else {}
    found = solve(seed(**MINIMUM_TIME, transcription=COARSE, **rule))
    assert found.ok
    assert found.duration == pytest.approx(0.2516 if preload else 0.2011, abs=2e-4)
    slope, u = switching(found, found.costates), found.drives_at_points
    assert np.abs(found.sample().u).max() < 60 * (1 + 1e-6)  # between the points as well
    if preload:
        middle = (u.max(axis=1) + u.min(axis=1)) / 2
        assert np.abs(u).max() > 59.9 and middle == pytest.approx(preload, abs=12)
        return
    clear = np.abs(slope) > 0.02 * np.abs(slope).max()
    by_interval = slope.reshape(-1, COARSE.degree, 4)
    same = (np.sign(by_interval).min(axis=1) == np.sign(by_interval).max(axis=1)).repeat(COARSE.degree, axis=0)
    chosen = clear & same
    assert chosen.sum() > 100
    assert np.abs(u + 60 * np.sign(slope))[chosen].max() < 0.1
    assert replay(found).end_error < 1e-6


@pytest.mark.slow
def test_objectives_are_what_they_say() -> None:
    """Every objective is best at its own, evaluated from samples and not by the optimiser."""
    mesh = Transcription("radau", 3, 12)
    types = {
        "effort": Objective("effort"),
        "energy": Objective("energy"),
        "peak": Objective("peak"),
        "electrical": Objective("electrical", weights=dict.fromkeys(SEED_DRIVES, 0.05)),
    }
    found = {name: solve(seed(transcription=mesh, objectives=(o,))) for name, o in types.items()}

    def values(run: Trajectory) -> dict[str, float]:
        t, each = power(run)
        u = run.blocks(t / run.duration)["u"]
        return {
            "effort": float(np.trapezoid((u**2).sum(axis=1), t)),
            "energy": float(np.trapezoid(np.maximum(each, 0).sum(axis=1), t)),
            "electrical": float(np.trapezoid((0.05 * u**2 + each).sum(axis=1), t)),
            "peak": float(np.abs(u).max()),
        }

    seen = {name: values(run) for name, run in found.items()}
    for name, best in found.items():
        assert best.ok
        assert seen[name][name] == pytest.approx(best.cost, rel=0.06 if name == "energy" else 1e-3)
        # effort and electrical losses differ by the net work, which is the same for all: equal optima
        assert all(seen[name][name] < other[name] * (1 + 1e-3) for other in seen.values())
    assert seen["peak"]["peak"] < 0.8 * seen["effort"]["peak"]
    assert seen["energy"]["energy"] < 0.9 * seen["effort"]["energy"]


def test_expressions_of_a_user() -> None:
    motion = rest_to_rest({"A": 0.1}, {"A": 1.1})
    usual = TrajectoryProblem(catalogue.load("four_bar"), **motion, transcription=COARSE, accuracy=None)
    own = solve(replace(usual, objectives=(Objective("expression", expression="3*u_A^2 - 2*u_A^2"),)))
    assert own.ok and own.cost == pytest.approx(solve(usual).cost, rel=1e-9)


@pytest.mark.slow
def test_periodic_scan() -> None:
    found = solve(example("seed_periodic_scan"))
    assert found.ok and found.cost == pytest.approx(618.179, abs=0.01)
    ends = found.blocks(np.array([0.0, 1.0]))
    assert ends["y"][0] == pytest.approx(ends["y"][1], abs=1e-9)
    assert ends["y_1"][0] == pytest.approx(ends["y_1"][1], abs=1e-8)
    passed = found.blocks(np.array([0.125, 0.375, 0.625, 0.875]))["y"]
    assert passed == pytest.approx(np.array([[0.08, 0], [0, 0.08], [-0.08, 0], [0, -0.08]]), abs=1e-9)


@pytest.mark.slow
def test_friction_and_spindles_cost_effort() -> None:
    found = solve(example("seed_friction_and_spindles"))
    assert found.ok and replay(found).end_error < 1e-6
    bare = seed()
    turn = 0.005 / (2 * np.pi)
    assert found.cost > solve(bare).cost * turn**2  # the same motion without friction, behind lossless spindles


@pytest.mark.slow
def test_a_margin_keeps_the_motion_away_from_a_singularity() -> None:
    problem = example("seed_away_from_singularity")
    kept = solve(problem)
    free = solve(replace(problem, bounds=replace(problem.bounds, margins={})))
    nearest = [run.margins(run.sample())["platform"].min() for run in (kept, free)]
    assert nearest[0] > 0.142 - 1e-6 and nearest[1] < 0.137
    assert kept.cost > free.cost


def load_example(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.slow
def test_leg_springs_make_the_scan_nearly_free() -> None:
    bare, best = load_example("seed_leg_springs").main()
    stiffness = best.parameters["k_leg"]
    assert stiffness == pytest.approx(160.97, abs=0.05)
    assert best.cost < 1e-5 * bare.cost
    problem = load_example("seed_leg_springs").problem()
    beside = solve(replace(problem, design={}, parameters={"k_leg": 1.02 * stiffness}))
    assert beside.cost > 100 * best.cost


@pytest.mark.slow
def test_geometry_for_least_effort() -> None:
    """The design found, put into the description itself, costs the same; designs beside it cost more."""
    found = solve(example("seed_geometry"))
    assert found.ok and found.cost == pytest.approx(575.9516, abs=1e-3)
    assert found.parameters["R"] == pytest.approx(0.9, abs=1e-6)  # on its bound
    assert found.parameters["r"] == pytest.approx(0.6447, abs=1e-4)
    scan = example("seed_periodic_scan")

    def cost(r: float) -> float:
        known = dict(scan.mechanism.parameters)
        for name, value in (("R", found.parameters["R"]), ("r", r)):
            known[name] = replace(known[name], value=sympy.Rational(value))
        return solve(replace(scan, mechanism=replace(scan.mechanism, parameters=known))).cost

    same, beside = (cost(found.parameters["r"] + shift) for shift in (0.0, -0.02))
    assert same == pytest.approx(found.cost, rel=1e-7) and beside > same + 0.1


def test_five_bar_pick_and_place() -> None:
    found = solve(example("five_bar_pick_and_place"))
    assert found.duration == pytest.approx(0.14919, abs=2e-5)
    at = found.of_tree("forward_kinematics", found.sample(np.array([0.0, found.duration])))
    assert at[:, [0, 2]] == pytest.approx(np.array([[-0.1, 0.55], [0.12, 0.5]]), abs=1e-8)
    assert replay(found).end_error < 1e-6


@pytest.mark.slow
def test_five_bar_passes_a_singularity_of_its_drives() -> None:
    found = solve(example("five_bar_through_singularity"))
    assert found.ok and found.refinements > 0 and found.errors.closure < 1e-9
    assert found.cost == pytest.approx(0.52394912, abs=2e-8)  # by Gauss 5 on 160 intervals 0.5239491210
    assert replay(found).end_error < 1e-6
    margin = found.margins(found.sample())["all drives"]
    assert margin[0] > 1 and margin[-1] < -1  # it changes sign: the drives alone cannot hold the tool between
    at = found.of_tree("forward_kinematics", found.sample(np.array([0.0, found.duration])))
    rise = np.sqrt(13) / 20
    assert at[:, 2] == pytest.approx([0.2 + rise, 0.2 - rise], abs=1e-8)
    assert np.abs(found.sample().u).max() < 10


@pytest.mark.slow
def test_delta_pick_and_place() -> None:
    found = solve(example("delta_pick_and_place"))
    assert found.ok and found.duration == pytest.approx(0.13639, abs=2e-5)
    assert found.errors.closure < 1e-9
    assert not found.model.equations.layout.z  # the platform does not turn: no unknown of the problem
    assert replay(found).end_error < 1e-6


def test_what_the_operation_mode_holds_is_no_unknown() -> None:
    """A delta's platform does not turn: the same motion and forces by fewer operations, and its loops stay closed."""
    mechanism = catalogue.load("delta")
    whole, alone = (PointEquations(mechanism, (Gravity(),), one_mode=one) for one in (False, True))
    held = [alone.system.tree.q[k].label for k in alone.constant]
    assert [label.rpartition("q")[2] for label in held] == list("wxyz") and not whole.constant
    assert len(whole.layout.z) == 4 and not alone.layout.z
    q, _, _ = whole.system.sample_states
    random = np.random.default_rng(1)
    known = dict(zip(("y_dot", "y_ddot", "u"), random.normal(size=(3, len(q), 3)), strict=True))
    known["y"] = q[:, list(whole.layout.y)]
    found: list[dict[str, np.ndarray]] = []
    for equations in (whole, alone):
        known["z"], values = q[:, list(equations.layout.z)], {}
        for program in (equations.closure, equations.motion, equations.dynamics):
            results, status = evaluate(program, [known[port.name] for port in program.inputs])
            assert (status == 0).all()
            values |= {port.name: result for port, result in zip(program.outputs, results, strict=True)}
        found.append(values)
    for name in ("q", "v", "a", "residual"):
        assert found[0][name] == pytest.approx(found[1][name], rel=1e-11, abs=1e-11)
    assert found[1]["implied"].shape == (len(q), 3) and np.abs(found[1]["implied"]).max() < 1e-13
    assert 2 * alone.dynamics.operations["total"] < whole.dynamics.operations["total"]
    turned = q.copy()
    turned[:, list(alone.constant)[1]] += 1e-5
    assert alone.off_mode(turned) and not alone.off_mode(q) and not whole.off_mode(turned)


@pytest.mark.slow
def test_other_operation_modes_have_all_unknowns() -> None:
    """Where a goal is not of the reference's mode the equations hold for all modes, and say what is out of reach."""
    problem = example("delta_pick_and_place")
    turned = replace(problem.end, coordinates={}, platform_rotation=(0.3, 0.0, 0.0))
    assert prepare(problem).model.equations.constant
    found = prepare(replace(problem, end=turned))
    assert not found.model.equations.constant and "the goal is out of reach" in found.guess.trouble


@pytest.mark.slow
def test_panda_point_to_point() -> None:
    found = solve(example("panda_point_to_point"))
    assert found.ok and found.duration == pytest.approx(0.191476, abs=5e-6)
    limits = np.array([87, 87, 87, 87, 12, 12, 12])
    assert (np.abs(found.sample().u) < limits * (1 + 1e-6)).all()
    assert replay(found).end_error < 1e-6
