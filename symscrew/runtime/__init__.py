"""Generated code at work: C compiled and called with NumPy arrays, or CasADi in its place."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.runtime.compiled import CompiledModel, casadi_evaluator, load
    from symscrew.runtime.compiled_function import CompiledFunction, EvaluationError, Evaluator
    from symscrew.runtime.compilers import FLAGS, CompileError, compile_c, compiler_key, find_compiler, run_tool
    from symscrew.runtime.cuda_kernels import CudaModel, cpp_module, cuda_module, load_cuda, load_cuda_as_cpp
    from symscrew.runtime.jax_functions import load_jax
    from symscrew.runtime.model_keys import model_key
    from symscrew.runtime.nvrtc import CudaCode, KernelSize, compile_cuda, find_nvrtc
    from symscrew.runtime.origin import model_of, remember_folder
    from symscrew.runtime.user_cache import CacheState, entry, key_of
    from symscrew.runtime.user_cache import clear as clear_cache
    from symscrew.runtime.user_cache import state as cache_state
    from symscrew.runtime.user_cache import without as without_cache
    from symscrew.runtime.versions import installed, version

__all__ = [
    "FLAGS",
    "CacheState",
    "CompileError",
    "CompiledFunction",
    "CompiledModel",
    "CudaCode",
    "CudaModel",
    "EvaluationError",
    "Evaluator",
    "KernelSize",
    "cache_state",
    "casadi_evaluator",
    "clear_cache",
    "compile_c",
    "compile_cuda",
    "compiler_key",
    "cpp_module",
    "cuda_module",
    "entry",
    "find_compiler",
    "find_nvrtc",
    "installed",
    "key_of",
    "load",
    "load_cuda",
    "load_cuda_as_cpp",
    "load_jax",
    "model_key",
    "model_of",
    "remember_folder",
    "run_tool",
    "version",
    "without_cache",
]

__getattr__ = doors(__name__)
