"""One compiled function, called with arrays of one state or of many.

arguments --state_arrays--> layout --evaluator of this layout, in threads on request--> results, status
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cached_property
from operator import index

import numpy as np

from symscrew.errors import DescriptionError, KindError
from symscrew.program import STATUS, Port
from symscrew.runtime.state_arrays import (
    BYTES,
    COLUMNS,
    DOUBLE,
    ROWS,
    STRIDED,
    flatten,
    layout_of,
    mostly_columns,
    overlaps_itself,
    unflatten,
    views,
)

# Reads the first arrays, writes the others; the largest status, where it knows that without looking.
Evaluator = Callable[[Sequence[np.ndarray], Sequence[np.ndarray], np.ndarray], "int | None"]
# The largest status, results (states, entries), the status of every state if that was to be told, shape of the batch.
Called = tuple[int, Sequence[np.ndarray], "np.ndarray | None", tuple[int, ...]]
# All at once, in threads; None, where arguments are something else. First of arguments that are arrays of float64
# (states, entries) or (entries), with or without the status of every state; then of such arrays, into others.
New = Callable[[Sequence[object], int, bool], "Called | None"]
Into = Callable[[Sequence[np.ndarray], int, Sequence[np.ndarray]], "Called | None"]
# States of a thread of Python, at least: starting it takes as long as some thousands of states of a short function.
PYTHON_THREAD_STATES = 16384
SHARE_UNIT = 64  # states: shares begin where blocks begin, so that every state has the neighbours it has in one thread


class EvaluationError(ArithmeticError):
    """A function reported a status other than success; `status` holds it per state."""

    def __init__(self, message: str, status: np.ndarray) -> None:
        """The error of a call whose states ended in `status`."""
        super().__init__(message)
        self.status = status


@dataclass(frozen=True)
class CompiledFunction:
    """One function of the model: call it with arrays (*batch, *shape), by position or by name.

    It returns an array per output (the array itself if there is one output only). A status above 0
    raises `EvaluationError`; with `check=False` the status (*batch) is returned as a last value instead, and
    outputs of failed states are NaN. Arrays of any memory order are read in place. Fastest are transposes of arrays
    (entries, states), as `np.asfortranarray(x)` makes: states then lie side by side, and so do the results.
    """

    name: str
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    evaluator: Evaluator
    columns: Evaluator | None = None
    strided: Evaluator | None = None
    new: New | None = None
    into: Into | None = None
    threads: int = 1
    texts: Mapping[int, str] = field(default_factory=lambda: STATUS, repr=False)

    def __repr__(self) -> str:
        given, found = (", ".join(f"{p.name}[{p.size}]" for p in ports) for ports in (self.inputs, self.outputs))
        return f"CompiledFunction({self.name}({given}) -> {found})"

    def __call__(
        self, *arguments: object, check: bool = True, out: object = None, threads: int | None = None, **named: object
    ) -> object:
        """Evaluate; see the class.

        Args:
            arguments: arrays of real numbers (*batch, *shape); batches are broadcast against each other.
            check: raise an error where a state failed, else return the status as a last value.
            out: an array of float64 (or a tuple of them, one per output) of the shape of the results, which are written
                there; it must not overlap an input. Results are then these arrays.
            threads: how many share the states; default: what `load` was told, else one. Results are the same bits.
            named: arguments by name.

        Raises:
            EvaluationError: a status above 0, unless `check` is False.
            KindError: not the function's inputs, each of them once, or not real numbers; threads that are no number.
            DescriptionError: an array that does not end in the shape of its input, batches or an `out`
                that do not fit.
        """
        given = arguments if not named and len(arguments) == len(self.inputs) else self._ordered(arguments, named)
        shares = self.threads if threads is None else min(index(threads), sys.maxsize)
        found = self.new(given, shares, not check) if self.new is not None and out is None else None
        if found is not None and (found[0] <= 0 or not check):
            _, results, codes, batch = found
            shaped = results if self._flat else self._shaped(results, batch)
            if codes is not None:
                return (*shaped, codes)
            return shaped[0] if len(shaped) == 1 else tuple(shaped)
        worst, shaped, status, batch = self._anyhow(given, out, shares)
        if not check:
            return (*shaped, status.reshape(batch))
        if worst > 0:
            status = status.reshape(batch)
            raise EvaluationError(self._failure(status), status)
        return shaped[0] if len(shaped) == 1 else tuple(shaped)

    @cached_property
    def _flat(self) -> bool:
        """Whether no output is a matrix."""
        return all(len(port.shape) == 1 for port in self.outputs)

    def _shaped(self, results: Sequence[np.ndarray], batch: tuple[int, ...]) -> Sequence[np.ndarray]:
        return [unflatten(r, batch, p.shape) for r, p in zip(results, self.outputs, strict=True)]

    def _anyhow(
        self, given: Sequence[object], out: object, shares: int
    ) -> tuple[int, Sequence[np.ndarray], np.ndarray, tuple[int, ...]]:
        """The largest status, results in the shape of the batch, statuses, that shape; for arguments of all kinds."""
        arrays, batch = views(self.inputs, given, self.name)
        layout = layout_of(arrays, batch)
        if layout == STRIDED or (layout == COLUMNS and self.columns is None):
            layout = STRIDED
            if self.strided is None:
                layout, arrays = ROWS, [np.ascontiguousarray(a) for a in arrays]
        if out is None:
            results = self._room(layout, arrays, batch)
            shaped: Sequence[np.ndarray] = self._shaped(results, batch)
        else:
            results, shaped = self._targets(out, batch, arrays)
            layout = layout if self.strided is None or layout_of(results, batch) == layout else STRIDED
        found = self.into(arrays, shares, results) if self.into is not None else None
        if found is not None and found[2] is not None:
            worst, status = found[0], found[2]
        else:
            status = np.zeros(math.prod(batch), dtype=np.intc)
            worst = self._evaluate(layout, (arrays, results, status), shares)
        for array, result, port in zip(shaped if out is not None else (), results, self.outputs, strict=False):
            if not np.may_share_memory(array, result):  # what no strides describe
                array[...] = unflatten(result, batch, port.shape)
        return worst, shaped, status, batch

    def _room(self, layout: str, arrays: Sequence[np.ndarray], batch: tuple[int, ...]) -> list[np.ndarray]:
        """New arrays (states, entries) for the results."""
        count = math.prod(batch)
        if layout == COLUMNS or (layout == STRIDED and len(batch) == 1 and mostly_columns(arrays)):
            return [np.empty((port.size, count)).T for port in self.outputs]
        return [np.empty((count, port.size)) for port in self.outputs]

    def _targets(
        self, out: object, batch: tuple[int, ...], arrays: Sequence[np.ndarray]
    ) -> tuple[list[np.ndarray], tuple[np.ndarray, ...]]:
        """The caller's arrays as (states, entries), and themselves."""
        given = out if isinstance(out, tuple) else (out,)
        if len(given) != len(self.outputs):
            raise DescriptionError(f"{self.name}: expected out to hold {len(self.outputs)} arrays, got {len(given)}")
        results: list[np.ndarray] = []
        for port, array in zip(self.outputs, given, strict=True):
            wanted, where = (*batch, *port.shape), f"{self.name}: expected out for {port.name} to be"
            if not isinstance(array, np.ndarray) or array.dtype != DOUBLE or array.shape != wanted:
                got = f"{array.dtype} {array.shape}" if isinstance(array, np.ndarray) else type(array).__name__
                raise DescriptionError(f"{where} an array of float64 of shape {wanted}, got {got}")
            if not array.flags.writeable:
                raise DescriptionError(f"{where} writeable")
            if overlaps_itself(array):
                raise DescriptionError(f"{where} an array whose entries lie apart, but several lie in one place")
            if any(np.may_share_memory(array, other) for other in (*arrays, *results)):
                raise DescriptionError(f"{where} apart from all inputs and other outputs, but it overlaps one")
            flat = flatten(array, batch, port.shape)
            whole = flat is not None and array.flags.aligned and not any(step % BYTES for step in flat.strides)
            if flat is None or not whole or (self.strided is None and not flat.flags.c_contiguous):
                flat = np.empty((math.prod(batch), port.size))
            results.append(flat)
        return results, given

    def _evaluate(
        self, layout: str, call: tuple[Sequence[np.ndarray], Sequence[np.ndarray], np.ndarray], threads: int
    ) -> int:
        """The largest status, after results and statuses have been written."""
        inputs, results, status = call
        evaluator = {ROWS: self.evaluator, COLUMNS: self.columns, STRIDED: self.strided}[layout]
        assert evaluator is not None
        if layout == COLUMNS:
            inputs, results = [a.T for a in inputs], [r.T for r in results]
        count = len(status)
        shares = min(threads, count // PYTHON_THREAD_STATES)
        if shares < 2:
            worst = evaluator(inputs, results, status)
            return int(status.max(initial=0)) if worst is None else worst
        step = -(-count // (shares * SHARE_UNIT)) * SHARE_UNIT

        def share(first: int) -> int:
            part = slice(first, min(first + step, count))
            cut = (slice(None), part) if layout == COLUMNS else (part,)
            worst = evaluator([a[cut] for a in inputs], [r[cut] for r in results], status[part])
            return int(status[part].max(initial=0)) if worst is None else worst

        with ThreadPoolExecutor(shares - 1) as pool:
            others = [pool.submit(share, first) for first in range(step, count, step)]
            return max(share(0), *(other.result() for other in others))

    def _ordered(self, arguments: Sequence[object], named: Mapping[str, object]) -> list[object]:
        names = [port.name for port in self.inputs]
        given = dict(zip(names, arguments, strict=False))
        twice = [name for name in named if name in given]
        if len(arguments) > len(names) or twice or sorted({**given, **named}) != sorted(names):
            got = ", ".join([*(str(n) for n in given), *named]) or "nothing"
            raise KindError(f"{self.name} expects ({', '.join(names)}), got {len(arguments)} arrays and {got}")
        return [{**given, **named}[name] for name in names]

    def _failure(self, status: np.ndarray) -> str:
        if not status.shape:
            return f"{self.name}: {self._text(int(status))}"
        failed = np.argwhere(status > 0)
        first = tuple(int(i) for i in failed[0])
        return (
            f"{self.name}: {len(failed)} of {status.size} states failed; the first is state {first}: "
            f"{self._text(int(status[first]))}"
        )

    def _text(self, status: int) -> str:
        return self.texts.get(status, f"status {status}, which this folder's manifest.json does not explain")
