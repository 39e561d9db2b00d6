"""Which modes are reached from which without a singularity: closed ways of what is held, every step proved.

    modes --road map over the configurations (mobility)--> ways from mode to mode: a guess
    values of what is held along a way --followed_mode, step by step--> witness, from one certified zero to the other
    determinants of opposite sign, limbs held alike --> a singularity on every way

A platform can go from mode to mode without a singularity around a cusp. (C. Innocenti, V. Parenti-Castelli, 1992.)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

import numpy as np

from symscrew.assembly.all_modes import AssemblyMode, AssemblyModes
from symscrew.assembly.followed_mode import shown
from symscrew.assembly.joint_angles import CLOSED
from symscrew.assembly.mode_signs import LOCKED
from symscrew.assembly.modes_c import held_modes_model
from symscrew.assembly.modes_library import CompiledModes, own_compiled_modes
from symscrew.assembly.proved_way import Led, ProvedWay
from symscrew.assembly.what_is_held import held_by
from symscrew.errors import DescriptionError
from symscrew.mobility import regular_ways
from symscrew.runtime import CompileError

Array = np.ndarray[Any, Any]
Corners = tuple[Mapping[str, float], ...]
Proved = dict[tuple[str, str], Corners]

CONNECTED, SEPARATED, UNDECIDED = "connected", "separated", "not found"
GROWTH = (2, 1)
"""Of how many points of the road map's way one straight piece passes, from piece to piece: straight pieces far from the
way may lead to another mode, so that it is followed point by point where the first attempt fails."""
NODES = 120
"""Random configurations of the road map: the planar platform with six modes in two pieces needs more than sixty."""
ROUNDING = 1e-12
"""Of what is held after whole turns: the double of a value and a turn is off by a ten-thousandth of it."""


@dataclass(frozen=True)
class Connection:
    """Of two modes: "connected", "separated" or "not found".

    `way`: values of what is held [rad, m], straight from one to the next, from `one` to `two`: a witness.
    """

    one: str
    two: str
    judgement: str
    way: Corners = field(default=(), repr=False)


def reachable_modes(
    found: AssemblyModes, *, search: bool = True, progress: Callable[[str], None] = lambda _: None
) -> tuple[Connection, ...]:
    """Of each pair of modes whether a way without a singularity of the closure leads from one to the other.

    "connected": every piece of the way is proved. "separated": a singularity lies on every
    way, as the determinants with the drives locked have opposite signs (of limbs that hold a platform in several ways,
    those of all limbs the same). "not found": neither is known; without `search` nothing was looked for.
    """
    one_way = _held_in_one_way(found)
    judged = {
        (a.name, b.name): Connection(a.name, b.name, SEPARATED if _apart(a, b, one_way) else UNDECIDED)
        for a, b in combinations(found.modes, 2)
    }
    if search and found.family is not None and found.chosen and UNDECIDED in {c.judgement for c in judged.values()}:
        proved = _Proofs(found, progress).connections()
        for one, two in judged:
            if (way := _joined(proved, one, two)) is not None:
                judged[one, two] = Connection(one, two, CONNECTED, way)
    return tuple(judged.values())


def _apart(one: AssemblyMode, two: AssemblyMode, one_way: bool) -> bool:
    """Whether the signs of two modes say that a singularity lies on every way between them.

    Where limbs hold a platform in several ways, only if those that are looked at have limbs of the same signs.
    """
    limbs = [{name: sign for name, sign in m.signs.items() if name != LOCKED} for m in (one, two)]
    signs = {m.signs.get(LOCKED, "0") for m in (one, two)}
    return signs == {"+", "-"} and (one_way or (limbs[0] == limbs[1] and "0" not in limbs[0].values()))


def _held_in_one_way(found: AssemblyModes) -> bool:
    """Whether displacements of all joints follow from a zero: universal joints and legs that slide have two."""
    if found.family is None:
        return True
    structure = found.family.equations.structure
    return not structure.open_limbs and all(run.kind != "hook" for run in structure.graph.runs)


class _Proofs:
    """Ways of the road map, led again along straight pieces of what is held."""

    def __init__(self, found: AssemblyModes, progress: Callable[[str], None]) -> None:
        assert found.family is not None
        self.found, self.progress = found, progress
        self.modes: Sequence[AssemblyMode] = [
            m for m in found.modes if m.certified and m.meeting == 1 and m.q is not None
        ]
        self.equations = found.family.equations
        self.steps = ProvedWay(self.equations, found.followers)
        self.compiled = _compiled(found, self.steps)
        motions = [(m, start) for e in found.network.edges.values() for m, start in e.motions]
        self.drives = [c for c in found.chosen if c not in {f.column for f in found.followers}]
        turning = [c for c in self.drives if any(m.revolute and start == c for m, start in motions)]
        self.turning = [] if found.followers else turning  # a whole turn of a wheel leaves others elsewhere

    def connections(self) -> Proved:
        """(first mode, other) -> (values of what is held along the way, steps)."""
        self.progress("road map over the configurations")
        points = [m.q for m in self.modes if m.q is not None]
        ways = regular_ways(self.found.network, self.drives, points, NODES) if len(points) > 1 else {}
        proved: Proved = {}
        for (one, two), q in ways.items():
            first, last = self.modes[one], self.modes[two]
            self.progress(f"a way from {first.name} to {last.name}, {len(proved)} of {len(ways)} are proved")
            if (corners := self._proved(first, last, q)) is not None:
                proved[first.name, last.name] = corners
        return proved

    def _columns(self, q: Array) -> dict[int, float]:
        """What is held; drives beyond those that hold the mechanism stay, no equation has them."""
        return dict(self.found.columns) | {c: float(q[c]) for c in self.drives}

    def _proved(self, one: AssemblyMode, two: AssemblyMode, points: Array) -> Corners | None:
        """The corners of a way that is proved to lead from mode to mode."""
        values = [self._columns(q) for q in points]
        values[0], values[-1] = dict(self.found.columns), self._closing(values[-1])
        if not all(self.steps.holds(m.z.real, v, ROUNDING) for m, v in ((one, values[0]), (two, values[-1]))):
            return None
        for growth in GROWTH:
            z, corners = self._led(one.z.real, values, growth)
            if corners[-1] == len(values) - 1 and self._is(two, z):
                return tuple(shown(self.found, values[k]) for k in corners)
        return None

    def _led(self, z: Array, values: Sequence[dict[int, float]], growth: int) -> tuple[Array, list[int]]:
        """A zero led along the values in pieces that are proved: where to, and the corners that it passed."""
        corners, reach = [0], 1
        while (at := corners[-1]) < len(values) - 1:
            end = min(at + reach, len(values) - 1)
            led = (self.compiled or self.steps).led(z, values[at], values[end])
            if led.reached == 1.0:
                z, reach = led.z, growth * (end - at)
                corners.append(end)
            elif end == at + 1:
                break
            else:
                reach = (end - at) // 2
        return z, corners

    def _is(self, mode: AssemblyMode, z: Array) -> bool:
        """Whether a zero within `CLOSED` of z is the mode's: it lies in the box that holds no other one."""
        places = [part.start + int(np.abs(mode.z[part]).argmax()) for part in self.equations.parts]
        if mode.radius is None or not all(z[place] for place in places):
            return False
        ends = [np.concatenate([c[part] / c[at] for part, at in zip(self.equations.parts, places, strict=True)])
                for c in (mode.z.real, z)]  # fmt: skip
        return float(np.abs(ends[0] - ends[1]).max()) + 2 * CLOSED < mode.radius

    def _closing(self, last: Mapping[int, float]) -> dict[int, float]:
        """What is held at the modes, after as many whole turns as the way made."""
        turns = {c: round((last[c] - self.found.columns[c]) / (2 * np.pi)) for c in self.turning}
        return {c: v + 2 * np.pi * turns.get(c, 0) for c, v in self.found.columns.items()}


class _CompiledWay:
    """Steps proved by the C of the mechanism, in doubles with bounds on all rounding: a thousand times as fast."""

    def __init__(self, compiled: CompiledModes, proof: ProvedWay) -> None:
        self.compiled, self.proof = compiled, proof
        self.model = compiled.model

    def led(self, z: Array, start: Mapping[int, float], goal: Mapping[int, float]) -> Led:
        """A zero that is certified where it is, led on."""
        mode = self.compiled.record()
        for part in self.proof.equations.parts:
            own = z[part] / z[part][np.abs(z[part]).argmax()]
            mode.z[part] = list(own)
        mode.drives[:] = self._drives(start)
        mode.error, mode.certified = CLOSED, 1
        if self.compiled.led(mode, self._drives(goal)) or mode.error > CLOSED:
            return Led(z, 0.0, 0)
        return Led(np.array(mode.z), 1.0, 1)

    def _drives(self, values: Mapping[int, float]) -> list[float]:
        drives = zip(self.model.held.drives, self.model.drives, strict=True)
        return [reference + values[column] * unit for column, (_, reference, unit, _) in drives]


def _compiled(found: AssemblyModes, proof: ProvedWay) -> _CompiledWay | None:
    """None where there is no compiler, or no C of such a mechanism."""
    try:
        held = held_by(found.mechanism, {}, found.held)
        return _CompiledWay(own_compiled_modes(held_modes_model(held)), proof)
    except (CompileError, DescriptionError):
        return None


def _joined(proved: Proved, one: str, two: str) -> Corners | None:
    """A way that is proved, or two by way of the mode that both begin at."""
    both = {**proved, **{(b, a): way[::-1] for (a, b), way in proved.items()}}
    if (one, two) in both:
        return both[one, two]
    return next(((*way, *both[middle, two][1:]) for (a, middle), way in both.items()
                 if a == one and (middle, two) in both), None)  # fmt: skip
