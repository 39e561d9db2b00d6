"""Sparse elimination in an order fixed while generating, with pivots proved on sample states.

    rows . unknowns = right  --eliminate--> pivots, factors, guards  --solve(right)--> unknowns as nodes

A row is a mapping from columns to nodes. Whether an entry is zero, and whether it may be a pivot, is
decided by its values at several consistent states, never by symbolic zero tests alone: some entries vanish
only on the closure manifold. Entries are compared without units: each row and column has a scale (a power
of the characteristic length).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field
from math import isfinite
from typing import Any

import numpy as np

from symscrew.algebra.nodes import Node, Tape, is_zero
from symscrew.algebra.screws import Vector, cross, dot
from symscrew.algebra.traversal import needed

# An entry below this at every sample, without units, is zero on the closure manifold. The samples close the loops to
# 1e-13 and entries are sums of a few products, so that rounding leaves 1e-12 at most of a zero; an entry that means
# something is above 1e-6 of the size of the mechanism at one of several random states. Above: it stays, may be a pivot.
NEGLIGIBLE = 1e-9
# A row whose best pivot is smaller than this, without units, waits for the others: near a singular configuration of
# its limb it would cost digits, where the rows of the hub together may have none (their rank decides then).
SAFE = 0.03
# A pivot may be this much smaller than the best one of its row if it saves operations: a digit is lost at most. Below,
# it is taken only where nothing else is left.
ACCEPTABLE = 0.1
SMALL = 1e-4  # a pivot below this, without units, is taken last even if its row has no better one: another row may

Column = Any  # hashable: a multiplier, a drive, an index into v, or column 1
Affine = dict[Column, Node]


@dataclass(frozen=True)
class Guard:
    """A pivot to be watched at run time: it must not fall below a threshold times `scale`."""

    pivot: Node
    scale: float


def divides(pivot: Node, used: Set[Node]) -> bool:
    """Whether one of the operations `used` divides by a pivot; only then its smallness does harm."""
    if pivot.value is not None:
        return False
    inverses = {node for node in needed([1 / pivot]) - needed([pivot]) if node.op == "reciprocal"}
    return not inverses or bool(inverses & used)


def magnitude(tape: Tape, entry: Node, scale: float) -> tuple[float, float]:
    """Smallest and largest magnitude of an entry over the samples, without units.

    Rounded to five digits, so that the last digits of another machine's sines do not choose other pivots.
    """
    known = tape.magnitudes.get((entry.index, scale))
    if known is None:
        sizes = [abs(value) * scale for value in np.atleast_1d(tape.sample(entry)).tolist()]
        sizes = [size for size in sizes if isfinite(size)]  # at a singular reference an earlier pivot was zero
        known = (float(f"{min(sizes):.4e}"), float(f"{max(sizes):.4e}")) if sizes else (0.0, 0.0)
        tape.magnitudes[entry.index, scale] = known
    return known


@dataclass(frozen=True)
class Pivot:
    """A column of a row, and the smallest magnitude of its entry over the samples, without units."""

    column: Column
    size: float


def choose_pivot(
    tape: Tape, row: Mapping[Column, Node], allowed: Mapping[Column, float], cost: Mapping[Column, int]
) -> Pivot | None:
    """The column of `row` to eliminate, or None if all allowed entries vanish on the manifold.

    `allowed` gives the scale of an entry in each column that may be a pivot, `cost` how many other rows it
    stands in. Among the entries that are large enough: constants first, then the cheapest, then the largest.
    """
    sizes = {c: magnitude(tape, row[c], allowed[c]) for c in row if c in allowed}
    sizes = {c: size for c, size in sizes.items() if size[1] > NEGLIGIBLE}
    if not sizes:
        return None
    best = max(size[0] for size in sizes.values())
    good = [c for c, size in sizes.items() if size[0] >= ACCEPTABLE * best]

    def preference(column: Column) -> tuple[bool, int, float]:
        return (row[column].value is None, cost.get(column, 0), -sizes[column][0])

    column = min(good, key=preference)
    return Pivot(column, sizes[column][0])


def combine(target: Mapping[Column, Node], factor: Node, other: Mapping[Column, Node]) -> Affine:
    """target + factor * other, column by column; entries that fold to zero disappear."""
    result = dict(target)
    for column, entry in other.items():
        total = result[column] + factor * entry if column in result else factor * entry
        if total is total.tape.zero:
            result.pop(column, None)
        else:
            result[column] = total
    return result


def solve_for(row: Mapping[Column, Node], pivot: Column) -> Affine:
    """The pivot's unknown from sum(row) = 0, as an affine combination of the other columns."""
    factor = -(1 / row[pivot])
    return {c: factor * entry for c, entry in row.items() if c != pivot}


def insert_solution(row: Mapping[Column, Node], pivot: Column, solution: Mapping[Column, Node]) -> Affine:
    """`row` with the pivot's unknown replaced by its solution."""
    rest = {c: entry for c, entry in row.items() if c != pivot}
    return combine(rest, row[pivot], solution) if pivot in row else rest


def solve_block(rows: Sequence[Mapping[Column, Node]], columns: Sequence[Column]) -> tuple[list[Affine], Node]:
    """Two or three unknowns from as many rows, sum(row) = 0, by Cramer's rule, and the determinant.

    Every unknown is an affine combination of the other columns. One division instead of as many as unknowns, which
    would wait for each other; the determinant is the product of their pivots.
    """
    others = list(dict.fromkeys(c for row in rows for c in row if c not in columns))
    tape = rows[0][columns[0]].tape
    matrix = [[row.get(c, tape.zero) for row in rows] for c in columns]
    rests = [[row.get(c, tape.zero) for row in rows] for c in others]
    if len(columns) == 2:
        (a, b), (c, d) = matrix
        determinant = a * d - b * c
        over = 1 / determinant
        found = [[(c * y - d * x) * over, (b * x - a * y) * over] for x, y in rests]
    else:
        first, second, third = (_three(column) for column in matrix)
        across = cross(second, third)
        determinant = tape.node(dot(first, across))
        over = 1 / determinant
        found = []
        for rest in rests:
            turned = cross(_three(rest), first)
            numerators = -tape.node(dot(_three(rest), across)), dot(turned, third), -tape.node(dot(turned, second))
            found.append([n * over for n in numerators])
    solutions = [
        {c: values[k] for c, values in zip(others, found, strict=True) if values[k] is not tape.zero}
        for k in range(len(columns))
    ]
    return solutions, determinant


def _three(values: Sequence[Node]) -> Vector:
    x, y, z = values
    return (x, y, z)


@dataclass
class Elimination:
    """A square sparse system with its pivots chosen; `solve` serves any number of right-hand sides.

    `steps`: (row, column, pivot, factors of the later rows); `upper`: the rows as they were when eliminated.
    """

    steps: list[tuple[int, Column, Node, dict[int, Node]]] = field(default_factory=list)
    upper: dict[int, Affine] = field(default_factory=dict)
    guards: list[Guard] = field(default_factory=list)
    redundant: list[int] = field(default_factory=list)
    free: list[Column] = field(default_factory=list)

    @property
    def vanishes(self) -> bool:
        """Whether a pivot is as good as zero at a sample."""
        return any(magnitude(g.pivot.tape, g.pivot, g.scale)[0] < SMALL for g in self.guards)

    def solve(self, right: Sequence[Node], free: Mapping[Column, Node] | None = None) -> dict[Column, Node]:
        """Unknowns from rows . unknowns = right; free unknowns as given, else zero.

        A multiple of another unknown is not taken through the pivot and back.
        """
        values = list(right)
        for row, _, _, factors in self.steps:
            if not is_zero(values[row]):
                for other, factor in factors.items():
                    values[other] = values[other] - factor * values[row]
        solution: dict[Column, Node] = dict(free or {})
        for row, column, pivot, _ in reversed(self.steps):
            over = 1 / pivot
            total, whole = values[row], values[row].tape.zero
            for c, entry in self.upper[row].items():
                if c == column or c not in solution:
                    continue
                part = entry * over
                if is_zero(solution[c]):
                    continue
                if part.value is not None:
                    whole = whole - part * solution[c]
                else:
                    total = total - entry * solution[c]
            solution[column] = total * over + whole
        return solution


@dataclass
class Pair(Elimination):
    """Two unknowns from two full rows by their determinant: one division, of two of which one would wait for the other.

    The determinant is the product of the pivots, up to sign, and stands for both in `steps` and `guards`.
    """

    matrix: tuple[tuple[Node, Node], tuple[Node, Node]] | None = None

    def solve(self, right: Sequence[Node], free: Mapping[Column, Node] | None = None) -> dict[Column, Node]:
        """Both unknowns, 0 and 1, from rows . unknowns = right."""
        assert self.matrix is not None
        ((a, b), (c, d)), ((_, _, determinant, _),) = self.matrix, self.steps
        over, (x, y) = 1 / determinant, right
        return {**(free or {}), 0: (d * x - b * y) * over, 1: (a * y - c * x) * over}


def pair(tape: Tape, rows: Sequence[Mapping[Column, Node]], scales: tuple[float, float]) -> Pair | None:
    """The pair of unknowns 0 and 1, if there are two rows that hold both and determine them at all samples.

    `scales`: of each row, in the way of `eliminate`, where the unknowns are without units.
    """
    if len(rows) != 2 or any(set(row) != {0, 1} for row in rows):
        return None
    (a, b), (c, d) = ((row[0], row[1]) for row in rows)
    determinant = tape.node(a * d - b * c)
    scale = scales[0] * scales[1]
    if determinant.value is not None or magnitude(tape, determinant, scale)[0] < SMALL:
        return None
    guards = [Guard(determinant, scale)]
    return Pair(steps=[(0, 0, determinant, {})], guards=guards, matrix=((a, b), (c, d)))


def eliminate(
    tape: Tape,
    rows: Sequence[Mapping[Column, Node]],
    unknowns: Mapping[Column, float],
    row_scales: Sequence[float],
    *,
    last: Sequence[Column] = (),
    yielding: bool = False,
    defined: Mapping[int, Column] | None = None,
) -> Elimination:
    """Choose pivots for rows . unknowns = right in Markowitz order.

    `unknowns` and `row_scales` give the unit scale of each column and row. Rows that vanish on the closure
    manifold are redundant, columns without a pivot are free. Columns in `last` are free if there is a choice; if they
    are `yielding`, only where no pivot is as good as zero at a sample for that.
    `defined`: a row that is there to define an unknown has its pivot there, and the unknown has no other.
    """
    own = defined or {}
    result = Elimination()
    active = {i: {c: e for c, e in row.items() if c in unknowns} for i, row in enumerate(rows)}
    while active:
        sizes = _sizes(tape, active, unknowns, row_scales)
        choice = _markowitz(active, sizes, last=set(last), yielding=yielding, defined=own)
        if choice is None:
            break
        row, column = choice
        pivot_row = active.pop(row)
        pivot = pivot_row[column]
        factors = {}
        for other, entries in active.items():
            if column in entries:
                factor = entries[column] * (1 / pivot)
                factors[other] = factor
                reduced = combine(entries, -factor, pivot_row)
                reduced.pop(column, None)
                active[other] = reduced
        result.steps.append((row, column, pivot, factors))
        result.upper[row] = pivot_row
        if pivot.value is None:
            result.guards.append(Guard(pivot, unknowns[column] * row_scales[row]))
    result.redundant = sorted(active)
    solved = {column for _, column, _, _ in result.steps}
    result.free = [c for c in unknowns if c not in solved]
    return result


def _sizes(
    tape: Tape,
    active: Mapping[int, Mapping[Column, Node]],
    unknowns: Mapping[Column, float],
    row_scales: Sequence[float],
) -> dict[tuple[int, Column], tuple[float, float]]:
    """Smallest and largest magnitude, without units, of every entry that does not vanish on the manifold."""
    sizes = {
        (i, column): magnitude(tape, entry, unknowns[column] * row_scales[i])
        for i, row in active.items()
        for column, entry in row.items()
    }
    return {at: size for at, size in sizes.items() if size[1] > NEGLIGIBLE}


def _markowitz(
    active: Mapping[int, Mapping[Column, Node]],
    sizes: Mapping[tuple[int, Column], tuple[float, float]],
    *,
    last: Set[Column],
    yielding: bool,
    defined: Mapping[int, Column],
) -> tuple[int, Column] | None:
    """Row and column of the next pivot: of those of a fair size the one that fills fewest entries [Markowitz 1957]."""
    others = set(defined.values())
    row_best: dict[int, float] = {}
    row_count: dict[int, int] = {}
    counts: dict[Column, int] = {}
    for (i, column), size in sizes.items():
        row_best[i] = max(row_best.get(i, 0.0), size[0])
        row_count[i] = row_count.get(i, 0) + 1
        counts[column] = counts.get(column, 0) + 1

    def preference(key: tuple[int, Column]) -> tuple[bool, bool, bool, int, bool, float]:
        i, column = key
        hopeless = sizes[key][0] < SMALL
        small = sizes[key][0] < ACCEPTABLE * row_best[i] or hopeless
        fill = (row_count[i] - 1) * (counts[column] - 1)
        return (yielding and hopeless, column in last, small, fill, active[i][column].value is None, -sizes[key][0])

    allowed = [(i, c) for i, c in sizes if (c == defined[i] if i in defined else c not in others)]
    return min(allowed, key=preference, default=None)
