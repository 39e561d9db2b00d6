"""What `--components` tells: every way of taking a configuration space apart, each within its part of the time.

Mobility --four-bars: motions; Singular: configuration_space; parallel axes: pose_modes;
           numerical_components; sampled_modes, with_zero_parameters--> words, JSON
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from symscrew.mobility.algebraic_branches import with_components
from symscrew.mobility.analysis import Mobility
from symscrew.mobility.assembly_ways import judged_modes
from symscrew.mobility.components import (
    AllowedTime,
    PoseModes,
    configuration_space,
    mode_lines,
    mode_values,
    numerical_components,
    numerical_lines,
    numerical_values,
    pose_lines,
    pose_modes,
    pose_values,
    sampled_modes,
    space_lines,
    space_values,
    with_zero_parameters,
    zero_lines,
    zero_values,
)
from symscrew.mobility.motions import component_lines, component_values, components_of

ALGEBRA, NUMBERS = 1 / 5, 4 / 15
"""Parts of the time for exact algebra and for the numerical decomposition; what is left is for given coordinates."""
KEPT = 2 / 15
"""Part of it that is left for configurations with zero parameters."""
SHORTLY = 1 / 15
"""Part of it for both where modes are known: wholes that are decomposed at all then take a second or two."""
MODES = 1 / 6
"""Part of it for modes with parallel axes, which are soon found or not at all."""
NO_FORMS = "operation modes not told apart: where a screw joint moves, no polynomials in Study's parameters need vanish"
"""Random poses of one smooth curve showed another number of quadrics from each start, and counted as several modes."""
Parts = tuple[list[str], dict[str, Any]]
"""Components in words and as JSON values."""


def studied_components(found: Mobility, allowed: AllowedTime) -> tuple[Mobility, Parts]:
    """(the result with what components prove of its branches, the components in words and as JSON values).

    Four-bars have a way of their own, which needs no program. Modes with parallel axes are soon found: where they are
    known the whole, which rarely ends then, is tried for a shorter time. What exact algebra does not divide is
    decomposed numerically.
    """
    curves = components_of(found.mechanism, found.network)
    if not isinstance(curves, str):
        return found, (component_lines(curves), component_values(curves))
    several = len(found.network.chords) > 1
    modes = _pose_modes(found, allowed) if several else "not decided: one loop"
    space = configuration_space(
        found.mechanism, found.network, allowed.at_most(_part(modes, ALGEBRA) * allowed.seconds)
    )
    if not found.network.chords:
        return found, ([str(space)], {"decided": False, "why": str(space)})
    if not isinstance(space, str) and space.proved:
        return with_components(found, space), (space_lines(space), space_values(space))
    divided, counted = _numerical(found, allowed, modes)
    if not isinstance(space, str):
        parts = [*space_lines(space), *divided], {**space_values(space), "numerical": counted}
        return with_components(found, space), parts
    lines, values = [space, *divided], {"decided": False, "why": space, "numerical": counted}
    if allowed.over():
        lines.append(f"the {allowed.seconds:g} s of the processor are over; --seconds gives more")
    elif isinstance(modes, str) and not several:
        modes = _pose_modes(found, allowed)
    more, more_values = _sampled(found, allowed) if isinstance(modes, str) else _of_poses(found, modes)
    return found, ([*lines, *more], {**values, **more_values})


def _part(modes: PoseModes | str, usual: float) -> float:
    return usual if isinstance(modes, str) else SHORTLY


def _pose_modes(found: Mobility, allowed: AllowedTime) -> PoseModes | str:
    return pose_modes(found.mechanism, found.network, allowed.at_most(MODES * allowed.seconds))


def _numerical(found: Mobility, allowed: AllowedTime, modes: PoseModes | str) -> tuple[list[str], Any]:
    """The numerical decomposition beside the modes that are known, in words and as JSON values."""
    sets = () if isinstance(modes, str) else (*(mode.part for mode in modes.modes), *modes.unseen)
    first = allowed.at_most(_part(modes, NUMBERS) * allowed.seconds)
    over = max(0.0, allowed.left - first - KEPT * allowed.seconds)
    spaces = numerical_components(found.mechanism, found.network, first, over=over, beside=sets)
    return ([spaces], spaces) if isinstance(spaces, str) else (numerical_lines(spaces), numerical_values(spaces))


def _of_poses(found: Mobility, modes: PoseModes) -> Parts:
    """Modes with parallel axes."""
    modes = replace(modes, others=judged_modes(found, modes.others)) if found.in_reference else modes
    return pose_lines(modes), {"pose_modes": pose_values(modes)}


def _sampled(found: Mobility, allowed: AllowedTime) -> Parts:
    """Modes that random configurations show, and those of them that have parameters which are zero."""
    if any(motion.helical for edge in found.network.edges.values() for motion, _ in edge.motions):
        return [NO_FORMS], {"operation_modes": {"decided": False, "why": NO_FORMS}}
    seen = sampled_modes(found.network, found.platform.body)
    seen = judged_modes(found, seen) if found.in_reference else seen
    least = allowed.at_most(ALGEBRA * allowed.seconds)
    held = with_zero_parameters(found.mechanism, found.network, seen, least)
    lines = [*mode_lines(seen), *zero_lines(held)]
    return lines, {"operation_modes": mode_values(seen), "zero_parameters": zero_values(held)}
