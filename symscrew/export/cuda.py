"""CUDA of a model: a kernel per function, one thread a state, and the same file as plain C++, a loop over states.

    <name>_<function>_states(count, stride, inputs ..., outputs ..., status)     entry k of state i at [k * stride + i]

Bodies are those of the C code (`symscrew.export.c_function`): their macros read and write where a thread's state lies.
Functions with a rank-revealing second path have only their first one: status 1 there. Nothing is allocated; arrays are
on the device, and the caller's.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from symscrew.export.c_function import angle_inputs, angles_symbol, body
from symscrew.export.c_header import comment
from symscrew.export.c_iteration import solver
from symscrew.export.c_names import argument_names, arguments, declare, wrapped_code
from symscrew.export.c_order import alive_along
from symscrew.export.c_precision import DOUBLE, Precision
from symscrew.export.c_printed import Printed, Shared
from symscrew.export.listing import banner, check_names, first_path, function_lines
from symscrew.model import Model
from symscrew.program import Iteration, Program

# Doubles that a thread's 255 registers hold beside addresses and the state's number; more go to local memory.
HELD = 120
# Of a block: two warps, so that of whatever registers kernels take little is left over. On an H200 drives are up to a
# tenth faster than with four warps, accelerations up to a twentieth; with eight most are slower.
CUDA_THREADS = 64
PROLOGUE = """\
#if defined(__CUDACC__) || defined(__CUDACC_RTC__)
#define UPPER_DEVICE static __device__ __forceinline__
#define UPPER_KERNEL extern "C" __global__ void __launch_bounds__(THREADS)
#define UPPER_FIRST ((size_t)blockIdx.x * blockDim.x + threadIdx.x)
#define UPPER_STEP ((size_t)gridDim.x * blockDim.x)
#define UPPER_SINCOS(x, s, c) SINCOS(x, s, c)
#define UPPER_INLINE __device__
#define UPPER_NAN NOT_A_NUMBER
#else /* plain C++ */
#include <cmath>
#include <cstddef>
using std::isfinite;
#define UPPER_DEVICE static inline
#define UPPER_KERNEL extern "C" void
#define UPPER_FIRST ((size_t)0)
#define UPPER_STEP ((size_t)1)
#define UPPER_SINCOS(x, s, c) (*(s) = std::sin(x), *(c) = std::cos(x))
#define UPPER_INLINE
#define UPPER_NAN (TYPE)NAN
#endif
#define restrict __restrict__
#define UPPER_UNUSED constexpr

UPPER_DEVICE void MODEL_set_nan(TYPE *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = UPPER_NAN;
    }
}
"""
MACROS = """\
#define BODY(function) UPPER_DEVICE int function##_body
#define REAL TYPE
#define READ(array, k) ((array)[(k) * stride])
#define SINES(array, k) ((array)[k])
#define WRITE(array, k, x) ((array)[(k) * stride] = (x))
#define CONSTANT(x) (x)
#define SQRT(x) ROOT(x)
#define ABS(x) MAGNITUDE(x)
#define LESS(a, b) ((a) < (b) ? ONE : ZERO)
#define SELECT(condition, a, b) ((condition) != ZERO ? (a) : (b))
#define FOURS TYPE
#define FOUR(array, k) \\
    ((READ(array, k) + READ(array, (k) + 1)) + (READ(array, (k) + 2) + READ(array, (k) + 3)))
#define SUM_OF_FOUR(x) (x)
#define SMALL(pivot, limit) (MAGNITUDE(pivot) <= (limit))
#define OR ||
#define FINITE_UNLESS(small, sum) (void)stride, (void)total; return (small) ? 1 : isfinite(sum) ? 0 : 2
#define FINITE(sum) (void)stride, (void)total; return isfinite(sum) ? 0 : 2
#define UNCHECKED() (void)stride, (void)total; return 0
#define NOT_BELOW(x, low, status) \\
    if (!((x) >= (low))) { return isfinite(x) ? (status) : 2; }
#define NOT_ABOVE(x, high, status) \\
    if (!((x) <= (high))) { return isfinite(x) ? (status) : 2; }
#define RESULT(checked, array, k, x) \\
    { const REAL result_ = (x); WRITE(array, k, result_); checked = checked + result_; }
"""
ABOUT = (
    "Compile <name>.cu by nvcc, or as C++ (-x c++) for a processor. Arrays are the caller's, on the device that runs "
    "the kernels: entry k of state i at [k * stride + i], stride >= count; an int of status per state. Each call "
    "starts a kernel on a stream (a cudaStream_t; NULL is the default one), does not wait for it, and returns what "
    "cudaGetLastError says, 0 where all is well. Nothing is allocated; several threads may call at once.",
)


def print_cuda(model: Model, precision: Precision = DOUBLE) -> dict[str, str]:
    """File name to text: `<name>.cu` and `<name>_cuda.h`, the calls from a host program."""
    check_names(model)
    shared = Shared(model, precision)
    bodies: list[str] = []
    kernels: list[str] = []
    crowded: dict[str, int] = {}
    for name, program in model.programs.items():
        found = first_path(program, "the CUDA code")
        symbol = f"{model.name}_{name}"
        straight = found.step if isinstance(found, Iteration) else found
        step = _printed(shared, f"{symbol}_step" if found is not straight else symbol, straight, precision)
        if (count := max(alive_along(step.order))) > _held(precision):
            crowded[name] = count
        bodies += ["", *body(step)]
        if isinstance(found, Iteration):
            bodies += ["", *_step(step), *_solver(symbol, found, step)]
        kernels += ["", *comment(function_lines(f"{symbol}_kernel", found)), *_kernel(step, symbol, found)]
    texts = {"UPPER": model.name.upper(), "MODEL": model.name, **_words(precision)}
    lines = [*comment(banner(model)), *_filled(PROLOGUE, texts), "", *shared.constants.lines(), "", *shared.lines()]
    lines += ["", *_filled(MACROS, texts), *bodies, *kernels, "", *_launches(model, precision)]
    return {f"{model.name}.cu": "\n".join([*lines, ""]), f"{model.name}_cuda.h": _header(model, precision, crowded)}


def print_device(model: Model) -> str:
    """Functions on arrays of one state, `int <name>_<function>(inputs ..., outputs ...)`, for code around them.

    As CUDA they run on the device; the text is C++, too. Functions are straight-line ones, in double precision.
    """
    shared, bodies = Shared(model, DOUBLE), list[str]()
    for name, program in model.programs.items():
        straight = first_path(program, "the CUDA code")
        assert isinstance(straight, Program)
        step = _printed(shared, f"{model.name}_{name}", straight, DOUBLE)
        bodies += ["", *body(step), "", *_step(step)]
    texts = {"UPPER": model.name.upper(), "MODEL": model.name, **_words(DOUBLE)}
    lines = [*_filled(PROLOGUE, texts), "", *shared.constants.lines(), "", *shared.lines()]
    return "\n".join([*lines, "", *_filled(MACROS, texts), *bodies, ""])


def _held(precision: Precision) -> int:
    return HELD if precision is DOUBLE else 2 * HELD


def _printed(shared: Shared, symbol: str, program: Program, precision: Precision) -> Printed:
    return Printed(shared.model, symbol, program, precision, shared=shared, registers=_held(precision))


def _words(precision: Precision) -> dict[str, str]:
    """What differs between the types of numbers."""
    return {
        "TYPE": precision.real,
        "THREADS": str(CUDA_THREADS),
        "SINCOS": precision.function("sincos"),
        "NOT_A_NUMBER": f'{precision.function("nan")}("")',
        "ROOT": precision.function("sqrt"),
        "MAGNITUDE": precision.function("fabs"),
        "ONE": precision.number(1.0),
        "ZERO": precision.number(0.0),
    }


def _filled(text: str, words: dict[str, str]) -> list[str]:
    return re.sub(rf"\b({'|'.join(words)})(?=_|\b)", lambda found: words[found[1]], text).splitlines()


def _called(step: Printed, where: str, stride: str) -> Iterator[str]:
    """Sines, zeros that the body leaves out, and the call of a body; `where` stands behind every array."""
    count, real = len(step.angles.gathered), step.precision.real
    upper = step.model.upper()
    if count:
        yield f"{real} angle[{count}], sine[{count}], cosine[{count}];"
        handed = [stride, "1", *(f"{name}{where}" for name in angle_inputs(step, "{1}")), "angle"]
        yield from wrapped_code(f"{angles_symbol(step)}({', '.join(handed)});", "")
        yield f"for (int k = 0; k < {count}; ++k) {{"
        yield f"    {upper}_SINCOS(angle[k], &sine[k], &cosine[k]);"
        yield "}"
    for name, run in step.cleared:
        yield f"for (size_t k = {run.start}; k < {run.stop}; ++k) {{"
        yield f"    {name}[k * {stride}{where}] = {step.precision.number(0.0)};"
        yield "}"
    handed = [stride, *(f"{name}{where}" for name in step.handed()), *(["sine", "cosine"] if count else []), "NULL"]
    yield from wrapped_code(f"const int outcome = {step.symbol}_body({', '.join(handed)});", "")


def _step(step: Printed) -> list[str]:
    """The step of an iteration on arrays of one state."""
    begin = f"{step.model.upper()}_DEVICE int "
    return [
        declare(step.symbol, arguments(step.program, step.precision), begin),
        "{",
        *(f"    {line}" for line in _called(step, "", "1")),
        "    return outcome;",
        "}",
    ]


def _solver(symbol: str, iteration: Iteration, step: Printed) -> list[str]:
    begin = f"{step.model.upper()}_DEVICE int "
    return solver(step.model, symbol, iteration, step.precision, inner=begin, outer=begin)


def _kernel(step: Printed, symbol: str, program: Program | Iteration) -> list[str]:
    """A kernel over states, or the loop over them."""
    upper = step.model.upper()
    given = ["size_t count", "size_t stride", *arguments(program, step.precision), "int *restrict status"]
    inside = _one(step, symbol, program) if isinstance(program, Iteration) else [*_called(step, " + index", "stride")]
    failed = []
    outputs = [port for port in program.outputs if port.size]
    names = dict(
        zip(program.outputs, argument_names((*program.inputs, *program.outputs))[len(program.inputs) :], strict=True)
    )
    for port in outputs:
        failed += [
            f"for (size_t k = 0; k < {port.size}; ++k) {{",
            f"    {names[port]}[k * stride + index] = {upper}_NAN;",
            "}",
        ]
    return [
        declare(f"{symbol}_kernel", given, f"{upper}_KERNEL "),
        "{",
        f"    for (size_t index = {upper}_FIRST; index < count; index += {upper}_STEP) {{",
        *(f"        {line}" for line in inside),
        *(["        if (outcome != 0) {", *(f"            {line}" for line in failed), "        }"] if failed else []),
        "        status[index] = outcome;",
        "    }",
        "}",
    ]


def _one(step: Printed, symbol: str, iteration: Iteration) -> list[str]:
    """An iteration of one state, on copies of its arrays."""
    real = step.precision.real
    names = argument_names((*iteration.inputs, *iteration.outputs))
    ports = (*iteration.inputs, *iteration.outputs)
    lines = [f"{real} own_{name}[{max(port.size, 1)}];" for name, port in zip(names, ports, strict=True)]
    for name, port in zip(names, iteration.inputs, strict=False):
        copied = _loop(port.size, f"own_{name}[k] = {name}[k * stride + index];")
        lines += copied or [f"(void){name};"]
    lines += [f"const int outcome = {symbol}({', '.join(f'own_{name}' for name in names)});"]
    return lines + _loop(iteration.outputs[0].size, f"{names[-1]}[k * stride + index] = own_{names[-1]}[k];")


def _loop(size: int, statement: str) -> list[str]:
    return [f"for (size_t k = 0; k < {size}; ++k) {{", f"    {statement}", "}"] if size else []


def _states(model: Model, name: str, precision: Precision) -> str:
    program = model.programs[name]
    given = [
        "size_t count",
        "size_t stride",
        *arguments(program, precision, restrict=""),
        "int *status",
        "void *stream",
    ]
    return declare(f"{model.name}_{name}_states", given)


def _launches(model: Model, precision: Precision) -> list[str]:
    """The calls from a host program; in plain C++ they run the loops."""
    lines = ["#if !defined(__CUDACC_RTC__)", f'#include "{model.name}_cuda.h"', ""]
    lines += ["#if defined(__CUDACC__)", "#define LAUNCH(kernel) kernel<<<blocks, THREADS, 0, (cudaStream_t)stream>>>"]
    lines += [
        "#define DONE() return (int)cudaGetLastError()",
        "#else",
        "#define LAUNCH(kernel) (void)blocks, (void)stream, kernel",
    ]
    lines += ["#define DONE() return 0", "#endif"]
    lines = [line.replace("THREADS", str(CUDA_THREADS)) for line in lines]
    for name, program in model.programs.items():
        handed = ["count", "stride", *argument_names((*program.inputs, *program.outputs)), "status"]
        lines += [
            "",
            f'extern "C" {_states(model, name, precision)}',
            "{",
            f"    const unsigned blocks = (unsigned)((count + {CUDA_THREADS - 1}) / {CUDA_THREADS});",
            "    if (count == 0) {",
            "        return 0;",
            "    }",
            *wrapped_code(f"LAUNCH({model.name}_{name}_kernel)({', '.join(handed)});"),
            "    DONE();",
            "}",
        ]
    return [*lines, "", "#undef LAUNCH", "#undef DONE", "#endif"]


def _header(model: Model, precision: Precision, crowded: Mapping[str, int]) -> str:
    """Declarations of the calls from a host program; `crowded`: values alive at once where registers hold fewer."""
    guard = f"{model.name.upper()}_CUDA_H"
    lines = [*comment([*banner(model), *ABOUT]), f"#ifndef {guard}", f"#define {guard}", "", "#include <stddef.h>", ""]
    lines += ["#ifdef __cplusplus", 'extern "C" {', "#endif"]
    for name, program in model.programs.items():
        said = [*function_lines(f"{model.name}_{name}_states", first_path(program, "the CUDA code"))]
        if name in crowded:
            said.append(
                f"Up to {crowded[name]} values at once, of about {_held(precision)} in registers: local memory."
            )
        lines += ["", *comment(said)]
        lines += [f"{_states(model, name, precision)};"]
    return "\n".join([*lines, "", "#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {guard} */", ""])
