"""Two zeros that almost meet, told apart: one singular end in doubles, two zeros or none in 60 digits.

    singular end --F(z) + mu u = 0, c (z - middle) = t--> mu(t), a parabola nearly --> its two zeros
    --Newton's method in 60 digits--> zeros --Krawczyk's test, boxes as small as their distance asks--> certificates

u and c are the null vectors of dF at the end, so that the bordered equations are regular there (Lyapunov, Schmidt).
Zeros of mu are real, or complex and then no modes. Numbers of the description have 60 digits: zeros nearer than `MEET`
are not told from one that is exactly double, which intervals cannot prove.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import Certificate, FineTest
from symscrew.assembly.rectangles import fine_middle
from symscrew.assembly.target_roots import Account, End

Array = np.ndarray[Any, Any]

MEET = 1e-20
"""Half the distance below which two zeros are not told apart: a squared root of 60 digits, and some for rounding."""
FIRST = 1e-3
"""Way to both sides in which the first parabola is laid; later ones are as wide as the zeros are apart."""
ROUNDS = 4
"""Parabolas laid, each as wide as the one before found the zeros apart; certificates judge what comes of the last."""
NEWTON = 8
"""Most steps: the digits double with each, from three to 60."""
NEAR = 1e-2
"""Farthest zero from the end: parabolas that open slower are no two zeros that meet."""
SHARES = (1e-1, 1e-2, 1e-3, 1e-4)
"""Radii of boxes over half the distance."""


def split_ends(equations: BatchEquations, slots: Sequence[Any], account: Account) -> Account:
    """The account with two regular ends in place of each singular one at which two zeros can be told apart."""
    ends = list[End]()
    for end in account.ends:
        alone = end.regular or end.curve or end.paths != 2 or end.kind not in ("real", "complex")
        found = None if alone else told_apart(equations, slots, end.z.real if end.kind == "real" else end.z)
        ends += [end] if found is None else [End(proof.z, proof.kind, proof=proof) for proof in found]
    return replace(account, ends=tuple(ends))


def told_apart(equations: BatchEquations, slots: Sequence[Any], z: Array) -> tuple[Certificate, Certificate] | None:
    """Certificates of the two zeros near a singular end, None where there are not two that can be told apart."""
    test = FineTest(equations, slots, z)
    if not test.square or not test.open:
        return None
    try:
        return _Split(test).certificates()
    except (ZeroDivisionError, ValueError, np.linalg.LinAlgError):  # a bordered matrix that is singular too
        return None


class _Split:
    def __init__(self, test: FineTest) -> None:
        self.test = test
        self.middle = [CONTEXT.mpc(c) for c in fine_middle(test.at_middle)]
        slopes = np.array([[complex(c) for c in row] for row in test.slopes_at(self.middle)])
        left, values, right = np.linalg.svd(slopes)
        if len(values) > 1 and values[-2] < np.sqrt(MEET) * values[0]:
            raise ValueError("more than two zeros meet")
        self.left, self.right = left[:, -1], right[-1].conj()
        if test.real:
            self.left, self.right = left[:, -1].real, right[-1].real

    def certificates(self) -> tuple[Certificate, Certificate] | None:
        """Of both, or None."""
        centre, width = CONTEXT.mpc(0), CONTEXT.mpf(FIRST)
        for _ in range(ROUNDS):
            below, at, above = (self._along(centre + k * width)[1] for k in (-1, 0, 1))
            two, one = (above - 2 * at + below) / (2 * width**2), (above - below) / (2 * width)
            vertex = -one / (2 * two)
            square = vertex**2 - at / two
            if self.test.real:
                vertex, square = CONTEXT.mpc(vertex.real), CONTEXT.mpc(square.real)
            half = CONTEXT.sqrt(square)
            if abs(centre + vertex) + abs(half) > NEAR:
                return None
            centre, width = centre + vertex, max(abs(half), CONTEXT.mpf(MEET))
        if abs(half) < MEET:
            return None
        found = [self._certificate(centre + sign * half, float(abs(half))) for sign in (1, -1)]
        one_, two_ = found
        if one_ is None or two_ is None or one_[0].kind == "" or one_[0].kind != two_[0].kind:
            return None
        apart = max(abs(a - b) for a, b in zip(one_[1], two_[1], strict=True))
        if not apart > one_[0].radius + two_[0].radius:
            return None
        return replace(one_[0], beside=two_[0].z), replace(two_[0], beside=one_[0].z)

    def _along(self, t: Any) -> tuple[list[Any], Any]:
        """(the point of the bordered equations at t, mu there)."""
        size = len(self.test.open)
        z, mu = list(self.middle), CONTEXT.mpc(0)
        for k, place in enumerate(self.test.open):
            z[place] += t * complex(self.right[k])
        start = [z[place] for place in self.test.open]
        for _ in range(NEWTON):
            value, slopes = self.test.values_at(z), self.test.slopes_at(z)
            matrix, right = CONTEXT.matrix(size + 1, size + 1), CONTEXT.matrix(size + 1, 1)
            for i in range(size):
                for j in range(size):
                    matrix[i, j] = slopes[i][j]
                matrix[i, size] = complex(self.left[i])
                matrix[size, i] = complex(self.right[i].conjugate())
                right[i] = -value[i] - mu * complex(self.left[i])
            right[size] = -sum(
                complex(self.right[k].conjugate()) * (z[p] - start[k]) for k, p in enumerate(self.test.open)
            )
            step = CONTEXT.lu_solve(matrix, right)
            for k, place in enumerate(self.test.open):
                z[place] += step[k]
            mu += step[size]
            if max(abs(c) for c in step) < MEET**2.5:
                break
        return z, mu

    def _certificate(self, t: Any, half: float) -> tuple[Certificate, list[Any]] | None:
        """Of the zero near t, with its coordinates."""
        z, size = self._along(t)[0], len(self.test.open)
        for _ in range(NEWTON):
            slopes, value = CONTEXT.matrix(self.test.slopes_at(z)), CONTEXT.matrix(self.test.values_at(z))
            step = CONTEXT.lu_solve(slopes, value)
            for k, place in enumerate(self.test.open):
                z[place] -= step[k]
            if max(abs(c) for c in step) < half * MEET:
                break
        if self.test.real and CONTEXT.mpc(t).imag == 0:
            z = [CONTEXT.mpc(c.real) for c in z]
        inverse = CONTEXT.inverse(CONTEXT.matrix(self.test.slopes_at(z)))
        y = [[inverse[i, j] for j in range(size)] for i in range(size)]
        radius = self.test.held(z, y, [share * half for share in SHARES])
        if radius is None:
            return None
        kind = "real" if not any(c.imag for c in z) else "complex" if max(abs(c.imag) for c in z) > 2 * radius else ""
        return Certificate(radius, np.array([complex(c) for c in z]), kind), z
