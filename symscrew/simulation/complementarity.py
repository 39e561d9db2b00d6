"""Forces and impulses of several contacts at one instant: each within its bounds, and what it moves not against it.

answers to unit forces, what moves without any, bounds --active sets--> forces
"""

from __future__ import annotations

import numpy as np

# Sets of contacts inside their bounds that are tried per contact; each is better than the one before, so that few are
# met twice.
MOST_SETS = 10
# Rates below the first part of the largest are rounding of it; a solution whose rates are off by more than the second
# is none. Between: contacts that depend on each other leave what their least squares cut off.
ROUNDING, OBEYED = 1e-13, 1e-9
# Part of the largest singular value of contacts' accelerations by forces under which contacts that act on the same
# freedom share their force (least squares) instead of being solved one by one.
SHARED = 1e-12


class UndecidedError(ArithmeticError):
    """Forces or impulses that obey their law were not found; the message says by how much they fail."""


def complementary(
    gain: np.ndarray, offset: np.ndarray, *, low: np.ndarray | None = None, high: np.ndarray | None = None
) -> np.ndarray:
    """p (n,) with low <= p <= high and w = gain p + offset: w >= 0 where p = low, <= 0 where p = high, else 0.

    That is the least of p gain p/2 + offset p within the bounds, for a symmetric gain (n, n) that has no negative
    eigenvalues, by the active sets of Lawson and Hanson (Solving Least Squares Problems, 1974, chapter 23), each
    contact in units of its own answer to a unit force. Impulses only push: low = 0 and no high by default. 0 is within
    the bounds.

    Raises:
        UndecidedError: what was found does not obey these conditions.
    """
    count = len(offset)
    answers = np.sqrt(np.maximum(np.diag(gain), 0.0))
    units = np.where(answers > 0, answers, 1.0)  # a contact that its own force does not move answers nothing
    gain, offset = gain / np.outer(units, units), offset / units
    least = np.zeros(count) if low is None else low * units
    most = np.full(count, np.inf) if high is None else high * units
    p, inside = np.zeros(count), (least < 0) & (most > 0)
    largest = float(np.abs(offset).max(initial=0.0))
    for _ in range(MOST_SETS * (count + 1)):
        while inside.any():
            trial = np.array(p)
            pushed = offset[inside] + gain[np.ix_(inside, ~inside)] @ p[~inside]
            trial[inside] = np.linalg.lstsq(gain[np.ix_(inside, inside)], -pushed, rcond=SHARED)[0]
            bound = np.clip(trial, least, most)
            beyond = bound != trial
            if not beyond.any():
                p = trial
                break
            parts = (bound[beyond] - p[beyond]) / (trial[beyond] - p[beyond])
            hit = np.flatnonzero(beyond)[parts <= parts.min()]
            p = np.clip(p + parts.min() * (trial - p), least, most)
            p[hit] = bound[hit]
            inside &= (p > least) & (p < most)
        wrong = _wrong(gain @ p + offset, p, least, most)
        wrong[inside] = 0.0
        if not (wrong > ROUNDING * largest).any():
            break
        inside[np.argmax(wrong)] = True
    off = float(_wrong(gain @ p + offset, p, least, most).max(initial=0.0))
    if not off <= OBEYED * largest:
        what = "impulses" if low is None else "forces"
        raise UndecidedError(
            f"the {what} of {count} contacts that act at one instant were not found: "
            f"what they move is {off / largest:.2g} of the largest off what their laws ask for"
        )
    return p / units


def _wrong(w: np.ndarray, p: np.ndarray, least: np.ndarray, most: np.ndarray) -> np.ndarray:
    """By how much each w breaks its condition."""
    low, high = p <= least, p >= most
    return np.where(low & high, 0.0, np.where(low, -w, np.where(high, w, np.abs(w))))
