"""C99 of a model: a header that can be read alone, and straight-line functions on caller-owned arrays.

    int <model>_<function>(inputs ..., outputs ...)                        one state
    int <model>_<function>_batch(count, inputs ..., outputs ..., status)   many states, one after the other

Nothing is allocated, no state is kept, matrices are column-major. On failure all outputs are NaN.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from symscrew.export.c_angles import calls, gather, prologue
from symscrew.export.c_rank_revealing import routines, second_path
from symscrew.export.listing import (
    Operand,
    balanced_sum,
    banner,
    check_names,
    checked_slots,
    decimal,
    expressions,
    function_lines,
    input_entries,
    live_instructions,
    step_ports,
    wrapped,
)
from symscrew.model import Model
from symscrew.program import STATUS, Iteration, Port, Program
from symscrew.rank_revealing import RankRevealing

TABLE = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "neg": "-{0}",
    "reciprocal": "1.0 / {0}",
    "div": "{0} / {1}",
    "sqrt": "sqrt({0})",
    "exp": "exp({0})",
    "sin": "sin({0})",
    "cos": "cos({0})",
    "tan": "tan({0})",
    "atan2": "atan2({0}, {1})",
    "abs": "fabs({0})",
    "less": "{0} < {1} ? 1.0 : 0.0",
    "select": "{0} != 0.0 ? {1} : {2}",
}
STATUS_MACROS = {
    -2: "RANK_LOST",
    -1: "RANK_REVEALING",
    0: "SUCCESS",
    1: "NEAR_SINGULAR",
    2: "NOT_FINITE",
    3: "NOT_CONVERGED",
    4: "OTHER_BRANCH",
}
NAMES_OF_MATH = "sin cos tan sqrt exp atan2 fabs isfinite NAN NULL INFINITY HUGE_VAL size_t M_PI M_E I errno assert"
NAMES_OF_LOCALS = "count status k worst outcome total next residual change orientation start substeps most"
NAMES_OF_LOCALS += " rate_scale row_scale inertia load closure curvature turn work multipliers rank sized shifted"
NAMES_OF_LOCALS += " loads columns mix amount internal moved part factor largest i j "
NAMES_OF_LOCALS += "".join(f" {name}{k}" for name in ("angle", "sine", "cosine") for k in range(64))
TAKEN = frozenset(f"{NAMES_OF_MATH} {NAMES_OF_LOCALS}".split())
ABOUT_ARRAYS = """Arrays are column-major, owned by the caller, and must not overlap; arrays of size 0 may be
NULL. A batch takes the arrays of `count` states one after the other, writes the status of each to `status`
unless that is NULL, and returns the largest. Do not compile with -ffinite-math-only or -ffast-math: the
checks for NaN would vanish."""


def print_c(model: Model) -> dict[str, str]:
    """File name to text: `<name>.h` and `<name>.c`."""
    check_names(model)
    return {f"{model.name}.h": print_header(model), f"{model.name}.c": print_source(model)}


def argument_names(ports: Sequence[Port]) -> list[str]:
    """The ports' names as C arguments: those that the code needs itself get an underscore."""
    return [port.name + "_" if port.name in TAKEN else port.name for port in ports]


def print_header(model: Model) -> str:
    """Declarations, sizes and what a user must know of every function."""
    upper = model.name.upper()
    lines = [
        *_comment([*banner(model), "", *wrapped(ABOUT_ARRAYS)]),
        f"#ifndef {upper}_H",
        f"#define {upper}_H",
        "",
        "#include <stddef.h>",
        "",
        f"#if !defined({upper}_RESTRICT)",
        "#if !defined(__cplusplus)",
        f"#define {upper}_RESTRICT restrict",
        "#elif defined(__GNUC__) || defined(_MSC_VER)",
        f"#define {upper}_RESTRICT __restrict",
        "#else",
        f"#define {upper}_RESTRICT",
        "#endif",
        "#endif",
        "",
        *(f"#define {upper}_{macro} {code}" for code, macro in STATUS_MACROS.items()),
        "",
        "#ifdef __cplusplus",
        'extern "C" {',
        "#endif",
        "",
        "/* What a status means. */",
        f"const char *{model.name}_status_text(int status);",
    ]
    for name, program in model.programs.items():
        symbol = f"{model.name}_{name}"
        lines += ["", *_comment(function_lines(symbol, program)), *_size_macros(symbol, program)]
        lines += [_signature(symbol, program, f"{upper}_RESTRICT") + ";"]
        lines += [_batch_signature(symbol, program, f"{upper}_RESTRICT") + ";"]
    lines += ["", "#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {upper}_H */", ""]
    return "\n".join(lines)


def print_source(model: Model) -> str:
    """Definitions of all functions."""
    lines = [
        *_comment(banner(model)),
        f'#include "{model.name}.h"',
        "",
        "#include <math.h>",
        "",
        "#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__",
        '#error "compile without -ffinite-math-only and -ffast-math: the checks for NaN would vanish"',
        "#endif",
        "",
        f"const char *{model.name}_status_text(int status)",
        "{",
        "    switch (status) {",
        *(f'    case {code}: return "{text}";' for code, text in STATUS.items()),
        '    default: return "unknown status";',
        "    }",
        "}",
        "",
        f"static void {model.name}_set_nan(double *array, size_t size)",
        "{",
        "    for (size_t k = 0; k < size; ++k) {",
        "        array[k] = (double)NAN;",
        "    }",
        "}",
    ]
    if any(gather(live_instructions(straight_line(p))[0]).gathered for p in model.programs.values()):
        lines += ["", *prologue(model.name)]
    seconds = [p for p in model.programs.values() if isinstance(p, RankRevealing)]
    if seconds:
        lines += ["", *routines(model.name, internal=any(p.wrenches for p in seconds))]
    for name, program in model.programs.items():
        symbol = f"{model.name}_{name}"
        if isinstance(program, Iteration):
            lines += ["", *_iteration(model.name, symbol, program)]
        elif isinstance(program, RankRevealing):
            lines += ["", *_with_second_path(model.name, symbol, program)]
        else:
            lines += ["", *_function(model.name, _signature(symbol, program, "restrict"), program)]
        lines += ["", *_batch(symbol, program)]
    return "\n".join([*lines, ""])


def _with_second_path(model: str, symbol: str, program: RankRevealing) -> list[str]:
    """A function whose near-singular states go to a second one."""

    def define(name: str, part: Program) -> list[str]:
        return _function(model, _signature(name, part, "restrict", "static int "), part)

    names = argument_names((*program.inputs, *program.outputs))
    second = f"{symbol}_rank_revealing"
    signature = _signature(second, program, "restrict", "static int ")
    call = f"{second}({', '.join(names)})"
    return [
        *second_path(model, symbol, signature, program, names, define),
        "",
        *_function(model, _signature(symbol, program, "restrict"), program, call),
    ]


def straight_line(program: Program | Iteration) -> Program:
    """The program itself, or an iteration's step."""
    return program.step if isinstance(program, Iteration) else program


def _comment(lines: Iterable[str]) -> list[str]:
    return ["/*", *((f" * {line}").rstrip() for line in lines), " */"]


def _size_macros(symbol: str, program: Program | Iteration) -> list[str]:
    ports = (*program.inputs, *program.outputs)
    names = [port.name.upper() for port in ports]
    if len(set(names)) != len(names):
        names = [port.name for port in ports]
    sizes = [(name, port.size) for name, port in zip(names, ports, strict=True)]
    return [f"#define {symbol.upper()}_{name}_SIZE {size}" for name, size in sizes]


def _arguments(program: Program | Iteration, restrict: str) -> list[str]:
    names = argument_names((*program.inputs, *program.outputs))
    read = len(program.inputs)
    return [f"{'const ' if i < read else ''}double *{restrict} {name}" for i, name in enumerate(names)]


def _declare(symbol: str, arguments: Sequence[str], prefix: str = "int ") -> str:
    return f"{prefix}{symbol}(\n    " + ",\n    ".join(arguments or ["void"]) + ")"


def _signature(symbol: str, program: Program | Iteration, restrict: str, prefix: str = "int ") -> str:
    return _declare(symbol, _arguments(program, restrict), prefix)


def _batch_signature(symbol: str, program: Program | Iteration, restrict: str) -> str:
    return _declare(f"{symbol}_batch", ["size_t count", *_arguments(program, restrict), f"int *{restrict} status"])


def _local_prefix(names: Iterable[str]) -> str:
    """A prefix of local variables that no argument can be mistaken for."""
    used = " ".join(names)
    return next(p for p in ("x", "t", "w", "local_", "symscrew_local_") if not re.search(rf"\b{p}\d", used))


def _function(model: str, signature: str, program: Program, second: str = "") -> list[str]:
    """The definition of a straight-line function: load, compute, check, store; `second` is its way out."""
    names = dict(
        zip(
            (p.name for p in (*program.inputs, *program.outputs)),
            argument_names((*program.inputs, *program.outputs)),
            strict=True,
        )
    )
    prefix = _local_prefix(names.values())

    def operand(value: int | float) -> str:
        return f"{prefix}{value}" if isinstance(value, int) else decimal(value)

    live, read = live_instructions(program)
    entries = input_entries(program)
    used = {entries[slot][0].name for slot in read if slot < len(entries)}
    lines = [signature, "{"]
    lines += [f"    (void){names[port.name]};" for port in program.inputs if port.name not in used]
    lines += [f"    (void){names[port.name]};" for port in program.outputs if not port.size]
    lines += [
        f"    const double {prefix}{slot} = {names[port.name]}[{k}];"
        for slot, (port, k) in enumerate(entries)
        if slot in read
    ]
    angles = gather(live)
    lines += [f"    const double {prefix}{t} = {text};" for t, text in expressions(angles.first, TABLE, operand)]
    lines += calls(model, angles, prefix, operand)
    lines += [f"    const double {prefix}{t} = {text};" for t, text in expressions(angles.rest, TABLE, operand)]
    lines += _checks(model, program, names, operand, second)
    for port, slots in zip(program.outputs, program.results, strict=True):
        lines += [f"    {names[port.name]}[{k}] = {operand(slot)};" for k, slot in enumerate(slots)]
    return [*lines, "    return 0;", "}"]


def _checks(model: str, program: Program, names: dict[str, str], operand: Operand, second: str) -> list[str]:
    """Guards, then the sum of all outputs; on failure NaN and the status, or the second path behind a small pivot."""
    guards = " || ".join(f"fabs({operand(slot)}) <= {decimal(t)}" for slot, t in program.guards)
    checked = [operand(slot) for slot in checked_slots(program)]
    lines: list[str] = []
    tests = [f"{guards} ? 1" if guards else ""]
    if checked:
        lines += wrapped_code(f"const double total = {balanced_sum(checked)};")
        tests += ["!isfinite(total) ? 2"]
    choice = " : ".join(test for test in tests if test)
    if not choice:
        return lines
    lines += wrapped_code(f"const int outcome = {choice} : 0;")
    if second and guards:
        lines += ["    if (outcome == 1) {", f"        return {second};", "    }"]
    lines += ["    if (outcome != 0) {"]
    outputs = [(names[port.name], port.size) for port in program.outputs if port.size]
    lines += [f"        {model}_set_nan({name}, {size});" for name, size in outputs]
    return [*lines, "        return outcome;", "    }"]


def wrapped_code(statement: str) -> list[str]:
    """A long statement over several lines, broken at blanks."""
    return wrapped(statement, first="    ", later="        ", width=110)


def _batch(symbol: str, program: Program | Iteration) -> list[str]:
    ports = (*program.inputs, *program.outputs)
    names = argument_names(ports)
    arguments = ", ".join(
        f"{name} + k * {port.size}" if port.size else name for name, port in zip(names, ports, strict=True)
    )
    return [
        _batch_signature(symbol, program, "restrict"),
        "{",
        "    int worst = 0;",
        "    for (size_t k = 0; k < count; ++k) {",
        *("    " + line for line in wrapped_code(f"const int outcome = {symbol}({arguments});")),
        "        if (status != NULL) {",
        "            status[k] = outcome;",
        "        }",
        "        worst = outcome > worst ? outcome : worst;",
        "    }",
        "    return worst;",
        "}",
    ]


def _iteration(model: str, symbol: str, iteration: Iteration) -> list[str]:
    """A step, Newton's iteration at one target, and the homotopy from the guess with doubled substeps."""
    step = iteration.step
    lines = _function(model, _signature(f"{symbol}_step", step, "restrict", "static int "), step)
    lines += ["", *_newton(symbol, iteration), "", *_substeps(symbol, iteration)]
    names = argument_names((*iteration.inputs, *iteration.outputs))
    y, guess, q = names[0], names[1], names[-1]
    n, m = iteration.inputs[1].size, iteration.inputs[0].size
    extra = "".join(f", {name}" for name in names[2:-1])
    named = list(zip(names, iteration.inputs, strict=False))
    finite = [f"{name}[{k}]" for name, port in named for k in range(port.size)]
    lines += [
        "",
        _signature(symbol, iteration, "restrict"),
        "{",
        *([f"    (void){y};"] if not m else []),
        *(f"    (void){name};" for name, port in named[2:] if not port.size),
        *wrapped_code(f"const double total = {balanced_sum(finite or ['0.0'])};"),
        "    int outcome = isfinite(total) ? 3 : 2;",
        "    if (outcome == 3) {",
        f"        double next[{n}], residual[1], change[1], orientation[1];",
        f"        double start[{max(m, 1)}] = {{0.0}};",
        *(f"        start[{i}] = {guess}[{k}];" for i, k in enumerate(iteration.independent)),
        f"        (void){symbol}_step({guess}, start{extra}, next, residual, change, orientation);",
        f"        const int most = {iteration.max_substeps};",
        "        for (int substeps = 1; substeps <= most && outcome != 0; substeps *= 2) {",
        f"            outcome = {symbol}_attempt(substeps, {y}, {guess}{extra}, start, orientation[0], {q});",
        "        }",
        "    }",
        "    if (outcome != 0) {",
        f"        {model}_set_nan({q}, {n});",
        "    }",
        "    return outcome;",
        "}",
    ]
    return lines


def _newton(symbol: str, iteration: Iteration) -> list[str]:
    names = [f"p{i}" for i in range(len(step_ports(iteration)))]
    arguments = ["double *q", "const double *y", *(f"const double *{n}" for n in names), "double branch"]
    extra = "".join(f", {name}" for name in names)
    tolerance, n = decimal(iteration.tolerance), iteration.outputs[0].size
    return [
        _declare(f"{symbol}_newton", arguments, "static int "),
        "{",
        f"    double next[{n}], residual[1], change[1], orientation[1];",
        f"    for (int step = 0; step < {iteration.max_steps}; ++step) {{",
        f"        if ({symbol}_step(q, y{extra}, next, residual, change, orientation) != 0) {{",
        "            return 3;",
        "        }",
        f"        for (int k = 0; k < {n}; ++k) {{",
        "            q[k] = next[k];",
        "        }",
        f"        if (residual[0] < {tolerance} && change[0] < {tolerance}) {{",
        "            return orientation[0] * branch > 0.0 ? 0 : 4;",
        "        }",
        "    }",
        "    return 3;",
        "}",
    ]


def _substeps(symbol: str, iteration: Iteration) -> list[str]:
    names = [f"p{i}" for i in range(len(step_ports(iteration)))]
    arguments = [
        "int substeps", "const double *y", "const double *guess", *(f"const double *{n}" for n in names),
        "const double *start", "double branch", "double *q",
    ]  # fmt: skip
    extra = "".join(f", {name}" for name in names)
    n, m = iteration.outputs[0].size, iteration.inputs[0].size
    return [
        _declare(f"{symbol}_attempt", arguments, "static int "),
        "{",
        f"    double target[{max(m, 1)}] = {{0.0}};",
        *(["    (void)y;", "    (void)start;"] if not m else []),
        f"    for (int k = 0; k < {n}; ++k) {{",
        "        q[k] = guess[k];",
        "    }",
        "    for (int k = 1; k <= substeps; ++k) {",
        *(["        const double part = (double)k / (double)substeps;"] if m else []),
        *(f"        target[{i}] = start[{i}] + (y[{i}] - start[{i}]) * part;" for i in range(m)),
        f"        const int outcome = {symbol}_newton(q, target{extra}, branch);",
        "        if (outcome != 0) {",
        "            return outcome;",
        "        }",
        "    }",
        "    return 0;",
        "}",
    ]
