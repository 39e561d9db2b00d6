"""Arrays of many states as a compiled function takes them: views of what the caller has, by where the numbers lie.

argument of any layout --views--> (states, entries), broadcast without copies --layout_of--> ROWS, COLUMNS, STRIDED

ROWS      one state after the other: C-contiguous arrays (states, entries)
COLUMNS   states side by side: transposes of C-contiguous arrays (entries, states), as `np.asfortranarray` makes
STRIDED   everything else, and mixtures; read where it is, a block of states at a time
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Sequence

import numpy as np

from symscrew.errors import DescriptionError, KindError, shorten
from symscrew.program import Port

ROWS, COLUMNS, STRIDED = "rows", "columns", "strided"
DOUBLE = np.dtype(float)
BYTES = DOUBLE.itemsize
REAL_KINDS = "fiub"  # of NumPy's types: floating, whole numbers with and without sign, bool
_Place = ctypes.c_char * 1


def place(array: np.ndarray) -> object:
    """Where an array begins, as ctypes passes it on; four times as fast as asking the array where it can be written."""
    try:
        return _Place.from_buffer(array)  # type: ignore[arg-type]
    except (TypeError, ValueError, BufferError):  # read-only, without entries, not in one piece
        return array.__array_interface__["data"][0]


def numbers(argument: object, where: str) -> np.ndarray:
    """The argument as an array of float64; the array itself where it is one.

    Raises:
        KindError: complex numbers, objects, texts, times, masked entries: nothing that is a real number as it stands.
    """
    try:
        array = argument if isinstance(argument, np.ndarray) else np.asarray(argument)
    except (TypeError, ValueError) as error:
        raise KindError(f"{where} expects an array of real numbers, got {shorten(argument)} ({error})") from error
    if array.dtype.kind not in REAL_KINDS:
        raise KindError(
            f"{where} expects an array of real numbers, got one of type {array.dtype}; convert it first, "
            "as by np.asarray(x, dtype=float), or x.real of complex numbers"
        )
    if isinstance(array, np.ma.MaskedArray) and np.ma.is_masked(array):
        raise KindError(
            f"{where} expects an array of real numbers, got a masked one; give masked entries numbers first"
        )
    found = np.asarray(array, dtype=DOUBLE)
    if found.flags.aligned and not any(step % BYTES for step in found.strides):
        return found
    return np.array(found)  # fields of records may stand anywhere


def views(ports: Sequence[Port], arguments: Sequence[object], name: str) -> tuple[list[np.ndarray], tuple[int, ...]]:
    """Arrays (states, entries) of all arguments, and the shape of the batch; copied is only what no strides describe.

    Raises:
        KindError: not real numbers.
        DescriptionError: an array that does not end in the shape of its port, or batches that do not fit.
    """
    arrays = []
    for port, argument in zip(ports, arguments, strict=True):
        array = numbers(argument, f"{name}, {port.name}:")
        shape = port.shape if port.shape != (1,) or array.shape[-1:] == (1,) else ()
        depth = array.ndim - len(shape)
        if depth < 0 or array.shape[depth:] != shape:
            expected = f"{port.name} of shape {port.shape} after batch dimensions"
            raise DescriptionError(f"{name} expects {expected}, got {array.shape}")
        if len(shape) > 1:  # column-major
            array = np.moveaxis(array, range(depth, array.ndim), range(array.ndim - 1, depth - 1, -1))
        arrays.append(array if len(shape) == 1 else array.reshape(*array.shape[:depth], port.size))
    batches = {a.shape[:-1] for a in arrays}
    try:
        batch = batches.pop() if len(batches) == 1 else np.broadcast_shapes(*batches)
    except ValueError as error:
        shapes = ", ".join(f"{p.name} {a.shape[:-1]}" for p, a in zip(ports, arrays, strict=True))
        raise DescriptionError(f"{name}: expected batches that fit together, got {shapes}") from error
    count = math.prod(batch)
    whole = (a if a.shape[:-1] == batch else np.broadcast_to(a, (*batch, a.shape[-1])) for a in arrays)
    return [a.reshape(count, a.shape[-1]) for a in whole], batch


def overlaps_itself(array: np.ndarray) -> bool:
    """Whether entries may lie in one place, as those of broadcast arrays: a step is within what smaller ones reach."""
    reach = array.itemsize
    for step, size in sorted((abs(step), size) for step, size in zip(array.strides, array.shape, strict=True)):
        if size > 1 and step < reach:
            return array.size > 0
        reach += step * (size - 1)
    return False


def layout_of(arrays: Sequence[np.ndarray], batch: tuple[int, ...]) -> str:
    """How arrays (states, entries) lie; columns only in a batch of one dimension, whose results are columns then."""
    if all(a.flags.c_contiguous for a in arrays):
        return ROWS
    if len(batch) == 1 and all(a.T.flags.c_contiguous for a in arrays):
        return COLUMNS
    return STRIDED


def mostly_columns(arrays: Sequence[np.ndarray]) -> bool:
    """Whether of arrays (states, entries) more numbers lie as columns than as rows: results will lie as they do."""
    sized = [a for a in arrays if a.strides[0] and a.shape[1] > 1]
    return bool(sum(a.shape[1] if a.strides[0] == BYTES else -a.shape[1] for a in sized) > 0)


def unflatten(array: np.ndarray, batch: tuple[int, ...], shape: tuple[int, ...]) -> np.ndarray:
    """Rows of column-major entries as arrays (*batch, *shape)."""
    full, depth = array.reshape(*batch, *reversed(shape)), len(batch)
    if len(shape) < 2:
        return full
    return np.moveaxis(full, range(depth, full.ndim), range(full.ndim - 1, depth - 1, -1))


def flatten(array: np.ndarray, batch: tuple[int, ...], shape: tuple[int, ...]) -> np.ndarray | None:
    """The opposite as a view of the same numbers; None where no strides describe it."""
    depth = len(batch)
    if len(shape) > 1:
        array = np.moveaxis(array, range(depth, array.ndim), range(array.ndim - 1, depth - 1, -1))
    made = array.reshape(math.prod(batch), math.prod(shape))
    return made if made.size == 0 or np.may_share_memory(made, array) else None
