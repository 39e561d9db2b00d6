"""Stages of equal limbs: what each limb does alike, to be written once and done limb after limb.

    rows of corresponding operations --Plan--> stage 0 | what comes between | stage 1 | ...

A stage holds rows that need nothing of the same stage but in their own limb: it can be done for one limb after the
other. A row is in the first stage where its operands are there, or in the one of its first reader where so fewer values
wait between stages. Stages of few rows are not worth a function and stay one by one.

Every value is computed up to its sign, which is known: a product takes those of its factors, a sum that of one term,
the other one is added or taken away, limb by limb. So no operation is added where equal limbs mirror each other.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from symscrew.algebra import Origin
from symscrew.program.equal_limbs import Limb, Limbs
from symscrew.program.lanes.limb_lanes import readings_of
from symscrew.program.lanes.limb_rows import rows_of
from symscrew.program.lanes.pack_plan import Code, Item, Plan
from symscrew.program.lanes.signed_operations import Operand, Operation, Row, signed
from symscrew.program.straight_line import Instruction

FEWEST = 6  # rows of a stage: its head, its call per limb and what it hands on take as many lines as it saves
MOST_LIMBS = 8  # pairs of operations grow with the square of their number
SIGNLESS = ("add", "mul", "div", "reciprocal")  # operations that take operands of any sign


@dataclass(frozen=True)
class LimbRow:
    """`signs[k] * slots[k]` = op of `operands[n][k]` in every limb k; `sources[n]` is the row that operand n is of.

    Of a sum, `terms` are the signs with which its second operand is added; numbers are without sign, but for those of
    roots.
    """

    number: int
    op: str
    slots: tuple[int, ...]
    signs: tuple[int, ...]
    operands: tuple[tuple[int | float, ...], ...]
    sources: tuple[int | None, ...]
    terms: tuple[int, ...]
    stage: int


@dataclass(frozen=True)
class Single:
    """`sign * slot` = op of operands; of a sum, `term` is the sign with which the second operand is added."""

    slot: int
    op: str
    sign: int
    operands: tuple[Operand, ...]
    term: int


@dataclass(frozen=True)
class LimbStages:
    """A program in stages of equal limbs, and single operations; all are in an order of evaluation."""

    limbs: tuple[Limb, ...]
    rows: tuple[LimbRow, ...]
    singles: tuple[Single, ...]
    negatives: Mapping[int, Operand]

    @property
    def stages(self) -> tuple[tuple[LimbRow, ...], ...]:
        """The rows of every stage."""
        count = 1 + max(row.stage for row in self.rows)
        return tuple(tuple(row for row in self.rows if row.stage == k) for k in range(count))


def limb_stages(
    instructions: Sequence[Instruction],
    stored: Collection[int],
    arrays: Mapping[int, str],
    *,
    origins: Mapping[int, Origin],
    limbs: Limbs,
) -> LimbStages | None:
    """The stages that save most, or None where there are none; `stored` are slots that are needed with their sign."""
    operations, negatives = signed(instructions)
    best: tuple[int, Plan, dict[Item, int], tuple[Limb, ...]] | None = None
    for family in limbs.families:
        if len(family) > MOST_LIMBS:
            continue
        for rows in dict.fromkeys(rows_of(operations, readings_of(operations, negatives, origins, family))):
            whole = tuple(row for row in rows if None not in row)
            if not whole:
                continue
            code = Code(operations, set(), set(), 1 + max(i.target for i in instructions), arrays)
            plan = Plan(code, whole, widths=(len(family),))
            levels = _stages(plan)
            saved = sum(plan.on) * (len(family) - 1)
            if saved and (best is None or saved > best[0]):
                best = saved, plan, levels, family
    if best is None:
        return None
    _, plan, levels, family = best
    wanted = {base: sign for base, sign in (negatives.get(slot, (slot, 1)) for slot in stored)}
    rows, singles = _signed(plan, levels, wanted)
    return LimbStages(family, tuple(rows), tuple(singles), negatives)


def _stages(plan: Plan) -> dict[Item, int]:
    """The stage of every row, and of single operations the one behind which they are (-1: before all)."""
    while True:
        levels = _levels(plan)
        sizes: dict[int, int] = {}
        for (packs, _), level in levels.items():
            if packs:
                sizes[level] = sizes.get(level, 0) + 1
        few = min(sizes, key=lambda level: (sizes[level], -level), default=-1)
        if few < 0 or sizes[few] >= FEWEST:
            break
        for (packs, number), level in levels.items():
            if packs and level == few:
                plan.on[number] = False
    _later(plan, levels)
    order = {level: n for n, level in enumerate(sorted({level for (packs, _), level in levels.items() if packs}))}
    return {item: order[level] if item[0] else level for item, level in levels.items()}


def _levels(plan: Plan) -> dict[Item, int]:
    found: dict[Item, int] = {}
    for item in plan.order():
        packs, number = item
        level = 0 if packs else -1
        if packs:
            for column, source in zip(plan.columns[number], map(plan.source, plan.columns[number]), strict=True):
                if source is not None:
                    level = max(level, found[True, source])
                    continue
                read = [_item(plan, entry[0]) for entry in column if entry is not None]
                level = max([level, *(found[other] + 1 for other in read if other is not None)])
        else:
            read = [_item(plan, a) for a, _ in plan.operations[number].args]
            level = max([level, *(found[other] for other in read if other is not None)])
        found[item] = level
    return found


def _item(plan: Plan, value: int | float) -> Item | None:
    if not isinstance(value, int) or value not in plan.operations:
        return None
    place = plan.at(value)
    return (False, value) if place is None else (True, place[0])


def _later(plan: Plan, levels: dict[Item, int]) -> None:
    """Rows that only later stages read come there, where not more of their operands have to wait for them."""
    readers: dict[int, list[int]] = {row: [] for (packs, row) in levels if packs}
    outside: set[int] = set()
    sources = {row: [plan.source(column) for column in plan.columns[row]] for row in readers}
    for row, read in sources.items():
        for source, column in zip(read, plan.columns[row], strict=True):
            if source is not None:
                readers[source].append(row)
            else:
                outside.update(at[0] for e in column if e is not None and (at := plan.at(e[0])) is not None)
    for packs, number in levels:
        if not packs:
            outside.update(at[0] for a, _ in plan.operations[number].args if (at := plan.at(a)) is not None)
    for packs, row in reversed(list(levels)):
        if not packs or row in outside or not readers[row]:
            continue
        first = min(levels[True, reader] for reader in readers[row])
        if first <= levels[True, row]:
            continue
        waiting = 0
        for source in {s for s in sources[row] if s is not None}:
            own = levels[True, source]
            others = [levels[True, reader] for reader in readers[source] if reader != row]
            waiting += own < first and source not in outside and all(level <= own for level in others)
        if waiting <= 1:
            levels[True, row] = first


def _signed(plan: Plan, levels: Mapping[Item, int], wanted: Mapping[int | float, int]) -> tuple[list[LimbRow], list[Single]]:
    """Rows and single operations with the sign of every value."""
    sign: dict[int, int] = {}
    rows, singles = [], []
    for packs, number in levels:
        if not packs:
            operation = plan.operations[number]
            single = _single(number, operation, sign, wanted)
            sign[number] = single.sign
            singles.append(single)
            continue
        row = _row(plan, number, levels[True, number], sign, wanted)
        sign.update(zip(row.slots, row.signs, strict=True))
        rows.append(row)
    return rows, singles


def _sign(operand: Operand, sign: Mapping[int, int]) -> int:
    value, own = operand
    if isinstance(value, int):
        return own * sign.get(value, 1)
    return -own if value < 0 else own


def _bare(value: int | float) -> int | float:
    return value if isinstance(value, int) else abs(value)


def _single(slot: int, operation: Operation, sign: Mapping[int, int], wanted: Mapping[int | float, int]) -> Single:
    op, args = operation
    if op not in SIGNLESS:
        return Single(slot, op, 1, tuple((a, _exact(a, own, sign)) for a, own in args), 1)
    signs = [_sign(a, sign) for a in args]
    bare = tuple((_bare(a), 1) for a, _ in args)
    if op != "add":
        result = signs[0] * (signs[1] if len(signs) > 1 else 1)
        return Single(slot, op, result, bare, 1)
    term = signs[0] * signs[1]
    if term < 0 and signs[1] == wanted.get(slot, 1):
        return Single(slot, op, signs[1], bare[::-1], term)
    return Single(slot, op, signs[0], bare, term)


def _exact(value: int | float, own: int, sign: Mapping[int, int]) -> int:
    """The sign by which what is known of an operand must be taken where it is needed with its own."""
    return own * sign.get(value, 1) if isinstance(value, int) else own


def _row(plan: Plan, number: int, stage: int, sign: Mapping[int, int], wanted: Mapping[int | float, int]) -> LimbRow:
    slots = tuple(slot for slot in plan.rows[number] if slot is not None)
    op, columns = plan.ops[number], [tuple(e for e in column if e is not None) for column in plan.columns[number]]
    signs = [tuple(_sign(e, sign) for e in column) for column in columns]
    operands = [tuple(_bare(a) for a, _ in column) for column in columns]
    sources = [plan.source(column) for column in plan.columns[number]]
    ones = (1,) * len(slots)
    if op == "sqrt":
        return LimbRow(number, op, slots, ones, tuple(operands), tuple(sources), signs[0], stage)
    if op != "add":
        result = tuple(a * b for a, b in zip(signs[0], signs[1] if len(signs) > 1 else ones, strict=True))
        return LimbRow(number, op, slots, result, tuple(operands), tuple(sources), ones, stage)
    terms = tuple(a * b for a, b in zip(*signs, strict=True))
    hoped = tuple(wanted.get(slot, 1) for slot in slots)
    if signs[0] != signs[1] and (signs[1] == hoped or (signs[0] != hoped and signs[1] == ones)):
        signs.reverse(), operands.reverse(), sources.reverse()
    return LimbRow(number, op, slots, signs[0], tuple(operands), tuple(sources), terms, stage)
