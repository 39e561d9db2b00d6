"""Generated functions compiled beside the loops that time them, and the arrays that both are given."""

from __future__ import annotations

import ctypes
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.export import print_c
from symscrew.model import Model
from symscrew.runtime import CompileError, compile_c, find_compiler

MOST_ARRAYS = 8  # that the loops in loops.c can pass; a function with more is refused with its name
Measure = Callable[[], float]


class Compiled:
    """The generated functions and the loops that time them, in two libraries."""

    def __init__(self, model: Model, functions: Sequence[str], *, threads: bool = False) -> None:
        """Compile; raises CompileError."""
        if find_compiler() is None:
            raise CompileError("no C compiler to compile what is to be timed; install gcc")
        self.whole = model
        self.model = replace(model, programs={name: model.programs[name] for name in functions})
        with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
            folder = Path(temporary)
            for file, text in print_c(self.model).items():
                (folder / file).write_text(text, encoding="utf-8")
            (folder / "loops.c").write_bytes(resources.files(__package__).joinpath("loops.c").read_bytes())
            compile_c(folder / "loops.c", folder / "loops.so")
            flags = ["-fopenmp"] if threads else []
            compile_c(folder / f"{model.name}.c", folder / "functions.so", flags=flags)
            self.loops, self.code = ctypes.CDLL(str(folder / "loops.so")), ctypes.CDLL(str(folder / "functions.so"))
        for loop in (self.loops.time_single, self.loops.time_block, self.loops.time_engine):
            loop.restype = ctypes.c_double

    def function(self, name: str, suffix: str = "") -> Any:
        """A function of the generated code."""
        return getattr(self.code, f"{self.model.name}_{name}{suffix}")


def pointer(array: np.ndarray) -> ctypes.c_void_p:
    """Where an array is."""
    return ctypes.c_void_p(array.ctypes.data)


def pointers(arrays: Sequence[np.ndarray]) -> Any:
    """Where arrays are, padded to the arity of the loops."""
    places = [a.ctypes.data for a in arrays]
    places += [places[0]] * (MOST_ARRAYS - len(places))
    return (ctypes.c_void_p * MOST_ARRAYS)(*places)


def states(model: Model, function: str, count: int) -> list[np.ndarray]:
    """The function's test states, repeated up to `count`, in C order."""
    given = [np.atleast_2d(x) for x in model.test_inputs[function]]
    return [np.ascontiguousarray(np.resize(x, (count, x.shape[1]))) for x in given]


def difference(expected: np.ndarray, got: np.ndarray) -> float:
    """Largest difference over the largest entry."""
    return float(np.abs(got - expected).max(initial=0.0) / max(np.abs(expected).max(initial=0.0), 1e-12))
