"""From a joined problem to its plan: guesses in order, one program, meshes refined part by part, one verdict.

parts --guess of each from the end of the one before--> transcriptions --joined--> IPOPT --> trajectories --> JoinedPlan
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.optimisation.cost_scale import cost_scale
from symscrew.optimisation.descents import descended
from symscrew.optimisation.explanation import broken_rows, pressing_bounds, status_of
from symscrew.optimisation.interruption import interruptible
from symscrew.optimisation.joined_plan import JoinedPlan
from symscrew.optimisation.joined_problem import JoinedProblem
from symscrew.optimisation.joined_program import Joined, joined
from symscrew.optimisation.joined_replay import linked
from symscrew.optimisation.optimality import Look, looked_at
from symscrew.optimisation.plan_verdict import judged
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions, TrajectoryProblem
from symscrew.optimisation.refinement import refinement_of
from symscrew.optimisation.result import Statistics, Trajectory
from symscrew.optimisation.solution import (
    LEAST_TIME,
    MOST_REFINEMENTS,
    REFINING,
    Prepared,
    Progress,
    check_bounds,
    clock,
    control_points,
    prepare,
    solver_of,
    statistics_of,
    transcribe,
)
from symscrew.optimisation.solver_warnings import SolverWarnings
from symscrew.optimisation.sparse import assemble, cost_of
from symscrew.optimisation.transcription import Transcribed
from symscrew.optimisation.warm_start import carried_multipliers, carried_unknowns


@dataclass(frozen=True)
class _Found:
    """What the solver found: its answer cut into parts, and the rest of its multipliers."""

    parts: tuple[Trajectory, ...]
    x: np.ndarray
    multipliers: np.ndarray
    joined: Joined

    @property
    def cost(self) -> float:
        """Of all parts."""
        return sum(part.cost for part in self.parts)

    @property
    def ok(self) -> bool | None:
        """Whether the solver succeeded, which every part says alike."""
        return self.parts[0].ok

    @property
    def better(self) -> np.ndarray | None:
        """Scaled unknowns of better motions near these; None where none were found."""
        return self.parts[0].better

    @property
    def statistics(self) -> Statistics:
        """What the solver took, of all parts together."""
        return self.parts[0].statistics

    def told(self, **words: Any) -> _Found:
        """The same with other words about every part."""
        return replace(self, parts=tuple(part.told(**words) for part in self.parts))


def solve_joined(problem: JoinedProblem, *, progress: Progress | None = None) -> JoinedPlan:
    """The optimal motions of a joined problem; look at `ok` and `status`.

    Args:
        problem: phases or load cases.
        progress: called with a line of text per stage.

    Raises:
        DescriptionError: the problem cannot be used as it is given.
    """
    began, say = clock(), progress or (lambda text: None)
    until = time.perf_counter() + problem.parts[0].solver.time_limit
    prepared = _prepared(problem)
    models = [PointModel(part, p.model.equations, p.guess.scales)
              for part, p in zip(_posed(problem, prepared), prepared, strict=True)]  # fmt: skip
    trouble = next(((k, p.guess.trouble) for k, p in enumerate(prepared) if p.guess.trouble), None)
    found = _once(problem, models, prepared, None, say=say, until=until)
    if trouble is not None and not all(part.ok for part in found.parts):
        return _plan(problem, found, began, reasons=(f"{problem.called(trouble[0])}: {trouble[1]}",))
    found, count, notes = _refined(problem, found, prepared, say=say, until=until)
    plan = replace(_plan(problem, found, began), refinements=count, notes=notes)
    if plan.ok:
        plan = _judged(plan)
    say(plan.status)
    return replace(plan, statistics=plan.statistics.completed("the rest", clock() - began))


def _prepared(problem: JoinedProblem) -> list[Prepared]:
    """Equations and guesses, those of phases each from the end of the one before."""
    found: list[Prepared] = []
    for k, part in enumerate(problem.parts):
        if k and problem.links[k - 1] is not None:
            before = found[k - 1]
            labels = part.independent or before.model.equations.labels
            part = replace(part, start=_whole(before.model, before.guess.q[-1]), independent=labels)
        found.append(prepare(part))
    return found


def _whole(model: PointModel, q: np.ndarray) -> Conditions:
    """A configuration as conditions, so that no other assembly mode is meant."""
    return Conditions(coordinates={c.label: float(v) for c, v in zip(model.system.tree.q, q, strict=True)})


def _posed(problem: JoinedProblem, prepared: Sequence[Prepared]) -> list[TrajectoryProblem]:
    """The parts as they are solved: in the coordinates of their guesses."""
    return [replace(part, independent=made.problem.independent)
            for part, made in zip(problem.parts, prepared, strict=True)]  # fmt: skip


def _once(
    problem: JoinedProblem,
    models: Sequence[PointModel],
    prepared: Sequence[Prepared],
    warm: _Found | None,
    *,
    say: Progress,
    until: float,
) -> _Found:
    """One program, solved; on from a better motion where one is near what the solver found."""
    found = _solved(problem, models, prepared, warm, say=say, until=until)

    def again(begin: np.ndarray) -> _Found:
        return _solved(problem, models, prepared, None, say=say, until=until, begin=begin)

    return descended(found, again, say=say, until=until)


def _solved(
    problem: JoinedProblem,
    models: Sequence[PointModel],
    prepared: Sequence[Prepared],
    warm: _Found | None,
    *,
    say: Progress,
    until: float,
    begin: np.ndarray | None = None,
) -> _Found:
    """What the solver makes of the guesses, of earlier motions `warm`, or of the scaled unknowns `begin`."""
    ready = clock()
    parts = [transcribe(model) for model in models]
    for part in parts:
        check_bounds(part)
    one = joined(problem, parts)
    start = np.zeros(one.unknowns.size)
    for k, part in enumerate(parts):
        one.own(k, start)[:] = _start(part, prepared[k], warm.parts[k] if warm else None)
    rest = sum(part.unknowns.size for part in parts)
    start[rest:] = warm.x[-(len(start) - rest) :] if warm and len(start) > rest else _ends(one, prepared)
    start = np.clip(start, one.unknowns.lower, one.unknowns.upper)
    scale = _cost_scale(one, start)
    start = start if begin is None else begin
    program = assemble(one.families, one.linear, one.cost, scale)
    labels = _labels(problem, one, program.labels)
    program = replace(program, labels=labels)
    say(f"program: {one.unknowns.size} unknowns, {len(labels)} constraints")
    limit = {} if until == np.inf else {"max_wall_time": max(until - time.perf_counter(), LEAST_TIME)}
    told = SolverWarnings(labels)
    solver = solver_of(models[0].problem, program, {**(REFINING if warm else {}), **limit}, warn=told.heard)
    made, extra = clock(), {}
    if warm and (carried := _carried(warm, one, scale)):
        extra = {"lam_g0": carried[0], "lam_x0": carried[1]}
    with interruptible(), told:
        answer = solver(
            x0=start, lbx=one.unknowns.lower, ubx=one.unknowns.upper, lbg=program.lower, ubg=program.upper, **extra
        )
    stats = solver.stats()
    x, g, pressure, rows = (np.array(answer[name]).ravel() for name in ("x", "g", "lam_x", "lam_g"))
    broken = broken_rows(program, one.unknowns, x, g)
    ok = bool(stats["success"]) and not broken
    reasons = () if ok else (*broken, *pressing_bounds(one.unknowns, x, pressure))
    status = status_of(stats.get("return_status", ""), success=bool(stats["success"]), broken=broken)
    say(f"{status} after {int(stats.get('iter_count', 0))} iterations")
    spent = replace(statistics_of(stats, clock() * 0, made - ready, clock() - made), undefined=told.counts)
    if warm:
        spent = warm.parts[0].statistics + spent
    look = looked_at(program, one.unknowns, (x, rows, pressure)) if ok else None
    outcome = (ok, status, spent, reasons, look)
    cut = [_part(one, k, (x, rows, pressure), scale=scale, outcome=outcome) for k in range(len(parts))]
    return _Found(tuple(cut), x, rows, one)


def _part(
    one: Joined,
    k: int,
    answer: tuple[np.ndarray, np.ndarray, np.ndarray],
    *,
    scale: float,
    outcome: tuple[bool, str, Statistics, tuple[str, ...], Look | None],
) -> Trajectory:
    """What unknowns, multipliers of rows and of bounds say of part k."""
    (x, rows, pressure), part, (ok, status, spent, reasons, look) = answer, one.parts[k], outcome
    own = one.own(k, x)
    cost = float(part.cost @ own) + sum(cost_of(f, own) for f in part.families)
    return Trajectory(
        part.model.problem, part, part.unknowns.unpack(own), own, one.own_rows(k, rows), one.own(k, pressure), cost,
        scale, ok, status, spent, reasons, solved=ok, look=look,
    )  # fmt: skip


def _start(part: Transcribed, prepared: Prepared, warm: Trajectory | None) -> np.ndarray:
    arrays = carried_unknowns(warm, part) if warm else prepared.guess.arrays(prepared.model, part.mesh, part.point_tau)
    arrays["u"] = control_points(part, arrays["u"])
    return np.asarray(np.clip(np.nan_to_num(part.unknowns.pack(arrays)), part.unknowns.lower, part.unknowns.upper))


def _ends(one: Joined, prepared: Sequence[Prepared]) -> np.ndarray:
    """Unknowns of links at the guess: configurations at the ends of phases, no impulses."""
    rest = sum(part.unknowns.size for part in one.parts)
    x = np.zeros(one.unknowns.size)
    for name, at in one.unknowns.index.items():
        if name.startswith("link_") and name.endswith(":z"):
            k = int(name[len("link_") : -len(":z")])
            z = prepared[k].guess.q[-1][list(prepared[k].model.equations.layout.z)]
            x[at] = z / one.unknowns.scale[at]
    return x[rest:]


def _cost_scale(one: Joined, start: np.ndarray) -> float:
    """A power of ten near the cost at the guess, or of motions of typical size."""
    return cost_scale(lambda x: float(one.cost @ x) + sum(cost_of(f, x) for f in one.families), start)


def _carried(warm: _Found, one: Joined, scale: float) -> tuple[np.ndarray, np.ndarray] | None:
    """Multipliers of the parts on their finer meshes; those of links start at 0."""
    carried = [carried_multipliers(t, part, scale) for t, part in zip(warm.parts, one.parts, strict=True)]
    if any(pair is None for pair in carried):
        return None
    rows = one.with_rows([pair[0] for pair in carried if pair])
    bounds = np.concatenate([pair[1] for pair in carried if pair])
    return rows, np.concatenate([bounds, np.zeros(one.unknowns.size - len(bounds))])


def _labels(problem: JoinedProblem, one: Joined, labels: Sequence[str]) -> tuple[str, ...]:
    """Labels of all rows, with the part they belong to."""
    owner = np.full(len(labels), -1)
    places = np.arange(len(labels))
    for k in range(len(one.parts)):
        owner[one.own_rows(k, places).astype(int)] = k
    return tuple(t if k < 0 else f"{t} in {problem.called(int(k))}" for t, k in zip(labels, owner, strict=True))


def _refined(
    problem: JoinedProblem, found: _Found, prepared: Sequence[Prepared], *, say: Progress, until: float
) -> tuple[_Found, int, tuple[str, ...]]:
    """The motions on finer meshes until every part's errors are as wanted; notes say why they are not."""
    accuracy, count = problem.parts[0].accuracy, 0
    while accuracy is not None and all(p.ok and not p.followed.trouble for p in found.parts):
        finer = [refinement_of(part, accuracy) for part in found.parts]
        notes = tuple(f"{problem.called(k)}: the errors between the points are not as wanted: {f.reason}"
                      for k, f in enumerate(finer) if f.reason)  # fmt: skip
        if all(f.mesh is None for f in finer):
            return found, count, notes
        if count == MOST_REFINEMENTS:
            return found, count, (f"finer meshes were not tried after {count} refinements",)
        models = []
        for part, f in zip(found.parts, finer, strict=True):
            given = part.model.problem
            if f.mesh is not None:
                degree = f.degree or given.transcription.degree
                mesh = replace(given.transcription, mesh=f.mesh, intervals=len(f.mesh), degree=degree)
                given = replace(given, transcription=mesh)
            models.append(PointModel(given, part.model.equations, part.model.scales))
        sizes = ", ".join(str(len(m.problem.transcription.mesh) or m.problem.transcription.intervals) for m in models)
        say(f"refinement {count + 1}: {sizes} intervals")
        again = _once(problem, models, prepared, found, say=say, until=until)
        if not all(part.ok and not part.followed.trouble for part in again.parts):
            status = next(p.followed.trouble or p.status for p in again.parts if not p.ok or p.followed.trouble)
            return found, count, (f"finer meshes of {sizes} intervals were given up: {status}",)
        found, count = again, count + 1
    return found, count, ()


def _plan(problem: JoinedProblem, found: _Found, began: np.ndarray, reasons: tuple[str, ...] = ()) -> JoinedPlan:
    """The plan before its verdict."""
    first = found.parts[0]
    status = f"not started: {reasons[0]}" if reasons else first.status
    return JoinedPlan(
        problem, found.parts, found.cost, bool(first.ok) and not reasons, status,
        first.statistics, (*reasons, *first.reasons),
    )  # fmt: skip


def _judged(plan: JoinedPlan) -> JoinedPlan:
    """The plan with the verdicts on its parts, each from where the one before ends, and on its links."""
    parts: list[Trajectory] = []
    for k, part in enumerate(plan.parts):
        if k and plan.problem.links[k - 1] is not None:
            q = parts[k - 1].sampled(np.ones(1)).q[0]
            part = replace(part, problem=replace(part.problem, start=_whole(part.model, q)))
        parts.append(judged(part))
    plan = replace(plan, parts=tuple(parts))
    # what is impossible comes first: meshes of the others are not refined then, so that they lack accuracy too
    for k in sorted((k for k, part in enumerate(parts) if not part.ok), key=lambda k: not parts[k].followed.trouble):
        where, part = plan.problem.called(k), parts[k]
        reasons = (f"{where}: {part.status}", *(f"{where}: {r}" for r in part.reasons if r not in part.status))
        return replace(plan, ok=False, status=reasons[0], reasons=reasons)
    return linked(plan)
