"""Straight-line functions in C.

`<symbol>_lane` has the operations of one state. Sines and cosines of input angles come ready, from `<symbol>_angles`
and `c_angles`. Where equal limbs make it pay, one state has a second form with limbs side by side (see `c_lanes`);
several states side by side are another one (see `c_wide`): a `Form` says what is different in the text.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby

from symscrew.export import c_lanes, c_unread
from symscrew.export.c_angles import Angles, calls, gather
from symscrew.export.c_order import short_lived
from symscrew.export.c_precision import Precision
from symscrew.export.listing import balanced_sum, checked_slots, expressions, input_entries, live_instructions, wrapped
from symscrew.program import Instruction, Iteration, Packing, Port, Program, packed

NAMES_OF_MATH = "sin cos tan sqrt exp atan2 fabs isfinite NAN NULL INFINITY HUGE_VAL size_t M_PI M_E I errno assert"
NAMES_OF_MATH += " sinf cosf tanf sqrtf expf atan2f fabsf"
NAMES_OF_LOCALS = "count status k worst outcome total next residual change orientation start substeps most"
NAMES_OF_LOCALS += " rate_scale row_scale inertia load closure curvature turn work multipliers rank sized shifted"
NAMES_OF_LOCALS += " loads columns mix amount internal moved part factor largest i j"
NAMES_OF_LOCALS += " angle sine cosine pivot stride pitch lane index first some block blocks number"
NAMES_OF_LOCALS += " every fours sum sum0 sum1 sum2 sum3 waiting at constant"
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
        guards = [slot for slot, _ in self.program.guards]
        arrays = {slot: array for slot, (array, _) in self.entries.items()}
        return packed(self.angles.rest, kept, [*guards, *checked_slots(self.program)], arrays)

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
    def order(self) -> list[Instruction]:
        """Everything else, in an order that suits registers."""
        return short_lived(self.angles.rest)

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
        return [f"    const {form.real} {self.prefix}{s} = {entered[s]};" for s in slots]

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


def inlined(printed: Printed) -> str:
    """The storage of a function that is called once: on its own, derivatives of the seed take a sixth more time."""
    return f"static inline {printed.model.upper()}_INLINE"


def lane(printed: Printed) -> list[str]:
    """`<symbol>_angles` and `<symbol>_lane`: everything of one state but the decision about the status.

    The lane returns the sum of all that must be finite and leaves its pivots in `pivot`.
    """
    pivots = [("pivot", k, slot) for k, (slot, _) in enumerate(printed.program.guards)]
    found, total = statements(printed, printed.alone, [*printed.stored, *pivots])
    body = [*(f"    {statement}" for statement in found), f"    return {total};"]
    head = f"{inlined(printed)} {printed.precision.real} "
    return [*angles_function(printed), *_lane(printed, f"{printed.symbol}_lane", head, body)]


def statements(printed: Printed, form: Form, stored: Iterable[tuple[str, int, int | float]]) -> tuple[list[str], str]:
    """The statements of a function in a form, and the sum of all that must be finite.

    What is read is read where it is first needed, results are written and summed where they are known, so that few
    values live at once. What is only summed comes first: at the end it would wait for the results in its sum.
    """
    prefix, operand, entered = printed.prefix, printed.operand, printed.entered(form)
    lines: list[str] = []
    known: set[int] = set()
    places: dict[str, list[str]] = {}  # by the text of what goes there: as keys the constant 1.0 and slot 1 are one
    slots: dict[str, int | float] = {}
    for array, k, slot in stored:
        places.setdefault(operand(slot), []).append(form.written.format(place(array, k, form.stride)))
        slots[operand(slot)] = slot
    waiting = dict.fromkeys(checked_slots(printed.program))
    terms = 0

    def first_read(slot: int | float) -> None:
        if isinstance(slot, int) and slot not in known:
            known.add(slot)
            lines.append(f"const {form.real} {prefix}{slot} = {entered[slot]};")

    def ready(slot: int | float) -> None:
        nonlocal terms
        text = operand(slot) if isinstance(slot, int) else form.constant.format(operand(slot))
        lines.extend(f"{at} = {text};" for at in places.pop(operand(slot), ()))
        if isinstance(slot, int) and slot in waiting:
            del waiting[slot]
            name = f"sum{terms % SUMS}"
            lines.append(f"{name} = {name} + {text};" if terms >= SUMS else f"{form.real} {name} = {text};")
            terms += 1

    firsts, others = c_unread.fours(printed.inputs, waiting)
    if form.stride == "1" and firsts:
        waiting = dict.fromkeys(others)
        lines.append(c_unread.statement(printed.model, printed.inputs, firsts))
        lines.append(f"{form.real} sum0 = {c_unread.total(printed.model)};")
        terms = 1
    used = {s for i in printed.order for s in (i.target, *i.args) if isinstance(s, int)}
    used |= {slot for slot in slots.values() if isinstance(slot, int)}
    for slot in [s for s in waiting if s not in used]:
        first_read(slot)
        ready(slot)
    texts = expressions(printed.order, form.table, operand)
    for instruction, (target, text) in zip(printed.order, texts, strict=True):
        for arg in instruction.args:
            first_read(arg)
        known.add(target)
        lines.append(f"const {form.real} {prefix}{target} = {text};")
        ready(target)
    for slot in [*(slots[text] for text in places), *waiting]:
        first_read(slot)
        ready(slot)
    return lines, balanced_sum([f"sum{k}" for k in range(min(terms, SUMS))] or [printed.precision.number(0.0)])


def angles_function(printed: Printed) -> list[str]:
    """`<symbol>_angles`, if the function has any: the angles whose sines and cosines come first."""
    program, real, angles = printed.program, printed.precision.real, printed.angles
    if not angles.gathered:
        return []
    form = Form(real, printed.precision.table, "stride", "pitch")
    strides = ["size_t stride", "size_t pitch"]
    given = [*strides, *arguments(program, printed.precision)[: len(program.inputs)], f"{real} *restrict angle"]
    read = {a for i in angles.first for a in i.args if isinstance(a, int)} | {a for a, *_ in angles.gathered}
    return [
        declare(f"{printed.symbol}_angles", given, f"{inlined(printed)} void "),
        "{",
        "    (void)stride;",
        "    (void)pitch;",
        *printed.unused(program.inputs, read),
        *printed.loads(sorted(read & set(printed.entries) - {i.target for i in angles.first}), form),
        *_statements(printed, angles.first),
        *(f"    {place('angle', k, 'pitch')} = {printed.operand(a)};" for k, (a, *_) in enumerate(angles.gathered)),
        "}",
        "",
    ]


def packed_lane(printed: Printed, packing: Packing) -> list[str]:
    """`<symbol>_packed_lane`: results of one state with equal limbs side by side, and the sum of what must be finite.

    At a small pivot this sum is NaN, and pivots are not given: the lane of limb after limb finds out what is wrong.
    """
    program = printed.program
    read = _read(printed)
    entered = [slot for slot in printed.entries if slot in read]
    body = c_lanes.Body(printed.model, packing, printed.precision, printed.prefix, set(entered))
    stored = [(place(name, k), slot) for name, k, slot in printed.stored]
    c_lanes.statements(body, {i.target: i for i in printed.angles.rest}, stored)
    c_lanes.total(body, checked_slots(program), program.guards, printed.inputs)
    lines = [*printed.loads(entered, printed.alone), *(line for text in body.lines for line in wrapped_code(text))]
    head = f"{inlined(printed)} {printed.precision.real} "
    lines = _lane(printed, f"{printed.symbol}_packed_lane", head, lines, pivots=False)
    return [f"#if {c_lanes.condition(printed.model, packing.width, printed.precision)}", *lines, "#endif"]


def _read(printed: Printed) -> set[int]:
    """The slots that a lane reads."""
    read = {a for i in printed.angles.rest for a in i.args if isinstance(a, int)}
    read |= {slot for *_, slot in printed.stored if isinstance(slot, int)} | {s for s, _ in printed.program.guards}
    return read | set(checked_slots(printed.program))


def _lane(printed: Printed, symbol: str, head: str, body: Sequence[str], *, pivots: bool = True) -> list[str]:
    """A function around the statements of one state."""
    real = printed.precision.real
    given = [*arguments(printed.program, printed.precision), *sines(printed)]
    given += [f"{real} *restrict pivot"] if printed.program.guards and pivots else []
    return [declare(symbol, given, head), "{", *unread(printed), *body, "}"]


def sines(printed: Printed) -> list[str]:
    """The declared arguments for sines and cosines of angles, if there are any."""
    real = printed.precision.real
    return [f"const {real} *restrict {name}" for name in ("sine", "cosine")] if printed.angles.gathered else []


def unread(printed: Printed) -> list[str]:
    """Nothing is said of arguments that are not read or written."""
    gathered = printed.angles.gathered
    lines = printed.unused(printed.program.inputs, _read(printed))
    lines += [f"    (void){printed.names[port.name]};" for port in printed.program.outputs if not port.size]
    for name, which in (("sine", 1), ("cosine", 2)) if gathered else ():
        if all(entry[which] is None for entry in gathered):
            lines.append(f"    (void){name};")
    return lines


def _statements(printed: Printed, instructions: Iterable) -> list[str]:
    real, table = printed.precision.real, printed.precision.table
    found = expressions(instructions, table, printed.operand)
    return [f"    const {real} {printed.prefix}{target} = {text};" for target, text in found]


def outcome(printed: Printed, total: str) -> str:
    """The status of a state by its pivots and the sum of its results."""
    fabs = printed.precision.function("fabs")
    limits = [printed.precision.threshold(threshold) for _, threshold in printed.program.guards]
    tests = [f"{fabs}(pivot[{k}]) <= {limit}" for k, limit in enumerate(limits)]
    if not checked_slots(printed.program):
        return "0"
    guards = f"{' || '.join(tests)} ? 1 : " if tests else ""
    return f"{guards}!isfinite({total}) ? 2 : 0"


def function(printed: Printed, signature: str, second: str = "") -> list[str]:
    """A function of one state: its lane, checked; `second` is its way out of small pivots."""
    if not printed.packing:
        return _one_by_one(printed, signature, second)
    condition = f"#if {c_lanes.condition(printed.model, printed.packing.width, printed.precision)}"
    apart = declare(f"{printed.symbol}_limb_by_limb", arguments(printed.program, printed.precision), "int ")
    handed = [*printed.handed(), *(["sine", "cosine"] if printed.angles.gathered else [])]
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
        *wrapped_code(f"{printed.symbol}_angles({', '.join(['1', '1', *printed.handed(outputs=False), 'angle'])});"),
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
    handed = [*printed.handed(), *(["sine", "cosine"] if printed.angles.gathered else [])]
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
