"""Runs of equal instructions as loops in C: smaller than the instructions one by one, and not slower.

An iteration finds its operands: in itself; in the iteration before, in a variable that is carried on; in arrays
(inputs, sines, cosines, values that wait) at places that advance evenly or stand in a table; or in a table of
constants. What is needed later than in the next iteration waits, iteration after iteration, in one array.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from symscrew.export.c_names import wrapped_code
from symscrew.export.c_printed import Printed
from symscrew.export.listing import balanced_sum, expressions
from symscrew.program import Instruction

Entry = tuple[str, int]  # an array and an index


@dataclass(frozen=True)
class Local:
    """An operand from the same iteration: position of its instruction."""

    position: int


@dataclass(frozen=True)
class Carried:
    """An operand from the iteration before: position of its instruction, and the operand of the first iteration."""

    position: int
    first: int | float


@dataclass(frozen=True)
class Same:
    """The same operand in all iterations."""

    value: int | float


@dataclass(frozen=True)
class Various:
    """Operands, all constants or all in arrays, one per iteration."""

    values: tuple[int | float, ...]


Source = Local | Carried | Same | Various


@dataclass(frozen=True)
class Loop:
    """`count` iterations of `period` instructions."""

    instructions: tuple[Instruction, ...]
    period: int

    @property
    def count(self) -> int:
        """Iterations."""
        return len(self.instructions) // self.period

    @property
    def body(self) -> tuple[Instruction, ...]:
        """The first iteration."""
        return self.instructions[: self.period]

    @cached_property
    def place(self) -> dict[int, tuple[int, int]]:
        """Iteration and position of each target."""
        return {i.target: divmod(k, self.period) for k, i in enumerate(self.instructions)}

    @cached_property
    def sources(self) -> list[list[Source]]:
        """Where the operands of the body come from."""
        return [
            [
                self._source(j, values)
                for values in zip(*[i.args for i in self.instructions[j :: self.period]], strict=True)
            ]
            for j in range(self.period)
        ]

    def _source(self, j: int, values: tuple[int | float, ...]) -> Source:
        first, place = values[0], self.place
        if isinstance(first, float):  # 0.0 is not -0.0
            return Same(first) if all(repr(v) == repr(first) for v in values) else Various(values)
        if values.count(first) == len(values) and first not in place:
            return Same(first)
        found = [place.get(v) if isinstance(v, int) else None for v in values]
        second = found[1]
        if second is not None:
            position = second[1]
            if all(at == (k, position) for k, at in enumerate(found)) and position < j:
                return Local(position)
            if found[0] is None and all(at == (k, position) for k, at in enumerate(found[1:])):
                return Carried(position, values[0])
        return Various(values)

    def read_from_arrays(self) -> Iterable[int]:
        """Slots of the loop itself that iterations read other than from themselves and the one before."""
        for sources in self.sources:
            for source in sources:
                if isinstance(source, Various):
                    yield from (v for v in source.values if isinstance(v, int) and v in self.place)

    def read_before(self) -> Iterable[int]:
        """Slots from elsewhere, of all iterations."""
        for instruction in self.instructions:
            yield from (a for a in instruction.args if isinstance(a, int) and a not in self.place)


def loop_statements(
    printed: Printed,
    loop: Loop,
    *,
    entry: Mapping[int, Entry],
    stored: Mapping[int, Sequence[Entry]],
    waiting: Mapping[int, int],
    checked: frozenset[int],
) -> list[str]:
    """The body of a part that is a loop, its return included.

    `entry`: where slots from elsewhere are; `stored`: the entries of outputs and pivots that a target is; `waiting`:
    the place of targets that are needed later, one behind the other iteration by iteration, or of the last only.
    """
    writer = _Writer(printed, loop, entry)
    body = writer.body()
    real, prefix = printed.precision.real, printed.prefix
    after = []
    for j, instruction in enumerate(loop.body):
        name = f"{prefix}{instruction.target}"
        every = [loop.instructions[k * loop.period + j].target for k in range(loop.count)]
        for n in range(len(stored.get(instruction.target, ()))):
            body.append(f"{writer.element([stored[t][n] for t in every])} = {name};")
        if all(t in waiting for t in every):
            body.append(f"{writer.element([('waiting', waiting[t]) for t in every])} = {name};")
        elif every[-1] in waiting:
            last = writer.kept(instruction.target)
            after.append(f"waiting[{waiting[every[-1]]}] = {last};")
    own = [f"{prefix}{i.target}" for i in loop.body if i.target in checked]
    if own:
        body.append(f"sum += {balanced_sum(own)};")
    body += writer.handed_on()
    head = [*writer.tables(), *writer.before]
    head += [f"{real} sum = {printed.precision.number(0.0)};"] if own else []
    head += [f"for (size_t k = 0; k < {loop.count}; ++k) {{"]
    lines = [f"    {text}" for text in head]
    for text in body:
        lines += [f"    {line}" for line in wrapped_code(text)]
    lines += ["    }", *(f"    {text}" for text in after)]
    return [*lines, f"    return {'sum' if own else printed.precision.number(0.0)};"]


class _Writer:
    """Statements of an iteration, with the tables and variables that they need."""

    def __init__(self, printed: Printed, loop: Loop, entry: Mapping[int, Entry]) -> None:
        self.printed, self.loop, self.entry = printed, loop, entry
        self.before: list[str] = []
        self.carried: dict[tuple[int, int | float], str] = {}
        self._indices: dict[tuple[int, ...], int] = {}
        self._constants: dict[tuple[int | float, ...], int] = {}
        self._known: dict[object, int] = {}
        self._next = printed.program.slots
        self._last: dict[int, str] = {}

    def body(self) -> list[str]:
        """Loads and operations."""
        printed, loop, lines = self.printed, self.loop, []
        real, prefix = printed.precision.real, printed.prefix
        for instruction, sources in zip(loop.body, loop.sources, strict=True):
            args: list[int | float] = []
            for source in sources:
                if isinstance(source, Local):
                    args.append(loop.body[source.position].target)
                elif isinstance(source, Same) and not isinstance(source.value, int):
                    args.append(source.value)
                else:
                    new = source not in self._known
                    args.append(self._name(source))
                    if new and isinstance(source, Various):
                        lines.append(f"const {real} {prefix}{args[-1]} = {self._various(source)};")
            ((_, text),) = expressions(
                [Instruction(instruction.target, instruction.op, tuple(args))], printed.precision.table, printed.operand
            )
            lines.append(f"const {real} {prefix}{instruction.target} = {text};")
        return lines

    def _name(self, source: Source) -> int:
        """A number of a variable of our own, declared before the loop unless it changes with every iteration."""
        if source not in self._known:
            self._known[source] = self._next
            self._next += 1
            real, name = self.printed.precision.real, f"{self.printed.prefix}{self._known[source]}"
            if isinstance(source, Same):
                self.before.append(f"const {real} {name} = {self._single(source.value)};")
            elif isinstance(source, Carried):
                self.before.append(f"{real} {name} = {self._single(source.first)};")
                self.carried[source.position, source.first] = name
        return self._known[source]

    def _single(self, value: int | float) -> str:
        if not isinstance(value, int):
            return self.printed.precision.number(value)
        array, index = self.entry[value]
        return f"{array}[{index}]"

    def _various(self, source: Various) -> str:
        if isinstance(source.values[0], float):
            column = self._constants.setdefault(source.values, len(self._constants))
            return f"constant[k][{column}]"
        return self.element([self.entry[v] for v in source.values if isinstance(v, int)])

    def element(self, entries: Sequence[Entry]) -> str:
        """An element of an array, one index per iteration."""
        ((array, first), (_, second)) = entries[:2]
        step = second - first
        if all(index == first + k * step for k, (_, index) in enumerate(entries)):
            factor = f"{abs(step)} * " if abs(step) != 1 else ""
            even = f"{first} {'+' if step > 0 else '-'} {factor}k" if step else f"{first}"
            return f"{array}[{even.removeprefix('0 + ')}]"
        column = self._indices.setdefault(tuple(index for _, index in entries), len(self._indices))
        return f"{array}[at[k][{column}]]"

    def kept(self, target: int) -> str:
        """The variable that holds the value of the last iteration behind the loop."""
        position = next(j for j, i in enumerate(self.loop.body) if i.target == target)
        for (carried, _), name in self.carried.items():
            if carried == position:
                return name
        name = f"{self.printed.prefix}{self._next}"
        self._next += 1
        self.before.append(f"{self.printed.precision.real} {name} = {self.printed.precision.number(0.0)};")
        self._last[position] = name
        return name

    def handed_on(self) -> list[str]:
        """The end of an iteration: what the next one, or what comes behind the loop, finds."""
        prefix, body = self.printed.prefix, self.loop.body
        pairs = [(name, position) for (position, _), name in self.carried.items()]
        pairs += [(name, position) for position, name in self._last.items()]
        return [f"{name} = {prefix}{body[position].target};" for name, position in pairs]

    def tables(self) -> list[str]:
        """Indices and constants, a row per iteration."""
        lines = []
        real, number = self.printed.precision.real, self.printed.precision.number
        for kind, name, columns in (
            ("unsigned", "at", [list(map(str, c)) for c in self._indices]),
            (real, "constant", [[number(v) for v in c] for c in self._constants]),
        ):
            if columns:
                rows = [", ".join(column[k] for column in columns) for k in range(self.loop.count)]
                lines.append(f"static const {kind} {name}[{self.loop.count}][{len(columns)}] = {{")
                lines += [f"    {{{row}}}," for row in rows]
                lines.append("};")
        return lines
