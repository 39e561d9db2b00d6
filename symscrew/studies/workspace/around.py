"""Places that no straight way reaches, from places of the grid beside them: round a hole of the workspace.

    results of all pieces --from neighbours, breadth first--> the same with the places behind holes

The whole grid is there when it begins, and it is gone through in one order, so that neither how the sweep was cut nor
who computed it when makes a difference.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from symscrew.studies.workspace.evaluation import Arrival, arrived, cases_of, prepare_sweep, results_at
from symscrew.studies.workspace.plan import Plan

Array = np.ndarray
Results = dict[str, Array]


def around_holes(plan: Plan, results: Mapping[str, Array]) -> Results:
    """Results (cases,) with those of places that are reached from neighbours, whose `around` is 1.

    First all are gone to that a way without a singularity leads to, then the others; what was reached straight stays as
    it is. Where ways round both sides of a hole end in different configurations, the shorter one counts, of equal ones
    that along the first axis.
    """
    known = _Known(plan, results)
    found = known.found
    for regular in (True, False):
        fresh = np.flatnonzero((found["reached"] > 0) & ((found["regular"] > 0) | (not regular)))
        while len(fresh):
            news = []
            for target, source in _beside(plan, fresh):
                open_ = found["reached"][target] == 0
                for start in range(0, int(open_.sum()), plan.chunk):
                    some = slice(start, start + plan.chunk)
                    news.append(known.gone(target[open_][some], source[open_][some], regular=regular))
            fresh = np.sort(np.concatenate(news)) if news else np.zeros(0, dtype=int)
    return found


def _beside(plan: Plan, numbers: Array) -> Iterator[tuple[Array, Array]]:
    """(neighbours, whose) of cases by number: one step of one axis farther, then back, an axis after the other."""
    for k, axis in enumerate(plan.axes):
        stride = plan.samples * math.prod(other.count for other in plan.axes[k + 1 :])
        place = numbers // stride % axis.count
        for step, inside in ((1, place < axis.count - 1), (-1, place > 0)):
            yield numbers[inside] + step * stride, numbers[inside]


class _Known:
    """Results by now, and configurations from which others are gone to: walked to again, or kept when reached."""

    def __init__(self, plan: Plan, results: Mapping[str, Array]) -> None:
        self.plan, self.made = plan, prepare_sweep(plan)
        self.found = {name: np.array(values) for name, values in results.items()}
        self.kept: dict[int, Array] = {}

    def gone(self, target: Array, source: Array, *, regular: bool) -> Array:
        """Numbers of the targets that are reached now from their sources, whose results count from now on."""
        plan, made, found = self.plan, self.made, self.found
        cases = cases_of(plan, made, target)
        at = arrived(plan, made, cases, (cases_of(plan, made, source), self._held(source)))
        clear = found["regular"][source] > 0
        good = at.reached & (clear & at.regular | (not regular))
        if not good.any():
            return np.zeros(0, dtype=int)
        least = {name: np.where(clear, value, np.fmin(value, 0.0))[good] for name, value in at.least.items()}
        results = results_at(plan, made, cases[good], Arrival(at.q[good], at.status[good], least), around=True)
        for name, values in results.items():
            found[name][target[good]] = values
        self.kept |= dict(zip(target[good].tolist(), at.q[good], strict=True))
        return np.asarray(target[good])

    def _held(self, numbers: Array) -> Array:
        """q (cases, nq)."""
        straight = np.array([n for n in numbers.tolist() if n not in self.kept], dtype=int)
        if len(straight):
            walked = arrived(self.plan, self.made, cases_of(self.plan, self.made, straight)).q
            self.kept |= dict(zip(straight.tolist(), walked, strict=True))
        return np.stack([self.kept[n] for n in numbers.tolist()])
