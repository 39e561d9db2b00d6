"""Time as a transcription divides it: intervals, points inside, and what stands between the points.

mesh (ends of intervals) x nodes of the scheme --> points;    y(tau) = linear in y_k, y'_k and y'' at the points
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.optimisation.problem import Transcription
from symscrew.optimisation.tableau import Tableau
from symscrew.optimisation.unknowns import Terms


@dataclass(frozen=True)
class TimeGrid:
    """`mesh` (n + 1,): ends of the intervals in relative time; `scheme`: the collocation, None for shooting."""

    mesh: np.ndarray
    scheme: Tableau | None

    @property
    def steps(self) -> np.ndarray:
        """Relative lengths of the intervals: (n,)."""
        return np.diff(self.mesh)

    @property
    def point_tau(self) -> np.ndarray:
        """Times of the points at which drives are unknowns: (intervals, points), relative."""
        nodes = self.scheme.nodes if self.scheme else np.zeros(1)  # shooting: at the start of the interval
        return np.asarray(self.mesh[:-1, None] + self.steps[:, None] * nodes)

    def add_interpolated(self, terms: Terms, rows: np.ndarray, tau: float, *, order: int) -> None:
        """Add y (order 0) or y' (order 1) at a relative time to `rows` (d,) of a linear map."""
        index, scheme = terms.unknowns.index, self.scheme
        if tau <= 0.0 or tau >= 1.0:
            terms.add(rows, index["y" if order == 0 else "y_1"][0 if tau <= 0.0 else -1])
            return
        assert scheme is not None  # shooting refuses conditions inside
        k = min(int(np.searchsorted(self.mesh, tau, side="right")) - 1, len(self.steps) - 1)
        h = self.steps[k]
        s = np.array([(tau - self.mesh[k]) / h])
        if order == 0:
            terms.add(rows, index["y"][k])
            terms.add(rows, index["y_1"][k], h * s[0])
            factors = h**2 * scheme.position_at(s)[0]
        else:
            terms.add(rows, index["y_1"][k])
            factors = h * scheme.rate_at(s)[0]
        for j, factor in enumerate(factors):
            terms.add(rows, index["y_2"][k, j], factor)


def mesh_of(given: Transcription) -> np.ndarray:
    """Ends of the intervals as parts of the duration, 0 and 1 included."""
    if not given.mesh:
        return np.linspace(0.0, 1.0, given.intervals + 1)
    if abs(given.mesh[-1] - 1.0) > 1e-12 or given.mesh[0] <= 0:  # what dividing a duration into parts may round
        raise DescriptionError("transcription.mesh: expected ends of intervals above 0, the last one 1")
    return np.array([0.0, *given.mesh])
