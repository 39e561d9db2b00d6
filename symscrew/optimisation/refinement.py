"""A finer mesh where the motion between the points does not obey its equations well enough."""

from __future__ import annotations

import numpy as np

from symscrew.optimisation.result import Trajectory

MOST_PARTS = 4
MARGIN = 0.5  # of the wanted error is aimed at
SWITCHING = 2.5
MOST_INTERVALS = 2000


def refined(trajectory: Trajectory, accuracy: tuple[float, float]) -> tuple[float, ...] | None:
    """Ends of the intervals of a finer mesh, or None where both errors are reached.

    `accuracy`: (dynamic, kinematic): the integral over an interval of the error of y_ddot [1/s] (the error of the
    rates that it brings about), and the opening of the loops between the points. An interval is cut in as many
    parts as the order of the scheme needs, at most 4.
    """
    errors, (dynamic, kinematic) = trajectory.errors, accuracy
    per = errors.worst
    if per.max() <= dynamic and errors.closure <= kinematic:
        return None
    scheme = trajectory.transcribed.scheme
    order = (scheme.degree if scheme else 2) + 1
    # a smooth part's error falls with the power `order`, that of an interval in which a drive switches with the first
    ratio = np.maximum(per / (MARGIN * dynamic), 1e-12)
    parts = np.clip(np.ceil(ratio ** (1.0 / order)), 1, MOST_PARTS).astype(int)
    parts = np.where(ratio > SWITCHING**order, MOST_PARTS, parts)
    mesh = trajectory.transcribed.mesh
    if parts.max() == 1 or parts.sum() > MOST_INTERVALS:
        return None
    ends: list[float] = []
    for k, count in enumerate(parts):
        ends += list(mesh[k] + (mesh[k + 1] - mesh[k]) * np.arange(1, count + 1) / count)
    ends[-1] = 1.0
    return tuple(float(e) for e in ends)
