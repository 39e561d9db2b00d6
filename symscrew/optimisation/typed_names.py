"""What coordinates of a problem may be called, and which labels the functions have for them.

names as typed --known--> did-you-mean, or    --label_of--> labels of the tree and of joints, BODY.PART of a pose
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.kinematics import full_name, nearest_names, typable_names

NO_RATES = ("tilt", "azimuth", "turn")  # the first two where a body is upright; a turn is three numbers


def known_names(mechanism: Mechanism, labels: Sequence[str]) -> list[str]:
    """What a condition or bound on coordinates may name: `labels` of the tree and of joints first."""
    return list(dict.fromkeys((*labels, *typable_names(mechanism))))


def check_rates(mechanism: Mechanism, labels: Sequence[str], where: str, names: Iterable[str]) -> None:
    """`check_typed` of rates: of `labels`, and of bodies' poses but for what has no rate where a body is upright.

    Raises:
        DescriptionError: begins with `where`.
    """
    given = list(names)
    check_typed(mechanism, labels, where, given)
    for name in given:
        label = label_of(mechanism, name)
        owner, _, part = label.rpartition(".")
        if label not in labels and (owner not in mechanism.bodies or part in NO_RATES):
            raise DescriptionError(
                f"{where}: {name} has no rate here; expected rates of x, y, z, rx, ry, rz, roll, pitch, yaw or torsion "
                "of a body, or of joints"
            )


def check_typed(mechanism: Mechanism, labels: Sequence[str], where: str, names: Iterable[str]) -> None:
    """Refuse names that mean nothing, and two that mean the same.

    Raises:
        DescriptionError: begins with `where`.
    """
    known, seen = known_names(mechanism, labels), dict[str, str]()
    for name in names:
        if name not in known and full_name(mechanism, name) not in known:
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
