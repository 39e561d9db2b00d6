"""Instructions as lanes see them: a difference is a sum, a negation belongs to what reads it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from symscrew.program.straight_line import Instruction

PACKED = frozenset(("add", "mul", "div", "reciprocal", "sqrt"))  # what a vector unit does on all lanes at once
SLOW = {"div": 4.0, "reciprocal": 4.0, "sqrt": 6.0}  # what they cost beside 1 for a sum or a product

WIDEST = 4  # lanes of a vector; more limbs than that take several

Operand = tuple[int | float, int]  # slot or constant, and its sign
Row = tuple[int | None, ...]  # corresponding slots, one per lane


class Operation(NamedTuple):
    """An instruction with signed operands."""

    op: str
    args: tuple[Operand, ...]


def signed(instructions: Iterable[Instruction]) -> tuple[dict[int, Operation], dict[int, Operand]]:
    """Operations by slot in order, and the slots that are another one's negative."""
    operations: dict[int, Operation] = {}
    negatives: dict[int, Operand] = {}

    def operand(arg: int | float, sign: int = 1) -> Operand:
        if isinstance(arg, int) and arg in negatives:
            base, inner = negatives[arg]
            return base, sign * inner
        return arg, sign

    for i in instructions:
        if i.op == "neg":
            negatives[i.target] = operand(i.args[0], -1)
        elif i.op == "sub":
            operations[i.target] = Operation("add", (operand(i.args[0]), operand(i.args[1], -1)))
        else:
            operations[i.target] = Operation(i.op, tuple([operand(a) for a in i.args]))
    return operations, negatives
