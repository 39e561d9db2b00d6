"""Families that a mechanism is a member of, and ways between their members, over the complex numbers.

all numbers   points, axes, lengths of the structure: every mechanism that is built alike
what is held  the drives of one mechanism, where its numbers are special: overconstrained ones close only with them
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations, Way, straight
from symscrew.assembly.coupled_columns import Follower
from symscrew.assembly.equal_axes import DEGREE as SPINOR_DEGREE
from symscrew.assembly.equal_axes import axis_pairs, equally_long, straight_in_spinors
from symscrew.assembly.slot_numbers import Displacements, Scalars
from symscrew.errors import DescriptionError

COMPLEX = Scalars(cmath.cos, cmath.sin, complex)
DEGREE = 24
"""Of polynomials for cosines of up to half a turn: right to rounding."""
MOST_RADIANS = 100.0
"""Of all held angles together, on one way: polynomials for them have as high a degree."""


class Family(Protocol):
    """`own`: the mechanism as a member at its reference; `whole`: whether all numbers are free."""

    @property
    def equations(self) -> BatchEquations:
        """Those of the structure."""

    @property
    def whole(self) -> bool:
        """Whether all numbers are free."""

    @property
    def key(self) -> str:
        """The same of two families that are one."""

    @property
    def own(self) -> Sequence[Any]:
        """The mechanism as a member, with what is held as in the reference."""

    def random(self, random: np.random.Generator) -> Sequence[Any]:
        """A complex member."""

    def way(self, start: Sequence[Any], end: Sequence[Any]) -> Way:
        """From a member to another."""

    def member(self, values: dict[int, float]) -> Sequence[Any]:
        """The mechanism with these displacements of what is held."""


@dataclass(frozen=True)
class AllNumbers:
    """The mechanisms of one structure."""

    equations: BatchEquations
    whole: bool = True

    @property
    def key(self) -> str:
        """That of the structure."""
        return self.equations.structure.key

    @cached_property
    def own(self) -> Sequence[Any]:
        """The numbers in the reference."""
        return self.member({})

    def member(self, values: dict[int, float]) -> Sequence[Any]:
        """The numbers in the slots."""
        return Displacements(self.equations.structure, COMPLEX, values).slots()

    def random(self, random: np.random.Generator) -> Sequence[Any]:
        """Complex numbers in all slots; a planar mechanism stays planar, an axis of two bodies as long in both."""
        structure = self.equations.structure
        hinges = {k for g in structure.groups if g.kind == "turn" for k in g.slots[:1]} if structure.planar else set()
        slots: list[Any] = []
        for k, slot in enumerate(structure.slots):
            numbers = random.normal(size=3) + 1j * random.normal(size=3)
            if slot.kind in ("number", "distance"):
                slots.append(2 * numbers[0])
            elif slot.kind in ("turned", "slid"):
                slots.append(numbers * np.array([1, 1, 0]))
            elif k in hinges:
                slots.append(np.array([0, 0, 1], dtype=complex))
            else:
                slots.append(numbers * np.array([1, 1, 0 if structure.planar else 1]))
        return equally_long(slots, axis_pairs(structure))

    def way(self, start: Sequence[Any], end: Sequence[Any]) -> Way:
        """Straight, but for axes that two bodies share."""
        pairs = axis_pairs(self.equations.structure)
        if pairs:
            return Way(self.equations, straight_in_spinors(start, end, pairs), SPINOR_DEGREE)
        return Way(self.equations, straight(start, end), 3 if self.equations.structure.crossings else 2)


@dataclass(frozen=True)
class WhatIsHeld:
    """One mechanism with complex values of what is held, displacements in the order of `columns`.

    `followers`: what couplings settle from these, on complex ways as well.
    """

    equations: BatchEquations
    columns: tuple[int, ...]
    followers: tuple[Follower, ...] = ()
    whole: bool = False

    @property
    def key(self) -> str:
        """Structure and numbers."""
        numbers = [np.asarray(s, dtype=complex).round(15).tolist() for s in self.slots(self.own)]
        coupled = [(f.column, {c: [float(p) for p in powers] for c, powers in f.terms.items()}) for f in self.followers]
        return repr((self.equations.structure.key, self.columns, numbers, *coupled))

    @cached_property
    def own(self) -> Sequence[Any]:
        """No displacements."""
        return [0j] * len(self.columns)

    def member(self, values: dict[int, float]) -> Sequence[Any]:
        """The displacements."""
        return [complex(values.get(c, 0.0)) for c in self.columns]

    def random(self, random: np.random.Generator) -> Sequence[Any]:
        """Complex displacements."""
        return list(random.normal(size=len(self.columns)) + 1j * random.normal(size=len(self.columns)))

    def way(self, start: Sequence[Any], end: Sequence[Any]) -> Way:
        """Straight in what is held."""

        def slots(s: complex) -> list[Any]:
            return self.slots([(1 - s) * a + s * b for a, b in zip(start, end, strict=True)])

        return Way(self.equations, slots, self._degree(self.span(start, end)))

    def span(self, start: Sequence[Any], end: Sequence[Any]) -> float:
        """How far all held angles turn together on a way [rad]."""
        graph = self.equations.structure.graph
        turning = [c for e in graph.edges if e.kind == "turn" for c in e.columns]
        turning += [link.column for link in graph.links if link.turning]
        ends = [self._whole(values) for values in (start, end)]
        return float(sum(abs(ends[1][c] - ends[0][c]) for c in turning if c in ends[0]))

    def _degree(self, span: float) -> int:
        """Of polynomials for products of the cosines of all held angles on a way.

        Squares of such products turn twice as fast as all angles together. Chebyshev's coefficients of a cosine of
        2 x over the way, x in the middle, are Bessel's J_n(x): below rounding from n = x + 9 x^(1/3) + 9 on.

        Raises:
            DescriptionError: so many turns that no polynomial of a sensible degree holds them.
        """
        if span > MOST_RADIANS:
            raise DescriptionError(
                f"what is held lies {span / (2 * np.pi):.3g} turns from the reference, over which no way is followed; "
                f"give angles that are less than {MOST_RADIANS / (2 * np.pi):.3g} turns away together"
            )
        return max(DEGREE, int(np.ceil(span + 9 * span ** (1 / 3) + 9)))

    def _whole(self, values: Sequence[Any]) -> dict[int, Any]:
        """Displacements of all that is held."""
        whole = dict(zip(self.columns, values, strict=True))
        for follower in self.followers:
            whole[follower.column] = follower.value(whole, COMPLEX.read)
        return whole

    def slots(self, values: Sequence[Any]) -> list[Any]:
        """The numbers in the slots for displacements in the order of `columns`."""
        return Displacements(self.equations.structure, COMPLEX, self._whole(values)).slots()
