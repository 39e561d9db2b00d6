"""Closure as linear and quadratic forms in the dual quaternion g of one body against another, for any scalars.

    g = x + eps y in Study's parameters, up to a factor: a point p goes to (x p x* + 2 y x*) / |x|^2, y = t x / 2
    distance        |image of p - a|^2 = L^2    one quadratic form, linear in  c = |p|^2 + |a|^2 - L^2
    meeting points  image of p = a              four linear forms of rank three: x p + 2 y - a x = 0
    angle           image of w times u = k      one quadratic form
    parallel axes   image of w = u              four linear forms: x w - u x = 0
    crossing lines  image of w at p meets u     one quadratic form: their mutual moment; lines go to g (w + eps m) g*
    coupled motions sum of angles, or ways, of a product of turns, or slides, about one axis = what is known: linear
    motions         of a joint: linear in its homogeneous coordinates, a matrix of eight rows

The same matrices serve doubles, complex numbers, intervals and residues: entries are sums of products of what comes in.
E. Study, Geometrie der Dynamen, 1903; M. Husty, H.-P. Schroecker, Algebraic geometry and kinematics, 2010.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

Array = np.ndarray[Any, Any]
Vector = Sequence[Any]

SIZE = 8
"""Study's parameters."""
CONJUGATE = np.array([1, -1, -1, -1, 1, -1, -1, -1])
"""Signs of the inverse displacement."""


def _hamilton() -> Array:
    """(a b)_k = sum of H[k, i, j] a_i b_j of quaternions."""
    table = np.zeros((4, 4, 4), dtype=int)
    for i, j, k, sign in (
        (0, 0, 0, 1), (1, 1, 0, -1), (2, 2, 0, -1), (3, 3, 0, -1),
        (0, 1, 1, 1), (1, 0, 1, 1), (2, 3, 1, 1), (3, 2, 1, -1),
        (0, 2, 2, 1), (2, 0, 2, 1), (3, 1, 2, 1), (1, 3, 2, -1),
        (0, 3, 3, 1), (3, 0, 3, 1), (1, 2, 3, 1), (2, 1, 3, -1),
    ):  # fmt: skip
        table[k, i, j] = sign
    return table


HAMILTON = _hamilton()
LEFT = np.stack([HAMILTON[:, k, :] for k in range(1, 4)])
"""Of the units i, j, k: the matrix of multiplication from the left."""
RIGHT = np.stack([HAMILTON[:, :, k] for k in range(1, 4)])
"""The same from the right."""


def _dual() -> Array:
    table = np.zeros((SIZE, SIZE, SIZE), dtype=int)
    table[:4, :4, :4] = HAMILTON
    table[4:, :4, 4:] = HAMILTON
    table[4:, 4:, :4] = HAMILTON
    return table


PRODUCT = _dual()
"""(a b)_k = sum of PRODUCT[k, i, j] a_i b_j of dual quaternions."""


def _turned() -> Array:
    """M[k, l]: twice the symmetric matrix of component k of x e_l x*."""
    table = np.zeros((3, 3, SIZE, SIZE), dtype=int)
    sign = CONJUGATE[:4]
    for k in range(3):
        for l in range(3):
            form = np.einsum("in,im,n->mn", HAMILTON[k + 1], RIGHT[l], sign)
            table[k, l, :4, :4] = form + form.T
    return table


def _moved(*, back: bool) -> Array:
    """T[k]: twice the symmetric matrix of component k of 2 y x*, or of 2 x* y."""
    table = np.zeros((3, SIZE, SIZE), dtype=int)
    sign = CONJUGATE[:4]
    for k in range(3):
        for x in range(4):
            for y in range(4):
                value = HAMILTON[k + 1, x, y] * sign[x] if back else HAMILTON[k + 1, y, x] * sign[x]
                table[k, x, 4 + y] = table[k, 4 + y, x] = 2 * value
    return table


def _lines() -> Array:
    """L[k, l]: twice the symmetric matrix of component k of y e_l x* + x e_l y*."""
    table = np.zeros((3, 3, SIZE, SIZE), dtype=int)
    sign = CONJUGATE[:4]
    for k in range(3):
        for l in range(3):
            form = np.einsum("in,im,n->mn", HAMILTON[k + 1], RIGHT[l], sign)
            table[k, l, 4:, :4] = form + form.T
            table[k, l, :4, 4:] = form + form.T
    return table


NORM = 2 * np.diag([1, 1, 1, 1, 0, 0, 0, 0])
"""Twice |x|^2, as all that follow: a form's gradient is its matrix times g, its value half g times that."""
SECOND = 2 * np.diag([0, 0, 0, 0, 1, 1, 1, 1])
STUDY = np.block([[np.zeros((4, 4), dtype=int), np.eye(4, dtype=int)], [np.eye(4, dtype=int), np.zeros((4, 4), int)]])
TURNED, MOVED, MOVED_BACK, LINES = _turned(), _moved(back=False), _moved(back=True), _lines()


def _add(form: Array, table: Array, factor: Any) -> None:
    """Add a table of integers, of which most are 0, times a scalar that may be dear."""
    for place in zip(*np.nonzero(table), strict=True):
        form[place] = form[place] + factor * int(table[place])


def distance(p: Vector, a: Vector, c: Any) -> Array:
    """|x|^2 c + 4 |y|^2 + 2 p t' - 2 a t - 2 a M p, t = 2 y x*, t' = 2 x* y, M p = x p x*; twice its matrix."""
    form: Array = 4 * SECOND.astype(object)
    _add(form, NORM, c)
    for k in range(3):
        _add(form, MOVED_BACK[k], 2 * p[k])
        _add(form, -MOVED[k], 2 * a[k])
        for l in range(3):
            _add(form, -TURNED[k, l], 2 * (a[k] * p[l]))
    return form


def angle(w: Vector, u: Vector, k: Any) -> Array:
    """u M w - k |x|^2; twice its matrix."""
    form: Array = np.zeros((SIZE, SIZE), dtype=object)
    _add(form, NORM, -k)
    for i in range(3):
        for j in range(3):
            _add(form, TURNED[i, j], u[i] * w[j])
    return form


def crossing(w: Vector, p: Vector, u: Vector, a: Vector) -> Array:
    """u m' + (a x u) w' of the lines w through p, displaced, and u through a; twice its matrix."""
    m, n = _moment(p, w), _moment(a, u)
    form: Array = np.zeros((SIZE, SIZE), dtype=object)
    for k in range(3):
        for l in range(3):
            _add(form, LINES[k, l], u[k] * w[l])
            _add(form, TURNED[k, l], u[k] * m[l] + n[k] * w[l])
    return form


def _moment(p: Vector, w: Vector) -> Vector:
    return (p[1] * w[2] - p[2] * w[1], p[2] * w[0] - p[0] * w[2], p[0] * w[1] - p[1] * w[0])


def meeting(p: Vector, a: Vector) -> Array:
    """The rows of x p + 2 y - a x."""
    return np.concatenate([axes(p, a), 2 * np.eye(4, dtype=int).astype(object)], axis=1)


def axes(w: Vector, u: Vector) -> Array:
    """The columns for x of x w - u x."""
    block = np.zeros((4, 4), dtype=object)
    for k in range(3):
        block = block + RIGHT[k].astype(object) * w[k] - LEFT[k].astype(object) * u[k]
    return block


def parallel(w: Vector, u: Vector) -> Array:
    """The rows of x w - u x."""
    return np.concatenate([axes(w, u), np.zeros((4, 4), dtype=object)], axis=1)


def turning(w: Vector, p: Vector) -> Array:
    """u + v (w + eps p x w), columns for u, v: tangent of half the angle is v |w| / u."""
    basis = np.zeros((SIZE, 2), dtype=object)
    basis[0, 0] = 1
    basis[1:4, 1], basis[5:8, 1] = list(w), list(_moment(p, w))
    return basis


def sliding(v: Vector) -> Array:
    """1 + eps v d / 2, columns for the denominator and d."""
    basis = np.zeros((SIZE, 2), dtype=object)
    basis[0, 0] = 2
    basis[5:8, 1] = list(v)
    return basis


def rolling(p: Vector) -> Array:
    """x + eps (p x - x p) / 2: rotations about a point; twice."""
    block = np.zeros((4, 4), dtype=object)
    for k in range(3):
        block = block + (LEFT[k] - RIGHT[k]).astype(object) * p[k]
    return np.concatenate([2 * np.eye(4, dtype=int).astype(object), block])


def coupled(known: Vector, *, turning: bool) -> Array:
    """The row  c x_3 - s x_0  of a product of turns by half of whose sum c and s are cosine and sine, or  c y_1 - s x_0
    of slides, s half of their sum and c one."""
    row = np.zeros((1, SIZE), dtype=object)
    row[0, 0], row[0, 3 if turning else 5] = -known[1], known[0]
    return row


def spinning(*, turning: bool, size: int) -> Array:
    """The columns for the coordinates of a turn about the third axis, or of a slide along the first, `size` times."""
    basis = np.zeros((SIZE, 2), dtype=int)
    basis[0, 0], basis[3 if turning else 5, 1] = 1 if turning else 2, size
    return basis


PLANAR = np.zeros((SIZE, 4), dtype=int)
"""Of displacements along the x-y plane: x0, x3, y1, y2."""
PLANAR[[0, 3, 5, 6], range(4)] = 1
