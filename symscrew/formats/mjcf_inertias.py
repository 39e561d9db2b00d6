"""What an MJCF's compiler finds from the inertia in its own configuration: dampers by a ratio, springs by a time.

    position dampratio="z"  -->  damping 2 z sqrt(kp m),              1/m = J M^-1 J^T of the actuator's moment arms J
    springdamper="T z"      -->  stiffness m / (T z)^2, damping 2 m / T,  1/m = (M^-1)_ii, of several freedoms the mean

M holds armatures of joints, actuators and tendons, and no equality. Source:
https://mujoco.readthedocs.io/en/stable/XMLreference.html#body-joint-springdamper, #actuator-position-dampratio.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.formats.draft import Draft, RawEffect
from symscrew.formats.mjcf_forces import TimedSpring
from symscrew.formats.mjcf_transmissions import Target, Transmissions
from symscrew.formats.rigid_displacements import Real
from symscrew.formats.tree_freedoms import freedoms_of, mass_matrix, ways_to

Array = np.ndarray[Any, Any]
LEAST = 1e-15
"""Of a time [s] and of its square by the ratio's: what the engine divides by is no less."""
DEPENDENT = 1e-12
"""Of the largest singular value of M: below it rounding alone is left, and a freedom moves no mass."""


@dataclass(frozen=True)
class OwnInertia:
    """The tree of a file in its own configuration, with all rotors, and what transmits forces to it."""

    draft: Draft
    transmissions: Transmissions

    @cached_property
    def names(self) -> list[str]:
        """The joint of every freedom."""
        return [self.draft.joints[freedom.joint].name for freedom in self._freedoms]

    @cached_property
    def _freedoms(self) -> list[Any]:
        return [f for k, joint in enumerate(self.draft.joints) for f in freedoms_of(k, joint)]

    @cached_property
    def inverse(self) -> Array | None:
        """M^-1; None where a freedom moves no mass."""
        draft = self.draft
        matrix = mass_matrix(draft, self._freedoms, ways_to(draft, self._freedoms))
        for rotor in draft.effects:
            if rotor.tendon is None or rotor.table["kind"] != "armature":
                continue
            along = self._along(rotor.tendon)
            factor = float(self.transmissions.tendons[rotor.tendon].get(rotor.joint, 1))  # of a pulley 1
            matrix += float(rotor.table["inertia"]) / factor**2 * np.outer(along, along)
        sizes = np.linalg.svd(matrix, compute_uv=False)
        if not len(sizes) or sizes[-1] <= DEPENDENT * sizes[0]:
            return None
        found: Array = np.linalg.inv(matrix)
        return found

    def _along(self, tendon: str) -> Array:
        """How much longer a tendon gets per unit of every freedom, as the file has it."""
        own = self.transmissions.own[tendon]
        return np.array([float(own.get(name, 0)) for name in self.names])

    def damping(self, target: Target, gear: Real, *, ratio: float, stiffness: float) -> float | None:
        """2 ratio sqrt(kp m) in an actuator's units, on a joint or a tendon; None: the inertia is not known."""
        moved = {target.joint} if target.tendon is None else set(self.transmissions.own[target.tendon])
        if self.inverse is None or any(self.names.count(name) != 1 for name in moved):
            return None
        arms = np.array([float(name == target.joint) for name in self.names])
        arms = float(gear) * (arms if target.tendon is None else self._along(target.tendon))
        yielding = float(arms @ self.inverse @ arms)
        return 2 * ratio * math.sqrt(stiffness / yielding) if yielding > 0 else None

    def enter_springs(self, draft: Draft, given: Mapping[str, TimedSpring], off: Collection[str]) -> None:
        """Enter the springs and dampers that joints have by a time and a ratio.

        Args:
            draft: that is filled.
            given: joint -> its springdamper.
            off: flags of the file by which forces do not act.
        """
        if not given:
            return
        if self.inverse is None:
            draft.ledger.lost("springdamper of a joint, for which the inertia is not known", len(given))
            return
        yielding = np.diag(self.inverse)
        for joint, spring in given.items():
            own = [value for name, value in zip(self.names, yielding, strict=True) if name == joint]
            inertia = len(own) / float(sum(own))
            if "damper" not in off:
                size = 2 * inertia / max(spring.time, LEAST)
                draft.effects.append(RawEffect(joint, {"kind": "damping", "coefficient": size}))
            if spring.rest is None:
                draft.ledger.lost("stiffness of a ball or free joint")
            elif "spring" not in off:
                size = inertia / max((spring.time * spring.ratio) ** 2, LEAST)
                draft.effects.append(
                    RawEffect(joint, {"kind": "spring", "stiffness": size, "rest": float(spring.rest)})
                )
            draft.ledger.turned("springdamper")
