"""On from better motions: a solver that stopped on a summit of the cost is sent on from beside it.

what a solver found --a better point near it--> what it finds from there --> ... the last that was better
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, Protocol, Self, TypeVar

import numpy as np

from symscrew.optimisation.result import Statistics

# Times that a solver is sent on from a better motion near what it took for the best: one summit may lead to another.
MOST_DESCENTS = 3


class Found(Protocol):
    """What a solver found: one motion, or several in one program."""

    @property
    def ok(self) -> bool | None:
        """Whether it succeeded."""

    @property
    def cost(self) -> float:
        """Of all that was solved."""

    @property
    def better(self) -> np.ndarray | None:
        """Scaled unknowns of a better point near it; None where none was found."""

    @property
    def statistics(self) -> Statistics:
        """What it took."""

    def told(self, **words: Any) -> Self:
        """The same with other words about it."""


F = TypeVar("F", bound=Found)


def descended(found: F, again: Callable[[np.ndarray], F], *, say: Callable[[str], None], until: float) -> F:
    """The best of what was found, on from better points by `again` as long as that pays, with the statistics of all."""
    for _ in range(MOST_DESCENTS):
        begin = found.better
        if begin is None or time.perf_counter() >= until:
            break
        say("the solver stopped where the cost bends downwards: on, from a better motion near it")
        other = again(begin)
        spent = found.statistics + other.statistics
        if not (other.ok and other.cost < found.cost):
            return found.told(statistics=spent)
        found = other.told(statistics=spent)
    return found
