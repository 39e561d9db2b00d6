"""Backlash of a drive: free play between the actuator and its joint."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.effects.acting import Acting
from symscrew.effects.contact_law import contact_law
from symscrew.effects.effect import Effect, Number
from symscrew.program import Port


@dataclass(frozen=True, repr=False)
class Backlash(Effect):
    """An actuator that moves by z and reaches its joint, which moves by s, only beyond a free play: e = z - s.

    `play` b [m or rad] above 0 is the whole way between the two flanks, at e = b/2 and e = -b/2. On the flank the
    joint is pushed and the actuator pushed back by the force of a two-sided contact (see
    `symscrew.effects.contact_law`; Hunt and Crossley) of the depth d = |e| - b/2:

        F = sign(e) k d^n max(0, 1 + h d_dot)  [N or N m],      e_dot = z_dot - s_dot,      m z_ddot = D - F

    `stiffness` k [N/m^n or N m/rad^n] above 0, `exponent` n 1 (default), 1.5 or 2, `damping` h [s/m or s/rad] at least
    0: between the flanks F = 0. `inertia` m [kg or kg m^2] above 0 is the actuator's, reflected to the joint, D the
    input `actuator_<name>` [N or N m]. States: e, at the start `initial` (0: midway), and z_dot, which starts at rest.
    It acts beside the ideal drive u of the joint. Stored: k d^(n+1)/(n+1), moving: m z_dot^2/2, fed beyond that:
    D z_dot - (F - k d^n sign(e)) e_dot [W], of which the contact takes the second part, never below 0.

        [[effects]]
        type = "backlash"
        joint = "A"
        play = 0.002
        stiffness = 2e4
        damping = 2
        inertia = 0.01
    """

    joint: str
    play: Number
    stiffness: Number
    inertia: Number
    exponent: Number = 1
    damping: Number = 0
    initial: Number = 0
    freedom: int | None = None
    name: str = ""

    def act(self, acting: Acting) -> None:
        """The force of both flanks, and the rates of the play and of the actuator."""
        what = f"backlash of joint {self.joint!r}"
        tape = acting.system.tape
        k = acting.freedom(self.joint, self.freedom, what)
        name = acting.label(self.name, self.joint, k, what)
        length, force_unit = ("m", "N") if acting.slides(self.joint, k) else ("rad", "N m")
        play = acting.number(self.play, f"{what}: play", above=0)
        inertia = acting.number(self.inertia, f"{what}: inertia", above=0)
        law = contact_law(acting, self.stiffness, self.exponent, self.damping, what=what)
        (pushed,) = acting.input(Port(f"actuator_{name}", (1,), (force_unit,), ("",), "force on the actuator"), "force")
        apart = acting.state(f"play_{name}", length, self.initial, f"place in the play of joint {self.joint}")
        moving = acting.state(f"actuator_{name}", f"{length}/s", 0.0, f"rate of the actuator of joint {self.joint}")
        opening = moving - acting.rate(self.joint, k)
        force = taken = tape.zero
        for sign in (1, -1):
            depth = sign * apart - acting.half * play
            flank, elastic, stored = law.at(tape, depth, sign * opening)
            force = force + sign * flank
            taken = taken + sign * (flank - elastic)
            acting.store(stored)
        acting.state_rate(f"play_{name}", opening)
        acting.state_rate(f"actuator_{name}", (pushed - force) * (1 / inertia))
        acting.drive(self.joint, k, force)
        acting.kinetic = acting.kinetic + acting.half * inertia * moving * moving
        acting.feed(f"backlash_{name}", pushed * moving - taken * opening)
