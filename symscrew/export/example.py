"""A runnable example in C with numbers filled in, and a CMakeLists.txt that builds it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.export.c_names import wrapped_code
from symscrew.export.c_precision import DOUBLE, Precision
from symscrew.export.listing import banner, plain, unit_of, wrapped
from symscrew.export.reload_limit import SPILLS
from symscrew.model import Model
from symscrew.program import Port

WIDTH = 112  # characters of a line of labels
LONGEST = 190  # lines of the program: it is read as a whole
SHOWN = (
    "assemble",
    "velocity",
    "acceleration",
    "inverse_dynamics",
    "inverse_dynamics_preload",
    "forward_dynamics",
    "joint_reactions",
)

PRINT_ARRAY = """/* Prints an array, an entry a line: its label and unit, and the number. */
static void print_array(
    const char *name, const REAL *array, size_t size, const char *const *labels)
{
    printf("  %s\\n", name);
    for (size_t k = 0; k < size; ++k) {
        printf("    %-32s % .12g\\n", labels[k], (double)array[k]);
    }
}
"""
PRINT_COLUMNS = """/* Prints a matrix, a column of it a line: what it is of, and the numbers. */
static void print_columns(
    const char *name, const REAL *array, size_t rows, size_t columns, const char *const *labels)
{
    printf("  %s\\n", name);
    for (size_t k = 0; k < columns; ++k) {
        printf("    %-24s", labels[k]);
        for (size_t i = 0; i < rows; ++i) {
            printf(" % .6g", (double)array[k * rows + i]);
        }
        printf("\\n");
    }
}
"""


def print_example(model: Model, precision: Precision = DOUBLE, sources: Sequence[str] = ()) -> str:
    """`example.c`: calls what matters most at the first test state, prints results with labels and units.

    It stays short enough to be read as a whole: of a large mechanism it calls fewer functions.
    """
    names = [name for name in SHOWN if name in model.programs] or list(model.programs)[:3]
    while len(lines := _lines(model, names, precision, sources)) > LONGEST and len(names) > 1:
        names = names[:-1]
    return "\n".join([*lines, ""])


def _lines(model: Model, names: Sequence[str], precision: Precision, sources: Sequence[str]) -> list[str]:
    files = " ".join(sources or [f"{model.name}.c"])
    lines = ["/*", *(f" * {line}".rstrip() for line in banner(model)[:3]), " *"]
    lines += [f" * {line}" for line in wrapped(f"cc -std=c99 -O2 -fno-math-errno example.c {files} -lm -o example")]
    lines += [" * ./example", " */", f'#include "{model.name}.h"', "", "#include <stdio.h>", ""]
    given, labels = _Arrays("given"), _Arrays("labels")
    calls = [line for name in names for line in ("", *_call(model, name, precision, given=given, labels=labels))]
    lines += ["/* A state of the mechanism: replace it by your own. The header says what the entries are. */"]
    for name, (port, numbers) in given.known.items():
        units = unit_of(port) or ", ".join(dict.fromkeys(port.units))
        lines.append(f"static const {precision.real} {name}[{port.size}] = {{ /* {plain(f'[{units}]')} */")
        entries = ", ".join(number.strip("()") for number in numbers)
        lines += [*wrapped(entries, first="    ", later="    ", width=WIDTH - 2), "};"]
    lines += ["", "/* What entries of results are. */"] if labels.known else []
    for name, (_, texts) in labels.known.items():
        lines.append(f"static const char *const {name}[{len(texts)}] = {{")
        lines += [*_packed([f'"{text}"' for text in texts], "    "), "};"]
    for routine, text in (("print_array", PRINT_ARRAY), ("print_columns", PRINT_COLUMNS)):
        if any(f" {routine}(" in line for line in calls):
            lines += ["", *text.replace("REAL", precision.real).splitlines()]
    lines += [*calls, "", "int main(void)", "{", "    int failures = 0;"]
    lines += [f"    failures += show_{name}() > 0;" for name in names]
    return [*lines, "    return failures != 0;", "}"]


class _Arrays:
    """Constant arrays of the file, each once however many functions take it."""

    def __init__(self, prefix: str) -> None:
        self.prefix = prefix
        self.known: dict[str, tuple[Port, tuple[str, ...]]] = {}

    def name(self, port: Port, entries: Sequence[str]) -> str:
        """What an array with these entries is called."""
        same = [name for name, (p, known) in self.known.items() if p.name == port.name and known == tuple(entries)]
        if same:
            return same[0]
        number = 1 + sum(p.name == port.name for p, _ in self.known.values())
        name = f"{self.prefix}_{port.name}{number if number > 1 else ''}"
        self.known[name] = port, tuple(entries)
        return name


def _call(model: Model, name: str, precision: Precision, *, given: _Arrays, labels: _Arrays) -> list[str]:
    """`show_<name>`: calls a function at one state and prints what it gives."""
    program, symbol = model.programs[name], f"{model.name}_{name}"
    states = [np.atleast_2d(array)[0] for array in model.test_inputs[name]]
    pairs = zip(program.inputs, states, strict=True)
    arguments = [
        given.name(port, [precision.number(x) for x in state]) if port.size else "NULL" for port, state in pairs
    ]
    outputs = [port for port in program.outputs if port.size]
    arguments += [f"{port.name}_found" if port.size else "NULL" for port in program.outputs]
    lines = [f"static int show_{name}(void)", "{"]
    lines += [f"    {precision.real} {port.name}_found[{port.size}];" for port in outputs]
    lines += wrapped_code(f"const int status = {symbol}({', '.join(arguments)});")
    lines += [f'    printf("{symbol}: status %d, %s\\n", status, {model.name}_status_text(status));']
    for port in outputs:
        columns = _columns(port)
        if columns is None:
            of = labels.name(port, [_entry(port, k) for k in range(port.size)])
            lines += wrapped_code(f'print_array("{port.name}", {port.name}_found, {port.size}, {of});')
        else:
            of, rows = labels.name(port, columns[0]), len(columns[1])
            lines.append(f'    print_columns("{port.name}: {", ".join(columns[1])}",')
            lines.append(f"        {port.name}_found, {rows}, {len(columns[0])}, {of});")
    return [*lines, "    return status;", "}"]


def _columns(port: Port) -> tuple[list[str], list[str]] | None:
    """(what the columns of a matrix are of, what its rows are with units), where labels say both; else None."""
    if len(port.shape) != 2 or min(port.shape) < 2 or len(port.labels) != port.size:
        return None
    rows = port.shape[0]
    pairs = [label.rpartition(".") for label in port.labels]
    columns = [plain(pairs[k][0]).replace('"', "'") for k in range(0, port.size, rows)]
    of_rows = [f"{pairs[k][2]} [{port.units[k]}]" for k in range(rows)]
    same = all(
        pair[0] == pairs[k - k % rows][0] and f"{pair[2]} [{port.units[k]}]" == of_rows[k % rows]
        for k, pair in enumerate(pairs)
    )
    return (columns, [plain(text).replace('"', "'") for text in of_rows]) if same and all(columns) else None


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
            "# roots are instructions, a product and its sum may be one (fused); no check is lost by either",
            'if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")',
            f"  target_compile_options({library} PRIVATE -fno-math-errno -ffp-contract=fast)",
            "endif()",
            "# GCC tries fewer ways to hold values in registers: long functions compile faster, to code as fast",
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
