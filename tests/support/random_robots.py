"""Robots at random: joints of every type, either way round, references, couplings, loops, and what acts on them.

robot = random_robot(seed, IN_MJCF)      # .mechanism, .effects, .limits
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from support.further_mechanisms import unit
from symscrew import Mechanism, MechanismBuilder
from symscrew.effects import Effect, effect_from_table
from symscrew.formats import JointLimits

IN_MJCF = ("R", "R", "P", "C", "U", "S", "E", "H", "fixed", "free")
IN_URDF = ("R", "R", "P", "C", "U", "E", "fixed", "free")
"""Types of joints that come back as they were."""
CLOSED = ("R", "R", "P")
"""Types of a chain that another joint closes."""
AXES = ([1, 0, 0], [0, 1, 0], [0, 0, 1], [3, 0, 4], [1, 2, 2], [-2, 1, 2], [0, -1, 0])
CROSSED = (([1, 0, 0], [0, 1, 0]), ([1, 2, 2], [2, -2, 1]), ([0, 0, 1], [0, -1, 0]))
FREEDOMS = {"R": 1, "P": 1, "H": 1, "C": 2, "U": 2, "S": 3, "E": 3, "free": 6, "fixed": 0}
TURNED_ROUND = ("R", "P", "S", "H")
"""Types that some joints are of whose child is nearer to the ground."""
SLIP = 1e-3
"""Velocity [rad/s or m/s] of the friction that files name."""


@dataclass
class RandomRobot:
    """What is made so far; `freedoms`: (joint, freedom, type), `singles`: joint -> whether it is driven."""

    chance: random.Random
    kinds: tuple[str, ...]
    builder: MechanismBuilder = field(default_factory=lambda: MechanismBuilder("robot"))
    bodies: list[str] = field(default_factory=lambda: ["base"])
    freedoms: list[tuple[str, int, str]] = field(default_factory=list)
    singles: dict[str, bool] = field(default_factory=dict)
    driven: dict[str, list[int]] = field(default_factory=dict)
    effects: list[Effect] = field(default_factory=list)
    limits: dict[str, JointLimits] = field(default_factory=dict)

    @property
    def mechanism(self) -> Mechanism:
        return self.builder.build()

    def some(self, share: float) -> bool:
        return self.chance.random() < share

    def number(self, low: float, high: float) -> float:
        return round(self.chance.uniform(low, high), 3)

    def place(self) -> list[float]:
        return [self.number(-0.6, 0.6) for _ in range(3)]

    def link(self, joint: str, name: str, kind: str) -> None:
        (a, b, c), (d, e, f) = ([self.number(*ends) for _ in range(3)] for ends in ((0.03, 0.05), (-0.004, 0.004)))
        inertia = [[a, d, e], [d, b, f], [e, f, c]]
        self.builder.body(name, mass=self.number(0.5, 2), com=self.place(), inertia=inertia)
        inner, outer = self.chance.choice(self.bodies[-2:]), name
        self.bodies.append(name)
        if kind in TURNED_ROUND and self.some(0.25):
            inner, outer = outer, inner
        driven = [k for k in range(FREEDOMS[kind]) if kind != "free" and self.some(0.5)]
        reference = {"reference": self.number(-0.5, 0.5)} if kind in ("R", "P") and self.some(0.4) else {}
        self.joint(joint, kind, (inner, outer), driven=driven, **reference)
        self.freedoms += [(joint, k, kind) for k in range(FREEDOMS[kind])]
        if kind in ("R", "P"):
            self.singles[joint] = bool(driven)

    def joint(self, name: str, kind: str, ends: tuple[str, str], *, driven: list[int], **more: Any) -> None:
        if kind == "U":
            more["axes"] = [unit(axis) for axis in self.chance.choice(CROSSED)]
        elif kind in ("R", "P", "H", "C", "E"):
            more["axes"] = [unit(self.chance.choice(AXES))]
        if kind == "H":
            more["pitch"] = self.number(0.02, 0.1)
        self.driven[name] = driven
        self.builder.joint(name, kind, parent=ends[0], child=ends[1], point=self.place(), driven=driven, **more)

    def coupling(self, forms: tuple[str, ...]) -> None:
        passive = [name for name, driven in self.singles.items() if not driven]
        if len(self.singles) < 3 or not passive:
            return
        last, form = self.chance.choice(passive), self.chance.choice(forms)
        first, *others = [name for name in self.singles if name != last]
        terms: dict[str, Any] = {last: self.number(0.5, 2), first: self.number(-2, -0.5)}
        if form == "polynomial":
            terms = {last: 1, first: [self.number(-1, 1) for _ in range(self.chance.choice((2, 3, 4)))]}
        elif form == "three":
            terms |= {others[0]: self.number(0.3, 1)}
        self.builder.coupling("tie", terms=terms)

    def forces(self, joint: str, freedom: int, kind: str) -> Iterator[dict[str, Any]]:
        """Effects on one freedom; of a ball or a free joint, but for friction, on all of them at once."""
        turning = kind in ("S", "free")
        one: dict[str, Any] = {"joint": joint} if FREEDOMS[kind] == 1 else {"joint": joint, "freedom": freedom}
        whole: dict[str, Any] = {"joint": joint} if turning else one
        if self.some(0.3):
            yield {"type": "dry_friction", **one, "coulomb": self.number(0.1, 1), "velocity": SLIP}
        if turning and freedom:
            return
        if self.some(0.4):
            ratio = {"ratio": self.number(2, 9)} if self.some(0.4) else {}
            yield {"type": "rotor_inertia", **whole, "inertia": self.number(0.01, 0.1), **ratio}
        if self.some(0.4):
            yield {"type": "viscous_friction", **whole, "coefficient": self.number(0.1, 1)}
        for _ in range(0 if kind == "free" else self.chance.choice((0, 0, 1, 2))):
            more: dict[str, Any] = {"nearest": True} if kind == "S" else {"rest": self.number(-0.4, 0.4)}
            more |= {"damping": self.number(0.1, 1)} if self.some(0.3) else {}
            yield {"type": "joint_spring", **whole, "stiffness": self.number(1, 20), **more}
        if not turning and freedom in self.driven[joint] and self.some(0.4):
            limit = {"limit": self.number(20, 50)} if self.some(0.4) else {}
            servo = {"type": "position_servo", **one, "stiffness": self.number(5, 50), "damping": self.number(0, 2)}
            yield {**servo, **limit}


def random_robot(seed: int, kinds: tuple[str, ...], *, forms: tuple[str, ...] = ("two",)) -> RandomRobot:
    """A robot of two to four links, or, of `CLOSED` types, of four or five in a loop; couplings of these forms."""
    made = RandomRobot(random.Random(seed), kinds)
    closed = kinds == CLOSED
    for k in range(made.chance.choice((4, 5) if closed else (2, 3, 4))):
        made.link(f"j{k}", f"link{k}", made.chance.choice(kinds if k == 0 else [x for x in kinds if x != "free"]))
    if closed:
        kind = made.chance.choice(("S", "S", "U", "C") if len(made.freedoms) > 4 else ("S",))
        made.joint("closing", kind, (made.chance.choice(made.bodies[:2]), made.bodies[-1]), driven=[])
    if made.some(0.6):
        made.coupling(forms)
    field = [0, 0, "-9.81"] if made.some(0.5) else [made.number(-9, 9) for _ in range(3)]
    tables = [{"type": "gravity", "acceleration": field}, *(t for one in made.freedoms for t in made.forces(*one))]
    made.effects += map(effect_from_table, tables)
    for joint in made.singles:
        if made.some(0.5):
            servo = any(table["type"] == "position_servo" and table["joint"] == joint for table in tables)
            effort = None if servo else made.number(5, 15)  # which the file's servo would keep, too
            made.limits[joint] = JointLimits(-made.number(1, 2), made.number(1, 2), effort=effort)
    return made
