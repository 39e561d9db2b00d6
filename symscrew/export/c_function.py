"""Straight-line functions in C.

`<symbol>_lane` has the operations of one state. Sines and cosines of input angles come ready, from `<symbol>_angles`
and `c_angles`. Where equal limbs make it pay, one state has a second form with limbs side by side (see `c_lanes`);
several states side by side are another one (see `c_wide`): a `Form` says what is different in the text.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from symscrew.export import c_lanes, c_unread
from symscrew.export.c_angles import calls
from symscrew.export.c_hub import Hub, hub_of
from symscrew.export.c_limbs import LIMBS, LimbText
from symscrew.export.c_names import arguments, c_lines, declare, grouped, wrapped_code
from symscrew.export.c_printed import Form, Printed, place
from symscrew.export.folding import folded
from symscrew.export.listing import balanced_sum, checked_slots, expressions, plain
from symscrew.export.pivots import pivot_text
from symscrew.export.stages import headed
from symscrew.program import OUT_OF_REACH, Packing, status_texts

LARGE = 100  # rows of a stage in the mean from which on stages are shorter text in any case; below, both are printed
# Of the text that stages must leave: where they save less, limbs are not very equal. Any less will do where roots begin
# early by stages, for they save time: delta's drives from the platform's motion, one mode, take 0.91.
SHORTER = 0.85
SUMS = 4  # of what must be finite, side by side: one alone is a chain of additions that wait for each other


def inlined(printed: Printed) -> str:
    """The storage of a function that is called once: on its own, derivatives of the seed take a sixth more time."""
    return f"static inline {printed.model.upper()}_INLINE"


def body(printed: Printed) -> list[str]:
    """The body of a function, for one state or for several side by side, as the macros of `c_widths` say.

    What is read is read where it is first needed, results are written and summed where they are known, so that few
    values live at once. What is only checked comes first: at the end it would wait for the results in its sum.
    """
    staged = printed.staged
    if staged is None:
        return _body(printed, None)
    text = _body(printed, LimbText(printed, staged))
    if staged.lanes or len(staged.rows) >= LARGE * len(staged.stages):
        return text
    whole = _body(printed, None)
    return text if sum(map(len, text)) < (1.0 if staged.early else SHORTER) * sum(map(len, whole)) else whole


def _body(printed: Printed, limbs: LimbText | None) -> list[str]:
    """A body with what equal limbs do in stages, or limb after limb in one text."""
    real = printed.precision.real
    given = ["size_t stride", *arguments(printed.program, printed.precision), *sines(printed)]
    head = declare(f"BODY({printed.symbol})", [*given, f"{real} *restrict total"], "")
    inner = _Body(printed, limbs)
    own = [f"    LIMBS({limbs.function}) {LIMBS};"] if limbs and limbs.hands_on else []
    lines = [*unread(printed), *own, *c_lines(grouped(inner.lines()))]
    return [*(limbs.head() if limbs else []), head, "{", *lines, "}"]


class _Body:
    """Statements while they are written: where results go, and what is to be checked yet."""

    def __init__(self, printed: Printed, limbs: LimbText | None) -> None:
        self.printed, self.limbs = printed, limbs
        slots = {slot: slot for slot in printed.program.tested}
        stored, table = printed.stored, dict(printed.precision.body_table)
        self.hub = hub_of(limbs) if limbs else Hub(printed.order, dict(printed.called), table, stored, slots)
        self.called = self.hub.called
        own = ("sine", "cosine")
        self.entered = {
            slot: f"{'SINES' if array in own else 'READ'}({array}, {k})" for slot, (array, k) in printed.entries.items()
        }
        self.written: list[tuple[str, int | None]] = []  # statements, and the slot that each serves
        self.places: dict[int, list[tuple[str, int]]] = {}
        self.constants: list[str] = []
        for array, k, slot in self.hub.stored:
            if isinstance(slot, int):
                self.places.setdefault(slot, []).append((array, k))
            else:
                self.constants.append(f"WRITE({array}, {k}, CONSTANT({printed.named(slot)}));")
        self.waiting = dict.fromkeys(limbs.checked if limbs else checked_slots(printed.program))
        self.terms = 0
        self.begun: set[str] = set()  # stages of which a limb has been called

    def _named(self, value: int | float) -> str:
        """A slot by its name, or a constant by its own."""
        return self.called[value] if isinstance(value, int) else self.printed.number(value)

    def lines(self) -> list[str]:
        """The statements under headings, the last of which gives the state's status."""
        printed, hub = self.printed, self.hub
        uses = Counter(a for i in hub.order for a in i.args if isinstance(a, int))
        read = set(uses)
        for slot, places in self.places.items():
            uses[slot] += len(places)
        tested = set(hub.tested.values())
        uses.update(hub.tested.values())
        uses.update(slot for slot in self.waiting if slot not in self.places)
        uses.update(hub.read)
        uses.update(dict.fromkeys([*hub.hands_on, *hub.given], 2))  # statements of their own
        self._inputs(uses)
        known = set[int]()
        found = folded(
            hub.order, uses, hub.table, name=self._named, places=self.entered,
            ends=lambda slot: slot not in read and slot not in tested,
        )  # fmt: skip
        for item in found:
            if item.kind == "last":
                self._last(item.slot, item.text)
            elif item.slot in hub.hands_on:
                self._stage(item.slot, item.text)
            elif item.slot in hub.given:
                assert self.limbs is not None
                self._write(f"const EACH{self.limbs.count} {self.called[item.slot]} = {item.text};")
            else:
                text = item.text or self.entered[item.slot]
                self._write(f"const REAL {self.called[item.slot]} = {text};", item.slot)
                if item.kind == "named" or item.slot in self.places or item.slot in self.waiting:
                    self._ready(item.slot)
                known.add(item.slot)
        for slot in [*self.places, *self.waiting, *tested]:
            if slot in self.entered and slot not in known:
                known.add(slot)
                self._write(f"const REAL {self.called[slot]} = {self.entered[slot]};", slot)
                self._ready(slot)
        return [
            *headed(self.written, printed.stages, lambda slot: self.called.get(slot, "")),
            *self.constants,
            *self._limits(),
            *self._status(),
        ]

    def _stage(self, call: int, text: str) -> None:
        """A limb's stage; the first limb's, in text, is that of all of them where they are side by side."""
        stage = text.split(", ")[2]
        self._write(f"{'NEXT' if stage in self.begun else 'FIRST'}_{text};")
        self.begun.add(stage)
        for slot in self.hub.hands_on[call]:
            self._ready(slot)
        if call in self.hub.sums:
            self._checked(f"ALONE({self.hub.sums[call]})")

    def _write(self, text: str, slot: int | None = None) -> None:
        self.written.append((text, slot))

    def _inputs(self, uses: Counter[int]) -> None:
        """What is read only to be checked: inputs of functions that leave out what a scene does not call for."""
        only = [s for s in self.waiting if s in self.entered and uses[s] == 1 and s not in self.places]
        firsts, others = c_unread.fours(self.printed.inputs, only)
        terms = [f"FOUR({array}, {k})" for array, k in (self.printed.inputs[slot] for slot in firsts)]
        if terms:
            self._write(f"const FOURS fours = {balanced_sum(terms)};")
            self._write("REAL checked0 = SUM_OF_FOUR(fours);")
            self.terms = 1
        for slot in only:
            del self.waiting[slot]
        for slot in others:
            self._checked(self.entered[slot], slot)

    def _last(self, slot: int, text: str) -> None:
        """A value that only goes to its place, or is only checked."""
        checked = slot in self.waiting
        self.waiting.pop(slot, None)
        ((array, k),) = self.places.pop(slot, [("", 0)])
        if not array:
            self._checked(text, slot)
        elif checked and self.terms >= SUMS:
            self._write(f"RESULT(checked{self.terms % SUMS}, {array}, {k}, {text});", slot)
            self.terms += 1
        elif checked:
            name = self.called[slot]
            self._write(f"const REAL {name} = {text};", slot)
            self._write(f"WRITE({array}, {k}, {name});", slot)
            self._checked(name, slot)
        else:
            self._write(f"WRITE({array}, {k}, {text});", slot)

    def _ready(self, slot: int) -> None:
        """What is known goes to its places, and into a sum."""
        name = self.called[slot]
        for array, k in self.places.pop(slot, ()):
            self._write(f"WRITE({array}, {k}, {name});", slot)
        if slot in self.waiting:
            del self.waiting[slot]
            self._checked(name, slot)

    def _checked(self, text: str, slot: int | None = None) -> None:
        """What must be finite goes into one of some sums, side by side."""
        name = f"checked{self.terms % SUMS}"
        loose = " " in text
        text = f"({text})" if loose and self.terms >= SUMS else text
        self._write(f"{name} = {name} + {text};" if self.terms >= SUMS else f"REAL {name} = {text};", slot)
        self.terms += 1

    def _limits(self) -> Iterator[str]:
        """What must be within limits, or the function ends here with another status."""
        printed = self.printed
        if printed.program.limits and not self.terms:
            self.terms = 1
            yield "REAL checked0 = CONSTANT(0.0);"
        texts, told = status_texts(printed.program), 0
        for slot, low, high, status in printed.program.limits:
            if status != told:
                told = status
                end = ";" if status >= OUT_OF_REACH else ":"  # the limb is named, others are told of in the header
                yield f"/* else status {status}: {plain(texts[status].partition(end)[0])} */"
            for macro, bound in (("NOT_BELOW", low), ("NOT_ABOVE", high)):
                if bound is not None:
                    yield f"{macro}({self.called[self.hub.tested[slot]]}, {printed.precision.number(bound)}, {status});"

    def _status(self) -> list[str]:
        """What the function returns, and what each pivot means."""
        printed = self.printed
        sums = balanced_sum([f"checked{k}" for k in range(min(self.terms, SUMS))] or ["CONSTANT(0.0)"])
        guards = printed.program.guards
        whole = self.limbs
        kind, every = (str(whole.count), f", {LIMBS}.checked") if whole and whole.last_check >= 0 else ("", "")
        if not guards:
            return [f"FINITE{kind}({sums}{every});" if self.terms or every else "UNCHECKED();"]
        told = list(self._small(guards))
        return [
            f"FINITE_UNLESS{kind}( /* status 1 where a pivot is smaller than its limit: */",
            *(f"    {test}{' OR' if k + 1 < len(told) else ','} /* {text} */" for k, (test, text) in enumerate(told)),
            f"    {sums}{every});",
        ]

    def _small(self, guards: Sequence[tuple[int, float]]) -> Iterator[tuple[str, str]]:
        """What tells of a small pivot, and where it is one; those that correspond in all limbs together."""
        printed, whole = self.printed, self.limbs
        texts = {slot: plain(pivot_text(printed.program.origins.get(slot))) for slot, _ in guards}
        limits = {slot: printed.precision.threshold(limit) for slot, limit in guards}
        at = {self.hub.tested[slot]: slot for slot, _ in guards}
        for slot, _ in guards:
            held = self.hub.tested[slot]
            row, k = whole.row_of.get(held, (None, 0)) if whole else (None, 0)
            if whole and row is not None and all(other in at for other in row.slots):
                if k:
                    continue
                slots, limbs = [at[other] for other in row.slots], whole.staged.limbs
                several = (texts[s].replace(limb.name, "limb") for s, limb in zip(slots, limbs, strict=True))
                test = f"{LIMBS}.{whole.members[row.number]}, {', '.join(limits[s] for s in slots)}"
                yield f"SMALL{whole.count}({test})", "; ".join(dict.fromkeys(several))
            else:
                yield f"SMALL({self.called[held]}, {limits[slot]})", texts[slot]


def angles_symbol(printed: Printed) -> str:
    """The function of the angles whose sines and cosines come first, shared by functions with the same angles."""
    program, real, angles = printed.program, printed.precision.real, printed.angles
    form = Form(real, printed.precision.table, "stride", "pitch")
    read = {a for i in angles.first for a in i.args if isinstance(a, int)} | {a for a, *_ in angles.gathered}
    given = ["size_t stride", "size_t pitch", *angle_inputs(printed, "const {} *restrict {}")]
    first = {i.target: f"angle{k}" for k, i in enumerate(angles.first)}
    entered = {**printed.entered(form), **first}

    def called(value: int | float) -> str:
        return entered[value] if isinstance(value, int) else printed.number(value)

    assert printed.shared is not None
    used = read & set(printed.entries) - set(first)
    lines = [
        declare("NAME", [*given, f"{real} *restrict angle"], f"{inlined(printed)} void "),
        "{",
        "    (void)stride;",
        "    (void)pitch;",
        *(f"    const {real} {first[t]} = {x};" for t, x in expressions(angles.first, printed.precision.table, called)),
        *(f"    {place('angle', k, 'pitch')} = {called(a)};" for k, (a, *_) in enumerate(angles.gathered)),
        "}",
        "",
    ]
    assert used <= set(entered), program.name
    return printed.shared.symbol("angles", "\n".join(lines))


def angle_inputs(printed: Printed, form: str) -> list[str]:
    """The inputs that angles are made of, in a form of type and name."""
    angles = printed.angles
    read = {a for i in angles.first for a in i.args if isinstance(a, int)} | {a for a, *_ in angles.gathered}
    arrays = {array for slot, (array, _) in printed.inputs.items() if slot in read}
    return [form.format(printed.precision.real, name) for name in printed.handed(outputs=False) if name in arrays]


def sines_symbol(printed: Printed) -> str:
    """The function that takes sines and cosines of one state's angles."""
    real, count, group = printed.precision.real, len(printed.angles.gathered), printed.precision.group
    size, zero = -(-count // group) * group, printed.precision.number(0.0)
    inputs = angle_inputs(printed, "{1}")
    given = [*angle_inputs(printed, "const {} *restrict {}"), f"{real} *restrict sine", f"{real} *restrict cosine"]
    lines = [
        declare("NAME", given, f"{inlined(printed)} void "),
        "{",
        f"    {real} angle[{size}] = {{{zero}}};",
        *wrapped_code(f"{angles_symbol(printed)}({', '.join(['1', '1', *inputs, 'angle'])});"),
        *(f"    angle[{k}] = angle[{count - 1}];" for k in range(count, size)),
        *calls(printed.model, printed.angles, printed.precision),
        "}",
        "",
    ]
    assert printed.shared is not None
    return printed.shared.symbol("sines", "\n".join(lines))


def packed_lane(printed: Printed, packing: Packing) -> list[str]:
    """`<symbol>_packed_lane`: results of one state with equal limbs side by side, and the sum of what must be finite.

    At a small pivot this sum is NaN, and pivots are not given: the lane of limb after limb finds out what is wrong.
    """
    told = grouped(c_lanes.statements(printed, packing))
    lines = c_lines(told)
    head = f"{inlined(printed)} {printed.precision.real} "
    lines = _lane(printed, f"{printed.symbol}_packed_lane", head, lines, pivots=False)
    return [f"#if {c_lanes.condition(printed.model, packing.width, printed.precision)}", *lines, "#endif"]


def _read(printed: Printed) -> set[int]:
    """The slots that a lane reads."""
    read = {a for i in printed.angles.rest for a in i.args if isinstance(a, int)}
    read |= {slot for *_, slot in printed.stored if isinstance(slot, int)} | set(printed.program.tested)
    return read | set(checked_slots(printed.program))


def _lane(printed: Printed, symbol: str, head: str, body: Sequence[str], *, pivots: bool = True) -> list[str]:
    """A function around the statements of one state."""
    real = printed.precision.real
    given = [*arguments(printed.program, printed.precision), *sines(printed)]
    given += [f"{real} *restrict pivot"] if printed.program.tested and pivots else []
    return [declare(symbol, given, head), "{", *unread(printed), *body, "}"]


def sines(printed: Printed) -> list[str]:
    """The declared arguments for sines and cosines of angles, if there are any."""
    real = printed.precision.real
    return [f"const {real} *restrict {name}" for name in ("sine", "cosine")] if printed.angles.gathered else []


def unread(printed: Printed) -> list[str]:
    """Nothing is said of arguments that are not read or written."""
    gathered = printed.angles.gathered
    lines = printed.unused(printed.program.inputs, _read(printed))
    written = {name for name, _, _ in printed.stored}
    names = [printed.names[port.name] for port in printed.program.outputs]
    lines += [f"    (void){name};" for name in names if name not in written]  # empty, or zeros that are there already
    for name, which in (("sine", 1), ("cosine", 2)) if gathered else ():
        if all(entry[which] is None for entry in gathered):
            lines.append(f"    (void){name};")
    return [f"    {' '.join(line.strip() for line in lines)}"] if lines else []


def outcome(printed: Printed, total: str) -> str:
    """The status of a state by its pivots and the sum of its results."""
    fabs = printed.precision.function("fabs")
    limits = [printed.precision.threshold(threshold) for _, threshold in printed.program.guards]
    tests = [f"{fabs}(pivot[{k}]) <= {limit}" for k, limit in enumerate(limits)]
    if not checked_slots(printed.program):
        return "0"
    guards = f"{' || '.join(tests)} ? 1 : " if tests else ""
    return f"{''.join(_within(printed))}{guards}!isfinite({total}) ? 2 : 0"


def _within(printed: Printed) -> Iterator[str]:
    """The status where a value that follows the pivots is beyond its limits."""
    program, number = printed.program, printed.precision.number
    for k, (_, low, high, status) in enumerate(program.limits, len(program.guards)):
        bounds = [f"pivot[{k}] {sign} {number(b)}" for sign, b in ((">=", low), ("<=", high)) if b is not None]
        yield f"!({' && '.join(bounds)}) ? isfinite(pivot[{k}]) ? {status} : 2 : "


def function(printed: Printed, signature: str, second: str = "", *, packed: Sequence[str] = ()) -> list[str]:
    """A function of one state: its lane, checked.

    `second` is its way out of small pivots, `packed` its lane with equal limbs side by side.
    """
    shared = bool(printed.lanes_of_limbs)
    if not printed.packing or not (packed or shared):
        return _one_by_one(printed, signature, second)
    condition = f"#if {c_lanes.condition(printed.model, printed.packing.width, printed.precision)}"
    apart = declare(f"{printed.symbol}_limb_by_limb", arguments(printed.program, printed.precision), "int ")
    handed = [*printed.handed(), *(["sine", "cosine"] if printed.angles.gathered else [])]
    handed = ["1", *handed, "NULL"] if shared else handed
    return [
        *packed,
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
    handed = ", ".join([*angle_inputs(printed, "{1}"), "sine", "cosine"])
    return [
        f"    {real} sine[{size}] = {{{zero}}}, cosine[{size}] = {{{zero}}};",
        *wrapped_code(f"{sines_symbol(printed)}({handed});"),
    ]


def _zeros(printed: Printed) -> list[str]:
    """Zeros of one state's outputs that the body does not write."""
    places = ((f"{name} + {run.start}" if run.start else name, len(run)) for name, run in printed.cleared)
    return [f"    {printed.model}_zero({place}, {size});" for place, size in places]


def _one_by_one(printed: Printed, signature: str, second: str) -> list[str]:
    """A function around its body; a long one, whose lane is in parts, around that."""
    program, precision = printed.program, printed.precision
    lines = [signature, "{", *_sines(printed), *_zeros(printed)]
    handed = [*printed.handed(), *(["sine", "cosine"] if printed.angles.gathered else [])]
    guards, real = len(program.tested), precision.real
    if printed.in_parts:
        lines += [f"    {real} pivot[{guards}] = {{{precision.number(0.0)}}};"] if guards else []
        call = f"{printed.symbol}_lane({', '.join([*handed, *(['pivot'] if guards else [])])});"
        if not checked_slots(program):
            return [*lines, *wrapped_code(f"(void){call}"), "    return 0;", "}"]
        lines += wrapped_code(f"const {real} total = {call}")
        lines += wrapped_code(f"const int outcome = {outcome(printed, 'total')};")
    else:
        call = f"{printed.symbol}_body({', '.join(['1', *handed, 'NULL'])})"
        if not checked_slots(program):
            return [*lines, *wrapped_code(f"return {call};"), "}"]
        lines += wrapped_code(f"const int outcome = {call};")
    if second and program.guards:
        lines += ["    if (outcome == 1) {", f"        return {second};", "    }"]
    lines += ["    if (outcome != 0) {"]
    for port in (p for p in program.outputs if p.size):
        lines += [f"        {printed.model}_set_nan({printed.names[port.name]}, {port.size});"]
    return [*lines, "    }", "    return outcome;", "}"]
