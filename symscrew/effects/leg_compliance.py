"""An elastic prismatic leg with structural damping, between its actuator and its joint."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.errors import DescriptionError
from symscrew.program import Port


@dataclass(frozen=True, repr=False)
class LegCompliance(Effect):
    """A prismatic leg that gives way by e [m] between its actuator (extended by z = s + e) and its joint (by s).

    States: e and z_dot. The actuator, with the mass m that its rotor and moving parts amount to along the leg, is
    pushed by the input `actuator_<name>` D [N], and the leg's force F on the joint pushes it back:

        F = k e + c (z_dot - s_dot),      e_dot = z_dot - s_dot,      m z_ddot = D - F

    `stiffness` k [N/m] and `mass` m [kg] above 0. Structural damping with the loss factor `loss` eta: its equivalent
    viscous coefficient at the leg's own resonance omega = sqrt(k/m), c = eta k/omega = eta sqrt(k m)
    (Craig and Kurdila, Fundamentals of Structural Dynamics, 2006, sec. 4.6). It acts beside the ideal drive u of
    the joint. Stored: k e^2/2, moving: m z_dot^2/2, fed beyond that: D z_dot - c e_dot^2 [W].

        [[effects]]
        type = "leg_compliance"
        joint = "leg1_P"
        stiffness = 2e6
        mass = 4
        loss = 0.02
    """

    joint: str
    stiffness: Number
    mass: Number
    loss: Number = 0
    freedom: int | None = None
    name: str = ""

    def act(self, acting: Acting) -> None:
        """The leg's force on its joint and the rates of deflection and actuator."""
        what = f"compliance of leg {self.joint!r}"
        tape = acting.system.tape
        k = acting.freedom(self.joint, self.freedom, what)
        if not acting.slides(self.joint, k):
            raise DescriptionError(f"{what}: expected a freedom that slides (the leg's prismatic joint)")
        name = acting.label(self.name, self.joint, k, what)
        stiffness = acting.number(self.stiffness, f"{what}: stiffness", above=0)
        mass = acting.number(self.mass, f"{what}: mass", above=0)
        c = acting.number(self.loss, f"{what}: loss", least=0) * tape.sqrt(stiffness * mass)
        (pushed,) = acting.input(Port(f"actuator_{name}", (1,), ("N",), ("",), "force on the actuator"), "force")
        give = acting.state(f"give_{name}", "m", 0.0, f"elastic deflection of leg {self.joint}")
        moving = acting.state(f"actuator_{name}", "m/s", 0.0, f"rate of the actuator of leg {self.joint}")
        opening = moving - acting.rate(self.joint, k)
        force = stiffness * give + c * opening
        acting.state_rate(f"give_{name}", opening)
        acting.state_rate(f"actuator_{name}", (pushed - force) * (1 / mass))
        acting.drive(self.joint, k, force)
        acting.store(acting.half * stiffness * give * give)
        acting.kinetic = acting.kinetic + acting.half * mass * moving * moving
        acting.feed(f"leg_compliance_{name}", pushed * moving - c * opening * opening)
