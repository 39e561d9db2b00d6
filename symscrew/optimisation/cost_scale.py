"""The size of a cost, by which a solver sees it divided: tolerances are of numbers of size one.

cost at the guess, or where that is next to nothing what unknowns of typical size make of it --> a power of ten
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

# A cost at the guess below this says nothing on its size: guesses at rest have none. What motions of typical size cost
# does: that of a mechanism of a millimetre may be 1e-12, and all motions would be best of it as it stands.
LEAST_COST = 1e-6
DRAWN = 4  # motions beside the guess
NOTHING = 1e-200  # a cost that no motion has: it stays as it is


def cost_scale(cost: Callable[[np.ndarray], float], start: np.ndarray) -> float:
    """A power of ten near the cost at the guess `start` (scaled unknowns), or near others' where that is nothing."""
    at_start = cost(start)
    value = abs(at_start)
    if not (np.isfinite(value) and value > LEAST_COST):
        random = np.random.default_rng(1)
        others = [abs(cost(start + random.uniform(-1.0, 1.0, len(start))) - at_start) for _ in range(DRAWN)]
        value = min(max((v for v in others if np.isfinite(v)), default=1.0), 1.0)
    return 10.0 ** round(float(np.log10(value))) if value > NOTHING else 1.0
