"""Compiled functions of a model, called from Python on NumPy arrays.

    model, or folder --print, compile--> shared library --ctypes--> functions of arrays (*batch, *shape)

    model = load(directory_or_model)
    u = model.inverse_dynamics(q, v, a)              # arrays (*batch, *shape)
    u, status = model.inverse_dynamics(q, v, a, check=False)

The generated C is compiled by the system's compiler and called through ctypes; a whole batch is one call on
the arrays themselves: nothing is copied if they are of type float64 and either C-contiguous (one state after the
other) or all transposes of C-contiguous arrays (size, states). With `load(..., vectorised=True)` the batch takes
eight states at once. Without a C compiler the same functions run in CasADi (`backend` says which).
"""

from __future__ import annotations

import ctypes
import math
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.description import check_name
from symscrew.export import (
    DOUBLE,
    HASHES,
    PRECISIONS,
    SPILLS,
    OutputError,
    Precision,
    print_c,
    read_hashes,
    read_manifest,
    read_port,
)
from symscrew.model import Model
from symscrew.program import STATUS, Port

COMPILERS = ("cc", "gcc", "clang")  # the first that is there
FLAGS = ("-std=c99", "-O2", "-fno-math-errno", "-ffp-contract=fast", "-shared", "-fPIC")
Evaluator = Callable[[Sequence[np.ndarray], Sequence[np.ndarray], np.ndarray], None]  # reads first, writes the others
Ports = Mapping[str, tuple[tuple[Port, ...], tuple[Port, ...]]]  # function -> inputs, outputs


class EvaluationError(ArithmeticError):
    """A function reported a status other than success; `status` holds it per state."""

    def __init__(self, message: str, status: np.ndarray) -> None:
        """The error of a call whose states ended in `status`."""
        super().__init__(message)
        self.status = status


class CompileError(RuntimeError):
    """The C compiler refused the generated code; the message holds what it said."""


@dataclass(frozen=True)
class CompiledFunction:
    """One function of the model: call it with arrays (*batch, *shape), by position or by name.

    It returns an array per output (the array itself if there is one output only). A status above 0
    raises `EvaluationError`; with `check=False` the status (*batch) is returned as a last value instead, and
    outputs of failed states are NaN. Inputs that are transposes of arrays (size, states) are read in place, and
    the outputs are such transposes, too.
    """

    name: str
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    evaluator: Evaluator
    columns: Evaluator | None = None

    def __repr__(self) -> str:
        given, found = (", ".join(f"{p.name}[{p.size}]" for p in ports) for ports in (self.inputs, self.outputs))
        return f"CompiledFunction({self.name}({given}) -> {found})"

    def __call__(self, *arguments: object, check: bool = True, **named: object) -> object:
        """Evaluate; see the class.

        Raises:
            EvaluationError: a status above 0, unless `check` is False.
            TypeError: not the function's inputs, each of them once.
            ValueError: an array that does not end in the shape of its input.
        """
        arrays, batch = self._arrays(self._ordered(arguments, named))
        count = math.prod(batch)
        if self.columns is not None and side_by_side(arrays, batch):
            columns = [np.empty((port.size, count)) for port in self.outputs]
            status = np.zeros(count, dtype=np.intc)
            self.columns([a.T for a in arrays], columns, status)
            return self._finished([c.T for c in columns], status, batch, check)
        flat = [
            np.ascontiguousarray(a if a.shape[:-1] == batch else np.broadcast_to(a, (*batch, a.shape[-1])))
            for a in arrays
        ]
        results = [np.empty((count, port.size)) for port in self.outputs]
        status = np.zeros(count, dtype=np.intc)
        self.evaluator(flat, results, status)
        return self._finished(results, status, batch, check)

    def _finished(
        self, results: Sequence[np.ndarray], status: np.ndarray, batch: tuple[int, ...], check: bool
    ) -> object:
        """Results in the shape of the batch, or an error that tells which states failed."""
        shaped = tuple(_unflatten(r, batch, p.shape) for r, p in zip(results, self.outputs, strict=True))
        status = status.reshape(batch)
        if not check:
            return (*shaped, status)
        if (status > 0).any():
            raise EvaluationError(self._failure(status), status)
        return shaped[0] if len(shaped) == 1 else shaped

    def _ordered(self, arguments: Sequence[object], named: Mapping[str, object]) -> list[object]:
        if not named and len(arguments) == len(self.inputs):
            return list(arguments)
        names = [port.name for port in self.inputs]
        given = dict(zip(names, arguments, strict=False))
        twice = [name for name in named if name in given]
        if len(arguments) > len(names) or twice or sorted({**given, **named}) != sorted(names):
            got = ", ".join([*(str(n) for n in given), *named]) or "nothing"
            raise TypeError(f"{self.name} expects ({', '.join(names)}), got {len(arguments)} arrays and {got}")
        return [{**given, **named}[name] for name in names]

    def _arrays(self, arguments: Sequence[object]) -> tuple[list[np.ndarray], tuple[int, ...]]:
        arrays = []
        for port, argument in zip(self.inputs, arguments, strict=True):
            array = np.asarray(argument, dtype=float)
            shape = port.shape if port.shape != (1,) or array.shape[-1:] == (1,) else ()
            depth = array.ndim - len(shape)
            if depth < 0 or array.shape[depth:] != shape:
                expected = f"{port.name} of shape {port.shape} after batch dimensions"
                raise ValueError(f"{self.name} expects {expected}, got {array.shape}")
            if len(shape) > 1:  # column-major
                array = np.moveaxis(array, range(depth, array.ndim), range(array.ndim - 1, depth - 1, -1))
            arrays.append(array if len(shape) == 1 else array.reshape(*array.shape[:depth], port.size))
        batches = {a.shape[:-1] for a in arrays}
        return arrays, batches.pop() if len(batches) == 1 else np.broadcast_shapes(*batches)

    def _failure(self, status: np.ndarray) -> str:
        if not status.shape:
            return f"{self.name}: {STATUS[int(status)]}"
        failed = np.argwhere(status > 0)
        first = tuple(int(i) for i in failed[0])
        return (
            f"{self.name}: {len(failed)} of {status.size} states failed; the first is state {first}: "
            f"{STATUS[int(status[first])]}"
        )


class CompiledModel:
    """The functions of a model as attributes and items; `backend` is "c" or "casadi"."""

    def __init__(self, name: str, backend: str, functions: Mapping[str, CompiledFunction]) -> None:
        """Functions by name, as `load` makes them."""
        self.name, self.backend, self.functions = name, backend, dict(functions)

    def __getattr__(self, name: str) -> CompiledFunction:
        """The function of this name."""
        functions: dict[str, CompiledFunction] = self.__dict__.get("functions", {})
        if name not in functions:
            raise AttributeError(f"the model has no function {name}; it has {', '.join(functions)}")
        return functions[name]

    def __repr__(self) -> str:
        return f"CompiledModel({self.name}: {len(self.functions)} functions in {self.backend})"

    def __getitem__(self, name: str) -> CompiledFunction:
        """The function of this name."""
        return self.functions[name]

    def __dir__(self) -> list[str]:
        """Attributes and functions."""
        return [*super().__dir__(), *self.functions]


def side_by_side(arrays: Sequence[np.ndarray], batch: tuple[int, ...]) -> bool:
    """Whether all arrays (states, size) are transposes of C-contiguous arrays, so that columns can be read in place."""
    if len(batch) != 1 or batch[0] < 2 or not arrays:
        return False
    sized = [a for a in arrays if a.shape[-1] > 1]
    return bool(sized) and all(a.shape[:-1] == batch and a.T.flags.c_contiguous for a in arrays)


def load(
    source: Model | str | Path,
    *,
    build_dir: str | Path | None = None,
    backend: str | None = None,
    vectorised: bool = False,
    threads: bool = False,
    precision: str | None = None,
    flags: Sequence[str] = (),
) -> CompiledModel:
    """The compiled functions of a model, or of a directory that `generate` wrote.

    Args:
        source: a model, or the directory with manifest.json.
        build_dir: where the compiled library goes; by default a temporary directory that is gone afterwards.
        backend: "c" or "casadi"; by default "c" if there is a C compiler.
        vectorised: batches of eight states at once in C: three to four times as fast with AVX2, but twice the
            time to compile, so that it pays from some millions of evaluations on.
        threads: batches shared among threads (OpenMP; OMP_NUM_THREADS says how many), vectorised as well.
        precision: "single" to print and compile a model's C in float; a directory knows its own. Arrays of
            Python are float64 all the same.
        flags: further flags of the C compiler.

    Raises:
        CompileError: the compiler refused the code.
        OutputError: the directory holds nothing that `generate` wrote, or only hashes of its code.
        ValueError: a backend or precision that cannot be had.
    """
    if backend not in (None, "c", "casadi"):
        raise ValueError(f"expected the backend 'c' or 'casadi', got {backend!r}")
    name, ports, own = _interface(source)
    if not isinstance(source, Model) and read_hashes(Path(source)):
        raise OutputError(f"{source}: holds hashes in place of its code ({HASHES}); generate it without --hashes-only")
    real = PRECISIONS[precision or own]
    if not isinstance(source, Model) and precision not in (None, own):
        raise ValueError(f"{source}: expected its own precision, {own}, got {precision}; generate it again")
    if backend == "casadi" and real is not DOUBLE:
        raise ValueError("expected the backend 'c' for single precision, got 'casadi'")
    chosen = backend or ("c" if find_compiler() else "casadi")
    if chosen == "c":
        speed = [f"-D{name.upper()}_STATE_BY_STATE"] if not (vectorised or threads) else []
        speed += ["-fopenmp"] if threads else []
        lanes = vectorised or threads  # else Python's calls take longer than what limbs side by side save
        library = _c_library(source, name, build_dir=build_dir, flags=[*speed, *flags], precision=real, lanes=lanes)
        evaluators = _c_evaluators(library, name, ports, real, columns=False)
        columns = _c_evaluators(library, name, ports, real, columns=True)
    else:
        evaluators, columns = _casadi_evaluators(source, ports), {}
    functions = {
        function: CompiledFunction(function, inputs, outputs, evaluators[function], columns.get(function))
        for function, (inputs, outputs) in ports.items()
    }
    return CompiledModel(name, chosen, functions)


def find_compiler() -> str | None:
    """Path of the system's C compiler, or None."""
    return next((path for path in map(shutil.which, COMPILERS) if path), None)


def compile_c(
    source: Path, library: Path, *, compiler: str | None = None, flags: Sequence[str] = (), native: bool = True
) -> None:
    """Compile a C file into a shared library, for this processor (`native`) where the compiler knows it.

    Raises:
        CompileError: there is no compiler, or it refused the file.
    """
    command = compiler or find_compiler()
    if command is None:
        raise CompileError(f"no C compiler ({', '.join(COMPILERS)}); install one or use backend='casadi'")
    own: tuple[str, ...] = ("-march=native",) if native else ()
    # a compiler that does not know an option refuses the file: try with fewer of those that only make it faster
    for machine in dict.fromkeys(((*own, SPILLS), own, ())):
        arguments = [command, *FLAGS, *machine, *flags, str(source), "-o", str(library), "-lm"]
        result = subprocess.run(arguments, capture_output=True, text=True, check=False)
        if result.returncode == 0:
            return
    raise CompileError(f"{command} refused {source.name}:\n{result.stderr[-4000:]}")


def _interface(source: Model | str | Path) -> tuple[str, Ports, str]:
    """Name, ports of every function, and precision."""
    if isinstance(source, Model):
        return source.name, {name: (p.inputs, p.outputs) for name, p in source.programs.items()}, "double"
    content = read_manifest(Path(source))
    name = check_name(content["mechanism"], "manifest.json, mechanism")
    functions = {check_name(f, "manifest.json, function"): entry for f, entry in content["functions"].items()}
    interface = {
        f: (tuple(map(read_port, entry["inputs"])), tuple(map(read_port, entry["outputs"])))
        for f, entry in functions.items()
    }
    return name, interface, "single" if content.get("precision") == "single" else "double"


def _c_library(
    source: Model | str | Path,
    name: str,
    *,
    build_dir: str | Path | None,
    flags: Sequence[str],
    precision: Precision,
    lanes: bool,
) -> ctypes.CDLL:
    """The C of a model or a folder, compiled and loaded."""
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        folder = Path(build_dir) if build_dir is not None else Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        sources = Path(temporary) if isinstance(source, Model) else Path(source)
        if isinstance(source, Model):
            for file, text in print_c(source, precision=precision, lanes=lanes).items():
                (sources / file).write_text(text, encoding="utf-8")
        library = folder / f"lib{name}.so"
        compile_c(sources / f"{name}.c", library, flags=flags)
        return ctypes.CDLL(str(library))  # stays mapped when the temporary file is gone


def _c_evaluators(
    library: ctypes.CDLL, name: str, ports: Ports, real: Precision, *, columns: bool
) -> dict[str, Evaluator]:
    """The batch function of every function of a library."""
    sizes = {function: len(inputs) + len(outputs) for function, (inputs, outputs) in ports.items()}
    return {f: _c_evaluator(library, f"{name}_{f}", n, real, columns=columns) for f, n in sizes.items()}


def _c_evaluator(library: ctypes.CDLL, symbol: str, arrays: int, real: Precision, *, columns: bool) -> Evaluator:
    """A batch function on arrays (states, size), or with `columns` (size, states)."""
    batch = getattr(library, f"{symbol}_batch_soa" if columns else f"{symbol}_batch")
    counts = 2 if columns else 1
    batch.argtypes = [*([ctypes.c_size_t] * counts), *([ctypes.c_void_p] * (arrays + 1))]
    batch.restype = ctypes.c_int

    def evaluate(inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray], status: np.ndarray) -> None:
        pointers = [array.__array_interface__["data"][0] for array in (*inputs, *outputs, status)]
        batch(*([len(status)] * counts), *pointers)

    def evaluate_single(inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray], status: np.ndarray) -> None:
        results = [np.empty(array.shape, np.float32) for array in outputs]
        evaluate([np.ascontiguousarray(array, np.float32) for array in inputs], results, status)
        for array, result in zip(outputs, results, strict=True):
            array[...] = result

    return evaluate if real is DOUBLE else evaluate_single


def _casadi_evaluators(source: Model | str | Path, ports: Ports) -> dict[str, Evaluator]:
    import casadi

    from symscrew.export import casadi_functions

    if isinstance(source, Model):
        functions = casadi_functions(source)
    else:
        functions = {name: casadi.Function.load(str(Path(source) / f"{name}.casadi")) for name in ports}
    return {name: casadi_evaluator(function) for name, function in functions.items()}


def casadi_evaluator(function: Any) -> Evaluator:
    """A CasADi function (its last output the status) on rows of arrays; failed states become NaN."""

    def evaluate(inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray], status: np.ndarray) -> None:
        count = len(status)
        sizes = [function.size_in(i) for i in range(function.n_in())]
        columns = [np.reshape(a, (count * c, r)).T for a, (r, c) in zip(inputs, sizes, strict=True)]
        mapped = function if count == 1 else function.map(count)
        *results, codes = mapped.call(columns)
        status[:] = np.asarray(codes, dtype=float).ravel().astype(status.dtype)
        for target, result in zip(outputs, results, strict=True):
            target[:] = np.asarray(result, dtype=float).T.reshape(target.shape)
            target[status != 0] = np.nan

    return evaluate


def _unflatten(array: np.ndarray, batch: tuple[int, ...], shape: tuple[int, ...]) -> np.ndarray:
    """Rows of column-major entries as arrays (*batch, *shape)."""
    full, depth = array.reshape(*batch, *reversed(shape)), len(batch)
    if len(shape) < 2:
        return full
    return np.moveaxis(full, range(depth, full.ndim), range(full.ndim - 1, depth - 1, -1))
