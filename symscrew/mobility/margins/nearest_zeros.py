"""How far a margin's zero is, in displacements of joints: along its gradient, with all loops closed.

    q, margins --closure there--> tangent and least closing step --differences along it--> gradients
               --Newton's method for the margin and the closure at once--> zeros

Every margin is followed by itself, all of them in one batch: two evaluations a step, of which the first gives values,
closure residual and Jacobian together. What is found is checked there by the margin's value and the closure.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from symscrew.algebra import Node
from symscrew.kinematics import System
from symscrew.mobility.margins.three_kinds import Margin

Array = NDArray[np.float64]

STEP = 0.15
"""Longest step in radians or characteristic lengths: Newton's method for the loops closes from there, and no zero that
a machine reaches is jumped over."""
STEPS = 80
"""Evaluations: what is more than four radians away is not near. Close to a zero five steps suffice, as step sizes are
made longer for double and triple ones, each with two or three that close the loops."""
DIFFERENCE = 1e-5
"""Half the step of differences along the tangent: the derivative is right to 1e-10."""
FOUND = 1e-10
"""Of its size over sample states: a margin below it is zero there."""
SHORT = 3e-5
"""Last step in radians or characteristic lengths from which a zero is reached: a simple one is then right to rounding,
a triple one, as of three equal arms that stretch at once and where the margin is 1e-10 already 5e-4 before it, to 1e-5.
"""
SQUARED = 1e-16
"""A sum of squares is followed down to this, as far as it goes, and it has no sign that would change there: doubles do
not tell a rank that is lost from pins 1e-12 out of line."""
LEVEL = 1e-10
"""A gradient below this, of the margin's size, leads nowhere: ten times what rounding leaves of its differences."""
CLOSED = 1e-11
"""Closure residual in characteristic lengths at which the loops count as closed."""
LOOSELY = 1e-2
"""Closure residual above which a step only closes the loops: a step of `STEP` leaves about half its square."""
NEAR = 0.2
"""A margin below this, of its size, is followed with all loops closed: where rank is lost, what closes them is as long
as the step, so that both at once do not converge."""
MANY_ZEROS = ((2.0, 0.2, 0.273), (3.0, 0.273, 0.31))
"""What a whole step leaves of a margin with a double zero is a quarter, with a triple one 8/27: steps are then made so
many times as long, once. With a simple zero it leaves next to nothing."""
LOST = 1.0
"""Closure residual in characteristic lengths from which Newton's method is not expected back."""
IDLE = 8
"""Steps without a tenth less of the margin after which it is followed no more: it has a minimum above zero there, and
Newton's method jumps about it."""
LESS = 0.9
"""What counts as less: see `IDLE`."""
CUT_OFF = 1e-9
"""Relative singular values below this are zero: redundant equations have 1e-16."""


@dataclass(frozen=True)
class Displaced:
    """The configuration where a margin is zero: the coordinate that has moved most, from where by how much.

    Attributes:
        coordinate: its label; a driven one where a drive moves.
        by: displacement [rad or m].
        kind: angle or length.
        value: the margin there, of its size over sample states.
        closure: residual of the loops there, in characteristic lengths.
    """

    coordinate: str
    by: float
    kind: str
    value: float
    closure: float

    @property
    def size(self) -> str:
        """The displacement in degrees or millimetres."""
        return f"{np.degrees(self.by):.4g} deg" if self.kind == "angle" else f"{1000 * self.by:.4g} mm"

    @property
    def words(self) -> str:
        """The coordinate and its displacement."""
        return f"{self.coordinate} displaced by {self.size}"


def find_zeros(system: System, margins: Sequence[Margin], start: Array) -> list[Displaced | None]:
    """For each margin the zero along its gradient from the configuration `start` (nq,); None where none was found."""
    if not margins:
        return []
    sizes = np.array([size_of(system, m, start) for m in margins])
    walks = [_Walk(k, start, 1.0 if m.form == "signed" else 2.0) for k, m in enumerate(margins)]
    for _ in range(STEPS):
        going = [walk for walk in walks if walk.going]
        if not going:
            break
        heres = _looked_at(system, margins, np.array([walk.q for walk in going]))
        for walk, here in zip(going, heres, strict=True):
            walk.judge(here, here.values[walk.margin] / sizes[walk.margin])
        moving = [(walk, here) for walk, here in zip(going, heres, strict=True) if walk.going]
        slopes = _slopes(system, [m.value for m in margins], [(walk.q, here.tangent) for walk, here in moving])
        steps = [
            walk.step(here, slope[:, walk.margin] / sizes[walk.margin])
            for (walk, here), slope in zip(moving, slopes, strict=True)
        ]
        if moving:
            moved = system.advance(np.array([walk.q for walk, _ in moving]), system.scales * np.array(steps))
            for (walk, _), q in zip(moving, moved, strict=True):
                walk.q = q
    ends = [walk.end for walk in walks]
    return [_displaced(system, margins[k], end, (start, sizes[k])) for k, end in enumerate(ends)]


@dataclass(frozen=True)
class _Here:
    """At a configuration: values of all margins, closure residual [lengths], rates that keep or close the loops."""

    values: Array
    residual: float
    tangent: Array
    closing: Array


class _Walk:
    """Where one margin has been followed to, and whether it is followed on."""

    def __init__(self, margin: int, start: Array, double: float) -> None:
        self.margin, self.double, self._once = margin, double, double  # a step twice as long for a double zero
        self.q = start.copy()
        self.target = FOUND if double == 1.0 else SQUARED
        self.end: Array | None = None
        self.going, self.found = True, False
        self._value, self._least, self._idle = np.inf, np.inf, 0
        self._best = np.inf  # the least value with closed loops
        self._stride = np.inf  # the last step towards the zero
        self._before = np.inf  # the value from which a whole step was made; infinite: none was

    def judge(self, here: _Here, value: float) -> None:
        """Whether it has arrived, or goes no further."""
        self._value = value
        closed = here.residual < CLOSED
        self.found = closed and abs(value) < (self.target if self._stride < SHORT else SQUARED)
        if closed and abs(value) < min(FOUND, self._best):
            self.end, self._best = self.q.copy(), abs(value)
        if here.residual < (CLOSED if abs(value) < NEAR else LOOSELY):
            if abs(value) < LESS * self._least:
                self._least, self._idle = abs(value), 0
            else:
                self._idle += 1
        lost = not (np.isfinite(value) and here.residual < LOST)
        self.going = not (self.found or lost or self._idle > IDLE)

    def step(self, here: _Here, slope: Array) -> Array:
        """Rates without unit: towards the margin's zero and towards closed loops."""
        square = float(slope @ slope)
        near = abs(self._value) < NEAR
        if here.residual > (CLOSED if near else LOOSELY):
            return here.closing
        if square < LEVEL**2:
            self.going = False
            return here.closing
        left = self._value / self._before
        if near and self.double == self._once:
            self.double *= next((times for times, least, most in MANY_ZEROS if least < left < most), 1.0)
        step = -self.double * self._value / square * (here.tangent @ slope)
        self._stride = float(np.linalg.norm(step))
        part = min(1.0, STEP / self._stride)
        self._before = self._value if part == 1.0 else np.inf
        step *= part
        return np.asarray(step if near else step + here.closing)


def size_of(system: System, margin: Margin, start: Array) -> float:
    """What the margin is compared with: the largest of its values at the sample states and here."""
    samples = np.abs(np.atleast_1d(system.tape.sample(margin.value)))
    here = abs(float(system.numeric([margin.value], (system.inputs.q, start[None]))[0, 0]))
    usual = float(np.max(samples[np.isfinite(samples)], initial=0.0))
    return max(usual, here) or 1.0


def _looked_at(system: System, margins: Sequence[Margin], q: Array) -> list[_Here]:
    """What each configuration needs to be judged and left, by one evaluation."""
    nodes = [m.value for m in margins]
    count, free = len(nodes), len(system.scales)
    residual = list(system.residual) if system.cuts else []
    closure = list(system.closure.dense()) if system.cuts else []
    found = system.numeric([*nodes, *residual, *closure], (system.inputs.q, q))
    heres = []
    for row in found:
        values, left = row[:count], row[count : count + len(residual)]
        if not residual:
            heres.append(_Here(values, 0.0, np.eye(free), np.zeros(free)))
            continue
        jacobian = row[count + len(residual) :].reshape(-1, free) * system.scales
        if not np.isfinite(row).all():
            heres.append(_Here(values, np.inf, np.zeros((free, 0)), np.zeros(free)))
            continue
        u, s, vt = np.linalg.svd(jacobian)
        rank = int((s > CUT_OFF * s[0]).sum())
        closing = -vt[:rank].T @ ((u[:, :rank].T @ left) / s[:rank])
        heres.append(_Here(values, float(np.abs(left).max()) / max(1.0, system.length), vt[rank:].T, closing))
    return heres


def _slopes(system: System, nodes: Sequence[Node], places: Sequence[tuple[Array, Array]]) -> list[Array]:
    """Derivatives of all nodes along the columns of the tangent at every configuration: (columns, nodes) each."""
    points = [(q, column) for q, tangent in places for column in tangent.T]
    if not points:
        return [np.zeros((0, len(nodes)))] * len(places)
    starts = np.repeat(np.array([q for q, _ in points]), 2, axis=0)
    steps = np.array([sign * DIFFERENCE * system.scales * column for _, column in points for sign in (1, -1)])
    values = system.numeric(nodes, (system.inputs.q, system.advance(starts, steps)))
    rates = (values[0::2] - values[1::2]) / (2 * DIFFERENCE)
    ends = np.cumsum([tangent.shape[1] for _, tangent in places])
    return [rates[end - tangent.shape[1] : end] for end, (_, tangent) in zip(ends, places, strict=True)]


def _residual(system: System, q: Array) -> float:
    """Closure residual in characteristic lengths."""
    if not system.cuts:
        return 0.0
    return float(np.abs(system.numeric(system.residual, (system.inputs.q, q[None]))).max() / max(1.0, system.length))


def _displaced(system: System, margin: Margin, end: Array | None, scale: tuple[Array, float]) -> Displaced | None:
    start, size = scale
    if end is None:
        return None
    driven = {system.tree.v[k].label for k in system.drive_rows()}
    moves = []
    for k, coordinate in enumerate(system.tree.q):
        if coordinate.kind in ("angle", "length"):
            by = float(end[k] - start[k])
            unit = system.length if coordinate.kind == "length" else 1.0
            moves.append((coordinate.label in driven and abs(by) > FOUND * unit, abs(by) / unit, coordinate, by))
    if not moves:
        return None
    _, _, coordinate, by = max(moves, key=lambda move: move[:2])
    value = float(system.numeric([margin.value], (system.inputs.q, end[None]))[0, 0]) / size
    return Displaced(coordinate.label, by, coordinate.kind, float(abs(value)), _residual(system, end))
