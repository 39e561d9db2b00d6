"""Functions of many states in C: blocks of eight states side by side, which the compiler's vectors take at once.

    int <symbol>_batch(count, inputs ..., outputs ..., status)               one state after the other
    int <symbol>_batch_soa(count, stride, inputs ..., outputs ..., status)   entry k of state i at k * stride + i

Both copy eight states into arrays [entry][8], run `<symbol>_lane` (see `c_function`) over the eight, and copy
the results out. A state whose check fails is given to the function of one state, which takes the second path,
or writes NaN and says why: statuses and results are those of single calls. With OpenMP, blocks are shared
among threads. Functions that repeat a step, those with functions of computed angles, and long ones (see `c_parts`)
run state by state.
"""

from __future__ import annotations

from symscrew.export import c_parts
from symscrew.export.c_function import Printed, argument_names, arguments, declare, outcome, wrapped_code
from symscrew.export.c_precision import Precision
from symscrew.export.listing import checked_slots
from symscrew.program import COUNTED, Iteration, Port, Program

LANES = 8
MOST_ENTRIES = 4096  # of all arrays of a function: blocks of more would take too much of the stack
FEW = 2  # states that are as fast one by one
THREADED = 1024  # states from which on threads are worth their start
BY_LANES = frozenset(op for op, kind in COUNTED.items() if kind != "trig")


def prologue(model: str, precision: Precision) -> list[str]:
    """The macros and copying routines that all batch functions of a model share."""
    upper, real = model.upper(), precision.real
    return [
        f"/* Batch functions take {LANES} states at once; {upper}_STATE_BY_STATE or {upper}_SCALAR: one by one. */",
        "#if defined(__GNUC__) && !defined(__clang__)",
        f'#define {upper}_VECTORISE _Pragma("GCC ivdep")',
        f"#define {upper}_INLINE __attribute__((always_inline))",
        "#else",
        f"#define {upper}_VECTORISE",
        f"#define {upper}_INLINE",
        "#endif",
        "",
        "/* `some` states from `first` on as a block; a stride of 0 means one state after the other. The last one",
        "   fills the lanes that are left. */",
        f"static inline void {model}_gather(",
        f"    size_t size, size_t first, size_t some, size_t stride, const {real} *restrict array,",
        f"    {real} *restrict block)",
        "{",
        "    if (stride == 0) {",
        f"        for (size_t lane = 0; lane < {LANES}; ++lane) {{",
        f"            const {real} *state = array + (first + (lane < some ? lane : some - 1)) * size;",
        "            for (size_t k = 0; k < size; ++k) {",
        f"                block[k * {LANES} + lane] = state[k];",
        "            }",
        "        }",
        "        return;",
        "    }",
        "    for (size_t k = 0; k < size; ++k) {",
        f"        const {real} *entry = array + k * stride + first;",
        f"        if (some == {LANES}) {{",
        f"            memcpy(block + k * {LANES}, entry, {LANES} * sizeof(*entry));",
        "        } else {",
        f"            for (size_t lane = 0; lane < {LANES}; ++lane) {{",
        f"                block[k * {LANES} + lane] = entry[lane < some ? lane : some - 1];",
        "            }",
        "        }",
        "    }",
        "}",
        "",
        f"static inline void {model}_scatter(",
        f"    size_t size, size_t first, size_t some, size_t stride, const {real} *restrict block,",
        f"    {real} *restrict array)",
        "{",
        "    if (stride == 0) {",
        "        for (size_t lane = 0; lane < some; ++lane) {",
        f"            {real} *state = array + (first + lane) * size;",
        "            for (size_t k = 0; k < size; ++k) {",
        f"                state[k] = block[k * {LANES} + lane];",
        "            }",
        "        }",
        "        return;",
        "    }",
        "    for (size_t k = 0; k < size; ++k) {",
        f"        {real} *entry = array + k * stride + first;",
        f"        if (some == {LANES}) {{",
        f"            memcpy(entry, block + k * {LANES}, {LANES} * sizeof(*entry));",
        "        } else {",
        "            for (size_t lane = 0; lane < some; ++lane) {",
        f"                entry[lane] = block[k * {LANES} + lane];",
        "            }",
        "        }",
        "    }",
        "}",
    ]


def guard(model: str) -> str:
    """The condition of the preprocessor for blocks."""
    return f"!defined({model.upper()}_SCALAR) && !defined({model.upper()}_STATE_BY_STATE)"


def by_lanes(printed: Printed) -> bool:
    """Whether the lanes of a function can run side by side: arithmetic only, not in parts, blocks of a fair size."""
    ports = (*printed.program.inputs, *printed.program.outputs)
    small = sum(port.size for port in ports) <= MOST_ENTRIES
    return small and not c_parts.long(printed) and all(i.op in BY_LANES for i in printed.angles.rest)


def block(printed: Printed) -> list[str]:
    """`<symbol>_block`: eight states side by side, and the status of each."""
    program, precision = printed.program, printed.precision
    real, symbol, upper = precision.real, printed.symbol, printed.model.upper()
    given = [*arguments(program, precision), "int *restrict status"]
    lines = [declare(f"{symbol}_block", given, "static void "), "{"]
    count, extra = len(printed.angles.gathered), []
    loop = f"    for (size_t lane = 0; lane < {LANES}; ++lane) {{"
    inputs = [f"{name} + lane" for name in printed.handed(outputs=False)]
    if count:
        handed = ", ".join([str(LANES), *inputs, "angle + lane"])
        lines += [
            f"    {real} angle[{count * LANES}], sine[{count * LANES}], cosine[{count * LANES}];",
            f"    {upper}_VECTORISE",
            loop,
            *wrapped_code(f"{symbol}_angles({handed});", "        "),
            "    }",
            f"    for (size_t k = 0; k < {count * LANES}; k += {precision.group}) {{",
            f"        {printed.model}_sincos({precision.group}, angle + k, sine + k, cosine + k);",
            "    }",
        ]
        extra += ["sine + lane", "cosine + lane"]
    if program.guards:
        lines += [f"    {real} pivot[{len(program.guards) * LANES}];"]
        extra += ["pivot + lane"]
    outputs = [f"{name} + lane" for name in printed.handed()[len(program.inputs) :]]
    call = f"{symbol}_lane({', '.join([str(LANES), *inputs, *outputs, *extra])});"
    vectorised = [f"    {upper}_VECTORISE", loop]
    status = f"status[lane] = {outcome(printed, 'total[lane]', f' * {LANES}', ' + lane')};"
    if not checked_slots(program):
        return [*lines, *vectorised, *wrapped_code(f"(void){call}", "        "), f"        {status}", "    }", "}"]
    return [
        *lines,
        f"    {real} total[{LANES}];",
        *vectorised,
        *wrapped_code(f"total[lane] = {call}", "        "),
        "    }",
        loop,
        *wrapped_code(status, "        "),
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
    ports = (*program.inputs, *program.outputs)
    names = argument_names(ports)
    given = ["size_t first", "size_t some", "size_t stride", *arguments(program, precision), "int *restrict status"]
    one = f"{symbol}_one(first + lane, stride, {', '.join(names)})"
    lines = [declare(f"{symbol}_some", given, "static int "), "{", "    int worst = 0;"]
    if lanes:
        sized = [(name, port, k) for k, (name, port) in enumerate(zip(names, ports, strict=True)) if port.size]
        inputs = [(name, port) for name, port, k in sized if k < len(program.inputs)]
        outputs = [(name, port) for name, port, k in sized if k >= len(program.inputs)]
        passed = ", ".join(f"{n}_block" if p.size else n for n, p in zip(names, ports, strict=True))
        lines += [
            f"#if {guard(model)}",
            f"    if (some > {FEW}) {{",
            *(f"        {precision.real} {name}_block[{port.size * LANES}];" for name, port, _ in sized),
            f"        int outcome[{LANES}];",
            *(f"        {model}_gather({p.size}, first, some, stride, {n}, {n}_block);" for n, p in inputs),
            *wrapped_code(f"{symbol}_block({passed}, outcome);", "        "),
            *(f"        {model}_scatter({p.size}, first, some, stride, {n}_block, {n});" for n, p in outputs),
            "        for (size_t lane = 0; lane < some; ++lane) {",
            "            if (outcome[lane] != 0) {",
            *wrapped_code(f"outcome[lane] = {one};", "                "),
            "            }",
            "            if (status != NULL) {",
            "                status[first + lane] = outcome[lane];",
            "            }",
            "            worst = outcome[lane] > worst ? outcome[lane] : worst;",
            "        }",
            "        return worst;",
            "    }",
            "#endif",
        ]
    return [
        *lines,
        "    for (size_t lane = 0; lane < some; ++lane) {",
        *wrapped_code(f"const int outcome = {one};", "        "),
        "        if (status != NULL) {",
        "            status[first + lane] = outcome;",
        "        }",
        "        worst = outcome > worst ? outcome : worst;",
        "    }",
        "    return worst;",
        "}",
    ]
