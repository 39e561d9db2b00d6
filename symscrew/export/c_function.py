"""Straight-line functions in C.

`<symbol>_lane` has the operations of one state. Sines and cosines of input angles come ready, from `<symbol>_angles`
and `c_angles`. Where equal limbs make it pay, one state has a second form with limbs side by side (see `c_lanes`);
several states side by side are another one (see `c_wide`): a `Form` says what is different in the text.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from symscrew.export import c_lanes, c_unread
from symscrew.export.c_angles import calls
from symscrew.export.c_names import arguments, declare, wrapped_code
from symscrew.export.c_printed import Form, Printed, place
from symscrew.export.listing import balanced_sum, checked_slots, expressions
from symscrew.program import Instruction, Packing

SUMS = 4  # of what must be finite, side by side: one alone is a chain of additions that wait for each other


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
    body = _Body(printed, form)
    for array, k, slot in stored:
        body.goes_to(slot, form.written.format(place(array, k, form.stride)))
    firsts, others = c_unread.fours(printed.inputs, body.waiting)
    if form.stride == "1" and firsts:
        body.sum_fours(firsts, others)
    used = {s for i in printed.order for s in (i.target, *i.args) if isinstance(s, int)}
    used |= {slot for slot in body.slots.values() if isinstance(slot, int)}
    for slot in [s for s in body.waiting if s not in used]:
        body.read(slot)
        body.ready(slot)
    texts = expressions(printed.order, form.table, printed.operand)
    for instruction, (target, text) in zip(printed.order, texts, strict=True):
        for arg in instruction.args:
            body.read(arg)
        body.known.add(target)
        body.lines.append(f"const {form.real} {printed.prefix}{target} = {text};")
        body.ready(target)
    for slot in [*(body.slots[text] for text in body.places), *body.waiting]:
        body.read(slot)
        body.ready(slot)
    sums = [f"sum{k}" for k in range(min(body.terms, SUMS))]
    return body.lines, balanced_sum(sums or [printed.precision.number(0.0)])


class _Body:
    """Statements while they are written: what is read already, where results go, and what is to be summed yet."""

    def __init__(self, printed: Printed, form: Form) -> None:
        self.printed, self.form, self.entered = printed, form, printed.entered(form)
        self.lines: list[str] = []
        self.known: set[int] = set()
        self.places: dict[str, list[str]] = {}  # by the text of what goes there: as keys 1.0 and slot 1 are one
        self.slots: dict[str, int | float] = {}
        self.waiting = dict.fromkeys(checked_slots(printed.program))
        self.terms = 0

    def goes_to(self, slot: int | float, at: str) -> None:
        """A result is stored at a place."""
        text = self.printed.operand(slot)
        self.places.setdefault(text, []).append(at)
        self.slots[text] = slot

    def sum_fours(self, firsts: Sequence[int], others: Iterable[int]) -> None:
        """The sum starts with inputs that are only checked, four at a time."""
        self.waiting = dict.fromkeys(others)
        self.lines.append(c_unread.statement(self.printed.model, self.printed.inputs, firsts))
        self.lines.append(f"{self.form.real} sum0 = {c_unread.total(self.printed.model)};")
        self.terms = 1

    def read(self, slot: int | float) -> None:
        """A slot that is there from the start gets its variable when it is first needed."""
        if isinstance(slot, int) and slot not in self.known:
            self.known.add(slot)
            self.lines.append(f"const {self.form.real} {self.printed.prefix}{slot} = {self.entered[slot]};")

    def ready(self, slot: int | float) -> None:
        """What is known goes to its places, and into the sum."""
        operand = self.printed.operand(slot)
        text = operand if isinstance(slot, int) else self.form.constant.format(operand)
        self.lines.extend(f"{at} = {text};" for at in self.places.pop(operand, ()))
        if isinstance(slot, int) and slot in self.waiting:
            del self.waiting[slot]
            name = f"sum{self.terms % SUMS}"
            summed = f"{name} = {name} + {text};" if self.terms >= SUMS else f"{self.form.real} {name} = {text};"
            self.lines.append(summed)
            self.terms += 1


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


def _statements(printed: Printed, instructions: Iterable[Instruction]) -> list[str]:
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
