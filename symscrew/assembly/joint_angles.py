"""Displacements of all joints from where the clusters are: those of the tree read off, those of rods and cuts solved.

    zero z --products of motions--> displacement of every cluster --held displacements--> poses of bodies
    joints between bodies with a pose --Newton from some starts, for all zeros at once--> displacements nearest to none

A limb may have several ways to hold the same bodies (a universal joint has two), or none: then it does not reach them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.closure_structure import Structure
from symscrew.assembly.dual_forms import MOVED, PRODUCT, TURNED
from symscrew.assembly.elementary_graph import Edge, Run
from symscrew.assembly.families import COMPLEX
from symscrew.assembly.linked_columns import in_whole_turns
from symscrew.assembly.slot_numbers import Displacements, matrices

Array = np.ndarray[Any, Any]
Pose = tuple[Array, Array]

STARTS = 24
"""Of each limb: the reference, and random ones; a leg's universal joint takes one in three."""
NEWTON = 40
"""Steps from a start."""
CLOSED = 1e-9
"""What a limb may be off its ends where it counts as reaching them; rounding is 1e-15, singular limbs keep half."""
DIFFERENCE = 1e-7
"""For derivatives of chains: half the digits, which Newton's method makes up for."""
CUT_OFF = 1e-7
"""Relative singular values below this are left out: idle spins have none."""
FAR = 1e6
"""Added to the size of displacements that miss what is held: any other way comes first."""
SEED = 20231009
"""Of the starts: always the same, so that results repeat."""


@dataclass(frozen=True)
class Step:
    """An elementary motion of a chain: its edge in the structure's frame, the sense, its value where it is held."""

    kind: str
    axis: Array
    point: Array
    sign: int
    columns: tuple[int, ...]
    value: float | None


class JointAngles:
    """Displacements of joints for zeros of a structure with these values of what is held."""

    def __init__(self, equations: BatchEquations, values: Mapping[int, float], columns: int) -> None:
        self.equations, self.values, self.columns = equations, values, columns
        self.structure: Structure = equations.structure
        found = Displacements(self.structure, COMPLEX, values)
        self.inside = {b: (np.real(np.array(r, dtype=complex)), np.real(np.array(t, dtype=complex)))
                       for b, (r, t) in found.poses.items()}  # fmt: skip
        self.motions = [np.real(m.astype(complex)) for m in matrices(self.structure, found.slots())[0]]

    def clusters(self, zeros: Array) -> dict[str, Pose]:
        """Displacements N x (3 x 3, 3) of the clusters against the ground, in the frame, sizes of the mechanism."""
        poses: dict[str, Pose] = {}
        for cluster, chain in self.structure.chains.items():
            g = np.tile(np.eye(8)[0], (len(zeros), 1))
            for k in chain:
                g = np.einsum("kij,ni,nj->nk", PRODUCT, g, zeros[:, self.equations.parts[k]] @ self.motions[k].T)
            size = (g[:, :4] ** 2).sum(axis=1)
            turn = np.einsum("klij,ni,nj->nkl", TURNED, g, g) / (2 * size[:, None, None])
            poses[cluster] = turn, np.einsum("kij,ni,nj->nk", MOVED, g, g) / (2 * size[:, None])
        return poses

    def bodies(self, zeros: Array) -> dict[str, Pose]:
        """Displacements of the bodies of all clusters that have coordinates."""
        clusters, graph = self.clusters(zeros), self.structure.graph
        return {
            body: after(clusters[home], self.inside[body]) for body, home in graph.cluster.items() if home in clusters
        }

    def solved(self, zeros: Array) -> tuple[Array, Array]:
        """(displacements N x columns, worst opening of a limb: below `CLOSED` where all limbs reach)."""
        q, off = np.zeros((len(zeros), self.columns)), np.zeros(len(zeros))
        for column, value in self.values.items():
            if column < self.columns:  # of a joint
                q[:, column] = value
        bodies, graph = self.bodies(zeros), self.structure.graph
        rods = {rod.cluster: rod for rod in self.structure.rods}
        chains = [self._through(rod.runs) for rod in rods.values()]
        chains += [self._through(limb) for limb in self.structure.open_limbs]
        inside = {e for rod in rods.values() for run in rod.runs for e in run.edges}
        inside |= {e for limb in self.structure.open_limbs for run in limb for e in run.edges}
        chains += [self._through((run,)) for run in graph.runs if not set(run.edges) & inside]
        for near, far, steps in chains:
            goal = after(inverse(bodies[near]), bodies[far])
            columns = [c for step in steps if step.value is None for c in step.columns]
            held = np.array([self.values.get(c, np.nan) for c in columns])
            found, left = _nearest(steps, goal, held)
            q[:, columns] = found
            off = np.maximum(off, left)
        return in_whole_turns(graph.links, self.values, q), off

    def _through(self, runs: Sequence[Run]) -> tuple[str, str, list[Step]]:
        """(first body, last body, the motions between them) of runs one after the other."""
        graph, steps = self.structure.graph, list[Step]()
        first = here = _end(runs[0], graph.cluster, near=True)
        for run in runs:
            start = _end(run, graph.cluster, near=True)
            steps += self._held(here, start)
            here = start
            for edge in run.edges:
                steps.append(self._step(edge, 1 if edge.parent == here else -1, None))
                here = edge.child if edge.parent == here else edge.parent
        return first, here, steps

    def _held(self, start: str, end: str) -> list[Step]:
        """The held motions from a body to another of its cluster."""
        ways: dict[str, list[Step]] = {start: []}
        front = [start]
        while front and end not in ways:
            here = front.pop(0)
            for edge in self.structure.graph.held:
                for near, far, sign in ((edge.parent, edge.child, 1), (edge.child, edge.parent, -1)):
                    if near == here and far not in ways:
                        moves = edge.axis is not None and edge.columns
                        value = self.values.get(edge.columns[0], 0.0) if moves else 0.0
                        ways[far] = ways[here] + ([self._step(edge, sign, value)] if moves else [])
                        front.append(far)
        return ways[end]

    def _step(self, edge: Edge, sign: int, value: float | None) -> Step:
        structure = self.structure
        axis = np.zeros(3)
        if edge.axis is not None:
            axis = np.array([float(sum(a * b for a, b in zip(row, edge.axis, strict=True))) for row in structure.frame])
        point = np.array([float(c) for c in structure.local(edge.point)])
        return Step(edge.kind, axis, point, sign, edge.columns, value)


def _end(run: Run, cluster: Mapping[str, str], *, near: bool) -> str:
    edge, home = (run.edges[0], run.near) if near else (run.edges[-1], run.far)
    return edge.parent if cluster[edge.parent] == home else edge.child


def after(one: Pose, two: Pose) -> Pose:
    """The product of displacements."""
    return one[0] @ two[0], (one[0] @ two[1][..., None])[..., 0] + one[1]


def inverse(pose: Pose) -> Pose:
    """The displacement back."""
    back = np.swapaxes(pose[0], -1, -2)
    return back, -(back @ pose[1][..., None])[..., 0]


def _nearest(steps: Sequence[Step], goal: Pose, held: Array) -> tuple[Array, Array]:
    """(displacements of a chain nearest to none that lead to the goals, how far they miss).

    Of ways with the values that are held too much, `held`, where there are such; NaN where nothing is.
    """
    count, width = len(goal[0]), sum(len(s.columns) for s in steps if s.value is None)
    random = np.random.default_rng(SEED)
    starts = np.concatenate([np.zeros((1, width)), random.uniform(-np.pi, np.pi, (STARTS - 1, width))])
    q = np.repeat(starts[None], count, axis=0).reshape(-1, width)
    goals = tuple(np.repeat(part, STARTS, axis=0) for part in goal)
    for _ in range(NEWTON):
        here = _missing(steps, q, goals)
        slopes = np.stack(
            [(_missing(steps, q + DIFFERENCE * np.eye(width)[k], goals) - here) / DIFFERENCE for k in range(width)],
            axis=2,
        ) if width else np.zeros((*here.shape, 0))  # fmt: skip
        step = (np.linalg.pinv(slopes, rcond=CUT_OFF) @ here[..., None])[..., 0]
        size = np.linalg.norm(step, axis=1, keepdims=True)
        q = _wrapped(steps, q - step / np.maximum(1.0, size))
        if size.max(initial=0.0) < 1e-14:
            break
    left = np.abs(_missing(steps, q, goals)).max(axis=1).reshape(count, STARTS)
    sizes = np.linalg.norm(q, axis=1).reshape(count, STARTS)
    missed = np.abs(np.nan_to_num(_wrapped(steps, q - held))).max(axis=1, initial=0.0).reshape(count, STARTS)
    sizes = sizes.round(6) + np.where(missed < CLOSED, 0.0, FAR)
    best = np.where(left < CLOSED, sizes, np.inf).argmin(axis=1)
    best = np.where((left < CLOSED).any(axis=1), best, left.argmin(axis=1))
    rows = np.arange(count)
    return q.reshape(count, STARTS, width)[rows, best], left[rows, best]


def _missing(steps: Sequence[Step], q: Array, goal: Sequence[Array]) -> Array:
    """Nine entries of the rotation and three of the translation by which a chain misses."""
    pose: Pose = np.tile(np.eye(3), (len(q), 1, 1)), np.zeros((len(q), 3))
    column = 0
    for step in steps:
        if step.value is None:
            moved = step.sign * q[:, column : column + len(step.columns)]
            column += len(step.columns)
        else:
            moved = np.full((len(q), 1), step.sign * step.value)
        pose = after(pose, _motion(step, moved))
    return np.concatenate([(pose[0] - goal[0]).reshape(len(q), 9), pose[1] - goal[1]], axis=1)


def _motion(step: Step, moved: Array) -> Pose:
    if step.kind == "slide":
        return np.tile(np.eye(3), (len(moved), 1, 1)), moved * step.axis
    vector = moved if step.kind == "ball" else moved * step.axis
    angle = np.linalg.norm(vector, axis=1)
    safe = np.where(angle < 1e-150, 1.0, angle)
    hat = np.zeros((len(moved), 3, 3))
    hat[:, 2, 1], hat[:, 0, 2], hat[:, 1, 0] = vector.T
    hat -= np.swapaxes(hat, 1, 2)
    a, b = np.sin(angle) / safe, 2 * (np.sin(angle / 2) / safe) ** 2
    a, b = np.where(angle < 1e-150, 1.0, a), np.where(angle < 1e-150, 0.5, b)
    turn = np.eye(3) + a[:, None, None] * hat + b[:, None, None] * (hat @ hat)
    return turn, step.point - turn @ step.point


def _wrapped(steps: Sequence[Step], q: Array) -> Array:
    """Angles within half a turn."""
    q, column = q.copy(), 0
    for step in steps:
        if step.value is not None:
            continue
        part = slice(column, column + len(step.columns))
        column = part.stop
        if step.kind == "turn":
            q[:, part] = (q[:, part] + np.pi) % (2 * np.pi) - np.pi
        elif step.kind == "ball":
            size = np.linalg.norm(q[:, part], axis=1, keepdims=True)
            turns = np.round(size / (2 * np.pi))
            q[:, part] *= 1 - 2 * np.pi * turns / np.maximum(size, 1.0)
    return q
