"""Programs run on NumPy: whole batches of states at once, instruction by instruction; a few of them one by one.

    arrays (*batch, size), one per input --evaluate--> arrays (*batch, size), one per output, and the status (*batch)

This is the reference for every printed target: what a target computes must agree with it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symscrew.algebra import apply_numpy
from symscrew.errors import DescriptionError, KindError
from symscrew.program.number_by_number import number_by_number
from symscrew.program.straight_line import NO_ROTATION, Iteration, Program

FEW = 8
"""States up to which Python's own numbers are faster than arrays, which cost the same for one as for many."""


def evaluate(program: Program, arguments: Sequence[object]) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
    """Run a program on NumPy, all states of a batch through each instruction at once.

    Args:
        program: what to run.
        arguments: an array (*batch, size) or (size,) per input, in the units of its port; batches are broadcast.

    Returns:
        An array (*batch, size) per output and the status (*batch), see `symscrew.program.STATUS`. Where the status
        is not 0 the results are NaN.

    Raises:
        KindError: more or fewer arguments than inputs, or not real numbers.
        DescriptionError: an array of another size than its input.
    """
    if len(arguments) != len(program.inputs):
        names = ", ".join(p.name for p in program.inputs)
        raise KindError(f"{program.name} expects {len(program.inputs)} inputs ({names}), got {len(arguments)}")
    arrays, batch = _arrays(program, arguments)
    with np.errstate(all="ignore"):
        values = _one_by_one(program, arrays, batch) or _all_at_once(program, arrays)
        results = [_entries(values, slots, batch) for slots in program.results]
        status = np.zeros(batch, dtype=int)
        for slot, low, high, code in program.limits:
            value = values[slot]
            within = (value >= (-np.inf if low is None else low)) & (value <= (np.inf if high is None else high))
            status = np.where((status == 0) & ~within, np.where(np.isfinite(value), code, 2), status)
        for guard, threshold in program.guards:
            status = np.where((status == 0) & (np.abs(values[guard]) <= threshold), 1, status)
        total = sum((values[slot] for slot in program.checked), start=np.zeros(batch))
        status = np.where((status == 0) & ~np.isfinite(total), 2, status)
        for result in results:
            result[status != 0] = np.nan
    return tuple(results), status


def real_array(argument: object, where: str) -> np.ndarray:
    """An argument as an array of doubles.

    Raises:
        KindError: complex numbers, of which NumPy would take the real part and only warn.
    """
    array = np.asarray(argument)
    if array.dtype.kind == "c":
        raise KindError(f"{where}: expected real numbers, got {array.dtype}; take x.real if its imaginary part is zero")
    return np.asarray(array, dtype=float)


def _arrays(program: Program, arguments: Sequence[object]) -> tuple[list[np.ndarray], tuple[int, ...]]:
    """An array (*batch, size) per input, whose batches broadcast to the second result."""
    arrays, batch = [], tuple[int, ...]()
    for port, argument in zip(program.inputs, arguments, strict=True):
        array = real_array(argument, f"{program.name}, {port.name}")
        if array.shape[-1:] != (port.size,) and port.size != 1:
            raise DescriptionError(
                f"{program.name}: {port.name} has {port.size} entries, got an array of shape {array.shape}"
            )
        if port.size == 1 and array.shape[-1:] != (1,):
            array = array[..., None]
        batch = np.broadcast_shapes(batch, array.shape[:-1])
        arrays.append(array)
    return arrays, batch


def _all_at_once(program: Program, arrays: Sequence[np.ndarray]) -> dict[int, Any]:
    """The value of every slot, each instruction on whole arrays."""
    given = [array[..., k] for array in arrays for k in range(array.shape[-1])]
    values: dict[int, Any] = dict(enumerate(given))
    for target, op, args in program.instructions:
        values[target] = apply_numpy(op, [values[a] if type(a) is int else a for a in args])
    return values


def _one_by_one(program: Program, arrays: Sequence[np.ndarray], batch: tuple[int, ...]) -> dict[int, Any]:
    """The value of every slot that is read, state by state; nothing where the arrays have to say it."""
    count = math.prod(batch)
    if not 0 < count <= FEW:
        return {}
    run = number_by_number(program)
    given = np.concatenate([np.broadcast_to(a, (*batch, a.shape[-1])).reshape(count, -1) for a in arrays], axis=1)
    found = [run(state) for state in given.tolist()]
    if not all(found):
        return {}
    columns = np.array(found).T.reshape(-1, *batch)
    return dict(zip(run.read, columns, strict=True))


def _entries(values: Mapping[int, Any], slots: Sequence[int | float], batch: tuple[int, ...]) -> np.ndarray:
    """An output (*batch, size) from the values of its slots, and its constants."""
    result = np.empty((*batch, len(slots)))
    result[...] = [0.0 if isinstance(s, int) else s for s in slots]
    for k, slot in enumerate(slots):
        if isinstance(slot, int):
            result[..., k] = values[slot]
    return result


def evaluate_iteration(iteration: Iteration, arguments: Sequence[object]) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
    """Run an iteration as its docstring says, state by state.

    Args:
        iteration: what to run.
        arguments: y (*batch, m), guess (*batch, n) and the run-time parameters (*batch, k), if there are any.

    Returns:
        q as the only array (*batch, n), and the status (*batch). Where the status is not 0, q is NaN.
    """
    arrays = [np.atleast_1d(real_array(a, f"{iteration.step.name}, argument {k + 1}")) for k, a in enumerate(arguments)]
    batch = np.broadcast_shapes(*(a.shape[:-1] for a in arrays))
    count = int(np.prod(batch))
    full = [np.broadcast_to(a, (*batch, a.shape[-1])).reshape(count, a.shape[-1]) for a in arrays]
    q = np.empty_like(full[1], dtype=float)
    status = np.empty(len(q), dtype=int)
    for i in range(len(q)):
        if not all(np.isfinite(a[i]).all() for a in full):
            q[i], status[i] = full[1][i], 2
            continue
        q[i], status[i] = _iterate(iteration, full[0][i], full[1][i], [a[i] for a in full[2:]])
    q[status != 0] = np.nan
    return (q.reshape(*batch, q.shape[-1]),), status.reshape(batch)


def _iterate(
    iteration: Iteration, y: np.ndarray, guess: np.ndarray, parameters: Sequence[np.ndarray]
) -> tuple[np.ndarray, int]:
    """One state: from the guess to y in 1, 2, 4, ... equal parts of the way, until one succeeds."""
    start = guess[list(iteration.independent)]
    (_, _, _, sign), first = evaluate(iteration.step, [guess, start, *parameters])
    if first >= NO_ROTATION:
        return np.array(guess), int(first)
    substeps, outcome = 1, 3
    while substeps <= iteration.max_substeps:
        q, outcome = np.array(guess), 0
        for k in range(1, substeps + 1):
            target = start + (y - start) * (k / substeps)
            q, outcome = _newton(iteration, q, target, parameters, sign=float(sign[0]))
            if outcome:
                break
        if outcome == 0:
            return q, 0
        substeps *= 2
    return np.array(guess), outcome


def _newton(
    iteration: Iteration, q: np.ndarray, y: np.ndarray, parameters: Sequence[np.ndarray], *, sign: float
) -> tuple[np.ndarray, int]:
    """Newton's method at one target y: the last q, and 0, 3 or 4 (see `STATUS`); `sign` is that of the branch."""
    for _ in range(iteration.max_steps):
        (q, residual, step, orientation), status = evaluate(iteration.step, [q, y, *parameters])
        if status:
            return q, 3
        if residual[0] < iteration.tolerance and step[0] < iteration.tolerance:
            return q, 0 if orientation[0] * sign > 0 else 4
    return q, 3
