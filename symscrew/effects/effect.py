"""What an effect is, and the small records that effects hand on: states, contacts, transmissions."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar

from symscrew.mechanism import Mechanism
from symscrew.tape import Node

if TYPE_CHECKING:
    from symscrew.effects.acting import Acting

Number = str | int | float | Decimal | Fraction  # texts are expressions of the mechanism's parameters
ALWAYS = {"always": True}  # metadata of a field that is shown even at its default


@dataclass(frozen=True, repr=False)
class Effect:
    """One effect of a scene: a frozen dataclass that says what it puts on a system.

    `depends_on` says why the effect cannot simply be added to others: "reactions" (its force depends on the
    joints' reactions), "drives" (it changes what the drives do), "inertia" (it changes masses, and with them what
    inertia and gravity do), "motion" (it changes which accelerations count), "gravity" (it turns the field);
    empty for a force screw of the state and of time, which adds up. A simplification says so in `simplifies`.
    """

    depends_on: ClassVar[frozenset[str]] = frozenset()
    simplifies: ClassVar[bool] = False

    def __post_init__(self) -> None:
        """Exact numbers as texts and lists as tuples, so that an effect read back from a file is the same."""
        for f in dataclasses.fields(self):
            object.__setattr__(self, f.name, _storable(getattr(self, f.name)))

    def transform(self, mechanism: Mechanism) -> Mechanism:
        """The mechanism with other inertias; its joints and points stay."""
        return mechanism

    def prepare(self, acting: Acting) -> None:
        """Before anything acts: simplifications, motion of the ground."""

    def act(self, acting: Acting) -> None:
        """Add force screws, joint forces, energy, inputs and states."""

    def contacts(self) -> tuple[Contact, ...]:
        """Forces with events (stick and slip, impacts), which come in as inputs for a simulation to determine."""
        return ()

    def shown_fields(self) -> dict[str, Any]:
        """Fields that are required or differ from their default, by name."""
        return {
            f.name: getattr(self, f.name)
            for f in dataclasses.fields(self)
            if f.default is dataclasses.MISSING or f.metadata.get("always") or getattr(self, f.name) != f.default
        }

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in self.shown_fields().items())})"


def _storable(value: Any) -> Any:
    if isinstance(value, list | tuple):
        return tuple(_storable(v) for v in value)
    return str(value) if isinstance(value, Decimal | Fraction) else value


@dataclass(frozen=True)
class State:
    """A state of an effect: name, unit, value at the start, and its symbol."""

    name: str
    unit: str
    initial: float
    node: Node


@dataclass(frozen=True)
class Contact:
    """A force with events: the input port that carries it, and the law that it must obey.

    `kind` "friction": |force| <= static + load |f| at rate 0 (coulomb where static is None), with the size |f| of the
    joint's reaction force; force = -L sign(rate) otherwise, L = coulomb + load |f|, and where there is a static
    level (static - coulomb) / (1 + (rate/stribeck_velocity)^2) more.
    `kind` "stop": lower <= displacement <= upper, force only inwards, rate reversed by -restitution on impact.
    Values are numbers or texts with expressions of the mechanism's parameters, as in the scene.
    """

    kind: str
    port: str
    joint: str
    freedom: int
    coulomb: Any = 0
    static: Any = None
    load: Any = 0
    stribeck_velocity: Any = None
    lower: Any = None
    upper: Any = None
    restitution: Any = 0


@dataclass(frozen=True)
class Transmission:
    """What stands between an entry of u and the force on its joint: both directions, and the unit of u.

    `rate` is the motor's rate, so that command * rate is the motor's power.
    """

    force: Callable[[Node], Node]
    command: Callable[[Node], Node]
    unit: str
    rate: Node


def transformed(mechanism: Mechanism, effects: tuple[Effect, ...]) -> Mechanism:
    """The mechanism with the inertias that the effects make of it: simplifications first, then additions."""
    for effect in sorted(effects, key=lambda e: not e.simplifies):
        mechanism = effect.transform(mechanism)
    return mechanism
