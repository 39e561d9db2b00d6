"""What a file of another format says, before it becomes a `Mechanism`: bodies, elementary joints, points.

    file --reader--> Draft --from_draft--> Mechanism

Everything is in absolute axes in the reference configuration, with 50 digits, under the file's own names.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from symscrew.formats.rigid_displacements import Real, Rotation, Triple


@dataclass(frozen=True)
class RawBody:
    """A body: mass [kg], centre of mass [m] and inertia about it, or None for a body without mass."""

    name: str
    mass: Real | None = None
    com: Triple | None = None
    inertia: Rotation | None = None


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


@dataclass
class Draft:
    """The contents of a file; a reader fills it from top to bottom.

    `notes` say what the file holds that a mechanism does not: for people, nothing depends on them.
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
    notes: list[str] = field(default_factory=list)
