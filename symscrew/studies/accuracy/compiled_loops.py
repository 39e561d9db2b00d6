"""Small C libraries for timing: a generated function called state by state in a loop."""

from __future__ import annotations

import ctypes
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from symscrew.export import DOUBLE, Precision, print_c
from symscrew.model import Model
from symscrew.program import Iteration, Port, Program
from symscrew.runtime import compile_c

Array = np.ndarray


def reduced(model: Model, programs: Mapping[str, Program | Iteration]) -> Model:
    """The model with other programs, for printing."""
    inputs = {name: model.test_inputs[name] for name in programs if name in model.test_inputs}
    return replace(model, programs=dict(programs), test_inputs=inputs)


def one_file(model: Model, programs: Mapping[str, Program | Iteration], precision: Precision = DOUBLE) -> str:
    """Generated functions as one C file without includes of its own."""
    files = print_c(reduced(model, programs), precision=precision, batches=False)
    name = model.name
    return files[f"{name}.c"].replace(f'#include "{name}.h"', files[f"{name}.h"])


def compiled(text: str, flags: Sequence[str] = ()) -> ctypes.CDLL:
    """The library of a C text; it stays mapped when its file is gone."""
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        source, library = Path(temporary) / "study.c", Path(temporary) / "study.so"
        source.write_text(text, encoding="utf-8")
        compile_c(source, library, flags=flags)
        return ctypes.CDLL(str(library))


def loop_code(symbol: str, inputs: Sequence[Port], outputs: Sequence[Port], real: str, *, result: str = "int") -> str:
    """`void <symbol>_loop(size_t count, in..., out...)`: the function at every state, arrays one after the other."""
    ports = [*(("const ", p) for p in inputs), *(("", p) for p in outputs)]
    declared = ", ".join(f"{const}{real} *a{k}" for k, (const, _) in enumerate(ports))
    passed = ", ".join(f"a{k} + i * {port.size}" for k, (_, port) in enumerate(ports))
    call = f"worst |= {symbol}({passed});" if result == "int" else f"{symbol}({passed});"
    return "\n".join(
        [
            f"int {symbol}_loop(size_t count, {declared})",
            "{",
            "    int worst = 0;",
            "    for (size_t i = 0; i < count; ++i) {",
            f"        {call}",
            "    }",
            "    return worst;",
            "}",
            "",
        ]
    )


def pointer(array: Array) -> ctypes.c_void_p:
    """Address of an array's entries."""
    return ctypes.c_void_p(array.ctypes.data)


def caller(library: ctypes.CDLL, symbol: str, inputs: Sequence[Array], outputs: Sequence[Array]) -> Callable[[], float]:
    """A run of `<symbol>_loop` over all states: seconds that it took; raises where a state failed."""
    function = getattr(library, f"{symbol}_loop")
    function.restype = ctypes.c_int
    arrays = [*inputs, *outputs]
    arguments = [ctypes.c_size_t(len(inputs[0])), *map(pointer, arrays)]

    def run() -> float:
        assert all(a.flags.c_contiguous for a in arrays)
        start = time.thread_time()
        worst = function(*arguments)
        taken = time.thread_time() - start
        if worst > 0:
            raise ArithmeticError(f"{symbol}: status {worst}")
        return taken

    return run
