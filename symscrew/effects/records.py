"""The small records that effects hand on: states of their own, contacts with events, transmissions of drives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy

from symscrew.algebra import Node, Vector, add, cross, dot, scale, transform
from symscrew.description import Mechanism
from symscrew.kinematics import Inertia, Rates


@dataclass(frozen=True)
class State:
    """A state of an effect: name, unit, value at the start, and its symbol.

    `initial` is that value where the parameters have those of the description, `start` its expression in them.
    """

    name: str
    unit: str
    initial: float
    node: Node
    carried: Node | None = None  # added to the value at the start: what the motion at the start gives it
    start: sympy.Expr = sympy.S.Zero

    def starting(self, numbers: Mapping[sympy.Symbol, sympy.Expr]) -> float:
        """The value at the start for these parameters, without what the motion gives it."""
        return float(self.start.xreplace(numbers))


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
class Passed:
    """A motion that was computed, at its n outputs: places of named points and forces in joints, absolute axes.

    `points`: name -> (n, 3) [m]; `forces`: joint -> (n, 3) [N], from parent on child.
    """

    mechanism: Mechanism
    points: Mapping[str, np.ndarray]
    forces: Mapping[str, np.ndarray]


@dataclass(frozen=True)
class Estimate:
    """What load-dependent effects read: reactions (f ; m_O) by joint, absolute axes, and rates of the links, with the
    ground's motion and gravity; as they are without these effects, or as a pass before found them."""

    reactions: Mapping[str, tuple[Vector, Vector]]
    rates: Sequence[Rates]


@dataclass(frozen=True)
class Transmission:
    """What stands between an entry of u and the force on its joint: both directions, and the unit of u.

    `rate` is the motor's rate, so that command * rate is the motor's power.
    """

    force: Callable[[Node], Node]
    command: Callable[[Node], Node]
    unit: str
    rate: Node


@dataclass(frozen=True)
class Bending:
    """A deflection eta [m] of a body's points along an axis e of it, by a shape: moves along with one link.

    `share` is the integral of the shape over the mass [kg], `place` that of the shape and the point [kg m], link
    coordinates, `mass` that of the square of the shape [kg]. `drive` is what accelerates it beside the link's motion,
    mass eta_ddot = drive - e . (share a_O + U place), with the acceleration of the link's points a_O + U r.
    """

    link: int
    axis: Vector
    share: Node
    place: Vector
    mass: Node
    amount: Node
    rate: Node
    drive: Node

    def wrench(self, moving: Rates) -> tuple[Vector, Vector]:
        """What the link must supply for the deflection's acceleration and for the Coriolis forces, at its origin."""
        felt = add(scale(self.share, moving.origin), transform(moving.matrix, self.place))
        gain = (self.drive - dot(self.axis, felt)) * (1 / self.mass)
        moved = add(scale(gain, self.axis), scale(2 * self.rate, cross(moving.omega, self.axis)))
        lever = add(self.place, scale(self.mass * self.amount, self.axis))
        return scale(self.share, moved), cross(lever, moved)

    @property
    def felt(self) -> tuple[Vector, Vector]:
        """The wrench on the link that works as the deflection's part of the mass does: (share e ; place x e)."""
        return scale(self.share, self.axis), cross(self.place, self.axis)

    def grown(self, own: Inertia) -> Inertia:
        """The inertia of the link with its points deflected."""
        e, eta = self.axis, self.amount
        square = self.mass * eta * eta
        rows = tuple(
            tuple(own.second[i][j] + eta * (self.place[i] * e[j] + e[i] * self.place[j]) + square * (e[i] * e[j])
                  for j in range(3))
            for i in range(3)
        )  # fmt: skip
        first = add(own.first, scale(self.share * eta, e))
        return Inertia(own.mass, first, rows, own.still)  # type: ignore[arg-type]


@dataclass(frozen=True)
class AddedInertia:
    """Inertia beside that of the bodies as given: of freedoms of the tree (index into v), and of deflections."""

    freedoms: Mapping[int, Node] = field(default_factory=dict)
    bendings: tuple[Bending, ...] = ()

    def grown(self, inertia: Sequence[Inertia]) -> list[Inertia]:
        """Inertias of the links with their points deflected."""
        result = list(inertia)
        for bending in self.bendings:
            result[bending.link] = bending.grown(result[bending.link])
        return result
