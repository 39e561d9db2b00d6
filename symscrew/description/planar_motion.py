"""Whether all bodies of a mechanism move in parallel planes, so that only one of their moments of inertia counts."""

from __future__ import annotations

from collections.abc import Sequence

import mpmath

from symscrew.description.joints import Motion
from symscrew.description.mechanism import Mechanism

ACROSS = 1e-12
"""Sine or cosine of the angle of axes below which they are parallel or at right angles: axes of 13 digits are."""

_CONTEXT = mpmath.mp.clone()
_CONTEXT.dps = 50  # digits, as in the validation


def planar_normal(mechanism: Mechanism) -> tuple[mpmath.mpf, ...] | None:
    """The unit normal that all rotations are about and all translations across; None where a joint leaves the plane."""
    turning: list[list[mpmath.mpf]] = []
    sliding: list[list[mpmath.mpf]] = []
    for joint in mechanism.joints.values():
        kind = joint.kind
        if kind.spherical or kind.helical:
            return None
        for motion in kind.motions:
            if motion.fixed or (len(joint.axes) == 1 < kind.freedom and motion.prismatic and len(kind.sliding) == 2):
                continue  # translations of a planar joint are across its axis
            axis = joint.axes[_index(motion, len(joint.axes))]
            values = [_CONTEXT.mpf(str(mechanism.number(c).evalf(_CONTEXT.dps))) for c in axis]
            (turning if motion.turns else sliding).append(values)
    if not turning:
        return None
    normal = turning[0]
    parallel = all(abs(abs(_dot(normal, axis)) - 1) < ACROSS for axis in turning)
    return tuple(normal) if parallel and all(abs(_dot(normal, axis)) < ACROSS for axis in sliding) else None


def _index(motion: Motion, given: int) -> int:
    return (motion.axis or 0) if given > 1 else 0


def _dot(a: Sequence[mpmath.mpf], b: Sequence[mpmath.mpf]) -> mpmath.mpf:
    return _CONTEXT.fdot(a, b)
