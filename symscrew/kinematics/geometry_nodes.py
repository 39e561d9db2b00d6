"""The numbers of a description as nodes of the tape: baked ones are constants of 60 digits, run-time ones inputs.

    length * sin(pi/3)  --scalar-->  a constant, or a node of the parameter `length`

Hidden identities between constants are folded (`settle`), so that what is structurally zero is the node zero.
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import (
    IDENTITY,
    Matrix,
    Node,
    Tape,
    Vector,
    cross,
    dot,
    expression_node,
    scale,
    subtract,
)
from symscrew.description import Joint, Mechanism
from symscrew.kinematics.link_quantities import Inertia
from symscrew.kinematics.parameter_trials import trials

UNITS: tuple[Vector, Vector, Vector] = IDENTITY

ALONG = 1e-9
"""A direction whose part across an axis is smaller than that part of it is along the axis, and an absolute axis is
projected instead. Real directions are far from it on either side, and either choice gives correct code."""


class Geometry:
    """The description's numbers as nodes: parameters, points and axes; run-time parameters are inputs."""

    def __init__(self, mechanism: Mechanism, tape: Tape) -> None:
        self.mechanism, self.tape = mechanism, tape
        self.parameters = {
            p.symbol: tape.symbol(p.name, p.unit, p.description or f"parameter {p.name}")
            for p in mechanism.parameters.values()
            if p.run_time
        }
        self._scalars: dict[object, Node] = {}
        self.regrouped: dict[
            tuple[Inertia, ...], tuple[Inertia, ...]
        ] = {}  # inertias as given -> with fewer numbers: see `link_inertias`
        found = [{self.parameters[s]: value for s, value in trial.items()} for trial in trials(mechanism)]
        tape.set_parameter_trials(found)

    def scalar(self, expression: object) -> Node:
        """A number of the description as a node; 60 digits of the same expression are computed once."""
        if expression not in self._scalars:
            node = expression_node(self.tape, self.mechanism.baked(expression), self.parameters)
            self._scalars[expression] = self.tape.settle(node)
        return self._scalars[expression]

    def known(self, expression: object) -> Node | None:
        """The node of a number that was asked for before; nothing is made."""
        return self._scalars.get(expression)

    def vector(self, values: Sequence[object]) -> Vector:
        """A vector of the description as nodes."""
        x, y, z = (self.scalar(v) for v in values)
        return (x, y, z)

    def settle(self, values: Vector) -> Vector:
        """A vector of constants with hidden identities folded (see `Tape.settle`)."""
        x, y, z = (self.tape.settle(v) for v in values)
        return (x, y, z)

    def settle_matrix(self, matrix: Matrix) -> Matrix:
        """A matrix of constants with hidden identities folded."""
        a, b, c = (self.settle(row) for row in matrix)
        return (a, b, c)

    def unit(self, values: Vector) -> Vector:
        """The vector divided by its length."""
        length = self.tape.sqrt(self.tape.settle(dot(values, values)))
        return self.settle(scale(1 / self.tape.settle(length), values))

    def size(self, node: object) -> float:
        """Magnitude of a constant at the nominal parameters."""
        return abs(self.tape.nominal(self.tape.settle(node)))

    def vanishes(self, node: object) -> bool:
        """Whether a constant is zero at all values of the run-time parameters, not at the nominal ones alone."""
        return self.tape.settle(node) is self.tape.zero

    def motion_axes(self, joint: Joint) -> tuple[Vector, ...]:
        """Axes to which the motions of a joint refer, absolute, in the reference configuration."""
        given = [self.vector(axis) for axis in joint.axes]
        return joint.kind.motion_axes(given, UNITS, self._across)

    def _across(self, normal: Vector) -> tuple[Vector, Vector]:
        first = self.perpendicular(normal)
        return first, self.settle(cross(normal, first))

    def perpendicular(self, axis: Vector, towards: Vector | None = None) -> Vector:
        """A unit vector perpendicular to `axis`: the component of `towards`, or of an absolute axis."""
        if towards is not None:
            rest = self.settle(subtract(towards, scale(dot(towards, axis), axis)))
            if max(self.size(c) for c in rest) > ALONG * max(self.size(c) for c in towards):
                return self.unit(rest)
        sizes = [self.size(c) for c in axis]
        nearest = UNITS[sizes.index(min(sizes))]
        return self.unit(subtract(nearest, scale(dot(nearest, axis), axis)))
