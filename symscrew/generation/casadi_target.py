"""Target "casadi": a .casadi file per function. Their bytes depend on the version of CasADi, their numbers do not."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from symscrew import runtime
from symscrew.export import casadi_functions
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import Results, compare_values, evaluated


def files(order: Order) -> Mapping[str, bytes]:
    """<function>.casadi of every function."""
    made = {}
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        for name, function in casadi_functions(order.model).items():
            path = Path(temporary) / f"{name}.casadi"
            function.save(str(path))
            made[path.name] = path.read_bytes()
    return made


def compare(case: Case) -> Iterator[Finding]:
    """Those just generated; those of the folder that is checked are not read: they can carry more than functions."""
    import casadi

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        function = casadi.Function.load(str(case.fresh / f"{name}.casadi"))
        return evaluated(
            runtime.casadi_evaluator(function), [p.size for p in case.model.programs[name].outputs], inputs
        )

    yield compare_values("CasADi", case.model, case.expected, evaluate)
