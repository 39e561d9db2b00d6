"""Special geometry that is a double zero of its conditions: pins in a line, similar platforms.

    conditions that linear steps bring no nearer to zero --double_directions--> directions in which they vanish twice
    these directions --vertex--> the step to where the conditions have no slope along them

Conditions that vanish twice, such as c (w . z)^2 = 0, have no slope where they hold, so that Gauss-Newton leaves w . z
as it was typed and stalls at its square: three parallel cranks with their pins in line close to first order on a plate
of another size, too. The slope of such conditions a little aside shows w, and where it vanishes, they do.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from symscrew.mobility.finite.variety import Array

ASIDE = 1e-4
"""How far aside slopes are taken, in units of the mechanism's size: their differences lose four of the sixteen digits
of doubles, and what is of third order cancels between the two sides."""
LOOKS = 3
"""Random directions in which slopes are looked at: each shows all but what it happens to be perpendicular to."""
SLOPES = 1e-7
"""Slopes below this part of the largest are rounding: 1e-12 over `ASIDE` and less, 1e-10 of two Bennett loops about one
axis. Their least real one is 3e-6: what two such loops of one shape have in common shows late on a motion."""
LEAST_REACH = 1e-18
"""Shortest step with which slopes are measured in 60 digits: values have 1e-58 of rounding, so the slope 1e-40, and
what is of third order adds 1e-36."""
REACH = 10.0
"""Slopes are measured that many times as far as the zero is believed to be."""
SEED = 20
"""Directions are drawn at random, the same ones in every run."""


@dataclass(frozen=True)
class Conditions:
    """Conditions on numbers z about the present ones, with their own unknowns solved for.

    `slopes(dz)`: their Jacobian at z + dz in doubles, rows in the basis that they have at dz = 0; `values(dz)`: what is
    left of them there, from residuals in 60 digits; `cut`: relative singular values of the Jacobian that are rounding.
    """

    slopes: Callable[[Array], Array]
    values: Callable[[Array], Array]
    cut: float


@dataclass(frozen=True)
class Doubled:
    """Directions, z x p, along which conditions vanish twice; `across`: rows that keep what linear steps leave of them.

    `curvature`: p x p x rows: second derivatives along the directions.
    """

    directions: Array
    across: Array
    curvature: Array


def double_directions(conditions: Conditions, most: int) -> tuple[Doubled | None, int]:
    """(the directions in which what linear steps cannot make vanish is curved, how many of `most` slopes are left).

    None where it is not; with fewer than no slopes left, it is not known.
    """
    matrix = conditions.slopes(np.zeros(0))
    u, s, vt = np.linalg.svd(matrix)
    rank = int((s > conditions.cut * s[0]).sum())
    kernel, across = vt[rank:].T, u[:, rank:].T
    if not kernel.size or not across.size:
        return None, most

    def bent(direction: Array) -> Array:
        """d(slopes along the kernel)/d(direction) of what linear steps leave: rows x kernel."""
        ahead, behind = (conditions.slopes(side * ASIDE * direction) for side in (1, -1))
        return np.asarray(across @ (ahead - behind) @ kernel / (2 * ASIDE))

    random = np.random.default_rng(SEED)
    looks = random.normal(size=(LOOKS, kernel.shape[1]))
    seen = np.concatenate([bent(kernel @ (look / np.linalg.norm(look))) for look in looks])
    sizes, rows = np.linalg.svd(seen, full_matrices=False)[1:]
    found = rows[sizes > SLOPES * max(1.0, sizes[0])]
    left = most - 2 * (LOOKS + len(found))
    if not len(found) or left < 0:
        return None, left
    directions = kernel @ found.T
    curvature = np.array([(bent(d) @ found.T).T for d in directions.T])
    return Doubled(directions, across, curvature), left


def vertex(conditions: Conditions, doubled: Doubled, believed: float) -> Array:
    """The step z to where the conditions have no slope along the directions; `believed`: about how far that is."""
    reach = max(LEAST_REACH, REACH * believed)
    slopes = []
    for direction in doubled.directions.T:
        ahead, behind = (conditions.values(side * reach * direction) for side in (1, -1))
        slopes.append(doubled.across @ (ahead - behind) / (2 * reach))
    count = len(slopes)
    # curvature[k, j] is the change along k of the slope along j: all of them are to vanish
    matrix = doubled.curvature.transpose(1, 2, 0).reshape(-1, count)
    return np.asarray(doubled.directions @ -np.linalg.lstsq(matrix, np.concatenate(slopes), rcond=SLOPES)[0])
