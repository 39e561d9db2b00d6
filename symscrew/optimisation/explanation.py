"""What a solver's end means, and which constraints a motion breaks where.

last iterate --constraints missed, bounds pressed--> sentences for `Trajectory.status` and `reasons`
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.optimisation.sparse import NonlinearProgram
from symscrew.optimisation.unknowns import Unknowns

STATUS = {
    "Solve_Succeeded": "optimal: all constraints hold and no better motion is near",
    "Solved_To_Acceptable_Level": "nearly optimal: the solver stalled close to its tolerance",
    "Infeasible_Problem_Detected": "infeasible: no motion near the last one meets all constraints",
    "Maximum_Iterations_Exceeded": "not converged: the most iterations were used up",
    "Restoration_Failed": "not converged: the solver found no way back to the constraints",
    "Search_Direction_Becomes_Too_Small": "not converged: the steps became too small to go on",
    "Diverging_Iterates": "not converged: the motion ran away; is something unbounded?",
    "Invalid_Number_Detected": "not converged: a function is undefined where the solver went (a singularity?)",
    "Error_In_Step_Computation": "not converged: the linear system could not be solved (a singular start?)",
    "Not_Enough_Degrees_Of_Freedom": "overdetermined: there are more conditions than unknowns",
    "Maximum_CpuTime_Exceeded": "not converged: the time was used up",
    "Maximum_WallTime_Exceeded": "not converged: the time was used up",
    "User_Requested_Stop": "stopped by the user",
}
SHOWN = 5  # kinds of constraints and of bounds that are named
BROKEN = 1e-6  # scaled: a solver that succeeds leaves less, so less is no reason why it did not
PRESSED = 1e-4  # scaled: an interior point stays off a bound that it presses against by less than this


def status_of(word: str, *, success: bool, broken: Sequence[str]) -> str:
    """What a solver's word means; one that calls itself successful is believed where no constraint is broken."""
    if success and broken:
        return f"not converged: the solver took it for solved by its own options, but {broken[0]}"
    return STATUS.get(word, f"the solver ended with {word}")


def broken_rows(program: NonlinearProgram, unknowns: Unknowns, x: np.ndarray, g: np.ndarray) -> tuple[str, ...]:
    """The constraints that are missed most, one line per kind: what, where, by how much."""
    entries: list[tuple[float, str, float]] = []
    for values, low, high, labels, times in (
        (g, program.lower, program.upper, program.labels, program.tau),
        (x, unknowns.lower, unknowns.upper, unknowns.labels, unknowns.tau),
    ):
        miss = np.maximum(np.maximum(low - values, values - high), 0.0)
        miss = np.where(np.isfinite(values), miss, np.inf)
        entries += [(float(miss[k]), labels[k], float(times[k])) for k in np.flatnonzero(~(miss <= BROKEN))]
    worst: dict[str, tuple[float, float, int]] = {}
    for size, label, tau in entries:
        kind = label.split(", row")[0]
        largest, at, count = worst.get(kind, (-1.0, 0.0, 0))
        worst[kind] = (size, tau, count + 1) if size > largest else (largest, at, count + 1)
    ordered = sorted(worst.items(), key=lambda item: -item[1][0])[:SHOWN]
    return tuple(
        f"{kind} is missed at {count} place{'s' if count > 1 else ''}, most (by {size:.2g}, scaled) at "
        f"{100 * at:.0f} % of the duration"
        for kind, (size, at, count) in ordered
    )


def pressing_bounds(unknowns: Unknowns, x: np.ndarray, multipliers: np.ndarray) -> tuple[str, ...]:
    """The bounds that the motion presses against most, one line per unknown's name."""
    bounded = (np.isfinite(unknowns.lower) | np.isfinite(unknowns.upper)) & (unknowns.lower < unknowns.upper)
    on = bounded & ((x < unknowns.lower + PRESSED) | (x > unknowns.upper - PRESSED))
    groups: dict[str, list[int]] = {}
    for k in np.flatnonzero(bounded):
        groups.setdefault(unknowns.labels[k], []).append(int(k))
    pressed = {label: float(np.abs(multipliers[at]).sum()) for label, at in groups.items() if on[at].any()}
    ordered = sorted(pressed, key=lambda label: -pressed[label])[:SHOWN]
    return tuple(
        f"{label} stands on its bounds at {100 * on[groups[label]].mean():.0f} % of its places" for label in ordered
    )
