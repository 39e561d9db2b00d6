"""Limbs that are another limb turned about z, or about (1, 1, 1): said once, with the angle.

mechanism --points and axes of two limbs, at two values of the parameters--> angle, or none
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import sympy

from symscrew.paper_formulas.limb_formulas import Freedom
from symscrew.paper_formulas.named_lengths import Lengths

Array = np.ndarray
SAME = 1e-9  # [m or 1] of points and axes that count as the same: doubles leave 1e-16, other limbs differ by far more
DEGREE = 180 / np.pi
THIRD = 2 * np.pi / 3  # of a turn
UPRIGHT, DIAGONAL = sympy.Matrix([0, 0, 1]), sympy.Matrix([1, 1, 1])


class Turned(NamedTuple):
    """The angle [degrees] from the first limb of a family, and the sign of each freedom's axis.

    About z; if `diagonal` about (1, 1, 1), as x, y and z follow each other in an Orthoglide.
    """

    angle: float
    signs: tuple[int, ...]
    diagonal: bool = False


def turned_by(first: Sequence[Freedom], other: Sequence[Freedom], lengths: Lengths) -> Turned | None:
    """What takes the first limb to the other one, or None; axes may point the other way."""
    if [(f.turns, f.spherical) for f in first] != [(f.turns, f.spherical) for f in other]:
        return None
    angle = _angle(*(_numbers(limb, lengths, UPRIGHT, other=False)[0] for limb in (first, other)))
    ways = [] if angle is None else [(angle, False)]
    for angle, diagonal in (*ways, (THIRD, True), (2 * THIRD, True)):
        signs = _signs(first, other, lengths, angle, diagonal=diagonal)
        if signs is not None:
            return Turned(angle * DEGREE, signs, diagonal)
    return None


def _signs(
    first: Sequence[Freedom], other: Sequence[Freedom], lengths: Lengths, angle: float, *, diagonal: bool
) -> tuple[int, ...] | None:
    """Signs of the other limb's axes beside those of the first one turned; None where it is no such limb."""
    signs = None
    if diagonal:  # x goes to y, y to z, z to x, once or twice
        turn, axis = np.roll(np.eye(3), round(angle / THIRD), axis=1), DIAGONAL
    else:
        c, s = np.cos(angle), np.sin(angle)
        turn, axis = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]), UPRIGHT
    for elsewhere in (False, True):
        one, two = (_numbers(limb, lengths, axis, other=elsewhere) for limb in (first, other))
        if np.abs(one[0] @ turn - two[0]).max() > SAME:
            return None
        along = one[1] @ turn
        seen = np.where((along * two[1]).sum(axis=1) < 0, -1, 1)
        signs = seen if signs is None else signs
        if (signs != seen).any() or np.abs(along * seen[:, None] - two[1]).max(initial=0.0) > SAME:
            return None
    return None if signs is None else tuple(int(sign) for sign in signs)


def _numbers(limb: Sequence[Freedom], lengths: Lengths, axis: sympy.Matrix, *, other: bool) -> tuple[Array, Array]:
    """Points and axes of a limb, a row each; a spherical joint has the `axis` of the turn."""

    def rows(vectors: Sequence[sympy.Matrix]) -> Array:
        return np.array([[lengths.number(entry, other=other) for entry in vector] for vector in vectors])

    return rows([f.point for f in limb]), rows([axis if f.spherical else f.axis for f in limb])


def _angle(one: Array, two: Array) -> float | None:
    """The angle between the first vectors that are off z."""
    for a, b in zip(one, two, strict=True):
        if np.hypot(*a[:2]) > SAME:
            if np.hypot(*b[:2]) < SAME:
                return None
            return float(np.arctan2(b[1], b[0]) - np.arctan2(a[1], a[0]))
    return 0.0


def families(limbs: Sequence[Sequence[Freedom] | str], lengths: Lengths) -> list[dict[int, Turned]]:
    """Indices of limbs with their angles from the first of each family, in the order of the description."""
    found: list[dict[int, Turned]] = []
    for k, limb in enumerate(limbs):
        for family in found:
            first = limbs[next(iter(family))]
            if not isinstance(limb, str) and not isinstance(first, str):
                turned = turned_by(first, limb, lengths)
                others = list(family.values())[1:]  # a family turns about one axis
                if turned is not None and all(turned.diagonal == other.diagonal for other in others):
                    family[k] = turned
                    break
        else:
            found.append({k: Turned(0.0, ())})
    return found
