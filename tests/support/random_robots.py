"""Robots at random: joints of every type, either way round, references, couplings, loops, and what acts on them."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

from support.further_mechanisms import unit
from symscrew import Mechanism, MechanismBuilder
from symscrew.effects import Effect, effect_from_table
from symscrew.formats import JointLimits

AXES = ([1, 0, 0], [0, 1, 0], [0, 0, 1], [3, 0, 4], [1, 2, 2], [-2, 1, 2], [0, -1, 0])
CROSSED = (([1, 0, 0], [0, 1, 0]), ([1, 2, 2], [2, -2, 1]), ([0, 0, 1], [0, -1, 0]))
SINGLE = ("R", "R", "P")
FREEDOMS = {"R": 1, "P": 1, "H": 1, "C": 2, "U": 2, "S": 3, "E": 3, "free": 6, "fixed": 0}
SLIP = 1e-3
"""Velocity [rad/s or m/s] of friction that files name."""


class RandomRobot:
    """A mechanism, effects and limits from a seed; `tree`: without loops; `plain`: hinges and slides alone."""

    def __init__(self, seed: int, *, tree: bool, plain: bool = False, kinds: str = "R R P C U S E H fixed") -> None:
        self.kinds = kinds.split()
        self.chance = random.Random(seed)
        self.tree, self.plain = tree, plain
        self.builder = MechanismBuilder("robot")
        self.freedoms: list[tuple[str, int, str]] = []  # joint, freedom, type
        self.singles: list[tuple[str, str, bool]] = []  # joint, type, driven
        self.driven: dict[str, list[int]] = {}
        self.bodies = ["base"]
        self._links()
        if not tree:
            self._loop()
        self._couplings()
        self.mechanism: Mechanism = self.builder.build()
        self.effects = self._effects()
        self.limits = self._limits()

    def number(self, low: float, high: float) -> float:
        return round(self.chance.uniform(low, high), 3)

    def place(self, size: float = 0.6) -> list[float]:
        return [self.number(-size, size) for _ in range(3)]

    def _links(self) -> None:
        count = self.chance.choice((2, 3, 4)) if self.tree else self.chance.choice((4, 5))
        for k in range(count):
            name = f"link{k}"
            moments = sorted(self.number(0.03, 0.05) for _ in range(3))
            products = [self.number(-0.004, 0.004) for _ in range(3)]
            (a, b, c), (d, e, f) = moments, products
            self.builder.body(name, mass=self.number(0.5, 2), com=self.place(), inertia=[[a, d, e], [d, b, f], [e, f, c]])
            kind = self.chance.choice(SINGLE if self.plain or not self.tree else self.kinds)
            if k == 0 and self.chance.random() < 0.2 and not self.plain:
                kind = "free"
            inner = self.chance.choice(self.bodies[-2:])
            self._joint(f"j{k}", kind, inner, name)
            self.bodies.append(name)

    def _joint(self, name: str, kind: str, inner: str, outer: str, *, closing: bool = False) -> None:
        ends = (inner, outer)
        if self.chance.random() < 0.25 and kind in ("R", "P", "S", "H") and not closing:
            ends = (outer, inner)
        more: dict[str, Any] = {}
        if kind == "U":
            more["axes"] = [unit(axis) for axis in self.chance.choice(CROSSED)]
        elif kind in ("R", "P", "H", "C", "E"):
            more["axes"] = [unit(self.chance.choice(AXES))]
        if kind == "H":
            more["pitch"] = self.number(0.02, 0.1)
        if kind in ("R", "P") and not closing and self.chance.random() < 0.4:
            more["reference"] = self.number(-0.5, 0.5)
        count = FREEDOMS[kind]
        driven = [k for k in range(count) if not closing and kind != "free" and self.chance.random() < 0.5]
        if driven:
            more["driven"] = driven
        self.builder.joint(name, kind, parent=ends[0], child=ends[1], point=self.place(), **more)
        self.driven[name] = driven
        if not closing:
            self.freedoms += [(name, k, kind) for k in range(count)]
            if kind in ("R", "P"):
                self.singles.append((name, kind, bool(driven)))

    def _loop(self) -> None:
        inner, outer = self.chance.choice((("base", self.bodies[-1]), (self.bodies[1], self.bodies[-1])))
        kind = self.chance.choice(("S", "S", "U", "C") if len(self.freedoms) > 3 else ("S",))
        self._joint("closing", kind, inner, outer, closing=True)

    def _couplings(self) -> None:
        undriven = [name for name, _, driven in self.singles if not driven]
        if len(self.singles) < 3 or not undriven or self.chance.random() < 0.5:
            return
        last = self.chance.choice(undriven)
        others = [name for name, _, _ in self.singles if name != last]
        form = self.chance.choice(("gears", "gears", "polynomial", "three"))
        terms: dict[str, Any] = {last: self.number(0.5, 2), self.chance.choice(others): self.number(-2, -0.5)}
        if form == "polynomial":
            first = next(key for key in terms if key != last)
            terms = {last: 1, first: [self.number(-1, 1) for _ in range(self.chance.choice((2, 3, 4)))]}
        if form == "three" and len(others) > 1:
            terms |= {name: self.number(0.3, 1) for name in others if name not in terms}
        self.builder.coupling("tie", terms=terms)

    def _effects(self) -> list[Effect]:
        field = [0, 0, "-9.81"] if self.chance.random() < 0.6 else [self.number(-9, 9) for _ in range(3)]
        tables: list[dict[str, Any]] = [{"type": "gravity", "acceleration": field}]
        for joint, freedom, kind in self.freedoms:
            tables += self._on_a_freedom(joint, freedom, kind)
        return [effect_from_table(table) for table in tables]

    def _on_a_freedom(self, joint: str, freedom: int, kind: str) -> Iterator[dict[str, Any]]:
        """Effects on one freedom; of a ball or a free joint, on all of them at once."""

        def some(share: float) -> bool:
            return self.chance.random() < share

        turning = kind in ("S", "free")
        one: dict[str, Any] = {"joint": joint} if FREEDOMS[kind] == 1 else {"joint": joint, "freedom": freedom}
        whole: dict[str, Any] = {"joint": joint} if turning else one
        if some(0.3):
            yield {"type": "dry_friction", **one, "coulomb": self.number(0.1, 1), "velocity": SLIP}
        if turning and freedom:
            return
        if some(0.4):
            ratio = {"ratio": self.number(2, 9)} if some(0.4) else {}
            yield {"type": "rotor_inertia", **whole, "inertia": self.number(0.01, 0.1), **ratio}
        if some(0.4):
            yield {"type": "viscous_friction", **whole, "coefficient": self.number(0.1, 1)}
        if kind != "free" and some(0.3):
            more: dict[str, Any] = {"nearest": True} if kind == "S" else {"rest": self.number(-0.4, 0.4)}
            more |= {"damping": self.number(0.1, 1)} if some(0.3) else {}
            yield {"type": "joint_spring", **whole, "stiffness": self.number(1, 20), **more}
        if not turning and freedom in self.driven.get(joint, []) and some(0.4):
            limit = {"limit": self.number(2, 5)} if some(0.4) else {}
            servo = {"type": "position_servo", **one, "stiffness": self.number(5, 50), "damping": self.number(0, 2)}
            yield {**servo, **limit}

    def _limits(self) -> dict[str, JointLimits]:
        found = {}
        for joint, _, _ in self.singles:
            if self.chance.random() < 0.5:
                found[joint] = JointLimits(-self.number(1, 2), self.number(1, 2), effort=self.number(100, 200))
        return found
