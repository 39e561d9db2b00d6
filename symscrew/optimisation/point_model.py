"""A problem with its derived equations: which unknowns a point of the motion has, and what they are called.

The unknowns of a point are blocks: y, its first and second derivative by the relative time tau in [0, 1] (so that
everything the transcription does to them is linear also where the duration T is free), z, the drives u, and what
objectives, rules and effects add.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from functools import cached_property
from typing import Any

from symscrew.description import exact
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.functions import joint_freedom_labels, u_port
from symscrew.optimisation.motion_equations import PointEquations
from symscrew.optimisation.problem import TrajectoryProblem
from symscrew.optimisation.problem_numbers import Get, ProblemNumbers
from symscrew.optimisation.rows import INFINITY, Scales
from symscrew.optimisation.typed_names import check_rates, check_typed


class PointModel:
    """A problem, its equations of motion and the sizes of its quantities: `scales` are those of the guess."""

    def __init__(
        self,
        problem: TrajectoryProblem,
        equations: PointEquations,
        scales: Scales,
        numbers: ProblemNumbers | None = None,
    ) -> None:
        """`numbers` takes the problem's numbers that are to stay symbols; None: they are put in as they are."""
        self.problem, self.equations, self.scales, self.numbers = problem, equations, scales, numbers
        system = equations.system
        self.system = system
        self.drive_labels = u_port(system).labels if system.drives else ()
        self.states = tuple(s.name for s in equations.acting.states)
        self.parameter_names = tuple(p.name for p in system.mechanism.parameters.values() if p.run_time)
        self.design = tuple(n for n in self.parameter_names if n in problem.design)
        self._check_names()

    # -- sizes and names ----------------------------------------------------------------------------------

    @property
    def d(self) -> int:
        """Number of independent coordinates."""
        return len(self.equations.labels)

    @property
    def initials(self) -> list[float]:
        """Values of the effects' states at the start, at the problem's parameters.

        Raises:
            DescriptionError: one follows a design parameter, which is not known before.
        """
        mechanism = self.system.mechanism
        values = mechanism.values({name: exact(value) for name, value in self.problem.parameters.items()})
        numbers = {p.symbol: values[name] for name, p in mechanism.parameters.items()}
        for state in self.equations.acting.states:
            chosen = {str(s) for s in mechanism.baked(state.start).free_symbols} & set(self.design)
            if chosen:
                raise DescriptionError(
                    f"design.{min(chosen)}: the state {state.name} begins with it; expected a start that is known"
                )
        return [state.starting(numbers) for state in self.equations.acting.states]

    def number(self, name: str, get: Get) -> Any:
        """A number of the problem as functions of a point hold it: its symbol, or its value."""
        return get(self.problem) if self.numbers is None else self.numbers(name, get)

    def of(self, problem: TrajectoryProblem) -> PointModel:
        """The same for a problem of the same shape, with its numbers as they are."""
        result = copy(self)
        result.problem, result.numbers = problem, None
        return result

    def _check_names(self) -> None:
        problem, bounds = self.problem, self.problem.bounds
        groups: list[tuple[str, Sequence[str], Sequence[str]]] = [
            ("bounds.drives", list(bounds.drives), self.drive_labels),
            ("bounds.drive_rates", list(bounds.drive_rates), self.drive_labels),
            ("bounds.reactions", list(bounds.reactions), list(self.system.mechanism.joints)),
            ("bounds.points", [name for name, _ in bounds.points], list(self.system.mechanism.points)),
            ("preload", list(problem.preload), self.drive_labels),
            ("design", list(problem.design), list(self.system.mechanism.parameters)),
            ("parameters", list(problem.parameters), list(self.system.mechanism.parameters)),
            ("turns", list(problem.turns), self._angles),
        ]
        mechanism = self.system.mechanism
        check_typed(mechanism, self.coordinate_labels, "bounds.joints", bounds.joints)
        check_typed(mechanism, self.coordinate_labels, "guess", problem.guess)
        check_rates(mechanism, self.rate_labels, "bounds.speeds", bounds.speeds)
        for o in problem.objectives:
            groups.append((f"objective {o.type}", [*o.weights, *o.preload], self.drive_labels))
        for shape in bounds.obstacles:
            named = (*shape.at, *shape.points, *(name for part in (*shape.segments, *shape.boxes) for name in part))
            groups.append(("bounds.obstacles", named, list(self.system.mechanism.points)))
        for d in bounds.distances:
            groups.append(("bounds.distances", (d.first, d.second), list(self.system.mechanism.points)))
        for which, c in (("start", problem.start), ("end", problem.end), *(("via", v) for v in problem.via)):
            check_typed(mechanism, self.coordinate_labels, f"{which}.coordinates", c.coordinates)
            check_rates(mechanism, self.rate_labels, f"{which}.rates", c.rates)
            groups.append((f"{which}.points", list(c.points), list(self.system.mechanism.points)))
        for where, names, known in groups:
            for name in names:
                if name not in known:
                    raise DescriptionError(f"{where}: unknown name {name!r}; {did_you_mean(name, known)}")

    @property
    def _angles(self) -> list[str]:
        """Labels of the independent coordinates that can turn round."""
        units = {c.label: c.kind for c in self.system.tree.q}
        return [label for label in self.equations.labels if units[label] == "angle"]

    @cached_property
    def joint_labels(self) -> tuple[str, ...]:
        """Labels of all joint freedoms, cut joints included."""
        return tuple(label for label, _, _ in joint_freedom_labels(self.system))

    @property
    def coordinate_labels(self) -> tuple[str, ...]:
        """Labels of coordinates; what else a condition or bound on them may name is in `typed_names`."""
        return tuple(
            dict.fromkeys((*self.equations.labels, *(c.label for c in self.system.tree.q), *self.joint_labels))
        )

    @property
    def rate_labels(self) -> tuple[str, ...]:
        """Labels of joints' rates; parts of poses have rates as well (`typed_names.check_rates`)."""
        return tuple(dict.fromkeys((*self.equations.labels, *self.joint_labels)))

    def drive_range(self, label: str) -> tuple[float, float]:
        """Bounds of a drive."""
        return self.problem.bounds.drives.get(label, (-INFINITY, INFINITY))
