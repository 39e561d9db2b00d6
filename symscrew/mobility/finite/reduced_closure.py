"""The reduced closure g(u) = 0 around a configuration, for many points at once (Lyapunov-Schmidt).

    g(u) = stresses . f(q(u)),   q(u) = q0 + kernel u + dependent w(u),   range_rows . f = 0 defines w(u)

q = q0 + kernel u + dependent w. All equations but the redundant ones are solved for w(u); the components on the
self-stresses that remain are g(u). Zeros of g are the configurations that the mechanism really reaches.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from symscrew.mobility.finite.local_solutions import Local
from symscrew.mobility.finite.variety import Array, ClosureVariety

STEPS = 80
"""Steps of Levenberg-Marquardt: a simple zero takes about ten, one at which g vanishes to third order gains a factor of
two or three a step. What has not arrived by then is no zero (`is_zero`), so that fewer zeros are found."""
SOLVES = 9
"""Steps of Newton's method for the dependent coordinates; quadratic from points on a sphere, so five do. Points at
which it does not end are left out (`Values.solved`)."""
SOLVED = 1e-12
"""Its last step: rounding of double precision times the condition of the equations that are not redundant."""
NEGLIGIBLE = 4e-16
"""|g| below this is rounding, whatever the size of g at other points."""
ON_SPHERE = 1e-6
"""A zero lies on the sphere if its radius is right to this part: the equation of the sphere is solved to 1e-11."""
DAMPING = 1e7
"""Where Levenberg-Marquardt's damping has grown beyond this, from 1e-3 by factors of five, no step helps: a local
minimum that is no zero."""


@dataclass(frozen=True)
class Values:
    """g, its derivative and the displacement q at each u, and that of q; `solved` where the other equations are."""

    u: Array
    q: Array
    g: Array
    derivative: Array
    slope: Array
    solved: Array

    def at(self, index: Array) -> Values:
        """The values at some of the points."""
        return Values(*(getattr(self, name)[index] for name in VALUES))


VALUES = tuple(field.name for field in fields(Values))


class ReducedClosure:
    """g(u) and its derivative in double precision."""

    def __init__(self, variety: ClosureVariety, here: Local) -> None:
        self.variety, self.here = variety, here

    def evaluate(self, u: Array, guess: Array | None = None) -> Values:
        """g at the points u, N x dof; `guess` are displacements near the solution.

        Newton's last step is taken to first order: its square is far below rounding, and so is what it does to slopes.
        """
        here = self.here
        q = here.q + u @ here.kernel.T
        if guess is not None:
            q = q + (guess - here.q) @ here.dependent @ here.dependent.T
        size = np.linalg.norm(u, axis=1)
        solved = np.zeros(len(u), dtype=bool)
        for _ in range(SOLVES):
            residuals, jacobians = self.variety.evaluate(q)
            square = here.range_rows @ jacobians @ here.dependent
            step = _solve(square, residuals @ here.range_rows.T)
            norm = np.linalg.norm(step, axis=1)
            usable = np.isfinite(norm) & (norm < 2 * size + SOLVED)
            last = np.where(usable[:, None], step, 0.0) @ here.dependent.T
            q = q - last
            solved = usable & (norm < SOLVED)
            if (solved | ~usable).all():
                break
        residuals = residuals - (jacobians @ last[..., None])[..., 0]
        left = here.range_rows @ jacobians
        change = -_solve_matrix(left @ here.dependent, left @ here.kernel)
        full = here.kernel + here.dependent @ change
        return Values(u, q, residuals @ here.stresses.T, here.stresses @ jacobians @ full, full, solved)

    def zeros_on_sphere(self, u: Array, radius: float, scale: float, *, guess: Array | None = None) -> Values:
        """Where Levenberg-Marquardt ends from each start u on the sphere |u| = radius; see `is_zero`.

        `scale`: the size of g at random points of the sphere.
        """
        now = self.evaluate(u, guess)
        damping = np.full(len(u), 1e-3)
        enough = max(1e-11, 2e-16 / scale) ** 2
        for _ in range(STEPS):
            error, gradient = _equations(now, radius, scale)
            square = np.where(now.solved, (error * error).sum(axis=1), np.inf)
            active = np.flatnonzero((square > enough) & (damping < DAMPING) & now.solved)
            if not len(active):
                break
            step = _damped_step(gradient[active], error[active], damping[active])
            ahead = (now.slope[active] @ step[..., None])[..., 0]
            trial = self.evaluate(now.u[active] - radius * step, now.q[active] - radius * ahead)
            trial_error, _ = _equations(trial, radius, scale)
            trial_square = np.where(trial.solved, (trial_error * trial_error).sum(axis=1), np.inf)
            better = trial_square < square[active]
            now = _replaced(now, active[better], trial, better)
            damping[active[better]] /= 5
            damping[active[~better]] *= 5
        return now


def is_zero(values: Values, radius: float, scale: float, tolerance: float = 1e-9) -> Array:
    """Which points are zeros of g on the sphere; `scale` is the size of g at random points of the sphere."""
    small = np.abs(values.g).max(axis=1) < max(tolerance * scale, NEGLIGIBLE)
    on_sphere = np.abs(np.linalg.norm(values.u, axis=1) - radius) < ON_SPHERE * radius
    return np.flatnonzero(small & on_sphere & values.solved)


def _equations(values: Values, radius: float, scale: float) -> tuple[Array, Array]:
    """g relative to its size and |u| / radius - 1, with their derivatives by u / radius."""
    norm = np.maximum(np.linalg.norm(values.u, axis=1), 1e-300)
    error = np.concatenate([values.g / scale, (norm / radius - 1)[:, None]], axis=1)
    outwards = (values.u / norm[:, None])[:, None, :]
    return error, np.concatenate([values.derivative * (radius / scale), outwards], axis=1)


def _damped_step(gradient: Array, error: Array, damping: Array) -> Array:
    normal = np.swapaxes(gradient, 1, 2) @ gradient
    diagonal = np.arange(normal.shape[1])
    size = np.linalg.norm(error, axis=1)
    normal[:, diagonal, diagonal] += np.maximum(damping * size, 1e-13)[:, None]
    return _solve(normal, (np.swapaxes(gradient, 1, 2) @ error[..., None])[..., 0])


def _replaced(values: Values, index: Array, other: Values, chosen: Array) -> Values:
    arrays = []
    for name in VALUES:
        array = getattr(values, name).copy()
        array[index] = getattr(other, name)[chosen]
        arrays.append(array)
    return Values(*arrays)


def _solve(matrices: Array, vectors: Array) -> Array:
    return _solve_matrix(matrices, vectors[..., None])[..., 0]


def _solve_matrix(matrices: Array, right: Array) -> Array:
    try:
        return np.asarray(np.linalg.solve(matrices, right))
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.pinv(matrices) @ right)
