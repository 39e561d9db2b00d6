"""Keyframes of an MJCF as values of our coordinates and rates: where a scene may begin.

    hinge, slide: the value itself    ball: (w, R v), turned into absolute axes    free: x - x0, and Q R^T
    rates: of hinge, slide and places the value itself, of turns R omega

R and x0 are the body's own orientation and place in the reference configuration, (w, v) and Q what the file says.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from symscrew.errors import DescriptionError
from symscrew.formats.rigid_displacements import (
    Pose,
    Real,
    Rotation,
    apply,
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
RATES = {"hinge": 1, "slide": 1, "ball": 3, "free": 6}
TURNING = ("wx", "wy", "wz")
QUATERNION = ("qw", "qx", "qy", "qz")
Values = Mapping[tuple[str, str], Real]
"""(joint of the file, its coordinate: empty where it has one) -> value."""


@dataclass(frozen=True)
class Listed:
    """A joint in the order of the file's coordinates: its kind, and the pose of its body in the reference."""

    name: str
    kind: str
    pose: Pose


def keyframes(root: Element, listed: Sequence[Listed], own: Mapping[str, Real]) -> dict[str, Values]:
    """Keyframe -> values of coordinates; raises DescriptionError for one of another length.

    `own`: hinge or slide -> its value in the file's own pose, which counts where a keyframe has fewer numbers.
    """
    found: dict[str, Values] = {}
    usual = [value for joint in listed for value in _in_own_pose(joint, own)]
    for section in elements(root, "keyframe"):
        for k, key in enumerate(elements(section, "key")):
            if "qpos" in key.attrib:
                given = _listed(key, "qpos", usual)
                found[key_name(key, k)] = _values(given, listed, label(key))
            elif "qvel" in key.attrib:
                found[key_name(key, k)] = {}
    return found


def keyframe_rates(root: Element, listed: Sequence[Listed]) -> dict[str, Values]:
    """Keyframe -> rates that are not zero; raises DescriptionError for another number of them."""
    found: dict[str, Values] = {}
    for section in elements(root, "keyframe"):
        for k, key in enumerate(elements(section, "key")):
            if "qvel" in key.attrib:
                given = _listed(key, "qvel", [real(0)] * sum(RATES[joint.kind] for joint in listed))
                values = {where: value for where, value in _rates(given, listed) if value != 0}
                found |= {key_name(key, k): values} if values else {}
    return found


def key_name(key: Element, index: int) -> str:
    """What a keyframe is called here."""
    return key.get("name") or f"key_{index}"


def _in_own_pose(joint: Listed, own: Mapping[str, Real]) -> list[Real]:
    if joint.kind == "free":
        return [*joint.pose.translation, *to_quaternion(joint.pose.rotation)]
    return [real(1), *[real(0)] * 3] if joint.kind == "ball" else [own.get(joint.name, real(0))]


def _listed(key: Element, what: str, usual: Sequence[Real]) -> list[Real]:
    """The numbers of a keyframe; those that it does not give are the usual ones, as for MuJoCo."""
    given = [real(v) for v in numbers(key.attrib[what], f"{label(key)}, {what}")]
    if len(given) > len(usual):
        raise DescriptionError(f"{label(key)}, {what}: expected {len(usual)} numbers, got {len(given)}")
    return [*given, *usual[len(given) :]]


def _rates(given: Sequence[Real], listed: Sequence[Listed]) -> Iterator[tuple[tuple[str, str], Real]]:
    at = 0
    for joint in listed:
        own = given[at : at + RATES[joint.kind]]
        at += len(own)
        if len(own) == 1:
            yield (joint.name, ""), own[0]
            continue
        for k, value in enumerate(own[:-3]):
            yield (joint.name, str(k)), value
        for axis, value in zip(TURNING, apply(joint.pose.rotation, triple(own[-3:])), strict=True):
            yield (joint.name, axis), value


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
            turn: Rotation = product(product(turned, _turn(own, where)), transposed(turned))
        else:
            place = minus(triple(own[:3]), joint.pose.translation)
            values |= {(joint.name, str(k)): c for k, c in enumerate(place)}
            turn = product(_turn(own[3:], where), transposed(turned))
        values |= {(joint.name, key): c for key, c in zip(QUATERNION, to_quaternion(turn), strict=True)}
    return values


def _turn(quaternion: Sequence[Real], where: str) -> Rotation:
    """A turn from its quaternion, as MuJoCo normalises it: zeros are none."""
    return from_quaternion(quaternion if any(quaternion) else [real(1), *quaternion[1:]], where)
