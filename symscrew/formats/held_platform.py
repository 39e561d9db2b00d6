"""The platform of a file that names none: the body that three legs or more hold, each on its own way to the ground."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.formats.draft import RawJoint

FREE = "free"
LEGS = 3
"""Ways from the ground to a body from which on it is a platform whose legs are chains of their own."""


def held_platform(ground: str, joints: Sequence[RawJoint]) -> str | None:
    """The body that most legs hold, three at least: ways from the ground that end in a joint of theirs each."""
    at: dict[str, list[RawJoint]] = {}
    joints = [joint for joint in joints if joint.type != FREE]  # which holds nothing
    for joint in joints:
        for end in {joint.parent, joint.child}:
            at.setdefault(end, []).append(joint)
    loops = len(joints) - (len(at) - 1)
    if loops < LEGS - 1:  # each leg beyond the first closes one
        return None
    legs: dict[str, int] = {}
    for body, own in at.items():
        if body != ground and len(own) >= LEGS:
            reached = depths(ground, [joint for joint in joints if body not in (joint.parent, joint.child)])
            legs[body] = sum((j.child if j.parent == body else j.parent) in reached for j in own)
    best = max(legs, key=lambda body: legs[body], default=None)
    return best if best is not None and legs[best] >= LEGS else None


def depths(ground: str, joints: Sequence[RawJoint]) -> dict[str, int]:
    """Joints between the ground and every body that they reach."""
    beside: dict[str, list[str]] = {}
    for joint in joints:
        beside.setdefault(joint.parent, []).append(joint.child)
        beside.setdefault(joint.child, []).append(joint.parent)
    found, frontier = {ground: 0}, [ground]
    while frontier:
        level = found[frontier[0]] + 1
        frontier = list(dict.fromkeys(far for near in frontier for far in beside.get(near, ()) if far not in found))
        found.update(dict.fromkeys(frontier, level))
    return found
