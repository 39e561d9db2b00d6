"""Straight-line functions in C.

The operations of a function are printed once, as `<symbol>_lane`, in which entry k of an argument lies at
k * stride and entry k of our own arrays at k * pitch: both are 1 for one state, and the pitch is 8 for one of eight
states that lie side by side (see `c_batch`). Sines and cosines of input angles come ready, from `<symbol>_angles` and
`c_angles`. Where equal limbs make it pay, one state has a second form with limbs side by side (see `c_lanes`).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby

from symscrew.export import c_lanes
from symscrew.export.c_angles import Angles, calls, gather
from symscrew.export.c_order import short_lived
from symscrew.export.c_precision import Precision
from symscrew.export.listing import balanced_sum, checked_slots, expressions, input_entries, live_instructions, wrapped
from symscrew.packs import Packing, packed
from symscrew.program import Iteration, Port, Program

NAMES_OF_MATH = "sin cos tan sqrt exp atan2 fabs isfinite NAN NULL INFINITY HUGE_VAL size_t M_PI M_E I errno assert"
NAMES_OF_MATH += " sinf cosf tanf sqrtf expf atan2f fabsf"
NAMES_OF_LOCALS = "count status k worst outcome total next residual change orientation start substeps most"
NAMES_OF_LOCALS += " rate_scale row_scale inertia load closure curvature turn work multipliers rank sized shifted"
NAMES_OF_LOCALS += " loads columns mix amount internal moved part factor largest i j"
NAMES_OF_LOCALS += " angle sine cosine pivot stride pitch lane index first some block blocks number"
NAMES_OF_LOCALS += " every sum sum0 sum1 sum2 sum3 waiting at constant"
ALONE = ("1", "1")  # stride and pitch of one state
PACKED = range(100, 2000)  # instructions of functions that are tried in lanes
PER_OUTPUT = 6  # and how many there are for every output: else the time goes into taking results out
SUMS = 4  # of what must be finite: one alone is a long chain of additions that wait for each other
RUN = 8  # zeros in a row that are written by a loop
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
        return packed(self.angles.rest, kept)

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

    def at(self, entry: int, step: str = "stride") -> str:
        """The place of an entry in an array of a lane: `stride` apart in arguments, `pitch` in arrays of our own."""
        return ("0", step)[entry] if entry < 2 else f"{entry} * {step}"

    @cached_property
    def entered(self) -> dict[int, str]:
        """Where slots are that are there from the start: entries of inputs, sines and cosines."""
        entries = enumerate(input_entries(self.program))
        found = {slot: f"{self.names[port.name]}[{self.at(k)}]" for slot, (port, k) in entries}
        for k, (_, *pair) in enumerate(self.angles.gathered):
            pairs = zip(("sine", "cosine"), pair, strict=True)
            found |= {slot: f"{array}[{self.at(k, 'pitch')}]" for array, slot in pairs if slot is not None}
        return found

    def loads(self, slots: Iterable[int]) -> list[str]:
        """Statements that read slots that are there from the start."""
        return [f"    const {self.precision.real} {self.prefix}{s} = {self.entered[s]};" for s in slots]

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
    def stored(self) -> list[tuple[str, int | float]]:
        """The entries of outputs and pivots, and what goes there, but for zeros that are there already."""
        outputs = zip(self.program.outputs, self.program.results, strict=True)
        cleared = {(name, k) for name, run in self.cleared for k in run}
        named = [(self.names[port.name], slots) for port, slots in outputs]
        entries = [(name, k, s) for name, slots in named for k, s in enumerate(slots) if (name, k) not in cleared]
        found = [(f"{name}[{self.at(k)}]", slot) for name, k, slot in entries]
        return found + [(f"pivot[{self.at(k, 'pitch')}]", slot) for k, (slot, _) in enumerate(self.program.guards)]

    def unused(self, ports: Iterable[Port], read: set[int]) -> list[str]:
        """Nothing is said of ports of which nothing is read."""
        entries = input_entries(self.program)
        used = {entries[slot][0].name for slot in read if slot < len(entries)}
        return [f"    (void){self.names[port.name]};" for port in ports if port.name not in used]


def lane(printed: Printed, *, inline: str = "") -> list[str]:
    """`<symbol>_angles` and `<symbol>_lane`: everything but the decision about the status.

    The lane returns the sum of all that must be finite and leaves its pivots in `pivot`. What it reads is read
    where it is first needed, and results are written and summed where they are known, so that few values live at once.
    """
    head = f"static inline {inline}{printed.precision.real} "
    body = [f"    {statement}" for statement in _streamed(printed)]
    return [*angles_function(printed, inline=inline), *_lane(printed, f"{printed.symbol}_lane", head, body)]


def _streamed(printed: Printed) -> Iterator[str]:
    """The statements of a lane."""
    real, prefix, operand = printed.precision.real, printed.prefix, printed.operand
    known: set[int] = set()
    places: dict[str, list[str]] = {}  # by the text of what goes there: as keys the constant 1.0 and slot 1 are one
    for place, slot in printed.stored:
        places.setdefault(operand(slot), []).append(place)
    waiting = dict.fromkeys(checked_slots(printed.program))
    terms = 0

    def first_read(slot: int | float) -> Iterator[str]:
        if isinstance(slot, int) and slot not in known:
            known.add(slot)
            yield f"const {real} {prefix}{slot} = {printed.entered[slot]};"

    def ready(slot: int | float) -> Iterator[str]:
        nonlocal terms
        yield from (f"{place} = {operand(slot)};" for place in places.pop(operand(slot), ()))
        if isinstance(slot, int) and slot in waiting:
            del waiting[slot]
            name = f"sum{terms % SUMS}"
            yield f"{name} = {name} + {operand(slot)};" if terms >= SUMS else f"{real} {name} = {operand(slot)};"
            terms += 1

    instructions = short_lived(printed.angles.rest)
    texts = expressions(instructions, printed.precision.table, operand)
    for instruction, (target, text) in zip(instructions, texts, strict=True):
        for arg in instruction.args:
            yield from first_read(arg)
        known.add(target)
        yield f"const {real} {prefix}{target} = {text};"
        yield from ready(target)
    left = {operand(slot): slot for _, slot in printed.stored}
    for slot in (*(left[text] for text in places), *waiting):
        yield from first_read(slot)
        yield from ready(slot)
    sums = [f"sum{k}" for k in range(min(terms, SUMS))]
    yield f"return {balanced_sum(sums or [printed.precision.number(0.0)])};"


def angles_function(printed: Printed, *, inline: str = "") -> list[str]:
    """`<symbol>_angles`, if the function has any: the angles whose sines and cosines come first."""
    program, real, angles = printed.program, printed.precision.real, printed.angles
    if not angles.gathered:
        return []
    strides = ["size_t stride", "size_t pitch"]
    given = [*strides, *arguments(program, printed.precision)[: len(program.inputs)], f"{real} *restrict angle"]
    read = {a for i in angles.first for a in i.args if isinstance(a, int)} | {a for a, *_ in angles.gathered}
    return [
        declare(f"{printed.symbol}_angles", given, f"static inline {inline}void "),
        "{",
        "    (void)stride;",
        "    (void)pitch;",
        *printed.unused(program.inputs, read),
        *printed.loads(sorted(read & set(printed.entered) - {i.target for i in angles.first})),
        *_statements(printed, angles.first),
        *(f"    angle[{printed.at(k, 'pitch')}] = {printed.operand(a)};" for k, (a, *_) in enumerate(angles.gathered)),
        "}",
        "",
    ]


def packed_lane(printed: Printed, packing: Packing) -> list[str]:
    """`<symbol>_packed_lane`: results of one state with equal limbs side by side, and the sum of what must be finite.

    At a small pivot this sum is NaN, and pivots are not given: the lane of limb after limb finds out what is wrong.
    """
    program = printed.program
    read = _read(printed)
    entered = [slot for slot in printed.entered if slot in read]
    body = c_lanes.Body(printed.model, packing, printed.precision, printed.prefix, set(entered))
    stored = printed.stored[: len(printed.stored) - len(program.guards)]
    c_lanes.statements(body, {i.target: i for i in printed.angles.rest}, stored)
    c_lanes.total(body, checked_slots(program), program.guards)
    lines = [*printed.loads(entered), *(line for text in body.lines for line in wrapped_code(text))]
    lines = _lane(
        printed, f"{printed.symbol}_packed_lane", f"static inline {printed.precision.real} ", lines, pivots=False
    )
    return [f"#if {c_lanes.condition(printed.model, packing.width, printed.precision)}", *lines, "#endif"]


def _read(printed: Printed) -> set[int]:
    """The slots that a lane reads."""
    read = {a for i in printed.angles.rest for a in i.args if isinstance(a, int)}
    return read | {slot for _, slot in printed.stored if isinstance(slot, int)} | set(checked_slots(printed.program))


def _lane(printed: Printed, symbol: str, head: str, body: Sequence[str], *, pivots: bool = True) -> list[str]:
    """A function around the statements of a lane."""
    program, real, gathered = printed.program, printed.precision.real, printed.angles.gathered
    given = ["size_t stride", "size_t pitch", *arguments(program, printed.precision)]
    given += [f"const {real} *restrict sine", f"const {real} *restrict cosine"] if gathered else []
    given += [f"{real} *restrict pivot"] if program.guards and pivots else []
    lines = [declare(symbol, given, head), "{"]
    lines += printed.unused(program.inputs, _read(printed))
    lines += [f"    (void){printed.names[port.name]};" for port in program.outputs if not port.size]
    for name, which in (("sine", 1), ("cosine", 2)) if gathered else ():
        if all(entry[which] is None for entry in gathered):
            lines.append(f"    (void){name};")
    return [*lines, "    (void)stride;", "    (void)pitch;", *body, "}"]


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
    if not printed.packing:
        return _one_by_one(printed, signature, second)
    condition = f"#if {c_lanes.condition(printed.model, printed.packing.width, printed.precision)}"
    apart = declare(f"{printed.symbol}_limb_by_limb", arguments(printed.program, printed.precision), "int ")
    handed = [*ALONE, *printed.handed(), *(["sine", "cosine"] if printed.angles.gathered else [])]
    return [
        *packed_lane(printed, printed.packing),
        "",
        *(condition, "__attribute__((noinline))", "#endif"),
        *_one_by_one(printed, f"static {apart}", second),
        "",
        signature,
        "{",
        condition,
        *_sines(printed),
        *_zeros(printed),
        *wrapped_code(f"if (isfinite({printed.symbol}_packed_lane({', '.join(handed)}))) {{"),
        "        return 0;",
        "    }",
        "#endif",
        *wrapped_code(f"return {printed.symbol}_limb_by_limb({', '.join(printed.handed())});"),
        "}",
    ]


def _sines(printed: Printed) -> list[str]:
    """Sines and cosines of one state's angles."""
    real, count, group = printed.precision.real, len(printed.angles.gathered), printed.precision.group
    if not count:
        return []
    size, zero = -(-count // group) * group, printed.precision.number(0.0)
    return [
        f"    {real} angle[{size}] = {{{zero}}}, sine[{size}] = {{{zero}}}, cosine[{size}] = {{{zero}}};",
        *wrapped_code(f"{printed.symbol}_angles({', '.join([*ALONE, *printed.handed(outputs=False), 'angle'])});"),
        *(f"    angle[{k}] = angle[{count - 1}];" for k in range(count, size)),
        *calls(printed.model, count, printed.precision),
    ]


def _zeros(printed: Printed) -> list[str]:
    """Zeros of one state's outputs that the lane does not write."""
    return [
        line
        for name, run in printed.cleared
        for line in (
            f"    for (size_t k = {run.start}; k < {run.stop}; ++k) {{",
            f"        {name}[k] = {printed.precision.number(0.0)};",
            "    }",
        )
    ]


def _one_by_one(printed: Printed, signature: str, second: str) -> list[str]:
    program, precision = printed.program, printed.precision
    real, guards = precision.real, program.guards
    lines = [signature, "{", *_sines(printed), *_zeros(printed)]
    lines += [f"    {real} pivot[{len(guards)}] = {{{precision.number(0.0)}}};"] if guards else []
    handed = [*ALONE, *printed.handed(), *(["sine", "cosine"] if printed.angles.gathered else [])]
    call = f"{printed.symbol}_lane({', '.join([*handed, *(['pivot'] if guards else [])])});"
    if not checked_slots(program):
        return [*lines, *wrapped_code(f"(void){call}"), "    return 0;", "}"]
    lines += wrapped_code(f"const {real} total = {call}")
    lines += wrapped_code(f"const int outcome = {outcome(printed, 'total')};")
    if second and guards:
        lines += ["    if (outcome == 1) {", f"        return {second};", "    }"]
    lines += ["    if (outcome != 0) {"]
    for port in (p for p in program.outputs if p.size):
        lines += [f"        {printed.model}_set_nan({printed.names[port.name]}, {port.size});"]
    return [*lines, "    }", "    return outcome;", "}"]
