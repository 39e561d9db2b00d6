"""Numbers of one mechanism whose held angles are fractions [rad], exactly: in the tangent t of half their common part.

    held angles --multiples of one fraction--> powers of ((1 - t^2)/(1 + t^2), 2 t/(1 + t^2)), as Singular writes them

The cosine of a fraction is transcendental (F. Lindemann, 1882), and t with it: numbers in t, over an algebraic field,
are zero where they are zero for every t, so that what Groebner bases say of the field of fractions in t holds here.
"""

from __future__ import annotations

from fractions import Fraction
from math import gcd
from typing import Any

from symscrew.assembly.closure_ideal import ClosureIdeal, Exactly, Written
from symscrew.assembly.residues import Angle, NumbersOf, Residue
from symscrew.assembly.what_is_held import Held
from symscrew.mobility import Exact, Field, NotDecidableError

MOST_MULTIPLE = 8
"""Of the common part, in one angle: numbers have twice its degree in t. Angles of a few digits that differ have more,
and their bases do not end."""


class Told(Residue):
    """A number modulo a prime that is also told exactly: a number of the field, or in words, as Singular writes it."""

    __slots__ = ("exact", "field", "text")

    def __init__(self, number: Residue, field: Exactly, exact: Exact | None, text: str = "") -> None:
        super().__init__(number.value, number.rest, number.prime)
        self.field, self.exact = field, exact
        self.text = text if exact is None else field.exact(exact) or "0"

    def _told(self, other: Any) -> Told:
        if isinstance(other, Told):
            return other
        return Told(self._of(other), self.field, Fraction(int(other)))

    def __add__(self, other: Any) -> Told:
        one, two, rest = self, self._told(other), super().__add__(other)
        if one.exact is not None and two.exact is not None:
            return Told(rest, self.field, one.exact + two.exact)
        return Told(rest, self.field, None, f"({one.text}+{two.text})")

    __radd__ = __add__

    def __neg__(self) -> Told:
        rest = super().__neg__()
        return Told(rest, self.field, None if self.exact is None else -self.exact, f"(-{self.text})")

    def __sub__(self, other: Any) -> Told:
        return self + -self._told(other)

    def __rsub__(self, other: Any) -> Told:
        return self.__neg__().__add__(other)

    def __mul__(self, other: Any) -> Told:
        one, two, rest = self, self._told(other), super().__mul__(other)
        if one.exact is not None and two.exact is not None:
            return Told(rest, self.field, one.exact * two.exact)
        if 0 in (one.exact, two.exact):
            return Told(rest, self.field, Fraction(0))
        return Told(rest, self.field, None, f"{one.text}*{two.text}")

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Told:
        below = self._told(other)
        if below.exact is None:
            raise NotDecidableError("a division by a number in t")
        return self * Told(1 / Residue(below.value, below.rest, below.prime), self.field, 1 / below.exact)

    def __rtruediv__(self, other: Any) -> Told:
        return self._told(other) / self

    def __pow__(self, power: float) -> Told:
        """The square root of 1: others would be new roots."""
        if self.exact != 1:
            raise NotDecidableError("a root that is not in the field")
        return self


class InTangent(Written):
    """Numbers of a field, and t: as `Exactly`, with powers of the point of the circle."""

    def __init__(self, field: Field) -> None:
        self.exactly = Exactly(field)
        super().__init__("(0,t)", dict(zip(self.exactly.unknowns, self.exactly.equations, strict=True)), field.degree)

    def text(self, number: Any) -> str:
        """A number, or nothing where it is zero."""
        if not isinstance(number, Told) or number.exact is not None:
            return self.exactly.exact(number.exact if isinstance(number, Told) else Fraction(int(number)))
        return f"({number.text})"


class _InTangent(NumbersOf):
    """The numbers with words."""

    def ideal(self) -> ClosureIdeal:
        self.take_prime()
        self.written = InTangent(self.field)
        multiples = [int(fraction * self.unit) for fraction in self.fractions.values()]
        self.common = gcd(*multiples) or 1
        largest = max(map(abs, multiples), default=0) // self.common
        if largest > MOST_MULTIPLE:
            raise NotDecidableError(f"angles have {largest} times their common part, {MOST_MULTIPLE} at most are tried")
        structure, slots = self.in_slots()
        return ClosureIdeal(structure, slots, self.written, tuple(_powers(largest)))

    def _read(self, value: Any) -> Any:
        if isinstance(value, Told):
            return value
        return Told(super()._read(value), self.written.exactly, Fraction(int(value)))

    def _exact(self, x: Exact) -> Any:
        return Told(super()._exact(x), self.written.exactly, x)

    def _circle(self, angle: Any) -> tuple[Any, Any]:
        cosine, sine = super()._circle(angle)
        if not isinstance(angle, Angle):
            return cosine, sine
        (a, b), k = angle.turn, angle.multiple // self.common
        assert isinstance(a, Told) and isinstance(b, Told)
        if not k:
            return a, b
        field, c, s = self.written.exactly, f"c{abs(k)}", f"s{k}" if k > 0 else f"(-s{-k})"
        return (Told(cosine, field, None, f"({a.text}*{c}-{b.text}*{s})"),
                Told(sine, field, None, f"({a.text}*{s}+{b.text}*{c})"))  # fmt: skip


def _powers(largest: int) -> list[str]:
    """Cosines and sines of multiples of the common part."""
    lines = ["number c1 = (1-t^2)/(1+t^2);", "number s1 = 2*t/(1+t^2);"]
    for k in range(2, largest + 1):
        lines += [f"number c{k} = c{k - 1}*c1-s{k - 1}*s1;", f"number s{k} = s{k - 1}*c1+c{k - 1}*s1;"]
    return lines


def ideal_in_tangent(held: Held) -> ClosureIdeal:
    """The closure of a mechanism with these values held.

    Raises:
        NotDecidableError: numbers that are in no such field. NotAlgebraicError: as of the structure.
    """
    return _InTangent(held).ideal()
