"""Generated code at work: C compiled and called with NumPy arrays, or CasADi in its place."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.runtime.compiled import CompiledModel, casadi_evaluator, load
    from symscrew.runtime.compiled_function import CompiledFunction, EvaluationError, Evaluator
    from symscrew.runtime.compilers import FLAGS, CompileError, compile_c, find_compiler, run_tool
    from symscrew.runtime.origin import model_of, version
    from symscrew.runtime.user_cache import CacheState, entry, key_of
    from symscrew.runtime.user_cache import clear as clear_cache
    from symscrew.runtime.user_cache import state as cache_state
    from symscrew.runtime.user_cache import without as without_cache

__all__ = [
    "FLAGS",
    "CacheState",
    "CompileError",
    "CompiledFunction",
    "CompiledModel",
    "EvaluationError",
    "Evaluator",
    "cache_state",
    "casadi_evaluator",
    "clear_cache",
    "compile_c",
    "entry",
    "find_compiler",
    "key_of",
    "load",
    "model_of",
    "run_tool",
    "version",
    "without_cache",
]

__getattr__ = doors(__name__)
