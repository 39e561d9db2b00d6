"""Dry friction in a joint: Coulomb, Stribeck, load-dependent; smooth, or with events for stick and slip."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import dot
from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.effects.parts import Values
from symscrew.effects.records import Contact
from symscrew.errors import DescriptionError, shorten
from symscrew.program import Port


@dataclass(frozen=True, repr=False)
class DryFriction(Effect):
    """A force against the rate s_dot [m/s or rad/s] of a joint's freedom, of the level [N or N m]

        L(s_dot) = Fc + mu |f| + (Fs - Fc) / (1 + (s_dot/v_s)^2)

    `coulomb` Fc and `static` Fs >= Fc, `stribeck_velocity` v_s: the Stribeck curve in its rational form (Hess and
    Soom, ASME J. Tribology 112, 1990, 147-152). `load` mu makes it depend on the size |f| [N] of the joint's reaction
    force: a coefficient of friction for a slider, times the bearing's radius [m] for a joint that turns. All >= 0.

    `mode` "smooth": F = -L s_dot / sqrt(s_dot^2 + v0^2) with `velocity` v0 > 0, of full level well above v0, viscous
    with L/v0 below: it creeps, and does not stick. `mode` "event": the force is the input `friction_<name>` for a
    simulation with stick and slip; `contacts` says its law; `static` without `stribeck_velocity` then drops to Fc
    at once where it slips. Dissipates: power -|F s_dot| [W]; no energy.

    The reaction depends on the friction in turn. Both are computed in turn `passes` times, beginning with the reactions
    of the same state and accelerations (inverse dynamics) or drives (forward dynamics) without load-dependent
    friction: exact to order `passes` in mu, each pass at the cost of all reactions.

        [[effects]]
        type = "dry_friction"
        joint = "A"
        coulomb = 0.4
        static = 0.6
        stribeck_velocity = 0.05
        velocity = 0.001
    """

    joint: str
    coulomb: Number = 0
    static: Number | None = None
    stribeck_velocity: Number | None = None
    velocity: Number | None = None
    load: Number = 0
    passes: int = 1
    mode: str = "smooth"
    freedom: int | None = None
    name: str = ""

    @property
    def depends_on(self) -> frozenset[str]:
        """The reactions, where the level depends on the load."""
        return frozenset() if self.load == 0 else frozenset({"reactions"})

    @property
    def label(self) -> str:
        """The name in inputs."""
        return self.name or (self.joint if self.freedom is None else f"{self.joint}_{self.freedom}")

    def contacts(self) -> tuple[Contact, ...]:
        """The law of stick and slip."""
        if self.mode != "event":
            return ()
        port, freedom = f"friction_{self.label}", self.freedom or 0
        return (
            Contact(
                "friction", port, self.joint, freedom, self.coulomb, self.static, self.load,
                stribeck_velocity=self.stribeck_velocity,
            ),
        )  # fmt: skip

    def _falls(self, at: Values) -> None:
        what = f"dry friction in joint {self.joint!r}"
        if at(self.static, what) < at(self.coulomb, what):
            raise DescriptionError(f"{what}: expected static >= coulomb, got {self.static} and {self.coulomb}")

    def act(self, acting: Acting) -> None:
        """The force against the rate, or its input."""
        what = f"dry friction in joint {self.joint!r}"
        tape = acting.system.tape
        k = acting.freedom(self.joint, self.freedom, what)
        coulomb = acting.number(self.coulomb, f"{what}: coulomb", least=0)
        load = acting.number(self.load, f"{what}: load", least=0)
        if self.mode not in ("smooth", "event"):
            raise DescriptionError(f"{what}: expected as mode 'smooth' or 'event', got {shorten(self.mode)}")
        sudden = self.mode == "event" and self.stribeck_velocity is None
        if (self.static is None) != (self.stribeck_velocity is None) and not sudden:
            raise DescriptionError(f"{what}: expected both 'static' and 'stribeck_velocity', or none, got one")
        rate = acting.rate(self.joint, k)
        rise = wide = None
        if self.static is not None:
            rise = acting.number(self.static, f"{what}: static", least=0) - coulomb
            if not sudden:
                wide = acting.number(self.stribeck_velocity, f"{what}: stribeck_velocity", above=0)
            acting.require(self._falls)
        if self.mode == "event":
            unit = "N" if acting.slides(self.joint, k) else "N m"
            name = acting.label(self.label, self.joint, k, what)
            (force,) = acting.input(Port(f"friction_{name}", (1,), (unit,), ("",), "force of dry friction"), "force")
        else:
            if self.velocity is None:
                raise DescriptionError(f"{what}: smooth friction needs the key 'velocity', below which it fades")
            level = coulomb
            if rise is not None and wide is not None:
                slow = rate * (1 / wide)
                level = level + rise * (1 / (1 + slow * slow))
            if load is not tape.zero:
                passes = acting.fixed(self.passes, f"{what}: passes")
                if passes not in range(1, 9):
                    raise DescriptionError(f"{what}: expected 1 to 8 passes, got {shorten(self.passes)}")
                reaction = acting.reaction(self.joint, int(passes))
                if reaction is None:
                    return
                level = level + load * tape.sqrt(dot(reaction[0], reaction[0]))
            fade = acting.number(self.velocity, f"{what}: velocity", above=0)
            force = -(level * (rate * (1 / tape.sqrt(rate * rate + fade * fade))))
        acting.drive(self.joint, k, force)
        acting.feed(f"dry_friction_{self.label}", force * rate)
