"""Numbers in the slots of a structure, for any scalars, and the matrices that they make.

values of what is held --displacements inside the clusters--> points, axes, lengths --dual_forms--> matrices
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import dot
from symscrew.assembly import dual_forms as forms
from symscrew.assembly.closure_structure import Group, Structure
from symscrew.assembly.elementary_graph import Edge, Point

Array = np.ndarray[Any, Any]
Pose = tuple[Array, Array]

QUADRATIC: Mapping[str, Callable[..., Array]] = {
    "distance": forms.distance, "angle": forms.angle, "crossing": forms.crossing,
}  # fmt: skip


@dataclass(frozen=True)
class Scalars:
    """Cosine, sine, and how numbers of 60 digits are read."""

    cos: Callable[[Any], Any]
    sin: Callable[[Any], Any]
    read: Callable[[Any], Any]

    def vector(self, values: Sequence[Any]) -> Array:
        """Three of these scalars."""
        result = np.empty(3, dtype=object)
        for k, value in enumerate(values):
            result[k] = self.read(value)
        return result


class Displacements:
    """Where bodies are inside their clusters for values of what is held; joints of the tree rest."""

    def __init__(self, structure: Structure, scalars: Scalars, values: Mapping[int, Any]) -> None:
        """`values`: held column -> displacement from the reference [rad, sizes of the mechanism]."""
        self.structure, self.scalars, self.values = structure, scalars, values
        self.poses: dict[str, Pose] = {}
        graph = structure.graph
        self._spread(graph.ground, self._still())
        for group in structure.groups:
            if group.edge is not None:
                self._across(group)
        for body in graph.cluster:
            if body not in self.poses:
                self._spread(body, self._still())

    def _across(self, group: Group) -> None:
        """The body behind a joint of the tree is displaced as that before it."""
        assert group.edge is not None
        near, far = (group.edge.parent, group.edge.child) if group.forward else (group.edge.child, group.edge.parent)
        if near in self.poses and far not in self.poses:
            self._spread(far, self.poses[near])

    def _still(self) -> Pose:
        read = self.scalars.read
        turn = np.empty((3, 3), dtype=object)
        for i in range(3):
            for j in range(3):
                turn[i, j] = read(int(i == j))
        return turn, self.scalars.vector((0, 0, 0))

    def _spread(self, body: str, pose: Pose) -> None:
        """The displacements of all bodies that are held to this one."""
        front = [body]
        self.poses[body] = pose
        while front:
            here = front.pop()
            for edge in self.structure.graph.held:
                for near, far, sign in ((edge.parent, edge.child, 1), (edge.child, edge.parent, -1)):
                    if near == here and far not in self.poses:
                        self.poses[far] = self._after(self.poses[here], edge, sign)
                        front.append(far)

    def _after(self, pose: Pose, edge: Edge, sign: int) -> Pose:
        """The displacement behind a held joint."""
        if not edge.columns or edge.axis is None:
            return pose
        value = sign * self.values.get(edge.columns[0], self.scalars.read(0))
        axis = self.scalars.vector(self.structure.turned(edge.axis))
        if self.structure.planar and edge.kind == "turn":
            axis = self.scalars.vector((0, 0, dot(self.structure.frame[2], edge.axis)))
        if edge.kind == "slide":
            return pose[0], pose[1] + pose[0].dot(axis * value)
        turn = self._rotation(axis, value)
        point = self.scalars.vector(self.structure.local(edge.point))
        return pose[0].dot(turn), pose[1] + pose[0].dot(point - turn.dot(point))

    def _rotation(self, axis: Array, value: Any) -> Array:
        c, s = self.scalars.cos(value), self.scalars.sin(value)
        x, y, z = axis
        hat = np.array([[0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x]], dtype=object)
        return np.asarray(self._still()[0] + hat * s + hat.dot(hat) * (1 - c))

    def point(self, body: str, at: Point) -> Array:
        """A point of a body."""
        turn, shift = self.poses[body]
        return np.asarray(turn.dot(self.scalars.vector(self.structure.local(at))) + shift)

    def _known(self, kind: str, value: Any) -> Array:
        result = self.scalars.vector((1, 0, 0))
        result[:2] = (self.scalars.cos(value), self.scalars.sin(value)) if kind == "turned" else (result[0], value)
        return result

    def slots(self) -> list[Any]:
        """The numbers in the slots."""
        found: list[Any] = []
        structure = self.structure
        for slot in structure.slots:
            if slot.kind == "point":
                found.append(self.point(slot.body, slot.at))
            elif slot.kind == "axis":
                axis = structure.turned(slot.at)
                if structure.planar and not any(abs(float(c)) > 0.5 for c in axis):  # of a hinge: 0 but for rounding
                    axis = (0, 0, dot(structure.frame[2], slot.at))
                found.append(self.poses[slot.body][0].dot(self.scalars.vector(axis)))
            elif slot.kind == "number":
                found.append(self.scalars.read(slot.at))
            elif slot.kind in ("turned", "slid"):
                found.append(self._known(slot.kind, self.values.get(slot.at, self.scalars.read(0))))
            else:
                assert slot.rod is not None
                way = self.point(*slot.rod[0]) - self.point(*slot.rod[1])
                p, a = (found[k] for k in slot.of)
                found.append(p.dot(p) + a.dot(a) - way.dot(way))
        return found


def matrices(structure: Structure, slots: Sequence[Any]) -> tuple[list[Array], list[tuple[Array, Array]]]:
    """(motions of the groups, (quadratic, linear) forms of the loops) with these numbers in the slots."""
    made: dict[str, Callable[[Group], Array]] = {
        "turn": lambda g: forms.turning(*(slots[k] for k in g.slots)),
        "slide": lambda g: forms.sliding(*(slots[k] for k in g.slots)),
        "ball": lambda g: forms.rolling(*(slots[k] for k in g.slots)),
        "planar": lambda _: forms.PLANAR.astype(object),
        "free": lambda _: np.eye(forms.SIZE, dtype=int).astype(object),
    }
    motions = [made[g.kind](g) for g in structure.groups]
    loops = []
    for loop in structure.loops:
        quadratic, linear = [], []
        for form in loop.forms:
            given = [slots[k] for k in form.slots]
            if form.kind in QUADRATIC:
                quadratic.append(QUADRATIC[form.kind](*given))
            elif form.kind in ("turned", "slid"):
                linear.append(forms.coupled(given[0], turning=form.kind == "turned"))
            else:
                rows = (forms.meeting if form.kind == "meeting" else forms.parallel)(*given)
                linear.append(rows[1:3] if structure.planar else rows)
        square = np.array(quadratic, dtype=object).reshape(-1, forms.SIZE, forms.SIZE)
        loops.append((square, np.concatenate(linear) if linear else np.zeros((0, forms.SIZE), dtype=object)))
    return motions, loops


def spins_of(structure: Structure) -> list[Array]:
    """The motions of what couplings tie, whole numbers, as factors of their products."""
    return [forms.spinning(turning=spin.turning, size=spin.size) for spin in structure.spins]
