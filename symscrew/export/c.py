"""C99 of a model: a header that can be read alone, and straight-line functions on caller-owned arrays.

    int <model>_<function>(inputs ..., outputs ...)                                     one state
    int <model>_<function>_batch(count, inputs ..., outputs ..., status)                many, one after the other
    int <model>_<function>_batch_soa(count, stride, inputs ..., outputs ..., status)    many, side by side

Nothing is allocated, no state is kept, matrices are column-major. On failure all outputs are NaN.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symscrew.export import c_angles, c_batch, c_lanes, c_parts, c_unread, c_wide
from symscrew.export.c_function import body, function
from symscrew.export.c_header import STATUS_MACROS, comment, print_header
from symscrew.export.c_interface import interface_table
from symscrew.export.c_iteration import iteration_functions
from symscrew.export.c_names import argument_names, arguments, declare
from symscrew.export.c_precision import DOUBLE, TABLE, Precision
from symscrew.export.c_printed import Printed, Shared
from symscrew.export.c_rank_revealing import routines, second_path
from symscrew.export.listing import banner, check_names, filled
from symscrew.model import Model
from symscrew.program import STATUS, Iteration, Program, RankRevealing

__all__ = ["STATUS_MACROS", "TABLE", "argument_names", "print_c", "print_header", "print_source", "straight_line"]

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
#define UPPER_UNUSED __attribute__((unused))
#else
#define UPPER_INLINE
#define UPPER_UNUSED
#endif

const char *MODEL_status_text(int status)
{
    switch (status) {
CASES
    default: return "unknown status";
    }
}

UPPER_UNUSED static inline void MODEL_set_nan(REAL *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = (REAL)NAN;
    }
}

UPPER_UNUSED static inline void MODEL_zero(REAL *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = ZERO;
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


def print_source(model: Model, *, precision: Precision = DOUBLE, batches: bool = True, lanes: bool = True) -> str:
    """Definitions of all functions: what they share, bodies, then function after function, then batches.

    With batches the file is read twice: it includes itself for the bodies of several states at once.
    """
    shared, name = Shared(model.name), model.name
    printed = {
        f: Printed(name, f"{name}_{f}", straight_line(p), precision, lanes and f in IN_LANES, shared)
        for f, p in model.programs.items()
    }
    straight = [f for f, program in model.programs.items() if not isinstance(program, Iteration)]
    blocks = [f for f in straight if batches and c_batch.by_lanes(printed[f])]
    functions = _functions(model, printed, shared, without=blocks)
    wide = [line for f in blocks for line in ("", *c_batch.block(printed[f]))]
    bodies = [line for f in blocks for line in ("", *body(printed[f]))]
    lines = [*comment(banner(model))]
    again = f"{name.upper()}_VECTORS"
    lines += [f"#if !defined({again})", *_head(name, precision, batches=batches)]
    lines += _shared(model, printed, blocks, precision=precision, batches=batches)
    lines += ["", *shared.lines(), *c_wide.one_state(name, precision), f"#endif /* {again} */"]
    lines += [*bodies, "", f"#if !defined({again})", *functions, "", *c_wide.undefined()]
    if blocks:
        lines += ["", f"#if {c_wide.guard(name)}", f"#define {again}", *c_wide.states(name, precision)]
        lines += [f'#include "{name}.c"', *c_wide.undefined(), *wide, "#endif"]
    if batches:
        for f, program in model.programs.items():
            symbol = f"{name}_{f}"
            lines += ["", *c_batch.batch(name, symbol, program, precision, lanes=f in blocks)]
    lines += [*interface_table(model, precision), f"#endif /* {again} */"]
    return "\n".join([*lines, ""])


def _functions(model: Model, printed: Mapping[str, Printed], shared: Shared, without: Sequence[str]) -> list[str]:
    """The functions of one state, with the bodies of those that are not in `without`."""
    lines = []
    for name, program in model.programs.items():
        symbol = f"{model.name}_{name}"
        if isinstance(program, Iteration):
            lines += ["", *iteration_functions(model.name, symbol, program, printed[name].precision, shared=shared)]
        else:
            own = [] if name in without else ["", *_body(printed[name])]
            lines += [*own, "", *_one_state(printed[name], program)]
    return lines


def _head(model: str, precision: Precision, *, batches: bool) -> list[str]:
    """Includes, what a compiler must not do, the texts of statuses, and NaN for results of states that fail."""
    cases = "\n".join(f'    case {code}: return "{text}";' for code, text in STATUS.items())
    words = {
        "REAL": precision.real,
        "ZERO": precision.number(0.0),
        "CASES": cases,
        "UPPER": model.upper(),
        "MODEL": model,
    }
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
    if any(c_unread.fours(p.inputs, p.program.checked)[0] for p in every if not p.in_parts):
        lines += c_unread.prologue(name, precision)
    lines += c_lanes.prologue(name, [p.packing for p in printed.values() if p.packing], precision)
    if batches:
        most = max(len(p.inputs) + len(p.outputs) for p in model.programs.values())
        chosen = [printed[n] for n in blocks]
        lines += ["", *c_batch.prologue(name, precision, chosen, angles=angles, ports=most)]
    seconds = [p for p in model.programs.values() if isinstance(p, RankRevealing)]
    if seconds:
        lines += ["", *routines(name, precision, internal=any(p.wrenches for p in seconds))]
    return lines


def _body(printed: Printed) -> list[str]:
    """The body of a function, in parts if it is long."""
    return c_parts.lane_in_parts(printed) if printed.in_parts else body(printed)


def _one_state(printed: Printed, program: Program) -> list[str]:
    """The function of one state; if it has a second path, this comes before it."""
    signature = declare(printed.symbol, arguments(program, printed.precision))
    if not isinstance(program, RankRevealing):
        return function(printed, signature)
    precision = printed.precision

    def define(name: str, part: Program) -> list[str]:
        inner = Printed(printed.model, name, part, precision, shared=printed.shared)
        return [*_body(inner), "", *function(inner, declare(name, arguments(part, precision), "static int "))]

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
