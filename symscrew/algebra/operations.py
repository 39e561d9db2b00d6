"""What each operation of the tape means: in NumPy (the same bits on every machine), in SymPy and with 60 digits."""

from __future__ import annotations

import operator
from typing import Any

import mpmath
import numpy as np
import sympy

from symscrew.algebra import elementary
from symscrew.description import sixty_digits

CONTEXT = mpmath.ctx_mp.MPContext()
CONTEXT.dps = 60  # of constants: zeros of the geometry stay zeros through hundreds of roundings, see `nodes.ZERO_BITS`

ARITHMETIC: dict[str, Any] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "neg": operator.neg,
}
"""What means the same for numbers of every kind and for nodes of a tape."""

ROUNDING = 1e-9
"""A value at a sample state that is smaller than this by its largest at all of them is rounding of a zero. Samples
close the loops to 1e-14, which leaves 1e-12 of a zero; a pivot that means something is above 1e-6. Below, 1 over it
is infinite; above, it is a number."""

# every operation of the tape, as a function of SymPy expressions
IN_SYMPY: dict[str, Any] = {
    **ARITHMETIC,
    "reciprocal": lambda x: 1 / x,
    "sqrt": sympy.sqrt,
    "exp": sympy.exp,
    "sin": sympy.sin,
    "cos": sympy.cos,
    "tan": sympy.tan,
    "atan2": sympy.atan2,
    "abs": sympy.Abs,
    "less": lambda x, y: sympy.Piecewise((1, x < y), (0, True)),
    "select": lambda c, x, y: sympy.Piecewise((x, sympy.Ne(c, 0)), (y, True)),
}

# and of arrays; sines and the like are our own, so that samples and test vectors are equal on every machine
IN_NUMPY: dict[str, Any] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "neg": np.negative,
    "reciprocal": lambda x: 1.0 / x,
    "div": np.divide,
    "sqrt": np.sqrt,
    "exp": elementary.exp,
    "sin": elementary.sin,
    "cos": elementary.cos,
    "tan": elementary.tan,
    "atan2": elementary.arctan2,
    "abs": np.abs,
    "less": lambda x, y: np.where(x < y, 1.0, 0.0),
    "select": lambda c, x, y: np.where(c != 0, x, y),
}


def at_samples(op: str, args: list[Any]) -> Any:
    """`apply_numpy` over sample states, where 1 over rounding is 1/0.

    A pivot that is rounding at a state where others are not, as at a singular reference, would let whatever is divided
    by it pass for a large number there, and that for what the sizes of the other states are measured by.
    """
    result = apply_numpy(op, args)
    if op == "reciprocal" and np.ndim(args[0]):
        sizes = np.abs(args[0])
        largest = np.max(sizes[np.isfinite(sizes)], initial=0.0)
        result = np.where(sizes < ROUNDING * largest, np.inf, result)
    return result


def apply_numpy(op: str, args: list[Any]) -> Any:
    """One operation of the tape on NumPy values."""
    return IN_NUMPY[op](*args)


def evaluate_constant(name: str, values: list[Any]) -> Any:
    """A function of constants with 60 digits."""
    if name == "less":
        return 1 if values[0] < values[1] else 0
    if name == "select":
        return values[1] if values[0] != 0 else values[2]
    if name == "abs":
        return abs(values[0])
    return getattr(CONTEXT, name)(*values)


def apply_high_precision(op: str, args: list[Any]) -> Any:
    """One operation of the tape with 60 digits."""
    if op in ARITHMETIC:
        return ARITHMETIC[op](*args)
    if op == "reciprocal":
        return 1 / args[0]
    return evaluate_constant(op, args)


def high_precision(number: sympy.Expr) -> Any:
    """An exact SymPy number as a 60-digit float of `CONTEXT`."""
    return CONTEXT.mpf(int(number)) if number.is_Integer else CONTEXT.mpf(sixty_digits(number)._mpf_)
