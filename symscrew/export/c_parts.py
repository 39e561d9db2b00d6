"""Long straight-line functions in C, in parts: what a compiler takes for a function grows faster than the function.

The lane of a long function (see `c_function`) calls `<symbol>_part0`, `<symbol>_part1`, ... in order, none of which
the compiler may inline. Where equal instructions follow each other, joint after joint or loop after loop, a part is a
loop (see `c_loops`). A value that a later part needs waits in an array on the stack, at a place that is given to
another one afterwards; inside a part every input is read where it is first needed and every output written where it
is known. The compiler would keep these values on the stack, too: there are more of them than registers.

Of a chain of 100 joints, in one piece with its block of eight states, in one piece without, and in parts without
loops: `body_poses` compiles in 16, 9 and 1.8 s and takes 4.2, 4.5 and 3.1 us for one state, 6.7, 4.8 and 3.1 us for one
of a batch; `energy` in 4.8, 2.0 and 1.0 s and takes 2.6 us each, and 1.0, 1.6 and 1.5 us. Parts of 250 and of 1000
instructions are not faster. With loops all 24 functions of this chain are 2.9 in place of 17 MB of C, compile in 11 in
place of 45 s, and a call takes between 0.69 and 1.00 of the time.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from symscrew.export.c_function import sines
from symscrew.export.c_loops import Entry, Loop, loop_statements
from symscrew.export.c_names import arguments, declare, wrapped_code
from symscrew.export.c_printed import Printed
from symscrew.export.c_repeats import Run, runs
from symscrew.export.listing import balanced_sum, checked_slots, expressions
from symscrew.program import Instruction

PART = 500  # instructions of a part: those of 250 and of 1000 are not faster


def prologue(model: str, functions: Iterable[Printed]) -> list[str]:
    """What keeps the compiler from joining the parts again."""
    if not any(printed.in_parts for printed in functions):
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
    def pieces(self) -> tuple[tuple[Instruction, ...] | Loop, ...]:
        """Loops where equal instructions follow each other; between them instructions, nearly equally many."""
        rest = self.printed.angles.rest
        found: list[tuple[Instruction, ...] | Loop] = []
        end = 0
        for run in [*runs(rest, self._kind), Run(len(rest), 1, 0)]:
            between = run.start - end
            count = -(-between // PART)
            ends = [end + between * k // count for k in range(count + 1)] if count else []
            found += [tuple(rest[a:b]) for a, b in pairwise(ends)]
            end = run.end
            if run.count:
                found.append(Loop(tuple(rest[run.start : run.end]), run.period))
        return tuple(found or [()])

    @cached_property
    def lists(self) -> tuple[tuple[Instruction, ...], ...]:
        """Instructions part by part."""
        return tuple(piece.instructions if isinstance(piece, Loop) else piece for piece in self.pieces)

    def _kind(self, slot: int | float) -> object:
        """What loops need to know of an operand from elsewhere, and of a target: the arrays that it stands in."""
        if not isinstance(slot, int):
            return "constant"
        return self.entries[slot][0] if slot in self.entries else self._arrays.get(slot, ())

    @cached_property
    def _arrays(self) -> dict[int, tuple[str, ...]]:
        """The arrays that take a computed slot, of those that are stored."""
        return {slot: tuple(array for array, _ in places) for slot, places in self.stored.items()}

    @cached_property
    def defined(self) -> dict[int, int]:
        """Slot to the part that computes it."""
        return {i.target: k for k, part in enumerate(self.lists) for i in part}

    @cached_property
    def waiting(self) -> dict[int, int]:
        """Slots that a later part reads, and the place of each: free again after the last part that reads it."""
        last = self._last_readers()
        places: dict[int, int] = {}
        free = _Places()
        until: dict[int, list[tuple[int, int]]] = {}
        for k, piece in enumerate(self.pieces):
            for place, size in sorted(until.pop(k - 1, []), reverse=True):
                free.give(place, size)
            for slots in _groups(piece, last):
                place = free.take(len(slots))
                places |= {slot: place + n for n, slot in enumerate(slots)}
                until.setdefault(max(last.get(slot, k) for slot in slots), []).append((place, len(slots)))
        return places

    def _last_readers(self) -> dict[int, int]:
        """Slots that wait, and the last part that reads each."""
        last: dict[int, int] = {}
        defined = self.defined
        for k, piece in enumerate(self.pieces):
            if isinstance(piece, Loop):
                last |= dict.fromkeys(piece.read_from_arrays(), k)
            read = {a for _, _, args in self.lists[k] for a in args if type(a) is int}
            last |= dict.fromkeys([slot for slot in read if defined.get(slot, k) < k], k)
        return last

    @property
    def room(self) -> int:
        """Places that are needed."""
        return 1 + max(self.waiting.values(), default=0)

    @cached_property
    def entries(self) -> dict[int, Entry]:
        """Slots that are there from the start: entries of inputs, sines and cosines."""
        computed = {i.target for i in self.printed.angles.rest}
        return {slot: entry for slot, entry in self.printed.entries.items() if slot not in computed}

    @cached_property
    def entered(self) -> dict[int, str]:
        """The same in C."""
        return {slot: f"{array}[{k}]" for slot, (array, k) in self.entries.items()}

    @cached_property
    def stored(self) -> dict[int, list[Entry]]:
        """Computed slots that are results or pivots, and the entries that take them."""
        program, names = self.printed.program, self.printed.names
        computed = {i.target for i in self.printed.angles.rest}
        found: dict[int, list[Entry]] = {}
        for port, slots in zip(program.outputs, program.results, strict=True):
            for k, slot in enumerate(slots):
                if isinstance(slot, int) and slot in computed:
                    found.setdefault(slot, []).append((names[port.name], k))
        for k, slot in enumerate(program.tested):
            if slot in computed:
                found.setdefault(slot, []).append(("pivot", k))
        return found

    def body(self, part: int) -> list[str]:
        """The body of a part, which returns the sum of what is checked of it."""
        printed, piece = self.printed, self.pieces[part]
        checked = checked_slots(printed.program)
        if isinstance(piece, Loop):
            before = set(piece.read_before())
            entry = {s: self.entries.get(s) or ("waiting", self.waiting[s]) for s in before}
            entry |= {s: ("waiting", self.waiting[s]) for s in piece.read_from_arrays()}
            own = frozenset(i.target for i in piece.instructions) & frozenset(checked)
            return loop_statements(printed, piece, entry=entry, stored=self.stored, waiting=self.waiting, checked=own)
        terms = [printed.operand(s) for s in checked if self.defined.get(s) == part]
        total = balanced_sum(terms or [printed.precision.number(0.0)])
        return [*(f"    {statement}" for statement in self.statements(part)), *wrapped_code(f"return {total};")]

    def statements(self, part: int) -> Iterator[str]:
        """Instructions of a part, one by one."""
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
            for array, k in self.stored.get(target, ()):
                yield f"{array}[{k}] = {prefix}{target};"
            if target in self.waiting:
                yield f"waiting[{self.waiting[target]}] = {prefix}{target};"


def _groups(piece: tuple[Instruction, ...] | Loop, last: Mapping[int, int]) -> Iterator[list[int]]:
    """Slots of a part that wait: one by one, and for a loop one behind the other, iteration by iteration."""
    if not isinstance(piece, Loop):
        yield from ([i.target] for i in piece if i.target in last)
        return
    for j in range(piece.period):
        slots = [i.target for i in piece.instructions[j :: piece.period]]
        if any(slot in last for slot in slots[:-1]):
            yield slots
        elif slots[-1] in last:
            yield slots[-1:]


class _Places:
    """Places in an array, given away again."""

    def __init__(self) -> None:
        self.size, self.free = 0, dict[int, list[int]]()

    def give(self, place: int, size: int) -> None:
        self.free.setdefault(size, []).append(place)

    def take(self, size: int) -> int:
        fitting = min((s for s, places in self.free.items() if s >= size and places), default=None)
        if fitting is None:
            self.size += size
            return self.size - size
        place = self.free[fitting].pop()
        if fitting > size:
            self.give(place + size, fitting - size)
        return place


def lane_in_parts(printed: Printed) -> list[str]:
    """`<symbol>_angles`, the parts, and `<symbol>_lane`, which calls them."""
    program, precision = printed.program, printed.precision
    real, gathered = precision.real, bool(printed.angles.gathered)
    parts = Parts(printed)
    given = [*arguments(program, precision), *sines(printed)]
    given += [f"{real} *restrict pivot"] if program.tested else []
    handed = [*printed.handed(), *(["sine", "cosine"] if gathered else []), *(["pivot"] if program.tested else [])]
    lines, sums = list[str](), []
    checked = checked_slots(program)
    for k in range(len(parts.pieces)):
        head = declare(f"{printed.symbol}_part{k}", [*given, f"{real} *restrict waiting"], f"{_macro(printed)} {real} ")
        lines += [head, "{", *_unread([*handed, "waiting"]), *parts.body(k), "}", ""]
        sums.append(f"{printed.symbol}_part{k}({', '.join([*handed, 'waiting'])})")
    total = balanced_sum([parts.entered[s] for s in checked if s in parts.entered] or [precision.number(0.0)])
    return [
        *lines,
        declare(f"{printed.symbol}_lane", given, f"static inline {real} "),
        "{",
        *_unread(handed),
        f"    {real} waiting[{parts.room}];",
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
    for k, slot in enumerate(program.tested):
        if slot not in parts.defined:
            lines.append(f"    pivot[{k}] = {parts.entered[slot]};")
    return lines
