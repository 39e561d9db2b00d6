"""Zeros that intervals cannot prove: of overconstrained mechanisms, and such at which several meet, by exact numbers.

    zero in doubles --Newton's method in 60 digits--> coordinates --integer relations--> numbers of the field
    these numbers --every row of F, exactly--> 0: it is a zero, whatever led there
                  --rank of dF, exactly--> regular;  singular --meeting_zeros--> how many zeros meet there

A zero that no other one of the structure is like has its coordinates in the field of the mechanism's numbers itself,
two that are mirror images in one with a square root more.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import FineTest
from symscrew.assembly.exact_slots import ExactEquations, Series, exact_equations
from symscrew.assembly.meeting_zeros import meeting_zeros
from symscrew.assembly.rectangles import fine_middle, read
from symscrew.assembly.what_is_held import Held
from symscrew.mobility import Exact, NotAlgebraicError, NotDecidableError, exact_value, generator_itself

Array = np.ndarray[Any, Any]

CLOSE = 1e-5
"""Distance of the zero in 60 digits from that in doubles: where two zeros meet, doubles know half the digits."""
STEPS = 12
"""Of Newton's method: from five digits to 60, also where the derivative is known to half of them."""
STILL = CONTEXT.mpf(10) ** -50
"""A step after which all digits are there; residuals have 58."""
DIGITS = 46
"""Of all integers of a relation together: fewer than the 50 that are known, else there is one by accident."""
STEPS_OF_RELATIONS = 3_000
"""Of the search for integers, a fraction of a second: relations of 46 digits take some hundred."""
MOST_TERMS = 8
"""Numbers of one relation, 1 and the coordinate among them: beyond it 50 digits do not tell."""


@dataclass(frozen=True)
class ExactRoot:
    """A zero in exact numbers, the first coordinate of each group that is not 0 made 1.

    `z`: as doubles, in the coordinates of the search. `meeting`: how many zeros it is, at least. `isolated`: whether it
    is so many, and no other solutions are beside it; else that was not found out.
    """

    coordinates: tuple[Exact, ...]
    z: Array
    meeting: int
    isolated: bool


class ExactRoots:
    """Zeros of one mechanism in exact numbers. `why`: what its numbers are in no field for, or ""."""

    def __init__(self, held: Held, equations: BatchEquations) -> None:
        """`equations`: those of the search, in which zeros come."""
        self.held, self.search, self.why = held, equations, ""
        self.exact: ExactEquations | None = None
        try:
            self.exact = exact_equations(held)
        except (NotDecidableError, NotAlgebraicError, ArithmeticError, ValueError) as error:
            self.why = str(error)
        if self.exact is not None and self.exact.equations.structure.key != equations.structure.key:
            self.exact, self.why = None, "its structure is another one in exact numbers"

    def root(self, z: Array, coefficients: Array) -> ExactRoot | None:
        """The exact zero near z, None where none was found. `coefficients`: of the search's equations, in doubles."""
        if self.exact is None:
            return None
        motions = self._motions(coefficients)
        try:
            found = _Recognised(self.exact, self._carried(z, motions, back=False)).root()
        except (ZeroDivisionError, NotDecidableError, ValueError, np.linalg.LinAlgError):
            return None
        if found is None:
            return None
        fine = np.array([complex(exact_value(c)) for c in found.coordinates])
        return replace(found, z=self._carried(fine, motions, back=True))

    def _motions(self, coefficients: Array) -> tuple[list[Array], list[Array]]:
        """Of the groups of the search, and of the exact structure in its frame."""
        assert self.exact is not None
        frames = [
            np.array([[float(c) for c in row] for row in e.structure.frame])
            for e in (self.search, self.exact.equations)
        ]
        whole = np.eye(8)
        whole[1:4, 1:4] = whole[5:8, 5:8] = frames[0] @ frames[1].T
        shapes = self.search.shapes[0]
        ends = np.cumsum([0, *(a * b for a, b in shapes)])
        own = [coefficients[a:b].reshape(shape) for a, b, shape in zip(ends, ends[1:], shapes, strict=False)]
        return own, [whole @ np.array([[float(c) for c in row] for row in m]) for m in self.exact.motions]

    def _carried(self, z: Array, motions: tuple[list[Array], list[Array]], *, back: bool) -> Array:
        """The same displacements in the coordinates of the other structure, whose axes have other lengths."""
        result = np.zeros(len(z), dtype=complex)
        for part, *pair in zip(self.search.parts, *motions, strict=True):
            here, there = pair[::-1] if back else pair
            result[part], *_ = np.linalg.lstsq(there.astype(complex), here @ z[part], rcond=None)
        return result


class _Recognised:
    def __init__(self, exact: ExactEquations, z: Array) -> None:
        self.exact = exact
        slots = [
            read(exact_value(s.exact)) if np.ndim(s) == 0 else [read(exact_value(c.exact)) for c in s]
            for s in exact.slots
        ]
        self.test = FineTest(exact.equations, slots, z)

    def root(self) -> ExactRoot | None:
        """With every row looked at in exact numbers."""
        if not self.test.real:
            return None
        still = self._at_reference()
        found = None if still is None else self._judged(still)
        if found is None:
            fine = self._refined()
            known = None if fine is None else self._in_field(fine)
            found = None if known is None else self._judged(known)
        return found

    # -- 60 digits ------------------------------------------------------------------------------------------

    def _at_reference(self) -> list[Exact] | None:
        """No displacements, if the zero is there."""
        middle = np.array([complex(c) for c in fine_middle(self.test.at_middle)])
        starts = [part.start for part in self.exact.equations.parts]
        still = np.zeros(len(middle))
        still[starts] = 1.0
        return [Fraction(int(c)) for c in still] if np.abs(middle - still).max() < CLOSE else None

    def _refined(self) -> list[Any] | None:
        """The zero in 60 digits; of a singular one the point where mu' is zero, at which it is a zero or is none."""
        z = [CONTEXT.mpf(c.real) for c in fine_middle(self.test.at_middle)]
        slopes = np.array([[complex(c).real for c in row] for row in self.test.slopes_at(z)])
        left, values, right = np.linalg.svd(slopes)
        small = CLOSE * self.test.size
        singular = len(values) < slopes.shape[1] or values[-1] < small
        if not singular:
            return self._regular(z)
        if slopes.shape[0] != slopes.shape[1] or (len(values) > 1 and values[-2] < small):
            return None
        return self._double(z, left[:, -1], right[-1])

    def _regular(self, z: list[Any]) -> list[Any] | None:
        """Newton's method, for more rows than coordinates by least squares."""
        for _ in range(STEPS):
            step = CONTEXT.lu_solve(CONTEXT.matrix(self._slopes(z)), CONTEXT.matrix(self._values(z)))
            for k, place in enumerate(self.test.open):
                z[place] -= step[k]
            if max(abs(c) for c in step) < STILL:
                return z
        return None

    def _double(self, z: list[Any], left: Array, right: Array) -> list[Any] | None:
        """F + mu u = 0, mu' = 0 along the null vector: by Newton's method, the second with slopes by differences."""
        begin, t, before = [z[p] for p in self.test.open], CONTEXT.mpf(0), None
        for _ in range(2 * STEPS):
            z, slope = self._bordered(z, (left, right), begin, t)
            if before is None:
                before, t = (t, slope), t + CONTEXT.mpf(CLOSE)
                continue
            change = slope - before[1]
            if not change:
                return z
            step = -slope * (t - before[0]) / change
            before, t = (t, slope), t + step
            if abs(step) < STILL:
                return self._bordered(z, (left, right), begin, t)[0]
            if abs(t) > CLOSE * 100:
                return None
        return None

    def _bordered(
        self, z: Sequence[Any], borders: tuple[Array, Array], begin: Sequence[Any], t: Any
    ) -> tuple[list[Any], Any]:
        """(the point with c (z - begin) = t and F + mu u = 0, how fast mu changes with t there)."""
        z, mu, size = list(z), CONTEXT.mpf(0), len(self.test.open)
        for _ in range(STEPS):
            value, matrix = self._values(z), self._matrix(z, borders)
            off = [*(v + mu * CONTEXT.mpf(u) for v, u in zip(value, borders[0], strict=True)),
                   sum((CONTEXT.mpf(c) * (z[p] - b) for c, p, b in zip(borders[1], self.test.open, begin, strict=True)),
                       CONTEXT.mpf(0)) - t]  # fmt: skip
            step = CONTEXT.lu_solve(matrix, CONTEXT.matrix([-c for c in off]))
            for k, place in enumerate(self.test.open):
                z[place] += step[k]
            mu += step[size]
            if max(abs(c) for c in step) < STILL:
                break
        along = CONTEXT.lu_solve(self._matrix(z, borders), CONTEXT.matrix([0] * size + [1]))
        return z, along[size]

    def _matrix(self, z: Sequence[Any], borders: tuple[Array, Array]) -> Any:
        size = len(self.test.open)
        matrix = CONTEXT.matrix(size + 1, size + 1)
        for i, row in enumerate(self._slopes(z)):
            for j, c in enumerate(row):
                matrix[i, j] = c
            matrix[i, size], matrix[size, i] = CONTEXT.mpf(borders[0][i]), CONTEXT.mpf(borders[1][i])
        return matrix

    def _values(self, z: Sequence[Any]) -> list[Any]:
        return [c.real for c in self.test.values_at([CONTEXT.mpc(c) for c in z])]

    def _slopes(self, z: Sequence[Any]) -> list[list[Any]]:
        return [[c.real for c in row] for row in self.test.slopes_at([CONTEXT.mpc(c) for c in z])]

    # -- exact numbers --------------------------------------------------------------------------------------

    def _in_field(self, z: Sequence[Any]) -> list[Exact] | None:
        """The coordinates as numbers of the field, with one square root more where one is needed."""
        found: list[Exact] = []
        for c in z:
            exact = self._number(c)
            if exact is None and self._adjoin(c):
                exact = self._number(c)
            if exact is None:
                return None
            found.append(exact)
        return found

    def _basis(self) -> list[Exact]:
        """Products of the generators' powers."""
        powers = [[_power(g, k) for k in range(g.degree)] for g in self.exact.field.generators]
        result: list[Exact] = []
        for chosen in product(*powers):
            term: Exact = Fraction(1)
            for factor in chosen:
                term = term * factor
            result.append(term)
        return result

    def _number(self, c: Any) -> Exact | None:
        """c as a combination of products of the generators with fractions."""
        if abs(c) < STILL:
            return Fraction(0)
        basis = [Fraction(1)] if not self.exact.field.generators else self._basis()
        for terms in ([Fraction(1)], basis):
            if len(terms) < MOST_TERMS:
                whole = _relation([c, *(exact_value(b) for b in terms)])
                if whole is not None and whole[0]:
                    parts = (b * Fraction(-n, whole[0]) for b, n in zip(terms, whole[1:], strict=True) if n)
                    return sum(parts, Fraction(0))
        return None

    def _adjoin(self, c: Any) -> bool:
        """A square root to the field with which c may be in it: of its square, or of a quadratic equation's."""
        square = self._number(c * c)
        if square is not None:
            self.exact.field.sqrt(square)
            return True
        whole = _relation([c * c, c, CONTEXT.mpf(1)])
        if whole is None or not whole[0]:
            return False
        two, one, none = whole
        self.exact.field.sqrt(Fraction(one * one - 4 * two * none))
        return True

    def _judged(self, coordinates: list[Exact]) -> ExactRoot | None:
        """What every row says of these numbers."""
        still: list[Series] = [{(): c} if c else {} for c in coordinates]
        if any(self.exact.values(still, 0)):
            return None
        meeting, isolated = meeting_zeros(self.exact, coordinates, self.test.open)
        return self._made(coordinates, meeting, isolated)

    def _made(self, coordinates: Sequence[Exact], meeting: int, isolated: bool) -> ExactRoot:
        """With the first coordinate of each group that is not 0 made 1, so that equal zeros have equal coordinates."""
        found: list[Exact] = []
        for part in self.exact.equations.parts:
            first = next(c for c in coordinates[part] if c)
            found += [c / first for c in coordinates[part]]
        return ExactRoot(tuple(found), np.zeros(0), meeting, isolated)


def _power(generator: Any, k: int) -> Exact:
    result: Exact = Fraction(1)
    for _ in range(k):
        result = result * generator_itself(generator)
    return result


def _relation(values: Sequence[Any]) -> list[int] | None:
    """Integers, not all zero, with which the sum is zero to 50 digits."""
    longest = 10 ** (DIGITS // len(values))
    found = CONTEXT.pslq(list(values), tol=STILL, maxcoeff=longest, maxsteps=STEPS_OF_RELATIONS)
    return None if found is None else [int(n) for n in found]
