"""A finer mesh where the motion between the points does not obey its equations well enough."""

from __future__ import annotations

import numpy as np

from symscrew.optimisation.result import Trajectory

MOST_PARTS = 4
MARGIN = 0.5  # of the wanted error is aimed at
MOST_INTERVALS = 2000


def refined(trajectory: Trajectory, accuracy: tuple[float, float]) -> tuple[float, ...] | None:
    """Ends of the intervals of a finer mesh, or None where both errors are reached or no finer mesh would do.

    `accuracy`: (dynamic, kinematic): the sum of the intervals' defects (how far a replay ends off the plan, to first
    order), and the opening of the loops between the points. An interval is cut in as many parts as the order of the
    scheme needs for its share, at most 4.
    """
    errors, (dynamic, kinematic) = trajectory.errors, accuracy
    if errors.drift <= dynamic and errors.closure <= kinematic:
        return None
    scheme = trajectory.transcribed.scheme
    # a smooth motion's defect falls with a power of twice the degree, less where a drive switches
    order = (scheme.degree if scheme else 2) + 1
    ratio = np.maximum(errors.defects * len(errors.defects) / (MARGIN * dynamic), 1e-12)
    parts = np.clip(np.ceil(ratio ** (1.0 / order)), 1, MOST_PARTS).astype(int)
    mesh = trajectory.transcribed.mesh
    if parts.max() == 1 or parts.sum() > MOST_INTERVALS:
        return None
    ends: list[float] = []
    for k, count in enumerate(parts):
        ends += list(mesh[k] + (mesh[k + 1] - mesh[k]) * np.arange(1, count + 1) / count)
    ends[-1] = 1.0
    return tuple(float(e) for e in ends)
