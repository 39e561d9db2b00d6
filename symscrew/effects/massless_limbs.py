"""The massless-limb approximation."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

from symscrew.description import Body, Mechanism
from symscrew.effects.effect import Effect
from symscrew.errors import DescriptionError, did_you_mean, shorten


@dataclass(frozen=True, repr=False)
class MasslessLimbs(Effect):
    """A simplification: all bodies but the platform and those in `keep` lose mass and inertia, weight included.

    The usual model of parallel machines with light limbs. What acts on the limbs otherwise stays, and so do payloads.
    Kinetic and potential energy are those of the bodies that are left. With freedoms that move massless bodies only,
    forward dynamics has no answer (status 1).

        [[effects]]
        type = "massless_limbs"
        keep = ["slider"]
    """

    simplifies: ClassVar[str] = "massless limbs"

    keep: tuple[str, ...] = ()

    @property
    def depends_on(self) -> frozenset[str]:
        """The inertia: weights go with the masses."""
        return frozenset({"inertia"})

    def transform(self, mechanism: Mechanism) -> Mechanism:
        """The mechanism without the limbs' inertias."""
        kept = {*self.keep, *([mechanism.platform] if mechanism.platform else [])}
        if not kept:
            raise DescriptionError(
                "massless limbs: the mechanism names no platform; expected the key 'keep' with the bodies that keep "
                "their mass"
            )
        for name in kept:
            if name not in mechanism.bodies:
                raise DescriptionError(
                    f"massless limbs: expected a body, got {shorten(name)}; {did_you_mean(str(name), mechanism.bodies)}"
                )
        bodies = {name: body if name in kept else Body(name) for name, body in mechanism.bodies.items()}
        return replace(mechanism, bodies=bodies)
