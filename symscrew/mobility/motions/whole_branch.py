"""What holds on all of a branch by proof, where the lines of `whole_motion` only sample it.

    chains from the ground to the body --screws, brackets--> a group each --what they have in common--> algebra h
    joints at rest on the samples --locked--> a mechanism; as mobile as before: they never move

The body's displacement is a product of displacements along any chain of joints, so in the group that the chain's screws
generate; its twist is in what the algebras of all chains have in common, at every configuration. Where the body has as
many freedoms as h, they are h (J. M. Herve, Mech. Mach. Theory 13, 1978, 437-450). Locked joints: the configurations of
the locked mechanism are some of those of the mechanism, and these are within a manifold of as many dimensions as there
are instantaneous freedoms; where the locked ones fill that, they are all near the configuration and, closure being
analytic, on the whole branch through it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_classes import ScrewClass, screw_class
from symscrew.mobility.symbols import (
    ExactSystem,
    NotDecidableError,
    Row,
    exact_rank,
    exact_system,
    exact_value,
    null_vectors,
    screw_algebra,
)

Array = np.ndarray[Any, Any]
MOST_CHAINS = 24
"""Chains from the ground to the body that are looked at, four times the limbs of a hexapod. Fewer of them prove less,
but nothing wrong."""


@dataclass(frozen=True)
class CommonGroup:
    """What the groups of all chains to the body have in common.

    Attributes:
        twists: a basis of its algebra (n, 6), (omega ; v) at O [1, m].
        system: its class.
        chains: how many chains were looked at.
        fixed: joints of one freedom at the ground whose screws are in it: the body can move so wherever it is.
    """

    twists: Array
    system: ScrewClass
    chains: int
    fixed: tuple[str, ...] = ()

    def holds(self, twists: Array, length: float) -> bool:
        """Whether twists (n, 6), (omega ; v/length) of unit motions, are in it, up to rounding of their poses."""
        scaled = self.twists / [1, 1, 1, length, length, length]
        basis = np.linalg.qr(scaled.T)[0] if len(scaled) else np.zeros((6, 0))
        return bool(np.abs(twists - twists @ basis @ basis.T).max(initial=0.0) < SEEN)


SEEN = 1e-7
"""Part of a unit motion by which twists at poses on the lines, which close to 1e-12, may be off."""


def common_group(mechanism: Mechanism, network: Network, body: str) -> CommonGroup | None:
    """The group in which the body moves, by all chains from the ground; None where the field is too large to ask."""
    if network.ties:
        return None
    try:
        system = exact_system(mechanism)
        found: list[Row] | None = None
        count, fixed = 0, tuple[str, ...]()
        for chain in _chains(network, body):
            algebra = screw_algebra([s for name in chain for s in system.screws[name]], system)
            if algebra is None:
                return None
            count += 1
            found = algebra if found is None else _in_both(found, algebra, system)
            if not found or count == MOST_CHAINS:
                break
        fixed = _at_the_ground(network, system, found or [])
    except NotDecidableError:
        return None
    if found is None:
        return None
    twists = np.array([[exact_value(c) for c in row] for row in found], dtype=float).reshape(-1, 6)
    return CommonGroup(twists, screw_class(twists, float(network.length)), count, fixed)


def _at_the_ground(network: Network, system: ExactSystem, algebra: list[Row]) -> tuple[str, ...]:
    """Joints of one freedom at the ground whose screws are in an algebra."""
    ends = {e.name: (e.parent, e.child) for e in network.edges.values() if len(e.screws) == 1}
    alone = [name for name, pair in ends.items() if network.ground in pair]
    inside = (exact_rank([*algebra, [*system.screws[n][0]]], system.field) == len(algebra) for n in alone)
    return tuple(name for name, yes in zip(alone, inside, strict=True) if yes)


def _chains(network: Network, body: str) -> Iterator[tuple[str, ...]]:
    """Joints of the ways from the ground to the body that pass no body twice, the shorter first."""
    waiting: list[tuple[str, tuple[str, ...], frozenset[str]]] = [
        (network.ground, (), frozenset([network.ground])),
    ]
    while waiting:
        here, joints, passed = waiting.pop(0)
        if here == body:
            yield joints
            continue
        for edge in network.edges.values():
            if here in (edge.parent, edge.child):
                there = edge.child if edge.parent == here else edge.parent
                if there not in passed:
                    waiting.append((there, (*joints, edge.name), passed | {there}))


def _in_both(a: list[Row], b: list[Row], system: ExactSystem) -> list[Row]:
    """A basis of what two spaces of screws have in common."""
    outside = [list(v) for basis in (a, b) for v in null_vectors(basis, 6, system.field)]
    return [list(v) for v in null_vectors(outside, 6, system.field)]
