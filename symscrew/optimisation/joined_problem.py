"""Several motions in one problem: phases, one after the other, or load cases that share their design.

Every part is a `TrajectoryProblem`. Phases are joined by links: the next one starts where the last one ends, and at
once freedoms may be stopped or thrown back, or a mass at rest be caught; cases have none. Durations, effects,
conditions, bounds and objectives are each part's own, the design parameters those of all; the cost is the sum.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.optimisation.contradictions import check_problem
from symscrew.optimisation.problem import TrajectoryProblem


@dataclass(frozen=True)
class Link:
    """What happens at once between two phases: the momentum balance of the closed chain, with the next phase's masses.

        N^T M (y_dot after - y_dot before) = sum_i S_i^T impulse_i,    rate_i after = -e_i rate_i before

    `impact`: label of a joint's freedom -> its restitution e_i, 0 to 1 (0: it is stopped); S_i is the freedom's rate by
    y_dot. `catches`: the mass that the next phase has more was at rest before; else it moved along, and without an
    impact the rates stay.
    """

    impact: Mapping[str, float] = field(default_factory=dict)
    catches: bool = False

    @property
    def is_smooth(self) -> bool:
        """Whether rates stay as they are."""
        return not self.impact and not self.catches


@dataclass(frozen=True, repr=False)
class JoinedProblem:
    """Parts and the `links` between neighbours, one fewer than parts: None between load cases."""

    parts: tuple[TrajectoryProblem, ...]
    links: tuple[Link | None, ...]
    name: str = "trajectory"
    text: str = ""

    def __repr__(self) -> str:
        what = "cases" if None in self.links else "phases"
        return f"<JoinedProblem {self.name}: {self.mechanism.name}, {len(self.parts)} {what}>"

    @property
    def mechanism(self) -> Mechanism:
        """Of all parts."""
        return self.parts[0].mechanism

    def called(self, k: int) -> str:
        """Part k as a person counts it."""
        linked = any(self.links[j] is not None for j in (k - 1, k) if 0 <= j < len(self.links))
        return f"{'phase' if linked else 'case'} {k + 1}"

    def __post_init__(self) -> None:
        if len(self.parts) < 2 or len(self.links) != len(self.parts) - 1:
            raise DescriptionError(
                f"a joined problem has at least two parts and a link less, got {len(self.parts)} and {len(self.links)}"
            )
        first = self.parts[0]
        for k, part in enumerate(self.parts):
            where = self.called(k)
            for name in ("design", "solver", "accuracy", "violation"):
                if getattr(part, name) != getattr(first, name):
                    raise DescriptionError(f"{where}: {name} has to be the same in all parts")
            if part.mechanism != first.mechanism:
                raise DescriptionError(f"{where}: all parts move the same mechanism; effects may differ")
            if part.periodic or part.starts > 1:
                raise DescriptionError(f"{where}: 'periodic' and 'starts' are of problems with one motion")
            if part.transcription.method == "shooting":
                raise DescriptionError(f"{where}: shooting takes one motion; expected radau or gauss")
            check_problem(part)
        for k, link in enumerate(self.links):
            if link is not None:
                self._check_link(k, link)

    def _check_link(self, k: int, link: Link) -> None:
        later = self.parts[k + 1]
        if not later.start.is_empty:
            raise DescriptionError(f"phase {k + 2}: it starts where phase {k + 1} ends; expected no conditions there")
        for label, restitution in link.impact.items():
            if not 0.0 <= restitution <= 1.0:
                raise DescriptionError(
                    f"impact of phase {k + 1}: expected a restitution from 0 to 1 for {label}, got {restitution:g}"
                )


def with_weight(problem: TrajectoryProblem, weight: float) -> TrajectoryProblem:
    """A part whose cost counts so many times."""
    if not weight >= 0:
        raise DescriptionError(f"weight: expected a number from 0, got {weight:g}")
    return replace(problem, objectives=tuple(replace(o, weight=weight * o.weight) for o in problem.objectives))
