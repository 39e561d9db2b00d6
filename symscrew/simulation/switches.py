"""Where the law of the motion changes: zeros of what the slopes compare and of what they take the size of.

slopes --conditions--> switches(t, q, v, x, u, s, p) -> g (n,), whose signs are the pieces that the slopes are smooth on

A step of an integrator across a corner has an error that its estimate need not see: steps end at these zeros.
"""

from __future__ import annotations

from dataclasses import replace

from symscrew.program import Port, Program
from symscrew.simulation.linking import Linker, Operand

STATE = ("q", "v", "x")  # inputs in which a condition is watched: those of time are landed on as features in time


def switches(slopes: Program, linker: Linker) -> Program | None:
    """The conditions of slopes as numbers that change their sign; None where the slopes have none.

    Args:
        slopes: accelerations and rates of the states.
        linker: in which they stand.
    """
    moving = _of_the_state(slopes)
    needed = {slot for result in slopes.results for slot in result if isinstance(slot, int)}
    found: dict[tuple[Operand, ...], None] = {}
    for target, op, args in reversed(slopes.instructions):
        if target not in needed:
            continue
        needed |= {arg for arg in args if isinstance(arg, int)}
        if target in moving and op in ("less", "abs"):
            found[args] = None
    if not found:
        return None
    conditions = list(reversed(found))
    values = [args[0] if len(args) == 1 else linker.apply("sub", args[1], args[0]) for args in conditions]
    values = list(dict.fromkeys(values))
    count = len(values)
    port = Port("g", (count,), ("1",) * count, tuple(f"g{k}" for k in range(count)), "conditions, in their own units")
    text = "What the slopes compare: they are smooth where no sign changes."
    whole = replace(linker.program("switches", text, [(port, values)]), guards=())
    return replace(whole, instructions=tuple(whole.live[0]))


def _of_the_state(program: Program) -> set[int]:
    """The slots that depend on the state."""
    found, at = set(), 0
    for port in program.inputs:
        if port.name in STATE:
            found |= set(range(at, at + port.size))
        at += port.size
    for target, _, args in program.instructions:
        if any(isinstance(arg, int) and arg in found for arg in args):
            found.add(target)
    return found
