"""Viscous friction in a joint."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.errors import DescriptionError


@dataclass(frozen=True, repr=False)
class ViscousFriction(Effect):
    """A force -c s_dot [N or N m] along a joint's freedom, with the joint's rate s_dot [m/s or rad/s].

    `coefficient` c [N s/m or N m s/rad], at least 0. Without `freedom` it acts on all freedoms of the joint, which
    must be alike then; in a spherical joint the moment is -c omega. Dissipates: power -c s_dot^2 <= 0 [W]; no energy.
    On a driven joint of the tree it costs two operations of inverse dynamics.

        [[effects]]
        type = "viscous_friction"
        joint = "A"
        coefficient = 0.2
    """

    joint: str
    coefficient: Number
    freedom: int | None = None

    def act(self, acting: Acting) -> None:
        """A force against the rate on every freedom that is meant."""
        what = f"viscous friction in joint {self.joint!r}"
        freedoms = acting.freedoms(self.joint, self.freedom, what)
        free = acting.joint(self.joint, what).kind.unconstrained
        if not free and len({acting.slides(self.joint, k) for k in freedoms}) > 1:
            raise DescriptionError(
                f"{what}: the joint slides and turns, with coefficients of different units; expected the key 'freedom'"
            )
        c = acting.number(self.coefficient, f"{what}: coefficient", least=0)
        for k in freedoms:
            rate = acting.rate(self.joint, k)
            force = -(c * rate)
            acting.drive(self.joint, k, force)
            acting.feed(f"viscous_friction_{self.joint}", force * rate)
