"""The quasi-static approximation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from symscrew.effects.acting import Acting
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

    depends_on: ClassVar[frozenset[str]] = frozenset({"motion"})
    simplifies: ClassVar[bool] = True

    def prepare(self, acting: Acting) -> None:
        """Declare it."""
        acting.simplifications.add("quasi_static")
