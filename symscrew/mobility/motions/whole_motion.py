"""Along the motion: what holds on all of the branch that was looked at, and its singular poses.

smooth configuration --coordinate_lines--> poses --tangents--> type, joints at rest, axes: WholeMotion
                                         --singular_poses--> where it is singular
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.finite import FiniteMobility
from symscrew.mobility.instantaneous import BodyFreedoms
from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions.coordinate_lines import (
    STRIDE,
    Pose,
    Setting,
    Track,
    independent_columns,
    pose_at,
    poses_next_to,
    track,
    tracks,
)
from symscrew.mobility.motions.held_spins import HeldSpins
from symscrew.mobility.motions.seen_poses import Closures, Seen, body_twists, in_doubles, seen_at
from symscrew.mobility.motions.singular_poses import SingularPose, lost_lines, singular_poses
from symscrew.mobility.motions.whole_branch import CommonGroup, common_group
from symscrew.mobility.screw_classes import ScrewClass

Array = np.ndarray[Any, Any]

EVERY = 7
"""Of the poses on the lines each seventh is asked for its screw system: 15 in a turn."""
BESIDE = 8
"""Poses off the lines: a line from a symmetric reference keeps a plane of symmetry, and with it what holds there only,
such as a principal pitch of zero of a 3-PRS."""
PRECISE = 8
"""Poses that are decided with 60 digits where doubles see what is not so as typed: each takes a tenth of a second."""
AROUND = 6
"""Poses next to the reference that show how many freedoms the body has at most poses."""
SEED = 22
"""Of the directions to the poses off the lines: always the same, so that results repeat."""
LOST = 1e-7
"""Singular value of a limb's unit screws at the reference that counts as none."""
CLEAR = 1e-4
"""Poses nearer to a singularity than this, as a part of the median of the margin, are no generic ones."""


@dataclass(frozen=True)
class WholeMotion:
    """The motion along the coordinate lines through a smooth configuration.

    Attributes:
        columns: freedoms that are the independent coordinates.
        poses: number of poses that were looked at on the lines.
        beside: number of poses beside them.
        classes: classes of the platform's freedoms at regular poses, the most frequent first.
        constant: whether there is one class, with the same principal pitches everywhere.
        idle: joints that never move.
        axes: joint axes that are axes of the platform's freedoms at every regular pose -> why that is proved, or "".
        singular: singular poses.
        ends: how each line ended, by column and direction.
        group: what the groups of all chains to the body have in common; None where that was not asked.
        type_proof: why the first class is that of every regular pose of the branch; empty where that was only seen.
        idle_proof: why the joints `idle` never move on the whole branch; empty where that was only seen.
        lost: (column, kind) of what is lost all along the line of that coordinate.
    """

    columns: tuple[int, ...]
    poses: int
    beside: int
    classes: tuple[ScrewClass, ...]
    constant: bool
    idle: tuple[str, ...]
    axes: Mapping[str, str]
    singular: tuple[SingularPose, ...]
    ends: tuple[tuple[int, int, str], ...]
    group: CommonGroup | None = None
    type_proof: str = ""
    idle_proof: str = ""
    lost: tuple[tuple[int, str], ...] = ()

    def locked(self, mechanism: Mechanism) -> Mechanism:
        """The mechanism with the joints `idle` replaced by such as cannot move."""
        none = {"type": "fixed", "axes": (), "pitch": None, "driven": (), "reference": ()}
        fixed = {name: replace(mechanism.joints[name], **none) for name in self.idle}  # type: ignore[arg-type]
        return replace(mechanism, joints={**mechanism.joints, **fixed})

    def at_rest(self, mechanism: Mechanism, network: Network, body: str) -> WholeMotion:
        """With what follows where the mechanism with the joints `idle` locked is as mobile: they rest on the branch.

        Its chains have smaller groups, in which the body moves, too.
        """
        group = common_group(mechanism, network, body)
        smaller = group is not None and (self.group is None or group.system.order < self.group.system.order)
        why = "with them locked there are as many freedoms"
        if group is None or not smaller:
            return replace(self, idle_proof=why)
        proof = _type_proof(group, self.classes, None)
        return replace(self, idle_proof=why, group=group, type_proof=proof or self.type_proof)


def motion_along(
    network: Network, finite: FiniteMobility, platform: BodyFreedoms, mechanism: Mechanism, *, exact: bool
) -> WholeMotion | str:
    """What holds along the coordinate lines through the configuration and the singular poses on them; or why not.

    Args:
        network: the configuration.
        finite: what really moves: lines are followed from smooth points only.
        platform: the body and its freedoms in the configuration.
        mechanism: whose limbs.
        exact: whether these freedoms were decided over the exact field.
    """
    if finite.dof is None or not finite.smooth:
        return "the configuration is no smooth point: its branches are in the table, --at goes to one of them"
    limbs = {name: limb.joints for name, limb in mechanism.limbs.items()}
    if not finite.dof:
        return "nothing moves"
    body = platform.body
    found = _followed(network, finite.dof, body, limbs, group=common_group(mechanism, network, body))
    if isinstance(found, str):
        return found
    proof = _type_proof(found.group, found.classes, platform.dof if exact else None)
    if found.group is None or not proof:
        return found
    axes = {name: why or _held(network, name, found.group) for name, why in found.axes.items()}
    return replace(found, type_proof=proof, axes=axes)


def _followed(
    network: Network, dimension: int, body: str, limbs: Mapping[str, tuple[str, ...]], *, group: CommonGroup | None
) -> WholeMotion | str:
    variety = HeldSpins(network, body)
    origin, others = np.zeros(variety.columns), dimension - len(variety.ends)
    if not others:
        return "nothing but passive spins moves"
    first = Setting(network, variety, others, body, 0, network.driven, {})
    pose = pose_at(first, origin, (), None)
    setting = Setting(network, variety, others, body, _generic_order(first), network.driven, _limbs(network, limbs))
    columns = independent_columns(network, pose.motions, network.driven)
    ways = [(column, tuple(c for c in columns if c != column), sign) for column in columns for sign in (1, -1)]
    lines = tracks(setting, ways)
    length, closures = float(network.length), Closures(network)
    regular, typical = _regular(lines)
    beside = _beside(setting, regular, typical)
    seen = _decided(closures, [pose.q for pose in (*regular, *beside)], dimension, body)
    if not seen:
        return "no coordinate line could be followed to a regular pose"
    if group is not None and not all(group.holds(one.twists.T.astype(float), length) for one in seen):
        group = None  # a proof that the poses contradict is none
    classes: dict[tuple[str, str], list[ScrewClass]] = {}
    for one in seen:
        classes.setdefault(one.name, []).append(one.system)
    order = sorted(classes.values(), key=len, reverse=True)
    pitches = [c.pitches for group in order for c in group]
    same = len(order) == 1 and all(np.allclose(p, pitches[0], rtol=1e-6, atol=1e-6 * length) for p in pitches)
    idle = tuple(name for name in network.edges if all(name in one.resting(network) for one in seen))
    common = set[str].intersection(*(set(one.axes) for one in seen))
    axes = {name: _proof(network, body, name, order[0][0]) for name in sorted(common)}
    ends = tuple((t.column, 1 if k % 2 == 0 else -1, t.end) for k, t in enumerate(lines))
    total = sum(len(t.poses) for t in lines)
    classes_seen = tuple(g[0] for g in order)
    return WholeMotion(columns, total, len(beside), classes_seen, same, idle, axes, singular_poses(setting, lines),
                       ends, group, lost=lost_lines(lines))  # fmt: skip


def _decided(closures: Closures, poses: list[Array], dimension: int, body: str) -> list[Seen]:
    """What the body does at each pose: of what doubles take for one class the first and the last in 60 digits, too.

    Where these are not of that class, some of its poses are decided in 60 digits, and the others left out.
    """
    alike: dict[tuple[str, str], list[int]] = {}
    decided, left_out = dict[int, Seen](), set[int]()
    seen = [in_doubles(closures, q, dimension, body) for q in poses]
    for k, one in enumerate(seen):
        alike.setdefault(one.name, []).append(k)
    for name, members in alike.items():
        ends = {k: seen_at(closures, poses[k], dimension, body) for k in {members[0], members[-1]}}
        if any(one.name != name for one in ends.values()):
            left_out |= set(members)
            some = members[:: max(1, len(members) // PRECISE)]
            ends |= {k: seen_at(closures, poses[k], dimension, body) for k in some if k not in ends}
        decided |= ends
    return [decided.get(k) or one for k, one in enumerate(seen) if k in decided or k not in left_out]


def _type_proof(group: CommonGroup | None, classes: tuple[ScrewClass, ...], freedoms: int | None) -> str:
    """Why the class is the same all along: the body has all the freedoms of a group, and can have no other.

    It has them at regular poses where it has them, decided exactly, in the configuration: ranks fall only at some.
    """
    if group is None or len(classes) != 1 or classes[0].order != group.system.order:
        return ""
    if group.system.order and freedoms != group.system.order:
        return ""
    chains = f"the groups of {group.chains} chains" if group.chains > 1 else "the group of its chain"
    if not group.system.order:
        return f"no displacement is in {chains} to the body"
    return f"what is in {chains} to the body is a {group.system.motion_type} group, and it moves so"


def _limbs(network: Network, limbs: Mapping[str, tuple[str, ...]]) -> dict[str, tuple[tuple[int, ...], int]]:
    """Limb -> (columns, rank at the reference); limbs of one joint cannot lose rank."""
    result = {}
    for name, joints in limbs.items():
        columns = tuple(c for joint in joints for c in network.edges[joint].columns)
        if len(columns) > 1:
            rows = np.array([[float(c) for c in network.screws[k]] for k in columns])
            result[name] = (columns, int(np.linalg.matrix_rank(rows, tol=LOST)))
    return result


def _generic_order(setting: Setting) -> int:
    """Freedoms of the body a little away from the reference, where they are most."""
    orders = [0]
    pose = pose_at(setting, np.zeros(setting.variety.columns), (), None)
    columns = independent_columns(setting.network, pose.motions, setting.drives)
    for column in columns[:2]:
        held = tuple(c for c in columns if c != column)
        line = track(setting, column, held, 1, most=AROUND) if setting.variety.rows else None
        for there in line.poses[1:] if line else (pose,):
            screws = setting.variety.displaced(there.q[None])[0]
            twists = body_twists(setting.network, setting.variety, screws, setting.body) @ there.motions
            orders.append(int((np.linalg.svd(twists, compute_uv=False) > CLEAR).sum()))
    return max(orders)


def _regular(tracks: list[Track]) -> tuple[list[Pose], dict[str, float]]:
    """(some of the poses on the lines, none at a singularity; the median of every margin on the lines)."""
    result = []
    for line in tracks:
        typical = {kind: float(np.median([p.margins[kind] for p in line.poses])) for kind in line.poses[0].margins}
        result += [p for p in line.poses if _clear(p, typical)][1::EVERY]
    every = [p.margins for line in tracks for p in line.poses]
    return result, {kind: float(np.median([margins[kind] for margins in every])) for kind in every[0]}


def _clear(pose: Pose, typical: Mapping[str, float]) -> bool:
    return all(value > CLEAR * typical[kind] for kind, value in pose.margins.items())


def _beside(setting: Setting, regular: list[Pose], typical: Mapping[str, float]) -> list[Pose]:
    """Poses off the lines, a stride from poses on them; none where one line is the whole branch."""
    if setting.dimension < 2 or not regular:
        return []
    random = np.random.default_rng(SEED)
    starts = []
    for k in np.linspace(0, len(regular) - 1, min(BESIDE, len(regular))).astype(int):
        along = random.normal(size=setting.dimension)
        starts.append(regular[k].q + STRIDE * regular[k].motions @ (along / np.linalg.norm(along)))
    found = poses_next_to(setting, np.array(starts), [()] * len(starts), [None] * len(starts))
    return [pose for pose in found if pose is not None and _clear(pose, typical)]


def _proof(network: Network, body: str, axis: str, found: ScrewClass) -> str:
    """Why the body moves about a joint's axis on the whole branch; empty where that was only seen."""
    for edge in network.edges.values():
        ends = {edge.parent, edge.child}
        named = axis.endswith(f" of {edge.name}")
        if named and ends == {network.ground, body} and len(edge.screws) == found.order:
            return f"{edge.name} joins {body} to {network.ground} and has no other freedom"
    return ""


def _held(network: Network, axis: str, group: CommonGroup) -> str:
    """Why a body that has all freedoms of a group moves about an axis all along; empty where that was only seen."""
    for name in group.fixed:
        if axis.endswith(f" of {name}"):
            return f"of a joint at rest on {network.ground}, with its screw in the {group.system.motion_type} group"
    return ""
