"""Kinematic functions: poses, twists, screws, Jacobians, joint displacements and rates."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import Node, Twist, Vector, add, cross, dot, revolute, transpose
from symscrew.description import Joint
from symscrew.functions.ports import (
    TWIST_LABELS,
    TWIST_RATE_UNITS,
    TWIST_UNITS,
    a_port,
    columns_port,
    function,
    length_units,
    q_port,
    ratio_units,
    u_port,
    v_port,
)
from symscrew.kinematics import (
    GROUND,
    BodyMotion,
    Cut,
    System,
    body_motions,
    cut_displacement,
    displacement,
    joint_screws,
    pair_of,
    tree_displacement,
    turns_are_lost,
)
from symscrew.program import Function, Port, lower


class Motion:
    """Screws, twists and their rates of a system at O in absolute axes, derived once for all functions."""

    def __init__(self, system: System) -> None:
        self.system = system
        self.screws = joint_screws(system.linkage)
        self.w = system.joint_rates(system.inputs.v)
        self.w_dot = system.joint_rates(system.inputs.a)
        self.links: tuple[BodyMotion, ...] = body_motions(system.tree, self.screws, self.w, self.w_dot)

    def body(self, name: str) -> BodyMotion:
        """Motion of a body."""
        return self.links[self.system.tree.link_of_body[name]]


def kinematic_functions(system: System, motion: Motion) -> list[Function]:
    """All kinematic functions that need no loop to be solved."""
    return [
        _body_poses(system),
        _body_twists(system, motion),
        _body_twist_rates(system, motion),
        *_points(system, motion),
        _joint_screws(system, motion),
        _joint_points(system),
        *_jacobians(system, motion),
        _joint_displacements(system),
        _joint_rates(system, motion),
        *([_drive_rates(system, motion)] if system.drives else []),
    ]


def moving_bodies(system: System) -> list[str]:
    """All bodies but the ground, in the order of the description."""
    return [name for name in system.mechanism.bodies if name != system.mechanism.ground]


def _body_poses(system: System) -> Function:
    bodies = moving_bodies(system)
    values: list[object] = []
    for name in bodies:
        link = system.tree.link_of_body[name]
        moved = displacement(system.frames[link], system.pose[link])
        values += [*(c for column in transpose(moved.rotation) for c in column), *moved.translation]
    labels = [f"R{i}{j}" for j in "xyz" for i in "xyz"] + ["x", "y", "z"]
    port = columns_port(
        "poses",
        bodies,
        labels,
        ("1",) * 9 + ("m",) * 3,
        description="per body: rotation (column-major) and translation",
    )
    text = "Displacement of every body from the reference configuration: x = R x_reference + t, absolute axes."
    return function(system, "body_poses", text, inputs=[(q_port(system), system.inputs.q)], outputs=[(port, values)])


def _state(system: System) -> list[tuple[Port, Sequence[Node]]]:
    return [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v)]


def _full_state(system: System) -> list[tuple[Port, Sequence[Node]]]:
    return [*_state(system), (a_port(system), system.inputs.a)]


def _body_twists(system: System, motion: Motion) -> Function:
    bodies = moving_bodies(system)
    values = [c for name in bodies for c in motion.body(name).twist.components]
    port = columns_port("twists", bodies, TWIST_LABELS, TWIST_UNITS, description="twist (omega ; v_O) of every body")
    return function(
        system, "body_twists", "Twists at O in absolute axes, eq. (6).", inputs=_state(system), outputs=[(port, values)]
    )


def _body_twist_rates(system: System, motion: Motion) -> Function:
    bodies = moving_bodies(system)
    values = [c for name in bodies for c in motion.body(name).rate.components]
    port = columns_port("twist_rates", bodies, TWIST_LABELS, TWIST_RATE_UNITS, description="rate of every body's twist")
    text = "Componentwise time derivatives of the twists at O, by the screw bracket."
    return function(system, "body_twist_rates", text, inputs=_full_state(system), outputs=[(port, values)])


def _points(system: System, motion: Motion) -> list[Function]:
    points = system.mechanism.points
    if not points:
        return []
    places = []
    for point in points.values():
        link = system.tree.link_of_body[point.body]
        places.append((link, system.local_point(link, system.geometry.vector(point.at))))
    names = list(points)
    ports = (
        columns_port("positions", names, "xyz", ("m",) * 3, description="absolute positions of the named points"),
        columns_port("velocities", names, "xyz", ("m/s",) * 3, description="their velocities"),
        columns_port("accelerations", names, "xyz", ("m/s^2",) * 3, description="their accelerations"),
    )
    ways = [
        list(zip(ports, way, strict=True)) for way in (_by_bodies(system, motion, places), _carried(system, places))
    ]
    positions = "Positions of the named points in absolute axes."
    motions = "Positions, velocities and accelerations of the named points in absolute axes."
    q = [(q_port(system), system.inputs.q)]
    return [
        _shortest([function(system, "forward_kinematics", positions, inputs=q, outputs=way[:1]) for way in ways]),
        _shortest([function(system, "point_motion", motions, inputs=_full_state(system), outputs=way) for way in ways]),
    ]


def _shortest(ways: Sequence[Function]) -> Function:
    """Of equal functions the one with the fewest operations."""
    return min(ways, key=lambda way: lower(way).operations["total"])


def _by_bodies(system: System, motion: Motion, points: Sequence[tuple[int, Vector]]) -> list[list[Node]]:
    """Positions, velocities, accelerations of points of links, by the links' poses, twists at O and their rates."""
    positions: list[object] = []
    velocities: list[object] = []
    accelerations: list[object] = []
    for link, local in points:
        at = system.pose[link].point(local)
        positions += at
        velocities += motion.links[link].twist.velocity_at(at)
        accelerations += acceleration_at(motion.links[link], at)
    return [[system.tape.node(entry) for entry in part] for part in (positions, velocities, accelerations)]


def _carried(system: System, points: Sequence[tuple[int, Vector]]) -> list[list[Node]]:
    """The same, from the links' own axes to the ground link by link."""
    linkage, rates = system.linkage, system.rates(system.inputs.a)
    positions: list[object] = []
    velocities: list[object] = []
    accelerations: list[object] = []
    for link, local in points:
        positions += linkage.carry_point(link, GROUND, local)
        velocities += linkage.carry(link, GROUND, system.twist[link].velocity_at(local))
        accelerations += linkage.carry(link, GROUND, rates[link].at(local))
    return [[system.tape.node(entry) for entry in part] for part in (positions, velocities, accelerations)]


def acceleration_at(motion: BodyMotion, at: Vector) -> Vector:
    """Acceleration [m/s^2] of the body's material point that is now at `at`, from twist and twist rate at O.

    a = dv_O/dt + alpha x r + omega x (v_O + omega x r), absolute axes: the rate of v_O alone is no acceleration of a
    point, as v_O belongs to another point of the body at every time.
    """
    field = motion.rate.velocity_at(at)
    return add(field, cross(motion.twist.angular, motion.twist.velocity_at(at)))


def all_joint_screws(system: System, motion: Motion) -> dict[str, tuple[Twist, ...]]:
    """Unit screws of every joint of the description, cut ones included, from parent to child."""
    cut = {c.joint.name: c for c in system.cuts}
    result = {}
    for name, joint in system.mechanism.joints.items():
        if name in cut:
            result[name] = _cut_screws(system, cut[name])
        else:
            result[name] = _tree_screws(system, motion, joint)
    return result


def _tree_screws(system: System, motion: Motion, joint: Joint) -> tuple[Twist, ...]:
    links = system.tree.links_of(joint.name)
    if links and links[0].inverted:
        return tuple(-1 * screw for link in reversed(links) for screw in motion.screws[link.index])
    return tuple(screw for link in links for screw in motion.screws[link.index])


def _cut_screws(system: System, cut: Cut) -> tuple[Twist, ...]:
    tip, hub = system.pose[cut.tip], system.pose[cut.hub]
    parent, child = (tip, hub) if cut.tip_is_parent else (hub, tip)
    parent_axes, child_axes = (cut.tip_axes, cut.hub_axes) if cut.tip_is_parent else (cut.hub_axes, cut.tip_axes)
    at = tip.point(cut.tip_point)
    pitch = system.geometry.scalar(cut.joint.pitch) if cut.joint.kind.helical else system.tape.zero
    screws: list[Twist] = []
    turns = 0
    for motion in cut.joint.kind.motions:
        if motion.spherical:
            link = cut.tip if cut.tip_is_parent else cut.hub
            carried = displacement(system.frames[link], system.pose[link]).rotation
            screws += [revolute(axis, at) for axis in transpose(carried)]
            continue
        index, second = motion.axis or 0, motion.revolute and turns == 1
        axis = child.direction(child_axes[index]) if second else parent.direction(parent_axes[index])
        turns += motion.revolute
        screws += pair_of(motion).screws(axis, at, pitch)
    return tuple(screws)


def joint_freedom_labels(system: System) -> list[tuple[str, str, str]]:
    """(label, kind, joint) of every freedom of every joint of the description."""
    return [
        (label, "length" if motion.prismatic else "angle", name)
        for name, joint in system.mechanism.joints.items()
        for label, motion in zip(joint.kind.freedom_names(name), joint.kind.freedoms, strict=True)
    ]


def _joint_screws(system: System, motion: Motion) -> Function:
    values = [c for screws in all_joint_screws(system, motion).values() for s in screws for c in s.components]
    found = joint_freedom_labels(system)
    units = ratio_units(("rad",) * 3 + ("m",) * 3, ["m" if kind == "length" else "rad" for _, kind, _ in found])
    entries = tuple(f"{label}.{entry}" for label, _, _ in found for entry in TWIST_LABELS)
    text = "unit screw of every joint freedom: (e ; r x e) of a turn, (0 ; e) of a slide"
    port = Port("screws", (6, len(found)), units, entries, text)
    text = "Unit screws of all joints at O in absolute axes, eq. (5); spherical: along the parent's axes."
    return function(system, "joint_screws", text, inputs=[(q_port(system), system.inputs.q)], outputs=[(port, values)])


def _joint_points(system: System) -> Function:
    values: list[object] = []
    cut = {c.joint.name: c for c in system.cuts}
    for name, joint in system.mechanism.joints.items():
        if name in cut and not joint.kind.slides:  # else its point moves on the parent, which may be the tip
            values += system.pose[cut[name].tip].point(cut[name].tip_point)
            continue
        link = system.tree.link_of_body[joint.child]
        values += system.pose[link].point(system.local_point(link, system.geometry.vector(joint.point)))
    names = list(system.mechanism.joints)
    port = columns_port("points", names, "xyz", ("m",) * 3, description="absolute position of every joint's point")
    text = "Positions of the joints' points, carried by the child body: where the joint reactions act."
    return function(system, "joint_points", text, inputs=[(q_port(system), system.inputs.q)], outputs=[(port, values)])


def _jacobians(system: System, motion: Motion) -> list[Function]:
    """Tree Jacobian of the platform (or last body): its twist at O as a matrix on v."""
    tree = system.tree
    body = system.mechanism.platform or moving_bodies(system)[-1]
    columns: dict[int, Twist] = {}
    for index in tree.path(tree.link_of_body[body]):
        link = tree.links[index]
        screws = motion.screws[index]
        if link.motion.spherical:
            # columns for v (child axes): the screws along the parent's axes combined by the rotation
            turn = system.placed[index].turn
            for k, column in enumerate(transpose(turn)):
                columns[link.v.start + k] = screws[0] * column[0] + screws[1] * column[1] + screws[2] * column[2]
        else:
            for k, screw in zip(range(link.v.start, link.v.stop), screws, strict=True):
                columns[k] = screw
    zero = (0,) * 6
    values = [c for k in range(len(tree.v)) for c in (columns[k].components if k in columns else zero)]
    units = ratio_units(("rad",) * 3 + ("m",) * 3, length_units(system))
    labels = tuple(f"{c.label}.{label}" for c in tree.v for label in TWIST_LABELS)
    port = Port("jacobian", (6, len(tree.v)), units, labels, f"twist of {body} at O per rate of the tree")
    text = f"Screw Jacobian of {body}: twist at O = jacobian v."
    return [
        function(
            system, "platform_jacobian", text, inputs=[(q_port(system), system.inputs.q)], outputs=[(port, values)]
        )
    ]


# -- displacements and rates of all joints --------------------------------------------------------------


def _joint_displacements(system: System) -> Function:
    values = []
    cut = {c.joint.name: c for c in system.cuts}
    for name, joint in system.mechanism.joints.items():
        values += cut_displacement(system, cut[name]) if name in cut else tree_displacement(system, joint)
    labels = joint_freedom_labels(system)
    units = tuple("m" if kind == "length" else "rad" for _, kind, _ in labels)
    port = Port("displacements", (len(labels),), units, tuple(label for label, _, _ in labels), "all joints")
    text = "Displacements of all joints, cut ones included; spherical joints as rotation vector in the parent's axes."
    inputs = [(q_port(system), system.inputs.q)]
    wrapped = [c.joint.name for c in system.cuts if turns_are_lost(c, system.linkage, system.geometry)]
    notes = [f"within half a turn, as a pose tells no whole turns: {', '.join(wrapped)}"] if wrapped else []
    return function(system, "joint_displacements", text, inputs=inputs, outputs=[(port, values)], notes=notes)


def ball_notes(system: System) -> tuple[str, ...]:
    """The balls whose coordinates describe the joint's parent against its child, as the tree comes from there."""
    links = (link for link in system.tree.links if link.inverted and link.motion.spherical)
    if names := sorted({link.joint for link in links}):
        return (
            f"balls that are reached by their child: {', '.join(names)}; quaternion, rates, displacement and drive are "
            "those of the parent against the child",
        )
    return ()


def rates_of_joints(system: System, motion: Motion) -> dict[str, list[Node]]:
    """Rates of the freedoms of every joint, cut ones included."""
    result: dict[str, list[Node]] = {}
    cut = {c.joint.name: c for c in system.cuts}
    for name in system.mechanism.joints:
        if name in cut:
            result[name] = _cut_rates(system, motion, cut[name])
            continue
        links = system.tree.links_of(name)
        ordered = links[::-1] if links and links[0].inverted else links
        result[name] = [rate for link in ordered for rate in motion.w[link.v]]
    return result


def _drive_rates(system: System, motion: Motion) -> Function:
    every = rates_of_joints(system, motion)
    force = u_port(system)
    units = tuple("m/s" if unit == "N" else "rad/s" for unit in force.units)
    port = Port("rates", force.shape, units, force.labels, "rates of the driven freedoms; power = u . rates")
    text = "Rates of the driven freedoms, in the order of u."
    values = [every[joint][freedom] for joint, freedom in system.drives]
    return function(system, "drive_rates", text, inputs=_state(system), outputs=[(port, values)])


def _joint_rates(system: System, motion: Motion) -> Function:
    values = [rate for rates in rates_of_joints(system, motion).values() for rate in rates]
    labels = joint_freedom_labels(system)
    units = tuple("m/s" if kind == "length" else "rad/s" for _, kind, _ in labels)
    port = Port("rates", (len(labels),), units, tuple(label for label, _, _ in labels), "all joints")
    text = "Rates of all joints, cut ones included; spherical joints along the parent's axes."
    return function(system, "joint_rates", text, inputs=_state(system), outputs=[(port, values)])


def _cut_rates(system: System, motion: Motion, cut: Cut) -> list[Node]:
    """Relative twist of child against parent, resolved along the joint's screws."""
    parent = motion.links[cut.tip if cut.tip_is_parent else cut.hub].twist
    child = motion.links[cut.hub if cut.tip_is_parent else cut.tip].twist
    relative = child - parent
    screws = _cut_screws(system, cut)
    if cut.joint.kind.ball:
        return [dot(screw.angular, relative.angular) for screw in screws]
    if len(cut.joint.kind.turning) == 2:
        e1, e2 = screws[0].angular, screws[1].angular
        skew = dot(e1, e2)
        one, two = dot(e1, relative.angular), dot(e2, relative.angular)
        scale_back = 1 / (1 - skew * skew) if skew is not system.tape.zero else 1
        return [(one - skew * two) * scale_back, (two - skew * one) * scale_back]
    at = system.pose[cut.tip].point(cut.tip_point)
    slide = relative.velocity_at(at)
    return [
        dot(screw.linear, slide) if motion.prismatic else dot(screw.angular, relative.angular)
        for motion, screw in zip(cut.joint.kind.motions, screws, strict=True)
    ]
