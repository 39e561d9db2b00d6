"""Couplings of coordinates as rows of the closure, beside those of cut joints.

    sum of p_j(x_j) = constant --rate--> sum of p_j'(x_j) v_j --rate--> sum of p_j' a_j + p_j'' v_j^2

A coupling acts on its joints' own freedoms: multiplier m is m p_j' on coordinate j, as a drive would be, and no wrench
on any body. All is divided by the first slope that is not zero in the reference configuration, so that the multiplier
is the force or moment on that coordinate and the row has its unit.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import Node, Tape
from symscrew.description import CoupledTerm, Coupling, slope
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.tree import Link, Tree


@dataclass(frozen=True)
class Share:
    """What one coordinate has in a coupling: its entries in q and v, x, and the coefficients of x, x^2 ...

    `reference` is x in the reference configuration.
    """

    q: int
    v: int
    x: Node
    reference: Node
    coefficients: tuple[Node, ...]

    @property
    def opened(self) -> Node:
        """How far x has moved its side of the coupling from the reference."""
        return _power_sum(self.coefficients, self.x) - _power_sum(self.coefficients, self.reference)

    def slope(self, order: int = 1) -> Node:
        """The derivative of this order by x."""
        tape = self.x.tape
        left = list(enumerate(self.coefficients, start=1))[order - 1 :]
        total = tape.zero
        for k, c in reversed(left):
            factor = 1
            for j in range(order):
                factor *= k - j
            total = total * self.x + factor * c
        return tape.node(total)


@dataclass(frozen=True)
class Relation:
    """A coupling at the nodes of a linkage."""

    coupling: Coupling
    shares: tuple[Share, ...]
    sliding: bool  # whether its row is in metres, else in radians

    @property
    def row(self) -> dict[int, Node]:
        """{index into v: slope}."""
        found: dict[int, Node] = {}
        for share in self.shares:
            found[share.v] = share.slope()
        return {k: entry for k, entry in found.items() if entry is not entry.tape.zero}

    @property
    def residual(self) -> Node:
        """How far the coupling is off [m, rad]."""
        total = self.shares[0].x.tape.zero
        for share in self.shares:
            total = total + share.opened
        return total

    def rate(self, v: Sequence[Node]) -> Node:
        """How fast it opens."""
        total = self.shares[0].x.tape.zero
        for k, entry in self.row.items():
            total = total + entry * v[k]
        return total

    def bias(self, v: Sequence[Node], a: Sequence[Node] | None = None) -> Node:
        """How its rate of opening changes at these accelerations of the tree, by default at none."""
        total = self.shares[0].x.tape.zero if a is None else self.rate(a)
        for share in self.shares:
            total = total + share.slope(2) * (v[share.v] * v[share.v])
        return total


def relation(at: Linkage, geometry: Geometry, coupling: Coupling) -> Relation:
    """A coupling at the coordinates of a linkage."""
    mechanism, tape = geometry.mechanism, geometry.tape
    slopes = [mechanism.number(slope(mechanism, term)) for term in coupling.terms]
    first = next(k for k, value in enumerate(slopes) if value != 0)
    unit = geometry.scalar(slope(mechanism, coupling.terms[first]))
    shares = tuple(_share(at, geometry, term, tape.settle(1 / unit)) for term in coupling.terms)
    return Relation(coupling, shares, at.tree.v[shares[first].v].kind == "length")


def _share(at: Linkage, geometry: Geometry, term: CoupledTerm, factor: Node) -> Share:
    link = coupled_link(at.tree, term)
    joint = at.tree.joints[term.joint]
    given = joint.reference[term.motion] if term.motion < len(joint.reference) else 0
    coefficients = tuple(geometry.tape.settle(factor * geometry.scalar(c)) for c in term.coefficients)
    return Share(link.q.start, link.v.start, at.q[link.q.start], _number(geometry, given), coefficients)


def coupled_link(tree: Tree, term: CoupledTerm) -> Link:
    """The link that a term's coordinate moves."""
    return next(link for link in tree.links_of(term.joint) if link.position == term.motion)


def _number(geometry: Geometry, value: object) -> Node:
    return geometry.tape.zero if value == 0 else geometry.scalar(value)


def _power_sum(coefficients: Sequence[Node], x: Node) -> Node:
    tape: Tape = x.tape
    total = tape.zero
    for c in reversed(coefficients):
        total = (total + c) * x
    return tape.node(total)
