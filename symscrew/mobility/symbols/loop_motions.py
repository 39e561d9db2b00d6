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

import sympy

from symscrew.description import Mechanism
from symscrew.mobility.joint_network import Network, network_of
from symscrew.mobility.screw_systems import eliminate
from symscrew.mobility.symbols.exact_screws import unmeasured_plane
from symscrew.mobility.symbols.generators import NotPolynomialError, Poly, Quotient
from symscrew.mobility.symbols.loci_at_points import true_loci
from symscrew.mobility.symbols.locus import AT_ONCE, Locus
from symscrew.mobility.symbols.polynomial_screws import SymbolicScrews, Vector, symbolic_screws

MOST_TERMS = 1500
"""Terms of an intermediate polynomial; what comes of a longer one is no formula that anybody reads. Beyond it the
result says so in place of the rates."""
MOST_WORK = 12_000
"""Products of terms in one elimination: a few seconds. Beyond it as above."""
LARGEST_SHOWN = 60
"""Terms of a component of a rate: three lines. Longer rates are given up, longer loci left out, and both are said."""
MOST_MINORS = 200
"""Determinants of full size whose common factor is looked for, the locus where the closure loses rank. Beyond it the
locus is not looked for, and the result says so."""

Row = list[Poly]


class Budget:
    """Products over the ring, until too much work has been done."""

    def __init__(self, work: SymbolicScrews) -> None:
        self.ring, self.left = work.ring, MOST_WORK

    def product(self, a: Poly, b: Poly) -> Poly:
        """a b, not in normal form."""
        self.left -= len(a.terms()) * len(b.terms())
        if self.left < 0:
            raise FormulaTooLargeError(f"more than {MOST_WORK} products of terms")
        return a * b


class FormulaTooLargeError(ArithmeticError):
    """A closed form exists but is too long to be of use."""


@dataclass(frozen=True)
class SymbolicLoops:
    """`rates`: joint rates of independent motions, `joints` their names (`joint` or `joint.i`).

    `freedoms`: twists (omega ; v) of `body` along the same motions, those that are not zero; `loci` where the
    closure loses rank; `not_tried`: loci that were not looked for or are too long to be shown, a sentence each.
    """

    parameters: tuple[sympy.Symbol, ...]
    joints: tuple[str, ...]
    rates: tuple[Vector, ...]
    body: str
    freedoms: tuple[Vector, ...]
    loci: tuple[Locus, ...]
    not_tried: tuple[str, ...] = ()


def symbolic_loops(mechanism: Mechanism, body: str) -> SymbolicLoops | str:
    """The motions of a mechanism in its parameters, or a sentence why they are not given."""
    if unmeasured := unmeasured_plane(mechanism.joints.values(), mechanism.number):
        return unmeasured
    try:
        return _loops(mechanism, symbolic_screws(mechanism), body)
    except NotPolynomialError as error:
        return f"no symbols: {error}"
    except FormulaTooLargeError as error:
        return f"the closed form is not of reasonable size: {error}"


def _loops(mechanism: Mechanism, work: SymbolicScrews, body: str) -> SymbolicLoops:
    network = network_of(mechanism)
    ring = work.ring
    scaled = {name: work.scaled_screws(joint) for name, joint in mechanism.joints.items()}
    screws = {name: [screw for screw, _ in made] for name, made in scaled.items()}
    factors = [factor for name in network.edges for _, factor in scaled[name]]
    rows = [row for loop in network.loops() for row in _rows(network, screws, loop, ring.ring.zero)]
    found = motions_by_minors(work, rows, network.freedoms)
    names = tuple(
        name if len(edge.screws) == 1 else f"{name}.{k}"
        for name, edge in network.edges.items()
        for k in range(len(edge.screws))
    )
    twist = _rows(network, screws, network.path(body), ring.ring.zero)
    freedoms = [moved for motion in found.vectors if (moved := _moved(work, twist, motion))]
    parts = ring.factors(found.dependent)
    shown = [part for part in parts if len(part.terms()) <= LARGEST_SHOWN]
    not_tried = [
        f"locus where the closure loses rank: a factor of {len(part.terms())} terms is not shown"
        for part in parts
        if part not in shown
    ]
    if found.minors_left_out:
        not_tried.append(
            f"locus where the closure loses rank: not looked for, {found.minors_left_out} determinants are more than "
            f"{MOST_MINORS}"
        )
    meaning = "the closure equations become dependent"
    loci = true_loci(work.shape, [Locus("closure", "loops", ring.expression(part), meaning) for part in shown])
    if not found.all_listed or len(loci) < len(shown):
        not_tried.append(f"the closure, {AT_ONCE}")
    return SymbolicLoops(
        tuple(ring.parameters),
        names,
        tuple(_vector(work, _unit_rates(work, motion, factors)) for motion in found.vectors),
        body,
        tuple(_vector(work, twist) for twist in freedoms),
        loci,
        tuple(not_tried),
    )


def _moved(work: SymbolicScrews, twist: Sequence[Row], motion: Row) -> Row | None:
    """The twist of a body along a motion, without common factors; None where it rests."""
    ring = work.ring
    moved = [
        ring.normal(sum((a * b for a, b in zip(row, motion, strict=True) if a and b), ring.ring.zero)) for row in twist
    ]
    return primitive(work, moved) if any(moved) else None


def _unit_rates(work: SymbolicScrews, motion: Row, factors: Sequence[Quotient]) -> Row:
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
        raise FormulaTooLargeError(f"a component has {longest} terms")
    return tuple(work.ring.expression(c) for c in vector)


def _rows(network: Network, screws: dict[str, list[Row]], steps: Sequence[tuple[str, int]], zero: Poly) -> list[Row]:
    rows = [[zero] * network.freedoms for _ in range(6)]
    for name, sign in steps:
        for column, screw in zip(network.edges[name].columns, screws[name], strict=True):
            for i in range(6):
                rows[i][column] = sign * screw[i] if screw[i] else zero
    return rows


@dataclass(frozen=True)
class PolynomialMotions:
    """`vectors`: null space of rows, without poles; `dependent`: common factor of the determinants of full size.

    Where `dependent` is zero the rows lose rank; `minors_left_out`: number of determinants, where these were too many
    to look for it (it is 1 then). `all_listed`: whether rank is known to be lost nowhere else.
    """

    vectors: list[Row]
    dependent: Poly
    minors_left_out: int = 0
    all_listed: bool = True


def motions_by_minors(work: SymbolicScrews, rows: Sequence[Row], columns: int) -> PolynomialMotions:
    """The null space of polynomial rows; raises FormulaTooLargeError."""
    ring = work.ring
    budget = Budget(work)
    left, solved = _constants_solved(work, [row for row in rows if any(row)], columns, budget)
    open_columns = [j for j in range(columns) if j not in dict(solved)]
    independent = work.independent_rows([[row[j] for j in open_columns] for row in left], len(open_columns))
    left = [left[i] for i in independent]
    small = _cramer(work, left, open_columns, budget)
    vectors = []
    for vector in small.vectors:
        full = [ring.ring.zero] * columns
        for j, c in zip(open_columns, vector, strict=True):
            full[j] = c
        for j, row in reversed(solved):
            parts = (budget.product(row[k], full[k]) for k in range(columns) if k != j and row[k] and full[k])
            total = sum(parts, ring.ring.zero)
            full[j] = -_limited(ring.normal(total)).mul_ground(1 / row[j].coeff(1))
        vectors.append(primitive(work, full))
    return PolynomialMotions(vectors, small.dependent, small.minors_left_out, small.all_listed)


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


class _Minors:
    """Determinants of the last rows of a matrix on chosen columns, each made once."""

    def __init__(self, work: SymbolicScrews, matrix: list[Row], budget: Budget) -> None:
        self.ring, self.matrix, self.budget = work.ring, matrix, budget
        self._known: dict[tuple[tuple[int, ...], int], Poly] = {}

    def __call__(self, chosen: tuple[int, ...], depth: int = 0) -> Poly:
        """Of the rows from `depth` on."""
        if not chosen:
            return self.ring.ring.one
        if (chosen, depth) not in self._known:
            total = self.ring.ring.zero
            for place, j in enumerate(chosen):
                if self.matrix[depth][j]:
                    part = self(chosen[:place] + chosen[place + 1 :], depth + 1)
                    if part:
                        term = self.budget.product(self.matrix[depth][j], part)
                        total = total + term if place % 2 == 0 else total - term
            self._known[chosen, depth] = _limited(self.ring.normal(total))
        return self._known[chosen, depth]


def _cramer(work: SymbolicScrews, rows: list[Row], columns: Sequence[int], budget: Budget) -> PolynomialMotions:
    """Null vectors over `columns` by determinants, and the common factor of the determinants of full size."""
    ring = work.ring
    rank, count = len(rows), len(columns)
    matrix = [[row[j] for j in columns] for row in rows]
    if rank == 0:
        unit = [[ring.ring.one if i == j else ring.ring.zero for i in range(count)] for j in range(count)]
        return PolynomialMotions(unit, ring.ring.one)
    minor = _Minors(work, matrix, budget)
    values = [[ring.number(c, work.somewhere) if c else 0 for c in row] for row in matrix]
    used = tuple(sorted(eliminate(values, count).pivots))
    base = minor(used)
    vectors = []
    for free in (j for j in range(count) if j not in used):
        vector = [ring.ring.zero] * count
        vector[free] = base
        for place, j in enumerate(used):
            order = tuple(sorted(free if k == j else k for k in used))
            vector[j] = -((-1) ** (place + order.index(free))) * minor(order)
        vectors.append(vector)
    minors = comb(count, rank)
    if minors <= MOST_MINORS:
        found = [minor(chosen) for chosen in combinations(range(count), rank)]
        common, quotients = ring.shared(found)
        return PolynomialMotions(vectors, common, all_listed=ring.all_listed(common, quotients))
    # a determinant that is a number settles it: the rank is never lost
    return PolynomialMotions(vectors, ring.ring.one, 0 if base.is_ground else minors)


def primitive(work: SymbolicScrews, vector: Sequence[Poly]) -> Row:
    """The vector without the common factor of its components, its first coefficient positive."""
    divided = work.ring.without_roots_in(work.ring.primitive(vector))
    first = next(c for c in divided if c)
    return [-c for c in divided] if first.LC < 0 else divided


def _limited(poly: Poly) -> Poly:
    if len(poly.terms()) > MOST_TERMS:
        raise FormulaTooLargeError(f"an intermediate polynomial has more than {MOST_TERMS} terms")
    return poly
