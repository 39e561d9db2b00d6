"""What a library of generated C says of itself: precision, and names and sizes of all arrays of every function.

    static const  <name>_interface[] = {"double", "velocity(q 4, y_dot 1) -> (v 4)", ..., NULL}

Whoever loads a library compares it with what the manifest says before anything is called: sizes that differ would let
a function write beyond the arrays that it is given. Compiled only where <NAME>_INTERFACE is defined, as loaders do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symscrew.export.c_precision import Precision
from symscrew.model import Model
from symscrew.program import Port

Ports = Mapping[str, tuple[Sequence[Port], Sequence[Port]]]  # function -> inputs, outputs


def interface(real: str, ports: Ports) -> tuple[str, ...]:
    """The lines for functions on numbers of this type of C: equal lines, equal arrays."""

    def sizes(of: Sequence[Port]) -> str:
        return ", ".join(f"{port.name} {port.size}" for port in of)

    return (real, *(f"{name}({sizes(given)}) -> ({sizes(found)})" for name, (given, found) in sorted(ports.items())))


def interface_table(model: Model, precision: Precision) -> list[str]:
    """The table as C, for the end of the file with the functions."""
    ports = {name: (program.inputs, program.outputs) for name, program in model.programs.items()}
    return [
        "",
        f"#if defined({model.name.upper()}_INTERFACE)",
        "/* For loaders: type, then name and entries of every array of every function. */",
        f"extern const char *const {model.name}_interface[];",
        f"const char *const {model.name}_interface[] = {{",
        *(f'    "{line}",' for line in interface(precision.real, ports)),
        "    NULL",
        "};",
        "#endif",
    ]
