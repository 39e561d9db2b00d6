"""What of a mechanism does not depend on where it is: tape, tree, frames, inputs, inertias, drives, parameters.

Mechanism --> Structure --linkage, cuts--> System
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.algebra import (
    IDENTITY,
    ZERO,
    Node,
    Tape,
    Vector,
    named,
    named_matrix,
    named_vector,
    subtract,
    transform,
    transpose,
)
from symscrew.description import Mechanism, characteristic_length, exact
from symscrew.kinematics.coordinate_names import check_apart, identifiers
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.limb_symmetry import equal_limbs
from symscrew.kinematics.link_frames import link_frames
from symscrew.kinematics.link_inertias import link_inertias
from symscrew.kinematics.link_quantities import Frame, Inertia, Placement
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.pairs import Turn
from symscrew.kinematics.rolling import Rolling
from symscrew.kinematics.tree import Coordinate, Link, Tree, spanning_tree
from symscrew.program import Function, Limbs, Port, Program, evaluate, lower

Array = np.ndarray[Any, Any]


@dataclass(frozen=True)
class Coordinates:
    """Nodes of the tree: configuration q, rates v, accelerations a."""

    q: tuple[Node, ...]
    v: tuple[Node, ...]
    a: tuple[Node, ...]


class Structure:
    """A mechanism on a tape of its own. Attributes are derived once and never change."""

    def __init__(
        self,
        mechanism: Mechanism,
        loaded: Mechanism | None = None,
        read: Collection[str] = (),
        rolled: Sequence[Rolling] = (),
        *,
        kept: Collection[str] = (),
    ) -> None:
        """The structure of a mechanism; `loaded` is the same one with other inertias, which are taken then.

        `read`: joints whose displacements effects ask for; `rolled`: bodies that roll on others; `kept`: joints of
        the tree in any case.
        """
        self.rolled = tuple(rolled)
        self.mechanism = loaded or mechanism
        self.tape = Tape()
        self.geometry = Geometry(mechanism, self.tape)
        self.tree: Tree = spanning_tree(mechanism, read, kept)
        self.frames: tuple[Frame, ...] = link_frames(mechanism, self.tree, self.geometry)
        self.inputs = self._inputs()
        self._lowered: dict[tuple[tuple[int, ...], ...], Program] = {}  # by results and inputs: Newton asks for many

    def _inputs(self) -> Coordinates:
        def make(prefix: str, coordinates: Sequence[Coordinate], unit: str, what: str) -> tuple[Node, ...]:
            names = identifiers(c.label for c in coordinates)
            check_apart(self.mechanism, (f"{prefix}_{name}" for name in names.values()))
            return tuple(
                self.tape.symbol(f"{prefix}_{names[c.label]}", c.unit + unit, f"{what} of {c.label}")
                for c in coordinates
            )

        return Coordinates(
            make("q", self.tree.q, "", "coordinate"),
            make("v", self.tree.v, "", "rate"),
            make("a", self.tree.v, "/s", "acceleration"),
        )

    @cached_property
    def inertia(self) -> tuple[Inertia, ...]:
        """Inertia of every link about its origin, link axes."""
        return link_inertias(self.mechanism, self.tree, self.frames, self.geometry)

    @cached_property
    def limbs(self) -> Limbs:
        """Which parts of the mechanism are equal limbs."""
        return equal_limbs(self.tree, self.mechanism.platform)

    @cached_property
    def length(self) -> float:
        """Characteristic length [m]; see `characteristic_length`."""
        return characteristic_length(self.mechanism)

    @cached_property
    def scales(self) -> Array:
        """What one rate of the tree is compared with, shape (nv,): the characteristic length for a length, else 1."""
        return np.array([self.length if c.kind == "length" else 1.0 for c in self.tree.v])

    @cached_property
    def reference(self) -> Array:
        """q in the reference configuration, shape (nq,)."""
        return self.reference_at(self.parameter_values)

    def reference_at(self, parameters: Array) -> Array:
        """q (nq,) in the reference configuration where the run-time parameters have these values (np,)."""
        known, names = self.mechanism.parameters, [p.name for p in self.mechanism.parameters.values() if p.run_time]
        default = np.array_equal(parameters, self.parameter_values)
        chosen = {} if default else {n: exact(float(x)) for n, x in zip(names, parameters, strict=True)}
        numbers = {known[name].symbol: value for name, value in self.mechanism.values(chosen).items()}
        q = np.zeros(len(self.tree.q))
        for link in self.tree.links[1:]:
            given = self.tree.joints[link.joint].reference
            value = float(given[link.position].xreplace(numbers)) if link.position < len(given) else 0.0
            q[link.q] = link.pair.reference(value)
        return q

    def advance(self, q: Array, step: Array) -> Array:
        """q moved along joint rates w (spherical: rotation vector in the axes before the rotation); shapes (..., n)."""
        moved = np.array(q, dtype=float)
        for link in self.tree.links[1:]:
            moved[..., link.q] = link.pair.moved(q[..., link.q], step[..., link.v])
        return moved

    @cached_property
    def drives(self) -> tuple[tuple[str, int], ...]:
        """(joint, freedom) of every drive, in the order of the description: the entries of u."""
        return tuple((j.name, k) for j in self.mechanism.joints.values() for k in j.driven)

    def drive_rows(self) -> dict[int, int]:
        """Index into v -> index into u, for drives of tree joints."""
        rows = {}
        for u, (joint, freedom) in enumerate(self.drives):
            if joint in self.tree.joints:
                rows[self.tree.velocity_indices(joint)[freedom]] = u
        return rows

    def virtual_directions(self) -> tuple[tuple[Vector, ...], tuple[Vector, ...]]:
        """Directions of forces and couples reciprocal to the virtual joint: it must not transmit them."""
        joint = self.tree.joints[self.tree.virtual] if self.tree.virtual else None
        if joint is None or joint.kind.unconstrained:
            return (), ()
        axes = list(enumerate(self.geometry.motion_axes(joint)))
        forces = tuple(axis for k, axis in axes if k not in joint.kind.sliding)
        return forces, tuple(axis for k, axis in axes if k not in joint.kind.turning)

    def linkage(self, q: Sequence[Node], turns: Mapping[int, Turn] | None = None) -> Linkage:
        """The links at coordinates q; `turns` gives cosines and sines of links whose angles are not needed."""
        known = turns or {}
        placed = [Placement(IDENTITY, IDENTITY, ZERO)]
        for link, frame in zip(self.tree.links[1:], self.frames[1:], strict=True):
            here = link.pair.placement(self.tape, frame, q[link.q], known.get(link.index))
            _name(here, link, self.tree.part(link.index))
            placed.append(here)
        return Linkage(self.tree, self.frames, tuple(placed), tuple(q))

    def local_point(self, link: int, point: Vector) -> Vector:
        """A point given in the reference configuration, in link coordinates."""
        frame = self.frames[link]
        return self.geometry.settle(transform(transpose(frame.axes), subtract(point, frame.origin)))

    @cached_property
    def parameters(self) -> tuple[Node, ...]:
        """Input nodes of the run-time parameters, in the order of the description."""
        return tuple(self.geometry.parameters[p.symbol] for p in self.mechanism.parameters.values() if p.run_time)

    @cached_property
    def parameter_values(self) -> Array:
        """Default values of the run-time parameters."""
        return np.array([float(p.value) for p in self.mechanism.parameters.values() if p.run_time])

    def parameter_ports(self) -> tuple[tuple[Port, ...], tuple[tuple[Node, ...], ...]]:
        """The input port `p` of the run-time parameters, or nothing where there are none."""
        chosen = [p for p in self.mechanism.parameters.values() if p.run_time]
        if not chosen:
            return (), ()
        port = Port(
            "p",
            (len(chosen),),
            tuple(p.unit for p in chosen),
            tuple(p.name for p in chosen),
            "run-time parameters",
        )
        return (port,), (self.parameters,)

    def numeric(
        self, nodes: Sequence[Node], *inputs: tuple[Sequence[Node], Array], parameters: Array | None = None
    ) -> Array:
        """Values of `nodes` for arrays (samples, n) of the given input nodes.

        `parameters`: run-time ones (np,) or (samples, np); default: those of the description.
        """
        chosen = self.parameter_values if parameters is None else parameters
        pairs = [*inputs, (self.parameters, chosen)] if self.parameters else list(inputs)
        key = (tuple(n.index for n in nodes), *(tuple(n.index for n in given) for given, _ in pairs))
        if key not in self._lowered:
            self._lowered[key] = self._lower(nodes, [given for given, _ in pairs])
        return evaluate(self._lowered[key], [a for _, a in pairs])[0][0]

    def _lower(self, nodes: Sequence[Node], inputs: Sequence[Sequence[Node]]) -> Program:
        ports = tuple(Port(f"x{i}", (len(n),), (), (), "") for i, n in enumerate(inputs))
        function = Function(
            "numeric",
            "",
            ports,
            (Port("y", (len(nodes),), (), (), ""),),
            tuple(tuple(n) for n in inputs),
            (tuple(nodes),),
        )
        return lower(function)


def _name(here: Placement, link: Link, part: str) -> None:
    """Call a link's placement what it is."""
    named_vector(here.offset, "offset", part)
    if link.motion.single and link.motion.turns:  # about z
        named(here.turn[0][0], "cos", part)
        named(here.turn[1][0], "sin", part)
    else:
        named_matrix(here.turn, "turn", part)
