"""Stages of equal limbs: what each limb does alike, to be written once and done limb after limb.

    corresponding operations --Plan--> rows and single operations --staged_rows--> stage 0 | between | stage 1 | ...

Of the readings of a program that one is taken which saves most. Stages of few rows are not worth a function and stay
one by one.

Every value is computed up to its sign, which is known: a product takes those of its factors, a sum that of one term,
the other one is added or taken away, limb by limb. So no operation is added where equal limbs mirror each other.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace

from symscrew.program.equal_limbs import Limb
from symscrew.program.lanes.corresponding import Corresponding
from symscrew.program.lanes.pack_plan import Code, Item, Plan
from symscrew.program.lanes.packs import Pack, Packing, packing_of
from symscrew.program.lanes.signed_operations import Operand, Operation
from symscrew.program.lanes.staged_rows import LimbRow, LimbStages, Single, staged

FEWEST = 6  # rows of a stage: its head, its call per limb and what it hands on take as many lines as it saves
PART = 0.3  # of the operations that stages must save: of less, the text is hardly shorter, and limbs are not so equal
# Of a program in lanes: vectors put together for a stage wait for all limbs. In seven stages the seed's drives from the
# platform's motion once took 1.06 of the time in lanes, its independent drives take 0.97; others have up to five.
MOST_STAGES = 7
MOST_LIMBS = 8  # pairs of operations grow with the square of their number
# A root, and the division by it, take as long as thirty operations: where limbs have some, what needs no rates is in
# stages of its own, so that the roots of all limbs begin before the rates of the first. One state of the drives from
# the platform's motion takes so 0.80 (delta, one mode), 0.95 (6-UPS) and 0.99 (seed) of the time; functions without
# roots, parted in the same way, up to 1.13.
WAITS = "sqrt"
SIGNLESS = ("add", "sub", "mul", "div", "reciprocal")  # operations that take operands of any sign


def stages_of_limbs(
    found: Corresponding, stored: Collection[int], arrays: Mapping[int, str], ports: Mapping[int, int]
) -> LimbStages | None:
    """The stages that save most, or None where there are none; `stored` are slots that are needed with their sign.

    `arrays` and `ports` say of which array and input slots are that are there from the start. Of readings that save as
    much the first one is taken; the one that may save most is tried first, for it often spares the others.
    """
    readings = list(enumerate(found.readings(MOST_LIMBS)))
    if not readings:
        return None
    operations, negatives = found.signed
    enough = PART * len(operations)
    best: tuple[int, int, Plan, tuple[Limb, ...]] | None = None
    for number, reading in sorted(readings, key=lambda some: -some[1].most * (len(some[1].family) - 1)):
        each = len(reading.family) - 1  # operations that a row saves
        least = max(enough, best[0] - (number < best[1])) if best else enough
        if reading.most * each <= least or len(reading.whole) * each <= least:
            continue
        code = Code(operations, set(), set(), 1 + max(i.target for i in found.instructions), arrays)
        plan = Plan(code, reading.whole, widths=(len(reading.family),))
        _without_small_ones(plan, least / each)
        saved = sum(plan.on) * each
        if saved > least:
            best = saved, number, plan, reading.family
    if best is None:
        return None
    *_, plan, family = best
    packing = packing_of(plan, negatives, stored)
    rates = {slot: min(port, 1) for slot, port in ports.items()}  # coordinates come first
    if 1 in rates.values() and any(isinstance(item, Pack) and item.op == WAITS for item in packing.items):
        return replace(_stages(packing, family, rates, lanes=False), early=True)
    return _stages(packing, family, {}, lanes=False)


def stages_of_lanes(packing: Packing, family: tuple[Limb, ...], ports: Mapping[int, int]) -> LimbStages | None:
    """The stages of a program in lanes, if every lane is a limb and all of them are there in every pack.

    `ports` says of which input slots are that are there from the start.
    """
    packs = (item for item in packing.items if isinstance(item, Pack))
    if packing.width != len(family) or any(None in pack.targets for pack in packs):
        return None
    found = _stages(packing, family, ports, lanes=True)
    return found if len(found.stages) <= MOST_STAGES else None


def _stages(packing: Packing, family: tuple[Limb, ...], ports: Mapping[int, int], *, lanes: bool) -> LimbStages:
    """Rows in stages, and single operations with their signs."""
    sign = {slot: pack.signs[lane] for slot, (pack, lane) in packing.place.items()}
    rows = [
        LimbRow(
            pack.number,
            pack.op,
            tuple(t for t in pack.targets if t is not None),
            pack.signs,
            tuple(v.entries for v in pack.operands),
            tuple(v.source for v in pack.operands),
            tuple(v.flips for v in pack.operands),
        )
        for pack in packing.items
        if isinstance(pack, Pack)
    ]
    gathered = {a for row in rows for entries in row.operands for a in entries if isinstance(a, int)}
    singles = []
    for item in packing.items:
        if not isinstance(item, Pack):
            single = _single(item, packing.operations[item], sign, gathered)
            sign[item] = single.sign
            singles.append(single)
    return LimbStages(family, tuple(staged(rows, singles, ports)), tuple(singles), packing.negatives, lanes)


def _without_small_ones(plan: Plan, least: float) -> None:
    """Stages of few rows are done one by one, until the rows that are left are too few at all."""
    order = plan.first_order
    while sum(plan.on) > least:
        stages = _rows_by_stage(plan, order)
        few = min(stages, key=lambda level: (len(stages[level]), -level), default=-1)
        if few < 0 or len(stages[few]) >= FEWEST:
            return
        for number in stages[few]:
            plan.on[number] = False
        order = plan.order()


def _rows_by_stage(plan: Plan, order: Iterable[Item]) -> dict[int, list[int]]:
    """The rows of every stage, each in the first one where its operands are there."""
    behind: dict[int, int] = {}  # the stage behind which a slot is there
    rows: dict[int, int] = {}
    found: dict[int, list[int]] = {}
    for packs, number in order:
        if not packs:
            slots = [a for a, _ in plan.operations[number].args if type(a) is int]
            behind[number] = max([behind.get(a, -1) for a in slots], default=-1)
            continue
        stage = 0
        for column in plan.columns[number]:
            source = plan.source(column)
            if source is None:
                slots = [entry[0] for entry in column if entry is not None and type(entry[0]) is int]
                stage = max([stage, *[1 + behind.get(a, -1) for a in slots]])
            elif rows[source] > stage:
                stage = rows[source]
        rows[number] = stage
        found.setdefault(stage, []).append(number)
        for slot in plan.rows[number]:
            if slot is not None:
                behind[slot] = stage
    return found


def _sign(operand: Operand, sign: Mapping[int, int]) -> int:
    value, own = operand
    if isinstance(value, int):
        return own * sign.get(value, 1)
    return -own if value < 0 else own


def _bare(value: int | float) -> int | float:
    return value if isinstance(value, int) else abs(value)


def _single(slot: int, operation: Operation, sign: Mapping[int, int], gathered: Collection[int]) -> Single:
    op, args = operation
    if op not in SIGNLESS:
        return Single(slot, op, 1, args)
    signs = [_sign(a, sign) for a in args]
    bare = tuple((_bare(a), 1) for a, _ in args)
    if op != "add":
        return Single(slot, op, signs[0] * (signs[1] if len(signs) > 1 else 1), bare)
    if signs[0] == signs[1]:
        return Single(slot, op, signs[0], bare)
    if signs[1] > 0:
        return Single(slot, "sub", signs[1], bare[::-1])
    return Single(slot, "sub", signs[0], bare)
