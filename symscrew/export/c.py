"""C99 of a model: a header that can be read alone, and straight-line functions on caller-owned arrays.

    int <model>_<function>(inputs ..., outputs ...)                                     one state
    int <model>_<function>_batch(count, inputs ..., outputs ..., status)                many, one after the other
    int <model>_<function>_batch_soa(count, stride, inputs ..., outputs ..., status)    many, side by side

Nothing is allocated, no state is kept, matrices are column-major. On failure all outputs are NaN.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from symscrew.export import c_angles, c_batch, c_lanes, c_parts, c_unread, c_wide
from symscrew.export.c_function import function, lane
from symscrew.export.c_interface import interface_table
from symscrew.export.c_iteration import iteration_functions
from symscrew.export.c_names import argument_names, arguments, declare
from symscrew.export.c_parameters import parameter_type
from symscrew.export.c_precision import DOUBLE, TABLE, Precision
from symscrew.export.c_printed import Printed
from symscrew.export.c_rank_revealing import routines, second_path
from symscrew.export.c_single import error_lines, single_errors
from symscrew.export.listing import banner, check_names, filled, function_lines, wrapped
from symscrew.model import Model
from symscrew.program import STATUS, Iteration, Program, RankRevealing

__all__ = ["STATUS_MACROS", "TABLE", "argument_names", "print_c", "print_header", "print_source", "straight_line"]

STATUS_MACROS = {
    -2: "RANK_LOST",
    -1: "RANK_REVEALING",
    0: "SUCCESS",
    1: "NEAR_SINGULAR",
    2: "NOT_FINITE",
    3: "NOT_CONVERGED",
    4: "OTHER_BRANCH",
}
IN_LANES = frozenset((  # what is called once per step of a control or a simulation: tried with equal limbs side by side
    "acceleration",
    "forward_dynamics",
    "forward_dynamics_independent",
    "inverse_dynamics",
    "inverse_dynamics_independent",
    "inverse_dynamics_platform",
    "inverse_kinematics",
    "inverse_velocity",
    "joint_reactions",
    "velocity",
))  # fmt: skip
ABOUT_ARRAYS = """Arrays are column-major, owned by the caller, and must not overlap; arrays of size 0 may be
NULL. Do not compile with -ffinite-math-only or -ffast-math: the checks for NaN would vanish."""
ABOUT_BATCHES = """A batch writes the status of each of `count` states to `status` unless that is NULL, and returns
the largest. <function>_batch takes the arrays of the states one after the other; <function>_batch_soa has entry k
of state i at [k * stride + i], stride >= count. Both take eight states at once on vector
units; results may differ from those of single calls by rounding (not where the compiler contracts nothing and the
sines are the same). With -fopenmp, %d states and more are shared among threads. The stack holds blocks of eight
states: define %s_STATE_BY_STATE to do without."""
ABOUT_LANES = """Single calls have equal limbs side by side on vector units of x86-64 (AVX2) where that is faster;
results are those of limb after limb, but for what the compiler contracts. Define %s_LIMB_BY_LIMB to do without."""

HEAD = """\
#include "MODEL.h"

#include <math.h>
#include <string.h>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "compile without -ffinite-math-only and -ffast-math: the checks for NaN would vanish"
#endif

/* Vectors that GCC makes of scalar code here cost more than they save; no comparison here traps. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC optimize("no-tree-slp-vectorize,no-trapping-math")
#endif
#if defined(__GNUC__)
#define UPPER_INLINE __attribute__((always_inline))
#else
#define UPPER_INLINE
#endif

const char *MODEL_status_text(int status)
{
    switch (status) {
CASES
    default: return "unknown status";
    }
}

static void MODEL_set_nan(REAL *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = (REAL)NAN;
    }
}
"""


def print_c(model: Model, *, precision: Precision = DOUBLE, batches: bool = True, lanes: bool = True) -> dict[str, str]:
    """File name to text: `<name>.h` and `<name>.c`; without batch functions, or limbs side by side, if not needed."""
    check_names(model)
    return {
        f"{model.name}.h": print_header(model, precision=precision, batches=batches),
        f"{model.name}.c": print_source(model, precision=precision, batches=batches, lanes=lanes and batches),
    }


def print_header(model: Model, *, precision: Precision = DOUBLE, batches: bool = True) -> str:
    """Declarations, sizes and what a user must know of every function."""
    upper = model.name.upper()
    about = wrapped(ABOUT_ARRAYS)
    if batches:
        about += [*wrapped(ABOUT_BATCHES % (c_batch.THREADED, upper)), *wrapped(ABOUT_LANES % upper)]
    measured = single_errors(model) if precision.suffix else {}
    if precision.suffix:
        about = [f"Single precision: all numbers are of type {precision.real}.", *about]
    lines = [
        *_comment([*banner(model), "", *about]),
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
        *parameter_type(model, precision),
    ]
    for name, program in model.programs.items():
        symbol = f"{model.name}_{name}"
        errors = error_lines(program, measured.get(name)) if precision.suffix else []
        lines += ["", *_comment([*function_lines(symbol, program), *errors]), *_size_macros(symbol, program)]
        lines += [declare(symbol, arguments(program, precision, f"{upper}_RESTRICT")) + ";"]
        if batches:
            lines += [text + ";" for text in c_batch.signatures(symbol, program, precision, f"{upper}_RESTRICT")]
    lines += ["", "#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {upper}_H */", ""]
    return "\n".join(lines)


def print_source(model: Model, *, precision: Precision = DOUBLE, batches: bool = True, lanes: bool = True) -> str:
    """Definitions of all functions: what they share, then function after function."""
    printed = {
        name: Printed(model.name, f"{model.name}_{name}", straight_line(p), precision, lanes and name in IN_LANES)
        for name, p in model.programs.items()
    }
    straight = [name for name, program in model.programs.items() if not isinstance(program, Iteration)]
    blocks = [name for name in straight if batches and c_batch.by_lanes(printed[name])]
    lines = [*_comment(banner(model)), *_head(model.name, precision, batches=batches)]
    lines += _shared(model, printed, blocks, precision=precision, batches=batches)
    for name, program in model.programs.items():
        symbol = f"{model.name}_{name}"
        if isinstance(program, Iteration):
            lines += ["", *iteration_functions(model.name, symbol, program, precision)]
        else:
            lines += ["", *_lane(printed[name]), "", *_one_state(printed[name], program)]
        if name in blocks:
            lines += ["", f"#if {c_wide.guard(model.name)}", *c_batch.block(printed[name]), "#endif"]
        if batches:
            lines += ["", *c_batch.batch(model.name, symbol, program, precision, lanes=name in blocks)]
    lines += interface_table(model, precision)
    return "\n".join([*lines, ""])


def _head(model: str, precision: Precision, *, batches: bool) -> list[str]:
    """Includes, what a compiler must not do, the texts of statuses, and NaN for results of states that fail."""
    cases = "\n".join(f'    case {code}: return "{text}";' for code, text in STATUS.items())
    words = {"REAL": precision.real, "CASES": cases, "UPPER": model.upper(), "MODEL": model}
    lines = filled(HEAD, words)
    return lines if batches else [line for line in lines if line != "#include <string.h>"]


def _shared(
    model: Model, printed: Mapping[str, Printed], blocks: Sequence[str], *, precision: Precision, batches: bool
) -> list[str]:
    """Types and routines that several functions call; `blocks` are the functions that take states in blocks."""
    name, lines = model.name, list[str]()
    angles = any(p.angles.gathered for p in printed.values())
    if angles:
        lines += ["", *c_angles.prologue(name, precision)]
    every = _straight_lines(name, model.programs, precision)
    lines += c_parts.prologue(name, every)
    if any(c_unread.fours(p.inputs, p.program.checked)[0] for p in every if not c_parts.long(p)):
        lines += c_unread.prologue(name, precision)
    lines += c_lanes.prologue(name, [p.packing for p in printed.values() if p.packing], precision)
    if batches:
        lines += ["", *c_batch.prologue(name, precision, [printed[n] for n in blocks], angles=angles)]
    seconds = [p for p in model.programs.values() if isinstance(p, RankRevealing)]
    if seconds:
        lines += ["", *routines(name, precision, internal=any(p.wrenches for p in seconds))]
    return lines


def _lane(printed: Printed) -> list[str]:
    """The lane of a function, in parts if it is long."""
    return c_parts.lane_in_parts(printed) if c_parts.long(printed) else lane(printed)


def _one_state(printed: Printed, program: Program) -> list[str]:
    """The function of one state; if it has a second path, this comes before it."""
    signature = declare(printed.symbol, arguments(program, printed.precision))
    if not isinstance(program, RankRevealing):
        return function(printed, signature)
    precision = printed.precision

    def define(name: str, part: Program) -> list[str]:
        inner = Printed(printed.model, name, part, precision)
        return [*_lane(inner), "", *function(inner, declare(name, arguments(part, precision), "static int "))]

    second = f"{printed.symbol}_rank_revealing"
    way_out = declare(second, arguments(program, precision), "static int ")
    call = f"{second}({', '.join(printed.handed())})"
    lines = second_path(printed, way_out, define)
    return [*lines, "", *function(printed, signature, call)]


def straight_line(program: Program | Iteration) -> Program:
    """The program itself, or an iteration's step."""
    return program.step if isinstance(program, Iteration) else program


def _straight_lines(model: str, programs: Mapping[str, Program | Iteration], precision: Precision) -> list[Printed]:
    """Every straight-line program that is printed, those of second paths included."""
    every = [straight_line(program) for program in programs.values()]
    seconds = [part for p in every if isinstance(p, RankRevealing) for part in (p.dense, p.wrenches) if part]
    return [Printed(model, "", program, precision) for program in (*every, *seconds)]


def _comment(lines: Iterable[str]) -> list[str]:
    return ["/*", *((f" * {line}").rstrip() for line in lines), " */"]


def _size_macros(symbol: str, program: Program | Iteration) -> list[str]:
    ports = (*program.inputs, *program.outputs)
    names = [port.name.upper() for port in ports]
    if len(set(names)) != len(names):
        names = [port.name for port in ports]
    sizes = [(name, port.size) for name, port in zip(names, ports, strict=True)]
    return [f"#define {symbol.upper()}_{name}_SIZE {size}" for name, size in sizes]
