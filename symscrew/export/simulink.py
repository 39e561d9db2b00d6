"""Simulink of a model: a level-2 S-function in C, whose parameter says which function of the model a block is.

    mex four_bar_sfun.c four_bar_*.c           S-Function block: four_bar_sfun, parameter 'velocity'

Ports are the arrays of the function in their order, column by column as in MATLAB, and last of all the status as a
number: where it is above 0 the outputs are NaN. It calls the C of the target "c".
"""

from __future__ import annotations

from symscrew.export.drive_kinematics_c import template
from symscrew.export.listing import banner, check_names, wrapped
from symscrew.model import Model

HEAD = """\
#define S_FUNCTION_NAME @NAME@_sfun
#define S_FUNCTION_LEVEL 2

#include <stddef.h>
#include <string.h>

#include "@NAME@.h"
#include "simstruc.h"

enum { MOST_PORTS = @MOST@, LONGEST_NAME = @LONGEST@ };

typedef struct {
    const char *name;
    int_T inputs, outputs; /* without the status */
    int_T input_size[MOST_PORTS], output_size[MOST_PORTS];
    int (*call)(const real_T *const *given, real_T *const *made);
} Function;
"""


def print_simulink(model: Model) -> dict[str, str]:
    """File name to text: `<name>_sfun.c`."""
    check_names(model)
    calls, rows = [], []
    most = max(len([p for p in ports if p.size]) for f in model.programs.values() for ports in (f.inputs, f.outputs))
    for function, program in model.programs.items():
        given, sizes = list[str](), list[list[int]]()
        for array, ports in (("given", program.inputs), ("made", program.outputs)):
            own = [port.size for port in ports if port.size]  # Simulink has no ports without entries
            sizes.append(own)
            places = iter(range(len(own)))
            given += [f"{array}[{next(places)}]" if port.size else "NULL" for port in ports]
        calls += [
            f"static int call_{function}(const real_T *const *given, real_T *const *made)",
            "{",
            *(f"    (void){name};" for name, own in zip(("given", "made"), sizes, strict=True) if not own),
            f"    return {model.name}_{function}({', '.join(given)});",
            "}",
            "",
        ]
        counts = ", ".join(str(len(own)) for own in sizes)
        arrays = ", ".join("{" + ", ".join(map(str, own or [0])) + "}" for own in sizes)
        rows += wrapped(f'{{"{function}", {counts}, {arrays}, call_{function}}},', first="    ", later="     ")
    words = {"NAME": model.name, "MOST": max(most, 1), "LONGEST": 2 + max(map(len, model.programs))}
    head = HEAD
    for word, meaning in words.items():
        head = head.replace(f"@{word}@", str(meaning))
    known = ", ".join(model.programs)
    text = f"{model.name}_sfun: expected as its parameter the name of a function in quotes, one of: {known}"
    error = "#define NO_SUCH_FUNCTION \\\n" + " \\\n".join(f'    "{line} "' for line in wrapped(text, width=90))
    about = ["/*", *(f" * {line}".rstrip() for line in banner(model)), " */"]
    lines = [*about, *head.splitlines(), "", *calls, "static const Function functions[] = {", *rows, "};", ""]
    lines += [*error.splitlines(), "", *template("simulink_sfun.c").splitlines(), ""]
    return {f"{model.name}_sfun.c": "\n".join(lines)}
