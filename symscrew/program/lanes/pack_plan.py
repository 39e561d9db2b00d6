"""Which rows of corresponding instructions are done at once: a cost model in operations of a vector unit.

    cost = packs + single operations + GATHERED * entries put into vectors + TAKEN_OUT * entries taken out

It says what packs save, and what it costs to gather their operands and to take results out. Packs that do not pay are
undone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, field, replace

from symscrew.program.lanes.signed_operations import SLOW, WIDEST, Operand, Operation, Row

WIDTHS = (2, WIDEST)  # of vectors
GATHERED = 1.5  # an entry that is put into a vector: a load with insertion, on the one port that shuffles
TAKEN_OUT = 1.0  # an entry that is taken out of a vector
ROUNDS_OF_UNDOING = 2  # over all packs, or fewer if one undoes nothing; a pack that would pay undone later stays

Item = tuple[bool, int]  # (True, row) of a pack, (False, slot) of a single instruction
Need = tuple[str, int | tuple[int | float, ...]]  # ("out", slot) to have on its own, ("in", entries) to gather
Column = tuple[Operand | None, ...]  # an operand of a pack: slot or constant, and sign, in every lane


@dataclass(frozen=True)
class Code:
    """Operations by slot; the slots of them that are `wanted` one by one, or there in any case; unused slots.

    `arrays` says which slots that are no operations are entries of the same array.
    """

    operations: Mapping[int, Operation]
    wanted: Set[int]
    checked: Set[int] = frozenset()
    unused: int = 0
    arrays: Mapping[int, str] = field(default_factory=dict)


class Plan:
    """Which rows are packed, and what that costs.

    `copies` are operations that are nothing but another slot or number where they are not packed. Of slots that are
    copied in packs some may not be read any more (`shared`); these cost nothing then.
    """

    def __init__(
        self,
        code: Code,
        found: tuple[Row, ...],
        *,
        copies: Mapping[int, int | float] | None = None,
    ) -> None:
        self.code, self.copies = code, copies or {}
        self.operations = operations = code.operations
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
        self.shared = {a for a in self.copies.values() if isinstance(a, int) and a in operations}
        self.shared -= {*self.place, *code.wanted, *code.checked}
        self.users: dict[int, list[int]] = {}
        for slot, operation in operations.items():
            for arg, _ in operation.args:
                for read in (arg, self.copies.get(arg) if isinstance(arg, int) else None):
                    if isinstance(read, int):
                        self.users.setdefault(read, []).append(slot)
        self.needs: dict[Need, int] = {}
        self.cost = 0.0
        self._wanted: dict[Item, list[Need]] = {}
        self.order()
        for key in (key for slot in code.wanted for key in self._read(slot)):
            self._need(key, 1)
        for item in self._items():
            self._account(item, 1)

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
        if one or other:
            return 0
        return 1 + (a in self.code.arrays and self.code.arrays[a] == self.code.arrays.get(b))

    def at(self, slot: int | float) -> tuple[int, int] | None:
        """Row and lane of a slot that is packed."""
        found = self.place.get(slot) if type(slot) is int else None
        return found if found is not None and self.on[found[0]] else None

    def source(self, column: Column) -> int | None:
        """The row whose pack holds a column as it is."""
        row = None
        for k, entry in enumerate(column):
            if entry is not None:
                found = self.at(self._plain(entry[0]))
                if found is None or found[1] != k or (row is not None and found[0] != row):
                    return None
                row = found[0]
        return row

    def _plain(self, operand: int | float) -> int | float:
        """What an operand is a copy of, if it is one and not packed."""
        if type(operand) is int and operand in self.copies and self.at(operand) is None:
            return self.copies[operand]
        return operand

    # -- cost -----------------------------------------------------------------------------------------

    def _items(self) -> Iterator[Item]:
        """(True, row) of packs and (False, slot) of single instructions."""
        seen = set()
        for slot in self.operations:
            found = self.at(slot)
            item = (False, slot) if found is None else (True, found[0])
            if item not in seen:
                seen.add(item)
                yield item

    def _price(self, key: Need) -> float:
        _, what = key
        if isinstance(what, int):
            if what in self.shared:
                return SLOW.get(self.operations[what].op, 1.0)
            return TAKEN_OUT if self.at(what) is not None else 0.0
        different = len(set(what))
        return GATHERED if different == 1 else GATHERED * different

    def _wants(self, item: Item) -> list[Need]:
        """What an item needs beside vectors that are there: slots taken out, vectors gathered; remembered."""
        found = self._wanted.get(item)
        if found is None:
            self._wanted[item] = found = self._looked_up(item)
        return found

    def _looked_up(self, item: Item) -> list[Need]:
        packs, number = item
        found: list[Need] = []
        if not packs:
            if number not in self.copies and number not in self.shared:
                for a, _ in self.operations[number].args:
                    found += self._read(self._plain(a))
            return found
        for column in self.columns[number]:
            if self.source(column) is None:
                entries = tuple([self._plain(entry[0]) for entry in column if entry is not None])
                if not all(type(a) is float for a in entries):
                    found.append(("in", entries))
                    for a in dict.fromkeys(entries):
                        found += self._read(a)
        return found

    def _read(self, operand: int | float) -> list[Need]:
        """What is needed to have an operand on its own."""
        if type(operand) is not int:
            return []
        if operand not in self.shared:
            return [("out", operand)]
        behind: list[Need] = [("out", a) for a, _ in self.operations[operand].args if isinstance(a, int)]
        return [("out", operand), *behind]

    def _own(self, item: Item) -> float:
        packs, number = item
        if not packs:
            free = number in self.copies or number in self.shared
            return 0.0 if free else SLOW.get(self.operations[number].op, 1.0)
        op = next(self.operations[slot].op for slot in self.rows[number] if slot is not None)
        return SLOW[op] * self.width / 2 if op in SLOW else 1.0

    def _account(self, item: Item, sign: int) -> None:
        self.cost += sign * self._own(item)
        for key in self._wants(item):
            self._need(key, sign)

    def _need(self, key: Need, sign: int) -> None:
        before = self.needs.get(key, 0)
        self.needs[key] = after = before + sign
        if not before or not after:
            self.cost += sign * self._price(key)

    def _toggle(self, row: int, known: Mapping[Item, list[Need]] | None = None) -> dict[Item, list[Need]]:
        """Pack a row, or undo it, and account for it and for all that reads it; `known` takes a toggle back.

        What all of these wanted before is returned.
        """
        members = [slot for slot in self.rows[row] if slot is not None]
        around = {self._item(u) for slot in members for u in self.users.get(slot, ())}
        packed, single = {(True, row)}, {(False, slot) for slot in members}
        concerned = around | (packed if self.on[row] else single)
        for item in concerned:
            self._account(item, -1)
        kept = [slot for slot in members if self.needs.get(("out", slot))]
        self.cost -= sum(self._price(("out", slot)) for slot in kept)
        before = {item: self._wanted.pop(item) for item in concerned}
        self._wanted |= known or {}
        self.on[row] = not self.on[row]
        self.cost += sum(self._price(("out", slot)) for slot in kept)
        for item in around | (packed if self.on[row] else single):
            self._account(item, 1)
        return before

    def _item(self, slot: int) -> Item:
        found = self.at(slot)
        return (False, slot) if found is None else (True, found[0])

    def improve(self) -> None:
        """Undo packs as long as that costs less."""
        for _ in range(ROUNDS_OF_UNDOING):
            changed = False
            for row in range(len(self.rows)):
                if self.on[row] and self._at_edge(row):
                    before = self.cost
                    wanted = self._toggle(row)
                    if self.cost < before:
                        changed = True
                    else:
                        self._toggle(row, wanted)
            if not changed:
                return

    def _at_edge(self, row: int) -> bool:
        """Whether something is gathered for a pack or taken out of it: undone among packs only, it would cost more."""
        if self._wants((True, row)):
            return True
        return any(slot is not None and self.needs.get(("out", slot)) for slot in self.rows[row])

    # -- order ----------------------------------------------------------------------------------------

    def _before(self, item: Item) -> Iterator[Item]:
        packs, number = item
        for slot in self.rows[number] if packs else (number,):
            if slot is not None:
                read = self.operations[slot].args
                for arg in [self.copies[slot]] if not packs and slot in self.copies else [a for a, _ in read]:
                    if isinstance(arg, int) and arg in self.operations:
                        yield self._item(arg)

    def order(self) -> list[Item]:
        """Items in an order of evaluation; rows that wait for each other are packed no longer, one in each cycle."""
        order: list[Item] = []
        done: dict[Item, bool] = {}
        for slot in self.operations:
            while not done.get(start := self._item(slot)):
                stack = [(start, self._before(start))]
                while stack:
                    item, rest = stack[-1]
                    done[item] = False
                    following = next((x for x in rest if not done.get(x)), None)
                    if following is None:
                        done[item] = True
                        order.append(item)
                        stack.pop()
                    elif following in done:
                        self._undo(stack, done)
                    else:
                        stack.append((following, self._before(following)))
        return order

    def _undo(self, stack: list[tuple[Item, Iterator[Item]]], done: dict[Item, bool]) -> None:
        """Pack the last row on the way no longer, and go back to what asked for it."""
        packs = False
        while not packs:
            (packs, number), _ = stack.pop()
            del done[packs, number]
        self.on[number] = False
        if stack:
            item, _ = stack.pop()
            stack.append((item, self._before(item)))

    def settled(self) -> Plan:
        """The same packs without copies that are in none, and without operations that nobody reads any more."""
        gone = {slot for slot in self.copies if self.at(slot) is None}
        gone |= {slot for slot in self.shared if not self.needs.get(("out", slot))}
        operations = {
            slot: Operation(o.op, tuple((self._plain(a), sign) for a, sign in o.args))
            for slot, o in self.operations.items()
            if slot not in gone
        }
        rows = tuple(row for row, on in zip(self.rows, self.on, strict=True) if on)
        return Plan(replace(self.code, operations=operations), rows)
