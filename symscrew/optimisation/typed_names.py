"""What coordinates of a problem may be called, and which labels the functions have for them.

names as typed --known--> did-you-mean, or    --label_of--> labels of the tree and of joints, BODY.PART of a pose
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.kinematics import BODY_PARTS, coordinate_units, full_name, nearest_names


def known_names(mechanism: Mechanism, labels: Sequence[str]) -> list[str]:
    """What a condition or bound on coordinates may name: `labels` of the tree and of joints first."""
    short = [part for part in BODY_PARTS if full_name(mechanism, part) != part]
    return list(dict.fromkeys((*labels, *coordinate_units(mechanism), *short)))


def check_typed(mechanism: Mechanism, labels: Sequence[str], where: str, names: Iterable[str]) -> None:
    """Refuse names that mean nothing, and two that mean the same.

    Raises:
        DescriptionError: begins with `where`.
    """
    known, seen = known_names(mechanism, labels), dict[str, str]()
    for name in names:
        if name not in known:
            raise DescriptionError(f"{where}: unknown name {name!r}; {nearest_names(name, known)}")
        other = seen.setdefault(label_of(mechanism, name), name)
        if other != name:
            raise DescriptionError(f"{where}: {other} and {name} are the same coordinate; leave one out")


def label_of(mechanism: Mechanism, typed: str) -> str:
    """The label that functions have for a name: rotation vectors of spherical joints are `joint.x` there."""
    name = full_name(mechanism, typed)
    owner, _, part = name.rpartition(".")
    spherical = owner in mechanism.joints and mechanism.joints[owner].kind.ball
    return f"{owner}.{part[1]}" if spherical and part in ("rx", "ry", "rz") else name
