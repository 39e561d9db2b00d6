"""Chains of elementary joints as the one joint with several freedoms that they are.

    hip.0 (R), hip.1 (R), axes that meet  -->  hip (U)          PR -> C, PPR -> E, PPPS -> free

Formats without such joints hold them as chains over bodies without mass; `symscrew` writes these as `hip.0`, `hip.1`.
Any other chain stays one.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

from symscrew.formats.draft import Draft, RawBody, RawJoint
from symscrew.formats.rigid_displacements import UNITS, ZERO, Real, Triple, cross, dot, length, minus, plus, scaled

NEAR = 1e-12
"""Below this, lengths [m], sines of angles and differences of unit vectors count as zero: files have 15 digits. A chain
whose axes miss by more stays a chain, which moves the same."""


def merged(draft: Draft) -> tuple[list[RawBody], list[RawJoint], dict[str, tuple[str, int | None]]]:
    """Bodies and joints, chains `stem.0`, `stem.1` ... over bodies without mass as one joint where they are one.

    Also: joint of such a chain -> (the whole one, its freedom there).
    """
    massless = {body.name for body in draft.bodies if body.mass is None}
    used = [end for joint in draft.joints for end in (joint.parent, joint.child)]
    marked = {body for _, body, _ in draft.points} | {draft.ground, draft.platform}
    inner = {name for name in massless if used.count(name) == 2 and name not in marked}
    after = {joint.parent: joint for joint in draft.joints if joint.parent in inner}
    tied = {name for coupling in draft.couplings for name in coupling.terms}  # they keep a coordinate of their own
    dropped: set[str] = set()
    joints, removed = [], set()
    parts: dict[str, tuple[str, int | None]] = {}
    for joint in draft.joints:
        if joint.name in removed:
            continue
        chain = [joint]
        stem = joint.name.removesuffix(".0")
        while stem != joint.name and chain[-1].child in after:
            following = after[chain[-1].child]
            if following.name != f"{stem}.{len(chain)}":
                break
            chain.append(following)
        whole = one_joint(chain, stem) if len(chain) > 1 and not tied & {part.name for part in chain} else None
        if whole is None:
            joints.append(joint)
            continue
        joints.append(whole)
        parts |= {part.name: (whole.name, k) for k, part in enumerate(chain)}
        removed |= {part.name for part in chain}
        dropped |= {part.child for part in chain[:-1]}
    return [body for body in draft.bodies if body.name not in dropped], joints, parts


def one_joint(chain: Sequence[RawJoint], name: str) -> RawJoint | None:
    """The joint of several freedoms that a chain of elementary joints is, or None."""
    kinds = "".join(joint.type for joint in chain)
    axes = [axis for joint in chain for axis in joint.axes]
    reference = tuple(value for joint in chain for value in joint.reference or (ZERO[0],))
    made = RawJoint(
        name, "", chain[0].parent, chain[-1].child, chain[-1].point,
        driven=tuple(k for k, joint in enumerate(chain) for _ in joint.driven), reference=reference,
    )  # fmt: skip
    if kinds == "RR" and _sine(axes[0], axes[1]) > NEAR:
        meeting = _meeting(chain[0].point, axes[0], chain[1].point, axes[1])
        return None if meeting is None else dataclasses.replace(made, type="U", point=meeting, axes=(axes[0], axes[1]))
    if kinds == "PR" and _sine(axes[0], axes[1]) < NEAR and dot(axes[0], axes[1]) > 0:
        return dataclasses.replace(made, type="C", axes=(axes[1],))
    if any(reference):
        return None
    if kinds == "PPR" and _same_triad(axes, (*plane_axes(axes[2]), axes[2])):
        return dataclasses.replace(made, type="E", axes=(axes[2],), reference=())
    if kinds == "PPPS" and _same_triad(axes, UNITS):
        spherical = tuple(3 + k for k in chain[3].driven)
        driven = tuple(k for k in made.driven if k < 3) + spherical
        return dataclasses.replace(made, type="free", driven=driven, reference=())
    return None


def plane_axes(normal: Triple) -> tuple[Triple, Triple]:
    """The two sliding axes of a planar joint: `symscrew.reference.maximal_coordinates.plane_axes` with 50 digits."""
    sizes = [abs(entry) for entry in normal]
    nearest = UNITS[sizes.index(min(sizes))]
    rest = minus(nearest, scaled(normal, dot(nearest, normal)))
    first = scaled(rest, 1 / length(rest))
    return first, cross(normal, first)


def _same_triad(axes: Sequence[Triple], wanted: Sequence[Triple]) -> bool:
    return all(length(minus(a, b)) < NEAR for a, b in zip(axes, wanted, strict=True))


def _sine(a: Triple, b: Triple) -> Real:
    return length(cross(a, b))


def _meeting(p: Triple, a: Triple, q: Triple, b: Triple) -> Triple | None:
    """Where the lines p + s a and q + t b meet, or None."""
    normal = cross(a, b)
    gap = minus(q, p)
    along = dot(cross(gap, b), normal) / dot(normal, normal)
    meeting = plus(p, scaled(a, along))
    miss = dot(gap, normal) / length(normal)
    return meeting if abs(miss) < NEAR * max(1, length(gap)) else None
