"""Packed programs: rows of corresponding instructions done at once, where this costs less than one by one.

    x1 = a b | x2 = c d | x3 = -(e f) | x4 = g h  -->  pack: (1, 1, -1, 1) (x1 x2 x3 x4) = (a c e g) * (b d f h)

A pack computes `sign * value` in every lane, so that sums and differences go together; signs are exact, and
results are those of the instructions one by one, bit for bit but for the signs of zeros. A program that does not gain
enough by the best plan (see `symscrew.program.lanes.pack_plan`) stays as it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from symscrew.program.lanes.corresponding import Corresponding
from symscrew.program.lanes.lane_padding import padded
from symscrew.program.lanes.lane_signs import GATHERED, Part, Signs, fewest_flips
from symscrew.program.lanes.pack_plan import Code, Column, Item, Plan
from symscrew.program.lanes.signed_operations import SLOW, Operand, Operation, Row

# A plan is taken if it costs at most this part of the instructions one by one. At 0.91 to 0.94 calls take 0.87 (forward
# dynamics of the 3RRR and of the delta) to 1.00 of the time, at 0.95 a row of four-bars, where loops wait for each
# other, takes 1.28: above, the program stays as it is, and has no packed form in C.
ENOUGH = 0.94
HOPELESS = 1.2  # plans that cost more than this part as found are not improved: a fifth would have to come off
NEAR = 1.03  # plans that cost this much more than the best one as found are improved, too: others stay behind it
LIKELY = 1.1  # plans of limbs as they are that cost more than this part of the best one are not made alike
# Without packs that lack a lane a plan may cost so much more: the seed's independent drives, with one such of 151, cost
# 1.007 by it, take 0.97 of the time, and their file has 22 kB less. Drives from the platform's motion would cost 1.034.
HARDLY = 1.01
MOST_LANES = 8  # two vectors of four: with more limbs, pairs of operations grow with the square of their number
Rows = tuple[Row, ...]


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


def packed(
    found: Corresponding, results: Iterable[int], checked: Iterable[int] = (), arrays: Mapping[int, str] | None = None
) -> Packing | None:
    """The packed program, or None where there is nothing to gain.

    `results` are slots that are needed one by one; those of them and of `checked` are there in any case.
    `arrays` names the array of slots that are there from the start: entries of one array correspond to each other.
    """
    readings = list(found.readings(MOST_LANES))
    if not readings:
        return None
    operations, negatives = found.signed
    kept, there = (
        {slot for slot in (negatives.get(slot, (slot, 1))[0] for slot in slots) if isinstance(slot, int)}
        for slots in (results, checked)
    )
    scalar = sum(SLOW.get(o.op, 1.0) for o in operations.values())
    code = Code(operations, kept, there, 1 + max(i.target for i in found.instructions), arrays or {})
    each = dict.fromkeys(reading.rows for reading in readings)
    plain = _least([(Plan(code, rows), rows) for rows in each if rows], LIKELY)
    plain = [(plan, rows) for plan, rows in plain if plan.cost < HOPELESS * scalar]
    padded_too = [plan for _, rows in plain for plan in _padded(code, rows)]
    plans = [plan for plan, _ in _least([*plain, *((plan, ()) for plan in padded_too)], NEAR)]
    for plan in plans:
        plan.improve()
    if not plans:
        return None
    plan = min(plans, key=lambda p: p.cost)
    if plan.cost > ENOUGH * scalar:
        return None
    return packing_of(_whole_if_near(plan.settled()), negatives, results)


def _whole_if_near(plan: Plan) -> Plan:
    """The plan without packs that lack a lane, if that costs hardly more: then limbs have one text for lanes, too."""
    whole = tuple(row for row in plan.rows if None not in row)
    if len(whole) == len(plan.rows) or not whole:
        return plan
    other = Plan(plan.code, whole)
    return other if other.cost <= HARDLY * plan.cost else plan


def packing_of(plan: Plan, negatives: Mapping[int, Operand], results: Iterable[int]) -> Packing:
    """The packed program of a plan, with few flips."""
    order = plan.order()
    items = tuple(_signed_packs(plan, order, fewest_flips(list(_parts(plan, order, _stored(results, negatives))))))
    place = {t: (p, k) for p in items if isinstance(p, Pack) for k, t in enumerate(p.targets) if t is not None}
    return Packing(plan.code.operations, negatives, items, place, plan.width)


def _least(plans: Sequence[tuple[Plan, Rows]], part: float) -> list[tuple[Plan, Rows]]:
    """Those plans, and their rows, that cost at most so much of what the cheapest one does."""
    least = min((plan.cost for plan, _ in plans), default=0.0)
    return [(plan, rows) for plan, rows in plans if plan.cost <= part * least]


def _padded(code: Code, rows: Rows) -> Iterator[Plan]:
    """Rows with lanes made alike, if that makes a difference."""
    more = padded(code.operations, rows, code.unused)
    if more.copies:
        yield Plan(replace(code, operations=more.operations), more.rows, copies=more.copies)


def _stored(results: Iterable[int], negatives: Mapping[int, Operand]) -> list[Operand]:
    """What is stored: slots, and their signs."""
    return [negatives.get(slot, (slot, 1)) for slot in results]


def _parts(plan: Plan, order: Sequence[Item], stored: Iterable[Operand]) -> Iterator[Part]:
    """What the signs of lanes are made of: every pack, behind the vectors that are gathered for it."""
    gathered: dict[tuple[int | float, ...], int] = {}
    alone = _alone(plan, order, stored)
    for packs, number in order:
        if not packs:
            continue
        operands: list[tuple[int | None, bool, int]] = []
        for column in plan.columns[number]:
            source, entries = plan.source(column), _entries(column)
            constant = source is None and _numbers(entries)
            if source is None and not constant:
                if entries not in gathered:
                    gathered[entries] = -1 - len(gathered)
                    yield Part(gathered[entries], GATHERED, (1 << plan.width) - 1)
                source = gathered[entries]
            operands.append((source, constant, 0 if constant else _own(column)))
        busy = sum(1 << k for k, slot in enumerate(plan.rows[number]) if slot is not None)
        plus, minus = (
            sum(1 << k for k, slot in enumerate(plan.rows[number]) if (slot, sign) in alone) for sign in (1, -1)
        )
        yield Part(number, plan.ops[number], busy, tuple(operands), plus, minus)


def _alone(plan: Plan, order: Sequence[Item], stored: Iterable[Operand]) -> set[Operand]:
    """What is read alone, with its sign: stored, gathered, or an operand of a single operation, but for sums."""
    found = set(stored)
    for packs, number in order:
        if packs:
            gathered = (column for column in plan.columns[number] if plan.source(column) is None)
            found.update((a, 1) for column in gathered for a in _entries(column))
        elif plan.operations[number].op != "add":
            found.update((a, 1) for a, _ in plan.operations[number].args)
    return found


def _own(column: Column) -> int:
    """The lanes of a column that are read negative."""
    return sum(1 << k for k, entry in enumerate(column) if entry is not None and entry[1] < 0)


def _entries(column: Column) -> tuple[int | float, ...]:
    """What a column holds, and the first of that in idle lanes."""
    some = next(entry for entry in column if entry is not None)
    return tuple([(entry or some)[0] for entry in column])


def _signed_packs(plan: Plan, order: Sequence[Item], found: Mapping[int, Signs]) -> Iterator[int | Pack]:
    """The items with the sign of every lane, as was found."""
    for packs, number in order:
        if not packs:
            yield number
            continue
        row, op, columns, signs = plan.rows[number], plan.ops[number], plan.columns[number], found[number]
        busy = sum(1 << k for k, slot in enumerate(row) if slot is not None)
        vectors, come = [], []  # and the signs by which vectors must be multiplied to be what is packed
        for column, lanes in zip(columns, signs.read, strict=True):
            vectors.append(vector := _vector(plan, column, lanes))
            inner = 0 if vector.source is None else found[vector.source].result
            come.append(lanes ^ inner ^ (0 if _constant(vector) else _own(column)))
        if op == "reciprocal" and (come[0] ^ signs.result) & busy:
            numerator = map(float, _per_lane(come[0] ^ signs.result, plan.width))
            op, vectors = "div", [Vector(None, tuple(numerator)), *vectors]
        if op == "add":
            op = "sub" if (come[0] ^ come[1]) & busy else "add"
            if _constant(vectors[0]) or (come[0] ^ signs.result) & busy:
                vectors.reverse()
        yield Pack(number, op, row, _per_lane(signs.result, plan.width), tuple(vectors))


def _per_lane(lanes: int, width: int) -> tuple[int, ...]:
    """-1 in some lanes, 1 in the others."""
    return tuple([-1 if lanes >> k & 1 else 1 for k in range(width)])


def _vector(plan: Plan, column: Column, lanes: int) -> Vector:
    """Where an operand comes from, with some lanes flipped."""
    source, entries = plan.source(column), _entries(column)
    if source is None and _numbers(entries):
        negative = _own(column) ^ lanes
        return Vector(None, tuple(-a if negative >> k & 1 else a for k, a in enumerate(entries)))
    return Vector(source, entries if source is None else (), _per_lane(lanes, plan.width) if lanes else None)


def _numbers(entries: Iterable[int | float]) -> bool:
    return all(isinstance(a, float) for a in entries)


def _constant(vector: Vector) -> bool:
    return vector.source is None and _numbers(vector.entries)
