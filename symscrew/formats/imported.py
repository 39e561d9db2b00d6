"""What an import gives: the mechanism, effects, limits and configurations beside it, and what became of everything.

taken over | turned into effects and limits | left out without influence | left out with influence
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from symscrew.description import Mechanism


@dataclass(frozen=True)
class JointLimits:
    """Reach [rad or m], greatest rate [per s] and effort [N m or N] of a joint; None where the file gives none."""

    lower: float | None = None
    upper: float | None = None
    velocity: float | None = None
    effort: float | None = None


@dataclass(frozen=True)
class Beside:
    """What is written to a file beside its mechanism: forces as in `Imported`, limits, gravity [m/s^2].

    `others` are effects that no file names, in words; what a file does not hold is left out where `accept` says so.
    """

    forces: tuple[Mapping[str, Any], ...] = ()
    limits: Mapping[str, JointLimits] = field(default_factory=dict)
    gravity: tuple[float, ...] | None = None
    others: tuple[str, ...] = ()
    accept: bool = False


@dataclass(frozen=True)
class Account:
    """What became of what a file says, how often it occurs; `changed`: numbers that are not the file's, in words.

    `rods`: bodies between two balls that could be bars, whose spins `ImportOptions.bars` leaves out.
    """

    taken: Mapping[str, int]
    effects: Mapping[str, int]
    harmless: Mapping[str, int]
    influence: Mapping[str, int]
    changed: tuple[str, ...] = ()
    rods: tuple[str, ...] = ()

    def lines(self) -> list[str]:
        """The table, a line a kind; kinds that do not occur are left out."""
        kinds = (
            ("taken over", self.taken),
            ("turned into effects and limits", self.effects),
            ("left out, without influence", self.harmless),
            ("left out, WITH influence on numbers", self.influence),
        )
        lines = [f"{what}: {_counted(counts)}" for what, counts in kinds if counts]
        return lines + [f"changed: {text}" for text in self.changed]


@dataclass(frozen=True)
class Imported:
    """A file as it was read.

    Attributes:
        mechanism: bodies, joints, couplings.
        forces: what the file says of forces: kind (armature, damping, friction, spring, servo), the joint, the freedom
            of a joint with several, and its numbers; kind load, the point, and the wrench where it is no input; kind
            drag, the body, and its numbers; kind cord, the points that it is over, and its numbers; kinds tendon and
            muscle, a name, the path, and its numbers. See
            `symscrew.effects.effects_of_file`.
        limits: joint -> its limits.
        configurations: name -> coordinates in the file's own order.
        account: what became of everything.
        gravity: the file's own [m/s^2]; None where it is the usual one.
        starts: name -> values of coordinates by their labels, as scenes take them.
        start_rates: name -> rates that are not zero, by the labels of rates.
    """

    mechanism: Mechanism
    forces: tuple[Mapping[str, Any], ...] = ()
    limits: Mapping[str, JointLimits] = field(default_factory=dict)
    configurations: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    account: Account = field(default_factory=lambda: Account({}, {}, {}, {}))
    gravity: tuple[float, ...] | None = None
    starts: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    start_rates: Mapping[str, Mapping[str, float]] = field(default_factory=dict)

    def acting(self) -> str:
        """What of it acts beside the usual gravity, by kinds with how often; empty where nothing does."""
        counts = Counter(str(force["kind"]) for force in self.forces)
        field = [] if self.gravity is None else [f"gravity {' '.join(f'{c:g}' for c in self.gravity)}"]
        return ", ".join([*field, *([_counted(counts)] if counts else [])])


def _counted(counts: Mapping[str, int]) -> str:
    return ", ".join(f"{what} ({count})" if count > 1 else what for what, count in counts.items())
