"""What a point of a motion is made of: its unknowns, its constraints, the sizes of its quantities.

blocks of unknowns Z --> rows  lower <= g(Z) <= upper,  integrand l(Z)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

INFINITY = float("inf")


@dataclass(frozen=True)
class Row:
    """One constraint: lower <= value <= upper, divided by `scale` for the solver.

    `measure`: what a violation between the points is divided by (default: `scale`).
    """

    label: str
    value: Any
    lower: float = 0.0
    upper: float = 0.0
    scale: float = 1.0
    measure: float | None = None


@dataclass(frozen=True)
class PointFunction:
    """Blocks of unknowns in order, the constraints, and what the cost integrates over relative time (None: nothing)."""

    blocks: Mapping[str, ca.SX]
    rows: tuple[Row, ...]
    integrand: Any = None

    @property
    def arguments(self) -> ca.SX:
        """All unknowns as one vector."""
        return ca.vertcat(ca.SX(0, 1), *self.blocks.values())


@dataclass(frozen=True)
class Scales:
    """Typical magnitudes: y (d,), z, u, the duration T [s], and the equations of motion `force` (d,)."""

    y: np.ndarray
    z: np.ndarray
    u: np.ndarray
    duration: float
    force: np.ndarray
    x: np.ndarray = field(default_factory=lambda: np.zeros(0))
