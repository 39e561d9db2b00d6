"""Problems built once: other numbers give what `solve` gives from scratch, warm or cold, compiled or interpreted."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.marks import slow
from support.optimal_problems import cart_pole_problem, pendulum, rest_to_rest, seed

from symscrew.description import Mechanism, MechanismBuilder, load_description
from symscrew.errors import DescriptionError
from symscrew.optimisation import (
    Bounds,
    Conditions,
    Objective,
    OptimisationProblem,
    Solver,
    TrajectoryProblem,
    Transcription,
    compiled_points,
    prepare,
    solve,
    write_plan,
)
from symscrew.optimisation.built_problem import _Start
from symscrew.optimisation.plan_verdict import judged
from symscrew.optimisation.stage_steps import StageSolver
from symscrew.runtime import CompileError

MESH = Transcription("radau", 3, 8)
FIVE_BAR_DRIVES = ("base_left", "base_right")


def problem() -> TrajectoryProblem:
    """A swing of a cart-pole, with two objectives and a parameter."""
    return replace(
        cart_pole_problem(MESH),
        start=Conditions(coordinates={"slide": 0.0, "hinge": 0.2}, rates={"slide": 0.1, "hinge": 0.0}),
        end=Conditions(coordinates={"slide": 0.4, "hinge": -0.1}, at_rest=True),
        bounds=Bounds(drives={"slide": (-20.0, 20.0)}, joints={"slide": (-2.0, 2.0)}, speeds={"hinge": (-9.0, 9.0)}),
        objectives=(Objective("effort"), Objective("jerk", weight=1e-4)),
    )


@cache
def interpreted() -> OptimisationProblem:
    return without_compiler(problem())


def without_compiler(of: TrajectoryProblem) -> OptimisationProblem:
    """The problem, built where there is none."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled_points, "compile_c", _no_compiler)
        made = OptimisationProblem(of)
        assert not made.compiled(wait=60)
    return made


def _no_compiler(*_: object, **__: object) -> None:
    raise CompileError("no C compiler (cc); install one")


CHANGES = {
    "start": {"start": {"slide": 0.05}},
    "rates at the start": {
        "start": Conditions(coordinates={"slide": 0.0, "hinge": 0.1}, rates={"slide": -0.2, "hinge": 0.5})
    },
    "rest at the start": {"start": Conditions(coordinates={"slide": 0.0, "hinge": 0.1}, at_rest=True)},
    "goal": {"goal": {"slide": 0.3, "hinge": 0.0}},
    "less at the goal": {"goal": Conditions(coordinates={"slide": 0.3}, rates={"slide": 0.1})},
    "duration": {"duration": 1.7},
    "bounds": {
        "bounds": Bounds(drives={"slide": (-1.6, 1.6)}, joints={"slide": (-2.0, 2.0)}, speeds={"hinge": (-2.0, 0.9)})
    },
    "weights": {"weights": (1.0, 1e-2)},
}
HELD = ("start", "goal", "rest at the start")  # what other changes hold as well


@pytest.mark.parametrize("name", [slow(name) if name in HELD else name for name in CHANGES])
def test_other_numbers_give_what_a_new_problem_gives(name: str) -> None:
    changes, base = dict(CHANGES[name]), problem()
    made = interpreted()
    first, warm = made.solve(), made.solve(**changes, warm=made.solve())
    given = {"end" if key == "goal" else key: value for key, value in changes.items()}
    for end in ("start", "end"):
        if isinstance(given.get(end), dict):
            before = getattr(base, end)
            given[end] = replace(before, coordinates={**before.coordinates, **given[end]})
    if "weights" in given:
        weights = given.pop("weights")
        given["objectives"] = tuple(replace(o, weight=w) for o, w in zip(base.objectives, weights, strict=True))
    known = solve(replace(base, **given))
    assert known.ok and warm.solved and abs(first.cost - known.cost) > 1e-4 * known.cost  # the change matters
    assert warm.cost == pytest.approx(known.cost, rel=1e-6)
    assert np.abs(warm.arrays["y"] - known.arrays["y"]).max() < 1e-4
    assert warm.problem.duration == known.problem.duration and warm.errors.drift == pytest.approx(
        known.errors.drift, rel=1e-2
    )


def test_parameters_of_the_mechanism_are_numbers_too() -> None:
    base = replace(problem(), mechanism=_with_length(), parameters={"length": 0.5})
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled_points, "compile_c", _no_compiler)
        made = OptimisationProblem(base)
    first = made.solve()
    other = made.solve(parameters={"length": 0.55}, warm=first)
    known = solve(replace(base, parameters={"length": 0.55}))
    assert other.solved and known.ok and abs(known.cost - first.cost) > 1e-3 * known.cost
    assert other.cost == pytest.approx(known.cost, rel=1e-6)


def _with_length() -> Mechanism:
    """The cart-pole with the pole's length as a parameter."""
    made = MechanismBuilder("cart_pole")
    made.parameter("length", "0.5", unit="m", description="length of the pole")
    made.body("cart", mass="1", com=[0, 0, 0])
    made.body("pole", mass="0.3", com=[0, 0, "-length"])
    made.joint("slide", "P", parent="base", child="cart", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    made.joint("hinge", "R", parent="cart", child="pole", point=[0, 0, 0], axes=[[0, -1, 0]])
    return made.build()


def test_a_warm_start_takes_few_steps_to_full_accuracy() -> None:
    made = interpreted()
    warm = made.solve()
    near = made.solve(start={"slide": 0.003}, warm=warm)
    cold = made.solve(start={"slide": 0.003})
    assert near.solved and near.cost == pytest.approx(cold.cost, rel=1e-7)
    assert 1 <= near.statistics.iterations <= 3 < cold.statistics.iterations


def test_steps_by_stages_and_by_active_sets_find_the_same() -> None:
    made, found = interpreted(), []
    warm = made.solve()
    assert made._stages is None  # continuous second rates join three stages
    alone = _built(replace(problem(), objectives=(Objective("effort"),), bounds=problem().bounds))
    assert alone._stages is not None and alone._stages.states == (4,) * 9 and alone._stages.controls[-1] == 0
    warm = alone.solve()
    alone._compiled = True  # steps by stages come with the compiler; they take interpreted functions as well
    for stages in (alone._stages, None):
        alone._stages = stages
        found.append(alone.solve(start={"slide": 0.02}, warm=warm))
    assert [name for name, _ in alone._solvers] == ["ipopt", "stages", "active sets"]
    assert all(f.solved and f.statistics.iterations <= 4 for f in found)
    assert found[0].cost == pytest.approx(found[1].cost, rel=1e-9)
    assert np.abs(found[0].x - found[1].x).max() < 1e-6
    assert np.abs(found[0].multipliers - found[1].multipliers).max() < 1e-5
    free = _built(replace(problem(), duration=(1.0, 3.0), objectives=(Objective("time"), Objective("effort"))))
    assert free._stages is None  # the duration is everywhere


def _built(given: TrajectoryProblem) -> OptimisationProblem:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled_points, "compile_c", _no_compiler)
        return OptimisationProblem(given)


def test_a_shifted_start_is_the_motion_as_it_goes_on() -> None:
    made = interpreted()
    plan = made.solve()
    later = 0.1
    at = plan.sampled(np.array([later / plan.duration]))
    now = Conditions(
        coordinates=dict(zip(plan.labels, at.y[0].tolist(), strict=True)),
        rates=dict(zip(plan.labels, at.y_dot[0].tolist(), strict=True)),
    )
    rest = plan.duration - later
    steps = [made.solve(start=now, duration=rest, warm=plan, shift=shift).statistics.iterations for shift in (later, 0)]
    moved = made.solve(start=now, duration=rest, warm=plan, shift=later)
    assert moved.solved and steps[0] <= steps[1]
    assert moved.cost < plan.cost and np.abs(moved.arrays["y"][0] - at.y[0]).max() < 1e-9


@pytest.mark.parametrize(
    "accuracy, verdict, status",
    [(None, True, "optimal"), ((1.0, 1.0), True, "optimal"), ((5e-7, 1e-9), False, "not confirmed: its equations")],
)
def test_the_solvers_word_is_no_verdict(accuracy: tuple[float, float] | None, verdict: bool, status: str) -> None:
    """Cold as it is, warm and judged; the coarse mesh does not reach what is asked for in the last case."""
    made = interpreted()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(made, "problem", replace(made.problem, accuracy=accuracy))
        found = made.solve()
        seen = made.solve(start={"slide": 0.01}, warm=found, judge=True)
    assert found.solved and found.ok is None and found.status.startswith("not judged")
    assert seen.solved and seen.ok is verdict and seen.status.startswith(status)
    assert (seen.replayed is not None) == (verdict and accuracy is not None)
    if not verdict:
        assert judged(seen) is seen  # a refusal is not undone


@pytest.mark.slow
def test_a_plan_on_another_assembly_mode_is_solved_and_refused() -> None:
    """The end has the drives of the start and the tool below the elbows: at the points nothing is broken."""
    ends = {
        side: Conditions(coordinates=dict.fromkeys(FIVE_BAR_DRIVES, 0.0), at_rest=True, points=points)
        for side, points in (("start", {}), ("end", {"tool": (None, None, 0.2 - math.sqrt(13) / 20)}))
    }
    mechanism = load_description(Path(__file__).parents[1] / "data" / "short_five_bar.toml")
    mesh = Transcription(intervals=6)
    made = _built(TrajectoryProblem(mechanism, duration=0.6, **ends, independent=FIVE_BAR_DRIVES, transcription=mesh))
    found, seen = made.solve(), made.solve(judge=True)
    assert found.solved and found.ok is None
    assert seen.solved and seen.ok is False and seen.status.startswith("impossible: the plan leaves its assembly mode")


def test_what_the_solver_gives_up_is_not_solved_and_not_good(tmp_path: Path) -> None:
    made, weak = interpreted(), Bounds(drives={"slide": (-0.1, 0.1)}, joints={"slide": (-2.0, 2.0)})
    weak = replace(weak, speeds=problem().bounds.speeds)
    for judge in (False, True):
        found = made.solve(bounds=weak, judge=judge)
        assert found.ok is False and not found.solved and found.reasons and "not judged" not in found.status
    for plan, solved in ((made.solve(), True), (found, False)):
        with np.load(write_plan(plan, tmp_path / "plan.npz")) as file:  # no pickled None
            assert not file["ok"] and bool(file["solved"]) == solved


def test_what_changes_more_than_numbers_is_refused() -> None:
    made = interpreted()
    with pytest.raises(
        DescriptionError,
        match=r"platform_normal at the end: .* build another optimisation_problem",
    ):
        made.solve(goal=Conditions(coordinates={"slide": 1.0}, platform_normal=(0.0, 0.0, 1.0)))
    with pytest.raises(DescriptionError, match="duration: the problem was built with a fixed one"):
        made.solve(duration=(1.0, 2.0))
    with pytest.raises(DescriptionError, match=r"bounds\.joints"):
        made.solve(bounds=Bounds())
    with pytest.raises(DescriptionError, match="weights: expected 2"):
        made.solve(weights=(1.0,))
    with pytest.raises(DescriptionError, match="parameters: l became numbers"):
        made.solve(parameters={"l": 1.0})
    with pytest.raises(DescriptionError, match="contradicts its bounds"):
        made.solve(start={"slide": 3.0})


def test_numbers_that_are_none_are_refused() -> None:
    """One as a weight was called solved without a step: a comparison with it is never true."""
    made = interpreted()
    warm = made.solve()
    for given, said in (
        ({"weights": (math.nan, 1.0)}, r"objectives\[0\].weight: expected a finite number, got nan"),
        ({"goal": {"slide": math.inf}}, "end.coordinates.slide: expected a finite number"),
        ({"start": {"slide": math.nan}}, "start.coordinates.slide: expected a finite number"),
        ({"shift": math.nan}, "shift: expected a time from 0 to the 2 s of the warm motion, got nan"),
        ({"shift": -0.1}, "shift: expected a time from 0"),
        ({"shift": 2.0}, "shift: expected a time from 0"),
    ):
        with pytest.raises(DescriptionError, match=said):
            made.solve(**given, warm=warm)  # type: ignore[arg-type]


def test_steps_by_stages_do_not_take_a_number_that_is_none_for_small() -> None:
    alone = _built(replace(problem(), objectives=(Objective("effort"),)))
    assert alone._stages is not None
    warm = alone.solve()
    given, solver = alone._numbers(alone.problem), StageSolver(alone._stages, alone._program, tolerance=1e-8, steps=3)
    for lost in ("rows", "bounds", "x"):
        begin = _Start(warm.x, warm.multipliers, warm.bound_multipliers)
        alone._answer(solver, given, begin)
        assert solver.stats()["success"]
        alone._answer(solver, given, replace(begin, **{lost: np.full_like(getattr(begin, lost), np.nan)}))
        assert not solver.stats()["success"]


def test_a_warm_start_that_was_not_solved_does_no_harm(monkeypatch: pytest.MonkeyPatch) -> None:
    made = _built(replace(problem(), solver=Solver(iterations=15)))
    monkeypatch.setattr(made, "_ways", lambda begin: ("ipopt",) if begin.rows is None else ("ipopt, warm",))
    plan = made.solve()
    lost = made.solve(duration=1e-3, warm=plan)
    assert plan.solved and not lost.solved and made.solve(warm=lost).solved
    assert made.solve(warm=replace(plan, multipliers=np.full_like(plan.multipliers, np.nan))).solved


def test_compiled_functions_are_those_that_were_interpreted(monkeypatch: pytest.MonkeyPatch) -> None:
    made = OptimisationProblem(problem())
    assert made.compiled(wait=300) and not made.trouble
    assert made.solve().cost == pytest.approx(interpreted().solve().cost, rel=1e-9)
    calls = []
    monkeypatch.setattr("symscrew.runtime.compilers._compile", lambda *a: calls.append(a))
    again = OptimisationProblem(problem())
    assert again.compiled(wait=60) and not calls  # the cache had it


@pytest.mark.parametrize(("right", "wrong"), [("sin(x)", "1.01 * sin(x)"), ("=sin(", "=1.01*sin(")])
def test_compiled_functions_that_differ_are_not_used(monkeypatch: pytest.MonkeyPatch, right: str, wrong: str) -> None:
    """Those of four points at a time, and those of CasADi's printer."""
    printed, calls = compiled_points._printed, list[str]()

    def broken(*given: Any) -> tuple[str, Any]:
        code, names = printed(*given)
        calls.append(code)
        return code.replace(right, wrong), names

    monkeypatch.setattr(compiled_points, "_printed", broken)
    if right == "=sin(":
        monkeypatch.setattr(compiled_points, "printable", lambda function: False)
    made = OptimisationProblem(problem())
    assert not made.compiled(wait=300) and "differ from interpreted ones" in made.trouble
    assert right in calls[0]
    assert made.solve().solved


def test_without_a_compiler_the_interpreter_goes_on() -> None:
    assert "no C compiler" in interpreted().trouble and interpreted().solve().solved


@pytest.mark.slow
def test_the_seed_is_solved_again_within_three_steps() -> None:
    base = seed(transcription=Transcription("radau", 3, 20))
    made = without_compiler(base)  # compiled functions give the same, see above, and take a quarter of a minute to make
    first, prepared = made.solve(), prepare(base)
    for step in (1e-2, 1e-3):
        given = {label: value + step for label, value in base.start.coordinates.items()}
        found = made.solve(start=given, warm=first)
        known = solve(replace(base, start=replace(base.start, coordinates=given)), prepared=prepared)
        assert found.solved and found.statistics.iterations <= 3
        assert found.cost == pytest.approx(known.cost, rel=1e-8) and found.errors.closure < 1e-9


def test_warnings_are_counted_and_named_on_every_way(capsys: pytest.CaptureFixture[str]) -> None:
    """Cold by an interior-point method; from where a function is undefined by active sets, then by the former."""
    text = "sqrt(1.05 - q_hinge)"
    usual = {**rest_to_rest({"hinge": 0.0}, {"hinge": 1.0}), "accuracy": None, "duration": (0.1, 10)}
    built = without_compiler(TrajectoryProblem(
        pendulum(), **usual, bounds=Bounds(expressions={text: (0, 5)}), objectives=(Objective("time"),),
        transcription=Transcription(degree=2, intervals=4),
    ))  # fmt: skip
    first = built.solve()
    assert first.solved and first.statistics.undefined == {text: 1}
    far = built.solve(warm=replace(first, x=2 * first.x))
    assert far.statistics.undefined == {text: 2} and not capsys.readouterr().err


def test_coordinates_that_are_none_and_texts_are_named() -> None:
    made = interpreted()
    label = made.problem.end.coordinates and next(iter(made.problem.end.coordinates))
    with pytest.raises(DescriptionError, match=f"goal: this problem takes no coordinate '{label}s'; did you mean"):
        made.solve(goal={f"{label}s": 1.0})
    with pytest.raises(DescriptionError, match=rf"start\.{label}: expected a number \[rad, m\], got 'a'"):
        made.solve(start={label: "a"})  # type: ignore[dict-item]
