"""What the effects of a scene put on a mechanism: the ground's acceleration, wrenches on links, joint forces.

Effects write into an `Acting` through its methods, the dynamics read it. Wrenches are kept per link, in the
axes before the link's motion, at its origin: where the recursions take them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar, Protocol

from symscrew.closure import carry, drive_row
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.mechanism import Point
from symscrew.program import Port
from symscrew.screws import ZERO, Vector, add, cross, scale
from symscrew.system import System
from symscrew.tape import Node
from symscrew.tree import GROUND

Loads = dict[int, tuple[Vector, Vector]]


class Effect(Protocol):
    """One effect of a scene: a frozen dataclass that says what it puts on a system."""

    __dataclass_fields__: ClassVar[dict[str, Any]]

    def act(self, acting: Acting) -> None:
        """Add force screws, joint forces, potential energy and inputs."""


class Acting:
    """The sum of what all effects contribute to one system at its present nodes."""

    def __init__(self, system: System, effects: Sequence[Effect]) -> None:
        self.system = system
        self.ground_acceleration: Vector = ZERO
        self.loads: Loads = {}
        self.joint_forces: dict[int, Node] = {}  # index into v -> generalised force along that freedom
        self.inputs: list[tuple[Port, tuple[Node, ...]]] = []
        self.potential: Node = system.tape.zero
        for effect in effects:
            effect.act(self)

    def accelerate_ground(self, acceleration: Vector) -> None:
        """Add a uniform acceleration of the ground [m/s^2], absolute axes."""
        self.ground_acceleration = add(self.ground_acceleration, acceleration)

    def store(self, energy: Node) -> None:
        """Add potential energy [J]."""
        self.potential = self.potential + energy

    def input(self, port: Port, description: str) -> tuple[Node, ...]:
        """Symbols for a further input of all functions that depend on loads."""
        nodes = tuple(
            self.system.tape.symbol(f"{port.name}_{label}", unit, f"{description} {label}")
            for label, unit in zip(port.labels, port.units, strict=True)
        )
        self.inputs.append((port, nodes))
        return nodes

    def point(self, name: str, what: str) -> Point:
        """A named point of the mechanism; `what` says which effect asks."""
        points = self.system.mechanism.points
        if name not in points:
            raise DescriptionError(
                f"{what}: expected a named point of the mechanism, got {name!r}" + did_you_mean(name, points)
            )
        return points[name]

    def push(self, point: Point, force: Vector, moment: Vector = ZERO) -> None:
        """A force [N] at a point of a body and a moment [N m], absolute axes."""
        system = self.system
        link = system.tree.link_of_body[point.body]
        if link == GROUND:
            return
        f, m = (carry(system.tree, system.placed, GROUND, link, vector, before=True) for vector in (force, moment))
        arm = system.placed[link].before(system.local_point(link, system.geometry.vector(point.at)))
        self._load(link, f, add(m, cross(arm, f)))

    def drive(self, joint: str, freedom: int, force: Node) -> None:
        """A generalised force on a joint's freedom, like a drive: > 0 pushes the child along its screw."""
        system = self.system
        if joint in system.tree.joints:
            index = system.tree.velocity_indices(joint)[freedom]
            self.joint_forces[index] = self.joint_forces.get(index, system.tape.zero) + force
            return
        cut = next(c for c in system.cuts if c.joint.name == joint)
        row = drive_row(cut, freedom, system.tree, system.placed)
        factor = -force if cut.tip_is_parent else force
        f, couple = scale(factor, row.force), scale(factor, row.couple)
        placed = system.placed
        if cut.tip != GROUND:
            tip = placed[cut.tip]
            self._load(cut.tip, tip.before(f), tip.before(add(couple, cross(cut.tip_point, f))))
        if cut.hub != GROUND:
            f, couple = (
                scale(-1, carry(system.tree, placed, cut.tip, cut.hub, vector, before=True)) for vector in (f, couple)
            )
            arm = placed[cut.hub].before(cut.contact)
            self._load(cut.hub, f, add(couple, cross(arm, f)))

    def _load(self, link: int, force: Vector, moment: Vector) -> None:
        f, m = self.loads.get(link, (ZERO, ZERO))
        self.loads[link] = (add(f, force), add(m, moment))
