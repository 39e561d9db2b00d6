"""A position servo: a drive that holds its joint at a commanded displacement."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import Node
from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import Values
from symscrew.errors import DescriptionError, shorten
from symscrew.program import Port


@dataclass(frozen=True, repr=False)
class PositionServo(Effect):
    """A force F = kp (s* - s) + kd (s*_dot - s_dot) [N or N m] along a joint's freedom, limited.

    The limits are +-`limit`, or `lowest` and `limit` where both are given. s, s_dot are the joint's displacement [m or
    rad] and rate; the target s* and its rate are the input `servo_<name>`. `stiffness` kp and `damping` kd at least 0.
    It acts beside the ideal drive u of the joint, so u = 0 leaves the joint to the servo, and inverse dynamics says
    what it lacks. Fed: F s_dot [W], from its supply. `name` is the joint's (with the freedom) unless given.

        [[effects]]
        type = "position_servo"
        joint = "A"
        stiffness = 400
        damping = 8
        limit = 30
    """

    joint: str
    stiffness: Number
    damping: Number = 0
    limit: Number | None = None
    freedom: int | None = None
    name: str = ""
    lowest: Number | None = None

    @property
    def reads(self) -> tuple[str, ...]:
        """Its joint."""
        return (self.joint,)

    def act(self, acting: Acting) -> None:
        """The servo's force on the freedom."""
        what = f"position servo of joint {self.joint!r}"
        tape = acting.system.tape
        k = acting.freedom(self.joint, self.freedom, what)
        stiffness = acting.number(self.stiffness, f"{what}: stiffness", least=0)
        damping = acting.number(self.damping, f"{what}: damping", least=0)
        unit = "m" if acting.slides(self.joint, k) else "rad"
        name = acting.label(self.name, self.joint, k, what)
        port = Port(f"servo_{name}", (2,), (unit, f"{unit}/s"), ("target", "rate"), "target of the servo and its rate")
        target, target_rate = acting.input(port, "servo's")
        rate = acting.rate(self.joint, k)
        force = stiffness * (target - acting.displacement(self.joint, k, what)) + damping * (target_rate - rate)
        if self.limit is not None:
            limit, lowest = self._ends(acting, what)
            force = tape.function("select", tape.function("less", limit, force), limit, force)
            force = tape.function("select", tape.function("less", force, lowest), lowest, force)
        elif self.lowest is not None:
            raise DescriptionError(f"{what}: expected the key 'limit' beside 'lowest'")
        acting.drive(self.joint, k, force)
        acting.feed(f"position_servo_{name}", force * rate)

    def _ends(self, acting: Acting, what: str) -> tuple[Node, Node]:
        """The greatest and the least force."""
        if self.lowest is None:
            limit = acting.number(self.limit, f"{what}: limit", above=0)
            return limit, -limit

        def apart(at: Values) -> None:
            low, high = at(self.lowest, f"{what}: lowest"), at(self.limit, f"{what}: limit")
            if not high > low:
                raise DescriptionError(f"{what}: limit: expected a number above {low:g}, got {shorten(self.limit)}")

        acting.require(apart)
        return acting.number(self.limit, f"{what}: limit"), acting.number(self.lowest, f"{what}: lowest")
