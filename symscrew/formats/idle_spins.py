"""Rods between two balls as bars: their spin about the line of the balls, which moves nothing else, is left out.

    bodies, joints --bars--> the same with a universal joint in place of one ball, mass on the line

That nothing else is moved needs no computation: a turn about the line through both centres leaves both where they are.
So the spin is a freedom of every pose, its rate multiplies nothing but the rod's own inertia, and no drive reaches it.
What is left of a rod is its mass m, its centre's place along the line and its mean inertia across the line. What is
left out is said for each: how far the centre is off the line, and the norm of what changes of the inertia about the
inner ball. With D that norm and e the offset, the rod's kinetic energy changes by at most D w^2/2 + m e w v for a turn
w and a speed v of that ball. Of a rod that is symmetric about the line nothing changes but its spin.

Rotor inertia, damping and dry friction of the inner ball act about the axes of the universal joint: what they did to
the spin goes with it. A spring along the shortest turn, and limits, have no place there: with them it needs `accept`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.formats.draft import Draft, RawBody, RawEffect, RawJoint
from symscrew.formats.held_platform import depths
from symscrew.formats.rigid_displacements import (
    UNITS,
    Real,
    Rotation,
    Triple,
    cross,
    dot,
    floored,
    length,
    minus,
    plus,
    scaled,
    unit,
)
from symscrew.formats.tree_freedoms import doubles

ASIDE = 0.3
"""Sine of the angle [1] between the rod and an axis of its neighbour from which on the universal joint has that axis:
the drives then share its turn. Nearer, a universal joint would be close to where its two turns are one."""
ABOUT_AXES = ("armature", "damping", "friction")
"""Forces of a ball that are the same about every axis, or are listed by axis."""
NO_ROD = 1e-9
"""Distance of two balls [m] below which there is no line between them."""


@dataclass(frozen=True)
class _Rod:
    """A body between two balls: that at the inner end becomes a universal joint, about `across` first."""

    body: RawBody
    inner: RawJoint
    neighbour: str
    balls: tuple[str, str]
    line: Triple
    across: Triple


def bars(
    draft: Draft, bodies: Sequence[RawBody], joints: Sequence[RawJoint], whole: Mapping[str, str]
) -> tuple[list[RawBody], list[RawJoint]]:
    """Bodies and joints with bars for rods, and what changed in the draft's ledger.

    What is rounding of zero goes first: taken out of an axis later, it would leave the next one not across it.

    `whole`: joint of the file -> the joint of `joints` that it is part of.

    Raises:
        DescriptionError: there is no rod that could be a bar.
    """
    bodies = [body if body.com is None else replace(body, com=floored(body.com)) for body in bodies]
    joints = [replace(j, point=floored(j.point), axes=tuple(floored(axis) for axis in j.axes)) for j in joints]
    rods = list(_rods(draft, bodies, joints, whole))
    if not rods:
        raise DescriptionError(
            "--bars: expected a rod between two balls without drives, couplings and loads, found none"
        )
    _settle_forces(draft, {rod.inner.name: rod for rod in rods}, whole)
    made = {rod.body.name: _bar(draft, rod) for rod in rods}
    turned = {rod.inner.name: _universal(rod) for rod in rods}
    for name in turned:
        for given in (draft.starts, draft.start_rates):
            for start, values in given.items():
                given[start] = {key: value for key, value in values.items() if whole.get(key[0], key[0]) != name}
    return [made.get(body.name, body) for body in bodies], [turned.get(joint.name, joint) for joint in joints]


def spinning_rods(
    draft: Draft, bodies: Sequence[RawBody], joints: Sequence[RawJoint], whole: Mapping[str, str]
) -> list[str]:
    """The bodies that could be bars; of what a chain of `joints` makes one joint, `whole` is as for `bars`."""
    return [rod.body.name for rod in _rods(draft, bodies, joints, whole)]


def _settle_forces(draft: Draft, inner: Mapping[str, _Rod], whole: Mapping[str, str]) -> None:
    """Forces of an inner ball act about the axes of its universal joint, where they have an axis; others are left out.

    The two axes are at right angles always, so that a rate w of the rod in the joint has w^2 = a^2 + b^2 with the
    rates about them: what is the same about every axis of the ball is the same about both. Where the first is at right
    angles to the rod, w is the least rate with which the ball lets it turn; a leaning one has the rod spin along.
    """
    kept: list[RawEffect] = []
    turned: dict[str, dict[str, None]] = {}
    for effect in draft.effects:
        ball, kind = whole.get(effect.joint, effect.joint), effect.table["kind"]
        freedom = effect.table.get("freedom")
        if ball not in inner:
            kept.append(effect)
        elif ball != effect.joint or kind not in ABOUT_AXES:
            draft.ledger.lost(f"{kind} of the rod's ball {effect.joint}")
        else:
            axes: Iterable[int | None] = range(2) if kind == "armature" else [freedom]
            tables = [effect.table if k is None else {**effect.table, "freedom": k} for k in axes if k != 2]
            kept += [replace(effect, table=table) for table in tables]
            turned.setdefault(ball, {})[kind] = None
    draft.effects = kept
    for ball, kinds in turned.items():
        rod = inner[ball]
        lean = np.degrees(np.arcsin(min(float(length(cross(rod.across, unit(rod.line, "rod")))), 1.0)))
        draft.ledger.changed.append(
            f"{ball}: {', '.join(kinds)} about the axes of the bar's universal joint, at {lean:.3g} deg to the bar and "
            "across it"
        )
    balls = {name for rod in inner.values() for name in rod.balls}
    for name in [name for name in draft.limits if whole.get(name, name) in balls]:
        del draft.limits[name]
        draft.ledger.lost("limits of rods' balls")


def _rods(
    draft: Draft, bodies: Sequence[RawBody], joints: Sequence[RawJoint], whole: Mapping[str, str]
) -> Iterator[_Rod]:
    points = {name: body for name, body, _ in draft.points}
    kept = {whole.get(name, name) for coupling in draft.couplings for name in coupling.terms}
    kept |= {*draft.drags, *(points[load.point] for load in draft.loads)}
    meeting: dict[str, list[RawJoint]] = {}
    for joint in joints:
        for end in (joint.parent, joint.child):
            meeting.setdefault(end, []).append(joint)
    if not any(len(at) == 2 and all(j.type == "S" for j in at) for at in meeting.values()):
        return
    deep = depths(draft.ground, joints)
    for body in bodies:
        at = meeting.get(body.name, [])
        if len(at) != 2 or body.name == draft.ground:
            continue
        if any(j.type != "S" or j.driven or any(j.reference) or j.name in kept for j in at) or body.name in kept:
            continue
        ends = [j.child if j.parent == body.name else j.parent for j in at]
        if ends[0] == ends[1]:
            continue
        near = int(deep.get(ends[1], 0) < deep.get(ends[0], 0))
        line = minus(at[1 - near].point, at[near].point)
        if length(line) > NO_ROD:
            balls = (at[0].name, at[1].name)
            yield _Rod(body, at[near], ends[near], balls, line, _across(ends[near], joints, line))


def _across(neighbour: str, joints: Sequence[RawJoint], line: Triple) -> Triple:
    """Unit axis of the universal joint in the neighbour: one that it turns about, or one at right angles to the rod."""
    along = unit(line, "rod")
    turns = [axis for j in joints if j.child == neighbour and j.type == "R" for axis in j.axes]
    best = max(turns, key=lambda axis: length(cross(axis, along)), default=None)
    if best is not None and length(cross(best, along)) > ASIDE:
        return unit(best, "axis")
    return unit(cross(along, min(UNITS, key=lambda axis: abs(dot(axis, along)))), "rod")


def _universal(rod: _Rod) -> RawJoint:
    """In place of the inner ball: about an axis of the neighbour, then across the rod."""
    axes = (rod.across, unit(cross(rod.across, rod.line), "rod"))
    return replace(rod.inner, type="U", parent=rod.neighbour, child=rod.body.name, axes=axes)


def _bar(draft: Draft, rod: _Rod) -> RawBody:
    """The rod's mass on its line; what that leaves out is said."""
    body, ball = rod.body, rod.inner.point
    if body.mass is None or body.com is None or body.inertia is None:
        draft.ledger.changed.append(f"{body.name}: a bar; its spin is left out")
        return body
    arm, n = minus(body.com, ball), unit(rod.line, "rod")
    centre = plus(ball, scaled(n, dot(arm, n)))
    moments: Rotation = body.inertia
    mean = (sum(moments[i][i] for i in range(3)) - dot(n, tuple(dot(row, n) for row in moments))) / 2
    after = _on_line(n, mean)
    off = float(length(minus(body.com, centre)))
    changed = _about(body, ball) - _about(replace(body, com=centre, inertia=after), ball)
    norm = float(np.abs(np.linalg.eigvalsh(changed)).max())
    of = norm / max(float(np.linalg.eigvalsh(_about(body, ball))[-1]), 1e-300)
    draft.ledger.changed.append(
        f"{body.name}: a bar; its spin is left out, of its inertia {norm:.2g} kg m^2 ({100 * of:.2g} %), of its centre "
        f"{off:.2g} m beside the line"
    )
    return replace(body, com=centre, inertia=after, axes=None)


def _on_line(n: Triple, mean: Real) -> Rotation:
    """Inertia of masses on a line."""
    rows = [[mean * ((i == j) - n[i] * n[j]) for j in range(3)] for i in range(3)]
    return ((rows[0][0], rows[0][1], rows[0][2]), (rows[1][0], rows[1][1], rows[1][2]), (rows[2][0], rows[2][1], rows[2][2]))  # fmt: skip # noqa: E501


def _about(body: RawBody, point: Triple) -> np.ndarray:
    """Inertia about a point [kg m^2], in doubles."""
    assert body.com is not None and body.mass is not None and body.inertia is not None  # looked at before
    arm = doubles(minus(body.com, point))
    own = np.array([doubles(row) for row in body.inertia])
    found: np.ndarray = own + float(body.mass) * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    return found
