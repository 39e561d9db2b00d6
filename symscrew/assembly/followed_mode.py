"""A mode led along a motion of what is held, in steps of which each is proved to stay on its branch.

    zero at the start, values --Krawczyk's test over a step, values as intervals--> box that holds one zero all along it

A step is taken only if for every value between its ends one zero, and a regular one, lies in the box, and if the zeros
at its ends, each proved to lie where it is, are in the box: then it is led on, and nothing is jumped over. Where steps
get too short a singularity is near, and the mode is refused.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.assembly.all_modes import AssemblyModes
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import ONE, Rectangle, held_by_box, held_within, read
from symscrew.assembly.families import COMPLEX
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
SLACK = 8.0
"""A box reaches farther than its ends by as many times `CLOSED`: scaled by a coordinate of half the size and more, what
lies within `CLOSED` of an end lies in it."""
NEWTON = 8
"""Steps to the zero in the middle of a step: from a zero as near three are enough."""
CONVERGED = 1e-14
"""A step below which no other one follows: rounding of coordinates of size 1."""


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
    led = ProvedWay(found.family.equations).led(mode.z.real, start, goal)
    refused = "" if led.reached == 1.0 else "no shorter step is proved to stay on the branch: a singularity is near"
    values = between(start, goal, led.reached)
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


def between(start: Mapping[int, float], goal: Mapping[int, float], s: float) -> dict[int, float]:
    """What is held at a part of the way."""
    return dict(goal) if s == 1.0 else {c: a + s * (goal[c] - a) for c, a in start.items()}


@dataclass(frozen=True)
class Led:
    """The zero (width,) that was come to, at which part of the way, in how many steps."""

    z: Array
    reached: float
    steps: int


class ProvedWay:
    """Zeros led along straight ways of what is held, in steps that are proved."""

    def __init__(self, equations: BatchEquations) -> None:
        self.equations = equations

    def led(self, z: Array, start: Mapping[int, float], goal: Mapping[int, float]) -> Led:
        """Step by step, as far as that is proved."""
        at, step, steps = 0.0, FIRST, 0
        if not self.begins(z, start):
            return Led(z, at, steps)
        while at < 1.0:
            end = min(1.0, at + step)
            after = self._stepped(z, between(start, goal, at), between(start, goal, end))
            if after is not None:
                z, at, step, steps = after, end, 2 * (end - at), steps + 1
                continue
            step = (end - at) / 2
            if step < SHORTEST:
                break
        return Led(z, at, steps)

    def _stepped(self, z: Array, start: Mapping[int, float], end: Mapping[int, float]) -> Array | None:
        """The zero at the end of a step that is proved, or None."""
        middle = self._zero(z, between(start, end, 0.5))
        after = self._zero(z, end)
        if middle is None or after is None:
            return None
        ends, over = (z, middle, after), self.over(start, end)
        rows = self.rows(over, middle)
        whole = held_by_box(self.equations, over, middle, ends=ends, past=SLACK * CLOSED, rows=rows)
        return after if whole and self.holds(after, end, rows=rows) else None

    def begins(self, z: Array, values: Mapping[int, float]) -> bool:
        """Whether a zero is proved to lie within `CLOSED` of z."""
        return self.holds(z, values)

    def rows(self, over: Sequence[Any], z: Array) -> Sequence[int] | None:
        """Rows that a step rests on; None: all."""
        return None

    def holds(
        self, z: Array, values: Mapping[int, float], give: float = 0.0, rows: Sequence[int] | None = None
    ) -> bool:
        """Whether a zero is proved to lie within `CLOSED` of z: then it is the one in each box that reaches past it.

        It is one for all values that differ by no more than `give`.
        """
        low, high = ({c: v + sign * give for c, v in values.items()} for sign in (-1, 1))
        return held_within(self.equations, self.over(low, high), z, CLOSED, rows)

    def _zero(self, z: Array, values: Mapping[int, float]) -> Array | None:
        """A zero near z, by Newton's method: a guess, which the box judges."""
        slots = Displacements(self.equations.structure, COMPLEX, values).slots()
        c, there, tracker = self.equations.coefficients(slots)[None], z[None] + 0j, Tracker(self.equations)
        for _ in range(NEWTON):
            step = tracker.newton(there, c)
            there = there + step
            if np.abs(step).max() < CONVERGED:
                break
        return np.asarray(there[0].real) if np.isfinite(there).all() else None

    def over(self, start: Mapping[int, float], end: Mapping[int, float]) -> list[Any]:
        """The numbers in the slots for all values of a step, as rectangles."""
        ways = {c: _hull(start[c], end[c]) for c in start}
        scalars = Scalars(lambda v: _bounded(CONTEXT.cos, v), lambda v: _bounded(CONTEXT.sin, v), read)
        return Displacements(self.equations.structure, scalars, ways).slots()


def _hull(one: float, two: float) -> Rectangle:
    """All numbers between two doubles."""
    a, b = read(CONTEXT.mpf(min(one, two))), read(CONTEXT.mpf(max(one, two)))
    return Rectangle((a.real[0], b.real[1]))


def _bounded(function: Any, value: Rectangle) -> Rectangle:
    """Cosine or sine of an interval: at its middle, give or take half its width."""
    low, high = value.real
    half = (high - low) // 2 + 1
    middle = read(function(CONTEXT.mpf((low + high) // 2) / ONE) + 2)  # never read as an exact zero
    return Rectangle((middle.real[0] - 2 * ONE - half, middle.real[1] - 2 * ONE + half))
