"""C functions in CasADi's external-function ABI, around the C code of a model and of its Jacobians.

    f = casadi.external("four_bar_casadi_inverse_dynamics", "./libfour_bar_external.so")

The shared library is made of `<name>.c`, `<name>_jacobians.c` and `<name>_external.c`. Functions of
`DIFFERENTIATED` come with `jac_<function>`, whose inputs are those of the function and then its outputs, and
whose outputs are the sparse blocks d output / d input, row of outputs by row: CasADi finds it by its name and
makes forward and reverse derivatives of it.

Names, shapes and order of inputs and outputs are those of the functions of `casadi.py`, `status` being the last
output. Whoever asks for the status gets it, and NaN beside it where it is above 0. To one who does not ask (an MX
graph that leaves it out, as objectives and constraints do), a state that fails returns 1, which CasADi reports as a
failed evaluation and IPOPT answers with a shorter step. The values are those of the C code: near a small pivot, where
it goes on by its second path, the status is -1 or -2 and the numbers are good; a function of `casadi.py` says 1 there.

Source: https://web.casadi.org/docs, sections "Using external functions" and "External derivatives".
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from symscrew.description import longer_name
from symscrew.export.c import print_c
from symscrew.export.listing import banner
from symscrew.model import Model
from symscrew.program import Iteration, Jacobian, Port, Program, jacobian

DIFFERENTIATED = (
    "forward_kinematics", "point_motion", "closure", "velocity", "acceleration", "assemble", "energy",
    "inverse_kinematics", "inverse_velocity", "inverse_dynamics", "inverse_dynamics_independent",
    "inverse_dynamics_platform", "forward_dynamics", "forward_dynamics_independent",
)  # fmt: skip
STATUS_PORT = Port("status", (1,), ("1",), ("status",), "0 where the other outputs are good, else why not")

HEAD = """
#ifndef casadi_int
#define casadi_int long long int
#endif
#ifndef casadi_real
#define casadi_real double
#endif
#ifndef CASADI_SYMBOL_EXPORT
#if defined(_WIN32)
#define CASADI_SYMBOL_EXPORT __declspec(dllexport)
#else
#define CASADI_SYMBOL_EXPORT __attribute__((visibility("default")))
#endif
#endif

/* Sizes of a function, and that it holds nothing: no memory, no reference count. */
#define EXTERNAL(name, inputs, outputs, words) \\
    CASADI_SYMBOL_EXPORT casadi_int name##_n_in(void); \\
    CASADI_SYMBOL_EXPORT casadi_int name##_n_out(void); \\
    CASADI_SYMBOL_EXPORT void name##_incref(void); \\
    CASADI_SYMBOL_EXPORT void name##_decref(void); \\
    CASADI_SYMBOL_EXPORT int name##_work(casadi_int *, casadi_int *, casadi_int *, casadi_int *); \\
    CASADI_SYMBOL_EXPORT const char *name##_name_in(casadi_int); \\
    CASADI_SYMBOL_EXPORT const char *name##_name_out(casadi_int); \\
    CASADI_SYMBOL_EXPORT const casadi_int *name##_sparsity_in(casadi_int); \\
    CASADI_SYMBOL_EXPORT const casadi_int *name##_sparsity_out(casadi_int); \\
    CASADI_SYMBOL_EXPORT int name(const casadi_real **, casadi_real **, casadi_int *, casadi_real *, int); \\
    casadi_int name##_n_in(void) { return inputs; } \\
    casadi_int name##_n_out(void) { return outputs; } \\
    void name##_incref(void) {} \\
    void name##_decref(void) {} \\
    int name##_work(casadi_int *sz_arg, casadi_int *sz_res, casadi_int *sz_iw, casadi_int *sz_w) \\
    { \\
        if (sz_arg != NULL) { *sz_arg = inputs; } \\
        if (sz_res != NULL) { *sz_res = outputs; } \\
        if (sz_iw != NULL) { *sz_iw = 0; } \\
        if (sz_w != NULL) { *sz_w = words; } \\
        return 0; \\
    }

/* An input that CasADi leaves out is zero, an output that it leaves out goes to the work array. */
static const casadi_real *input(const casadi_real *given, casadi_real **work, size_t size)
{
    casadi_real *own = *work;
    *work += size;
    if (given != NULL) {
        return given;
    }
    for (size_t k = 0; k < size; ++k) {
        own[k] = 0.0;
    }
    return own;
}

static casadi_real *output(casadi_real *wanted, casadi_real **work, size_t size)
{
    casadi_real *own = *work;
    *work += size;
    return wanted != NULL ? wanted : own;
}
"""


def jacobians_model(model: Model) -> tuple[Model, dict[str, Jacobian]]:
    """A model `<name>_jacobians` of the Jacobians of what is differentiated, and how their entries lie."""
    found = {name: jacobian(model.programs[name]) for name in DIFFERENTIATED if name in model.programs}
    found = {name: made for name, made in found.items() if made.blocks}
    inputs = {made.program.name: _test_inputs(model, name) for name, made in found.items()}
    programs: dict[str, Program | Iteration] = {made.program.name: made.program for made in found.values()}
    return replace(model, name=longer_name(model.name, "_jacobians"), programs=programs, test_inputs=inputs), found


def _test_inputs(model: Model, name: str) -> tuple[np.ndarray, ...]:
    """The states of a function; for an iteration its solution, then y and the parameters."""
    given = model.test_inputs[name]
    if not isinstance(model.programs[name], Iteration):
        return given
    (solution,), _ = model(name, *given)
    return (solution, given[0], *given[2:])


def print_external(model: Model) -> dict[str, str]:
    """File name to text: `<name>_external.c`, `<name>_jacobians.h` and `.c`."""
    derived, jacobians = jacobians_model(model)
    lines = ["/*", *(f" * {line}".rstrip() for line in banner(model)), " */", f'#include "{model.name}.h"']
    lines += [f'#include "{derived.name}.h"', "", "#include <stddef.h>", *HEAD.rstrip().splitlines()]
    for name, program in model.programs.items():
        lines += ["", *_function(model.name, name, program)]
        if name in jacobians:
            lines += ["", *_jacobian(model.name, name, jacobians[name])]
    return {f"{model.name}_external.c": "\n".join([*lines, ""]), **print_c(derived, batches=False)}


def _function(model: str, name: str, program: Program | Iteration) -> list[str]:
    symbol = f"{model}_casadi_{name}"
    inputs, outputs = program.inputs, (*program.outputs, STATUS_PORT)
    words = sum(port.size for port in (*inputs, *program.outputs))
    given = [(port, f"input(arg[{i}], &w, {port.size})") for i, port in enumerate(inputs)]
    lines = [f"EXTERNAL({symbol}, {len(inputs)}, {len(outputs)}, {words})", ""]
    lines += names_of(symbol, "in", [port.name for port in inputs])
    lines += names_of(symbol, "out", [port.name for port in outputs])
    lines += sparsities_of(symbol, "in", [dense_pattern(port) for port in inputs])
    lines += sparsities_of(symbol, "out", [dense_pattern(port) for port in outputs])
    results = list(enumerate(program.outputs))
    return [*lines, *body_of(symbol, f"{model}_{name}", inputs=given, results=results, status=len(results))]


def _jacobian(model: str, name: str, made: Jacobian) -> list[str]:
    """`jac_<function>`: inputs and outputs of the function in, one block per output and input out."""
    symbol = f"jac_{model}_casadi_{name}"
    inputs, outputs = made.source.inputs, (*made.source.outputs, STATUS_PORT)
    iteration = isinstance(made.source, Iteration)
    blocks = {(o, i): (port, entry) for port, entry in _placed(made) for o, i in [entry[:2]]}
    words = sum(port.size for port in (*inputs, *made.program.inputs, *made.program.outputs))
    count = len(inputs) + len(outputs)
    lines = [f"EXTERNAL({symbol}, {count}, {len(inputs) * len(outputs)}, {words})", ""]
    lines += names_of(symbol, "in", [*(p.name for p in inputs), *(f"out_{p.name}" for p in outputs)])
    lines += names_of(symbol, "out", [f"jac_{o.name}_{i.name}" for o in outputs for i in inputs])
    lines += sparsities_of(symbol, "in", [dense_pattern(port) for port in (*inputs, *outputs)])
    patterns = [
        pattern_of(o, i, blocks[r, c][1] if (r, c) in blocks else None)
        for r, o in enumerate(outputs)
        for c, i in enumerate(inputs)
    ]
    lines += sparsities_of(symbol, "out", patterns)
    # the solution of an iteration is the first output, which CasADi hands over after the inputs
    order = [len(inputs), 0, *range(2, len(inputs))] if iteration else list(range(len(inputs)))
    given = [(port, f"input(arg[{k}], &w, {port.size})") for k, port in zip(order, made.program.inputs, strict=True)]
    results = [(o * len(inputs) + i, port) for port, (o, i, _, _) in _placed(made)]
    return [*lines, *body_of(symbol, f"{model}_jacobians_{made.program.name}", inputs=given, results=results)]


def _placed(made: Jacobian) -> Iterator[tuple[Port, tuple[int, int, tuple[int, ...], tuple[int, ...]]]]:
    """Every output of the Jacobian's program with the place of its entries."""
    for port in made.program.outputs:
        yield port, made.blocks[port.name]


def body_of(
    symbol: str,
    function: str,
    *,
    inputs: Sequence[tuple[Port, str]],
    results: Sequence[tuple[int, Port]],
    status: int | None = None,
) -> list[str]:
    """The call of a function of the C code: inputs with what they are in C, outputs with their places in `res`.

    `status` is the place of the status; a function without one can only fail.
    """
    lines = [f"int {symbol}(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w, int mem)", "{"]
    passed = []
    for k, (port, argument) in enumerate(inputs):
        lines += [f"    const casadi_real *in{k} = {argument};"] if port.size else []
        passed.append(f"in{k}" if port.size else "NULL")
    for k, (place, port) in enumerate(results):
        lines += [f"    casadi_real *out{k} = output(res[{place}], &w, {port.size});"] if port.size else []
        passed.append(f"out{k}" if port.size else "NULL")
    call = ", ".join(passed)
    return [
        *lines,
        *("    (void)arg;" for _ in range(not any(port.size for port, _ in inputs))),
        "    (void)iw;",
        "    (void)w;",
        "    (void)mem;",
        *_ending(f"{function}({call})", status),
        "}",
    ]


def _ending(call: str, status: int | None) -> list[str]:
    if status is None:
        return [f"    return {call} > 0;"]
    return [
        f"    const int status = {call};",
        f"    if (res[{status}] != NULL) {{",
        f"        res[{status}][0] = status;",
        "        return 0;",
        "    }",
        "    return status > 0;",
    ]


def names_of(symbol: str, side: str, names: Sequence[str]) -> list[str]:
    """The function that tells names of inputs ("in") or outputs ("out")."""
    cases = [f'    case {k}: return "{name}";' for k, name in enumerate(names)]
    return _choice(f"const char *{symbol}_name_{side}(casadi_int i)", cases, "NULL")


def sparsities_of(symbol: str, side: str, patterns: Sequence[Sequence[int]]) -> list[str]:
    """A static array per pattern and the function that chooses it."""
    known: dict[tuple[int, ...], str] = {}
    arrays, cases = [], []
    for k, pattern in enumerate(patterns):
        key = tuple(pattern)
        if key not in known:
            known[key] = f"pattern{len(known)}"
            numbers = ", ".join(map(str, key))
            arrays.append(f"    static const casadi_int {known[key]}[] = {{{numbers}}};")
        cases.append(f"    case {k}: return {known[key]};")
    return _choice(f"const casadi_int *{symbol}_sparsity_{side}(casadi_int i)", cases, "NULL", arrays)


def _choice(signature: str, cases: Sequence[str], default: str, before: Sequence[str] = ()) -> list[str]:
    return [signature, "{", *before, "    switch (i) {", *cases, f"    default: return {default};", "    }", "}", ""]


def dense_pattern(port: Port) -> list[int]:
    """CasADi's pattern of a matrix without zeros."""
    rows, columns = (port.shape[0], port.shape[1]) if len(port.shape) == 2 else (port.size, 1)
    return [rows, columns, 1]


def pattern_of(output: Port, given: Port, entry: tuple[int, int, tuple[int, ...], tuple[int, ...]] | None) -> list[int]:
    """Compressed columns of a block: rows, columns, start of each column, row of each entry."""
    rows, columns = ((), ()) if entry is None else entry[2:]
    starts = [sum(c < k for c in columns) for k in range(given.size + 1)]
    return [output.size, given.size, *starts, *rows]
