"""Generated code at work: C compiled and called with NumPy arrays, or CasADi in its place."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.runtime.compiled import (
        FLAGS,
        CompiledFunction,
        CompiledModel,
        CompileError,
        EvaluationError,
        Evaluator,
        casadi_evaluator,
        compile_c,
        find_compiler,
        load,
    )

__all__ = [
    "FLAGS",
    "CompileError",
    "CompiledFunction",
    "CompiledModel",
    "EvaluationError",
    "Evaluator",
    "casadi_evaluator",
    "compile_c",
    "find_compiler",
    "load",
]

__getattr__ = doors(__name__)
