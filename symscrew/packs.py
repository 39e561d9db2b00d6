"""Packed programs: rows of corresponding instructions done at once, where this costs less than one by one.

A pack computes `sign * value` in every lane, so that sums and differences go together; signs are exact, and
results are those of the instructions one by one, bit for bit. A cost model in operations of a vector unit says
what packs save and what it costs to gather their operands and to take results out; packs that do not pay are
undone, and a program that does not gain enough stays as it is.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass

from symscrew.lane_signs import Part, fewest_flips
from symscrew.lanes import Operand, Operation, Row, corresponding, joined, signed
from symscrew.program import Instruction

WIDTHS = (2, 4)  # of vectors; more lanes than that take several
SLOW = {"div": 4.0, "reciprocal": 4.0, "sqrt": 6.0}  # beside 1 for a sum or a product
GATHERED = 1.0  # an entry that is put into a vector
TAKEN_OUT = 1.0  # an entry that is taken out of a vector
ENOUGH = 0.8  # the part of the cost that is worth packing at most
HOPELESS = 1.1  # and of what is tried to be improved
FAR = 1.3  # times the least cost: other ways are not tried to be improved
MOST_JOINED = 6  # lanes of ways that are joined
OTHERS = 5  # ways that are joined with the best one
PASSES = 2

Column = tuple[Operand | None, ...]  # an operand of a pack: slot or constant, and sign, in every lane


@dataclass(frozen=True)
class Vector:
    """An operand of a pack: pack number `source`, or else `entries` (slots or constants), times `flips` if given."""

    source: int | None
    entries: tuple[int | float, ...]
    flips: tuple[int, ...] | None = None


@dataclass(frozen=True)
class Pack:
    """`signs[k] * targets[k]` = op of operands in every lane k; lanes with target None are idle."""

    number: int
    op: str
    targets: Row
    signs: tuple[int, ...]
    operands: tuple[Vector, ...]


@dataclass(frozen=True)
class Packing:
    """A program as `items` in order of evaluation: slots of `operations`, and packs.

    `place[slot]` is (pack, lane) of packed slots; `negatives` are slots that are another one's negative or copy.
    """

    operations: Mapping[int, Operation]
    negatives: Mapping[int, Operand]
    items: tuple[int | Pack, ...]
    place: Mapping[int, tuple[Pack, int]]
    width: int
    cost: float


def packed(instructions: Sequence[Instruction], results: Iterable[int]) -> Packing | None:
    """The packed program, or None where there is nothing to gain; `results` are slots that are needed one by one."""
    operations, negatives = signed(instructions)
    wanted = {negatives[slot][0] if slot in negatives else slot for slot in results}
    kept = {slot for slot in wanted if isinstance(slot, int)}
    scalar = sum(SLOW.get(o.op, 1.0) for o in operations.values())
    plans = [_Plan(operations, rows, kept) for rows in corresponding(operations)]
    least = min((plan.cost for plan in plans), default=0.0)
    plans = [plan for plan in plans if plan.cost < min(HOPELESS * scalar, FAR * least)]
    for plan in plans:
        plan.improve()
    if not plans:
        return None
    plan = _joined(sorted(plans, key=lambda p: p.cost))
    if plan.cost > ENOUGH * scalar:
        return None
    order = plan.order()
    items = tuple(_signed_packs(plan, order, fewest_flips([_part(plan, k) for packs, k in order if packs])))
    place = {t: (p, k) for p in items if isinstance(p, Pack) for k, t in enumerate(p.targets) if t is not None}
    return Packing(operations, negatives, items, place, plan.width, plan.cost)


def _joined(plans: Sequence[_Plan]) -> _Plan:
    """The best of several plans, with rows of other ones where they cost less still."""
    best, *others = plans
    for plan in others[:OTHERS]:
        if len(plan.found[0]) == len(best.found[0]) <= MOST_JOINED:
            both = _Plan(best.operations, joined(best.found, plan.found), best.wanted)
            both.improve()
            best = min(best, both, key=lambda p: p.cost)
    return best


class _Plan:
    """Which rows are packed, and what that costs."""

    def __init__(self, operations: Mapping[int, Operation], found: Sequence[Row], wanted: set[int]) -> None:
        self.operations, self.found, self.wanted = operations, found, wanted
        parts = -(-len(found[0]) // WIDTHS[-1])
        lanes = -(-len(found[0]) // parts)
        self.width = next(width for width in WIDTHS if width >= lanes)
        cut = [row[start : start + lanes] for row in found for start in range(0, len(row), lanes)]
        self.rows = rows = [
            (*row, *(None,) * (self.width - len(row))) for row in cut if sum(slot is not None for slot in row) > 1
        ]
        self.place = {slot: (i, k) for i, row in enumerate(rows) for k, slot in enumerate(row) if slot is not None}
        self.on = [True] * len(rows)
        self.columns = [self._columns(row) for row in rows]
        self.users: dict[int, list[int]] = {}
        for slot, operation in operations.items():
            for arg, _ in operation.args:
                if isinstance(arg, int):
                    self.users.setdefault(arg, []).append(slot)
        self.needs: Counter[tuple] = Counter({("out", slot): 1 for slot in wanted})
        self.cost = 0.0
        self._wanted: dict[tuple[bool, int], tuple[tuple, ...]] = {}
        while (stuck := self._cycle()) is not None:
            self.on[stuck] = False
        for item in self._items():
            self._account(item, 1)
        self.cost += sum(self._price(("out", slot)) for slot in wanted)

    # -- how operands of a row stand ------------------------------------------------------------------

    def _columns(self, row: Row) -> tuple[Column, ...]:
        """The operands of a row, terms and factors in the order that fits those of the first lane best."""
        filled = {k: self.operations[slot].args for k, slot in enumerate(row) if slot is not None}
        first = next(iter(filled.values()))
        op = next(self.operations[slot].op for slot in row if slot is not None)
        if op in ("add", "mul"):
            for k, args in filled.items():
                straight, crossed = (
                    self._fit(first[0][0], args[i][0]) + self._fit(first[1][0], args[1 - i][0]) for i in (0, 1)
                )
                filled[k] = args[::-1] if crossed > straight else args
        lanes = range(self.width)
        return tuple(tuple(filled[k][i] if k in filled else None for k in lanes) for i in range(len(first)))

    def _fit(self, a: int | float, b: int | float) -> int:
        if isinstance(a, float) or isinstance(b, float):
            return 3 * (isinstance(a, float) and isinstance(b, float))
        if a == b:
            return 4
        one, other = self.place.get(a), self.place.get(b)
        if one and other:
            return 5 * (one[0] == other[0])
        return int(not one and not other)

    def at(self, slot: int | float) -> tuple[int, int] | None:
        """Row and lane of a slot that is packed."""
        found = self.place.get(slot) if isinstance(slot, int) else None
        return found if found and self.on[found[0]] else None

    def source(self, column: Column) -> int | None:
        """The row whose pack holds a column as it is."""
        rows = set()
        for k, entry in enumerate(column):
            if entry is not None:
                found = self.at(entry[0])
                if found is None or found[1] != k:
                    return None
                rows.add(found[0])
        return rows.pop() if len(rows) == 1 else None

    # -- cost -----------------------------------------------------------------------------------------

    def _items(self) -> Iterator[tuple[bool, int]]:
        """(True, row) of packs and (False, slot) of single instructions."""
        seen = set()
        for slot in self.operations:
            found = self.at(slot)
            item = (False, slot) if found is None else (True, found[0])
            if item not in seen:
                seen.add(item)
                yield item

    def _price(self, key: tuple) -> float:
        if key[0] == "out":
            return TAKEN_OUT if self.at(key[1]) is not None else 0.0
        different = len(set(key[1]))
        return GATHERED if different == 1 else GATHERED * different

    def _wants(self, item: tuple[bool, int]) -> tuple[tuple, ...]:
        """What an item needs beside vectors that are there: slots taken out, vectors gathered; remembered."""
        if item not in self._wanted:
            self._wanted[item] = tuple(self._looked_up(item))
        return self._wanted[item]

    def _looked_up(self, item: tuple[bool, int]) -> Iterator[tuple]:
        packs, number = item
        if not packs:
            yield from (("out", a) for a, _ in self.operations[number].args if isinstance(a, int))
            return
        for column in self.columns[number]:
            entries = tuple(entry[0] for entry in column if entry is not None)
            if self.source(column) is None and not all(isinstance(a, float) for a in entries):
                yield ("in", entries)
                yield from (("out", a) for a in dict.fromkeys(entries) if isinstance(a, int))

    def _own(self, item: tuple[bool, int]) -> float:
        packs, number = item
        if not packs:
            return SLOW.get(self.operations[number].op, 1.0)
        op = next(self.operations[slot].op for slot in self.rows[number] if slot is not None)
        return SLOW[op] * self.width / 2 if op in SLOW else 1.0

    def _account(self, item: tuple[bool, int], sign: int) -> None:
        self.cost += sign * self._own(item)
        for key in self._wants(item):
            before = self.needs[key]
            self.needs[key] += sign
            if min(before, before + sign) == 0:
                self.cost += sign * self._price(key)

    def _toggle(self, row: int, known: Mapping[tuple[bool, int], tuple[tuple, ...]] | None = None) -> Mapping:
        """Pack a row, or undo it, and account for it and for all that reads it; `known` takes a toggle back.

        What all of these wanted before is returned.
        """
        members = [slot for slot in self.rows[row] if slot is not None]
        around = {self._item(u) for slot in members for u in self.users.get(slot, ())}
        packed, single = {(True, row)}, {(False, slot) for slot in members}
        concerned = around | (packed if self.on[row] else single)
        for item in concerned:
            self._account(item, -1)
        kept = [slot for slot in members if self.needs["out", slot]]
        self.cost -= sum(self._price(("out", slot)) for slot in kept)
        before = {item: self._wanted.pop(item) for item in concerned}
        self._wanted |= known or {}
        self.on[row] = not self.on[row]
        self.cost += sum(self._price(("out", slot)) for slot in kept)
        for item in around | (packed if self.on[row] else single):
            self._account(item, 1)
        return before

    def _item(self, slot: int) -> tuple[bool, int]:
        found = self.at(slot)
        return (False, slot) if found is None else (True, found[0])

    def improve(self) -> None:
        """Undo packs as long as that costs less."""
        for _ in range(PASSES):
            changed = False
            for row in range(len(self.rows)):
                if self.on[row]:
                    before = self.cost
                    wanted = self._toggle(row)
                    if self.cost < before:
                        changed = True
                    else:
                        self._toggle(row, wanted)
            if not changed:
                return

    # -- order ----------------------------------------------------------------------------------------

    def _before(self, item: tuple[bool, int]) -> Iterator[tuple[bool, int]]:
        packs, number = item
        for slot in self.rows[number] if packs else (number,):
            if slot is not None:
                for arg, _ in self.operations[slot].args:
                    if isinstance(arg, int) and arg in self.operations:
                        yield self._item(arg)

    def _walk(self) -> tuple[list[tuple[bool, int]], int | None]:
        """Items in an order of evaluation, or a row that is in a cycle."""
        order: list[tuple[bool, int]] = []
        done: dict[tuple[bool, int], bool] = {}
        for start in self._items():
            stack = [(start, self._before(start))]
            while stack:
                item, rest = stack[-1]
                if done.get(item):
                    stack.pop()
                    continue
                done[item] = False
                following = next((x for x in rest if not done.get(x)), None)
                if following is None:
                    done[item] = True
                    order.append(item)
                    stack.pop()
                elif following in done:
                    return order, next(x[1] for x, _ in reversed(stack) if x[0])
                else:
                    stack.append((following, self._before(following)))
        return order, None

    def _cycle(self) -> int | None:
        return self._walk()[1]

    def order(self) -> list[tuple[bool, int]]:
        """Items in an order of evaluation."""
        return self._walk()[0]


def _part(plan: _Plan, number: int) -> Part:
    """What the signs of a row's lanes are made of."""
    row = plan.rows[number]
    busy = sum(1 << k for k, slot in enumerate(row) if slot is not None)
    op = next(plan.operations[slot].op for slot in row if slot is not None)
    operands = []
    for column in plan.columns[number]:
        constant = all(entry is None or isinstance(entry[0], float) for entry in column)
        own = 0 if constant else sum(1 << k for k, entry in enumerate(column) if entry is not None and entry[1] < 0)
        operands.append((plan.source(column), constant, own))
    return Part(number, op, busy, tuple(operands))


def _signed_packs(plan: _Plan, order: Sequence[tuple[bool, int]], other: Set[int]) -> Iterator[int | Pack]:
    """The items with the sign of every lane, as their operands give it; packs in `other` take the other way."""
    made: dict[int, tuple[int, ...]] = {}
    for packs, number in order:
        if not packs:
            yield number
            continue
        row = plan.rows[number]
        op = next(plan.operations[slot].op for slot in row if slot is not None)
        vectors, signs = zip(*(_vector(plan, made, c) for c in plan.columns[number]), strict=True)
        busy = [k for k, slot in enumerate(row) if slot is not None]
        op, operands, result = _combined(op, vectors, signs, busy, other=number in other)
        made[number] = result
        yield Pack(number, op, row, result, operands)


def _vector(plan: _Plan, made: Mapping[int, tuple[int, ...]], column: Column) -> tuple[Vector, tuple[int, ...]]:
    """Where an operand comes from, and by which signs it must be multiplied to be that operand."""
    some = next(entry for entry in column if entry is not None)
    source = plan.source(column)
    if source is not None:
        inner = made[source]
        signs = tuple(inner[k] * (1 if entry is None else entry[1]) for k, entry in enumerate(column))
        return Vector(source, ()), signs
    filled = [entry or some for entry in column]
    entries, signs = tuple(entry[0] for entry in filled), tuple(entry[1] for entry in filled)
    if all(isinstance(a, float) for a in entries):
        return Vector(None, tuple(s * a for s, a in zip(signs, entries, strict=True))), (1,) * len(entries)
    return Vector(None, entries), signs


def _combined(
    op: str, vectors: Sequence[Vector], signs: Sequence[tuple[int, ...]], busy: Sequence[int], *, other: bool
) -> tuple[str, tuple[Vector, ...], tuple[int, ...]]:
    """Operation, operands and signs of a pack."""
    plus = (1,) * len(signs[0])
    if op in ("mul", "div"):
        result = tuple(a * b for a, b in zip(*signs, strict=True))
        constant = next((k for k, vector in enumerate(vectors) if _constant(vector)), None)
        if not other or constant is None:
            return op, tuple(vectors), result
        return op, tuple(_flipped(v, result) if k == constant else v for k, v in enumerate(vectors)), plus
    if op == "sqrt":
        flip = any(signs[0][k] < 0 for k in busy)
        return op, (_flipped(vectors[0], signs[0]) if flip else vectors[0],), plus
    if op == "reciprocal":
        if other:
            return "div", (Vector(None, tuple(map(float, signs[0]))), vectors[0]), plus
        return op, tuple(vectors), signs[0]
    (first, second), (one, another) = vectors, signs
    if _constant(first) or (other and not _constant(second)):
        first, second, one, another = second, first, another, one
    ratio = tuple(a * b for a, b in zip(one, another, strict=True))
    among = {ratio[k] for k in busy}
    if len(among) == 1:
        return "add" if among == {1} else "sub", (first, second), one
    return "add", (first, _flipped(second, ratio)), one


def _constant(vector: Vector) -> bool:
    return vector.source is None and all(isinstance(a, float) for a in vector.entries)


def _flipped(vector: Vector, flips: tuple[int, ...]) -> Vector:
    if _constant(vector):
        return Vector(None, tuple(f * a for f, a in zip(flips, vector.entries, strict=True)))
    return Vector(vector.source, vector.entries, flips)
