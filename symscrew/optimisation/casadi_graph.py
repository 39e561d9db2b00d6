"""Straight-line programs on CasADi expressions, without the guards and the status of exported functions.

An optimiser passes through states at which a guard would fire, and needs derivatives there; so the operations
stand alone here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import casadi as ca

from symscrew.export import TABLE
from symscrew.program import Program


def symbolic_outputs(program: Program, known: Mapping[str, Any]) -> dict[str, ca.SX]:
    """Outputs of a program by name, at SX vectors of its inputs by name."""
    slots: list[Any] = [None] * max(program.slots, 1 + max((i.target for i in program.instructions), default=0))
    at = 0
    for port in program.inputs:
        value = ca.SX(known[port.name])
        if value.numel() != port.size:
            raise ValueError(f"{program.name}: {port.name} has {port.size} entries, got {value.numel()}")
        for entry in value.elements():
            slots[at] = entry
            at += 1
    for instruction in program.instructions:
        arguments = [slots[a] if isinstance(a, int) else ca.SX(a) for a in instruction.args]
        slots[instruction.target] = TABLE[instruction.op](*arguments)
    return {
        port.name: ca.vertcat(ca.SX(0, 1), *[slots[s] if isinstance(s, int) else ca.SX(s) for s in results])
        for port, results in zip(program.outputs, program.results, strict=True)
    }


def numeric_function(program: Program) -> ca.Function:
    """A program as a function of numbers, its outputs without a status."""
    symbols = [ca.SX.sym(port.name, port.size) for port in program.inputs]
    names = [port.name for port in program.inputs]
    found = symbolic_outputs(program, dict(zip(names, symbols, strict=True)))
    return ca.Function(program.name, symbols, list(found.values()), names, list(found))
