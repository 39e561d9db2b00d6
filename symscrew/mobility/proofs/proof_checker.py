"""Checks the proof file of a mobility verdict. This file imports nothing else of the package: Python is enough.

    python proof_checker.py FILE        exit 0: every claim is proved;  1: one is not;  2: not such a file

The file has the mechanism in exact numbers, the claims, and the evidence. The screws, loops and matrices are made here
from the mechanism; from the evidence come only what is quick to check and long to find:

    rank at least r     a minor of r rows and columns: no pivot of its elimination in intervals contains zero
    rank at most r      columns - r independent vectors that the matrix maps to zero, exactly
    at rest             independent screws of joints in the loops that these make among themselves; others go on alone
    smooth              every loop moves in a group of displacements (a basis closed under the screw bracket), and the
                        rank is the sum of their dimensions: implicit functions;
                        or limbs between two bodies of which each reaches all of a group;
                        or smooth in the loops of some of the joints, and the other loops independent of these;
                        or parts that are smooth without couplings, and couplings independent of them;
                        or the only motion of a loop of six freedoms, shut to an order that no isolated one has
    isolated            a self-stress that does work on the only motion at some order, all lower orders closed; or
                        one whose quadratic form is definite
    branches            one redundant equation with a quadratic form that is not degenerate: a cone (Morse);
                        or smooth parts whose equations, multiplied, are combinations of the loops' polynomials, and the
                        other way round, up to factors that are not zero in the configuration
    at least d          a zero of all quadratic forms at which they are independent, in a box that Krawczyk's
                        operator maps into itself: a branch of dimension d along it

Numbers are rational, or polynomials in generators: roots of a polynomial in an interval, or (without a polynomial)
any number of an interval; then the claims hold for all mechanisms with numbers in the intervals. An identity of such
polynomials holds for the numbers; an interval without zero shows that a number is not zero. Screws at O, (omega ; v).

A coupling keeps a sum of polynomials of coordinates at its value: sum p_j(x_j), x_j from `at` in the configuration. It
is a row of the closure beside the six of a loop. Files with couplings are of format 2, which has nothing else new.
"""

from __future__ import annotations

import hashlib
import json
import re
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations, permutations, product
from math import lcm
from operator import add
from typing import Any

BITS = 320
"""Binary digits after the point of interval ends: far more than the 200 that generators are given with."""
ONE = 1 << BITS
LONGEST = 200_000
"""Characters of one number: longer ones are no mechanism's, and would only keep the reader waiting."""
LARGEST = 256
"""Exponent of a generator, and degree of its polynomial, for the same reason."""
FORMAT, COUPLED = "symscrew mobility proof 1", "symscrew mobility proof 2"
"""Of files without couplings, and with them: who knows of none must not judge such a mechanism."""
UNIT = ONE >> 140
"""How far the square of a coupled axis may be from 1, since coordinates are counted along unit axes: what numbers of 50
digits leave open is a million times less, what a rounded decimal does is more."""
MOST_WAYS = 16
"""In which six joints reach a pose: the largest multiplicity of an isolated one."""
WHOLE = "all displacements"
"""Instead of a basis: the group of all rigid displacements, of dimension 6."""
Interval = tuple[int, int]
Key = tuple[int, ...]


class RefusedError(Exception):
    """The evidence does not carry the claim."""


class UnreadableError(Exception):
    """The file is not a proof file."""


def need(holds: bool, why: str) -> None:
    """Refuses with the reason where something does not hold."""
    if not holds:
        raise RefusedError(why)


# -- numbers ----------------------------------------------------------------------------------------------


class Number:
    """A polynomial in the generators: exponents -> rational coefficient."""

    __slots__ = ("terms", "within")

    def __init__(self, within: Numbers, terms: dict[Key, Fraction]) -> None:
        self.within, self.terms = within, terms

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __add__(self, other: Number) -> Number:
        if not other.terms or not self.terms:
            return other if other.terms else self
        terms = dict(self.terms)
        for key, c in other.terms.items():
            total = terms.get(key, 0) + c
            if total:
                terms[key] = Fraction(total)
            else:
                del terms[key]
        return Number(self.within, terms)

    def __neg__(self) -> Number:
        return Number(self.within, {key: -c for key, c in self.terms.items()})

    def __sub__(self, other: Number) -> Number:
        return self + -other

    def __mul__(self, other: Number) -> Number:
        if not self.terms or not other.terms:
            return self.within.zero
        if not self.within.count:  # rational numbers have one term each
            return Number(self.within, {(): self.terms[()] * other.terms[()]})
        terms: dict[Key, Fraction] = {}
        for a, x in self.terms.items():
            for b, y in other.terms.items():
                key = tuple(i + j for i, j in zip(a, b, strict=True))
                terms[key] = terms.get(key, Fraction(0)) + x * y
        return self.within.reduced(terms)


class Numbers:
    """The numbers of a file: its generators, their equations and intervals."""

    def __init__(self, generators: Sequence[Any]) -> None:
        self.count = len(generators)
        self.low: list[list[Number] | None] = [None] * self.count
        self.between: list[Interval] = []
        self.zero = Number(self, {})
        for k, entry in enumerate(generators):
            low, high = (_rational(end) for end in entry["between"])
            need(low <= high, f"generator {k}: its interval is empty")
            if "polynomial" in entry:
                given = [self.read(c) for c in entry["polynomial"]]
                below = all(not any(key[k:]) for c in given for key in c.terms)
                need(1 < len(given) <= LARGEST and below, f"generator {k}: no polynomial over those before")
                ends = [self._signs(given, end) for end in (low, high)]
                opposite = ends[0][1] < 0 < ends[1][0] or ends[1][1] < 0 < ends[0][0]
                need(opposite, f"generator {k}: no root in its interval")
                self.low[k] = given
            self.between.append((low.numerator * ONE // low.denominator, -(-high.numerator * ONE // high.denominator)))
        self.one = self.rational(Fraction(1))

    def rational(self, value: Fraction) -> Number:
        """A rational number."""
        return Number(self, {(0,) * self.count: value} if value else {})

    def read(self, value: Any) -> Number:
        """A number of the file: "p/q", or [["p/q", exponent, ...], ...]."""
        if isinstance(value, str):
            return self.rational(_rational(value))
        terms: dict[Key, Fraction] = {}
        for coefficient, *exponents in value:
            sound = len(exponents) == self.count and all(type(e) is int and 0 <= e <= LARGEST for e in exponents)
            if not sound or tuple(exponents) in terms:
                raise UnreadableError(f"expected {self.count} exponents of generators, got {exponents}")
            terms[tuple(exponents)] = _rational(coefficient)
        return self.reduced(terms)

    def reduced(self, terms: dict[Key, Fraction]) -> Number:
        """The polynomial with high powers of the generators replaced by their equations."""
        for k in reversed(range(self.count)):
            low = self.low[k]
            while low is not None and (high := [key for key in terms if key[k] >= len(low)]):
                key = max(high, key=lambda key: key[k])
                factor = terms.pop(key)
                for power, c in enumerate(low):
                    for other, x in c.terms.items():
                        target = [i + j for i, j in zip(key, other, strict=True)]
                        target[k] = key[k] - len(low) + power
                        terms[tuple(target)] = terms.get(tuple(target), Fraction(0)) - factor * x
        return Number(self, {key: c for key, c in terms.items() if c})

    def interval(self, number: Number) -> Interval:
        """Ends, times 2^BITS, between which the number is."""
        total = (0, 0)
        for key, c in number.terms.items():
            part = (ONE, ONE)
            for k, power in enumerate(key):
                for _ in range(power):
                    part = _product(part, self.between[k])
            total = _sum(total, _times(part, c))
        return total

    def _signs(self, low: Sequence[Number], x: Fraction) -> Interval:
        """The polynomial at a rational number."""
        return self.interval(sum((c * self.rational(x**i) for i, c in enumerate(low)), self.rational(x ** len(low))))


def _rational(text: Any) -> Fraction:
    if not isinstance(text, str) or len(text) > LONGEST or not re.fullmatch(r"-?[0-9]+(/[0-9]*[1-9][0-9]*)?", text):
        raise UnreadableError(f"expected a rational number such as -3/7, got {str(text)[:40]!r}")
    return Fraction(text)


def _sum(a: Interval, b: Interval) -> Interval:
    return a[0] + b[0], a[1] + b[1]


def _product(a: Interval, b: Interval) -> Interval:
    ends = [x * y for x in a for y in b]
    return min(ends) >> BITS, -(-max(ends) >> BITS)


def _times(a: Interval, c: Fraction) -> Interval:
    low, high = (a[0], a[1]) if c > 0 else (a[1], a[0])
    return low * c.numerator // c.denominator, -(-high * c.numerator // c.denominator)


def _total(parts: Iterable[Interval]) -> Interval:
    total = (0, 0)
    for part in parts:
        total = _sum(total, part)
    return total


def _apart(a: Interval) -> bool:
    return a[0] > 0 or a[1] < 0


def _pivots(matrix: list[list[Interval]], *, exchange: bool) -> list[Interval]:
    """Pivots of elimination in intervals, with rows exchanged for large ones or not; refused where one may be zero."""
    left, found = [list(row) for row in matrix], []
    for k in range(len(left)):
        lead = max(range(k, len(left)), key=lambda i: abs(sum(left[i][k]))) if exchange else k
        left[k], left[lead] = left[lead], left[k]
        low, high = left[k][k]
        need(low > 0 or high < 0, "a minor or a form that is not shown to be regular")
        found.append((low, high))
        back = ((ONE << BITS) // high, -(-(ONE << BITS) // low))
        support = [(j, b) for j, b in enumerate(left[k]) if j > k and b != (0, 0)]  # columns before are done with
        for i in range(k + 1, len(left)):
            factor = _product(left[i][k], back)
            if factor != (0, 0):
                down, row = (-factor[1], -factor[0]), left[i]
                for j, b in support:
                    row[j] = _sum(row[j], _product(down, b))
    return found


# -- screws, loops ----------------------------------------------------------------------------------------

Screw = list[Number]


def cross(a: Sequence[Number], b: Sequence[Number]) -> Screw:
    """a x b."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def bracket(a: Screw, b: Screw) -> Screw:
    """[A, B] = (a x b ; a x b_O + a_O x b)."""
    mixed = [x + y for x, y in zip(cross(a[:3], b[3:]), cross(a[3:], b[:3]), strict=True)]
    return [*cross(a[:3], b[:3]), *mixed]


@dataclass(frozen=True)
class Joint:
    """A joint: its bodies, the screws of its freedoms in order from parent to child, and their first column."""

    name: str
    parent: str
    child: str
    screws: list[Screw]
    first: int

    @property
    def columns(self) -> range:
        """The columns of its freedoms."""
        return range(self.first, self.first + len(self.screws))

    def column(self, index: Any) -> int:
        """The column of one of its freedoms, as a file counts them: from the first, 0, and not back from the last."""
        if type(index) is not int or not 0 <= index < len(self.screws):
            raise UnreadableError(f"joint {self.name}: a freedom that it has not")
        return self.first + index


Tie = dict[int, list[Number]]
"""A coupling: column -> coefficients of the first, second ... power of the displacement from the configuration."""


@dataclass(frozen=True)
class Part:
    """Loops, couplings (by index) and joints that share none of them with other parts: they move independently."""

    loops: list[int]
    ties: list[int]
    names: list[str]


class Mechanism:
    """The graph, its loops, its couplings and its matrices, from the description in the file."""

    def __init__(self, entry: Any) -> None:
        self.entry, self.numbers = entry, Numbers(entry["generators"])
        self.ground, self.platform = entry["ground"], entry["body"]
        self.joints: dict[str, Joint] = {}
        self.freedoms = 0
        for joint in entry["joints"]:
            screws = [screw for motion in joint["motions"] for screw in self._screws(joint, motion)]
            need(joint["name"] not in self.joints, f"joint {joint['name']} is there twice")
            made = Joint(joint["name"], joint["parent"], joint["child"], screws, self.freedoms)
            self.joints[made.name] = made
            self.freedoms += len(screws)
        self.drives = [self.joints[name].column(index) for name, index in entry["drives"]]
        self.limbs: dict[str, list[str]] = entry["limbs"]
        self._reached: dict[str, tuple[tuple[str, int], ...]] = {self.ground: ()}
        chords = self._span()
        self.loops = [self._loop(self.joints[name]) for name in chords]
        self.ties = [self._tie(coupling["terms"]) for coupling in entry.get("couplings", [])]
        self.untied, self.blocks = self._parts([]), self._parts(self.ties)

    def alone(self, names: Sequence[str]) -> Mechanism:
        """These joints and the bodies that they join, one of these the ground; all that is connected."""
        joints = [joint for joint in self.entry["joints"] if joint["name"] in names]
        need(len(joints) == len(names) > 0, "joints that are not there, or there twice")
        body = joints[0]["parent"]
        empty: dict[str, Any] = {"drives": [], "limbs": {}, "couplings": []}
        return Mechanism({**self.entry, **empty, "joints": joints, "ground": body, "body": body})

    def _screws(self, joint: Any, motion: Any) -> list[Screw]:
        read, zero = self.numbers.read, self.numbers.zero
        kind = motion["kind"]
        point = [read(c) for c in joint["point"]]
        if len(point) != 3:
            raise UnreadableError(f"joint {joint['name']}: expected a point of three numbers")
        if kind == "S":
            axes = [[self.numbers.one if i == k else zero for i in range(3)] for k in range(3)]
            return [[*axis, *cross(point, axis)] for axis in axes]
        axis = [read(c) for c in motion["axis"]]
        if kind not in ("R", "P", "H") or len(axis) != 3:
            raise UnreadableError(f"joint {joint['name']}: expected motions R, P, H or S with axes of three numbers")
        need(any(_apart(self.numbers.interval(c)) for c in axis), f"joint {joint['name']}: an axis without direction")
        if kind == "P":
            return [[zero, zero, zero, *axis]]
        linear = cross(point, axis)
        if kind == "H":
            pitch = read(motion["pitch"])
            linear = [a + pitch * b for a, b in zip(linear, axis, strict=True)]
        return [[*axis, *linear]]

    def _span(self) -> list[str]:
        """A spanning tree from the ground; the joints that close loops."""
        used: set[str] = set()
        front = [self.ground]
        while front:
            body = front.pop(0)
            for joint in self.joints.values():
                for near, far, sign in ((joint.parent, joint.child, 1), (joint.child, joint.parent, -1)):
                    if near == body and far not in self._reached:
                        self._reached[far] = (*self._reached[body], (joint.name, sign))
                        used.add(joint.name)
                        front.append(far)
        bodies = {body for joint in self.joints.values() for body in (joint.parent, joint.child)} | {self.platform}
        need(bodies <= set(self._reached), "a body is not connected to the ground")
        return [name for name in self.joints if name not in used]

    def _loop(self, chord: Joint) -> list[tuple[str, int]]:
        out, back = self._reached[chord.parent], self._reached[chord.child]
        common = 0
        while common < min(len(out), len(back)) and out[common] == back[common]:
            common += 1
        return [*out[common:], (chord.name, 1), *((name, -sign) for name, sign in reversed(back[common:]))]

    def _tie(self, terms: Any) -> Tie:
        """The sum of p(x) - p(at) over the terms in powers of x - at, by Horner's scheme."""
        tie: Tie = {}
        for term in terms:
            joint, at = self.joints[term["joint"]], self.numbers.read(term["at"])
            column, screw = joint.column(term["freedom"]), joint.screws[term["freedom"]]
            axis = screw[:3] if any(screw[:3]) else screw[3:]
            low, high = self.numbers.interval(_dot(axis, axis))
            need(max(abs(low - ONE), abs(high - ONE)) <= UNIT, "a coupled axis that has not the length 1")
            need(column not in tie, f"joint {joint.name} is twice in a coupling")
            shifted = [self.numbers.zero, *(self.numbers.read(c) for c in term["coefficients"])]
            for first in range(len(shifted) - 1):
                for k in reversed(range(first, len(shifted) - 1)):
                    shifted[k] = shifted[k] + at * shifted[k + 1]
            tie[column] = shifted[1:]
        return tie

    def _parts(self, ties: Sequence[Tie]) -> list[Part]:
        """Parts whose loops, and couplings of those given, share no joint: their motions are independent."""
        sets = [{name for name, _ in loop} for loop in self.loops]
        sets += [{joint.name for joint in self.joints.values() if tie.keys() & set(joint.columns)} for tie in ties]
        parts: list[tuple[list[int], set[str]]] = []
        for index, names in enumerate(sets):
            touching = [part for part in parts if part[1] & names]
            parts = [part for part in parts if not part[1] & names]
            inside = sorted([index, *(i for part in touching for i in part[0])])
            parts.append((inside, names.union(*(part[1] for part in touching))))
        count = len(self.loops)
        return [
            Part([i for i in inside if i < count], [i - count for i in inside if i >= count],
                 [name for name in self.joints if name in names])
            for inside, names in sorted(parts, key=lambda part: part[0])
        ]  # fmt: skip

    def factors(self, loop: int) -> list[tuple[int, Screw]]:
        """(column, signed screw) of a loop: it closes where the product of exp(screw q_column) is 1."""
        result = []
        for name, sign in self.loops[loop]:
            joint = self.joints[name]
            parts = [(c, s if sign > 0 else [-x for x in s]) for c, s in zip(joint.columns, joint.screws, strict=True)]
            result += parts if sign > 0 else parts[::-1]
        return result

    def matrix(self, of: Sequence[str]) -> list[list[Number]]:
        """A matrix by name: what its rows are; columns are the joint freedoms, those of a limb or block alone."""
        kind, rest = of[0], of[1:]
        if kind in ("block", "untied"):
            part = (self.blocks if kind == "block" else self.untied)[int(rest[0])]
            columns = [c for name in part.names for c in self.joints[name].columns]
            every = [row for loop in part.loops for row in self._rows(self.loops[loop])]
            return [[row[c] for c in columns] for row in (*every, *(self._tie_row(self.ties[k]) for k in part.ties))]
        if kind == "limb":
            return [list(row) for row in zip(*(s for n in self.limbs[rest[0]] for s in self.joints[n].screws),
                                             strict=True)]  # fmt: skip
        rows = [row for loop in self.loops for row in self._rows(loop)] + [self._tie_row(tie) for tie in self.ties]
        if rest and rest[0] in ("twist", "turning"):
            rows += self._rows(self._reached[self.platform])[: 6 if rest[0] == "twist" else 3]
        elif rest and rest[0] == "drives":
            zero, one = self.numbers.zero, self.numbers.one
            rows += [[one if c == drive else zero for c in range(self.freedoms)] for drive in self.drives]
        if kind != "closure" or rest not in ([], ["twist"], ["turning"], ["drives"]):
            raise UnreadableError(f"expected the name of a matrix, got {of}")
        return rows

    def powers(self, indices: Iterable[int]) -> list[list[Number]]:
        """A row for every power of a coupled coordinate, a column for each of the couplings."""
        ties = [self.ties[index] for index in indices]
        places = sorted({(column, k) for tie in ties for column, given in tie.items() for k in range(len(given))})
        return [[tie[c][k] if k < len(tie.get(c, ())) else self.numbers.zero for tie in ties] for c, k in places]

    def _tie_row(self, tie: Tie) -> list[Number]:
        return [tie[c][0] if c in tie else self.numbers.zero for c in range(self.freedoms)]

    def _rows(self, path: Iterable[tuple[str, int]]) -> list[list[Number]]:
        rows = [[self.numbers.zero] * self.freedoms for _ in range(6)]
        for name, sign in path:
            joint = self.joints[name]
            for column, screw in zip(joint.columns, joint.screws, strict=True):
                for i in range(6):
                    rows[i][column] = screw[i] if sign > 0 else -screw[i]
        return rows


# -- ranks ------------------------------------------------------------------------------------------------


def at_least(numbers: Numbers, matrix: Sequence[Sequence[Number]], minor: Any) -> int:
    """The size of a minor that is shown not to be zero."""
    rows, columns = minor["rows"], minor["columns"]
    need(len(set(rows)) == len(rows) == len(set(columns)) == len(columns), "a minor with a row twice, or not square")
    there = all(type(i) is int and 0 <= i < len(matrix) for i in rows)
    need(there and all(type(j) is int and 0 <= j < len(matrix[0]) for j in columns), "a minor that is not there")
    return len(_pivots([[numbers.interval(matrix[i][j]) for j in columns] for i in rows], exchange=True))


def null_space(numbers: Numbers, matrix: Sequence[Sequence[Number]], given: Any) -> list[list[Number]]:
    """Independent vectors that the matrix maps to zero, read and checked: each has an entry that the others lack."""
    vectors = [[numbers.read(c) for c in vector] for vector in given]
    for k, vector in enumerate(vectors):
        need(not matrix or len(vector) == len(matrix[0]), "a null vector of another length")
        used = [j for j, c in enumerate(vector) if c]
        own = [j for j in used if not any(v[j] for i, v in enumerate(vectors) if i != k)]
        need(any(_apart(numbers.interval(vector[j])) for j in own), "null vectors not shown to be independent")
        for row in matrix:
            need(not sum((row[j] * vector[j] for j in used), numbers.zero), "a vector that is no null vector")
    return vectors


def rank(numbers: Numbers, matrix: Sequence[Sequence[Number]], entry: Any) -> tuple[int, int]:
    """Proved bounds of the rank."""
    least = at_least(numbers, matrix, entry["minor"])
    width = len(matrix[0]) if matrix else 0
    most = width - len(null_space(numbers, matrix, entry["null"])) if "null" in entry else min(len(matrix), width)
    need([least, most] == entry["rank"], f"a rank between {entry['rank']}: shown is {[least, most]}")
    return least, most


# -- real motion ------------------------------------------------------------------------------------------


def group(numbers: Numbers, screws: Sequence[Screw], given: Any) -> list[Screw]:
    """A basis that is closed under brackets and holds the screws; each vector has a 1 where the others have a 0."""
    if given == WHOLE:
        return [[numbers.one if i == k else numbers.zero for i in range(6)] for k in range(6)]
    basis = [[numbers.read(c) for c in vector] for vector in given]
    pivots = []
    for vector in basis:
        own = (j for j in range(6) if not (vector[j] - numbers.one) and sum(1 for v in basis if v[j]) == 1)
        pivots.append(next(own, -1))
    need(all(len(v) == 6 for v in basis) and -1 not in pivots, "a basis without a 1 of its own in every vector")
    for x in (*screws, *(bracket(a, b) for a, b in combinations(basis, 2))):
        for p, vector in zip(pivots, basis, strict=True):
            x = [a - x[p] * b for a, b in zip(x, vector, strict=True)]
        need(not any(x), "a screw or a bracket outside of the group")
    return basis


Polynomial = dict[Key, Number]
"""In the tangents of a part's freedoms: exponents -> coefficient."""


def polynomial(numbers: Numbers, given: Any, count: int) -> Polynomial:
    """A polynomial of the file: [[number, exponents ...], ...]."""
    terms: Polynomial = {}
    for number, *powers in given:
        sound = len(powers) == count and all(type(e) is int and 0 <= e <= LARGEST for e in powers)
        if not sound or tuple(powers) in terms:
            raise UnreadableError(f"expected {count} exponents of tangents, got {powers}")
        terms[tuple(powers)] = numbers.read(number)
    return {key: c for key, c in terms.items() if c}


def multiplied(a: Polynomial, b: Polynomial) -> Polynomial:
    """Their product."""
    terms: Polynomial = {}
    for one, x in a.items():
        for two, y in b.items():
            key = tuple(map(add, one, two))
            terms[key] = terms[key] + x * y if key in terms else x * y
    return {key: c for key, c in terms.items() if c}


def cancelled(numbers: Numbers, products: Sequence[tuple[Polynomial, Polynomial]]) -> bool:
    """Whether products add up to zero: in integers, with the exponents of tangents and generators in one more each."""
    whole = []
    pairs = ([pair[k] for pair in products] for k in (0, 1))
    sides = [[[((*e, *g), c) for e, n in p.items() for g, c in n.terms.items()] for p in side] for side in pairs]
    digit = sum(max((max(key, default=0) for p in side for key, _ in p), default=0) for side in sides).bit_length()
    for side in sides:
        scale = lcm(*(c.denominator for p in side for _, c in p))
        whole.append([[(sum(e << digit * k for k, e in enumerate(key)), int(c * scale)) for key, c in p] for p in side])
    total: dict[int, int] = {}
    for one, two in zip(*whole, strict=True):
        for i, x in one:
            for j, y in two:
                total[i + j] = total.get(i + j, 0) + x * y
    left: dict[int, dict[Key, Fraction]] = {}  # what stands before each product of tangents
    tangents = digit * len(next(iter(products[0][1])))
    for key, c in total.items():
        powers = tuple((key >> tangents + digit * k) % (1 << digit) for k in range(numbers.count))
        left.setdefault(key % (1 << tangents), {})[powers] = Fraction(c)
    return not any(numbers.reduced(terms) for terms in left.values())


def closed(numbers: Numbers, factors: Sequence[tuple[int, Screw]], count: int) -> list[Polynomial]:
    """The product of 1 + t (w + eps v), a dual quaternion: no displacement where all but its first part is zero."""
    pose = [{(0,) * count: numbers.one}, *({} for _ in range(7))]
    for column, screw in factors:
        key = _power(column, count)
        turn = [[{key: c} if c else {} for c in half] for half in (screw[:3], screw[3:])]
        moved = [_hamilton(pose[:4], turn[0]), _hamilton(pose[4:], turn[0]), _hamilton(pose[:4], turn[1])]
        added = [*moved[0], *(_added(a, b) for a, b in zip(moved[1], moved[2], strict=True))]
        pose = [_added(a, b) for a, b in zip(pose, added, strict=True)]
    return pose


def _hamilton(q: Sequence[Polynomial], v: Sequence[Polynomial]) -> list[Polynomial]:
    """A quaternion times a vector."""
    w, x, y, z = q
    rows = (((x, 0, -1), (y, 1, -1), (z, 2, -1)), ((w, 0, 1), (y, 2, 1), (z, 1, -1)),
            ((w, 1, 1), (z, 0, 1), (x, 2, -1)), ((w, 2, 1), (x, 1, 1), (y, 0, -1)))  # fmt: skip
    result = []
    for row in rows:
        total: Polynomial = {}
        for p, k, sign in row:
            part = multiplied(p, v[k])
            total = _added(total, part if sign > 0 else {key: -c for key, c in part.items()})
        result.append(total)
    return result


def _added(a: Polynomial, b: Polynomial) -> Polynomial:
    terms = {**a, **{key: a[key] + c if key in a else c for key, c in b.items()}}
    return {key: c for key, c in terms.items() if c}


def _power(column: int, count: int) -> Key:
    return tuple(int(k == column) for k in range(count))


def chain(
    mechanism: Mechanism, ends: Sequence[str], names: Sequence[str], one: dict[str, str]
) -> tuple[list[Screw], list[str]]:
    """(screws of the joints that lead from one body to another, the bodies between); `one`: which stands for each."""
    bodies, screws = [ends[0]], []
    for joint in (mechanism.joints[name] for name in names):
        near, far = one[joint.parent], one[joint.child]
        need(bodies[-1] in (near, far), "joints that are no limb")
        bodies.append(far if bodies[-1] == near else near)
        screws += joint.screws
    need(bodies[-1] == ends[1], "a limb that ends elsewhere")
    return screws, bodies[1:-1]


class Block:
    """A part of the mechanism with the bounds of its rank, its motions, and the groups of its loops."""

    def __init__(
        self, mechanism: Mechanism, name: Sequence[str], entry: Any, *, held: frozenset[str] = frozenset()
    ) -> None:
        """`name`: as of its matrix, ("block", "0"); "untied" instead of "block" for a part without couplings.

        `held`: joints that are shown to be at rest, so that they are none.
        """
        self.mechanism, self.numbers, self.entry, self.name, self.held = mechanism, mechanism.numbers, entry, name, held
        part = (mechanism.blocks if name[0] == "block" else mechanism.untied)[int(name[1])]
        self.loops, self.ties, self.names = part.loops, part.ties, [name for name in part.names if name not in held]
        moving = [name not in held for name in part.names for _ in mechanism.joints[name].screws]
        self.columns = [c for name in self.names for c in mechanism.joints[name].columns]
        matrix = [[c for c, kept in zip(row, moving, strict=True) if kept] for row in mechanism.matrix(name)]
        self.least, self.most = rank(self.numbers, matrix, entry["rank"])
        self.motions = null_space(self.numbers, matrix, entry["rank"].get("null", []))
        at = {column: k for k, column in enumerate(self.columns)}
        self.factors = [[(at[c], s) for c, s in mechanism.factors(loop) if c in at] for loop in self.loops]
        self.brackets: list[list[tuple[int, int, Screw]]] = []
        self.tied_columns = [{at[c]: powers for c, powers in mechanism.ties[k].items()} for k in self.ties]

    @cached_property
    def dimensions(self) -> tuple[int, int, list[int] | None, bool]:
        """(least, most dimension of the real motion; those of all branches, or None; whether it is smooth)."""
        proof, width = self.entry["proof"], len(self.columns)
        kind = proof["kind"]
        low, high = width - self.most, width - self.least
        if kind == "none":
            return (0, high, None, False) if high else (0, 0, [0], True)
        if kind == "rigid":
            return self.rest(proof).dimensions
        if kind == "nested":
            self.nested(proof)
            need(low == high, "a rank that is not decided")
            return low, low, [low], True
        if kind == "tied":
            self.tied(proof)
            return high, high, [high], True
        if kind == "limbs":
            need(not self.ties, "a proof that leaves couplings out")
            self.limbs(proof)
            need(low == high, "a rank that is not decided")
            return low, low, [low], True
        if kind == "parts":
            sizes = self.parts(proof)
            alone = sizes == [high] and low == high
            return max(sizes), max(sizes), sizes, alone
        groups = [group(self.numbers, [s for _, s in f], g) for f, g in zip(self.factors, proof["groups"], strict=True)]
        redundant = sum(map(len, groups)) + len(self.ties) - self.least
        need(redundant == 0 or low == high == len(self.motions), "a rank that is not decided")
        if kind == "endless":
            need(high == 1, "more than one motion")
            self.endless(proof)
            return 1, 1, [1], True
        if kind == "groups":
            need(redundant == 0, "groups with more dimensions than the rank")
            return high, high, [high], True
        if kind == "stopped":
            need(high == 1, "more than one motion")
            self.stopped(proof)
            return 0, 0, [0], False
        if kind == "direction":
            self.direction(proof, redundant)
            return high - redundant, high, None, False
        if kind != "form":
            raise UnreadableError(f"expected the kind of a proof, got {kind!r}")
        basis = [[self.numbers.rational(_rational(c)) for c in row] for row in proof["basis"]]
        need(bool(basis), "a form of no motion")
        form = self.changed(self.form(proof["stress"]), basis)
        signs = {low > 0 for low, _ in _pivots(form, exchange=False)}
        if len(signs) == 1:
            return 0, 0, [0], False
        need(redundant == 1, "an indefinite form among several redundant equations")
        return high - 1, high - 1, [high - 1], False

    def resting(self) -> list[str]:
        """Joints that are shown not to move: of parts that do not move at all, and of rigid loops."""
        if not self.dimensions[1]:
            return self.names
        proof = self.entry["proof"]
        if proof["kind"] != "rigid":
            return []
        rest = self.rest(proof)
        return sorted(rest.held - self.held) + rest.resting()

    def rest(self, proof: Any) -> Block:
        """The part without joints which have independent screws in the loops that they alone make: they cannot move."""
        need(not self.ties, "a proof that leaves couplings out")
        held = set(self.held)
        for entry in proof["rigid"]:
            alone = self.mechanism.alone(entry["joints"])
            shown = at_least(alone.numbers, alone.matrix(["closure"]), entry["minor"]) == alone.freedoms
            need(shown and set(entry["joints"]) <= set(self.names), "joints that are not shown to be at rest")
            held |= set(entry["joints"])
        return Block(self.mechanism, self.name, proof["rest"], held=frozenset(held))

    def nested(self, proof: Any) -> None:
        """Smooth in the loops that some joints make alone, and all other loops independent on their motions: smooth."""
        need(not self.ties and set(proof["joints"]) <= set(self.names), "joints of another part, or couplings left out")
        alone = self.mechanism.alone(proof["joints"])
        need(len(alone.blocks) == len(proof["parts"]), "parts that are missing")
        inside = [Block(alone, ("block", str(k)), entry) for k, entry in enumerate(proof["parts"])]
        found = [part.dimensions for part in inside]
        need(all(smooth for *_, smooth in found), "joints whose own loops are not smooth")
        own = sum(len(part.columns) - least for part, (least, *_) in zip(inside, found, strict=True))
        others = len(self.loops) - len(alone.loops)
        need(self.least == own + 6 * others, "other loops that are not independent of these")

    def parts(self, proof: Any) -> list[int]:
        """Dimensions of smooth parts that are, near the configuration, together all zeros of the loops' polynomials.

        Unknowns are t = tan(|w| q / 2) / |w| of every freedom, of a slide q / 2. Equations of a part are zero at t = 0
        with independent derivatives. Each polynomial of the loops, times a unit, is a combination of them: the part is
        among the zeros. Each product of one equation from every part, to some power and times a unit, is a combination
        of the loops' polynomials: there are no others. A unit is a polynomial that is not zero at t = 0. No Groebner
        basis is needed to see any of this, nor that parts cannot be divided: smooth ones near a point cannot.
        """
        numbers, count = self.numbers, len(self.columns)
        need(not self.ties, "a proof that leaves couplings out")
        need(not any(_dot(s[:3], s[3:]) for f in self.factors for _, s in f), "a screw joint, which is not algebraic")
        closure = [p for factors in self.factors for p in closed(numbers, factors, count)[1:] if p]
        parts = [[polynomial(numbers, e, count) for e in part["equations"]] for part in proof["parts"]]
        need(bool(parts), "no part")
        origin = (0,) * count
        slopes = [[[p.get(_power(k, count), numbers.zero) for k in range(count)] for p in part] for part in parts]
        for part, rows, entry in zip(parts, slopes, proof["parts"], strict=True):
            need(not any(origin in p for p in part), "a part that does not hold the configuration")
            independent = not part or at_least(numbers, rows, entry["minor"]) == len(part)
            need(independent, "equations of a part that are not independent in the configuration")
            for p, shown in zip(closure, entry["closure"], strict=True):
                self._combined(p, shown, part)
        for (a, rows), (b, others) in permutations(enumerate(slopes), 2):
            given = [m["minor"] for m in proof["apart"] if m["parts"] == [a, b]]
            apart = any(at_least(numbers, [*rows, *others], minor) > len(rows) for minor in given)
            need(apart, "a part that may be within another")
        for chosen, shown in zip(product(*parts), proof["products"], strict=True):
            need(type(shown["power"]) is int and 0 < shown["power"] <= MOST_WAYS, "a power that is none")
            p = {origin: numbers.one}
            for factor in chosen * shown["power"]:
                p = multiplied(p, factor)
            self._combined(p, shown, closure)
        return sorted({count - len(part) for part in parts})

    def _combined(self, p: Polynomial, shown: Any, others: Sequence[Polynomial]) -> None:
        """Refuses unless p times a unit is the sum of the others times the factors shown."""
        numbers, count = self.numbers, len(self.columns)
        unit = polynomial(numbers, shown["unit"], count)
        need(_apart(numbers.interval(unit.get((0,) * count, numbers.zero))), "a unit that may be zero")
        given = [polynomial(numbers, f, count) for f in shown["factors"]]
        less = {key: -c for key, c in p.items()}
        same = cancelled(numbers, [(less, unit), *zip(others, given, strict=True)])
        need(same, "a polynomial that is not the combination shown")

    def tied(self, proof: Any) -> None:
        """Smooth without the couplings, and these independent on its motions: smooth, by implicit functions.

        Couplings that are combinations of others, in all powers of all coordinates, hold with them.
        """
        inside = [k for k, part in enumerate(self.mechanism.untied) if set(part.names) <= set(self.names)]
        need(len(inside) == len(proof["parts"]), "parts without couplings that are missing")
        loops = 0
        for k, entry in zip(inside, proof["parts"], strict=True):
            part = Block(self.mechanism, ("untied", str(k)), entry)
            least, _, _, smooth = part.dimensions
            need(smooth, "a part that is not smooth without couplings")
            loops += len(part.columns) - least
        alike = null_space(self.numbers, self.mechanism.powers(self.ties), proof["implied"])
        need(self.least == loops + len(self.ties) - len(alike), "couplings that are not independent of the loops")

    def limbs(self, proof: Any) -> None:
        """Limbs between two bodies, each of which reaches all of a group: smooth, as the meet of groups is a group."""
        inside, one = list[str](), self.bodies()
        ends = [one[body] for body in proof["between"]]
        for limb in proof["limbs"]:
            screws, bodies = chain(self.mechanism, ends, limb["joints"], one)
            inside += bodies
            reached = at_least(self.numbers, [list(row) for row in zip(*screws, strict=True)], limb["minor"])
            need(
                reached == len(group(self.numbers, screws, limb["group"])), "a limb that does not reach all of a group"
            )
        used = [name for limb in proof["limbs"] for name in limb["joints"]]
        need(sorted(used) == sorted(self.names), "joints that are in no limb, or in two")
        need(len({*inside, *ends}) == len(inside) + len(ends) == len(inside) + 2, "limbs that share a body")

    def bodies(self) -> dict[str, str]:
        """Every body, and which stands for it: joints at rest make their bodies one."""
        joints = self.mechanism.joints
        one = {body: body for joint in joints.values() for body in (joint.parent, joint.child)}
        for name in sorted(self.held):
            gone, kept = one[joints[name].parent], one[joints[name].child]
            one = {body: kept if stands == gone else stands for body, stands in one.items()}
        return one

    def stress(self, given: Any) -> tuple[list[Screw], list[Number]]:
        """A self-stress, six numbers a loop and one a coupling, that does no work on any screw."""
        stress, count = [self.numbers.read(c) for c in given], len(self.loops)
        parts, pulls = [stress[6 * k : 6 * k + 6] for k in range(count)], stress[6 * count :]
        need(len(stress) == 6 * count + len(self.ties), "a self-stress of another length")
        work = [self.numbers.zero] * len(self.columns)
        for part, factors in zip(parts, self.factors, strict=True):
            for column, screw in factors:
                work[column] = work[column] + _dot(part, screw)
        for pull, tie in zip(pulls, self.tied_columns, strict=True):
            for column, powers in tie.items():
                work[column] = work[column] + pull * powers[0]
        need(not any(work), "a self-stress that does work on a joint")
        return parts, pulls

    def form(self, given: Any) -> list[list[Number]]:
        """Twice the second-order work of a self-stress on the motions: sum of stress . [S_j, S_k] u_j u_k, j < k."""
        zero, count = self.numbers.zero, len(self.motions)
        form = [[zero] * count for _ in range(count)]
        parts, pulls = self.stress(given)
        if not self.brackets:
            self.brackets = [[(j, k, bracket(a, b)) for (j, a), (k, b) in combinations(f, 2)] for f in self.factors]
        loops = zip(parts, self.brackets, strict=True)
        works = [(j, k, _dot(part, screw)) for part, found in loops for j, k, screw in found]
        two = self.numbers.rational(Fraction(2))  # the second derivative of c x^2 is 2 c u^2
        for pull, tie in zip(pulls, self.tied_columns, strict=True):
            works += [(c, c, pull * two * powers[1]) for c, powers in tie.items() if len(powers) > 1]
        moved = [[(x, u[c]) for x, u in enumerate(self.motions) if u[c]] for c in range(len(self.columns))]
        for j, k, work in works:
            for x, u in moved[j] if work else ():
                for y, v in moved[k]:
                    done = work * u * v
                    form[x][y] = form[x][y] + done
                    form[y][x] = form[y][x] + done
        return form

    def changed(self, form: list[list[Number]], basis: list[list[Number]]) -> list[list[Interval]]:
        """The form in another basis of the motions, in intervals."""
        need(len(basis) == len(form) and all(len(row) == len(form) for row in basis), "a basis of another size")
        columns = list(zip(*form, strict=True))
        half = [[_dot(row, column) for column in columns] for row in basis]
        return [[self.numbers.interval(_dot(row, other)) for other in basis] for row in half]

    def direction(self, proof: Any, redundant: int) -> None:
        """A common zero of the forms, one for each redundant equation, at which they are independent.

        Krawczyk: with an approximate inverse Y of the derivative, y - Y f(y) + (1 - Y f'(box)) (box - y) lies inside
        of the box, so that the box has a zero of f, and f' is regular there (R. Krawczyk, Computing 4, 1969, 187-201).
        """
        read, numbers = _rational, self.numbers
        centre, radius = [read(c) for c in proof["centre"]], read(proof["radius"])
        inverse = [[read(c) for c in row] for row in proof["inverse"]]
        slices = [[numbers.rational(read(c)) for c in row] for row in proof["slices"]]
        forms = [self.form(stress) for stress in proof["stresses"]]
        size = len(self.motions)
        need(len(forms) == redundant and len(forms) + len(slices) == size == len(centre), "forms that are missing")
        sizes = {len(row) for row in slices} | {len(row) for row in inverse}
        need(radius > 0 and sizes == {size} and len(inverse) == size, "a box of another size")
        need(any(abs(c) > radius for c in centre), "a box around no direction")
        point = [numbers.rational(c) for c in centre]
        rows = [[_dot(row, point) for row in form] for form in forms]
        values = [numbers.interval(_dot(row, point)) for row in rows] + [(0, 0)] * len(slices)
        width = -(-radius.numerator * ONE // radius.denominator)
        wide = (-width, width)
        slopes: list[list[Interval]] = []  # of v . Q v / 2 and of the slices through the centre, over the box
        for form, row in zip(forms, rows, strict=True):
            spread = [[_product(numbers.interval(c), wide) for c in entries] for entries in form]
            slopes.append([_sum(numbers.interval(c), _total(s)) for c, s in zip(row, spread, strict=True)])
        slopes += [[numbers.interval(c) for c in row] for row in slices]
        for i, weights in enumerate(inverse):
            moved = _times(_total(_times(v, w) for v, w in zip(values, weights, strict=True) if w), Fraction(-1, 2))
            for j in range(size):
                part = _total(_times(slopes[k][j], -w) for k, w in enumerate(weights) if w)
                moved = _sum(moved, _product(_sum(part, (ONE, ONE) if i == j else (0, 0)), wide))
            need(max(abs(moved[0]), abs(moved[1])) < width - 1, "a box that Krawczyk's operator leaves")

    def stopped(self, proof: Any) -> None:
        """The only motion, continued order by order, until a self-stress does work."""
        arc = [[self.numbers.read(c) for c in rates] for rates in proof["arc"]]
        need(any(arc[0]) and all(len(rates) == len(self.columns) for rates in arc), "an arc that does not start")
        parts, pulls = self.stress(proof["stress"])
        left = self.opened(arc)
        need(not any(c for order in left[:-1] for c in order), "a motion that opens a loop at a lower order")
        work = _dot([c for part in parts for c in part] + pulls, left[-1])
        need(_apart(self.numbers.interval(work)), "a self-stress that does no work on the motion")

    def endless(self, proof: Any) -> None:
        """The only motion of a loop of six freedoms or fewer, shut to an order that no isolated configuration has.

        Six joints that turn or slide reach a pose in at most 16 isolated ways, multiplicities counted (E. J. F.
        Primrose, Mech. Mach. Theory 21, 1986, 509-512): where the arc of the only motion is shut to that order, the
        one equation that is left in its parameter is zero. Fewer joints are completed by hinges in general position.
        If these moved, the motion of the five, say, would reach every small rotation about every line of space, and
        nothing else; but two of their own axes that are skew make what is no rotation. With two hinges and more, their
        screws span what only a cone of too many dimensions would meet.
        """
        screws = [screw for _, screw in self.factors[0]]
        need(
            len(self.loops) == 1 and not self.ties and len(screws) <= len(screws[0]), "more than a loop of six freedoms"
        )
        need(not any(_dot(s[:3], s[3:]) for s in screws), "a screw joint, which is not algebraic")
        pairs = (_dot(a[:3], b[3:]) + _dot(a[3:], b[:3]) for a, b in combinations(screws, 2))
        skew = len(screws) != 5 or any(_apart(self.numbers.interval(power)) for power in pairs)
        need(skew, "five freedoms of which no two are skew")
        arc = [[self.numbers.read(c) for c in rates] for rates in proof["arc"]]
        whole = all(len(rates) == len(self.columns) for rates in arc)
        need(whole and len(arc) >= MOST_WAYS, "an arc that is too short")
        need(any(_apart(self.numbers.interval(c)) for c in arc[0]), "an arc that does not start")
        left = self.opened(arc)[:MOST_WAYS]
        need(not any(c for order in left for c in order), "a motion that opens a loop")

    def opened(self, arc: Sequence[Sequence[Number]]) -> list[list[Number]]:
        """Coefficients in t of the velocities at which rates, a power series, open the loops and couplings."""
        result: list[list[Number]] = [[] for _ in range(len(arc) + 1)]
        for factors in self.factors:
            rates = [[order[c] for c, _ in factors] for order in arc]
            loop = velocities([s for _, s in factors], rates) if factors else [[self.numbers.zero] * 6] * len(result)
            result = [[*a, *b] for a, b in zip(result, loop, strict=True)]
        for tie in self.tied_columns:
            moved = [self.numbers.zero] * (len(arc) + 1)
            for column, powers in tie.items():
                moved = [a + b for a, b in zip(moved, self._moved([r[column] for r in arc], powers), strict=True)]
            result = [[*a, b] for a, b in zip(result, moved, strict=True)]
        return result

    def _moved(self, rates: Sequence[Number], powers: Sequence[Number]) -> list[Number]:
        """Coefficients in t of the velocity of sum powers_k x^k, where x moves from 0 with the rates."""
        zero, rational = self.numbers.zero, self.numbers.rational
        x = [zero, *(r * rational(Fraction(1, k + 1)) for k, r in enumerate(rates)), zero]
        power, total = [self.numbers.one, *[zero] * (len(x) - 1)], [zero] * len(x)
        for c in powers:
            power = [sum((power[i] * x[k - i] for i in range(k + 1)), zero) for k in range(len(x))]
            total = [a + c * b for a, b in zip(total, power, strict=True)]
        return [rational(Fraction(k)) * c for k, c in enumerate(total)][1:]


def velocities(screws: Sequence[Screw], rates: Sequence[Sequence[Number]]) -> list[Screw]:
    """Coefficients in t of sum S_k(t) u_k(t) along dS_k/dt = [sum over j < k of S_j u_j, S_k]; one more than rates."""
    numbers = screws[0][0].within
    series, result = [[screw] for screw in screws], []
    carried: list[list[Screw]] = [[] for _ in screws]  # coefficients of the twist that carries the screw
    for order in range(len(rates) + 1):
        total = [numbers.zero] * 6
        for k, own in enumerate(series):
            if order:
                grown = [numbers.zero] * 6
                for a in range(order):
                    grown = [x + y for x, y in zip(grown, bracket(carried[k][a], own[order - 1 - a]), strict=True)]
                own.append([numbers.rational(Fraction(1, order)) * x for x in grown])
            carried[k].append(total)
            for b in range(min(order + 1, len(rates))):
                if rates[b][k]:
                    total = [x + y * rates[b][k] for x, y in zip(total, own[order - b], strict=True)]
        result.append(total)
    return result


def _dot(a: Sequence[Number], b: Sequence[Number]) -> Number:
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), a[0].within.zero)


# -- claims -----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Verdict:
    """What was found: `proved` claims, `refused` ones with the reason, and what the file itself calls not proved."""

    mechanism: str
    proved: tuple[str, ...]
    refused: tuple[str, ...]
    not_proved: tuple[str, ...]

    @property
    def holds(self) -> bool:
        """Whether every claim of the file is proved."""
        return not self.refused

    def __str__(self) -> str:
        words = (("proved", self.proved), ("REFUSED", self.refused), ("not proved", self.not_proved))
        lines = [f"{word}: {text}" for word, texts in words for text in texts]
        end = "every claim of the file is proved" if self.holds else "the file does not prove what it claims"
        return "\n".join(map(printable, [f"Mobility of {self.mechanism}", *lines, end]))


def facts_of(mechanism: Mechanism, entry: Any) -> dict[str, Any]:
    """What the evidence shows: words -> value."""
    blocks = entry["blocks"]
    need(len(blocks) == len(mechanism.blocks), "evidence for another number of blocks")
    parts = [Block(mechanism, ("block", str(index)), block) for index, block in enumerate(blocks)]
    least, most = sum(part.least for part in parts), sum(part.most for part in parts)
    freedoms, loops, ties = mechanism.freedoms, len(mechanism.loops), len(mechanism.ties)
    found: dict[str, Any] = {
        "joint freedoms": freedoms,
        "independent loops": loops,
        "Kutzbach-Gruebler": freedoms - 6 * loops - ties,
        "instantaneous mobility at most": freedoms - least,
        "finite mobility at most": freedoms - least,
    }
    if least == most:
        found["instantaneous mobility"], found["redundant constraints"] = freedoms - least, 6 * loops + ties - least
    _add_motion(found, [part.dimensions for part in parts], freedoms - sum(len(part.columns) for part in parts))
    if resting := sorted(name for part in parts for name in part.resting()):
        found["joints at rest"] = resting
    for name, given in entry["ranks"].items():
        value, bound = rank(mechanism.numbers, mechanism.matrix(name.split(" ", 1)), given)
        if value != bound:
            continue
        if name.startswith("limb "):
            found[f"constraints of {name[5:]}"] = 6 - value
        elif least == most and name == "closure twist":
            found[f"freedoms of {mechanism.platform}"] = value - least
            found["internal freedoms"] = freedoms - value
        elif least == most and name == "closure turning":
            found[f"rotations of {mechanism.platform}"] = value - least
        elif name == "closure drives":
            found["freedoms with the drives locked"] = freedoms - value
    return found


def _add_motion(found: dict[str, Any], parts: Sequence[tuple[int, int, list[int] | None, bool]], free: int) -> None:
    """Finite mobility: blocks move independently, so dimensions add up."""
    found["finite mobility at least"] = free + sum(part[0] for part in parts)
    found["finite mobility at most"] = free + sum(part[1] for part in parts)
    if found["finite mobility at least"] == found["finite mobility at most"]:
        found["finite mobility"] = found["finite mobility at least"]
    sums = {free}
    for _, _, dimensions, _ in parts:
        sums = {a + b for a in sums for b in dimensions or ()}
    if sums:
        found["smooth"] = all(part[3] for part in parts)
        found["branches"] = None if found["smooth"] else sorted(sums - {0})


def printable(text: str) -> str:
    """One line of text in which nothing moves the cursor: a name in a file must not say what the checker says."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


def said(text: str) -> None:
    """Prints it; where the console has no such letter, its number stands for it."""
    encoding = sys.stdout.encoding or "ascii"
    print(text.encode(encoding, "backslashreplace").decode(encoding))


def digest(mechanism: Any) -> str:
    """SHA-256 of the description: a file is about this mechanism and no other."""
    text = json.dumps(mechanism, sort_keys=True, separators=(",", ":"), ensure_ascii=True)
    return hashlib.sha256(text.encode()).hexdigest()


def check_proof(values: Any) -> Verdict:
    """Judges every claim of a proof file.

    Args:
        values: what the JSON file holds.

    Raises:
        UnreadableError: it is no proof file.
    """
    try:
        expected = COUPLED if "couplings" in values["mechanism"] else FORMAT
        if values["format"] != expected:
            raise UnreadableError(f"expected the format {expected!r}, got {str(values['format'])[:60]!r}")
        name, claims = str(values["mechanism"]["name"]), [(str(c["claim"]), c["value"]) for c in values["claims"]]
        sampled = [(str(c["claim"]), c["value"], str(c["why"])) for c in values["not proved"]]
        texts = tuple(f"{claim} {json.dumps(value)}: {why}" for claim, value, why in sampled)
        if "ways" in values:
            texts += ("ways between assembly modes here: way_checker.py judges them",)
        try:
            need(bool(claims), "a file without claims")
            need(values["digest"] == digest(values["mechanism"]), "the description is not the one that was proved")
            found = facts_of(Mechanism(values["mechanism"]), values)
        except RefusedError as error:
            return Verdict(name, (), tuple(f"{c} {json.dumps(v)}: {error}" for c, v in claims) or (str(error),), texts)
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, RecursionError) as error:
        raise UnreadableError(f"{type(error).__name__}: {error}") from error
    shown = [claim in found and _same(found[claim], v) for claim, v in claims]
    proved = [f"{claim} {json.dumps(v)}" for (claim, v), true in zip(claims, shown, strict=True) if true]
    refused = [
        f"{claim} {json.dumps(v)}: the evidence shows {json.dumps(found[claim]) if claim in found else 'nothing of it'}"
        for (claim, v), true in zip(claims, shown, strict=True)
        if not true
    ]
    refused += [
        f"{claim} {json.dumps(v)}, called not proved: the evidence shows {json.dumps(found[claim])}"
        for claim, v, _ in sampled
        if claim in found and not _same(found[claim], v)
    ]
    return Verdict(name, tuple(proved), tuple(refused), texts)


def _same(a: Any, b: Any) -> bool:
    """Whether two values are the same JSON: to Python true is 1, and 1.0, in lists as well."""
    return json.dumps(a) == json.dumps(b)


def values_of(text: str) -> Any:
    """What JSON text holds, where every key is there once, as another reader might take the other, and no NaN is."""

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        made = dict(pairs)
        if len(made) < len(pairs):
            raise UnreadableError(f"a key twice in {', '.join(key[:20] for key in made)}")
        return made

    def refused(name: str) -> Any:
        raise UnreadableError(f"{name}, which is no number")

    return json.loads(text, object_pairs_hook=once, parse_constant=refused)


def main(arguments: Sequence[str]) -> int:
    """Checks a file, says what it proves; 0, 1 or 2 as above."""
    if len(arguments) != 1:
        print("usage: proof_checker.py FILE", file=sys.stderr)
        return 2
    try:
        with open(arguments[0], encoding="utf-8") as file:
            verdict = check_proof(values_of(file.read()))
    except (OSError, ValueError, RecursionError, MemoryError, UnreadableError) as error:
        print(f"{arguments[0]}: not a proof file that can be read: {printable(str(error)[:200])}", file=sys.stderr)
        return 2
    said(str(verdict))
    return 0 if verdict.holds else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
