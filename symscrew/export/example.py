"""A runnable example in C with numbers filled in, and a CMakeLists.txt that builds it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.export.c_names import wrapped_code
from symscrew.export.c_precision import DOUBLE, Precision
from symscrew.export.listing import banner, plain, unit_of, wrapped
from symscrew.model import Model
from symscrew.program import Port

# of gcc: without it the register allocation of a long function takes most of the time, for no faster code
SPILLS = "--param=lra-max-considered-reload-pseudos=5"
WIDTH = 112  # characters of a line of labels
SHOWN = (
    "assemble",
    "velocity",
    "acceleration",
    "inverse_dynamics",
    "inverse_dynamics_preload",
    "forward_dynamics",
    "joint_reactions",
)

PRINT = """/* Prints an array, an entry a line: its label and unit, and the number. */
static void print_array(
    const char *name, const REAL *array, size_t size, const char *const *labels)
{
    printf("  %s\\n", name);
    for (size_t k = 0; k < size; ++k) {
        printf("    %-32s % .12g\\n", labels[k], (double)array[k]);
    }
}
"""


def print_example(model: Model, precision: Precision = DOUBLE, sources: Sequence[str] = ()) -> str:
    """`example.c`: calls what matters most at the first test state, prints results with labels and units."""
    names = [name for name in SHOWN if name in model.programs] or list(model.programs)[:3]
    files = " ".join(sources or [f"{model.name}.c"])
    lines = ["/*", *(f" * {line}".rstrip() for line in banner(model)[:3]), " *"]
    lines += [f" * {line}" for line in wrapped(f"cc -std=c99 -O2 -fno-math-errno example.c {files} -lm -o example")]
    lines += [" * ./example", " */", f'#include "{model.name}.h"', "", "#include <stdio.h>", ""]
    given = _Given(precision)
    calls = [line for name in names for line in ("", *_call(model, name, given, precision=precision))]
    lines += [*given.lines(), "", *PRINT.replace("REAL", precision.real).splitlines(), *calls]
    lines += ["", "int main(void)", "{", "    int failures = 0;"]
    lines += [f"    failures += show_{name}() > 0;" for name in names]
    return "\n".join([*lines, "    return failures != 0;", "}", ""])


class _Given:
    """The arrays that functions are called with, each once."""

    def __init__(self, precision: Precision) -> None:
        self.precision = precision
        self.arrays: dict[tuple[str, tuple[str, ...]], tuple[str, Port]] = {}

    def name(self, port: Port, state: np.ndarray) -> str:
        """What an array with these numbers is called."""
        key = port.name, tuple(self.precision.number(x) for x in state)
        if key not in self.arrays:
            number = 1 + sum(name == port.name for name, _ in self.arrays)
            self.arrays[key] = f"given_{port.name}{number if number > 1 else ''}", port
        return self.arrays[key][0]

    def lines(self) -> list[str]:
        """Their definitions: some numbers a line, the first entry's label in front."""
        lines = ["/* A state of the mechanism: replace it by your own. The header says what the entries are. */"]
        for (_, numbers), (name, port) in self.arrays.items():
            units = unit_of(port) or ", ".join(dict.fromkeys(port.units))
            lines.append(f"static const {self.precision.real} {name}[{port.size}] = {{ /* {plain(f'[{units}]')} */")
            lines += [*_several([number.strip("()") for number in numbers], "    "), "};"]
        return lines


def _several(entries: Sequence[str], indent: str) -> list[str]:
    """Entries with commas, some a line."""
    return wrapped(", ".join(entries), first=indent, later=indent, width=110)


def _call(model: Model, name: str, given: _Given, *, precision: Precision) -> list[str]:
    """`show_<name>`: calls a function at one state and prints what it gives."""
    program, symbol = model.programs[name], f"{model.name}_{name}"
    states = [np.atleast_2d(array)[0] for array in model.test_inputs[name]]
    pairs = zip(program.inputs, states, strict=True)
    arguments = [given.name(port, state) if port.size else "NULL" for port, state in pairs]
    outputs = [port for port in program.outputs if port.size]
    arguments += [f"{port.name}_found" if port.size else "NULL" for port in program.outputs]
    lines = [f"static int show_{name}(void)", "{"]
    for port in outputs:
        lines.append(f"    static const char *const {port.name}_labels[{port.size}] = {{")
        lines += [*_packed([f'"{_entry(port, k)}"' for k in range(port.size)], "        "), "    };"]
    lines += [f"    {precision.real} {port.name}_found[{port.size}];" for port in outputs]
    lines += wrapped_code(f"const int status = {symbol}({', '.join(arguments)});")
    lines += [f'    printf("{symbol}: status %d, %s\\n", status, {model.name}_status_text(status));']
    lines += [
        f'    print_array("{port.name}", {port.name}_found, {port.size}, {port.name}_labels);' for port in outputs
    ]
    return [*lines, "    return status;", "}"]


def _packed(entries: Sequence[str], indent: str) -> list[str]:
    """Texts with commas, as many a line as fit: blanks in them are no places to break a line."""
    lines: list[str] = []
    for entry in entries:
        if lines and len(lines[-1]) + len(entry) + 2 <= WIDTH:
            lines[-1] += f" {entry},"
        else:
            lines.append(f"{indent}{entry},")
    return lines


def _entry(port: Port, k: int) -> str:
    """Label and unit of an entry as text of C."""
    label = port.labels[k] if len(port.labels) == port.size else f"{port.name}[{k}]"
    unit = unit_of(port) or port.units[k]
    return plain(f"{label} [{unit}]").replace('"', "'")


def print_cmake(model: Model, sources: Sequence[str] = ()) -> str:
    """`CMakeLists.txt`: a static library `<name>_model` of the sources, and the example."""
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
            f"add_library({library} STATIC",
            *(f"  {source}" for source in sources or [f"{model.name}.c"]),
            ")",
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
