"""The motion along coordinate lines in words and as JSON values."""

from __future__ import annotations

from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions.branch_words import freedom_names, named_axes
from symscrew.mobility.motions.pose_words import kind_words, pose_lines, value_of
from symscrew.mobility.motions.singular_poses import SingularPose
from symscrew.mobility.motions.whole_motion import WholeMotion

ALL = 6  # freedoms of a body that moves as it likes: no group worth a word


def motion_lines(found: WholeMotion, network: Network, mechanism: Mechanism, body: str) -> list[str]:
    """What holds along the lines, and the singular poses, a line each."""
    names = freedom_names(network)
    beside = f", and {found.beside} beside these lines" if found.beside else ""
    lines = [f"{found.poses} poses along {', '.join(names[c] for c in found.columns)}, each alone{beside} (sampled)"]
    for system in found.classes[:1]:
        kept = "at every regular pose" if len(found.classes) == 1 else "at most regular poses"
        changes = not found.constant and len(found.classes) == 1 and bool(system.pitches)
        pitch = ", principal pitches not constant" if changes else ""
        why = f" of the branch (proved: {found.type_proof})" if found.type_proof else ""
        lines.append(f"{body} {system.motion_type}, {system if found.constant else system.words}: {kept}{why}{pitch}")
    lines += [f"{body} {system.motion_type}, {system.words}: elsewhere" for system in found.classes[1:]]
    group = found.group.system if found.group is not None else None
    if group is not None and not found.type_proof and 0 < group.order < ALL:
        lines.append(
            f"{body} stays in a group of displacements on the whole branch (proved): {group.motion_type}, {group}"
        )
    for why in dict.fromkeys(found.axes.values()):
        axes = named_axes([axis for axis, reason in found.axes.items() if reason == why])
        lines.append(f"{body} can move {axes} all along ({f'proved: {why}' if why else 'sampled'})")
    judged = f"proved: {found.idle_proof}" if found.idle_proof else "sampled"
    lines.append(f"never move: {', '.join(found.idle)} ({judged})" if found.idle else "every joint moves")
    for column, kind in found.lost:
        lines.append(f"all along the line of {names[column]}: {kind_words(kind, body)} (sampled)")
    lines += pose_lines(found, network, mechanism, body)
    if not found.lost and not any(pose.kinds or pose.open for pose in found.singular):
        lines.append("no singular pose was found on these lines")
    return lines


def motion_values(found: WholeMotion, network: Network, mechanism: Mechanism) -> dict[str, Any]:
    """The same as JSON values."""
    names = freedom_names(network)
    group = found.group.system if found.group is not None else None
    return {
        "coordinates": [names[c] for c in found.columns],
        "poses": found.poses,
        "poses_beside": found.beside,
        "judgement": "sampled",
        "classes": [
            {
                "type": c.type,
                "motion_type": c.motion_type,
                "class": c.name,
                "principal_pitches": list(c.pitches) if found.constant else None,
            }
            for c in found.classes
        ],
        "constant": found.constant,
        "class_proved": bool(found.type_proof),
        "class_proof": found.type_proof,
        "group": None if group is None else {"type": group.type, "class": group.name, "order": group.order},
        "idle_joints": list(found.idle),
        "idle_proved": bool(found.idle_proof),
        "idle_proof": found.idle_proof,
        "axes": [{"axis": axis, "proved": bool(why), "why": why} for axis, why in found.axes.items()],
        "lines": [{"coordinate": names[c], "direction": sign, "end": end} for c, sign, end in found.ends],
        "singular_lines": [{"coordinate": names[column], "kind": kind} for column, kind in found.lost],
        "singular_poses": [_singular(pose, network, mechanism) for pose in found.singular],
    }


def _singular(pose: SingularPose, network: Network, mechanism: Mechanism) -> dict[str, Any]:
    name, value, long = value_of(pose, network, mechanism)
    return {
        "coordinate": name,
        "value": value,
        "unit": "m" if long else "rad",
        "ends_passed": pose.ends_passed,
        "kinds": list(pose.kinds),
        "almost": dict(pose.almost),
        "open": list(pose.open),
        "instantaneous": pose.instantaneous,
        "with_drives_locked": pose.locked,
        "branches": list(pose.branches),
        "displacements": _rounded(pose.q),
    }


def _rounded(values: np.ndarray[Any, Any]) -> list[float]:
    return [round(float(c), 9) for c in values]
