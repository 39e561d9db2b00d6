"""Second derivatives of CasADi's external functions: what makes its Hessians exact, sparse and compiled.

The library of `casadi_external` with `<name>_hessians.c` and `<name>_external_hessians.c` beside its sources: every
function of `DIFFERENTIATED` that is no iteration then has its adjoint, `adj1_<function>`, and the adjoint's Jacobian,
`jac_adj1_<function>`, with exactly the blocks and entries that are not zero. CasADi finds both by their names, so that
`casadi.hessian`, and IPOPT without any option, take them.

Source: https://web.casadi.org/docs, section "External derivatives".
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from symscrew.description import longer_name
from symscrew.errors import DescriptionError
from symscrew.export.c import print_c
from symscrew.export.casadi_external import (
    DIFFERENTIATED,
    HEAD,
    STATUS_PORT,
    body_of,
    dense_pattern,
    names_of,
    pattern_of,
    sparsities_of,
)
from symscrew.export.listing import banner
from symscrew.model import Model
from symscrew.program import Iteration, Jacobian, Program, adjoint, jacobian


@dataclass(frozen=True)
class Second:
    """A function, its adjoint and the adjoint's Jacobian."""

    source: Program
    adjoint: Program
    jacobian: Jacobian


def hessians_model(model: Model) -> tuple[Model, Mapping[str, Second]]:
    """A model `<name>_hessians` of the adjoints and their Jacobians, and these by the names of what they are of.

    Raises:
        DescriptionError: the model has no function that can be differentiated twice.
    """
    found: dict[str, Second] = {}
    programs: dict[str, Program | Iteration] = {}
    inputs: dict[str, tuple[np.ndarray, ...]] = {}
    for name in DIFFERENTIATED:
        source = model.programs.get(name)
        if source is None or isinstance(source, Iteration) or not any(port.size for port in source.outputs):
            continue
        made = adjoint(source)
        second = jacobian(made)
        found[name] = Second(source, made, second)
        count = len(model.test_inputs[name][0]) if model.test_inputs[name] else 1
        sizes = [port.size for port in source.outputs]
        # weights that are all different, near 1
        weights = tuple(np.tile(np.linspace(0.5, 1.5, size), (count, 1)) for size in sizes)
        for program in (made, second.program):
            programs[program.name] = program
            inputs[program.name] = (*model.test_inputs[name], *weights)
    if not found:
        possible = ", ".join(name for name in DIFFERENTIATED if name != "assemble")
        known = ", ".join(model.programs)
        raise DescriptionError(f"target external_hessians: needs one of {possible}; the model has {known}")
    return replace(model, name=longer_name(model.name, "_hessians"), programs=programs, test_inputs=inputs), found


def print_hessians(model: Model) -> dict[str, str]:
    """File name to text: `<name>_external_hessians.c`, `<name>_hessians.h` and `.c`."""
    derived, found = hessians_model(model)
    lines = ["/*", *(f" * {line}".rstrip() for line in banner(model)), " */", f'#include "{derived.name}.h"', ""]
    lines += ["#include <stddef.h>", *HEAD.rstrip().splitlines()]
    for name, second in found.items():
        lines += ["", *_adjoint(model.name, name, second), "", *_jacobian(model.name, name, second)]
    return {f"{model.name}_external_hessians.c": "\n".join([*lines, ""]), **print_c(derived, batches=False)}


def _arguments(second: Second) -> list[str]:
    """Inputs, outputs as they came out, weights: as CasADi hands them to an adjoint."""
    outputs = [*(port.name for port in second.source.outputs), "status"]
    inputs = [port.name for port in second.source.inputs]
    return [*inputs, *(f"out_{name}" for name in outputs), *(f"adj_{name}" for name in outputs)]


def _read(second: Second) -> list[int]:
    """Which of these the C functions take: the inputs and the weights but that of the status."""
    given, found = len(second.source.inputs), len(second.source.outputs)
    return [*range(given), *(given + found + 1 + k for k in range(found))]


def _adjoint(model: str, name: str, second: Second) -> list[str]:
    symbol = f"adj1_{model}_casadi_{name}"
    made, outputs = second.adjoint, (*second.source.outputs, STATUS_PORT)
    ports = (*second.source.inputs, *outputs, *outputs)
    words = sum(port.size for port in (*made.inputs, *made.outputs))
    lines = [f"EXTERNAL({symbol}, {len(ports)}, {len(made.outputs)}, {words})", ""]
    lines += names_of(symbol, "in", _arguments(second))
    lines += names_of(symbol, "out", [port.name for port in made.outputs])
    lines += sparsities_of(symbol, "in", [dense_pattern(port) for port in ports])
    lines += sparsities_of(symbol, "out", [dense_pattern(port) for port in made.outputs])
    given = [(p, f"input(arg[{k}], &w, {p.size})") for k, p in zip(_read(second), made.inputs, strict=True)]
    results = list(enumerate(made.outputs))
    return [*lines, *body_of(symbol, f"{model}_hessians_{made.name}", inputs=given, results=results)]


def _jacobian(model: str, name: str, second: Second) -> list[str]:
    symbol = f"jac_adj1_{model}_casadi_{name}"
    made, outputs = second.jacobian, (*second.source.outputs, STATUS_PORT)
    of, by = second.adjoint.outputs, (*second.source.inputs, *outputs, *outputs)
    read = _read(second)
    blocks = {(made.blocks[p.name][0], read[made.blocks[p.name][1]]): p for p in made.program.outputs}
    words = sum(port.size for port in (*made.program.inputs, *made.program.outputs))
    names = _arguments(second)
    lines = [f"EXTERNAL({symbol}, {len(by) + len(of)}, {len(of) * len(by)}, {words})", ""]
    lines += names_of(symbol, "in", [*names, *(f"out_{port.name}" for port in of)])
    lines += names_of(symbol, "out", [f"jac_{port.name}_{other}" for port in of for other in names])
    lines += sparsities_of(symbol, "in", [dense_pattern(port) for port in (*by, *of)])
    patterns = [
        pattern_of(o, i, made.blocks[blocks[r, c].name] if (r, c) in blocks else None)
        for r, o in enumerate(of)
        for c, i in enumerate(by)
    ]
    lines += sparsities_of(symbol, "out", patterns)
    given = [(p, f"input(arg[{k}], &w, {p.size})") for k, p in zip(read, made.program.inputs, strict=True)]
    results = [(r * len(by) + c, port) for (r, c), port in blocks.items()]
    return [*lines, *body_of(symbol, f"{model}_hessians_{made.program.name}", inputs=given, results=results)]
