"""Packed programs: rows of corresponding instructions done at once, where this costs less than one by one.

    x1 = a b | x2 = c d | x3 = -(e f) | x4 = g h  -->  pack: (1, 1, -1, 1) (x1 x2 x3 x4) = (a c e g) * (b d f h)

A pack computes `sign * value` in every lane, so that sums and differences go together; signs are exact, and
results are those of the instructions one by one, bit for bit but for the signs of zeros. A program that does not gain
enough by the best plan (see `symscrew.program.lanes.pack_plan`) stays as it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace

from symscrew.algebra import Origin
from symscrew.program.equal_limbs import NO_LIMBS, Limbs
from symscrew.program.lanes.lane_padding import padded
from symscrew.program.lanes.lane_signs import Part, fewest_flips
from symscrew.program.lanes.limb_lanes import readings_of
from symscrew.program.lanes.limb_rows import rows_of
from symscrew.program.lanes.pack_plan import Code, Column, Plan
from symscrew.program.lanes.signed_operations import SLOW, Operand, Operation, Row, signed
from symscrew.program.straight_line import Instruction

# A plan is taken if it costs at most this part of the instructions one by one. At 0.91 to 0.94 calls take 0.87 (forward
# dynamics of the 3RRR and of the delta) to 1.00 of the time, at 0.95 a row of four-bars, where loops wait for each
# other, takes 1.28: above, the program stays as it is, and has no packed form in C.
ENOUGH = 0.94
HOPELESS = 1.2  # plans that cost more than this part as found are not improved: a fifth would have to come off
NEAR = 1.03  # plans that cost this much more than the best one as found are improved, too: others stay behind it
LIKELY = 1.1  # plans of limbs as they are that cost more than this part of the best one are not made alike
MOST_LANES = 8  # two vectors of four: with more limbs, pairs of operations grow with the square of their number
Rows = tuple[Row, ...]
NO_ORIGINS: Mapping[int, Origin] = {}


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


def packed(
    instructions: Sequence[Instruction],
    results: Iterable[int],
    checked: Iterable[int] = (),
    arrays: Mapping[int, str] | None = None,
    *,
    origins: Mapping[int, Origin] = NO_ORIGINS,
    limbs: Limbs = NO_LIMBS,
) -> Packing | None:
    """The packed program, or None where there is nothing to gain.

    `results` are slots that are needed one by one; those of them and of `checked` are there in any case.
    `arrays` names the array of slots that are there from the start: entries of one array correspond to each other.
    `origins` says where slots come from, `limbs` which parts of the mechanism are equal: without them nothing is.
    """
    families = [family for family in limbs.families if len(family) <= MOST_LANES]
    if not families:
        return None
    operations, negatives = signed(instructions)
    kept, there = (
        {slot for slot in (negatives.get(slot, (slot, 1))[0] for slot in slots) if isinstance(slot, int)}
        for slots in (results, checked)
    )
    scalar = sum(SLOW.get(o.op, 1.0) for o in operations.values())
    code = Code(operations, kept, there, 1 + max(i.target for i in instructions), arrays or {})
    readings = (lanes for family in families for lanes in readings_of(operations, negatives, origins, family))
    found = dict.fromkeys(rows_of(operations, lanes) for lanes in readings)
    plain = _least([(Plan(code, rows), rows) for rows in found if rows], LIKELY)
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
    plan = plan.settled()
    order = plan.order()
    items = tuple(_signed_packs(plan, order, fewest_flips([_part(plan, k) for packs, k in order if packs])))
    place = {t: (p, k) for p in items if isinstance(p, Pack) for k, t in enumerate(p.targets) if t is not None}
    return Packing(plan.code.operations, negatives, items, place, plan.width, plan.cost)


def _least(plans: Sequence[tuple[Plan, Rows]], part: float) -> list[tuple[Plan, Rows]]:
    """Those plans, and their rows, that cost at most so much of what the cheapest one does."""
    least = min((plan.cost for plan, _ in plans), default=0.0)
    return [(plan, rows) for plan, rows in plans if plan.cost <= part * least]


def _padded(code: Code, rows: Rows) -> Iterator[Plan]:
    """Rows with lanes made alike, if that makes a difference."""
    more = padded(code.operations, rows, code.unused)
    if more.copies:
        yield Plan(replace(code, operations=more.operations), more.rows, copies=more.copies)


def _part(plan: Plan, number: int) -> Part:
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


def _signed_packs(plan: Plan, order: Sequence[tuple[bool, int]], other: Set[int]) -> Iterator[int | Pack]:
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


def _vector(plan: Plan, made: Mapping[int, tuple[int, ...]], column: Column) -> tuple[Vector, tuple[int, ...]]:
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
