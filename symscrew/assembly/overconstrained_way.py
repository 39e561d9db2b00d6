"""The zero that the motion through the reference has at other values of what is held, of more equations than unknowns.

    finite mobility, proved --> near the reference all equations are zero along a curve in what is held
    straight way of what is held --Krawczyk's test of as many rows as unknowns--> one zero of these rows in each box

Along a step that zero is an analytic function of what is held, and so is what the rows left out are there. They are
zero along a piece, so that they are zero all along: at the end lies a zero of all equations (identity theorem). Steps
may rest on other rows, as each begins in the zero at which the last one ended. Angles are led by half a turn at most.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import Certificate, Chart
from symscrew.assembly.joint_angles import CLOSED
from symscrew.assembly.proved_way import ProvedWay
from symscrew.assembly.rectangles import middle_of_box
from symscrew.assembly.what_is_held import Held
from symscrew.mobility import analyse_mobility

Array = np.ndarray[Any, Any]

ROUNDED = 1e-14
"""How far values in doubles, and turned back by whole turns, may be from what is held."""


class _Way(ProvedWay):
    """Steps that rest on some rows each."""

    def rows(self, over: Sequence[Any], z: Array) -> Sequence[int]:
        """The most independent ones."""
        return independent_rows(self.equations, over, z)

    def begins(self, z: Array, values: Mapping[int, float]) -> bool:
        """Whether rows have one zero at the reference, so that what is held are coordinates of the motion there."""
        return self.holds(z, values, rows=self.rows(self.over(values, values), z))


def independent_rows(equations: BatchEquations, slots: Sequence[Any], z: Array) -> list[int]:
    """As many rows of all as there are coordinates, those that are most independent at z: a part that can be tested.

    Of what they hold nothing is said of the rows that are left out.
    """
    chart = Chart(equations, slots, z)
    coefficients = np.array([middle_of_box(v) for m in chart.numbers() for v in m.ravel()])
    _, slopes = equations.evaluate(chart.middle[None], coefficients[None])
    left, chosen = slopes[0][:, chart.open].real.copy(), list[int]()
    for _ in chart.open:
        sizes = np.linalg.norm(left, axis=1)
        chosen.append(int(sizes.argmax()))
        along = left[chosen[-1]] / (sizes[chosen[-1]] or 1.0)
        left -= np.outer(left @ along, along)
    return sorted(chosen)


def on_the_motion(held: Held, equations: BatchEquations, known: Array) -> Certificate | None:
    """The zero at what is held that the motion through the reference leads to; None where that is not proved.

    Args:
        held: what is held.
        equations: of it, more than unknowns.
        known: the zero of the reference.
    """
    finite = analyse_mobility(held.mechanism).finite
    if finite is None or not (finite.proved and finite.smooth) or finite.dof != len(held.drives):
        return None
    goal = {c: held.off(c, 2 * held.values[c]) for c in held.drives} if not held.followers else dict(held.values)
    way = _Way(equations, held.followers)
    led = way.led(known.real, dict.fromkeys(goal, 0.0), goal)
    if led.reached < 1.0 or not way.holds(led.z, goal, ROUNDED, rows=way.rows(way.over(goal, goal), led.z)):
        return None
    return Certificate(CLOSED, led.z + 0j, "real")
