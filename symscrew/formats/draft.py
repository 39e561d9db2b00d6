"""What a file of another format says, before it becomes a `Mechanism`: bodies, elementary joints, points.

    file --reader--> Draft --from_draft--> Mechanism

Everything is in absolute axes in the reference configuration, with 50 digits, under the file's own names.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from symscrew.formats.rigid_displacements import Pose, Real, Rotation, Triple

AXES = "lengths of axes, which are directions"
"""What of axes that are no unit vectors is passed over, as rounded ones are."""


@dataclass(frozen=True)
class RawBody:
    """A body: mass [kg], centre of mass [m] and inertia about it, or None for a body without mass.

    `axes`: the principal ones as columns, where the file gives them; `left_open`: by how much the file's
    digits leave its inertia open, a norm [kg m^2].
    """

    name: str
    mass: Real | None = None
    com: Triple | None = None
    inertia: Rotation | None = None
    axes: Rotation | None = None
    left_open: Real | None = None


@dataclass(frozen=True)
class RawJoint:
    """A joint of one of our types; `reference` are the coordinates' values in the reference configuration."""

    name: str
    type: str
    parent: str
    child: str
    point: Triple
    axes: tuple[Triple, ...] = ()
    pitch: Real | None = None
    driven: tuple[int, ...] = ()
    reference: tuple[Real, ...] = ()


@dataclass(frozen=True)
class RawCoupling:
    """A relation between joints with one coordinate each: joint -> coefficients of its powers, from the first on."""

    name: str
    terms: Mapping[str, tuple[Real, ...]]


@dataclass(frozen=True)
class RawEffect:
    """An effect on a joint of the file: the keys of its table besides the joint and its freedom.

    `tendon`: the one that it is along in the file, where that is over the joint, or a pulley's.
    """

    joint: str
    table: Mapping[str, Any]
    tendon: str | None = None


@dataclass(frozen=True)
class RawLoad:
    """A wrench at a named point: force [N] and moment [N m] in absolute axes, constant, or None: an input."""

    point: str
    wrench: tuple[Real, ...] | None = None


@dataclass(frozen=True)
class RawPicture:
    """A mesh that a body looks like: `read` gives its triangles (n, 3, 3) [m] in a frame with this pose."""

    body: str
    pose: Pose
    read: Callable[[], Any]


@dataclass
class Limits:
    """What a file says of the reach, speed and effort of a joint [rad or m, and per s; N m or N]; None: nothing.

    `push`: between which forces all drives of the joint stay, where the file gives both.
    """

    lower: Real | None = None
    upper: Real | None = None
    velocity: Real | None = None
    effort: Real | None = None
    push: tuple[Real, Real] | None = None


@dataclass
class Ledger:
    """What became of everything that a file says, by kind, with how often it occurs."""

    effects: dict[str, int] = field(default_factory=dict)
    harmless: dict[str, int] = field(default_factory=dict)
    influence: dict[str, int] = field(default_factory=dict)
    changed: list[str] = field(default_factory=list)

    def turned(self, what: str, count: int = 1) -> None:
        """Became an effect or a limit."""
        self.effects[what] = self.effects.get(what, 0) + count

    def passed(self, what: str, count: int = 1) -> None:
        """Left out, without influence on any number here."""
        self.harmless[what] = self.harmless.get(what, 0) + count

    def lost(self, what: str, count: int = 1) -> None:
        """Left out, although numbers depend on it."""
        self.influence[what] = self.influence.get(what, 0) + count


@dataclass
class Draft:
    """The contents of a file; a reader fills it from top to bottom.

    `ledger` says what became of what the file holds besides; `gravity` [m/s^2] is the file's own where it is not the
    usual one; `configurations`: coordinates by name, in the file's order; `starts`: the same by joint and coordinate,
    `start_rates`: rates that belong to them;
    `parts_of`: name of a joint that is part of another now -> that one and its freedom there (None: none of its own);
    `leads`: slide of a screw -> (pitch [m/rad], its and the hinge's coordinate in the reference configuration);
    `frames`: joints' own axes; `drags`: body -> what a medium does to it, as keys of a table;
    `cords`: springs over points, `tendons` those on other ways, and what pulls in either, as such tables;
    `notes` are for people, nothing depends on them.
    """

    name: str
    ground: str
    origin: str
    description: str = ""
    platform: str | None = None
    characteristic_length: Real | None = None
    bodies: list[RawBody] = field(default_factory=list)
    joints: list[RawJoint] = field(default_factory=list)
    points: list[tuple[str, str, Triple]] = field(default_factory=list)
    couplings: list[RawCoupling] = field(default_factory=list)
    effects: list[RawEffect] = field(default_factory=list)
    loads: list[RawLoad] = field(default_factory=list)
    drags: dict[str, Mapping[str, Any]] = field(default_factory=dict)
    cords: list[Mapping[str, Any]] = field(default_factory=list)
    tendons: list[Mapping[str, Any]] = field(default_factory=list)
    limits: dict[str, Limits] = field(default_factory=dict)
    ledger: Ledger = field(default_factory=Ledger)
    gravity: tuple[str, ...] | None = None
    configurations: dict[str, tuple[Real, ...]] = field(default_factory=dict)
    starts: dict[str, Mapping[tuple[str, str], Real]] = field(default_factory=dict)
    start_rates: dict[str, Mapping[tuple[str, str], Real]] = field(default_factory=dict)
    parts_of: dict[str, tuple[str, int | None]] = field(default_factory=dict)
    leads: dict[str, tuple[Real, Real, Real]] = field(default_factory=dict)
    frames: dict[str, Pose] = field(default_factory=dict)
    pictures: list[RawPicture] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
