"""Where names stand in a picture: beside their points, off joints, bars and other names.

points, names --candidates around each--> boxes --cost of what a box covers--> the cheapest box of each, in turn
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

Array = np.ndarray

DIRECTIONS = 16  # in which a name is tried around its point
FAR = (11.0, 15.0, 20.0)  # how far from its point the middle of a name's nearest side is [points of type]
LINE, NAME, JOINT, AWAY = 4.0, 12.0, 14.0, 1.0
"""What it costs a name to lie on a bar, on another name, on a joint; and to be on the inner side of its point.

A name on a bar can still be read; one on a name or on a joint hides what it should explain."""
MARGIN = 1.5  # points of type around a name that are to be free


def label_places(
    points: Array,
    sizes: Array,
    *,
    bars: Sequence[tuple[Array, Array]],
    joints: Array,
    middle: Array,
    far: Sequence[float] = FAR,
) -> Array:
    """Middles of names (n, 2), all in points of type.

    Args:
        points: (n, 2), what is named.
        sizes: (n, 2), widths and heights of the names.
        bars: (from, to) of lines that are drawn, each end (2,).
        joints: (m, 3): place and radius of the marks of joints.
        middle: (2,) of the picture: names are rather outwards.
        far: how far from its point the middle of a name's nearest side may be.
    """
    angles = np.arange(DIRECTIONS) * 2 * np.pi / DIRECTIONS
    around = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    starts = np.array([start for start, _ in bars]).reshape(-1, 2)
    ends = np.array([end for _, end in bars]).reshape(-1, 2)
    placed: list[tuple[Array, Array]] = []
    for point, size in zip(points, sizes, strict=True):
        half = size / 2 + MARGIN
        away = point - middle
        outwards = away / (np.linalg.norm(away) or 1.0)
        best, least = point, np.inf
        for gone in far:
            for direction in around:
                # the box touches the circle with this radius about the point on its own side
                box = point + direction * gone + np.sign(np.round(direction, 6)) * half * np.abs(direction)
                cost = LINE * _crossed(box, half, starts, ends) + 0.04 * gone - AWAY * float(direction @ outwards)
                cost += NAME * sum(bool((np.abs(box - other) < half + more).all()) for other, more in placed)
                if len(joints):
                    gap = np.maximum(np.abs(joints[:, :2] - box) - half, 0.0)
                    cost += JOINT * int((np.linalg.norm(gap, axis=1) < joints[:, 2]).sum())
                if cost < least:
                    best, least = box, cost
        placed.append((best, half))
    return np.array([box for box, _ in placed]).reshape(-1, 2)


def _crossed(box: Array, half: Array, starts: Array, ends: Array) -> int:
    """How many lines meet a box: by the part of a line within both of its strips."""
    if not len(starts):
        return 0
    span = np.where(np.abs(ends - starts) < 1e-9, 1e-9, ends - starts)  # points of type: lines along an axis
    one, two = (box - half - starts) / span, (box + half - starts) / span
    enter, leave = np.minimum(one, two).max(axis=1), np.maximum(one, two).min(axis=1)
    return int((np.maximum(enter, 0.0) < np.minimum(leave, 1.0)).sum())
