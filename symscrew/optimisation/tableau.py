"""Collocation as data: nodes, weights and the integrals of the interpolation through the nodes.

All schemes take second rates y'' at K nodes c_i of an interval of length h as unknowns:

    y'(c_i) = y'_0 + h sum_j rate[i, j] y''_j
    y(c_i)  = y_0 + h c_i y'_0 + h^2 sum_j position[i, j] y''_j

`rate` integrates the polynomial through the nodes once (the Butcher matrix of the Gauss and Radau IIA methods).
First-order collocation treats y and y' as two states of which each is collocated: position = rate^2, so that
y' and the derivative of y's polynomial agree at the nodes only. Second-order collocation integrates the same
polynomial twice, so that y' is the derivative of y everywhere (S. Moreno-Martin, L. Ros, E. Celaya, "Collocation
methods for second and higher order systems", Autonomous Robots 48, 2024).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from math import comb

import numpy as np
from numpy.polynomial import legendre

from symscrew.errors import DescriptionError, did_you_mean

# Nine nodes are of order 17 (Radau) and 18 (Gauss): who wants a smaller error takes more intervals. Polynomials are
# series of Legendre's, whose integrals are exact to 1e-15 there; in powers of s every node costs most of a digit.
HIGHEST_DEGREE = 9


@dataclass(frozen=True)
class Tableau:
    """A collocation scheme on the unit interval: `nodes` (K,), `weights` (K,), `rate`, `position` (K, K).

    `end_rate`, `end_position` (K,) do the same at the end of the interval. `second_order` tells which of the two
    schemes `position` is.
    """

    family: str
    degree: int
    second_order: bool
    nodes: np.ndarray
    weights: np.ndarray
    rate: np.ndarray
    position: np.ndarray
    end_rate: np.ndarray
    end_position: np.ndarray

    def basis(self, s: np.ndarray) -> np.ndarray:
        """Lagrange polynomials through the nodes at s (n,): shape (n, K)."""
        return _at(s, _lagrange(self.nodes))

    def bernstein(self, s: np.ndarray) -> np.ndarray:
        """Bernstein polynomials of degree K - 1 at s (n,): shape (n, K).

        Drives are polynomials with these coefficients (control points): where all control points keep a bound,
        the polynomial keeps it everywhere between.
        """
        s, top = np.asarray(s, dtype=float)[:, None], self.degree - 1
        j = np.arange(self.degree)
        return np.asarray(np.array([comb(top, k) for k in j]) * s**j * (1 - s) ** (top - j))

    @property
    def control(self) -> np.ndarray:
        """Values at the nodes from control points: shape (K, K)."""
        return self.bernstein(self.nodes)

    def rate_at(self, s: np.ndarray) -> np.ndarray:
        """Integrals of the Lagrange polynomials from 0 to s: shape (n, K)."""
        return _at(s, _integrated(_lagrange(self.nodes)))

    def position_at(self, s: np.ndarray) -> np.ndarray:
        """What stands for `position` at any s: shape (n, K).

        First-order schemes: y is the polynomial whose rate is the interpolation of y' through the nodes.
        """
        if self.second_order:
            return _at(s, _integrated(_integrated(_lagrange(self.nodes))))
        return np.asarray(self.rate_at(s) @ self.rate)

    def slope(self) -> np.ndarray:
        """Derivatives of the Lagrange polynomials at the nodes, per unit interval: shape (K, K)."""
        return _at(self.nodes, legendre.legder(_lagrange(self.nodes), scl=2.0))


@cache
def tableau(family: str, degree: int, second_order: bool = True) -> Tableau:
    """The scheme with `degree` nodes of a family: "gauss" (Legendre-Gauss) or "radau" (Legendre-Gauss-Radau)."""
    if family not in NODES:
        raise DescriptionError(f"transcription: unknown collocation {family!r}; {did_you_mean(family, NODES)}")
    if not 1 <= degree <= HIGHEST_DEGREE:
        raise DescriptionError(f"transcription: expected a degree from 1 to {HIGHEST_DEGREE}, got {degree}")
    nodes = NODES[family](degree)
    once, end = _integrated(_lagrange(nodes)), np.ones(1)
    rate, end_rate = _at(nodes, once), _at(end, once)[0]
    if second_order:
        twice = _integrated(once)
        position, end_position = _at(nodes, twice), _at(end, twice)[0]
    else:
        position, end_position = rate @ rate, end_rate @ rate
    return Tableau(family, degree, second_order, nodes, end_rate, rate, position, end_rate, end_position)


def _gauss(degree: int) -> np.ndarray:
    return (1 + legendre.leggauss(degree)[0]) / 2


def _radau(degree: int) -> np.ndarray:
    """Zeros of P_K - P_(K-1) on [-1, 1], the last one at 1, brought to [0, 1]."""
    series = np.zeros(degree + 1)
    series[degree], series[degree - 1] = 1.0, -1.0
    roots = np.sort(legendre.legroots(series).real)
    derivative = legendre.legder(series)
    for _ in range(3):  # the companion matrix leaves a few units in the last place
        slope = legendre.legval(roots, derivative)
        roots = roots - legendre.legval(roots, series) / slope
    roots[-1] = 1.0
    return (1 + roots) / 2


NODES: Mapping[str, Callable[[int], np.ndarray]] = {"gauss": _gauss, "radau": _radau}


def _lagrange(nodes: np.ndarray) -> np.ndarray:
    """Coefficients of the Lagrange polynomials in Legendre's of 2 s - 1: column j belongs to node j."""
    return np.linalg.inv(legendre.legvander(2 * nodes - 1, len(nodes) - 1))


def _integrated(coefficients: np.ndarray) -> np.ndarray:
    """Integral from s = 0 of series in Legendre's polynomials of 2 s - 1, whose coefficients stand in columns."""
    return np.asarray(legendre.legint(coefficients, lbnd=-1, scl=0.5))


def _at(s: np.ndarray, coefficients: np.ndarray) -> np.ndarray:
    """Values of such series at s (n,): shape (n, columns)."""
    return np.asarray(legendre.legvander(2 * np.asarray(s, dtype=float) - 1, len(coefficients) - 1) @ coefficients)
