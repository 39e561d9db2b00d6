"""Target "cuda": a kernel per function, one thread a state; the same file is plain C++, which is how it is compared."""

from __future__ import annotations

import ctypes
import shutil
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from symscrew import runtime
from symscrew.export import DOUBLE, Precision, print_cuda
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import Results, compare_values, first_path, relative_difference

COMPILERS = ("g++", "clang++", "c++")
FLAGS = ("-std=c++11", "-O0", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-x", "c++", "-shared", "-fPIC")
SINGLE_TOLERANCE = 1e-3  # of the largest entry: float has seven digits, and a function near a pivot loses some


def files(order: Order) -> Mapping[str, str]:
    """<name>.cu, <name>_cuda.h."""
    return print_cuda(order.model, order.precision)


def section(order: Order) -> Sequence[str]:
    """How to compile and call the kernels."""
    name = order.model.name
    return [
        "## On a graphics processor",
        "",
        f"`nvcc -O3 -arch=native -shared -Xcompiler -fPIC {name}.cu -o lib{name}_cuda.so`, or as C++ on a processor:",
        f"`g++ -O2 -x c++ -shared -fPIC {name}.cu -o lib{name}_cuda.so`. One thread takes one state; entry k of state",
        f"i of every array lies at `[k * stride + i]`. `{name}_cuda.h` declares a call per function; from Python,",
        "`load_cuda` of `symscrew.runtime` compiles and calls the kernels on CuPy's arrays.",
    ]


def compare(case: Case) -> Iterator[Finding]:
    """Values of the file as C++; whether CUDA's compiler takes it, and what its kernels spill."""
    name = case.model.name
    compiler = next((path for path in map(shutil.which, COMPILERS) if path), None)
    if compiler is None:
        yield True, "no C++ compiler here (apt install g++): CUDA code not run"
    else:
        library = case.fresh / f"lib{name}_cuda.so"
        outcome, said = runtime.run_tool([compiler, *FLAGS, f"{name}.cu", "-o", str(library)], name, folder=case.fresh)
        if outcome:
            yield False, f"{Path(compiler).name} refuses {name}.cu as C++: {said.strip()[-300:]}"
            return
        yield _compared(case, ctypes.CDLL(str(library)))
    if runtime.find_nvrtc() is None:
        yield True, "no CUDA compiler here (pip install 'symscrew[nvrtc]'): CUDA code not compiled for a device"
        return
    try:
        kernels = runtime.compile_cuda((case.fresh / f"{name}.cu").read_text()).kernels
    except runtime.CompileError as error:
        yield False, str(error)
        return
    spilled = [k.removeprefix(f"{name}_").removesuffix("_kernel") for k, size in kernels.items() if size.spill_stores]
    most = max((k.registers for k in kernels.values()), default=0)
    told = f"; {', '.join(spilled)} keep some values in local memory" if spilled else "; none spills"
    yield len(kernels) == len(case.model.programs), f"NVRTC: {len(kernels)} kernels, at most {most} registers{told}"


def _compared(case: Case, library: ctypes.CDLL) -> Finding:
    model, precision = case.model, case.precision
    expected = {name: first_path(*found) for name, found in case.expected.items()}

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        sizes = [port.size for port in model.programs[name].outputs]
        return called_as_loop(library, model.name, name, inputs=inputs, sizes=sizes, precision=precision)

    if precision is DOUBLE:
        return compare_values("CUDA code as C++", model, expected, evaluate)
    worst = 0.0
    for name, (arrays, status) in expected.items():
        got, codes = evaluate(name, model.test_inputs[name])
        sound = (np.ravel(status) == 0) & (codes == 0)
        pairs = zip(arrays, got, strict=True)
        worst = max([worst, *(relative_difference(a[sound], b[sound]) for a, b in pairs if sound.any())])
    return worst <= SINGLE_TOLERANCE, f"CUDA code in single precision, as C++, differs from double by {worst:.1e}"


def called_as_loop(
    library: ctypes.CDLL,
    model: str,
    function: str,
    *,
    inputs: Sequence[np.ndarray],
    sizes: Sequence[int],
    precision: Precision,
) -> Results:
    """Outputs and statuses of a function compiled as C++, of inputs (states, size)."""
    real = np.float64 if precision is DOUBLE else np.float32
    states = len(inputs[0]) if inputs else 1
    given = [np.ascontiguousarray(np.asarray(x).T, dtype=real) for x in inputs]
    outputs = [np.empty((size, states), dtype=real) for size in sizes]
    status = np.empty(states, dtype=np.intc)
    pointers = [ctypes.c_void_p(x.ctypes.data) for x in (*given, *outputs, status)]
    call = getattr(library, f"{model}_{function}_states")
    call(ctypes.c_size_t(states), ctypes.c_size_t(states), *pointers, None)
    return tuple(x.T.astype(float) for x in outputs), status
