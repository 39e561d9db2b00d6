"""The volume of a limb's joint screws: zero exactly where they become dependent.

    V = det [S_1 ... S_6]                    six freedoms; signed
    V = sum of det^2 over all minors         fewer or more: rank is lost on two or more conditions at once

The screws (omega ; v / length) are seen from the link of the limb in whose axes most entries are zero: the volume
does not depend on the axes, its length as an expression does.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import Any

import numpy as np

from symscrew.algebra import (
    IDENTITY,
    NEGLIGIBLE,
    ZERO,
    Grid,
    Node,
    Tape,
    Vector,
    Volume,
    rank_of,
    sampled,
    scale,
    transform,
    volume,
    zeroed,
)
from symscrew.description import Motion, rotation
from symscrew.kinematics import GROUND, Cut, System, pair_of, universal_axes

LONG = 10
"""Freedoms up to which a limb is looked at from every one of its links, which costs a grid of screws a link.

Beyond it only from the ground, through the links' poses, which all screws share: carried joint by joint, the
expressions of a long chain double in size. The volume is the same, its expression may be longer; `limb_margins`
says so."""

Piece = tuple[int, Motion, Vector, Vector, object]


def limb_freedoms(system: System, joints: Sequence[str]) -> list[Piece]:
    """(link, motion, axis, point, pitch) of every freedom of a limb, in coordinates of that link."""
    return [piece for joint in joints for piece in _pieces(system, joint)]


def limb_volume(system: System, joints: Sequence[str]) -> Volume:
    """In the axes of the limb's link in which most entries are zero; signed where the span is constant in one."""
    tape = system.tape
    pieces = limb_freedoms(system, joints)
    best: tuple[tuple[bool, int, int], Grid] | None = None
    for frame in _candidate_frames([link for link, *_ in pieces]):
        columns = [_seen(system, piece, frame, known=len(pieces) > LONG) for piece in pieces]
        grid = zeroed(tape, [[column[i] for column in columns] for i in range(6)])
        rows = _constant_span(tape, grid)
        entries = [e for row in grid for e in row if e is not tape.zero]
        rank = (rows is None, sum(e.value is None for e in entries), len(entries))
        if best is None or rank < best[0]:
            best = (rank, [grid[i] for i in rows] if rows is not None else grid)
    if best is None:
        return Volume(tape.one, "signed")
    return volume(tape, best[1], rank_of(tape, best[1]))


def _candidate_frames(links: Sequence[int]) -> list[int]:
    """The links in whose axes a limb is looked at: all of it, of a long one the ground only, where poses are known."""
    found = list(dict.fromkeys([*links, GROUND]))
    return found if len(found) <= LONG + 1 else [GROUND]


def _pieces(system: System, name: str) -> list[Piece]:
    """(link, motion, axis, point, pitch) of every freedom of a joint, in coordinates of a link."""
    cut = next((c for c in system.cuts if c.joint.name == name), None)
    if cut is not None:
        return _cut_pieces(system, cut)
    result: list[Piece] = []
    for link in system.tree.links_of(name):
        frame = system.frames[link.index]
        if link.motion.spherical:
            result += [(link.index, rotation(), axis, ZERO, None) for axis in IDENTITY]
        elif link.motion.single:  # a slider keeps its parent's axes
            axis = (0, 0, 1) if link.motion.turns else frame.axis
            result.append((link.index, link.motion, axis, ZERO, frame.pitch))
    return result


def _cut_pieces(system: System, cut: Cut) -> list[Piece]:
    kind = cut.joint.kind
    if kind.spherical:
        return [(cut.tip, rotation(), axis, cut.tip_point, None) for axis in IDENTITY]
    axes = universal_axes(cut, system.linkage) if kind.universal else cut.tip_axes
    pitch = system.geometry.scalar(cut.joint.pitch) if cut.joint.pitch is not None else None
    return [(cut.tip, m, axes[m.axis or 0], cut.tip_point, pitch) for m in kind.motions]


def _seen(system: System, piece: Piece, frame: int, *, known: bool = False) -> list[Node]:
    """The unit screw of a freedom (omega ; v / length) at the origin and in the axes of a link.

    Joint after joint between the two, or with `known` from the poses, which all of a long limb's screws share.
    """
    link, motion, axis, point, pitch = piece
    tape = system.tape
    by_pose = known and frame == GROUND and link != GROUND
    pose = system.pose[link]
    axis = transform(pose.rotation, axis) if by_pose else system.linkage.carry(link, frame, axis)
    if not motion.turns:
        (twist,) = pair_of(motion).screws(axis, ZERO, pitch)
        linear = twist.linear
    else:
        at = pose.point(point) if by_pose else system.linkage.carry_point(link, frame, point)
        (twist,) = pair_of(motion).screws(axis, at, pitch)
        linear = scale(tape.constant(1 / system.length), twist.linear)
    return [tape.node(c) for c in (*twist.angular, *linear)]


def _constant_span(tape: Tape, grid: Grid) -> list[int] | None:
    """Rows that tell the columns apart, if these span one and the same space at all samples; else None."""
    count = len(grid[0])
    if count >= 6:
        return None
    values = sampled(tape, grid)
    together = np.concatenate(list(values), axis=1)
    if np.linalg.matrix_rank(together, tol=NEGLIGIBLE) != count:
        return None
    basis = np.linalg.svd(together)[0][:, :count]
    return list(max(combinations(range(6), count), key=lambda rows: _size(basis[list(rows)])))


def _size(matrix: np.ndarray[Any, Any]) -> float:
    """|det|, rounded so that the last digits of another machine choose nothing else."""
    return round(abs(float(np.linalg.det(matrix))), 6)
