"""Sets of configurations where the equations have less rank than around them: with equations for that, regular zeros.

    f = 0, rank of f' is r there --f'(z) (A + B L) = 0 with unknown L, r x (n - r)--> z regular, L told by z

A and B are random, so that the columns of A + B L are any n - r directions: these vanish together where the rank is r
and nowhere that it is higher. So three balls in one line, whose bars are stretched, have x2^2 + x3^2 = 0, two
complex planes, and of these real is the line x2 = x3 = 0 alone, where its derivatives vanish.
(A. Leykin, J. Verschelde, A. Zhao, Theor. Comp. Sci. 359 (2006) 111-122; J. Hauenstein, C. Wampler, Isosingular sets
and deflation, Found. Comp. Math. 13 (2013) 371-403.)
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from symscrew.mobility.components.many_points import ManyPoints
from symscrew.mobility.components.polynomials import Exponents, Polynomial, constant, total, variable
from symscrew.mobility.symbols import Exact

Array = np.ndarray[Any, Any]

VAGUE = 1e-4
"""Relative singular value that counts as none at a point known to 1e-6 or better: m-fold ones are known to the m-th
root of 1e-12."""
RANGE = 30
"""Random coefficients are whole numbers up to it, none of them zero."""
STEPS = 8
"""Of Newton's method, whose error is squared by each where the rank is made regular."""
SETTLED = 1e-12
"""Last step, of variables about one: at a singular zero it is halved each time, 1e-9 after so many."""


def deflated(polynomials: Sequence[Polynomial], rank: int, random: np.random.Generator) -> list[Polynomial]:
    """The polynomials with the conditions for this rank, in rank times corank more variables."""
    before = len(next(iter(polynomials[0].terms)))
    free = before - rank
    after = before + rank * free

    def whole() -> Exact:
        return Fraction(int(random.integers(1, RANGE)) * int(random.choice([-1, 1])))

    given = [Polynomial({(*key, *[0] * (rank * free)): c for key, c in p.terms.items()}) for p in polynomials]
    mixed = [[whole() for _ in range(rank)] for _ in range(before)]
    conditions = []
    for j in range(free):
        unknown = [variable(before + j * rank + i, after) for i in range(rank)]
        along = [
            total([constant(whole(), after), *(v.scaled(c) for v, c in zip(unknown, row, strict=True))])
            for row in mixed
        ]
        conditions += [total(_slope(p, k) * along[k] for k in range(before)) for p in given]
    return [*given, *(p for p in conditions if p)]


def _slope(polynomial: Polynomial, place: int) -> Polynomial:
    terms: dict[Exponents, Exact] = {}
    for key, c in polynomial.terms.items():
        if key[place]:
            terms[(*key[:place], key[place] - 1, *key[place + 1 :])] = c * Fraction(key[place])
    return Polynomial(terms)


def ranks_of(polynomials: ManyPoints, z: Array) -> Array:
    """Ranks of the derivatives at points that are not known to rounding."""
    values = np.linalg.svd(polynomials.at(z)[1], compute_uv=False)
    return np.asarray((values > VAGUE * np.maximum(values[:, :1], VAGUE)).sum(axis=1))


def made_regular(polynomials: ManyPoints, z: Array, least: float) -> tuple[Array, Array]:
    """(points with what is told of them by the first ones, which Newton's method settled); `polynomials`: deflated."""
    count = len(polynomials.sizes) - z.shape[1]
    points = np.concatenate([z, np.zeros((len(z), count))], axis=1)
    values, slopes = polynomials.at(points)  # linear in the new ones, which are zero here
    inner = slopes[:, :, z.shape[1] :]
    points[:, z.shape[1] :] = -(np.linalg.pinv(inner, rcond=VAGUE) @ values[..., None])[..., 0]
    step = np.full(points.shape, np.inf)
    for _ in range(STEPS):
        values, slopes = polynomials.at(points)
        step = (np.linalg.pinv(slopes, rcond=least) @ values[..., None])[..., 0]
        points = points - step
    return points, np.abs(step).max(axis=1, initial=0.0) < SETTLED * (1 + np.abs(points).max(axis=1, initial=0.0))
