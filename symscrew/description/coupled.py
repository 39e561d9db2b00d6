"""Couplings of a description: which coordinates they relate, and what is no coupling.

    [couplings.NAME]
    terms = { wheel = 1, pinion = 3, "drive.1" = ["0.5", "0.01"] }    # wheel + 3 pinion + x/2 + x^2/100 stays

A term names a coordinate (`joint`, or `joint.k` for the k-th motion of a joint with several) and gives its factor, or
the coefficients of its first, second ... power. The sum stays what it is in the reference configuration.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy

from symscrew.description.expressions import numeric
from symscrew.description.mechanism import CoupledTerm, Coupling, Joint, Mechanism
from symscrew.description.reader import Reader
from symscrew.errors import DescriptionError, did_you_mean, shorten

MOST_POWERS = 8
"""Powers of a coordinate in a coupling: files of robots have four, and each adds two operations to every function."""


def read_coupling(reader: Reader, name: str, terms: Any, joints: Mapping[str, Joint]) -> Coupling:
    """The coupling that a description gives by its terms; raises DescriptionError."""
    where = f"couplings.{name}.terms"
    if not isinstance(terms, Mapping) or not terms:
        raise DescriptionError(f"{where}: expected coordinates with their factors, got {shorten(terms)}")
    known = {label: (joint, k) for joint in joints.values() for k, label in enumerate(_labels(joint))}
    made = []
    for label, value in terms.items():
        if label not in known:
            raise DescriptionError(f"{where}: there is no coordinate {shorten(label)}; {did_you_mean(label, known)}")
        joint, k = known[label]
        if not joint.kind.motions[k].single:
            raise DescriptionError(f"{where}: {label!r} turns about a point: it has no coordinate that can be coupled")
        listed = value if isinstance(value, Sequence) and not isinstance(value, str) else [value]
        if not 0 < len(listed) <= MOST_POWERS:
            raise DescriptionError(f"{where}: expected 1 to {MOST_POWERS} coefficients of {label}, got {len(listed)}")
        numbers = [reader.number(v, f"{where}.{label}[{i}]") for i, v in enumerate(listed)]
        while numbers and numbers[-1] == 0:
            numbers.pop()
        if not numbers:
            raise DescriptionError(f"{where}: the factor of {label!r} is 0; leave the coordinate out")
        made.append(CoupledTerm(joint.name, k, tuple(numbers)))
    return Coupling(name, tuple(made))


def _labels(joint: Joint) -> list[str]:
    return joint.kind.motion_names(joint.name)


def terms_of(coupling: Coupling, joints: Mapping[str, Joint]) -> dict[str, tuple[Any, ...]]:
    """Coordinate -> its coefficients: what `read_coupling` reads."""
    return {_labels(joints[t.joint])[t.motion]: t.coefficients for t in coupling.terms}


def check_couplings(mechanism: Mechanism) -> None:
    """Raise DescriptionError for a coupling that holds a coordinate still, or that does not change at the reference."""
    for coupling in mechanism.couplings.values():
        where = f"couplings.{coupling.name}"
        if coupling.name in mechanism.joints:
            raise DescriptionError(f"{where}: a joint has this name; couplings and joints need different ones")
        slopes = [abs(numeric(mechanism.number(slope(mechanism, term)), where=where)) for term in coupling.terms]
        if not max(slopes) > 0:
            raise DescriptionError(
                f"{where}: all its slopes are 0 in the reference configuration, where it ties no coordinate to another"
            )


def slope(mechanism: Mechanism, term: CoupledTerm) -> sympy.Expr:
    """What a term changes by per unit of its coordinate, in the reference configuration."""
    given = mechanism.joints[term.joint].reference
    at = given[term.motion] if term.motion < len(given) else sympy.S.Zero
    return sympy.Add(*(k * c * at ** (k - 1) for k, c in enumerate(term.coefficients, start=1)))
