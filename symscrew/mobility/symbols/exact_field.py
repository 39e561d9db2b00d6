"""Exact real numbers in which zero is decidable: a tower of square roots over Q or over Q(2 cos(2 pi / n)).

    expressions --Field.read--> numbers of Q(theta)(sqrt r1)(sqrt r2) ..., theta = 2 cos(2 pi / n)

A number is rational, or a polynomial of degree below d in a generator of degree d over the numbers below it. A
square root is adjoined only after it has been proved that the field below has no such root, so every number has
one normal form, and it is zero exactly when all its coefficients are. Whether a + b w (w^2 = r) is a square is
decided by descent: s^2 = (a +- sqrt(a^2 - b^2 r)) / 2 must be a square one level below, down to Q, or to the ring
of integers Z[2 cos(2 pi / n)] where a root has integer coefficients of known size.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import product
from math import gcd, isqrt, lcm

import sympy

from symscrew.algebra import CONTEXT
from symscrew.mobility.symbols.exact_numbers import (
    Exact,
    Generator,
    NotDecidableError,
    Number,
    expression,
    generators_of,
    inverse,
    made,
    value,
)

MOST_ROOTS = 5
"""Independent square roots in one field: its degree, and the length of every number, doubles with each, so five are
degree 32. Beyond it ranks stand on 60 digits, and the result says why it is not exact."""
HIGHEST_DEGREE = 8
"""Of 2 cos(2 pi / n) over Q (n = 48 and 60 have it: angles in steps of 7.5 and 6 degrees). A root of a number is looked
for among 2^(degree - 1) choices of signs of its conjugates. Beyond it ranks stand on 60 digits, as above."""
LARGEST_SQUARED = 1000
"""Squares of primes up to this are taken out of an integer under a root, which keeps coefficients short; a larger one
may stay inside, which is as right."""
LONGEST_SQUARE = CONTEXT.mpf(10) ** 30
"""Numbers whose conjugates, times their denominator, are larger are not looked at for a root: with 60 digits their
integer coefficients would not be certain."""
CERTAIN_NORM = CONTEXT.mpf(10) ** 45
"""A norm below this is known to the unit in 60 digits, so that it shows whether it is a square."""
WHOLE = CONTEXT.mpf(10) ** -20
"""A computed coefficient this close to an integer may be that; the candidate is then squared exactly."""


class Field:
    """A field that grows with the numbers that are read into it."""

    def __init__(self, expressions: Iterable[sympy.Expr] = ()) -> None:
        """`expressions`: all whose angles must have a place in it."""
        self.generators: list[Generator] = []
        self._read: dict[sympy.Expr, Exact] = {}
        self._roots: dict[Exact, Exact | None] = {}
        self.unit = _angle_unit(expressions)
        if self.unit > 1:
            self._begin_with_cosine()

    @property
    def degree(self) -> int:
        """Degree over the rational numbers."""
        result = 1
        for generator in self.generators:
            result *= generator.degree
        return result

    def __str__(self) -> str:
        return f"Q({', '.join(str(g.name) for g in self.generators)})" if self.generators else "Q"

    def read(self, e: sympy.Expr) -> Exact:
        """The number that an expression stands for; raises NotDecidableError where it is not in such a field."""
        if e not in self._read:
            self._read[e] = self._convert(e)
        return self._read[e]

    def direction(self, axis: Iterable[sympy.Expr]) -> tuple[Exact, ...]:
        """A vector along `axis` with one component 1: a direction needs no length, and often fewer roots."""
        before, known = list(self.generators), dict(self._read)
        numbers = [self.read(c) for c in axis]
        lead = max((c for c in numbers if c), key=lambda c: abs(value(c)))
        scale = inverse(lead)
        result = tuple(c * scale for c in numbers)
        used = generators_of(result)
        if any(g not in before and g not in used for g in self.generators):
            self.generators = before + [g for g in self.generators if g in used and g not in before]
            self._read = known
        return result

    def sqrt(self, x: Exact) -> Exact:
        """The non-negative square root, adjoined if it is not there."""
        if value(x) < 0:
            raise NotDecidableError("the square root of a negative number")
        found = self._root(x, len(self.generators))
        if found is None:
            if sum(1 for g in self.generators if g.degree == 2) >= MOST_ROOTS:
                raise NotDecidableError(f"more than {MOST_ROOTS} independent square roots")
            # an integer radicand without small squares keeps coefficients short
            outside, inside = _reduced(x)
            level = self.generators[-1].level + 1 if self.generators else 0
            root = CONTEXT.sqrt(value(inside))
            generator = Generator(level, (-inside, Fraction(0)), root, sympy.sqrt(expression(inside)))
            self.generators.append(generator)
            return Number(generator, (Fraction(0), outside))
        return found if value(found) >= 0 else -found

    def _convert(self, e: sympy.Expr) -> Exact:
        if e.is_Rational:
            return Fraction(int(e.p), int(e.q))
        if e.is_Add:
            return sum((self.read(a) for a in e.args), Fraction(0))
        if e.is_Mul:
            result: Exact = Fraction(1)
            for a in e.args:
                result = result * self.read(a)
            return result
        if e.is_Pow and e.exp.is_Rational and e.exp.q in (1, 2):
            base = self.read(e.base)
            power = base if e.exp.q == 1 else self.sqrt(base)
            result = Fraction(1)
            for _ in range(abs(int(e.exp.p))):
                result = result * power
            return result if e.exp > 0 else inverse(result)
        if isinstance(e, sympy.Abs):
            inner = self.read(e.args[0])
            return inner if value(inner) >= 0 else -inner
        if isinstance(e, (sympy.sin, sympy.cos)):
            return self._trigonometric(e)
        expanded = sympy.expand_trig(e)
        if expanded != e:
            return self.read(expanded)
        raise NotDecidableError(f"{e} is not an algebraic number that could be decided")

    def _trigonometric(self, e: sympy.Expr) -> Exact:
        turn = e.args[0] / (2 * sympy.pi)
        if not turn.is_Rational:
            expanded = sympy.expand_trig(e)
            if expanded != e:
                return self.read(expanded)
            raise NotDecidableError(f"{e} is transcendental")
        if isinstance(e, sympy.sin):
            turn = sympy.Rational(1, 4) - turn
        step = turn * self.unit
        if not step.is_Integer or not self.generators or self.generators[0].degree == 1:
            raise NotDecidableError(f"{e} has no place in the field")
        theta = Number(self.generators[0], self._theta())
        before: Exact = Fraction(2)
        now: Exact = theta
        for _ in range(abs(int(step)) % self.unit - 1):
            before, now = now, theta * now - before
        return (now if abs(int(step)) % self.unit else Fraction(2)) * Fraction(1, 2)

    def _theta(self) -> tuple[Exact, ...]:
        return (Fraction(0), Fraction(1)) + (Fraction(0),) * (self.generators[0].degree - 2)

    def _begin_with_cosine(self) -> None:
        n = self.unit
        turns = [j for j in range(1, n // 2 + 1) if gcd(j, n) == 1]
        if not 2 <= len(turns) <= HIGHEST_DEGREE:
            raise NotDecidableError(f"2 cos(2 pi/{n}) has degree {len(turns)}")
        conjugates = tuple(2 * CONTEXT.cos(2 * CONTEXT.pi * j / n) for j in turns)
        # the minimal polynomial has integer coefficients and these roots
        product_so_far = [CONTEXT.one]
        for root in conjugates:
            shifted = [CONTEXT.zero, *product_so_far]
            product_so_far = [a - root * b for a, b in zip(shifted, [*product_so_far, CONTEXT.zero], strict=True)]
        low = tuple(Fraction(int(CONTEXT.nint(c))) for c in product_so_far[:-1])
        self.generators.append(Generator(0, low, conjugates[0], 2 * sympy.cos(2 * sympy.pi / n), conjugates))

    def _root(self, x: Exact, level: int) -> Exact | None:
        """A square root of x among the numbers of the first `level` generators, or None: there is none."""
        if not x:
            return Fraction(0)
        if value(x) < 0:
            return None
        if level == 0:
            return _rational_root(Fraction(x))
        generator = self.generators[level - 1]
        if generator.conjugates:
            if x not in self._roots:
                self._roots[x] = _cyclotomic_root(x, generator)
            return self._roots[x]
        minus_r = generator.modulus[0]
        a, b = x.coefficients if isinstance(x, Number) and x.generator is generator else (x, Fraction(0))
        if not b:
            found = self._root(a, level - 1)
            if found is None and (other := self._root(a / -minus_r, level - 1)) is not None:
                found = made(generator, (Fraction(0), other))
            return found
        norm = self._root(a * a + b * b * minus_r, level - 1)
        if norm is None:
            return None
        for sign in (1, -1):
            s = self._root((a + sign * norm) * Fraction(1, 2), level - 1)
            if s:
                return made(generator, (s, b * inverse(2 * s)))
        return None


def _rational_root(x: Fraction) -> Fraction | None:
    top, bottom = isqrt(x.numerator), isqrt(x.denominator)
    return Fraction(top, bottom) if top * top == x.numerator and bottom * bottom == x.denominator else None


def _reduced(x: Exact) -> tuple[Fraction, Exact]:
    """(f, y) with x = f^2 y: a rational x becomes an integer y without squares of small primes."""
    if isinstance(x, Number):
        return Fraction(1), x
    outside, inside = Fraction(1, x.denominator), x.numerator * x.denominator
    for prime in sympy.primerange(2, LARGEST_SQUARED):
        while inside % (prime * prime) == 0:
            inside //= prime * prime
            outside *= int(prime)
    return outside, Fraction(inside)


def _cyclotomic_root(x: Exact, generator: Generator) -> Exact | None:
    """A root in Q(theta): times the common denominator it is an integer combination of powers of theta.

    (Z[2 cos(2 pi / n)] is the ring of integers; its conjugates are the roots of those of x, up to signs.)
    """
    degree = generator.degree
    coefficients = x.coefficients if isinstance(x, Number) else (x, *[Fraction(0)] * (degree - 1))
    denominator = lcm(*(Fraction(c).denominator for c in coefficients))
    squares = [sum(value(c) * t**k for k, c in enumerate(coefficients)) for t in generator.conjugates]
    if min(squares) < 0:
        return None
    if denominator * max(squares) > LONGEST_SQUARE:
        raise NotDecidableError("a square root of numbers that are too long")
    norm = CONTEXT.one
    for s in squares:
        norm *= s * denominator * denominator
    whole_norm = int(CONTEXT.nint(norm))
    if norm < CERTAIN_NORM and isqrt(whole_norm) ** 2 != whole_norm:
        return None  # the norm of a square is a square
    roots = [CONTEXT.sqrt(s) * denominator for s in squares]
    powers = CONTEXT.matrix([[t**k for k in range(degree)] for t in generator.conjugates])
    back = powers**-1
    for signs in product((1, -1), repeat=degree - 1):
        signed = [roots[0], *(s * r for s, r in zip(signs, roots[1:], strict=True))]
        found = [sum(back[i, j] * signed[j] for j in range(degree)) for i in range(degree)]
        whole = [int(CONTEXT.nint(c)) for c in found]
        if max(abs(c - w) for c, w in zip(found, whole, strict=True)) < WHOLE:
            candidate = made(generator, tuple(Fraction(w, denominator) for w in whole))
            if candidate * candidate == x:
                return candidate
    return None


def _angle_unit(expressions: Iterable[sympy.Expr]) -> int:
    """n such that all sines and cosines of rational parts of pi are in Q(2 cos(2 pi / n)); 1 without any."""
    n = 1
    for e in expressions:
        for angle in _angles(e):
            turn = angle / (2 * sympy.pi)
            if turn.is_Rational:
                n = lcm(n, int(turn.q), 4)
    return n


def _angles(e: sympy.Expr) -> Iterator[sympy.Expr]:
    for atom in e.atoms(sympy.sin, sympy.cos):
        expanded = sympy.expand_trig(atom)
        for inner in expanded.atoms(sympy.sin, sympy.cos) or {atom}:
            yield inner.args[0]
