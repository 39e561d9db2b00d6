"""Where a limb's screws become dependent beside the conditions that are listed: found by looking.

    screws in the reference --displaced--> 6 x n --Newton's method for a rank less, from many starts--> places

A common factor of all minors is what one condition says. Minors without a common factor may vanish together where
several conditions hold at once: axes of a folded limb that fall into one line, say. These places are sought in doubles;
that one was found is so, that none was found is no proof.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy

Array = np.ndarray[Any, Any]

STARTS, STEPS = 24, 24
"""Starts, drawn at random, and steps of each: Newton's method is quadratic, or halves the distance at a double zero."""
SEED = 1905
"""Of the starts: always the same, so that results repeat."""
LONGEST = 0.5
"""A step in radians or sizes of the limb: beyond, slopes say nothing."""
DIFFERENCE = 1e-6
"""Half the step of differences: slopes are right to nine digits."""
LOST = 1e-9
"""Singular value of the screws, of the largest, that is zero: half the digits where it is a double zero."""
ON = 1e-6
"""Value of a listed condition, of what it usually has, below which a place is on it."""
FAR = 2.0
"""Sizes of the limb beyond which a slider is not looked for."""


def place_of_loss(
    screws: Array, displaced: Sequence[tuple[int, float, sympy.Symbol]], listed: Sequence[sympy.Expr], size: float
) -> dict[sympy.Symbol, float] | None:
    """The place nearest to the reference at which rank is lost and nothing listed is zero; None: none was found.

    Args:
        screws: of the limb in the reference from base to tip, n x 6, lengths over `size` [m].
        displaced: (index of the screw, sense, its symbol) of the displaced freedoms.
        listed: the conditions that are known, in these symbols alone: zero there.
        size: of the limb [m].
    """
    symbols = [symbol for *_, symbol in displaced]
    turning = np.array([bool(np.any(screws[k, :3])) for k, *_ in displaced])
    random = np.random.default_rng(SEED)
    starts = random.uniform(-1, 1, (STARTS, len(displaced))) * np.where(turning, np.pi, FAR)
    rank = int((np.linalg.svd(_chain(screws, displaced, starts), compute_uv=False) > LOST).sum(axis=1).max())
    found = _newton(screws, displaced, starts, rank)
    found = np.where(turning, (found + np.pi) % (2 * np.pi) - np.pi, found)
    found = found[(np.abs(found) < np.where(turning, 4, FAR)).all(axis=1)]
    for expression in listed:
        value = sympy.lambdify(symbols, expression, "numpy")
        units = np.where(turning, 1.0, size)
        at = [np.abs(np.broadcast_to(value(*(units * q).T), len(q))) for q in (found, starts)]
        found = found[at[0] > ON * np.median(at[1])]
    if not len(found):
        return None
    nearest = found[np.linalg.norm(found, axis=1).argmin()]
    return dict(zip(symbols, (nearest * np.where(turning, 1.0, size)).tolist(), strict=True))


def _newton(screws: Array, displaced: Sequence[tuple[int, float, sympy.Symbol]], q: Array, rank: int) -> Array:
    """Those of the starts from which a place with a rank less was found, there."""
    if not rank:
        return q[:0]
    shifts = DIFFERENCE * np.eye(q.shape[1])
    for _ in range(STEPS):
        u, _, vt = np.linalg.svd(_chain(screws, displaced, q))
        left, right = u[:, :, rank - 1 :], np.swapaxes(vt, 1, 2)[:, :, rank - 1 :]

        def seen(place: Array, left: Array = left, right: Array = right) -> Array:
            return (np.swapaxes(left, 1, 2) @ _chain(screws, displaced, place) @ right).reshape(len(place), -1)

        slopes = np.stack([(seen(q + d) - seen(q - d)) / (2 * DIFFERENCE) for d in shifts], axis=2)
        step = (np.linalg.pinv(slopes, rcond=LOST) @ seen(q)[:, :, None])[:, :, 0]
        q = q - step * np.minimum(1, LONGEST / np.maximum(np.linalg.norm(step, axis=1), LONGEST))[:, None]
    values = np.linalg.svd(_chain(screws, displaced, q), compute_uv=False)
    return q[values[:, rank - 1] < LOST * values[:, 0]]


def _chain(screws: Array, displaced: Sequence[tuple[int, float, sympy.Symbol]], q: Array) -> Array:
    """Screws of the limb at displacements (N, k): N x 6 x n."""
    carried = np.broadcast_to(np.eye(6), (len(q), 6, 6))
    amounts = {k: sense * q[:, i] for i, (k, sense, _) in enumerate(displaced)}
    columns = []
    for k, screw in enumerate(screws):
        columns.append(carried @ screw)
        if k in amounts:
            carried = carried @ _carrier(screw, amounts[k])
    return np.stack(columns, axis=2)


def _carrier(screw: Array, amounts: Array) -> Array:
    """What carries a twist (omega ; v) by exp(amount screw) of a unit screw without pitch, or of a slide: N x 6 x 6."""
    turn, slide = (np.cross(np.eye(3), part) for part in (screw[:3], screw[3:]))
    hat = np.block([[turn, np.zeros((3, 3))], [slide, turn]])
    a = amounts[:, None, None]
    if not screw[:3].any():
        return np.asarray(np.eye(6) + a * hat)
    # of ad: ad^5 + 2 ad^3 + ad = 0 for a unit axis without pitch
    s, c = np.sin(a), np.cos(a)
    square = hat @ hat
    return np.asarray(
        np.eye(6) + (3 * s - a * c) / 2 * hat + (4 - 4 * c - a * s) / 2 * square
        + (s - a * c) / 2 * square @ hat + (2 - 2 * c - a * s) / 2 * square @ square
    )  # fmt: skip
