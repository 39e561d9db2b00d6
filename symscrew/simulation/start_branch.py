"""Whether rates at the start, or behind an impact, belong to a motion: in a singular configuration the closure's first
order does not say.

Rates with J v = 0 go on into a motion only if accelerations follow, J a = -(dJ/dt) v: whatever combination of rows is
zero in J, the same combination of (dJ/dt) v has to be zero. In regular configurations of a mechanism this holds of all
rates; where branches cross it holds of the rates of each branch and of no sum of two.
"""

from __future__ import annotations

import numpy as np

from symscrew.simulation.asked_closure import Closure
from symscrew.simulation.state_programs import Plant

# Singular values of the closure, parts of the largest, below which a combination of rows counts as zero. A singular
# configuration is reached to about the root of rounding, 1e-8; above, accelerations are finite.
LOST = 1e-7
# What such a combination leaves of (dJ/dt) v, without units and divided by the square of the largest rate, above which
# the rates are of no branch: a sum of two branches leaves about 1, rounding less than 1e-8.
OPENS = 1e-6


def leaves_every_branch(jacobian: np.ndarray, bias: np.ndarray, rates: np.ndarray) -> bool:
    """Whether no accelerations keep the loops closed.

    Args:
        jacobian: of the closure (rows, freedoms), without units.
        bias: (dJ/dt) v (rows,), without units.
        rates: v (freedoms,) [rad/s, characteristic lengths per s].
    """
    size = float(np.abs(rates).max(initial=0.0))
    if not size or not jacobian.size:
        return False
    left, values, _ = np.linalg.svd(jacobian, full_matrices=True)
    kept = int((values > LOST * values.max(initial=0.0)).sum())
    return bool(np.abs(left[:, kept:].T @ bias).max(initial=0.0) > OPENS * size * size)


def impact_leaves_every_branch(plant: Plant, q: np.ndarray, v: np.ndarray) -> bool:
    """The same of rates v (nv,) behind an impact at q (nq,): its law knows the first order alone."""
    if plant.closure is None:
        return False
    closure, p = Closure(plant.model), [plant.parameters[None]] if len(plant.parameters) else []
    ((_, jacobian),) = closure.at(q[None], *p)
    (bias,) = closure.bias(q[None], v[None], *p)
    return leaves_every_branch(jacobian, bias, v / closure.units)


OF_NO_BRANCH = (
    "the stop is met in a singular configuration, where branches of the motion meet: what the law of impact leaves of "
    "the rates belongs to none of them"
)
