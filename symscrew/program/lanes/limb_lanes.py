"""Which limb every value of a program belongs to, and what it is called there: lanes by construction.

    origin (quantity, part, component, by) --role of the part in its limb--> lane, and a name that equal limbs share

A value with a name is in the lane of the limb that its part belongs to; one of the hub that is a coefficient of
something in a limb (what the platform needs per multiplier of leg 3) is in that limb's. Values without names lie
between: what is made of one limb's values and of shared ones is in its lane, and so is what only one limb's values are
made of. What several limbs meet in belongs to none of them.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from symscrew.algebra import Origin
from symscrew.program.equal_limbs import Limb
from symscrew.program.lanes.signed_operations import WIDEST, Operand, Operation

OWN_AXES = frozenset((
    "omega", "velocity", "alpha", "acceleration", "acceleration_matrix", "alpha_still", "acceleration_still",
    "acceleration_matrix_still", "joint_rate", "joint_acceleration", "joint_acceleration_still", "momentum_rate",
    "opening", "opening_rate", "opening_bias", "arm", "closure", "pivot", "determinant", "factor", "null_space",
    "limb_target", "limb_length", "force", "transmitted", "balance", "multiplier", "multiplier_part", "drive", "aside",
    "generalised_force", "composite", "mass_matrix", "stiffness", "answer", "effort", "handed_inertia", "handed_force",
    "follows", "q", "v", "a", "u", "pose", "rate", "gain", "y", "y_dot", "y_ddot",
))  # fmt: skip
"""Quantities that equal limbs have under equal names: scalars, and vectors in axes that a link carries.

Axes before a motion, and absolute ones, stand otherwise to each limb: a component of one may be another component of
the next. There the name is a hint, and what they are made of and go into decides."""

TURNS = frozenset(("cos", "sin"))
"""An angle counts from the link's zero, which may differ by a quarter turn between equal limbs: their names either
correspond in all limbs (`turned` is False) or are hints."""


@dataclass
class LimbLanes:
    """The lane of slots, operations and what is there from the start; names that equal limbs share, and hints."""

    count: int
    lane: dict[int, int] = field(default_factory=dict)
    names: dict[int, Hashable] = field(default_factory=dict)
    hints: dict[int, Hashable] = field(default_factory=dict)


class _Names:
    """Names of one family of limbs: places of their parts, and whose a coefficient between two limbs is."""

    def __init__(self, family: Sequence[Limb], origins: Mapping[int, Origin], *, turned: bool) -> None:
        self.place = {part: (k, role) for k, limb in enumerate(family) for part, role in limb.parts.items()}
        self.turned, self.exact = turned, OWN_AXES if turned else OWN_AXES | TURNS
        pairs = {(self.of(o.part), self.of(o.by)) for o in origins.values() if o.by}
        between = {(own[0], by[0]) for own, by in pairs if own and by and own[0] != by[0]}
        # of one limb's values per each of the others (its multiplier per drive) the others are the lanes
        self.by_other = len({by for _, by in between}) > len({own for own, _ in between})

    def of(self, label: str) -> tuple[int, str] | None:
        """Limb and role of `part` or `part.component`."""
        return self.place.get(label) or self.place.get(label.partition(".")[0])

    def read(self, origin: Origin) -> tuple[int, Hashable, bool] | None:
        """Lane, name, and whether equal limbs share it; None of what belongs to no limb."""
        own, by, rest = self.place.get(origin.part), self.of(origin.by), origin.by.partition(".")[2]
        exact = origin.quantity in self.exact
        if own is None:
            if by is None:
                return None
            return by[0], (origin.quantity, origin.part, origin.component, by[1], rest), False
        if by is None:
            return (
                own[0],
                (origin.quantity, own[1], origin.component, origin.by),
                exact and not (origin.by and self.turned),
            )
        away = by[0] - own[0]
        if away and self.by_other:
            return by[0], (origin.quantity, own, origin.component, by[1], rest), False
        return own[0], (origin.quantity, own[1], origin.component, by[1], rest, away), exact


def readings_of(
    operations: Mapping[int, Operation],
    negatives: Mapping[int, Operand],
    origins: Mapping[int, Origin],
    family: Sequence[Limb],
) -> Iterator[LimbLanes]:
    """The lanes of a family of equal limbs: with equal zeros of their angles, and turned where names differ then."""
    bases = {slot: negatives[slot][0] if slot in negatives else slot for slot in origins}
    named = {base: origins[slot] for slot, base in reversed(bases.items()) if isinstance(base, int)}  # the first stays
    straight, hub = _called(operations, named, family, turned=False)
    _between(operations, straight.lane, hub, straight.count)
    yield straight
    turned, _ = _called(operations, named, family, turned=True)
    if turned.names != straight.names:
        yield replace(turned, lane=straight.lane)


def _called(
    operations: Mapping[int, Operation], named: Mapping[int, Origin], family: Sequence[Limb], *, turned: bool
) -> tuple[LimbLanes, set[int]]:
    """The lanes of values with names, and those of the hub."""
    found, names = LimbLanes(len(family)), _Names(family, named, turned=turned)
    hub: set[int] = set()
    for slot, origin in named.items():
        read = names.read(origin)
        if read is None:
            hub.add(slot)
            continue
        found.lane[slot], name, exact = read
        if exact and (slot in operations or origin.quantity not in TURNS):
            found.names[slot] = name
        elif not turned:
            found.hints[slot] = name
    return found, hub


ROUNDS = 2  # forwards and backwards: a third one finds nothing more, with one a few values less are in lanes


def _between(operations: Mapping[int, Operation], lane: dict[int, int], shared: set[int], count: int) -> None:
    """Put values without names into lanes."""
    read = {slot: [a for a, _ in o.args if isinstance(a, int)] for slot, o in operations.items()}
    users: dict[int, list[int]] = {}
    for slot, args in read.items():
        for a in args:
            users.setdefault(a, []).append(slot)
    mixed: set[int] = set()
    size = -(-count // -(-count // WIDEST))  # limbs in one vector
    free = [slot for slot in operations if slot not in lane and slot not in shared]
    for _ in range(ROUNDS):
        mixed.clear()
        for slot in free:
            if slot not in lane:
                lanes = {lane[a] for a in read[slot] if a in lane}
                if len(lanes) > 1 or not mixed.isdisjoint(read[slot]):
                    mixed.add(slot)
                elif lanes:
                    lane[slot] = lanes.pop()
        for slot in reversed(free):
            if slot not in lane and slot in users:
                lanes = {lane.get(u, -1) for u in users[slot]}
                if len(lanes) == 1 and -1 not in lanes:
                    lane[slot] = lanes.pop()
    for slot in reversed(free):  # what some limbs share, opposite ones say, is the first one's, and the others read it
        if slot not in lane and slot in users and slot not in mixed:
            lanes = {lane.get(u, -1) for u in users[slot]}
            if -1 not in lanes and len({k % size for k in lanes}) == 1:
                lane[slot] = min(lanes)
