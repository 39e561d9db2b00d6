"""A mode led along a motion of what is held, in steps of which each is proved to stay on its branch.

    zero at the start, values --Krawczyk's test over a step, values as intervals--> box that holds one zero all along it

A step is taken only if for every value between its ends one zero, and a regular one, lies in the box, and if the zeros
at its ends, each proved to lie where it is, are in the box: then it is led on, and nothing is jumped over. Where steps
get too short a singularity is near, and the mode is refused.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.assembly.all_modes import AssemblyModes
from symscrew.assembly.joint_angles import CLOSED, JointAngles
from symscrew.assembly.mode_signs import ModeSigns
from symscrew.assembly.proved_way import ProvedWay, between
from symscrew.assembly.what_is_held import held_by

Array = np.ndarray[Any, Any]


@dataclass(frozen=True)
class FollowedMode:
    """How far a mode was led: `reached` part of the motion (1: all), values there, displacements of all freedoms.

    `q`: None where a limb does not reach it. `smallest`: least singular value of the passive joints' matrix there.
    `refused`: why it was not led on, empty at the end.
    """

    name: str
    reached: float
    held: Mapping[str, float]
    q: Array | None
    residual: float
    steps: int
    smallest: float
    refused: str = ""


def follow_mode(found: AssemblyModes, name: str, drives: Mapping[str, Any]) -> FollowedMode:
    """The mode `name` led straight to other values of what is held [rad, m]; refused where it is not proved to go on.

    Raises:
        DescriptionError: unknown names of drives. KeyError: no mode of this name.
    """
    mode = found.mode(name)
    if found.family is None or not mode.certified:
        return FollowedMode(name, 0.0, found.held, mode.q, mode.residual, 0, mode.smallest, "the mode is not certified")
    given = held_by(found.mechanism, drives, {key: v for key, v in found.held.items() if key not in drives})
    start, goal = dict(found.columns), {c: given.values[c] for c in found.columns}
    led = ProvedWay(found.family.equations, found.followers).led(mode.z.real, start, goal)
    refused = "" if led.reached == 1.0 else "no shorter step is proved to stay on the branch: a singularity is near"
    values = between(start, goal, led.reached)
    for follower in found.followers:
        values[follower.column] = follower.value(values, float)
    q, off = JointAngles(found.family.equations, values, found.network.freedoms).solved(led.z[None])
    reached = off[0] <= CLOSED
    if not reached:
        refused = refused or "joints of a limb do not reach there"
    seen = ModeSigns(found.network, found.mechanism, list(start)).look(q[0])
    gone = shown(found, values)
    return FollowedMode(
        name, led.reached, gone, q[0] if reached else None, seen.residual, led.steps, seen.smallest, refused
    )


def shown(found: AssemblyModes, values: Mapping[int, float]) -> dict[str, float]:
    """Values of what is held [rad, m], as the description counts them."""
    slides = {start for e in found.network.edges.values() for motion, start in e.motions if motion.prismatic}
    sizes = {c: float(found.network.length) if c in slides else 1.0 for c in values}
    return {name: value + (values[c] - found.columns[c]) * sizes[c]
            for (name, value), c in zip(found.held.items(), found.columns, strict=False) if c in values}  # fmt: skip
