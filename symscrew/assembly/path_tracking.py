"""Paths of zeros followed over all of them at once: predictor of fourth order, Newton's method, steps of their own.

    Way, zeros at s = 0 --Runge-Kutta, Newton--> zeros at s = 1, or where a path could not be followed further
    paths that end in a singular point --around s = 1, until they come back--> its mean, and how many paths meet there

A step is taken back where the correction is long: another path may be near. (A. Sommese, C. Wampler, The numerical
solution of systems of polynomials, 2005; winding: A. Morgan, A. Sommese, C. Wampler, 1991.)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations

Array = np.ndarray[Any, Any]
Coefficients = Callable[[Array], Array]

LONGEST = 0.1
"""First and longest step of s in [0, 1]."""
SHORTEST = 1e-2
"""Of the part of the way that may be left: a shorter step ends a path."""
NEARLY = (1e-4, 1e-9)
"""A path that needs more than a step for this part of the way, or less, is left there: it comes to a singular end, or
to an almost singular one, which a second attempt with the shorter part tells."""
CORRECTION = 1e-4
"""Longest first correction, of points of length one; the predictor's error is as long."""
CONVERGED = 1e-11
"""A correction below this ends Newton's method: rounding of regular points is a hundred times smaller."""
NEWTON = 4
"""Corrections of a step; quadratic convergence from `CORRECTION` needs two."""
CRAWL = (1e-3, 60)
"""Near its end, with this part of the way left, a path that gets over half of the rest in so many steps comes to a
singular end; one that needs more is held back by rounding, so that luck takes every other step, and ends there."""
MOST_STEPS = 3000
"""Of a path; those of random platforms take fifty."""
DIFFERENCE = 1e-6
"""Half the step of s for dF/ds: right to nine digits, which the correction makes up for."""


@dataclass(frozen=True)
class Ends:
    """Points where paths ended, how far each came, which came to the end, steps altogether."""

    z: Array
    s: Array
    reached: Array
    steps: int


def solve(slopes: Array, values: Array) -> Array:
    """The steps that slopes N x rows x width map to the values N x rows: of square systems, else least squares."""
    if slopes.shape[1] == slopes.shape[2]:
        try:
            return np.asarray(np.linalg.solve(slopes, values[..., None])[..., 0])
        except np.linalg.LinAlgError:
            pass
    back = np.conj(np.swapaxes(slopes, 1, 2))
    if slopes.shape[1] >= slopes.shape[2]:
        square = back @ slopes
        ridge = 1e-28 * np.trace(square, axis1=1, axis2=2).real[:, None, None]
        try:
            steps = np.linalg.solve(square + ridge * np.eye(square.shape[1]), back @ values[..., None])
            return np.asarray(steps[..., 0])
        except np.linalg.LinAlgError:  # one of them is singular or no number: the others are solved all the same
            pass
    good = np.asarray(np.isfinite(slopes).all(axis=(1, 2)))
    inverses = np.linalg.pinv(np.where(good[:, None, None], slopes, 0.0))
    return np.where(good[:, None], (inverses @ values[..., None])[..., 0], np.nan)


class Tracker:
    """Follows zeros of a structure's equations."""

    def __init__(self, equations: BatchEquations, correction: float = CORRECTION, nearly: float = NEARLY[0]) -> None:
        self.equations, self.correction, self.nearly = equations, correction, nearly

    def newton(self, z: Array, c: Array) -> Array:
        """The step of Newton's method, across every group."""
        values, slopes = self.equations.evaluate(z, c)
        patches = self.equations.patches(z)
        slopes = np.concatenate([slopes, patches], axis=1)
        values = np.concatenate([values, np.zeros(patches.shape[:2])], axis=1)
        return solve(slopes, -values)

    def rate(self, z: Array, s: Array, way: Coefficients) -> Array:
        """dz/ds across every group."""
        _, slopes = self.equations.evaluate(z, way(s))
        count, aside = len(z), np.concatenate([s + DIFFERENCE, s - DIFFERENCE])
        values = self.equations.values(np.concatenate([z, z]), way(aside))
        patches = self.equations.patches(z)
        slopes = np.concatenate([slopes, patches], axis=1)
        change = (values[:count] - values[count:]) / (2 * DIFFERENCE)
        values = np.concatenate([change, np.zeros(patches.shape[:2])], axis=1)
        return solve(slopes, -values)

    def predicted(self, z: Array, s: Array, h: Array, way: Coefficients) -> Array:
        """Fourth order."""
        step = h[:, None]
        a = self.rate(z, s, way)
        b = self.rate(z + step / 2 * a, s + h / 2, way)
        c = self.rate(z + step / 2 * b, s + h / 2, way)
        d = self.rate(z + step * c, s + h, way)
        return np.asarray(z + step / 6 * (a + 2 * b + 2 * c + d))

    def corrected(self, z: Array, c: Array) -> tuple[Array, Array, Array]:
        """(points, length of the first correction, whether Newton's method converged)."""
        first = last = np.zeros(len(z))
        for k in range(NEWTON):
            step = self.newton(z, c)
            last = np.linalg.norm(step, axis=1)
            first = last if k == 0 else first
            z = self.equations.scaled(z + step)
            if (last < CONVERGED).all():
                break
        return z, first, last < CONVERGED

    def follow(self, z: Array, way: Coefficients, until: float = 1.0) -> Ends:
        """Zeros at s = 0 followed towards s = `until`."""
        count, steps = len(z), 0
        z, s = self.equations.scaled(z), np.zeros(count)
        h, going = np.full(count, LONGEST), np.ones(count, dtype=bool)
        rest, since = np.full(count, until), np.zeros(count, dtype=int)
        with np.errstate(all="ignore"):
            while going.any() and steps < MOST_STEPS:
                now = np.flatnonzero(going)
                left = until - s[now]
                step = np.minimum(h[now], left)
                guess = self.equations.scaled(self.predicted(z[now], s[now], step, way))
                after, first, good = self.corrected(guess, way(s[now] + step))
                good &= (first < self.correction) & np.isfinite(after).all(axis=1)
                taken = now[good]
                z[taken], s[taken] = after[good], s[taken] + step[good]
                s[taken[left[good] <= h[taken]]] = until
                ratio = np.nan_to_num(0.5 * self.correction / np.maximum(first, 1e-16), nan=0.0) ** 0.2
                h[now] = np.where(
                    good, np.minimum(step * np.clip(ratio, 0.5, 3.0), 0.5), step * np.clip(ratio, 0.1, 0.5)
                )
                left = until - s[now]
                halved = (left < 0.5 * rest[now]) | (left > CRAWL[0])
                rest[now], since[now] = np.where(halved, left, rest[now]), np.where(halved, 0, since[now] + 1)
                going[now] = (left > 0) & (h[now] > SHORTEST * self.nearly) & ((left > self.nearly) | (h[now] >= left))
                going[now] &= since[now] < CRAWL[1]
                steps += 1
        return Ends(z, s, s >= until, steps)
