"""A way of y over relative time: quintic pieces through places with rates, of which a first guess is made."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Path:
    """y over relative time: piecewise polynomials through `values` (n, d) at `times` (n,).

    The rates there are `slopes` (n, d), the second rates 0.
    """

    times: np.ndarray
    values: np.ndarray
    slopes: np.ndarray

    def __call__(self, tau: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """y, y' and y'' at relative times (n,): quintic pieces without second rates at their ends."""
        k = np.clip(np.searchsorted(self.times, tau, side="right") - 1, 0, len(self.times) - 2)
        h = (self.times[k + 1] - self.times[k])[:, None]
        s = (np.asarray(tau)[:, None] - self.times[k][:, None]) / h
        start, end = self.values[k], self.values[k + 1]
        a, b = self.slopes[k] * h, self.slopes[k + 1] * h
        rise = end - start
        c3, c4, c5 = 10 * rise - 6 * a - 4 * b, -15 * rise + 8 * a + 7 * b, 6 * rise - 3 * (a + b)
        y = start + s * (a + s**2 * (c3 + s * (c4 + s * c5)))
        y_1 = (a + s**2 * (3 * c3 + s * (4 * c4 + s * 5 * c5))) / h
        y_2 = s * (6 * c3 + s * (12 * c4 + s * 20 * c5)) / h**2
        return y, y_1, y_2
