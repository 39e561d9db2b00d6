"""The spanning tree of a mechanism as Pinocchio takes it: joints, inertias, cut joints, states.

Every revolute joint becomes a JointModelRZ, every slider a JointModelPZ (their frames have z along the axis),
a spherical joint a JointModelSpherical, a virtual free joint a JointModelFreeFlyer: the fastest that Pinocchio
has. Coordinates are ordered platform first, then limb by limb.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import sympy

from symscrew.description import Joint, Mechanism
from symscrew.kinematics import GROUND, Link, Tree, spanning_tree

Array = np.ndarray


@dataclass(frozen=True)
class Element:
    """One Pinocchio joint: its frame (axes, origin) in absolute axes in the reference configuration.

    `q`, `v`: the indices into the tree's coordinates that it takes; `reference`: what to subtract from q.
    """

    kind: str
    parent: int
    axes: Array
    origin: Array
    q: tuple[int, ...]
    v: tuple[int, ...]
    reference: Array
    link: int


@dataclass(frozen=True)
class CutJoint:
    """A cut joint between two Pinocchio joints: its point, and for a universal joint its two axes."""

    tip: int
    hub: int
    point: Array
    axes: tuple[Array, ...]


@dataclass(frozen=True)
class PinocchioTree:
    """Joints in Pinocchio's order, inertias per joint (mass, centre, inertia; absolute axes), cut joints."""

    elements: tuple[Element, ...]
    inertias: tuple[tuple[float, Array, Array], ...]
    cuts: tuple[CutJoint, ...]
    drive_in_limb: int

    @property
    def hub(self) -> int:
        """Freedoms of the platform's joint."""
        return len(self.elements[0].v)

    @property
    def text(self) -> str:
        """The description that pinocchio_timing.cpp reads."""
        rotations = sum(len(cut.axes) == 2 for cut in self.cuts)
        head = [len(self.elements), len(self.cuts), self.hub if self.cuts else 0, rotations, self.drive_in_limb]
        lines = [" ".join(map(str, head))]
        for element, (mass, centre, inertia) in zip(self.elements, self.inertias, strict=True):
            axes, origin = self.frame(element.parent)
            numbers = [
                *(axes.T @ element.axes).ravel(),
                *(axes.T @ (element.origin - origin)),
                mass,
                *(element.axes.T @ (centre - element.origin)),
                *(element.axes.T @ inertia @ element.axes).ravel(),
            ]
            lines.append(f"{element.kind} {element.parent} " + " ".join(repr(float(x)) for x in numbers))
        for cut in self.cuts:
            numbers = [*self._local(cut.tip, cut.point), *self._local(cut.hub, cut.point)]
            for joint, axis in zip((cut.tip, cut.hub), cut.axes or (np.zeros(3),) * 2, strict=True):
                numbers += [*(self.frame(joint)[0].T @ axis)]
            rotation = int(len(cut.axes) == 2)
            lines.append(f"{cut.tip} {cut.hub} {rotation} " + " ".join(repr(float(x)) for x in numbers))
        return "\n".join(lines) + "\n"

    def frame(self, joint: int) -> tuple[Array, Array]:
        """Axes and origin of a joint's frame in the reference configuration; 0 is the ground."""
        if joint == 0:
            return np.eye(3), np.zeros(3)
        return self.elements[joint - 1].axes, self.elements[joint - 1].origin

    def _local(self, joint: int, point: Array) -> Array:
        axes, origin = self.frame(joint)
        local: Array = axes.T @ (point - origin)
        return local

    def states(self, q: Array, v: Array, a: Array) -> tuple[Array, Array, Array]:
        """Pinocchio's q, v, a of consistent states (states, n) of the tree."""
        qs, vs, accelerations = [], [], []
        for element in self.elements:
            place, rate, change = q[:, element.q] - element.reference, v[:, element.v], a[:, element.v]
            if len(element.q) > len(element.v):  # a quaternion
                place = np.concatenate([place[:, :-4], place[:, -3:], place[:, -4:-3]], axis=1)  # (x, y, z, w)
            if len(element.v) == 6:
                turn = rotations(q[:, element.q[-4:]])
                omega = rate[:, 3:]
                linear = np.einsum("sji,sj->si", turn, rate[:, :3])
                linear_dot = np.einsum("sji,sj->si", turn, change[:, :3]) - np.cross(omega, linear)
                rate = np.concatenate([linear, omega], axis=1)
                change = np.concatenate([linear_dot, change[:, 3:]], axis=1)
            qs.append(place)
            vs.append(rate)
            accelerations.append(change)
        joined = [np.ascontiguousarray(np.concatenate(parts, axis=1)) for parts in (qs, vs, accelerations)]
        return joined[0], joined[1], joined[2]


def pinocchio_tree(mechanism: Mechanism) -> PinocchioTree:
    """The tree of a serial chain, or of a platform whose limbs of three coordinates are cut at the platform."""
    tree = spanning_tree(mechanism)
    order = _ordered(mechanism, tree)
    elements: list[Element] = []
    number = {GROUND: 0}
    for links in order:
        element = _element(mechanism, tree, links, number[links[0].parent])
        elements.append(element)
        number |= {link.index: len(elements) for link in links}
    inertias = [_inertia(mechanism, links) for links in order]
    cuts = []
    for joint in _limb_order(tree, number):
        ends = [number[tree.link_of_body[body]] for body in (joint.parent, joint.child)]
        axes = tuple(_numbers(mechanism, axis) for axis in joint.axes)
        if not (joint.kind.ball or joint.kind.universal):
            raise ValueError(f"joint {joint.name}: expected cut joints of type S or U, got {joint.type}")
        tip_first = ends[0] > ends[1]
        cuts.append(CutJoint(max(ends), min(ends), _numbers(mechanism, joint.point), axes if tip_first else axes[::-1]))
    driven = {j.name for j in mechanism.joints.values() if j.driven}
    limb = order[1:4]
    place = [i for i, links in enumerate(limb) if links[0].joint in driven]
    return PinocchioTree(tuple(elements), tuple(inertias), tuple(cuts), place[0] if cuts else 0)


def _ordered(mechanism: Mechanism, tree: Tree) -> list[list[Link]]:
    """Groups of links that make one Pinocchio joint: the platform's first, then branch by branch."""
    if not tree.cut:
        return [[link] for link in tree.links[1:]]
    assert mechanism.platform is not None
    platform = list(reversed(tree.path(tree.link_of_body[mechanism.platform])))
    groups: list[list[Link]] = [[tree.links[i] for i in platform]]
    roots = [link for link in tree.links[1:] if link.parent == GROUND and link.index not in platform]
    for root in roots:
        waiting = [root]
        while waiting:
            link = waiting.pop()
            groups.append([link])
            waiting += [child for child in tree.links[1:] if child.parent == link.index]
    return groups


def _limb_order(tree: Tree, number: dict[int, int]) -> list[Joint]:
    """Cut joints in the order of their limbs."""

    def tip(joint: Joint) -> int:
        return max(number[tree.link_of_body[body]] for body in (joint.parent, joint.child))

    return sorted(tree.cut, key=tip)


def _element(mechanism: Mechanism, tree: Tree, links: list[Link], parent: int) -> Element:
    link = links[-1]
    joint = tree.joints[link.joint]
    assert link.motion is not None
    q = tuple(i for part in links for i in range(part.q.start, part.q.stop))
    v = tuple(i for part in links for i in range(part.v.start, part.v.stop))
    origin = _numbers(mechanism, joint.point)
    if len(links) == 4:
        reference = np.concatenate([_numbers(mechanism, joint.reference), np.zeros(4)])
        return Element("free", parent, np.eye(3), origin, q, v, reference, link.index)
    if link.motion.spherical:
        return Element("S", parent, np.eye(3), origin, q, v, np.zeros(4), link.index)
    if len(links) > 1 or not (link.motion.revolute or link.motion.prismatic):
        raise ValueError(f"joint {joint.name}: expected R, P, U, S or a virtual free joint, got {joint.type}")
    axis = _numbers(mechanism, joint.axes[link.motion.axis or 0]) * (-1 if link.inverted else 1)
    place = link.position
    values = _numbers(mechanism, joint.reference) if joint.reference else np.zeros(2)
    return Element(link.motion.kind, parent, triad(axis), origin, q, v, values[place : place + 1], link.index)


def _inertia(mechanism: Mechanism, links: list[Link]) -> tuple[float, Array, Array]:
    """Mass, centre and inertia about it of the bodies of a group, absolute axes."""
    bodies = [mechanism.bodies[name] for link in links for name in link.bodies]
    heavy = [(body, body.mass, body.com) for body in bodies if body.mass is not None and body.com is not None]
    if not heavy:
        return 0.0, np.zeros(3), np.zeros((3, 3))
    ((body, mass, com),) = heavy
    inertia = np.zeros((3, 3)) if body.inertia is None else np.array([_numbers(mechanism, r) for r in body.inertia])
    return float(mechanism.number(mass)), _numbers(mechanism, com), inertia


def triad(axis: Array) -> Array:
    """A rotation matrix whose third column is the axis."""
    first = np.cross(np.eye(3)[np.abs(axis).argmin()], axis)
    first /= np.linalg.norm(first)
    return np.column_stack([first, np.cross(axis, first), axis])


def rotations(quaternions: Array) -> Array:
    """Rotation matrices (states, 3, 3) of unit quaternions (w, x, y, z)."""
    w, r = quaternions[:, 0], quaternions[:, 1:]
    cross = np.cross(np.eye(3)[None], r[:, None, :])
    outer = 2 * r[:, :, None] * r[:, None, :]
    turned: Array = outer + 2 * w[:, None, None] * cross + (w**2 - (r**2).sum(axis=1))[:, None, None] * np.eye(3)
    return turned


def _numbers(mechanism: Mechanism, values: Sequence[sympy.Expr]) -> Array:
    return np.array([float(mechanism.number(value)) for value in values])
