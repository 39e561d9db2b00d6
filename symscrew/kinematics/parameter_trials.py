"""Values of run-time parameters at which identities of the geometry are looked at: what is zero at all is always zero.

nominal values --moved by parts that no identity survives--> three trials
"""

from __future__ import annotations

from typing import Any

import sympy

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description import Mechanism

COUNT = 3  # the first is the nominal value


def trials(mechanism: Mechanism) -> list[dict[sympy.Symbol, Any]]:
    """Symbols of the run-time parameters -> values of 60 digits, of every trial; none without such parameters."""
    chosen = [p for p in mechanism.parameters.values() if p.run_time]
    found = []
    for k in range(COUNT if chosen else 0):
        trial = {}
        for i, p in enumerate(chosen):
            shift = CONTEXT.mpf(k) * CONTEXT.sqrt(i + 2) / 97
            trial[p.symbol] = high_precision(p.value) * (1 + shift) + shift / 89
        found.append(trial)
    return found


def always_below(mechanism: Mechanism, expression: sympy.Expr, bound: float) -> bool:
    """Whether the size of an expression of the description is below a bound, for all values of the parameters."""
    baked = mechanism.baked(expression)
    if not baked.free_symbols:
        return bool(abs(mechanism.number(expression).evalf(30)) < bound)
    numbers = [{s: sympy.Float(value, 40) for s, value in trial.items()} for trial in trials(mechanism)]
    return all(bool(abs(baked.xreplace(at).evalf(30)) < bound) for at in numbers)
