"""Zeros led along straight ways of what is held, in steps that are proved.

step --Newton's method at its middle and end--> zeros --Krawczyk's test for all values of it--> one zero in a box
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import held_by_box, held_within
from symscrew.assembly.coupled_columns import Follower
from symscrew.assembly.families import COMPLEX
from symscrew.assembly.joint_angles import CLOSED
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.rectangles import ONE, Rectangle, read
from symscrew.assembly.slot_numbers import Displacements, Scalars

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
    """Zeros led along straight ways of what is held, in steps that are proved.

    `followers`: what couplings settle; values of theirs that are given are not read.
    """

    def __init__(self, equations: BatchEquations, followers: Sequence[Follower] = ()) -> None:
        self.equations, self.followers = equations, followers

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
        return held_within(self.equations, self.over(low, high), z, CLOSED, rows=rows)

    def _zero(self, z: Array, values: Mapping[int, float]) -> Array | None:
        """A zero near z, by Newton's method: a guess, which the box judges."""
        slots = Displacements(self.equations.structure, COMPLEX, self._whole(values, COMPLEX.read)).slots()
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
        return Displacements(self.equations.structure, scalars, self._whole(ways, read)).slots()

    def _whole(self, values: Mapping[int, Any], read_number: Callable[[Any], Any]) -> dict[int, Any]:
        """These values with those that couplings settle from them."""
        whole = dict(values)
        for follower in self.followers:
            whole[follower.column] = follower.value(whole, read_number)
        return whole


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
