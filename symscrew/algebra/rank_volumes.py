"""Volumes of grids of nodes: numbers that vanish exactly where the rank falls, without any division.

    grid (rows x columns), rank r --> det(block) ... det(block) * sum of the squared minors of what is left

A grid is a list of rows of nodes without units. What is zero in it is read from the sample states, so a volume is
right on the closure manifold. `reciprocal_factors` eliminates columns by minors without their common factor.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import comb

import numpy as np

from symscrew.algebra.elimination import NEGLIGIBLE
from symscrew.algebra.nodes import Node, Tape

# With more maximal minors than this the determinant of the Gram matrix is shorter than the sum of their squares
# (Cauchy and Binet: they are equal): of 6 columns one determinant of 21 sums, against 84 determinants of 9 rows.
MOST_SQUARES = 30
# A volume that needs more minors than this is not derived (`TooLargeError`): each takes a few operations, and functions
# of tens of thousands of them are for nobody. A dense determinant of 12 rows has 4095 minors: 11 rows are derived.
MOST_MINORS = 4000
MOST_SUMMED = 400  # minors of a sum of squares: each is a determinant of its own, with some ten minors in it
# Up to so many columns all sets of them are tried as a block (4095 sets), of more only small sets and the whole: then a
# factor may not split off, and the volume is longer, but as right.
MOST_COLUMNS, SMALL_BLOCK = 12, 3

Grid = list[list[Node]]


@dataclass(frozen=True)
class Volume:
    """`form`: "signed" (a determinant), "squared" (a sum of squares) or "mixed" (a determinant times squares)."""

    value: Node
    form: str


class TooLargeError(ValueError):
    """A volume would need too many minors; the text says how many, of which size."""


def reciprocal_factors(tape: Tape, block: Grid) -> list[dict[int, Node]]:
    """Combinations of rows {row: factor} that annihilate the columns, as polynomials without common factor.

    Minors (Cramer), from each connected part of the block on its own. A column that stands in one row alone
    takes that row away.
    """
    count = len(block[0]) if block else 0
    rows, columns = set(range(len(block))), set(range(count))
    while True:
        single = {j: [i for i in rows if block[i][j] is not tape.zero] for j in columns}
        found = next((j for j in sorted(columns) if len(single[j]) == 1), None)
        if found is None:
            break
        rows.discard(single[found][0])
        columns.discard(found)
    result: list[dict[int, Node]] = []
    for part_rows, part_columns in _parts(tape, block, rows, columns):
        if not part_columns:
            result += [{i: tape.one} for i in part_rows]
            continue
        chosen = _independent_columns(tape, block, part_rows, part_columns)
        if len(part_rows) > len(chosen):
            result += _annihilators(tape, block, part_rows, chosen)
    return result


def _independent_columns(tape: Tape, block: Grid, rows: Sequence[int], columns: Sequence[int]) -> list[int]:
    """As many columns as the part's rank, best conditioned; fewer than all where a freedom is internal (a spin)."""
    values = sampled(tape, [[block[i][j] for j in columns] for i in rows])
    rank = max(int(np.linalg.matrix_rank(v, tol=NEGLIGIBLE)) for v in values)
    if rank == len(columns):
        return list(columns)
    sizes = {}
    for chosen in combinations(range(len(columns)), rank):
        part = values[:, :, list(chosen)]
        gram = np.linalg.det(np.swapaxes(part, 1, 2) @ part)
        sizes[chosen] = round(float(gram.min()), 9)
    return [columns[j] for j in max(sizes, key=lambda chosen: sizes[chosen])]


def _annihilators(tape: Tape, block: Grid, rows: Sequence[int], columns: Sequence[int]) -> list[dict[int, Node]]:
    values = sampled(tape, [[block[i][j] for j in columns] for i in rows])
    sizes = {}
    for chosen in combinations(range(len(rows)), len(columns)):
        sizes[chosen] = round(float(np.abs(np.linalg.det(values[:, list(chosen)])).min()), 9)
    used = [rows[i] for i in max(sizes, key=lambda chosen: sizes[chosen])]
    result = []
    for free in (i for i in rows if i not in used):
        taking = sorted([*used, free])
        factors = {}
        for place, row in enumerate(taking):
            minor = determinant(tape, [[block[i][j] for j in columns] for i in taking if i != row])
            if minor is not tape.zero:
                factors[row] = -minor if place % 2 else minor
        result.append(_primitive(tape, factors))
    return result


def _parts(tape: Tape, block: Grid, rows: set[int], columns: set[int]) -> list[tuple[list[int], list[int]]]:
    """Connected parts of the pattern of non-zeros: (rows, columns) of each."""
    result = []
    waiting = set(rows)
    while waiting:
        mine: set[int] = {min(waiting)}
        held: set[int] = set()
        while True:
            more = {j for j in columns if any(block[i][j] is not tape.zero for i in mine)}
            wider = mine | {i for i in rows if any(block[i][j] is not tape.zero for j in more)}
            if wider == mine and more == held:
                break
            mine, held = wider, more
        waiting -= mine
        result.append((sorted(mine), sorted(held)))
    return result


def _primitive(tape: Tape, factors: dict[int, Node]) -> dict[int, Node]:
    """The factors without what all of them have in common; a single one becomes 1."""
    if len(factors) == 1:
        return dict.fromkeys(factors, tape.one)
    split = {i: _factors(node) for i, node in factors.items()}
    common = None
    for _, counted in split.values():
        common = Counter(counted) if common is None else common & counted
    result = {}
    for i, (sign, counted) in split.items():
        rest = counted - (common or Counter())
        value = sign
        for node in sorted(rest.elements(), key=lambda n: n.index):
            value = value * node
        result[i] = value
    if all(value.value is not None for value in result.values()):  # a constant direction: unit length
        size = tape.sqrt(_sum(tape, (value * value for value in result.values())))
        return {i: value / size for i, value in result.items()}
    return result


def _factors(node: Node) -> tuple[Node, Counter[Node]]:
    """(constant, factors that are not) of a product."""
    constant, counted = node.tape.one, Counter[Node]()
    stack = [node]
    while stack:
        current = stack.pop()
        if current.value is not None:
            constant = constant * current
        elif current.op == "neg":
            constant = -constant
            stack.append(current.args[0])
        elif current.op == "mul":
            stack += current.args
        else:
            counted[current] += 1
    return constant, counted


def volume(tape: Tape, grid: Grid, rank: int) -> Volume:
    """Zero exactly where the rank of the grid falls below `rank`: a determinant, or a sum of squared minors.

    Columns (of a tall grid) that fill a block of as many rows split off as a signed factor.

    Args:
        tape: the tape of the entries.
        grid: rows of entries without units.
        rank: what the rank is in general position.

    Raises:
        TooLargeError: it would take more than `MOST_MINORS` minors, or the squares of more than `MOST_SUMMED`.
    """
    grid = trimmed(tape, grid)
    if not grid or not grid[0] or rank == 0:
        return Volume(tape.one, "signed")
    if len(grid) < len(grid[0]):
        grid = [list(column) for column in zip(*grid, strict=True)]
    if len(grid[0]) > rank:
        return Volume(_squares(tape, grid, rank), "squared")
    value = tape.one
    while grid and grid[0]:
        block = _block(tape, grid)
        if block is None:
            break
        rows, columns = block
        value = value * determinant(tape, [[grid[i][j] for j in columns] for i in rows])
        grid = [[e for j, e in enumerate(row) if j not in columns] for i, row in enumerate(grid) if i not in rows]
    if not grid or not grid[0]:
        return Volume(value, "signed")
    rest = _squares(tape, grid, len(grid[0]))
    if value.value is not None:
        return Volume(value * value * rest, "squared")
    return Volume(value * rest, "mixed")


def _block(tape: Tape, grid: Grid) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """The smallest set of columns that are zero outside as many rows; None if there is none."""
    count = len(grid[0])
    patterns = [frozenset(i for i, row in enumerate(grid) if row[j] is not tape.zero) for j in range(count)]
    # all sets of columns where there are few, else small ones and the whole
    few = count <= MOST_COLUMNS
    sizes = [*range(1, (count if few else SMALL_BLOCK) + 1), *([] if few else [count])]
    for size in sizes:
        for columns in combinations(range(count), size):
            rows = {i for j in columns for i in patterns[j]}
            if len(rows) == size:
                return tuple(sorted(rows)), columns
    return None


def _squares(tape: Tape, grid: Grid, rank: int) -> Node:
    """Sum of the squares of all minors of size `rank`, or the determinant of the Gram matrix if that is shorter."""
    rows, columns = len(grid), len(grid[0])
    count = comb(rows, rank) * comb(columns, rank)
    if rank == columns and count > MOST_SQUARES:
        return determinant(tape, [[_sum(tape, (row[i] * row[j] for row in grid)) for j in range(columns)]
                                  for i in range(columns)])  # fmt: skip
    if count > MOST_SUMMED:
        raise TooLargeError(f"{count} minors of size {rank}")
    total = tape.zero
    for i in combinations(range(rows), rank):
        for j in combinations(range(columns), rank):
            minor = determinant(tape, [[grid[a][b] for b in j] for a in i])
            total = total + minor * minor
    return total


def determinant(tape: Tape, grid: Grid) -> Node:
    """The determinant without divisions: Laplace by rows, sparse ones first, every minor once.

    Raises:
        TooLargeError: more than `MOST_MINORS` minors.
    """
    count = len(grid)
    order = sorted(range(count), key=lambda i: -sum(e is not tape.zero for e in grid[i]))
    known: dict[frozenset[int], Node] = {frozenset(): tape.one}

    def minor(columns: frozenset[int]) -> Node:
        """Of the last rows of `order` and the given columns."""
        if columns not in known:
            if len(known) > MOST_MINORS:
                raise TooLargeError(f"more than {MOST_MINORS} minors")
            row = grid[order[count - len(columns)]]
            total = tape.zero
            for place, j in enumerate(sorted(columns)):
                if row[j] is not tape.zero:
                    term = row[j] * minor(columns - {j})
                    total = total - term if place % 2 else total + term
            known[columns] = total
        return known[columns]

    value = minor(frozenset(range(count)))
    odd = sum(1 for a, b in combinations(order, 2) if a > b) % 2
    return -value if odd else value


def _sum(tape: Tape, terms: Iterable[Node]) -> Node:
    total = tape.zero
    for term in terms:
        total = total + term
    return total


def vanishes(tape: Tape, node: Node) -> bool:
    """Whether a node without unit is zero at all samples."""
    return float(np.abs(tape.sample(node)).max()) < NEGLIGIBLE


def zeroed(tape: Tape, grid: Grid) -> Grid:
    """The grid with entries that vanish at all samples set to 0."""
    return [[tape.zero if vanishes(tape, e) else e for e in row] for row in grid]


def trimmed(tape: Tape, grid: Grid) -> Grid:
    """The grid without rows and columns that vanish at all samples or are a constant multiple of another there."""
    for _ in range(2):  # rows, then columns
        grid = [list(column) for column in zip(*_distinct(tape, zeroed(tape, grid)), strict=True)]
    return grid


def _distinct(tape: Tape, grid: Grid) -> Grid:
    """The rows that do not vanish and are no constant multiple of an earlier one."""
    kept: list[tuple[np.ndarray, list[Node]]] = []
    if not grid or not grid[0]:
        return []
    for row, values in zip(grid, np.moveaxis(sampled(tape, grid), 1, 0), strict=True):
        size = float(np.linalg.norm(values))
        if size == 0.0:
            continue
        unit = values.ravel() / size
        if all(_apart(unit, other) for other, _ in kept):
            kept.append((unit, row))
    return [row for _, row in kept]


def _apart(unit: np.ndarray, other: np.ndarray) -> bool:
    return min(float(np.abs(unit - other).max()), float(np.abs(unit + other).max())) > NEGLIGIBLE


def sampled(tape: Tape, grid: Grid) -> np.ndarray:
    """Values of a grid of nodes at the sample states of the tape, shape (samples, rows, columns)."""
    values = [[np.atleast_1d(tape.sample(e)) for e in row] for row in grid]
    count = max((len(v) for row in values for v in row), default=1)
    return np.array([[[v[k % len(v)] for v in row] for row in values] for k in range(count)])


def rank_of(tape: Tape, grid: Grid) -> int:
    """The rank in general position: the largest over the samples."""
    return max(int(np.linalg.matrix_rank(values, tol=NEGLIGIBLE)) for values in sampled(tape, grid))


def most_independent(matrix: np.ndarray) -> list[int]:
    """As many rows of a matrix as it has columns, in order: one after the other the farthest from those before."""
    left, chosen = np.array(matrix), list[int]()
    for _ in range(matrix.shape[1]):
        sizes = np.linalg.norm(left, axis=1)
        sizes[chosen] = -1.0
        chosen.append(int(sizes.argmax()))
        direction = left[chosen[-1]] / (sizes.max() or 1.0)
        left = left - np.outer(left @ direction, direction)
    return sorted(chosen)
