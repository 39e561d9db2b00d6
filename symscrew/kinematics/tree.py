"""From the graph of a mechanism to a spanning tree, its coordinates and the joints that are cut.

The tree is grown from the ground breadth first; where several joints reach a body at the same depth, a
driven joint wins, then the one with fewest freedoms: spherical joints are cut. A platform that three or more
limbs hold hangs on a virtual joint instead (free, or planar in a planar mechanism) and all its joints are
cut: every limb is then a chain of its own, and only the platform's equations couple them.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from functools import cached_property

import sympy

from symscrew.description import NO_MOTION, Joint, Mechanism, Motion, Vector
from symscrew.errors import DescriptionError
from symscrew.kinematics.kept_joints import SAME_DIRECTION, Reached, keeping
from symscrew.kinematics.pairs import LowerPair, pair_of
from symscrew.kinematics.parameter_trials import always_below

GROUND = 0  # index of the ground among the links: the first of them, which all others hang on

LIMBS_OF_HUB = 3
"""Limbs from the ground that meet at a platform from which on it hangs on a joint of its own: they are chains of their
own then, and only its own equations couple them. With two limbs a single loop through the platform has fewer
coordinates. What the platform carries, a gripper's jaws, is no limb."""

SPATIAL_PATH, PLANAR_PATH = 5, 3
"""Freedoms of the shortest path to the platform from which on a free joint (six freedoms), or in a planar mechanism a
planar one (three), is not many more. Below, the platform stays at the end of its shortest path."""

FAR_OUT = 10**6
"""A depth that no chain of joints reaches: bodies beyond a platform on its own joint come after all others."""


@dataclass(frozen=True)
class Coordinate:
    """One entry of q (`kind` "angle", "length" or "quaternion") or of v ("angle", "length", "rotation")."""

    label: str
    joint: str
    kind: str
    unit: str


@dataclass(frozen=True)
class Link:
    """One elementary motion of the tree and what it carries.

    `parent` is the index of the parent link (0 is the ground), `bodies` are its body (none
    for the intermediate part of a universal joint), `q` and `v` are slices into the coordinates. `inverted`
    says that the tree passes the joint from child to parent: its axis is then negated. `position` is the motion's
    place among its joint's.
    """

    index: int
    parent: int
    joint: str
    motion: Motion
    inverted: bool
    bodies: tuple[str, ...]
    q: slice
    v: slice
    position: int = 0

    def __repr__(self) -> str:
        return (
            f"Link({self.index} on {self.parent} by {self.joint or 'nothing'}, carries {', '.join(self.bodies) or '-'})"
        )

    @property
    def pair(self) -> LowerPair:
        """What its motion does with nodes."""
        return pair_of(self.motion)


@dataclass(frozen=True)
class Tree:
    """The spanning tree: links in topological order (ground first), coordinates, cut joints."""

    links: tuple[Link, ...]
    link_of_body: dict[str, int]
    joints: dict[str, Joint]
    cut: tuple[Joint, ...]
    q: tuple[Coordinate, ...]
    v: tuple[Coordinate, ...]
    virtual: str | None

    def __repr__(self) -> str:
        return f"Tree({len(self.links)} links, {len(self.q)} coordinates, {len(self.cut)} cut joints)"

    def path(self, link: int) -> tuple[int, ...]:
        """Links from `link` down to, not including, the ground."""
        chain = []
        while link != GROUND:
            chain.append(link)
            link = self.links[link].parent
        return tuple(chain)

    def common(self, one: int, other: int) -> int:
        """The outermost link that carries both, one of the two perhaps, or the ground."""
        carrying = set(self.path(other))
        return next((link for link in self.path(one) if link in carrying), GROUND)

    @cached_property
    def parts(self) -> tuple[str, ...]:
        """What every link is called: its body, or the motion of its joint (`joint.0`) where it carries none."""
        return tuple(
            link.bodies[0] if link.bodies else self.joints[link.joint].kind.motion_names(link.joint)[link.position]
            for link in self.links
        )

    def part(self, link: int) -> str:
        """What a link is called."""
        return self.parts[link]

    def links_of(self, joint: str) -> tuple[Link, ...]:
        """The links that make up a tree joint, from the ground outwards."""
        return tuple(link for link in self.links if link.joint == joint)

    @property
    def spheres(self) -> tuple[tuple[int, int], ...]:
        """(first entry in q, first entry in v) of every quaternion."""
        return tuple((link.q.start, link.v.start) for link in self.links if link.motion.spherical)

    @property
    def plain(self) -> tuple[tuple[int, int], ...]:
        """(entry in q, entry in v) of every coordinate whose rate is its entry in v."""
        return tuple((link.q.start, link.v.start) for link in self.links if link.motion.single)

    def velocity_indices(self, joint: str) -> tuple[int, ...]:
        """Indices into v of a tree joint, in the order of its freedoms (parent to child)."""
        links = self.links_of(joint)
        if links and links[0].inverted:
            links = links[::-1]
        return tuple(i for link in links for i in range(link.v.start, link.v.stop))


def spanning_tree(mechanism: Mechanism, read: Collection[str] = (), kept: Collection[str] = ()) -> Tree:
    """The tree of a mechanism; every mechanism, serial or parallel, goes through here.

    `read`: joints whose displacements effects ask for, over any number of turns; see `keeping`. `kept`: joints that
    need coordinates of their own, as those with stops and friction that events switch.
    """
    virtual = virtual_joint(mechanism)
    try:
        joints, reached = _kept_tree(mechanism, virtual, read, kept)
    except DescriptionError:
        if virtual is None:
            raise
        virtual = None  # a limb all of whose joints must stay: it carries the platform itself, and another one is cut
        joints, reached = _kept_tree(mechanism, virtual, read, kept)
    tree_joints = {name for name, _ in reached.values()}
    order = [j for j in joints.values() if j.name in tree_joints]
    coordinates = _coordinates(order)
    links, link_of_body = _links(mechanism, joints, reached, coordinates)
    return Tree(
        links=tuple(links),
        link_of_body=link_of_body,
        joints={j.name: j for j in order},
        cut=tuple(j for j in mechanism.joints.values() if j.name not in tree_joints),
        q=tuple(c for joint in order for c in coordinates[joint.name][0]),
        v=tuple(c for joint in order for c in coordinates[joint.name][1]),
        virtual=virtual.name if virtual else None,
    )


def _kept_tree(
    mechanism: Mechanism, virtual: Joint | None, read: Collection[str], kept: Collection[str]
) -> tuple[dict[str, Joint], Reached]:
    """All joints, and the tree that has those which must stay; its platform hangs on `virtual` where that is one."""
    joints = dict(mechanism.joints)
    if virtual is not None:
        joints[virtual.name] = virtual
    coupled = {*kept, *(term.joint for coupling in mechanism.couplings.values() for term in coupling.terms)}
    grown = _grow(mechanism, joints, virtual)
    return joints, keeping(
        mechanism, joints, grown, read=read, coupled=coupled, grow=lambda some: _grow(mechanism, some, virtual)
    )


def _grow(mechanism: Mechanism, joints: dict[str, Joint], virtual: Joint | None) -> dict[str, tuple[str, bool]]:
    """Body -> (joint that reaches it, whether passed from child to parent), breadth first."""
    reached: dict[str, tuple[str, bool]] = {}
    depth = {mechanism.ground: 0}
    if virtual is not None:
        # The platform is reached by its virtual joint only; nothing grows through it towards the limbs
        # before they have been grown from the ground.
        reached[virtual.child] = (virtual.name, False)
        depth[virtual.child] = FAR_OUT
    level = 0
    while len(depth) < len(mechanism.bodies) + (mechanism.ground not in mechanism.bodies):
        frontier = [body for body, d in depth.items() if d == level]
        if not frontier:
            if virtual is None or level > FAR_OUT:
                raise AssertionError("validation lets only connected mechanisms through")
            level = FAR_OUT
            continue
        candidates: dict[str, tuple[tuple[bool, int], str, bool]] = {}
        for joint in joints.values():
            for near, far, inverted in (
                (joint.parent, joint.child, False),
                (joint.child, joint.parent, True),
            ):
                if near in frontier and far not in depth:
                    key = (not joint.driven, joint.kind.freedom)
                    if far not in candidates or key < candidates[far][0]:
                        candidates[far] = (key, joint.name, inverted)
        for body, (_, name, inverted) in candidates.items():
            reached[body] = (name, inverted)
            depth[body] = level + 1
        level += 1
    return reached


def virtual_joint(mechanism: Mechanism) -> Joint | None:
    """The joint on which a platform hangs that three or more limbs hold, or None.

    Free where the shortest path to the platform has five freedoms or more, planar where all joints of the
    mechanism are planar in one plane and the path has three: the limbs then are chains of their own.
    """
    platform = mechanism.platform
    if platform is None or platform == mechanism.ground:
        return None
    held = _held(mechanism, platform)
    meeting = [j for j in mechanism.joints.values() if platform in (j.parent, j.child) and {j.parent, j.child} & held]
    reached = _grow(mechanism, dict(mechanism.joints), None)
    freedoms, length, body = 0, 0, platform
    while body != mechanism.ground:
        name, inverted = reached[body]
        joint = mechanism.joints[name]
        freedoms += joint.kind.freedom
        length += 1
        body = joint.child if inverted else joint.parent
    if len(meeting) < LIMBS_OF_HUB or length < 2:
        return None
    # At the centre of mass the platform's equations are shortest; q then holds its absolute position.
    point = mechanism.bodies[platform].com or meeting[0].point
    name = f"{platform}_pose"
    if freedoms >= SPATIAL_PATH:
        return Joint(name, "free", mechanism.ground, platform, point, reference=point)
    normal = _common_normal(mechanism)
    if freedoms >= PLANAR_PATH and normal is not None:
        return Joint(name, "E", mechanism.ground, platform, point, axes=(normal,))
    return None


def _held(mechanism: Mechanism, platform: str) -> set[str]:
    """Bodies that the ground reaches without the platform: what a limb goes through. A gripper's jaws are none."""
    held, waiting = {mechanism.ground}, [mechanism.ground]
    while waiting:
        body = waiting.pop()
        for joint in mechanism.joints.values():
            if body in (joint.parent, joint.child):
                far = joint.child if joint.parent == body else joint.parent
                if far != platform and far not in held:
                    held.add(far)
                    waiting.append(far)
    return held


def _common_normal(mechanism: Mechanism) -> Vector | None:
    """The axis that all revolute joints share and all sliders cross at right angles, or None."""
    turning = [j.axes[0] for j in mechanism.joints.values() if j.kind.hinge]
    if not turning or not all(j.kind.hinge or j.kind.slider for j in mechanism.joints.values()):
        return None
    normal = turning[0]

    def equal(a: sympy.Expr, b: sympy.Expr) -> bool:
        return always_below(mechanism, sympy.S(a) - sympy.S(b), SAME_DIRECTION)

    for axis in turning:
        if not all(equal(a, n) for a, n in zip(axis, normal, strict=True)):
            return None
    for joint in mechanism.joints.values():
        if joint.kind.slider and not equal(
            sum(a * n for a, n in zip(joint.axes[0], normal, strict=True)), sympy.S.Zero
        ):
            return None
    return (normal[0], normal[1], normal[2])


def _coordinates(joints: list[Joint]) -> dict[str, tuple[list[Coordinate], list[Coordinate]]]:
    result: dict[str, tuple[list[Coordinate], list[Coordinate]]] = {}
    for joint in joints:
        q: list[Coordinate] = []
        v: list[Coordinate] = []
        for name, motion in zip(joint.kind.motion_names(joint.name), joint.kind.motions, strict=True):
            for entries, coordinates in ((motion.q, q), (motion.v, v)):
                for entry in entries:
                    label = f"{joint.name}{entry.suffix}" if entry.suffix else name
                    coordinates.append(Coordinate(label, joint.name, entry.kind, entry.unit))
        result[joint.name] = (q, v)
    return result


def _links(
    mechanism: Mechanism,
    joints: dict[str, Joint],
    reached: dict[str, tuple[str, bool]],
    coordinates: dict[str, tuple[list[Coordinate], list[Coordinate]]],
) -> tuple[list[Link], dict[str, int]]:
    """Expand the tree's joints into elementary links, in topological order."""
    q_start, v_start, q_next, v_next = {}, {}, 0, 0
    for name, (q, v) in coordinates.items():
        q_start[name], v_start[name] = q_next, v_next
        q_next, v_next = q_next + len(q), v_next + len(v)
    links = [Link(GROUND, GROUND, "", NO_MOTION, False, (mechanism.ground,), slice(0, 0), slice(0, 0))]
    link_of_body = {mechanism.ground: GROUND}
    waiting = dict(reached)
    while waiting:
        for body, (name, inverted) in list(waiting.items()):
            joint = joints[name]
            inner = joint.child if inverted else joint.parent
            if inner not in link_of_body:
                continue
            del waiting[body]
            current = link_of_body[inner]
            motions = list(enumerate(joint.kind.motions or (NO_MOTION,)))
            q_at, v_at = _offsets(joint, q_start[name], v_start[name])
            for position, motion in reversed(motions) if inverted else motions:
                in_q = slice(q_at[position], q_at[position] + len(motion.q))
                in_v = slice(v_at[position], v_at[position] + len(motion.v))
                links.append(Link(len(links), current, name, motion, inverted, (), in_q, in_v, position))
                current = len(links) - 1
            links[current] = replace(links[current], bodies=(*links[current].bodies, body))
            link_of_body[body] = current
    return links, link_of_body


def _offsets(joint: Joint, q: int, v: int) -> tuple[list[int], list[int]]:
    """Where each motion of a joint starts in q and v."""
    q_at, v_at = [], []
    for motion in joint.kind.motions or (NO_MOTION,):
        q_at.append(q)
        v_at.append(v)
        q, v = q + len(motion.q), v + len(motion.v)
    return q_at, v_at
