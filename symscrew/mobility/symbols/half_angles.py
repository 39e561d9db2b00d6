"""Common factors of polynomials in sines and cosines, where s^2 + c^2 = 1 hides them.

    s^2, s (1 + c) : no common factor as polynomials, 1 + c on the circle;   c = (1 - t^2)/(1 + t^2), s = 2 t/(1 + t^2)

A polynomial of degree n in cosine and sine of an angle is a form of degree 2 n in cosine and sine of its half, so
that common factors are those of polynomials in t = tan(angle/2), the root at infinity (cosine of the half zero)
among them. A factor of even degree in every t is a polynomial in sines and cosines again.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

Poly = Any
"""An element of a polynomial ring of SymPy."""


@dataclass(frozen=True)
class Angle:
    """Indices of the generators that are cosine and sine of one angle."""

    cosine: int
    sine: int


def terms_as_forms(polys: Sequence[Poly], angles: Sequence[Angle]) -> int:
    """About how many terms the polynomials have as forms in halves of the angles."""
    total = sum(map(len, polys))
    for order in _orders(polys, angles):
        total *= 2 * order + 1
    return total


def _orders(polys: Sequence[Poly], angles: Sequence[Angle]) -> list[int]:
    """Largest degree in cosine and sine of each angle."""
    return [max(m[a.cosine] + m[a.sine] for p in polys for m in p.itermonoms()) for a in angles]


def shared_factor(polys: Sequence[Poly], angles: Sequence[Angle]) -> tuple[Poly, list[Poly]]:
    """(common factor g, quotients p / g) of polynomials that are not zero, modulo s^2 + c^2 = 1 of every angle.

    No normal forms: g p' - p is a multiple of the relations. g is 1 where nothing of even degree is in common.
    """
    forms = _Forms(polys, angles)
    common, at_infinity = forms.common()
    if common == 1 and not any(at_infinity):
        return polys[0].ring.one, list(polys)
    degrees = forms.degrees_of(common, at_infinity)
    left = [n - degree // 2 for n, degree in zip(forms.orders, degrees, strict=True)]
    factor = forms.back(common, [degree // 2 for degree in degrees])
    return factor, [forms.back(form.exquo(common), left) for form in forms.forms]


class _Forms:
    """Polynomials as forms in halves of the angles: t stands in the place of the sine, the cosine is gone.

    `orders`: n per angle; every form has the degree 2 n. As its factor 1 + t^2 is one.
    """

    def __init__(self, polys: Sequence[Poly], angles: Sequence[Angle]) -> None:
        self.angles, self.ring = angles, polys[0].ring
        self.orders = _orders(polys, angles)
        self.forms = [self._form(p) for p in polys]

    def _form(self, poly: Poly) -> Poly:
        one, total = self.ring.one, self.ring.zero
        for monomial, coefficient in poly.terms():
            others = list(monomial)
            term = one * coefficient
            for angle, order in zip(self.angles, self.orders, strict=True):
                c, s = monomial[angle.cosine], monomial[angle.sine]
                t = self.ring.gens[angle.sine]
                term *= (1 - t**2) ** c * (2 * t) ** s * (1 + t**2) ** (order - c - s)
                others[angle.cosine] = others[angle.sine] = 0
            total += term.mul_monom(tuple(others))
        return total

    def degree(self, poly: Poly, angle: Angle) -> int:
        """Degree in t."""
        return max((monomial[angle.sine] for monomial in poly.itermonoms()), default=0)

    def common(self) -> tuple[Poly, list[int]]:
        """(common factor of even degree in every t, how often its root at infinity is in it, per angle)."""
        found = self.ring.zero
        for form in sorted(self.forms, key=len):
            found = found.gcd(form)
            if found.is_ground:
                break
        found = self._without_ones(found)
        highest = [max(self.degree(form, angle) for form in self.forms) for angle in self.angles]
        at_infinity = [2 * n - degree for n, degree in zip(self.orders, highest, strict=True)]
        parts = [factor for factor, power in found.factor_list()[1] for _ in range(power)]
        for k, angle in enumerate(self.angles):
            if (sum(self.degree(part, angle) for part in parts) + at_infinity[k]) % 2 == 0:
                continue
            if at_infinity[k]:
                at_infinity[k] -= 1
            else:  # one of odd degree stays, the simplest
                odd = [part for part in parts if self.degree(part, angle) % 2]
                parts.remove(min(odd, key=lambda part: (self._odd(part), len(part))))
        if any((sum(self.degree(p, a) for p in parts) + i) % 2 for a, i in zip(self.angles, at_infinity, strict=True)):
            return self.ring.one, [0] * len(self.angles)  # what stays of one angle made another odd
        product = self.ring.one
        for part in parts:
            product *= part
        return product, at_infinity

    def _odd(self, part: Poly) -> int:
        """In how many angles a factor is of odd degree."""
        return sum(self.degree(part, angle) % 2 for angle in self.angles)

    def _without_ones(self, found: Poly) -> Poly:
        """The common factor without powers of 1 + t^2, which are taken out of the forms."""
        for k, angle in enumerate(self.angles):
            one = self.ring.gens[angle.sine] ** 2 + 1
            while not found.is_ground and not found.rem(one):
                found = found.exquo(one)
                self.forms = [form.exquo(one) for form in self.forms]
                self.orders[k] -= 1
        return found

    def degrees_of(self, common: Poly, at_infinity: Sequence[int]) -> list[int]:
        """Degree of the common form in the halves of every angle."""
        return [self.degree(common, a) + i for a, i in zip(self.angles, at_infinity, strict=True)]

    def back(self, form: Poly, orders: Sequence[int]) -> Poly:
        """A form of degree 2 m in the halves of every angle, `orders` m, as a polynomial in sines and cosines.

        t^j stands for sin^j cos^(2 m - j) of the half: s/2 for a pair of one each, (1 - c)/2 and (1 + c)/2 for two.
        """
        ring, total = self.ring, self.ring.zero
        for monomial, coefficient in form.terms():
            others = list(monomial)
            term = ring.one * coefficient
            for angle, order in zip(self.angles, orders, strict=True):
                j, c, s = monomial[angle.sine], ring.gens[angle.cosine], ring.gens[angle.sine]
                mixed, sines = j % 2, j // 2
                term *= (s / 2) ** mixed * ((1 - c) / 2) ** sines * ((1 + c) / 2) ** (order - sines - mixed)
                others[angle.sine] = 0
            total += term.mul_monom(tuple(others))
        return total
