"""Limbs that are another limb turned about z: said once, with the angle.

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


class Turned(NamedTuple):
    """The angle [degrees] about z from the first limb of a family, and the sign of each freedom's axis."""

    angle: float
    signs: tuple[int, ...]


def turned_by(first: Sequence[Freedom], other: Sequence[Freedom], lengths: Lengths) -> Turned | None:
    """What takes the first limb to the other one, or None; axes may point the other way."""
    if [(f.turns, f.spherical) for f in first] != [(f.turns, f.spherical) for f in other]:
        return None
    angle, signs = None, None
    for elsewhere in (False, True):
        one, two = (_numbers(limb, lengths, other=elsewhere) for limb in (first, other))
        if angle is None:
            angle = _angle(one[0], two[0])
        if angle is None:
            return None
        c, s = np.cos(angle), np.sin(angle)
        turn = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        if np.abs(one[0] @ turn - two[0]).max() > SAME:
            return None
        along = one[1] @ turn
        seen = np.where((along * two[1]).sum(axis=1) < 0, -1, 1)
        signs = seen if signs is None else signs
        if (signs != seen).any() or np.abs(along * seen[:, None] - two[1]).max(initial=0.0) > SAME:
            return None
    assert angle is not None and signs is not None
    return Turned(float(angle) * DEGREE, tuple(int(sign) for sign in signs))


def _numbers(limb: Sequence[Freedom], lengths: Lengths, *, other: bool) -> tuple[Array, Array]:
    """Points and axes of a limb, a row each; a spherical joint has z for an axis, whatever the turn."""

    def rows(vectors: Sequence[sympy.Matrix]) -> Array:
        return np.array([[lengths.number(entry, other=other) for entry in vector] for vector in vectors])

    upright = sympy.Matrix([0, 0, 1])
    return rows([f.point for f in limb]), rows([upright if f.spherical else f.axis for f in limb])


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
                if turned is not None:
                    family[k] = turned
                    break
        else:
            found.append({k: Turned(0.0, ())})
    return found
