"""Everything that the functions of a model share: a structure at nodes for q, v, a, and the closure of its loops.

    Structure --at q--> Linkage --> cuts --> ClosureJacobian
              --------> SampleStates, at which pivots are chosen

`System` is built once per model. Its inputs q, v, a are nodes of the tape; the closure Jacobian and its
bias are written in "joint rates" w: v itself, except that a spherical joint's rates are taken in the axes
before its rotation (w = turn v), which is where the limbs' wrenches arrive.
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from symscrew.algebra import Node, Pose, Twist, Vector
from symscrew.description import Mechanism
from symscrew.kinematics.closure_jacobian import ClosureJacobian
from symscrew.kinematics.cut_joints import Cut, Row, cuts, drive_row
from symscrew.kinematics.link_quantities import Inertia, Placement, Rates
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.loop_closure import closure_rate
from symscrew.kinematics.pairs import Turn
from symscrew.kinematics.recursion import rates, twists
from symscrew.kinematics.rolling import Rolling
from symscrew.kinematics.sample_states import Array, SampleStates, States
from symscrew.kinematics.structure import Coordinates, Structure
from symscrew.program import Port


@dataclass(frozen=True, eq=False)
class Configuration:
    """A structure at nodes for q, v, a: its links, its cut joints, and the sample states that all of them share."""

    structure: Structure
    samples: SampleStates
    inputs: Coordinates
    closure: ClosureJacobian


class System:
    """The mechanism on a tape. Attributes are derived once and never change."""

    def __init__(
        self,
        mechanism: Mechanism,
        loaded: Mechanism | None = None,
        *,
        read: Collection[str] = (),
        rolled: Sequence[Rolling] = (),
        kept: Collection[str] = (),
        configuration: Configuration | None = None,
    ) -> None:
        """The system of a mechanism; `loaded` is the same one with other inertias, which are taken then.

        `read` names the joints whose displacements effects ask for, which then are no places to cut a loop; `rolled`
        says which bodies roll on others, `kept` which joints are of the tree in any case.
        With a `configuration` it is the system of that, else at the inputs of the tree.
        """
        here = configuration or _at_inputs(Structure(mechanism, loaded, read, rolled, kept=kept))
        self.structure, self.samples, self.inputs, self.closure = (
            here.structure,
            here.samples,
            here.inputs,
            here.closure,
        )
        self.mechanism, self.tape, self.geometry = (
            self.structure.mechanism,
            self.structure.tape,
            self.structure.geometry,
        )
        self.tree, self.frames = self.structure.tree, self.structure.frames
        self.linkage: Linkage = self.closure.linkage
        self.placed: tuple[Placement, ...] = self.linkage.placed
        self.cuts: tuple[Cut, ...] = self.closure.cuts
        self.answers: dict[Hashable, Any] = {}  # what was asked of this system before

    def __repr__(self) -> str:
        counts = f"{len(self.tree.links) - 1} links, {len(self.tree.v)} rates, {len(self.cuts)} cut joints"
        return f"System({self.mechanism.name!r}: {counts})"

    def at(
        self,
        q: Sequence[Node],
        turns: Mapping[int, Turn],
        v: Sequence[Node] | None = None,
        a: Sequence[Node] | None = None,
    ) -> System:
        """The same structure at other nodes for q, v, a; `turns` gives cosines and sines that are known."""
        inputs = Coordinates(tuple(q), tuple(v or self.inputs.v), tuple(a or self.inputs.a))
        linkage = self.structure.linkage(inputs.q, turns)
        closure = ClosureJacobian(self.geometry, linkage, self._cuts(linkage, turns))
        return System(self.mechanism, configuration=Configuration(self.structure, self.samples, inputs, closure))

    def _cuts(self, linkage: Linkage, turns: Mapping[int, Turn]) -> tuple[Cut, ...]:
        return cuts(linkage, self.geometry, through_limbs=not turns, rolled=self.structure.rolled)

    # -- kinematics at these nodes ----------------------------------------------------------------------

    @property
    def pose(self) -> tuple[Pose, ...]:
        """absolute_T_link of every link."""
        return self.linkage.poses

    @cached_property
    def twist(self) -> tuple[Twist, ...]:
        """Twist of every link at its origin, link axes."""
        return twists(self.linkage, self.inputs.v)

    def rates(self, a: Sequence[Node]) -> tuple[Rates, ...]:
        """Rates of every link against the ground for given accelerations of the tree."""
        return rates(self.linkage, self.inputs.v, a)

    def joint_rates(self, v: Sequence[Node]) -> list[Node]:
        """w from v: spherical rates turned into the axes before the rotation."""
        return self.linkage.joint_rates(v)

    def tree_rates(self, w: Sequence[Node]) -> list[Node]:
        """v from w."""
        return self.linkage.tree_rates(w)

    # -- closure at these nodes -------------------------------------------------------------------------

    @property
    def jacobian(self) -> list[dict[int, Node]]:
        """Rows of the closure Jacobian in joint rates w: {index into v: entry}, one per multiplier."""
        return self.closure.rows

    @property
    def residual(self) -> list[Node]:
        """How far the loops are open, one number per row."""
        return self.closure.residual

    def bias(self, rate: Sequence[Rates], a: Sequence[Node] | None = None) -> list[Node]:
        """(dJ/dt) v per row, from rates taken at zero accelerations of the tree; J a + (dJ/dt) v from rates at a."""
        return self.closure.bias(self.twist, rate, self.inputs.v, a)

    @property
    def opening_rates(self) -> list[Node]:
        """How fast the loops open, one number per row: J v."""
        v = self.inputs.v
        return [value for cut in self.cuts for value in closure_rate(cut, self.linkage, self.twist, v)]

    def powers(self, index: int, force: Vector, moment: Vector, inside: int) -> dict[int, Node]:
        """Power per joint rate, down to link `inside`, of a wrench on a link (axes before its motion, its origin)."""
        return self.closure.powers(index, (force, moment), inside)

    def cut_drives(self) -> dict[int, list[tuple[int, Row]]]:
        """Cut joint -> (index into u, unit drive wrench on its child, tip axes), for drives of cut joints."""
        index = {cut.joint.name: c for c, cut in enumerate(self.cuts)}
        result: dict[int, list[tuple[int, Row]]] = {}
        for u, (joint, freedom) in enumerate(self.drives):
            if joint in index:
                row = drive_row(self.cuts[index[joint]], freedom, self.linkage)
                result.setdefault(index[joint], []).append((u, row))
        return result

    # -- consistent states at which pivots are chosen ------------------------------------------------------

    @property
    def sample_states(self) -> States:
        """Consistent (q, v, a): first the reference configuration, then others near it; shapes (samples, n)."""
        return self.samples.chosen

    def states(self, count: int, seed: int) -> States:
        """The reference configuration and `count` random ones near it with consistent v, a; shapes (1 + count, n)."""
        return self.samples.states(count, seed)

    def use_samples(self) -> None:
        """Give the tape's inputs their values at the sample states."""
        self.samples.use()

    # -- of the structure: asked for everywhere ------------------------------------------------------------

    @property
    def inertia(self) -> tuple[Inertia, ...]:
        """Inertia of every link about its origin, link axes."""
        return self.structure.inertia

    @property
    def length(self) -> float:
        """Characteristic length [m]; see `characteristic_length`."""
        return self.structure.length

    @property
    def scales(self) -> Array:
        """What one rate of the tree is compared with, shape (nv,): the characteristic length for a length, else 1."""
        return self.structure.scales

    @property
    def reference(self) -> Array:
        """q in the reference configuration, shape (nq,)."""
        return self.structure.reference

    def reference_at(self, parameters: Array) -> Array:
        """q (nq,) in the reference configuration where the run-time parameters have these values (np,)."""
        return self.structure.reference_at(parameters)

    @property
    def drives(self) -> tuple[tuple[str, int], ...]:
        """(joint, freedom) of every drive, in the order of the description: the entries of u."""
        return self.structure.drives

    @property
    def parameters(self) -> tuple[Node, ...]:
        """Input nodes of the run-time parameters, in the order of the description."""
        return self.structure.parameters

    @property
    def parameter_values(self) -> Array:
        """Default values of the run-time parameters."""
        return self.structure.parameter_values

    def drive_rows(self) -> dict[int, int]:
        """Index into v -> index into u, for drives of tree joints."""
        return self.structure.drive_rows()

    def parameter_ports(self) -> tuple[tuple[Port, ...], tuple[tuple[Node, ...], ...]]:
        """The input port `p` of the run-time parameters, or nothing where there are none."""
        return self.structure.parameter_ports()

    def local_point(self, link: int, point: Vector) -> Vector:
        """A point given in the reference configuration, in link coordinates."""
        return self.structure.local_point(link, point)

    def advance(self, q: Array, step: Array) -> Array:
        """q moved along joint rates w (spherical: rotation vector in the axes before the rotation)."""
        return self.structure.advance(q, step)

    def moved(self, q: Array, step: Array) -> Array:
        """q (n, nq) moved along rates v (n, nv), those of the model's functions (spherical: in the child's axes)."""
        return self.advance(q, self.numeric(self.joint_rates(self.inputs.v), (self.inputs.q, q), (self.inputs.v, step)))

    def numeric(
        self, nodes: Sequence[Node], *inputs: tuple[Sequence[Node], Array], parameters: Array | None = None
    ) -> Array:
        """Values of `nodes` for arrays (samples, n) of the given input nodes; run-time parameters default."""
        return self.structure.numeric(nodes, *inputs, parameters=parameters)


def _at_inputs(structure: Structure) -> Configuration:
    """The configuration whose q, v, a are the inputs of every function."""
    linkage = structure.linkage(structure.inputs.q)
    closure = ClosureJacobian(structure.geometry, linkage, cuts(linkage, structure.geometry, rolled=structure.rolled))
    return Configuration(structure, SampleStates(structure, closure), structure.inputs, closure)
