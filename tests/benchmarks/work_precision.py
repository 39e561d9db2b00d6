"""Errors, steps and the cost beside a bare loop: every benchmark problem and hard case at five tolerances.

The seed, hanging and swinging, is measured against itself at 1e-13. A bare loop is DOP853 with projection around the
same generated functions and nothing else (lean/bare_loop.c); where it fails or goes astray there is no ratio. The first
ratio is of instructions where valgrind is there, the second of time.
"""

from __future__ import annotations

import math

from support.problems import SEED, compiled, problems

from .bare_loops import Measured, compared
from .tables import table

TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12)


def run(*, repeats: int = 5, names: tuple[str, ...] | None = None) -> tuple[str, dict[str, object]]:
    """A Markdown table of errors, one of ratios, and the raw numbers."""
    errors, ratios, raw = [], [], {}
    for name in names or (*problems(), SEED):
        case = compiled(name)
        count = name not in ("flyball_governor",)  # 130,000 steps take valgrind minutes
        found = compared(case, TOLERANCES, repeats=repeats, count=count)
        errors.append([name, *(_cell(ours) for ours, _ in found)])
        ratios.append([name, *(_ratio(ours, bare) for ours, bare in found)])
        pairs = zip(TOLERANCES, found, strict=True)
        raw[name] = [{"tolerance": t, "ours": vars(a), "bare": vars(b)} for t, (a, b) in pairs]
        print(f"{name}: done", flush=True)
    header = ["problem", *(f"{t:g}" for t in TOLERANCES)]
    text = (
        f"Error against the reference (steps) by tolerance:\n\n{table(header, errors)}\n\n"
        f"Instructions, then time, by those of a bare loop (its error, steps):\n\n{table(header, ratios)}"
    )
    return text, {"problems": raw}


def _cell(found: Measured) -> str:
    return f"{found.error:.1e} ({found.steps})" if found.steps > 0 else "stopped"


def _ratio(ours: Measured, bare: Measured) -> str:
    if bare.steps < 0 or ours.steps < 0 or not bare.error < 10 * max(ours.error, 1e-9):
        return "-" if bare.steps < 0 else f"astray ({bare.error:.0e})"
    instructions = f"{ours.instructions / bare.instructions:.2f}" if bare.instructions else "-"
    seconds = ours.seconds / bare.seconds if bare.seconds > 0 else math.nan
    return f"{instructions}, {seconds:.2f} ({bare.error:.0e}, {bare.steps})"
