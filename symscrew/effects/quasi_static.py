"""The quasi-static approximation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from symscrew.effects.effect import Effect


@dataclass(frozen=True, repr=False)
class QuasiStatic(Effect):
    """A simplification: rates and accelerations of the mechanism do not enter the inertial forces.

    Drives and reactions then hold weights, springs, friction and loads in balance at every configuration; a moving
    base still loads the bodies. Reflected rotor inertias drop out too. There is no forward dynamics: without inertia
    the drives do not determine accelerations.

        [[effects]]
        type = "quasi_static"
    """

    simplifies: ClassVar[str] = "quasi-static"
    keeps_motion: ClassVar[bool] = False

    @property
    def depends_on(self) -> frozenset[str]:
        """The motion: what follows from accelerations is left out of every effect."""
        return frozenset({"motion"})
