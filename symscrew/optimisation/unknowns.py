"""The unknowns of a transcription: where they stand in the solver's vector, how they are scaled and bounded.

arrays by name --pack--> X (what the solver sees, of size one) --unpack--> arrays by name;    value = scale X
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

INFINITY = float("inf")


@dataclass(frozen=True)
class UnknownGroup:
    """Unknowns of one name at every point: what a person calls them, typical sizes (len(labels),), bounds of all."""

    name: str
    labels: Sequence[str]
    size: np.ndarray
    lower: float = -INFINITY
    upper: float = INFINITY


@dataclass
class Unknowns:
    """Arrays of unknowns by name; entry i of the solver's vector stands for `scale[i]` times itself.

    `index[name]` has the shape of the array and holds positions. `tau` is the time of every entry, `labels` what
    a person calls it.
    """

    index: dict[str, np.ndarray] = field(default_factory=dict)
    scale: np.ndarray = field(default_factory=lambda: np.zeros(0))
    lower: np.ndarray = field(default_factory=lambda: np.zeros(0))
    upper: np.ndarray = field(default_factory=lambda: np.zeros(0))
    tau: np.ndarray = field(default_factory=lambda: np.zeros(0))
    labels: list[str] = field(default_factory=list)

    @property
    def size(self) -> int:
        """Number of unknowns."""
        return len(self.scale)

    def add(self, name: str, tau: np.ndarray, labels: Sequence[str], scale: np.ndarray) -> np.ndarray:
        """Unknowns of the shape (*tau.shape, len(labels)) with one scale per label, without bounds yet."""
        tau = np.asarray(tau, dtype=float)
        count, width = int(tau.size), len(labels)
        first = self.size
        self.scale = np.concatenate([self.scale, np.tile(np.asarray(scale, dtype=float), count)])
        self.lower = np.concatenate([self.lower, np.full(count * width, -INFINITY)])
        self.upper = np.concatenate([self.upper, np.full(count * width, INFINITY)])
        self.tau = np.concatenate([self.tau, np.repeat(tau.ravel(), width)])
        self.labels += list(labels) * count
        self.index[name] = first + np.arange(count * width).reshape(*tau.shape, width)
        return self.index[name]

    def bound(self, entries: np.ndarray, lower: float, upper: float) -> None:
        """Narrow the bounds of entries (in the unknowns' own units)."""
        at = np.atleast_1d(entries)
        self.lower[at] = np.maximum(self.lower[at], lower / self.scale[at])
        self.upper[at] = np.minimum(self.upper[at], upper / self.scale[at])

    def copy(self) -> Unknowns:
        """The same with bounds of its own."""
        return replace(self, lower=self.lower.copy(), upper=self.upper.copy())

    def pack(self, values: dict[str, np.ndarray]) -> np.ndarray:
        """The solver's vector of given arrays; what is not given is 0."""
        x = np.zeros(self.size)
        for name, array in values.items():
            if name in self.index:
                at = self.index[name]
                x[at] = np.asarray(array, dtype=float).reshape(at.shape) / self.scale[at]
        return x

    def unpack(self, x: np.ndarray) -> dict[str, np.ndarray]:
        """Arrays by name from the solver's vector."""
        return {name: (x * self.scale)[at] for name, at in self.index.items()}


@dataclass
class Terms:
    """Rows of a sparse linear map of the unknowns, collected entry by entry; scaled to the solver's unknowns."""

    unknowns: Unknowns
    rows: list[np.ndarray] = field(default_factory=list)
    columns: list[np.ndarray] = field(default_factory=list)
    values: list[np.ndarray] = field(default_factory=list)

    def add(self, rows: np.ndarray, entries: np.ndarray, factor: object = 1.0) -> None:
        """Add factor times the unknowns `entries` to `rows`; all of one shape, or broadcast."""
        rows, entries, factor = np.broadcast_arrays(rows, entries, np.asarray(factor, dtype=float))
        self.rows.append(rows.ravel())
        self.columns.append(entries.ravel())
        self.values.append(factor.ravel() * self.unknowns.scale[entries.ravel()])

    def entries(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rows, columns and values of all entries."""
        if not self.rows:
            return np.zeros(0, int), np.zeros(0, int), np.zeros(0)
        return np.concatenate(self.rows), np.concatenate(self.columns), np.concatenate(self.values)
