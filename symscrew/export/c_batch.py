"""Functions of many states in C: blocks of eight states side by side, in vectors of the machine.

    int <symbol>_batch(count, inputs ..., outputs ..., status)               one state after the other
    int <symbol>_batch_soa(count, stride, inputs ..., outputs ..., status)   entry k of state i at k * stride + i

`<symbol>_block` takes eight states that lie side by side in vectors (see `c_wide`). Full blocks are read and written
where they are; states one after the other, and less than eight, are copied into arrays [entry][8] and the
results out of them. A state whose check fails is given to the function of one state, which takes the second path, or
writes NaN and says why: statuses and results are those of single calls. With OpenMP, blocks are shared among threads.
Functions that repeat a step, those with functions of computed angles, and long ones (see `c_parts`) run state by state.
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.export import c_parts, c_wide
from symscrew.export.c_names import argument_names, arguments, declare, wrapped_code
from symscrew.export.c_precision import Precision
from symscrew.export.c_printed import Printed
from symscrew.export.c_wide import LANES
from symscrew.export.listing import filled
from symscrew.program import COUNTED, Iteration, Port, Program

# Entries of all arrays of a function: a block of more would take over a quarter of a megabyte of the stack, and such a
# function runs state by state.
MOST_ENTRIES = 4096
FEW = 2  # states that are as fast one by one as in a block of eight; more go in a block
VOID = "static void "
THREADED = 1024  # states from which on threads are worth their start; fewer stay in one
BY_LANES = frozenset(op for op, kind in COUNTED.items() if kind != "trig")


ROUTINES = """
/* Asks for the entries of the next states: they lie too far apart for the processor to foresee them. */
static inline void MODEL_prefetch(size_t size, size_t stride, const REAL *array)
{
#if defined(__GNUC__)
    for (size_t k = 0; k < size; ++k) {
        __builtin_prefetch(array + k * stride);
    }
#else
    (void)size;
    (void)stride;
    (void)array;
#endif
}

/* `some` states from `first` on as a block; a stride of 0 means one state after the other. The last one
   fills the lanes that are left. */
static inline void MODEL_gather(
    size_t size, size_t first, size_t some, size_t stride, const REAL *restrict array,
    REAL *restrict block)
{
    if (stride == 0) {
        for (size_t lane = 0; lane < EIGHT; ++lane) {
            const REAL *state = array + (first + (lane < some ? lane : some - 1)) * size;
            for (size_t k = 0; k < size; ++k) {
                block[k * EIGHT + lane] = state[k];
            }
        }
        return;
    }
    for (size_t k = 0; k < size; ++k) {
        const REAL *entry = array + k * stride + first;
        for (size_t lane = 0; lane < EIGHT; ++lane) {
            block[k * EIGHT + lane] = entry[lane < some ? lane : some - 1];
        }
    }
}

static inline void MODEL_scatter(
    size_t size, size_t first, size_t some, size_t stride, const REAL *restrict block,
    REAL *restrict array)
{
    if (stride == 0) {
        for (size_t lane = 0; lane < some; ++lane) {
            REAL *state = array + (first + lane) * size;
            for (size_t k = 0; k < size; ++k) {
                state[k] = block[k * EIGHT + lane];
            }
        }
        return;
    }
    for (size_t k = 0; k < size; ++k) {
        REAL *entry = array + k * stride + first;
        for (size_t lane = 0; lane < some; ++lane) {
            entry[lane] = block[k * EIGHT + lane];
        }
    }
}
"""


def prologue(model: str, precision: Precision, blocks: Sequence[Printed], *, angles: bool) -> list[str]:
    """The types and routines that all batch functions of a model share.

    `blocks`: the functions that have blocks; `angles`: some functions take sines of angles.
    """
    upper, words = model.upper(), {"REAL": precision.real, "EIGHT": str(LANES), "MODEL": model}
    return [
        f"/* Batch functions take {LANES} states at once; {upper}_STATE_BY_STATE or {upper}_SCALAR: one by one. */",
        *(c_wide.types(model, precision, {i.op for p in blocks for i in p.angles.rest}) if blocks else []),
        *filled(ROUTINES, words),
        *(_sincos_block(model, precision) if angles else []),
    ]


def _sincos_block(model: str, precision: Precision) -> list[str]:
    """Sines and cosines of `size` angles; the vector functions of eight have the bits of those of four."""
    upper, real = model.upper(), precision.real
    arguments = f"size_t size, const {real} *angle, {real} *sine, {real} *cosine"
    lines = [
        f"static inline void {model}_sincos_block({arguments})",
        "{",
        f"    for (size_t k = 0; k < size; k += {precision.group}) {{",
        f"        {model}_sincos({precision.group}, angle + k, sine + k, cosine + k);",
        "    }",
        "}",
    ]
    if precision.group >= LANES:
        return ["", *lines]
    wide, conditions = f"{model}_lanes{LANES}", ("__GNUC__", "__GLIBC__", "__x86_64__", "__AVX512F__")
    return [
        "",
        f"#if {' && '.join(f'defined({c})' for c in conditions)} && !defined({upper}_SCALAR)",
        f"typedef {real} {wide} __attribute__((vector_size(64)));",
        f"{wide} _ZGVeN{LANES}v_sin({wide});",
        f"{wide} _ZGVeN{LANES}v_cos({wide});",
        f"static inline void {model}_sincos_block({arguments})",
        "{",
        f"    for (size_t k = 0; k < size; k += {LANES}) {{",
        f"        {wide} all, s, c;",
        "        memcpy(&all, angle + k, sizeof(all));",
        f"        s = _ZGVeN{LANES}v_sin(all);",
        f"        c = _ZGVeN{LANES}v_cos(all);",
        "        memcpy(sine + k, &s, sizeof(s));",
        "        memcpy(cosine + k, &c, sizeof(c));",
        "    }",
        "}",
        "#else",
        *lines,
        "#endif",
    ]


def by_lanes(printed: Printed) -> bool:
    """Whether the lanes of a function can run side by side: arithmetic only, not in parts, blocks of a fair size."""
    ports = (*printed.program.inputs, *printed.program.outputs)
    small = sum(port.size for port in ports) <= MOST_ENTRIES
    return small and not c_parts.long(printed) and all(i.op in BY_LANES for i in printed.angles.rest)


def block(printed: Printed) -> list[str]:
    """`<symbol>_wide` and `<symbol>_block`: results of states side by side, and of each the sum of what must be finite.

    That sum is NaN at a small pivot.
    """
    return [*c_wide.function(printed), "", *_eight(printed)]


def _eight(printed: Printed) -> list[str]:
    program, precision = printed.program, printed.precision
    real, symbol = precision.real, printed.symbol
    lines = [
        declare(f"{symbol}_block", ["size_t stride", *arguments(program, precision), f"{real} *restrict total"], VOID),
        "{",
    ]
    for name, run in printed.cleared:
        lines += [
            f"    for (size_t k = {run.start}; k < {run.stop}; ++k) {{",
            f"        for (size_t lane = 0; lane < {LANES}; ++lane) {{",
            f"            {name}[k * stride + lane] = {precision.number(0.0)};",
            "        }",
            "    }",
        ]
    count, own = len(printed.angles.gathered), []
    if count:
        size, inputs = count * LANES, [f"{name} + lane" for name in printed.handed(outputs=False)]
        handed = ", ".join(["stride", str(LANES), *inputs, "angle + lane"])
        lines += [
            f"    {real} angle[{size}], sine[{size}], cosine[{size}];",
            f"    for (size_t lane = 0; lane < {LANES}; ++lane) {{",
            *wrapped_code(f"{symbol}_angles({handed});", "        "),
            "    }",
            f"    {printed.model}_sincos_block({size}, angle, sine, cosine);",
        ]
        own = ["sine", "cosine"]
    handed = ", ".join(["stride", *(f"{name} + lane" for name in [*printed.handed(), *own, "total"])])
    return [
        *lines,
        f"    for (size_t lane = 0; lane < {LANES}; lane += {printed.model.upper()}_WIDE) {{",
        *wrapped_code(f"{symbol}_wide({handed});", "        "),
        "    }",
        "}",
    ]


def signatures(symbol: str, program: Program | Iteration, precision: Precision, restrict: str) -> list[str]:
    """Declarations of both batch functions, without a semicolon."""
    given = [*arguments(program, precision, restrict), f"int *{restrict} status"]
    return [
        declare(f"{symbol}_batch", ["size_t count", *given]),
        declare(f"{symbol}_batch_soa", ["size_t count", "size_t stride", *given]),
    ]


def batch(model: str, symbol: str, program: Program | Iteration, precision: Precision, *, lanes: bool) -> list[str]:
    """Definitions of both batch functions; `lanes` says whether there is a `<symbol>_block`."""
    names = argument_names((*program.inputs, *program.outputs))
    given = arguments(program, precision)
    passed = ", ".join(names)
    lines = ["", *_one(model, symbol, program, precision), "", *_some(model, symbol, program, precision, lanes=lanes)]
    lines += [
        "",
        declare(f"{symbol}_states", ["size_t count", "size_t stride", *given, "int *restrict status"], "static int "),
        "{",
        "    int worst = 0;",
        f"    const size_t blocks = count / {LANES} + (count % {LANES} != 0);",
        "#if defined(_OPENMP) && _OPENMP >= 201107",
        f"#pragma omp parallel for schedule(static) reduction(max : worst) if (count >= {THREADED})",
        "#endif",
        "    for (size_t number = 0; number < blocks; ++number) {",
        f"        const size_t first = number * {LANES};",
        f"        const size_t some = count - first < {LANES} ? count - first : {LANES};",
        *wrapped_code(f"const int outcome = {symbol}_some(first, some, stride, {passed}, status);", "        "),
        "        worst = outcome > worst ? outcome : worst;",
        "    }",
        "    return worst;",
        "}",
    ]
    for signature, stride in zip(signatures(symbol, program, precision, "restrict"), ("0", "stride"), strict=True):
        call = f"return {symbol}_states(count, {stride}, {passed}, status);"
        lines += ["", signature, "{"]
        if stride == "stride":
            call = f"return stride == 0 && count > 0 ? 2 : {call[7:]}"
        lines += [*wrapped_code(call), "}"]
    return lines[1:]


def _one(model: str, symbol: str, program: Program | Iteration, precision: Precision) -> list[str]:
    """State `index` by the function of one state."""
    ports = (*program.inputs, *program.outputs)
    names = argument_names(ports)
    given = ["size_t index", "size_t stride", *arguments(program, precision)]
    lines = [declare(f"{symbol}_one", given, "static int "), "{", "    if (stride == 0) {"]
    here = ", ".join(f"{n} + index * {p.size}" if p.size else n for n, p in zip(names, ports, strict=True))
    lines += [*wrapped_code(f"return {symbol}({here});", "        "), "    }"]
    sized = [(name, port, k) for k, (name, port) in enumerate(zip(names, ports, strict=True)) if port.size]
    read = len(program.inputs)
    lines += [f"    {precision.real} {name}_one[{port.size}] = {{{precision.number(0.0)}}};" for name, port, _ in sized]
    lines += [
        text
        for name, port, k in sized
        if k < read
        for text in _copied(port, f"{name}_one[k] = {name}[k * stride + index];")
    ]
    here = ", ".join(f"{n}_one" if p.size else n for n, p in zip(names, ports, strict=True))
    lines += wrapped_code(f"const int outcome = {symbol}({here});")
    lines += [
        text
        for name, port, k in sized
        if k >= read
        for text in _copied(port, f"{name}[k * stride + index] = {name}_one[k];")
    ]
    return [*lines, "    return outcome;", "}"]


def _copied(port: Port, statement: str) -> list[str]:
    return [f"    for (size_t k = 0; k < {port.size}; ++k) {{", f"        {statement}", "    }"]


def _some(model: str, symbol: str, program: Program | Iteration, precision: Precision, *, lanes: bool) -> list[str]:
    """Up to eight states from `first` on."""
    names = argument_names((*program.inputs, *program.outputs))
    given = ["size_t first", "size_t some", "size_t stride", *arguments(program, precision), "int *restrict status"]
    one = f"{symbol}_one(first + lane, stride, {', '.join(names)})"
    lines = [declare(f"{symbol}_some", given, "static int "), "{", "    int worst = 0;"]
    if lanes:
        lines += [f"#if {c_wide.guard(model)}", *_blocked(model, symbol, program, precision, one=one), "#endif"]
    return [
        *lines,
        "    for (size_t lane = 0; lane < some; ++lane) {",
        *wrapped_code(f"const int outcome = {one};", "        "),
        *_told("    "),
        "    return worst;",
        "}",
    ]


def _told(indent: str) -> list[str]:
    """The end of a loop over states: the outcome goes to the caller."""
    lines = [
        "    if (status != NULL) {",
        "        status[first + lane] = outcome;",
        "    }",
        "    worst = outcome > worst ? outcome : worst;",
        "}",
    ]
    return [indent + line for line in lines]


def _blocked(model: str, symbol: str, program: Program | Iteration, precision: Precision, *, one: str) -> list[str]:
    """Three to eight states as a block: where they are, if they lie side by side, else in a copy."""
    ports = (*program.inputs, *program.outputs)
    names, read = argument_names(ports), len(program.inputs)
    sized = [(name, port, k < read) for k, (name, port) in enumerate(zip(names, ports, strict=True)) if port.size]
    here = [f"{n} + first" if p.size else n for n, p in zip(names, ports, strict=True)]
    copies = [f"{n}_block" if p.size else n for n, p in zip(names, ports, strict=True)]
    return [
        f"    if (some > {FEW}) {{",
        f"        {precision.real} total[{LANES}];",
        f"        if (some == {LANES} && stride != 0) {{",
        f"            if (first + {2 * LANES} <= stride) {{",
        *(f"                {model}_prefetch({p.size}, stride, {n} + first + {LANES});" for n, p, _ in sized),
        "            }",
        *wrapped_code(f"{symbol}_block({', '.join(['stride', *here, 'total'])});", " " * 12),
        "        } else {",
        *(f"            {precision.real} {name}_block[{port.size * LANES}];" for name, port, _ in sized),
        *(
            f"            {model}_gather({p.size}, first, some, stride, {n}, {n}_block);"
            for n, p, given in sized
            if given
        ),
        *wrapped_code(f"{symbol}_block({', '.join([str(LANES), *copies, 'total'])});", " " * 12),
        *(
            f"            {model}_scatter({p.size}, first, some, stride, {n}_block, {n});"
            for n, p, given in sized
            if not given
        ),
        "        }",
        "        for (size_t lane = 0; lane < some; ++lane) {",
        "            int outcome = 0;",
        "            if (!isfinite(total[lane])) {",
        *wrapped_code(f"outcome = {one};", " " * 16),
        "            }",
        *_told("        "),
        "        return worst;",
        "    }",
    ]
