"""Coordinates that couplings settle once others are held: the second gear of a pair, a mimic joint, a differential.

    known columns, couplings --terms of unknown columns, linear ones eliminated--> a polynomial of known displacements
    again with these, until nothing more is settled

A coupling is of coordinates as they are counted, not of angles up to whole turns: what follows from held numbers is one
number, and is held itself. What no coupling settles and some coupling ties is free: `linked_columns`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import comb
from typing import Any

import sympy

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description import Mechanism
from symscrew.mobility import Network

Powers = tuple[sympy.Expr, ...]
"""Coefficients of a displacement [rad, m], of its square ..., exact."""

NONE = 1e-45
"""Coefficients of 60 digits that are zero."""


@dataclass(frozen=True)
class Follower:
    """A column whose displacement is the sum of polynomials, without constants, of those of others.

    `terms`: column -> coefficients in 60 digits [rad, sizes of the mechanism]; `exact`: the same in rad and m.
    """

    column: int
    terms: Mapping[int, tuple[Any, ...]]
    exact: Mapping[int, Powers]

    def value(self, values: Mapping[int, Any], read: Callable[[Any], Any]) -> Any:
        """Its displacement, of any scalars; `read` makes one of a number of 60 digits."""
        total = read(0)
        for column, coefficients in self.terms.items():
            total = total + _horner([read(c) for c in coefficients], values[column], read(0))
        return total

    def exactly(self, values: Mapping[int, sympy.Expr]) -> sympy.Expr:
        """The same in exact numbers [rad, m]."""
        parts = [_horner(powers, values[column], sympy.Integer(0)) for column, powers in self.exact.items()]
        return sympy.expand(sympy.Add(*parts))


def _horner(coefficients: Sequence[Any], d: Any, zero: Any) -> Any:
    """The sum of c d, c d^2 ..."""
    total = zero
    for c in reversed(coefficients):
        total = (total + c) * d
    return total


@dataclass(frozen=True)
class Coupled:
    """`followers` in an order in which each rests on known columns alone; couplings that are left, and their columns.

    `met`: couplings of which all columns are known: they may hold or not.
    """

    followers: tuple[Follower, ...]
    left: Mapping[str, tuple[int, ...]]
    met: Mapping[str, Mapping[int, Powers]]


def coupled_columns(mechanism: Mechanism, network: Network, known: Iterable[int]) -> Coupled:
    """What the couplings settle where the columns `known` are held."""
    known = tuple(dict.fromkeys(known))
    powers = {name: powers_of(mechanism, network, name) for name in mechanism.couplings}
    met = {name: terms for name, terms in powers.items() if set(terms) <= set(known)}
    sizes = sizes_of(network)
    settled: dict[int, Follower] = {}
    while found := _settled(powers, {*known, *settled}):
        for column, exact in found.items():
            terms = {c: scaled(p, sizes[c], sizes[column]) for c, p in exact.items()}
            settled[column] = Follower(column, terms, exact)
    every = {*known, *settled}
    left = {name: tuple(c for c in terms if c not in every) for name, terms in powers.items()}
    return Coupled(tuple(settled.values()), {name: columns for name, columns in left.items() if columns}, met)


def powers_of(mechanism: Mechanism, network: Network, name: str) -> dict[int, Powers]:
    """Column -> coefficients of its displacement from the reference, of a coupling."""
    result = dict[int, Powers]()
    for term in mechanism.couplings[name].terms:
        joint = mechanism.joints[term.joint]
        at = mechanism.number(joint.reference[term.motion]) if term.motion < len(joint.reference) else sympy.Integer(0)
        given = [mechanism.number(c) for c in term.coefficients]
        count = len(given)
        moved = [
            sympy.expand(sympy.Add(*(given[j - 1] * comb(j, k) * at ** (j - k) for j in range(k, count + 1))))
            for k in range(1, count + 1)
        ]
        result[network.tied_column(term.joint, term.motion)] = tuple(moved)
    return result


def sizes_of(network: Network) -> dict[int, Any]:
    """Column -> its unit in rad or m."""
    motions = [(start, motion) for e in network.edges.values() for motion, start in e.motions]
    return {start: network.length if motion.prismatic else CONTEXT.one for start, motion in motions}


def scaled(powers: Powers, size: Any, own: Any) -> tuple[Any, ...]:
    """Coefficients [rad, m] in 60 digits, of a displacement of this size for one of the size `own`."""
    return tuple(high_precision(p) * size**k / own for k, p in enumerate(powers, start=1))


def _settled(powers: Mapping[str, Mapping[int, Powers]], known: set[int]) -> dict[int, dict[int, Powers]]:
    """Unknown columns that these couplings settle -> polynomials of known ones."""
    rows = {name: terms for name, terms in powers.items()
            if not set(terms) <= known and all(len(p) == 1 for c, p in terms.items() if c not in known)}  # fmt: skip
    unknown = sorted({c for terms in rows.values() for c in terms} - known)
    if not rows:
        return {}
    names = list(rows)
    matrix = sympy.Matrix([
        [*(rows[name].get(c, (sympy.Integer(0),))[0] for c in unknown), *(int(name == other) for other in names)]
        for name in names
    ])  # fmt: skip
    reduced, pivots = matrix.rref(iszerofunc=_is_zero)
    result = dict[int, dict[int, Powers]]()
    for k, pivot in enumerate(pivots):
        if pivot >= len(unknown) or any(not _is_zero(reduced[k, j]) for j in range(len(unknown)) if j != pivot):
            continue
        total = dict[int, list[sympy.Expr]]()
        for j, name in enumerate(names):
            factor = -reduced[k, len(unknown) + j]
            for column in (c for c in rows[name] if c in known and not _is_zero(factor)):
                _add_to(total.setdefault(column, []), [factor * p for p in rows[name][column]])
        result[unknown[pivot]] = {c: tuple(map(sympy.simplify, p)) for c, p in total.items()}
    return result


def _add_to(total: list[sympy.Expr], more: Sequence[sympy.Expr]) -> None:
    total += [sympy.Integer(0)] * (len(more) - len(total))
    for k, value in enumerate(more):
        total[k] += value


def _is_zero(value: sympy.Expr) -> bool:
    return bool(value == 0) or bool(abs(high_precision(value)) < NONE)
