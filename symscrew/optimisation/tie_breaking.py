"""Continuation for objectives that many drives serve equally well: least effort breaks the ties, less and less of it.

    cost + epsilon (effort without units),  epsilon 1, 0.1, ... from one optimum to the next

Energy and electrical power are linear in a drive whose rate does not change sign: their programs have no curvature
there, and a solver wanders. With a little effort each has one optimum, which leads to that of the cost alone.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from symscrew.optimisation.problem import Objective, TrajectoryProblem
from symscrew.optimisation.result import Trajectory
from symscrew.optimisation.sparse import cost_of
from symscrew.optimisation.transcription import Transcribed

FLAT = ("energy", "electrical", "time", "peak", "expression")  # no curvature in a drive, or none that is sure
# Parts of the cost at the guess that effort has at first, and at last: below the solver's tolerance times the number of
# unknowns it would not be felt.
PARTS = (1.0, 1e-1, 1e-2, 1e-3, 1e-4)
# Share of the cost that effort may have where a motion is still called optimal: as the slopes of one that was found
# without it, a cost may fall by a thousandth. Slopes themselves say nothing: a drive that rests between bounds stands
# in a kink of such costs, where they are anything.
MOST_EFFORT = 1e-3
Once = Callable[[TrajectoryProblem, Trajectory | None], Trajectory]


def can_break_ties(trajectory: Trajectory) -> bool:
    """Whether effort may help a problem that was not solved."""
    kinds = {o.type for o in trajectory.problem.objectives}
    return (
        not trajectory.ok
        and bool(kinds & set(FLAT))
        and "effort" not in kinds
        and trajectory.status.startswith(("not converged", "nearly", "infeasible"))
    )


def with_effort(trajectory: Trajectory, part: float) -> TrajectoryProblem:
    """The problem with effort added: about `part` of the cost at the guess."""
    problem, scales = trajectory.problem, trajectory.model.scales
    labels = trajectory.drive_labels
    weights = {label: 1.0 / float(size**2) for label, size in zip(labels, scales.u, strict=True)}
    weight = part * trajectory.cost_scale / (max(len(labels), 1) * scales.duration)
    return replace(problem, objectives=(*problem.objectives, Objective("effort", weight, weights)))


def continued(trajectory: Trajectory, once: Once) -> tuple[Trajectory, float] | None:
    """The optimum with the least effort that can be solved, and its part: 0 where none is needed; None without any."""
    best: tuple[Trajectory, float] | None = None
    for part in PARTS:
        found = once(with_effort(trajectory, part), best[0] if best else None)
        if not found.ok:
            break
        best = found, part
    if best is None:
        return None
    alone = once(trajectory.problem, best[0])
    return (alone, 0.0) if alone.ok else best


def without_effort(found: Trajectory, problem: TrajectoryProblem, transcribed: Transcribed) -> Trajectory:
    """The motion as one of the problem without effort: the same unknowns, another cost.

    The looks at slopes and curvature were at the cost with effort; the status says so, and one with much is refused.
    """
    cost = float(transcribed.cost @ found.x) + sum(cost_of(family, found.x) for family in transcribed.families)
    mesh = found.problem.transcription
    share = float(found.cost - cost) / max(abs(cost), np.finfo(float).tiny)
    note = f"least effort breaks ties between motions: with {share:.1e} of the cost"
    made = replace(
        found, problem=replace(problem, transcription=mesh), transcribed=transcribed, cost=cost, look=None,
        notes=(*found.notes, note),
    )  # fmt: skip
    if not found.ok:
        return made
    if not share <= MOST_EFFORT:
        why = f"{note}, and with less none was found"
        return replace(made, ok=False, status=f"not confirmed: {why}", reasons=(why,))
    return replace(made, status=f"optimal with effort that breaks ties, {share:.1e} of the cost; not looked at without")
