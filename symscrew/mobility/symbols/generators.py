"""Expressions of a description as polynomials over generators in which zero is decidable.

    r (1 - cos theta) / sqrt(r^2 + H^2)  -->  (r w - r c w) / (r^2 + H^2),  w^2 = r^2 + H^2, c^2 + s^2 = 1

Generators are the parameters, sine and cosine of each angle with c^2 + s^2 = 1, and a square root w with
w^2 = its radicand. In lexicographic order with w before c before s before the parameters, these relations are a
Groebner basis (their leading terms w^2, c^2 are coprime), so every polynomial has one normal form, and it is
zero exactly when the normal form is. Sines and cosines of rational parts of pi are polynomials in one generator
2 cos(2 pi / n) with its minimal polynomial.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, isqrt, lcm
from typing import Any

import numpy as np
import sympy
from sympy import QQ
from sympy.polys.rings import PolyRing

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description import Mechanism
from symscrew.mobility.symbols.atoms import atoms_of
from symscrew.mobility.symbols.common_divisor import divisor
from symscrew.mobility.symbols.exact_field import Field
from symscrew.mobility.symbols.exact_numbers import NotDecidableError, Number
from symscrew.mobility.symbols.half_angles import Angle, shared_factor, terms_as_forms
from symscrew.mobility.symbols.square_classes import SquareClasses, is_square

Poly = Any
"""An element of the ring: SymPy's `PolyElement`, which is generic in a way that type checkers do not follow."""


MOST_PRODUCTS = 12_000
"""Products of terms that one ring makes: a few seconds, formulas of a page. The seed needs a quarter of it, a Stewart
platform three quarters, and for the loci of its drives more. Beyond it the symbols, or these loci, are given up with a
sentence; numbers and ranks do not depend on them."""
MOST_FORMS = 60_000
"""Terms of polynomials written in halves of their angles, where common factors on the circle are looked for: a second.
A PRS limb needs 185, the seed's 2055. Beyond it the symbols are given up with a sentence, for loci would be wrong."""
FLAT = 1e-12
"""Eigenvalues of a quadratic form below this, relative to the largest, are zero: forms of a few rational coefficients.
Wrong either way, a locus that no real parameters reach is shown, or hidden."""


class NotPolynomialError(ValueError):
    """An expression has a function that is neither rational, nor a sine or cosine, nor a square root."""


@dataclass(frozen=True)
class Quotient:
    """numerator / denominator, both in normal form."""

    numerator: Any
    denominator: Any


class Generators:
    """The ring of the given expressions; `mechanism` gives the parameters' values, for signs of square roots."""

    def __init__(self, mechanism: Mechanism, expressions: Iterable[sympy.Expr]) -> None:
        self.values = {p.symbol: p.value for p in mechanism.parameters.values()}
        prepared = [sympy.expand_trig(e) for e in expressions]
        parameters, every, roots = atoms_of(prepared)
        angles = [angle for angle in every if angle.free_symbols]
        self.constants = _constants([e for e in prepared if len(angles) < len(every)])
        self.parameters = parameters
        atoms = [*roots, *(sympy.cos(a) for a in angles), *(sympy.sin(a) for a in angles), *parameters]
        if self.constants.generators:
            atoms.append(self.constants.generators[0].name)
        names = [f"g{k}" for k in range(len(atoms))] or ["unused"]
        self.ring = PolyRing(names, sympy.QQ, sympy.lex)
        self.atoms: dict[sympy.Expr, Poly] = dict(zip(atoms, self.ring.gens, strict=False))
        self._back = dict(zip(self.ring.symbols, atoms, strict=False))
        self._relations = [self.atoms[sympy.cos(a)] ** 2 + self.atoms[sympy.sin(a)] ** 2 - 1 for a in angles]
        self._angles = [Angle(atoms.index(sympy.cos(a)), atoms.index(sympy.sin(a))) for a in angles]
        if self.constants.generators:
            theta = self.ring.gens[len(atoms) - 1]
            modulus = self.constants.generators[0].modulus
            low = (theta**k * QQ(c.numerator, c.denominator) for k, c in enumerate(modulus) if c)
            self._relations.append(theta ** len(modulus) + sum(low, self.ring.zero))
        self._spent = 0
        self._places: dict[frozenset[tuple[sympy.Symbol, sympy.Expr]], list[Any]] = {}
        self._factors: dict[Poly, list[Poly]] = {}
        self._replaced: dict[sympy.Expr, Quotient] = {}
        self._radicands = SquareClasses()
        self._roots: list[tuple[Poly, Poly]] = []
        for root in reversed(roots):
            self._define_root(root)

    def read(self, expression: sympy.Expr) -> Quotient:
        """The expression as a fraction of normal forms."""
        return self._read(sympy.expand_trig(expression))

    def normal(self, poly: Poly) -> Poly:
        """The normal form."""
        leading = [_leading(relation) for relation in self._relations]
        if all(monomial[k] < power for monomial in poly.itermonoms() for k, power in leading):
            return poly
        return poly.rem(self._relations)

    def product(self, a: Poly, b: Poly) -> Poly:
        """Normal form of a product; raises NotPolynomialError when too many have been made."""
        self._spent += len(a) * len(b)
        if self._spent > MOST_PRODUCTS:
            raise NotPolynomialError("the closed forms are not of reasonable size")
        return self.normal(a * b) if a and b else self.ring.zero

    def cancelled(self, top: Poly, bottom: Poly) -> Quotient:
        """top / bottom without their common factor."""
        if not top:
            return Quotient(top, self.ring.one)
        if bottom.is_ground:
            return Quotient(top.quo_ground(bottom.coeff(1)), self.ring.one)
        common = divisor(top, bottom)
        return Quotient(top, bottom) if common == 1 else Quotient(top.exquo(common), bottom.exquo(common))

    def shortest(self, poly: Poly) -> Poly:
        """The polynomial with squares of sines or of cosines, per angle, whichever leaves fewest terms; not normal."""
        for angle in self._angles:
            cosine, square = angle.cosine, self.ring.gens[angle.cosine] ** 2
            other = self.ring.zero
            for monomial, coefficient in poly.terms():
                pairs, rest = divmod(monomial[angle.sine], 2)
                left = tuple(rest if k == angle.sine else m for k, m in enumerate(monomial))
                other += ((1 - square) ** pairs * coefficient).mul_monom(left)
            poly = min(poly, other, key=lambda p: (len(p), p.degree(cosine)))
        return poly

    def expression(self, poly: Poly) -> sympy.Expr:
        """The polynomial in the description's own words."""
        if not poly:
            return sympy.S.Zero
        result = poly.as_expr()
        if self.constants.generators:
            theta = self.ring.symbols[len(self.atoms) - 1]
            result = sympy.expand(result.replace(lambda e: e == theta or (e.is_Pow and e.base == theta), self._cosines))
        return result.xreplace(self._back)

    def _cosines(self, power: sympy.Expr) -> sympy.Expr:
        """theta^k as a sum of cosines of multiples, (z + 1/z)^k."""
        k = int(power.exp) if power.is_Pow else 1
        turn = 2 * sympy.pi / self.constants.unit
        return sympy.Add(*(sympy.binomial(k, j) * sympy.cos((k - 2 * j) * turn) for j in range(k + 1)))

    def determinant(self, rows: Sequence[Sequence[Poly]]) -> Poly:
        """Determinant without divisions, by expansion along the sparsest row."""
        if not rows:
            return self.ring.one
        k = min(range(len(rows)), key=lambda i: sum(1 for c in rows[i] if c))
        total = self.ring.zero
        others = [row for i, row in enumerate(rows) if i != k]
        for j, entry in enumerate(rows[k]):
            if entry:
                minor = self.determinant([[*row[:j], *row[j + 1 :]] for row in others])
                term = self.product(entry, minor)
                total = total + term if (j + k) % 2 == 0 else total - term
        return self.normal(total)

    def shared(self, polys: Sequence[Poly]) -> tuple[Poly, list[Poly]]:
        """(g, p / g): the greatest common divisor of normal forms (1 where all are zero), and quotients.

        In sines and cosines as on the circle, where s^2 and s (1 + c) have 1 + c in common; of these factors those that
        are polynomials in them: see `half_angles`.
        """
        common = self._divisor(polys)
        divided = [poly if common == 1 else poly.exquo(common) for poly in polys]
        present = [poly for poly in divided if poly]
        met = [a for a in self._angles if any(m[a.cosine] or m[a.sine] for p in present for m in p.itermonoms())]
        if not met or any(p.is_ground for p in present) or len(present) < 2:
            return common, divided
        if terms_as_forms(present, met) > MOST_FORMS:
            raise NotPolynomialError("the closed forms are not of reasonable size")
        factor, quotients = shared_factor(present, met)
        if factor.is_ground:
            return common, divided
        quotients = [self.normal(p) for p in quotients]
        if any(self.normal(factor * q - p) for q, p in zip(quotients, present, strict=True)):
            raise AssertionError("a common factor that does not divide")
        left = iter(quotients)
        return self.normal(common * factor), [next(left) if p else p for p in divided]

    def common_factor(self, polys: Iterable[Poly]) -> Poly:
        """The greatest common divisor of normal forms: see `shared`; without angles no more are asked for than tell."""
        return self.shared(list(polys))[0] if self._angles else self._divisor(polys)

    def _divisor(self, polys: Iterable[Poly]) -> Poly:
        """The greatest common divisor as polynomials (1 where all are zero)."""
        result = self.ring.zero
        for poly in polys:
            result = divisor(result, poly)
            if result == 1:
                break
        return result or self.ring.one

    def primitive(self, vector: Sequence[Poly]) -> list[Poly]:
        """The vector without the common factor of its components, numbers among it."""
        quotients = self.shared(vector)[1]
        numbers = [number for quotient in quotients for number in quotient.coeffs()]
        least = lcm(*(int(number.denominator) for number in numbers))
        size = QQ(gcd(*(int(number * least) for number in numbers)) or 1, least)
        return [quotient.quo_ground(size) for quotient in quotients]

    def without_roots_in(self, polys: Sequence[Poly]) -> list[Poly]:
        """The polynomials without common factors that have a square root in them, such as p + sqrt(H^2 + L^2).

        c / f = c f' / (f f') with f' the conjugate of f, whose product is free of the root; factors are looked for
        in the shortest of the polynomials.
        """
        result = list(polys)
        present = [c for c in polys if c]
        if not self._roots or not present:
            return result
        shortest = min(present, key=lambda c: len(c.terms()))
        for factor, _ in shortest.factor_list()[1]:
            for _, root in self._roots:
                conjugate = factor.compose(root, -root)
                if conjugate == factor:
                    continue
                norm = self.product(factor, conjugate)
                divided = [divmod(self.product(c, conjugate), norm) if c else (c, c) for c in result]
                if norm and not any(rest for _, rest in divided):
                    result = [self.normal(c) for c, _ in divided]
                    break
        return result

    def factors(self, poly: Poly) -> list[Poly]:
        """Irreducible factors that can vanish for real values of the generators, each once."""
        if not poly or poly.is_ground:
            return []
        return [factor for factor in self._factored(poly) if not self._never_zero(factor)]

    def _factored(self, poly: Poly) -> list[Poly]:
        """Irreducible factors, each once."""
        if poly not in self._factors:
            self._factors[poly] = [factor for factor, _ in poly.factor_list()[1]]
        return self._factors[poly]

    def all_listed(self, common: Poly, quotients: Iterable[Poly]) -> bool:
        """Whether polynomials, `shared`, vanish together nowhere but where `factors` of what they have in common do.

        False says only that this is not known: they may where several conditions hold at once.
        """
        hidden = [factor for factor in self._factored(common) if self._never_zero(factor)]
        return all(map(self._positive, hidden)) and any(map(self._positive, filter(None, quotients)))

    def _positive(self, poly: Poly) -> bool:
        """A number, or a sum of even powers with one: zero nowhere."""
        if self._constant_only(poly):
            return bool(poly)
        signs = {coefficient > 0 for _, coefficient in poly.terms()}
        even = all(exponent % 2 == 0 for monomial, _ in poly.terms() for exponent in monomial)
        return len(signs) == 1 and even and any(not any(monomial) for monomial in poly.itermonoms())

    def number(self, poly: Poly, values: Mapping[sympy.Symbol, sympy.Expr] | None = None) -> Any:
        """Value in 60 digits at the parameters' values, or at others."""
        given = values if values is not None else self.values
        key = frozenset(given.items())
        if key not in self._places:
            place = [high_precision(self._back[g].xreplace(dict(given))) for g in self.ring.symbols if g in self._back]
            self._places[key] = place
        place = self._places[key]
        total = CONTEXT.zero
        for monomial, coefficient in poly.terms():
            term = CONTEXT.mpf(int(coefficient.numerator)) / int(coefficient.denominator)
            for k, exponent in enumerate(monomial):
                if exponent:
                    term *= place[k] ** exponent
            total += term
        return total

    def _constant_only(self, poly: Poly) -> bool:
        """A number: a polynomial in the constants' cosine alone, in normal form and so not zero."""
        if poly.is_ground:
            return True
        last = len(self.atoms) - 1 if self.constants.generators else -1
        return all(k == last for monomial in poly.itermonoms() for k, exponent in enumerate(monomial) if exponent)

    def _never_zero(self, poly: Poly) -> bool:
        """A constant, or a sum of even powers: it vanishes nowhere or where several generators do at once."""
        if poly.is_ground:
            return True
        if _definite(poly) or (self.constants.generators and self._constant_only(poly)):
            return True
        signs = {coefficient > 0 for _, coefficient in poly.terms()}
        even = all(exponent % 2 == 0 for monomial, _ in poly.terms() for exponent in monomial)
        return len(signs) == 1 and even

    def _define_root(self, root: sympy.Expr) -> None:
        """w^2 = radicand, squares taken out: sqrt(L^2 (s^2 + c^2)) is |L|, its sign that of the values."""
        inner = self._read(root.base)
        square = self.product(inner.numerator, inner.denominator)  # sqrt(n/d) = sqrt(n d) / d, up to the sign of d
        if square.is_ground and (known := self._root_among_constants(square)) is not None:
            self._replaced[root] = Quotient(known, inner.denominator)
            return
        coefficient, factors = square.factor_list()
        outside, rest = self.ring.one, self.ring.one
        for factor, power in factors:
            outside = self.product(outside, factor ** (power // 2))
            rest = self.product(rest, factor ** (power % 2))
        number = _fraction(coefficient)
        if rational := is_square(number):
            outside = outside * QQ(isqrt(number.numerator), isqrt(number.denominator))
        else:
            rest = rest * coefficient
        here = outside
        if not rest.is_ground or not rational:
            here = self.product(outside, self._root_of(rest, root))
        sign = 1 if self.number(here) * self.number(inner.denominator) >= 0 else -1
        self._replaced[root] = Quotient(sign * here, inner.denominator)

    def _root_among_constants(self, square: Poly) -> Poly | None:
        """The root of a rational number, where it is a polynomial in the cosine of the constants' field."""
        if not self.constants.generators or not square:
            return None
        coefficient = square.coeff(1)
        number = sympy.Rational(int(coefficient.numerator), int(coefficient.denominator))
        if number < 0:
            return None
        degree = self.constants.degree
        found = self.constants.read(sympy.sqrt(number))
        return self._constant(found) if self.constants.degree == degree else None

    def _constant(self, x: Any) -> Poly:
        """A number of the constants' field as a polynomial in its cosine."""
        theta = self.atoms[self.constants.generators[0].name]
        coefficients = x.coefficients if isinstance(x, Number) else (x,)
        terms = (theta**k * QQ(c.numerator, c.denominator) for k, c in enumerate(coefficients) if c)
        return sum(terms, self.ring.zero)

    def _root_of(self, radicand: Poly, root: sympy.Expr) -> Poly:
        """The generator w with w^2 = radicand; one that is there already when the radicand is."""
        for known, generator in self._roots:
            if known == radicand:
                return generator
        coefficient, factors = radicand.factor_list()
        if not self._radicands.added(_fraction(coefficient), (factor for factor, power in factors if power % 2)):
            raise NotPolynomialError("square roots that are products of each other")  # there would be divisors of zero
        generator = self.atoms[root]
        self._roots.append((radicand, generator))
        self._relations.insert(0, generator**2 - radicand)
        self._back[self.ring.symbols[list(self.atoms).index(root)]] = sympy.sqrt(self.expression(radicand))
        self._places.clear()
        return generator

    def _read(self, e: sympy.Expr) -> Quotient:
        one = self.ring.one
        if e.is_Rational:
            return Quotient(self.ring.one * sympy.QQ(int(e.p), int(e.q)), one)
        if e in self._replaced:
            return self._replaced[e]
        if e in self.atoms:
            return Quotient(self.atoms[e], one)
        if isinstance(e, (sympy.sin, sympy.cos)) and not e.free_symbols:
            return Quotient(self._constant(self.constants.read(e)), one)
        if e.is_Add:
            parts = [self._read(a) for a in e.args]
            total = parts[0]
            for part in parts[1:]:
                top = self.product(total.numerator, part.denominator) + self.product(part.numerator, total.denominator)
                bottom = self.product(total.denominator, part.denominator)
                if total.denominator == part.denominator:
                    top, bottom = total.numerator + part.numerator, total.denominator
                total = Quotient(self.normal(top), bottom)
            return total
        if e.is_Mul:
            top, bottom = one, one
            for part in map(self._read, e.args):
                top, bottom = self.product(top, part.numerator), self.product(bottom, part.denominator)
            return Quotient(top, bottom)
        if e.is_Pow and e.exp.is_Rational and e.exp.q in (1, 2):
            base = self._read(e.base if e.exp.q == 1 else sympy.sqrt(e.base))
            power = abs(int(e.exp.p))
            top, bottom = self.normal(base.numerator**power), self.normal(base.denominator**power)
            return Quotient(top, bottom) if e.exp > 0 else Quotient(bottom, top)
        raise NotPolynomialError(f"{e} is neither rational in the parameters nor a sine, cosine or square root")


def _fraction(number: Any) -> Fraction:
    return Fraction(int(number.numerator), int(number.denominator))


def _leading(relation: Poly) -> tuple[int, int]:
    """(generator, power) of the leading term of a relation."""
    exponents = relation.leading_expv()
    power = max(exponents)
    return exponents.index(power), power


def _definite(poly: Poly) -> bool:
    """A quadratic form in the generators that is a sum of two squares or more, such as H^2 + (R - r)^2."""
    if any(sum(monomial) != 2 for monomial, _ in poly.terms()):
        return False
    size = poly.ring.ngens
    form = np.zeros((size, size))
    for monomial, coefficient in poly.terms():
        places = [k for k, exponent in enumerate(monomial) for _ in range(exponent)]
        form[places[0], places[1]] += float(coefficient) / 2
        form[places[1], places[0]] += float(coefficient) / 2
    values = np.linalg.eigvalsh(form)
    tiny = FLAT * np.abs(values).max()
    return bool((values > -tiny).all() or (values < tiny).all()) and int((np.abs(values) > tiny).sum()) >= 2


def _constants(expressions: Iterable[sympy.Expr]) -> Field:
    """The field of the sines and cosines of rational parts of pi among the expressions."""
    try:
        return Field([atom for e in expressions for atom in e.atoms(sympy.sin, sympy.cos) if not atom.free_symbols])
    except NotDecidableError as error:
        raise NotPolynomialError(str(error)) from error
