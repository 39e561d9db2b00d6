"""Programs and equations of motion in many digits, as the reference of what doubles lose.

A program is walked instruction by instruction in mpmath, at the constants that the generated code has (doubles): what
differs from the code's results is rounding alone. `accelerations` is a second formulation: the dense equations
M a - J^T multipliers = f, J a = -bias solved by singular values, with none of the code's choices of pivots.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np

from symscrew.model import Model
from symscrew.program.rank_revealing import RankRevealing
from symscrew.program.straight_line import Program

MP = mpmath.mp.clone()
MP.dps = 50
OPERATIONS = {
    "add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b, "neg": lambda a: -a,
    "div": lambda a, b: a / b, "reciprocal": lambda a: 1 / a, "sqrt": MP.sqrt, "sin": MP.sin, "cos": MP.cos,
    "tan": MP.tan, "atan2": MP.atan2, "exp": MP.exp, "abs": abs, "less": lambda a, b: MP.mpf(a < b),
    "select": lambda c, a, b: a if c != 0 else b,
}  # fmt: skip


def walked(program: Program, *inputs: Sequence[Any]) -> list[list[Any]]:
    """The outputs of a program at one state, as lists of mpmath numbers; inputs are doubles or mpmath numbers."""
    slots: dict[int, Any] = dict(enumerate(MP.mpf(x) for array in inputs for x in array))

    def value(slot: int | float) -> Any:
        return slots[slot] if isinstance(slot, int) else MP.mpf(slot)

    for instruction in program.instructions:
        slots[instruction.target] = OPERATIONS[instruction.op](*map(value, instruction.args))
    return [[value(slot) for slot in result] for result in program.results]


def doubles(values: Sequence[Any]) -> np.ndarray:
    """The nearest doubles."""
    return np.array([float(x) for x in values])


def closure(found: Model, q: Sequence[Any]) -> tuple[Any, Any]:
    """Residual (m) and Jacobian (m, n) of the closure without units, in many digits."""
    system = found.system
    (residual,) = walked(found.programs["closure"], q)[:1]
    (jacobian,) = walked(found.programs["closure_jacobian"], q)[:1]
    length = MP.mpf(system.length)
    rows = [1 / length if row.unit == "N" else MP.one for cut in system.cuts for row in cut.rows]
    units = [length if c.kind == "length" else MP.one for c in system.tree.v]
    m, n = len(rows), len(units)
    matrix = MP.matrix(m, n)
    for i in range(m):
        for k in range(n):
            matrix[i, k] = jacobian[k * m + i] * rows[i] * units[k]
    return MP.matrix([r * w for r, w in zip(residual, rows, strict=True)]), matrix


def pseudo_inverse(matrix: Any, rank: int | None = None) -> Any:
    """Smallest solution by the `rank` most independent rows; by default those above 1e-25 of the longest.

    Rows that depend on the others are left out, which is the pseudo-inverse where the right side is consistent.
    """
    m, n = matrix.rows, matrix.cols
    left = [[matrix[i, k] for k in range(n)] for i in range(m)]
    basis: list[list[Any]] = []
    chosen: list[int] = []
    longest = MP.zero
    while len(chosen) < min(m, n):
        best = max((i for i in range(m) if i not in chosen), key=lambda i: MP.fdot(left[i], left[i]))
        size = MP.sqrt(MP.fdot(left[best], left[best]))
        longest = max(longest, size)
        if len(chosen) == rank or size <= longest * MP.mpf("1e-25"):
            break
        unit = [x / size for x in left[best]]
        basis.append(unit)
        chosen.append(best)
        for i in range(m):
            if i not in chosen:
                along = MP.fdot(left[i], unit)
                left[i] = [x - along * e for x, e in zip(left[i], unit, strict=True)]
    triangle = MP.matrix(len(chosen), len(chosen))
    for a, i in enumerate(chosen):
        row = [matrix[i, k] for k in range(n)]
        for b in range(len(chosen)):
            triangle[a, b] = MP.fdot(row, basis[b]) if b <= a else MP.zero
    solved = triangle**-1 if chosen else triangle
    result = MP.matrix(n, m)
    for k in range(n):
        for b, i in enumerate(chosen):
            result[k, i] = MP.fsum(basis[a][k] * solved[a, b] for a in range(len(chosen)))
    return result


def singular_values(matrix: Any) -> list[Any]:
    """Descending."""
    return list(MP.svd_r(matrix, compute_uv=False))


def accelerations(found: Model, q: Sequence[Any], v: Sequence[Any], u: Sequence[Any], rank: int | None = None) -> Any:
    """a (n) from the dense equations in many digits, at exactly these inputs."""
    forward = found.programs["forward_dynamics"]
    assert isinstance(forward, RankRevealing) and forward.dense is not None
    mass, force, jacobian, bias = walked(forward.dense, q, v, u)
    n, m = len(force), len(bias)
    rates, rows = [MP.mpf(x) for x in forward.rates], [MP.mpf(x) for x in forward.rows]
    inertia = MP.matrix(n, n)
    closed = MP.matrix(m, n)
    for k in range(n):
        for i in range(n):
            inertia[i, k] = mass[k * n + i] * rates[i] * rates[k]
        for i in range(m):
            closed[i, k] = jacobian[k * m + i] * rows[i] * rates[k]
    inverse = pseudo_inverse(closed, rank)
    particular = -(inverse * MP.matrix([b * w for b, w in zip(bias, rows, strict=True)]))
    projector = MP.eye(n) - inverse * closed
    load = projector * (MP.matrix([f * r for f, r in zip(force, rates, strict=True)]) - inertia * particular)
    # P M P + (1 - P) is regular where M is on the null space; its inverse gives the null-space accelerations
    regular = projector * inertia * projector + (MP.eye(n) - projector)
    gain = particular + projector * MP.lu_solve(regular, load)
    return [gain[i] * rates[i] for i in range(n)]


def settled(found: Model, q: Sequence[float], rank: int | None = None) -> list[Any]:
    """q of a tree of simple joints moved onto the closure in many digits, by smallest steps."""
    system = found.system
    assert all(link.motion.kind not in "SF" for link in system.tree.links[1:]), "angles and lengths only"
    units = [MP.mpf(system.length) if c.kind == "length" else MP.one for c in system.tree.v]
    at = [MP.mpf(x) for x in q]
    for _ in range(8):
        residual, jacobian = closure(found, at)
        step = pseudo_inverse(jacobian, rank) * residual
        at = [x - d * unit for x, d, unit in zip(at, step, units, strict=True)]
    return at
