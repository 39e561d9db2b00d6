"""The configuration that a result is about: what was given and what all other coordinates are there."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from symscrew.kinematics import BODY_PARTS, coordinate_units

if TYPE_CHECKING:
    from symscrew.mobility.analysis import Mobility

STILL = 1e-12
"""A coordinate [rad, m] below this is shown as 0: what 60 digits leave of one that does not move is far below."""


def place_lines(found: Mobility) -> list[str]:
    """A displaced configuration in words, lengths in mm and angles in degrees; none for the reference."""
    if found.in_reference or found.reached is None:
        return []
    units, platform = coordinate_units(found.mechanism), found.mechanism.platform
    shown = {n: quantity(v, units[n]) for n, v in found.reached.values.items()}
    lines = [f"given: {found.configuration.removeprefix('at ')}; all others follow, from the reference configuration"]
    own = f"{platform}."
    joints = {name: text for name, text in shown.items() if not name.startswith(own)}
    lines.append("joints: " + ", ".join(f"{name} = {text}" for name, text in joints.items()))
    if platform is not None:
        lines.append(f"{platform}: " + ", ".join(f"{part} = {shown[own + part]}" for part in _parts(shown, own)))
    return lines


def _parts(shown: Mapping[str, str], own: str) -> list[str]:
    return [part for part in BODY_PARTS if own + part in shown]


def place_values(found: Mobility) -> dict[str, Any]:
    """Every coordinate by name, in SI units and as it is shown."""
    if found.reached is None:
        return {}
    units = coordinate_units(found.mechanism)
    return {
        name: {"value": 0.0 if abs(v) < STILL else v, "unit": units[name], "shown": quantity(v, units[name])}
        for name, v in found.reached.values.items()
    }


def quantity(value: float, unit: str) -> str:
    """A value as it can be typed again, to six digits: lengths in mm, angles in degrees.

    >>> quantity(0.05, "m"), quantity(-0.5235987755982988, "rad")
    ('50mm', '-30deg')
    """
    if abs(value) < STILL:
        return "0"
    if unit == "m":
        return f"{value * 1000:.6g}mm"
    return f"{math.degrees(value):.6g}deg" if unit == "rad" else f"{value:.6g}"
