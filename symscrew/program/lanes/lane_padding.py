"""Lanes made alike: where a limb lies along an axis, its program lacks products with one and sums with zero.

A row of corresponding instructions with no member in one lane gets one there if what reads the row reads something
else in that lane: `x` where the others have a product is `1 * x`, where they have a sum it is `x + 0`, and a zero is
`0 * y`. Products of one slot with constants that lanes share are done in each of them, as one product with a vector
of constants. Values stay what they are, but for signs of zeros. Where it is not in a pack, such a member is a copy.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from symscrew.program.lanes.signed_operations import Operand, Operation, Row

NEUTRAL = {"mul": 1.0, "add": 0.0}  # the operand with which an operation is a copy
# How well operands of two lanes fit each other, best first: in one row, the same slot, both constants, one slot times
# constants, may have its place in the row, both from outside. Only their order counts, and their sum over operands.
ROW, SAME, CONSTANTS, SCALED, LIKELY, INPUTS = 6, 5, 4, 3, 2, 1

Args = tuple[Operand, ...]
Place = tuple[int, int]  # row and lane


@dataclass(frozen=True)
class Padded:
    """Rows with members put in; `operations` has them too, `copies` says of which slot or number each is a copy."""

    operations: Mapping[int, Operation]
    rows: tuple[Row, ...]
    copies: Mapping[int, int | float]


def padded(operations: Mapping[int, Operation], rows: Sequence[Row], free: int) -> Padded:
    """The rows with members where some are missing between others that are there; their slots are `free` and on."""
    padding = _Padding(operations, rows, free)
    padding.run()
    padding.scale()
    return Padded(padding.operations, tuple(tuple(row) for row in padding.rows), padding.copies)


class _Padding:
    """Rows on their way: the operands of each member are held against those of another one, readers first."""

    def __init__(self, operations: Mapping[int, Operation], rows: Sequence[Row], free: int) -> None:
        self.operations = dict(operations)
        self.rows = [list(row) for row in rows]
        self.place: dict[int, Place] = {
            s: (i, k) for i, row in enumerate(rows) for k, s in enumerate(row) if s is not None
        }
        self.copies: dict[int, int | float] = {}
        self.free = free
        size = [len(row) - row.count(None) for row in rows]
        joined = {a: size[i] for a, (i, _) in self.place.items()}
        self.model = [self._most_joined(row, joined) for row in rows]  # the member of each row that the others follow
        order = sorted(range(len(rows)), key=lambda i: -self.model[i])
        self.open = [self.place[s] for i in order for s in rows[i] if s is not None and s != self.model[i]]

    def _most_joined(self, row: Row, joined: Mapping[int, int]) -> int:
        """The member whose operands are in the largest rows; `joined` says how large the row of a slot is."""
        members = [slot for slot in row if slot is not None]
        args = [[a for a, _ in self.operations[slot].args if isinstance(a, int)] for slot in members]
        sizes = [sum([joined.get(a, 0) for a in own]) for own in args]
        return members[sizes.index(max(sizes))]

    def run(self) -> None:
        """Members with one best order of operands are settled first: what they settle may decide about others."""
        while self.open:
            waiting, self.open = self.open, []
            left = [at for at in waiting if not self._settled(at)]
            if len(left) == len(waiting):
                self._settled(left.pop(0), anyhow=True)
            self.open = left + self.open

    def _settled(self, at: Place, *, anyhow: bool = False) -> bool:
        """Put in what the operands of a member need, if it is clear which of them are which."""
        row, lane = at
        model = self.operations[self.model[row]].args
        ways = list(self._ways(at))
        fits = [self._fit(way, model, at) for way in ways]
        best = max(fits)
        found = [way for way, fit in zip(ways, fits, strict=True) if fit == best]
        if len(found) > 1 and not anyhow:
            found = list({repr(way): way for way in found}.values())  # slot 0 is not 0.0
            if len(found) > 1 and any(self._opens(way, model, at) for way in found):
                return False
        member = self.rows[row][lane]
        assert member is not None
        op = self.operations[member].op
        args = tuple(self._joined(a, b, at) for a, b in zip(found[0], model, strict=True))
        self.operations[member] = Operation(op, args)
        return True

    def _ways(self, at: Place) -> Iterator[Args]:
        """The orders of a member's operands; of one that was put in, also which of them it is a copy of."""
        row, lane = at
        member = self.rows[row][lane]
        assert member is not None
        operation = self.operations[member]
        if member not in self.copies:
            yield operation.args
            if operation.op in NEUTRAL:
                yield operation.args[::-1]
            return
        copied = self.copies[member]
        pair = ((copied, 1), (NEUTRAL[operation.op], 1))
        if operation.op == "mul" and copied == 0.0 and isinstance(copied, float):
            for k, (other, _) in enumerate(self.operations[self.model[row]].args):
                found = self._counterpart(other, lane)
                if found is not None:
                    zero = ((0.0, 1), (found, 1))
                    yield zero if k else zero[::-1]
        yield pair
        yield pair[::-1]

    def _counterpart(self, slot: int | float, lane: int) -> int | None:
        """What a slot of one lane is in another one."""
        if not isinstance(slot, int):
            return None
        at = self.place.get(slot)
        return self.rows[at[0]][lane] if at else slot

    def _fit(self, args: Args, model: Args, at: Place) -> int:
        return sum([self._fits(a, b, at) for (a, _), (b, _) in zip(args, model, strict=True)])

    def _opens(self, args: Args, model: Args, at: Place) -> bool:
        return any(self._fits(a, b, at) == LIKELY for (a, _), (b, _) in zip(args, model, strict=True))

    def _fits(self, a: int | float, b: int | float, at: Place) -> int:
        if isinstance(a, float) and isinstance(b, float):
            return CONSTANTS
        if not isinstance(b, int):
            return 0
        there = self.place.get(b)
        if there is None:
            if a == b and isinstance(a, int):
                return SAME
            if not isinstance(a, int) or a in self.place:
                return 0
            return SCALED if self._scaled(a)[1] == self._scaled(b)[1] else INPUTS
        member = self.rows[there[0]][at[1]]
        if member is not None:
            return ROW if member == a or self._copies(member, a) else 0
        return LIKELY if self._joinable(a, there, at[1]) else 0

    def _copies(self, member: int, a: int | float) -> bool:
        """Is it a copy of this slot or number? Slot 0 is not 0.0."""
        return member in self.copies and repr(self.copies[member]) == repr(a)

    def _joinable(self, a: int | float, there: Place, lane: int) -> bool:
        """Can an operand have its place, or a copy its place, in this row?"""
        op = self.operations[self.model[there[0]]].op
        return self._single(a) == op or (op in NEUTRAL and (isinstance(a, int) or a == 0.0))

    def _single(self, a: int | float) -> str | None:
        """What an operand does that is an operation in no row."""
        return self.operations[a].op if isinstance(a, int) and a in self.operations and a not in self.place else None

    def _joined(self, operand: Operand, model: Operand, at: Place) -> Operand:
        """The operand, or a copy that has its place in the row of what another lane has here."""
        (a, sign), (b, _) = operand, model
        there = self.place.get(b) if isinstance(b, int) else None
        if there is None:
            return operand
        row, lane = there[0], at[1]
        member = self.rows[row][lane]
        if member is not None:
            return (member, sign) if self._copies(member, a) else operand
        if not self._joinable(a, there, lane):
            return operand
        op = self.operations[self.model[row]].op
        slot = a if isinstance(a, int) and self._single(a) == op else self._copy(a, Operation(op, ()))
        self.rows[row][lane] = slot
        self.place[slot] = (row, lane)
        self.open.append((row, lane))
        return slot, sign

    def _copy(self, copied: int | float, operation: Operation) -> int:
        slot, self.free = self.free, self.free + 1
        self.copies[slot], self.operations[slot] = copied, operation
        return slot

    # -- products that lanes share --------------------------------------------------------------------

    def scale(self) -> None:
        """Columns of products of one slot with constants become rows."""
        known: dict[str, int] = {}
        for row in list(self.rows):
            members = [(k, slot) for k, slot in enumerate(row) if slot is not None]
            for n in range(len(self.operations[members[0][1]].args)):
                column = {k: self.operations[slot].args[n][0] for k, slot in members}
                if self._worth_scaling(column):
                    self._scale(column, known)
                    for k, slot in members:
                        op, args = self.operations[slot].op, list(self.operations[slot].args)
                        found = self.rows[known[repr(column)]][k]
                        assert found is not None
                        args[n] = (found, args[n][1])
                        self.operations[slot] = Operation(op, tuple(args))

    def _worth_scaling(self, column: Mapping[int, int | float]) -> bool:
        found = {self._scaled(a) for a in column.values()}
        bases = {base for factor, base in found if factor != 0.0}
        return len(found) > 1 and len(bases) == 1 and None not in bases

    def _scaled(self, a: int | float) -> tuple[float, int | None]:
        """Factor and slot of which something is a product that is in no row; a number has no slot."""
        if not isinstance(a, int):
            return a, None
        if self._single(a) == "mul":
            (one, sign), (other, another) = self.operations[a].args
            if isinstance(one, float) and isinstance(other, int):
                return sign * another * one, other
            if isinstance(other, float) and isinstance(one, int):
                return sign * another * other, one
        return 1.0, a

    def _scale(self, column: Mapping[int, int | float], known: dict[str, int]) -> None:
        key = repr(column)
        if key in known:
            return
        base = next(b for b in (self._scaled(a)[1] for a in column.values()) if b is not None)
        row: list[int | None] = [None] * len(self.rows[0])
        known[key] = len(self.rows)
        for k, a in column.items():
            row[k] = slot = self._copy(a, Operation("mul", ((self._scaled(a)[0], 1), (base, 1))))
            self.place[slot] = (len(self.rows), k)
        self.rows.append(row)
