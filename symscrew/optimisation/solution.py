"""From a problem to a trajectory: model, guess, transcription, solver, refinement.

problem --PointEquations--> programs --first_guess--> scales --Collocation--> families --assemble--> NLP --> Trajectory
"""

from __future__ import annotations

import math
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError, expect
from symscrew.optimisation.collocation import Collocation
from symscrew.optimisation.contradictions import check_inputs, check_problem
from symscrew.optimisation.cost_scale import cost_scale
from symscrew.optimisation.descents import descended
from symscrew.optimisation.explanation import broken_rows, pressing_bounds, status_of
from symscrew.optimisation.guess import Guess, first_guess, unit_scales
from symscrew.optimisation.interruption import interruptible
from symscrew.optimisation.many_starts import Attempt, Values, searched
from symscrew.optimisation.motion_equations import PointEquations
from symscrew.optimisation.optimality import looked_at
from symscrew.optimisation.parameter_values import check_effects, described
from symscrew.optimisation.passages import passages
from symscrew.optimisation.plan_verdict import judged
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import TrajectoryProblem
from symscrew.optimisation.refinement import refinement_of
from symscrew.optimisation.result import Statistics, Trajectory
from symscrew.optimisation.shooting import Shooting
from symscrew.optimisation.solver_warnings import SolverWarnings
from symscrew.optimisation.sparse import NonlinearProgram, assemble, cost_of
from symscrew.optimisation.tie_breaking import can_break_ties, continued, without_effort
from symscrew.optimisation.transcription import Discretisation, Transcribed
from symscrew.optimisation.warm_start import carried_multipliers, carried_unknowns

LEAST_TIME = 1e-3  # [s] where the time is used up already: IPOPT refuses 0, and ends before its first iteration
Progress = Callable[[str], None]
METHODS: Mapping[str, Callable[[PointModel], Discretisation]] = {
    "radau": Collocation,
    "gauss": Collocation,
    "shooting": Shooting,
}
# Meshes tried after the first one; a motion that still misses its accuracy is handed out as it is, and `errors` and
# `Trajectory.notes` say so.
MOST_REFINEMENTS = 12
# IPOPT from an earlier motion: of another problem, or of the same one on a coarser mesh. The barrier begins low (0.1 by
# default), so that the start is not pushed into the middle of its bounds; a refined mesh begins nearer still.
WARM: Mapping[str, Any] = {"warm_start_init_point": "yes", "mu_init": 1e-4}
REFINING: Mapping[str, Any] = {"warm_start_init_point": "yes", "mu_init": 1e-6} | dict.fromkeys(
    ("warm_start_bound_push", "warm_start_bound_frac", "warm_start_slack_bound_push", "warm_start_slack_bound_frac",
     "warm_start_mult_bound_push"), 1e-7
)  # fmt: skip
# No gradient of the Lagrangian by the parameters: nobody asks for it, and compiled points do not derive themselves. And
# no lines on the standard error where a trial step leaves what is defined, unless somebody counts them: solvers shorten
# it, and the status tells.
USUAL: Mapping[str, Any] = {"no_nlp_grad": True, "calc_lam_p": False, "show_eval_warnings": False}


@dataclass(frozen=True)
class Prepared:
    """A problem with its derived equations: what several transcriptions of it share."""

    problem: TrajectoryProblem
    model: PointModel
    guess: Guess


def prepare(problem: TrajectoryProblem) -> Prepared:
    """Derive the equations and make the first guess.

    Raises:
        DescriptionError: the problem names what does not exist, or contradicts itself.
    """
    check_problem(problem)
    mechanism = described(problem)
    elsewhere = any(
        conditions.mode for conditions in problem.conditions.values()
    )  # perhaps in no mode of the reference
    equations = PointEquations(mechanism, problem.effects, problem.independent, one_mode=not elsewhere)
    if not equations.constant:
        return _prepared(problem, equations)
    try:
        found = _prepared(problem, equations)
    except DescriptionError:
        found = None  # not for these conditions, or without regular equations
    if found is None or found.guess.parted or found.guess.trouble or equations.off_mode(found.guess.q):
        return _prepared(problem, PointEquations(mechanism, problem.effects, problem.independent))
    return found


def _prepared(problem: TrajectoryProblem, equations: PointEquations) -> Prepared:
    check_inputs(problem.inputs, {port.name: port.size for port, _ in equations.acting.own_inputs})
    check_effects(problem, equations.system.mechanism, equations.acting)
    sizes = (len(equations.layout.z), len(equations.system.drives), len(equations.acting.states))
    model = PointModel(problem, equations, unit_scales(len(equations.labels), *sizes))
    if not equations.labels:
        raise DescriptionError(f"{problem.mechanism.name} has no freedom that could move")
    guess = first_guess(model)
    return Prepared(problem, PointModel(problem, equations, guess.scales), guess)


def solve(
    problem: TrajectoryProblem,
    *,
    warm: Trajectory | None = None,
    prepared: Prepared | None = None,
    progress: Progress | None = None,
) -> Trajectory:
    """The optimal trajectory of a problem; look at `ok` and `status`.

    Args:
        problem: what to optimise.
        warm: an earlier trajectory to start from, of the same mechanism.
        prepared: equations derived earlier for the same mechanism, effects and coordinates.
        progress: called with a line of text per stage.

    Raises:
        DescriptionError: the problem cannot be used as it is given.
    """
    expect(problem, TrajectoryProblem)
    began, until = clock(), time.perf_counter() + problem.solver.time_limit
    say = progress or (lambda text: None)
    found = prepared or prepare(problem)
    search = None
    if problem.starts > 1 and warm is None:
        search = searched(problem, found.model, found.guess, attempts)
        say(str(search))
        best = search.best
        if best is not None and best.guess is not None:
            problem = replace(problem, guess=best.guess)
            found = prepare(problem)
    trajectory = None
    if found.guess.parted and warm is None:
        say("the way of the guess leads to another assembly mode than the goal's: looking for a passage")
        trajectory = _passed(found, say, until)
    if trajectory is None:
        trajectory = _accurate(found, problem, warm=warm, say=say, began=began, until=until)
        if trajectory.ok and trajectory.followed.trouble and not found.guess.parted:
            say(trajectory.followed.trouble)
            trajectory = _passed(found, say, until) or trajectory
    trajectory = judged(trajectory)
    if found.guess.parted and warm is None and not trajectory.ok:
        trajectory = _refused(trajectory)
    say(trajectory.status)
    spent = trajectory.statistics
    if search is not None:
        trajectory = trajectory.told(search=search, notes=(*trajectory.notes, str(search)))
        spent = replace(spent, undefined=dict((search.undefined + Counter(spent.undefined)).most_common()))
    return trajectory.told(statistics=spent.completed("errors and meshes", clock() - began))


def attempts(problem: TrajectoryProblem, guesses: Sequence[Values | None]) -> list[Attempt]:
    """What comes of guesses on the first mesh, with the equations derived once."""
    found: list[Attempt] = []
    usual = prepare(problem)
    for values in guesses:
        if values is None:
            made = solve(problem, prepared=usual)
        else:
            model = PointModel(replace(problem, guess=values), usual.model.equations, usual.guess.scales)
            guess = first_guess(model)
            made = solve(model.problem, prepared=Prepared(model.problem, model, guess))
        found.append(Attempt(values, bool(made.ok), made.cost, made.status, made.statistics.undefined))
    return found


def _accurate(
    found: Prepared,
    problem: TrajectoryProblem,
    *,
    warm: Trajectory | None,
    say: Progress,
    began: np.ndarray,
    until: float,
) -> Trajectory:
    """The optimum on a mesh that is fine enough, as far as it is found and stays on its branch."""
    model = PointModel(problem, found.model.equations, found.guess.scales)
    say(f"model: {model.d} independent coordinates {', '.join(model.equations.labels)}")
    trajectory = _once(model, found.guess, warm=warm, say=say, began=began, until=until)
    part = 0.0
    if warm is None and can_break_ties(trajectory) and time.perf_counter() < until:

        def once(posed: TrajectoryProblem, near: Trajectory | None) -> Trajectory:
            other = PointModel(posed, model.equations, model.scales)
            return _once(other, found.guess, warm=near, say=say, began=clock(), until=until)

        say("not solved as it is: effort is added, and taken away again")
        trajectory, part = continued(trajectory, once) or (trajectory, 0.0)
    if problem.accuracy and trajectory.ok and not trajectory.followed.trouble:
        trajectory = _refined(trajectory, found.guess, problem.accuracy, say, until=until)
    if part:
        mesh = replace(problem, transcription=trajectory.problem.transcription)
        trajectory = without_effort(trajectory, problem, transcribe(PointModel(mesh, model.equations, model.scales)))
    return trajectory


def _passed(found: Prepared, say: Progress, until: float) -> Trajectory | None:
    """The optimum by coordinates that stay regular on a way to the goal; None where there is none that is a motion."""
    for problem in passages(found.model, found.guess):
        other = prepare(problem)
        if other.guess.trouble or other.guess.parted:
            continue
        trajectory = _accurate(other, problem, warm=None, say=say, began=clock(), until=until)
        if trajectory.ok and not trajectory.followed.trouble:
            labels = ", ".join(problem.independent or ())
            return trajectory.told(notes=(*trajectory.notes, f"through a passage, by the coordinates {labels}"))
        say(f"no motion was found through the passage: {trajectory.followed.trouble or trajectory.status}")
    return None


def _refused(trajectory: Trajectory) -> Trajectory:
    """Why there is no motion to a goal on another branch."""
    reason = "the goal lies on another assembly mode than the start, and no motion through a passage was found"
    return trajectory.told(ok=False, status=f"{reason}; {trajectory.status}", reasons=(reason, *trajectory.reasons))


def _refined(
    trajectory: Trajectory, guess: Guess, accuracy: tuple[float, float], say: Progress, *, until: float
) -> Trajectory:
    """The motion on finer meshes until its errors are as wanted; its notes say why they are not."""
    for count in range(MOST_REFINEMENTS + 1):
        model, finer = trajectory.model, refinement_of(trajectory, accuracy)
        mesh, reason = finer.mesh, finer.reason
        if mesh is None:
            break
        if count == MOST_REFINEMENTS:
            reason = f"a finer mesh of {len(mesh)} intervals was not tried after {count} refinements"
            break
        what = f" of degree {finer.degree}" if finer.degree else ""
        say(f"refinement {count + 1}: {len(mesh)} intervals{what}, drift {trajectory.errors.drift:.1e} so far")
        before = model.problem.transcription
        transcription = replace(before, mesh=mesh, intervals=len(mesh), degree=finer.degree or before.degree)
        model = PointModel(replace(model.problem, transcription=transcription), model.equations, model.scales)
        again = _once(model, guess, warm=trajectory, say=say, began=clock(), until=until, start_options=REFINING)
        spent = trajectory.statistics + again.statistics
        if not again.ok:  # the coarser motion is an optimum still
            say(f"the finer mesh is given up: {again.status}")
            reason = f"a finer mesh of {len(mesh)} intervals was given up: {again.status}"
            trajectory = trajectory.told(statistics=spent)
            break
        if again.followed.trouble:
            reason = f"a finer mesh of {len(mesh)} intervals was given up: {again.followed.trouble}"
            trajectory = trajectory.told(statistics=spent)
            break
        trajectory = again.told(refinements=count + 1, statistics=spent)
    return (
        trajectory.told(notes=(f"the errors between the points are not as wanted: {reason}",)) if reason else trajectory
    )


def clock() -> np.ndarray:
    """Wall and processor time [s]."""
    return np.array([time.perf_counter(), time.process_time()])


def transcribe(model: PointModel) -> Transcribed:
    """The transcription that the problem asks for."""
    return METHODS[model.problem.transcription.method](model).transcribed()


def _once(
    model: PointModel,
    guess: Guess,
    *,
    warm: Trajectory | None,
    say: Progress,
    began: np.ndarray,
    until: float,
    start_options: Mapping[str, Any] = WARM,
) -> Trajectory:
    """The optimum on a mesh; where a better motion is near what the solver found, what it finds from there."""
    found = _solved(model, guess, warm=warm, say=say, began=began, until=until, start_options=start_options)

    def again(begin: np.ndarray) -> Trajectory:
        return _solved(model, guess, warm=None, say=say, began=clock(), until=until, begin=begin)

    return descended(found, again, say=say, until=until)


def _solved(
    model: PointModel,
    guess: Guess,
    *,
    warm: Trajectory | None,
    say: Progress,
    began: np.ndarray,
    until: float,
    start_options: Mapping[str, Any] = WARM,
    begin: np.ndarray | None = None,
) -> Trajectory:
    """What the solver makes of a guess, of an earlier motion `warm`, or of the scaled unknowns `begin`."""
    ready = clock()
    transcribed = transcribe(model)
    unknowns = transcribed.unknowns
    check_bounds(transcribed)
    arrays = (
        carried_unknowns(warm, transcribed) if warm else guess.arrays(model, transcribed.mesh, transcribed.point_tau)
    )
    arrays["u"] = control_points(transcribed, arrays["u"])
    start = np.clip(np.nan_to_num(unknowns.pack(arrays)), unknowns.lower, unknowns.upper)
    if guess.trouble and warm is None and begin is None:
        return _not_started(transcribed, start, guess.trouble)
    scale = cost_scale_of(transcribed, start)
    start = start if begin is None else begin
    program = assemble(transcribed.families, transcribed.linear, transcribed.cost, scale)
    say(f"program: {unknowns.size} unknowns, {len(program.labels)} constraints")
    limit = {} if until == np.inf else {"max_wall_time": max(until - time.perf_counter(), LEAST_TIME)}
    told = SolverWarnings(program.labels)
    solver = solver_of(model.problem, program, {**(start_options if warm else {}), **limit}, warn=told.heard)
    made = clock()
    extra = {}
    if warm is not None and (carried := carried_multipliers(warm, transcribed, scale)):
        extra = {"lam_g0": carried[0], "lam_x0": carried[1]}
    with interruptible(), told:
        answer = solver(x0=start, lbx=unknowns.lower, ubx=unknowns.upper, lbg=program.lower, ubg=program.upper, **extra)
    stats = solver.stats()
    done = clock()
    x = np.array(answer["x"]).ravel()
    word = stats.get("return_status", "")
    g = np.array(answer["g"]).ravel()
    pressure = np.array(answer["lam_x"]).ravel()
    broken = broken_rows(program, unknowns, x, g)
    ok = bool(stats["success"]) and not broken
    reasons = () if ok else (*broken, *pressing_bounds(unknowns, x, pressure))
    status = status_of(word, success=bool(stats["success"]), broken=broken)
    say(f"{status} after {int(stats.get('iter_count', 0))} iterations")
    spent = replace(statistics_of(stats, ready - began, made - ready, done - made), undefined=told.counts)
    rows = np.array(answer["lam_g"]).ravel()
    return Trajectory(
        model.problem, transcribed, unknowns.unpack(x), x, rows, pressure, float(answer["f"]) * scale, scale, ok,
        status, spent, reasons, solved=ok, look=looked_at(program, unknowns, (x, rows, pressure)) if ok else None,
    )  # fmt: skip


def control_points(transcribed: Transcribed, u: np.ndarray) -> np.ndarray:
    """Coefficients of the drives' polynomials from their values at the points (points, drives)."""
    if transcribed.scheme is None:
        return u
    n, k = transcribed.point_tau.shape
    inverse = np.linalg.inv(transcribed.scheme.control)
    return np.asarray(np.einsum("ij,njm->nim", inverse, u.reshape(n, k, -1)).reshape(n * k, -1))


def _not_started(transcribed: Transcribed, start: np.ndarray, trouble: str) -> Trajectory:
    """The guess as it is, where no solver can help."""
    zeros = np.zeros(sum(f.count * len(f.function.rows) for f in transcribed.families) + len(transcribed.linear.labels))
    return Trajectory(
        transcribed.model.problem, transcribed, transcribed.unknowns.unpack(start), start, zeros, np.zeros(len(start)),
        float("nan"), 1.0, False, f"not started: {trouble}", Statistics(0, {}, {}), (trouble,),
    )  # fmt: skip


def cost_scale_of(transcribed: Transcribed, start: np.ndarray) -> float:
    """A power of ten near the cost at the guess, or of motions of typical size."""
    return cost_scale(lambda x: float(transcribed.cost @ x) + sum(cost_of(f, x) for f in transcribed.families), start)


def check_bounds(transcribed: Transcribed) -> None:
    """Refuse bounds of an unknown that no value satisfies."""
    unknowns = transcribed.unknowns
    bad = np.flatnonzero(unknowns.lower > unknowns.upper)
    if len(bad):
        k = int(bad[0])
        raise DescriptionError(
            f"the bounds of {unknowns.labels[k]} at {unknowns.tau[k]:.3g} of the duration contradict each other: "
            f"lower {unknowns.lower[k] * unknowns.scale[k]:g}, upper {unknowns.upper[k] * unknowns.scale[k]:g}"
        )


def solver_of(
    problem: TrajectoryProblem, program: NonlinearProgram, start: Mapping[str, Any], *, warn: bool = False
) -> ca.Function:
    """The problem's solver of a program, with `start` among its options; `warn`: it says where functions fail."""
    given = problem.solver
    if not ca.has_nlpsol(given.name):
        raise DescriptionError(f"solver.name: this CasADi has no solver {given.name!r}; 'ipopt' comes with it")
    nlp = {"x": program.x, "p": program.p, "f": program.f, "g": program.g}
    options: dict[str, Any] = {"print_time": False, "error_on_fail": False, **USUAL, "show_eval_warnings": warn}
    if given.name == "ipopt":
        own: dict[str, Any] = {
            "print_level": 0, "sb": "yes", "tol": given.tolerance, "max_iter": given.iterations,
            "constr_viol_tol": min(1e-8, given.tolerance), "nlp_scaling_method": "none",
        }  # fmt: skip
        if math.isfinite(given.time_limit):
            own["max_wall_time"] = given.time_limit
        own |= start
        derivatives = {"grad_f": program.gradient, "jac_g": program.jacobian, "hess_lag": program.hessian}
        options |= {**derivatives, "ipopt": own | dict(given.options)}
    else:
        options |= dict(given.options)
        if given.name == "sqpmethod":
            options |= {"hess_lag": symmetric(program.hessian), "max_iter": given.iterations}
            options |= {"print_header": False, "print_iteration": False, "print_status": False}
    try:
        return ca.nlpsol("trajectory", given.name, nlp, options)
    except RuntimeError as error:
        reason = str(error).splitlines()[-1]
        raise DescriptionError(f"solver: {given.name} does not take these options: {reason}") from error


def symmetric(hessian: ca.Function) -> ca.Function:
    """The whole Hessian from its upper part."""
    inputs = hessian.mx_in()
    whole = ca.triu2symm(hessian(*inputs))
    return ca.Function(hessian.name(), inputs, [whole], hessian.name_in(), ["hess_gamma_x_x"])


def statistics_of(
    stats: Mapping[str, Any], model: np.ndarray, transcription: np.ndarray, solver: np.ndarray
) -> Statistics:
    """Iterations, and times of a solver's functions apart from the rest of it."""
    parts = []
    for k, kind in enumerate(("t_wall_nlp_", "t_proc_nlp_")):
        functions = sum(float(v) for name, v in stats.items() if name.startswith(kind))
        parts.append({
            "model and guess": float(model[k]), "transcription": float(transcription[k]), "functions": functions,
            "solver": float(solver[k]) - functions,
        })  # fmt: skip
    times, processor = parts
    return Statistics(int(stats.get("iter_count", 0)), times, processor)
