"""Whether two points near a configuration are on one sheet of the configuration space.

    point --steps within the tangent space, corrected onto the closure--> along an arc --> does it arrive at the other?

Branches of two or more dimensions may touch: their tangent spaces at the configuration are the same, and the sheets are
apart by the square of the distance only. Tangent spaces do not tell such branches apart, a path that stays on its sheet
does: it ends above or below a point of the other one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from symscrew.mobility.finite import ClosureVariety, Local, local_at

Array = np.ndarray[Any, Any]

ANGLE = 0.1
"""Of a step, seen from the configuration [rad]: it leaves the tangent space by its square times the radius, a tenth of
what sheets of unlike curvature are apart."""
SIDEWAYS = 0.3
"""Corrections may be this part of the step: larger ones lead to another sheet."""
CORRECTIONS = 12
"""Steps of Newton's method for one point: five do where the sheet is apart from others."""
CORRECTED = 1e-11
"""Their last: rounding of doubles over singular values of 1e-5, which branches have on a sphere of a fiftieth."""
LAST = 6
"""Steps that end on the other point's projection, each of which squares what is left."""
ARRIVED = 1e-7
"""Distance at which the other point is reached: points are known to 1e-9, sheets on a sphere of radius 0.02 are apart
by 4e-4 times their difference in curvature, and those that touch to third order by 8e-6."""


def on_one_sheet(variety: ClosureVariety, here: Local, one: Array, two: Array, *, rank: int) -> bool:
    """Whether paths of points of the same rank lead from one displacement to the other, and back, around `here`."""
    return _arrives(variety, (here.q, one, two), rank=rank) and _arrives(variety, (here.q, two, one), rank=rank)


def _arrives(variety: ClosureVariety, places: tuple[Array, Array, Array], *, rank: int) -> bool:
    """Whether a path about the first of three places leads from the second to the third."""
    centre, start, end = places
    now, tangent = start, local_at(variety, start, rank=rank).kernel
    for target in _arc(start - centre, end - centre, tangent):
        found = _step(variety, now, centre + target, tangent, rank=rank)
        if found is None:
            return False
        now, tangent = found
    for _ in range(LAST):
        if np.linalg.norm(end - now) < ARRIVED:
            return True
        found = _step(variety, now, end, tangent, rank=rank)
        if found is None:
            return False
        now, tangent = found
    return bool(np.linalg.norm(end - now) < ARRIVED)


def _arc(start: Array, end: Array, tangent: Array) -> Iterator[Array]:
    """Points of an arc between two vectors; between opposite ones through the tangent space of the first."""
    radius = float(np.linalg.norm(start))
    u = start / radius
    across = end - u * (u @ end)
    angle = float(np.arctan2(np.linalg.norm(across), u @ end))
    if np.linalg.norm(across) < ANGLE * radius and angle > np.pi / 2:
        directions = tangent - np.outer(u, u @ tangent)
        across = directions[:, int(np.linalg.norm(directions, axis=0).argmax())]
        angle = np.pi
    count = int(np.ceil(angle / ANGLE))
    if count > 1:
        w = across / np.linalg.norm(across)
        for k in range(1, count):
            turned = k * angle / count
            yield radius * (np.cos(turned) * u + np.sin(turned) * w)


def _step(
    variety: ClosureVariety, now: Array, target: Array, tangent: Array, *, rank: int
) -> tuple[Array, Array] | None:
    """(the point of the sheet beside the target, its tangent space); None where the sheet was lost."""
    forward = tangent @ (tangent.T @ (target - now))
    guess = q = now + forward
    most = SIDEWAYS * float(np.linalg.norm(forward)) + ARRIVED
    for _ in range(CORRECTIONS):
        residuals, jacobians = variety.evaluate(q[None])
        u, s, vt = np.linalg.svd(jacobians[0])
        step = vt[:rank].T @ ((u[:, :rank].T @ residuals[0]) / s[:rank])
        q = q - step
        if not np.linalg.norm(q - guess) < most:
            return None
        if np.linalg.norm(step) < CORRECTED:
            return q, vt[rank:].T
    return None
