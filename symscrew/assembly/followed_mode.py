"""A mode led along a motion of what is held, in steps of which each is proved to stay on its branch.

    zero at the start, values --Krawczyk's test over a step, values as intervals--> box that holds one zero all along it

A step is taken only if for every value between its ends one zero, and a regular one, lies in the box, and if the zero
before it lies in the box: then it is led on, and nothing is jumped over. Where steps get too short a singularity is
near, and the mode is refused.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.assembly.all_modes import AssemblyModes
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import ONE, Rectangle, held_by_box, read
from symscrew.assembly.families import COMPLEX, Family
from symscrew.assembly.joint_angles import CLOSED, JointAngles
from symscrew.assembly.mode_signs import ModeSigns
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.slot_numbers import Displacements, Scalars
from symscrew.assembly.what_is_held import held_by

Array = np.ndarray[Any, Any]

FIRST = 0.1
"""Part of the motion of the first step; shorter ones follow where it is not proved."""
SHORTEST = 1e-4
"""Part of the motion below which it is refused: a singularity is about as near."""
WIDE = 1.5
"""Least box of a step over the way of the zero in it, so that its ends lie inside."""
NEWTON = 8
"""Steps to the zero in the middle of a step: from a zero as near three are enough."""


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
    goal = held_by(found.mechanism, drives, {key: v for key, v in found.held.items() if key not in drives})
    return _Following(found, mode.z, {c: goal.values[c] for c in found.columns}).followed(name)


class _Following:
    def __init__(self, found: AssemblyModes, z: Array, goal: Mapping[int, float]) -> None:
        assert found.family is not None
        self.found, self.z = found, np.real(z)
        self.family: Family = found.family
        self.equations: BatchEquations = found.family.equations
        self.start, self.goal = dict(found.columns), dict(goal)

    def followed(self, name: str) -> FollowedMode:
        """Step by step."""
        at, step, steps, refused = 0.0, FIRST, 0, ""
        while at < 1.0:
            end = min(1.0, at + step)
            after = self._stepped(at, end)
            if after is not None:
                self.z, at, step, steps = after, end, 2 * (end - at), steps + 1
                continue
            step = (end - at) / 2
            if step < SHORTEST:
                refused = "no shorter step is proved to stay on the branch: a singularity is near"
                break
        q, off = JointAngles(self.equations, self._values(at), self.found.network.freedoms).solved(self.z[None])
        reached = off[0] <= CLOSED
        if not reached:
            refused = refused or "joints of a limb do not reach there"
        seen = ModeSigns(self.found.network, self.found.mechanism, list(self.start)).look(q[0])
        gone = {label: a + at * (b - a) for label, a, b in self._shown()}
        return FollowedMode(name, at, gone, q[0] if reached else None, seen.residual, steps, seen.smallest, refused)

    def _shown(self) -> list[tuple[str, float, float]]:
        """(name, value at the start, at the end) of what is held, as the description counts them."""
        names = list(self.found.held)
        unit = [self.found.held[n] for n in names]
        moved = dict(zip(names, self.start, strict=False))
        sizes = {n: self._size(c) for n, c in moved.items()}
        return [(n, v, v + (self.goal[moved[n]] - self.start[moved[n]]) * sizes[n])
                for n, v in zip(names, unit, strict=True)]  # fmt: skip

    def _size(self, column: int) -> float:
        """Metres or radians of a unit of a column."""
        edges = self.found.network.edges.values()
        slides = any(m.prismatic and start == column for e in edges for m, start in e.motions)
        return float(self.found.network.length) if slides else 1.0

    def _values(self, s: float) -> dict[int, float]:
        return {c: a + s * (self.goal[c] - a) for c, a in self.start.items()}

    def _stepped(self, start: float, end: float) -> Array | None:
        """The zero at the end of a step that is proved, or None."""
        middle = self._zero((start + end) / 2)
        after = self._zero(end)
        if middle is None or after is None:
            return None
        places = [part.start + int(np.abs(middle[part]).argmax()) for part in self.equations.parts]
        ends = [self._fixed(z, places) for z in (self.z, middle, after)]
        radius = WIDE * max(float(np.abs(z - ends[1]).max()) for z in (ends[0], ends[2])) + CLOSED
        return after if held_by_box(self.equations, self._over(start, end), ends[1], radius) else None

    def _fixed(self, z: Array, places: list[int]) -> Array:
        result = z.copy()
        for part, place in zip(self.equations.parts, places, strict=True):
            result[part] = z[part] / z[place]
        return result

    def _zero(self, s: float) -> Array | None:
        """A zero near the last one, by Newton's method: a guess, which the box judges."""
        slots = Displacements(self.equations.structure, COMPLEX, self._values(s)).slots()
        c, z, tracker = self.equations.coefficients(slots)[None], self.z[None] + 0j, Tracker(self.equations)
        for _ in range(NEWTON):
            z = z + tracker.newton(z, c)
        return np.asarray(z[0].real) if np.isfinite(z).all() else None

    def _over(self, start: float, end: float) -> list[Any]:
        """The numbers in the slots for all values of a step, as rectangles."""
        one, two = self._values(start), self._values(end)
        ways = {c: _between(one[c], two[c]) for c in one}
        scalars = Scalars(lambda v: _bounded(CONTEXT.cos, v), lambda v: _bounded(CONTEXT.sin, v), read)
        return Displacements(self.equations.structure, scalars, ways).slots()


def _between(one: float, two: float) -> Rectangle:
    """All numbers between two doubles."""
    a, b = read(CONTEXT.mpf(min(one, two))), read(CONTEXT.mpf(max(one, two)))
    return Rectangle((a.real[0], b.real[1]))


def _bounded(function: Any, value: Rectangle) -> Rectangle:
    """Cosine or sine of an interval: at its middle, give or take half its width."""
    low, high = value.real
    half = (high - low) // 2 + 1
    middle = read(function(CONTEXT.mpf((low + high) // 2) / ONE) + 2)  # never read as an exact zero
    return Rectangle((middle.real[0] - 2 * ONE - half, middle.real[1] - 2 * ONE + half))
