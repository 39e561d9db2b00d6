"""The closure variety: joint displacements that close all loops, evaluated for many points at once.

    displacements q --exponentials of the screws--> poses --chords--> residual f(q) [6 per loop], Jacobian df/dq

Every joint moves by the exponential of its reference screw, in absolute axes (product of exponentials), so no
body frames are needed. A spherical joint's three coordinates are a rotation vector. The same code runs in double
precision on a batch of points and in 60 digits on one: only the arithmetic differs.

Residual of a loop: the displacement by which the chord fails to close, as a small twist (omega ; v). Its
derivative at a point of the variety are the signed screws of the displaced joints.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT, IDENTITY, revolute
from symscrew.description import Motion as JointMotion
from symscrew.mobility.finite.closure_residual import ClosureResidual
from symscrew.mobility.joint_network import Edge, Network
from symscrew.mobility.screw_systems import Real, Row, Screw

Array = np.ndarray[Any, Any]
"""Doubles, or objects that are numbers of 60 digits."""
Pose = tuple[Array, Array]
Step = tuple[Array, Array, Array | None]
"""(rotation, translation, screws in the axes before the step where they change on the way: those of a sphere)."""


@dataclass(frozen=True)
class Arithmetic:
    """The scalars of an evaluation: how to read a 60-digit number, sine, cosine and square root."""

    dtype: Any
    read: Callable[[Any], Any]
    sin: Callable[[Array], Array]
    cos: Callable[[Array], Array]
    sqrt: Callable[[Array], Array]
    tiny: Any
    """Square of an angle below which a rotation counts as none, so that nothing is divided by zero."""

    def array(self, values: Any) -> Array:
        """`values`, nested lists of 60-digit numbers or integers, as an array of these scalars."""
        given = np.array(values, dtype=object)
        result = np.empty(given.shape, dtype=self.dtype)
        for index in np.ndindex(given.shape):
            result[index] = self.read(given[index])
        return result


def _elementwise(function: Callable[[Any], Any]) -> Callable[[Array], Array]:
    def applied(values: Array) -> Array:
        return np.asarray(np.frompyfunc(function, 1, 1)(values))

    return applied


DOUBLE = Arithmetic(float, float, np.sin, np.cos, np.sqrt, 1e-290)
DIGITS_60 = Arithmetic(
    object, CONTEXT.mpf, _elementwise(CONTEXT.sin), _elementwise(CONTEXT.cos), _elementwise(CONTEXT.sqrt),
    CONTEXT.mpf(10) ** -200,
)  # fmt: skip


@dataclass(frozen=True)
class Motion:
    """One elementary motion of a joint in the arithmetic: what it is, first column, screws and point.

    `hat`, `square`: the cross-product matrix of the axis and its square; `pitch`: the advance along the axis.
    """

    motion: JointMotion
    column: int
    screws: Array
    point: Array
    hat: Array
    square: Array
    pitch: Any


@dataclass(frozen=True)
class _Alike:
    """The elementary motions by kind, with the arrays of all of one kind."""

    sliding: list[Motion]
    turning: list[Motion]
    spherical: list[Motion]
    hats: Array
    squares: Array
    points: Array
    centres: Array
    screws: Array

    @classmethod
    def of(cls, motions: Sequence[Motion]) -> _Alike:
        """Revolute and helical ones are turning."""
        sliding = [m for m in motions if m.motion.prismatic]
        spherical = [m for m in motions if m.motion.spherical]
        turning = [m for m in motions if not (m.motion.prismatic or m.motion.spherical)]
        arrays = [[m.hat for m in turning], [m.square for m in turning], [m.point for m in turning],
                  [m.point for m in spherical], [m.screws for m in spherical]]  # fmt: skip
        return cls(sliding, turning, spherical, *(np.array(array) for array in arrays))


class ClosureVariety:
    """Closure residuals and Jacobians of a mechanism; coordinates are displacements from the reference.

    Lengths are in units of the mechanism's size about the centre of its joints.
    """

    def __init__(self, network: Network, arithmetic: Arithmetic = DOUBLE) -> None:
        self.network, self.arithmetic = network, arithmetic
        edges = list(network.edges.values())
        self.centre = centre = [sum(edge.point[k] for edge in edges) / len(edges) for k in range(3)]
        self.columns = network.freedoms
        self._places = _places(network)
        self.rows = 6 * len(network.chords) + len(network.ties)
        self._ties = [
            [(network.tied_column(term.joint, term.motion), term.read(arithmetic.read)) for term in tie.terms]
            for tie in network.ties
        ]
        self._fixed = None if arithmetic is DOUBLE else ClosureResidual(network, centre)

    @cached_property
    def _motions(self) -> dict[str, tuple[Motion, ...]]:
        """The motions of every joint; residuals and screws of 60 digits do without."""
        return {edge.name: _motions(edge, self.centre, self.arithmetic) for edge in self.network.edges.values()}

    @cached_property
    def _alike(self) -> _Alike:
        return _Alike.of([motion for motions in self._motions.values() for motion in motions])

    def evaluate(self, q: Array) -> tuple[Array, Array]:
        """(residuals N x rows, Jacobians N x rows x columns) at the points q, N x columns."""
        screws, poses = self.forward(q)
        return self.gaps(poses, q), self.jacobians(screws, q)

    def gaps(self, poses: Mapping[str, Pose], q: Array) -> Array:
        """The residuals N x rows at the points q with these displacements of the bodies, as `forward` has them."""
        residuals = self._zeros(len(q), self.rows)
        for k, name in enumerate(self.network.chords):
            edge = self.network.edges[name]
            gap = _product(poses[f"{name} closed"], _inverse(poses[edge.child]))
            residuals[:, 6 * k : 6 * k + 6] = _small_twist(gap)
        residuals[:, 6 * len(self.network.chords) :] = self._tied(q)
        return residuals

    def _tied(self, q: Array) -> Array:
        """How far the couplings are off at the points q."""
        values = self._zeros(len(q), len(self._ties))
        for k, terms in enumerate(self._ties):
            for column, term in terms:
                values[:, k] = values[:, k] + term.value(q[:, column])
        return values

    def forward(self, q: Array) -> tuple[Array, dict[str, tuple[Array, Array]]]:
        """(displaced screws N x columns x 6, displacement (rotation, translation) of every body), about the centre."""
        poses, every, starts = self._placed(q)
        return self._displaced(len(q), every, starts), poses

    def _placed(self, q: Array) -> tuple[dict[str, Pose], dict[int, Step], dict[int, Pose]]:
        """(displacement of every body, the step of every motion, the displacement before it)."""
        count, starts = len(q), dict[int, Pose]()
        poses = {self.network.ground: (self._identity(count), self._zeros(count, 3))}
        every = self._steps(q)
        for name, sign in self.network.tree:
            edge = self.network.edges[name]
            if sign > 0:
                poses[edge.child] = self._passed(name, every, poses[edge.parent], starts)
            else:
                total = poses[edge.child]
                for motion in reversed(self._motions[name]):
                    total = _product(total, _inverse(every[motion.column][:2]))
                poses[edge.parent] = total
                self._passed(name, every, total, starts)
        for name in self.network.chords:
            start = poses[self.network.edges[name].parent]
            poses[f"{name} closed"] = self._passed(name, every, start, starts)
        return poses, every, starts

    def residual(self, q: Array) -> Array:
        """The residual at one point."""
        if self._fixed is not None:
            return np.array([*self._fixed(list(q)), *self._tied(q[None])[0]], dtype=object)
        return np.asarray(self.gaps(self._placed(q[None])[0], q[None])[0])

    def displaced(self, q: Array) -> Array:
        """The displaced screws N x columns x 6 at the points q, as `forward` has them."""
        if self._fixed is None or len(q) != 1:
            _, every, starts = self._placed(q)
            return self._displaced(len(q), every, starts)
        result = np.empty((1, self.columns, 6), dtype=object)
        for column, screw in enumerate(self._fixed.screws(list(q[0]))):
            result[0, column] = screw
        return result

    def slopes(self, q: Array) -> Array:
        """The Jacobians N x rows x columns at the points q."""
        return self.jacobians(self.displaced(q), q)

    def stations(self, q: Array) -> dict[str, list[Pose]]:
        """Joint -> displacements, about the centre, before, between and after its motions, at the points q."""
        (poses, every, _), result = self._placed(q), dict[str, list[Pose]]()
        for name, edge in self.network.edges.items():
            found = [poses[edge.parent]]
            for motion in self._motions[name]:
                rotation, translation, _ = every[motion.column]
                found.append(_product(found[-1], (rotation, translation)))
            result[name] = found
        return result

    def jacobians(self, screws: Array, q: Array) -> Array:
        """The Jacobians N x rows x columns at the points q with these displaced screws."""
        result = self._zeros(len(screws), self.rows, self.columns)
        chords, columns, signs = self._places
        loops = 6 * len(self.network.chords)
        shape = (len(screws), loops // 6, 6, self.columns)
        blocks = result[:, :loops].reshape(shape)  # a view: splitting an axis copies nothing
        blocks[:, chords, :, columns] = np.swapaxes(screws[:, columns], 0, 1) * signs[:, None, None]
        for k, terms in enumerate(self._ties, start=loops):
            for column, term in terms:
                result[:, k, column] = result[:, k, column] + term.slope(q[:, column])
        return result

    def _passed(self, name: str, steps: Mapping[int, Step], start: Pose, starts: dict[int, Pose]) -> Pose:
        """The displacement behind a joint, from that of its parent; those before its motions go into `starts`."""
        for motion in self._motions[name]:
            starts[motion.column] = start
            start = _product(start, steps[motion.column][:2])
        return start

    def _displaced(self, count: int, steps: Mapping[int, Step], starts: Mapping[int, Pose]) -> Array:
        """The screws N x columns x 6 of all motions, displaced by what comes before them."""
        alike = self._alike
        screws = self._zeros(count, self.columns, 6)
        for motions in (alike.turning + alike.sliding, alike.spherical):
            if not motions:
                continue
            first = [m.column for m in motions]
            rotations = np.stack([starts[c][0] for c in first], axis=1)
            shifts = np.stack([starts[c][1] for c in first], axis=1)[:, :, None, :]
            if motions is alike.spherical:
                local = np.stack([changed for c in first if (changed := steps[c][2]) is not None], axis=1)
            else:
                local = np.array([m.screws for m in motions])[None]
            turned = np.swapaxes(rotations, 2, 3)
            angular = local[..., :3] @ turned
            linear = local[..., 3:] @ turned + _cross(shifts, angular)
            columns = np.array(first)[:, None] + np.arange(local.shape[2])
            screws[:, columns, :3], screws[:, columns, 3:] = angular, linear
        return screws

    def _steps(self, q: Array) -> dict[int, Step]:
        """First column of every elementary motion -> its step at the points q; all of one kind are computed at once."""
        result: dict[int, Step] = {}
        alike, count = self._alike, len(q)
        for motion in alike.sliding:
            result[motion.column] = (self._identity(count), q[:, motion.column, None] * motion.screws[0, 3:], None)
        if alike.turning:
            angle = q[:, [motion.column for motion in alike.turning]]
            sine, versine = self.arithmetic.sin(angle), 1 - self.arithmetic.cos(angle)
            rotation = sine[..., None, None] * alike.hats + versine[..., None, None] * alike.squares
            rotation[..., range(3), range(3)] += self.arithmetic.read(1)
            moved = alike.points - (rotation @ alike.points[..., None])[..., 0]
            for k, motion in enumerate(alike.turning):
                shift = moved[:, k]
                if motion.motion.helical:
                    shift = shift + angle[:, k, None] * (motion.pitch * motion.screws[0, :3])
                result[motion.column] = (rotation[:, k], shift, None)
        if alike.spherical:
            vectors = np.stack([q[:, m.column : m.column + 3] for m in alike.spherical], axis=1)
            parts = self._rotation_vector(vectors.reshape(-1, 3))
            rotation, jacobian = (part.reshape(count, -1, 3, 3) for part in parts)
            moved = alike.centres - (rotation @ alike.centres[..., None])[..., 0]
            screws = np.swapaxes(jacobian, 2, 3) @ alike.screws
            for k, motion in enumerate(alike.spherical):
                result[motion.column] = (rotation[:, k], moved[:, k], screws[:, k])
        return result

    def _rotation_vector(self, vector: Array) -> tuple[Array, Array]:
        """(rotation, left Jacobian) of rotation vectors: omega = J_l(w) dw/dt."""
        square = (vector * vector).sum(axis=1)
        small = np.asarray(square < self.arithmetic.tiny, dtype=bool)
        safe = np.where(small, 1 + 0 * square, square)
        angle = self.arithmetic.sqrt(safe)
        half = self.arithmetic.sin(angle / 2) / angle
        a = np.where(small, 1 + 0 * square, self.arithmetic.sin(angle) / angle)
        b = np.where(small, (1 + 0 * square) / 2, 2 * half * half)
        c = np.where(small, (1 + 0 * square) / 6, (1 - a) / safe)
        hat = _hat(vector)
        square_hat = hat @ hat
        one = self._identity(len(vector))
        rotation = one + a[:, None, None] * hat + b[:, None, None] * square_hat
        jacobian = one + b[:, None, None] * hat + c[:, None, None] * square_hat
        return rotation, jacobian

    def _zeros(self, *shape: int) -> Array:
        result = np.empty(shape, dtype=self.arithmetic.dtype)
        result[...] = self.arithmetic.read(0)
        return result

    def _identity(self, count: int) -> Array:
        result = self._zeros(count, 3, 3)
        for k in range(3):
            result[:, k, k] = self.arithmetic.read(1)
        return result


def moved(network: Network, fine: ClosureVariety, point: Array) -> Network:
    """The network in the configuration with the displacements `point`, in 60 digits."""
    screws, poses = fine.forward(point[None])
    centre = fine.centre
    edges: dict[str, Edge] = {}
    for edge in network.edges.values():
        rotation, translation = (part[0] for part in poses[edge.child])
        local = np.array([edge.point[k] - centre[k] for k in range(3)], dtype=object)
        moved = rotation @ local + translation
        place = (moved[0] + centre[0], moved[1] + centre[1], moved[2] + centre[2])
        rows = []
        for motion, column in edge.motions:
            if motion.spherical:
                rows += [tuple(CONTEXT.mpf(c) for c in revolute(axis, place).components) for axis in IDENTITY]
            else:
                w, v = screws[0, column, :3], screws[0, column, 3:]
                shift = (centre[1] * w[2] - centre[2] * w[1], centre[2] * w[0] - centre[0] * w[2],
                         centre[0] * w[1] - centre[1] * w[0])  # fmt: skip
                rows.append((*w, *(a + b for a, b in zip(v, shift, strict=True))))
        edges[edge.name] = replace(edge, point=place, screws=tuple(rows))
    ties = tuple(
        replace(tie, terms=tuple(t.moved(point[network.tied_column(t.joint, t.motion)]) for t in tie.terms))
        for tie in network.ties
    )
    return replace(network, edges=edges, ties=ties)


def _places(network: Network) -> tuple[Array, Array, Array]:
    """Of every column in every loop: (number of the loop, column, sign)."""
    found = [(k, column, sign) for k, loop in enumerate(network.loops()) for name, sign in loop
             for column in network.edges[name].columns]  # fmt: skip
    chords, columns, signs = np.array(found, dtype=int).reshape(-1, 3).T
    return chords, columns, signs


def _motions(edge: Edge, centre: Sequence[Real], arithmetic: Arithmetic) -> tuple[Motion, ...]:
    """The joint's motions with their screws moved to the centre."""
    point = [edge.point[k] - centre[k] for k in range(3)]
    result = []
    for motion, column in edge.motions:
        local = edge.screws[column - edge.start : column - edge.start + motion.freedom]
        moved = [_moved(screw, centre) for screw in local]
        screws = arithmetic.array(moved)
        axis = screws[0, :3]
        hat = _hat(axis[None])[0]
        # the part of the screw's linear velocity along its axis is the pitch
        pitch = axis @ screws[0, 3:]
        result.append(Motion(motion, column, screws, arithmetic.array(point), hat, hat @ hat, pitch))
    return tuple(result)


def _moved(screw: Screw, centre: Sequence[Real]) -> Row:
    """The same screw with its moment about `centre` instead of O: v - r x omega."""
    w, v, r = screw[:3], screw[3:], centre
    return [
        *w,
        v[0] - (r[1] * w[2] - r[2] * w[1]),
        v[1] - (r[2] * w[0] - r[0] * w[2]),
        v[2] - (r[0] * w[1] - r[1] * w[0]),
    ]


def _product(a: tuple[Array, Array], b: tuple[Array, Array]) -> tuple[Array, Array]:
    return a[0] @ b[0], (a[0] @ b[1][..., None])[..., 0] + a[1]


def _inverse(a: tuple[Array, Array]) -> tuple[Array, Array]:
    back = np.swapaxes(a[0], 1, 2)
    return back, -(back @ a[1][..., None])[..., 0]


def _small_twist(gap: tuple[Array, Array]) -> Array:
    rotation, translation = gap
    half = [
        (rotation[:, 2, 1] - rotation[:, 1, 2]) / 2,
        (rotation[:, 0, 2] - rotation[:, 2, 0]) / 2,
        (rotation[:, 1, 0] - rotation[:, 0, 1]) / 2,
    ]
    return np.concatenate([np.stack(half, axis=1), translation], axis=1)


def _hat(vector: Array) -> Array:
    x, y, z = vector[:, 0], vector[:, 1], vector[:, 2]
    result = np.empty((len(vector), 3, 3), dtype=vector.dtype)
    result[:, 0, 0] = result[:, 1, 1] = result[:, 2, 2] = 0 * x
    result[:, 0, 1], result[:, 0, 2], result[:, 1, 2] = -z, y, -x
    result[:, 1, 0], result[:, 2, 0], result[:, 2, 1] = z, -y, x
    return result


def _cross(a: Array, b: Array) -> Array:
    result = np.empty(np.broadcast_shapes(a.shape, b.shape), dtype=b.dtype)
    result[..., 0] = a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1]
    result[..., 1] = a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2]
    result[..., 2] = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return result
