"""Interleaved repeats and their quartiles."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass

import numpy as np


@dataclass(frozen=True)
class Times:
    """Least, quartiles and median of repeated measurements, in the unit of the measurement."""

    least: float
    lower: float
    median: float
    upper: float
    repeats: int

    @property
    def text(self) -> str:
        """The median with the quartiles."""
        return f"{self.median:.3g} ({self.lower:.3g} ... {self.upper:.3g})"

    def as_json(self) -> dict[str, float]:
        """Plain numbers."""
        return asdict(self)


def interleaved(measures: Mapping[str, Callable[[], float]], repeats: int) -> dict[str, Times]:
    """A B C A B C ...: one value of each measure per round, so that a disturbance meets all of them."""
    values: dict[str, list[float]] = {name: [] for name in measures}
    for _ in range(repeats):
        for name, measure in measures.items():
            values[name].append(measure())
    return {name: quartiles(found) for name, found in values.items()}


def quartiles(values: Sequence[float]) -> Times:
    """Summary of measurements."""
    least, lower, median, upper = np.percentile(values, [0, 25, 50, 75])
    return Times(float(least), float(lower), float(median), float(upper), len(values))
