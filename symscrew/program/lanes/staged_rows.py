"""Which stage every row of equal limbs is in, and what lies between stages.

A stage holds rows that need nothing of the same stage but in their own limb: it can be done for one limb after the
other. A row is in the first stage where its operands are there, or in the one of its first reader where so fewer values
wait between stages.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from symscrew.program.equal_limbs import Limb
from symscrew.program.lanes.pack_plan import Item
from symscrew.program.lanes.signed_operations import Operand

PARTED = 12  # rows of each part of a stage that is parted


@dataclass(frozen=True)
class LimbRow:
    """`signs[k] * slots[k]` = op of `operands[n][k]` in every limb k, times `flips[n][k]` where these are given.

    `sources[n]` is the row that operand n is of, if it is one.
    """

    number: int
    op: str
    slots: tuple[int, ...]
    signs: tuple[int, ...]
    operands: tuple[tuple[int | float, ...], ...]
    sources: tuple[int | None, ...]
    flips: tuple[tuple[int, ...] | None, ...]
    stage: int = 0


@dataclass(frozen=True)
class Single:
    """`sign * slot` = op of operands; those of operations that any sign suits are without, others times theirs."""

    slot: int
    op: str
    sign: int
    operands: tuple[Operand, ...]


@dataclass(frozen=True)
class LimbStages:
    """A program in stages of equal limbs, and single operations.

    `lanes`: whether these are those of its form in lanes, too; `early`: whether roots of all limbs begin before rates.
    """

    limbs: tuple[Limb, ...]
    rows: tuple[LimbRow, ...]
    singles: tuple[Single, ...]
    negatives: Mapping[int, Operand]
    lanes: bool = False
    early: bool = False

    @cached_property
    def stages(self) -> tuple[tuple[LimbRow, ...], ...]:
        """The rows of every stage."""
        count = 1 + max(row.stage for row in self.rows)
        return tuple(tuple(row for row in self.rows if row.stage == k) for k in range(count))


Read = tuple[tuple[int, ...], tuple[int | float, ...]]  # rows that are read limb by limb, and slots or numbers


def staged(rows: Sequence[LimbRow], singles: Sequence[Single], ports: Mapping[int, int]) -> list[LimbRow]:
    """The rows, each with its stage."""
    place = {slot: row.number for row in rows for slot in row.slots}
    unordered: dict[Item, Read] = {}
    for row in rows:
        pairs = list(zip(row.sources, row.operands, strict=True))
        apart = tuple(a for source, entries in pairs if source is None for a in entries)
        unordered[True, row.number] = tuple(s for s, _ in pairs if s is not None), apart
    for single in singles:
        unordered[False, single.slot] = (), tuple(a for a, _ in single.operands)
    read = _ordered(unordered, place)
    levels = _levels(read, place)
    _later(read, place, levels)
    parts = _parted(read, place, levels, ports)
    used = {part: n for n, part in enumerate(sorted(set(parts.values())))}
    by_number = {row.number: row for row in rows}
    return [replace(by_number[n], stage=used[parts[n]]) for packs, n in read if packs]


def _levels(read: Mapping[Item, Read], place: Mapping[int, int]) -> dict[Item, int]:
    """The stage of every row, and of single operations the one behind which they are (-1: before all)."""
    found: dict[Item, int] = {}
    for item, (sources, slots) in read.items():
        behind = max((found[other] for other in _items(slots, place) if other in found), default=-1)
        found[item] = max([behind + 1, *(found[True, s] for s in sources)]) if item[0] else behind
    return found


def _items(slots: Iterable[int | float], place: Mapping[int, int]) -> Iterator[Item]:
    for a in slots:
        if isinstance(a, int):
            yield (True, place[a]) if a in place else (False, a)


def _parted(
    read: Mapping[Item, Read], place: Mapping[int, int], levels: Mapping[Item, int], ports: Mapping[int, int]
) -> dict[int, tuple[int, int, bool]]:
    """The stage of every row: what needs nothing of later inputs is done before these are worked off on the hub.

    Position, velocities, accelerations are stages of their own where the hub gives limbs something of each. So are rows
    that no later stage needs: they are done when the hub wants them.
    """
    latest: dict[Item, int] = {}  # stage that needs an item, itself or through others
    for item in reversed(list(read)):
        own = max(latest.get(item, -1), levels[item] if item[0] else -1)
        sources, slots = read[item]
        for other in (*((True, s) for s in sources), *_items(slots, place)):
            if other in read:
                latest[other] = max(latest.get(other, -1), own)
    rank: dict[Item, int] = {}  # of the last input that an item needs; of rows, by what the hub gives
    for item, (sources, slots) in read.items():
        others = [other for other in _items(slots, place) if other in read]
        inputs = [] if item[0] else [ports.get(a, -1) for a in slots if isinstance(a, int)]
        rank[item] = max([-1, *inputs, *(rank[True, s] for s in sources), *(rank[other] for other in others)])
    found = {n: (levels[True, n], rank[True, n], False) for packs, n in read if packs}
    late = {n for n, (level, *_) in found.items() if latest.get((True, n), -1) <= level}
    while True:
        parts = sorted(set(found.values()))
        sizes = Counter(found.values())
        few = next((part for part in parts if sizes[part] < PARTED and sum(p[0] == part[0] for p in parts) > 1), None)
        if few is None:
            break
        same = [part for part in parts if part[0] == few[0]]
        at = same.index(few)
        gone, into = (few, same[at + 1]) if at + 1 < len(same) else (same[at - 1], few)
        found = {n: into if part == gone else part for n, part in found.items()}
    wanted = Counter(part for n, part in found.items() if n in late)
    apart = {part for part, size in Counter(found.values()).items() if PARTED <= wanted[part] <= size - PARTED}
    return {n: (*part[:2], part in apart and n in late) for n, part in found.items()}


def _ordered(read: Mapping[Item, Read], place: Mapping[int, int]) -> dict[Item, Read]:
    """In an order of evaluation."""
    found: dict[Item, Read] = {}
    for root in read:
        stack = [root]
        while stack:
            item = stack[-1]
            sources, slots = read[item]
            before = [*((True, s) for s in sources), *_items(slots, place)]
            left = [other for other in before if other in read and other not in found] if item not in found else []
            if left:
                stack += left
            else:
                found[item] = read[item]
                stack.pop()
    return found


def _later(read: Mapping[Item, Read], place: Mapping[int, int], levels: dict[Item, int]) -> None:
    """Rows that only later stages read come there, where not more of their operands have to wait for them."""
    readers: dict[int, list[int]] = {number: [] for packs, number in read if packs}
    outside: set[int] = set()
    for (_, number), (sources, slots) in read.items():
        for source in sources:
            readers[source].append(number)
        outside.update(place[a] for a in slots if a in place)  # type: ignore[index]
    for packs, row in reversed(list(read)):
        if not packs or row in outside or not readers[row]:
            continue
        first = min(levels[True, reader] for reader in readers[row])
        waiting = 0
        for source in set(read[True, row][0]):
            own = levels[True, source]
            others = [levels[True, reader] for reader in readers[source] if reader != row]
            waiting += own < first and source not in outside and all(level <= own for level in others)
        if first > levels[True, row] and waiting <= 1:
            levels[True, row] = first
