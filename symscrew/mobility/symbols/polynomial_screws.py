"""Constraints and freedoms of limbs and platform in the description's parameters, eqs. (11)-(18) with symbols.

    limb --screws--> polynomials S --Cramer--> wrenches (S^T N w = 0) --union, Cramer--> freedoms of the platform

Null vectors come from minors (Cramer), so they are polynomial in the generators and have no poles; common factors
are taken out. What the factors mean is reported as loci: where a limb's screws become dependent (limb
singularity), where the union of the constraints loses rank (constraint singularity), where a force becomes a
couple. Rows and columns of the minors are chosen at random values of the parameters, so ranks are generic.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
import sympy

from symscrew.algebra import IDENTITY, as_vector, high_precision
from symscrew.description import Joint, Mechanism
from symscrew.kinematics import motion_screws
from symscrew.mobility.carrying_limbs import carried_by_limbs
from symscrew.mobility.screw_systems import Screw, eliminate, unit_rows
from symscrew.mobility.symbols.exact_screws import across
from symscrew.mobility.symbols.generators import Generators, NotPolynomialError, Poly, Quotient
from symscrew.mobility.symbols.loci_at_points import Shape, true_loci
from symscrew.mobility.symbols.locus import AT_ONCE, Locus

Vector = tuple[sympy.Expr, ...]
SEED = 840
"""Of the place in general position at which rows and columns are chosen: always the same, so that results repeat."""


@dataclass(frozen=True)
class SymbolicLimb:
    """Screws (omega ; v) as columns without their scale, constraints (f ; m) and their number for generic values."""

    name: str
    screws: tuple[Vector, ...]
    constraints: tuple[Vector, ...]


@dataclass(frozen=True)
class SymbolicMobility:
    """Constraints and freedoms in the parameters; `loci` where they degenerate.

    Those of the platform are empty where it is not limbs alone that carry it (`carried_by_limbs`).
    """

    parameters: tuple[sympy.Symbol, ...]
    limbs: tuple[SymbolicLimb, ...]
    constraints: tuple[Vector, ...]
    freedoms: tuple[Vector, ...]
    loci: tuple[Locus, ...]
    not_tried: tuple[str, ...] = ()


class Reciprocal(NamedTuple):
    """Null vectors of the reciprocal product with screws; common factor of all maximal minors of these.

    `all_listed`: whether they are known to lose rank nowhere but where that factor is zero.
    """

    wrenches: list[list[Poly]]
    dependent: Poly
    all_listed: bool


def symbolic_mobility(mechanism: Mechanism, *, work: SymbolicScrews | None = None) -> SymbolicMobility | None:
    """The limbs and the platform with symbols; None without limbs or where an expression has no exact ring.

    `work`: the mechanism's `symbolic_screws` where somebody has them already, with what was found of them.
    """
    if not mechanism.limbs or mechanism.platform is None:
        return None
    try:
        return (work or symbolic_screws(mechanism)).run()
    except NotPolynomialError:
        return None


def symbolic_screws(mechanism: Mechanism) -> SymbolicScrews:
    """The ring of the limbs' geometry, without limbs of all joints; raises NotPolynomialError where there is none."""
    joints = [mechanism.joints[j] for limb in mechanism.limbs.values() for j in limb.joints]
    given = [e for joint in joints or mechanism.joints.values() for e in expressions_of(joint)]
    return SymbolicScrews(mechanism, Generators(mechanism, given))


def expressions_of(joint: Joint) -> list[sympy.Expr]:
    """The expressions that a joint's screws are made of."""
    pitch = [] if joint.pitch is None else [joint.pitch]
    return [*joint.point, *(c for axis in joint.axes for c in axis), *pitch]


def screws_of_limbs(mechanism: Mechanism) -> SymbolicScrews | None:
    """`symbolic_screws`; None without limbs or where an expression has no exact ring."""
    try:
        return symbolic_screws(mechanism) if mechanism.limbs else None
    except NotPolynomialError:
        return None


def why_no_symbols(mechanism: Mechanism) -> str:
    """Why limbs and platform have none, in words: an expression without an exact ring, or the size of what follows."""
    try:
        symbolic_screws(mechanism)
    except NotPolynomialError as error:
        return f"no symbols: {error}"
    return "no symbols: the closed forms are not of reasonable size"


class SymbolicScrews:
    """Screws, wrenches and where they degenerate, over one ring."""

    def __init__(self, mechanism: Mechanism, ring: Generators) -> None:
        self.mechanism, self.ring = mechanism, ring
        random = np.random.default_rng(SEED)
        # near the given values, where square roots stay real, but in general position
        self.somewhere = {
            symbol: sympy.N(ring.values[symbol], 60) * (1 + sympy.Rational(int(random.integers(1, 900)), 50021))
            + sympy.Rational(int(random.integers(1, 900)), 100003)
            for symbol in ring.parameters
        }
        self.loci: list[Locus] = []
        self._scaled: dict[str, list[tuple[list[Poly], Quotient]]] = {}
        self._limbs: dict[tuple[str, frozenset[tuple[str, int]]], Reciprocal] = {}

    def run(self) -> SymbolicMobility:
        """Limbs, their constraints, the platform's freedoms and where they degenerate."""
        limbs, union, open_ones = [], list[list[Poly]](), list[str]()
        self.loci = []
        for name, limb in self.mechanism.limbs.items():
            screws = [screw for joint in limb.joints for screw in self.screws(self.mechanism.joints[joint])]
            wrenches, dependent, all_listed = self.of_limb(name)
            open_ones += [] if all_listed else [name]
            self._note("limb", name, dependent, "the screws of the limb become dependent")
            for wrench in wrenches:
                self._note_wrench(name, wrench)
            limbs.append(SymbolicLimb(name, self._vectors(screws), self._vectors(wrenches)))
            union += wrenches
        parameters = tuple(self.ring.parameters)
        if not carried_by_limbs(self.mechanism):
            loci = true_loci(self.shape, self.loci)
            return SymbolicMobility(parameters, tuple(limbs), (), (), loci, self._not_listed(loci, open_ones))
        freedoms, dependent, all_listed = self.of_all_limbs
        open_ones += [] if all_listed else [self.mechanism.platform or ""]
        meaning = "the constraints of the limbs become dependent"
        self._note("constraint", self.mechanism.platform or "", dependent, meaning)
        loci = true_loci(self.shape, self.loci)
        constraints, moved = self._vectors(union), self._vectors(freedoms)
        return SymbolicMobility(parameters, tuple(limbs), constraints, moved, loci, self._not_listed(loci, open_ones))

    def of_limb(self, limb: str, locked: Collection[tuple[str, int]] = ()) -> Reciprocal:
        """What is reciprocal to the limb's screws without those of the `locked` freedoms (joint, number)."""
        key = (limb, frozenset(locked))
        if key not in self._limbs:
            joints = [self.mechanism.joints[name] for name in self.mechanism.limbs[limb].joints]
            screws = [screw for joint in joints for k, screw in enumerate(self.screws(joint))
                      if (joint.name, k) not in locked]  # fmt: skip
            self._limbs[key] = self.reciprocal(screws)
        return self._limbs[key]

    @cached_property
    def shape(self) -> Shape:
        """The geometry in numbers, for loci at their zeros."""
        return Shape(self.mechanism)

    @cached_property
    def of_all_limbs(self) -> Reciprocal:
        """What is reciprocal to the constraints of all limbs."""
        return self.reciprocal([wrench for name in self.mechanism.limbs for wrench in self.of_limb(name).wrenches])

    def _not_listed(self, loci: Sequence[Locus], names: Sequence[str]) -> tuple[str, ...]:
        """That rank may be lost elsewhere; so, too, where a factor was of rows that others take the place of."""
        dropped = {locus.where for locus in self.loci if locus.kind in ("limb", "constraint") and locus not in loci}
        every = [name for name in (*self.mechanism.limbs, self.mechanism.platform or "") if name in {*names, *dropped}]
        return (f"{', '.join(every)}, {AT_ONCE}",) if every else ()

    def screws(self, joint: Joint) -> list[list[Poly]]:
        """Screws of a joint as polynomials: each times its common denominator."""
        return [screw for screw, _ in self.scaled_screws(joint)]

    def scaled_screws(self, joint: Joint) -> list[tuple[list[Poly], Quotient]]:
        """(screw as polynomials, what the unit screw was multiplied by) for each freedom of the joint."""
        if joint.name not in self._scaled:
            self._scaled[joint.name] = [self.scalars().cleared(screw) for screw in self.unit_screws(joint)]
        return self._scaled[joint.name]

    def scalars(self) -> Scalars:
        """Fractions over the ring, with arithmetic."""
        return Scalars(self.ring)

    def unit_screws(self, joint: Joint) -> list[tuple[Any, ...]]:
        """Screws of the joint as fractions, as long as its axes are (a planar joint's are completed without roots)."""
        scalars = self.scalars()
        point = tuple(scalars.read(c) for c in joint.point)
        axes = tuple(as_vector([scalars.read(c) for c in axis]) for axis in joint.axes)
        present = [self.mechanism.number(c) != 0 for axis in joint.axes[:1] for c in axis]
        axes = joint.kind.motion_axes(axes, IDENTITY, lambda normal: across(normal, present)[:2])
        pitch = scalars.read(joint.pitch) if joint.pitch is not None else None
        made = motion_screws(joint.kind, axes, point, pitch)
        return [twist.components for _, twists in made for twist in twists]

    def reciprocal(self, screws: Sequence[Sequence[Poly]]) -> Reciprocal:
        """What is reciprocal to all of the screws, and where they become dependent."""
        ring = self.ring
        rows = [[*screws[i][3:], *screws[i][:3]] for i in self.independent(screws)]
        rank = len(rows)
        if rank == 0:
            every = [[ring.ring.one if i == j else ring.ring.zero for i in range(6)] for j in range(6)]
            return Reciprocal(every, ring.ring.one, all_listed=True)
        minors = {columns: ring.determinant([[row[j] for j in columns] for row in rows])
                  for columns in combinations(range(6), rank)}  # fmt: skip
        common, quotients = ring.shared(list(minors.values()))
        used = max(
            (columns for columns, minor in minors.items() if minor),
            key=lambda columns: (-len(minors[columns].terms()), abs(ring.number(minors[columns], self.somewhere))),
        )
        vectors = [self._cramer(minors, used, free) for free in range(6) if free not in used]
        wrenches = [self._primitive(vector) for vector in vectors]
        return Reciprocal(wrenches, common, ring.all_listed(common, quotients))

    def independent_rows(self, rows: Sequence[Sequence[Poly]], columns: int) -> list[int]:
        """Indices of the first rows that are linearly independent for generic values of the parameters."""
        return _independent([[self.ring.number(c, self.somewhere) if c else 0 for c in row] for row in rows], columns)

    def independent(self, screws: Sequence[Sequence[Poly]]) -> list[int]:
        """Indices of the first screws that are linearly independent for generic values of the parameters."""
        return _independent([[self.ring.number(c, self.somewhere) for c in screw] for screw in screws])

    def _cramer(self, minors: dict[tuple[int, ...], Poly], used: tuple[int, ...], free: int) -> list[Poly]:
        """x_free = det(used), x_j = -+ det(used with j replaced by free): rows x = 0."""
        zero = self.ring.ring.zero
        vector = [zero] * 6
        vector[free] = minors[used]
        for place, j in enumerate(used):
            replaced = [free if k == j else k for k in used]
            order = tuple(sorted(replaced))
            sign = (-1) ** (place + order.index(free))
            vector[j] = -sign * minors[order]
        return vector

    def _primitive(self, vector: list[Poly]) -> list[Poly]:
        """The vector with the common factor of its components taken out, first coefficient positive."""
        divided = self.ring.primitive(vector)
        first = next(c for c in divided if c)
        return [-c if first.LC < 0 else c for c in divided]

    def _note(self, kind: str, where: str, factor: Poly, meaning: str) -> None:
        for part in self.ring.factors(factor):
            locus = Locus(kind, where, self.ring.expression(part), meaning)
            if locus not in self.loci:
                self.loci.append(locus)

    def _note_wrench(self, limb: str, wrench: list[Poly]) -> None:
        """Where a wrench with a force becomes a couple, and where one with a moment passes through O."""
        force = self.ring.common_factor(wrench[:3])
        moment = self.ring.common_factor(wrench[3:])
        if any(wrench[:3]) and any(wrench[3:]):
            self._note("couple", limb, force, "the constraint force becomes a couple")
            self._note("through O", limb, moment, "the constraint is a force through O")

    def _vectors(self, screws: Sequence[Sequence[Poly]]) -> tuple[Vector, ...]:
        return tuple(tuple(self.ring.expression(c) for c in screw) for screw in screws)


class Scalars:
    """Fractions with + - *, for the generic screw functions."""

    def __init__(self, ring: Generators) -> None:
        self.ring = ring

    def read(self, expression: sympy.Expr) -> Any:
        """The expression as a fraction with arithmetic."""
        return _Scalar(self.ring, self.ring.read(expression))

    def cleared(self, components: Sequence[Any]) -> tuple[list[Poly], Quotient]:
        """(the components times their common denominator, without common factors; what they were multiplied by)."""
        ring = self.ring
        one = ring.ring.one
        given = [c.value if isinstance(c, _Scalar) else Quotient(one * c, one) for c in components]
        denominators: list[Poly] = []
        for fraction in given:
            if fraction.numerator and fraction.denominator not in denominators and fraction.denominator != 1:
                denominators.append(fraction.denominator)
        multiple = one
        for denominator in denominators:
            multiple = multiple.lcm(denominator)
        cleared = [
            ring.product(f.numerator, multiple.exquo(f.denominator)) if f.numerator else ring.ring.zero for f in given
        ]
        common, divided = ring.shared(cleared)
        return divided, Quotient(multiple, common)


class _Scalar:
    def __init__(self, ring: Generators, value: Quotient) -> None:
        self.ring, self.value = ring, value

    def _other(self, other: Any) -> Quotient:
        one = self.ring.ring.one
        return other.value if isinstance(other, _Scalar) else Quotient(one * other, one)

    def __add__(self, other: Any) -> _Scalar:
        a, b = self.value, self._other(other)
        if a.denominator == b.denominator:
            return _Scalar(self.ring, self.ring.cancelled(self.ring.normal(a.numerator + b.numerator), a.denominator))
        top = self.ring.product(a.numerator, b.denominator) + self.ring.product(b.numerator, a.denominator)
        return _Scalar(self.ring, self.ring.cancelled(top, self.ring.product(a.denominator, b.denominator)))

    __radd__ = __add__

    def __mul__(self, other: Any) -> _Scalar:
        a, b = self.value, self._other(other)
        top = self.ring.product(a.numerator, b.numerator)
        return _Scalar(self.ring, self.ring.cancelled(top, self.ring.product(a.denominator, b.denominator)))

    __rmul__ = __mul__

    def __sub__(self, other: Any) -> _Scalar:
        return self + _Scalar(self.ring, self._other(other)) * -1

    def __rsub__(self, other: Any) -> _Scalar:
        return _Scalar(self.ring, self._other(other)) + self * -1


def _independent(rows: Sequence[Sequence[Any]], columns: int = 6) -> list[int]:
    """Indices of the first rows that are linearly independent."""
    chosen: list[int] = []
    for i in range(len(rows)):
        if eliminate(unit_rows([rows[k] for k in (*chosen, i)]), columns).rank == len(chosen) + 1:
            chosen.append(i)
    return chosen


def numbers_at(vectors: Sequence[Vector], mechanism: Mechanism) -> list[Screw]:
    """Symbolic vectors at the parameters' values, 60 digits."""
    return [tuple(high_precision(mechanism.number(c)) for c in vector) for vector in vectors]
