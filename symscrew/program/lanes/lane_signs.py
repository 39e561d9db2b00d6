"""Signs of lanes: which operands of packs are flipped, so that few are.

A pack may hold the negative of an instruction in some lanes. Its signs are those of its operands: a product's are their
products; in a sum of two that differ in the signs of some lanes, but not of all, one of them must be flipped: a
product with 1 and -1 more. Equal limbs that mirror each other differ much in signs, and whether the second or the first
one is flipped decides what comes after. A product with a constant has any signs for nothing.

Flipping the second one always makes packed programs of the catalogue up to 5 % longer (2 % in the mean), and single
calls up to 8 % slower (6-UPS: drives in y; drives of the 3RRR 4 %), in others the same.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass
from heapq import heappop, heappush
from typing import NamedTuple

# Over all packs that can be had in two ways, or fewer if one changes nothing. More would only find fewer flips: the
# signs of all lanes are right with any.
ROUNDS = 2


@dataclass(frozen=True)
class Part:
    """A pack: its lanes in use, and of every operand the pack that it is, if so, whether it is constant, and its signs.

    Lanes are bits: of `busy` those in use, of signs those that are negative.
    """

    number: int
    op: str
    busy: int
    operands: tuple[tuple[int | None, bool, int], ...]


class _Done(NamedTuple):
    """The signs of a pack's result, how many operands are flipped for it, and whether it can be had in two ways."""

    signs: int
    flips: int
    two: bool


def fewest_flips(parts: Sequence[Part]) -> set[int]:
    """The packs, each after those that it reads, that flip the first operand, or have plus in every lane.

    One after the other takes its other way if there are not more flips then: what is equal may lead to less.
    """
    other: set[int] = set()
    place = {part.number: k for k, part in enumerate(parts)}
    readers: dict[int, list[int]] = {}
    for k, part in enumerate(parts):
        for source in {source for source, _, _ in part.operands if source is not None}:
            readers.setdefault(source, []).append(k)
    done: dict[int, _Done] = {}
    for part in parts:
        done[part.number] = _done(part, done, other=False)
    for _ in range(ROUNDS):
        changed = False
        for number in sorted(number for number, found in done.items() if found.two):
            tried = other ^ {number}
            before = _change(parts, done, place[number], other=tried, readers=readers)
            fewer = sum(found.flips - done[k].flips for k, found in before.items())
            if fewer >= 0:
                other = tried
                changed |= fewer > 0
            else:
                done |= before
        if not changed:
            break
    return other


def _change(
    parts: Sequence[Part], done: dict[int, _Done], start: int, *, other: Set[int], readers: Mapping[int, list[int]]
) -> dict[int, _Done]:
    """Bring up to date what follows from the choice at one pack; what it was before is returned."""
    changed: dict[int, _Done] = {}
    waiting = [start]
    while waiting:
        part = parts[heappop(waiting)]
        before, now = done[part.number], _done(part, done, other=part.number in other)
        if now != before:
            changed[part.number], done[part.number] = before, now
        if now.signs != before.signs:
            for reader in readers.get(part.number, ()):
                if reader not in waiting:
                    heappush(waiting, reader)
    return changed


def _done(part: Part, done: Mapping[int, _Done], *, other: bool) -> _Done:
    """What a pack comes to; `other`: in its other way, if it has two."""
    busy = part.busy
    signs = [own if source is None else own ^ done[source].signs for source, _, own in part.operands]
    if part.op == "sqrt":
        return _Done(0, int(signs[0] & busy != 0), two=False)
    constant = part.op == "reciprocal" or any(constant for _, constant, _ in part.operands)
    if part.op == "add":
        two = not constant and (signs[0] ^ signs[1]) & busy not in (0, busy)
        result = signs[1] if part.operands[0][1] or (two and other) else signs[0]
        return _Done(result, int(two), two)
    result = signs[0] ^ signs[-1] if len(signs) > 1 else signs[0]
    two = constant and result & busy not in (0, busy)
    return _Done(0 if two and other else result, 0, two)
