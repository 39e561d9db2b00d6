"""Drives from the equations that remain at the hub: unique, or distributed by smallest weighted squares."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from symscrew.algebra import Affine, Column, Guard, Node, Tape, eliminate, magnitude, named, named_entries
from symscrew.dynamics.setting import ONE


@dataclass(frozen=True)
class DriveSolution:
    """Drives u (one node each), the guarded pivots, and how many more drives than equations there are."""

    u: tuple[Node, ...]
    guards: tuple[Guard, ...]
    redundancy: int
    unreachable: int  # equations that no drive can serve: passive freedoms


def solve_drives(
    tape: Tape,
    finals: Sequence[Affine],
    scales: Mapping[int, float],
    *,
    weights: Sequence[Node] | None = None,
    preload: Sequence[Node] | None = None,
    several: bool = False,
) -> DriveSolution:
    """u from finals: sum of entries = 0.

    As many independent equations as drives: the unique solution. Fewer: the u that minimises
    sum w_j (u_j - preload_j)^2 (weights 1, preload 0 by default), which leaves of the preload exactly its
    internal part: u = preload + W^-1 A^T (A W^-1 A^T)^-1 (b - A preload).
    """
    columns = {("drive", j): s for j, s in scales.items()}
    rows = [{c: e for c, e in final.items() if c in columns} for final in finals]
    right = [-final.get(ONE, tape.zero) for final in finals]
    row_scales = [_row_scale(row, columns) for row in rows]
    elimination = eliminate(tape, rows, columns, row_scales)
    independent = sorted(row for row, *_ in elimination.steps)
    if len(independent) == len(columns):
        solution = elimination.solve(right)
        u = tuple(solution.get(("drive", j), tape.zero) for j in scales)
        return DriveSolution(u, tuple(elimination.guards), 0, len(rows) - len(independent))
    matrix = [[rows[i].get(("drive", j), tape.zero) for j in scales] for i in independent]
    target = [right[i] for i in independent]
    if preload is not None:
        target = [
            t - _sum(tape, (a * p for a, p in zip(row, preload, strict=True)))
            for t, row in zip(target, matrix, strict=True)
        ]
    inverse_weights = [1 / w for w in weights] if weights is not None else [tape.one] * len(columns)
    scaled = [[a * w for a, w in zip(row, inverse_weights, strict=True)] for row in matrix]
    normal = [[_sum(tape, (x * y for x, y in zip(s, row, strict=True))) for row in matrix] for s in scaled]
    for i, row in enumerate(normal):
        named_entries(row, "share", [f"drives.{i}_{j}" for j in range(len(row))])
    sizes = [row_scales[i] * row_scales[i] for i in independent]
    multipliers, guards = solve_symmetric(tape, normal, target, sizes, at_once=not several)
    u = tuple(
        _sum(tape, (scaled[i][j] * multipliers[i] for i in range(len(matrix))))
        + (preload[j] if preload is not None else tape.zero)
        for j in range(len(columns))
    )
    return DriveSolution(u, guards, len(columns) - len(independent), len(rows) - len(independent))


def solve_symmetric(
    tape: Tape,
    matrix: Sequence[Sequence[Node]],
    right: Sequence[Node],
    scales: Sequence[float],
    *,
    at_once: bool = False,
) -> tuple[list[Node], tuple[Guard, ...]]:
    """x from a symmetric positive definite matrix by L D L^T; `scales` are the unit scales of the diagonal.

    Two unknowns `at_once`, by their determinant: one division for two of which one would wait for the other. That is
    not stable backwards: not for mass matrices, which are much larger along some motions than along others.
    """
    n = len(matrix)
    if at_once and n == 2 and matrix[1][0] is not tape.zero:
        (a, _), (b, c) = matrix
        determinant = named(a * c - b * b, "determinant")
        over = 1 / determinant
        guarded = () if determinant.value is not None else (Guard(determinant, scales[0] * scales[1]),)
        return [(c * right[0] - b * right[1]) * over, (a * right[1] - b * right[0]) * over], guarded
    lower: list[list[Node]] = [[tape.zero] * n for _ in range(n)]
    filled: list[list[int]] = [[] for _ in range(n)]  # places of a row of `lower` that are not zero
    diagonal: list[Node] = []
    guards: list[Guard] = []
    for j in range(n):
        d = matrix[j][j] - _sum(tape, (lower[j][k] * (lower[j][k] * diagonal[k]) for k in filled[j]))
        named(d, "pivot", component=str(j))
        diagonal.append(d)
        if d.value is None:
            guards.append(Guard(d, scales[j]))
        for i in range(j + 1, n):
            common = (k for k in filled[i] if lower[j][k] is not tape.zero)
            entry = matrix[i][j] - _sum(tape, (lower[i][k] * (lower[j][k] * diagonal[k]) for k in common))
            lower[i][j] = entry * (1 / d)
            if lower[i][j] is not tape.zero:
                filled[i].append(j)
    forward: list[Node] = []
    for i in range(n):
        forward.append(right[i] - _sum(tape, (lower[i][k] * forward[k] for k in range(i))))
    x: list[Node] = [tape.zero] * n
    for i in reversed(range(n)):
        x[i] = forward[i] * (1 / diagonal[i]) - _sum(tape, (lower[k][i] * x[k] for k in range(i + 1, n)))
    return x, tuple(guards)


def _sum(tape: Tape, terms: Iterable[Node]) -> Node:
    total = tape.zero
    for term in terms:
        total = total + term
    return total


def _row_scale(row: Affine, columns: Mapping[Column, float]) -> float:
    """The unit scale that makes the row's largest sampled entry about 1."""
    largest = 0.0
    for column, entry in row.items():
        largest = max(largest, magnitude(entry.tape, entry, columns[column])[1])
    return 1.0 / largest if largest > 0 else 1.0
