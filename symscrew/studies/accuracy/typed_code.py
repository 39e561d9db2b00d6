"""A program for another number type: C with long double or complex numbers, values in many digits.

These serve as references and for the complex step. They have no guards: where the generated function would report
a small pivot, these divide.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import mpmath
import numpy as np

from symscrew.export import decimal, live_instructions
from symscrew.program import Program

FORMS = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "neg": "-{0}",
    "reciprocal": "1 / {0}",
    "div": "{0} / {1}",
    "less": "{0} < {1} ? 1 : 0",
    "select": "{0} != 0 ? {1} : {2}",
}


@dataclass(frozen=True)
class NumberType:
    """A type of C: its name, and what comes before and after the names of functions."""

    name: str
    before: str = ""
    after: str = ""

    def call(self, op: str) -> str:
        """Format of an operation."""
        if op in FORMS:
            return FORMS[op]
        places = "{0}, {1}" if op == "atan2" else "{0}"
        name = "fabs" if op == "abs" else op
        return f"{self.before}{name}{self.after}({places})"


LONG_DOUBLE = NumberType("long double", "", "l")
COMPLEX = NumberType("double complex", "c")


def only(program: Program, outputs: Sequence[str]) -> Program:
    """The program with some of its outputs, and only the operations that these need."""
    kept = [k for k, port in enumerate(program.outputs) if port.name in outputs]
    reduced = replace(
        program,
        outputs=tuple(program.outputs[k] for k in kept),
        results=tuple(program.results[k] for k in kept),
    )
    live, _ = live_instructions(reduced)
    return replace(reduced, instructions=tuple(live))


def typed_function(program: Program, symbol: str, kind: NumberType) -> str:
    """`void symbol(const T *in0, ..., T *out0, ...)` in C99."""
    inputs = [f"const {kind.name} *in{k}" for k in range(len(program.inputs))]
    outputs = [f"{kind.name} *out{k}" for k in range(len(program.outputs))]
    lines = [f"void {symbol}({', '.join([*inputs, *outputs])})", "{"]
    slot = 0
    for k, port in enumerate(program.inputs):
        lines += [f"    const {kind.name} x{slot + i} = in{k}[{i}];" for i in range(port.size)]
        slot += port.size
    for instruction in program.instructions:
        operands = [_operand(a) for a in instruction.args]
        lines.append(f"    const {kind.name} x{instruction.target} = {kind.call(instruction.op).format(*operands)};")
    for k, slots in enumerate(program.results):
        lines += [f"    out{k}[{i}] = {_operand(s)};" for i, s in enumerate(slots)]
    return "\n".join([*lines, "}", ""])


def _operand(value: int | float) -> str:
    return f"x{value}" if isinstance(value, int) else decimal(float(value))


def in_digits(program: Program, arguments: Sequence[Sequence[Any]], digits: int = 60) -> list[list[Any]]:
    """Outputs of a program at one state in arithmetic of many digits; entries may be any real numbers."""
    context = mpmath.mp.clone()
    context.dps = digits
    values: dict[int, Any] = {}
    slot = 0
    for array in arguments:
        for entry in array:
            values[slot] = context.mpf(entry)
            slot += 1
    apply = _operations(context)
    for instruction in program.instructions:
        args = [values[a] if isinstance(a, int) else context.mpf(a) for a in instruction.args]
        values[instruction.target] = apply[instruction.op](*args)
    return [[values[s] if isinstance(s, int) else context.mpf(s) for s in slots] for slots in program.results]


def _operations(context: Any) -> dict[str, Any]:
    return {
        "add": lambda a, b: a + b,
        "sub": lambda a, b: a - b,
        "mul": lambda a, b: a * b,
        "neg": lambda a: -a,
        "reciprocal": lambda a: 1 / a,
        "div": lambda a, b: a / b,
        "sqrt": context.sqrt,
        "exp": context.exp,
        "sin": context.sin,
        "cos": context.cos,
        "tan": context.tan,
        "atan2": context.atan2,
        "abs": abs,
        "less": lambda a, b: context.mpf(a < b),
        "select": lambda a, b, c: b if a != 0 else c,
    }


def as_floats(values: Sequence[Sequence[Any]]) -> list[np.ndarray]:
    """Numbers of many digits rounded to double."""
    return [np.array([float(v) for v in row]) for row in values]
