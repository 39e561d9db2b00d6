"""Rows of corresponding operations, one per limb: by their names, then by what lies beside them.

    same name, same operation --> row;   beside rows: operands and readers of members --> pairs, the likeliest first

Operations without names correspond if they are beside rows at the same places: operands of corresponding operations
and readers of them vote for each other, one more if nothing else there does the same. Pairs are taken the most votes
first, and each new one votes for its own neighbours, so that rows grow from the named values into what lies between.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from heapq import heappop, heappush
from itertools import combinations

from symscrew.program.lanes.limb_lanes import LimbLanes
from symscrew.program.lanes.limb_neighbours import LEAF, Neighbours
from symscrew.program.lanes.signed_operations import Operation, Row

ALONE, AMONG = 4, 2  # what a neighbour counts that is the only one there with its operation, or one of several
HINT = 1  # what it counts to have the same hint: as much as a shared operand
MOST_ALIKE = 24  # operations that look alike and are compared; of more, neighbours decide: pairs grow with the square
CONSTANT, SHARED, UNNAMED = -1, -2, -3  # operands that are not known by their name
NOTHING: frozenset[int] = frozenset()


def rows_of(operations: Mapping[int, Operation], lanes: LimbLanes, beside: Neighbours | None = None) -> tuple[Row, ...]:
    """Operations in rows of corresponding ones, two or more in each, a limb at the same place in all.

    What lies beside what is the same for all readings with the same lanes.
    """
    return _Pairing(operations, lanes, beside or Neighbours(operations, lanes.lane)).rows()


class _Pairing:
    """The rows so far: `row[x]` are the members of that of number x (see `Neighbours`), at first alone; and pairs."""

    def __init__(self, operations: Mapping[int, Operation], lanes: LimbLanes, neighbours: Neighbours) -> None:
        self.operations, self.lanes, self.beside = operations, lanes, neighbours
        self.lane = neighbours.lane
        self.row = [[x] for x in range(len(self.lane))]
        # A pair x < y is the number x * base + y; what waits is that less its votes times base * base: most come first.
        self.base = 1 + len(self.lane)
        self.waits: dict[int, int] = {}
        self.taken = [1 << lane for lane in self.lane]  # limbs with a member in the row of a number
        self.made, self.pure = self._made()
        self.outer = self._read_outside()
        self.hints = self._hints()
        self.marked = [bool(outer or hint) for outer, hint in zip(self.outer, self.hints, strict=True)]
        self.groups = self._groups()

    def _hints(self) -> list[int]:
        """The hints as numbers, 0 where there is none."""
        known: dict[Hashable, int] = {}
        hints = self.lanes.hints
        return [known.setdefault(hints[slot], 1 + len(known)) if slot in hints else 0 for slot in self.beside.slots]

    def _read_outside(self) -> list[frozenset[int]]:
        """What an operation, and operands of its limb without a name, read that is none of the limb's.

        Shared values, and for the operation itself constants as one.
        """
        own: dict[int, frozenset[int]] = {}
        found = [NOTHING] * len(self.lane)
        lane, names, number = self.beside.of, self.lanes.names, self.beside.number
        for slot, (_, args) in self.operations.items():
            if slot not in number:
                continue
            mine, whole, further = lane[slot], NOTHING, NOTHING
            for a, _ in args:
                if type(a) is not int:
                    further |= {CONSTANT}
                elif lane.get(a) != mine:
                    whole |= {a}
                elif a in own and a not in names:
                    further |= own[a]
            own[slot] = whole
            found[number[slot]] = whole | further
        return found

    def _made(self) -> tuple[dict[int, int], set[int]]:
        """What every operation is made of, down to names, as a number; and those that are made of a limb's alone."""
        known: dict[Hashable, int] = {}
        number: dict[int, int] = {}
        pure: set[int] = set()
        names, lane = self.lanes.names, self.beside.of
        for slot, (op, args) in self.operations.items():
            own = lane.get(slot)
            if own is None:
                continue
            if slot in names:
                number[slot] = known.setdefault((op, names[slot]), len(known))
                pure.add(slot)
                continue
            parts, alone = [], True
            for a, _ in args:
                if type(a) is not int:
                    parts.append(CONSTANT)
                elif lane.get(a) != own:
                    parts.append(SHARED)
                    alone = False
                elif a in number:
                    parts.append(number[a])
                    alone = alone and a in pure
                elif a in names:  # there from the start
                    parts.append(known.setdefault(names[a], len(known)))
                    number[a] = parts[-1]
                    pure.add(a)
                else:
                    parts.append(UNNAMED)
                    alone = False
            parts.sort()
            number[slot] = known.setdefault((op, *parts), len(known))
            if alone:
                pure.add(slot)
        return number, pure

    # -- rows -------------------------------------------------------------------------------------------------

    def rows(self) -> tuple[Row, ...]:
        """Rows by name, then by votes."""
        changed: set[int] = set()
        for row in list(self._named()):
            for x, y in combinations(row, 2):
                self._vote_beside((x,), (y,), changed)
        for group in self.groups:
            if 1 < len(group) <= MOST_ALIKE:
                for k, x in enumerate(group):
                    self._vote((x,), group[k + 1 :], 0, changed)
        self._pair(changed)
        slots, lane, op = self.beside.slots, self.lane, self.beside.op
        found: list[Row] = []
        for x, members in enumerate(self.row):
            if len(members) > 1 and op[x] != LEAF and x == min(members):
                places: list[int | None] = [None] * self.lanes.count
                for y in members:
                    places[lane[y]] = slots[y]
                found.append(tuple(places))
        return tuple(found)

    def _pair(self, changed: Iterable[int]) -> None:
        """Take pairs, the likeliest first."""
        waits, taken, base = self.waits, self.taken, self.base
        square = base * base
        first = sorted([waits[pair] for pair in changed], reverse=True)  # from its end
        heap: list[int] = []
        while first or heap:
            found = heappop(heap) if not first or (heap and heap[0] < first[-1]) else first.pop()
            pair = found % square
            if waits[pair] == found:  # else it has more votes, and waits with these
                x, y = divmod(pair, base)
                if not taken[x] & taken[y]:
                    for more in self._join(x, y):
                        heappush(heap, waits[more])

    def _groups(self) -> list[list[int]]:
        """Operations that are made alike."""
        groups: defaultdict[tuple[int, str], list[int]] = defaultdict(list)
        made, slots, op = self.made, self.beside.slots, self.beside.op
        for x in self.beside.met:
            if op[x] != LEAF:
                groups[made[slots[x]], op[x]].append(x)
        return list(groups.values())

    def _named(self) -> Iterator[list[int]]:
        """Rows of what is the same down to names of the limb, if there are equally many in every limb that has some."""
        slots, pure, names = self.beside.slots, self.pure, self.lanes.names
        leaves: defaultdict[Hashable, list[int]] = defaultdict(list)
        for x in self.beside.met:
            if self.beside.op[x] == LEAF and slots[x] in names:
                leaves[names[slots[x]]].append(x)
        certain = ([x for x in group if slots[x] in pure] for group in self.groups)
        for group in [*leaves.values(), *certain]:
            columns: list[list[int]] = [[] for _ in range(self.lanes.count)]
            for x in group:
                columns[self.lane[x]].append(x)
            lengths = {len(column) for column in columns if column}
            if len(lengths) == 1 and sum(map(bool, columns)) > 1:
                for k in range(lengths.pop()):
                    row = [column[k] for column in columns if column]
                    self._joined(row, sum(1 << self.lane[x] for x in row))
                    yield row

    def _joined(self, row: list[int], taken: int) -> None:
        """Its members are in this row now, together."""
        for x in row:
            self.row[x], self.taken[x] = row, taken

    def _join(self, x: int, y: int) -> set[int]:
        """Two rows are one; the pairs that have other votes now."""
        one, other = self.row[x], self.row[y]
        self._joined(one + other, self.taken[x] | self.taken[y])
        changed: set[int] = set()
        self._vote_beside(one, other, changed)
        return changed

    # -- votes ------------------------------------------------------------------------------------------------

    def _vote_beside(self, some: Iterable[int], more: Sequence[int], changed: set[int]) -> None:
        """What is beside members of a row at the same places, each of some and of more, corresponds, too."""
        waits, taken, base, marked, beside = self.waits, self.taken, self.base, self.marked, self.beside.beside
        gain = ALONE * base * base
        for p in some:
            mine = beside[p].items()
            for q in more:
                others = beside[q]
                for op, found in mine:
                    if op not in others:
                        continue
                    there = others[op]
                    if len(found) > 1 or len(there) > 1:
                        self._vote(found, there, AMONG, changed)
                        continue
                    x, y = found[0], there[0]
                    if not taken[x] & taken[y]:
                        pair = x * base + y if x < y else y * base + x
                        if pair in waits:
                            waits[pair] -= gain
                        else:
                            waits[pair] = (self._alike(x, y, pair) if marked[x] and marked[y] else pair) - gain
                        changed.add(pair)

    def _vote(self, some: Iterable[int], more: Sequence[int], amount: int, changed: set[int]) -> None:
        """So many votes for each of some with each of others, but for pairs of which some limb has members in both."""
        waits, taken, base, marked = self.waits, self.taken, self.base, self.marked
        gain = amount * base * base
        for x in some:
            own = taken[x]
            for y in more:
                if not own & taken[y]:
                    pair = x * base + y if x < y else y * base + x
                    if pair in waits:
                        waits[pair] -= gain
                    else:
                        waits[pair] = (self._alike(x, y, pair) if marked[x] and marked[y] else pair) - gain
                    changed.add(pair)

    def _alike(self, x: int, y: int, pair: int) -> int:
        """How a pair waits by what the two have in common by themselves."""
        votes = len(self.outer[x] & self.outer[y])
        hint = self.hints[x]
        if hint and hint == self.hints[y]:
            votes += HINT
        return pair - votes * self.base * self.base
