"""Equal limbs in vector lanes: the packed form of a function of one state, in C with vector types.

`<symbol>_packed_lane` computes what `<symbol>_lane` computes of one state, with packs (see `symscrew.packs`) as
vectors of GCC and clang. It stands behind the condition of `condition`; elsewhere, and if `<MODEL>_SCALAR` or
`<MODEL>_LIMB_BY_LIMB` is defined, `<symbol>_lane` does the same one by one. No vector type crosses a function's
boundary but that of the square root, which is inlined.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from symscrew.export.c_precision import Precision
from symscrew.packs import Pack, Packing, Vector
from symscrew.program import Instruction

SIGNS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def condition(model: str, width: int, precision: Precision) -> str:
    """The condition of the preprocessor for packs of this width."""
    unit = "__AVX512F__" if width * _bytes(precision) > 32 else "__AVX2__"
    upper = model.upper()
    return f"defined(__GNUC__) && defined({unit}) && !defined({upper}_SCALAR) && !defined({upper}_LIMB_BY_LIMB)"


def _bytes(precision: Precision) -> int:
    return 32 // precision.group


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
        f"typedef {precision.real} {name} __attribute__((vector_size({width * _bytes(precision)})));",
    ]
    if root:
        lines += [
            f"static inline {name} {name}_sqrt({name} x)",
            "{",
            f"    {name} root = x;",
            f"    for (int k = 0; k < {width}; ++k) {{",
            f"        root[k] = {precision.function('sqrt')}(x[k]);",
            "    }",
            "    return root;",
            "}",
        ]
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
    gathered: dict[tuple, str] = field(default_factory=dict)

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
        if pack.op == "sqrt":
            text = f"{self.vector}_sqrt({parts[0]})"
        elif pack.op == "reciprocal":
            text = f"{self._literal((1.0,) * self.packing.width)} / {parts[0]}"
        else:
            text = f" {SIGNS[pack.op]} ".join(parts)
        self.lines.append(f"    const {self.vector} {self.name(pack.number)} = {text};")

    def _operand(self, vector: Vector) -> str:
        if vector.source is not None:
            text = self.name(vector.source)
        elif all(isinstance(a, float) for a in vector.entries):
            text = self._literal(vector.entries)
        else:
            if vector.entries not in self.gathered:
                entries = ", ".join([self.scalar(a) for a in vector.entries])
                self.gathered[vector.entries] = name = f"{self.prefix}gathered{len(self.gathered)}"
                self.lines.append(f"    const {self.vector} {name} = {{{entries}}};")
            text = self.gathered[vector.entries]
        return text if vector.flips is None else f"{self._literal(tuple(map(float, vector.flips)))} * {text}"

    def _literal(self, values: Iterable[float]) -> str:
        return f"({self.vector}){{{', '.join(self.precision.number(v) for v in values)}}}"

    def _define(self, slot: int, text: str) -> None:
        self.lines.append(f"    const {self.precision.real} {self.prefix}{slot} = {text};")


def statements(body: Body, instructions: Mapping[int, Instruction], wrap: Callable[[str], list[str]]) -> list[str]:
    """All statements of a packed function in order, long ones wrapped."""
    for item in body.packing.items:
        if isinstance(item, Pack):
            body.pack(item)
        else:
            body.single(instructions[item])
    return [line for text in body.lines for line in wrap(text)]
