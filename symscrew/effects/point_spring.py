"""A spring and damper between two points."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import dot, scale
from symscrew.effects.acting import Acting, between
from symscrew.effects.effect import Effect, Number
from symscrew.effects.joint_spring import spring_law
from symscrew.errors import DescriptionError


@dataclass(frozen=True, repr=False)
class PointSpring(Effect):
    """A tension T = F0 + k x + k3 x^3 + c d_dot [N] along the line between two named points, d apart [m].

    x = d - `length` [m]. `stiffness` k [N/m], `damping` c [N s/m] and `length` at least 0; `preload` F0 [N] is the
    tension at x = 0; `cubic` k3 [N/m^3] of either sign; or `energy` E(x) [J] as a text with x instead of k, k3, F0.
    The points' bodies are pulled towards each other: T e on the first, -T e on the second, e from first to second.
    Stored: F0 x + k x^2/2 + k3 x^4/4, or E(x); dissipated: c d_dot^2 [W]. A point may be fixed to the ground.

    Warning: where the points meet (d = 0) the line has no direction and the status is 2, except with k alone:
    then the force is -k times the distance vector, without a root.

        [[effects]]
        type = "point_spring"
        start = "anchor"
        end = "tool"
        stiffness = 200
        length = 0.1
        damping = 3
    """

    start: str
    end: str
    stiffness: Number = 0
    length: Number = 0
    preload: Number = 0
    cubic: Number = 0
    damping: Number = 0
    energy: str = ""

    def act(self, acting: Acting) -> None:
        """Pull both bodies, store and dissipate."""
        system, tape = acting.system, acting.system.tape
        what = f"spring between {self.start} and {self.end}"
        first, second = acting.point(self.start, what), acting.point(self.end, what)
        if first == second or first.body == second.body:
            raise DescriptionError(f"{what}: expected points of two bodies, both are on {first.body!r}")
        length = acting.number(self.length, f"{what}: length", least=0)
        c = acting.number(self.damping, f"{what}: damping", least=0)
        away, speed = between(system, first, second)
        square = tape.node(dot(away, away))
        if length is tape.zero and c is tape.zero and not self.energy and self.preload == 0 and self.cubic == 0:
            k = acting.number(self.stiffness, f"{what}: stiffness", least=0)
            force = scale(k, away)
            acting.store(acting.half * k * square)
        else:
            distance = tape.sqrt(square)
            energy, slope = spring_law(acting, self, distance - length, what)
            direction = scale(1 / distance, away)
            rate = tape.node(dot(direction, speed))
            force = scale(slope + c * rate, direction)
            acting.store(energy)
            acting.feed(f"point_spring_{self.start}_{self.end}", -(c * rate * rate))
        acting.push(first, force)
        acting.push(second, scale(-1, force))
