"""Everything that the functions of a model share: tape, tree, frames, inputs, placements, closure.

`System` is built once per model. Its inputs q, v, a are nodes of the tape; the closure Jacobian and its
bias are written in "joint rates" w: v itself, except that a spherical joint's rates are taken in the axes
before its rotation (w = turn v), which is where the limbs' wrenches arrive.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from symscrew.algebra import (
    Node,
    Pose,
    Tape,
    Twist,
    Vector,
    add,
    cross,
    least_norm,
    subtract,
    transform,
    transpose,
)
from symscrew.description import Mechanism
from symscrew.kinematics.cut_joints import Cut, Row, closure_bias, closure_residual, cuts, drive_row, on_hub
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_frames import link_frames
from symscrew.kinematics.link_inertias import link_inertias
from symscrew.kinematics.link_quantities import Frame, Inertia, Placement, Rates
from symscrew.kinematics.recursion import placements, poses, rates, twists
from symscrew.kinematics.tree import Tree, spanning_tree
from symscrew.program import Function, Port, evaluate, lower

Wrench = tuple[Vector, Vector]
SAMPLES = 5
SEED = 20230811


@dataclass(frozen=True)
class Coordinates:
    """Input nodes of the tree: configuration q, rates v, accelerations a."""

    q: tuple[Node, ...]
    v: tuple[Node, ...]
    a: tuple[Node, ...]


class System:
    """The mechanism on a tape. Attributes are derived once and never change."""

    def __init__(self, mechanism: Mechanism, loaded: Mechanism | None = None) -> None:
        """The system of a mechanism; `loaded` is the same one with other inertias, which are taken then."""
        self.mechanism = loaded or mechanism
        self.tape = Tape()
        self.geometry = Geometry(mechanism, self.tape)
        self.tree: Tree = spanning_tree(mechanism)
        self.frames: tuple[Frame, ...] = link_frames(mechanism, self.tree, self.geometry)
        self.inputs = self._inputs()
        self.placed: tuple[Placement, ...] = placements(self.tape, self.tree, self.frames, self.inputs.q)
        self.cuts: tuple[Cut, ...] = cuts(self.tree, self.frames, self.geometry, self.placed)

    def at(
        self,
        q: Sequence[Node],
        turns: dict[int, tuple[Node, Node]],
        v: Sequence[Node] | None = None,
        a: Sequence[Node] | None = None,
    ) -> System:
        """The same system with other nodes for q, v, a; `turns` gives cosines and sines that are known."""
        other = copy.copy(self)
        for name in ("pose", "twist", "jacobian", "residual"):
            other.__dict__.pop(name, None)
        other.inputs = Coordinates(tuple(q), tuple(v or self.inputs.v), tuple(a or self.inputs.a))
        other.placed = placements(self.tape, self.tree, self.frames, other.inputs.q, turns)
        other.cuts = cuts(self.tree, self.frames, self.geometry, other.placed, through_limbs=not turns)
        return other

    def _inputs(self) -> Coordinates:
        def make(prefix: str, coordinates: Sequence, unit: str, what: str) -> tuple[Node, ...]:
            return tuple(
                self.tape.symbol(f"{prefix}_{c.label.replace('.', '_')}", c.unit + unit, f"{what} of {c.label}")
                for c in coordinates
            )

        return Coordinates(
            make("q", self.tree.q, "", "coordinate"),
            make("v", self.tree.v, "", "rate"),
            make("a", self.tree.v, "/s", "acceleration"),
        )

    # -- kinematics -------------------------------------------------------------------------------------

    @cached_property
    def pose(self) -> tuple[Pose, ...]:
        """absolute_T_link of every link."""
        return poses(self.tree, self.placed)

    @cached_property
    def twist(self) -> tuple[Twist, ...]:
        """Twist of every link at its origin, link axes."""
        return twists(self.tree, self.frames, self.placed, self.inputs.v)

    @cached_property
    def inertia(self) -> tuple[Inertia, ...]:
        """Inertia of every link about its origin, link axes."""
        return link_inertias(self.mechanism, self.tree, self.frames, self.geometry)

    def local_point(self, link: int, point: Vector) -> Vector:
        """A point given in the reference configuration, in link coordinates."""
        frame = self.frames[link]
        return self.geometry.settle(transform(transpose(frame.axes), subtract(point, frame.origin)))

    def rates(self, a: Sequence[Node]) -> tuple[Rates, ...]:
        """Rates of every link against the ground for given accelerations of the tree."""
        return rates(self.tree, self.frames, self.placed, self.inputs.v, a)

    @cached_property
    def length(self) -> float:
        """Characteristic length [m]; see `characteristic_length`."""
        return characteristic_length(self.mechanism)

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

    def cut_drives(self) -> dict[int, list[tuple[int, Row]]]:
        """Cut joint -> (index into u, unit drive wrench on its child, tip axes), for drives of cut joints."""
        index = {cut.joint.name: c for c, cut in enumerate(self.cuts)}
        result: dict[int, list[tuple[int, Row]]] = {}
        for u, (joint, freedom) in enumerate(self.drives):
            if joint in index:
                cut = self.cuts[index[joint]]
                row = drive_row(cut, freedom, self.tree, self.placed)
                result.setdefault(index[joint], []).append((u, row))
        return result

    # -- closure ----------------------------------------------------------------------------------------

    @cached_property
    def jacobian(self) -> list[dict[int, Node]]:
        """Rows of the closure Jacobian in joint rates w: {index into v: entry}, one per multiplier."""
        return [row for cut in self.cuts for row in self.cut_rows(cut)]

    def cut_rows(self, cut: Cut) -> list[dict[int, Node]]:
        """Rows of one cut joint: {index into v: entry}, in joint rates w.

        Links that carry both sides of the loop make no difference.
        """
        common = self.tree.common(cut.tip, cut.hub)
        rows = []
        for row in cut.rows:
            entries: dict[int, Node] = {}
            below = self.limb_wrenches(cut, row, entries)
            if cut.hub != common:
                parent = self.tree.links[cut.hub].parent
                if cut.arm is not None and parent in below:
                    force, moment = self._outwards(cut.hub, *below[parent])
                else:
                    force, moment = on_hub(cut, self.tree, self.placed, row.force, row.couple)
                self._push(entries, cut.hub, force, moment, -1, common)
            rows.append({k: e for k, e in entries.items() if e is not self.tape.zero})
        return rows

    def powers(self, index: int, force: Vector, moment: Vector, inside: int) -> dict[int, Node]:
        """Power per joint rate, down to link `inside`, of a wrench on a link (axes before its motion, its origin)."""
        entries: dict[int, Node] = {}
        self._push(entries, index, force, moment, 1, inside)
        return entries

    def limb_wrenches(self, cut: Cut, row: Row, entries: dict[int, Node]) -> dict[int, Wrench]:
        """A reciprocal wrench at the origin of its tip and of every link between it and what the hub hangs on, too.

        In that link's axes. Its power per joint rate of the limb is added to `entries`.
        """
        common = self.tree.common(cut.tip, cut.hub)
        if cut.tip == common:
            return {}
        placed = self.placed[cut.tip]
        force, moment = row.force, add(row.couple, cross(cut.tip_point, row.force))
        below = self._push(entries, cut.tip, placed.before(force), placed.before(moment), 1, common)
        return {cut.tip: (force, moment), **below}

    def _outwards(self, index: int, force: Vector, moment: Vector) -> Wrench:
        """A wrench at the origin of a link's parent as one at the link's, in the axes before its motion."""
        placed = self.placed[index]
        back = transpose(placed.rotation)
        return transform(back, force), transform(back, subtract(moment, cross(placed.offset, force)))

    def _push(
        self, entries: dict, index: int, force: Vector, moment: Vector, sign: int, inside: int
    ) -> dict[int, Wrench]:
        """Push a unit wrench from a link (axes before its motion) to link `inside`, noting S . w of each row.

        Returns the wrench at the origin of every link inside it, in that link's axes.
        """
        below: dict[int, Wrench] = {}
        while True:
            link, frame, placed = self.tree.links[index], self.frames[index], self.placed[index]
            values = link.pair.powers(frame, force, moment)
            for k, value in zip(range(link.v.start, link.v.stop), values, strict=True):
                entries[k] = entries.get(k, self.tape.zero) + sign * self.tape.node(value)
            force = transform(placed.rotation, force)
            moment = add(transform(placed.rotation, moment), cross(placed.offset, force))
            index = link.parent
            below[index] = force, moment
            if index == inside:
                return below
            force, moment = self.placed[index].before(force), self.placed[index].before(moment)

    def bias(self, rate: Sequence[Rates]) -> list[Node]:
        """(dJ/dt) v per row, from rates taken at zero accelerations of the tree."""
        return [value for cut in self.cuts for value in closure_bias(cut, self.tree, self.placed, self.twist, rate)]

    @cached_property
    def residual(self) -> list[Node]:
        """How far the loops are open, one number per row."""
        return [
            value
            for cut in self.cuts
            for value in closure_residual(cut, self.tree, self.placed, self.pose, self.geometry)
        ]

    def joint_rates(self, v: Sequence[Node]) -> list[Node]:
        """w from v: spherical rates turned into the axes before the rotation."""
        result = list(v)
        for link in self.tree.links[1:]:
            result[link.v] = link.pair.joint_rates(self.placed[link.index], v[link.v])
        return result

    def tree_rates(self, w: Sequence[Node]) -> list[Node]:
        """v from w."""
        result = list(w)
        for link in self.tree.links[1:]:
            result[link.v] = link.pair.tree_rates(self.placed[link.index], w[link.v])
        return result

    # -- consistent states at which pivots are chosen --------------------------------------------------------

    @cached_property
    def reference(self) -> np.ndarray:
        """q in the reference configuration, shape (nq,)."""
        q = np.zeros(len(self.tree.q))
        for link in self.tree.links[1:]:
            given = self.tree.joints[link.joint].reference
            value = float(self.mechanism.number(given[link.position])) if link.position < len(given) else 0.0
            q[link.q] = link.pair.reference(value)
        return q

    @cached_property
    def parameters(self) -> tuple[Node, ...]:
        """Input nodes of the run-time parameters, in the order of the description."""
        return tuple(self.geometry.parameters[p.symbol] for p in self.mechanism.parameters.values() if p.run_time)

    @cached_property
    def parameter_values(self) -> np.ndarray:
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

    def numeric(self, nodes: Sequence[Node], *inputs: tuple[Sequence[Node], np.ndarray]) -> np.ndarray:
        """Values of `nodes` for arrays (samples, n) of the given input nodes; run-time parameters default."""
        pairs = [*inputs, (self.parameters, self.parameter_values)] if self.parameters else list(inputs)
        ports = tuple(Port(f"x{i}", (len(n),), (), (), "") for i, (n, _) in enumerate(pairs))
        function = Function(
            "numeric",
            "",
            ports,
            (Port("y", (len(nodes),), (), (), ""),),
            tuple(tuple(n) for n, _ in pairs),
            (tuple(nodes),),
        )
        return evaluate(lower(function), [a for _, a in pairs])[0][0]

    def dense_jacobian(self) -> list[Node]:
        """The closure Jacobian in w as a full matrix, row-major."""
        n = len(self.tree.v)
        return [row.get(k, self.tape.zero) for row in self.jacobian for k in range(n)]

    def advance(self, q: np.ndarray, step: np.ndarray) -> np.ndarray:
        """q moved along joint rates w (spherical: rotation vector in the axes before the rotation)."""
        moved = np.array(q, dtype=float)
        for link in self.tree.links[1:]:
            moved[..., link.q] = link.pair.moved(q[..., link.q], step[..., link.v])
        return moved

    @cached_property
    def sample_states(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Consistent (q, v, a): first the reference configuration, then others near it; shapes (samples, n).

        The same bits on every machine: they choose pivots and stand in what is generated.
        """
        return self.states(SAMPLES, SEED)

    def states(self, count: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The reference configuration and `count` random ones near it with consistent v, a; shapes (1 + count, n)."""
        random = np.random.default_rng(seed)
        scales = np.array([self.length if c.kind == "length" else 1.0 for c in self.tree.v])
        start = self.reference[None, :]
        q = np.repeat(start, count, axis=0)
        q = self.advance(q, 0.15 * scales * random.uniform(-1, 1, (count, len(scales))))
        if self.cuts:
            q = self.closed(q, scales)
        q = np.concatenate([start, q])
        v, a = self._consistent(q, scales, random)
        return q, v, a

    def closed(self, q: np.ndarray, scales: np.ndarray) -> np.ndarray:
        """Gauss-Newton onto the closure manifold; states that do not get there are replaced by others."""
        n = len(scales)
        for _ in range(60):
            both = self.numeric([*self.residual, *self.dense_jacobian()], (self.inputs.q, q))
            residual, jacobian = both[:, : len(self.residual)], both[:, len(self.residual) :]
            open_still = np.abs(residual).max(axis=1) >= 1e-14 * max(1.0, self.length)
            if not open_still.any():
                break
            for i in np.flatnonzero(open_still):
                step = least_norm(jacobian[i].reshape(-1, n) * scales, -residual[i])
                limit = max(1.0, np.abs(step).max() / 0.3)
                q[i] = self.advance(q[i], scales * step / limit)
        residual = self.numeric(self.residual, (self.inputs.q, q))
        good = np.abs(residual).max(axis=1) < 1e-11 * max(1.0, self.length)
        if not good.any():
            return np.repeat(self.reference[None, :], len(q), axis=0)
        return q[np.resize(np.flatnonzero(good), len(q))]

    def _consistent(
        self, q: np.ndarray, scales: np.ndarray, random: np.random.Generator
    ) -> tuple[np.ndarray, np.ndarray]:
        """Random rates in the null space of the closure, and accelerations that fit them."""
        n = len(scales)
        w = random.uniform(-1, 1, (len(q), n)) * scales
        gain = random.uniform(-1, 1, (len(q), n)) * scales
        if not self.cuts:
            return w, gain
        jacobian = self.numeric(self.dense_jacobian(), (self.inputs.q, q)).reshape(len(q), -1, n)
        for i, j in enumerate(jacobian):
            w[i] -= scales * least_norm(j * scales, (j * w[i]).sum(axis=1))
        v = self.numeric(self.tree_rates(self.inputs.v), (self.inputs.q, q), (self.inputs.v, w))
        zero = [self.tape.zero] * n
        bias = self.numeric(self.bias(self.rates(zero)), (self.inputs.q, q), (self.inputs.v, v))
        for i, j in enumerate(jacobian):
            gain[i] -= scales * least_norm(j * scales, (j * gain[i]).sum(axis=1) + bias[i])
        a = self.numeric(self.tree_rates(self.inputs.v), (self.inputs.q, q), (self.inputs.v, gain))
        return v, a

    def use_samples(self) -> None:
        """Give the tape's inputs their values at the sample states."""
        q, v, a = self.sample_states
        values = {}
        for nodes, array in ((self.inputs.q, q), (self.inputs.v, v), (self.inputs.a, a)):
            values.update({node: array[:, k] for k, node in enumerate(nodes)})
        for node, value in zip(self.parameters, self.parameter_values, strict=True):
            values[node] = np.full(len(q), value)
        self.tape.set_samples(values)


def characteristic_length(mechanism: Mechanism) -> float:
    """The length [m] by which norms of mixed quantities divide lengths: the description's, if it gives one.

    Else the root mean square distance of the joints' points and the named points from their centre: invariant
    under rigid motions, proportional to the unit; 1 where all points coincide.
    """
    if mechanism.characteristic_length is not None:
        return float(mechanism.number(mechanism.characteristic_length))
    points = [[float(mechanism.number(c)) for c in joint.point] for joint in mechanism.joints.values()]
    points += [[float(mechanism.number(c)) for c in p.at] for p in mechanism.points.values()]
    cloud = np.array(points)
    size = float(np.sqrt(((cloud - cloud.mean(axis=0)) ** 2).sum(axis=1).mean())) if len(cloud) else 0.0
    # Rounded, so that the same description gives the same bytes on every machine.
    return float(f"{size:.6g}") if size > 0 else 1.0
