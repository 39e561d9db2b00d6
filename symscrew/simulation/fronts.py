"""The order in which the rows of the closure are made orthogonal: front by front, so that a chain of loops costs
as much per loop however long it is.

A front takes the rows of one loop (of all that are left, once each of them shares rates with each other one), the
rates that no front before it has, and the directions that its children leave. Its rows use up `rank` of these
directions; the rest go to its parent, the next front that shares one of its rates. This is the multifrontal
factorisation of sparse matrices (Duff and Reid, ACM TOMS 9, 1983; for orthogonal factors Davis, ACM TOMS 38, 2011,
algorithm 915), with pivots chosen among the rows of a front only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

# A row whose remaining length is below this part of the longest one, in all sampled configurations, depends on the rows
# before it: it does not count for the rank of a front. Smaller: rounding makes dependent rows independent.
DEPENDENT = 1e-7
# Length of a row, without units, that is rounding of the rows before: no direction is taken from it.
NOTHING_LEFT = 1e-14


@dataclass(frozen=True)
class Front:
    """`rows` of the closure, `columns` (rates) that come in here, index of the `parent` (-1: none).

    `rank`: rows that are independent of each other and of those of earlier fronts in regular configurations.
    """

    rows: tuple[int, ...]
    columns: tuple[int, ...]
    parent: int
    rank: int = 0


def fronts(loops: Sequence[Sequence[int]], entries: np.ndarray) -> tuple[Front, ...]:
    """Fronts in their order, children before parents; their ranks are not known yet.

    Args:
        loops: rows of the closure, loop by loop.
        entries: rows and columns (n, 2) of the Jacobian's entries that are not always zero.
    """
    columns: dict[int, set[int]] = {}
    for row, column in entries.tolist():
        columns.setdefault(row, set()).add(column)
    live = [rows for loop in loops if (rows := tuple(row for row in loop if row in columns))]
    reach = [set().union(*(columns[row] for row in rows)) for rows in live]
    near = {i: {j for j in range(len(live)) if j != i and reach[i] & reach[j]} for i in range(len(live))}
    order: list[list[int]] = []  # loops of every front
    waiting: list[set[int]] = []  # those that its directions wait for
    while near:
        first = min(near, key=lambda i: (len(near[i]), i))
        others = near[first]
        whole = others | {first}
        group = whole if all(near[j] | {j} == whole for j in others) else {first}
        order.append(sorted(group))
        waiting.append(others - group)
        for j in others:  # what the front leaves couples them
            near[j] = (near[j] | others) - group - {j}
        for i in group:
            del near[i]
    place = {loop: k for k, group in enumerate(order) for loop in group}
    found, known = [], set[int]()
    for loops_here, later in zip(order, waiting, strict=True):
        own = set().union(*(reach[i] for i in loops_here)) - known
        known |= own
        rows = tuple(row for i in loops_here for row in live[i])
        found.append(Front(rows, tuple(sorted(own)), min((place[j] for j in later), default=-1)))
    return tuple(found)


def regular(found: Sequence[Front], matrices: Sequence[np.ndarray]) -> tuple[tuple[Front, ...], float]:
    """The fronts with their ranks, and the smallest pivot of regular configurations (the median over `matrices`)."""
    pivots = [front_pivots(matrix, found) for matrix in matrices]
    ranks = [
        max(int((p[k] > DEPENDENT * max(max(own, default=0.0) for own in p)).sum()) for p in pivots)
        for k in range(len(found))
    ]
    complete = [p for p in pivots if all(len(own) >= rank for own, rank in zip(p, ranks, strict=True))]
    least = sorted(
        min((own[rank - 1] for own, rank in zip(p, ranks, strict=True) if rank), default=1.0) for p in complete
    )
    ranked = tuple(replace(front, rank=rank) for front, rank in zip(found, ranks, strict=True))
    return ranked, float(least[len(least) // 2]) if least else 1.0


def front_pivots(matrix: np.ndarray, found: Sequence[Front]) -> list[np.ndarray]:
    """Per front, the lengths of its rows made orthogonal one after the other, the longest remaining row first."""
    left, pivots = np.array(matrix), []
    for front in found:
        rows, own = list(front.rows), []
        while rows:
            norms = np.sqrt((left[rows] ** 2).sum(axis=1))
            best = int(norms.argmax())
            if norms[best] < NOTHING_LEFT:
                break
            own.append(float(norms[best]))
            unit = left[rows.pop(best)] / norms[best]
            for _ in range(2):  # twice is enough: Kahan, in Parlett, The Symmetric Eigenvalue Problem, section 6.9
                left -= np.outer(left @ unit, unit)
        pivots.append(np.array(own))
    return pivots


@dataclass(frozen=True)
class Layout:
    """Where a front's numbers are in arrays over all fronts: `row`, `pivot`, directions `at`, `width` of them, place
    `up` of those that it leaves among its parent's (0: none), and its orthonormal vectors `turn`."""

    row: int
    pivot: int
    at: int
    width: int
    up: int
    turn: int


def layouts(found: Sequence[Front]) -> tuple[Layout, ...]:
    """Places of all fronts, directions as `columns` first, then what the children leave, child by child."""
    children: Mapping[int, list[int]] = {
        k: [c for c, front in enumerate(found) if front.parent == k] for k in range(len(found))
    }
    widths: list[int] = []
    for k, front in enumerate(found):
        widths.append(len(front.columns) + sum(widths[c] - found[c].rank for c in children[k]))
    starts = np.concatenate([[0], np.cumsum(widths)]).astype(int).tolist()
    up = [0] * len(found)
    for k, front in enumerate(found):
        place = starts[k] + len(front.columns)
        for c in children[k]:
            up[c] = place
            place += widths[c] - found[c].rank
    rows = np.cumsum([0, *(len(front.rows) for front in found)]).tolist()
    pivots = np.cumsum([0, *(front.rank for front in found)]).tolist()
    turns = np.cumsum([0, *(width * width for width in widths)]).tolist()
    return tuple(Layout(rows[k], pivots[k], starts[k], widths[k], up[k], turns[k]) for k in range(len(found)))


def paths(found: Sequence[Front], entries: np.ndarray) -> dict[int, tuple[int, ...]]:
    """Per row, the fronts below its own through which its entries come, in their order."""
    owner = {column: k for k, front in enumerate(found) for column in front.columns}
    own = {row: k for k, front in enumerate(found) for row in front.rows}
    met: dict[int, set[int]] = {row: set() for row in own}
    for row, column in entries.tolist():
        front = owner[column]
        while front != own[row]:
            met[row].add(front)
            front = found[front].parent
    return {row: tuple(sorted(through)) for row, through in met.items()}
