"""Modelica of a model: a package with an external function and a block per program, around the C of the target "c".

    (v, status) = four_bar.velocity(q, y_dot);         status as in the header; above 0 the results are NaN
    four_bar.velocity_block rates(q = here, y_dot = rate);        the same as a block, which stops where it fails

Arrays are column by column, as in C. The library that tools link is `lib<name>` in the folder of the package.
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.export.listing import banner, check_names, plain, statuses, wrapped
from symscrew.model import Model
from symscrew.program import Iteration, Port, Program

WORDS = """algorithm and annotation assert block break class connect connector constant constrainedby der discrete each
else elseif elsewhen encapsulated end enumeration equation expandable extends external false final flow for function if
import impure in initial inner input loop model not operator or outer output package parameter partial protected public
pure record redeclare replaceable return stream then true type when while within time Real Integer Boolean String"""
RESERVED = frozenset(f"{WORDS} status".split())


def print_modelica(model: Model) -> dict[str, str]:
    """File name to text: `<name>.mo`."""
    check_names(model)
    package = safe(model.name)
    lines = [*(f"// {line}".rstrip() for line in banner(model)), f"package {package}", _text(model.name, "  ")]
    for function, program in model.programs.items():
        lines += ["", *_function(model.name, function, program), "", *_block(function, program)]
    return {f"{package}.mo": "\n".join([*lines, f"end {package};", ""])}


def safe(name: str) -> str:
    """A name as an identifier of Modelica.

    >>> safe("velocity"), safe("der")
    ('velocity', 'der_of_model')
    """
    return f"{name}_of_model" if name in RESERVED else name


def port_names(program: Program | Iteration) -> tuple[list[str], list[str]]:
    """Inputs and outputs as identifiers that differ."""
    used, found = set[str](), []
    for port in (*program.inputs, *program.outputs):
        name = safe(port.name)
        name = f"{name}_out" if name in used else name
        used.add(name)
        found.append(name)
    return found[: len(program.inputs)], found[len(program.inputs) :]


def _text(text: str, indent: str, end: str = "") -> str:
    """A comment of the language, on one line."""
    return f'{indent}"{plain(text).replace(chr(34), chr(39))}"{end}'


def _declared(kind: str, names: Sequence[str], ports: Sequence[Port]) -> list[str]:
    return [
        f"    {kind} Real {name}[{port.size}]{_text(port.description, ' ', ';')}"
        for name, port in zip(names, ports, strict=True)
    ]


def _function(model: str, function: str, program: Program | Iteration) -> list[str]:
    """The external function."""
    given, made = port_names(program)
    codes = "; ".join(f"{code} {text.split(':')[0]}" for code, text in statuses(program).items())
    where = f'IncludeDirectory="modelica://{safe(model)}", LibraryDirectory="modelica://{safe(model)}"'
    call = f"status = {model}_{function}({', '.join([*given, *made])})"
    return [
        f"  function {safe(function)}",
        _text(program.description, "    "),
        *_declared("input", given, program.inputs),
        *_declared("output", made, program.outputs),
        f"    output Integer status{_text(codes, ' ', ';')}",
        *wrapped(f'external "C" {call}', first="  ", later="      "),
        f'    annotation(Include="#include \\"{model}.h\\"", Library={{"{model}", "m"}},',
        f"               {where});",
        f"  end {safe(function)};",
    ]


def _block(function: str, program: Program | Iteration) -> list[str]:
    """The same as a block: outputs hold at every instant, and a failure ends the simulation."""
    given, made = port_names(program)
    name = f"{function}_block"
    return [
        f"  block {name}",
        _text(f"{function}, at every instant", "    "),
        *_declared("input", given, program.inputs),
        *_declared("output", made, program.outputs),
        f"    output Integer status{_text('up to 0: success', ' ', ';')}",
        "  equation",
        f"    ({', '.join([*made, 'status'])}) = {safe(function)}({', '.join(given)});",
        f'    assert(status <= 0, "{function} fails: its status says why");',
        f"  end {name};",
    ]
