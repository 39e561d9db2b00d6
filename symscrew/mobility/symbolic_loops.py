"""Motions of closed loops in the description's parameters: joint rates and body freedoms as polynomials.

For mechanisms without limbs, over the whole graph. Equations with a constant coefficient are solved first, so that
few and small determinants are left; the rest is Cramer's rule, so the rates have no poles. Common factors are taken
out; where all determinants of full size vanish the closure loses rank.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from math import comb
from typing import Any

import sympy

from symscrew.description import Mechanism
from symscrew.mobility.generators import Fraction, NotPolynomialError, Poly
from symscrew.mobility.joint_network import network_of
from symscrew.mobility.screw_systems import eliminate
from symscrew.mobility.symbolic_screws import Locus, SymbolicScrews, Vector, symbolic_screws

MOST_TERMS = 1500
"""Terms of an intermediate polynomial; beyond it the closed form is not of reasonable size."""
MOST_WORK = 12_000
"""Products of terms in one elimination."""
LARGEST_SHOWN = 60
MOST_MINORS = 200

Row = list[Poly]


class Budget:
    """Products over the ring, until too much work has been done."""

    def __init__(self, work: SymbolicScrews) -> None:
        self.ring, self.left = work.ring, MOST_WORK

    def product(self, a: Poly, b: Poly) -> Poly:
        """a b, not in normal form."""
        self.left -= len(a.terms()) * len(b.terms())
        if self.left < 0:
            raise TooLargeError(f"more than {MOST_WORK} products of terms")
        return a * b


class TooLargeError(ArithmeticError):
    """A closed form exists but is too long to be of use."""


@dataclass(frozen=True)
class SymbolicLoops:
    """`rates`: joint rates of independent motions, `joints` their names (`joint` or `joint.i`).

    `freedoms`: twists (omega ; v) of `body` along the same motions, those that are not zero; `loci` where the
    closure loses rank.
    """

    parameters: tuple[sympy.Symbol, ...]
    joints: tuple[str, ...]
    rates: tuple[Vector, ...]
    body: str
    freedoms: tuple[Vector, ...]
    loci: tuple[Locus, ...]


def symbolic_loops(mechanism: Mechanism, body: str) -> SymbolicLoops | str:
    """The motions of a mechanism in its parameters, or a sentence why they are not given."""
    try:
        return _loops(mechanism, symbolic_screws(mechanism), body)
    except NotPolynomialError as error:
        return f"no symbols: {error}"
    except TooLargeError as error:
        return f"the closed form is not of reasonable size: {error}"


def _loops(mechanism: Mechanism, work: SymbolicScrews, body: str) -> SymbolicLoops:
    network = network_of(mechanism)
    ring = work.ring
    scaled = {name: work.scaled_screws(joint) for name, joint in mechanism.joints.items()}
    screws = {name: [screw for screw, _ in made] for name, made in scaled.items()}
    factors = [factor for name in network.edges for _, factor in scaled[name]]
    rows = [row for loop in network.loops() for row in _rows(network, screws, loop, ring.ring.zero)]
    motions, dependent = null_vectors(work, rows, network.freedoms)
    names = tuple(
        name if len(edge.screws) == 1 else f"{name}.{k}"
        for name, edge in network.edges.items()
        for k in range(len(edge.screws))
    )
    twist = _rows(network, screws, network.path(body), ring.ring.zero)
    freedoms = []
    for motion in motions:
        moved = [ring.normal(sum((a * b for a, b in zip(row, motion, strict=True) if a and b), ring.ring.zero))
                 for row in twist]  # fmt: skip
        if any(moved):
            freedoms.append(primitive(work, moved))
    loci = [
        Locus("closure", "loops", ring.expression(part), "the closure equations become dependent")
        for part in ring.factors(dependent)
        if len(part.terms()) <= LARGEST_SHOWN
    ]
    return SymbolicLoops(
        tuple(ring.parameters),
        names,
        tuple(_vector(work, _unit_rates(work, motion, factors)) for motion in motions),
        body,
        tuple(_vector(work, twist) for twist in freedoms),
        tuple(loci),
    )


def _unit_rates(work: SymbolicScrews, motion: Row, factors: Sequence[Fraction]) -> Row:
    """Rates of the unit screws, from those of screws that were multiplied by `factors`."""
    ring = work.ring
    multiple = ring.ring.one
    for rate, factor in zip(motion, factors, strict=True):
        if rate:
            multiple = multiple.lcm(factor.denominator)
    rates = [
        ring.product(ring.product(rate, f.numerator), multiple.exquo(f.denominator)) if rate else rate
        for rate, f in zip(motion, factors, strict=True)
    ]
    return primitive(work, [_limited(rate) for rate in rates])


def _vector(work: SymbolicScrews, vector: Sequence[Poly]) -> Vector:
    if any(len(c.terms()) > LARGEST_SHOWN for c in vector if c):
        longest = max(len(c.terms()) for c in vector if c)
        raise TooLargeError(f"a component has {longest} terms")
    return tuple(work.ring.expression(c) for c in vector)


def _rows(network: Any, screws: dict[str, list[Row]], steps: Sequence[tuple[str, int]], zero: Poly) -> list[Row]:
    rows = [[zero] * network.freedoms for _ in range(6)]
    for name, sign in steps:
        for column, screw in zip(network.edges[name].columns, screws[name], strict=True):
            for i in range(6):
                rows[i][column] = sign * screw[i] if screw[i] else zero
    return rows


def null_vectors(work: SymbolicScrews, rows: Sequence[Row], columns: int) -> tuple[list[Row], Poly]:
    """(null space of the rows without poles, factor of the determinants whose zeros lose rank)."""
    ring = work.ring
    budget = Budget(work)
    left, solved = _constants_solved(work, [row for row in rows if any(row)], columns, budget)
    open_columns = [j for j in range(columns) if j not in dict(solved)]
    independent = work.independent_rows([[row[j] for j in open_columns] for row in left], len(open_columns))
    left = [left[i] for i in independent]
    small, common = _cramer(work, left, open_columns, budget)
    vectors = []
    for vector in small:
        full = [ring.ring.zero] * columns
        for j, c in zip(open_columns, vector, strict=True):
            full[j] = c
        for j, row in reversed(solved):
            parts = (budget.product(row[k], full[k]) for k in range(columns) if k != j and row[k] and full[k])
            total = sum(parts, ring.ring.zero)
            full[j] = -_limited(ring.normal(total)).mul_ground(1 / row[j].coeff(1))
        vectors.append(primitive(work, full))
    return vectors, common


def _constants_solved(
    work: SymbolicScrews, rows: list[Row], columns: int, budget: Budget
) -> tuple[list[Row], list[tuple[int, Row]]]:
    """(equations left, (column, equation) solved for it): pivots that are numbers, sparsest rows first."""
    ring = work.ring
    solved: list[tuple[int, Row]] = []
    left = [list(row) for row in rows]
    while True:
        pivots = [(sum(len(c.terms()) for c in row if c), i, j)
                  for i, row in enumerate(left) for j in range(columns) if row[j] and row[j].is_ground]  # fmt: skip
        if not pivots:
            return left, solved
        _, i, j = min(pivots)
        pivot = left.pop(i)
        lead = 1 / pivot[j].coeff(1)
        for row in left:
            if factor := row[j]:
                for k in range(columns):
                    if pivot[k]:
                        row[k] = _limited(ring.normal(row[k] - budget.product(factor, pivot[k].mul_ground(lead))))
        left = [row for row in left if any(row)]
        solved.append((j, pivot))


def _cramer(work: SymbolicScrews, rows: list[Row], columns: Sequence[int], budget: Budget) -> tuple[list[Row], Poly]:
    """Null vectors over `columns` by determinants, and the common factor of the determinants of full size."""
    ring = work.ring
    rank, count = len(rows), len(columns)
    matrix = [[row[j] for j in columns] for row in rows]
    if rank == 0:
        return [
            [ring.ring.one if i == j else ring.ring.zero for i in range(count)] for j in range(count)
        ], ring.ring.one
    minors: dict[tuple[tuple[int, ...], int], Poly] = {}

    def minor(chosen: tuple[int, ...], depth: int) -> Poly:
        """Determinant of the last rows from `depth` on the chosen columns."""
        if not chosen:
            return ring.ring.one
        if (chosen, depth) not in minors:
            total = ring.ring.zero
            for place, j in enumerate(chosen):
                if matrix[depth][j]:
                    part = minor(chosen[:place] + chosen[place + 1 :], depth + 1)
                    if part:
                        term = budget.product(matrix[depth][j], part)
                        total = total + term if place % 2 == 0 else total - term
            minors[chosen, depth] = _limited(ring.normal(total))
        return minors[chosen, depth]

    values = [[ring.number(c, work.somewhere) if c else 0 for c in row] for row in matrix]
    used = tuple(sorted(eliminate(values, count).pivots))
    base = minor(used, 0)
    vectors = []
    for free in (j for j in range(count) if j not in used):
        vector = [ring.ring.zero] * count
        vector[free] = base
        for place, j in enumerate(used):
            order = tuple(sorted(free if k == j else k for k in used))
            vector[j] = -((-1) ** (place + order.index(free))) * minor(order, 0)
        vectors.append(vector)
    common = base
    if comb(count, rank) <= MOST_MINORS:
        found = (minor(chosen, 0) for chosen in combinations(range(count), rank))
        common = ring.common_factor(m for m in found if m)
    elif not base.is_ground:
        common = ring.ring.one
    return vectors, common


def primitive(work: SymbolicScrews, vector: Sequence[Poly]) -> Row:
    """The vector without the common factor of its components, its first coefficient positive."""
    common = work.ring.common_factor(c for c in vector if c)
    divided = work.ring.without_roots_in([c.exquo(common) if c else c for c in vector])
    first = next(c for c in divided if c)
    return [-c for c in divided] if first.LC < 0 else divided


def _limited(poly: Poly) -> Poly:
    if len(poly.terms()) > MOST_TERMS:
        raise TooLargeError(f"an intermediate polynomial has more than {MOST_TERMS} terms")
    return poly
