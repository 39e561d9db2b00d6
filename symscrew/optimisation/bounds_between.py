"""Bounds of a plan between its points: what is proved to hold at every time, and where something is broken.

Every quantity with a bound is enclosed over pieces of time (`enclosures`, `followed_branch`). A piece whose enclosure
keeps its bounds is settled; one in whose middle a bound is broken tells by how much; what is neither is halved.
So the violation that is reported is never less than that of the motion, and hardly more.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from symscrew.optimisation.constraints import bound_rows
from symscrew.optimisation.enclosed_quantities import EnclosedQuantities
from symscrew.optimisation.enclosures import Enclosure, bounds_of
from symscrew.optimisation.followed_branch import Boxes, Branch, Followed
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.planned_motion import PlannedMotion
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.rows import Row

# Halvings of a piece: a millionth of an interval. What is not settled then counts with its enclosure.
MOST_HALVINGS = 20
# What nothing bounds over pieces of a thousandth of an interval is hardly bounded over shorter ones.
MOST_UNBOUNDED = 10
# Pieces at a time: more would fill the memory (a kilobyte for each operation of a function).
MOST_PIECES = 20_000
KNOWN = 1.1  # an enclosure within a tenth of a violation that was seen is settled: the mesh is to be mended anyway


@dataclass(frozen=True)
class Violations:
    """Violations of bounds between the points, scaled: `largest` of all, `per_interval` (intervals,), and the worst.

    `label`: the quantity that is worst, `tau` where, `by`: how far in its own units (squares for distances and
    reactions).
    """

    largest: float
    per_interval: np.ndarray
    label: str = ""
    tau: float = 0.0
    by: float = 0.0


class BoundedRows:
    """The quantities of a plan that have bounds, on enclosures."""

    def __init__(self, motion: PlannedMotion, branch: Branch) -> None:
        symbols = point_symbols(motion.model, moving=True)
        at = MotionQuantities(motion.model, symbols)
        self.rows: list[Row] = [r for r in bound_rows(at) if r.lower < r.upper]
        self.measures = [r.measure or r.scale for r in self.rows]
        looked = [r.value if r.between is None else r.between for r in self.rows]
        values = ca.vertcat(ca.SX(0, 1), *[value / m for value, m in zip(looked, self.measures, strict=True)])
        self.quantities = EnclosedQuantities(motion, branch, symbols, values)
        self.low, self.high = (
            np.array([getattr(r, name) / m for r, m in zip(self.rows, self.measures, strict=True)])[:, None]
            for name in ("lower", "upper")
        )

    def enclosed(self, boxes: Boxes) -> tuple[np.ndarray, np.ndarray]:
        """How far rows may leave their bounds over pieces, and how far they do in their middles: (rows, n)."""
        n = len(boxes.pieces)
        values = self.quantities.over(boxes)
        low, high = (np.array(part).reshape(-1, n) for part in zip(*(bounds_of(v, n) for v in values), strict=True))
        middle = np.array(
            [np.broadcast_to(v.middle[0], (n,)) if isinstance(v, Enclosure) else np.full(n, v) for v in values]
        )
        may = np.maximum(np.maximum(self.low - low, high - self.high), 0.0)
        does = np.maximum(np.maximum(self.low - middle, middle - self.high), 0.0)
        return np.nan_to_num(may, nan=np.inf, posinf=np.inf), np.nan_to_num(does, nan=0.0, posinf=np.inf)


def violations_of(motion: PlannedMotion, branch: Branch, followed: Followed, allowed: float) -> Violations:
    """Violations of the bounds of a plan that was followed, where they may be more than `allowed` (scaled)."""
    intervals = len(motion.transcribed.mesh) - 1
    bounded = BoundedRows(motion, branch)
    nothing = Violations(0.0, np.zeros(intervals))
    if not bounded.rows:
        return nothing
    if followed.trouble:
        return Violations(np.inf, np.full(intervals, np.inf), "everything: the plan is not followed")
    seen = np.zeros((len(bounded.rows), intervals))  # what a motion breaks for sure
    result = np.zeros((len(bounded.rows), intervals))
    where = np.zeros((len(bounded.rows), intervals))
    boxes = followed.boxes
    for halving in range(MOST_HALVINGS + 1):
        may, does = bounded.enclosed(boxes)
        k, tau = boxes.pieces.interval, boxes.pieces.tau(motion.transcribed.mesh)
        for row in range(len(bounded.rows)):
            better = does[row] > seen[row, k]
            for i in np.flatnonzero(better):
                if does[row, i] > seen[row, k[i]]:
                    seen[row, k[i]], where[row, k[i]] = does[row, i], tau[i]
        open_ = may > np.maximum(allowed, KNOWN * seen[:, k])
        last = halving == MOST_HALVINGS or 2 * int(open_.any(axis=0).sum()) > MOST_PIECES
        hopeless = np.isinf(may).any(axis=0) & (halving >= MOST_UNBOUNDED)
        settled = np.asarray(~open_.any(axis=0)) | last | hopeless
        for row in range(len(bounded.rows)):
            np.maximum.at(result[row], k[settled], may[row, settled])
        if settled.all():
            break
        boxes = halved(branch, boxes.chosen(~settled))
    result = np.maximum(result, seen)
    row, interval = divmod(int(np.argmax(result)), intervals)
    worst = bounded.rows[row]
    at = where[row, interval] or float(motion.transcribed.mesh[interval : interval + 2].mean())
    largest = float(result[row, interval])
    return Violations(largest, result.max(axis=0), worst.label, at, largest * bounded.measures[row])


def halved(branch: Branch, boxes: Boxes) -> Boxes:
    """Boxes over both halves of pieces; where none is proved it is everything, until it is halved again."""
    halves = boxes.pieces.halves()
    shift = boxes.slope * boxes.pieces.radius[:, None] / 2
    near = np.concatenate([boxes.z - shift, boxes.z + shift])
    made, good = branch.boxes(halves, near)
    lost = ~good[:, None]
    return Boxes(
        halves, np.where(lost, near, made.z), made.slope, np.where(lost, np.inf, made.radius), made.inverse,
        np.where(lost[:, None], np.inf, made.excess),
    )  # fmt: skip
