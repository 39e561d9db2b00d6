"""Directions of the second-order tangent cone: where all quadratic forms of the self-stresses vanish.

A component of the cone whose directions form a space of dimension k meets a generic linear space of codimension k
in isolated directions. So the quadrics are solved on random linear spaces of every codimension, from a number of
starts that grows with the dimension, always the same ones; polynomials of degree two cost next to nothing.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from symscrew.mobility.finite.variety import Array

STARTS_PER_DIMENSION = 24
"""Random starts on a linear space, times its dimension. A space of dimension d meets d - 1 or more quadrics in up to
2^(d - 1) lines; of those the starts find most, and neighbours of the others stand in for them."""
STEPS = 60
"""Steps of Levenberg-Marquardt: simple zeros take ten, double ones a factor of two a step."""
ZERO = 1e-10
"""A direction in which all unit forms are below this is in the cone."""
PER_KIND = 10
"""Directions of every rank of the derivative that become starts, as far apart as possible."""
RANK = 1e-6
"""Singular values of the derivative below this are zero: where the directions are known to 1e-10, a double one to half
the digits."""
APART = 1e-3
"""Unit directions that are closer together than this are one."""


def cone_directions(forms: Array, generator: np.random.Generator) -> Array:
    """Unit vectors u with u . Q_k . u = 0 for all k, N x d, far apart, some of every rank of the derivative."""
    dof = forms.shape[1]
    used = np.array([form / np.linalg.norm(form) for form in forms if form.any()])
    if not len(used):
        return np.zeros((0, dof))
    found: list[Array] = []
    for codimension in range(dof):
        size = dof - codimension
        basis = np.linalg.qr(generator.normal(size=(dof, dof)))[0][:, :size]
        starts = generator.normal(size=(STARTS_PER_DIMENSION * size, size))
        restricted = np.einsum("ia,kij,jb->kab", basis, used, basis)
        found += list(_solved(restricted, starts) @ basis.T)
    return np.array(list(_spread(np.array(found).reshape(-1, dof), used))).reshape(-1, dof)


def _solved(forms: Array, starts: Array) -> Array:
    """Where Levenberg-Marquardt on the unit sphere arrives at zeros."""
    u = starts / np.linalg.norm(starts, axis=1)[:, None]
    damping = np.full(len(u), 1e-2)
    values, rows = _at(forms, u)
    for _ in range(STEPS):
        normal = np.swapaxes(rows, 1, 2) @ rows
        size = np.linalg.norm(values, axis=1)
        normal[:, range(u.shape[1]), range(u.shape[1])] += np.maximum(damping * size, 1e-13)[:, None]
        step = np.linalg.solve(normal, (np.swapaxes(rows, 1, 2) @ values[..., None]))[..., 0]
        trial = u - step
        trial /= np.linalg.norm(trial, axis=1)[:, None]
        trial_values, trial_rows = _at(forms, trial)
        better = np.linalg.norm(trial_values, axis=1) < size
        u = np.where(better[:, None], trial, u)
        values = np.where(better[:, None], trial_values, values)
        rows = np.where(better[:, None, None], trial_rows, rows)
        damping = np.clip(np.where(better, damping / 5, damping * 5), 1e-8, 1e8)
    solutions: Array = u[np.linalg.norm(values[:, :-1], axis=1) < ZERO]
    return solutions


def _at(forms: Array, u: Array) -> tuple[Array, Array]:
    """(values of the forms and of the sphere, their derivatives) at the points."""
    images = np.einsum("kij,nj->nki", forms, u)
    values = np.einsum("nki,ni->nk", images, u)
    sphere = ((u * u).sum(axis=1) - 1) / 2
    return np.concatenate([values, sphere[:, None]], axis=1), np.concatenate([2 * images, u[:, None, :]], axis=1)


def _spread(u: Array, forms: Array) -> Iterator[Array]:
    """For every rank of the derivative some directions that are far apart, each with its opposite."""
    if not len(u):
        return
    values = np.linalg.svd(2 * np.einsum("kij,nj->nki", forms, u), compute_uv=False)
    ranks = (values > RANK).sum(axis=1)
    for rank in np.unique(ranks):
        members = u[ranks == rank]
        chosen = [members[0]]
        distance = _apart(members, chosen[0])
        while len(chosen) < PER_KIND and distance.max() > APART:
            chosen.append(members[int(distance.argmax())])
            distance = np.minimum(distance, _apart(members, chosen[-1]))
        for direction in chosen:
            yield direction
            yield -direction


def _apart(members: Array, direction: Array) -> Array:
    """Distance of unit vectors up to sign."""
    result: Array = np.minimum(np.linalg.norm(members - direction, axis=1), np.linalg.norm(members + direction, axis=1))
    return result
