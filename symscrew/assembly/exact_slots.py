"""The numbers of one mechanism in a field in which zero is decidable, and its equations in them, exactly.

    expressions --Field--> points, axes, lengths, held angles as numbers of the field --slot_numbers--> slots
    slots, homogeneous coordinates as power series --dual_forms--> F as power series

A power series has exponents of its variables -> number, none of them 0, up to an order of all exponents together. Axes
have any length here, as nothing depends on it, so that fewer roots are needed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.dual_forms import CONJUGATE, PRODUCT, SIZE
from symscrew.assembly.residues import Angle, NumbersOf
from symscrew.assembly.slot_numbers import matrices, spins_of
from symscrew.assembly.what_is_held import Held
from symscrew.mobility import Exact, Field, NotDecidableError, exact_value

Array = np.ndarray[Any, Any]

TERMS = [(k, i, j, int(PRODUCT[k, i, j])) for k in range(SIZE) for i in range(SIZE) for j in range(SIZE)
         if PRODUCT[k, i, j]]  # fmt: skip
Series = dict[tuple[int, ...], Exact]


class Algebraic:
    """A number of a field. A square root that is not there is adjoined."""

    __slots__ = ("exact", "field")

    def __init__(self, exact: Exact, field: Field) -> None:
        self.exact, self.field = exact, field

    def _of(self, other: Any) -> Exact:
        if isinstance(other, Algebraic):
            return other.exact
        if int(other) != other:
            raise NotDecidableError(f"{other} came without its exact number")
        return Fraction(int(other))

    def __add__(self, other: Any) -> Algebraic:
        return Algebraic(self.exact + self._of(other), self.field)

    __radd__ = __add__

    def __neg__(self) -> Algebraic:
        return Algebraic(-self.exact, self.field)

    def __sub__(self, other: Any) -> Algebraic:
        return Algebraic(self.exact - self._of(other), self.field)

    def __rsub__(self, other: Any) -> Algebraic:
        return Algebraic(self._of(other) - self.exact, self.field)

    def __mul__(self, other: Any) -> Algebraic:
        return Algebraic(self.exact * self._of(other), self.field)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Algebraic:
        below = self._of(other)
        if not below:
            raise NotDecidableError("a division by zero")
        return Algebraic(self.exact / below, self.field)

    def __rtruediv__(self, other: Any) -> Algebraic:
        return Algebraic(self._of(other), self.field) / self

    def __pow__(self, power: float) -> Algebraic:
        """The square root."""
        if power != 0.5:
            raise NotDecidableError(f"the power {power}")
        return Algebraic(self.field.sqrt(self.exact), self.field)

    def __float__(self) -> float:
        return float(exact_value(self.exact))

    def __bool__(self) -> bool:
        return bool(self.exact)


class _Exactly(NumbersOf):
    """The numbers as they are."""

    def _read(self, value: Any) -> Any:
        return value if isinstance(value, Algebraic) else Algebraic(Fraction(int(value)), self.field)

    def _exact(self, x: Exact) -> Any:
        return Algebraic(x, self.field)

    def _circle(self, angle: Any) -> tuple[Any, Any]:
        if not isinstance(angle, Angle):
            return self._read(1), self._read(0)
        if angle.multiple:
            raise NotDecidableError("cosine and sine of a fraction [rad] are transcendental")
        return angle.turn

    def equations(self) -> ExactEquations:
        structure, slots = self.in_slots()
        return ExactEquations(BatchEquations(structure), slots, self.field)


class ExactEquations:
    """F of a mechanism over a field. `equations`: the same structure in doubles; `slots`: its numbers."""

    def __init__(self, equations: BatchEquations, slots: Sequence[Any], field: Field) -> None:
        self.equations, self.slots, self.field = equations, slots, field
        self.motions, self.loops = matrices(equations.structure, slots)
        self.moving = [*self.motions, *spins_of(equations.structure)]

    def work(self, terms: int) -> int:
        """Products of fractions that values of series of so many terms take, about."""
        factors = sum(len(way) for way in self.equations.ways)
        forms = sum(len(square) for square, _ in self.loops)
        return (factors * len(TERMS) + forms * SIZE) * (terms * self.field.degree) ** 2

    def values(self, z: Sequence[Series], order: int) -> list[Series]:
        """Every row, of coordinates that are power series, up to this order."""
        made = [
            [linear(motion[i], z[part]) for i in range(SIZE)]
            for motion, part in zip(self.moving, self.equations.made_of, strict=True)
        ]
        rows: list[Series] = []
        for (square, linear_), way in zip(self.loops, self.equations.ways, strict=True):
            turned = [
                [_times(c, Fraction(int(CONJUGATE[i]))) if f.back else c for i, c in enumerate(made[f.motion])]
                for f in way
            ]
            g = turned[0]
            for factor in turned[1:]:
                g = _product(g, factor, order)
            rows += [_sum([product(c, linear(form[i], g), order) for i, c in enumerate(g)]) for form in square]
            rows += [linear(row, g) for row in linear_]
        for place in self.equations.free:
            x = z[self.equations.parts[place]]
            rows.append(_sum([product(x[i], x[i + 4], order) for i in range(4)]))
        return rows


def exact_equations(held: Held) -> ExactEquations:
    """The equations of a mechanism with these values held.

    Raises:
        NotDecidableError: numbers that are in no such field. NotAlgebraicError: as of the structure.
    """
    return _Exactly(held).equations()


def linear(row: Sequence[Any], z: Sequence[Series]) -> Series:
    """The sum of series, each times a number of the row."""
    factors = [c.exact if isinstance(c, Algebraic) else Fraction(int(c)) for c in row]
    return _sum([_times(c, factor) for c, factor in zip(z, factors, strict=True) if factor])


def _times(series: Mapping[tuple[int, ...], Exact], factor: Exact) -> Series:
    return {key: c * factor for key, c in series.items()}


def _sum(values: Sequence[Series]) -> Series:
    total: Series = {}
    for value in values:
        for key, c in value.items():
            total[key] = total[key] + c if key in total else c
    return {key: c for key, c in total.items() if c}


def product(a: Series, b: Series, order: int) -> Series:
    """The product of two series, up to an order."""
    found: Series = {}
    for one, x in a.items():
        left = order - sum(one)
        for two, y in b.items():
            if sum(two) <= left:
                key = tuple(map(int.__add__, one, two))
                found[key] = found[key] + x * y if key in found else x * y
    return {key: c for key, c in found.items() if c}


def _product(a: Sequence[Series], b: Sequence[Series], order: int) -> list[Series]:
    """The product of dual quaternions."""
    parts: list[list[Series]] = [[] for _ in range(SIZE)]
    for k, i, j, sign in TERMS:
        parts[k].append(_times(product(a[i], b[j], order), Fraction(sign)))
    return [_sum(part) for part in parts]
