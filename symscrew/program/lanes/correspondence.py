"""Instructions that correspond to each other: equal limbs, found again in a straight-line program.

Equal limbs give isomorphic parts of a program, but for signs, the order of factors and terms, and their leaves.
Nothing here knows a mechanism. A class of instructions that are alike with all that they are made of, one per
limb (a limb's root, say), splits the program into lanes: what depends on one of them only, and what only one of
them needs. Between lanes, instructions are paired by how alike they are, seen some operations down and up, and
by how many of their neighbours are paired already.
"""

from __future__ import annotations

import heapq
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations

from symscrew.program.straight_line import Instruction

PACKED = frozenset(("add", "mul", "div", "reciprocal", "sqrt"))  # what a vector unit does on all lanes at once
SLOW = {"div": 4.0, "reciprocal": 4.0, "sqrt": 6.0}  # what they cost beside 1 for a sum or a product
MOST_LANES = 8  # two vectors of four: classes of more are joints of a chain rather than limbs
# Limits of the search, which takes seconds beyond. What they leave out is done one by one: longer, with equal results.
MOST_INSTRUCTIONS = 5000  # of a program: none is split beyond
MOST_CLASSES = 16  # of alike instructions that are tried as roots of limbs, the largest first
MOST_SPLITS = 12  # into lanes, those that share most
MOST_CANDIDATES = 64  # pairs of instructions that look the same and are compared; of more, neighbours must decide
# The part of the operations that packs must be able to save for a split to be followed up: with less, gathering
# operands and taking results out costs more than that (see `pack_plan`).
LEAST = 0.3
ROUNDS = 5  # how many operations far instructions are compared: fewer mix legs up, more find no others alike at leaves
NEIGHBOUR = 4  # what a paired neighbour counts beside a round that agrees: less than all rounds together

Operand = tuple[int | float, int]  # slot or constant, and its sign
Row = tuple[int | None, ...]  # corresponding slots, one per lane


@dataclass(frozen=True)
class Operation:
    """An instruction with signed operands: a difference is a sum, a negation belongs to what reads it."""

    op: str
    args: tuple[Operand, ...]


def signed(instructions: Iterable[Instruction]) -> tuple[dict[int, Operation], dict[int, Operand]]:
    """Operations by slot in order, and the slots that are another one's negative."""
    operations: dict[int, Operation] = {}
    negatives: dict[int, Operand] = {}

    def operand(arg: int | float, sign: int = 1) -> Operand:
        if isinstance(arg, int) and arg in negatives:
            base, inner = negatives[arg]
            return base, sign * inner
        return arg, sign

    for i in instructions:
        if i.op == "neg":
            negatives[i.target] = operand(i.args[0], -1)
        elif i.op == "sub":
            operations[i.target] = Operation("add", (operand(i.args[0]), operand(i.args[1], -1)))
        else:
            operations[i.target] = Operation(i.op, tuple(operand(a) for a in i.args))
    return operations, negatives


def corresponding(
    operations: Mapping[int, Operation], arrays: Mapping[int, str] | None = None
) -> list[tuple[Row, ...]]:
    """Ways to put operations into rows of corresponding ones, two or more in each, a lane at the same place in all.

    `arrays` says which slots that are no operations are entries of the same array.
    """
    if len(operations) > MOST_INSTRUCTIONS:
        return []
    users = _users(operations)
    read = {slot: [a for a, _ in o.args if isinstance(a, int)] for slot, o in operations.items()}
    found: dict[tuple[Row, ...], None] = {}
    splits: dict[tuple[tuple[int, int], ...], tuple[int, int]] = {}
    for group in _classes(operations):
        for lane in _lanes(operations, read, users, group):
            shared = _shared(operations, lane, len(group))
            if shared >= LEAST * len(operations):
                splits[tuple(lane.items())] = shared, len(group)
    for split, (_, count) in sorted(splits.items(), key=lambda x: -x[1][0])[:MOST_SPLITS]:
        rows = _rows(_Pairing(operations, users, lane=dict(split), count=count, arrays=arrays or {}))
        if _saved(rows) >= LEAST * len(operations):
            found[rows] = None
    return list(found)


def joined(rows: Sequence[Row], others: Sequence[Row]) -> tuple[Row, ...]:
    """Rows, and what other ones of equally many lanes have besides, their lanes put where the same slots are."""
    lanes = range(len(rows[0]))
    place = {slot: k for row in rows for k, slot in enumerate(row) if slot is not None}
    votes = Counter((place[slot], k) for row in others for k, slot in enumerate(row) if slot in place)
    best = max(permutations(lanes), key=lambda order: sum(votes[k, order[k]] for k in lanes))
    moved = (tuple(None if row[k] in place else row[k] for k in best) for row in others)
    return (*rows, *(row for row in moved if sum(slot is not None for slot in row) > 1))


def _saved(rows: Sequence[Row]) -> int:
    """How many instructions are saved by doing each row at once."""
    return sum(sum(slot is not None for slot in row) - 1 for row in rows)


def _rows(pairing: _Pairing) -> tuple[Row, ...]:
    """The instructions of the lane of middle size with what they are paired with in the others."""
    sizes = Counter(pairing.lane.values())
    order = sorted(range(pairing.count), key=lambda k: (sizes[k], k))
    middle = order[len(order) // 2]
    pairs = {other: pairing.pairs(middle, other) for other in order if other != middle}
    rows = (
        tuple(slot if k == middle else pairs[k].get(slot) for k in range(pairing.count))
        for slot, at in pairing.lane.items()
        if at == middle
    )
    return tuple(row for row in rows if sum(slot is not None for slot in row) > 1)


def _users(operations: Mapping[int, Operation]) -> dict[int, list[int]]:
    users: dict[int, list[int]] = defaultdict(list)
    for slot, operation in operations.items():
        for arg in dict.fromkeys(a for a, _ in operation.args if isinstance(a, int)):
            users[arg].append(slot)
    return users


def _classes(operations: Mapping[int, Operation]) -> list[list[int]]:
    """Two to eight instructions alike in all that they are made of, but for signs and leaves; large ones first."""
    colour: dict[int, int] = {}
    depth: dict[int, int] = {}
    known: dict[tuple[str | int, ...], int] = {}
    members: dict[int, list[int]] = defaultdict(list)
    for slot, operation in operations.items():
        inner = sorted(
            colour.get(a, -1) if isinstance(a, int) else -2 for a, _ in operation.args
        )  # -1 an input, -2 a constant
        colour[slot] = known.setdefault((operation.op, *inner), len(known))
        depth[slot] = 1 + max((depth.get(a, 0) for a, _ in operation.args if isinstance(a, int)), default=0)
        members[colour[slot]].append(slot)
    found = [group for group in members.values() if 2 <= len(group) <= MOST_LANES]
    found.sort(key=lambda group: (operations[group[0]].op in ("add", "mul"), depth[group[0]]))
    found = [group for group in _slow(operations) if group not in found] + found
    return found[:MOST_CLASSES]


def _slow(operations: Mapping[int, Operation]) -> list[list[int]]:
    """Two to eight divisions or roots that are made of equally many other ones, whatever else they are made of."""
    below: dict[int, set[int]] = {}
    members: dict[tuple[str, ...], list[int]] = defaultdict(list)
    for slot, operation in operations.items():
        inner = set().union(*(below.get(a, ()) for a, _ in operation.args if isinstance(a, int)))
        if operation.op in SLOW:
            members[operation.op, *sorted(operations[s].op for s in inner)].append(slot)
            inner.add(slot)
        below[slot] = inner
    return [group for group in members.values() if 2 <= len(group) <= MOST_LANES]


def _lanes(
    operations: Mapping[int, Operation],
    read: Mapping[int, Sequence[int]],
    users: Mapping[int, Sequence[int]],
    group: Sequence[int],
) -> Iterator[dict[int, int]]:
    """The lane of every slot that belongs to one member of a class, in two ways.

    What depends on one member only, what only that reads, and then what depends on none and touches one lane and no
    other; entries of inputs do not count there, or they do.
    """
    member = {slot: 1 << k for k, slot in enumerate(group)}
    mask: dict[int, int] = {}
    lane: dict[int, int] = {}
    for slot, args in read.items():
        bits = member.get(slot, 0)
        for arg in args:
            bits |= mask.get(arg, 0)
        mask[slot] = bits
        if bits and not bits & (bits - 1):
            lane[slot] = bits.bit_length() - 1
    free = [slot for slot in operations if not mask[slot]]
    for slot in reversed(free):
        readers = {lane.get(u, -1) for u in users.get(slot, ())}
        if len(readers) == 1 and -1 not in readers:
            lane[slot] = readers.pop()
    entries = list(dict.fromkeys(a for args in read.values() for a in args if a not in operations))
    for leaves in ([], entries):
        more = dict(lane)
        for _ in range(2):
            for slots, beside in ((free, read), (free[::-1], users), (leaves, users)):
                for slot in slots:
                    if slot not in more:
                        touched = {more[x] for x in beside.get(slot, ()) if x in more}
                        if len(touched) == 1:
                            more[slot] = touched.pop()
        yield {slot: more[slot] for slot in operations if slot in more}


def _shared(operations: Mapping[int, Operation], lane: Mapping[int, int], count: int) -> int:
    """How many instructions packs could save at most."""
    counts = [Counter[str]() for _ in range(count)]
    for slot, k in lane.items():
        counts[k][operations[slot].op] += 1
    return sum(sum(c[op] for c in counts) - max(c[op] for c in counts) for op in sorted(PACKED))


class _Pairing:
    """Pairs instructions of two lanes: greedily, the most alike first, so that each pair helps its neighbours."""

    def __init__(
        self,
        operations: Mapping[int, Operation],
        users: Mapping[int, Sequence[int]],
        *,
        lane: Mapping[int, int],
        count: int,
        arrays: Mapping[int, str],
    ) -> None:
        self.operations, self.users, self.lane, self.count, self.arrays = operations, users, lane, count, arrays
        self.views = self._views()
        self.inside: dict[int, list[int]] = defaultdict(list)
        for slot, k in lane.items():
            if operations[slot].op in PACKED:
                self.inside[k].append(slot)

    def _views(self) -> dict[int, list[int]]:
        """What each slot looks like from 0, 1, ... operations away, below and above it."""
        known: dict[tuple[str | int, ...], int] = {}
        ops = {slot: known.setdefault((self.operations[slot].op,), len(known)) for slot in self.lane}
        down, up = ({slot: [colour] for slot, colour in ops.items()} for _ in range(2))
        named = {name: -3 - k for k, name in enumerate(dict.fromkeys(self.arrays.values()))}

        def leaf(a: int | float) -> int:
            return -2 if isinstance(a, float) else named[self.arrays[a]] if a in self.arrays else -1

        for k in range(1, ROUNDS):
            for slot, lane in self.lane.items():
                below = sorted(
                    down[a][k - 1] if isinstance(a, int) and self.lane.get(a) == lane else leaf(a)
                    for a, _ in self.operations[slot].args
                )
                above = sorted(up[u][k - 1] if self.lane.get(u) == lane else -1 for u in self.users.get(slot, ()))
                down[slot].append(known.setdefault(("down", ops[slot], *below), len(known)))
                up[slot].append(known.setdefault(("up", ops[slot], *above), len(known)))
        return {slot: down[slot] + up[slot] for slot in self.lane}

    def pairs(self, one: int, other: int) -> dict[int, int]:
        """Slot of one lane to slot of the other, the most alike first."""
        neighbours: Counter[tuple[int, int]] = Counter()
        alike: dict[tuple[int, int], int] = {}
        paired: dict[int, int] = {}
        taken: set[int] = set()

        def weight(a: int, b: int) -> int:
            if (a, b) not in alike:
                alike[a, b] = sum(x == y for x, y in zip(self.views[a], self.views[b], strict=True))
            return alike[a, b] + NEIGHBOUR * neighbours[a, b]

        heap = [(-weight(a, b), a, b) for a, b in self._candidates(one, other)]
        heapq.heapify(heap)
        while heap:
            found, a, b = heapq.heappop(heap)
            if a in paired or b in taken or -found != weight(a, b):
                continue
            paired[a] = b
            taken.add(b)
            for x, y in self._beside(a, b):
                if self.lane.get(x) == one and self.lane.get(y) == other and x not in paired and y not in taken:
                    op = self.operations[x].op
                    if op in PACKED and op == self.operations[y].op:
                        neighbours[x, y] += 1
                        heapq.heappush(heap, (-weight(x, y), x, y))
        return paired

    def _candidates(self, one: int, other: int) -> set[tuple[int, int]]:
        """Pairs that look alike, below and above, below, or above, where few others do."""
        far, half = ROUNDS - 1, ROUNDS // 2
        found: set[tuple[int, int]] = set()
        for at in ((far, ROUNDS + far), (half, ROUNDS + half), (far,), (ROUNDS + far,)):
            classes: dict[tuple[int, ...], tuple[list[int], list[int]]] = defaultdict(lambda: ([], []))
            for side, lane in enumerate((one, other)):
                for slot in self.inside[lane]:
                    view = self.views[slot]
                    classes[tuple(view[k] for k in at)][side].append(slot)
            for left, right in classes.values():
                if len(left) * len(right) <= MOST_CANDIDATES:
                    found.update((a, b) for a in left for b in right)
        return found

    def _beside(self, a: int, b: int) -> Iterable[tuple[int, int]]:
        below = ([x for x, _ in self.operations[s].args if isinstance(x, int)] for s in (a, b))
        above = (self.users.get(s, ()) for s in (a, b))
        for first, second in (tuple(below), tuple(above)):
            yield from ((x, y) for x in first for y in second)
