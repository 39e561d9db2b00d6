"""How far a margin's zero is, in displacements of joints: along its gradient, with all loops closed.

    q, margins --tangent of the closure, differences along it--> gradients --Newton's method, loops closed--> zeros

Every margin is followed by itself, all of them in one batch. What is found is checked there: the margin's value and
the closure of the loops are evaluated at the end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from symscrew.kinematics import System
from symscrew.mobility.margins.three_kinds import Margin

Array = NDArray[np.float64]

STEP = 0.15
"""Longest step in radians or characteristic lengths: Newton's method for the loops closes from there, and no zero that
a machine reaches is jumped over."""
STEPS = 30
"""Steps: what is more than four radians away is not near; close to a zero five suffice, as step sizes are doubled for
double ones."""
DIFFERENCE = 1e-5
"""Half the step of differences along the tangent: the derivative is right to 1e-10."""
FOUND = 1e-10
"""Of its size over sample states: a margin below it is zero there. The coordinates are then right to 1e-5 even where it
has a double zero."""
LEVEL = 1e-9
"""A gradient below this, of the margin's size, leads nowhere."""
CLOSED = 1e-11
"""Closure residual in characteristic lengths at which the loops count as closed."""
CLOSINGS = 8
"""Steps of Newton's method that close the loops again: two or three from a regular configuration."""
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
    nodes = [m.value for m in margins]
    sizes = np.array([size_of(system, m, start) for m in margins])
    double = np.array([1.0 if m.form == "signed" else 2.0 for m in margins])
    q = np.repeat(start[None], len(margins), axis=0)
    active = list(range(len(margins)))
    found: dict[int, Array] = {}
    for _ in range(STEPS):
        if not active:
            break
        values = system.numeric(nodes, (system.inputs.q, q[active]))
        now = {i: values[row, i] / sizes[i] for row, i in enumerate(active)}
        for i in active:
            if abs(now[i]) < FOUND:
                found[i] = q[i].copy()
        active = [i for i in active if i not in found]
        tangents = _tangents(system, q[active]) if active else []
        slopes = _slopes(system, nodes, q[active], tangents) if active else []
        moved = []
        for row, i in enumerate(active):
            slope = slopes[row][:, i] / sizes[i]
            square = float(slope @ slope)
            if square < LEVEL**2:
                continue
            step = -double[i] * now[i] / square * (tangents[row] @ slope)
            length = float(np.linalg.norm(step))
            q[i] = system.advance(q[[i]], (system.scales * step * min(1.0, STEP / length))[None])[0]
            moved.append(i)
        closed = _closed(system, q[moved]) if moved else np.zeros((0, q.shape[1]))
        active = []
        for row, i in enumerate(moved):
            if np.isfinite(closed[row]).all():
                q[i] = closed[row]
                active.append(i)
    return [_displaced(system, margins[i], found.get(i), (start, sizes[i])) for i in range(len(margins))]


def size_of(system: System, margin: Margin, start: Array) -> float:
    """What the margin is compared with: the largest of its values at the sample states and here."""
    samples = np.abs(np.atleast_1d(system.tape.sample(margin.value)))
    here = abs(float(system.numeric([margin.value], (system.inputs.q, start[None]))[0, 0]))
    usual = float(np.max(samples[np.isfinite(samples)], initial=0.0))
    return max(usual, here) or 1.0


def _jacobians(system: System, q: Array) -> Array:
    """Closure over rates without unit, N x rows x nv."""
    count = len(system.scales)
    found = system.numeric(system.closure.dense(), (system.inputs.q, q))
    return np.asarray(found.reshape(len(q), -1, count) * system.scales)


def _tangents(system: System, q: Array) -> list[Array]:
    """Orthonormal motions that keep the loops closed, without unit, as columns, at every configuration."""
    count = len(system.scales)
    if not system.cuts:
        return [np.eye(count)] * len(q)
    bases = []
    for jacobian in _jacobians(system, q):
        _, s, vt = np.linalg.svd(jacobian)
        bases.append(vt[int((s > CUT_OFF * s[0]).sum()) :].T)
    return bases


def _slopes(system: System, nodes: Sequence[object], q: Array, tangents: Sequence[Array]) -> list[Array]:
    """Derivatives of all nodes along the columns of each tangent: (columns, nodes) for every configuration."""
    points: list[tuple[Array, Array]] = []
    places: list[int] = []
    for here, tangent in zip(q, tangents, strict=True):
        places.append(len(points))
        for column in tangent.T:
            for sign in (1, -1):
                points.append((here, sign * DIFFERENCE * system.scales * column))
    if not points:
        return [np.zeros((0, len(nodes)))] * len(q)
    moved = system.advance(np.array([p for p, _ in points]), np.array([s for _, s in points]))
    values = system.numeric(nodes, (system.inputs.q, moved))  # type: ignore[arg-type]
    rates = (values[0::2] - values[1::2]) / (2 * DIFFERENCE)
    return [rates[p // 2 : p // 2 + t.shape[1]] for p, t in zip(places, tangents, strict=True)]


def _residuals(system: System, q: Array) -> Array:
    """Closure residual in characteristic lengths, N."""
    if not system.cuts:
        return np.zeros(len(q))
    found = np.abs(system.numeric(system.residual, (system.inputs.q, q))).max(axis=1)
    return np.asarray(found / max(1.0, system.length))


def _closed(system: System, q: Array) -> Array:
    """The configurations with loops closed, by the least change; not numbers where they do not close."""
    if not system.cuts:
        return q
    q = q.copy()
    for _ in range(CLOSINGS):
        if (_residuals(system, q) < CLOSED).all():
            return q
        residuals = system.numeric(system.residual, (system.inputs.q, q))
        steps = [
            np.linalg.lstsq(j, -r, rcond=CUT_OFF)[0] for j, r in zip(_jacobians(system, q), residuals, strict=True)
        ]
        q = system.advance(q, np.array(steps) * system.scales)
    q[~(_residuals(system, q) < CLOSED)] = np.nan
    return q


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
    return Displaced(coordinate.label, by, coordinate.kind, float(abs(value)), float(_residuals(system, end[None])[0]))
