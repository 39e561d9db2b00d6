"""A straight-line program on its way into C: its arguments, angles, order, results, and how operands are written.

Program --Printed--> angles first | the rest in an order that suits registers | what is stored where
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby

from symscrew.export.c_angles import Angles, gather
from symscrew.export.c_names import TAKEN, argument_names
from symscrew.export.c_order import short_lived, within
from symscrew.export.c_precision import Precision
from symscrew.export.constants import Constants, Writing
from symscrew.export.listing import checked_slots, input_entries, live_instructions
from symscrew.export.stages import Stages
from symscrew.export.value_names import LEGEND, value_names
from symscrew.model import Model
from symscrew.program import (
    Corresponding,
    Instruction,
    LimbStages,
    Packing,
    Port,
    Program,
    packed,
    stages_of_lanes,
    stages_of_limbs,
)

# Instructions of functions that are tried in lanes: of fewer, gathering costs what is saved; of more, finding what goes
# together takes half a second and more (within: forward dynamics of the 6-UPS, 0.73 of the time limb after limb).
PACKED = range(100, 4000)
PER_OUTPUT = 6  # and how many there must be for every output: else the time goes into taking results out
# Functions of more than so many instructions and entries stored are printed in parts, without blocks of states; up to
# there in one piece, which has blocks and takes some seconds to compile at most.
LONG = 5500
STORED = 4  # instructions that an entry of an output counts as: compilers take a function's stores by pairs
RUN = 8  # so many zeros in a row are written by a loop before the lane; fewer with the other results


@dataclass(frozen=True)
class Form:
    """How the statements of a function are written: for one state, or for several in vectors.

    Entry k of an argument lies at k * `stride`, of our own arrays at k * `pitch`; `read` and `written` are formats of
    a place that is read or written, `constant` of a number that is written; `table` is of operations.
    """

    real: str
    table: Mapping[str, str]
    stride: str = "1"
    pitch: str = "1"
    read: str = "{}"
    written: str = "{}"
    constant: str = "{}"


def place(array: str, entry: int, step: str = "1") -> str:
    """Entry k of an array whose entries are `step` apart."""
    if entry < 2:
        return f"{array}[{('0', step)[entry]}]"
    return f"{array}[{entry}]" if step == "1" else f"{array}[{entry} * {step}]"


class Shared:
    """Functions that several functions call, printed once: their text with `NAME` in place of the symbol, by symbol."""

    def __init__(self, model: Model, precision: Precision) -> None:
        """None yet."""
        self.model, self.symbols = model.name, dict[str, str]()
        opening = f"{model.name.upper()}_UNUSED static const {precision.real}"
        constant = "    {name} = {number}{end} "
        writing = Writing(precision.number, constant, ("/* ", "   ", " */"), opening, legend=LEGEND)
        self.constants = Constants(model, writing)

    def symbol(self, stem: str, text: str) -> str:
        """The symbol of a function with this text."""
        return self.symbols.setdefault(text, f"{self.model}_{stem}{len(self.symbols)}")

    def lines(self) -> list[str]:
        """All of them."""
        return [line for text, symbol in self.symbols.items() for line in text.replace("NAME", symbol).split("\n")]


@dataclass(frozen=True)
class Printed:
    """A straight-line program on its way into C: the names of its arguments, its angles, its pivots.

    `registers`: how many values a processor holds, where an order with few above that is looked for; 0: any number.
    """

    model: str
    symbol: str
    program: Program
    precision: Precision
    lanes: bool = False
    shared: Shared | None = None
    registers: int = 0

    @cached_property
    def in_parts(self) -> bool:
        """Whether it is a long function, printed in parts (see `c_parts`)."""
        entries = sum(port.size for port in self.program.outputs)
        return len(self.program.instructions) + STORED * entries > LONG

    @cached_property
    def corresponding(self) -> Corresponding:
        """What corresponds in its equal limbs."""
        return Corresponding(self.angles.rest, origins=self.program.origins, limbs=self.program.limbs)

    @cached_property
    def packing(self) -> Packing | None:
        """Its form with equal limbs side by side, if `lanes` are wanted and pay."""
        kept = [s for slots in self.program.results for s in slots if isinstance(s, int)]
        count = len(self.program.instructions)
        if not self.lanes or count not in PACKED or len(kept) * PER_OUTPUT > count:
            return None
        arrays = {slot: array for slot, (array, _) in self.entries.items()}
        checked = [*self.program.tested, *checked_slots(self.program)]
        return packed(self.corresponding, kept, checked, arrays)

    @cached_property
    def ports(self) -> dict[int, int]:
        """The input, by its number, of slots that are there from the start; angles are of the first one."""
        numbers = {self.names[port.name]: n for n, port in enumerate(self.program.inputs)}
        return {slot: numbers.get(array, 0) for slot, (array, _) in self.entries.items()}

    @cached_property
    def lanes_of_limbs(self) -> LimbStages | None:
        """Its stages of equal limbs that are those of its form in lanes, too: where every lane is a limb."""
        if not self.packing:
            return None
        families = (f for f in self.program.limbs.families if len(f) == self.packing.width)
        return next(filter(None, (stages_of_lanes(self.packing, family, self.ports) for family in families)), None)

    @cached_property
    def staged(self) -> LimbStages | None:
        """What its equal limbs do, once, if that is a good part of it."""
        if self.registers:  # an order for one machine's registers is that of all operations, limb after limb
            return None
        if self.lanes_of_limbs:
            return self.lanes_of_limbs
        stored = [slot for *_, slot in self.stored if isinstance(slot, int)]
        arrays = {slot: array for slot, (array, _) in self.entries.items()}
        return stages_of_limbs(self.corresponding, stored, arrays, self.ports)

    def take(self, packing: Packing | None) -> None:
        """Its packed form, found by another process."""
        self.__dict__["packing"] = packing  # where `cached_property` keeps it

    @cached_property
    def names(self) -> dict[str, str]:
        """Port name to argument name."""
        ports = (*self.program.inputs, *self.program.outputs)
        return dict(zip((p.name for p in ports), argument_names(ports), strict=True))

    @cached_property
    def angles(self) -> Angles:
        """What is computed before everything else."""
        live, _ = live_instructions(self.program)
        kept = {s for slots in self.program.results for s in slots if isinstance(s, int)}
        return gather(live, kept | set(self.program.tested))

    @cached_property
    def order(self) -> list[Instruction]:
        """Everything else, in an order that suits registers."""
        rest = self.angles.rest
        return within(rest, self.registers) if self.registers else short_lived(rest)

    @cached_property
    def prefix(self) -> str:
        """A prefix of local variables that no argument can be mistaken for."""
        used = " ".join(self.names.values())
        return next(p for p in ("x", "t", "w", "local_", "symscrew_local_") if not re.search(rf"\b{p}\d", used))

    def operand(self, value: int | float) -> str:
        """A slot or constant."""
        return f"{self.prefix}{value}" if isinstance(value, int) else self.precision.number(value)

    @cached_property
    def stages(self) -> Stages:
        """Which limb, and what part of the theory, its slots are of."""
        return Stages(self.program)

    @cached_property
    def called(self) -> Mapping[int, str]:
        """What slots are called in C: by their place in the theory."""
        constants = self.shared.constants.names.values() if self.shared else ()
        return value_names(self.program, {*TAKEN, *self.names.values(), *constants})

    def named(self, value: int | float) -> str:
        """A slot by its name, or a constant by its own."""
        return self.called[value] if isinstance(value, int) else self.number(value)

    def number(self, value: float) -> str:
        """A constant by its name, if it has one."""
        return self.shared.constants.text(value) if self.shared else self.precision.number(value)

    def handed(self, *, outputs: bool = True) -> list[str]:
        """The names of the arguments, to hand them on."""
        ports = (*self.program.inputs, *self.program.outputs) if outputs else self.program.inputs
        return [self.names[p.name] for p in ports]

    @cached_property
    def alone(self) -> Form:
        """How one state is written."""
        return Form(self.precision.real, self.precision.table)

    @cached_property
    def inputs(self) -> dict[int, tuple[str, int]]:
        """The array and entry of slots that are entries of inputs."""
        return {slot: (self.names[port.name], k) for slot, (port, k) in enumerate(input_entries(self.program))}

    @cached_property
    def entries(self) -> dict[int, tuple[str, int]]:
        """The array and entry of slots that are there from the start: entries of inputs, sines and cosines."""
        found = dict(self.inputs)
        for k, (_, *pair) in enumerate(self.angles.gathered):
            pairs = zip(("sine", "cosine"), pair, strict=True)
            found |= {slot: (array, k) for array, slot in pairs if slot is not None}
        return found

    def entered(self, form: Form) -> dict[int, str]:
        """What reads slots that are there from the start."""
        own = ("sine", "cosine")
        return {
            slot: form.read.format(place(array, k, form.pitch if array in own else form.stride))
            for slot, (array, k) in self.entries.items()
        }

    def loads(self, slots: Iterable[int], form: Form) -> list[str]:
        """Statements that read slots that are there from the start."""
        entered = self.entered(form)
        return [f"const {form.real} {self.prefix}{s} = {entered[s]};" for s in slots]

    @cached_property
    def cleared(self) -> list[tuple[str, range]]:
        """Runs of zeros in outputs, which are written before the lane, by loops."""
        found = []
        for port, slots in zip(self.program.outputs, self.program.results, strict=True):
            first = 0
            for zero, some in groupby(repr(slot) == "0.0" for slot in slots):
                run = range(first, first := first + len(list(some)))
                if zero and len(run) >= RUN:
                    found.append((self.names[port.name], run))
        return found

    @cached_property
    def stored(self) -> list[tuple[str, int, int | float]]:
        """The entries of outputs, and what goes there, but for zeros that are there already."""
        outputs = zip(self.program.outputs, self.program.results, strict=True)
        cleared = {(name, k) for name, run in self.cleared for k in run}
        named = [(self.names[port.name], slots) for port, slots in outputs]
        return [(name, k, s) for name, slots in named for k, s in enumerate(slots) if (name, k) not in cleared]

    def unused(self, ports: Iterable[Port], read: set[int]) -> list[str]:
        """Nothing is said of ports of which nothing is read."""
        entries = input_entries(self.program)
        used = {entries[slot][0].name for slot in read if slot < len(entries)}
        return [f"    (void){self.names[port.name]};" for port in ports if port.name not in used]
