"""Coordinates that a coupling ties to one another and that nothing held settles: two gears that both turn freely.

    coupling, known columns --whole numbers p, without a common factor--> sum of p times free ones = what is known
    angles up to whole turns --integers--> displacements of which the coupling holds as they are counted

Angles in a ratio of whole numbers are algebraic: p turns of one hinge are a product of p equal displacements. The sum
up to one whole turn is the sum itself, as whole turns of the hinges add to it whatever turns are missing. Angles in
another ratio, or to a power, are transcendental.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from math import gcd, lcm
from typing import Any

import numpy as np
import sympy

from symscrew.algebra import high_precision
from symscrew.assembly.coupled_columns import Coupled, Follower, powers_of, scaled, sizes_of
from symscrew.description import Mechanism
from symscrew.mobility import Network, NotAlgebraicError

Array = np.ndarray[Any, Any]

MOST_TURNS = 40
"""Of all hinges of a coupling together: degrees, and with them solutions, grow with it."""


@dataclass(frozen=True)
class Link:
    """The sum of `factors`, column -> whole number, times displacements is twice that of `column`, of no joint.

    `turning`: whether they are angles, up to whole turns of the sum; else slides.
    """

    name: str
    column: int
    factors: Mapping[int, int]
    turning: bool


def links_of(mechanism: Mechanism, network: Network, coupled: Coupled) -> tuple[tuple[Link, ...], tuple[Follower, ...]]:
    """(what couplings that are left tie, displacements of their columns: half of what is known in each).

    Raises:
        NotAlgebraicError: what has no polynomials, or none that are built here.
    """
    sizes = sizes_of(network)
    turning = {start: motion.turns for e in network.edges.values() for motion, start in e.motions}
    links, halves = list[Link](), list[Follower]()
    for name, left in coupled.left.items():
        powers = powers_of(mechanism, network, name)
        if any(len(powers[c]) > 1 for c in left):
            raise NotAlgebraicError("a power of what is free has no polynomials here")
        if len({turning[c] for c in left}) > 1:
            raise NotAlgebraicError("an angle that is free with a slide that is free has no polynomials")
        factors, scale = _whole_numbers({c: powers[c][0] for c in left})
        if sum(map(abs, factors.values())) > MOST_TURNS:
            raise NotAlgebraicError(f"{sum(map(abs, factors.values()))} turns together are more than {MOST_TURNS}")
        column = network.freedoms + len(links)
        exact = {c: tuple(sympy.expand(-scale * p / 2) for p in known) for c, known in powers.items() if c not in left}
        terms = {c: scaled(p, sizes[c], sizes[left[0]]) for c, p in exact.items()}
        links.append(Link(name, column, factors, turning[left[0]]))
        halves.append(Follower(column, terms, exact))
    return _saturated(links, halves)


def _whole_numbers(given: Mapping[int, sympy.Expr]) -> tuple[dict[int, int], sympy.Expr]:
    """(whole numbers without a common factor in the ratios of these, what these are times to be them)."""
    first = next(iter(given.values()))
    ratios = {c: sympy.nsimplify(sympy.radsimp(sympy.simplify(p / first))) for c, p in given.items()}
    if not all(ratio.is_Rational for ratio in ratios.values()):
        raise NotAlgebraicError("free coordinates in a ratio that is no fraction have no polynomials")
    whole = lcm(*(int(ratio.q) for ratio in ratios.values()))
    common = gcd(*(int(ratio * whole) for ratio in ratios.values()))
    return {c: int(ratio * whole) // common for c, ratio in ratios.items()}, sympy.Rational(whole, common) / first


def _saturated(links: Sequence[Link], halves: Sequence[Follower]) -> tuple[tuple[Link, ...], tuple[Follower, ...]]:
    """The same couplings as sums of which whole turns are made up for by whole turns of hinges, all at once.

    Those of several couplings of the same angles may not be: of 2 a + b and b - 2 c, a + c and b - 2 c are.
    """
    turning = [k for k, link in enumerate(links) if link.turning]
    if not turning:
        return tuple(links), tuple(halves)
    rows, columns = _rows([links[k] for k in turning])
    left, made = _by_columns(rows)
    if abs(left.det()) == 1:
        return tuple(links), tuple(halves)
    every, parts, below = list(links), list(halves), made.inv()
    for place, k in enumerate(turning):
        share = [(halves[j], value) for j, value in zip(turning, left.inv()[place, :], strict=True) if value]
        factors = {c: int(p) for c, p in zip(columns, below[place, :], strict=True) if p}
        every[k] = replace(links[k], factors=factors)
        parts[k] = _sum_of(share, halves[k].column)
    return tuple(every), tuple(parts)


def _sum_of(shares: Sequence[tuple[Follower, sympy.Rational]], column: int) -> Follower:
    exact, terms = dict[int, tuple[sympy.Expr, ...]](), dict[int, tuple[Any, ...]]()
    for half, share in shares:
        for c, powers in half.exact.items():
            exact[c] = tuple(a + share * b for a, b in zip_longest(exact.get(c, ()), powers, fillvalue=0))
            more = [high_precision(share) * p for p in half.terms[c]]
            terms[c] = tuple(a + b for a, b in zip_longest(terms.get(c, ()), more, fillvalue=0))
    return Follower(column, terms, exact)


def _rows(links: Sequence[Link]) -> tuple[list[list[int]], list[int]]:
    columns = sorted({c for link in links for c in link.factors})
    return [[link.factors.get(c, 0) for c in columns] for link in links], columns


def in_whole_turns(links: Iterable[Link], values: Mapping[int, float], q: Array) -> Array:
    """Displacements N x columns with angles moved by whole turns so that couplings hold as they are counted.

    By few turns, though not always by the fewest.
    """
    tied = [link for link in links if link.turning]
    if not tied:
        return q
    rows, columns = _rows(tied)
    missing = np.array([2 * values.get(link.column, 0.0) for link in tied]) - q[:, columns] @ np.array(rows).T
    turns, free = _turns(rows)
    q = q.copy()
    for k, off in enumerate(np.round(missing / (2 * np.pi)).astype(int)):
        found = turns @ off
        for _ in range(len(columns)):
            for way in free:  # whole turns that no coupling notices
                found = found - way * round(float(found @ way / (way @ way)))
        q[k, columns] += 2 * np.pi * found
    return q


def _turns(rows: Sequence[Sequence[int]]) -> tuple[Array, list[Array]]:
    """(T with rows T = 1 in whole numbers, whole numbers that the rows take to 0)."""
    left, made = _by_columns(rows)
    count, whole = len(rows), np.array(made.tolist(), dtype=int)
    return np.array((made[:, :count] * left.inv()).tolist(), dtype=int), list(whole[:, count:].T)


def _by_columns(rows: Sequence[Sequence[int]]) -> tuple[sympy.Matrix, sympy.Matrix]:
    """(H, U): rows U is a square matrix H, then zeros, by Euclid's steps on columns; U and its inverse are whole."""
    left, made = sympy.Matrix(rows), sympy.eye(len(rows[0]))
    for k in range(len(rows)):
        while any(left[k, k + 1 :]):
            places = [j for j in range(k, left.cols) if left[k, j]]
            least = min(places, key=lambda j: abs(left[k, j]))
            for matrix, times in ((m, list(left[k, :])) for m in (made, left)):
                for j in places:
                    if j != least:
                        matrix[:, j] -= (times[j] // times[least]) * matrix[:, least]
            for matrix in (left, made):
                matrix.col_swap(k, least)
    return left[:, : len(rows)], made
