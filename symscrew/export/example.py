"""A runnable example in C with numbers filled in, and a CMakeLists.txt that builds it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.export.c_precision import DOUBLE, Precision
from symscrew.export.listing import banner, plain, unit_of
from symscrew.model import Model
from symscrew.program import Iteration, Port, Program

# of gcc: without it the register allocation of a long function takes most of the time, for no faster code
SPILLS = "--param=lra-max-considered-reload-pseudos=5"
SHOWN = (
    "assemble",
    "velocity",
    "acceleration",
    "inverse_dynamics",
    "inverse_dynamics_preload",
    "forward_dynamics",
    "joint_reactions",
)

PRINT = """static void print_array(
    const char *name, const REAL *array, size_t size, const char *const *entry)
{
    printf("  %s\\n", name);
    for (size_t k = 0; k < size; ++k) {
        printf("    %-32s % .12g\\n", entry[k], (double)array[k]);
    }
}
"""


def print_example(model: Model, precision: Precision = DOUBLE) -> str:
    """`example.c`: calls what matters most at the first test state, prints results with labels and units."""
    names = [name for name in SHOWN if name in model.programs] or list(model.programs)[:3]
    lines = ["/*", *(f" * {line}".rstrip() for line in banner(model)), " *"]
    lines += [
        f" * cc -std=c99 -O2 -fno-math-errno example.c {model.name}.c -lm -o example && ./example",
        " */",
    ]
    lines += [
        f'#include "{model.name}.h"',
        "",
        "#include <stdio.h>",
        "",
        *PRINT.replace("REAL", precision.real).splitlines(),
    ]
    for name in names:
        states = [np.atleast_2d(array)[0] for array in model.test_inputs[name]]
        lines += ["", *_call(model.name, name, model.programs[name], states=states, precision=precision)]
    lines += ["", "int main(void)", "{", "    int failures = 0;"]
    lines += [f"    failures += show_{name}() > 0;" for name in names]
    return "\n".join([*lines, "    return failures != 0;", "}", ""])


def _call(
    model: str, name: str, program: Program | Iteration, *, states: Sequence[np.ndarray], precision: Precision
) -> list[str]:
    """`show_<name>`: calls a function at one state and prints what it gives."""
    symbol = f"{model}_{name}"
    lines = [f"static int show_{name}(void)", "{"]
    arguments = []
    for i, (port, state) in enumerate(zip(program.inputs, states, strict=True)):
        arguments.append(f"input{i}" if port.size else "NULL")
        if port.size:
            lines += [f"    static const {precision.real} input{i}[{port.size}] = {{ /* {port.name} */"]
            lines += [f"        {precision.number(x)}, /* {_entry(port, k)} */" for k, x in enumerate(state)]
            lines += ["    };"]
    for i, port in enumerate(program.outputs):
        arguments.append(f"output{i}" if port.size else "NULL")
        if port.size:
            lines += [f"    static const char *const entries{i}[{port.size}] = {{"]
            lines += [f'        "{_entry(port, k)}",' for k in range(port.size)]
            lines += ["    };", f"    {precision.real} output{i}[{port.size}];"]
    lines += [f"    const int status = {symbol}({', '.join(arguments)});"]
    lines += [f'    printf("{symbol}: status %d, %s\\n", status, {model}_status_text(status));']
    lines += [
        f'    print_array("{port.name}", output{i}, {port.size}, entries{i});'
        for i, port in enumerate(program.outputs)
        if port.size
    ]
    return [*lines, "    return status;", "}"]


def _entry(port: Port, k: int) -> str:
    """Label and unit of an entry as text of C."""
    label = port.labels[k] if len(port.labels) == port.size else f"{port.name}[{k}]"
    unit = unit_of(port) or port.units[k]
    return plain(f"{label} [{unit}]").replace('"', "'")


def print_cmake(model: Model) -> str:
    """`CMakeLists.txt`: a static library `<name>_model` and the example."""
    lines = [f"# {line}".rstrip() for line in banner(model)]
    library = f"{model.name}_model"
    return "\n".join(
        [
            *lines,
            "cmake_minimum_required(VERSION 3.10)",
            f"project({model.name} C)",
            "",
            "if(NOT CMAKE_BUILD_TYPE)",
            "  set(CMAKE_BUILD_TYPE Release)",
            "endif()",
            "",
            f"add_library({library} STATIC {model.name}.c)",
            f"target_include_directories({library} PUBLIC ${{CMAKE_CURRENT_SOURCE_DIR}})",
            f"set_target_properties({library} PROPERTIES C_STANDARD 99 POSITION_INDEPENDENT_CODE ON)",
            'if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")',
            f"  target_compile_options({library} PRIVATE -fno-math-errno -ffp-contract=fast)",
            "endif()",
            "include(CheckCCompilerFlag)",
            f"check_c_compiler_flag({SPILLS} {model.name.upper()}_FEW_RELOADS)",
            f"if({model.name.upper()}_FEW_RELOADS)",
            f"  target_compile_options({library} PRIVATE {SPILLS})",
            "endif()",
            "if(UNIX)",
            f"  target_link_libraries({library} PUBLIC m)",
            "endif()",
            "",
            f"add_executable({model.name}_example example.c)",
            f"target_link_libraries({model.name}_example PRIVATE {library})",
            "",
        ]
    )
