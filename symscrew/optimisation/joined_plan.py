"""The outcome of a joined problem: the motion of every part with its verdict, and what became of the links."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symscrew.optimisation.joined_problem import JoinedProblem
from symscrew.optimisation.result import Statistics, Trajectory


@dataclass(frozen=True)
class Passed:
    """A link as it was looked at: y_dot (d,) before and behind, `off` of the tree's own momentum balance [y, times the
    duration], and the energy [J] that the impact took."""

    before: np.ndarray
    behind: np.ndarray
    off: float
    lost: float


@dataclass(frozen=True, repr=False)
class JoinedPlan:
    """Motions of all parts; `ok` is the verdict on all, `status` a sentence, `reasons` what stands against it.

    `parts` are trajectories as of problems by themselves, `cost` the sum of theirs, `parameters` the design found.
    `links`: one for each pair of phases. `end_error`: how far a replay of all phases, each from where that of the one
    before ended, is off at the last end (y and, times the duration, y_dot; the largest of cases: of each by itself),
    None where none was made.
    """

    problem: JoinedProblem
    parts: tuple[Trajectory, ...]
    cost: float
    ok: bool
    status: str
    statistics: Statistics
    reasons: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    links: tuple[Passed | None, ...] = ()
    end_error: float | None = None
    refinements: int = 0

    def __repr__(self) -> str:
        return f"<JoinedPlan {self.problem.name}: {len(self.parts)} parts, cost {self.cost:.6g}, {self.status}>"

    @property
    def parameters(self) -> dict[str, float]:
        """The design parameters found."""
        return self.parts[0].parameters

    @property
    def starts(self) -> np.ndarray:
        """When phases start [s]; of cases 0."""
        times = [0.0]
        for part, link in zip(self.parts, self.problem.links, strict=False):
            times.append(0.0 if link is None else times[-1] + part.duration)
        return np.array(times)
