"""Singular values and eigenvalues of small matrices, in doubles or in 60 digits: arrays of objects are of 60 digits."""

from __future__ import annotations

from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT

Array = np.ndarray[Any, Any]

NONE = 1e-7
"""Relative singular value of doubles that counts as zero: the points at which systems are taken are known to 1e-12,
and stand a tenth of the mechanism's size away from what is special."""
NONE_OF_60 = 1e-20
"""The same of 60 digits: points are known to 1e-26, and what is meant, such as an axis 1e-12 off, or the square of
that, is nowhere as small on a pose that stands away from what is special."""


def none(values: Array) -> float:
    """What counts as zero in the arithmetic of these values, relative to the largest."""
    return NONE_OF_60 if values.dtype == object else NONE


def svd(matrix: Array, *, full: bool = True) -> tuple[Array, Array, Array]:
    """(U, singular values, V transposed), with all columns of U and all rows of V transposed, or those with a value."""
    rows, columns = matrix.shape
    if matrix.dtype != object or not matrix.size:
        given = matrix.astype(float) if matrix.size else np.zeros(matrix.shape)
        u, s, vt = np.linalg.svd(given, full_matrices=full)
        return u, s, vt
    high = rows >= columns  # the library wants it so
    tall = CONTEXT.matrix((matrix if high else matrix.T).tolist())
    u, s, vt = (np.array(part.tolist(), dtype=object) for part in CONTEXT.svd_r(tall, full_matrices=full))
    return (u, s[:, 0], vt) if high else (vt.T, s[:, 0], u.T)


def eigenvalues(symmetric: Array) -> Array:
    """Those of a symmetric matrix, ascending."""
    if symmetric.dtype != object:
        return np.asarray(np.linalg.eigvalsh(symmetric))
    if not symmetric.size:
        return np.zeros(0)
    found = CONTEXT.eigsy(CONTEXT.matrix(symmetric.tolist()), eigvals_only=True)
    return np.array(sorted(found), dtype=object)


def norms(rows: Array) -> Array:
    """The length of every row."""
    if rows.dtype != object:
        return np.asarray(np.linalg.norm(rows, axis=1))
    return np.array([CONTEXT.sqrt(sum((c * c for c in row), CONTEXT.zero)) for row in rows], dtype=object)


def row_space(rows: Array) -> Array:
    """Orthonormal rows of the row space; each row counts with its own size."""
    sizes = norms(rows)
    rows = rows[sizes > 0] / sizes[sizes > 0][:, None]
    if not len(rows):
        return np.zeros((0, rows.shape[1]))
    _, s, vt = svd(rows, full=False)  # of hundreds of rows of six all columns of U would take minutes
    return np.asarray(vt[s > none(rows) * s[0]])
