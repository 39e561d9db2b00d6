"""All joint reactions at once, and which of them an overconstrained mechanism leaves undetermined.

With drives and multipliers known, one pass from the tips to the ground gives the wrench through every
joint. Multipliers that equilibrium leaves free are internal loads of redundant constraints: they take the
values that make the sum of squares of all reactions smallest (moments about the joints' points, divided by
the characteristic length), and every component that they touch is reported as not unique.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from symscrew.algebra import (
    NEGLIGIBLE,
    ZERO,
    Affine,
    Column,
    Guard,
    Node,
    Pose,
    Vector,
    add,
    cross,
    magnitude,
    named_wrench,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.dynamics.drives import solve_symmetric
from symscrew.dynamics.equilibrium import Balance
from symscrew.dynamics.setting import ONE, Setting, Wrenches, accumulate
from symscrew.kinematics import GROUND, Link


@dataclass(frozen=True)
class JointWrench:
    """Reaction of a joint per column (1 and free multipliers), at `point` in the axes of `rotation`'s source.

    `rotation` maps those axes to absolute axes; `position` is the point in absolute coordinates.
    """

    joint: str
    columns: Wrenches
    pose: Pose


@dataclass(frozen=True)
class Reactions:
    """Reactions from parent on child (f ; m_O), absolute axes, per joint; components that are not unique."""

    wrenches: dict[str, tuple[Vector, Vector]]
    free: int
    not_unique: tuple[str, ...]
    guards: tuple[Guard, ...]


def numeric_multipliers(setting: Setting, balance: Balance, u: Sequence[Node]) -> dict[Column, Affine]:
    """Multipliers with the drives put in: columns 1 and free multipliers only."""
    result = {}
    for key, affine in balance.multipliers.items():
        total: Affine = {}
        for column, entry in affine.items():
            if isinstance(column, tuple) and column[0] == "drive":
                column, entry = ONE, entry * u[column[1]]
            total[column] = total[column] + entry if column in total else entry
        setting.name_multiplier(key, total)
        result[key] = total
    return result


def joint_wrenches(
    setting: Setting,
    pose: Sequence[Pose],
    *,
    wrench: Callable[[Link], tuple[Vector, Vector]],
    loads: Mapping[int, tuple[Vector, Vector]],
    multipliers: Mapping[Column, Affine],
    u: Sequence[Node],
) -> list[JointWrench]:
    """The wrench through every joint on its tip or child, at the joint's point, without the drives' shares.

    Args:
        setting: the tree, its cuts and drives.
        pose: absolute_T_link of every link.
        wrench: the inertial wrench of a link less what acts on it, link axes, at its origin.
        loads: further wrenches on links, axes before their motions, at their origins.
        multipliers: of the cut joints, as sums over column 1 and free multipliers.
        u: forces and torques of the drives on their joints [N, N m].
    """
    tree, setting = setting.tree, replace(setting, called="transmitted")

    def with_drives(c: int) -> Wrenches:
        return setting.cut_wrench(c, multipliers, lambda k: {ONE: u[k]})

    waiting: dict[int, Wrenches] = {link.index: {} for link in tree.links}
    result: dict[str, JointWrench] = {}
    for c, cut in enumerate(setting.cuts):
        if cut.relation is not None:
            result[cut.joint.name] = _tie(setting, c, multipliers["multiplier", c, 0])
            continue
        at_tip = setting.cut_wrench(c, multipliers, lambda _: {})
        sign = -1 if cut.tip_is_parent else 1
        place = Pose(pose[cut.tip].rotation, pose[cut.tip].point(cut.tip_point))
        signed: Wrenches = {k: (scale(sign, f), scale(sign, m)) for k, (f, m) in at_tip.items()}
        result[cut.joint.name] = _named(JointWrench(cut.joint.name, signed, place))
        for column, (f, m) in with_drives(c).items():
            if cut.tip != GROUND:
                accumulate(waiting[cut.tip], column, scale(-1, f), scale(-1, add(m, cross(cut.tip_point, f))))
    for link in reversed(tree.links[1:]):
        here = waiting.pop(link.index)
        accumulate(here, ONE, *wrench(link))
        before = setting.before_motion(link, here, loads, with_drives)
        placed = setting.placed[link.index]
        joint = tree.joints[link.joint]
        last = tree.links_of(joint.name)[-1]
        if link is last and joint.name != tree.virtual and not joint.kind.unconstrained:  # which transmits nothing
            known = partial(_known_shares, setting, multipliers, u)
            result[joint.name] = _tree_reaction(setting, pose, link, before=before, known=known)
        for column, (f, m) in before.items():
            f, m = transform(placed.rotation, f), transform(placed.rotation, m)
            if link.parent != GROUND:
                accumulate(waiting[link.parent], column, f, add(m, cross(placed.offset, f)))
    return list(result.values())


def _tie(setting: Setting, c: int, multiplier: Affine) -> JointWrench:
    """The multiplier of a coupling as a force or moment along x: what it weighs, and where it is read."""
    tape, row = setting.tape, setting.cuts[c].rows[0]
    columns: Wrenches = {}
    for column, factor in multiplier.items():
        along = (factor, tape.zero, tape.zero)
        accumulate(columns, column, *((along, ZERO) if row.unit == "N" else (ZERO, along)))
    return JointWrench(setting.cuts[c].joint.name, columns, Pose())


def _tree_reaction(
    setting: Setting, pose: Sequence[Pose], link: Link, *, before: Wrenches, known: Callable[[int], Affine]
) -> JointWrench:
    """What the joint transmits, its own freedoms cleared: passive ones carry nothing, driven ones the drive."""
    placed, parent = setting.placed[link.index], pose[link.parent]
    sign = -1 if link.inverted else 1
    rotation = Pose(parent.rotation) @ Pose(placed.rotation)
    place = Pose(rotation.rotation, pose[link.index].translation)
    frame = replace(setting.frames[link.index], arm=_arm(setting, pose, link, place))
    columns: Wrenches = {}
    for column, (force, moment) in before.items():
        f, m = link.pair.cleared(frame, force, moment)
        columns[column] = scale(sign, f), scale(sign, m)
    _remove_known(setting, pose, link, columns=columns, place=place, arm=frame.arm, known=known)
    return _named(JointWrench(link.joint, columns, place))


def _arm(setting: Setting, pose: Sequence[Pose], last: Link, place: Pose) -> Vector:
    """From a place on the last link of a joint to where its sliders push: its point, which the child carries."""
    kind, arm = setting.tree.joints[last.joint].kind, setting.frames[last.index].arm
    if len(kind.sliding) < 2:  # one axis, with which all links are in line
        return arm if last.motion.prismatic else ZERO
    if not last.inverted:
        return arm
    turning = next(link for link in setting.tree.links_of(last.joint) if link.motion.turns)
    point = pose[turning.index].point(setting.frames[turning.index].arm)
    return transform(transpose(place.rotation), subtract(point, place.translation))


def _named(joint: JointWrench) -> JointWrench:
    """A joint's wrench, called so."""
    for column, wrench in joint.columns.items():
        named_wrench(wrench, "joint_reaction", joint.joint, by="" if column == ONE else str(column))
    return joint


def _known_shares(setting: Setting, multipliers: Mapping[Column, Affine], u: Sequence[Node], k: int) -> Affine:
    """What drives, known forces and couplings exert on a freedom of the tree, per column."""
    drive, force = setting.drives.get(k), setting.joint_forces.get(k)
    found: Affine = {}
    for share in (None if drive is None else u[drive], force):
        if share is not None:
            found[ONE] = found[ONE] + share if ONE in found else share
    for c, entry in setting.ties.get(k, ()):
        for column, factor in multipliers["multiplier", c, 0].items():
            found[column] = found.get(column, setting.tape.zero) + entry * factor
    return found


def _remove_known(
    setting: Setting,
    pose: Sequence[Pose],
    last: Link,
    *,
    columns: Wrenches,
    place: Pose,
    arm: Vector,
    known: Callable[[int], Affine],
) -> None:
    """Take what acts on a joint's other motions (compound, helical) along them out of what it transmits.

    `arm`: from the place to where sliders push, in its axes.
    """
    sign = -1 if last.inverted else 1
    for link in setting.tree.links_of(last.joint):
        if not link.motion.single or (link is last and not link.motion.helical):
            continue
        for column, share in known(link.v.start).items():
            if link.motion.prismatic:
                axis = pose[link.parent].direction(setting.frames[link.index].axis)
            else:
                axis = transpose(pose[link.index].rotation)[2]
            local = scale(-sign * share, transform(transpose(place.rotation), axis))
            accumulate(columns, column, *((local, cross(arm, local)) if link.motion.prismatic else (ZERO, local)))


def solve_reactions(setting: Setting, found: Sequence[JointWrench], free: Sequence[Column]) -> Reactions:
    """Reactions (f ; m_O), absolute axes, with the free multipliers of an overconstrained mechanism put in.

    They take the values for which the sum of squares over all joints, at their points and with moments divided by the
    characteristic length, is smallest. Joints whose reaction depends on this choice are named.
    """
    guards: tuple[Guard, ...] = ()
    amounts: dict[Column, Node] = {}
    if free:
        amounts, guards = _smallest(setting, found, free)
    wrenches: dict[str, tuple[Vector, Vector]] = {}
    touched: list[str] = []
    for joint in found:
        total: Wrenches = {}
        for column, (f, m) in joint.columns.items():
            factor = setting.tape.one if column == ONE else amounts[column]
            accumulate(total, ONE, scale(factor, f), scale(factor, m))
        found_at_o = at_origin(joint.pose, *total.get(ONE, (ZERO, ZERO)))
        wrenches[joint.joint] = named_wrench(found_at_o, "reaction", joint.joint)
        touched += _not_unique(setting, joint, free)
    return Reactions(wrenches, len(free), tuple(touched), guards)


def at_origin(pose: Pose, force: Vector, moment: Vector) -> tuple[Vector, Vector]:
    """A wrench at the pose's origin in its axes, referred to O in absolute axes."""
    f = pose.direction(force)
    return f, add(pose.direction(moment), cross(pose.translation, f))


def _smallest(
    setting: Setting, found: Sequence[JointWrench], free: Sequence[Column]
) -> tuple[dict[Column, Node], tuple[Guard, ...]]:
    """Free multipliers that minimise the weighted sum of squares of all reactions."""
    tape = setting.tape
    weight = tape.constant(1.0 / setting.length)

    def components(joint: JointWrench, column: Column) -> list[Node]:
        if column not in joint.columns:
            return [tape.zero] * 6
        force, moment = joint.columns[column]
        return [tape.node(c) for c in (*force, *scale(weight, moment))]

    stacked = {c: _sparse(n for joint in found for n in components(joint, c)) for c in (ONE, *free)}

    def inner(x: Mapping[int, Node], y: Mapping[int, Node]) -> Node:
        total = tape.zero
        for k in x if len(x) < len(y) else y:  # both ascend
            if k in x and k in y:
                total = total + x[k] * y[k]
        return total

    n = len(free)
    upper = {(i, j): inner(stacked[free[i]], stacked[free[j]]) for i in range(n) for j in range(i, n)}
    normal = [[upper[min(i, j), max(i, j)] for j in range(n)] for i in range(n)]
    right = [-inner(stacked[a], stacked[ONE]) for a in free]
    scales = [1.0 / max(1e-30, magnitude(tape, normal[i][i], 1.0)[1]) for i in range(len(free))]
    values, guards = solve_symmetric(tape, normal, right, scales)
    return dict(zip(free, values, strict=True)), guards


def _sparse(entries: Iterable[Node]) -> dict[int, Node]:
    """The entries that are not zero, by place."""
    return {k: node for k, node in enumerate(entries) if node is not node.tape.zero}


def _not_unique(setting: Setting, joint: JointWrench, free: Sequence[Column]) -> list[str]:
    """Components (f ; m_O) that change with a free multiplier at some sample state."""
    labels = ("fx", "fy", "fz", "mx", "my", "mz")
    touched = []
    scales = (1.0,) * 3 + (1.0 / setting.length,) * 3
    totals = np.zeros(6)
    for column in free:
        if column in joint.columns:
            force, moment = at_origin(joint.pose, *joint.columns[column])
            for k, entry in enumerate((*force, *moment)):
                values = np.abs(setting.tape.sample(setting.tape.node(entry))) * scales[k]
                totals[k] = max(totals[k], float(np.max(values)))
    for k, label in enumerate(labels):
        if totals[k] > 100 * NEGLIGIBLE:
            touched.append(f"{joint.joint}.{label}")
    return touched
