"""Signs of lanes: which operands of packs are flipped, so that few are.

A pack may hold the negative of an instruction in some lanes. Its signs are those of its operands: a product's are their
products; in a sum of two that differ in the signs of some lanes, but not of all, one of them must be flipped: a
product with 1 and -1 more. Equal limbs that mirror each other differ much in signs, and whether the second or the first
one is flipped decides what comes after. A product with a constant has any signs for nothing.

Flipping the second one always makes packed programs of the catalogue up to 5 % longer (2 % in the mean), and single
calls up to 8 % slower (6-UPS: drives in y; drives of the 3RRR 4 %), in others the same.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import dataclass

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


def fewest_flips(parts: Sequence[Part]) -> set[int]:
    """The packs, each after those that it reads, that flip the first operand, or have plus in every lane.

    One after the other takes its other way if there are not more flips then: what is equal may lead to less.
    """
    other: set[int] = set()
    place = {part.number: k for k, part in enumerate(parts)}
    now = _flips(parts, other)
    for _ in range(ROUNDS):
        before, ways = now.count, now.ways
        for number in sorted(ways):
            found = _flips(parts, other ^ {number}, now, place[number])
            if found.count <= now.count:
                other, now = other ^ {number}, found
        if now.count == before:
            break
        now = _flips(parts, other)
    return other


@dataclass(frozen=True)
class _Flips:
    """How many flips there are, in front of every pack too, the signs of packs, and those that can be had two ways.

    The ways are those behind where the count started.
    """

    count: int
    until: list[int]
    made: dict[int, int]
    ways: list[int]


def _flips(parts: Sequence[Part], other: Set[int], known: _Flips | None = None, start: int = 0) -> _Flips:
    """The flips; from a pack on if they are `known` in front of it, and up to more than there were then."""
    made = dict(known.made) if known else {}
    until = known.until[:start] if known else []
    count, most = (known.until[start], known.count) if known else (0, None)
    ways = []
    for part in parts[start:]:
        until.append(count)
        busy = part.busy
        signs = [own if source is None else own ^ made[source] for source, _, own in part.operands]
        constant = part.op == "reciprocal" or any(constant for _, constant, _ in part.operands)
        if part.op == "add":
            two = not constant and (signs[0] ^ signs[1]) & busy not in (0, busy)
            count += two
            result = signs[1] if part.operands[0][1] or (two and part.number in other) else signs[0]
        elif part.op == "sqrt":
            two = False
            count += signs[0] & busy != 0
            result = 0
        else:
            result = signs[0] ^ signs[-1] if len(signs) > 1 else signs[0]
            two = constant and result & busy not in (0, busy)
            result = 0 if two and part.number in other else result
        made[part.number] = result
        if two:
            ways.append(part.number)
        if most is not None and count > most:
            break
    return _Flips(count, until, made, ways)
