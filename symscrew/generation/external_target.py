"""Target "external": the C code as external functions of CasADi, with their Jacobians. It brings "c" along."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.export import jacobians_model, library_sources, print_external
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import TOLERANCE, Results, compare_values, relative_difference
from symscrew.program import Port
from symscrew.runtime import compile_c, find_compiler


def files(order: Order) -> Mapping[str, str]:
    """<name>_external.c, <name>_jacobians.h, <name>_jacobians.c."""
    return print_external(order.model)


def compare(case: Case) -> Iterator[Finding]:
    """Values, statuses and Jacobians of the functions in CasADi's ABI."""
    if find_compiler() is None:  # which the target "c" says
        return
    directory, model, expected = case.fresh, case.model, case.expected
    library = directory / f"lib{model.name}_external.so"
    names = library_sources((path.name for path in directory.iterdir()), model.name)
    others = [*names[1:], *(f"{model.name}{part}.c" for part in ("_jacobians", "_external"))]
    more = [str(directory / other) for other in others]
    compile_c(directory / names[0], library, flags=("-ffp-contract=off", *more))

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        ports = (model.programs[name].inputs, model.programs[name].outputs)
        function = load_external(library, f"{model.name}_casadi_{name}")
        rows = [_row(function, *ports, state) for state in zip(*inputs, strict=True)]
        status = np.array([code for _, code in rows])
        columns = zip(*(row for row, _ in rows), strict=True)
        return tuple(np.array(column) for column in columns), status

    yield compare_values("CasADi external", model, expected, evaluate)
    yield _compare_jacobians(library, case)


def _compare_jacobians(library: Path, case: Case) -> Finding:
    """Blocks of the Jacobians against the derivatives that the evaluator gives, at the states that do not fail."""
    model, expected = case.model, case.expected
    derived, jacobians = jacobians_model(model)
    worst = 0.0
    for name, made in jacobians.items():
        function = load_external(library, f"jac_{model.name}_casadi_{name}")
        values, status = derived(made.program.name, *derived.test_inputs[made.program.name])
        for k in np.flatnonzero(np.asarray(status) == 0):
            state = [array[k] for array in (*model.test_inputs[name], *expected[name][0])]
            found = function.call([*_shaped((*made.source.inputs, *made.source.outputs), state), 0.0])
            for port, value in zip(made.program.outputs, values, strict=True):
                output, place, *_ = made.blocks[port.name]
                block = found[output * len(made.source.inputs) + place]
                worst = max(worst, relative_difference(value[k], np.array(block.nonzeros())))
    text = f"{len(jacobians)} Jacobians of CasADi externals agree with the evaluator to {worst:.1e}"
    return worst <= TOLERANCE, text


def load_external(library: Path, symbol: str) -> Any:
    """A function of a shared library in CasADi's ABI."""
    import casadi

    return casadi.external(symbol, str(library))


def _row(
    function: Any, inputs: Sequence[Port], outputs: Sequence[Port], state: Sequence[np.ndarray]
) -> tuple[tuple[np.ndarray, ...], int]:
    """The outputs (size) of an external function at one state, and its status."""
    *found, status = function.call(_shaped(inputs, state))
    return tuple(np.array(x).T.reshape(port.size) for port, x in zip(outputs, found, strict=True)), int(status)


def _shaped(ports: Sequence[Port], state: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Arrays (size) as CasADi wants them: matrices, where the port is one."""
    return [x.reshape(p.shape, order="F") if len(p.shape) == 2 else x for p, x in zip(ports, state, strict=True)]
