"""Straight-line functions in C.

The operations of a function are printed once, as `<symbol>_lane`, in which entry k of an array lies at
k * stride: with a stride of 1 it is one state, with a stride of 8 one of eight states that lie side by side
(see `c_batch`). Sines and cosines of input angles come ready, from `<symbol>_angles` and `c_angles`. Where equal
limbs make it pay, one state has a second form with limbs side by side (see `c_lanes`).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

from symscrew.export import c_lanes
from symscrew.export.c_angles import Angles, calls, gather
from symscrew.export.c_precision import Precision
from symscrew.export.listing import balanced_sum, checked_slots, expressions, input_entries, live_instructions, wrapped
from symscrew.packs import Packing, packed
from symscrew.program import Iteration, Port, Program

NAMES_OF_MATH = "sin cos tan sqrt exp atan2 fabs isfinite NAN NULL INFINITY HUGE_VAL size_t M_PI M_E I errno assert"
NAMES_OF_MATH += " sinf cosf tanf sqrtf expf atan2f fabsf"
NAMES_OF_LOCALS = "count status k worst outcome total next residual change orientation start substeps most"
NAMES_OF_LOCALS += " rate_scale row_scale inertia load closure curvature turn work multipliers rank sized shifted"
NAMES_OF_LOCALS += " loads columns mix amount internal moved part factor largest i j"
NAMES_OF_LOCALS += " angle sine cosine pivot stride lane index first some block blocks number"
PACKED = range(100, 2000)  # instructions of functions that are tried in lanes
PER_OUTPUT = 6  # and how many there are for every output: else the time goes into taking results out
TAKEN = frozenset(f"{NAMES_OF_MATH} {NAMES_OF_LOCALS}".split())


def argument_names(ports: Sequence[Port]) -> list[str]:
    """The ports' names as C arguments: those that the code needs itself get an underscore."""
    return [port.name + "_" if port.name in TAKEN else port.name for port in ports]


def arguments(program: Program | Iteration, precision: Precision, restrict: str = "restrict") -> list[str]:
    """The declared arguments of a function: its inputs and outputs."""
    names = argument_names((*program.inputs, *program.outputs))
    read = len(program.inputs)
    real = precision.real
    return [f"{'const ' if i < read else ''}{real} *{restrict} {name}" for i, name in enumerate(names)]


def declare(symbol: str, given: Sequence[str], prefix: str = "int ") -> str:
    """A declaration with an argument per line."""
    return f"{prefix}{symbol}(\n    " + ",\n    ".join(given or ["void"]) + ")"


def wrapped_code(statement: str, indent: str = "    ") -> list[str]:
    """A long statement over several lines, broken at blanks."""
    return wrapped(statement, first=indent, later=indent + "    ", width=110)


@dataclass(frozen=True)
class Printed:
    """A straight-line program on its way into C: the names of its arguments, its angles, its pivots."""

    model: str
    symbol: str
    program: Program
    precision: Precision
    lanes: bool = False

    @cached_property
    def packing(self) -> Packing | None:
        """Its form with equal limbs side by side, if `lanes` are wanted and pay."""
        kept = [s for slots in self.program.results for s in slots if isinstance(s, int)]
        count = len(self.program.instructions)
        if not self.lanes or count not in PACKED or len(kept) * PER_OUTPUT > count:
            return None
        return packed(self.angles.rest, checked_slots(self.program))

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
        return gather(live, kept | {slot for slot, _ in self.program.guards})

    @cached_property
    def prefix(self) -> str:
        """A prefix of local variables that no argument can be mistaken for."""
        used = " ".join(self.names.values())
        return next(p for p in ("x", "t", "w", "local_", "symscrew_local_") if not re.search(rf"\b{p}\d", used))

    def operand(self, value: int | float) -> str:
        """A slot or constant."""
        return f"{self.prefix}{value}" if isinstance(value, int) else self.precision.number(value)

    def handed(self, *, outputs: bool = True) -> list[str]:
        """The names of the arguments, to hand them on."""
        ports = (*self.program.inputs, *self.program.outputs) if outputs else self.program.inputs
        return [self.names[p.name] for p in ports]

    def at(self, entry: int) -> str:
        """The place of an entry in an array of a lane."""
        return ("0", "stride")[entry] if entry < 2 else f"{entry} * stride"

    def _loads(self, read: set[int]) -> list[str]:
        real = self.precision.real
        return [
            f"    const {real} {self.prefix}{slot} = {self.names[port.name]}[{self.at(k)}];"
            for slot, (port, k) in enumerate(input_entries(self.program))
            if slot in read
        ]

    def _unused(self, ports: Iterable[Port], read: set[int]) -> list[str]:
        entries = input_entries(self.program)
        used = {entries[slot][0].name for slot in read if slot < len(entries)}
        return [f"    (void){self.names[port.name]};" for port in ports if port.name not in used]


def lane(printed: Printed, *, inline: str = "") -> list[str]:
    """`<symbol>_angles` and `<symbol>_lane`: everything but the decision about the status.

    The lane returns the sum of all that must be finite and leaves its pivots in `pivot`.
    """
    body, head = _statements(printed, printed.angles.rest), f"static inline {inline}{printed.precision.real} "
    first = angles_function(printed, inline=inline)
    return [*first, *_lane(printed, f"{printed.symbol}_lane", head, body, printed.operand)]


def angles_function(printed: Printed, *, inline: str = "") -> list[str]:
    """`<symbol>_angles`, if the function has any: the angles whose sines and cosines come first."""
    program, real, angles = printed.program, printed.precision.real, printed.angles
    if not angles.gathered:
        return []
    given = ["size_t stride", *arguments(program, printed.precision)[: len(program.inputs)], f"{real} *restrict angle"]
    read = {a for i in angles.first for a in i.args if isinstance(a, int)} | {a for a, *_ in angles.gathered}
    return [
        declare(f"{printed.symbol}_angles", given, f"static inline {inline}void "),
        "{",
        "    (void)stride;",
        *printed._unused(program.inputs, read),
        *printed._loads(read),
        *_statements(printed, angles.first),
        *(f"    angle[{printed.at(k)}] = {printed.operand(a)};" for k, (a, *_) in enumerate(angles.gathered)),
        "}",
        "",
    ]


def packed_lane(printed: Printed, packing: Packing) -> list[str]:
    """`<symbol>_packed_lane`: the same as the lane of one state, with equal limbs side by side."""
    entered = {*range(len(input_entries(printed.program))), *(s for _, *pair in printed.angles.gathered for s in pair)}
    body = c_lanes.Body(
        printed.model, packing, printed.precision, printed.prefix, {s for s in entered if s is not None}
    )
    statements = c_lanes.statements(body, {i.target: i for i in printed.angles.rest}, wrapped_code)
    head = f"static inline {printed.precision.real} "
    before = len(body.lines)
    lines = _lane(printed, f"{printed.symbol}_packed_lane", head, statements, body.scalar, lambda: body.lines[before:])
    return [f"#if {c_lanes.condition(printed.model, packing.width, printed.precision)}", *lines, "#endif"]


def _lane(
    printed: Printed,
    symbol: str,
    head: str,
    body: Sequence[str],
    operand: Callable[[int | float], str],
    late: Callable[[], Sequence[str]] = tuple,
) -> list[str]:
    """A function around the statements of a lane; `late` gives those that naming its results has added."""
    program, real, angles = printed.program, printed.precision.real, printed.angles
    given = ["size_t stride", *arguments(program, printed.precision)]
    given += [f"const {real} *restrict sine", f"const {real} *restrict cosine"] if angles.gathered else []
    given += [f"{real} *restrict pivot"] if program.guards else []
    pivots = [slot for slot, _ in program.guards]
    read = {a for i in angles.rest for a in i.args if isinstance(a, int)} | set(checked_slots(program))
    lines = [declare(symbol, given, head), "{"]
    lines += printed._unused(program.inputs, read)
    lines += [f"    (void){printed.names[port.name]};" for port in program.outputs if not port.size]
    lines += ["    (void)stride;"]
    lines += printed._loads(read)
    for k, (_, *pair) in enumerate(angles.gathered):
        for array, slot in zip(("sine", "cosine"), pair, strict=True):
            if slot is not None:
                lines.append(f"    const {real} {printed.prefix}{slot} = {array}[{printed.at(k)}];")
    for name, which in (("sine", 1), ("cosine", 2)) if angles.gathered else ():
        if all(entry[which] is None for entry in angles.gathered):
            lines.append(f"    (void){name};")
    ends = [f"    pivot[{printed.at(k)}] = {operand(slot)};" for k, slot in enumerate(pivots)]
    for port, slots in zip(program.outputs, program.results, strict=True):
        ends += [f"    {printed.names[port.name]}[{printed.at(k)}] = {operand(s)};" for k, s in enumerate(slots)]
    checked = [operand(slot) for slot in checked_slots(program)] or [printed.precision.number(0.0)]
    return [*lines, *body, *late(), *ends, *wrapped_code(f"return {balanced_sum(checked)};"), "}"]


def _statements(printed: Printed, instructions: Iterable) -> list[str]:
    real, table = printed.precision.real, printed.precision.table
    found = expressions(instructions, table, printed.operand)
    return [f"    const {real} {printed.prefix}{target} = {text};" for target, text in found]


def outcome(printed: Printed, total: str, step: str = "", plus: str = "") -> str:
    """The status of a state by its pivots and the sum of its results."""
    fabs = printed.precision.function("fabs")
    tests = [
        f"{fabs}(pivot[{k}{step}{plus}]) <= {printed.precision.threshold(t)}"
        for k, (_, t) in enumerate(printed.program.guards)
    ]
    if not checked_slots(printed.program):
        return "0"
    guards = f"{' || '.join(tests)} ? 1 : " if tests else ""
    return f"{guards}!isfinite({total}) ? 2 : 0"


def function(printed: Printed, signature: str, second: str = "") -> list[str]:
    """A function of one state: its lane with a stride of 1, checked; `second` is its way out of small pivots."""
    program, precision = printed.program, printed.precision
    real, count = precision.real, len(printed.angles.gathered)
    group, zero = precision.group, precision.number(0.0)
    packing = printed.packing
    lines = [*packed_lane(printed, packing), ""] if packing else []
    lines += [signature, "{"]
    if count:
        size = -(-count // group) * group
        lines += [
            f"    {real} angle[{size}] = {{{zero}}}, sine[{size}] = {{{zero}}}, cosine[{size}] = {{{zero}}};",
            *wrapped_code(f"{printed.symbol}_angles({', '.join(['1', *printed.handed(outputs=False), 'angle'])});"),
            *(f"    angle[{k}] = angle[{count - 1}];" for k in range(count, size)),
            *calls(printed.model, count, precision),
        ]
    if program.guards:
        lines += [f"    {real} pivot[{len(program.guards)}] = {{{zero}}};"]
    handed = ["1", *printed.handed(), *(["sine", "cosine"] if count else []), *(["pivot"] if program.guards else [])]
    call = f"{printed.symbol}_lane({', '.join(handed)});"
    side_by_side = f"{printed.symbol}_packed_lane({', '.join(handed)});"
    if not checked_slots(program):
        return [*lines, *wrapped_code(f"(void){call}"), "    return 0;", "}"]
    single = wrapped_code(f"const {real} total = {call}")
    if packing:
        condition = c_lanes.condition(printed.model, packing.width, precision)
        side = [f"    (void){printed.symbol}_lane;", *wrapped_code(f"const {real} total = {side_by_side}")]
        lines += [f"#if {condition}", *side, "#else", *single, "#endif"]
    else:
        lines += single
    lines += wrapped_code(f"const int outcome = {outcome(printed, 'total')};")
    if second and program.guards:
        lines += ["    if (outcome == 1) {", f"        return {second};", "    }"]
    lines += ["    if (outcome != 0) {"]
    for port in (p for p in program.outputs if p.size):
        lines += [f"        {printed.model}_set_nan({printed.names[port.name]}, {port.size});"]
    return [*lines, "    }", "    return outcome;", "}"]
