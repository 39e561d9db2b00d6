"""CasADi functions on enclosures, instruction by instruction.

function of scalars --its instructions--> `EnclosedFunction`;  enclosures of its inputs --> enclosures of its outputs
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import casadi as ca
import numpy as np

from symscrew.optimisation.enclosed_choices import COMPARISONS, compared, joined, opposite, selected
from symscrew.optimisation.enclosures import ELEMENTARY, Arithmetic, Enclosure, Number, constant, everything

SUMS: Mapping[int, float] = {ca.OP_ADD: 1.0, ca.OP_SUB: -1.0}
FACTORS: Mapping[int, float] = {ca.OP_NEG: -1.0, ca.OP_TWICE: 2.0}


class EnclosedFunction:
    """A CasADi function of scalars on enclosures; what has no enclosure is everything."""

    def __init__(self, function: ca.Function) -> None:
        self.size = function.sz_w()
        self.shapes = [function.size_out(k) for k in range(function.n_out())]
        self.code = [
            (
                op := function.instruction_id(k),
                function.instruction_input(k),
                function.instruction_output(k),
                float(function.instruction_constant(k)) if op == ca.OP_CONST else 0.0,
            )
            for k in range(function.n_instructions())
        ]

    def __call__(self, arithmetic: Arithmetic, inputs: Sequence[Sequence[Number]]) -> list[list[Number]]:
        """Enclosures of all entries of all outputs, column by column."""
        work: list[Number] = [0.0] * self.size
        results: list[list[Number]] = [[0.0] * (rows * columns) for rows, columns in self.shapes]
        with np.errstate(all="ignore"):
            for op, given, made, value in self.code:
                if op == ca.OP_INPUT:
                    work[made[0]] = inputs[given[0]][given[1]]
                elif op == ca.OP_OUTPUT:
                    results[made[0]][made[1]] = work[given[0]]
                elif op == ca.OP_CONST:
                    work[made[0]] = value
                else:
                    work[made[0]] = _operated(arithmetic, op, [work[k] for k in given])
        return results


def _operated(at: Arithmetic, op: int, args: list[Number]) -> Number:
    if op in SUMS:
        chosen = joined(args[0], args[1]) if op == ca.OP_ADD else None
        return at.add(args[0], args[1], SUMS[op]) if chosen is None else chosen
    if op == ca.OP_MUL:
        return at.multiply(args[0], args[1])
    if op == ca.OP_DIV:
        over = args[1]
        return at.multiply(args[0], at.of(ELEMENTARY[ca.OP_INV], over) if isinstance(over, Enclosure) else 1.0 / over)
    if op in FACTORS:
        return at.scaled(args[0], FACTORS[op])
    if op in (ca.OP_POW, ca.OP_CONSTPOW):
        return at.power(args[0], args[1])
    if op == ca.OP_ASSIGN:
        return args[0]
    size = next((len(a.low[0]) for a in args if isinstance(a, Enclosure)), 1)
    return _of_enclosures(at, op, [a if isinstance(a, Enclosure) else constant(a, size) for a in args])


def _of_enclosures(at: Arithmetic, op: int, args: list[Enclosure]) -> Enclosure:
    if op in COMPARISONS:
        return compared(op, args[0], args[1])
    if op == ca.OP_NOT:
        return opposite(args[0])
    if op == ca.OP_IF_ELSE_ZERO:
        return selected(args[0], args[1])
    if op in (ca.OP_FMAX, ca.OP_FMIN):
        return at.larger(args[0], args[1]) if op == ca.OP_FMAX else at.smaller(args[0], args[1])
    if op == ca.OP_ATAN2:
        return at.angle(args[0], args[1])
    if op in ELEMENTARY:
        return at.of(ELEMENTARY[op], args[0])
    return everything(len(at.radius))
