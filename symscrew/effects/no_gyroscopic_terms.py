"""Dynamics without gyroscopic terms."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from symscrew.effects.effect import Effect


@dataclass(frozen=True, repr=False)
class NoGyroscopicTerms(Effect):
    """A simplification: omega x J omega is left out of the moment about every body's centre of mass.

    Euler's equation becomes J alpha = sum of moments; forces m a_C stay, centripetal and Coriolis accelerations of the
    centres included. The couple that is left out does no work, omega . (omega x J omega) = 0, so energy stays in
    balance.

        [[effects]]
        type = "no_gyroscopic_terms"
    """

    simplifies: ClassVar[str] = "no gyroscopic terms"
    keeps_gyroscopic_moments: ClassVar[bool] = False

    @property
    def depends_on(self) -> frozenset[str]:
        """The inertia: a payload's gyroscopic moment is left out as well."""
        return frozenset({"inertia"})
