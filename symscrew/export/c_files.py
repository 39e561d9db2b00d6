"""The C of a model in several files, by families of functions: who calls some compiles what these are in.

    <name>.h            what users include                     <name>_kinematics.c, _loops.c, _dynamics.c, ...
    <name>_support.h    what the sources share                 <name>_batch.c   all batch functions
    <name>_support.c    texts of statuses, routines

A source of a family holds functions of one state. `<name>_batch.c` includes the families' bodies once more, for several
states side by side: who needs no batches leaves it out, and nothing of them is compiled. Sources find each other in
their own folder, without a path. The same as one file is `symscrew.export.c.print_source`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from symscrew.export import c_wide
from symscrew.export.c_header import comment
from symscrew.export.c_interface import interface_table
from symscrew.export.c_pieces import Pieces, again, head, lanes_macro, routines_of, shared_types, status_text
from symscrew.export.listing import packed

# family: the names of its functions; the first that fits is it, and what fits none is `further`
FAMILIES = {
    "derivatives": r"derivative|linear|gradient|sensitivity",
    "regressor": r"regressor|identification",
    "margins": r"margin",
    "forward_dynamics": r"^forward_dynamics",  # with its reactions: they share a second path
    "inverse_dynamics": r"^inverse_dynamics",
    "reactions": r"reactions",
    "kinematics": r"^(body_|forward_kinematics|point_|joint_|drive_(rate|position)s|platform_|inverse_(kinem|veloc))",
    "loops": r"^(clos|velocity|acceleration|null_space|assemble)",
    "momentum": r"momentum|energy|mass_matrix|bias|power|force",
}
FURTHER = "further"


def family(function: str) -> str:
    """The family that a function is of.

    >>> family("body_poses"), family("forward_dynamics_reactions"), family("assemble"), family("mine")
    ('kinematics', 'forward_dynamics', 'loops', 'further')
    """
    return next((name for name, pattern in FAMILIES.items() if re.search(pattern, function)), FURTHER)


def print_sources(pieces: Pieces) -> dict[str, str]:
    """File name to text of everything but the header that users include."""
    model, name = pieces.model, pieces.name
    families: dict[str, list[str]] = {}
    for function in model.programs:
        families.setdefault(family(function), []).append(function)
    files = {f"{name}_{kind}.c": _family(pieces, kind, functions) for kind, functions in families.items()}
    if pieces.batches:
        bodies = [
            f"{name}_{kind}.c" for kind, functions in families.items() if not set(functions).isdisjoint(pieces.blocks)
        ]
        files[f"{name}_batch.c"] = _batch(pieces, bodies)
    files[f"{name}_support.c"] = _support_source(pieces)
    files[f"{name}_support.h"] = _support_header(pieces)
    return {file: "\n".join([*lines, ""]) for file, lines in files.items()}


def _about(pieces: Pieces, what: str, functions: Sequence[str] = ()) -> list[str]:
    """The comment at the start of a file; see the header for everything else."""
    listed = packed([*functions], indent="  ") if functions else []
    return comment(
        [f"{pieces.name}: {what}.", *listed, f"Generated with {pieces.name}.h, which says of what; do not edit."]
    )


def _family(pieces: Pieces, kind: str, functions: Sequence[str]) -> list[str]:
    """Bodies, which are read twice, then functions of one state, which are not."""
    bodies = [line for f in functions if f in pieces.bodies for line in pieces.body(f, beside=functions)]
    own = [line for f in functions for line in pieces.functions[f]]
    lines = [*_about(pieces, kind, functions), f'#include "{pieces.name}_support.h"', *bodies]
    if not bodies:
        return [*lines, *own]
    name, guard = pieces.name, again(pieces.name)
    support, lanes = f'#include "{name}_support.h"', lanes_macro(name)
    read = [f'#include "{name}_{kind}.c"', f"#undef {guard}", f"#undef {lanes}", f"{support} /* for one limb again */"]
    own = [*pieces.side_by_side(functions, lambda width: [f"{support} /* for all limbs at once */", *read]), *own]
    return [*lines, "", f"#if !defined({guard})", *own, f"#endif /* {guard} */"]


def _batch(pieces: Pieces, bodies: Sequence[str]) -> list[str]:
    """Routines of blocks, the bodies of several states, blocks, and all batch functions."""
    name, precision = pieces.name, pieces.precision
    lines = [*_about(pieces, "functions of many states"), f'#include "{name}_support.h"', "", "#include <string.h>"]
    lines += ["", *pieces.batch_routines()]
    if pieces.blocks:
        undefined = c_wide.undefined(pieces.limbs)
        lines += ["", *undefined, "", f"#if {c_wide.guard(name)}", f"#define {again(name)}"]
        lines += [*c_wide.states(name, precision, pieces.limbs), *(f'#include "{file}"' for file in bodies)]
        lines += [*undefined, *pieces.wide, "#endif"]
    return [*lines, *pieces.batch_functions()]


def _support_source(pieces: Pieces) -> list[str]:
    """What is compiled once: texts of statuses, the routines of second paths, the table for loaders."""
    lines = [
        *_about(pieces, "texts of statuses, and what several functions call"),
        f'#include "{pieces.name}_support.h"',
    ]
    lines += ["", *status_text(pieces.model)]
    routines = routines_of(pieces)
    if routines:
        lines += ["", *(line.removeprefix("static ") for line in routines)]
    return [*lines, *interface_table(pieces.model, pieces.precision)]


def _support_header(pieces: Pieces) -> list[str]:
    """What the sources share; users include the other header."""
    name, precision = pieces.name, pieces.precision
    guard = f"{name.upper()}_SUPPORT_H"
    lines = [*_about(pieces, "what its sources share"), f"#ifndef {guard}", f"#define {guard}", ""]
    lines += [*head(name, precision), *shared_types(pieces)]
    prototypes = _prototypes(routines_of(pieces))
    lines += ["", "/* Of the second path of functions, in the support's source. */", *prototypes] if prototypes else []
    lines += ["", *pieces.shared.constants.lines(), "", *pieces.shared.lines()]
    one = c_wide.one_state(name, precision, pieces.limbs)
    if not pieces.lanes:
        return [*lines, *one, "", f"#endif /* {guard} */"]
    lines += ["", f"#endif /* {guard} */", "", "/* Read again where bodies are, with equal limbs side by side. */"]
    lines += [f"#if !defined({again(name)}) || defined({lanes_macro(name)})", *c_wide.undefined(pieces.limbs), "#endif"]
    for width in sorted(set(pieces.lanes.values())):
        lines += [f"#if defined({lanes_macro(name)}) && {lanes_macro(name)} == {width}"]
        lines += [*c_wide.side_by_side(name, precision, width), "#endif"]
    return [*lines, f"#if !defined({again(name)})", *one, "#endif"]


def _prototypes(routines: Sequence[str]) -> list[str]:
    """Declarations of the static functions of a text."""
    text = "\n".join(routines)
    return [f"{found[1]};" for found in re.finditer(r"^static ([^{;]*?\))\n\{", text, re.M)]
