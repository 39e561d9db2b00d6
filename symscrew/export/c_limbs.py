"""What equal limbs do, written once: stages, functions of a limb.

    STAGE(<function>, 0)(limb, stride, inputs ..., what the hub gives, own)        own: what limbs hand on
    NEXT_LIMB(1, <function>, 0, stride, inputs ..., what the hub gives, &limbs);   limb is a number in every call

Stages are inlined, and limbs are numbers wherever one is called: entries of inputs, and signs that depend on the limb,
are constants to the compiler, what a limb hands on are values like others. `x + sign1 * y` is `x + y` of one limb and
`x - y` of another one: no operation. With limbs side by side in lanes (see `c_lanes`) the same text works on vectors,
and a stage is called once.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from symscrew.export.c_names import TAKEN, arguments, c_lines, declare, grouped
from symscrew.export.c_order import short_lived
from symscrew.export.c_printed import Printed
from symscrew.export.folding import ATOM, BINDING, PRODUCT, SUM, folded
from symscrew.export.listing import checked_slots, wrapped
from symscrew.export.stages import EACH, LaneStages, headed
from symscrew.export.value_names import ANONYMOUS, LONGEST
from symscrew.program import Instruction, LimbRow, LimbStages

MINUS = "minus_"
LIMBS = "limbs"  # the variable of what limbs hand on
WIDTH = 108  # characters of a line of members
Entries = tuple[int | float, ...]  # slots or numbers, one per limb
Stored = tuple[str, tuple[int, ...], tuple[int, ...]]  # array, entries, and signs, of what limbs write


@dataclass
class StageText:
    """A printed stage: the inputs that it reads, its parameters beside them with what they are, and its lines."""

    arrays: list[str] = field(default_factory=list)
    given: list[tuple[str, Entries]] = field(default_factory=list)
    lines: list[str] = field(default_factory=list)
    checked: bool = False


class LimbText:
    """A function whose equal limbs are written once: what its stages hold, and how it is printed."""

    def __init__(self, printed: Printed, staged: LimbStages) -> None:
        self.printed, self.staged, self.count = printed, staged, len(staged.limbs)
        self.function = printed.symbol.removeprefix(f"{printed.model}_")
        self.row_of = {slot: (row, k) for row in staged.rows for k, slot in enumerate(row.slots)}
        self.sign = {single.slot: single.sign for single in staged.singles}
        self.sign |= {slot: sign for row in staged.rows for slot, sign in zip(row.slots, row.signs, strict=True)}
        self.written, self.stored = self._stored()
        checked = dict.fromkeys(self.base(slot)[0] for slot in checked_slots(printed.program))
        self.checked_rows = {r.number for r in staged.rows if all(slot in checked for slot in r.slots)}
        there = {slot for row in staged.rows if row.number in self.checked_rows for slot in row.slots}
        self.checked = [slot for slot in checked if isinstance(slot, int) and slot not in there]
        self.crossing = self._crossing()
        constants = printed.shared.constants.names.values() if printed.shared else ()
        self.taken = {*TAKEN, *printed.names.values(), *constants, LIMBS, "limb", "own", "sine", "cosine"}
        self.members = self.named([r for r in staged.rows if r.number in self.crossing], Used({"checked"}))
        self.checked_before = False  # whether a stage before has begun the sum of what must be finite
        self.texts = [_Stage(self, rows).text for rows in staged.stages]
        self.last_check = max((n for n, text in enumerate(self.texts) if text.checked), default=-1)

    # -- what is where ----------------------------------------------------------------------------------------

    def base(self, slot: int | float) -> tuple[int | float, int]:
        """The slot or number that a slot is, and its sign."""
        return self.staged.negatives.get(slot, (slot, 1)) if isinstance(slot, int) else (slot, 1)

    def _stored(self) -> tuple[dict[int, list[Stored]], list[tuple[str, int, int | float]]]:
        """By row the results that its stage writes: array, entries, signs; and those that are written elsewhere."""
        at: dict[int, list[tuple[str, int, int, int]]] = {}
        rest: list[tuple[str, int, int | float]] = []
        for array, k, slot in self.printed.stored:
            base, sign = self.base(slot)
            if isinstance(base, int) and base in self.row_of and isinstance(slot, int):
                at.setdefault(base, []).append((array, k, sign * self.sign[base], slot))
            else:
                rest.append((array, k, slot))
        found: dict[int, list[Stored]] = {}
        for row in self.staged.rows:
            places = [at.get(slot, []) for slot in row.slots]
            if len({tuple(array for array, *_ in some) for some in places}) > 1:
                rest += [(array, k, slot) for some in places for array, k, _, slot in some]
                continue
            found[row.number] = [
                (some[0][0], tuple(k for _, k, *_ in some), tuple(sign for *_, sign, _ in some))
                for some in zip(*places, strict=True)
            ]
        return found, rest

    def _crossing(self) -> set[int]:
        """The rows that are read outside of their stage."""
        read: set[int | float] = {self.base(a)[0] for single in self.staged.singles for a, _ in single.operands}
        read |= {self.base(slot)[0] for *_, slot in self.stored}
        read |= {self.base(slot)[0] for slot in self.printed.program.tested} | set(self.checked)
        found: set[int] = set()
        stage = {row.number: row.stage for row in self.staged.rows}
        for row in self.staged.rows:
            for source, entries in zip(row.sources, row.operands, strict=True):
                if source is None:
                    read.update(self.base(a)[0] for a in entries)
                elif stage[source] != row.stage:
                    found.add(source)
        return found | {self.row_of[a][0].number for a in read if isinstance(a, int) and a in self.row_of}

    # -- names ------------------------------------------------------------------------------------------------

    def lane_name(self, entries: Entries, signs: Sequence[int]) -> str:
        """The name of what corresponds in every limb, the limb's left out; "" where none tells."""
        called, found = self.printed.called, []
        for k, (a, sign) in enumerate(zip(entries, signs, strict=True)):
            name = called.get(a, "") if isinstance(a, int) else ""
            bare = name.removeprefix(MINUS)
            if bare and not ANONYMOUS.fullmatch(bare):
                limb = self.staged.limbs[k].name
                short = bare.removeprefix(f"{limb}_").replace(f"_by_{limb}_", "_by_")
                short = short if short[0].isalpha() else f"limb_{short}"
                found.append((short if "_" in short else bare, (name != bare) ^ (sign < 0)))
        if not found:
            return ""
        name = Counter(name for name, _ in found).most_common(1)[0][0]
        negative = {negative for _, negative in found}
        name = (MINUS if negative == {True} else "signed_" if len(negative) > 1 else "") + name
        return name if len(name) <= LONGEST else ""

    def named(self, rows: Sequence[LimbRow], used: Used) -> dict[int, str]:
        """Names of rows by number, none of those that are used, which are more now."""
        return {row.number: used.new(self.lane_name(row.slots, row.signs)) for row in rows}

    # -- the text ---------------------------------------------------------------------------------------------

    @cached_property
    def hands_on(self) -> list[str]:
        """The members of what limbs hand on."""
        return [*self.members.values(), *(["checked"] if self.last_check >= 0 else [])]

    def head(self) -> list[str]:
        """The type of what limbs hand on, and the stages."""
        lines = []
        if self.hands_on:
            listed = wrapped(f"EACH{self.count} {', '.join(self.hands_on)};", first="    ", later="      ", width=WIDTH)
            lines += ["typedef struct {", *listed, f"}} LIMBS({self.function});", ""]
        for n, text in enumerate(self.texts):
            given = ["size_t limb", "size_t stride", *self._arguments(text.arrays)]
            given += [f"const EACH{self.count} {name}" if self.waits(e) else f"REAL {name}" for name, e in text.given]
            given += [f"LIMBS({self.function}) *own"] if self.hands_on else []
            lines += [declare(f"STAGE({self.function}, {n})", given, ""), "{", *text.lines, "}", ""]
        return lines

    def waits(self, entries: Entries) -> bool:
        """Whether what the hub gives is one value per limb, all of them at once: where lanes have the same text."""
        return self.staged.lanes and not same(entries)

    def _arguments(self, arrays: Sequence[str]) -> list[str]:
        """Declared arguments of these names."""
        precision = self.printed.precision
        known = arguments(self.printed.program, precision)
        known += [f"const {precision.real} *restrict {name}" for name in ("sine", "cosine")]
        return [text for text in known if text.split()[-1].lstrip("*") in arrays]

    def handed(self, stage: int) -> list[str]:
        """The arguments of a call but for what the hub gives, which comes before the last one."""
        names = [text.split()[-1].lstrip("*") for text in self._arguments(self.texts[stage].arrays)]
        return ["stride", *names]


def same(entries: Entries) -> bool:
    """Whether something is the same in all limbs."""
    return len(set(map(repr, entries))) == 1


class Used:
    """Names that are used."""

    def __init__(self, names: Iterable[str]) -> None:
        self.names = set(names)
        self.next: dict[str, int] = {}  # by name, the number from which on some are free

    def new(self, name: str) -> str:
        """A name that is not used yet, t1, t2 ... where there is none; it is used from here on."""
        number, used = self.next.get(name, 1), self.names
        while (found := (name if number == 1 else f"{name}_{number}") if name else f"t{number}") in used:
            number += 1
        self.next[name] = number + 1
        used.add(found)
        return found


class _Stage:
    """A stage while it is printed."""

    def __init__(self, whole: LimbText, rows: Sequence[LimbRow]) -> None:
        self.whole, self.rows, self.count, self.text = whole, rows, whole.count, StageText()
        self.ids = {row.number: -1 - n for n, row in enumerate(rows)}
        self.row_of = {self.ids[row.number]: row for row in rows}
        self.used = Used({*whole.taken, "checked"})
        self.names: dict[int, str] = {}
        self.leaves: dict[int, str] = {}  # what is there from the start: its text, and whether it is a limb's own
        self.own: set[int] = set()
        self.known: dict[tuple[object, ...], int | float] = {}
        self.signs: dict[tuple[int, ...], str] = {}
        self.constants: list[str] = []
        self.table, self.binding = dict(whole.printed.precision.body_table), dict(BINDING)
        self.table["sqrt"] = f"SQRT{self.count}({{0}})"
        self.order: list[Instruction] = []
        local = whole.named([row for row in rows if row.number not in whole.crossing], self.used)
        for row in rows:
            crossing = row.number in whole.crossing
            self.names[self.ids[row.number]] = self._member(row.number) if crossing else local[row.number]
        for row in rows:
            self._operation(row)
        self._print()

    def _member(self, row: int) -> str:
        return f"OWN({self.whole.members[row]})"

    def _new(self, name: str) -> int:
        found = -1 - len(self.names)
        self.names[found] = name
        return found

    def _name(self, value: int | float) -> str:
        return self.names[value] if isinstance(value, int) else self.whole.printed.number(value)

    # -- operands ---------------------------------------------------------------------------------------------

    def _operation(self, row: LimbRow) -> None:
        """A row as an instruction on what it reads."""
        args = [self._operand(row, n) for n in range(len(row.operands))]
        if all(not isinstance(a, int) or a not in self.own for a in args):  # one must differ by limb, to be a vector
            args[0] = self._given(row.operands[0], "")
        self.order.append(Instruction(self.ids[row.number], row.op, tuple(args)))

    def _operand(self, row: LimbRow, n: int) -> int | float:
        source, entries, flips = row.sources[n], row.operands[n], row.flips[n]
        if source in self.ids:
            found: int | float = self.ids[source]
        elif source is not None:
            found = self._once(("row", source), lambda: self._new(self._member(source)))
        else:
            found = self._once(("entries", *entries), lambda: self._gathered(entries))
        if isinstance(found, int) and (source is not None):
            self.own.add(found)
        if flips is None:
            return found
        return self._once(("flipped", found, flips), lambda: self._flipped(found, flips))

    def _once(self, key: tuple[object, ...], make: Callable[[], int | float]) -> int | float:
        text = tuple(map(repr, key))
        if text not in self.known:
            self.known[text] = make()
        return self.known[text]

    def _flipped(self, found: int | float, flips: tuple[int, ...]) -> int:
        """A value times signs."""
        op = f"times {flips}"
        text, sum_ = self._times(flips, "{0}"), flips == (-1,) * self.count
        self.table[op], self.binding[op] = text, ((ATOM,), SUM if sum_ else PRODUCT)
        target = self._new(self.used.new(""))
        self.own.add(target)
        self.order.append(Instruction(target, op, (found,)))
        return target

    def _times(self, signs: tuple[int, ...], text: str) -> str:
        """A text times signs; what all limbs share of them stands in front."""
        minus = "-" if signs[0] < 0 else ""
        pattern = tuple(s * signs[0] for s in signs)
        if len(set(pattern)) == 1:
            return f"{minus}{text}"
        if pattern not in self.signs:
            number = self.whole.printed.precision.number
            self.signs[pattern] = name = self.used.new(f"sign{len(self.signs) + 1}")
            self._constant(name, [number(float(s)).strip("()") for s in pattern])
        return f"{minus}{self.signs[pattern]} * {text}"

    def _constant(self, name: str, values: Sequence[str]) -> None:
        self.constants.append(f"const NUMBER{self.count} {name} = OF{self.count}({', '.join(values)});")

    def _gathered(self, entries: Entries) -> int | float:
        """An input's entry, a number, or what the hub gives."""
        whole = self.whole
        numbers = [a for a in entries if isinstance(a, float)]
        if len(numbers) == len(entries):
            if same(entries):
                return numbers[0]
            texts = [whole.printed.number(a) for a in numbers]
            stem = re.sub(r"_\d+$", "", texts[0].strip("(-)"))
            name = self.used.new(f"each_{stem}" if stem[0].isalpha() else "factor")
            sizes = tuple(abs(a) for a in numbers)
            if same(sizes):  # by a name for it and one for the signs, which others have, too
                size = whole.printed.number(sizes[0])
                text = self._times(tuple(-1 if a < 0 else 1 for a in numbers), size)
                if sizes[0] == 1.0:  # the signs themselves
                    text = text.removesuffix(f" * {size}")
                if text in self.signs.values():
                    name = text
                else:
                    self.constants.append(f"const NUMBER{self.count} {name} = {text};")
            else:
                self._constant(name, [text.strip("()") for text in texts])
            found = self._new(name)
            self.own.add(found)
            return found
        slots = [a for a in entries if isinstance(a, int)]
        name = whole.lane_name(entries, (1,) * len(entries))
        if numbers or any(a not in whole.printed.entries for a in slots):
            return self._given(entries, name)
        found = self._new(self.used.new(name))
        places = [whole.printed.entries[a] for a in slots]
        self.text.arrays += [a for a in dict.fromkeys(array for array, _ in places) if a not in self.text.arrays]
        texts = [f"{_reader(array)}({array}, {k})" for array, k in places]
        step = places[1][1] - places[0][1]
        if same(entries):
            self.leaves[found] = texts[0]
            return found
        self.own.add(found)
        if [(places[0][0], places[0][1] + step * n) for n in range(self.count)] == places and step > 0:
            array, first = places[0]
            self.leaves[found] = f"IN_EACH{self.count}({_reader(array)}, {array}, {first}, {step})"
        else:
            self.leaves[found] = f"OF{self.count}({', '.join(texts)})"
        return found

    def _given(self, entries: Entries, name: str) -> int:
        """A parameter."""
        name = self.used.new(name or "given")
        self.text.given.append((name, entries))
        if same(entries):
            return self._new(name)
        found = self._new(f"GIVEN({name})" if self.whole.waits(entries) else name)
        self.own.add(found)
        return found

    # -- statements -------------------------------------------------------------------------------------------

    def _print(self) -> None:
        whole, order = self.whole, short_lived(self.order)
        uses = Counter(a for i in order for a in i.args if isinstance(a, int))
        read = set(uses)
        for target, member in self.row_of.items():
            uses[target] += 2 * (member.number in whole.crossing) + (member.number in whole.checked_rows)
            uses[target] += len(whole.written.get(member.number, ()))
        self.lines: list[tuple[str, int | None]] = []
        kind = f"LIMB{self.count}"
        found = folded(
            order, uses, self.table, name=self._name, places=self.leaves, binding=self.binding,
            ends=lambda slot: slot not in read,
        )  # fmt: skip
        for item in found:
            row = self.row_of.get(item.slot)
            slot = item.slot if row else None
            name, text = self.names[item.slot], item.text or self.leaves.get(item.slot, "")
            if item.kind == "last":
                name = text
            elif row is not None and row.number in whole.crossing:
                self.lines.append((f"{name} = {text};", slot))
            else:
                self.lines.append((f"const {kind if item.slot in self.own or row else 'REAL'} {name} = {text};", slot))
            if row is not None:
                self._known(row, name, item.kind == "last")
        heads = LaneStages(whole.printed.stages, {t: row.slots[0] for t, row in self.row_of.items()}, (), EACH)
        if self.text.checked:
            self.lines.append(("OWN(checked) = checked;", None))
        told = grouped([*self.constants, *headed(self.lines, heads, lambda slot: "")])
        self.text.lines = ["    (void)limb, (void)stride;", *c_lines(told)]

    def _known(self, row: LimbRow, text: str, loose: bool) -> None:
        """A value goes to its places, and into the sum of what must be finite."""
        slot, count = self.ids[row.number], self.count
        for array, places, signs in self.whole.written.get(row.number, ()):
            if array not in self.text.arrays:
                self.text.arrays.append(array)
            value = text if set(signs) == {1} else self._times(signs, f"({text})" if loose else text)
            at = ", ".join(map(str, places))
            self.lines.append((f"WRITE{count}({array}, {at}, {value});", slot))
        if row.number in self.whole.checked_rows:
            before = "" if self.text.checked else f"LIMB{count} "
            start = "checked" if self.text.checked else "OWN(checked)" if self.whole.checked_before else ""
            value = f"({text})" if loose and start and " " in text else text
            self.lines.append((f"{before}checked = {f'{start} + ' if start else ''}{value};", slot))
            self.text.checked = self.whole.checked_before = True


def _reader(array: str) -> str:
    return "SINES" if array in ("sine", "cosine") else "READ"
