"""A spring, with a damper where it has one, in a joint."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from symscrew.algebra import Node
from symscrew.description import parse
from symscrew.effects.acting import Acting
from symscrew.effects.ball_turns import ball_turn
from symscrew.effects.effect import Effect, Number
from symscrew.errors import DescriptionError

DEFLECTION = sympy.Symbol("x", real=True)


@dataclass(frozen=True, repr=False)
class JointSpring(Effect):
    """A force -(F0 + k x + k3 x^3) - c s_dot [N or N m] along a joint's freedom, x = s - `rest` [m or rad].

    s is the joint's displacement, s_dot its rate. `stiffness` k [N/m or N m/rad] and `damping` c at least 0;
    `preload` F0 [N or N m] pulls s downwards where x = 0; `cubic` k3 of either sign, softening if negative.
    For any other law, `energy` E(x) [J] is a text with x and the parameters instead of k, k3 and F0; the force is
    -dE/dx, so that the spring stores what it takes. Stored: F0 x + k x^2/2 + k3 x^4/4, or E(x); the damper
    dissipates c s_dot^2 [W]. In a spherical joint only k and c act, on the rotation vector and omega. The vector goes
    on over whole turns, for which its three components are states (`turn_<joint>_x` ..., rad), at the start the
    shortest one; with `nearest` it is the shortest one always, without states: beyond half a turn the spring then pulls
    on the other way round.

        [[effects]]
        type = "joint_spring"
        joint = "A"
        stiffness = 50
        preload = 2
        rest = "pi/6"
    """

    joint: str
    stiffness: Number = 0
    rest: Number = 0
    preload: Number = 0
    cubic: Number = 0
    damping: Number = 0
    energy: str = ""
    freedom: int | None = None
    nearest: bool = False

    @property
    def reads(self) -> tuple[str, ...]:
        """Its joint."""
        return (self.joint,)

    def act(self, acting: Acting) -> None:
        """The force on the freedom, what the spring stores and what the damper takes."""
        what = f"spring in joint {self.joint!r}"
        joint = acting.joint(self.joint, what)
        c = acting.number(self.damping, f"{what}: damping", least=0)
        if joint.kind.ball and self.freedom is None:
            self._spherical(acting, what, c)
            return
        if self.nearest:
            raise DescriptionError(f"{what}: 'nearest' is of ball joints' rotation vectors; this joint has its turns")
        k = acting.freedom(self.joint, self.freedom, what)
        x = acting.displacement(self.joint, k, what) - acting.number(self.rest, f"{what}: rest")
        law = spring_law(acting, self, x, what)
        rate = acting.rate(self.joint, k)
        acting.drive(self.joint, k, -law[1] - c * rate)
        acting.store(law[0])
        acting.feed(f"joint_spring_{self.joint}", -(c * rate * rate))

    def _spherical(self, acting: Acting, what: str, c: Node) -> None:
        if any(value != 0 for value in (self.rest, self.preload, self.cubic)) or self.energy:
            raise DescriptionError(f"{what}: a spherical joint takes only stiffness and damping")
        stiffness = acting.number(self.stiffness, f"{what}: stiffness", least=0)
        joint = acting.joint(self.joint, what)
        angles = acting.displacements(joint) if self.nearest else ball_turn(acting, joint)
        for k, angle in enumerate(angles):
            rate = acting.rate(self.joint, k)
            acting.drive(self.joint, k, -(stiffness * angle) - c * rate)
            acting.store(acting.half * stiffness * angle * angle)
            acting.feed(f"joint_spring_{self.joint}", -(c * rate * rate))


def spring_law(acting: Acting, spring: object, x: Node, what: str) -> tuple[Node, Node]:
    """Energy [J] and its derivative by the deflection x, from the fields of a spring."""
    text = spring.energy  # type: ignore[attr-defined]
    k, f0, k3 = spring.stiffness, spring.preload, spring.cubic  # type: ignore[attr-defined]
    if text:
        if any(value != 0 for value in (k, f0, k3)):
            raise DescriptionError(f"{what}: expected either 'energy' or stiffness, preload and cubic, got both")
        names = {name: p.symbol for name, p in acting.system.mechanism.parameters.items()}
        energy = parse(text, {**names, "x": DEFLECTION}, where=f"{what}: energy")
        slope = sympy.diff(energy, DEFLECTION)
        return acting.of(energy, {DEFLECTION: x}, what), acting.of(slope, {DEFLECTION: x}, what)
    stiffness = acting.number(k, f"{what}: stiffness", least=0)
    preload, cubic = acting.number(f0, f"{what}: preload"), acting.number(k3, f"{what}: cubic")
    square = x * x
    quarter = acting.half * acting.half
    energy = preload * x + acting.half * stiffness * square + quarter * cubic * square * square
    return energy, preload + x * (stiffness + cubic * square)
