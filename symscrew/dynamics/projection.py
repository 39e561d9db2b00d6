"""The equations of motion of the free rates: one dependent rate after another, with its inertia and its force.

The elimination of the closure gives each dependent rate by later ones, w_p = sum of c_j w_j, and likewise its
acceleration, a_p = sum of c_j a_j + b. Put into the virtual power of the inertia M and of the forces R, which the
accelerations without the free parts still lack, this hands them on to the rates j,

    R_j += M_jp b + c_j (R_p + M_pp b),      M_jk += c_j M_pk + M_jp c_k + c_j c_k M_pp,

until only free rates are left: N^T M N and N^T (R + M p) of `free_motion` with the zeros of every limb kept.
Two components of a velocity that are seen from turned axes are handed on together: a = c x + s y, b = c y - s x keep
M_aa + M_bb, and with t = c (M_aa - M_bb) - 2 s M_ab they add M_bb + c t, M_aa - c t and M_ab + s t. The first of the
two waits for the other one, and its force does where more comes to it between them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from symscrew.algebra import Affine, Column, Elimination, Node, Tape, named_entries

UNIT = 1e-9
"""What squares of a cosine and a sine may be off 1 at the samples, where rounding leaves 1e-15: two components beyond
it are no turn of two others, and are handed on one by one, which is right for any."""


@dataclass
class _Step:
    """A dependent rate: its row of the closure and factors on later rows, its c, its inertia with itself and others."""

    row: int
    column: Column
    factors: dict[int, Node]
    over: Node
    follows: Affine
    own: Node
    others: Affine = field(default_factory=dict)


class Projection:
    """The inertia of a system in its joint rates w, handed on from the dependent rates to the free ones."""

    def __init__(
        self,
        tape: Tape,
        elimination: Elimination,
        inertia: Sequence[Sequence[Node]],
        label: Callable[[Column], str] = str,
    ) -> None:
        """`label`: what the unknowns of the elimination are called."""
        self.tape, self.label = tape, label
        left: dict[Column, Affine] = {
            j: {k: entry for k, entry in enumerate(row) if entry is not tape.zero} for j, row in enumerate(inertia)
        }
        for row in elimination.upper.values():
            for column in row:
                left.setdefault(column, {})
        self.left = left
        self.rows = 1 + max((k for row, _, _, factors in elimination.steps for k in (row, *factors)), default=-1)
        self.steps = [self._step(step, elimination.upper) for step in elimination.steps]
        partner = self._partners()
        waiting: set[Column] = set()
        self.waits: dict[int, tuple[int, bool]] = {}  # by the first of two steps: the second, and whether they turn
        places = {step.column: k for k, step in enumerate(self.steps)}
        for k, step in enumerate(self.steps):
            other = partner.get(step.column)
            if other is None:
                self._hand_on(step)
            elif other.column in waiting:
                self.waits[places[other.column]] = k, self._turn(other, step)
            else:
                waiting.add(step.column)

    def _step(self, solved: tuple[int, Column, Node, dict[int, Node]], upper: Mapping[int, Affine]) -> _Step:
        row, column, pivot, factors = solved
        over = 1 / pivot
        follows = {c: -(entry * over) for c, entry in upper[row].items() if c != column}
        named_entries(follows.values(), "follows", [f"{self.label(column)}|{self.label(c)}" for c in follows])
        return _Step(row, column, factors, over, follows, self.tape.zero)

    def _partners(self) -> dict[Column, _Step]:
        """Steps of components that are turned together: a = c x + s y and b = +-(c y - s x), with c c + s s = 1."""
        found: dict[Column, _Step] = {}
        seen = [step for step in self.steps if len(step.follows) == 2 and not isinstance(step.column, int)]
        for n, a in enumerate(seen):
            x, y = a.follows
            for b in seen[:n]:
                if {a.column, b.column} & set(found) or set(b.follows) != {x, y}:
                    continue
                c, s = a.follows[x], a.follows[y]
                if any(b.follows[x] is -sign * s and b.follows[y] is sign * c for sign in (1, -1)) and self._unit(c, s):
                    found[a.column], found[b.column] = b, a
        return found

    def _unit(self, c: Node, s: Node) -> bool:
        return bool(np.abs(self.tape.sample(c * c + s * s) - 1.0).max() < UNIT)

    def _turn(self, a: _Step, b: _Step) -> bool:
        """Two components handed on together; one by one, and False, where they are coupled with what they follow."""
        x, y = a.follows
        if {x, y} & {*self.left[a.column], *self.left[b.column]}:
            self._hand_on(a)
            self._hand_on(b)
            return False
        c, s = a.follows[x], a.follows[y]
        sign = 1 if b.follows[y] is c else -1
        of_a, of_b = self.left.pop(a.column), self.left.pop(b.column)
        zero = self.tape.zero
        for step, others in ((a, of_a), (b, of_b)):
            step.own = others.get(step.column, zero)
            step.others = {k: entry for k, entry in others.items() if k != step.column}
        first, both, second = of_a.pop(a.column, zero), sign * of_a.pop(b.column, zero), of_b.pop(b.column, zero)
        of_b.pop(a.column, None)
        for other in {*of_a, *of_b}:
            self.left[other].pop(a.column, None)
            self.left[other].pop(b.column, None)
        part = c * (first - second) - (2 * s) * both
        along, across = c * part, s * part
        self._add(x, x, second + along)
        self._add(y, y, first - along)
        self._add(x, y, both + across)
        for other in [*of_a, *(k for k in of_b if k not in of_a)]:
            m, n = of_a.get(other, zero), sign * of_b.get(other, zero)
            self._add(x, other, c * m - s * n)
            self._add(y, other, s * m + c * n)
        return True

    def _hand_on(self, step: _Step) -> None:
        others, follows = self.left.pop(step.column), step.follows
        step.own = others.pop(step.column, self.tape.zero)
        step.others = others
        named_entries(others.values(), "handed_inertia", [f"{self.label(step.column)}|{self.label(c)}" for c in others])
        named_entries([step.own], "handed_inertia", [self.label(step.column)])
        for other in others:
            self.left[other].pop(step.column)
        carried = {j: c * step.own for j, c in follows.items()}
        for j, entry in others.items():
            carried[j] = carried[j] + entry if j in carried else entry
        touched = list(carried)
        for n, j in enumerate(touched):
            for k in touched[: n + 1]:
                self._add(j, k, self._product(follows, j, carried, k) + self._product(others, j, follows, k))

    def _add(self, j: Column, k: Column, entry: Node) -> None:
        if entry is not self.tape.zero:
            total = self.left[j][k] + entry if k in self.left[j] else entry
            self.left[j][k] = self.left[k][j] = total

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
        for places in self._order(shifts):
            for k in places:
                for j, entry in self.steps[k].others.items():
                    values[j] = values[j] + entry * shifts[k]
            for k in places:
                step = self.steps[k]
                here = values[step.column] + step.own * shifts[k]
                named_entries([here], "handed_force", [self.label(step.column)])
                for j, c in step.follows.items():
                    values[j] = values[j] + c * here
        return [values[k] for k in free]

    def _order(self, shifts: Sequence[Node]) -> list[tuple[int, ...]]:
        """Places of the steps as their forces are handed on: a step waits for its partner only where that matters."""
        moved = [k for k, shift in enumerate(shifts) if shift is not self.tape.zero]
        late: dict[int, list[tuple[int, ...]]] = {}
        for first, (second, turned) in self.waits.items():
            column = self.steps[first].column
            if any(k in (first, second) or column in self.steps[k].others for k in moved if first <= k <= second):
                late[first], late[second] = [], [(first, second)] if turned else [(first,), (second,)]
        return [places for k in range(len(self.steps)) for places in late.get(k, [(k,)])]

    def shifts(self, opening: Sequence[Node]) -> list[Node]:
        """b of every step: what the dependent accelerations are beside those that they follow."""
        values = [-value for value in opening]
        values += [self.tape.zero] * (self.rows - len(values))
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
