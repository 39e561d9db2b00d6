"""Couplings of coordinates in mobility: rows of the closure beside those of the loops.

    sum of p_j(x_j) = constant --displacements d_j from the configuration--> sum of r_j(d_j) = 0, r_j without constant

Lengths are divided by the characteristic length as the network's are, and every relation by its largest slope, so that
its row is of the size of a loop's.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import comb
from typing import Any

import sympy

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description import CoupledTerm, Mechanism

Real = Any


@dataclass(frozen=True)
class TiedTerm:
    """What one coordinate adds: coefficients of d, d^2 ... of its displacement d from the configuration."""

    joint: str
    motion: int
    coefficients: tuple[Real, ...]

    def value(self, d: Any) -> Any:
        """The term at a displacement: a number, or an array of them."""
        total = 0 * d
        for c in reversed(self.coefficients):
            total = (total + c) * d
        return total

    def slope(self, d: Any) -> Any:
        """Its derivative there."""
        total = 0 * d
        for k in range(len(self.coefficients), 0, -1):
            total = total * d + k * self.coefficients[k - 1]
        return total

    def bend(self, d: Any) -> Any:
        """Its second derivative there."""
        total = 0 * d
        for k in range(len(self.coefficients), 1, -1):
            total = total * d + k * (k - 1) * self.coefficients[k - 1]
        return total

    def moved(self, d: Real) -> TiedTerm:
        """The same for displacements from where this coordinate has been displaced by d."""
        size = len(self.coefficients)
        shifted = [
            sum(self.coefficients[j - 1] * comb(j, k) * d ** (j - k) for j in range(k, size + 1))
            for k in range(1, size + 1)
        ]
        return replace(self, coefficients=tuple(shifted))

    def read(self, read: Callable[[Real], Any]) -> TiedTerm:
        """The same with numbers of another arithmetic."""
        return replace(self, coefficients=tuple(read(c) for c in self.coefficients))


@dataclass(frozen=True)
class Tie:
    """A coupling at a configuration."""

    name: str
    terms: tuple[TiedTerm, ...]


def ties_of(mechanism: Mechanism, length: Real) -> tuple[Tie, ...]:
    """The couplings of a mechanism in its reference configuration, in 60 digits and units of its size."""
    return tuple(
        Tie(coupling.name, _scaled([_term(mechanism, term, length) for term in coupling.terms]))
        for coupling in mechanism.couplings.values()
    )


def _term(mechanism: Mechanism, term: CoupledTerm, length: Real) -> TiedTerm:
    joint = mechanism.joints[term.joint]
    unit = length if joint.kind.motions[term.motion].prismatic else CONTEXT.one
    numbers = tuple(high_precision(mechanism.number(c)) * unit**k for k, c in enumerate(term.coefficients, start=1))
    given = joint.reference[term.motion] if term.motion < len(joint.reference) else sympy.S.Zero
    return TiedTerm(term.joint, term.motion, numbers).moved(high_precision(mechanism.number(given)) / unit)


def _scaled(terms: Sequence[TiedTerm]) -> tuple[TiedTerm, ...]:
    largest = max(abs(term.coefficients[0]) for term in terms)
    return tuple(replace(term, coefficients=tuple(c / largest for c in term.coefficients)) for term in terms)
