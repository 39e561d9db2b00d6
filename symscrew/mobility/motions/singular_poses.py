"""Singular poses on the coordinate lines through the reference: where, of which kind, what the mechanism does there.

Track --a margin that dips to zero, a coordinate that turns back--> pose, refined --germs there--> SingularPose
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from symscrew.mobility.finite import local_at
from symscrew.mobility.motions.coordinate_lines import STRIDE, Pose, Setting, Track, corrected, pose_at
from symscrew.mobility.motions.germs import germs_at

Array = np.ndarray[Any, Any]

DIPS = 0.5
"""A margin that is lowest at a pose, below this part of its median along the line, may be zero nearby."""
ZERO = 1e-5
"""Part of its median below which a margin, refined, is zero: it goes through zero like a distance along the line, which
is known to 1e-8."""
GOLDEN, TIMES = (5**0.5 - 1) / 2, 8
"""Golden section on a stretch of two strides, to a hundredth of it."""
SECANTS, NARROWER = 5, 20
"""Then secants from both sides, on a stretch ten times narrower each time: their error is its square."""
SAME = 1e-4
"""Poses closer together than this are one, of several kinds."""
LOST = 1e-5
"""Relative singular value of the closure that counts as lost at a refined pose."""


@dataclass(frozen=True)
class SingularPose:
    """A singular pose on a coordinate line.

    Attributes:
        column: of the coordinate that moves, the others being at rest.
        q: displacements of all joint freedoms from the reference [rad, lengths in units of the mechanism].
        kinds: `closure`, `drives`, `platform`, `coordinate`, or the name of a limb.
        instantaneous: instantaneous freedoms there.
        branches: dimensions of the branches that meet there, where the closure is singular; empty where not told.
    """

    column: int
    q: Array
    kinds: tuple[str, ...]
    instantaneous: int
    branches: tuple[int, ...]


def singular_poses(setting: Setting, tracks: Sequence[Track]) -> tuple[SingularPose, ...]:
    """Those on all lines, each once."""
    found: list[tuple[int, Array, list[str]]] = []
    for line in tracks:
        for kind, q in _on(setting, line):
            same = [entry for entry in found if entry[0] == line.column and _near(entry[1], q)]
            if same:
                same[0][2].extend([kind] * (kind not in same[0][2]))
            else:
                found.append((line.column, q, [kind]))
    return tuple(_judged(setting, column, q, kinds) for column, q, kinds in found)


def _near(a: Array, b: Array) -> bool:
    turned = np.abs((a - b + np.pi) % (2 * np.pi) - np.pi)
    return bool(np.linalg.norm(np.minimum(np.abs(a - b), turned)) < SAME)


def _on(setting: Setting, line: Track) -> Iterator[tuple[str, Array]]:
    """(kind, displacements) along one line."""
    poses = line.poses
    for before, after in pairwise(poses):
        if before.direction[line.column] * after.direction[line.column] < 0:
            q = _lowest(setting, line, before, None)
            if q is not None:
                yield "coordinate", q[0]
    for kind in poses[0].margins:
        values = np.array([pose.margins[kind] for pose in poses])
        typical = float(np.median(values))
        for k in range(1, len(poses) - 1):
            if values[k] <= min(values[k - 1], values[k + 1]) and values[k] < DIPS * typical:
                found = _lowest(setting, line, poses[k - 1], kind, strides=2.2)
                if found is not None and found[1] < ZERO * max(typical, float(values.max()) * ZERO):
                    yield kind, found[0]


def _lowest(
    setting: Setting, line: Track, start: Pose, kind: str | None, *, strides: float = 1.2
) -> tuple[Array, float] | None:
    """(displacements, value) where a margin is lowest on the stretch after a pose, by golden section.

    Without a kind the value is the coordinate's own rate.
    """

    def at(part: float) -> tuple[float, Array] | None:
        q = corrected(setting, start.q + part * STRIDE * start.direction, line.held)
        if q is None:
            return None
        pose = pose_at(setting, q, line.held, start.direction)
        return (abs(float(pose.direction[line.column])) if kind is None else pose.margins[kind]), q

    low, high = 0.0, strides
    inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)]
    values = [at(part) for part in inner]
    for _ in range(TIMES):
        left = values[1] is None or (values[0] is not None and values[0][0] < values[1][0])
        if left:
            high, inner = inner[1], [inner[1] - GOLDEN * (inner[1] - low), inner[0]]
            values = [at(inner[0]), values[0]]
        else:
            low, inner = inner[0], [inner[1], inner[0] + GOLDEN * (high - inner[0])]
            values = [values[1], at(inner[1])]
    best = min((v for v in values if v is not None), key=lambda pair: pair[0], default=None)
    for _ in range(SECANTS):  # a margin goes through zero like a distance: both sides of the V meet there
        ends = at(low), at(high)
        if ends[0] is None or ends[1] is None or not ends[0][0] + ends[1][0] > 0:
            break
        middle = (ends[0][0] * high + ends[1][0] * low) / (ends[0][0] + ends[1][0])
        there = at(middle)
        if there is None:
            break
        best = there if best is None or there[0] < best[0] else best
        low, high = middle - (high - low) / NARROWER, middle + (high - low) / NARROWER
    return None if best is None else (best[1], best[0])


def _judged(setting: Setting, column: int, q: Array, kinds: list[str]) -> SingularPose:
    """The pose with the branches that meet there."""
    variety = setting.variety
    values = np.linalg.svd(variety.evaluate(q[None])[1][0], compute_uv=False)
    rank = int((values > LOST * max(values[0], LOST)).sum()) if len(values) else 0
    instantaneous = variety.columns - rank
    branches: tuple[int, ...] = ()
    if "closure" in kinds and instantaneous > setting.dimension:
        here = local_at(variety, q, rank=rank)
        dimensions = {d: d for d in range(1, instantaneous)}
        branches = tuple(sorted((germ.dimension for germ in germs_at(variety, here, dimensions)), reverse=True))
    return SingularPose(column, q, tuple(kinds), instantaneous, branches)
