"""Long straight-line functions in C, in parts: what a compiler takes for a function grows faster than the function.

The lane of a long function (see `c_function`) calls `<symbol>_part0`, `<symbol>_part1`, ... in order, none of which
the compiler may inline. A value that a later part needs waits in an array on the stack, at a place that is given to
another one afterwards; inside a part every input is read where it is first needed and every output written where it
is known. The compiler would keep these values on the stack, too: there are more of them than registers.

Of a chain of 100 joints, in one piece with its block of eight states, in one piece without, and in parts:
`body_poses` compiles in 16, 9 and 1.8 s and takes 4.2, 4.5 and 3.1 us for one state, 6.7, 4.8 and 3.1 us for one of a
batch; `energy` in 4.8, 2.0 and 1.0 s and takes 2.6 us each, and 1.0, 1.6 and 1.5 us. Parts of 250 and of 1000
instructions are not faster.

Matrices that are mostly zero are cleared by a loop instead of an assignment for each of their entries.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from symscrew.export.c_function import Printed, angles_function, arguments, declare, wrapped_code
from symscrew.export.listing import balanced_sum, checked_slots, expressions, input_entries
from symscrew.program import Instruction

LONG = 5500  # functions of more than so many instructions and entries stored are printed in parts
STORED = 4  # instructions that an entry of an output counts as: compilers take a function's stores by pairs
PART = 500  # instructions of a part


def long(printed: Printed) -> bool:
    """Whether a function is printed in parts."""
    program = printed.program
    return len(program.instructions) + STORED * sum(port.size for port in program.outputs) > LONG


def prologue(model: str, functions: Iterable[Printed]) -> list[str]:
    """What keeps the compiler from joining the parts again."""
    if not any(long(printed) for printed in functions):
        return []
    macro = f"{model.upper()}_PART"
    return [
        "",
        "/* Long functions are compiled in parts, which must stay apart. */",
        "#if defined(__GNUC__)",
        f"#define {macro} __attribute__((noinline)) static",
        "#else",
        f"#define {macro} static",
        "#endif",
    ]


@dataclass(frozen=True)
class Parts:
    """The instructions of a function in parts, and where values wait between them."""

    printed: Printed

    @cached_property
    def lists(self) -> tuple[tuple[Instruction, ...], ...]:
        """Instructions part by part, of nearly equal length."""
        rest = self.printed.angles.rest
        count = max(1, -(-len(rest) // PART))
        ends = [len(rest) * k // count for k in range(count + 1)]
        return tuple(rest[a:b] for a, b in pairwise(ends))

    @cached_property
    def defined(self) -> dict[int, int]:
        """Slot to the part that computes it."""
        return {i.target: k for k, part in enumerate(self.lists) for i in part}

    @cached_property
    def waiting(self) -> dict[int, int]:
        """Slots that a later part reads, and the place of each: free again after the last part that reads it."""
        last: dict[int, int] = {}
        for k, part in enumerate(self.lists):
            for slot in (a for i in part for a in i.args if isinstance(a, int)):
                if self.defined.get(slot, k) < k:
                    last[slot] = k
        places: dict[int, int] = {}
        free: list[int] = []
        count = 0
        for k, part in enumerate(self.lists):
            free += sorted((places[s] for s in places if last[s] == k - 1), reverse=True)
            for slot in (i.target for i in part if i.target in last):
                if free:
                    places[slot] = free.pop()
                else:
                    places[slot], count = count, count + 1
        return places

    @cached_property
    def entered(self) -> dict[int, str]:
        """Slots that are there from the start: entries of inputs, sines and cosines."""
        names = self.printed.names
        found = {s: f"{names[port.name]}[{k}]" for s, (port, k) in enumerate(input_entries(self.printed.program))}
        for k, (_, *pair) in enumerate(self.printed.angles.gathered):
            found |= {s: f"{name}[{k}]" for name, s in zip(("sine", "cosine"), pair, strict=True) if s is not None}
        return {slot: text for slot, text in found.items() if slot not in self.defined}

    @cached_property
    def stored(self) -> dict[int, list[str]]:
        """Computed slots that are results or pivots, and the entries that take them."""
        program, names = self.printed.program, self.printed.names
        found: dict[int, list[str]] = {}
        for port, slots in zip(program.outputs, program.results, strict=True):
            for k, slot in enumerate(slots):
                if isinstance(slot, int) and slot in self.defined:
                    found.setdefault(slot, []).append(f"{names[port.name]}[{k}]")
        for k, (slot, _) in enumerate(program.guards):
            if slot in self.defined:
                found.setdefault(slot, []).append(f"pivot[{k}]")
        return found

    def statements(self, part: int) -> Iterator[str]:
        """The body of a part."""
        printed = self.printed
        real, prefix = printed.precision.real, printed.prefix
        known: set[int] = set()
        texts = expressions(self.lists[part], printed.precision.table, printed.operand)
        for instruction, (target, text) in zip(self.lists[part], texts, strict=True):
            for slot in (a for a in instruction.args if isinstance(a, int)):
                if slot not in known and self.defined.get(slot) != part:
                    known.add(slot)
                    source = self.entered.get(slot) or f"waiting[{self.waiting[slot]}]"
                    yield f"const {real} {prefix}{slot} = {source};"
            yield f"const {real} {prefix}{target} = {text};"
            for entry in self.stored.get(target, ()):
                yield f"{entry} = {prefix}{target};"
            if target in self.waiting:
                yield f"waiting[{self.waiting[target]}] = {prefix}{target};"


def lane_in_parts(printed: Printed) -> list[str]:
    """`<symbol>_angles`, the parts, and `<symbol>_lane`, which has a stride of 1 only."""
    program, precision = printed.program, printed.precision
    real, gathered = precision.real, bool(printed.angles.gathered)
    parts = Parts(printed)
    given = arguments(program, precision)
    given += [f"const {real} *restrict sine", f"const {real} *restrict cosine"] if gathered else []
    given += [f"{real} *restrict pivot"] if program.guards else []
    handed = [*printed.handed(), *(["sine", "cosine"] if gathered else []), *(["pivot"] if program.guards else [])]
    lines, sums = angles_function(printed), []
    checked = checked_slots(program)
    for k in range(len(parts.lists)):
        own = [printed.operand(s) for s in checked if parts.defined.get(s) == k]
        head = declare(f"{printed.symbol}_part{k}", [*given, f"{real} *restrict waiting"], f"{_macro(printed)} {real} ")
        lines += [head, "{", *_unread([*handed, "waiting"])]
        lines += [f"    {statement}" for statement in parts.statements(k)]
        lines += [*wrapped_code(f"return {balanced_sum(own or [precision.number(0.0)])};"), "}", ""]
        sums.append(f"{printed.symbol}_part{k}({', '.join([*handed, 'waiting'])})")
    total = balanced_sum([parts.entered[s] for s in checked if s in parts.entered] or [precision.number(0.0)])
    return [
        *lines,
        declare(f"{printed.symbol}_lane", ["size_t stride", "size_t pitch", *given], f"static inline {real} "),
        "{",
        *_unread(["stride", "pitch", *handed]),
        f"    {real} waiting[{max(1, len(set(parts.waiting.values())))}];",
        *_given(parts),
        *wrapped_code(f"{real} total = {total};"),
        *(line for call in sums for line in wrapped_code(f"total += {call};")),
        "    return total;",
        "}",
    ]


def _macro(printed: Printed) -> str:
    return f"{printed.model.upper()}_PART"


def _unread(names: Sequence[str]) -> list[str]:
    """Nothing is said of arguments that are not read."""
    return [f"    (void){name};" for name in names]


def _given(parts: Parts) -> list[str]:
    """Entries of outputs and pivots that no part computes: constants and inputs."""
    printed = parts.printed
    program, number = printed.program, printed.precision.number
    cleared = {(name, k) for name, run in printed.cleared for k in run}
    lines = []
    for port, slots in zip(program.outputs, program.results, strict=True):
        name = printed.names[port.name]
        for k, slot in enumerate(slots):
            if slot not in parts.defined and (name, k) not in cleared:
                lines.append(f"    {name}[{k}] = {parts.entered[slot] if isinstance(slot, int) else number(slot)};")
    for k, (slot, _) in enumerate(program.guards):
        if slot not in parts.defined:
            lines.append(f"    pivot[{k}] = {parts.entered[slot]};")
    return lines
