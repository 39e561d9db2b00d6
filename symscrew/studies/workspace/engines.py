"""What evaluates the functions of a sweep: the fastest engine that is there. All give the same numbers to rounding.

    model --fastest--> Engine: its name, call(function, arrays) -> results, status

Where a small pivot hands over to a second path, which engines on devices do not have, these states are computed in C.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.errors import DescriptionError, did_you_mean
from symscrew.model import Model
from symscrew.program import RankRevealing
from symscrew.runtime import CompileError, find_compiler, load, load_cuda, load_jax
from symscrew.studies.workspace.configurations import Call, calls_of

Array = np.ndarray
SMALL_PIVOT = 1  # status of a first path
# Modules that come with JAX where it runs on something else than processors: JAX itself takes a second to say so.
ACCELERATED = ("jax_cuda12_plugin", "jax_cuda13_plugin", "jax_rocm60_plugin", "libtpu")


@dataclass(frozen=True)
class Engine:
    """`name`: one of `ENGINES`; `text`: in words; `device`: whether one process has it for itself; `call`."""

    name: str
    text: str
    device: bool
    call: Call


def fastest(model: Model, wanted: str = "") -> Engine:
    """The first of `ENGINES` that is there, or the one that is wanted.

    Raises:
        DescriptionError: an engine that is not known, or cannot be had here.
    """
    if wanted and wanted not in ENGINES:
        raise DescriptionError(f"--engine: no engine is called {wanted!r}; {did_you_mean(wanted, ENGINES)}")
    if wanted:
        try:
            return ENGINES[wanted](model)
        except CompileError as error:
            raise DescriptionError(f"--engine: {wanted} cannot be had here: {error}") from error
    for name, make in ENGINES.items():
        if name != "jax" or any(importlib.util.find_spec(module) for module in ACCELERATED):
            try:
                return make(model)
            except CompileError:
                continue
    raise AssertionError("the last of them is always there")


def _cuda(model: Model) -> Engine:
    kernels = load_cuda(model)

    def call(name: str, *arrays: Array) -> tuple[Sequence[Array], Array]:
        library = kernels.library
        given = (library.asarray(np.ascontiguousarray(np.asarray(x, dtype=float).T)) for x in arrays)
        found = [x.get() if hasattr(x, "get") else x for x in getattr(kernels, name)(*given)]
        return [np.ascontiguousarray(x.T) for x in found[:-1]], found[-1]

    return Engine("cuda", "CUDA, a thread a state", True, _with_second_paths(model, call))


def _jax(model: Model) -> Engine:
    functions, where = load_jax(model)
    return Engine("jax", f"JAX on {where}", True, _with_second_paths(model, functions))


def _c(model: Model) -> Engine:
    if find_compiler() is None:
        raise CompileError("there is no C compiler")
    return Engine("c", "C, eight states at a time", False, calls_of(load(model)))


def _casadi(model: Model) -> Engine:
    return Engine("casadi", "CasADi, state by state", False, calls_of(load(model, backend="casadi")))


ENGINES: Mapping[str, Callable[[Model], Engine]] = {"cuda": _cuda, "jax": _jax, "c": _c, "casadi": _casadi}


def _with_second_paths(model: Model, call: Call) -> Call:
    """The call with states of small pivots computed in C, for functions that have a path for them."""
    other: list[Call] = []

    def both(name: str, *arrays: Array) -> tuple[Sequence[Array], Array]:
        results, status = call(name, *arrays)
        small = np.flatnonzero(status == SMALL_PIVOT)
        if not len(small) or not isinstance(model.programs[name], RankRevealing):
            return results, status
        if not other:
            other.append(calls_of(load(model)))
        again, codes = other[0](name, *(np.broadcast_to(x, (len(status), x.shape[-1]))[small] for x in arrays))
        found = [np.array(x) for x in results]
        for one, more in zip(found, again, strict=True):
            one[small] = more
        codes_of_all = np.array(status)
        codes_of_all[small] = codes
        return found, codes_of_all

    return both
