"""Singular poses in words: those of which the same is said in one line, with the coordinates that lead there.

SingularPose --place, kinds, what the mechanism does there--> "at limb1_P, limb2_P = 0.5 m, each alone: ..."
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions.branch_words import freedom_names
from symscrew.mobility.motions.singular_poses import MOST_FREEDOMS, SingularPose

if TYPE_CHECKING:
    from symscrew.mobility.motions.whole_motion import WholeMotion

MOST_LINES = 12
"""Lines on singular poses; of more, how many there are. All are in the JSON."""
UNTRIED = f"its branches were not looked for, there being more than {MOST_FREEDOMS} freedoms"
OWN = "its limb"
KINDS = {
    "closure": "the closure loses rank: more instantaneous mobility",
    "constraint": "constraint singularity: the constraints of the limbs become dependent",
    "drives": "actuation singularity: a freedom is left with all drives locked",
    "platform": "{} has fewer freedoms",
    "dead": "dead point: {} is at rest for an instant",
    "coordinate": "end of the coordinate's range",
}


def pose_lines(found: WholeMotion, network: Network, mechanism: Mechanism, body: str) -> list[str]:
    """The singular poses on the lines; one for all coordinates of which it says the same, each of its own limb."""
    alone = bool(found.classes) and found.classes[0].order == 1
    limbs = sorted(joint for limb in mechanism.limbs.values() for joint in limb.joints) == sorted(network.edges)
    alike: dict[tuple[str, str, str], list[SingularPose]] = {}
    for pose in found.singular:
        what = _words(pose, body, limbs=limbs, alone=alone)
        own = _limb_of(pose, network, mechanism)
        alike.setdefault(
            (_place(pose, network, mechanism), _passed(pose), what.replace(f" {own} ", f" {OWN} ")), []
        ).append(pose)
    names, lines = freedom_names(network), list[str]()
    for (place, passed, what), poses in list(alike.items())[:MOST_LINES]:
        moved = [names[c] for c in dict.fromkeys(pose.column for pose in poses)]
        several = len(moved) > 1
        said = what if several else what.replace(OWN, _limb_of(poses[0], network, mechanism))
        lines.append(f"at {', '.join(moved)} = {place}{', each alone' * several}{passed}: {said}")
    left = sum(map(len, list(alike.values())[MOST_LINES:]))
    return [*lines, f"and {left} more singular pose{'s' * (left > 1)}"] if left else lines


def _words(pose: SingularPose, body: str, *, limbs: bool, alone: bool) -> str:
    """Kinds, and what the mechanism does there."""
    dependent = [kind for kind in pose.kinds if kind not in KINDS]
    finer = {
        "closure": "constraint" if limbs and not dependent else "closure",
        "platform": "dead" if alone else "platform",
    }
    parts = [kind_words(finer.get(kind, kind), body) for kind in pose.kinds if kind in KINDS]
    parts += [limb_words(dependent)] if dependent else []
    if "closure" in pose.kinds:
        crossing = ", ".join(map(str, pose.branches))
        locked = f", {pose.locked} with all drives locked" if pose.locked else ""
        parts.append(f"{pose.instantaneous} instantaneous freedoms{locked}")
        untold = UNTRIED if pose.untried else "its branches were not told apart"
        parts.append(f"branches of dimension {crossing} meet" if pose.branches else untold)
    parts += [f"{kind_words(kind, body)}, as far as doubles tell" for kind in pose.open]
    for kind, left in pose.almost.items():
        parts.append(f"almost, and not as typed (what it takes stays open by {left:.1e}): {kind_words(kind, body)}")
        if kind == "closure":
            parts.append("poses beyond may be of another branch")
    return "; ".join(parts)


def kind_words(kind: str, body: str) -> str:
    """What is lost, in words."""
    return KINDS[kind].format(body) if kind in KINDS else limb_words([kind])


def limb_words(limbs: Sequence[str]) -> str:
    """That the screws of limbs become dependent."""
    return f"limb singularity: the screws of {' and of '.join(limbs)} become dependent"


def _limb_of(pose: SingularPose, network: Network, mechanism: Mechanism) -> str:
    """The limb whose coordinate moves; empty for none."""
    joint = next(edge.name for edge in network.edges.values() if pose.column in edge.columns)
    return next((limb.name for limb in mechanism.limbs.values() if joint in limb.joints), "")


def _passed(pose: SingularPose) -> str:
    if not pose.ends_passed:
        return ""
    return f", past {'an end' if pose.ends_passed == 1 else f'{pose.ends_passed} ends'} of its range"


def value_of(pose: SingularPose, network: Network, mechanism: Mechanism) -> tuple[str, float, bool]:
    """(name, value as the description counts it [rad, m], whether it is a length)."""
    for edge in network.edges.values():
        for index, (motion, start) in enumerate(edge.motions):
            if start <= pose.column < start + motion.freedom:
                reference = mechanism.joints[edge.name].reference
                given = motion.single and index < len(reference)
                begin = float(mechanism.number(reference[index])) if given else 0.0
                scale = float(network.length) if motion.prismatic else 1.0
                return freedom_names(network)[pose.column], begin + scale * float(pose.q[start]), motion.prismatic
    raise AssertionError("a coordinate is a freedom of a joint")


def _place(pose: SingularPose, network: Network, mechanism: Mechanism) -> str:
    _, value, long = value_of(pose, network, mechanism)
    return f"{value:.6g} m" if long else f"{value:.6g} rad ({np.degrees(value):.4g} deg)"
