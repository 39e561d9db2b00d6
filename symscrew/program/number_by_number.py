"""Programs on Python's own numbers: one state at a time, which for few states is several times as fast as arrays.

    inputs of one state as a list of numbers --numbers--> a number per slot, with the bits of the arrays

NumPy takes half a microsecond for an operation on an array of one number, Python a tenth of it for a number. Where
Python raises an error and IEEE arithmetic goes on (a division by 0, the root of a negative number), there is no answer
here: the arrays say what comes of it.
"""

from __future__ import annotations

import math
import operator
import weakref
from collections.abc import Callable, Sequence
from typing import Any

from symscrew.algebra import apply_numpy
from symscrew.program.straight_line import Program

OPERATIONS: dict[str, Callable[[Any, Any], Any]] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "sqrt": lambda x, _: math.sqrt(x),
    "exp": lambda x, _: float(apply_numpy("exp", [x])),
    "sin": lambda x, _: float(apply_numpy("sin", [x])),
    "cos": lambda x, _: float(apply_numpy("cos", [x])),
    "tan": lambda x, _: float(apply_numpy("tan", [x])),
    "atan2": lambda y, x: float(apply_numpy("atan2", [y, x])),
    "abs": lambda x, _: abs(x),
    "less": lambda x, y: 1.0 if x < y else 0.0,
    "both": lambda x, y: (x, y),
    "one of": lambda condition, both: both[0] if condition != 0.0 else both[1],
}
"""Every operation of a program with two operands: of one operand twice the same, of three in two steps."""

NO_NUMBER = (ZeroDivisionError, ValueError, OverflowError)
"""What Python raises where IEEE arithmetic has an infinity or NaN."""

Step = tuple[int, Callable[[Any, Any], Any], int, int]
"""A slot, and the operation and the slots of its operands that make it."""


class NumberByNumber:
    """A program made ready: its constants stand in slots behind the others.

    `read`: the slots that decide results and status.
    """

    def __init__(self, program: Program) -> None:
        self._slots = program.slots
        self._inputs = sum(port.size for port in program.inputs)
        self.read = sorted({
            *(slot for slots in program.results for slot in slots if type(slot) is int),
            *program.tested,
            *program.checked,
        })  # fmt: skip
        self._constants: dict[float | str, int] = {}
        self._behind: list[float] = []
        self._steps: list[Step] = []
        for target, op, args in program.instructions:
            self._add(target, op, [a if type(a) is int else self._slot_of(float(a)) for a in args])

    def _slot_of(self, constant: float) -> int:
        key = constant if constant else repr(constant)  # zeros have signs
        if key not in self._constants:
            self._constants[key] = self._slots + len(self._behind)
            self._behind.append(constant)
        return self._constants[key]

    def _add(self, target: int, op: str, slots: list[int]) -> None:
        """An instruction; with the bits of what it says."""
        add = self._steps.append
        if op == "neg":
            add((target, operator.mul, slots[0], self._slot_of(-1.0)))
        elif op == "reciprocal":
            add((target, operator.truediv, self._slot_of(1.0), slots[0]))
        elif op == "select":
            add((target, OPERATIONS["both"], slots[1], slots[2]))
            add((target, OPERATIONS["one of"], slots[0], target))
        else:
            add((target, OPERATIONS[op], slots[0], slots[-1]))

    def __call__(self, inputs: Sequence[float]) -> list[float]:
        """The numbers of the slots in `read`; none at all where Python's arithmetic has none for one of them."""
        values = [*inputs, *[0.0] * (self._slots - self._inputs), *self._behind]
        try:
            for target, operation, a, b in self._steps:
                values[target] = operation(values[a], values[b])
        except NO_NUMBER:
            return []
        return [values[slot] for slot in self.read]


_READY: dict[int, NumberByNumber] = {}


def number_by_number(program: Program) -> NumberByNumber:
    """The program made ready, once for as long as it is there."""
    key = id(program)
    if key not in _READY:
        _READY[key] = NumberByNumber(program)
        weakref.finalize(program, _READY.pop, key, None).atexit = False
    return _READY[key]
