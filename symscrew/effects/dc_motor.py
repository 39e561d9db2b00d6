"""A direct-current motor with the current as a state."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.program import Port


@dataclass(frozen=True, repr=False)
class DcMotor(Effect):
    """A force k N i [N or N m] along a joint's freedom from the current i [A], a state of its own:

        L di/dt = U - R i - k N s_dot

    with the voltage U [V] as input `voltage_<name>`. `torque_constant` k [N m/A = V s/rad], `resistance` R [ohm] and
    `inductance` L [H] above 0, `ratio` N (rotor's angle per joint displacement, "2*pi/lead" for a screw). It acts
    beside the ideal drive u of the joint. Stored: L i^2/2; fed beyond that: U i - R i^2 [W], the supply less the
    heat. Its rotor is an effect of its own (rotor_inertia). `name` is the joint's unless given.

        [[effects]]
        type = "dc_motor"
        joint = "A"
        torque_constant = 0.05
        resistance = 1.2
        inductance = 0.0008
        ratio = 50
    """

    joint: str
    torque_constant: Number
    resistance: Number
    inductance: Number
    ratio: Number = 1
    current: Number = 0
    freedom: int | None = None
    name: str = ""

    def act(self, acting: Acting) -> None:
        """The motor's force, the rate of the current, energies."""
        what = f"DC motor of joint {self.joint!r}"
        k = acting.freedom(self.joint, self.freedom, what)
        name = acting.label(self.name, self.joint, k, what)
        constant = acting.number(self.torque_constant, f"{what}: torque_constant", above=0)
        resistance = acting.number(self.resistance, f"{what}: resistance", above=0)
        inductance = acting.number(self.inductance, f"{what}: inductance", above=0)
        ratio = acting.number(self.ratio, f"{what}: ratio")
        (voltage,) = acting.input(Port(f"voltage_{name}", (1,), ("V",), ("",), "voltage at the motor"), "voltage")
        current = acting.state(f"current_{name}", "A", self.current, f"current of the motor of {self.joint}")
        coupling = constant * ratio
        rate = acting.rate(self.joint, k)
        acting.state_rate(f"current_{name}", (voltage - resistance * current - coupling * rate) * (1 / inductance))
        acting.drive(self.joint, k, coupling * current)
        acting.store(acting.half * inductance * current * current)
        acting.feed(f"dc_motor_{name}", current * (voltage - resistance * current))
