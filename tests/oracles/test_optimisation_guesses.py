"""Many guesses, and continuation: what is found how often, and optima of costs without curvature."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.optimal_problems import cart_pole_problem, rest_to_rest, slider

from symscrew.description import load_description
from symscrew.errors import DescriptionError
from symscrew.optimisation import solution, tie_breaking
from symscrew.optimisation.many_starts import Attempt, Search, random_guesses
from symscrew.optimisation.plan_verdict import judged
from symscrew.optimisation.problem import Bounds, Objective, TrajectoryProblem, Transcription
from symscrew.optimisation.result import Trajectory
from symscrew.optimisation.solution import attempts, prepare, solve, transcribe

pytestmark = pytest.mark.slow


def test_what_was_found_how_often() -> None:
    costs = [5.0, 3.0, 3.0 * (1 + 5e-5), float("nan"), 5.0, 9.0, 3.0]
    found = Search(tuple(Attempt(None, np.isfinite(c), c, "") for c in costs))
    assert found.optima == [(3.0, 3), (5.0, 2), (9.0, 1)]
    assert found.share == 3 / 7 and found.best is not None and found.best.cost == 3.0
    assert str(found) == "of 7 guesses: cost 3 by 3, 5 by 2, 9 by 1, no motion by 1"
    none = Search((Attempt(None, False, 1.0, ""),))
    assert none.best is None and none.share == 0.0 and str(none) == "of 1 guesses: cost no motion by 1"


def test_random_guesses_are_those_of_the_seed_and_keep_the_ends() -> None:
    problem = replace(cart_pole_problem(Transcription(intervals=4)), starts=4, seed=3)
    made = prepare(problem)
    first, again = (random_guesses(problem, made.model, made.guess) for _ in range(2))
    assert first == again and len(first) == 3
    other = random_guesses(replace(problem, seed=4), made.model, made.guess)
    assert other != first
    for values in first:
        assert values["slide"][0] == pytest.approx(0, abs=1e-12) and values["hinge"][-1] == pytest.approx(np.pi)
        assert np.ptp(values["hinge"]) > 0.5
    assert len({a.cost for a in attempts(replace(problem, starts=1, seed=1), [None, *first])}) > 1


def test_random_guesses_of_closed_loops_stay_within_reach() -> None:
    """A five-bar's elbows are at most two rods of 0.35 m apart at every time of every guess."""
    mechanism = load_description(Path(__file__).parents[1] / "data" / "short_five_bar.toml")
    motion = rest_to_rest({"base_left": 0.0, "base_right": 0.0}, {"base_left": 0.3, "base_right": 0.2})
    problem = TrajectoryProblem(mechanism, starts=6, **motion, independent=("base_left", "base_right"))
    made = prepare(problem)

    def elbow(side: int, angle: float) -> np.ndarray:
        """x and z: the crank (side 0.15, 0.2) about y, from its foot at side 0.15."""
        c, s = np.cos(angle), np.sin(angle)
        return np.array([side * 0.15 * (1 + c) + 0.2 * s, 0.2 * c - side * 0.15 * s])

    widest = 0.0
    for values in random_guesses(problem, made.model, made.guess):
        for left, right in zip(values["base_left"], values["base_right"], strict=True):
            assert np.linalg.norm(elbow(-1, left) - elbow(1, right)) <= 0.7
            widest = max(widest, abs(left))
    assert widest > 0.35  # beside the usual way


@pytest.mark.slow
def test_the_best_of_many_guesses_is_handed_out() -> None:
    problem = cart_pole_problem(Transcription("radau", 3, 20))
    alone = solve(problem)
    found = solve(replace(problem, starts=6))
    assert found.ok and found.search is not None and len(found.search.attempts) == 6
    assert found.search.attempts[0].cost == pytest.approx(alone.cost, rel=1e-6)
    assert found.cost == pytest.approx(found.search.optima[0][0], rel=1e-6) and found.cost <= alone.cost * (1 + 1e-9)
    assert str(found.search) in found.notes


def test_starts_and_seeds_that_mean_nothing_are_refused() -> None:
    problem = cart_pole_problem(Transcription(intervals=4))
    for settings, said in (({"starts": 0}, "at least one of starts"), ({"seed": 2}, "random guesses take starts")):
        with pytest.raises(DescriptionError, match=said):
            prepare(replace(problem, **settings))


# -- continuation ------------------------------------------------------------------------------------------------


def pushed(**settings: object) -> TrajectoryProblem:
    """1 kg over 1 m in 1 s with least energy from the drive: half of the largest speed squared, which is over 1."""
    usual = {"objectives": (Objective("energy"),), "bounds": Bounds(drives={"slide": (-20.0, 20.0)}), "accuracy": None,
             "transcription": Transcription(intervals=20)}  # fmt: skip
    return TrajectoryProblem(slider(), (), **rest_to_rest({"slide": 0.0}, {"slide": 1.0}), **{**usual, **settings})  # type: ignore[arg-type]


@pytest.mark.parametrize("alone", [True, False])
def test_effort_leads_to_the_cost_alone_or_stays_small(monkeypatch: pytest.MonkeyPatch, alone: bool) -> None:
    """Full force, coasting, full force: with speed v (1 - v / 20) = 1 the energy is v^2 / 2."""
    speed = 10 * (1 - np.sqrt(1 - 4 / 20))
    easy = solve(pushed())
    assert easy.ok and easy.cost == pytest.approx(speed**2 / 2, rel=2e-3)
    continued, posed = tie_breaking.continued, []

    def watched(trajectory: Trajectory, once: tie_breaking.Once) -> object:
        def counted(problem: TrajectoryProblem, near: Trajectory | None) -> Trajectory:
            posed.append(problem)
            found = once(problem, near)
            return replace(found, ok=found.ok and (alone or len(problem.objectives) > 1))

        return continued(trajectory, counted)

    monkeypatch.setattr(solution, "can_break_ties", lambda trajectory: True)
    monkeypatch.setattr(solution, "continued", watched)
    found = solve(pushed())
    assert found.ok and [len(p.objectives) for p in posed] == [2] * len(tie_breaking.PARTS) + [1]
    assert found.problem.objectives == easy.problem.objectives
    assert easy.cost * (1 - 1e-6) <= found.cost <= easy.cost * (1 + (1e-6 if alone else 1e-3))
    assert bool(found.notes) is not alone


def test_only_what_was_not_solved_is_continued() -> None:
    found = solve(pushed())
    assert not tie_breaking.can_break_ties(found)
    lost = replace(found, ok=False, status="not converged: the most iterations were used up")
    assert tie_breaking.can_break_ties(lost)
    assert not tie_breaking.can_break_ties(replace(lost, status="impossible: another branch"))
    effort = replace(lost, problem=replace(found.problem, objectives=(Objective("effort"),)))
    assert not tie_breaking.can_break_ties(effort)


def test_the_cost_without_effort_is_that_of_the_motion() -> None:
    found = solve(pushed())
    posed = tie_breaking.with_effort(found, 0.1)
    mixed = solve(posed)
    bare = tie_breaking.without_effort(mixed, found.problem, transcribe(found.model))
    at = mixed.sample(count=4_001)
    power = np.maximum(at.u[:, 0] * at.y_dot[:, 0], 0)
    assert bare.cost == pytest.approx(np.trapezoid(power, at.t), rel=0.1)  # power between the points is not its own
    assert bare.cost < mixed.cost and bare.cost > found.cost * (1 - 1e-6)
    assert "least effort breaks ties" in bare.notes[-1]


@pytest.mark.parametrize("part, much", [(1.0, True), (1e-2, True), (1e-3, False)])
def test_with_effort_is_called_optimal_as_far_as_it_is(part: float, much: bool) -> None:
    """With as much effort as cost it costs 2 % more than the best, which it was called."""
    problem = pushed()
    found = solve(problem)
    bare = judged(tie_breaking.without_effort(solve(tie_breaking.with_effort(found, part)), problem, found.transcribed))
    assert bare.ok is not much
    words = "not confirmed: least effort breaks ties" if much else "optimal with effort that breaks ties, 1.8e-04 of"
    assert bare.status.startswith(words) and "no better motion is near" not in bare.status
    assert (bare.cost > found.cost * 1.01) == (part == 1.0)
