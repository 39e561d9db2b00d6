"""Evidence for ranks: a minor that is not zero, and null vectors over the exact field.

matrix of the checker --full pivoting in doubles, or in 60 digits--> rows and columns of a minor
                      --elimination over the field--> null vectors, one for each column that is left
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from symscrew.mobility.proofs.proof_checker import Number, RefusedError, at_least
from symscrew.mobility.proofs.proof_numbers import ProofNumbers
from symscrew.mobility.screw_systems import eliminate
from symscrew.mobility.symbols import NotDecidableError, null_vectors

CLEAR = 1e-9
"""A pivot in doubles above this, relative to the largest entry, is one; what lies below is looked at in 60 digits."""
Matrix = Sequence[Sequence[Number]]


def rank_entry(numbers: ProofNumbers, matrix: Matrix) -> dict[str, Any]:
    """Bounds of the rank with their evidence; `null` only where columns are left and the field is decidable."""
    rows, columns = _minor(numbers, matrix)
    width = len(matrix[0]) if matrix else 0
    most, entry = min(len(matrix), width), {}
    if len(rows) < most and numbers.system is not None:
        exact = [[numbers.exact(c) for c in row] for row in matrix]
        try:
            vectors = null_vectors([row for row in exact if any(row)], width, numbers.system.field)
        except NotDecidableError:  # the numbers of the elimination grow too long
            vectors = []
        if vectors and len(rows) > width - len(vectors):  # entries that doubles take for numbers are zero
            rows, columns = _minor(numbers, matrix, width - len(vectors))
        if vectors:
            most, entry = width - len(vectors), {"null": [[numbers.json(c) for c in v] for v in vectors]}
    minor = {"rows": rows, "columns": columns}
    return {"rank": [len(rows), most], "minor": minor, **entry}


def _minor(numbers: ProofNumbers, matrix: Matrix, most: int | None = None) -> tuple[list[int], list[int]]:
    """Rows and columns of the largest minor that is shown to be regular."""
    if not matrix or not matrix[0]:
        return [], []
    for places in (_by_doubles, _by_digits):  # 60 digits only where doubles do not tell
        found = places(numbers, matrix)
        if found is None:
            continue
        rows, columns = found
        minor = {"rows": rows[:most], "columns": columns[:most]}
        try:
            at_least(numbers.read.numbers, matrix, minor)
        except RefusedError:
            continue
        return minor["rows"], minor["columns"]
    return [], []


def _by_doubles(numbers: ProofNumbers, matrix: Matrix) -> tuple[list[int], list[int]] | None:
    """Full pivoting; None where a pivot is neither clear nor rounding."""
    values = np.array([[numbers.value(c) for c in row] for row in matrix])
    largest = float(np.abs(values).max(initial=0.0)) or 1.0
    left, rows, columns = values / largest, list[int](), list[int]()
    while len(rows) < min(values.shape):
        i, j = np.unravel_index(int(np.abs(left).argmax()), left.shape)
        pivot = left[i, j]
        if abs(pivot) < CLEAR:
            break
        rows.append(int(i))
        columns.append(int(j))
        left = left - np.outer(left[:, j], left[i]) / pivot
        left[i, :], left[:, j] = 0.0, 0.0
    rounding = np.finfo(float).eps * max(values.shape) * len(rows)
    return (rows, columns) if float(np.abs(left).max(initial=0.0)) <= rounding else None


def _by_digits(numbers: ProofNumbers, matrix: Matrix) -> tuple[list[int], list[int]]:
    """The same with 60 digits: pivot columns, then pivot rows of these columns."""
    values = [[numbers.precise(c) for c in row] for row in matrix]
    columns = list(eliminate(values, len(matrix[0])).pivots)
    turned = [[row[j] for row in values] for j in columns]
    return list(eliminate(turned, len(matrix)).pivots), columns
