"""A frame for every link, chosen so that its constants are mostly zeros and ones.

A revolute link's z is its joint axis and its x points where the next joint, or the tip, lies; a prismatic
link keeps its parent's axes; a spherical link keeps the absolute axes of the reference configuration. The
constants are nodes of the tape: numbers where the geometry is baked, expressions of run-time parameters
otherwise. What is structurally zero here is what the generated code does not compute.

The choice is each motion's own (`symscrew.kinematics.pairs`); here it is told what lies further out.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symscrew.algebra import IDENTITY, ZERO, Vector
from symscrew.description import Joint, Mechanism
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import Frame
from symscrew.kinematics.pairs import Site
from symscrew.kinematics.tree import GROUND, Link, Tree


def link_frames(mechanism: Mechanism, tree: Tree, geometry: Geometry) -> tuple[Frame, ...]:
    """The frame of every link of the tree."""
    frames: list[Frame] = [Frame(IDENTITY, ZERO, IDENTITY, ZERO, ZERO, geometry.tape.zero)]
    for link in tree.links[1:]:
        outboard = _Outboard(mechanism, tree, geometry, link)
        site = Site(
            geometry,
            frames[link.parent],
            link.parent == GROUND,
            tree.joints[link.joint],
            link.position,
            link.inverted,
            outboard.points,
            outboard.axes,
        )
        frames.append(link.pair.frame(site))
    return tuple(frames)


@dataclass(frozen=True)
class _Outboard:
    """What leaves a link outwards."""

    mechanism: Mechanism
    tree: Tree
    geometry: Geometry
    link: Link

    def joints(self) -> Iterator[tuple[Joint, int | None]]:
        """(joint, index of its first axis seen from the link)."""
        tree, link = self.tree, self.link
        if not link.bodies:  # inside a compound joint: its next motion
            following = next(other for other in tree.links if other.parent == link.index)
            yield tree.joints[link.joint], following.motion.axis
            return
        for child in tree.links:
            if child.parent == link.index:
                yield tree.joints[child.joint], child.motion.axis
        for joint in tree.cut:
            for body, position in ((joint.parent, 0), (joint.child, -1)):
                if body in link.bodies:
                    yield joint, (position if joint.axes else None)

    def points(self) -> Iterator[Vector]:
        """Points of the joints, then centres of mass, absolute."""
        for joint, _ in self.joints():
            yield self.geometry.vector(joint.point)
        for body in self.link.bodies:
            com = self.mechanism.bodies[body].com
            if com is not None:
                yield self.geometry.vector(com)

    def axes(self) -> Iterator[Vector]:
        """First axes of the joints, absolute."""
        for joint, index in self.joints():
            if index is not None and joint.axes:
                yield self.geometry.motion_axes(joint)[index]
