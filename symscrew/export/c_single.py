"""What single precision costs: errors of every function against double, over random consistent states.

Each operation is evaluated on numbers rounded to `float` and its result is rounded again, which is what C does
with sums, products, quotients and roots; a sine or an arc tangent is taken as correctly rounded. So the figures
are the same on every machine. A compiler that contracts a * b + c rounds less often.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symscrew.algebra import apply_numpy
from symscrew.export.c_precision import SINGLE
from symscrew.export.listing import wrapped
from symscrew.model import Model, inputs_at
from symscrew.program import Iteration, Program, evaluate

STATES, SEED = 256, 32  # random states that errors are measured at: the header prints one digit of the largest


def rounded(array: object) -> np.ndarray:
    """The numbers of type `float` next to those of an array of any shape, as float64 in the same shape."""
    with np.errstate(all="ignore"):
        return np.asarray(array, dtype=np.float32).astype(float)


def evaluate_single(program: Program, arguments: Sequence[np.ndarray]) -> tuple[np.ndarray, ...]:
    """Results (states, size) of a program whose every operation rounds to `float`."""
    columns = [rounded(a)[..., k] for a, p in zip(arguments, program.inputs, strict=True) for k in range(p.size)]
    values: list[Any] = [*columns, *([None] * (program.slots - len(columns)))]
    states = max((len(a) for a in arguments), default=1)
    with np.errstate(all="ignore"):
        for i in program.instructions:
            operands = [values[a] if isinstance(a, int) else rounded(a) for a in i.args]
            values[i.target] = rounded(apply_numpy(i.op, operands))
    found = []
    for slots in program.results:
        entries = [values[s] if isinstance(s, int) else rounded(s) for s in slots]
        found.append(
            np.stack([np.broadcast_to(e, (states,)) for e in entries], -1) if entries else np.zeros((states, 0))
        )
    return tuple(found)


def single_inputs(model: Model) -> Mapping[str, tuple[np.ndarray, ...]]:
    """The states (STATES, size) of every function but iterations: consistent, numbers of type `float`."""
    states = model.system.states(STATES - 1, SEED)
    programs = {name: p for name, p in model.programs.items() if not isinstance(p, Iteration)}
    return {name: tuple(map(rounded, inputs_at(model.system, p, states))) for name, p in programs.items()}


def single_errors(model: Model) -> Mapping[str, tuple[int, tuple[float, ...]]]:
    """Per function the number of states and, per output, the largest error over its largest entry."""
    found, given = {}, single_inputs(model)
    for name, program in model.programs.items():
        if isinstance(program, Iteration):
            continue
        inputs = given[name]
        exact, status = evaluate(program, inputs)
        sound = np.atleast_1d(status) == 0
        errors = tuple(_error(a[sound], b[sound]) for a, b in zip(exact, evaluate_single(program, inputs), strict=True))
        found[name] = (int(sound.sum()), errors)
    return found


def _error(expected: np.ndarray, got: np.ndarray) -> float:
    largest = np.abs(expected).max(initial=0.0)
    return float(np.abs(expected - got).max(initial=0.0) / largest) if largest else 0.0


def error_lines(program: Program | Iteration, measured: tuple[int, tuple[float, ...]] | None) -> list[str]:
    """What the header says about a function in single precision."""
    if isinstance(program, Iteration):
        bound = SINGLE.threshold(program.tolerance)
        return wrapped(
            f"Single precision: Newton's iteration ends when residual and step are below {bound}", later="  "
        )
    if measured is None:
        return []
    states, errors = measured
    named = ", ".join(f"{p.name} {e:.0e}" for p, e in zip(program.outputs, errors, strict=True) if p.size)
    text = f"Single precision: largest error against double at {states} states, over the largest entry: {named}"
    return wrapped(text, later="  ")
