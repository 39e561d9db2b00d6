"""Equal limbs in vector lanes: the packed form of a function of one state, in C with vector types.

Where every lane is a limb it is the text of the function's body (see `c_limbs`), read with other macros; what is here
is for six limbs in vectors of four, and for limbs that lie differently.

`<symbol>_packed_lane` computes what `<symbol>_lane` computes of one state, with packs (see `symscrew.program.lanes`) as
vectors of GCC and clang. It stands behind the condition of `condition`; elsewhere, and if `<MODEL>_SCALAR` or
`<MODEL>_LIMB_BY_LIMB` is defined, `<symbol>_limb_by_limb` does the same one by one. So it does for a state that fails:
what is checked is one sum here, NaN at a small pivot, and which status that is, is found out there. No vector type
crosses a function's boundary but that of the square root, which is inlined.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence

from symscrew.export import c_unread
from symscrew.export.c_order import short_lived
from symscrew.export.c_precision import Precision
from symscrew.export.c_printed import Printed, place
from symscrew.export.folding import ATOM, BINDING, LOOSE, PRODUCT, SUM, folded
from symscrew.export.lane_names import LaneNames
from symscrew.export.listing import balanced_sum, checked_slots
from symscrew.export.stages import LaneStages, headed
from symscrew.program import Instruction, Pack, Packing, Vector


def condition(model: str, width: int, precision: Precision) -> str:
    """The condition of the preprocessor for packs of this width."""
    unit = "__AVX512F__" if width * precision.size > 32 else "__AVX2__"
    upper = model.upper()
    return f"defined(__GNUC__) && defined({unit}) && !defined({upper}_SCALAR) && !defined({upper}_LIMB_BY_LIMB)"


def prologue(model: str, packings: Iterable[Packing], precision: Precision) -> list[str]:
    """The vector types of some packed functions, and the square roots that they take."""
    roots: dict[int, bool] = {}
    for packing in packings:
        rooted = any(isinstance(item, Pack) and item.op == "sqrt" for item in packing.items)
        roots[packing.width] = rooted or roots.get(packing.width, False)
    return [line for width in sorted(roots) for line in _type(model, width, precision, root=roots[width])]


def _type(model: str, width: int, precision: Precision, *, root: bool) -> list[str]:
    name = f"{model}_vector{width}"
    lines = [
        "",
        f"#if {condition(model, width, precision)}",
        f"typedef {precision.real} {name} __attribute__((vector_size({width * precision.size})));",
        f"typedef {precision.integer} {name}_mask __attribute__((vector_size({width * precision.size})));",
    ]
    if root:
        lines += precision.vector_root(name, width)
    lines += [
        f"{model.upper()}_UNUSED static inline {precision.real} {name}_sum({name} x)",
        "{",
        f"    return {balanced_sum([f'x[{k}]' for k in range(width)])};",
        "}",
    ]
    return [*lines, "#endif"]


def in_order(packing: Packing) -> list[int | Pack]:
    """The items of a packing in an order that suits registers."""
    targets = [_targets(item) for item in packing.items]
    known = {slot: k for k, slots in enumerate(targets) for slot in slots}

    def proxy(k: int, slots: Sequence[int]) -> Instruction:
        given = (a for s in slots for a, _ in packing.operations[s].args if isinstance(a, int))  # 2.0 is not slot 2
        read = dict.fromkeys(known[a] for a in given if a in known)
        return Instruction(k, packing.operations[slots[0]].op, tuple(read))

    proxies = [proxy(k, slots) for k, slots in enumerate(targets)]
    return [packing.items[i.target] for i in short_lived(proxies)]


def _targets(item: int | Pack) -> list[int]:
    return [t for t in item.targets if t is not None] if isinstance(item, Pack) else [item]


def statements(printed: Printed, packing: Packing) -> list[str]:
    """The statements of a packed function: results go to their places as soon as they are known; then the sum."""
    body = _Body(printed, packing)
    return [
        f"typedef {printed.model}_vector{packing.width} {body.type};",
        *headed(body.lines(), LaneStages(printed.stages, body.numbers, printed.entries), body.name),
        *body.end,
    ]


class _Body:
    """A packed function while it is written.

    Its operations are instructions: those of the program on single slots, and others whose targets are negative
    numbers: packs, vectors that are put together of single values (`gather`), and vectors times signs (`signs`).
    `lane k` takes a single value out of a pack.
    """

    def __init__(self, printed: Printed, packing: Packing) -> None:
        self.printed, self.packing, self.type = printed, packing, f"lanes{packing.width}"
        real, one = printed.precision.table, printed.precision.number(1.0)
        self.table = {
            **real,
            "reciprocal": f"{one} / {{0}}",
            "root": f"{printed.model}_vector{packing.width}_sqrt({{0}})",
        }
        self.binding = dict(BINDING)
        for op, operands in (("less", 2), ("select", 3)):
            self.table[op] = f"({real[op]})"
            self.binding[op] = ((ATOM,) * operands, ATOM)
        self.order: list[Instruction] = []
        self.known = set(printed.entries)
        self.packs: dict[int, int] = {}  # number of a pack to its target
        self.numbers: dict[int, int] = {}  # target of a pack to one of its slots
        self.made: dict[tuple[str, tuple[int | float, ...]], int] = {}  # vectors that are there already
        self.flipped: dict[tuple[int | float, tuple[int, ...]], int] = {}  # vectors times signs, once each
        self.names = LaneNames(printed, packing.width)
        self.places: dict[int, list[str]] = {}
        self.end: list[str] = []
        self.uses = Counter[int]()

    def name(self, value: int | float) -> str:
        """A vector or a single value by its name, a constant by its own."""
        return self.names.of(value)

    def lines(self) -> Iterator[tuple[str, int | None]]:
        """Statements, and the slot that each serves."""
        stored = [(place(array, k), slot) for array, k, slot in self.printed.stored]
        waiting: dict[int, list[tuple[str, int]]] = {}
        written: list[str] = []
        for at, slot in stored:
            base = self.packing.negatives.get(slot, (slot, 1))[0] if isinstance(slot, int) else slot
            if isinstance(slot, int) and isinstance(base, int) and base in self.packing.operations:
                waiting.setdefault(base, []).append((at, slot))
            elif isinstance(slot, int) and base == slot:
                written.append(f"{at} = {self.names.entered(slot)};")
            else:
                written.append(f"{at} = {self.printed.number(float(slot))};")
        for item in in_order(self.packing):
            if isinstance(item, Pack):
                self._pack(item)
            else:
                instruction = self.names.instructions[item]
                args = tuple(self._single(a) for a in instruction.args)
                self._add(instruction.op, args, item)
            for target in _targets(item):
                for at, slot in waiting.get(target, ()):
                    self.places.setdefault(int(self._single(slot)), []).append(at)
        self._total()
        yield from ((text, None) for text in written)
        yield from self._folded()

    def _folded(self) -> Iterator[tuple[str, int | None]]:
        printed, real = self.printed, self.printed.precision.real
        read = {a for i in self.order for a in i.args if isinstance(a, int)} | set(self.uses)
        self.uses.update(a for i in self.order for a in i.args if isinstance(a, int))
        for slot, written in self.places.items():
            self.uses[slot] += len(written)
        places = {slot: self.names.entered(slot) for slot in printed.entries}
        for slot, text in places.items():  # first, as a compiler may: where they are first read, calls take 1 % more
            if self.uses[slot] > 1:
                yield f"const {real} {self.name(slot)} = {text};", slot
        found = folded(
            self.order, self.uses, self.table, name=self.name, places=places,
            ends=lambda slot: slot not in read, binding=self.binding,
        )  # fmt: skip
        for item in found:
            if item.kind == "read":
                continue
            if item.kind == "last":
                if item.slot in self.places:
                    (at,) = self.places.pop(item.slot)
                    yield f"{at} = {item.text};", item.slot
                continue
            text, vector = item.text, item.slot < 0
            if vector and text.count("{") == 1 and text.endswith("}"):  # a list is enough where it is declared
                text = text.removeprefix(f"({self.type})")
            yield f"const {self.type if vector else real} {self.name(item.slot)} = {text};", item.slot
            for at in self.places.pop(item.slot, ()):
                yield f"{at} = {self.name(item.slot)};", item.slot

    def _add(self, op: str, args: tuple[int | float, ...], target: int) -> None:
        self.order.append(Instruction(target, op, args))
        self.known.add(target)

    def _single(self, value: int | float) -> int | float:
        """A slot or constant; one that is in a pack, or another's negative, is taken out where it is first needed."""
        if not isinstance(value, int):
            return value
        if value in self.packing.negatives and value not in self.known:
            base, sign = self.packing.negatives[value]
            if sign > 0 or not isinstance(base, int):
                return self._single(base) if sign > 0 else -base
            self._add("neg", (self._single(base),), value)
        elif value not in self.known:
            pack, lane = self.packing.place[value]
            op = f"lane {lane}" if pack.signs[lane] > 0 else f"minus lane {lane}"
            self.table[op] = f"{{0}}[{lane}]" if pack.signs[lane] > 0 else f"-{{0}}[{lane}]"
            self.binding[op] = ((ATOM,), ATOM if pack.signs[lane] > 0 else SUM)
            self._add(op, (self.packs[pack.number],), value)
        return value

    def _pack(self, pack: Pack) -> None:
        """A pack, behind what its operands must be put together of."""
        args: list[int | float] = [self._operand(vector) for vector in pack.operands]
        if all(not isinstance(a, int) or a >= 0 for a in args):  # two numbers: one of them must become a vector
            args[0] = self._gathered((args[0],) * self.packing.width)
        target = self.names.pack(pack)
        self.packs[pack.number] = target
        self.numbers[target] = _targets(pack)[0]
        self._add("root" if pack.op == "sqrt" else pack.op, tuple(args), target)

    def _operand(self, vector: Vector) -> int | float:
        """A vector as the target of an instruction, or a number that is the same in all lanes."""
        if vector.source is not None:
            found: int | float = self.packs[vector.source]
        elif len(set(map(repr, vector.entries))) == 1:
            found = self._single(vector.entries[0])
        else:
            found = self._gathered(tuple(self._single(a) for a in vector.entries))
        if vector.flips is None:
            return found
        if (found, vector.flips) not in self.flipped:
            signs = self._gathered(tuple(map(float, vector.flips)))
            self.table["signs"] = "{0} * {1}"
            self.binding["signs"] = ((PRODUCT, ATOM), PRODUCT)
            self.flipped[found, vector.flips] = target = self.names.other()
            self._add("signs", (signs, found), target)
        return self.flipped[found, vector.flips]

    def _gathered(self, entries: tuple[int | float, ...]) -> int:
        """A vector of single values, which is made once, or of constants, which is written where it is read."""
        constant = not any(isinstance(a, int) for a in entries)
        key = ("gather", entries)
        if key not in self.made or constant:
            op = "gather"
            if constant:  # as a text of its own: signs are no sums
                op = f"gather {', '.join(self._number(a) for a in entries)}"
                self.table[op] = f"({self.type}){{{{{op.removeprefix('gather ')}}}}}"
            else:
                self.table[op] = f"({self.type}){{{{{', '.join(f'{{{k}}}' for k in range(len(entries)))}}}}}"
                self.binding[op] = ((LOOSE,) * len(entries), ATOM)
            self.made[key] = self.names.gathered(entries)
            self._add(op, () if constant else entries, self.made[key])
        return self.made[key]

    def _number(self, value: float) -> str:
        text = self.printed.number(value)
        return text[1:-1] if text.startswith("(") else text

    def _needed(self, value: int) -> str:
        """The name of what is read at the end."""
        slot = self._single(value) if value >= 0 else value
        if not isinstance(slot, int):
            return self.printed.number(slot)
        if slot in self.printed.entries:
            return self.names.entered(slot)  # read where it is
        self.uses[slot] += 2  # more than once: it has a name
        return self.name(slot)

    def _total(self) -> None:
        """The sum of what must be finite is returned, NaN where a pivot is small or a value beyond its limits.

        Packs whose lanes must all be finite are summed as vectors, packs of pivots are compared as vectors.
        """
        program, precision, inputs = self.printed.program, self.printed.precision, self.printed.inputs
        negatives = self.packing.negatives
        left = dict.fromkeys(negatives.get(slot, (slot, 1))[0] for slot in checked_slots(program))
        small = {negatives.get(slot, (slot, 1))[0]: threshold for slot, threshold in program.guards}
        packs = [item for item in self.packing.items if isinstance(item, Pack)]
        used = range(1 + max(k for pack in packs for k, t in enumerate(pack.targets) if t is not None))
        terms, masks = [], []
        for pack in packs:
            if all(pack.targets[k] in left for k in used):
                terms.append(self._needed(self.packs[pack.number]))
                for k in used:
                    left.pop(pack.targets[k], None)  # type: ignore[arg-type]
            limits = [None if t is None else small.get(t) for t in pack.targets]
            if sum(t is not None for t in limits) > 1:
                texts = [precision.number(-1.0) if t is None else precision.threshold(t) for t in limits]
                name, limit = self._needed(self.packs[pack.number]), f"({self.type}){{{', '.join(texts)}}}"
                masks.append(f"(({name} <= {limit}) & ({name} >= -{limit}))")
                small = {slot: t for slot, t in small.items() if slot not in pack.targets}
        firsts, others = c_unread.fours(inputs, (slot for slot in left if isinstance(slot, int)))
        if firsts:
            self.end.append(c_unread.statement(self.printed.model, inputs, firsts))
        single = [c_unread.total(self.printed.model)] if firsts else []
        single += [self._needed(slot) for slot in others]
        if terms or masks:
            self.end.append(f"const {self.type} every = {self._every(terms, masks)};")
            single += [f"every[{k}]" for k in used]
        text = balanced_sum(single or [precision.number(0.0)])
        tests = list(self._tests(small))
        self.end.append(
            f"return {' || '.join(tests)} ? ({precision.real})NAN : {text};" if tests else f"return {text};"
        )

    def _every(self, terms: Sequence[str], masks: Sequence[str]) -> str:
        zeros = ", ".join([self.printed.precision.number(0.0)] * self.packing.width)
        text = balanced_sum(terms) if terms else f"({self.type}){{{zeros}}}"
        if not masks:
            return text
        mask = f"{self.printed.model}_vector{self.packing.width}_mask"
        return f"({self.type})(({mask})({text}) | {' | '.join(masks)})"  # all bits set are a NaN

    def _tests(self, small: Mapping[int | float, float]) -> Iterator[str]:
        """What tells of a small pivot, and of a value beyond its limits."""
        precision = self.printed.precision
        for slot, threshold in small.items():
            yield f"{precision.function('fabs')}({self._needed(int(slot))}) <= {precision.threshold(threshold)}"
        for slot, low, high, _ in self.printed.program.limits:
            name = self._needed(slot)
            bounds = [
                f"{name} {sign} {precision.number(b)}" for sign, b in ((">=", low), ("<=", high)) if b is not None
            ]
            yield f"!({' && '.join(bounds)})"
