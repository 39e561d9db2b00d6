"""IEC 61131-3 structured text of a model: a function block per program, for CODESYS, TwinCAT and others.

    velocity(q := here, y_dot := rates);  IF velocity.valid THEN there := velocity.v; END_IF

LREAL arrays, column by column as in C; loops with bounds, no pointers, nothing of a vendor. `status` is that of the C.
Outputs are those of the last success: structured text has no NaN that every controller survives, and a zero would be a
command; `valid` is FALSE then. The rank-revealing path behind small pivots is not printed: status 1 there.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from symscrew.export.constants import Constants, Writing
from symscrew.export.folding import statements
from symscrew.export.listing import (
    balanced_sum,
    banner,
    check_names,
    checked_slots,
    code_lines,
    decimal,
    function_lines,
    input_entries,
    live_instructions,
    wrapped,
)
from symscrew.export.pivots import pivots_told
from symscrew.export.stages import Stages, headed
from symscrew.export.value_names import value_names
from symscrew.model import Model
from symscrew.program import NO_ROTATION, Iteration, Port, Program, RankRevealing

TABLE = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "neg": "-{0}",
    "reciprocal": "1.0 / {0}",
    "div": "{0} / {1}",
    "sqrt": "SQRT({0})",
    "exp": "EXP({0})",
    "sin": "SIN({0})",
    "cos": "COS({0})",
    "tan": "TAN({0})",
    "atan2": "MODEL_angle({0}, {1})",
    "abs": "ABS({0})",
    "less": "SEL({0} < {1}, 0.0, 1.0)",
    "select": "SEL({0} <> 0.0, {2}, {1})",
}
LARGEST = "1.0E37"  # no number of a machine in SI units is larger, and matiec takes no larger constant
WORDS = """abs acos action add and any array asin at atan begin bool by byte case concat configuration constant cos ctd
ctu date delete dint div do dt dword else elsif end eq exit exp expt false find for from function ge gt if in initial
insert int interval jmp le left len limit lint ln log lreal lt lword max mid min mod move mul mux ne not of on or order
override param pointer priority program read real ref reference repeat replace resource ret retain return right rol ror
rs rtc sel shl shr sin single sint sqrt sr step string struct sub super tan task then this time to tod tof ton tp
transition true trunc type udint uint ulint union until usint var while with word wstring xor"""
LOCALS = "status valid total branch code first substeps part k i n found next residual change orientation start target"
LOCALS += " one_step going"
RESERVED = frozenset(f"{WORDS} {LOCALS} r_edge f_edge read_only read_write time_of_day date_and_time".split())

ANGLE = """\
(* The angle of the point (x, y): -pi ... pi. *)
FUNCTION MODEL_angle : LREAL
VAR_INPUT
  y : LREAL;
  x : LREAL;
END_VAR
IF ABS(x) >= ABS(y) AND x <> 0.0 THEN
  MODEL_angle := ATAN(y / x);
  IF x < 0.0 THEN
    IF y < 0.0 THEN
      MODEL_angle := ATAN(y / x) - 3.141592653589793;
    ELSE
      MODEL_angle := ATAN(y / x) + 3.141592653589793;
    END_IF;
  END_IF;
ELSIF y > 0.0 THEN
  MODEL_angle := 1.5707963267948966 - ATAN(x / y);
ELSIF y < 0.0 THEN
  MODEL_angle := -1.5707963267948966 - ATAN(x / y);
ELSE
  MODEL_angle := x + y; (* 0, or what is not finite *)
END_IF;
END_FUNCTION"""


def print_structured_text(model: Model) -> dict[str, str]:
    """File name to text: `<name>.st`."""
    check_names(model)
    constants = Constants(model, WRITING)
    lines = _comment([*banner(model), "Numbers are LREAL, arrays start at 0; see the block's comment for units."])
    lines += ["", *_types(model)]
    if any(i.op == "atan2" for p in model.programs.values() for i in _straight(p).instructions):
        lines += ["", *ANGLE.replace("MODEL", model.name).splitlines()]
    for name, program in model.programs.items():
        lines += ["", *_comment(function_lines(f"{model.name}_{name}", _first_path(program)))]
        if isinstance(program, Iteration):
            lines += _iteration(model.name, name, program, constants)
        else:
            lines += _Block(model.name, name, program, constants).lines()
    return {f"{model.name}.st": "\n".join([*lines, ""])}


def _straight(program: Program | Iteration) -> Program:
    return program.step if isinstance(program, Iteration) else program


def _first_path(program: Program | Iteration) -> Program | Iteration:
    """The program as it is printed."""
    if not isinstance(program, RankRevealing):
        return program
    note = "the rank-revealing path behind small pivots is not in structured text: status 1 there"
    return Program(
        program.name, program.description, program.inputs, program.outputs, program.instructions, program.results,
        program.guards, (*program.notes, note), program.slots, program.origins, program.limbs, program.limits,
        program.reach,
    )  # fmt: skip


def _comment(lines: Iterable[str]) -> list[str]:
    """Lines as a comment; nothing in them ends it."""
    texts = [_said(line).rstrip() for line in lines]
    return ["(*", *(f"  {text}".rstrip() for text in texts), "*)"]


def _said(text: str) -> str:
    """A text as it may stand in a comment: nothing in it begins or ends one."""
    return text.replace("(*", "( *").replace("*)", "* )")


def _number(value: float) -> str:
    return decimal(value).replace("e", "E")


# Each block has the constants that it reads, since constants of a whole project are declared outside of blocks.
WRITING = Writing(
    _number, "  {name} : LREAL := {number}; ", ("(* ", "   ", " *)"), taken=RESERVED, alike=str.lower, said=_said
)


def safe(name: str) -> str:
    """A name as an identifier: no word of the language in any case, no two underscores in a row, none at an end.

    >>> safe("q"), safe("step"), safe("Sin")
    ('q', 'step_of_model', 'Sin_of_model')
    """
    text = re.sub(r"_{2,}", "_", name).strip("_")
    return f"{text}_of_model" if text.lower() in RESERVED or not text else text


def port_names(ports: Sequence[Port], taken: Iterable[str] = ()) -> list[str]:
    """Ports as identifiers that differ in more than case."""
    used, found = {name.lower() for name in taken}, []
    for port in ports:
        name, number = safe(port.name), 2
        while name.lower() in used:
            name, number = f"{safe(port.name)}_{number}", number + 1
        used.add(name.lower())
        found.append(name)
    return found


def block_ports(program: Program | Iteration) -> tuple[list[str], list[str]]:
    """Names of a block's inputs and outputs."""
    given = port_names(program.inputs)
    return given, port_names(program.outputs, given)


def _called(program: Program, taken: Collection[str]) -> Mapping[int, str]:
    """Slots by names that differ in more than case."""
    used = {name.lower() for name in taken} | RESERVED
    found = {}
    for slot, text in value_names(program, taken).items():
        name = re.sub(r"_{2,}", "_", text).strip("_")
        number = 2
        while name.lower() in used:
            name, number = f"{text}_{number}", number + 1
        used.add(name.lower())
        found[slot] = name
    return found


def _array(model: str, size: int) -> str:
    """The type of so many numbers: a name, since blocks only hand on arrays of the same one."""
    return f"{model}_vector{max(size, 1)}"


def _types(model: Model) -> list[str]:
    """The types of all arrays."""
    every = [p for program in model.programs.values() for p in (program, _straight(program))]
    sizes = sorted({max(port.size, 1) for p in every for port in (*p.inputs, *p.outputs)})
    names = [f"  {_array(model.name, size)} : ARRAY [0..{size - 1}] OF LREAL;" for size in sizes]
    return ["TYPE", *names, "END_TYPE"]


def _declared(model: str, name: str, program: Program | Iteration) -> tuple[list[str], list[str], list[str]]:
    """Head of a block, names of its inputs, names of its outputs."""
    given, made = block_ports(program)
    lines = [f"FUNCTION_BLOCK {model}_{name}", *(["VAR_INPUT"] if given else [])]
    lines += [f"  {n} : {_array(model, p.size)};" for n, p in zip(given, program.inputs, strict=True)]
    lines += [*(["END_VAR"] if given else []), "VAR_OUTPUT"]
    lines += [f"  {n} : {_array(model, p.size)};" for n, p in zip(made, program.outputs, strict=True)]
    return [*lines, "  status : INT;", "  valid : BOOL;", "END_VAR"], given, made


class _Block:
    """The function block of a straight-line program."""

    def __init__(self, model: str, name: str, program: Program, constants: Constants) -> None:
        self.symbol, self.program, self.constants = f"{model}_{name}", program, constants
        self.read: set[float] = set()  # constants
        self.table = {op: text.replace("MODEL", model) for op, text in TABLE.items()}
        self.head, self.given, self.made = _declared(model, name, program)
        self.called = _called(program, (*self.given, *self.made, self.symbol, *constants.names.values()))

    def operand(self, value: int | float) -> str:
        """A slot by its name, or a number."""
        if isinstance(value, int):
            return self.called[value]
        self.read.add(abs(value))
        return self.constants.text(value)

    def lines(self) -> list[str]:
        """Declarations, then: load, compute, check, store."""
        program = self.program
        live, read = live_instructions(program)
        names = dict(zip((p.name for p in program.inputs), self.given, strict=True))
        loads = [
            (slot, f"{self.called[slot]} := {names[port.name]}[{k}];")
            for slot, (port, k) in enumerate(input_entries(program))
            if slot in read
        ]
        found = list(statements(program, live, self.table, self.operand))
        body = headed(((f"{self.called[k]} := {t};", k) for k, t in found), Stages(program), self.operand, "(* {} *)")
        stores = [
            f"  {name}[{k}] := {self.operand(slot)};"
            for name, slots in zip(self.made, program.results, strict=True)
            for k, slot in enumerate(slots)
        ]
        local = [self.called[slot] for slot, _ in [*loads, *found]]
        return [
            *self.head,
            "VAR",
            *(f"  {name} : LREAL;" for name in (*local, "total")),
            "END_VAR",
            *self._constants(),
            *(line for _, load in loads for line in code_lines(load, later="  ")),
            *(line for text in body for line in code_lines(text, comment="(*", later="  ")),
            *self._status(),
            "valid := status = 0;",
            *(["IF valid THEN", *stores, "END_IF;"] if stores else []),
            "END_FUNCTION_BLOCK",
        ]

    def _constants(self) -> list[str]:
        """The block of what it reads."""
        found = self.constants.block(self.read)
        indented = (f"  {line}" if line.startswith("(*") else line for line in found)
        return ["VAR CONSTANT", *indented, "END_VAR"] if found else []

    def _status(self) -> Iterator[str]:
        """Limits, then pivots, then whether all is finite, as in the other targets."""
        yield "status := 0;"
        for slot, low, high, code in self.program.limits:
            value = self.operand(slot)
            bounds = [f"{value} >= {_number(low)}"] if low is not None else []
            bounds += [f"{value} <= {_number(high)}"] if high is not None else []
            yield f"IF status = 0 AND NOT ({' AND '.join(bounds)}) THEN"
            yield f"  IF ABS({value}) <= {LARGEST} THEN"
            yield f"    status := {code};"
            yield from ("  ELSE", "    status := 2;", "  END_IF;", "END_IF;")
        for slot, limit, told in pivots_told(self.program):
            yield f"(* {_said(told)} *)"
            yield from code_lines(f"IF status = 0 AND ABS({self.operand(slot)}) <= {_number(limit)} THEN")
            yield from ("  status := 1;", "END_IF;")
        total = balanced_sum([self.operand(slot) for slot in checked_slots(self.program)] or ["0.0"])
        yield from wrapped(f"total := {total};", later="  ")
        yield f"IF status = 0 AND NOT (ABS(total) <= {LARGEST}) THEN"
        yield from ("  status := 2;", "END_IF;")


def _iteration(model: str, name: str, iteration: Iteration, constants: Constants) -> list[str]:
    """A block of one step, and Newton's iteration in more and more parts of the way from the guess."""
    step = _Block(model, f"{name}_step", iteration.step, constants)
    head, given, (q,) = _declared(model, name, iteration)
    n, m = iteration.outputs[0].size, iteration.inputs[0].size
    y, guess, *more = given
    finite = [f"{x}[{k}]" for x, p in zip(given, iteration.inputs, strict=True) for k in range(p.size)]
    ports, results = step.given, step.made

    def call(at: str, target: str) -> str:
        values = zip(ports, (at, target, *more), strict=True)
        return f"one_step({', '.join(f'{port} := {value}' for port, value in values)});"

    measures = [f"one_step.{result}" for result in results]
    refused = bool(iteration.step.limits)
    lines = [*step.lines(), "", *head, "VAR", f"  one_step : {model}_{name}_step;"]
    lines += [f"  found : {_array(model, n)};", f"  start : {_array(model, m)};", f"  target : {_array(model, m)};"]
    lines += ["  total : LREAL;", "  branch : LREAL;", "  part : LREAL;"]
    lines += ["  k : INT;", "  i : INT;", "  substeps : INT;", "  going : BOOL;", "END_VAR", "status := 2;"]
    lines += wrapped(f"total := {balanced_sum(finite or ['0.0'])};", later="  ")
    lines += [f"IF ABS(total) <= {LARGEST} THEN", "  status := 3;"]
    lines += [f"  start[{i}] := {guess}[{k}];" for i, k in enumerate(iteration.independent)]
    lines += [f"  {call(guess, 'start')}", f"  branch := {measures[3]}[0];"]
    if refused:
        lines += [f"  IF one_step.status >= {NO_ROTATION} THEN", "    status := one_step.status;", "  END_IF;"]
    limit = f" AND status < {NO_ROTATION}" if refused else ""
    tolerance = _number(iteration.tolerance)
    body = [  # WHILE, with a count: FOR from 1 to 1 is none in matiec
        "substeps := 1;",
        f"WHILE substeps <= {iteration.max_substeps} AND status <> 0{limit} DO",
        f"  found := {guess};",
        "  status := 0;",
        "  k := 0;",
        "  WHILE k < substeps AND status = 0 DO",
        "    k := k + 1;",
        "    part := INT_TO_LREAL(k) / INT_TO_LREAL(substeps);",
        *(f"    target[{i}] := start[{i}] + ({y}[{i}] - start[{i}]) * part;" for i in range(m)),
        "    status := 3;",
        "    going := TRUE;",
        "    i := 0;",
        f"    WHILE i < {iteration.max_steps} AND going DO",
        "      i := i + 1;",
        f"      {call('found', 'target')}",
        "      IF one_step.status <> 0 THEN",
        "        going := FALSE;",
        "      ELSE",
        f"        found := {measures[0]};",
        f"        IF {measures[1]}[0] < {tolerance} AND {measures[2]}[0] < {tolerance} THEN",
        "          going := FALSE;",
        f"          IF {measures[3]}[0] * branch > 0.0 THEN",
        "            status := 0;",
        "          ELSE",
        "            status := 4;",
        "          END_IF;",
        "        END_IF;",
        "      END_IF;",
        "    END_WHILE;",
        "  END_WHILE;",
        "  substeps := 2 * substeps;",
        "END_WHILE;",
    ]
    lines += [f"  {line}" for line in body]
    lines += ["END_IF;", "valid := status = 0;", "IF valid THEN", f"  {q} := found;", "END_IF;"]
    return [*lines, "END_FUNCTION_BLOCK"]
