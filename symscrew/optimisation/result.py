"""A motion that was found: with the solver's multipliers, its verdict and its errors.

PlannedMotion + multipliers --costates, mesh_errors--> Trajectory: status, errors between the points
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.optimisation.followed_branch import Branch, Followed
from symscrew.optimisation.many_starts import Search
from symscrew.optimisation.mesh_errors import Errors, costates_of, errors_of
from symscrew.optimisation.optimality import Look
from symscrew.optimisation.planned_motion import PlannedMotion

# What is said of a motion, and nothing of what it is.
WORDS = frozenset({"ok", "status", "statistics", "reasons", "refinements", "notes", "replayed", "search", "look"})


@dataclass(frozen=True)
class Statistics:
    """Iterations, and time [s] by part (model, transcription, functions, solver, errors, total), by two clocks.

    `times`: the wall's; `processor`: the processor's, over all threads. `undefined`: equation -> evaluations on the
    solver's way in which it was the first that was not finite (the solver shortens such steps).
    """

    iterations: int
    times: Mapping[str, float]
    processor: Mapping[str, float]
    undefined: Mapping[str, int] = field(default_factory=dict)

    def __add__(self, after: Statistics) -> Statistics:
        """Of both, one after the other."""
        times, processor = (
            {name: old.get(name, 0.0) + seconds for name, seconds in new.items()}
            for old, new in ((self.times, after.times), (self.processor, after.processor))
        )
        undefined = Counter(self.undefined) + Counter(after.undefined)
        return Statistics(self.iterations + after.iterations, times, processor, dict(undefined.most_common()))

    def completed(self, rest: str, spent: np.ndarray) -> Statistics:
        """With what the `rest` took of what was `spent` in all (by both clocks), and the total."""
        times, processor = (
            {**each, rest: total - sum(each.values()), "total": total}
            for each, total in zip((self.times, self.processor), spent.tolist(), strict=True)
        )
        return replace(self, times=times, processor=processor)


@dataclass(frozen=True)
class Replay:
    """How the replayed motion differs from the planned one: t (n,), y, planned (n, d) at the ends of the intervals.

    `end_error`: largest difference of y and, times the duration, of y_dot at the end; `integration`: how much halving
    the last step changed the end; `closure`: largest opening of the loops without units; `local_errors` (intervals,):
    what replays of single intervals, from the plan at their starts, end off the plan.
    """

    t: np.ndarray
    y: np.ndarray
    planned: np.ndarray
    end_error: float
    largest_error: float
    integration: float
    closure: float
    local_errors: np.ndarray


@dataclass(frozen=True, repr=False)
class Trajectory(PlannedMotion):
    """The outcome of an optimisation; `ok` is the verdict on it, None where it was not judged.

    `ok` is False where the motion is only the best iterate, or a look by another route did not confirm it; `solved` is
    the solver's own word, on the points of the mesh alone.
    `arrays` are the unknowns by name (rates by relative time), `x`, `multipliers`, `bound_multipliers` the solver's
    own vectors; `cost` is in the units of the objectives; `parameters` the design found, by name. `status` is one
    sentence, `reasons` say which constraints cannot be met, where; `notes` say what was not
    tried to make it more exact, or by which coordinates a passage was found; `replayed` is the replay that
    confirmed it, None where none was made; `search` what came of other guesses, where several were asked for; `look`
    what slopes and curvature say of the solver's answer, None where it was not looked at.
    """

    x: np.ndarray
    multipliers: np.ndarray
    bound_multipliers: np.ndarray
    cost: float
    cost_scale: float
    ok: bool | None
    status: str
    statistics: Statistics
    reasons: tuple[str, ...] = ()
    refinements: int = 0
    notes: tuple[str, ...] = ()
    replayed: Replay | None = None
    search: Search | None = None
    solved: bool = False
    look: Look | None = None

    def __repr__(self) -> str:
        return f"<Trajectory {self.problem.name}: {self.duration:g} s, cost {self.cost:.6g}, {self.status}>"

    @property
    def better(self) -> np.ndarray | None:
        """Scaled unknowns of a better motion near this one; None where none was found."""
        return self.look.better if self.look else None

    def told(self, **words: Any) -> Trajectory:
        """The same motion with other words about it (`ok`, `status`, `notes` ...): looks at it are not made again."""
        other = replace(self, **words)
        own = {field.name for field in fields(self)}
        assert not words.keys() - WORDS, words
        vars(other).update({name: look for name, look in vars(self).items() if name not in own})
        return other

    @cached_property
    def costates(self) -> np.ndarray:
        """Multipliers of the rows at the points as functions of relative time: (points, rows)."""
        return costates_of(self.transcribed.families[0], self.multipliers * self.cost_scale)

    @cached_property
    def errors(self) -> Errors:
        """Errors between the points."""
        settled = replace(self, transcribed=self.transcribed.settled())
        return errors_of(settled, self.costates, self.branch, self.followed)

    @cached_property
    def branch(self) -> Branch:
        """The loops on enclosures."""
        return Branch(self)

    @cached_property
    def followed(self) -> Followed:
        """The motion followed from its start on its assembly mode."""
        return self.branch.followed()
