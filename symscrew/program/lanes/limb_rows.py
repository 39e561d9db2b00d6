"""Rows of corresponding operations, one per limb: by their names, then by what lies beside them.

    same name, same operation --> row;   beside rows: operands and readers of members --> pairs, the likeliest first

Operations without names correspond if they are beside rows at the same places: operands of corresponding operations
and readers of them vote for each other, one more if nothing else there does the same. Pairs are taken the most votes
first, and each new one votes for its own neighbours, so that rows grow from the named values into what lies between.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from itertools import combinations

from symscrew.program.lanes.limb_lanes import LimbLanes
from symscrew.program.lanes.signed_operations import PACKED, Operation, Row

ALONE, AMONG = 4, 2  # what a neighbour counts that is the only one there with its operation, or one of several
HINT = 1  # what it counts to have the same hint: as much as a shared operand
MOST_ALIKE = 24  # operations that look alike and are compared; of more, neighbours decide: pairs grow with the square
CONSTANT, SHARED, UNNAMED = -1, -2, -3  # operands that are not known by their name
LEAF = "leaf"  # what is there from the start: inputs, sines and cosines


def rows_of(operations: Mapping[int, Operation], readings: Iterable[LimbLanes]) -> Iterator[tuple[Row, ...]]:
    """By each reading, operations in rows of corresponding ones, two or more in each, a limb at the same place in all.

    Readings with the same lanes follow each other: what lies beside what is the same for them.
    """
    beside = None
    for lanes in readings:
        if beside is None or beside.lane is not lanes.lane:
            beside = Neighbours.of(operations, lanes.lane)
        yield _rows(operations, lanes, beside)


def _rows(operations: Mapping[int, Operation], lanes: LimbLanes, beside: Neighbours) -> tuple[Row, ...]:
    pairing = _Pairing(operations, lanes, beside)
    pairing.run()
    rows = {id(row): row for row in pairing.row.values() if len(row) - row.count(None) > 1}
    first = {key: min([s for s in row if s is not None]) for key, row in rows.items()}
    found = [rows[key] for key in sorted(rows, key=first.__getitem__) if first[key] in operations]
    return tuple(map(tuple, found))


@dataclass(frozen=True)
class Neighbours:
    """Operations in lanes and what is there for them from the start (`op`), and what lies beside each in its own lane.

    `beside`: its operands and its readers, by operation.
    """

    lane: Mapping[int, int]
    op: dict[int, str]
    beside: dict[int, tuple[dict[str, list[int]], dict[str, list[int]]]]

    @classmethod
    def of(cls, operations: Mapping[int, Operation], lane: Mapping[int, int]) -> Neighbours:
        """Those of all operations that a vector unit does and that are in a lane."""
        found = cls(lane, {}, {})
        op, beside = found.op, found.beside
        for slot, (kind, args) in operations.items():
            own = lane.get(slot)
            if own is None or kind not in PACKED:
                continue
            op[slot] = kind
            below: dict[str, list[int]] = {}
            beside[slot] = below, {}
            for a, _ in args:
                if type(a) is not int or lane.get(a) != own:
                    continue
                if a not in op:
                    if a in operations:
                        continue
                    op[a], beside[a] = LEAF, ({}, {})
                mine = below.setdefault(op[a], [])
                if a not in mine:
                    mine.append(a)
                    beside[a][1].setdefault(kind, []).append(slot)
        return found


class _Pairing:
    """The rows so far, by slot, and pairs that wait to be taken."""

    def __init__(self, operations: Mapping[int, Operation], lanes: LimbLanes, neighbours: Neighbours) -> None:
        self.operations, self.lanes, self.lane = operations, lanes, lanes.lane
        self.op, self.beside = neighbours.op, neighbours.beside
        self.row: dict[int, list[int | None]] = {}
        # a pair x < y is the number x * base + y; in the heap that less its votes times base * base: most come first
        self.base = 1 + max(self.op, default=0)
        self.votes: dict[int, int] = {}
        self.heap: list[int] = []
        self.taken = {slot: 1 << self.lane[slot] for slot in self.op}  # limbs with a member in the row of a slot
        self.made, self.pure = self._made()
        self.outer = self._read_outside()
        self.groups = self._groups()

    def _read_outside(self) -> dict[int, frozenset[int]]:
        """What an operation, and operands of its limb without a name, read that is none of the limb's.

        Shared values, and for the operation itself constants as one.
        """
        own: dict[int, set[int]] = {}
        found: dict[int, frozenset[int]] = {}
        lane, names, operations = self.lane, self.lanes.names, self.operations
        for slot, op in self.op.items():
            if op == LEAF:
                continue
            mine, whole, further = lane[slot], set[int](), set[int]()
            for a, _ in operations[slot].args:
                if type(a) is not int:
                    further.add(CONSTANT)
                elif lane.get(a) != mine:
                    whole.add(a)
                elif a in own and a not in names:
                    further |= own[a]
            own[slot] = whole
            found[slot] = frozenset(whole | further) if further else frozenset(whole)
        return found

    def _made(self) -> tuple[dict[int, int], set[int]]:
        """What every operation is made of, down to names, as a number; and those that are made of a limb's alone."""
        known: dict[Hashable, int] = {}
        number: dict[int, int] = {}
        pure: set[int] = set()
        names, lane, operations = self.lanes.names, self.lane, self.operations

        def part(a: int | float, own: int) -> int:
            if isinstance(a, float):
                return CONSTANT
            if lane.get(a) != own:
                return SHARED
            if a not in number and a in names:
                return known.setdefault(names[a], len(known))
            return number.get(a, UNNAMED)

        for slot, operation in operations.items():
            own = lane.get(slot)
            if own is None:
                continue
            if slot in names:
                number[slot] = known.setdefault((operation.op, names[slot]), len(known))
                pure.add(slot)
                continue
            parts = sorted([part(a, own) for a, _ in operation.args])
            number[slot] = known.setdefault((operation.op, *parts), len(known))
            if all(isinstance(a, float) or a in pure or (a in names and lane.get(a) == own) for a, _ in operation.args):
                pure.add(slot)
        return number, pure

    # -- rows -------------------------------------------------------------------------------------------------

    def run(self) -> None:
        """Rows by name, then by votes."""
        changed: set[int] = set()
        for row in list(self._named()):
            for x, y in combinations([s for s in row if s is not None], 2):
                self._vote_beside(x, y, changed)
        for group in self.groups:
            if 1 < len(group) <= MOST_ALIKE:
                for k, slot in enumerate(group):
                    self._vote((slot,), group[k + 1 :], 0, changed)
        heap, votes, taken, base = self.heap, self.votes, self.taken, self.base
        square = base * base
        heap += [pair - votes[pair] * square for pair in changed]
        heapify(heap)
        while heap:
            weight, pair = divmod(heappop(heap), square)
            if -weight == votes[pair]:
                x, y = divmod(pair, base)
                if not taken[x] & taken[y]:
                    self._join(x, y)

    def _groups(self) -> list[list[int]]:
        """Operations that are made alike."""
        groups: defaultdict[tuple[int, str], list[int]] = defaultdict(list)
        for slot, op in self.op.items():
            if op != LEAF:
                groups[self.made[slot], op].append(slot)
        return list(groups.values())

    def _named(self) -> Iterator[list[int | None]]:
        """Rows of what is the same down to names of the limb, if there are equally many in every limb that has some."""
        leaves: defaultdict[Hashable, list[int]] = defaultdict(list)
        for slot, op in self.op.items():
            if op == LEAF and slot in self.lanes.names:
                leaves[self.lanes.names[slot]].append(slot)
        certain = ([s for s in group if s in self.pure] for group in self.groups)
        for group in [*leaves.values(), *certain]:
            columns: list[list[int]] = [[] for _ in range(self.lanes.count)]
            for slot in group:
                columns[self.lane[slot]].append(slot)
            lengths = {len(column) for column in columns if column}
            if len(lengths) == 1 and sum(map(bool, columns)) > 1:
                for k in range(lengths.pop()):
                    row = [column[k] if column else None for column in columns]
                    self._joined(row)
                    yield row

    def _joined(self, row: list[int | None]) -> None:
        """Its members are in this row now, together."""
        members = [slot for slot in row if slot is not None]
        taken = 0
        for slot in members:
            taken |= 1 << self.lane[slot]
        for slot in members:
            self.row[slot], self.taken[slot] = row, taken

    def _members(self, x: int) -> list[int | None]:
        return self.row.get(x) or [x if k == self.lane[x] else None for k in range(self.lanes.count)]

    def _join(self, x: int, y: int) -> None:
        one, other = self._members(x), self._members(y)
        self._joined([b if a is None else a for a, b in zip(one, other, strict=True)])
        changed: set[int] = set()
        for p in one:
            for q in other:
                if p is not None and q is not None:
                    self._vote_beside(p, q, changed)
        heap, votes, square = self.heap, self.votes, self.base * self.base
        for pair in changed:
            heappush(heap, pair - votes[pair] * square)

    # -- votes ------------------------------------------------------------------------------------------------

    def _vote_beside(self, p: int, q: int, changed: set[int]) -> None:
        """What is beside two members of a row at the same places corresponds, too."""
        votes, taken, base = self.votes, self.taken, self.base
        for mine, others in zip(self.beside[p], self.beside[q], strict=True):
            for op, some in mine.items():
                if op not in others:
                    continue
                more = others[op]
                if len(some) > 1 or len(more) > 1:
                    self._vote(some, more, AMONG, changed)
                    continue
                x, y = some[0], more[0]
                if not taken[x] & taken[y]:
                    pair = x * base + y if x < y else y * base + x
                    votes[pair] = (votes[pair] if pair in votes else self._alike(x, y)) + ALONE
                    changed.add(pair)

    def _vote(self, some: Sequence[int], more: Sequence[int], amount: int, changed: set[int]) -> None:
        """So many votes for each of some with each of others, but for pairs of which some limb has members in both."""
        votes, taken, base = self.votes, self.taken, self.base
        for x in some:
            own = taken[x]
            for y in more:
                if not own & taken[y]:
                    pair = x * base + y if x < y else y * base + x
                    votes[pair] = (votes[pair] if pair in votes else self._alike(x, y)) + amount
                    changed.add(pair)

    def _alike(self, x: int, y: int) -> int:
        """The votes of what two slots have in common by themselves."""
        hints, outer = self.lanes.hints, self.outer
        hinted = HINT if x in hints and hints[x] == hints.get(y) else 0
        mine = outer.get(x)
        if not mine:
            return hinted
        other = outer[y]
        return hinted if mine.isdisjoint(other) else hinted + len(mine & other)
