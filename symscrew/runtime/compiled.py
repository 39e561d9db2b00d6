"""Compiled functions of a model, called from Python on NumPy arrays.

    model, or folder --origin--> C of a function --c_library, at its first call--> function of arrays (*batch, *shape)

    model = load(directory_or_model)
    u = model.inverse_dynamics(q, v, a)              # arrays (*batch, *shape)
    u, status = model.inverse_dynamics(q, v, a, check=False)

The generated C is compiled by the system's compiler, function by function when they are first called, kept in the
user's cache and called through ctypes. A whole batch is one call on the arrays themselves, eight states at once;
nothing is copied, whatever their memory order (see `state_arrays`). Without a C compiler the same functions run in
CasADi (`backend` says which).
"""

from __future__ import annotations

import ctypes
import os
import tempfile
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from os import PathLike
from pathlib import Path
from pickle import PicklingError
from typing import Any

import numpy as np

from symscrew import notebook
from symscrew.errors import expect
from symscrew.export import DOUBLE, library_sources
from symscrew.model import Model
from symscrew.runtime.c_library import Evaluators, Made, evaluators, library_of
from symscrew.runtime.compiled_function import CompiledFunction, EvaluationError, Evaluator
from symscrew.runtime.compilers import COMPILERS, FLAGS, CompileError, compile_c, find_compiler
from symscrew.runtime.origin import Origin, origin_of
from symscrew.runtime.strided_c import THREADS

__all__ = [
    "COMPILERS",
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


class CompiledModel:
    """The functions of a model as attributes and items; `backend` is "c" or "casadi"."""

    def __init__(self, name: str, backend: str, functions: Mapping[str, CompiledFunction]) -> None:
        """Functions by name, as `load` makes them."""
        self.name, self.backend, self.functions = name, backend, dict(functions)

    def __reduce__(self) -> tuple[Any, ...]:
        """Refuse to be copied: its functions are the machine code of this process."""
        raise PicklingError(
            f"{self.name}: compiled functions belong to one process; give the other one the model, or the name of its "
            "folder, and `symscrew.load` it there (it is compiled once, and kept)"
        )

    def __getattr__(self, name: str) -> CompiledFunction:
        """The function of this name."""
        functions: dict[str, CompiledFunction] = self.__dict__.get("functions", {})
        if name not in functions:
            raise AttributeError(f"the model has no function {name}; it has {', '.join(functions)}")
        return functions[name]

    def __repr__(self) -> str:
        return f"CompiledModel({self.name}: {len(self.functions)} functions in {self.backend})"

    def _repr_html_(self) -> str:
        rows = [
            (name, *(", ".join(f"{p.name}[{p.size}]" for p in ports) for ports in (f.inputs, f.outputs)))
            for name, f in self.functions.items()
        ]
        return notebook.table(repr(self), ("function", "of", "gives"), rows)

    def __getitem__(self, name: str) -> CompiledFunction:
        """The function of this name."""
        return self.functions[name]

    def __dir__(self) -> list[str]:
        """Attributes and functions."""
        return [*super().__dir__(), *self.functions]


def load(
    source: Model | str | Path,
    *,
    build_dir: str | Path | None = None,
    backend: str | None = None,
    vectorised: bool | None = None,
    threads: bool | int = False,
    precision: str | None = None,
    flags: Sequence[str] = (),
    trusted: bool = False,
) -> CompiledModel:
    """The compiled functions of a model, or of a directory that `generate` wrote.

    Functions are compiled when they are first called, and kept in the user's cache (`symscrew cache`). Of a directory,
    the mechanism is derived again and the C that it gives is compiled, after the C in the directory has been found to
    be the same: nothing in it is run that this version would not write.

    Args:
        source: a model, or the directory with manifest.json.
        build_dir: a directory for the compiled library, lib<name>.so, with all functions, compiled now.
        backend: "c" or "casadi"; by default "c" if there is a C compiler that works.
        vectorised: batches of eight states at once in C: three to ten times as fast, the default. False: one by one,
            which compiles in half the time; True: single calls have equal limbs side by side, too.
        threads: how many threads share the states of a call, unless the call says it; True: as many as processors.
        precision: "single" to print and compile a model's C in float; a directory knows its own. Arrays of
            Python are float64 all the same.
        flags: further flags of the C compiler.
        trusted: compile the C of the directory as it stands, and whole, now. It can do whatever you can: only for
            directories that you or somebody whom you trust wrote. Sizes of arrays are compared all the same.

    Raises:
        CompileError: the compiler refused the code (for good, where "c", flags or a directory were asked for; else
            functions run in CasADi, and a warning says so).
        OutputError: the directory holds nothing that `generate` wrote, only hashes of its code, other code than its
            description gives, or a manifest that does not fit the C.
        DescriptionError: the directory's mechanism.toml describes no mechanism.
        ValueError: a backend or precision that cannot be had.
    """
    expect(source, Model, str, PathLike)
    if backend not in (None, "c", "casadi"):
        raise ValueError(f"expected the backend 'c' or 'casadi', got {backend!r}")
    origin = origin_of(source, precision, trusted=trusted, lanes=vectorised is True)
    if backend == "casadi" and origin.precision is not DOUBLE:
        raise ValueError("expected the backend 'c' for single precision, got 'casadi'")
    chosen = backend or ("c" if find_compiler() else "casadi")
    share = (os.cpu_count() or 1) if threads is True else int(threads) or 1
    if chosen == "c":
        speed = [f"-D{origin.name.upper()}_STATE_BY_STATE"] if vectorised is False else []
        whole = bool(origin.sources) or build_dir is not None
        try:
            place = Path(build_dir) if build_dir is not None else None
            optional = backend is None and not flags and origin.precision is DOUBLE
            options = [*speed, *flags]
            made = _whole(origin, options, place) if whole else _one_by_one(origin, options, optional=optional)
            return CompiledModel(origin.name, "c", {f: replace(c, threads=share) for f, c in made.items()})
        except CompileError as error:
            if backend == "c" or whole or flags or origin.precision is not DOUBLE:
                raise
            _tell(f"{origin.name}: its functions run", error, stacklevel=3)
    return CompiledModel(origin.name, "casadi", _in_casadi(origin))


def _tell(what: str, error: CompileError, *, stacklevel: int) -> None:
    said = " ".join(str(error).split())
    warnings.warn(f"{what} in CasADi, some ten times slower than compiled: {said}", RuntimeWarning, stacklevel)


def _one_by_one(origin: Origin, flags: Sequence[str], *, optional: bool) -> dict[str, CompiledFunction]:
    """Functions that are compiled when they are first called; the shortest one now, to see that the compiler works.

    `optional`: one that the compiler refuses later runs in CasADi.
    """
    compilers_work: list[bool] = []

    def making(function: str) -> Callable[[bool], Made]:
        compiled = _making(origin, function, tuple(flags))

        def make(threads: bool) -> Made:
            try:
                return compiled(threads)
            except CompileError as error:
                if threads or not (optional and compilers_work):
                    raise
                _tell(f"{origin.name}: {function} runs", error, stacklevel=2)
                return _made_in_casadi(origin, function)

        return make

    lazy = {f: Evaluators(making(f)) for f in origin.ports}
    if lazy:
        lazy[min(origin.ports, key=lambda f: sum(p.size for ports in origin.ports[f] for p in ports))].ready()
    compilers_work.append(True)
    return _functions(origin, lazy)


def _made_in_casadi(origin: Origin, function: str) -> Made:
    """What stands in for a compiled function: arrays of any layout by CasADi."""
    from symscrew.export import casadi_functions

    rows = casadi_evaluator(casadi_functions(origin.model().only([function]))[function])

    def columns(inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray], status: np.ndarray) -> int | None:
        return rows([a.T for a in inputs], [a.T for a in outputs], status)

    return rows, columns, rows, None


def _making(origin: Origin, function: str, flags: Sequence[str]) -> Callable[[bool], Made]:
    """What compiles one function by itself."""

    def make(threads: bool) -> Made:
        with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
            sources = _written(origin, origin.files(function), Path(temporary))
            ports = {function: origin.ports[function]}
            options = [*flags, *(THREADS if threads else ())]
            library = library_of(origin.name, sources, ports, precision=origin.precision, flags=options)
        return evaluators(library, f"{origin.name}_{function}", origin.ports[function], origin.precision)

    return make


def _whole(origin: Origin, flags: Sequence[str], build_dir: Path | None) -> dict[str, CompiledFunction]:
    """All functions in one library, compiled now."""

    @cache
    def library(threads: bool) -> ctypes.CDLL:
        with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
            sources = origin.sources or _written(origin, origin.files(""), Path(temporary))
            options = [*flags, *(THREADS if threads else ())]
            place = None if threads else build_dir
            return library_of(
                origin.name, sources, origin.ports, precision=origin.precision, flags=options, build_dir=place
            )

    def making(function: str) -> Callable[[bool], Made]:
        symbol = f"{origin.name}_{function}"
        return lambda threads: evaluators(library(threads), symbol, origin.ports[function], origin.precision)

    made = {function: Evaluators(making(function)) for function in origin.ports}
    for function in made.values():
        function.ready()
    return _functions(origin, made)


def _written(origin: Origin, files: Mapping[str, str], folder: Path) -> Sequence[Path]:
    """C files in a folder; those to compile, the one with the model's name first."""
    for file, text in files.items():
        (folder / file).write_text(text, encoding="utf-8")
    return [folder / file for file in library_sources(files, origin.name)]


def _functions(origin: Origin, made: Mapping[str, Evaluators]) -> dict[str, CompiledFunction]:
    own = origin.precision is DOUBLE  # numbers of another type are converted on the way
    return {
        f: CompiledFunction(
            f, *origin.ports[f], of.rows, of.columns if own else None, of.strided, of.new, of.into, texts=origin.texts
        )
        for f, of in made.items()
    }


def _in_casadi(origin: Origin) -> dict[str, CompiledFunction]:
    """The functions in CasADi, always made anew of the model: its files can carry more than functions."""
    from symscrew.export import casadi_functions

    made = casadi_functions(origin.model())
    return {
        f: CompiledFunction(f, *ports, casadi_evaluator(made[f]), texts=origin.texts)
        for f, ports in origin.ports.items()
    }


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
