"""How a coordinate is called: one name that is typed, shown and accepted everywhere.

"joint", "joint.i"                  the displacement of a single freedom [rad, m]
"joint.rx", "joint.qx" ...          of a spherical joint: its rotation vector [rad]; an entry of its quaternion
"platform_pose.0", .qx              of the joint on which the package hangs a platform that many limbs hold
"body.x", .y, .z                    how far a body is displaced from the reference [m]
"body.rx", .ry, .rz                 its rotation vector from there: an angle about an axis, as three components [rad]
"body.turn"                         the same as text, "30deg about 1,1,0"
"body.tilt", .azimuth, .torsion     a turn by `torsion` about z, then by `tilt` about the axis (cos a, sin a, 0), a the
                                    azimuth; a tilt without azimuth is about x [rad]
"body.roll", .pitch, .yaw           turns about x, then y, then z, absolute axes [rad]
"body.qx", .qy, .qz                 entries of its quaternion: the sine of half an angle, no angle

`tilt`, `z` and so on alone are the platform's; `q.joint` is the same as `joint`: so columns of runs are called.
"""

from __future__ import annotations

import difflib
import itertools
import math
import re
from collections.abc import Collection, Iterable, Mapping
from typing import Any

import sympy

from symscrew.description import Joint, Mechanism, given_value
from symscrew.errors import DescriptionError, did_you_mean, expect, shorten
from symscrew.kinematics.tree import virtual_joint

ANGLES = ("rx", "ry", "rz", "tilt", "azimuth", "torsion", "roll", "pitch", "yaw", "turn")
BODY_PARTS: Mapping[str, str] = {
    **dict.fromkeys("xyz", "m"), **dict.fromkeys(ANGLES, "rad"), **dict.fromkeys(("qx", "qy", "qz"), "1")
}  # fmt: skip
"""What a body's coordinates end in, and their units."""
SPHERICAL_PARTS: Mapping[str, str] = {p: BODY_PARTS[p] for p in ("qx", "qy", "qz", "rx", "ry", "rz")}
"""The same of a spherical joint."""
PLATFORM = "platform."
"""What stands for the platform's body in names, unless something else is called so."""
COLUMN = "q."
"""What columns of coordinates begin with, in the files of `simulate` and `drives`."""


def identifiers(labels: Iterable[str]) -> dict[str, str]:
    """Label -> its name in expressions and on tapes, each its own: `joint.2` is `joint_2`, or `joint__2` where a joint
    is called `joint_2`.

    >>> identifiers(["joint.1", "joint.2", "joint_2"])
    {'joint.1': 'joint_1', 'joint.2': 'joint__2', 'joint_2': 'joint_2'}
    """
    given = list(labels)
    taken = {label for label in given if "." not in label}
    found = {}
    for label in dict.fromkeys(given):
        name = label
        if "." in label:
            name = next(n for k in itertools.count(1) if (n := label.replace(".", "_" * k)) not in taken)
            taken.add(name)
        found[label] = name
    return found


def check_apart(mechanism: Mechanism, names: Iterable[str]) -> None:
    """Raise DescriptionError for a parameter that is an input and has the name of one of these inputs."""
    for name in names:
        if name in mechanism.parameters and mechanism.parameters[name].run_time:
            raise DescriptionError(
                f"parameters.{name}: as an input it is called like a coordinate, a rate or a drive of a joint; "
                "give the parameter another name"
            )


def coordinate_units(mechanism: Mechanism) -> dict[str, str]:
    """Every typable name of a coordinate, joints first, then the platform, then the other bodies; with its unit."""
    virtual = virtual_joint(mechanism)
    made: dict[str, str] = {}
    for joint in [*mechanism.joints.values(), *([virtual] if virtual else [])]:
        made |= _of_joint(joint)
    platform = [mechanism.platform] if mechanism.platform else []
    for body in dict.fromkeys([*platform, *mechanism.bodies]):
        if body != mechanism.ground:
            made |= {f"{body}.{part}": unit for part, unit in BODY_PARTS.items() if f"{body}.{part}" not in made}
    return made


def _of_joint(joint: Joint) -> dict[str, str]:
    made: dict[str, str] = {}
    for name, motion in zip(joint.kind.motion_names(joint.name), joint.kind.motions, strict=True):
        if motion.spherical:
            made |= {f"{joint.name}.{part}": unit for part, unit in SPHERICAL_PARTS.items()}
        else:
            made[name] = motion.q[0].unit
    return made


def typable_names(mechanism: Mechanism) -> list[str]:
    """Every name of a coordinate, then the parts of the platform's pose alone."""
    short = [part for part in BODY_PARTS if full_name(mechanism, part) != part]
    return [*coordinate_units(mechanism), *short]


def full_name(mechanism: Mechanism, name: str) -> str:
    """The name with its owner: the platform's where only a part is typed, as in `tilt`; without a column's `q.`.

    `platform` is the platform, whatever its body is called, unless something else is.
    """
    if name.startswith(COLUMN) and not _is_owner(mechanism, COLUMN[:-1]):
        name = name.removeprefix(COLUMN)
    if name.startswith(PLATFORM) and mechanism.platform is not None and not _is_owner(mechanism, PLATFORM[:-1]):
        return f"{mechanism.platform}.{name.removeprefix(PLATFORM)}"
    owned = "." in name or name in mechanism.joints or name in mechanism.parameters or name in mechanism.bodies
    if owned or name not in BODY_PARTS or mechanism.platform is None:
        return name
    return f"{mechanism.platform}.{name}"


def _is_owner(mechanism: Mechanism, name: str) -> bool:
    return name in mechanism.joints or name in mechanism.bodies or name in mechanism.points


def tree_label(mechanism: Mechanism, labels: Collection[str], typed: str) -> str:
    """The label of the coordinate of the tree that a name means.

    That of a platform which hangs on a joint of the package's own is this joint's: `x`, `y`, `z` its translations (of
    its point, and counted from O), `qx`, `qy`, `qz` its quaternion, `rz` a planar one's angle.

    Raises:
        DescriptionError: the tree has no such coordinate.
    """
    expect(typed, str)
    name, virtual = full_name(mechanism, typed), virtual_joint(mechanism)
    owner, _, part = name.rpartition(".")
    if name in labels:
        return name
    if virtual is not None and owner == virtual.child:
        if f"{virtual.name}.{part}" in labels:
            return f"{virtual.name}.{part}"
        for label, parts in zip(virtual.kind.motion_names(virtual.name), _parts_of(virtual), strict=True):
            if part in parts:
                return label
    near = nearest_names(typed, labels)
    hint = f"; {near}" if near.startswith("did you mean") else ""
    raise DescriptionError(f"expected labels of q among {', '.join(labels)}, got {typed!r}{hint}")


def _parts_of(virtual: Joint) -> tuple[tuple[str, ...], ...]:
    """What the motions of the joint on which a platform hangs are called of the platform."""
    if not virtual.axes:  # all motions are free
        return ("x",), ("y",), ("z",), ()
    upright = tuple(virtual.axes[0]) == (0, 0, 1)  # x and y then complete the triad
    return (("x",), ("y",), ("rz", "yaw", "torsion")) if upright else ((), (), ())


def given_coordinates(mechanism: Mechanism, given: Mapping[str, Any], where: str = "at") -> dict[str, sympy.Expr]:
    """Full name -> exact value [rad, m] of coordinates as they are typed: with units or without.

    Names that are none are handed on, with their values as numbers: who looks for them says so.

    Raises:
        DescriptionError: a value that cannot be read, one in a unit of another kind, or a coordinate given twice.
    """
    units, found = coordinate_units(mechanism), dict[str, sympy.Expr]()
    for typed, value in given.items():
        name, here = full_name(mechanism, typed), f"{where} {typed}"
        if name.endswith(".turn") and name in units:
            made = {f"{name[:-4]}{part}": entry for part, entry in _turn(value, here).items()}
        else:
            read = given_value(value, where=here)
            made = {name: read.measured_in(units[name], here) if name in units else read.value}
        if twice := sorted(made.keys() & found.keys()):
            raise DescriptionError(f"{where}: {twice[0]} is given twice")
        found |= made
    return found


def given_parameter(mechanism: Mechanism, name: str, value: Any, where: str = "at") -> sympy.Expr:
    """The value of a parameter in its unit, exact; raises DescriptionError."""
    here = f"{where} {name}"
    return given_value(value, where=here).measured_in(mechanism.parameters[name].unit, here)


def angle_notices(mechanism: Mechanism, given: Mapping[str, Any]) -> list[str]:
    """A sentence for every angle that was given as a bare number of more than half a turn."""
    units, found = coordinate_units(mechanism), []
    units |= {name: parameter.unit for name, parameter in mechanism.parameters.items()}
    for typed, value in given.items():
        name = full_name(mechanism, typed)
        if name in units and not name.endswith(".turn"):
            found.append(given_value(value, where=typed).notice(units[name], typed))
    return [text for text in found if text]


def _turn(value: Any, where: str) -> dict[str, sympy.Expr]:
    """The rotation vector of "30deg about 1,1,0"; an axis of any length."""
    angle, about, axis = str(value).partition(" about ")
    entries = [sympy.S.Zero if not part.strip() else given_value(part, where=where).value
               for part in axis.strip(" ()[]").replace(",", " ").split()]  # fmt: skip
    length = sympy.sqrt(sum((c * c for c in entries), sympy.S.Zero))
    if not about or len(entries) != 3 or length == 0:
        raise DescriptionError(
            f"{where}: expected an angle about an axis such as '30deg about 1,1,0', got {shorten(value)}"
        )
    size = given_value(angle, where=where).measured_in("rad", where)
    return {part: size * c / length for part, c in zip(("rx", "ry", "rz"), entries, strict=True)}


def nearest_names(name: str, known: Iterable[str]) -> str:
    """A sentence with the known names that a typed one is closest to, whatever stands between its parts.

    >>> nearest_names("limb5 S.qy", ["limb5_S.qx", "limb5_S.qy", "limb4_S.qy"])
    "did you mean 'limb5_S.qy'?"
    """
    candidates = list(dict.fromkeys(known))
    plain = {_plain(candidate): candidate for candidate in reversed(candidates)}
    if _plain(name) in plain:
        return f"did you mean {plain[_plain(name)]!r}?"
    near = difflib.get_close_matches(_plain(name), plain, n=3, cutoff=0.75)
    if near:
        return "did you mean " + " or ".join(repr(plain[n]) for n in near) + "?"
    return did_you_mean(name, candidates)


def _plain(name: str) -> str:
    return re.sub(r"[^a-z0-9]", "", name.lower())


def quaternion_entry(name: str, value: float) -> str:
    """What an entry of a quaternion is as an angle, in words; nothing for other coordinates.

    >>> quaternion_entry("limb5_S.qy", 0.05)
    'an entry of a quaternion: alone, a turn by 5.73 deg about y'
    """
    part = name.rpartition(".")[2]
    if len(part) != 2 or part[0] != "q" or part[1] not in "xyz" or not abs(value) <= 1:
        return ""
    return f"an entry of a quaternion: alone, a turn by {math.degrees(2 * math.asin(value)):.3g} deg about {part[1]}"
