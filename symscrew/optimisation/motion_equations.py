"""The equations that a motion must obey at one time, as one straight-line program: closure and dynamics.

The configuration follows from the independent coordinates y and the others, z. Where limbs have closed forms z
are the rest of the platform's own coordinates, else the rest of the tree's. What is constant in the operation mode of
the reference configuration (a delta's platform does not turn) is no unknown: motions of that mode alone need no more.
The equations of motion are projected onto the directions that the loops leave free (columns N of the null space of
the closure),

    N^T (M a + bias - forces of drives and effects) = 0,

one per freedom: no multiplier is left, nothing is divided by a pivot of the drives. So they hold
for redundant drives, for passive freedoms and in singularities of the drives alike.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from symscrew.algebra import Node
from symscrew.description import Mechanism
from symscrew.dynamics import Admissible, generalised_forces
from symscrew.effects import Acting, Effect, system_under
from symscrew.errors import DescriptionError
from symscrew.functions import (
    Equations,
    Motion,
    accelerates,
    all_reactions,
    driven,
    effect_functions,
    function,
    kinematic_functions,
    margin_functions,
    moved_by,
)
from symscrew.kinematics import System
from symscrew.loops import (
    OFF,
    Loops,
    Mode,
    closed_limbs,
    closures,
    hub_links,
    limb_coordinates,
    met_rows,
    operation_mode,
)
from symscrew.program import Function, Port, Program, lower


@dataclass(frozen=True)
class Layout:
    """Which entries of q are y and z, and whether limbs are solved in closed form.

    `y`, `z`: indices into q; `closed`: q follows from the platform's entries by the limbs' closed forms.
    """

    y: tuple[int, ...]
    z: tuple[int, ...]
    closed: bool


class PointEquations:
    """System, independent coordinates and the programs of a trajectory problem, each derived when it is asked for.

    `loops` are those of the plain tree; `labels` the labels of y; `one_mode`: for motions of the operation mode of the
    reference configuration only, see `off_mode`.
    """

    def __init__(
        self,
        mechanism: Mechanism,
        effects: Sequence[Effect],
        independent: Sequence[str] | None = None,
        *,
        one_mode: bool = False,
    ) -> None:
        self.effects, self.one_mode = tuple(effects), one_mode
        self.system = system_under(mechanism, self.effects)
        self.system.use_samples()
        self.loops = Loops(self.system, independent)
        self.acting, self.drives = driven(self.system, self.effects)
        self._lowered: dict[str, Program] = {}
        for effect in self.effects:
            if effect.contacts():
                raise DescriptionError(
                    f"effects: {type(effect).__name__} switches by events, which an optimiser cannot differentiate; "
                    "take its regularised mode"
                )
            if effect.rolled(mechanism):
                raise DescriptionError(
                    f"effects: {type(effect).__name__} constrains rates alone, which the equations of an optimal "
                    "motion do not hold between their points; take 'rolling_contact'"
                )

    @property
    def labels(self) -> tuple[str, ...]:
        """Labels of the independent coordinates y."""
        return self.loops.labels

    @cached_property
    def accelerates(self) -> bool:
        """Whether accelerations follow from forces, so that a plan can be replayed: not without mass."""
        return accelerates(self.system, self.effects, self.loops)

    @cached_property
    def layout(self) -> Layout:
        """How q is made of y and z."""
        y = tuple(entry.q for entry in self.loops.entries)
        closed = bool(self._hub) and set(y) <= set(self._hub)
        entries = self._hub if closed else range(len(self.system.tree.q))
        return Layout(y, tuple(k for k in entries if k not in y and k not in self.constant), closed)

    @cached_property
    def _hub(self) -> tuple[int, ...]:
        """Entries of q that place the platform, where limbs that have closed forms hang on it; else empty."""
        hub = hub_links(self.system)
        if hub is None or closed_limbs(self.system) is None:
            return ()
        return tuple(k for link in hub for k in range(link.q.start, link.q.stop))

    @cached_property
    def _mode(self) -> Mode:
        """What the operation mode of the reference configuration makes follow."""
        return operation_mode(self.system, self.loops.free)

    @cached_property
    def constant(self) -> Mapping[int, float]:
        """Index into q -> value of what is constant of the platform [1, rad, m]; empty unless for one mode."""
        hub = self._hub if self.one_mode else ()
        return {f.index: f.shift for f in self._mode.q if f.leader is None and f.index in hub}

    def off_mode(self, q: np.ndarray) -> bool:
        """Whether any of the configurations q (n, nq) is not of the operation mode that the equations are for."""
        held = self.constant
        return bool(held) and not bool((np.abs(q[:, list(held)] - list(held.values())) < OFF).all())

    @cached_property
    def _placed(self) -> tuple[System, dict[int, tuple[Node, Node]], Loops]:
        """The system at q from y and z, cosines and sines that are known, and its loops."""
        if not self.layout.closed:
            return self.system, {}, self.loops
        own: dict[int, Node] = {k: self.system.inputs.q[k] for k in (*self.layout.y, *self.layout.z)}
        own |= {k: self.system.tape.constant(value) for k, value in self.constant.items()}
        found = limb_coordinates(self.system, closed_limbs(self.system) or (), own)
        placed = self.system.at(found.q, found.turns)
        closure = next(closures(placed))
        if self.constant:  # their rates are none: the coordinates themselves stand in the rows already
            still = tuple(f for f in self._mode.v if f.leader is None)
            closure = replace(closure, mode=Mode(placed, (), still, self._mode.free))
        return placed, found.turns, Loops(placed, self.labels if self.loops.entries else None, closure)

    @cached_property
    def _moving(self) -> tuple[System, tuple[Node, ...], tuple[Node, ...]]:
        """The system with v and a put in from the rates of y, which are returned too."""
        placed, turns, loops = self._placed
        y_dot, y_ddot = loops.inputs("ydot"), loops.inputs("yddot")
        v = placed.tree_rates(loops.rates_from(y_dot))
        at = placed.at(placed.inputs.q, turns, v)
        bias = at.bias(at.rates([at.tape.zero] * len(v)))
        a = placed.tree_rates(loops.accelerations_from(y_ddot, bias, at.joint_rates(v)))
        return placed.at(placed.inputs.q, turns, v, a), y_dot, y_ddot

    def _configuration(self) -> list[tuple[Port, Sequence[Node]]]:
        q = self.system.inputs.q
        parts = (("y", self.layout.y), ("z", self.layout.z))
        return [(_plain(name, len(at)), [q[k] for k in at]) for name, at in parts]

    @cached_property
    def closure(self) -> Program:
        """(y, z) -> q, closure, implied: what y and z must satisfy, without units, as many rows as z has entries.

        `implied` are rows that hold in the operation mode for any y and z: plans are judged by them, too.
        """
        placed, _, loops = self._placed
        system, tape = self.system, self.system.tape
        redundant = set((self.loops if self.constant else loops).elimination.redundant)  # not what the mode makes so
        met = met_rows(closed_limbs(system) or ()) if self.layout.closed else frozenset()
        rows = [row for cut in placed.cuts for row in cut.rows]
        values: list[Node] = []
        for k, (row, value) in enumerate(zip(rows, placed.residual, strict=True)):
            if k in redundant or row.label in met:
                continue
            values.append(value * tape.constant(1.0 / system.length) if row.unit == "N" else value)
        for link in system.tree.links[1:]:
            if link.motion.spherical and {*range(link.q.start, link.q.stop)} & {*self.layout.z, *self.layout.y}:
                values.append(sum((c * c for c in placed.inputs.q[link.q]), start=tape.zero) - tape.one)
        implied = [value for value in values if self.constant and self._mode.closes(value)]
        values = [value for value in values if value not in implied]
        if len(values) != len(self.layout.z):
            raise DescriptionError(
                f"the loops give {len(values)} equations for {len(self.layout.z)} dependent coordinates; the closure "
                "is not regular here"
            )
        parts = (("q", placed.inputs.q), ("closure", values), ("implied", implied))
        outputs = [(_plain(name, len(nodes)), nodes) for name, nodes in parts]
        return lower(function(system, "closure_point", "", inputs=self._configuration(), outputs=outputs))

    @cached_property
    def step(self) -> Program:
        """(q, y) -> step: the Newton step in joint rates that closes the loops and moves to y."""
        wanted = self.loops.inputs("y")
        outputs = [(_plain("step", len(self.system.tree.v)), self.loops.newton_step(wanted))]
        inputs = [(_plain("q", len(self.system.inputs.q)), self.system.inputs.q), (_plain("y", len(wanted)), wanted)]
        return lower(function(self.system, "newton_step", "", inputs=inputs, outputs=outputs))

    @cached_property
    def move(self) -> Program:
        """(q, y) -> q_next: a whole Newton step that closes the loops and moves to y."""
        wanted = self.loops.inputs("y")
        moved = moved_by(self.system, self.loops.newton_step(wanted))
        inputs = [(_plain("q", len(self.system.inputs.q)), self.system.inputs.q), (_plain("y", len(wanted)), wanted)]
        return lower(
            function(self.system, "newton_move", "", inputs=inputs, outputs=[(_plain("q_next", len(moved)), moved)])
        )

    @cached_property
    def pivots(self) -> Program:
        """(q) -> pivots of the closure's elimination without units: one near 0 means singular coordinates y."""
        values = [guard.pivot * self.system.tape.constant(guard.scale) for guard in self.loops.guards]
        inputs = [(_plain("q", len(self.system.inputs.q)), self.system.inputs.q)]
        return lower(
            function(self.system, "pivots", "", inputs=inputs, outputs=[(_plain("pivots", len(values)), values)])
        )

    @cached_property
    def motion(self) -> Program:
        """(y, z, y_dot, y_ddot) -> v, a."""
        moving, y_dot, y_ddot = self._moving
        outputs = [
            (_plain("v", len(moving.inputs.v)), moving.inputs.v),
            (_plain("a", len(moving.inputs.a)), moving.inputs.a),
        ]
        return lower(
            function(
                self.system, "motion_point", "", inputs=[*self._state(y_dot), _port("y_ddot", y_ddot)], outputs=outputs
            )
        )

    def _state(self, y_dot: Sequence[Node]) -> list[tuple[Port, Sequence[Node]]]:
        return [*self._configuration(), _port("y_dot", y_dot)]

    @cached_property
    def dynamics(self) -> Program:
        """(y, z, y_dot, y_ddot, u, ...) -> residual of the projected equations of motion, x_dot."""
        moving, y_dot, y_ddot = self._moving
        placed, _, loops = self._placed
        system, tape = self.system, self.system.tape
        acting = self._acting(moving)
        force = generalised_forces(moving, acting, moving.inputs.a)
        columns = Admissible(placed, loops).tree_columns
        residual = [sum((n * f for n, f in zip(c, force, strict=True)), start=tape.zero) for c in columns]
        rates = [acting.state_rates[s.name] for s in acting.states]
        inputs = [*self._state(y_dot), _port("y_ddot", y_ddot), *self.drives, *acting.inputs]
        outputs = [(_plain("residual", len(residual)), residual), (_plain("x_dot", len(rates)), rates)]
        return lower(function(system, "dynamics_point", "", inputs=inputs, outputs=outputs))

    @cached_property
    def carried(self) -> Program:
        """(y, z, y_dot) -> carried: what the motion gives the states at the start beside their initial values."""
        moving, y_dot, _ = self._moving
        states = self._acting(moving).states
        values = [moving.tape.zero if state.carried is None else state.carried for state in states]
        outputs = [(_plain("carried", len(values)), values)]
        return lower(function(self.system, "carried_point", "", inputs=self._state(y_dot), outputs=outputs))

    def _acting(self, moving: System) -> Acting:
        acting, drives = driven(moving, self.effects)
        loads = None
        for _ in range(acting.passes if acting.needs_reactions else 0):
            before = Equations(moving, self.effects, loads, unloaded=loads is None)
            nodes = drives[0][1] if drives else ()
            forces = tuple(acting.drive_force(k, node) for k, node in enumerate(nodes))
            loads = before.estimate(before.reactions(forces))
            acting, drives = driven(moving, self.effects, loads)
        return acting

    @cached_property
    def forward(self) -> Program:
        """(y, z, y_dot, u, ...) -> y_ddot by forward dynamics, x_dot."""
        placed, turns, loops = self._placed
        y_dot = loops.inputs("ydot")
        w = loops.rates_from(y_dot)
        v = placed.tree_rates(w)
        moving = placed.at(placed.inputs.q, turns, v)
        if self.acting.needs_reactions:
            raise DescriptionError(
                "transcription.formulation: an effect that depends on the joints' loads needs the inverse formulation"
            )
        acting, _ = driven(moving, self.effects)
        free, a, _ = Admissible(moving, loops, acting.added_inertia).accelerations(acting)
        y_ddot = loops.second_rates(free, moving.joint_rates(a), w)
        rates = [acting.state_rates[s.name] for s in acting.states]
        inputs = [*self._state(y_dot), *self.drives, *acting.inputs]
        outputs = [_port("y_ddot", y_ddot), (_plain("x_dot", len(rates)), rates)]
        return lower(function(self.system, "forward_point", "", inputs=inputs, outputs=outputs))

    @cached_property
    def given_functions(self) -> Program | None:
        """(q, ...) -> values of what effects' texts say of time and coordinates; None without any."""
        values, q = self.acting.given_functions, self.system.inputs.q
        if not values:
            return None
        inputs = [(_plain("q", len(q)), q), *self.acting.inputs_of(values)]
        outputs = [(_plain("values", len(values)), values)]
        return lower(function(self.system, "given_functions", "", inputs=inputs, outputs=outputs))

    @cached_property
    def reactions(self) -> Program:
        """(q, v, a, u, ...) -> reactions of all joints (f ; m_O) for given drives."""
        at = self.system.inputs
        acting, drives = driven(self.system, self.effects)
        nodes = drives[0][1] if drives else ()
        loads = None
        for _ in range(acting.passes if acting.needs_reactions else 0):
            before = Equations(self.system, self.effects, loads, unloaded=loads is None)
            loads = before.estimate(before.reactions([acting.drive_force(k, n) for k, n in enumerate(nodes)]))
            acting, _ = driven(self.system, self.effects, loads)
        equations = Equations(self.system, self.effects, loads)
        forces = [equations.forces.drive_force(k, node) for k, node in enumerate(nodes)]
        port, values, _, _ = all_reactions(equations, forces)
        state = [(_plain(n, len(x)), x) for n, x in (("q", at.q), ("v", at.v), ("a", at.a))]
        inputs = [*state, *drives, *acting.inputs]
        return lower(function(self.system, "reactions_point", "", inputs=inputs, outputs=[(port, values)]))

    @cached_property
    def _kinematics(self) -> dict[str, Function]:
        return {f.name: f for f in kinematic_functions(self.system, Motion(self.system))}

    @cached_property
    def _margins(self) -> dict[str, Function]:
        return {f.name: f for f in margin_functions(self.system)}

    @cached_property
    def _effects(self) -> dict[str, Function]:
        return {f.name: f for f in effect_functions(self.system, self.effects, self.loops)}

    @cached_property
    def effect_rates(self) -> Program | None:
        """(q, v, x, ...) -> x_dot; None without states."""
        found = self._effects.get("effect_state_rates")
        return lower(found) if found else None

    def tree_function(self, name: str) -> Program:
        """A kinematic function of the model by name, of q, v and a; drive rates are those of the motors' sides."""
        if name not in self._lowered:
            found = self._effects.get(name) if name == "drive_rates" else None
            self._lowered[name] = lower(found or self._kinematics[name])
        return self._lowered[name]

    @cached_property
    def margins(self) -> list[Program]:
        """The singularity margins of q."""
        return [lower(f) for f in self._margins.values()]


def _plain(name: str, size: int) -> Port:
    return Port(name, (size,), ("1",) * size, (), name)


def _port(name: str, nodes: Sequence[Node]) -> tuple[Port, Sequence[Node]]:
    return _plain(name, len(nodes)), nodes
