"""Polynomials at many complex points at once: values, derivatives, bounds of both, and values in 70 digits.

    polynomials --every monomial is a smaller one times a variable--> monomials at all points --two tables--> f, df/dz

Variables are in units that are powers of two, near the sizes that they have, and equations have their largest
coefficient near one: both change no digit of a coefficient.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import frexp
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.components.polynomials import Exponents, Polynomial
from symscrew.mobility.symbols import exact_value

Array = np.ndarray[Any, Any]
BITS = 240
"""Of a fraction in 70 digits: those of coefficients, whose roots are known to 60, and some for rounding."""
ROUNDING = 2.0**-53
"""Relative error of one operation."""


@dataclass(frozen=True, eq=False)
class ManyPoints:
    """The polynomials f: in units `sizes` (powers of two) of the variables.

    `parents`: for every degree (monomials, those that they are made of, the variable that is multiplied);
    `table`: coefficients, polynomials x monomials; `slopes`: monomials x (polynomials, variables);
    `bends`: absolute values of second derivatives, monomials x (polynomials, variables), summed over the
    second variable;
    `fractions`: [(monomial, coefficient as an integer over 2^BITS)] for each polynomial.
    """

    sizes: Array
    parents: tuple[tuple[Array, Array, Array], ...]
    table: Array
    slopes: Array
    bends: Array
    fractions: tuple[tuple[tuple[int, int], ...], ...]
    operations: int

    @classmethod
    def of(cls, polynomials: Sequence[Polynomial], sizes: Array) -> ManyPoints:
        """The polynomials in units of the variables."""
        keys = _closed({key for p in polynomials for key in p.terms})
        place = {key: k for k, key in enumerate(keys)}
        count, width = len(polynomials), len(sizes)
        table = np.zeros((count, len(keys)))
        fractions = []
        exact = CONTEXT.mpf(2) ** BITS
        for row, p in enumerate(polynomials):
            terms = {key: exact_value(c) * _power(sizes, key) for key, c in p.terms.items()}
            unit = CONTEXT.mpf(2) ** frexp(float(max(abs(c) for c in terms.values())))[1]
            for key, c in terms.items():
                table[row, place[key]] = float(c / unit)
            fractions.append(tuple((place[key], int(CONTEXT.nint(c / unit * exact))) for key, c in terms.items()))
        slopes, bends = np.zeros((len(keys), count, width)), np.zeros((len(keys), count, width))
        for key, k in place.items():
            for i in range(width):
                if not key[i]:
                    continue
                once = _lower(key, i)
                slopes[place[once], :, i] += key[i] * table[:, k]
                for j in range(width):
                    if once[j]:
                        bends[place[_lower(once, j)], :, i] += key[i] * once[j] * np.abs(table[:, k])
        levels: dict[int, list[tuple[int, int, int]]] = {}
        for key, k in place.items():
            if any(key):
                last = max(i for i in range(width) if key[i])
                levels.setdefault(sum(key), []).append((k, place[_lower(key, last)], last))
        columns = (np.array(rows).T for _, rows in sorted(levels.items()))
        parents = tuple((which, smaller, last) for which, smaller, last in columns)
        operations = 4 * (max(map(sum, keys)) + max(len(f) for f in fractions) + width)
        return cls(sizes, parents, table, slopes.reshape(len(keys), -1), bends.reshape(len(keys), -1),
                   tuple(fractions), operations)  # fmt: skip

    def monomials(self, z: Array) -> Array:
        """All monomials at points, one a row."""
        made = np.ones((len(z), self.table.shape[1]), dtype=z.dtype)
        for which, smaller, variable in self.parents:
            made[:, which] = made[:, smaller] * z[:, variable]
        return made

    def at(self, z: Array) -> tuple[Array, Array]:
        """(values: points x polynomials, derivatives: points x polynomials x variables)."""
        made = self.monomials(z)
        count, (rows, columns) = len(z), self._shape
        used, table = self._both
        values = np.zeros((count, rows * (columns + 1)), dtype=made.dtype)
        if np.iscomplexobj(made):
            parts = np.concatenate([made.real, made.imag]) @ table  # coefficients are real: one product of doubles
            values[:, used] = parts[:count] + 1j * parts[count:]
        else:
            values[:, used] = made @ table
        return values[:, :rows], values[:, rows:].reshape(count, rows, columns)

    def sizes_at(self, z: Array) -> tuple[Array, Array]:
        """What values and derivatives can be at most where variables have these absolute values."""
        made = self.monomials(np.abs(z))
        return made @ np.abs(self.table).T, (made @ np.abs(self.slopes)).reshape(len(z), *self._shape)

    def bends_at(self, z: Array) -> Array:
        """How much derivatives can change at most, for each unit that all variables change: as `sizes_at`."""
        return np.asarray((self.monomials(np.abs(z)) @ self.bends).reshape(len(z), *self._shape))

    def in_digits(self, real: Array, imaginary: Array) -> tuple[Array, Array]:
        """Real and imaginary parts of values at points, all integers over 2^BITS, polynomials x points."""
        one = np.full(len(real), 1 << BITS, dtype=object)
        made: list[tuple[Array, Array]] = [(one, one - one)] * self.table.shape[1]
        for which, smaller, variable in self.parents:
            for k, parent, i in zip(which, smaller, variable, strict=True):
                made[k] = fraction_product(made[parent], (real[:, i], imaginary[:, i]))
        values = [[sum(c * made[k][part] for k, c in terms) >> BITS for terms in self.fractions] for part in (0, 1)]
        return np.array(values[0], dtype=object), np.array(values[1], dtype=object)

    @cached_property
    def _both(self) -> tuple[Array, Array]:
        """(places of values and derivatives that are not zero everywhere, their coefficients)."""
        whole = np.concatenate([self.table.T, self.slopes], axis=1)
        used = np.flatnonzero(whole.any(axis=0))
        return used, np.ascontiguousarray(whole[:, used])

    @property
    def _shape(self) -> tuple[int, int]:
        return len(self.table), len(self.sizes)


def fraction_product(one: tuple[Array, Array], two: tuple[Array, Array]) -> tuple[Array, Array]:
    """The product of complex numbers whose parts are integers over 2^BITS."""
    (a, b), (c, d) = one, two
    return (a * c - b * d) >> BITS, (a * d + b * c) >> BITS


def _lower(key: Exponents, variable: int) -> Exponents:
    return (*key[:variable], key[variable] - 1, *key[variable + 1 :])


def _closed(keys: set[Exponents]) -> list[Exponents]:
    """The monomials and all that divide them, the smallest first."""
    found, new = set(keys), set(keys)
    while new:
        new = {_lower(key, i) for key in new for i in range(len(key)) if key[i]} - found
        found |= new
    return sorted(found, key=lambda key: (sum(key), key))


def _power(sizes: Array, key: Exponents) -> Any:
    value = CONTEXT.mpf(1)
    for size, power in zip(sizes, key, strict=True):
        value *= CONTEXT.mpf(float(size)) ** power
    return value
