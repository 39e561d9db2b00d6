"""A planned motion between its points as polynomials in pieces of its intervals, over which it can be enclosed.

PlannedMotion --Taylor coefficients in x, -1 to 1 over an interval--> pieces [centre - radius, centre + radius] of x
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import comb

import numpy as np

from symscrew.optimisation.enclosures import Enclosure, Number, polynomial
from symscrew.optimisation.planned_motion import PlannedMotion


@dataclass(frozen=True)
class Pieces:
    """Parts of intervals of the mesh: number of the interval, centre and half width in -1 to 1, (n,) each."""

    interval: np.ndarray
    centre: np.ndarray
    radius: np.ndarray

    @staticmethod
    def whole(intervals: int) -> Pieces:
        """Every interval as a piece."""
        return Pieces(np.arange(intervals), np.zeros(intervals), np.ones(intervals))

    def __len__(self) -> int:
        return len(self.interval)

    def chosen(self, at: np.ndarray) -> Pieces:
        """Some of them."""
        return Pieces(self.interval[at], self.centre[at], self.radius[at])

    def halves(self) -> Pieces:
        """Each cut in two: first all left parts, then all right ones."""
        half = self.radius / 2
        return Pieces(
            np.tile(self.interval, 2), np.concatenate([self.centre - half, self.centre + half]), np.tile(half, 2)
        )

    def with_others(self, others: Pieces) -> Pieces:
        """These and others."""
        pairs = ((getattr(self, n), getattr(others, n)) for n in ("interval", "centre", "radius"))
        return Pieces(*(np.concatenate(pair) for pair in pairs))

    def tau(self, mesh: np.ndarray) -> np.ndarray:
        """Relative times of the centres."""
        low, high = mesh[self.interval], mesh[self.interval + 1]
        return np.asarray((low + high) / 2 + (high - low) / 2 * self.centre)


class MotionPolynomials:
    """The unknowns of a motion by x in -1 to 1 over every interval; `coefficients[name]` (powers, intervals, size)."""

    def __init__(self, motion: PlannedMotion) -> None:
        mesh, scheme = motion.transcribed.mesh, motion.transcribed.scheme
        degree = max(scheme.degree + 1 if scheme else 0, 5)  # y has one more than nodes; shooting is read as quintics
        count, intervals = degree + 1, len(mesh) - 1
        x = np.cos(np.pi * (np.arange(count) + 0.5) / count)
        k = np.repeat(np.arange(intervals), count)
        tau = mesh[k] + np.diff(mesh)[k] * (1 + np.tile(x, intervals)) / 2
        inverse = np.linalg.inv(x[:, None] ** np.arange(count))
        self.coefficients: Mapping[str, np.ndarray] = {
            name: np.einsum("ij,kjm->ikm", inverse, values.reshape(intervals, count, -1))
            for name, values in motion.blocks(tau, k).items()
        }
        self.mesh = mesh
        self.shift = np.array([[comb(i, j) if i >= j else 0 for i in range(count)] for j in range(count)])

    def recentred(self, name: str, pieces: Pieces) -> np.ndarray:
        """Coefficients by x - centre: (powers, n, size)."""
        given = self.coefficients[name][:, pieces.interval]
        powers = np.arange(len(given))
        lifted = pieces.centre[:, None, None] ** np.clip(powers[None] - powers[:, None], 0, None)
        return np.asarray(np.einsum("nji,ji,inm->jnm", lifted, self.shift, given))

    def enclosed(self, name: str, pieces: Pieces) -> list[Enclosure]:
        """An enclosure per entry of an unknown."""
        every = self.recentred(name, pieces)
        return [polynomial(every[:, :, k], pieces.radius) for k in range(every.shape[2])]

    def at(self, name: str, pieces: Pieces, part: float = 0.0) -> np.ndarray:
        """Values (n, size) at centre + part * radius."""
        x = pieces.centre + part * pieces.radius
        given = self.coefficients[name][:, pieces.interval]
        return np.asarray(np.einsum("in,inm->nm", x ** np.arange(len(given))[:, None], given))

    def slopes(self, name: str, pieces: Pieces) -> np.ndarray:
        """Slopes by x (n, size) at the centres."""
        return np.asarray(self.recentred(name, pieces)[1])

    def time(self, pieces: Pieces) -> list[Number]:
        """Relative time itself."""
        half = np.diff(self.mesh)[pieces.interval] / 2
        return [polynomial(np.array([pieces.tau(self.mesh), half]), pieces.radius)]
