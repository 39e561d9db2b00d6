"""Actuators of an MJCF file: which freedoms are driven, and the servos and limits of the drives.

    position, velocity, general actuators that are either --> position_servo beside the drive
    forcerange, ctrlrange of motors --> limits     on a site --> a wrench there that is an input

An actuator on a fixed tendon drives a joint or a pulley (`mjcf_transmissions`).
Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#actuator.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

import numpy as np

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import Draft, RawEffect, RawLoad
from symscrew.formats.mjcf_forces import effort
from symscrew.formats.mjcf_settings import ACTUATORS, Settings
from symscrew.formats.mjcf_transmissions import Target, Transmissions
from symscrew.formats.rigid_displacements import Real, real
from symscrew.formats.safe_xml import Element, elements, label, number, numbers
from symscrew.formats.tree_freedoms import freedoms_of, mass_matrix, ways_to

ON_OTHERS = ("tendon", "site", "body", "slidersite", "cranksite", "refsite")
"""What an actuator may act on in place of a joint."""


@dataclass(frozen=True)
class Actuators:
    """The actuators of a file: elements with the attributes of their classes, and what they act on."""

    listed: Sequence[tuple[Element, Mapping[str, str]]]
    transmissions: Transmissions

    @classmethod
    def of(cls, root: Element, settings: Settings, transmissions: Transmissions) -> Actuators:
        """Of the <actuator> sections; raises DescriptionError."""
        listed = []
        for section in elements(root, "actuator"):
            for element in elements(section):
                if element.tag not in (*ACTUATORS, "plugin"):
                    raise DescriptionError(f"{label(element)} in <actuator>: only actuators of joints are supported")
                listed.append((element, settings.actuator(element)))
        return cls(listed, transmissions)

    def on_targets(self) -> Iterator[tuple[Element, Mapping[str, str], Target]]:
        """Those on joints and fixed tendons."""
        for element, given in self.listed:
            target = self.transmissions.of(given, label(element))
            if target is not None:
                yield element, given, target

    def driven(self) -> dict[str, tuple[int, ...]]:
        """Joint -> its freedoms that an actuator drives, by the gear where there are several."""
        found: dict[str, set[int]] = {}
        for element, given, target in self.on_targets():
            gear = numbers(given.get("gear", "1"), f"{label(element)}, gear")
            found.setdefault(target.joint, set()).update(_geared(gear, label(element)))
        return {name: tuple(sorted(indices)) for name, indices in found.items()}


def _geared(gear: Sequence[object], where: str) -> list[int]:
    indices = [k for k, value in enumerate(gear) if value != 0]
    if len(indices) != 1:
        raise DescriptionError(f"{where}, gear: expected one entry that is not zero, got {len(indices)}")
    return indices


def actuator_forces(draft: Draft, actuators: Actuators, sites: Mapping[str, object], *, displaced: bool) -> None:
    """Enter servos and limits of the actuators; those that a mechanism has no drive for are in the ledger.

    Args:
        draft: with its bodies and joints.
        actuators: of the file.
        sites: names that an actuator may act on.
        displaced: whether the reference configuration is not the file's own.
    """
    for element, given, target in actuators.on_targets():
        gear = [real(v) for v in numbers(given.get("gear", "1"), f"{label(element)}, gear")]
        factor = next((value for value in gear if value != 0), real(1)) * target.factor
        damped = _Damped(draft, actuators.transmissions, target, factor, displaced)
        _servo(draft, element.tag, given, name=target.joint, gear=float(factor), damped=damped)
        if factor != 1:
            draft.ledger.turned("gear: the drive acts on the joint, limits and gains are multiplied")
        for key in ("forcerange", "ctrlrange"):
            if key in given and (key == "forcerange" or element.tag == "motor"):
                low, high = numbers(given[key], f"{label(element)}, {key}", 2)
                effort(draft, target.joint, max(abs(low), abs(high)) * abs(Decimal(str(factor))))
                draft.ledger.turned(key)
    for element, given in actuators.listed:
        if actuators.transmissions.of(given, label(element)) is None:
            _on_others(draft, element, given, sites)


def _on_others(draft: Draft, element: Element, given: Mapping[str, str], sites: Mapping[str, object]) -> None:
    """A force at a site is an input; what acts on anything else is left out."""
    site = given.get("site")
    if site is None or "refsite" in given or element.tag != "motor":
        what = next((key for key in ON_OTHERS if key in given), "nothing that is known")
        draft.ledger.lost(f"<{element.tag}> actuators on a {what}: they drive no joint of their own")
        return
    if site not in sites:
        raise DescriptionError(f"{label(element)}: there is no site {shorten(site)}; {did_you_mean(site, sites)}")
    if all(load.point != site for load in draft.loads):
        draft.loads.append(RawLoad(site))
    draft.ledger.turned("motors on sites: a wrench there is an input, in the body's axes; gears are for the caller")


@dataclass(frozen=True)
class _Damped:
    """Finds the damping of a servo from its ratio, as MuJoCo does: by the inertia in the file's own configuration."""

    draft: Draft
    transmissions: Transmissions
    target: Target
    gear: Real
    displaced: bool

    def gain(self, ratio: float, stiffness: float) -> float | None:
        """2 ratio sqrt(kp m) in the actuator's units, 1/m = J M^-1 J^T of its moment arms J; None: not known."""
        if self.displaced:
            return None
        draft = self.draft
        freedoms = [f for k, joint in enumerate(draft.joints) for f in freedoms_of(k, joint)]
        matrix = mass_matrix(draft, freedoms, ways_to(draft, freedoms))
        names = [draft.joints[freedom.joint].name for freedom in freedoms]
        arms = np.zeros(len(names))
        for name, factor in self.transmissions.coefficients(self.target).items():
            if names.count(name) != 1:
                return None
            arms[names.index(name)] = float(factor * self.gear / self.target.factor)
        try:
            yielding = float(arms @ np.linalg.solve(matrix, arms))
        except np.linalg.LinAlgError:
            return None
        return 2 * ratio * math.sqrt(stiffness / yielding) if yielding > 0 else None


def _servo(draft: Draft, tag: str, given: Mapping[str, str], *, name: str, gear: float, damped: _Damped) -> None:
    """A position or velocity actuator, or a general one that is one, as a servo beside the drive."""

    def value(key: str, default: str = "0") -> float:
        return float(number(given.get(key, default), f"<{tag} joint={name!r}>, {key}"))

    if tag == "motor":
        return
    if tag == "position":
        kp, kv = value("kp", "1"), value("kv")
    elif tag == "velocity":
        kp, kv = 0.0, value("kv", "1")
    elif tag == "general":
        gains = _general(draft, given, f"<{tag} joint={name!r}>")
        if gains is None:
            return
        kp, kv = gains
    else:
        draft.ledger.lost(f"<{tag}> actuators")
        return
    if "dampratio" in given and value("dampratio"):
        found = damped.gain(value("dampratio"), kp)
        if found is None:
            draft.ledger.lost("dampratio of a position actuator, for which the inertia is not known")
        kv = kv if found is None else found
    table: dict[str, Any] = {"kind": "servo", "stiffness": kp * gear**2, "damping": kv * gear**2}
    if "forcerange" in given:
        low, high = (float(v) for v in numbers(given["forcerange"], f"<{tag} joint={name!r}>, forcerange", 2))
        table["limit"] = max(abs(low), abs(high)) * abs(gear)
    if kp < 0 or kv < 0:
        raise DescriptionError(f"<{tag} joint={name!r}>: expected gains of at least 0, got {kp} and {kv}")
    draft.effects.append(RawEffect(name, table))
    draft.ledger.turned(f"<{tag}> actuators")


def _general(draft: Draft, given: Mapping[str, str], where: str) -> tuple[float, float] | None:
    """Gains (kp, kv) of a general actuator that is a servo: force = g u + b1 length + b2 rate; None for a motor.

    A servo whose g is not its stiffness follows the command g u / kp: commands have another unit, forces none.
    """

    def listed(key: str, default: str) -> list[float]:
        found = [float(v) for v in numbers(given.get(key, default), f"{where}, {key}")]
        return [*found, 0.0, 0.0, 0.0][:3]

    gain, bias = listed("gainprm", "1"), listed("biasprm", "0")
    if given.get("biastype", "none") == "none" and given.get("gaintype", "fixed") == "fixed":
        return None
    if given.get("biastype") != "affine" or bias[0] or gain[1] or gain[2]:
        draft.ledger.lost("general actuators that are neither motors nor servos")
        return None
    if bias[1] and abs(bias[1] + gain[0]) > 1e-9 * abs(gain[0]):
        draft.ledger.turned("general actuators with commands of another unit: the servo's target is a displacement")
    return -bias[1], -bias[2]
