"""What equal limbs do, written once: functions of a limb, called one limb after the other.

    STAGE(<symbol>_limbs0)(limb, inputs ..., what the hub gives, &limb1)      limb is a number in every call

`limb` is a literal wherever a stage is called, and stages are inlined: entries of inputs and signs that depend on it are
constants to the compiler, and what a limb hands on (`<symbol>_limb`) are values like others. Signs multiply the second
term of a sum, and are no operations: `a + sign1 * b` is `a + b` of one limb and `a - b` of another one.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from symscrew.export.c_names import TAKEN, arguments, declare, grouped
from symscrew.export.c_order import short_lived
from symscrew.export.c_printed import Printed
from symscrew.export.folding import ATOM, BINDING, LOOSE, PRODUCT, SUM, folded
from symscrew.export.listing import checked_slots
from symscrew.export.stages import TOGETHER, Stage, headed
from symscrew.export.value_names import ANONYMOUS
from symscrew.program import Instruction
from symscrew.program.lanes.limb_stages import LimbRow, LimbStages, Single

CALL = "call"
MINUS = "minus_"


@dataclass(frozen=True)
class Call:
    """The call of a stage for one limb."""

    target: int
    stage: int
    limb: int


@dataclass
class StageText:
    """A printed stage: its parameters beside the inputs, each with what the calls give, and its lines."""

    arrays: list[str] = field(default_factory=list)
    given: list[tuple[str, tuple[int | float, ...]]] = field(default_factory=list)
    lines: list[str] = field(default_factory=list)
    checked: bool = False


class LimbText:
    """A function whose equal limbs are written once, while it is printed."""

    def __init__(self, printed: Printed, staged: LimbStages) -> None:
        self.printed, self.staged = printed, staged
        self.count = len(staged.limbs)
        self.row_of = {slot: (row, k) for row in staged.rows for k, slot in enumerate(row.slots)}
        self.sign = {single.slot: single.sign for single in staged.singles}
        self.sign |= {slot: sign for row in staged.rows for slot, sign in zip(row.slots, row.signs, strict=True)}
        self.entries = printed.entries
        self.free = max([*self.row_of, *self.sign, *printed.called, 0]) + 1
        self.stored_in_stage: dict[int, list[tuple[str, tuple[int, ...], tuple[int, ...]]]] = {}
        self.stored: list[tuple[str, int, int | float]] = []
        self._store()
        checked = dict.fromkeys(self.base(slot)[0] for slot in checked_slots(printed.program))
        self.checked_rows = {r.number for r in staged.rows if all(slot in checked for slot in r.slots)}
        self.checked = [s for s in checked if s not in self.row_of or self.row_of[s][0].number not in self.checked_rows]
        self.crossing = self._crossing()
        constants = printed.shared.constants.names.values() if printed.shared else ()
        taken = {*TAKEN, *printed.names.values(), *constants, "limb", "sine", "cosine", "stride"}
        self.variables = [self._unique(limb.name, taken) for limb in staged.limbs]
        self.taken = {*taken, *self.variables}
        self.members = self._named_rows([r for r in staged.rows if r.number in self.crossing], set(taken) | {"checked"})
        self.calls = {}
        for stage in range(len(staged.stages)):
            for k in range(self.count):
                self.calls[stage, k] = Call(self.free, stage, k)
                self.free += 1
        self.texts = [self._stage(n, rows) for n, rows in enumerate(staged.stages)]

    # -- what is where ----------------------------------------------------------------------------------------

    def base(self, slot: int) -> tuple[int | float, int]:
        """The slot or number that a slot is, and its sign."""
        return self.staged.negatives.get(slot, (slot, 1))

    def _store(self) -> None:
        """Results that stages write, and the others."""
        at: dict[int, list[tuple[str, int, int]]] = {}
        for array, k, slot in self.printed.stored:
            base, sign = self.base(slot) if isinstance(slot, int) else (slot, 1)
            if isinstance(base, int) and base in self.row_of:
                at.setdefault(base, []).append((array, k, sign * self.sign[base]))
            else:
                self.stored.append((array, k, slot))
        for row in self.staged.rows:
            places = [at.get(slot, []) for slot in row.slots]
            if not any(places):
                continue
            arrays = {tuple(array for array, _, _ in some) for some in places}
            if len(arrays) == 1:
                self.stored_in_stage[row.number] = [
                    (some[0][0], tuple(k for _, k, _ in some), tuple(sign for _, _, sign in some))
                    for some in zip(*places, strict=True)
                ]
            else:
                exact = {(a, k): s for a, k, s in self.printed.stored}
                self.stored += [(array, k, exact[array, k]) for some in places for array, k, _ in some]

    def _crossing(self) -> set[int]:
        """The rows that are read outside of their stage."""
        read: set[int | float] = {a for single in self.staged.singles for a, _ in single.operands}
        read |= {self.base(slot)[0] for _, _, slot in self.stored if isinstance(slot, int)}
        read |= {self.base(slot)[0] for slot in self.printed.program.tested} | set(self.checked)
        found: set[int] = set()
        stage = {row.number: row.stage for row in self.staged.rows}
        for row in self.staged.rows:
            for source, entries in zip(row.sources, row.operands, strict=True):
                if source is None:
                    read.update(entries)
                elif stage[source] != row.stage:
                    found.add(source)
        return found | {self.row_of[a][0].number for a in read if isinstance(a, int) and a in self.row_of}

    # -- names ------------------------------------------------------------------------------------------------

    @staticmethod
    def _unique(name: str, used: set[str]) -> str:
        found, number = name, 2
        while found in used:
            found, number = f"{name}_{number}", number + 1
        used.add(found)
        return found

    def lane_name(self, entries: Sequence[int | float], signs: Sequence[int]) -> str:
        """The name of what corresponds in every limb; "" where none tells."""
        called, found = self.printed.called, []
        for k, (a, sign) in enumerate(zip(entries, signs, strict=True)):
            if not isinstance(a, int) or a not in called:
                continue
            name, negative = called[a].removeprefix(MINUS), called[a].startswith(MINUS) ^ (sign < 0)
            if not ANONYMOUS.fullmatch(name):
                limb = self.staged.limbs[k].name
                name = name.removeprefix(f"{limb}_").replace(f"_by_{limb}_", "_by_")
                found.append((name, negative))
        if not found:
            return ""
        name = Counter(name for name, _ in found).most_common(1)[0][0]
        negative = {negative for _, negative in found}
        name = name if "_" in name and not name[0].isdigit() else f"own_{name}"
        return (MINUS if negative == {True} else "signed_" if len(negative) > 1 else "") + name

    def _named_rows(self, rows: Sequence[LimbRow], used: set[str]) -> dict[int, str]:
        found: dict[int, str] = {}
        anonymous = 0
        for row in rows:
            name = self.lane_name(row.slots, row.signs)
            while not name:
                anonymous += 1
                name = f"t{anonymous}" if f"t{anonymous}" not in used else ""
            found[row.number] = self._unique(name, used)
        return found

    # -- a stage ----------------------------------------------------------------------------------------------

    def of(self, values: Sequence[str]) -> str:
        """A text that depends on the limb."""
        return values[0] if len(set(values)) == 1 else f"OF{self.count}(limb, {', '.join(values)})"

    def index(self, places: Sequence[int]) -> str:
        """The entry of an array, by the limb."""
        first, step = places[0], places[1] - places[0]
        if step == 0 and len(set(places)) == 1:
            return str(first)
        if step > 0 and all(place == first + step * k for k, place in enumerate(places)):
            by = "limb" if step == 1 else f"{step} * limb"
            return by if first == 0 else f"{first} + {by}"
        return self.of([f"{place}u" for place in places])

    def _leaf(self, slot: int, place: str | None = None) -> str:
        array, k = self.entries[slot]
        macro = "SINES" if array in ("sine", "cosine") else "READ"
        return f"{macro}({array}, {k if place is None else place})"

    def _stage(self, number: int, rows: Sequence[LimbRow]) -> StageText:
        return _Stage(self, number, rows).text

    # -- the whole --------------------------------------------------------------------------------------------

    def head(self) -> list[str]:
        """The type of what a limb hands on, and the stages."""
        symbol = self.printed.symbol
        lines = []
        members = [*self.members.values(), *(["checked"] if any(t.checked for t in self.texts) else [])]
        if members:
            listed = declare("REAL ", members, "", width=104).removeprefix("REAL (").removesuffix(")")
            lines += ["typedef struct {", f"    REAL {listed};", f"}} LIMB({symbol});", ""]
        for n, text in enumerate(self.texts):
            given = ["size_t limb", "size_t stride", *self._array_arguments(text.arrays)]
            given += [f"REAL {name}" for name, _ in text.given]
            given += [f"LIMB({symbol}) *own"] if members else []
            lines += [declare(f"STAGE({symbol}, {n})", given, ""), "{", *(f"    {line}" for line in text.lines), "}", ""]
        return lines

    def _array_arguments(self, arrays: Sequence[str]) -> list[str]:
        real = self.printed.precision.real
        known = arguments(self.printed.program, self.printed.precision)
        known += [f"const {real} *restrict {name}" for name in ("sine", "cosine")]
        return [text for text in known if text.rpartition("*")[2].removeprefix("restrict ") in arrays]

    def call_text(self, call: Call) -> tuple[str, tuple[int | float, ...]]:
        """The call as a format, and the operands that it is given."""
        text = self.texts[call.stage]
        arrays = [name.rpartition("*")[2].removeprefix("restrict ") for name in self._array_arguments(text.arrays)]
        values = tuple(entries[call.limb] for _, entries in text.given)
        number = self.printed.number
        given = [str(call.limb), "stride", *arrays]
        given += [f"{{{n}}}" if isinstance(a, int) else f"CONSTANT({number(a)})" for n, a in enumerate(values)]
        given += [f"&{self.variables[call.limb]}"] if self.members or any(t.checked for t in self.texts) else []
        return f"STAGE_OF({self.printed.symbol}, {call.stage})({', '.join(given)})", values


class _Stage:
    """A stage while it is printed."""

    def __init__(self, whole: LimbText, number: int, rows: Sequence[LimbRow]) -> None:
        self.whole, self.number, self.rows = whole, number, rows
        self.text = StageText()
        self.ids = {row.number: -1 - n for n, row in enumerate(rows)}
        self.free = -1 - len(rows)
        self.used = set(whole.taken) | {"checked", "own"}
        self.names: dict[int, str] = {}
        self.leaves: dict[int, str] = {}
        self.columns: dict[tuple[int | float, ...], int | float] = {}
        self.signs: dict[tuple[int, ...], str] = {}
        self.table = dict(whole.printed.precision.body_table)
        self.binding = dict(BINDING)
        local = whole._named_rows([r for r in rows if r.number not in whole.crossing], self.used)
        for row in rows:
            crossing = row.number in whole.crossing
            self.names[self.ids[row.number]] = f"own->{whole.members[row.number]}" if crossing else local[row.number]
        self._print()

    def _new(self, name: str) -> int:
        found, self.free = self.free, self.free - 1
        self.names[found] = name
        return found

    def name(self, value: int | float) -> str:
        return self.names[value] if isinstance(value, int) else self.whole.printed.number(value)

    def _operand(self, row: LimbRow, n: int) -> int | float:
        source, entries = row.sources[n], row.operands[n]
        if source is not None:
            if source in self.ids:
                return self.ids[source]
            key: tuple[int | float, ...] = (source,)
            if key not in self.columns:
                self.columns[key] = self._new(f"own->{self.whole.members[source]}")
            return self.columns[key]
        if entries not in self.columns:
            self.columns[entries] = self._gathered(entries)
        return self.columns[entries]

    def _gathered(self, entries: tuple[int | float, ...]) -> int | float:
        """An input's entry, a number, or a parameter."""
        whole = self.whole
        if all(isinstance(a, float) for a in entries):
            if len(set(entries)) == 1:
                return entries[0]
            found = self._new("")
            self.leaves[found] = whole.of([whole.printed.number(a) for a in entries])
            self.names[found] = LimbText._unique("of_the_limb", self.used)
            return found
        name = whole.lane_name(entries, (1,) * len(entries))
        name = LimbText._unique(name, self.used) if name else LimbText._unique("given", self.used)
        found = self._new(name)
        if all(isinstance(a, int) and a in whole.entries for a in entries):
            slots = [a for a in entries if isinstance(a, int)]
            arrays = [whole.entries[a][0] for a in slots]
            self.text.arrays += [array for array in dict.fromkeys(arrays) if array not in self.text.arrays]
            if len(set(arrays)) == 1:
                self.leaves[found] = whole._leaf(slots[0], whole.index([whole.entries[a][1] for a in slots]))
            else:
                self.leaves[found] = whole.of([whole._leaf(a) for a in slots])
            return found
        self.text.given.append((name, entries))
        return found

    def _times(self, signs: tuple[int, ...]) -> tuple[str, int]:
        """The name of signs, up to the last factor."""
        first = signs[0]
        pattern = tuple(s * first for s in signs)
        if pattern not in self.signs:
            self.signs[pattern] = LimbText._unique(f"sign{len(self.signs) + 1}", self.used)
        return self.signs[pattern], first

    def _print(self) -> None:
        whole = self.whole
        instructions = []
        for row in self.rows:
            args = tuple(self._operand(row, n) for n in range(len(row.operands)))
            op = row.op
            if op in ("add", "sqrt") and len(set(row.terms)) > 1:
                sign, first = self._times(row.terms)
                op = f"{op} {'-' if first < 0 else '+'} {sign}"
                if row.op == "add":
                    self.table[op] = f"{{0}} {'-' if first < 0 else '+'} {sign} * {{1}}"
                    self.binding[op] = ((SUM, ATOM), SUM)
                else:
                    self.table[op] = self.table["sqrt"].format(f"{'-' if first < 0 else ''}{sign} * {{0}}")
                    self.binding[op] = ((ATOM,), ATOM)
            elif op == "add" and row.terms[0] < 0:
                op = "sub"
            elif op == "sqrt" and row.terms[0] < 0:
                op = "root of minus"
                self.table[op] = self.table["sqrt"].format("-{0}")
                self.binding[op] = ((ATOM,), ATOM)
            instructions.append(Instruction(self.ids[row.number], op, args))
        order = short_lived(instructions)
        row_of = {self.ids[row.number]: row for row in self.rows}
        uses = Counter(a for i in order for a in i.args if isinstance(a, int))
        read = set(uses)
        for row in self.rows:
            me = self.ids[row.number]
            uses[me] += 2 * (row.number in whole.crossing) + len(whole.stored_in_stage.get(row.number, ()))
            uses[me] += row.number in whole.checked_rows
        written: list[tuple[str, int | None]] = []

        def served(target: int) -> int | None:
            row = row_of.get(target)
            return None if row is None else row.slots[0]

        def ready(row: LimbRow, text: str) -> None:
            slot = row.slots[0]
            for array, places, signs in whole.stored_in_stage.get(row.number, ()):
                if array not in self.text.arrays:
                    self.text.arrays.append(array)
                value = text
                if len(set(signs)) > 1:
                    sign, first = self._times(signs)
                    value = f"{'-' if first < 0 else ''}{sign} * {self._atom(text)}"
                elif signs[0] < 0:
                    value = f"-{self._atom(text)}"
                written.append((f"WRITE({array}, {whole.index(places)}, {value});", slot))
            if row.number in whole.checked_rows:
                if self.text.checked:
                    written.append((f"checked = checked + {self._product(text)};", slot))
                else:
                    written.append((f"REAL checked = {text};", slot))
                self.text.checked = True

        for item in folded(
            order, uses, self.table, name=self.name, places=self.leaves, binding=self.binding,
            ends=lambda slot: slot not in read and slot in row_of and row_of[slot].number not in whole.crossing,
        ):  # fmt: skip
            if item.kind == "read":
                written.append((f"const REAL {self.names[item.slot]} = {self.leaves[item.slot]};", None))
            elif item.kind == "last":
                ready(row_of[item.slot], item.text)
            else:
                name = self.names[item.slot]
                head = "" if name.startswith("own->") else "const REAL "
                written.append((f"{head}{name} = {item.text};", served(item.slot)))
                ready(row_of[item.slot], name)
        if self.text.checked:
            written.append(("own->checked = checked;", None))
        real = whole.printed.precision.real
        one, minus = (whole.printed.precision.number(x) for x in (1.0, -1.0))
        signs = [
            f"const {real} {name} = {whole.of([one if s > 0 else minus[1:-1] for s in pattern])};"
            for pattern, name in self.signs.items()
        ]
        self.text.lines = ["(void)limb, (void)stride;", *signs, *grouped(headed(written, _Heads(whole), self.name_of_slot))]

    def name_of_slot(self, slot: int) -> str:
        return "x"

    @staticmethod
    def _atom(text: str) -> str:
        return text if re.fullmatch(r"(own->)?\w+", text) else f"({text})"

    @staticmethod
    def _product(text: str) -> str:
        return text if " " not in text else f"({text})"


class _Heads:
    """The stages of the theory that rows are of."""

    def __init__(self, whole: LimbText) -> None:
        self.single = whole.printed.stages

    def of(self, slot: int) -> Stage | None:
        """That of a row, by the slot of its first limb."""
        stage = self.single.of(slot)
        return Stage(TOGETHER, stage.text, TOGETHER) if stage is not None else None


@dataclass(frozen=True)
class Hub:
    """What is done for no limb alone, between calls of stages; `members` are the values that a call hands on."""

    order: list[Instruction]
    called: Mapping[int, str]
    table: Mapping[str, str]
    stored: list[tuple[str, int, int | float]]
    checked: list[int]
    tested: Mapping[int, int]
    members: Mapping[int, list[int]]
    sums: Mapping[int, str]
    read: Counter[int]


def hub(whole: LimbText) -> Hub:
    """The rest of a function whose equal limbs are in stages."""
    staged, printed = whole.staged, whole.printed
    called = _called(whole)
    table = dict(printed.precision.body_table)
    made: dict[int, Instruction] = {}
    negative: dict[int, int] = {}

    def exact(slot: int | float, sign: int = 1) -> int | float:
        base, own = whole.base(slot) if isinstance(slot, int) else (slot, 1)
        sign *= own
        if not isinstance(base, int):
            return sign * base
        if sign * whole.sign.get(base, 1) > 0:
            return base
        if base not in negative:
            negative[base] = new = whole.free
            whole.free += 1
            made[new] = Instruction(new, "neg", (base,))
            name = printed.called[slot] if isinstance(slot, int) and slot in printed.called else f"exact_{new}"
            called[new] = LimbText._unique(name, whole.used)
        return negative[base]

    def instruction(single: Single) -> Instruction:
        if single.op in ("add", "mul", "div", "reciprocal"):
            op = "sub" if single.op == "add" and single.term < 0 else single.op
            return Instruction(single.slot, op, tuple(a for a, _ in single.operands))
        return Instruction(single.slot, single.op, tuple(exact(a, _plain(whole, a) * s) for a, s in single.operands))

    for single in staged.singles:
        made[single.slot] = instruction(single)
    stored = [(array, k, exact(slot)) for array, k, slot in whole.stored]
    limited = {slot for slot, *_ in printed.program.limits}
    tested = {}
    for slot in printed.program.tested:
        found = exact(slot) if slot in limited else whole.base(slot)[0]
        assert isinstance(found, int)
        tested[slot] = found
    stage = {row.number: row.stage for row in staged.rows}
    proxies = [_proxy(whole, i) for i in made.values()]
    for call in whole.calls.values():
        text, values = whole.call_text(call)
        table[f"{CALL} {call.stage} {call.limb}"] = text
        made[call.target] = Instruction(call.target, f"{CALL} {call.stage} {call.limb}", values)
        before = {stage[s] for row in staged.stages[call.stage] for s in row.sources if s is not None} - {call.stage}
        earlier = tuple(whole.calls[n, call.limb].target for n in sorted(before))
        proxies.append(_proxy(whole, Instruction(call.target, CALL, (*values, *earlier))))
    proxies = _sorted(proxies)
    order = [made[i.target] for i in short_lived(proxies)]
    members = {
        call.target: [r.slots[call.limb] for r in staged.stages[call.stage] if r.number in whole.crossing]
        for call in whole.calls.values()
    }
    sums = {
        call.target: f"{whole.variables[call.limb]}.checked"
        for call in whole.calls.values()
        if whole.texts[call.stage].checked
    }
    read = Counter(
        a for row in staged.rows for e in row.operands for a in e if isinstance(a, int) and a in whole.entries
    )
    return Hub(order, called, table, stored, list(whole.checked), tested, members, sums, read)


def _plain(whole: LimbText, a: int | float) -> int:
    """A sign that `exact` takes twice."""
    return whole.sign.get(a, 1) if isinstance(a, int) else 1


def _called(whole: LimbText) -> dict[int, str]:
    printed, staged = whole.printed, whole.staged
    found: dict[int, str] = {}
    whole.used = set(whole.taken)
    for slot in [*whole.entries, *(single.slot for single in staged.singles)]:
        name = printed.called[slot]
        if whole.sign.get(slot, 1) < 0 and not ANONYMOUS.fullmatch(name):
            name = name.removeprefix(MINUS) if name.startswith(MINUS) else f"{MINUS}{name}"
        found[slot] = LimbText._unique(name, whole.used)
    for row in staged.rows:
        if row.number in whole.crossing:
            for k, slot in enumerate(row.slots):
                found[slot] = f"{whole.variables[k]}.{whole.members[row.number]}"
    return found


def _proxy(whole: LimbText, instruction: Instruction) -> Instruction:
    """An instruction that waits for calls in place of what they hand on."""
    args: list[int | float] = []
    for a in instruction.args:
        if isinstance(a, int) and a in whole.row_of:
            row, k = whole.row_of[a]
            args.append(whole.calls[row.stage, k].target)
        else:
            args.append(a)
    return Instruction(instruction.target, instruction.op, tuple(args))


def _sorted(proxies: Sequence[Instruction]) -> list[Instruction]:
    """In an order of evaluation."""
    by = {i.target: i for i in proxies}
    done: dict[int, Instruction] = {}

    for root in sorted(by):
        stack = [root]
        while stack:
            target = stack[-1]
            if target in done:
                stack.pop()
                continue
            left = [a for a in by[target].args if isinstance(a, int) and a in by and a not in done]
            if left:
                stack += left
            else:
                done[target] = by[target]
                stack.pop()
    return list(done.values())
