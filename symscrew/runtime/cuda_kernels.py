"""Kernels of a model on a CUDA device, called with CuPy's arrays.

    kernels = load_cuda(model)
    u, status = kernels.inverse_dynamics(q, v, a)         arrays (size, states) on the device, status (states)

The code is that of the target "cuda", compiled by the NVRTC that CuPy brings for the device that is there; or the same
file as C++, whose kernels are loops on this processor, called with NumPy's arrays.
"""

from __future__ import annotations

import ctypes
import shutil
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.export import CUDA_THREADS, PRECISIONS, print_cuda
from symscrew.model import Model
from symscrew.program import Iteration, Program
from symscrew.runtime.compilers import CompileError, run_tool

MOST_BLOCKS = 2**20  # of a launch; with more states, a thread takes several


@dataclass(frozen=True)
class CudaModel:
    """The functions of a model as attributes: each takes an array (size, states) per input, by position or name.

    It returns an array (size, states) per output, and the status (states) last; outputs of failed states are NaN. A
    call does not wait for the device. TypeError and ValueError say which argument does not fit.
    """

    model: Model
    module: Any
    library: Any
    real: str

    def __getattr__(self, name: str) -> Callable[..., tuple[Any, ...]]:
        """The function of this name."""
        program = self.model.programs.get(name)
        if program is None:
            known = ", ".join(self.model.programs)
            raise AttributeError(f"expected a function of {self.model.name} ({known}), got {name!r}")
        kernel = self.module.get_function(f"{self.model.name}_{name}_kernel")
        return lambda *arrays, **named: self._call(kernel, program, arrays, named)

    def _call(
        self, kernel: Any, program: Program | Iteration, arrays: tuple[Any, ...], named: dict[str, Any]
    ) -> tuple[Any, ...]:
        names = [port.name for port in program.inputs]
        given = dict(zip(names, arrays, strict=False)) | named
        if len(arrays) > len(names) or set(given) != set(names):
            raise TypeError(f"{program.name} expects the arrays {', '.join(names)}, got {len(arrays)} and {[*named]}")
        read = []
        for port in program.inputs:
            array = self.library.ascontiguousarray(given[port.name], dtype=self.real)
            if array.ndim != 2 or array.shape[0] != port.size:
                raise ValueError(f"{program.name}: expected {port.name} of ({port.size}, states), got {array.shape}")
            read.append(array)
        states = {array.shape[1] for array in read}
        if len(states) != 1:
            raise ValueError(f"{program.name}: expected as many states in every array, got {sorted(states)}")
        count = states.pop()
        written = [self.library.empty((port.size, count), dtype=self.real) for port in program.outputs]
        status = self.library.empty(count, dtype="int32")
        if count:
            size = self.library.uint64(count)
            blocks = min(-(-count // CUDA_THREADS), MOST_BLOCKS)
            kernel((blocks,), (CUDA_THREADS,), (size, size, *read, *written, status))
        return (*written, status)


def load_cuda(model: Model, *, precision: str = "double") -> CudaModel:
    """The functions of a model on the CUDA device that is there, in "double" or "single" precision.

    Raises:
        CompileError: CuPy is not installed, no device is there, or the code is refused.
    """
    module, library = cuda_module(print_cuda(model, PRECISIONS[precision])[f"{model.name}.cu"])
    return CudaModel(model, module, library, "float64" if precision == "double" else "float32")


def cuda_module(text: str) -> tuple[Any, Any]:
    """Kernels of a text compiled for the device that is there, and the library of its arrays, CuPy.

    Raises:
        CompileError: as `load_cuda`.
    """
    try:
        import cupy
    except ImportError as error:
        raise CompileError("no CuPy here: pip install 'symscrew[cuda]' on a machine with a CUDA device") from error
    try:
        devices = cupy.cuda.runtime.getDeviceCount()
    except cupy.cuda.runtime.CUDARuntimeError as error:
        raise CompileError(f"no CUDA device here ({error}); symscrew.load runs on processors") from error
    if not devices:
        raise CompileError("no CUDA device here; symscrew.load runs on processors")
    return cupy.RawModule(code=text, options=("-std=c++11",)), cupy


CPP_COMPILERS = ("g++", "clang++", "c++")  # the first that is there
CPP_FLAGS = ("-std=c++11", "-O2", "-x", "c++", "-shared", "-fPIC")


class _Loops:
    """The file as C++, with what is asked of CuPy's modules."""

    def __init__(self, text: str, name: str, flags: Sequence[str]) -> None:
        compiler = next((path for path in map(shutil.which, CPP_COMPILERS) if path), None)
        if compiler is None:
            raise CompileError(f"no C++ compiler ({', '.join(CPP_COMPILERS)}): CUDA code not run")
        with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
            folder = Path(temporary)
            (folder / f"{name}.cu").write_text(text, encoding="utf-8")
            outcome, said = run_tool([compiler, *flags, f"{name}.cu", "-o", "loops.so"], name, folder=folder)
            if outcome:
                raise CompileError(f"{Path(compiler).name} refuses {name}.cu as C++: {said.strip()[-300:]}")
            self.library = ctypes.CDLL(str(folder / "loops.so"))

    def get_function(self, name: str) -> Callable[..., None]:
        """The loop that stands for a kernel; how threads are launched does not matter."""
        loop = getattr(self.library, name)
        loop.restype = None

        def launched(_grid: object, _block: object, arguments: Sequence[Any]) -> None:
            loop(*map(_passed, arguments))

        return launched


def _passed(argument: Any) -> Any:
    """An array by its address, numbers by their types."""
    if isinstance(argument, np.ndarray):
        return ctypes.c_void_p(argument.ctypes.data)
    if isinstance(argument, np.floating):
        return ctypes.c_double(float(argument))
    if isinstance(argument, np.unsignedinteger):
        return ctypes.c_size_t(int(argument))
    return ctypes.c_int(int(argument))


def cpp_module(text: str, name: str, flags: Sequence[str] = CPP_FLAGS) -> tuple[Any, Any]:
    """The same text as C++, and NumPy in place of CuPy; raises CompileError as `load_cuda_as_cpp`."""
    return _Loops(text, name, flags), np


def load_cuda_as_cpp(model: Model, *, precision: str = "double", flags: Sequence[str] = CPP_FLAGS) -> CudaModel:
    """The functions of the CUDA file on this processor, in "double" or "single" precision, on NumPy's arrays.

    Raises:
        CompileError: there is no C++ compiler, or it refuses the code.
    """
    files = print_cuda(model, PRECISIONS[precision])
    text = files[f"{model.name}.cu"].replace(f'#include "{model.name}_cuda.h"', files[f"{model.name}_cuda.h"])
    real = "float64" if precision == "double" else "float32"
    return CudaModel(model, *cpp_module(text, model.name, flags), real)
