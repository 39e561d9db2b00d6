"""Branches where the loops leave one equation, f(u) = 0: told by the rank of its quadratic form, not by samples.

    rank 3 and more, indefinite   f does not factor: one branch, a cone
    rank 2, indefinite            f = x y + h(z) in suitable coordinates (splitting lemma): two branches that cross, of
                                  tangent spaces x = 0 and y = 0, where h vanishes; else f does not factor

Whether h vanishes is seen at points z near the configuration, as far as doubles tell. Other cases are left to samples.
M. Golubitsky, D. Schaeffer, Singularities and groups in bifurcation theory I, 1985, chapter II.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from symscrew.mobility.finite import ReducedClosure

Array = np.ndarray[Any, Any]

ALONE = 1e-8
"""Forms of all self-stresses are multiples of one: relative singular value of the others, which are rounding."""
FLAT, BENT = 1e-9, 1e-4
"""Relative eigenvalues below the first are zero, above the second are not; between them nothing is told."""
TRIES = 4
"""Random directions z at which h is looked at."""
DISTANCES = (1e-2, 2e-3)
"""Of these points, in units of the mechanism's size: half and a tenth of the sphere on which zeros are looked for. The
nearer ones where other singular places are so close that Newton's method does not get there."""
VANISHES, STAYS = 1e-9, 1e-7
"""|h| over the form's size times the square of the distance: a cubic term leaves 1e-2 to 1e-3, one of fourth order 1e-4
to 1e-6. Between the two nothing is told."""
ROUNDING = 1e-15
"""What doubles leave of h where it is zero, in units of the mechanism's size; ten times as much is told from it."""
DIFFERENCE = 1e-5
"""Half the step of differences of the gradient."""
ENDED = 1e-9
"""The last of Newton's steps: h is then right to the square of it."""
STEPS = 8
"""Of Newton's method with the Hessian at the configuration: each gains a factor of the distance."""
SEED = 20230811
"""Of the random directions: always the same, so that results repeat."""


def sheets_of_one_equation(reduced: ReducedClosure, forms: Array) -> Array | None:
    """Unit normals of the tangent spaces of the two branches as rows; no rows: one branch; None: not told."""
    dof = reduced.here.dof
    if dof < 3 or not len(forms):
        return None
    u, s, _ = np.linalg.svd(forms.reshape(len(forms), -1))
    if not s[0] > 0 or (len(s) > 1 and s[1] > ALONE * s[0]):
        return None
    form = np.tensordot(u[:, 0], forms, axes=1)
    values, vectors = np.linalg.eigh(form)
    relative = np.abs(values) / np.abs(values).max()
    bent = relative > BENT
    if (relative[~bent] > FLAT).any() or bent.sum() < 2 or values[bent].min() * values[bent].max() > 0:
        return None
    if bent.sum() > 2:
        return np.zeros((0, dof))
    parts = (u[:, 0], vectors[:, bent], vectors[:, ~bent])
    told = (_splits(reduced, parts, far) for far in DISTANCES)
    split = next((answer for answer in told if answer is not None), None)
    if split is None:
        return None
    if not split:
        return np.zeros((0, dof))
    ends = vectors[:, bent].T * np.sqrt(np.abs(values[bent]))[:, None]
    normals = np.array([ends[0] + ends[1], ends[0] - ends[1]])
    return np.asarray(normals / np.linalg.norm(normals, axis=1)[:, None])


def _splits(reduced: ReducedClosure, parts: tuple[Array, Array, Array], far: float) -> bool | None:
    """Whether h, what is left of f where its gradient across vanishes, is zero; None where that is not told.

    `parts`: weights of the equations in f, unit vectors across, where the form is not zero, and along it as columns.
    """
    weights, across, along = parts

    def at(points: Array) -> tuple[Array, Array, bool]:
        values = reduced.evaluate(points)
        slopes = np.einsum("k,nkj,ji->ni", weights, values.derivative, across)
        return values.g @ weights, slopes, bool(values.solved.all())

    steps = DIFFERENCE * across.T
    _, slopes, solved = at(np.concatenate([steps, -steps]))
    hessian = (slopes[:2] - slopes[2:]) / (2 * DIFFERENCE)
    random = np.random.default_rng(SEED).normal(size=(TRIES, along.shape[1]))
    points = far * (random / np.linalg.norm(random, axis=1)[:, None]) @ along.T
    for _ in range(STEPS):
        if not solved:
            return None
        _, slopes, solved = at(points)
        step = np.linalg.solve(hessian, slopes.T).T
        if np.linalg.norm(step, axis=1).max() > far:
            return None
        points = points - step @ across.T
    left, _, solved = at(points)
    if not solved or np.linalg.norm(step, axis=1).max() > ENDED:
        return None
    most, size = float(np.abs(left).max()), float(np.linalg.norm(hessian)) * far**2
    if most < max(VANISHES * size, ROUNDING):
        return True
    return False if most > max(STAYS * size, 10 * ROUNDING) else None
