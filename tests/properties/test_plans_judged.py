"""Verdicts on plans: on one assembly mode from the start, bounds held between the points, replayed."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from support.marks import slow
from support.optimal_problems import bead, cart_pole_problem, pendulum, rest_to_rest

from symscrew import catalogue
from symscrew.description import load_description
from symscrew.effects import EndStop, Gravity, QuasiStatic
from symscrew.errors import DescriptionError
from symscrew.optimisation import enclosed_functions, enclosures, mesh_errors, plan_verdict
from symscrew.optimisation.bounds_between import violations_of
from symscrew.optimisation.built_problem import optimisation_problem
from symscrew.optimisation.followed_branch import Branch
from symscrew.optimisation.followed_motion import replay
from symscrew.optimisation.joined_problem import JoinedProblem
from symscrew.optimisation.joined_solution import solve_joined
from symscrew.optimisation.problem import (
    Bounds,
    Conditions,
    Distance,
    Objective,
    Solver,
    TrajectoryProblem,
    Transcription,
)
from symscrew.optimisation.result import Trajectory
from symscrew.optimisation.solution import solve

SHORT_FIVE_BAR = load_description(Path(__file__).parents[1] / "data" / "short_five_bar.toml")
RISE = math.sqrt(13) / 20
BELOW = Conditions(
    coordinates={"base_left": 0.0, "base_right": 0.0}, points={"tool": (None, None, 0.2 - RISE)}, at_rest=True
)
HOME = Conditions(coordinates={"base_left": 0.0, "base_right": 0.0}, at_rest=True)


def five_bar(**settings) -> TrajectoryProblem:  # type: ignore[no-untyped-def]
    """The tool of the short five-bar from above its elbows to somewhere."""
    usual = {"duration": 0.6, "start": HOME, "transcription": Transcription(intervals=20), "accuracy": None}
    return TrajectoryProblem(SHORT_FIVE_BAR, **{**usual, **settings})


@pytest.fixture(scope="module")
def above() -> Trajectory:
    """A motion above the elbows, on 8 intervals."""
    end = Conditions(coordinates={"base_left": 0.3, "base_right": 0.2}, at_rest=True)
    return solve(five_bar(end=end, transcription=Transcription(intervals=8)))


def tool(found: Trajectory) -> np.ndarray:
    """Place of the tool at the end of a motion."""
    return found.of_tree("forward_kinematics", found.sample(np.array([0.0, found.duration])))[-1]


# -- the branch --------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_a_goal_on_another_branch_is_reached_through_a_passage() -> None:
    """With the drives as coordinates the end would be the start itself, its tool on the other branch."""
    found = solve(five_bar(end=BELOW, accuracy=(5e-7, 1e-9), transcription=Transcription(intervals=40)))
    assert found.ok and "through a passage" in found.notes[0] and found.followed.trouble == ""
    assert tool(found) == pytest.approx([0, 0, 0.2 - RISE], abs=1e-7)
    assert found.cost == pytest.approx(0.5239491210, abs=1e-7)  # by Gauss 5 on 160 intervals
    assert found.replayed is not None and replay(found).end_error < 1e-6


def test_a_goal_on_another_branch_is_refused_where_the_coordinates_are_given() -> None:
    found = solve(five_bar(end=BELOW, independent=("base_left", "base_right")))
    assert not found.ok and "the goal lies on another assembly mode" in found.status


def test_a_plan_on_one_branch_is_followed(above: Trajectory) -> None:
    """Boxes hold the configurations that Newton's method finds step by step from the start."""
    boxes = above.followed.boxes
    assert above.ok and above.followed.trouble == ""
    tau = boxes.pieces.tau(above.transcribed.mesh)
    q = above.kinematics.follow(above.blocks(tau)["y"], above.sample(np.array([0.0])).q[0])
    z = q[:, list(above.model.equations.layout.z)]
    assert np.abs(z - boxes.z).max() < 1e-9
    enclosed = above.branch.enclosed(boxes)
    for part in (-1.0, -0.4, 0.7, 1.0):
        y = above.branch.polynomials.at("y", boxes.pieces, part)
        z, found = above.branch.solved(y, boxes.z + part * boxes.pieces.radius[:, None] * boxes.slope)
        low, high = (np.array([getattr(e, n)[0] for e in enclosed]).T for n in ("low", "high"))
        assert found.all() and (low - 1e-12 <= z).all() and (z <= high + 1e-12).all()


def mirrored(found: Trajectory, points: slice, name: str = "z") -> Trajectory:
    """The plan with the tool on the other side of the elbows at some points."""
    z = np.array(found.arrays["z"])
    q = found.point_configurations
    flat = z.reshape(len(q), -1)
    for k in range(len(q))[points]:
        near = np.array(q[k])
        near[list(found.model.equations.layout.z)] += [1.08, -1.08]
        other = found.kinematics.assemble(q[k][list(found.model.equations.layout.y)], near)
        assert other is not None and np.abs(other - q[k]).max() > 0.5
        flat[k] = other[list(found.model.equations.layout.z)]
    return replace(found, arrays={**found.arrays, "z": z})


@pytest.mark.parametrize("points", [slice(10, 11), slice(-1, None), slice(0, 1)])
def test_a_jump_to_another_branch_is_seen(above: Trajectory, points: slice) -> None:
    bad = plan_verdict.judged(mirrored(above, points))
    assert not bad.ok and bad.status.startswith("impossible: the plan leaves its assembly mode")


def test_a_plan_on_another_mode_than_its_start_is_seen(above: Trajectory) -> None:
    bad = plan_verdict.judged(mirrored(above, slice(None)))
    assert not bad.ok and "starts on another assembly mode" in bad.status


# -- bounds between the points -----------------------------------------------------------------------------------


def around(radius: float, height: float, **settings) -> TrajectoryProblem:  # type: ignore[no-untyped-def]
    """A bead led past a post at 0.1 m, on the way at `height`."""
    usual = {"transcription": Transcription(intervals=50), "guess": {"x": (-1.0, 0.0, 1.0), "z": (height, 0.4, height)}}
    motion = rest_to_rest({"x": -1.0, "z": height}, {"x": 1.0, "z": height})
    bounds = Bounds(distances=(Distance("bead", "post", (radius, math.inf)),))
    return TrajectoryProblem(bead(), (), **{**motion, "bounds": bounds, **usual, **settings})


def nearest(found: Trajectory) -> float:
    """Least distance of bead and post, over samples."""
    at = found.sample(count=40_001)
    return float(np.hypot(at.y[:, 0], at.y[:, 1] - 0.1).min())


@pytest.mark.parametrize(
    "radius, height, intervals", [(0.3, 0.0, 10), slow(0.3, 0.0, 50), slow(0.02, 0.095, 50), slow(0.006, 0.1, 50)]
)
def test_posts_are_passed_at_their_radius(radius: float, height: float, intervals: int) -> None:
    """At the points of the default mesh alone a post of 6 mm was passed at 0.6 mm and one of 20 mm at 0.5 mm."""
    found = solve(around(radius, height, transcription=Transcription(intervals=intervals)))
    assert found.ok and found.errors.violation <= found.problem.violation
    assert radius * (1 - 1e-5) <= nearest(found) <= radius * (1 + 1e-3)


@pytest.mark.parametrize("intervals", [11, pytest.param(30, marks=pytest.mark.slow)])
def test_violations_are_no_less_than_samples_show_and_hardly_more(intervals: int) -> None:
    found = solve(around(0.11, 0.0, accuracy=None, transcription=Transcription(intervals=intervals)))
    seen = 1 - (nearest(found) / 0.11) ** 2
    assert seen > 1e-3 and seen - 1e-9 <= found.errors.violation <= 1.11 * seen
    assert found.errors.violations.label == "distance of bead and post"
    assert found.errors.violations.tau == pytest.approx(0.5, abs=0.05)


def test_a_bound_that_is_broken_between_the_points_is_no_optimum() -> None:
    problem = around(0.11, 0.0, accuracy=(math.inf, math.inf), transcription=Transcription(intervals=30))
    coarse = solve(replace(problem, accuracy=None))
    bad = plan_verdict.judged(replace(coarse, problem=problem))
    assert not bad.ok and "distance of bead and post is broken between the points" in bad.status


def test_quantities_of_closed_loops_are_bounded_between_the_points(above: Trajectory) -> None:
    """Every kind of bound on a closed chain, each just at what samples show: never less, and found where it is."""
    at = above.sample(count=4_001)
    place = above.of_tree("forward_kinematics", at)
    margins = above.margins(at)
    name, values = next(iter(margins.items()))
    speeds = above.of_tree("joint_rates", at)[:, above.model.joint_labels.index("elbow_left")]
    force = np.linalg.norm(above.reactions(at)[:, 24:27], axis=1)
    tip = list(above.problem.mechanism.joints)[4]
    cases = {
        "z of point tool": (
            Bounds(points={("tool", 2): (-math.inf, 0.0)}), place[:, 2].max() / above.model.system.length
        ),
        f"margin {name}": (Bounds(margins={name: (-math.inf, 0.0)}), values.max()),
        "speed of elbow_left": (
            Bounds(speeds={"elbow_left": (-math.inf, -9.0)}), (speeds.max() + 9.0) * above.model.scales.duration
        ),
        f"reaction force of {tip}": (Bounds(reactions={tip: (1.0, None)}), force.max() ** 2 - 1),
        "q_base_left*q_elbow_left": (
            Bounds(expressions={"q_base_left*q_elbow_left": (9.0, 10.0)}), 9 - (at.q[:, 0] * at.q[:, 2]).min()
        ),
    }  # fmt: skip
    for label, (bounds, seen) in cases.items():
        bounded = replace(above, problem=replace(above.problem, bounds=bounds))
        model = type(above.model)(bounded.problem, above.model.equations, above.model.scales)
        bounded = replace(bounded, transcribed=replace(above.transcribed, model=model))
        found = violations_of(bounded, Branch(bounded), above.followed, 1e-5)
        assert found.label == label and seen - 1e-7 <= found.largest <= 1.11 * seen, label


def test_effects_that_choose_are_bounded_between_the_points() -> None:
    """A stop that the crank meets on its way: a joint's load as samples show it."""
    stop = EndStop("A", upper="0.45", stiffness=30, exponent=2, damping="0.5")
    problem = TrajectoryProblem(
        catalogue.load("four_bar"), (stop,), duration=0.5, **rest_to_rest({"A": 0.1}, {"A": 0.6}),
        transcription=Transcription(intervals=6), accuracy=None,
    )  # fmt: skip
    found = solve(problem)
    assert found.ok
    at = found.sample(count=501)
    assert at.y[0, 0] < 0.45 < at.y[-1, 0]
    forces = found.reactions(at).reshape(len(at.t), -1, 6)[:, :, :3]
    seen = (np.linalg.norm(forces[:, list(problem.mechanism.joints).index("B")], axis=1).max() / 0.1) ** 2 - 1
    bounded = replace(found, problem=replace(problem, bounds=Bounds(reactions={"B": (0.1, None)})))
    model = type(found.model)(bounded.problem, found.model.equations, found.model.scales)
    bounded = replace(bounded, transcribed=replace(found.transcribed, model=model))
    bad = violations_of(bounded, Branch(bounded), found.followed, 1e-5)
    assert seen > 0 and seen * (1 - 1e-6) <= bad.largest <= 1.11 * seen


def test_what_nothing_bounds_is_not_settled(monkeypatch: pytest.MonkeyPatch) -> None:
    """An operation without an enclosure: no traceback and no optimum, but a sentence that names the quantity."""
    kept = {op: made for op, made in enclosures.ELEMENTARY.items() if op != ca.OP_EXP}
    monkeypatch.setattr(enclosed_functions, "ELEMENTARY", kept)
    problem = around(0.05, 0.0, transcription=Transcription(intervals=4))
    problem = replace(problem, bounds=Bounds(expressions={"exp(q_x)": (0.0, 99.0)}))
    found = solve(problem)
    assert not found.ok and "exp(q_x) is not settled between the points" in found.status and len(found.mesh) == 5


# -- replay ------------------------------------------------------------------------------------------------------


def test_a_plan_that_its_drives_do_not_follow_is_not_confirmed() -> None:
    found = solve(cart_pole_problem(Transcription("radau", 3, 20)))
    wanted = replace(found.problem, accuracy=(1.0, 1.0))
    assert plan_verdict.judged(replace(found, problem=wanted)).ok  # what is asked for is little
    weaker = {**found.arrays, "u": 0.9 * found.arrays["u"]}
    bad = plan_verdict.judged(replace(found, problem=replace(wanted, accuracy=(1e3, 1e3)), arrays=weaker))
    assert bad.ok
    bad = plan_verdict.judged(replace(found, problem=replace(wanted, accuracy=(0.01, 1.0)), arrays=weaker))
    assert not bad.ok and bad.status.startswith("not confirmed")


@pytest.mark.slow
def test_errors_that_grow_are_judged_where_they_arise() -> None:
    """A pole held upright for 3 s: what is off at first is off by e^(5.8 * 3) times as much at the end."""
    problem = cart_pole_problem(Transcription("radau", 3, 20))
    upright = rest_to_rest({"slide": 0.0, "hinge": math.pi}, {"slide": 0.5, "hinge": math.pi})
    found = solve(replace(problem, **upright, duration=3.0, accuracy=(5e-7, 1e-9)))
    # those that arise late grow less: in the mean e^(5.8 * 3) = 4e7 is a few thousand
    assert found.ok and found.errors.growth > 10 * mesh_errors.MOST_GROWTH and found.errors.drift > 5e-7
    assert found.errors.judged.sum() <= 5e-7 and len(found.mesh) < 200
    # What no mesh can help: how much of what grows 4e7 times there is to grow follows from the solver's last digits.
    assert replay(found).end_error > 20 * 5e-7
    assert replay(found).local_errors.sum() <= 1e-6


@pytest.mark.parametrize("built", [False, True], ids=["solve", "built"])
def test_a_solver_that_is_content_with_less_is_not_believed(built: bool) -> None:
    """Its own options say that 0.3 is near enough for constraints; nothing else was asked for."""
    lax = Solver(tolerance=0.3, options={"constr_viol_tol": 0.3, "dual_inf_tol": 1e9, "compl_inf_tol": 1e9})
    posed = cart_pole_problem(Transcription(intervals=8))
    posed = replace(posed, solver=lax)
    found = optimisation_problem(posed).solve(judge=True) if built else solve(posed)
    assert not found.ok and not found.solved
    assert found.status.startswith("not converged: the solver took it for solved by its own options, but ")
    assert "is missed at" in found.status
    assert solve(replace(posed, solver=Solver())).ok


@pytest.mark.parametrize("seed", range(3))
def test_errors_of_intervals_are_what_their_replays_miss(seed: int) -> None:
    """Of a pendulum on coarse meshes, whose residuals integrate to next to nothing without its stiffness."""
    random = np.random.default_rng(seed)
    goal, duration = float(random.uniform(0.5, 3.0)), float(random.uniform(0.5, 2.0))
    mesh = Transcription(intervals=int(random.integers(8, 14)))
    found = solve(
        TrajectoryProblem(
            pendulum(), duration=duration, **rest_to_rest({"hinge": 0.0}, {"hinge": goal}), transcription=mesh,
            accuracy=None,
        )
    )  # fmt: skip
    estimated, replayed = found.errors.local, replay(found).local_errors
    assert replayed.max() > 1e-8
    np.testing.assert_allclose(estimated, replayed, rtol=0.2, atol=0.02 * replayed.max())


@pytest.mark.parametrize("what", ["massless", "quasi-static"])
def test_what_cannot_be_replayed_is_called_so(what: str) -> None:
    """A KeyError came of the search for forward dynamics."""
    mechanism, effects = pendulum(), (Gravity(), QuasiStatic())
    if what == "massless":
        bodies = {name: replace(body, mass=None) for name, body in mechanism.bodies.items()}
        mechanism, effects = replace(mechanism, bodies=bodies), ()
    ends = rest_to_rest({"hinge": 0.0}, {"hinge": 1.0})
    problem = TrajectoryProblem(
        mechanism, effects, **ends, objectives=(Objective("jerk"),), transcription=Transcription(intervals=4)
    )
    found = solve(problem)
    assert found.ok and found.replayed is None and plan_verdict.NOT_REPLAYED in found.notes
    with pytest.raises(DescriptionError, match="accelerations do not follow"):
        replay(found)
    plan = solve_joined(JoinedProblem((problem, problem), (None,)))
    assert plan.ok and all(plan_verdict.NOT_REPLAYED in part.notes for part in plan.parts)


def test_plans_of_half_a_turn_an_interval_are_followed() -> None:
    """Between points a radian apart Newton's method does not get from one to the next: it is no singularity."""
    start, end = (Conditions(coordinates={"A": at}, at_rest=True) for at in (0.0, 4 * math.pi))
    problem = TrajectoryProblem(
        catalogue.load("four_bar"), duration=2.0, start=start, end=end,
        transcription=Transcription(intervals=4), accuracy=None,
    )  # fmt: skip
    assert solve(problem).followed.trouble == ""
