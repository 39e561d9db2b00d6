"""Components on all of which a joint rests at the one angle where its variable has no value: found in other charts.

    t = tan(angle / 2 - where it is zero) / |w|: no value half a turn from there

A component is missed in a chart only if one of its joints rests at the angle which that chart lacks for it. A joint
rests at one angle and every chart lacks another one, so that a component missed in each of n + 1 charts would have
n + 1 joints at rest, one more than have such variables: n charts beside the first show all that the first one lacks.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import isfinite

from symscrew.description import Mechanism
from symscrew.mobility.components.algebraic_closure import closure_equations
from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.closure_parts import CHARTS, ClosureEquations, Length
from symscrew.mobility.components.component_parts import Part
from symscrew.mobility.components.exact_parts import exact_parts
from symscrew.mobility.components.real_configurations import resting_angles, turning
from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols import exact_value

SAME = 1e-9
"""Relative difference of tangents, of which both are exact numbers in doubles, that are the same."""
HeldPart = tuple[Part, ClosureEquations]
"""A component with the equations in whose variables it is."""


def held_components(
    mechanism: Mechanism, network: Network, closure: ClosureEquations, seconds: float
) -> list[HeldPart] | None:
    """The components that the closure's own chart lacks; None where that is not decided in so many seconds."""
    allowed = AllowedTime(seconds)
    places = [k for k, length in enumerate(closure.lengths) if turning(length)]
    if len(places) >= len(CHARTS):
        return None
    found: dict[tuple[object, ...], list[HeldPart]] = {}
    for chart in range(1, len(places) + 1):
        other = closure_equations(mechanism, network, chart)
        exact = exact_parts(other, allowed.left)
        if not exact.complete or not all(part.irreducible for part in exact.parts):
            return None
        here: dict[tuple[object, ...], list[HeldPart]] = {}
        for part in exact.parts:
            rests = _rests(part, other)
            lacked = {k: t for k, t in rests.items() if _same(t, _lacked(closure.lengths[k]))}
            if lacked:
                angles = resting_angles(closure, network)
                held = tuple(angle for k, angle in zip(places, angles, strict=True) if k in lacked)
                shown = tuple(e for e in part.equations if "t" not in e)
                key = (part.dimension, *((k, f"{t:.9g}") for k, t in sorted(rests.items())))
                here.setdefault(key, []).append((replace(part, held=held, equations=shown), other))
        for key, parts in here.items():  # who rests at the same angles is lacked by the same charts
            found.setdefault(key, parts)
    return [pair for parts in found.values() for pair in parts]


def _rests(part: Part, closure: ClosureEquations) -> Mapping[int, float]:
    """Variable that is the same all over the part -> tangent of half the joint's angle over |w|, from the reference.

    Numbers of the field only, as those are that charts lack: each is then an equation of the reduced basis.
    """
    rests, count = {}, len(closure.variables)
    for polynomial in part.polynomials:
        keys = [key for key in polynomial if any(key)]
        if len(keys) == 1 and sum(keys[0]) == 1 and turning_place(keys[0].index(1), closure):
            k = keys[0].index(1)
            value = -polynomial.get((0,) * count, 0.0) / polynomial[keys[0]]
            zero, square = float(closure.lengths[k].zero or 0), _square(closure.lengths[k])
            below = 1 - value * zero * square
            rests[k] = (value + zero) / below if below else float("inf")
    return rests


def turning_place(k: int, closure: ClosureEquations) -> bool:
    """Whether a variable is the tangent of half a joint's angle."""
    return k < len(closure.lengths) and turning(closure.lengths[k])


def _square(length: Length) -> float:
    return float(sum(exact_value(c) ** 2 for c in length.screw[:3]))


def _lacked(length: Length) -> float:
    """The tangent from the reference that the variable lacks."""
    assert length.zero is not None
    return -1 / (float(length.zero) * _square(length))


def _same(a: float, b: float) -> bool:
    return isfinite(a) and abs(a - b) <= SAME * max(abs(a), abs(b))  # no chart lacks half a turn from the reference
