"""Forces and limits of joints and actuators of an MJCF file, as effects and limits.

    armature -> rotor_inertia     damping -> viscous_friction     frictionloss -> dry_friction
    stiffness, springref -> joint_spring     range -> limits     position, velocity actuators -> position_servo

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#body-joint and #actuator.
"""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

from symscrew.errors import DescriptionError
from symscrew.formats.draft import Draft, Limits, RawEffect
from symscrew.formats.mjcf_settings import Attributes, Settings
from symscrew.formats.rigid_displacements import real
from symscrew.formats.safe_xml import Element, elements, label, number, numbers

SLIP = "1e-3"
"""Rate [rad/s or m/s] below which dry friction of a file creeps: files give its level alone, engines make it stick."""
UNLIKE = ("ball", "free")
"""Joints whose freedoms have no axis of their own: an armature there is no rotor, a spring none of one coordinate."""


def joint_forces(draft: Draft, settings: Settings, name: str, *, attributes: Attributes, kind: str) -> None:
    """Enter what a joint says of forces and limits."""
    where, single = f"<joint name={name!r}>", kind not in UNLIKE

    def values(key: str) -> list[Decimal]:
        return numbers(attributes.get(key, "0"), f"{where}, {key}")

    def add(kind_of: str, what: str, **table: Any) -> None:
        draft.effects.append(RawEffect(name, {"kind": kind_of, **table}))
        draft.ledger.turned(what)

    armature, damping, friction = values("armature")[0], values("damping"), values("frictionloss")[0]
    stiffness = values("stiffness")
    if armature != 0:
        if single:
            add("armature", "armature", inertia=float(armature))
        else:
            draft.ledger.lost(f"armature of a {kind} joint")
    if damping[0] != 0 and (single or kind == UNLIKE[0]):
        add("damping", "damping", coefficient=float(damping[0]))
    elif damping[0] != 0:
        draft.ledger.lost("damping of a free joint")
    if friction != 0:
        if single:
            add("friction", "frictionloss", coulomb=float(friction), velocity=float(SLIP))
        else:
            draft.ledger.lost(f"frictionloss of a {kind} joint")
    if stiffness[0] != 0:
        rest = number(attributes.get("springref", "0"), f"{where}, springref")
        at = settings.angle(rest) if kind == "hinge" else real(rest)
        if single:
            add("spring", "stiffness", stiffness=float(stiffness[0]), rest=float(at))
        else:
            draft.ledger.lost(f"stiffness of a {kind} joint")
    if any(value != 0 for value in (*damping[1:], *stiffness[1:])):
        draft.ledger.lost("powers of damping or stiffness above the first")
    if any(value != 0 for value in values("springdamper")):
        draft.ledger.lost("springdamper")
    if single:
        _limits(draft, settings, name, attributes=attributes, kind=kind)


def _limits(draft: Draft, settings: Settings, name: str, *, attributes: Attributes, kind: str) -> None:
    where = f"<joint name={name!r}>"
    if "range" in attributes and (
        attributes.get("limited", "auto") == "true"
        or (attributes.get("limited", "auto") == "auto" and settings.auto_limits)
    ):
        low, high = numbers(attributes["range"], f"{where}, range", 2)
        found = draft.limits.setdefault(name, Limits())
        found.lower, found.upper = (settings.angle(v) if kind == "hinge" else real(v) for v in (low, high))
        draft.ledger.turned("range")
    if "actuatorfrcrange" in attributes and attributes.get("actuatorfrclimited", "auto") != "false":
        low, high = numbers(attributes["actuatorfrcrange"], f"{where}, actuatorfrcrange", 2)
        _effort(draft, name, max(abs(low), abs(high)))
        draft.ledger.turned("actuatorfrcrange")


def _effort(draft: Draft, name: str, most: Any) -> None:
    found = draft.limits.setdefault(name, Limits())
    size = real(most)
    found.effort = size if found.effort is None else min(found.effort, size)


def actuator_forces(draft: Draft, root: Element, settings: Settings) -> None:
    """Enter servos and limits of the actuators on joints; those that a mechanism has no drive for are in the ledger."""
    for section in elements(root, "actuator"):
        for element in elements(section):
            given = settings.actuator(element)
            name = given.get("joint") or given.get("jointinparent")
            if name is None:
                continue
            gear = [real(v) for v in numbers(given.get("gear", "1"), f"{label(element)}, gear")]
            factor = next((value for value in gear if value != 0), real(1))
            _servo(draft, element.tag, given, name=name, gear=float(factor))
            if factor != 1:
                draft.ledger.turned("gear: the drive acts on the joint, limits and gains are multiplied")
            for key in ("forcerange", "ctrlrange"):
                if key in given and (key == "forcerange" or element.tag == "motor"):
                    low, high = numbers(given[key], f"{label(element)}, {key}", 2)
                    _effort(draft, name, max(abs(low), abs(high)) * abs(Decimal(str(factor))))
                    draft.ledger.turned(key)


def _servo(draft: Draft, tag: str, given: Mapping[str, str], *, name: str, gear: float) -> None:
    """A position or velocity actuator, or a general one that is one, as a servo beside the drive."""

    def value(key: str, default: str = "0") -> float:
        return float(number(given.get(key, default), f"<{tag} joint={name!r}>, {key}"))

    def listed(key: str) -> list[float]:
        found = [float(v) for v in numbers(given.get(key, "0"), f"<{tag} joint={name!r}>, {key}")]
        return [*found, 0.0, 0.0, 0.0][:3]

    if tag == "motor":
        return
    if tag == "position":
        kp, kv = value("kp", "1"), value("kv")
    elif tag == "velocity":
        kp, kv = 0.0, value("kv", "1")
    elif tag == "general":
        gain, bias = listed("gainprm") if "gainprm" in given else [1.0, 0.0, 0.0], listed("biasprm")
        if given.get("biastype", "none") == "none" and given.get("gaintype", "fixed") == "fixed":
            return
        if given.get("biastype") != "affine" or bias[0] or gain[1] or gain[2]:
            draft.ledger.lost("general actuators that are neither motors nor servos")
            return
        if bias[1] and abs(bias[1] + gain[0]) > 1e-9 * abs(gain[0]):
            draft.ledger.lost("general actuators whose gain is not their stiffness")
        kp, kv = -bias[1], -bias[2]
    else:
        draft.ledger.lost(f"<{tag}> actuators")
        return
    if "dampratio" in given and value("dampratio"):
        draft.ledger.lost("dampratio of a position actuator, which depends on the pose")
    table: dict[str, Any] = {"kind": "servo", "stiffness": kp * gear**2, "damping": kv * gear**2}
    if "forcerange" in given:
        low, high = (float(v) for v in numbers(given["forcerange"], f"<{tag} joint={name!r}>, forcerange", 2))
        table["limit"] = max(abs(low), abs(high)) * abs(gear)
    if kp < 0 or kv < 0:
        raise DescriptionError(f"<{tag} joint={name!r}>: expected gains of at least 0, got {kp} and {kv}")
    draft.effects.append(RawEffect(name, table))
    draft.ledger.turned(f"<{tag}> actuators")
