"""Equal limbs in vector lanes: the packed form of a function of one state, in C with vector types.

`<symbol>_packed_lane` computes what `<symbol>_lane` computes of one state, with packs (see `symscrew.program.lanes`) as
vectors of GCC and clang. It stands behind the condition of `condition`; elsewhere, and if `<MODEL>_SCALAR` or
`<MODEL>_LIMB_BY_LIMB` is defined, `<symbol>_limb_by_limb` does the same one by one. So it does for a state that fails:
what is checked is one sum here, NaN at a small pivot, and which status that is, is found out there. No vector type
crosses a function's boundary but that of the square root, which is inlined.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from symscrew.export import c_unread
from symscrew.export.c_order import short_lived
from symscrew.export.c_precision import Precision
from symscrew.export.listing import balanced_sum
from symscrew.program import Instruction, Pack, Packing, Program, Vector

# operation of a pack to its text: operands, the vector type and a vector of ones
TABLE = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "div": "{0} / {1}",
    "sqrt": "{vector}_sqrt({0})",
    "reciprocal": "{ones} / {0}",
}


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
    return [*lines, "#endif"]


@dataclass
class Body:
    """The statements of a packed function while they are printed; `prefix` starts the names of scalars."""

    model: str
    packing: Packing
    precision: Precision
    prefix: str
    known: set[int]
    lines: list[str] = field(default_factory=list)
    gathered: dict[str, str] = field(default_factory=dict)

    @property
    def vector(self) -> str:
        """The vector type."""
        return f"{self.model}_vector{self.packing.width}"

    def name(self, pack: int) -> str:
        """The variable of a pack."""
        return f"{self.prefix}pack{pack}"

    def scalar(self, value: int | float) -> str:
        """A slot or constant; one that is in a pack, or another's negative, is taken out where it is first needed."""
        if not isinstance(value, int):
            return self.precision.number(value)
        if value not in self.known:
            self.known.add(value)
            if value in self.packing.place:
                pack, lane = self.packing.place[value]
                text = f"{self.name(pack.number)}[{lane}]"
                self._define(value, text if pack.signs[lane] > 0 else f"-{text}")
            else:
                base, sign = self.packing.negatives[value]
                text = self.scalar(base)
                self._define(value, text if sign > 0 else f"-{text}")
        return f"{self.prefix}{value}"

    def single(self, instruction: Instruction) -> None:
        """An instruction on its own."""
        text = self.precision.table[instruction.op].format(*[self.scalar(a) for a in instruction.args])
        self.known.add(instruction.target)
        self._define(instruction.target, text)

    def pack(self, pack: Pack) -> None:
        """A pack."""
        parts = [self._operand(vector) for vector in pack.operands]
        ones = self.literal((1.0,) * self.packing.width)
        text = TABLE[pack.op].format(*parts, vector=self.vector, ones=ones)
        self.lines.append(f"const {self.vector} {self.name(pack.number)} = {text};")

    def _operand(self, vector: Vector) -> str:
        if vector.source is not None:
            text = self.name(vector.source)
        elif all(isinstance(a, float) for a in vector.entries):
            text = self.literal(vector.entries)
        else:
            entries = ", ".join([self.scalar(a) for a in vector.entries])
            if entries not in self.gathered:
                self.gathered[entries] = name = f"{self.prefix}gathered{len(self.gathered)}"
                self.lines.append(f"const {self.vector} {name} = {{{entries}}};")
            text = self.gathered[entries]
        return text if vector.flips is None else f"{self.literal(tuple(map(float, vector.flips)))} * {text}"

    def literal(self, values: Iterable[float]) -> str:
        """A vector of constants."""
        return f"({self.vector}){{{', '.join(self.precision.number(v) for v in values)}}}"

    def _define(self, slot: int, text: str) -> None:
        self.lines.append(f"const {self.precision.real} {self.prefix}{slot} = {text};")


def _targets(item: int | Pack) -> list[int]:
    return [t for t in item.targets if t is not None] if isinstance(item, Pack) else [item]


def in_order(packing: Packing) -> list[int | Pack]:
    """The items of a packing in an order that suits registers."""
    targets = [_targets(item) for item in packing.items]
    known: dict[int | float, int] = {slot: k for k, slots in enumerate(targets) for slot in slots}

    def proxy(k: int, slots: Sequence[int]) -> Instruction:
        read = dict.fromkeys(known[a] for s in slots for a, _ in packing.operations[s].args if a in known)
        return Instruction(k, packing.operations[slots[0]].op, tuple(read))

    proxies = [proxy(k, slots) for k, slots in enumerate(targets)]
    return [packing.items[i.target] for i in short_lived(proxies)]


def statements(body: Body, instructions: Mapping[int, Instruction], stored: Iterable[tuple[str, int | float]]) -> None:
    """All statements of a packed function in order; results go to their places as soon as they are known."""
    places: dict[int, list[tuple[str, int]]] = {}
    for place, slot in stored:
        base = body.packing.negatives.get(slot, (slot, 1))[0] if isinstance(slot, int) else slot
        if isinstance(slot, int) and isinstance(base, int) and base in body.packing.operations:
            places.setdefault(base, []).append((place, slot))
        else:
            body.lines.append(f"{place} = {body.scalar(slot)};")
    for item in in_order(body.packing):
        if isinstance(item, Pack):
            body.pack(item)
        else:
            body.single(instructions[item])
        for target in _targets(item):
            body.lines += [f"{place} = {body.scalar(slot)};" for place, slot in places.get(target, ())]


def total(body: Body, checked: Iterable[int], program: Program, inputs: Mapping[int, tuple[str, int]]) -> None:
    """The sum of what must be finite is returned, NaN where a pivot is small or a value beyond its limits.

    Packs whose lanes must all be finite are summed as vectors, packs of pivots are compared as vectors.
    """
    packing, precision, vector = body.packing, body.precision, body.vector
    left = dict.fromkeys(packing.negatives.get(slot, (slot, 1))[0] for slot in checked)
    small = {packing.negatives.get(slot, (slot, 1))[0]: threshold for slot, threshold in program.guards}
    packs = [item for item in packing.items if isinstance(item, Pack)]
    used = range(1 + max(k for pack in packs for k, t in enumerate(pack.targets) if t is not None))
    terms, masks = [], []
    for pack in packs:
        name = body.name(pack.number)
        if all(pack.targets[k] in left for k in used):
            terms.append(name)
            for k in used:
                left.pop(pack.targets[k], None)  # type: ignore[arg-type]
        limits = [None if t is None else small.get(t) for t in pack.targets]
        if sum(t is not None for t in limits) > 1:
            texts = [precision.number(-1.0) if t is None else precision.threshold(t) for t in limits]
            limit = f"({vector}){{{', '.join(texts)}}}"
            masks.append(f"(({name} <= {limit}) & ({name} >= -{limit}))")
            small = {slot: t for slot, t in small.items() if slot not in pack.targets}
    firsts, others = c_unread.fours(inputs, (slot for slot in left if isinstance(slot, int)))
    if firsts:
        body.lines.append(c_unread.statement(body.model, inputs, firsts))
    single = [c_unread.total(body.model)] if firsts else []
    single += [body.scalar(slot) for slot in others]
    if terms or masks:
        text = balanced_sum(terms) if terms else body.literal((0.0,) * packing.width)
        if masks:  # all bits set are a NaN
            text = f"({vector})(({vector}_mask)({text}) | {' | '.join(masks)})"
        body.lines.append(f"const {vector} every = {text};")
        single += [f"every[{k}]" for k in used]
    text = balanced_sum(single or [precision.number(0.0)])
    tests = [f"{precision.function('fabs')}({body.scalar(s)}) <= {precision.threshold(t)}" for s, t in small.items()]
    for slot, low, high, _ in program.limits:
        within = [
            f"{body.scalar(slot)} {sign} {precision.number(b)}"
            for sign, b in ((">=", low), ("<=", high))
            if b is not None
        ]
        tests.append(f"!({' && '.join(within)})")
    body.lines.append(f"return {' || '.join(tests)} ? ({precision.real})NAN : {text};" if tests else f"return {text};")
