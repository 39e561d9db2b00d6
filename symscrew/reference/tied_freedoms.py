"""Couplings of coordinates for method B: which freedoms a coupling acts on, and with what ratio.

states of the bodies --joint_displacements--> x --p'(x)--> slopes: a unit of the coupling is slope_j on freedom j
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symscrew.description import slope
from symscrew.reference.joint_motion import displacements_of
from symscrew.reference.maximal_coordinates import Array, BodyState, NumericMechanism


@dataclass(frozen=True)
class TiedFreedoms:
    """Freedoms that couplings act on with their joints, and slopes (states, couplings, freedoms)."""

    freedoms: tuple[int, ...]
    joints: tuple[int, ...]
    slopes: Array


def tied_freedoms(numbers: NumericMechanism, whole: BodyState) -> TiedFreedoms:
    """Of the couplings at stacked states; each is divided by its first slope in the reference configuration."""
    mechanism = numbers.mechanism
    places: dict[tuple[str, int], int] = {}
    for coupling in mechanism.couplings.values():
        for term in coupling.terms:
            places.setdefault((term.joint, term.motion), len(places))
    owners = [numbers.joints.index(joint) for joint, _ in places]
    freedoms = [
        int(numbers.freedoms[j][mechanism.joints[joint].kind.starts[k]])
        for j, (joint, k) in zip(owners, places, strict=True)
    ]
    slopes = np.zeros((len(whole.translation), len(mechanism.couplings), len(places)))
    for c, coupling in enumerate(mechanism.couplings.values()):
        units = (float(mechanism.number(slope(mechanism, term))) for term in coupling.terms)
        unit = next(value for value in units if value)
        for term in coupling.terms:
            numbers_of = [float(mechanism.number(value)) for value in term.coefficients]
            at = displacements_of(numbers, whole, term.joint)[..., term.motion] if not coupling.linear else 0.0
            value = sum(k * factor * at ** (k - 1) for k, factor in enumerate(numbers_of, start=1))
            slopes[:, c, places[term.joint, term.motion]] += value / unit
    return TiedFreedoms(tuple(freedoms), tuple(owners), slopes)
