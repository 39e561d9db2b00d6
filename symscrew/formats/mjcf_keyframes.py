"""Keyframes of an MJCF as values of our coordinates: where a scene may begin.

    hinge, slide: the value itself    ball: (w, R v), turned into absolute axes    free: x - x0, and Q R^T

R and x0 are the body's own orientation and place in the reference configuration, (w, v) and Q what the file says.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from symscrew.errors import DescriptionError
from symscrew.formats.rigid_displacements import (
    Pose,
    Real,
    Rotation,
    from_quaternion,
    minus,
    product,
    real,
    to_quaternion,
    transposed,
    triple,
)
from symscrew.formats.safe_xml import Element, elements, label, numbers

SIZES = {"hinge": 1, "slide": 1, "ball": 4, "free": 7}
QUATERNION = ("qw", "qx", "qy", "qz")
Values = Mapping[tuple[str, str], Real]
"""(joint of the file, its coordinate: empty where it has one) -> value."""


@dataclass(frozen=True)
class Listed:
    """A joint in the order of the file's coordinates: its kind, and the pose of its body in the reference."""

    name: str
    kind: str
    pose: Pose


def keyframes(root: Element, listed: Sequence[Listed]) -> dict[str, Values]:
    """Keyframe -> values of coordinates; raises DescriptionError for one of another length."""
    found: dict[str, Values] = {}
    for section in elements(root, "keyframe"):
        for k, key in enumerate(elements(section, "key")):
            if "qpos" not in key.attrib:
                continue
            given = [real(v) for v in numbers(key.attrib["qpos"], f"{label(key)}, qpos")]
            size = sum(SIZES[joint.kind] for joint in listed)
            if len(given) != size:
                raise DescriptionError(f"{label(key)}, qpos: expected {size} numbers, got {len(given)}")
            found[key.get("name") or f"key_{k}"] = _values(given, listed, label(key))
    return found


def _values(given: Sequence[Real], listed: Sequence[Listed], where: str) -> Values:
    values: dict[tuple[str, str], Real] = {}
    at = 0
    for joint in listed:
        own = given[at : at + SIZES[joint.kind]]
        at += len(own)
        if len(own) == 1:
            values[joint.name, ""] = own[0]
            continue
        turned = joint.pose.rotation
        if joint.kind == "ball":
            turn: Rotation = product(product(turned, from_quaternion(own, where)), transposed(turned))
        else:
            place = minus(triple(own[:3]), joint.pose.translation)
            values |= {(joint.name, str(k)): c for k, c in enumerate(place)}
            turn = product(from_quaternion(own[3:], where), transposed(turned))
        values |= {(joint.name, key): c for key, c in zip(QUATERNION, to_quaternion(turn), strict=True)}
    return values
