"""A problem that is solved again and again with other numbers: built once, compiled, started from the last motion.

TrajectoryProblem --transcription with symbols for its numbers--> nonlinear program with parameters
    --point functions as C--> solvers;    solve(start, goal, ..., warm) --numbers, bounds--> Trajectory

A motion that starts near an optimum is found by sequential quadratic programming with exact second derivatives, stage
by stage where the program falls into stages: two or three steps, where an interior-point method on the whole would
first leave the bounds that the motion stands on. What that does not reach is left to IPOPT, as `solve` does it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from numbers import Real
from typing import Any

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError, did_you_mean, expect
from symscrew.optimisation.compiled_points import CompiledPoints
from symscrew.optimisation.contradictions import check_problem
from symscrew.optimisation.explanation import broken_rows, pressing_bounds, status_of
from symscrew.optimisation.optimality import looked_at
from symscrew.optimisation.parameter_values import check_effects, check_parameters
from symscrew.optimisation.plan_verdict import judged
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Bounds, Conditions, Range, TrajectoryProblem
from symscrew.optimisation.problem_numbers import ProblemNumbers
from symscrew.optimisation.problem_shape import other_shape
from symscrew.optimisation.result import Trajectory
from symscrew.optimisation.solution import (
    USUAL,
    WARM,
    Prepared,
    check_bounds,
    clock,
    control_points,
    cost_scale_of,
    prepare,
    solver_of,
    statistics_of,
    symmetric,
    transcribe,
)
from symscrew.optimisation.solver_warnings import SolverWarnings
from symscrew.optimisation.sparse import NonlinearProgram, assemble, point_functions, row_bounds
from symscrew.optimisation.stage_order import stages_of
from symscrew.optimisation.stage_steps import INACTIVE, StageSolver
from symscrew.optimisation.transcription import Transcribed, bound_by_problem, linear_cost
from symscrew.optimisation.unknowns import Unknowns
from symscrew.optimisation.warm_start import carried_multipliers, carried_unknowns, shifted

# Steps of a warm start: near an optimum two or three reach full accuracy. A motion that needs more has left it, and an
# interior-point method finds the way better.
MOST_STEPS = 15
# What compiled functions may differ by from the interpreted ones, relative to the largest entry: they are sums of up to
# 30 000 operations in another order.
AGREEING = 1e-9

# Changes of the active set in a step: near an optimum there are few. From far away a method that goes on to its own
# thousand takes seconds where an interior-point method takes a hundredth of one.
MOST_CHANGES = 100
STAGED = "stages"  # the first way to be tried
NOT_JUDGED = "not judged: the solver's constraints hold on its mesh, and nothing else was looked at"

Given = Conditions | Mapping[str, float]


@dataclass(frozen=True)
class _Numbers:
    """A problem's numbers as the solvers take them."""

    problem: TrajectoryProblem
    known: Unknowns
    lower: np.ndarray
    upper: np.ndarray
    parameters: np.ndarray
    values: np.ndarray


@dataclass(frozen=True)
class _Start:
    """Unknowns, multipliers of constraints and of bounds (None: not known)."""

    x: np.ndarray
    rows: np.ndarray | None = None
    bounds: np.ndarray | None = None


def optimisation_problem(problem: TrajectoryProblem, *, prepared: Prepared | None = None) -> OptimisationProblem:
    """A problem built once, to be solved often: see `OptimisationProblem`."""
    return OptimisationProblem(problem, prepared=prepared)


class OptimisationProblem:
    """A problem whose conditions at the ends, duration, bounds, weights and parameters change from solve to solve."""

    def __init__(self, problem: TrajectoryProblem, *, prepared: Prepared | None = None) -> None:
        """Derive, transcribe and start the compiler.

        Args:
            problem: its mesh is kept, and not refined: choose it by what `solve` found to be enough.
            prepared: equations derived earlier for the same mechanism, effects and coordinates.

        Raises:
            DescriptionError: the problem cannot be used as it is given.
        """
        expect(problem, TrajectoryProblem)
        if problem.transcription.method == "shooting":
            raise DescriptionError("transcription.method: an optimisation_problem takes collocation; got shooting")
        if problem.starts > 1:
            raise DescriptionError("problem.starts: an optimisation_problem starts from one motion; solve takes many")
        self.problem = problem
        found = prepared or prepare(problem)
        model = PointModel(problem, found.model.equations, found.guess.scales, ProblemNumbers())
        self._made: Transcribed = transcribe(model)
        check_bounds(self._made)
        arrays = found.guess.arrays(model.of(problem), self._made.mesh, self._made.point_tau)
        arrays["u"] = control_points(self._made, arrays["u"])
        unknowns = self._made.unknowns
        self._guess = np.clip(np.nan_to_num(unknowns.pack(arrays)), unknowns.lower, unknowns.upper)
        self._trouble = found.guess.trouble
        self._scale = cost_scale_of(self._made.settled(), self._guess)
        families = self._made.families
        self._points = CompiledPoints(
            {f.name: point_functions(f) for f in families}, {f.name: f.count for f in families}
        )
        self._compiled = False
        self._program = self._assembled()
        self._stages = stages_of(self._made, self._program)
        self._solvers: dict[tuple[str, bool], Any] = {}

    # -- compiled functions ---------------------------------------------------------------------------------------

    def compiled(self, *, wait: float = 0.0) -> bool:
        """Whether the functions are compiled C; waits for the compiler at most so many seconds.

        `trouble` says why they will not be.
        """
        if not self._compiled and self._points.ready(wait=wait) and not self.trouble:
            program = self._assembled()
            difference = self._difference(program)
            if difference > AGREEING:
                self._points.trouble = f"compiled functions differ from interpreted ones by {difference:.1e}"
                return False
            self._program, self._solvers, self._compiled = program, {}, True
        return self._compiled

    @property
    def trouble(self) -> str:
        """Why the functions stay interpreted, or nothing."""
        return self._points.trouble

    def _assembled(self) -> NonlinearProgram:
        made, functions = self._made, self._points.functions
        return assemble(
            made.families, made.linear, made.cost, self._scale, points=lambda family: functions[family.name]
        )

    def _difference(self, program: NonlinearProgram) -> float:
        """Of all derivatives at the guess, with multipliers that are all different."""
        p = self._numbers(self.problem).parameters
        multipliers = np.linspace(-1.0, 1.0, len(program.labels))

        def derivatives(of: NonlinearProgram) -> list[ca.DM]:
            slopes = [*of.gradient(self._guess, p), *of.jacobian(self._guess, p)]
            return [*slopes, of.hessian(self._guess, p, 1.0, multipliers)]

        worst = 0.0
        for ours, known in zip(derivatives(program), derivatives(self._program), strict=True):
            one, other = np.array(ours.nonzeros()), np.array(known.nonzeros())
            worst = max(worst, float(np.abs(one - other).max(initial=0.0) / np.abs(other).max(initial=1e-300)))
        return worst

    # -- solving --------------------------------------------------------------------------------------------------

    def solve(
        self,
        *,
        start: Given | None = None,
        goal: Given | None = None,
        duration: float | Range | None = None,
        bounds: Bounds | None = None,
        weights: Sequence[float] | None = None,
        parameters: Mapping[str, float] | None = None,
        inputs: Mapping[str, tuple[float, ...]] | None = None,
        warm: Trajectory | None = None,
        shift: float = 0.0,
        judge: bool = False,
    ) -> Trajectory:
        """The solver's trajectory with other numbers; look at `solved`, and at `ok` and `status` where it was judged.

        What is not given stays as in the problem. A motion as the solver leaves it may leave its assembly mode, break
        bounds between the points or differ from what its drives do: `ok` is None until it was judged, False where the
        solver failed.

        Args:
            start: conditions, or values of coordinates by label that replace those of the problem [rad, m].
            goal: the same at the end.
            duration: [s], fixed or a range as in the problem.
            bounds: of the same quantities.
            weights: of the objectives, in their order.
            parameters: of the mechanism, by name; those that are in the problem or made for run time.
            inputs: constant values of effects' inputs, by port.
            warm: the motion to start from, such as the last one.
            shift: time by which `warm` is over already [s], less than its duration; its end is held.
            judge: follow the branch and, where the problem has an `accuracy`, enclose what is between the points and
                replay, as `symscrew.optimisation.solve` does; it takes longer than a warm solve. The mesh is not
                refined: one that is too coarse for the accuracy is "not confirmed".

        Raises:
            DescriptionError: what is given changes the shape of the problem, or contradicts itself.
        """
        began = clock()
        given = self._numbers(
            self._changed(
                start=start, goal=goal, duration=duration, bounds=bounds, weights=weights, parameters=parameters,
                inputs=inputs,
            )
        )  # fmt: skip
        begin = self._start(warm, shift)
        self.compiled()
        ready, undefined = clock(), Counter[str]()
        ways = [(name, begin) for name in self._ways(begin)]
        if warm is not None and not warm.solved:
            ways.append(("ipopt", _Start(self._guess)))  # where a solver gave up is often no way on
        for name, begin in ways:
            told = SolverWarnings(self._program.labels)
            solver = self._solver(name, told.heard)
            with told:
                answer = self._answer(solver, given, begin)
            undefined.update(told.counts)
            stats = solver.stats()
            if stats["success"]:
                break
        found = self._trajectory(given, answer, stats, (began, ready, clock()))
        found = found.told(statistics=replace(found.statistics, undefined=dict(undefined.most_common())))
        return self._judged(found, given) if judge else found

    def _judged(self, found: Trajectory, given: _Numbers) -> Trajectory:
        """A motion with its verdict; slopes and curvature are those of the program with its numbers."""
        if found.solved:
            answered = (found.x, found.multipliers, found.bound_multipliers)
            program = replace(self._program, lower=given.lower, upper=given.upper)
            found = found.told(look=looked_at(program, given.known, answered, given.parameters))
        return judged(found)

    def _changed(
        self,
        *,
        start: Given | None,
        goal: Given | None,
        weights: Sequence[float] | None,
        parameters: Mapping[str, float] | None,
        **others: Any,
    ) -> TrajectoryProblem:
        """The problem with other numbers."""
        problem, labels = self.problem, self._made.model.equations.labels
        changed = {name: value for name, value in others.items() if value is not None}
        if start is not None:
            changed["start"] = _conditions(problem.start, start, "start", labels)
        if goal is not None:
            changed["end"] = _conditions(problem.end, goal, "goal", labels)
        if weights is not None:
            if len(weights) != len(problem.objectives):
                count = len(problem.objectives)
                raise DescriptionError(f"weights: expected {count}, one for each objective, got {len(weights)}")
            objectives = zip(problem.objectives, weights, strict=True)
            changed["objectives"] = tuple(replace(o, weight=float(weight)) for o, weight in objectives)
        if parameters is not None:
            changed["parameters"] = {**problem.parameters, **parameters}
        if not changed:
            return problem
        result = replace(problem, **changed)
        check_problem(result)
        system, acting = self._made.model.system, self._made.model.equations.acting
        difference = other_shape(problem, result, self._made.model)
        if difference:
            raise DescriptionError(f"{difference}; build another optimisation_problem for it")
        if parameters is not None:
            check_parameters(result, system.mechanism)
            check_effects(result, system.mechanism, acting)
        return result

    def _numbers(self, problem: TrajectoryProblem) -> _Numbers:
        made = self._made
        known = made.free.copy()
        bound_by_problem(known, made.model, problem)
        lower, upper = self._program.lower, self._program.upper
        if any(row.limits for family in made.families for row in family.function.rows):
            lower, upper = row_bounds(made.families, made.linear, problem)
        collected = made.model.numbers
        assert collected is not None
        values = collected.values(problem)
        cost = linear_cost(known, made.model, problem) if len(values) else np.zeros(0)
        if (known.lower > known.upper).any():
            check_bounds(replace(made, unknowns=known))
        return _Numbers(problem, known, lower, upper, np.concatenate([values, cost]), values)

    def _start(self, warm: Trajectory | None, shift: float) -> _Start:
        if warm is None:
            return _Start(self._guess)
        if not 0.0 <= shift < warm.duration:
            raise DescriptionError(
                f"shift: expected a time from 0 to the {warm.duration:g} s of the warm motion, got {shift:g}"
            )
        if not all(np.isfinite(part).all() for part in (warm.x, warm.multipliers, warm.bound_multipliers)):
            return _Start(self._guess)  # a solver left it where functions are not defined
        made = self._made
        if not np.array_equal(warm.transcribed.mesh, made.mesh) or len(warm.x) != len(self._guess):
            arrays = carried_unknowns(warm, made)
            arrays["u"] = control_points(made, arrays["u"])
            carried = carried_multipliers(warm, made, self._scale)
            rows, pressure = carried or (None, None)
            return _Start(np.nan_to_num(made.unknowns.pack(arrays)), rows, pressure)
        ratio = warm.cost_scale / self._scale
        x, rows = shifted(warm, shift) if shift else (warm.x, warm.multipliers)
        return _Start(x, ratio * rows, ratio * warm.bound_multipliers)

    def _answer(self, solver: Any, given: _Numbers, begin: _Start) -> Mapping[str, Any]:
        known = given.known
        extra: dict[str, Any] = {} if begin.rows is None else {"lam_g0": begin.rows, "lam_x0": begin.bounds}
        found: Mapping[str, Any] = solver(
            x0=np.clip(begin.x, known.lower, known.upper), lbx=known.lower, ubx=known.upper, lbg=given.lower,
            ubg=given.upper, p=given.parameters, **extra,
        )  # fmt: skip
        return found

    def _ways(self, begin: _Start) -> tuple[str, ...]:
        """The solvers to try in turn."""
        if begin.rows is None:
            return ("ipopt",)
        return (*((STAGED,) if self._stages and self._compiled else ()), "active sets", "ipopt, warm")

    def _solver(self, name: str, warn: bool) -> Any:
        """The solver of this name; `warn`: one that says where functions are undefined on its way."""
        if (name, warn) not in self._solvers:
            problem, program = self.problem, self._program
            made: StageSolver | ca.Function
            if name == STAGED and self._stages is not None:
                made = StageSolver(self._stages, program, tolerance=problem.solver.tolerance, steps=MOST_STEPS)
            elif name == "active sets":
                made = _by_active_sets(problem, program, warn=warn)
            else:
                made = solver_of(problem, program, WARM if "warm" in name else {}, warn=warn)
            self._solvers[name, warn] = made
        return self._solvers[name, warn]

    def _trajectory(
        self, given: _Numbers, answer: Mapping[str, Any], stats: Mapping[str, Any], times: Sequence[np.ndarray]
    ) -> Trajectory:
        x, g, pressure = (np.array(answer[name]).ravel() for name in ("x", "g", "lam_x"))
        program = replace(self._program, lower=given.lower, upper=given.upper)
        success, word = bool(stats["success"]), str(stats.get("return_status", ""))
        reasons = broken = broken_rows(program, given.known, x, g)
        solved = success and not broken
        if not solved:
            reasons = (*broken, *pressing_bounds(given.known, x, pressure))
        status = NOT_JUDGED if solved else status_of(word, success=success, broken=broken)
        if self._trouble and not solved:
            status, reasons = f"not solved: {self._trouble}", (self._trouble, *reasons)
        made = replace(self._made, unknowns=given.known, model=self._made.model.of(given.problem), numbers=given.values)
        began, ready, done = times
        return Trajectory(
            given.problem, made, given.known.unpack(x), x, np.array(answer["lam_g"]).ravel(), pressure,
            float(answer["f"]) * self._scale, self._scale, None if solved else False, status,
            statistics_of(stats, np.zeros(2), ready - began, done - ready), reasons, solved=solved,
        )  # fmt: skip


def _conditions(before: Conditions, given: Given, where: str, labels: Sequence[str]) -> Conditions:
    """Conditions with other values of coordinates, or others altogether; `labels` are the independent coordinates."""
    if isinstance(given, Conditions):
        return given
    known = dict.fromkeys((*before.coordinates, *labels))
    for label, value in given.items():
        if label not in known:
            raise DescriptionError(f"{where}: this problem takes no coordinate {label!r}; {did_you_mean(label, known)}")
        if isinstance(value, bool) or not isinstance(value, Real):
            raise DescriptionError(f"{where}.{label}: expected a number [rad, m], got {value!r}")
    return replace(before, coordinates={**before.coordinates, **given})


def _by_active_sets(problem: TrajectoryProblem, program: NonlinearProgram, *, warn: bool) -> ca.Function:
    """Steps by an active-set method on the whole, sparse."""
    x, p = program.x, program.p
    both = [*program.gradient(x, p), *program.jacobian(x, p)]
    first = ca.Function("nlp_jac_fg", [x, p], both, ["x", "p"], ["f", "grad_f_x", "g", "jac_g_x"])
    own = {"print_iter": False, "print_header": False, "print_info": False, "error_on_fail": False, "min_lam": INACTIVE}
    own |= {"max_iter": MOST_CHANGES}
    options: dict[str, Any] = {
        "max_iter": MOST_STEPS, "tol_pr": problem.solver.tolerance, "tol_du": problem.solver.tolerance, **USUAL,
        "print_header": False, "print_iteration": False, "print_status": False, "print_time": False,
        "error_on_fail": False, "show_eval_warnings": warn, "jac_fg": first, "hess_lag": symmetric(program.hessian),
        "qpsol": "qrqp", "qpsol_options": own,
    }  # fmt: skip
    nlp: dict[str, Any] = {"x": x, "p": p, "f": program.f, "g": program.g}
    return ca.nlpsol("warm", "sqpmethod", nlp, options)
