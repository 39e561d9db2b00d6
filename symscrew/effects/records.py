"""The small records that effects hand on: states of their own, contacts with events, transmissions of drives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from symscrew.algebra import Node


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
