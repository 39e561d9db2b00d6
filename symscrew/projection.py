"""The equations of motion of the free rates: one dependent rate after another, with its inertia and its force.

The elimination of the closure gives each dependent rate by later ones, w_p = sum of c_j w_j, and likewise its
acceleration, a_p = sum of c_j a_j + b. Put into the virtual power of the inertia M and of the forces R, which the
accelerations without the free parts still lack, this hands them on to the rates j,

    R_j += M_jp b + c_j (R_p + M_pp b),      M_jk += c_j M_pk + M_jp c_k + c_j c_k M_pp,

until only free rates are left: N^T M N and N^T (R + M p) of `symscrew.admissible` with the zeros of every limb kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.elimination import Affine, Column, Elimination
from symscrew.tape import Node, Tape


@dataclass(frozen=True)
class _Step:
    """A dependent rate: its row of the closure and factors on later rows, its c, its inertia with itself and others."""

    row: int
    column: Column
    factors: dict[int, Node]
    over: Node
    follows: Affine
    own: Node
    others: Affine


class Projection:
    """The inertia of a system in its joint rates w, handed on from the dependent rates to the free ones."""

    def __init__(self, tape: Tape, elimination: Elimination, inertia: Sequence[Sequence[Node]]) -> None:
        self.tape = tape
        left: dict[Column, Affine] = {
            j: {k: entry for k, entry in enumerate(row) if entry is not tape.zero} for j, row in enumerate(inertia)
        }
        for row in elimination.upper.values():
            for column in row:
                left.setdefault(column, {})
        self.steps = [self._step(left, elimination, *step) for step in elimination.steps]
        self.left = left

    def _step(
        self,
        left: dict[Column, Affine],
        elimination: Elimination,
        row: int,
        column: Column,
        pivot: Node,
        factors: dict[int, Node],
    ) -> _Step:
        over = 1 / pivot
        follows = {c: -(entry * over) for c, entry in elimination.upper[row].items() if c != column}
        others = left.pop(column)
        own = others.pop(column, self.tape.zero)
        for other in others:
            left[other].pop(column)
        carried = {j: c * own for j, c in follows.items()}
        for j, entry in others.items():
            carried[j] = carried[j] + entry if j in carried else entry
        touched = list(carried)
        for n, j in enumerate(touched):
            for k in touched[: n + 1]:
                total = self._product(follows, j, carried, k) + self._product(others, j, follows, k)
                if total is not self.tape.zero:
                    left[j][k] = left[k][j] = left[j][k] + total if k in left[j] else total
        return _Step(row, column, factors, over, follows, own, others)

    def _product(self, x: Affine, j: Column, y: Affine, k: Column) -> Node:
        return x[j] * y[k] if j in x and k in y else self.tape.zero

    def inertia(self, free: Sequence[Column]) -> list[list[Node]]:
        """N^T M N for the free rates in this order."""
        return [[self.left[j].get(k, self.tape.zero) for k in free] for j in free]

    def forces(self, missing: Sequence[Node], opening: Sequence[Node], free: Sequence[Column]) -> list[Node]:
        """N^T (R + M p): `missing` is R per joint rate, `opening` the closure's own acceleration per row."""
        shifts = self.shifts(opening)
        values: dict[Column, Node] = dict(enumerate(missing))
        values |= {step.column: values.get(step.column, self.tape.zero) for step in self.steps}
        for step, shift in zip(self.steps, shifts, strict=True):
            for j, entry in step.others.items():
                values[j] = values[j] + entry * shift
            here = values[step.column] + step.own * shift
            for j, c in step.follows.items():
                values[j] = values[j] + c * here
        return [values[k] for k in free]

    def shifts(self, opening: Sequence[Node]) -> list[Node]:
        """b of every step: what the dependent accelerations are beside those that they follow."""
        values = [-value for value in opening]
        values += [self.tape.zero] * (len(self.steps) - len(values))
        result = []
        for step in self.steps:
            for other, factor in step.factors.items():
                values[other] = values[other] - factor * values[step.row]
            result.append(values[step.row] * step.over)
        return result

    def accelerations(self, free: dict[Column, Node], opening: Sequence[Node]) -> list[Node]:
        """All joint accelerations from the free ones."""
        found = dict(free)
        for step, shift in zip(self.steps[::-1], self.shifts(opening)[::-1], strict=True):
            total = shift
            for j, c in step.follows.items():
                total = total + c * found[j]
            found[step.column] = total
        return [found[k] for k in range(sum(isinstance(k, int) for k in found))]
