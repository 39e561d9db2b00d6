"""Programs with 60 digits: what rounding to doubles does to a function, told by computing without it.

arrays (states, size), one per input --exact_results--> arrays (states, size), one per output, rounded once
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT, apply_high_precision
from symscrew.program.straight_line import Program

Array = np.ndarray


def exact_results(program: Program, inputs: Sequence[Array]) -> tuple[Array, ...]:
    """The outputs of a program's instructions, each with 60 digits; its checks and any second path are left out.

    Args:
        program: what to run; its constants are taken as the doubles that they are.
        inputs: (states, size) per input, in the units of its port.

    Returns:
        (states, size) per output: the nearest doubles. NaN for a state that divides by zero.
    """
    states = [_state(program, [float(x) for array in state for x in array]) for state in zip(*inputs, strict=True)]
    return tuple(
        np.array([entries[k] for entries in states]).reshape(len(states), port.size)
        for k, port in enumerate(program.outputs)
    )


def _state(program: Program, given: Sequence[float]) -> list[list[float]]:
    """Entries of every output at one state."""
    values: dict[int, Any] = dict(enumerate(map(CONTEXT.mpf, given)))
    try:
        for target, op, args in program.instructions:
            known = [values[a] if type(a) is int else CONTEXT.mpf(a) for a in args]
            values[target] = apply_high_precision(op, known)
    except ZeroDivisionError:
        return [[np.nan] * port.size for port in program.outputs]
    return [[float(values[s] if isinstance(s, int) else s) for s in slots] for slots in program.results]
