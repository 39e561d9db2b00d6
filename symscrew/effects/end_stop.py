"""End stops of a joint: one-sided, dissipative, never sticking."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import Node
from symscrew.effects.acting import Acting
from symscrew.effects.contact_law import ContactLaw, contact_law
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import Values
from symscrew.effects.records import Contact
from symscrew.errors import DescriptionError, shorten
from symscrew.program import Port


@dataclass(frozen=True, repr=False)
class EndStop(Effect):
    """A stop where a joint's displacement s [m or rad] leaves [`lower`, `upper`]; either may be absent.

    Compliant (the default), by Hunt and Crossley (ASME J. Appl. Mech. 42, 1975, 440-445): with the depth
    d = max(0, s - upper), and likewise at the other end,

        F = k d^n max(0, 1 + h d_dot)      [N or N m], against d

    `stiffness` k [N/m^n] above 0, `exponent` n 1, 1.5 (default) or 2, `damping` h [s/m or s/rad] at least 0.
    F >= 0: the stop never pulls, so nothing sticks; at d = 0 it starts from 0. Stored: k d^(n+1)/(n+1); what F
    differs from k d^n by takes (F - k d^n) d_dot >= 0 from the mechanism, so energy is never created.

    `mode` "impact": a rigid stop for simulation with events. The force is the input `stop_<name>` (> 0 pushes the
    joint upwards); `contacts` says its law: no penetration, no pulling, rate reversed by -`restitution` (0 to 1).

        [[effects]]
        type = "end_stop"
        joint = "leg1_P"
        lower = 0.2
        upper = 0.5
        stiffness = 1e6
        damping = 0.5
    """

    joint: str
    lower: Number | None = None
    upper: Number | None = None
    stiffness: Number | None = None
    exponent: Number = 1.5
    damping: Number = 0
    mode: str = "compliant"
    restitution: Number = 0
    freedom: int | None = None
    name: str = ""

    @property
    def label(self) -> str:
        """The name in inputs."""
        return self.name or (self.joint if self.freedom is None else f"{self.joint}_{self.freedom}")

    def contacts(self) -> tuple[Contact, ...]:
        """The rigid stop's law."""
        if self.mode != "impact":
            return ()
        return (
            Contact(
                "stop", f"stop_{self.label}", self.joint, self.freedom or 0, lower=self.lower, upper=self.upper,
                restitution=self.restitution,
            ),
        )  # fmt: skip

    def stops(self) -> tuple[tuple[str, int, Number | None, Number | None], ...]:
        """Its two ends."""
        return ((self.joint, self.freedom or 0, self.lower, self.upper),)

    @property
    def reads(self) -> tuple[str, ...]:
        """Its joint."""
        return (self.joint,)

    def act(self, acting: Acting) -> None:
        """The force of both ends, or the input of a rigid stop."""
        what = f"end stop of joint {self.joint!r}"
        k = acting.freedom(self.joint, self.freedom, what)
        if self.lower is None and self.upper is None:
            raise DescriptionError(f"{what}: expected 'lower', 'upper' or both, got none")
        acting.require(self._apart)
        if self.mode not in ("compliant", "impact"):
            raise DescriptionError(f"{what}: expected as mode 'compliant' or 'impact', got {shorten(self.mode)}")
        if self.mode == "impact":
            self._rigid(acting, k, what)
        else:
            self._compliant(acting, k, what)

    def _apart(self, at: Values) -> None:
        what = f"end stop of joint {self.joint!r}"
        if self.lower is None or self.upper is None:
            return
        ends = [at(v, f"{what}: {n}") for v, n in ((self.lower, "lower"), (self.upper, "upper"))]
        if not ends[0] < ends[1]:
            raise DescriptionError(f"{what}: expected lower < upper, got {ends[0]:g} and {ends[1]:g}")

    def _gives_back(self, at: Values) -> None:
        what = f"end stop of joint {self.joint!r}"
        if not 0 <= at(self.restitution, f"{what}: restitution") <= 1:
            raise DescriptionError(f"{what}: expected a restitution from 0 to 1, got {shorten(self.restitution)}")

    def _rigid(self, acting: Acting, k: int, what: str) -> None:
        acting.require(self._gives_back)
        unit = "N" if acting.slides(self.joint, k) else "N m"
        name = acting.label(self.label, self.joint, k, what)
        (force,) = acting.input(Port(f"stop_{name}", (1,), (unit,), ("",), "force of the stop"), "force")
        acting.drive(self.joint, k, force)
        acting.feed(f"end_stop_{name}", force * acting.rate(self.joint, k))

    def _compliant(self, acting: Acting, k: int, what: str) -> None:
        if self.stiffness is None:
            raise DescriptionError(f"{what}: a compliant stop needs the key 'stiffness'")
        law = contact_law(acting, self.stiffness, self.exponent, self.damping, what=what)
        place, rate = acting.displacement(self.joint, k, what), acting.rate(self.joint, k)
        for end, sign in ((self.lower, -1), (self.upper, 1)):
            if end is not None:
                depth = sign * (place - acting.number(end, f"{what}: limit"))
                self._side(acting, k, depth=depth, speed=sign * rate, sign=sign, law=law)

    def _side(self, acting: Acting, k: int, *, depth: Node, speed: Node, sign: int, law: ContactLaw) -> None:
        """One end: its force against the depth, what it stores and what it takes."""
        force, elastic, stored = law.at(acting.system.tape, depth, speed)
        acting.drive(self.joint, k, -sign * force)
        acting.store(stored)
        acting.feed(f"end_stop_{self.label}", (elastic - force) * speed)
