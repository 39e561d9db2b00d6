"""Steps of a library's integrator that end where a condition of the slopes changes its sign; see `switches`.

dense output of a step --conditions at nine places--> polynomials --first zero--> where the step should have ended
The compiled loop does the same (`kernels/switches.c`), without SciPy.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.polynomial import Chebyshev

LANDINGS = 8  # takes of a step for one corner: its zero moves by squares, three are usual
CREDIT = 20  # short steps onto corners in a row; then every other step passes them: work stays bounded
SHORT = 0.1  # part of a step below which one onto a corner counts as short
SAMPLES = 9  # of the conditions along a step: its polynomial in time is of degree seven, theirs little higher
TOUCH = 0.03  # of what a condition moves in a step: so near to zero its turning is looked at by a step of its own
ROUNDING = 2e-15  # of a state: what a condition changes by it is no change

Dense = Callable[[float], np.ndarray]


class Corners:
    """Conditions along a run: which of them are zero at the present state, and what is left of the credit."""

    def __init__(self, values: Callable[[float, np.ndarray], np.ndarray], units: np.ndarray) -> None:
        """`values`: conditions (n,) at t and y; `units` (len(y),): sizes of y where it is zero."""
        self.values, self.units = values, units
        self.zero: set[int] = set()
        self._landed: set[int] = set()
        self.credit = CREDIT
        self.unlooked = 0  # steps that the credit was used up for
        self._directions = np.modf(0.618034 * np.arange(1, len(units) + 1))[0] + 0.5
        self._directions[1::2] *= -1

    def end(self, dense: Dense, left: float, right: float, aimed: int | None) -> tuple[float, int | None] | None:
        """Where the step from left to right should have ended, and the condition that is zero there; None: it is good.

        `aimed`: the condition at whose zero it should end. The condition is None where one only turns back close to 0.
        """
        if self.credit <= 0:
            self.unlooked += 1
            return None
        places = 0.5 * (1 - np.cos(np.pi * np.arange(SAMPLES) / (SAMPLES - 1)))
        g = np.array([self.values(left + (right - left) * p, dense(left + (right - left) * p)) for p in places])
        y = dense(right)
        moved = self.values(right, y + 2 * ROUNDING * self._directions * np.maximum(np.abs(y), self.units))
        noise = np.abs(moved - g[-1])
        shortest = 4.5e-16 * max(abs(right), right - left) / (right - left)
        self._landed = set()
        first: tuple[float, int | None] = (2.0, None)
        turning = 2.0
        for k in np.flatnonzero(np.abs(g).max(axis=0) > 4 * noise):
            part = _first_change(places, g[:, k], noise[k], zero=int(k) in self.zero)
            if k == aimed and part > 1:
                part = _zero_at_end(places, g[:, k])
            if abs(part - 1) <= shortest or abs(g[-1, k]) <= noise[k] / 16:
                self._landed.add(int(k))
                continue
            nearest = int(np.abs(g[:, k]).argmin())
            if 8 * shortest < part < (1.5 if k == aimed else 1.0):
                first = min(first, (part, int(k)), key=lambda found: found[0])
            elif k != aimed and 0 < nearest < SAMPLES - 1 and abs(g[nearest, k]) < TOUCH * np.abs(g[:, k]).max():
                turning = min(turning, float(places[nearest]))
        if first[1] is None and turning > 1:
            return None
        part, which = first if first[1] is not None else (turning, None)
        return left + part * (right - left), which

    def accept(self, *, short: bool) -> None:
        """The step that was looked at last stands; `short`: one onto a corner, much shorter than what would pass it."""
        self.zero, self._landed = self._landed, set()
        self.credit = self.credit - 1 if short else min(self.credit + 1, CREDIT)

    def anew(self) -> None:
        """The run goes on from another state."""
        self.zero = set()


def passed(unlooked: float) -> tuple[str, ...]:
    """An event that tells of steps that were not looked at."""
    if not unlooked:
        return ()
    return (
        f"{int(unlooked)} steps may have passed corners of a law of force unseen: these followed each other so closely "
        "(chattering, bounces that come to rest) that not every step could end on one",
    )


def _first_change(places: np.ndarray, values: np.ndarray, noise: float, *, zero: bool) -> float:
    """The first part of the step, behind its start, at which a condition with these values is zero; 2: none."""
    if zero or abs(values[0]) <= noise:  # of what is zero at the start: what is left when this zero is taken out
        polynomial = Chebyshev.fit(places[1:], (values[1:] - values[0]) / places[1:], SAMPLES - 2, domain=[0, 1])
    else:
        polynomial = Chebyshev.fit(places, values, SAMPLES - 1, domain=[0, 1])
    found = polynomial.roots()
    real = np.sort(found.real[(np.abs(found.imag) < 1e-12) & (found.real > 0) & (found.real <= 1)])
    return float(real[0]) if len(real) else 2.0


def _zero_at_end(places: np.ndarray, values: np.ndarray) -> float:
    """The zero near the end of the step; 2: none is."""
    polynomial, part = Chebyshev.fit(places, values, SAMPLES - 1, domain=[0, 1]), 1.0
    slope = polynomial.deriv()
    for _ in range(4):
        rate = slope(part)
        part -= float(polynomial(part) / rate) if rate else 0.0
    return part if abs(part - 1) < 0.25 else 2.0
