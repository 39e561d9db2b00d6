"""A finer mesh where the motion between the points does not obey its equations well enough.

errors of a trajectory --order of the scheme--> parts that every interval is cut in --> mesh
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symscrew.optimisation.result import Trajectory

# An interval is cut in at most so many parts at a time: the order of the scheme, on which their number rests, shows
# only once an interval is smooth. More: intervals next to a switching are cut in vain.
MOST_PARTS = 4
MARGIN = 0.5  # this part of the wanted error is aimed at, so that one refinement is mostly enough
# A finer mesh would do no more than take time and memory: the motion stays as it is, and `errors` say how good it is.
MOST_INTERVALS = 2000
# Above so many intervals, points are added in every one instead: errors of smooth motions fall with a power of twice
# the degree. (An acrobot's swing of 3 s takes 1600 intervals of degree 3, 225 in this way and less than half of the
# time.) Below, cutting is as quick, and finds switchings, which more points do not help.
MANY = 250
MOST_DEGREE = 7  # 5e-7 takes some 70 intervals with it then; sums of higher degree lose digits


@dataclass(frozen=True)
class Refinement:
    """Ends of the intervals of a finer mesh. Without one, `reason` says why errors stay, or is empty.

    `degree`: of the points in an interval, where it rises; 0: as it was.
    """

    mesh: tuple[float, ...] | None
    reason: str = ""
    degree: int = 0


def refinement_of(trajectory: Trajectory, accuracy: tuple[float, float]) -> Refinement:
    """A finer mesh, or none where all errors are reached or no finer mesh would do.

    `accuracy`: (dynamic, kinematic): the sum of the intervals' defects (how far a replay ends off the plan, to first
    order), and the opening of the loops between the points; bounds may be broken between the points by the problem's
    `violation`. An interval is cut in as many parts as the order of the scheme needs for its share, at most 4; where
    that were more than `MANY` intervals, the degree rises by 2 on the same ones.
    """
    errors, (dynamic, kinematic) = trajectory.errors, accuracy
    if len(errors.unseen.cuts):
        return _cut(trajectory.transcribed.mesh, errors.unseen.cuts)
    defects, allowed = errors.judged, trajectory.problem.violation
    if defects.sum() <= dynamic and errors.closure <= kinematic and errors.violation <= allowed:
        return Refinement(None)
    scheme = trajectory.transcribed.scheme
    # a smooth motion's defect falls with a power of twice the degree, less where a drive switches
    order = (scheme.degree if scheme else 2) + 1
    ratio = np.maximum(defects * len(defects) / (MARGIN * dynamic), 1e-12)
    # between points at which a bound is kept a motion leaves it by its curvature: by the square of their distance
    broken = np.maximum(errors.violations.per_interval / (MARGIN * allowed), 1e-12)
    # what nothing bounds over the shortest pieces of time is not bounded over shorter intervals either
    mended = np.isfinite(broken) & (errors.violations.per_interval > allowed)
    broken = np.where(mended, broken, 1e-12)
    wanted = np.maximum(ratio ** (1.0 / order), broken**0.5)
    parts = np.clip(np.ceil(wanted), 1, MOST_PARTS).astype(int)
    mesh = trajectory.transcribed.mesh
    if parts.max() == 1:
        return Refinement(None, "a finer mesh would not bring them nearer")
    if scheme and parts.sum() > MANY and scheme.degree < MOST_DEGREE:
        return Refinement(tuple(float(e) for e in mesh[1:]), degree=min(scheme.degree + 2, MOST_DEGREE))
    if parts.sum() > MOST_INTERVALS:
        return Refinement(None, f"a finer mesh of {parts.sum()} intervals was not tried, {MOST_INTERVALS} are the most")
    ends: list[float] = []
    for k, count in enumerate(parts):
        ends += list(mesh[k] + (mesh[k + 1] - mesh[k]) * np.arange(1, count + 1) / count)
    ends[-1] = 1.0
    return Refinement(tuple(float(e) for e in ends))


def _cut(mesh: np.ndarray, cuts: np.ndarray) -> Refinement:
    """With further ends of intervals."""
    ends = np.union1d(mesh[1:], cuts)
    if len(ends) > MOST_INTERVALS:
        return Refinement(None, f"a finer mesh of {len(ends)} intervals was not tried, {MOST_INTERVALS} are the most")
    return Refinement(tuple(float(e) for e in ends))
