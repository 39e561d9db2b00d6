"""Target "casadi": a .casadi file per function. Their bytes depend on the version of CasADi, their numbers do not."""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import runtime
from symscrew.export import casadi_functions
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import Results, compare_values, evaluated


def files(order: Order) -> Mapping[str, bytes]:
    """<function>.casadi of every function."""
    return saved(casadi_functions(order.model))


def saved(functions: Mapping[str, Any]) -> Mapping[str, bytes]:
    """CasADi functions by name as files."""
    made = {}
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        for name, function in functions.items():
            path = Path(temporary) / f"{name}.casadi"
            function.save(str(path))
            _whole(path)
            made[path.name] = path.read_bytes()
    return made


def _whole(path: Path) -> None:
    """CasADi says nothing where a disk is full, and leaves a part of the file; what it cannot read is one.

    Raises:
        OSError: it is.
    """
    import casadi

    try:
        casadi.Function.load(str(path))
    except RuntimeError as error:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path)) from error


def compare(case: Case) -> Iterator[Finding]:
    """Those just generated; those of the folder that is checked are not read: they can carry more than functions."""
    import casadi

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        function = casadi.Function.load(str(case.fresh / f"{name}.casadi"))
        return evaluated(
            runtime.casadi_evaluator(function), [p.size for p in case.model.programs[name].outputs], inputs
        )

    yield compare_values("CasADi", case.model, case.expected, evaluate)
