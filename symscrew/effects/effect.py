"""What an effect is: a frozen dataclass that says what it puts on a system, or leaves out of it.

    mechanism --transform--> mechanism --prepare, act--> Acting: what the dynamics read

An effect answers for itself. The dynamics ask what all effects of a scene add up to and which part of the inertial
forces they keep; they know none of them by its name.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any, ClassVar

from symscrew.description import Mechanism
from symscrew.effects.acting import Acting
from symscrew.effects.records import Contact, Passed
from symscrew.errors import DescriptionError, KindError, expect, shorten
from symscrew.kinematics import Rolling, System

Number = str | int | float | Decimal | Fraction  # texts are expressions of the mechanism's parameters
ALWAYS = {"always": True}  # metadata of a field that is shown even at its default


@dataclass(frozen=True, repr=False)
class Effect:
    """One effect of a scene: a frozen dataclass that says what it puts on a system, and what it leaves out.

    A simplification names itself in `simplifies` ("massless limbs"; empty: it leaves nothing out) and says which part
    of the inertial forces is not kept:

        keeps_motion               rates and accelerations of the mechanism enter them
        keeps_gyroscopic_moments   omega x J omega enters the moment about every centre of mass

    One that is only wanted where it saves operations gives in `undone` what takes its place elsewhere.
    """

    simplifies: ClassVar[str] = ""
    looks_back: ClassVar[bool] = False  # whether `seen` says anything of a motion
    keeps_motion: ClassVar[bool] = True
    keeps_gyroscopic_moments: ClassVar[bool] = True

    @property
    def depends_on(self) -> frozenset[str]:
        """Why the effect cannot simply be added to others; empty for a force screw of the state and of time.

        "reactions": its force depends on the joints' reactions; "drives": it changes what the drives do; "inertia":
        it changes masses, and with them what inertia and gravity do; "motion": it changes which accelerations count;
        "gravity": it turns the field.
        """
        return frozenset()

    @property
    def leaves_out(self) -> bool:
        """Whether it leaves anything out."""
        return bool(self.simplifies)

    def keeps_gyroscopic_moment(self, body: str) -> bool:
        """Whether omega x J omega enters the moment about the centre of mass of a body."""
        return self.keeps_gyroscopic_moments

    def undone(self) -> Effect | None:
        """The effect without what it leaves out, to be taken where leaving it out makes a function longer.

        None: what it leaves out is left out at any price.
        """
        return None

    @property
    def notes(self) -> tuple[str, ...]:
        """What a user of a model with this effect must know."""
        return ()

    @property
    def reads(self) -> tuple[str, ...]:
        """Joints whose displacement it asks for, which a loop is then not cut at if turns would be lost."""
        return ()

    @property
    def own_coordinates(self) -> tuple[str, ...]:
        """Joints that need coordinates of their own for it, which a loop is not cut at."""
        return ()

    def rolled(self, mechanism: Mechanism) -> tuple[Rolling, ...]:
        """Bodies that it lets roll on others without sliding: constraints of the rates."""
        return ()

    def seen(self, motion: Passed) -> str:
        """What a user must know of a motion that was computed with it: what it leaves out, where that counts; or ""."""
        return ""

    def __post_init__(self) -> None:
        """Exact numbers as texts and lists as tuples, so that an effect read back from a file is the same."""
        for f in dataclasses.fields(self):
            object.__setattr__(self, f.name, _storable(getattr(self, f.name)))

    def transform(self, mechanism: Mechanism) -> Mechanism:
        """The mechanism with other inertias; its joints and points stay."""
        return mechanism

    def prepare(self, acting: Acting) -> None:
        """Before anything acts: motion of the ground."""

    def act(self, acting: Acting) -> None:
        """Add force screws, joint forces, energy, inputs and states."""

    def conclude(self, acting: Acting) -> None:
        """After all effects have acted, when the acceleration of the ground is known."""

    def contacts(self) -> tuple[Contact, ...]:
        """Forces with events (stick and slip, impacts), which come in as inputs for a simulation to determine."""
        return ()

    def stops(self) -> tuple[tuple[str, int, Number | None, Number | None], ...]:
        """Reaches that it holds joints in: (joint, freedom, lower, upper), each end a displacement or None."""
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


def transformed(mechanism: Mechanism, effects: tuple[Effect, ...]) -> Mechanism:
    """The mechanism with the inertias that the effects make of it: simplifications first, then additions."""
    for effect in sorted(effects, key=lambda e: not e.simplifies):
        mechanism = effect.transform(mechanism)
    return mechanism


def given_effects(effects: Sequence[Effect]) -> tuple[Effect, ...]:
    """The effects that somebody gave, each looked at.

    Raises:
        KindError: one effect in place of a sequence, or what is none: a name, a class.
    """
    if isinstance(effects, str) or not isinstance(effects, Iterable):
        kind = type(effects).__name__
        raise KindError(f"expected a sequence of effects, (symscrew.Gravity(),), got {shorten(effects)} ({kind})")
    every = tuple(effects)
    for effect in every:
        expect(effect, Effect)
    return every


def system_under(mechanism: Mechanism, effects: tuple[Effect, ...]) -> System:
    """The system of a mechanism under effects: its inertias, the loops cut where none of them reads, what rolls.

    Raises:
        DescriptionError: two wheels of one name, or a constraint that does not fit.
    """
    rolled = [one for effect in effects for one in effect.rolled(mechanism)]
    twice = [one.name for k, one in enumerate(rolled) if one.name in [other.name for other in rolled[:k]]]
    if twice:
        raise DescriptionError(f"effects: two of them are called {twice[0]!r}; give one another name (key 'name')")
    met = [contact.joint for effect in effects for contact in effect.contacts()]
    own = [name for effect in effects for name in effect.own_coordinates]
    kept = tuple(dict.fromkeys([*met, *own]))
    loaded = transformed(mechanism, effects)
    return System(mechanism, loaded, read=joints_read(effects), rolled=rolled, kept=kept)


def joints_read(effects: tuple[Effect, ...]) -> tuple[str, ...]:
    """Joints whose displacements the effects ask for."""
    return tuple(dict.fromkeys(name for effect in effects for name in effect.reads))
