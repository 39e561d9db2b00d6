"""Functions of generated C as functions of arrays: compiled when they are first called, or all at once.

C of a function, <symbol>_arrays --compile_c--> library --its own table of sizes--> is it what is called here?
                                                        --ctypes--> evaluators on rows, columns, any strides
"""

from __future__ import annotations

import ctypes
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from threading import RLock
from typing import Any

import numpy as np

from symscrew.export import DOUBLE, OutputError, Precision, interface
from symscrew.program import Port
from symscrew.runtime import numpy_call
from symscrew.runtime.compiled_function import Called, Evaluator
from symscrew.runtime.compilers import CompileError, compile_c
from symscrew.runtime.state_arrays import BYTES, place
from symscrew.runtime.strided_c import MISFIT, NUMPY_AS_EXPECTED, strided_source

Ports = Mapping[str, tuple[tuple[Port, ...], tuple[Port, ...]]]  # function -> inputs, outputs


# Of the arguments as they are: with new results, where that can be, and into arrays.
Direct = tuple[Callable[..., "Called | None"] | None, Callable[..., "Called | None"]]
# By rows, by columns, by strides, and of the arguments as they are.
Made = tuple[Evaluator, Evaluator, Evaluator, Direct | None]


class Evaluators:
    """Evaluators of one function; `make` is called when one of them is called first, by one thread."""

    def __init__(self, make: Callable[[bool], Made]) -> None:
        """Those that `make` returns, without threads or with them."""
        self._make, self._lock = make, RLock()
        self._made: Made | None = None
        self._threaded: Made | None = None

    def ready(self) -> Made:
        """Compile now, if that has not been done.

        Raises:
            CompileError: the compiler refused the code.
        """
        with self._lock:
            if self._made is None:
                self._made = self._make(False)
            return self._made

    def rows(self, inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray], status: np.ndarray) -> int | None:
        """States one after the other: C-contiguous arrays (states, entries)."""
        return (self._made or self.ready())[0](inputs, outputs, status)

    def columns(self, inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray], status: np.ndarray) -> int | None:
        """States side by side: arrays (entries, states) with the same distance between all entries."""
        return (self._made or self.ready())[1](inputs, outputs, status)

    def strided(self, inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray], status: np.ndarray) -> int | None:
        """Arrays (states, entries) of any strides."""
        return (self._made or self.ready())[2](inputs, outputs, status)

    def new(self, given: Sequence[object], threads: int, told: bool) -> Called | None:
        """The arguments as they are, results in new arrays."""
        direct = (self._made or self.ready())[3]
        if threads > 1 and direct is not None:
            direct = self._with_threads()[3]
        return direct[0](threads, told, *given) if direct is not None and direct[0] is not None else None

    def into(self, given: Sequence[np.ndarray], threads: int, results: Sequence[np.ndarray]) -> Called | None:
        """Arrays (states, entries) of any strides, and those for the results."""
        direct = (self._made or self.ready())[3]
        if threads > 1 and direct is not None:
            direct = self._with_threads()[3]
        return direct[1](given, threads, results) if direct is not None else None

    def _with_threads(self) -> Made:
        """Those of a library with threads of its own; without, where the compiler does not know how."""
        with self._lock:
            if self._threaded is None:
                try:
                    self._threaded = self._make(True)
                except CompileError:
                    self._threaded = (*self.ready()[:3], None)
            return self._threaded


def library_of(
    name: str,
    sources: Sequence[Path],
    ports: Ports,
    *,
    precision: Precision,
    flags: Sequence[str],
    build_dir: Path | None = None,
) -> ctypes.CDLL:
    """C files of a model, with what reads any strides, compiled and loaded; `ports`: its functions and their arrays.

    Raises:
        CompileError: the compiler refused them, or wrote something else than their library.
        OutputError: the arrays of the functions are not those of `ports`.
    """
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        folder = build_dir if build_dir is not None else Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        beside = []
        for number, (function, (inputs, outputs)) in enumerate(ports.items()):
            beside.append(Path(temporary) / f"strided_{number}.c")
            symbol = f"{name}_{function}"
            text = strided_source(symbol, inputs, outputs, precision) + numpy_call.call_source(symbol, inputs, outputs)
            beside[-1].write_text(text, encoding="utf-8")
        library = folder / f"lib{name}.so"
        further = [str(path) for path in (*sources[1:], *beside)]
        compile_c(sources[0], library, flags=[f"-D{name.upper()}_INTERFACE", *flags, *further])
        try:
            loaded = ctypes.CDLL(str(library))  # stays mapped when the temporary file is gone
        except OSError as error:
            if "undefined symbol" in str(error) or "symbol not found" in str(error).lower():
                missing = str(error).rpartition(": ")[2]
                text = f"{name}: manifest.json does not fit the C, which has no {missing}; generate it again"
                raise OutputError(text) from error
            what = f"{sources[0].name}: the compiler wrote a library that cannot be loaded: {error}"
            raise CompileError(what) from error
    _compare(loaded, name, interface(precision.real, ports))
    return loaded


def _compare(library: ctypes.CDLL, name: str, expected: Sequence[str]) -> None:
    """The library's own table against what is going to be called."""
    try:
        start = ctypes.addressof(ctypes.c_char_p.in_dll(library, f"{name}_interface"))
    except ValueError as error:
        raise OutputError(
            f"{name}: its C says nothing of the sizes of its arrays; it is of another version, generate it again"
        ) from error
    found: list[str] = []
    while len(found) <= len(expected):
        text = ctypes.c_char_p.from_address(start + len(found) * ctypes.sizeof(ctypes.c_char_p)).value
        if text is None:
            break
        found.append(text.decode("ascii", "replace"))
    if found != list(expected):
        first = next((k for k, (a, b) in enumerate(zip(found, expected, strict=False)) if a != b), None)
        pair = (found[first], expected[first]) if first is not None else (f"{len(found)} lines", f"{len(expected)}")
        raise OutputError(
            f"{name}: manifest.json does not fit the C, which has {pair[0]!r} where the manifest says {pair[1]!r}; "
            "generate it again"
        )


def evaluators(
    library: ctypes.CDLL, symbol: str, ports: tuple[Sequence[Port], Sequence[Port]], precision: Precision
) -> Made:
    """The batch functions of a symbol with these inputs and outputs, by rows, columns and strides."""
    inputs, outputs = ports
    pointers = [ctypes.c_void_p] * (len(inputs) + len(outputs) + 1)
    batch, batch_soa, by_strides = (_symbol(library, f"{symbol}{end}") for end in ("_batch", "_batch_soa", "_arrays"))
    batch.argtypes = [ctypes.c_size_t, *pointers]
    batch_soa.argtypes = [ctypes.c_size_t, ctypes.c_size_t, *pointers]
    by_strides.argtypes = [ctypes.c_size_t, ctypes.c_void_p, *pointers]
    batch.restype = batch_soa.restype = by_strides.restype = ctypes.c_int
    stride_array = ctypes.c_ssize_t * max(2 * (len(inputs) + len(outputs)), 1)

    def rows(given: Sequence[np.ndarray], found: Sequence[np.ndarray], status: np.ndarray) -> int:
        return int(batch(len(status), *map(place, given), *map(place, found), place(status)))

    def columns(given: Sequence[np.ndarray], found: Sequence[np.ndarray], status: np.ndarray) -> int:
        stride = next((a.strides[0] // BYTES for a in (*given, *found) if len(a) > 1), len(status))
        return int(batch_soa(len(status), stride, *map(place, given), *map(place, found), place(status)))

    def strided(given: Sequence[np.ndarray], found: Sequence[np.ndarray], status: np.ndarray) -> int:
        strides = stride_array(*[step // BYTES for a in (*given, *found) for step in a.strides])
        worst = int(by_strides(len(status), ctypes.addressof(strides), *map(place, (*given, *found, status))))
        if worst == MISFIT:
            raise MemoryError(f"{symbol}: no memory for a block of states")
        return worst

    def turned(given: Sequence[np.ndarray], found: Sequence[np.ndarray], status: np.ndarray) -> int:
        return strided([a.T for a in given], [a.T for a in found], status)

    direct = _direct(library, symbol, inputs) if NUMPY_AS_EXPECTED else None
    return (rows, columns, strided, direct) if precision is DOUBLE else (strided, turned, strided, direct)


def _direct(library: ctypes.CDLL, symbol: str, inputs: Sequence[Port]) -> Direct:
    """What calls <symbol>_call for new results, and <symbol>_numpy for arrays (states, entries) that are given."""
    call = _symbol(library, f"{symbol}_numpy")
    call.argtypes = [ctypes.c_size_t, ctypes.c_size_t, *([ctypes.py_object] * 4)]
    call.restype = ctypes.c_int
    like = np.zeros(1)
    matrices = any(len(port.shape) != 1 for port in inputs)  # whose entries stand in another order

    def into(given: Sequence[np.ndarray], threads: int, results: Sequence[np.ndarray]) -> Called | None:
        count = len(results[0]) if results else len(given[0]) if given else 1
        status = np.empty(count, np.intc)
        shares = min(threads, count // numpy_call.THREAD_STATES) if threads > 1 else 1
        worst = call(count, shares, like, tuple(given), tuple(results), status)
        return None if worst == MISFIT else (worst, results, status, (count,))

    return (None if matrices else numpy_call.callable_of(library, symbol)), into


def _symbol(library: ctypes.CDLL, symbol: str) -> Any:
    try:
        return library[symbol]
    except AttributeError as error:
        raise CompileError(f"the compiler wrote a library without {symbol}") from error
