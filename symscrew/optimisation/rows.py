"""What a point of a motion is made of: its unknowns, its constraints, the sizes of its quantities.

blocks of unknowns Z --> rows  lower <= g(Z) <= upper,  integrand l(Z)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import casadi as ca
import numpy as np

from symscrew.optimisation.problem import Range, TrajectoryProblem

INFINITY = float("inf")


@dataclass(frozen=True)
class Row:
    """One constraint: lower <= value <= upper, divided by `scale` for the solver.

    `limits`: both bounds in a problem of the same shape with other numbers; None where they are the same in all.
    `measure`: what a violation between the points is divided by (default: `scale`). `between`: what is enclosed there
    in place of `value`.
    """

    label: str
    value: Any
    lower: float = 0.0
    upper: float = 0.0
    scale: float = 1.0
    limits: Callable[[TrajectoryProblem], Range] | None = None
    measure: float | None = None
    between: Any = None

    def range_in(self, problem: TrajectoryProblem) -> Range:
        """Both bounds in a problem of the same shape."""
        return (self.lower, self.upper) if self.limits is None else self.limits(problem)


@dataclass(frozen=True)
class PointFunction:
    """Blocks of unknowns in order, the constraints, and what the cost integrates over relative time (None: nothing).

    `numbers`: symbols of the problem's numbers that rows and integrand hold (see `problem_numbers`); mostly none.
    """

    blocks: Mapping[str, ca.SX]
    rows: tuple[Row, ...]
    integrand: Any = None
    numbers: ca.SX = field(default_factory=lambda: ca.SX(0, 1))

    @property
    def arguments(self) -> ca.SX:
        """All unknowns as one vector."""
        return ca.vertcat(ca.SX(0, 1), *self.blocks.values())

    def settled(self, values: Sequence[float]) -> PointFunction:
        """The same with these values in place of its symbols of numbers."""
        if not self.numbers.numel():
            return self
        given = [ca.SX(r.value) for r in self.rows] + ([] if self.integrand is None else [ca.SX(self.integrand)])
        found = ca.substitute(given, [self.numbers], [ca.SX(ca.DM(values))])
        rows = tuple(replace(row, value=value) for row, value in zip(self.rows, found, strict=False))
        return PointFunction(self.blocks, rows, None if self.integrand is None else found[-1])


@dataclass(frozen=True)
class Scales:
    """Typical magnitudes: y (d,), z, u, the duration T [s], and the equations of motion `force` (d,)."""

    y: np.ndarray
    z: np.ndarray
    u: np.ndarray
    duration: float
    force: np.ndarray
    x: np.ndarray = field(default_factory=lambda: np.zeros(0))
