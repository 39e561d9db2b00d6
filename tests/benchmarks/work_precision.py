"""Errors, steps and the cost beside bare loops: every benchmark problem and hard case at five tolerances.

The seed, hanging and swinging, is measured against itself at 1e-13. A bare loop is DOP853 with projection around the
same generated functions and nothing else: `bare` with our stages and projection (lean/bare_loop.c), `other` by another
hand, with SciPy's tableau and dense normal equations (lean/other_loop.c), `raw` the same whose outputs are left off
the mechanism. Where one fails or goes astray there is no
ratio. Of the seed instructions are compared too, counted by valgrind where it is there, at equal error: those that the
other loop would need for ours, between the tolerances that it was run at.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from support.problems import SEED, Compiled, compiled, problems

from .bare_loops import Measured, compared
from .tables import table

TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
EQUAL = (1e-4, 1e-6, 1e-8, 1e-10)


def run(*, repeats: int = 5, names: tuple[str, ...] | None = None) -> tuple[str, dict[str, object]]:
    """A Markdown table of errors, one of ratios, one of the seed at equal error, and the raw numbers."""
    errors, ratios, raw = [], [], {}
    for name in names or (*problems(), SEED):
        case = compiled(name)
        found = [(pair["ours"], pair["bare"]) for pair in compared(case, TOLERANCES, repeats=repeats)]
        errors.append([name, *(_cell(ours) for ours, _ in found)])
        ratios.append([name, *(_ratio(ours, bare) for ours, bare in found)])
        pairs = zip(TOLERANCES, found, strict=True)
        raw[name] = [{"tolerance": t, "ours": vars(a), "bare": vars(b)} for t, (a, b) in pairs]
        print(f"{name}: done", flush=True)
    header = ["problem", *(f"{t:g}" for t in TOLERANCES)]
    text = (
        f"Error against the reference (steps) by tolerance:\n\n{table(header, errors)}\n\n"
        f"Time by that of a bare loop at the same local tolerance (its error, steps):\n\n{table(header, ratios)}"
    )
    if names is None or SEED in names:
        text += f"\n\nThe seed at equal error, ours by bare loops:\n\n{at_equal_error(compiled(SEED), repeats)}"
    return text, {"problems": raw}


def at_equal_error(case: Compiled, repeats: int) -> str:
    """Instructions and time of ours by those of the two bare loops, at the errors that ours reaches."""
    found = compared(case, EQUAL, repeats=repeats, count=True, names=("ours", "bare", "other", "raw"))
    rows = []
    for tolerance, at in zip(EQUAL, found, strict=True):
        ours, cells = at["ours"], []
        for name in ("bare", "other", "raw"):
            for quantity in ("instructions", "seconds"):
                needed = _needed([f[name] for f in found], ours.error, quantity)
                cells.append(f"{getattr(ours, quantity) / needed:.2f}" if needed > 0 else "-")
        rows.append([f"{tolerance:g}", f"{ours.error:.1e}", ours.instructions, *cells])
    header = ["tolerance", "error", "instructions", "by bare", "time", "by another hand's", "time"]
    header += ["outputs off it", "time"]
    return table(header, rows)


def _needed(found: Sequence[Measured], error: float, quantity: str) -> float:
    """What a loop needs for an error, between those that it was run at (on logarithmic scales); nan beyond."""
    points = sorted((math.log(f.error), math.log(getattr(f, quantity))) for f in found if f.steps > 0 and f.error > 0
                    and getattr(f, quantity) > 0)  # fmt: skip
    if not points or not points[0][0] <= math.log(error) <= points[-1][0]:
        return math.nan
    return math.exp(float(np.interp(math.log(error), *zip(*points, strict=True))))


def _cell(found: Measured) -> str:
    return f"{found.error:.1e} ({found.steps})" if found.steps > 0 else "stopped"


def _ratio(ours: Measured, bare: Measured) -> str:
    if bare.steps < 0 or ours.steps < 0 or not bare.error < 10 * max(ours.error, 1e-9):
        return "-" if bare.steps < 0 else f"astray ({bare.error:.0e})"
    seconds = ours.seconds / bare.seconds if bare.seconds > 0 else math.nan
    return f"{seconds:.2f} ({bare.error:.0e}, {bare.steps})"
