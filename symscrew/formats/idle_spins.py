"""Rods between two balls as bars: their spin about the line of the balls, which moves nothing else, is left out.

    bodies, joints --bars--> the same with a universal joint in place of one ball, mass on the line, and the platform

That nothing else is moved needs no computation: a turn about the line through both centres leaves both where they are.
So the spin is a freedom of every pose, its rate multiplies nothing but the rod's own inertia, and no drive reaches it.
What is left of a rod is its mass m, its centre's place along the line and its mean inertia across the line. What is
left out is said for each: how far the centre is off the line, and the norm of what changes of the inertia about the
inner ball. With D that norm and e the offset, the rod's kinetic energy changes by at most D w^2/2 + m e w v for a turn
w and a speed v of that ball. Of a rod that is symmetric about the line nothing changes but its spin. Forces and limits
of the two balls have no place in a bar: with them it needs `accept`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.formats.draft import Draft, RawBody, RawJoint
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
LEGS = 3
"""Ways from the ground to a body from which on it is a platform whose legs are chains of their own."""
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
    """Bodies and joints with bars for rods, and what changed in the draft's ledger; its platform is found.

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
    _without_forces(draft, {name for rod in rods for name in rod.balls}, whole)
    made = {rod.body.name: _bar(draft, rod) for rod in rods}
    turned = {rod.inner.name: _universal(rod) for rod in rods}
    for name in turned:
        for given in (draft.starts, draft.start_rates):
            for start, values in given.items():
                given[start] = {key: value for key, value in values.items() if whole.get(key[0], key[0]) != name}
    draft.platform = draft.platform or _platform(draft.ground, joints)
    return [made.get(body.name, body) for body in bodies], [turned.get(joint.name, joint) for joint in joints]


def _without_forces(draft: Draft, balls: Collection[str], whole: Mapping[str, str]) -> None:
    """Forces and limits of the rods' balls have no place in a bar: the ledger says so, as of all that is left out."""
    left = [effect for effect in draft.effects if whole.get(effect.joint, effect.joint) in balls]
    for kind, joint in dict.fromkeys((effect.table["kind"], effect.joint) for effect in left):
        draft.ledger.lost(f"{kind} of the rod's ball {joint}")
    draft.effects = [effect for effect in draft.effects if effect not in left]
    for name in [name for name in draft.limits if whole.get(name, name) in balls]:
        del draft.limits[name]
        draft.ledger.lost("limits of rods' balls")


def _rods(
    draft: Draft, bodies: Sequence[RawBody], joints: Sequence[RawJoint], whole: Mapping[str, str]
) -> Iterator[_Rod]:
    points = {name: body for name, body, _ in draft.points}
    kept = {whole.get(name, name) for coupling in draft.couplings for name in coupling.terms}
    kept |= {*draft.drags, *(points[load.point] for load in draft.loads)}
    depths = _depths(draft.ground, joints)
    for body in bodies:
        at = [joint for joint in joints if body.name in (joint.parent, joint.child)]
        if len(at) != 2 or body.name == draft.ground:
            continue
        if any(j.type != "S" or j.driven or any(j.reference) or j.name in kept for j in at) or body.name in kept:
            continue
        ends = [j.child if j.parent == body.name else j.parent for j in at]
        if ends[0] == ends[1]:
            continue
        near = int(depths.get(ends[1], 0) < depths.get(ends[0], 0))
        line = minus(at[1 - near].point, at[near].point)
        if length(line) > NO_ROD:
            balls = (at[0].name, at[1].name)
            yield _Rod(body, at[near], ends[near], balls, line, _across(ends[near], joints, line))


def _depths(ground: str, joints: Sequence[RawJoint]) -> dict[str, int]:
    """Joints between the ground and every body."""
    found, frontier = {ground: 0}, [ground]
    while frontier:
        ends = [pair for j in joints for pair in ((j.parent, j.child), (j.child, j.parent)) if pair[0] in frontier]
        frontier = list(dict.fromkeys(far for _, far in ends if far not in found))
        found.update((far, 1 + max(found.values())) for far in frontier)
    return found


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


def _platform(ground: str, joints: Sequence[RawJoint]) -> str | None:
    """The body that most legs hold, three at least: ways from the ground that end in a joint of theirs each."""
    legs: dict[str, int] = {}
    for body in dict.fromkeys(end for joint in joints for end in (joint.parent, joint.child)):
        if body != ground:
            without = [joint for joint in joints if body not in (joint.parent, joint.child)]
            reached = _depths(ground, without)
            ends = [j.child if j.parent == body else j.parent for j in joints if body in (j.parent, j.child)]
            legs[body] = sum(end in reached for end in ends)
    best = max(legs, key=lambda body: legs[body], default=None)
    return best if best is not None and legs[best] >= LEGS else None
