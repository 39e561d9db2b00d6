"""Forces and limits of joints and actuators of an MJCF file, as effects and limits.

    armature -> rotor_inertia     damping -> viscous_friction     frictionloss -> dry_friction
    stiffness, springref -> joint_spring     range -> limits     position, velocity actuators -> position_servo

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#body-joint and #actuator.
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from typing import Any

from symscrew.errors import DescriptionError, shorten
from symscrew.formats.draft import Draft, Limits, RawEffect
from symscrew.formats.mjcf_settings import Attributes, Settings
from symscrew.formats.rigid_displacements import Real, real
from symscrew.formats.safe_xml import number, numbers

SLIP = "1e-3"
"""Rate [rad/s or m/s] below which dry friction of a file creeps: files give its level alone, engines make it stick."""
FREE = "free"
UNLIKE = ("ball", FREE)
"""Joints whose freedoms have no axis of their own: a spring there is none of one coordinate."""


@dataclass(frozen=True)
class TimedSpring:
    """A joint's springdamper: time [s], ratio, and where its spring rests (None: it has no coordinate of its own)."""

    time: float
    ratio: float
    rest: Real | None


def joint_forces(
    draft: Draft, settings: Settings, name: str, *, attributes: Attributes, kind: str
) -> TimedSpring | None:
    """Enter what a joint says of forces and limits; a spring and damper that wait for its inertia are the result."""
    where, single = f"<joint name={name!r}>", kind not in UNLIKE

    def values(key: str, flag: str = "") -> list[Decimal]:
        given = numbers(attributes.get(key, "0"), f"{where}, {key}")
        return given if given and flag not in settings.off else [Decimal(0)]

    def add(kind_of: str, what: str, **table: Any) -> None:
        draft.effects.append(RawEffect(name, {"kind": kind_of, **table}))
        draft.ledger.turned(what)

    armature, friction = values("armature")[0], values("frictionloss", "frictionloss")[0]
    damping, stiffness = values("damping", "damper"), values("stiffness", "spring")
    if armature != 0:
        add("armature", "armature", inertia=float(armature))
    timed = _timed(settings, attributes, where, kind)
    if damping[0] != 0 and timed is None:
        add("damping", "damping", coefficient=float(damping[0]))
    freedoms = {"ball": range(3), FREE: range(6)}.get(kind, (None,))
    for k in freedoms if friction != 0 else ():
        more = {} if k is None else {"freedom": k}
        add("friction", "frictionloss", coulomb=float(friction), velocity=float(SLIP), **more)
    if friction != 0 and not single:
        draft.ledger.changed.append(f"{where}, frictionloss: about axes of the parent, the file means the body's own")
    if stiffness[0] != 0 and timed is None:
        if single:
            rest = _rest(settings, attributes, where, kind)
            add("spring", "stiffness", stiffness=float(stiffness[0]), rest=float(rest))
        elif kind == "ball":  # along the shortest turn from where it stands in the file
            add("spring", "stiffness", stiffness=float(stiffness[0]), nearest=True)
        else:
            draft.ledger.lost(f"stiffness of a {kind} joint")
    if any(value != 0 for value in (*damping[1:], *stiffness[1:])):
        draft.ledger.lost("powers of damping or stiffness above the first")
    if single:
        _limits(draft, settings, name, attributes=attributes, kind=kind)
    elif any(numbers(attributes.get("range", "0"), f"{where}, range")) and attributes.get("limited") != "false":
        draft.ledger.passed(f"range of a {kind} joint")
    return timed


def _rest(settings: Settings, attributes: Attributes, where: str, kind: str) -> Real:
    rest = number(attributes.get("springref", "0"), f"{where}, springref")
    return settings.angle(rest) if kind == "hinge" else real(rest)


def _timed(settings: Settings, attributes: Attributes, where: str, kind: str) -> TimedSpring | None:
    """What is in the place of stiffness and damping, where both numbers of springdamper are above zero."""
    time, ratio = numbers(attributes.get("springdamper", "0 0"), f"{where}, springdamper", 2)
    if not time and not ratio:
        return None
    if time <= 0 or ratio <= 0:
        raise DescriptionError(f"{where}, springdamper: expected a time and a ratio above zero, got {time} {ratio}")
    rest = None if kind in UNLIKE else _rest(settings, attributes, where, kind)
    return TimedSpring(float(time), float(ratio), rest)


def _limits(draft: Draft, settings: Settings, name: str, *, attributes: Attributes, kind: str) -> None:
    where = f"<joint name={name!r}>"
    whole = limited(settings, attributes, "range", "limited") or _reversed(attributes, "range", "limited")
    if "limit" not in settings.off and whole:
        low, high = numbers(attributes["range"], f"{where}, range", 2)
        found = draft.limits.setdefault(name, Limits())
        found.lower, found.upper = (settings.angle(v) if kind == "hinge" else real(v) for v in (low, high))
        draft.ledger.turned("range")
    if limited(settings, attributes, "actuatorfrcrange", "actuatorfrclimited"):
        low, high = numbers(attributes["actuatorfrcrange"], f"{where}, actuatorfrcrange", 2)
        effort(draft, name, max(abs(low), abs(high)))
        draft.limits[name].push = (real(low), real(high))
        draft.ledger.turned("actuatorfrcrange")


def limited(settings: Settings, attributes: Attributes, reach: str, key: str) -> bool:
    """Whether a range is one that limits, by MuJoCo's rule: with `auto` one whose ends are in order.

    Raises:
        DescriptionError: a switch that is none, `true` without such a range, a range that nothing says the use of.
    """
    said = attributes.get(key, "auto")
    if said not in ("true", "false", "auto"):
        raise DescriptionError(f"{key}: expected true, false or auto, got {shorten(said)}")
    given = attributes.get(reach)
    low, high = numbers(given, reach, 2) if given is not None else (0, 0)
    if said == "true" and not low < high:
        raise DescriptionError(
            f"{key}: is true, where {reach} is {shorten(given) if given is not None else 'missing'}; expected two "
            "numbers, the smaller one first"
        )
    if said == "auto" and not settings.auto_limits and (low, high) != (0, 0):
        raise DescriptionError(
            f'{reach}: is given without {key} where <compiler> says autolimits="false", which MuJoCo refuses; add '
            f'{key}="true" or "false"'
        )
    return said == "true" or (said == "auto" and low < high)


def _reversed(attributes: Attributes, reach: str, key: str) -> bool:
    """Whether a range has its larger end first, so that it limits nothing: the account says so."""
    low, high = numbers(attributes.get(reach, "0 0"), reach, 2)
    return attributes.get(key, "auto") == "auto" and low > high


def effort(draft: Draft, name: str, most: Any) -> None:
    """Enter the greatest effort [N or N m] of a joint, the least of those that are given."""
    found = draft.limits.setdefault(name, Limits())
    size = real(most)
    found.effort = size if found.effort is None else min(found.effort, size)
