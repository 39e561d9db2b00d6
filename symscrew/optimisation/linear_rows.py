"""Constraints that are linear in a transcription's unknowns, collected one group after the other.

rows.new(labels, times, lower, upper) -> row numbers;    rows.terms.add(row numbers, unknowns, factors)
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.sparse import Linear, SparseMap
from symscrew.optimisation.time_grid import TimeGrid
from symscrew.optimisation.unknowns import Terms, Unknowns


class LinearRows:
    """Rows lower <= matrix X <= upper of a model's transcription; `terms` takes the entries of the matrix."""

    def __init__(self, model: PointModel, grid: TimeGrid, unknowns: Unknowns) -> None:
        self.model, self.grid, self.unknowns = model, grid, unknowns
        self.terms = Terms(unknowns)
        self._lower: list[np.ndarray] = []
        self._upper: list[np.ndarray] = []
        self._labels: list[str] = []
        self._tau: list[np.ndarray] = []
        self._count = 0

    def new(
        self, labels: Sequence[str], tau: np.ndarray | float, lower: object = 0.0, upper: object = 0.0
    ) -> np.ndarray:
        """Row numbers (times, labels) of new constraints."""
        times = np.atleast_1d(np.asarray(tau, dtype=float))
        shape = (len(times), len(labels))
        rows = self._count + np.arange(shape[0] * shape[1]).reshape(shape)
        self._count += rows.size
        for store, value in ((self._lower, lower), (self._upper, upper)):
            store.append(np.broadcast_to(np.asarray(value, dtype=float), shape).ravel())
        self._labels += list(labels) * len(times)
        self._tau.append(np.repeat(times, len(labels)))
        return rows

    def linear(self) -> Linear:
        """All of them."""
        rows, columns, values = self.terms.entries()
        none = [np.zeros(0)]
        return Linear(
            SparseMap.of(rows, columns, values, self._count),
            np.concatenate([*none, *self._lower]),
            np.concatenate([*none, *self._upper]),
            tuple(self._labels),
            np.concatenate([*none, *self._tau]),
        )
