"""Linear least squares of least norm with the same bits on every machine.

    matrix (m, n), right (m,) --> x (n,): of those with the least |matrix x - right| the one with the least |x|

Libraries of linear algebra choose their kernels by the processor, so that last digits differ; states that are
recorded must not. Here Gram-Schmidt with pivoting in plain NumPy sums and products gives the equations an orthonormal
form, from which the solution is read; where they depend on each other, the columns first, which leaves as many
equations as the rank.
"""

from __future__ import annotations

import numpy as np


def least_norm(matrix: np.ndarray, right: np.ndarray, *, rank: float = 1e-9) -> np.ndarray:
    """The shortest x (n,) of those that minimise |matrix x - right|, for a matrix (m, n) and (m,).

    Directions whose remainder is below `rank` times the largest column or row count as dependent: 1e-9 is as far from
    rounding (1e-16) as from what is meant (1e-3 and more).

    >>> least_norm(np.array([[1.0, 1.0], [2.0, 2.0]]), np.array([1.0, 2.0])).round(12).tolist()
    [0.5, 0.5]
    """
    rows, values = _orthonormal(matrix, right, rank)
    if len(rows) < len(matrix):  # dependent equations, which may contradict each other
        columns, _ = _orthonormal(matrix.T, np.zeros(matrix.shape[1]), rank)
        reduced = [(direction[:, None] * matrix).sum(axis=0) for direction in columns]
        known = np.array([(direction * right).sum() for direction in columns])
        rows, values = _orthonormal(np.array(reduced).reshape(len(reduced), matrix.shape[1]), known, rank)
    found: np.ndarray = (rows * values[:, None]).sum(axis=0)
    return found


def _orthonormal(rows: np.ndarray, values: np.ndarray, rank: float) -> tuple[np.ndarray, np.ndarray]:
    """Equations rows . x = values as equations with orthonormal rows, the largest remainder first."""
    rows, values = np.array(rows, dtype=float), np.array(values, dtype=float)
    basis, right = np.zeros((min(rows.shape), rows.shape[1])), np.zeros(min(rows.shape))
    largest = 0.0
    for count in range(len(right)):
        sizes = (rows * rows).sum(axis=1)
        chosen = int(np.argmax(sizes))
        largest = max(largest, float(sizes[chosen]))
        if not sizes[chosen] > rank**2 * largest:
            return basis[:count], right[:count]
        row, value = rows[chosen].copy(), values[chosen]
        overlap = (basis[:count] * row).sum(axis=1)  # rounding has left parts along the earlier ones
        row, value = row - (overlap[:, None] * basis[:count]).sum(axis=0), value - (overlap * right[:count]).sum()
        size = np.sqrt((row * row).sum())
        basis[count], right[count] = row / size, value / size
        amounts = (rows * basis[count]).sum(axis=1)
        rows -= amounts[:, None] * basis[count]
        values -= amounts * right[count]
    return basis, right
