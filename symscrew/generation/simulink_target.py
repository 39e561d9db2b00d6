"""Target "simulink": a C S-function around the target "c", which a stub of Simulink's header runs here."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from symscrew.export import library_sources, print_simulink
from symscrew.generation.rust_target import call
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import compare_values
from symscrew.model import Model
from symscrew.runtime import find_compiler

LIMIT = 600  # seconds of the C compiler, which takes a minute for the longest functions of the catalogue
PLACE = "simulink_blocks"  # a folder of its own: other targets have a main.c, too

# As much of simstruc.h as the S-function uses, with the meaning that Simulink's documentation gives.
STUB = """\
#include <string.h>
typedef double real_T;
typedef int int_T;
typedef struct { const char *text; } mxArray;
typedef struct {
    mxArray parameter;
    int_T wanted, given, inputs, outputs, input_size[64], output_size[64];
    const real_T *input[64];
    real_T *output[64];
    const char *error;
    void *user;
} SimStruct;
#define INHERITED_SAMPLE_TIME (-1.0)
#define SS_OPTION_EXCEPTION_FREE_CODE 1
#define ssSetNumSFcnParams(S, n) ((S)->wanted = (n))
#define ssGetNumSFcnParams(S) ((S)->wanted)
#define ssGetSFcnParamsCount(S) ((S)->given)
#define ssSetSFcnParamTunable(S, k, tunable) ((void)(S), (void)(k), (void)(tunable))
#define ssGetSFcnParam(S, k) ((k) == 0 ? &(S)->parameter : NULL)
#define ssSetErrorStatus(S, text) ((S)->error = (text))
#define ssSetNumInputPorts(S, n) ((S)->inputs = (n), 1)
#define ssSetNumOutputPorts(S, n) ((S)->outputs = (n), 1)
#define ssSetInputPortWidth(S, k, n) ((S)->input_size[k] = (n))
#define ssSetInputPortRequiredContiguous(S, k, yes) ((void)(S), (void)(k), (void)(yes))
#define ssSetInputPortDirectFeedThrough(S, k, yes) ((void)(S), (void)(k), (void)(yes))
#define ssSetOutputPortWidth(S, k, n) ((S)->output_size[k] = (n))
#define ssSetNumSampleTimes(S, n) ((void)(S), (void)(n))
#define ssSetOptions(S, options) ((void)(S), (void)(options))
#define ssSetSampleTime(S, k, time) ((void)(S), (void)(k), (void)(time))
#define ssSetOffsetTime(S, k, time) ((void)(S), (void)(k), (void)(time))
#define ssSetUserData(S, pointer) ((S)->user = (pointer))
#define ssGetUserData(S) ((S)->user)
#define ssGetInputPortSignal(S, k) ((const void *)(S)->input[k])
#define ssGetOutputPortSignal(S, k) ((void *)(S)->output[k])
static int mxGetString(const mxArray *array, char *text, size_t size)
{
    const size_t length = strlen(array->text);
    memcpy(text, array->text, length < size ? length + 1 : size);
    text[size - 1] = '\\0';
    return length < size ? 0 : 1;
}
"""
# A block of every function, each at as many states as it is told first.
MAIN = """\
#include <stdio.h>
#include "@NAME@_sfun.c"

static real_T values[2][64][@LARGEST@];

int main(int count, char **names)
{
    for (int k = 1; k < count; ++k) {
        SimStruct block = {.parameter = {names[k]}, .given = 1};
        real_T states = 0.0;
        mdlInitializeSizes(&block);
        if (block.error != NULL) {
            fputs(block.error, stderr);
            return 1;
        }
        mdlInitializeSampleTimes(&block);
        mdlStart(&block);
        for (int port = 0; port < 64; ++port) {
            block.input[port] = values[0][port];
            block.output[port] = values[1][port];
        }
        if (fread(&states, sizeof states, 1, stdin) != 1) {
            return 2;
        }
        for (int state = 0; state < (int)states; ++state) {
            for (int port = 0; port < block.inputs; ++port) {
                const size_t size = (size_t)block.input_size[port];
                if (fread(values[0][port], sizeof(real_T), size, stdin) != size) {
                    return 2;
                }
            }
            mdlOutputs(&block, 0);
            for (int port = 0; port < block.outputs; ++port) {
                fwrite(values[1][port], sizeof(real_T), (size_t)block.output_size[port], stdout);
            }
        }
        mdlTerminate(&block);
    }
    return 0;
}
"""


def files(order: Order) -> Mapping[str, str]:
    """<name>_sfun.c."""
    return print_simulink(order.model)


def section(order: Order) -> Sequence[str]:
    """How it is built."""
    name = order.model.name
    return [
        "### Simulink",
        "",
        "In MATLAB, with this folder as the current one:",
        "",
        "```matlab",
        f"files = setdiff({{dir('{name}*.c').name}}, {{'{name}_sfun.c'}});",
        f"mex('{name}_sfun.c', files{{:}})",
        "```",
        "",
        f"Then an S-Function block `{name}_sfun` with the name of a function in quotes as its parameter.",
    ]


def compare(case: Case) -> Iterator[Finding]:
    """Values by a stub of Simulink's header; that is no test in Simulink."""
    if find_compiler() is None:  # which the target "c" says
        return
    failed = build(case.model, case.fresh)
    if failed:
        yield False, failed
        return
    given = {name: case.model.test_inputs[name] for name in case.expected}
    found = call(case.model, case.fresh / PLACE, given, np.dtype("<f8"), *case.model.programs)
    yield compare_values("S-function, by a stub of Simulink,", case.model, case.expected, lambda name, _: found[name])


def build(model: Model, directory: Path) -> str:
    """The S-function in a folder as a program PLACE/main that runs blocks; "" or what the compiler says."""
    place = directory / PLACE
    place.mkdir(exist_ok=True)
    ports = [p for program in model.programs.values() for p in (*program.inputs, *program.outputs)]
    main = MAIN.replace("@NAME@", model.name).replace("@LARGEST@", str(max([1, *(p.size for p in ports)])))
    for file, text in (("simstruc.h", STUB), ("cg_sfun.h", ""), ("main.c", main)):
        (place / file).write_text(text, encoding="utf-8")
    files = [path.name for path in directory.iterdir() if path.name.startswith(model.name)]
    sources = [f"../{file}" for file in library_sources(files, model.name)]
    strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function"]
    strict += ["-O0", "-ffp-contract=off", "-I..", "-I."]
    command = [find_compiler() or "cc", *strict, "main.c", *sources, "-o", "main", "-lm"]
    try:
        done = subprocess.run(
            command, cwd=place, capture_output=True, encoding="utf-8", errors="replace", check=False, timeout=LIMIT
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return f"the S-function of {model.name} does not compile: {error}"
    return f"the S-function of {model.name} does not compile: {done.stderr[:500]}" if done.returncode else ""
