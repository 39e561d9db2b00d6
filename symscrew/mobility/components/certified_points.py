"""Points on a section in 70 digits, each proved to be within a small ball of a regular zero of the combined equations.

    doubles --z - Y F(z), F in 70 digits, Y the inverse of the derivatives in doubles--> 60 digits
    |Y F| + q r < r, q >= |1 - Y F'| in the ball of radius r --> exactly one zero in it (Krawczyk 1969, Banach)

All roundings are bounded; coefficients are those of the mechanism to 60 digits, sections are numbers as they stand.
What is proved is of random combinations of the equations where there are more of them than needed; then how large all
equations are at the points is evidence that these are zeros of each.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ldexp
from typing import Any

import numpy as np

from symscrew.mobility.components.many_points import BITS, ROUNDING, fraction_product
from symscrew.mobility.components.moving_sections import Section, SquareSystem

Array = np.ndarray[Any, Any]
Fractions = tuple[Array, Array]
"""Real and imaginary parts as integers over 2^BITS."""

REFINED = 15
"""Steps at most: each brings as many digits as the derivatives' inverse has, five to sixteen."""
ROUNDED = 2.0**-200
"""A step below it is of the size of rounding."""
KNOWN = 2.0**-190
"""Relative error of coefficients of 60 digits (2^-199) with those of the operations on integers over 2^240."""
SLACK = 1.001
"""Bounds are sums of positive doubles, of far less than 1e10 terms: their own rounding is within this."""
WIDER = 4.0
"""Ball against the step that is left: the zero has to be inside."""


@dataclass(frozen=True, eq=False)
class Refined:
    """Points in 70 digits, radius of the ball around each that has one zero (infinite: not proved), and residual.

    `residual`: largest absolute value of all equations, not of combinations, whose coefficients are about one.
    """

    points: Fractions
    radii: Array
    residual: float

    @property
    def certified(self) -> int:
        """Points with balls that are apart from each other."""
        z, proved = _doubles(self.points), np.isfinite(self.radii)
        away = np.abs(z[:, None] - z[None]).max(axis=2) - self.radii[:, None] - self.radii[None]
        np.fill_diagonal(away, 1.0)
        return int((proved & (np.where(proved[None], away, 1.0) > 1e-12).all(axis=1)).sum())


def refined(system: SquareSystem, section: Section, z: Array) -> Refined:
    """The points to 60 digits, and what is proved of them."""
    _, slopes = system.at(z)
    matrix = np.concatenate([slopes, np.broadcast_to(section.matrix, (len(z), *section.matrix.shape))], axis=1)
    inverse = np.linalg.inv(matrix)
    points = _fractions(z)
    for _ in range(REFINED):
        values, _ = _residuals(system, section, points)
        step = np.einsum("pij,pj->pi", inverse, values)
        change = _fractions(step)
        points = points[0] - change[0], points[1] - change[1]
        if np.abs(step).max(initial=0.0) < ROUNDED:
            break
    values, residual = _residuals(system, section, points)
    return Refined(points, _radii(system, section, _doubles(points), (inverse, values)), residual)


def _residuals(system: SquareSystem, section: Section, points: Fractions) -> tuple[Array, float]:
    """(values of the combined equations and the section as doubles, points x variables, the largest of all)."""
    real, imaginary = system.polynomials.in_digits(*points)
    mixed = _combined(system.mixing, (real, imaginary))
    across = _combined(section.matrix, (points[0].T, points[1].T))
    right = _fractions(section.right)
    across = across[0] - right[0][:, None], across[1] - right[1][:, None]
    values = np.concatenate([_doubles(mixed), _doubles(across)]).T
    return values, float(np.abs(_doubles((real, imaginary))).max(initial=0.0))


def _combined(matrix: Array, values: Fractions) -> Fractions:
    """The matrix times columns of values."""
    factors = _fractions(matrix)
    rows = []
    for i in range(len(matrix)):
        terms = [fraction_product((factors[0][i, j], factors[1][i, j]), (values[0][j], values[1][j]))
                 for j in range(matrix.shape[1])]  # fmt: skip
        rows.append((sum(t[0] for t in terms), sum(t[1] for t in terms)))
    empty = (0, values[0].shape[1])
    if not rows:
        return np.empty(empty, dtype=object), np.empty(empty, dtype=object)
    return np.array([r[0] for r in rows], dtype=object), np.array([r[1] for r in rows], dtype=object)


def _radii(system: SquareSystem, section: Section, z: Array, found: tuple[Array, Array]) -> Array:
    """Of each point the radius of a ball, in the largest of the variables, with exactly one zero; infinite if none."""
    inverse, values = found
    polynomials, size = system.polynomials, np.abs(inverse)
    # values: to 60 digits, of combinations and of sections
    spread = np.maximum(np.abs(z), 1.0)
    errors = polynomials.operations * KNOWN * polynomials.sizes_at(spread)[0] @ np.abs(system.mixing).T
    beside = polynomials.operations * KNOWN * (spread @ np.abs(section.matrix).T + np.abs(section.right))
    wrong = np.abs(values) * (1 + 1e-10) + np.concatenate([errors, beside], axis=1)
    step = SLACK * np.einsum("pij,pj->pi", size, wrong).max(axis=1)
    radius = WIDER * step
    # derivatives: in doubles, at the centre and in the ball
    _, slopes = system.at(z)
    matrix = np.concatenate([slopes, np.broadcast_to(section.matrix, (len(z), *section.matrix.shape))], axis=1)
    rounded = 4 * polynomials.operations * ROUNDING
    largest = polynomials.sizes_at(np.abs(z) + radius[:, None])[1]
    bends = polynomials.bends_at(np.abs(z) + radius[:, None]) * radius[:, None, None]
    unknown = np.abs(system.mixing) @ (bends + rounded * largest)
    change = np.concatenate([unknown, np.zeros((len(z), *section.matrix.shape))], axis=1)
    count = z.shape[1]
    left = np.abs(np.eye(count) - inverse @ matrix) + size @ (change + 8 * count * ROUNDING * np.abs(matrix))
    contraction = SLACK * left.sum(axis=2).max(axis=1)
    with np.errstate(invalid="ignore"):
        proved = (contraction < 1) & (step + contraction * radius < radius)
    return np.where(proved, radius, np.inf)


def trace_in_digits(points: Fractions, beside: tuple[Fractions, Fractions]) -> float:
    """Second difference of the sum of points over three parallel sections, against the sum of the ways of each."""
    ahead, behind = beside
    bends = [(a + b - 2 * p).sum(axis=0) for p, a, b in zip(points, ahead, behind, strict=True)]
    ways = sum(np.abs(_doubles(side) - _doubles(points)).sum(axis=0) for side in beside)
    second = np.abs(_doubles((bends[0], bends[1])))
    return float(second.max() / max(float(np.max(ways)), 1e-300))


def _fractions(values: Array) -> Fractions:
    to_integer = np.frompyfunc(lambda v: int(ldexp(float(v), BITS)), 1, 1)
    return to_integer(np.real(values)), to_integer(np.imag(values))


def _doubles(values: Fractions) -> Array:
    to_double = np.frompyfunc(lambda v: ldexp(float(v), -BITS), 1, 1)
    return np.asarray(to_double(values[0]).astype(float) + 1j * to_double(values[1]).astype(float))
