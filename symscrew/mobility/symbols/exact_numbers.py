"""Exact real numbers: rational, or polynomials in a generator over the numbers below it, in one normal form.

    a + b w with w^2 = r: its product with c + d w is (a c + b d r) + (a d + b c) w, and it is 0 only if a = b = 0

because a generator is adjoined only where the numbers below have no such root (see `exact_field`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy

from symscrew.algebra import CONTEXT

Exact = Any
"""A `Fraction` or a `Number`."""


class NotDecidableError(ValueError):
    """A number is not in such a field, or the field is too big; the text says which."""


@dataclass(frozen=True, eq=False)
class Generator:
    """A generator: `modulus` are the low coefficients of its monic polynomial; `value` in 60 digits, `name` exact."""

    level: int
    modulus: tuple[Exact, ...]
    value: Any
    name: sympy.Expr
    conjugates: tuple[Any, ...] = ()

    @property
    def degree(self) -> int:
        """Degree over the numbers below."""
        return len(self.modulus)


class Number:
    """coefficients[0] + coefficients[1] g + ..., not all but the first zero."""

    __slots__ = ("coefficients", "generator")

    def __init__(self, generator: Generator, coefficients: tuple[Exact, ...]) -> None:
        self.generator, self.coefficients = generator, coefficients

    def __bool__(self) -> bool:
        return True

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Number) and self.generator is other.generator and (
            self.coefficients == other.coefficients
        )  # fmt: skip

    def __hash__(self) -> int:
        return hash(self.coefficients)

    def __add__(self, other: Exact) -> Exact:
        if not isinstance(other, Number) or other.generator.level < self.generator.level:
            return Number(self.generator, (self.coefficients[0] + other, *self.coefficients[1:]))
        if other.generator is self.generator:
            return made(
                self.generator, tuple(a + b for a, b in zip(self.coefficients, other.coefficients, strict=True))
            )
        return other + self

    __radd__ = __add__

    def __neg__(self) -> Number:
        return Number(self.generator, tuple(-c for c in self.coefficients))

    def __sub__(self, other: Exact) -> Exact:
        return self + -other

    def __rsub__(self, other: Exact) -> Exact:
        return -self + other

    def __mul__(self, other: Exact) -> Exact:
        if not other:
            return Fraction(0)
        if not isinstance(other, Number) or other.generator.level < self.generator.level:
            return Number(self.generator, tuple(c * other for c in self.coefficients))
        if other.generator is not self.generator:
            return other * self
        modulus, degree = self.generator.modulus, self.generator.degree
        whole: list[Exact] = [Fraction(0)] * (2 * degree - 1)
        for i, a in enumerate(self.coefficients):
            if a:
                for j, b in enumerate(other.coefficients):
                    if b:
                        whole[i + j] = whole[i + j] + a * b
        for k in range(2 * degree - 2, degree - 1, -1):
            if top := whole[k]:
                for i, m in enumerate(modulus):
                    if m:
                        whole[k - degree + i] = whole[k - degree + i] - top * m
        return made(self.generator, tuple(whole[:degree]))

    __rmul__ = __mul__

    def __truediv__(self, other: Exact) -> Exact:
        return self * inverse(other)

    def __rtruediv__(self, other: Exact) -> Exact:
        return inverse(self) * other


def made(generator: Generator, coefficients: tuple[Exact, ...]) -> Exact:
    """The polynomial in the generator in normal form: one that does not need it is a number below."""
    return Number(generator, coefficients) if any(coefficients[1:]) else coefficients[0]


def inverse(x: Exact) -> Exact:
    """1 / x."""
    if not isinstance(x, Number):
        return 1 / Fraction(x)
    if x.generator.degree == 2 and not x.generator.modulus[1]:
        a, b = x.coefficients
        norm = inverse(a * a + b * b * x.generator.modulus[0])
        return made(x.generator, (a * norm, -b * norm))
    return _inverse_by_euclid(x)


def _inverse_by_euclid(x: Number) -> Exact:
    """Extended Euclid on the polynomial of x and the modulus of its generator."""
    r0: list[Exact] = [*x.generator.modulus, Fraction(1)]
    r1 = _trimmed(list(x.coefficients))
    s0: list[Exact] = []
    s1: list[Exact] = [Fraction(1)]
    while len(r1) > 1:
        quotient, rest = _divided(r0, r1)
        subtracted: list[Exact] = [*s0] + [Fraction(0)] * (len(quotient) + len(s1))
        for i, a in enumerate(quotient):
            for j, b in enumerate(s1):
                subtracted[i + j] = subtracted[i + j] - a * b
        r0, r1, s0, s1 = r1, rest, s1, _trimmed(subtracted)
    scale = inverse(r1[0])
    padded = [c * scale for c in s1] + [Fraction(0)] * (x.generator.degree - len(s1))
    return made(x.generator, tuple(padded))


def _divided(a: list[Exact], b: list[Exact]) -> tuple[list[Exact], list[Exact]]:
    rest, quotient = list(a), [Fraction(0)] * (len(a) - len(b) + 1)
    lead = inverse(b[-1])
    for k in range(len(a) - len(b), -1, -1):
        quotient[k] = factor = rest[k + len(b) - 1] * lead
        if factor:
            for i, c in enumerate(b):
                rest[k + i] = rest[k + i] - factor * c
    return quotient, _trimmed(rest[: len(b) - 1])


def _trimmed(p: list[Exact]) -> list[Exact]:
    while p and not p[-1]:
        p.pop()
    return p


def value(x: Exact) -> Any:
    """The number in 60 digits."""
    if isinstance(x, Number):
        total = CONTEXT.zero
        for c in reversed(x.coefficients):
            total = total * x.generator.value + value(c)
        return total
    x = Fraction(x)
    return CONTEXT.mpf(x.numerator) / x.denominator


def expression(x: Exact) -> sympy.Expr:
    """The number as a SymPy expression."""
    if isinstance(x, Number):
        terms = (expression(c) * x.generator.name**k for k, c in enumerate(x.coefficients) if c)
        return sympy.expand(sympy.Add(*terms))
    x = Fraction(x)
    return sympy.Rational(x.numerator, x.denominator)


def generators_of(numbers: Iterable[Exact]) -> set[Generator]:
    """The generators that the numbers use, with those below them."""
    found: set[Generator] = set()
    stack = list(numbers)
    while stack:
        x = stack.pop()
        if isinstance(x, Number):
            stack += x.coefficients
            if x.generator not in found:
                found.add(x.generator)
                stack += x.generator.modulus
    return found


def generator_itself(generator: Generator) -> Number:
    """The generator as a number."""
    return Number(generator, (Fraction(0), Fraction(1), *[Fraction(0)] * (generator.degree - 2)))


def terms_of(x: Exact, generators: Sequence[Generator]) -> dict[tuple[int, ...], Fraction]:
    """The number as a polynomial in the generators: exponents -> coefficient."""
    if not isinstance(x, Number):
        return {(0,) * len(generators): Fraction(x)} if x else {}
    place = generators.index(x.generator)
    terms: dict[tuple[int, ...], Fraction] = {}
    for power, c in enumerate(x.coefficients):
        for key, value_below in terms_of(c, generators).items():
            terms[(*key[:place], power, *key[place + 1 :])] = value_below
    return terms
