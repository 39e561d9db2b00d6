"""A screw between a motor and a sliding drive, with lead and efficiency."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import Node
from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import Values
from symscrew.effects.records import Transmission
from symscrew.errors import DescriptionError


@dataclass(frozen=True, repr=False)
class ScrewTransmission(Effect):
    """The drive of a sliding freedom is a motor's torque tau [N m] through a screw; it replaces the entry of u.

    `lead` p [m per turn]: the motor turns by 2 pi s/p, and without loss F = 2 pi tau/p [N]. `efficiency` eta while the
    motor drives (F s_dot > 0), `back_efficiency` eta_b while the load does (default: eta), both in (0, 1]:

        tau = p/(2 pi) (m F + n |F| sigma),    m = (1/eta + eta_b)/2,    n = (1/eta - eta_b)/2,
        F = 2 pi/p tau / (m + n sign(tau) sigma),    sigma = s_dot / sqrt(s_dot^2 + v0^2)

    so that tau = F p/(2 pi eta) when driving and F p eta_b/(2 pi) when driven, with a transition of width `velocity`
    v0 [m/s] (needed unless eta = eta_b = 1). Both directions are exact inverses of each other. A lead may be negative
    (left-hand thread). Dissipates n |F s_dot| + ... = tau phi_dot - F s_dot >= 0 well above v0; no energy.
    A self-locking screw (eta_b <= 0) holds any load and is not in this model.

        [[effects]]
        type = "screw_transmission"
        joint = "leg1_P"
        lead = 0.005
        efficiency = 0.9
        velocity = 1e-4
    """

    joint: str
    lead: Number
    efficiency: Number = 1
    back_efficiency: Number | None = None
    velocity: Number | None = None
    freedom: int | None = None

    @property
    def depends_on(self) -> frozenset[str]:
        """The drives: u is the motor's torque."""
        return frozenset({"drives"})

    def act(self, acting: Acting) -> None:
        """Put the screw between the entry of u and the force on the joint."""
        what = f"screw transmission of joint {self.joint!r}"
        tape = acting.system.tape
        k = acting.freedom(self.joint, self.freedom, what)
        if not acting.slides(self.joint, k):
            raise DescriptionError(f"{what}: expected a freedom that slides")
        back = self.efficiency if self.back_efficiency is None else self.back_efficiency
        given = {"efficiency": self.efficiency, "back_efficiency": back}

        def possible(at: Values) -> None:
            if at(self.lead, f"{what}: lead") == 0:
                raise DescriptionError(f"{what}: expected a lead other than 0 m per turn")
            for key, value in given.items():
                if not 0 < at(value, f"{what}: {key}") <= 1:
                    raise DescriptionError(f"{what}: expected as {key} a number above 0 and at most 1, got {value!r}")

        acting.require(possible)
        turns = 2 * acting.number("pi", what) * (1 / acting.number(self.lead, f"{what}: lead"))
        forth, back_node = (acting.number(v, f"{what}: {key}", above=0) for key, v in given.items())
        mean, lost = acting.half * (1 / forth + back_node), acting.half * (1 / forth - back_node)
        rate = acting.rate(self.joint, k)
        if lost is tape.zero and mean is tape.one:
            acting.transmit(
                self.joint, k, Transmission(lambda u: turns * u, lambda f: f * (1 / turns), "N m", turns * rate), what
            )
            return
        if self.velocity is None:
            raise DescriptionError(f"{what}: an efficiency below 1 needs the key 'velocity', the transition's width")
        wide = acting.number(self.velocity, f"{what}: velocity", above=0)
        sigma = rate * (1 / tape.sqrt(rate * rate + wide * wide))

        def force(torque: Node) -> Node:
            ideal = turns * torque
            share = lost * sigma
            negative = tape.function("less", ideal, 0)
            return ideal / (mean + tape.function("select", negative, -share, share))

        def command(f: Node) -> Node:
            return (mean * f + lost * (tape.function("abs", f) * sigma)) * (1 / turns)

        acting.transmit(self.joint, k, Transmission(force, command, "N m", turns * rate), what)
