"""Polynomials over an exact field, and dual quaternions of them: what closure equations are made of.

    x0 + x1 i + x2 j + x3 k + eps (y0 + y1 i + y2 j + y3 k): Study's parameters of a displacement, up to a factor

E. Study, Geometrie der Dynamen, 1903; M. Husty, H.-P. Schroecker, Algebraic geometry and kinematics, 2010.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from symscrew.mobility.symbols import Exact, Generator, exact_value, terms_of

Exponents = tuple[int, ...]


class Polynomial:
    """Exponents of the variables -> coefficient in the exact field, none of them zero."""

    __slots__ = ("terms",)

    def __init__(self, terms: Mapping[Exponents, Exact]) -> None:
        self.terms = {key: c for key, c in terms.items() if c}

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __add__(self, other: Polynomial) -> Polynomial:
        terms = dict(self.terms)
        for key, c in other.terms.items():
            terms[key] = terms[key] + c if key in terms else c
        return Polynomial(terms)

    def __neg__(self) -> Polynomial:
        return Polynomial({key: -c for key, c in self.terms.items()})

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def __mul__(self, other: Polynomial) -> Polynomial:
        terms: dict[Exponents, Exact] = {}
        for one, a in self.terms.items():
            for two, b in other.terms.items():
                key = tuple(i + j for i, j in zip(one, two, strict=True))
                terms[key] = terms[key] + a * b if key in terms else a * b
        return Polynomial(terms)

    def scaled(self, factor: Exact) -> Polynomial:
        """The polynomial times a number."""
        return Polynomial({key: factor * c for key, c in self.terms.items()} if factor else {})

    @property
    def degree(self) -> int:
        """Total degree; 0 of the zero polynomial."""
        return max((sum(key) for key in self.terms), default=0)

    def at(self, values: Sequence[Exact]) -> Exact:
        """Its value at exact numbers."""
        total: Exact = Fraction(0)
        for key, c in self.terms.items():
            for value, power in zip(values, key, strict=True):
                for _ in range(power):
                    c = c * value
            total = total + c
        return total

    def text(self, variables: Sequence[str], generators: Sequence[Generator], letters: Sequence[str]) -> str:
        """As a sum of products of names and fractions, the way algebra systems read it."""
        parts = []
        for key, c in self.terms.items():
            names = [f"{name}^{power}" for name, power in zip(variables, key, strict=True) if power]
            for powers, rational in terms_of(c, generators).items():
                inner = [f"{letter}^{power}" for letter, power in zip(letters, powers, strict=True) if power]
                parts.append("*".join([f"({rational})", *inner, *names]))
        return "+".join(parts) or "0"

    def floats(self) -> dict[Exponents, float]:
        """Its coefficients as doubles."""
        return {key: float(exact_value(c)) for key, c in self.terms.items()}


def constant(value: Exact, count: int) -> Polynomial:
    """A number as a polynomial in `count` variables."""
    return Polynomial({(0,) * count: value})


def variable(index: int, count: int) -> Polynomial:
    """One of `count` variables."""
    return Polynomial({tuple(int(k == index) for k in range(count)): Fraction(1)})


def total(polynomials: Iterable[Polynomial]) -> Polynomial:
    """Their sum."""
    result = Polynomial({})
    for polynomial in polynomials:
        result = result + polynomial
    return result


Dual = Sequence[Polynomial]


def product(a: Dual, b: Dual) -> list[Polynomial]:
    """The product of two dual quaternions."""
    mixed = [p + q for p, q in zip(_hamilton(a[:4], b[4:]), _hamilton(a[4:], b[:4]), strict=True)]
    return [*_hamilton(a[:4], b[:4]), *mixed]


def _hamilton(a: Dual, b: Dual) -> list[Polynomial]:
    return [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]


def conjugate(a: Dual) -> list[Polynomial]:
    """The inverse displacement, up to a factor."""
    return [a[0], -a[1], -a[2], -a[3], a[4], -a[5], -a[6], -a[7]]


def joint_factor(screw: Sequence[Exact], parameter: Polynomial, count: int) -> list[Polynomial]:
    """The displacement along a freedom: 1 + t (w + eps v), t = tan(angle / 2) / |w|; of a slide 1 + eps t v."""
    scaled = [parameter.scaled(c) for c in screw]
    return [constant(Fraction(1), count), *scaled[:3], Polynomial({}), *scaled[3:]]


def arrays(polynomials: Sequence[Polynomial]) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    """(exponents of all monomials m x variables, coefficients polynomials x m) as doubles."""
    keys = sorted({key for p in polynomials for key in p.terms})
    place = {key: k for k, key in enumerate(keys)}
    table = np.zeros((len(polynomials), len(keys)))
    for row, p in enumerate(polynomials):
        for key, c in p.floats().items():
            table[row, place[key]] = c
    return np.array(keys, dtype=int), table
