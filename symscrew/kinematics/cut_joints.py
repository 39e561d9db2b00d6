"""Loop closure: a cut joint contributes exactly its reciprocal wrenches.

For every cut joint the wrenches reciprocal to its screws are written in the axes of its tip link (the side
that fewer cut joints share) at the joint's point. Multiplier k times wrench k acts on the tip, its opposite
on the hub. So row k of the closure Jacobian is w_k . (V_tip - V_hub): a wrench with a name, a point and a
unit, and the same rows serve velocities, accelerations and positions (`symscrew.kinematics.loop_closure`) and the
equilibrium of forces.

    tip --tip_point--> (joint's point) <--contact-- hub
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy

from symscrew.algebra import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    cross,
    named_vector,
    product,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.description import Coupling, Joint
from symscrew.errors import DescriptionError
from symscrew.kinematics.coupled_coordinates import Relation, relation
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.rolling import Rolling, Touch, touch
from symscrew.kinematics.tree import GROUND


@dataclass(frozen=True)
class Row:
    """One reciprocal wrench at the cut point, tip axes: (force ; couple), with its multiplier's label.

    Not `holonomic`: it constrains rates alone, and no function of the coordinates has what it allows.
    """

    label: str
    unit: str
    force: Vector
    couple: Vector
    holonomic: bool = True


@dataclass(frozen=True)
class Cut:
    """A cut joint: its links, its point in both, the axes it has in both, and its rows.

    `hub_point` is the joint's point in the hub, `contact` the hub's point that is now at the tip's point (the
    same unless the joint slides), `arm` the way to it from the hub's origin through the limb, in tip axes (None:
    it is better seen through the hub). A coupling of coordinates is among them as well: it has a `relation` in place of
    all that, holds no bodies together, and its row has no wrench. So is a body that rolls on another: it has a `touch`,
    and its point in either link moves over it. Neither has axes. `triad` holds in its rows two unit vectors across the
    joint's single axis and the axis, tip axes. `reference` is hub_R_tip in the reference configuration. The rows of
    `parent_axes` are the absolute axes of the reference configuration, carried by the joint's parent, in that link's
    axes.
    """

    joint: Joint
    tip: int
    hub: int
    tip_point: Vector
    hub_point: Vector
    contact: Vector
    tip_axes: tuple[Vector, ...] = ()
    hub_axes: tuple[Vector, ...] = ()
    triad: Matrix = IDENTITY
    reference: Matrix = IDENTITY
    parent_axes: Matrix = IDENTITY
    tip_is_parent: bool = False
    arm: Vector | None = None
    rows: tuple[Row, ...] = ()

    relation: Relation | None = None
    touch: Touch | None = None

    @property
    def is_joint(self) -> bool:
        """Whether it is a joint that was cut: no coupling, no rolling."""
        return self.relation is None and self.touch is None

    def __repr__(self) -> str:
        between = f"between links {self.hub} and {self.tip}"
        return f"Cut({self.joint.name!r}, {self.joint.type} {between}, {len(self.rows)} rows)"


def cuts(
    at: Linkage, geometry: Geometry, *, through_limbs: bool = True, rolled: Sequence[Rolling] = ()
) -> tuple[Cut, ...]:
    """Every cut joint with its reciprocal wrenches, for given placements of links whose loops are closed; couplings,
    and what is `rolled`.

    Without `through_limbs` places on a hub are seen through the hub: where limbs follow from it, that is known.
    """
    tree = at.tree
    shared = [0] * len(tree.links)
    for joint in tree.cut:
        shared[tree.link_of_body[joint.parent]] += 1
        shared[tree.link_of_body[joint.child]] += 1
    result = []
    for joint in tree.cut:
        parent, child = tree.link_of_body[joint.parent], tree.link_of_body[joint.child]
        parent_first = parent != GROUND and (shared[parent] <= shared[child] or child == GROUND)
        cut = _cut(at, geometry, joint, (parent, child) if parent_first else (child, parent))
        arm = _arm(at, cut) if through_limbs else None
        result.append(replace(cut, arm=arm and named_vector(arm, "arm", joint.name)))
    couplings = (_coupled(at, geometry, coupling) for coupling in geometry.mechanism.couplings.values())
    return (*result, *couplings, *(_rolled(at, geometry, given) for given in rolled))


def _rolled(at: Linkage, geometry: Geometry, given: Rolling) -> Cut:
    """Rolling among the cut joints: forces where the wheel touches, on it and on what it rolls on."""
    tree, found = at.tree, touch(at, geometry, given)
    tip, hub = tree.link_of_body[given.wheel.body], tree.link_of_body[given.ground.body]
    place = add(found.centre, found.arm)
    contact = at.carry_point(tip, hub, place)
    ways = [("ahead", found.along[0], False), ("aside", found.along[1], False), ("normal", found.normal, True)]
    rows = (Row(f"{given.name}.{name}", "N", way, ZERO, held) for name, way, held in ways[: 3 if given.held else 2])
    return Cut(
        joint=Joint(given.name, "free", given.ground.body, given.wheel.body, given.wheel.at),
        tip=tip,
        hub=hub,
        tip_point=place,
        hub_point=contact,
        contact=contact,
        rows=tuple(rows),
        touch=found,
    )


def _coupled(at: Linkage, geometry: Geometry, coupling: Coupling) -> Cut:
    """A coupling among the cut joints: a row of the closure that acts on freedoms, at no place."""
    found = relation(at, geometry, coupling)
    ground = geometry.mechanism.ground
    return Cut(
        joint=Joint(coupling.name, "free", ground, ground, (sympy.S.Zero,) * 3),
        tip=GROUND,
        hub=GROUND,
        tip_point=ZERO,
        hub_point=ZERO,
        contact=ZERO,
        rows=(Row(f"{coupling.name}.tie", "N" if found.sliding else "N m", ZERO, ZERO),),
        relation=found,
    )


def _cut(at: Linkage, geometry: Geometry, joint: Joint, ends: tuple[int, int]) -> Cut:
    """A cut joint between two links: its tip and its hub.

    Raises:
        DescriptionError: its type slides along an axis that then turns, so that its wrenches are at rest on neither.
    """
    if not joint.kind.closable:
        raise DescriptionError(
            f"joints.{joint.name}: a loop is cut at this joint, and the constraint of a {joint.kind.name} joint is not "
            "known there; describe it as several joints with bodies between them"
        )
    tip, hub = ends
    frames, tip_is_parent = at.frames, at.tree.link_of_body[joint.parent] == tip
    point = geometry.vector(joint.point)
    axes = geometry.motion_axes(joint) if joint.axes else ()
    local = []
    for link in ends:
        back = transpose(frames[link].axes)
        place = geometry.settle(transform(back, subtract(point, frames[link].origin)))
        local.append((place, tuple(geometry.settle(transform(back, axis)) for axis in axes)))
    (tip_point, tip_axes), (hub_point, hub_axes) = local
    cut = Cut(
        joint=joint,
        tip=tip,
        hub=hub,
        tip_point=tip_point,
        hub_point=hub_point,
        triad=_triad(geometry, tip_axes),
        parent_axes=frames[tip if tip_is_parent else hub].axes,
        reference=geometry.settle_matrix(product(transpose(frames[hub].axes), frames[tip].axes)),
        contact=at.carry_point(tip, hub, tip_point) if joint.kind.slides else hub_point,
        tip_axes=tip_axes,
        hub_axes=hub_axes,
        tip_is_parent=tip_is_parent,
    )
    named_vector(cut.contact, "contact", joint.name)
    return replace(cut, rows=reciprocal_rows(cut, at, geometry))


def _triad(geometry: Geometry, axes: tuple[Vector, ...]) -> Matrix:
    """Rows: two unit vectors across the joint's single axis, then the axis; the tip's axes if there is none."""
    if len(axes) == 3:
        return (axes[0], axes[1], axes[2])
    if len(axes) != 1:
        return IDENTITY
    axis = axes[0]
    first = geometry.perpendicular(axis)
    return (first, geometry.settle(cross(axis, first)), axis)


def reciprocal_rows(cut: Cut, at: Linkage, geometry: Geometry) -> tuple[Row, ...]:
    """The wrenches reciprocal to all screws of the joint: 6 minus its freedoms.

    A force along d at the joint's point is reciprocal to rotations through the point and to translations
    across d; a couple along d to translations and to rotations about axes across d. A helical joint adds
    the wrench (e ; -h e).
    """
    kind = cut.joint.kind
    a, b, axis = cut.triad
    rows: list[Row] = []

    def force(direction: Vector, name: str) -> None:
        rows.append(Row(f"{cut.joint.name}.f{name}", "N", direction, ZERO))

    def moment(direction: Vector, name: str) -> None:
        rows.append(Row(f"{cut.joint.name}.m{name}", "N m", ZERO, direction))

    if not kind.slides:
        for direction, name in zip(IDENTITY, "xyz", strict=True):
            force(direction, name)
    elif len(kind.sliding) == 2:
        force(axis, "z")
    else:
        force(a, "x")
        force(b, "y")
    if kind.helical:
        pitch = geometry.scalar(cut.joint.pitch)
        rows.append(Row(f"{cut.joint.name}.fz", "N", axis, scale(-pitch, axis)))
    turning = len(kind.turning)
    if turning == 0 and not kind.spherical:
        for direction, name in zip(IDENTITY, "xyz", strict=True):
            moment(direction, name)
    elif turning == 1:
        moment(a, "x")
        moment(b, "y")
    elif turning == 2:
        first, second = universal_axes(cut, at)
        moment(cross(first, second), "n")
    for row in rows:
        place, _, name = row.label.partition(".")
        named_vector(row.force, "constraint", place, prefix=f"{name}_force_")
        named_vector(row.couple, "constraint", place, prefix=f"{name}_couple_")
    return tuple(rows)


def drive_row(cut: Cut, freedom: int, at: Linkage) -> Row:
    """The unit wrench of a drive on a freedom of a cut joint: a force along, or a couple about its axis."""
    kind = cut.joint.kind
    motion = kind.freedoms[freedom]
    if motion.spherical:
        axis = cut.parent_axes[freedom - kind.freedoms.index(motion)]
        axis = axis if cut.tip_is_parent else at.carry(cut.hub, cut.tip, axis)
    elif kind.universal:
        axis = universal_axes(cut, at)[motion.axis or 0]
    else:
        axis = cut.tip_axes[motion.axis or 0]
    name = f"{cut.joint.name}.drive{freedom}"
    return Row(name, "N", axis, ZERO) if motion.prismatic else Row(name, "N m", ZERO, axis)


def universal_axes(cut: Cut, at: Linkage) -> tuple[Vector, Vector]:
    """Present axes of a cut universal joint in tip axes: the first is carried by the parent, the second by
    the child."""
    carried = tuple(at.carry(cut.hub, cut.tip, axis) for axis in cut.hub_axes)
    return (cut.tip_axes[0], carried[1]) if cut.tip_is_parent else (carried[0], cut.tip_axes[1])


def _arm(at: Linkage, cut: Cut) -> Vector | None:
    """From the hub's origin to the contact through the limb, tip axes; None where the way through the hub is shorter.

    Where the loops are closed, a hub that turns about a point of the limb's base has it through the limb just as
    well, and there most of it is constant or zero: a leg on its universal joint sees the centre in a plane of its own.
    """
    if cut.hub == GROUND:
        return None
    hub = at.tree.links[cut.hub]
    limb = at.tree.path(cut.tip)
    if not hub.motion.spherical or cut.hub in limb or hub.parent not in (GROUND, *limb):
        return None
    return subtract(cut.tip_point, at.carry_point(hub.parent, cut.tip, at.placed[cut.hub].offset))


def on_hub(cut: Cut, at: Linkage, force: Vector, couple: Vector) -> tuple[Vector, Vector]:
    """A wrench at the cut joint (tip axes) as force and moment about the hub's origin, axes before the hub's motion."""
    if cut.arm is not None:
        couple = add(couple, cross(cut.arm, force))
    force, couple = (at.carry(cut.tip, cut.hub, vector, before=True) for vector in (force, couple))
    if cut.arm is None:
        couple = add(couple, cross(at.placed[cut.hub].before(cut.contact), force))
    return force, couple
