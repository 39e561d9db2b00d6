"""A spring and damper between two points, along a line or over further points."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from symscrew.algebra import Node, Vector, dot, scale, subtract
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

    `through` names points over which it is led without friction, in their order, as a cord over pins: d is the length
    of all parts, T the same in each. `shortest` [m] is below `length` where there is slack: x = 0 from there to
    `length`, and below d - `shortest`; a cord that only pulls has 0.

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
    through: tuple[str, ...] = ()
    shortest: Number | None = None

    def act(self, acting: Acting) -> None:
        """Pull the bodies, store and dissipate."""
        system, tape = acting.system, acting.system.tape
        what = f"spring between {self.start} and {self.end}"
        points = [acting.point(name, what) for name in (self.start, *self.through, self.end)]
        if len({point.body for point in points}) == 1:
            raise DescriptionError(f"{what}: expected points of two bodies, all are on {points[0].body!r}")
        length = acting.number(self.length, f"{what}: length", least=0)
        c = acting.number(self.damping, f"{what}: damping", least=0)
        parts = [between(system, a, b) for a, b in pairwise(points)]
        plain = not self.energy and self.preload == 0 and self.cubic == 0 and self.shortest is None
        if length is tape.zero and c is tape.zero and plain and len(parts) == 1:
            ((away, _),) = parts
            k = acting.number(self.stiffness, f"{what}: stiffness", least=0)
            pulls = [scale(k, away)]
            acting.store(acting.half * k * tape.node(dot(away, away)))
        else:
            sizes = [tape.sqrt(tape.node(dot(away, away))) for away, _ in parts]
            directions = [scale(1 / size, away) for size, (away, _) in zip(sizes, parts, strict=True)]
            rates = [tape.node(dot(e, speed)) for e, (_, speed) in zip(directions, parts, strict=True)]
            distance, rate = sum(sizes[1:], start=sizes[0]), sum(rates[1:], start=rates[0])
            energy, slope = spring_law(acting, self, self._deflection(acting, distance, length, what), what)
            acting.store(energy)
            acting.feed(f"point_spring_{self.start}_{self.end}", -(c * rate * rate))
            pulls = [scale(slope + c * rate, e) for e in directions]
        for n, point in enumerate(points):
            forces: list[Vector] = pulls[n : n + 1]
            if n:
                back: Vector = pulls[n - 1]
                forces = [subtract(forces[0], back)] if forces else [scale(-1, back)]
            acting.push(point, forces[0])

    def _deflection(self, acting: Acting, distance: Node, length: Node, what: str) -> Node:
        """x, which is zero within the slack."""
        if self.shortest is None:
            return distance - length
        tape = acting.system.tape
        least = acting.number(self.shortest, f"{what}: shortest", least=0)
        below = tape.function("select", tape.function("less", distance, least), distance - least, tape.zero)
        return tape.function("select", tape.function("less", length, distance), distance - length, below)
