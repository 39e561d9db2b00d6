"""Directional derivatives of programs by complex steps: no subtraction, so exact to rounding."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.program import Program

STEP = 1e-30  # its square is lost beside 1, so that what is left is the derivative


def _real_choice(condition: complex, one: complex, another: complex) -> complex:
    return one if condition.real != 0.0 else another


def _angle(y: complex, x: complex) -> complex:
    slope = (x.real * y.imag - y.real * x.imag) / (x.real**2 + y.real**2)
    return complex(np.arctan2(y.real, x.real), slope)


OPERATIONS = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "reciprocal": lambda a: 1.0 / a,
    "neg": lambda a: -a,
    "sqrt": np.sqrt,
    "exp": np.exp,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "atan2": _angle,
    "abs": lambda a: -a if a.real < 0.0 else a,
    "less": lambda a, b: complex(a.real < b.real),
    "select": _real_choice,
}


def complex_step(
    program: Program, state: Sequence[np.ndarray], direction: Sequence[np.ndarray]
) -> tuple[np.ndarray, ...]:
    """The derivative (size) of every output of a program at a state (an array (size) per input) along a direction."""
    entries = [
        complex(x, STEP * d) for xs, ds in zip(state, direction, strict=True) for x, d in zip(xs, ds, strict=True)
    ]
    values = dict(enumerate(entries))
    for target, op, args in program.instructions:
        operands = [values[a] if isinstance(a, int) else complex(a) for a in args]
        values[target] = complex(OPERATIONS[op](*operands))
    return tuple(
        np.array([values[s].imag / STEP if isinstance(s, int) else 0.0 for s in slots]) for slots in program.results
    )
