"""Freedoms, constraints, counts, branches and margins of a result by routes that none of them was found by.

    description --exponentials in doubles--> screws of every joint at the configuration
    motions --sums along other paths--> twists of the body;  closure and drives in one matrix --> freedoms left
    screws of limbs and loops --singular values--> connectivity, orders;  margins --determinants, ranks--> zeros

Ranks are judged by singular values in doubles where these can tell, else by elimination in 60 digits.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symscrew.algebra import CONTEXT
from symscrew.description import Joint
from symscrew.mobility.analysis import Mobility
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import Real, Screw, combine, eliminate, unit_rows
from symscrew.mobility.singularities import MarginValue

Array = NDArray[np.float64]
Found = tuple[str, bool, str, str]
"""Claim, whether it holds, evidence, the statement that falls with it."""

TOLD = 1e-9
"""Relative singular value above which doubles tell that it is none of rounding; of smaller ones 60 digits tell."""
SAME = 1e-9
"""Of a screw and of the mechanism's distance from the origin: screws in doubles and in 60 digits that are the same."""
POWER = 1e-20
"""Power of a wrench on screws that it is reciprocal to, both of unit length: zeros of ranks are taken from 1e-27."""
TANGENT = 1e-2
"""Velocity of closure along a direction of a branch, which was seen from points nearby: right to 1e-4 where branches
touch, and a wrong one misses by a tenth and more."""
DETERMINANT = 1e-6
"""Relative difference of a margin and the determinant of the same screws: a determinant of six loses few digits."""
LOST = 1e-3
"""Relative singular value that a rank lost may have where its margin, a product of up to six, is below 1e-9 of its
size."""
KINDS = frozenset("RPHCUS")
"""Joints whose screws are made anew: what turns or slides along axes of the description, and balls."""


def second_routes(found: Mobility) -> Iterator[Found]:
    """Every claim that the checks of ranks, motions and symbols leave open."""
    yield from _screws(found)
    yield _platform(found)
    if found.dof_drives_locked is not None:
        yield _drives(found)
    yield from _limbs(found)
    yield from _counts(found)
    yield from _branches(found)
    yield from _margins(found)


def has_rank(vectors: Sequence[Sequence[Real]], rank: int, columns: int) -> bool:
    """Whether vectors have a rank: told by doubles, where they cannot, by 60 digits."""
    rows = unit_rows(vectors)
    if not rows:
        return rank == 0
    s = np.linalg.svd(np.array([[float(c) for c in row] for row in rows]), compute_uv=False)
    s = np.append(s / s[0], 0.0)
    if not 0 < rank < len(s) or s[rank] > TOLD:
        return False
    if rank == len(s) - 1 and s[-2] > TOLD:
        return True
    return eliminate(rows, columns).rank == rank


# -- screws ----------------------------------------------------------------------------------------------


def _screws(found: Mobility) -> list[Found]:
    """Screws of all joints, displaced by exponentials along a tree of its own, in doubles."""
    joints = found.mechanism.joints.values()
    if found.taken is not None or not {joint.type for joint in joints} <= KINDS:
        return []
    if any(_is_ball(joint) and joint.reference for joint in joints):
        return []
    values = {} if found.in_reference or found.reached is None else found.reached.values
    network, length = found.network, float(found.network.length)
    pieces = {joint.name: _freedoms(found, joint, values) for joint in joints}
    poses, apart = _poses(found, pieces)
    if len(poses) < len(network.bodies):
        return []
    reach = max(float(np.abs(pose[:3, 3]).max()) / length for pose in poses.values())
    reach = max(reach, 1.0)
    worst = apart / max(length, 1.0)
    for joint in joints:
        made, at = [], poses[joint.parent]
        for screw, by in pieces[joint.name]:
            made.append(_carried(at, screw))
            at = at @ _exponential(screw, by)
        if _is_ball(joint):  # three turns about one point, in whatever axes: a ball has the same three screws
            made = [_carried(at, s) for s, _ in pieces[joint.name]]
        own = np.array([[float(c) for c in s] for s in network.edges[joint.name].screws])
        new = np.array(made) / np.array([1, 1, 1, length, length, length])
        reach = max(reach, float(np.abs(own).max()))
        worst = max(worst, *(_outside(new, row) for row in own))
    text = f"at most {worst:.1e} from screws displaced by exponentials in doubles"
    return [("screws of all joints", worst < SAME * reach, text, "")]


def _poses(found: Mobility, pieces: Mapping[str, list[tuple[Array, float]]]) -> tuple[dict[str, Array], float]:
    """Poses of the bodies that joints reach from the ground, and how far apart ways to the same body end [m]."""
    poses, apart = {found.mechanism.ground: np.eye(4)}, 0.0
    waiting = list(found.mechanism.joints.values())
    while True:
        left = [joint for joint in waiting if joint.parent not in poses and joint.child not in poses]
        for joint in (joint for joint in waiting if joint not in left):
            across = np.eye(4)
            for screw, by in pieces[joint.name]:
                across = across @ _exponential(screw, by)
            if joint.parent not in poses:
                poses[joint.parent] = poses[joint.child] @ np.linalg.inv(across)
            end = poses[joint.parent] @ across
            apart = max(apart, float(np.abs(poses.setdefault(joint.child, end) - end).max()))
        if len(left) in (0, len(waiting)):
            return poses, apart
        waiting = left


def _freedoms(found: Mobility, joint: Joint, values: Mapping[str, float]) -> list[tuple[Array, float]]:
    """(screw in metres in the reference configuration, displacement) of each freedom; a ball's turn as one of three."""
    number = found.mechanism.number
    point = np.array([float(number(c)) for c in joint.point])
    axes = [np.array([float(number(c)) for c in axis]) for axis in joint.axes]
    axes = [axis / np.linalg.norm(axis) for axis in axes]
    if _is_ball(joint):
        turn = np.array([values.get(f"{joint.name}.r{c}", 0.0) for c in "xyz"])
        angle = float(np.linalg.norm(turn))
        first = turn / angle if angle else np.array([1.0, 0, 0])
        across = np.linalg.svd(first[None])[2][1:]
        return [(_turning(axis, point, 0.0), by) for axis, by in zip([first, *across], [angle, 0.0, 0.0], strict=True)]
    pitch = float(number(joint.pitch)) if joint.pitch is not None else 0.0
    references = [float(number(c)) for c in joint.reference] or [0.0] * joint.kind.freedom
    pieces = []
    for k, motion in enumerate(joint.kind.motions):
        axis = axes[motion.axis or 0]
        screw = _turning(axis, point, pitch) if motion.turns else np.array([0.0, 0, 0, *axis])
        label = joint.name if joint.kind.freedom == 1 else f"{joint.name}.{k}"
        pieces.append((screw, values.get(label, references[k]) - references[k]))
    return pieces


def _is_ball(joint: Joint) -> bool:
    return any(motion.spherical for motion in joint.kind.motions)


def _turning(axis: Array, point: Array, pitch: float) -> Array:
    return np.array([*axis, *(np.cross(point, axis) + pitch * axis)])


def _exponential(screw: Array, by: float) -> Array:
    """The displacement along a unit screw by an angle [rad], or along a slide [m]."""
    pose = np.eye(4)
    turn, shift = screw[:3], screw[3:]
    if not turn.any():
        pose[:3, 3] = by * shift
        return pose
    x, y, z = turn
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    pose[:3, :3] += np.sin(by) * skew + (1 - np.cos(by)) * skew @ skew
    moved = by * np.eye(3) + (1 - np.cos(by)) * skew + (by - np.sin(by)) * skew @ skew
    pose[:3, 3] = moved @ shift
    return pose


def _carried(pose: Array, screw: Array) -> Array:
    """The screw in the axes of the ground, at its origin."""
    turn = pose[:3, :3] @ screw[:3]
    return np.concatenate([turn, pose[:3, :3] @ screw[3:] + np.cross(pose[:3, 3], turn)])


def _outside(screws: Array, screw: Array) -> float:
    """What of a screw is not in the span of others, over its size."""
    rest = screw - screws.T @ np.linalg.lstsq(screws.T, screw, rcond=None)[0]
    return float(np.linalg.norm(rest)) / max(float(np.linalg.norm(screw)), 1.0)


# -- the body, drives and limbs --------------------------------------------------------------------------


def _platform(found: Mobility) -> Found:
    """Twists of the body by every motion, summed along another path where there is one, against its freedoms."""
    platform, network = found.platform, found.network
    rows = [[CONTEXT.zero] * network.freedoms for _ in range(6)]
    for name, sign in _way(network, platform.body):
        edge = network.edges[name]
        for column, screw in zip(edge.columns, edge.screws, strict=True):
            for k in range(6):
                rows[k][column] = sign * screw[k]
    twists = [combine(rows, motion) for motion in unit_rows(found.first_order.motions)]
    known = unit_rows(_without_unit(platform.freedoms.basis, network.length))
    # rank of the twists as they are: what is rounding beside the largest is no freedom
    own = eliminate(twists, 6).rank == platform.dof
    same = own and has_rank([*known, *span_of(twists)], platform.dof, 6)
    turning = eliminate([twist[:3] for twist in twists], 3).rank
    text = f"{platform.dof} twists, {platform.rotations} of them turn, as by sums of rates along another path"
    if not same or turning != platform.rotations:
        text = f"not the twists of the motions, of which {turning} turn"
    return f"freedoms of {platform.body} by its motions", same and turning == platform.rotations, text, ""


def span_of(twists: Sequence[Screw]) -> list[list[Real]]:
    """Rows of full rank that span the same."""
    return [list(row) for row in eliminate(twists, 6).rows]


def _way(network: Network, body: str) -> list[tuple[str, int]]:
    """Joints and senses from the ground to a body, depth first, joints that close loops first."""
    order = sorted(network.edges.values(), key=lambda edge: edge.name not in network.chords)
    before: dict[str, tuple[str, str, int]] = {network.ground: ("", "", 0)}
    front = [network.ground]
    while front:
        at = front.pop()
        for edge in order:
            for near, far, sign in ((edge.parent, edge.child, 1), (edge.child, edge.parent, -1)):
                if near == at and far not in before:
                    before[far] = (at, edge.name, sign)
                    front.append(far)
    way: list[tuple[str, int]] = []
    while body != network.ground:
        body, name, sign = before[body]
        way.append((name, sign))
    return way


def _drives(found: Mobility) -> Found:
    """Closure and locked drives in one matrix, whose null space are the freedoms left."""
    network, left = found.network, found.dof_drives_locked or 0
    locked = [[CONTEXT.mpf(int(k == column)) for k in range(network.freedoms)] for column in network.driven]
    holds = has_rank([*found.first_order.rows, *locked], network.freedoms - left, network.freedoms)
    return "freedoms left with all drives locked", holds, f"{left}, by the rank of closure and drives", ""


def _limbs(found: Mobility) -> Iterator[Found]:
    """Constraints of a limb do no work on its screws, and there are as many as the screws leave."""
    for limb in found.limbs:
        names = found.mechanism.limbs[limb.name].joints
        screws = [screw for name in names for screw in found.network.edges[name].screws]
        wrenches = unit_rows(_without_unit(limb.constraints.basis, found.network.length))
        terms = ((w, s) for w in wrenches for s in unit_rows(screws))
        worst = max((abs(sum(w[k] * s[(k + 3) % 6] for k in range(6))) for w, s in terms), default=CONTEXT.zero)
        count = len(limb.constraints.basis)
        enough = has_rank(screws, 6 - count, 6) and has_rank(wrenches, count, 6)
        text = f"largest power {float(worst):.1e} of {count} constraints on {len(screws)} screws"
        yield f"constraints of {limb.name}", bool(worst < POWER) and enough, text, ""


def _counts(found: Mobility) -> Iterator[Found]:
    """Orders of the loops, connectivity of limbs and groups by ranks of their own."""
    counts, network = found.counts, found.network
    wrong = [
        loop.joint
        for loop, steps in zip(counts.loops, network.loops(), strict=True)
        if not loop.order <= loop.dimension <= 6
        or not has_rank(_centred([network.edges[name] for name, _ in steps]), loop.order, 6)
    ]
    groups = found.decisions.groups
    if groups is not None and groups != tuple(loop.dimension for loop in counts.loops):
        wrong.append("groups over the exact field")
    for limb in counts.limbs:
        edges = [network.edges[name] for name in found.mechanism.limbs[limb.name].joints]
        if not has_rank(_centred(edges), limb.connectivity, 6):
            wrong.append(limb.name)
    if counts.mobility != found.dof or counts.platform != found.platform.dof:
        wrong.append("M or S_F")
    every = _centred(list(network.edges.values()))
    if network.chords and not has_rank(every, 6 - counts.common, 6):
        wrong.append("lambda")
    text = f"not so: {', '.join(wrong)}" if wrong else f"{len(counts.loops)} loops, {len(counts.limbs)} limbs"
    yield "orders, groups and connectivity", not wrong, text, ""


def _centred(edges: Sequence[Any]) -> list[list[Real]]:
    """Screws of joints about the first one's point."""
    x, y, z = edges[0].point
    return [[a, b, c, d - (y * c - z * b), e - (z * a - x * c), f - (x * b - y * a)]
            for edge in edges for a, b, c, d, e, f in edge.screws]  # fmt: skip


def _without_unit(screws: Sequence[Screw], length: Real) -> list[list[Real]]:
    return [[*s[:3], *(c / length for c in s[3:])] for s in screws]


# -- branches and margins --------------------------------------------------------------------------------


def _branches(found: Mobility) -> Iterator[Found]:
    """Dimensions of the table against the finite mobility, directions against the closure."""
    table = found.branches
    if table is None or not table.rows:
        return
    finite, rows = found.finite, np.array([[float(c) for c in row] for row in found.first_order.rows])
    dimensions = {row.dimension for row in table.rows}
    allowed = {finite.dof} if finite.smooth else set(finite.branches or ())
    holds = dimensions <= allowed and max(dimensions) == finite.dof and (not finite.smooth or len(table.rows) == 1)
    holds = holds and all(row.dimension == row.internal + (row.platform.order if row.platform is not None else 0)
                          for row in table.rows if row.platform is not None)  # fmt: skip
    size = float(np.abs(rows).max()) if rows.size else 1.0
    worst = max((float(np.abs(rows @ row.tangent.T).max()) for row in table.rows if rows.size and row.tangent.size),
                default=0.0) / size  # fmt: skip
    text = f"dimensions {sorted(dimensions, reverse=True)}, directions close the loops to {worst:.1e}"
    yield "branches by dimension and direction", holds and worst < TANGENT, text, "branches"


def _margins(found: Mobility) -> Iterator[Found]:
    """Margins that vanish against ranks; those of limbs with six screws against their determinant."""
    margins = found.singularities.margins
    if not margins or found.taken is not None:
        return
    wrong = [f"{m.kind} ({m.name})" for m in margins if not (_as_ranks(found, m) and _as_determinant(found, m))]
    text = f"not so: {', '.join(wrong)}" if wrong else f"{len(margins)} of them"
    yield "margins by determinants and ranks", not wrong, text, "margins"


def _as_ranks(found: Mobility, margin: MarginValue) -> bool:
    """Whether a margin that vanishes is one of screws that are dependent, or all but so, here."""
    if not margin.vanishes or margin.note:
        return True
    network = found.network
    limb = found.mechanism.limbs.get(margin.name)
    if margin.kind == "limb" and limb is None:
        return True  # of a chain that is not described
    rows: list[Sequence[Real]]
    if limb is not None:
        rows = [s for name in limb.joints for s in network.edges[name].screws]
    else:
        rows = [*found.first_order.rows]
        if margin.kind == "actuation":
            rows += [[float(k == c) for k in range(network.freedoms)] for c in _locked(found, margin.name)]
    s = np.linalg.svd(np.array([[float(c) for c in row] for row in rows]), compute_uv=False)
    return bool(s[-1] < LOST * s[0])


def _locked(found: Mobility, name: str) -> list[int]:
    """Columns of the drives that are locked."""
    network = found.network
    if name == "all drives":
        return list(network.driven)
    labels = {}
    for edge in network.edges.values():
        for k, column in enumerate(edge.columns):
            labels[edge.name if len(edge.columns) == 1 else f"{edge.name}.{k}"] = column
    return [labels[part] for part in name.split() if part in labels]


def _as_determinant(found: Mobility, margin: MarginValue) -> bool:
    """Whether a limb's margin is, up to its sign, the determinant of its six screws."""
    limb = found.mechanism.limbs.get(margin.name)
    if limb is None or margin.kind != "limb" or margin.form != "signed":
        return True
    ratio = float(found.network.length) / found.singularities.length
    screws = [s for name in limb.joints for s in found.network.edges[name].screws]
    if len(screws) != 6:
        return True
    matrix = np.array([[float(c) for c in s] for s in screws])
    turning = matrix[:, :3].any(axis=1)
    matrix[turning, 3:] *= ratio
    value = abs(float(np.linalg.det(matrix)))
    size = float(np.prod(np.linalg.norm(matrix, axis=1)))
    return abs(value - abs(margin.value)) <= DETERMINANT * max(value, abs(margin.value)) + TOLD * size
