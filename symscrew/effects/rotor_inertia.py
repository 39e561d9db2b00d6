"""The inertia of a drive's rotor, reflected to its joint."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.errors import DescriptionError


@dataclass(frozen=True, repr=False)
class RotorInertia(Effect):
    """A force -J N^2 s_ddot [N or N m] along a joint's freedom: the rotor turns at N times the joint's rate.

    `inertia` J [kg m^2], at least 0, `ratio` N (rotor's angle per joint displacement: without unit for a joint that
    turns, [rad/m] for one that slides, "2*pi/lead"; default 1, for an inertia that is reflected already). From the
    rotor's momentum J N s_dot about its own axis and the power of the gear; what the rotor's axis does besides
    turning with its joint's parent is left out (its mass belongs to the parent's). Kinetic energy J N^2 s_dot^2/2.
    No loop is cut at its joint: another joint of the loop is. In a spherical joint it is the same about every
    axis, a force -J N^2 omega_dot (what MuJoCo calls armature of a ball); in a free joint as well, with the same number
    in kg along every axis.

        [[effects]]
        type = "rotor_inertia"
        joint = "leg1_P"
        inertia = 2e-5
        ratio = "2*pi/0.005"
    """

    joint: str
    inertia: Number
    ratio: Number = 1
    freedom: int | None = None

    @property
    def own_coordinates(self) -> tuple[str, ...]:
        """Its joint: the rotor adds to the inertia of a coordinate."""
        return (self.joint,)

    def act(self, acting: Acting) -> None:
        """An inertia that moves with one freedom."""
        what = f"rotor inertia of joint {self.joint!r}"
        kind = acting.joint(self.joint, what).kind
        whole = (kind.ball or kind.unconstrained) and self.freedom is None
        freedoms = range(kind.freedom) if whole else [acting.freedom(self.joint, self.freedom, what)]
        if not whole and kind.freedoms[freedoms[0]].spherical:
            raise DescriptionError(f"{what}: expected a freedom with an axis of its own, got one of a spherical joint")
        inertia = acting.number(self.inertia, f"{what}: inertia", least=0)
        ratio = acting.number(self.ratio, f"{what}: ratio")
        for k in freedoms:
            acting.reflect(self.joint, k, acting.system.tape.settle(inertia * ratio * ratio), what)
