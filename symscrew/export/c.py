"""C99 of a model: a header that can be read alone, and straight-line functions on caller-owned arrays.

    int <model>_<function>(inputs ..., outputs ...)                                     one state
    int <model>_<function>_batch(count, inputs ..., outputs ..., status)                many, one after the other
    int <model>_<function>_batch_soa(count, stride, inputs ..., outputs ..., status)    many, side by side

Nothing is allocated, no state is kept, matrices are column-major. On failure all outputs are NaN.
"""

from __future__ import annotations

from functools import cache

from symscrew.export import c_wide
from symscrew.export.c_files import print_sources
from symscrew.export.c_header import STATUS_MACROS, comment, print_header
from symscrew.export.c_interface import interface_table
from symscrew.export.c_names import argument_names
from symscrew.export.c_pieces import (
    IN_LANES,
    Pieces,
    again,
    head,
    lanes_macro,
    routines_of,
    shared_types,
    status_text,
    straight_line,
)
from symscrew.export.c_precision import DOUBLE, TABLE, Precision
from symscrew.export.line_width import within_width
from symscrew.export.listing import banner, check_names
from symscrew.model import Model

__all__ = [
    "IN_LANES", "STATUS_MACROS", "TABLE", "argument_names", "print_c", "print_header", "print_source", "straight_line",
]  # fmt: skip


def print_c(
    model: Model,
    *,
    precision: Precision = DOUBLE,
    batches: bool = True,
    lanes: bool = True,
    several: bool = False,
    processes: int = 1,
) -> dict[str, str]:
    """File name to text: `<name>.h` and `<name>.c`, or `several` sources by families of functions (see `c_files`).

    Without batch functions, or limbs side by side, if they are not needed; `several` may be printed by two `processes`.
    """
    check_names(model)
    header = cache(lambda: print_header(model, precision=precision, batches=batches))
    if several:
        pieces = Pieces(
            model, precision, batches=batches, lanes=lanes and batches, processes=processes, meanwhile=header
        )
        files = {f"{model.name}.h": header(), **print_sources(pieces)}
    else:
        source = print_source(model, precision=precision, batches=batches, lanes=lanes and batches)
        files = {f"{model.name}.h": header(), f"{model.name}.c": source}
    return {file: within_width(file, text) for file, text in files.items()}


def print_source(model: Model, *, precision: Precision = DOUBLE, batches: bool = True, lanes: bool = True) -> str:
    """Definitions of all functions in one file: what they share, bodies, then function after function, then batches.

    With batches the file is read twice: it includes itself for the bodies of several states at once.
    """
    pieces, name = Pieces(model, precision, batches=batches, lanes=lanes), model.name
    routines = routines_of(pieces)
    lines = [*comment(banner(model)), f"#if !defined({again(name)})", *head(name, precision)]
    lines += ["", "#include <string.h>"] if batches else []
    lines += ["", *status_text(model), *shared_types(pieces)]
    lines += ["", *pieces.batch_routines()] if batches else []
    lines += ["", *routines] if routines else []
    one, undefined = c_wide.one_state(name, precision, pieces.limbs), c_wide.undefined(pieces.limbs)
    lines += ["", *pieces.shared.constants.lines(), "", *pieces.shared.lines(), *one]
    lines += [f"#endif /* {again(name)} */"]
    lines += [line for f in pieces.bodies for line in pieces.body(f, beside=pieces.bodies)]

    def read_again(width: int) -> list[str]:
        macros = [*undefined, *c_wide.side_by_side(name, precision, width), f'#include "{name}.c"']
        return [*macros, *(f"#undef {macro}" for macro in (again(name), lanes_macro(name))), *undefined, *one]

    lines += ["", f"#if !defined({again(name)})", *pieces.side_by_side(pieces.bodies, read_again)]
    lines += [*(line for f in pieces.functions.values() for line in f), "", *undefined]
    if pieces.blocks:
        lines += ["", f"#if {c_wide.guard(name)}", f"#define {again(name)}"]
        lines += [*c_wide.states(name, precision, pieces.limbs), f'#include "{name}.c"', *undefined]
        lines += [*pieces.wide, "#endif"]
    lines += pieces.batch_functions() if batches else []
    lines += [*interface_table(model, precision), f"#endif /* {again(name)} */"]
    return "\n".join([*lines, ""])
