"""Thresholds of trajectory optimisation: what happens on either side, and what the results say of it."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import pytest
from support.optimal_problems import cart_pole_problem, pendulum, rest_to_rest, slider

from symscrew import catalogue
from symscrew.errors import DescriptionError
from symscrew.optimisation import (
    consistent_poses,
    cost_scale,
    explanation,
    followed_branch,
    followed_motion,
    guess,
    mesh_errors,
    refinement,
    shooting,
    solution,
)
from symscrew.optimisation import problem as words
from symscrew.optimisation.constraints import FORMULATIONS
from symscrew.optimisation.descents import descended
from symscrew.optimisation.followed_branch import Branch
from symscrew.optimisation.objectives import OBJECTIVE_TYPES
from symscrew.optimisation.obstacles import SHAPES
from symscrew.optimisation.problem import Bounds, Conditions, Objective, Solver, TrajectoryProblem, Transcription
from symscrew.optimisation.refinement import refinement_of
from symscrew.optimisation.result import Statistics, Trajectory
from symscrew.optimisation.solution import METHODS, prepare, solve
from symscrew.optimisation.tableau import HIGHEST_DEGREE, tableau

pytestmark = pytest.mark.slow


def swing(**settings: object) -> TrajectoryProblem:
    """A pendulum lifted by a radian with least effort, on four intervals."""
    usual = {
        **rest_to_rest({"hinge": 0.0}, {"hinge": 1.0}), "transcription": Transcription(degree=2, intervals=4),
        "accuracy": (1e-5, 1e-9),
    }  # fmt: skip
    return TrajectoryProblem(pendulum(), **{**usual, **settings})  # type: ignore[arg-type]


def crank(**settings: object) -> TrajectoryProblem:
    """The four-bar's crank turned by a radian with least effort."""
    usual = {**rest_to_rest({"A": 0.1}, {"A": 1.1}), "transcription": Transcription(intervals=4), "accuracy": None}
    return TrajectoryProblem(catalogue.load("four_bar"), **{**usual, **settings})  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def coarse() -> Trajectory:
    """The pendulum on its first mesh."""
    return solve(swing(accuracy=None))


@pytest.fixture(scope="module")
def in_one_interval() -> Trajectory:
    """The crank turned by more than two radians, on one interval."""
    mesh = Transcription(intervals=1, degree=5)
    return solve(crank(**rest_to_rest({"A": 0.1}, {"A": 2.5}), transcription=mesh))


def test_every_word_of_a_problem_has_its_entry() -> None:
    assert set(OBJECTIVE_TYPES) == set(words.OBJECTIVES)
    assert set(METHODS) == set(words.METHODS)
    assert set(FORMULATIONS) == set(words.FORMULATIONS)
    assert set(SHAPES) == set(words.SHAPE_TYPES)


def test_one_line_of_a_problem_and_of_a_trajectory(coarse: Trajectory) -> None:
    assert repr(swing()) == "<TrajectoryProblem trajectory: pendulum, 1 s, least effort>"
    assert repr(coarse).startswith("<Trajectory trajectory: 1 s, cost ") and coarse.status in repr(coarse)
    assert len(repr(coarse)) < 200


# -- refinement of the mesh ------------------------------------------------------------------------------------


def test_refinement_says_what_it_did_not_try(monkeypatch: pytest.MonkeyPatch) -> None:
    fine = solve(swing())
    assert fine.refinements >= 1 and fine.errors.drift <= 1e-5 and fine.notes == ()
    monkeypatch.setattr(solution, "MOST_REFINEMENTS", 0)
    stopped = solve(swing())
    assert stopped.refinements == 0 and stopped.errors.drift > 1e-5
    assert not stopped.ok and stopped.status.startswith("not confirmed: its equations are missed by 1.3e-02")
    assert "was not tried after 0 refinements" in stopped.notes[0] and stopped.notes[0] in stopped.reasons


def test_a_mesh_of_too_many_intervals_is_not_tried(monkeypatch: pytest.MonkeyPatch, coarse: Trajectory) -> None:
    mesh = refinement_of(coarse, (1e-5, 1e-9)).mesh
    assert mesh is not None and len(mesh) > 4
    monkeypatch.setattr(refinement, "MOST_INTERVALS", len(mesh) - 1)
    assert "are the most" in refinement_of(coarse, (1e-5, 1e-9)).reason
    found = solve(swing())
    assert found.refinements == 0 and f"{len(mesh)} intervals was not tried, {len(mesh) - 1} are" in found.notes[0]


def test_points_are_added_where_intervals_would_be_many(monkeypatch: pytest.MonkeyPatch, coarse: Trajectory) -> None:
    wanted = (1e-9, 1e-9)
    cut = refinement_of(coarse, wanted)
    assert cut.mesh is not None and len(cut.mesh) > len(coarse.mesh) - 1 and cut.degree == 0
    monkeypatch.setattr(refinement, "MANY", 4)
    more = refinement_of(coarse, wanted)
    degree = coarse.problem.transcription.degree
    assert more.mesh == tuple(coarse.transcribed.mesh[1:]) and more.degree == degree + 2
    found = solve(replace(swing(), accuracy=wanted))
    scheme = found.transcribed.scheme
    assert found.ok and scheme is not None and scheme.degree > degree + 2 and len(found.mesh) == len(coarse.mesh)
    monkeypatch.setattr(refinement, "MOST_DEGREE", degree)
    assert refinement_of(coarse, wanted) == cut


def test_trial_steps_that_are_undefined_print_nothing(capfd: pytest.CaptureFixture[str]) -> None:
    """A cost that is no number where the solver first goes: its line searches say nothing themselves."""
    problem = replace(swing(), objectives=(Objective("expression", expression="(1.5 - u_hinge)^0.5"),), accuracy=None)
    solve(replace(problem, solver=Solver(iterations=5)))
    assert "WARNING" not in "".join(capfd.readouterr())


def test_parts_and_margin_of_a_refinement(monkeypatch: pytest.MonkeyPatch, coarse: Trajectory) -> None:
    nearly = (0.9 * coarse.errors.drift, 1e-9)
    usual = len(refinement_of(coarse, nearly).mesh or ())
    monkeypatch.setattr(refinement, "MARGIN", 1e-2)
    assert len(refinement_of(coarse, nearly).mesh or ()) > usual
    assert len(refinement_of(coarse, (1e-12, 1e-9)).mesh or ()) == 4 * refinement.MOST_PARTS
    monkeypatch.setattr(refinement, "MOST_PARTS", 1)
    assert refinement_of(coarse, (1e-12, 1e-9)) == refinement.Refinement(
        None, "a finer mesh would not bring them nearer"
    )


def test_a_finer_mesh_that_fails_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    once = solution._once

    def failing(*given, **named):  # type: ignore[no-untyped-def]
        found = once(*given, **named)
        return found if named.get("warm") is None else replace(found, ok=False, status="not converged: on purpose")

    monkeypatch.setattr(solution, "_once", failing)
    found = solve(swing())
    assert not found.ok and found.refinements == 0  # an optimum of the coarse mesh alone
    assert found.notes[0].endswith("was given up: not converged: on purpose")


def test_the_safety_of_the_costs_error(monkeypatch: pytest.MonkeyPatch) -> None:
    found = solve(swing(accuracy=None, transcription=Transcription(intervals=4, second_order=False)))
    usual = found.errors.cost
    monkeypatch.setattr(mesh_errors, "SAFETY", 0.0)
    without = mesh_errors.errors_of(found, found.costates, found.branch, found.followed).cost
    monkeypatch.setattr(mesh_errors, "SAFETY", 1.0)
    once = mesh_errors.errors_of(found, found.costates, found.branch, found.followed).cost
    assert 0 < without < once < usual and usual - once == pytest.approx(once - without)


# -- replay ----------------------------------------------------------------------------------------------------


def test_halvings_of_a_replay(monkeypatch: pytest.MonkeyPatch, coarse: Trajectory) -> None:
    assert followed_motion.replay(coarse).integration < 1e-9
    monkeypatch.setattr(followed_motion, "MOST_HALVINGS", 2)
    monkeypatch.setattr(followed_motion, "STEPS", 1)
    assert 1e-9 < followed_motion.replay(coarse).integration < 1e-2
    monkeypatch.setattr(followed_motion, "MOST_HALVINGS", 1)
    assert followed_motion.replay(coarse).integration == np.inf  # one step size tells nothing


# -- guess and configurations ----------------------------------------------------------------------------------


def test_a_singular_start_is_not_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    assert prepare(crank()).guess.trouble == ""
    monkeypatch.setattr(guess, "SINGULAR", 10.0)
    found = solve(crank())
    assert not found.ok and found.status.startswith("not started: the start is singular")


def test_conditions_out_of_reach(monkeypatch: pytest.MonkeyPatch) -> None:
    assert prepare(crank()).guess.trouble == ""
    monkeypatch.setattr(consistent_poses, "REACHED", 0.0)
    assert "is out of reach" in prepare(crank()).guess.trouble


def test_too_few_damped_steps_do_not_reach(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(consistent_poses, "MOST_DAMPED_STEPS", 1)
    monkeypatch.setattr(consistent_poses, "STEPS_OF_A_STEP", 0)
    assert "is out of reach" in prepare(crank()).guess.trouble


@pytest.mark.parametrize("way", [99.0, 101.0, 600.0])
def test_what_is_far_is_not_out_of_reach(monkeypatch: pytest.MonkeyPatch, way: float) -> None:
    """A rail of more than 100 m, a crank that turns more than 15 times: steps of half a metre ended before it."""
    rail = TrajectoryProblem(slider(), (), **rest_to_rest({"slide": 0.0}, {"slide": way}))  # type: ignore[arg-type]
    turned = crank(end=Conditions(coordinates={"A": way}, at_rest=True))
    for problem in (rail, turned):
        assert prepare(problem).guess.trouble == ""
    monkeypatch.setattr(consistent_poses, "MOST_FAR_STEPS", 0)
    assert ("is out of reach" in prepare(rail).guess.trouble) == (way > 100)


def test_damping_only_changes_the_way(monkeypatch: pytest.MonkeyPatch) -> None:
    usual = prepare(crank()).guess.q[-1]
    monkeypatch.setattr(consistent_poses, "DAMPING", 1.0)
    assert np.abs(prepare(crank()).guess.q[-1] - usual).max() < 1e-9
    monkeypatch.setattr(consistent_poses, "MOST_DAMPING", 1e-20)  # given up with the first step that is no better
    monkeypatch.setattr(consistent_poses, "LARGEST_STEP", 1e3)
    far = prepare(crank(end=Conditions(coordinates={"A": 3.0}, at_rest=True)))
    assert np.isfinite(far.guess.q).all()


def test_configurations_one_by_one_are_those_found_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    made = prepare(crank())
    kinematics = consistent_poses.Kinematics(made.model, guess.default_parameters(made.model))
    y = made.guess.path(np.linspace(0, 1, 5))[0]
    near = np.repeat(made.guess.q[:1], 5, 0)
    q, found = kinematics.assemble_all(y, near)
    assert found.all()
    monkeypatch.setattr(consistent_poses, "MOST_COMMON_STEPS", 1)
    again, found = kinematics.assemble_all(y, near)
    assert found.all() and np.abs(again - q).max() < 1e-11
    monkeypatch.setattr(consistent_poses, "LARGEST_STEP", 0.05)  # shorter steps, the same place
    again, found = kinematics.assemble_all(y, near)
    assert found.all() and np.abs(again - q).max() < 1e-11
    monkeypatch.setattr(consistent_poses, "MOST_STEPS", 1)
    again, found = kinematics.assemble_all(y, near)
    assert not found[1:].any() and (again[1:] == near[1:]).all()  # what is not found stays as it is


def test_how_a_free_duration_is_guessed(monkeypatch: pytest.MonkeyPatch) -> None:
    free = swing(duration=(0.1, 1e9), bounds=Bounds(drives={"hinge": (-12.0, 12.0)}), objectives=(Objective("time"),))
    usual = prepare(free).guess.duration
    assert 0.1 < usual < 10
    monkeypatch.setattr(guess, "TRIALS", 2)
    assert prepare(free).guess.duration == pytest.approx(guess.LONGEST)  # only the ends of the range are looked at
    monkeypatch.setattr(guess, "LONGEST", 0.11)
    assert prepare(free).guess.duration <= 0.11  # too short for the drives: the solver has to lengthen it


def test_steps_along_the_guess(monkeypatch: pytest.MonkeyPatch) -> None:
    fine = prepare(crank()).guess
    monkeypatch.setattr(guess, "FINEST", 3)
    coarse = prepare(crank()).guess
    assert (len(fine.q), len(coarse.q)) == (61, 4)
    assert np.abs(fine.q[::20] - coarse.q).max() < 1e-10  # the same branch, as long as Newton's method finds it


# -- solver ----------------------------------------------------------------------------------------------------


def test_the_scale_of_a_small_cost_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    usual = solve(swing(accuracy=None))
    assert usual.cost_scale != 1.0
    monkeypatch.setattr(cost_scale, "LEAST_COST", 1e9)
    found = solve(swing(accuracy=None))
    assert found.cost_scale == 1.0 and found.cost == pytest.approx(usual.cost, rel=1e-7)


def test_what_is_named_where_no_motion_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    weak = swing(bounds=Bounds(drives={"hinge": (-1.0, 1.0)}), solver=Solver(iterations=30))
    usual = solve(weak).reasons
    assert any("missed at" in line for line in usual) and any("drive hinge stands on its bounds" in x for x in usual)
    monkeypatch.setattr(explanation, "SHOWN", 1)
    shown = solve(weak).reasons
    assert sum("missed at" in line for line in shown) == 1 <= sum("missed at" in line for line in usual)
    monkeypatch.setattr(explanation, "BROKEN", 1e9)
    monkeypatch.setattr(explanation, "PRESSED", -1e9)
    assert solve(weak).reasons == ()


def test_shooting_closes_its_loops_by_newton_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    shot = Transcription("shooting", 1, 8)
    good = solve(crank(transcription=shot))
    assert good.ok and good.errors.nodal_closure < 1e-7
    monkeypatch.setattr(shooting, "NEWTON", 0)  # every stage at the configuration of the interval's start
    bad = solve(crank(transcription=shot))
    assert abs(bad.cost - good.cost) > 1e-4 * good.cost


# -- what is refused -------------------------------------------------------------------------------------------


def test_degrees_and_intervals_have_an_end() -> None:
    assert tableau("gauss", HIGHEST_DEGREE).weights.sum() == pytest.approx(1, abs=3e-15)
    with pytest.raises(DescriptionError, match="expected a degree from 1 to 9, got 10"):
        tableau("gauss", HIGHEST_DEGREE + 1)
    assert Transcription(intervals=10_000).intervals == 10_000
    with pytest.raises(DescriptionError, match="expected 1 to 10000, got 10001"):
        Transcription(intervals=10_001)


def test_what_shooting_cannot_have_is_refused() -> None:
    sliding = TrajectoryProblem(slider(), effects=(), **rest_to_rest({"slide": 0.0}, {"slide": 1.0}))
    shot = replace(sliding, transcription=Transcription("shooting", 1, 4))
    assert solve(shot).ok
    for name, made in OBJECTIVE_TYPES.items():
        if not made.shooting:
            with pytest.raises(DescriptionError, match="shooting takes neither"):
                solve(replace(shot, objectives=(Objective(name),)))


def test_a_direction_is_told_from_its_opposite() -> None:
    """The sines of a rotation by half a turn are zero as those of none are; the cosine is not."""
    ends = [Conditions(platform_rotation=(0.0, turn, 0.0), at_rest=True) for turn in (0.0, 3.141592653589793)]
    angles = [solve(swing(end=end, start=Conditions(coordinates={"hinge": 0.3}))).sample().y[-1, 0] for end in ends]
    assert angles[0] == pytest.approx(0, abs=1e-6) and abs(angles[1]) == pytest.approx(np.pi, abs=1e-6)


def test_the_cart_pole_needs_no_refinement_where_none_is_asked_for() -> None:
    found = solve(replace(cart_pole_problem(Transcription(intervals=20)), accuracy=None))
    assert found.ok and found.notes == () and found.refinements == 0


# -- the branch ------------------------------------------------------------------------------------------------


def test_boxes_that_an_operator_keeps_are_there_below_one_only() -> None:
    """r = offset + excess r in closed form; at 1 and above, singular or negative, there is none."""
    excess = np.array(
        [[[0.5, 0.25], [0.0, 0.5]], [[1.0, 0.0], [0.0, 0.5]], [[0.2, 3.0], [3.0, 0.2]], [[np.inf, 0], [0, 0]]]
    )
    found = followed_branch._kept(excess, np.full((4, 2), 0.1))
    np.testing.assert_allclose(found[0], [0.3, 0.2], rtol=1e-14)
    assert np.isinf(found[1:]).any(axis=1).all()


@pytest.mark.parametrize(("name", "value"), [("FAR", 0.0), ("FAR", np.inf), ("BOXES", 2), ("BOXES", 8), ("WIDER", 2.0)])
def test_how_pieces_are_cut_changes_no_branch(
    name: str, value: float, in_one_interval: Trajectory, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan, usual = in_one_interval, in_one_interval.followed
    monkeypatch.setattr(followed_branch, name, value)
    other = Branch(plan).followed()
    assert usual.trouble == other.trouble == ""
    assert len(other.boxes.pieces) > 1 and len(usual.boxes.pieces) > 1  # one interval is more than one piece
    for found in (usual, other):
        assert np.isclose(found.boxes.pieces.radius.sum(), 1.0)  # all of the interval, once
        ends = found.boxes.z + found.boxes.slope * found.boxes.pieces.radius[:, None]
        starts = found.boxes.z - found.boxes.slope * found.boxes.pieces.radius[:, None]
        assert np.abs(ends[:-1] - starts[1:]).max() < 0.05  # [rad], by tangents: neighbours meet


def test_words_about_a_motion_change_no_look_at_it(coarse: Trajectory) -> None:
    looked = coarse.followed
    said = coarse.told(status="seen")
    assert (
        said.status == "seen" and coarse.status != "seen" and said.followed is looked and said.branch is coarse.branch
    )
    with pytest.raises(AssertionError):
        coarse.told(x=coarse.x)


@dataclass(frozen=True)
class Stopped:
    """What a solver found at a cost, with what it took; a better point is near until the last."""

    cost: float
    statistics: Statistics
    better: np.ndarray | None = field(default_factory=lambda: np.zeros(1))
    ok: bool = True

    def told(self, **words: Any) -> Stopped:
        return replace(self, **words)


@pytest.mark.parametrize("costs, best, took", [((3.0, 4.0), 5.0, 3), ((3.0, 2.0, 1.0, 0.5), 1.0, 4), ((6.0,), 5.0, 2)])
def test_what_was_tried_from_better_motions_counts(costs: tuple[float, ...], best: float, took: int) -> None:
    """Until it does not pay, at most three times; all iterations are told, of what was not better as well."""
    every = [Stopped(cost, Statistics(1, {}, {})) for cost in costs]
    left = iter(every)
    found = descended(Stopped(5.0, Statistics(1, {}, {})), lambda _: next(left), say=lambda _: None, until=np.inf)
    assert (found.cost, found.statistics.iterations) == (3.0 if costs == (3.0, 4.0) else best, took)
