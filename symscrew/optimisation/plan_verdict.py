"""The verdict on a plan: what the solver found is good only if it was followed, accurate enough, and replayed.

Trajectory, solved --branch, errors between the points, bounds between the points, replay--> `ok` and `status`
"""

from __future__ import annotations

import numpy as np

from symscrew.optimisation.explanation import STATUS
from symscrew.optimisation.followed_motion import replay
from symscrew.optimisation.mesh_errors import MOST_GROWTH
from symscrew.optimisation.result import Replay, Trajectory

# A replay may end off the plan by so many times the accuracy that the mesh was refined to: its defects are known to
# first order.
REPLAYED = 2.0
NOT_REPLAYED = (
    "not replayed: accelerations do not follow from forces without mass or quasi-statically; whether the drives hold "
    "the motion between the points was not looked at"
)
UNCURVED = "whether the cost bends upwards was not looked at: the pivots of its second derivatives do not tell"


def judged(trajectory: Trajectory) -> Trajectory:
    """The trajectory with the verdict of looks by other routes; one that failed or was refused already stays so."""
    if trajectory.ok is None and trajectory.solved:
        trajectory = trajectory.told(ok=True, status=STATUS["Solve_Succeeded"])
    if not trajectory.ok:
        return trajectory
    if trajectory.look is not None and not trajectory.look.curved:
        trajectory = trajectory.told(notes=(*trajectory.notes, UNCURVED))
    if trouble := trajectory.followed.trouble:
        return _refused(trajectory, "impossible", (trouble,))
    if downhill := _downhill(trajectory):
        return _refused(trajectory, "not confirmed", (downhill,))
    accuracy = trajectory.problem.accuracy
    if accuracy is None:
        return trajectory  # no accuracy was asked for
    missed = _missed(trajectory, accuracy)
    if not trajectory.model.equations.accelerates:
        trajectory = trajectory.told(notes=(*trajectory.notes, NOT_REPLAYED))
    elif not missed:
        played = replay(trajectory)
        trajectory = trajectory.told(replayed=played)
        missed = _off(trajectory, played, REPLAYED * accuracy[0])
    return _refused(trajectory, "not confirmed", missed) if missed else trajectory


def _refused(trajectory: Trajectory, word: str, reasons: tuple[str, ...]) -> Trajectory:
    return trajectory.told(ok=False, status=f"{word}: {reasons[0]}", reasons=(*reasons, *trajectory.notes))


def _downhill(trajectory: Trajectory) -> str:
    """Why what the solver found is no optimum, by its slopes and curvature; empty where they do not tell."""
    look = trajectory.look
    if look is None:
        return ""
    if not look.level:
        return f"the solver stopped on a slope of {look.slope:.1e} (scaled), an optimum has none: a wide tolerance?"
    if look.better is None:
        return ""
    return f"a motion near it costs {look.gain * trajectory.cost_scale:.2g} less, and none that is best was found there"


def _missed(trajectory: Trajectory, accuracy: tuple[float, float]) -> tuple[str, ...]:
    """What of the asked accuracy is not reached between the points."""
    errors, (dynamic, kinematic) = trajectory.errors, accuracy
    found = []
    if not errors.violation <= trajectory.problem.violation:
        worst = errors.violations
        what, near = worst.label or "a drive's bound", f"near {100 * worst.tau:.1f} % of the duration"
        size = f"{errors.violation:.2g} of its size"
        found.append(
            f"{what} is broken between the points by {size} {near}"
            if np.isfinite(errors.violation)
            else f"{what} is not settled between the points {near}: nothing bounds it there"
        )
    found += [what for what in (errors.unseen.forces, errors.unseen.costs) if what]
    if len(errors.unseen.cuts):
        near, long = f"near {100 * errors.unseen.where:.1f} % of the duration", errors.unseen.shortest
        found.append(
            f"what acts or counts there changes within {long * trajectory.duration:.2g} s {near}, which a mesh of "
            f"{len(trajectory.transcribed.mesh) - 1} intervals does not see"
        )
    total = float(errors.judged.sum())
    if not total <= dynamic:
        found.append(f"its equations are missed by {total:.1e} between the points, {dynamic:.1e} were asked for")
    if not errors.closure <= kinematic:
        found.append(f"its loops open by {errors.closure:.1e} between the points, {kinematic:.1e} were asked for")
    return tuple(found)


def _off(trajectory: Trajectory, played: Replay, allowed: float) -> tuple[str, ...]:
    """Why a replay does not confirm the plan."""
    apart, grows = float(played.local_errors.sum()), trajectory.errors.growth > MOST_GROWTH
    if played.end_error + played.integration <= allowed or (grows and apart <= allowed):
        return ()
    return (
        f"replayed by forward simulation it ends {played.end_error:.1e} off the plan (integration error "
        f"{played.integration:.1e}; intervals by themselves {apart:.1e} in all)",
    )
