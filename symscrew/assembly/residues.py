"""The numbers of one mechanism modulo a prime, exactly: roots, sines of parts of a turn, lengths and angles held.

    expressions --exact field--> Q(theta)(sqrt r1)(sqrt r2) --a root of each generator modulo p--> residues
    held angles --powers of one point of the circle--> residues of their cosines and sines

Numbers of the field whose denominators p does not divide map to residues as a ring does, whichever roots are taken. The
cosine of a fraction [rad] is transcendental (F. Lindemann, 1882), so that polynomials in the cosines and sines of
multiples of one angle map by any point of the circle. Rank, and with it a bound by a Groebner basis, only falls on the
way, where every zero of the mechanism has residues too: what that asks for stands in `root_bounds`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from math import gcd, lcm
from random import Random
from typing import Any

import sympy

from symscrew.algebra import CONTEXT, high_precision
from symscrew.assembly.closure_structure import Structure
from symscrew.assembly.elementary_graph import held_graph
from symscrew.assembly.held_structure import held_structure
from symscrew.assembly.slot_numbers import Displacements, Scalars
from symscrew.assembly.what_is_held import Held
from symscrew.mobility import Edge, Exact, Field, Network, NotDecidableError, exact_system, exact_value

LARGEST_PRIME = 2147483629
"""The largest prime below 2^31 - 1: coefficients of 31 bits are what Singular takes."""
MOST_PRIMES = 4000
"""Looked at for one in which all roots are: with five square roots one in 32 has them."""


class Residue:
    """A number in 60 digits and modulo a prime; sums and products of both at once."""

    __slots__ = ("prime", "rest", "value")

    def __init__(self, value: Any, rest: int, prime: int) -> None:
        self.value, self.rest, self.prime = value, rest % prime, prime

    def _of(self, other: Any) -> Residue:
        if isinstance(other, Residue):
            return other
        if int(other) != other:
            raise NotDecidableError(f"{other} came without its residue")
        return Residue(CONTEXT.mpf(other), int(other), self.prime)

    def __add__(self, other: Any) -> Residue:
        o = self._of(other)
        return Residue(self.value + o.value, self.rest + o.rest, self.prime)

    __radd__ = __add__

    def __neg__(self) -> Residue:
        return Residue(-self.value, -self.rest, self.prime)

    def __sub__(self, other: Any) -> Residue:
        return self + -self._of(other)

    def __rsub__(self, other: Any) -> Residue:
        return self._of(other) - self

    def __mul__(self, other: Any) -> Residue:
        o = self._of(other)
        return Residue(self.value * o.value, self.rest * o.rest, self.prime)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Residue:
        o = self._of(other)
        if not o.rest:
            raise NotDecidableError("a denominator that the prime divides")
        return Residue(self.value / o.value, self.rest * pow(o.rest, -1, self.prime), self.prime)

    def __rtruediv__(self, other: Any) -> Residue:
        return self._of(other) / self

    def __pow__(self, power: float) -> Residue:
        """Only the square root of 1: others would be new roots."""
        if power != 0.5 or self.rest != 1:
            raise NotDecidableError("a root that is not in the field")
        return self

    def __float__(self) -> float:
        return float(self.value)

    def __bool__(self) -> bool:
        return bool(self.rest)


class Angle:
    """A held angle: `multiple` of the unit, then `turn` (cosine, sine) in the field; times 1 or -1."""

    def __init__(self, multiple: int, turn: tuple[Residue, Residue], value: Any) -> None:
        self.multiple, self.turn, self.value = multiple, turn, value

    def __rmul__(self, sign: int) -> Angle:
        return self if sign > 0 else Angle(-self.multiple, (self.turn[0], -self.turn[1]), -self.value)


def residues_of(held: Held, *, most: int = LARGEST_PRIME) -> tuple[Structure, list[Any], int]:
    """(structure with lengths in other units, numbers in its slots modulo a prime, the prime, `most` or less).

    Raises:
        NotDecidableError: numbers that are in no such field. NotAlgebraicError: as of the structure.
    """
    return NumbersOf(held).residues(most)


class NumbersOf:
    """Points, screws, lengths and held angles of a mechanism, exactly; here modulo a prime."""

    def __init__(self, held: Held) -> None:
        self.held, self.mechanism = held, held.mechanism
        self.moved = {c: e for c, e in held.given.items() if e != 0}
        self.turning = {c for e in held.network.edges.values() for m, c in e.motions if m.turns}
        self.turning |= {link.column for link in held.links if link.turning}
        self.tied = {c for link in held.links for c in link.factors}
        fractions, parts = dict[int, Fraction](), dict[int, sympy.Expr]()
        for column in self.turning & set(self.moved):
            fractions[column], parts[column] = _split(self.moved[column])
        self.unit = lcm(*(f.denominator for f in fractions.values()))
        self.fractions, self.parts = fractions, parts
        angles = [f(e) for e in parts.values() for f in (sympy.cos, sympy.sin)]
        self.system = exact_system(self.mechanism, angles)
        self.field: Field = self.system.field
        self.points = {n: [self.field.read(self.mechanism.number(c)) for c in j.point]
                       for n, j in self.mechanism.joints.items()}  # fmt: skip
        self.lengths = {c: self.field.read(e) for c, e in self.moved.items() if c not in self.turning}
        self.turns = {c: (self.field.read(sympy.cos(e)), self.field.read(sympy.sin(e))) for c, e in parts.items()}
        self.screws = {n: [self._screw(n, k) for k in range(len(s))] for n, s in self.system.screws.items()}

    def _screw(self, joint: str, place: int) -> tuple[Exact, ...]:
        """A freedom's screw; of unit length and in its sense where the freedom is held elsewhere, or a coupling's."""
        edge = self.held.network.edges[joint]
        screw, column = self.system.screws[joint][place], edge.start + place
        if column not in self.moved and column not in self.tied:
            return tuple(screw)
        part = slice(0, 3) if column in self.turning else slice(3, 6)
        length = self.field.sqrt(sum((c * c for c in screw[part]), Fraction(0)))
        known = edge.screws[place][part]
        same = sum(exact_value(a) * b for a, b in zip(screw[part], known, strict=True)) > 0
        scale = (1 if same else -1) / length
        return tuple(c * scale for c in screw)

    def residues(self, most: int = LARGEST_PRIME) -> tuple[Structure, list[Any], int]:
        """As `residues_of` has them."""
        self.take_prime(most)
        structure, slots = self.in_slots()
        return structure, [s.rest if isinstance(s, Residue) else [c.rest for c in s] for s in slots], self.prime

    def take_prime(self, most: int = LARGEST_PRIME) -> None:
        """Chooses the prime, the roots in it, and the tangent of half the angle that is the unit of held ones."""
        self.prime, self.roots = self._prime(most)
        self.tangent = Random(self.prime).randrange(self.prime)

    def in_slots(self) -> tuple[Structure, list[Any]]:
        """The structure with lengths in other units, and its numbers as they are read here."""
        edges = {name: self._edge(edge) for name, edge in self.held.network.edges.items()}
        network = replace(self.held.network, edges=edges)
        structure = structure_in(network, self.held)
        values = {c: self._value(c) for c in self.held.chosen}
        scalars = Scalars(lambda v: self._circle(v)[0], lambda v: self._circle(v)[1], self._read)
        return structure, Displacements(structure, scalars, values).slots()

    def _prime(self, most: int) -> tuple[int, Mapping[Any, int]]:
        """A prime in which every generator has a root, and these roots."""
        step = lcm(2, self.field.unit)
        for k in range(MOST_PRIMES):
            prime = most - most % step + 1 - k * step
            if prime <= most and sympy.isprime(prime):
                roots = self._roots(prime)
                if roots is not None:
                    return prime, roots
        raise NotDecidableError("no prime was found in which all roots are")

    def _roots(self, prime: int) -> dict[Any, int] | None:
        found: dict[Any, int] = {}
        for generator in self.field.generators:
            if generator.conjugates:
                found[generator] = _cosine(self.field.unit, prime)
                continue
            root = sympy.sqrt_mod(-_rest(generator.modulus[0], found, prime) % prime, prime)
            if root is None:
                return None
            found[generator] = int(root)
        return found

    def _read(self, value: Any) -> Any:
        return value if isinstance(value, Residue) else Residue(CONTEXT.zero, 0, self.prime) + value

    def _exact(self, x: Exact) -> Any:
        return Residue(exact_value(x), _rest(x, self.roots, self.prime), self.prime)

    def _scale(self) -> Any:
        """A length of the mechanism's size, a fraction: thresholds are in such units."""
        return self._exact(1 / Fraction(float(self.held.network.length)))

    def _edge(self, edge: Edge) -> Edge:
        x, y, z = (self._exact(c) * self._scale() for c in self.points[edge.name])
        screws = tuple(tuple(self._exact(c) for c in screw) for screw in self.screws[edge.name])
        return replace(edge, point=(x, y, z), screws=screws)

    def _value(self, column: int) -> Any:
        if column not in self.moved:
            return self._read(0) if column not in self.turning else Angle(0, (self._read(1), self._read(0)), 0)
        if column not in self.turning:
            return self._exact(self.lengths[column]) * self._scale()
        cosine, sine = (self._exact(c) for c in self.turns[column])
        multiple = int(self.fractions[column] * self.unit)
        return Angle(multiple, (cosine, sine), high_precision(self.moved[column]))

    def _circle(self, angle: Any) -> tuple[Any, Any]:
        """Cosine and sine: a power of the point that stands for the unit, turned on."""
        if not isinstance(angle, Angle):  # of a freedom that is held where it is
            return self._read(1), self._read(0)
        p = self.prime
        tangent = self.tangent
        below = pow(1 + tangent * tangent, -1, p)
        c, s = _power((1 - tangent * tangent) * below % p, 2 * tangent * below % p, abs(angle.multiple), p)
        s = s if angle.multiple >= 0 else -s
        (a, b), value = angle.turn, angle.value
        return (Residue(CONTEXT.cos(value), a.rest * c - b.rest * s, p),
                Residue(CONTEXT.sin(value), a.rest * s + b.rest * c, p))  # fmt: skip


def structure_in(network: Network, held: Held) -> Structure:
    """The structure of a network whose numbers are of another kind."""
    graph = held_graph(network, held.chosen, held.mechanism.platform, held.links)
    points = [edge.point for edge in network.edges.values()]
    x, y, z = (sum(p[k] for p in points) / len(points) for k in range(3))
    return held_structure(graph, (x, y, z), held.mechanism.platform)


def _split(angle: sympy.Expr) -> tuple[Fraction, sympy.Expr]:
    """A fraction, and what is left of an angle: a part of a turn, or what else has an algebraic cosine."""
    rest = sympy.expand(angle)
    number = rest.as_coeff_Add()[0]
    left = rest - number
    if not number.is_Rational:
        raise NotDecidableError(f"the angle {angle} has no fraction")
    return Fraction(int(number.p), int(number.q)), left


def _rest(x: Exact, roots: Mapping[Any, int], prime: int) -> int:
    """An exact number modulo the prime."""
    if hasattr(x, "generator"):
        total = 0
        for c in reversed(x.coefficients):
            total = (total * roots[x.generator] + _rest(c, roots, prime)) % prime
        return total
    fraction = Fraction(x)
    if gcd(fraction.denominator, prime) != 1:
        raise NotDecidableError("a denominator that the prime divides")
    return fraction.numerator * pow(fraction.denominator, -1, prime) % prime


def _cosine(n: int, prime: int) -> int:
    """r + 1 / r of an element of order n, the residue of 2 cos(2 pi / n)."""
    divisors = list(sympy.factorint(n))
    for base in _bases():
        r = pow(base, (prime - 1) // n, prime)
        if all(pow(r, n // d, prime) != 1 for d in divisors):
            return (r + pow(r, -1, prime)) % prime
    raise AssertionError("a prime field has elements of every order that divides p - 1")


def _bases() -> Iterator[int]:
    yield from range(2, 10**6)


def _power(c: int, s: int, exponent: int, prime: int) -> tuple[int, int]:
    """(c + i s)^exponent."""
    x, y = 1, 0
    while exponent:
        if exponent & 1:
            x, y = (x * c - y * s) % prime, (x * s + y * c) % prime
        c, s = (c * c - s * s) % prime, 2 * c * s % prime
        exponent >>= 1
    return x, y
