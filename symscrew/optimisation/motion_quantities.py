"""Quantities of a motion at one time, as CasADi expressions of the unknowns there.

blocks (y, y', y'', z, u ... by relative time) --programs of the mechanism--> q, v, points, reactions, margins
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import casadi as ca

from symscrew.errors import DescriptionError
from symscrew.functions import moving_bodies
from symscrew.kinematics import identifiers
from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import TrajectoryProblem, fixed_duration
from symscrew.program import Port


class MotionQuantities:
    """Expressions at one point, each made when it is asked for."""

    def __init__(self, model: PointModel, blocks: Mapping[str, ca.SX]) -> None:
        self.model, self.blocks = model, blocks
        problem = model.problem
        self.T = blocks["T"] if problem.free_duration else ca.SX(model.number("duration", fixed_duration))
        self.y, self.z = blocks["y"], blocks["z"]
        self.y_dot = blocks["y_1"] / self.T
        self.y_ddot = blocks["y_2"] / self.T**2 if "y_2" in blocks else ca.SX(0, 1)
        self.known: dict[str, Any] = {
            "y": self.y, "z": self.z, "y_dot": self.y_dot, "y_ddot": self.y_ddot, "t": blocks["tau"] * self.T,
            "u": blocks.get("u", ca.SX(0, 1)), "x": blocks.get("x", ca.SX(0, 1)), "p": self._parameters(),
        }  # fmt: skip
        for port, _ in model.equations.acting.own_inputs:
            self.known[port.name] = ca.vertcat(ca.SX(0, 1), *[self._input(port, k) for k in range(port.size)])

    def _input(self, port: Port, k: int) -> ca.SX:
        def get(problem: TrajectoryProblem) -> float:
            return float(problem.inputs.get(port.name, (0.0,) * port.size)[k])

        return ca.SX(self.model.number(f"input {port.name}[{k}]", get))

    def _parameters(self) -> ca.SX:
        model, values = self.model, []
        defaults = {p.name: float(p.value) for p in model.system.mechanism.parameters.values()}
        for name in model.parameter_names:
            if name in model.design:
                values.append(self.blocks["p"][model.design.index(name)])
            else:

                def get(problem: TrajectoryProblem, name: str = name) -> float:
                    return problem.parameters.get(name, defaults[name])

                values.append(ca.SX(model.number(f"parameter {name}", get)))
        return ca.vertcat(ca.SX(0, 1), *values)

    # -- quantities ---------------------------------------------------------------------------------------------

    @cached_property
    def _closed(self) -> dict[str, ca.SX]:
        return symbolic_outputs(self.model.equations.closure, self.known)

    @property
    def q(self) -> ca.SX:
        """Configuration of the tree."""
        return self._closed["q"]

    @property
    def opening(self) -> ca.SX:
        """What the closure lacks, without units: as many rows as z has entries."""
        return self._closed["closure"]

    @cached_property
    def _moving(self) -> dict[str, ca.SX]:
        known = dict(self.known)
        if known["y_ddot"].numel() == 0:
            known["y_ddot"] = ca.SX.zeros(self.model.d)
        return symbolic_outputs(self.model.equations.motion, known)

    def of_tree(self, name: str) -> dict[str, ca.SX]:
        """Outputs of a kinematic function of the model."""
        program = self.model.equations.tree_function(name)
        wanted = {port.name for port in program.inputs}
        known = {**self.known, "q": self.q} | ({**self._moving} if wanted & {"v", "a"} else {})
        return symbolic_outputs(program, known)

    @cached_property
    def drive_rates(self) -> ca.SX:
        """Rates of the drives."""
        return self.of_tree("drive_rates")["rates"]

    @cached_property
    def coordinates(self) -> dict[str, Any]:
        """Every coordinate that a condition or bound may name."""
        model = self.model
        result = {label: self.y[k] for k, label in enumerate(model.equations.labels)}
        for k, c in enumerate(model.system.tree.q):
            result.setdefault(c.label, self.q[k])
        missing = [label for label in model.joint_labels if label not in result]
        if missing:
            every = self.of_tree("joint_displacements")["displacements"]
            for k, label in enumerate(model.joint_labels):
                result.setdefault(label, every[k])
        return result

    def rate(self, label: str) -> Any:
        """Rate of a coordinate."""
        labels = self.model.equations.labels
        if label in labels:
            return self.y_dot[labels.index(label)]
        return self._joint_rates[self.model.joint_labels.index(label)]

    @cached_property
    def _joint_rates(self) -> ca.SX:
        return self.of_tree("joint_rates")["rates"]

    @cached_property
    def points(self) -> dict[str, ca.SX]:
        """Positions of the named points [m], absolute axes."""
        values = self.of_tree("forward_kinematics")["positions"]
        return {name: values[3 * k : 3 * k + 3] for k, name in enumerate(self.model.system.mechanism.points)}

    @cached_property
    def reactions(self) -> ca.SX:
        """Wrenches (f ; m_O) of all joints."""
        return symbolic_outputs(self.model.equations.reactions, {**self.known, "q": self.q, **self._moving})[
            "reactions"
        ]

    @cached_property
    def margins(self) -> dict[str, Any]:
        """Singularity margins by name."""
        result: dict[str, Any] = {}
        for program in self.model.equations.margins:
            values = symbolic_outputs(program, {**self.known, "q": self.q})["margins"]
            result |= {label: values[k] for k, label in enumerate(program.outputs[0].labels)}
        return result

    @cached_property
    def platform_pose(self) -> tuple[ca.SX, ca.SX]:
        """Rotation and translation of the platform from the reference configuration."""
        platform = self.model.system.mechanism.platform
        if platform is None:
            raise DescriptionError("conditions on the platform: this mechanism names no platform")
        return self.body_pose(platform)

    @cached_property
    def _poses(self) -> ca.SX:
        return self.of_tree("body_poses")["poses"]

    def body_pose(self, body: str) -> tuple[ca.SX, ca.SX]:
        """Rotation and translation of a body from the reference configuration."""
        at = moving_bodies(self.model.system).index(body)
        values = self._poses[12 * at : 12 * at + 12]
        return ca.reshape(values[:9], 3, 3), values[9:]

    @cached_property
    def _twists(self) -> ca.SX:
        return self.of_tree("body_twists")["twists"]

    def body_twist(self, body: str) -> ca.SX:
        """Twist (omega ; v_O) of a body."""
        at = moving_bodies(self.model.system).index(body)
        return self._twists[6 * at : 6 * at + 6]

    @property
    def names(self) -> dict[str, Any]:
        """What an expression of a user may name: t, T, q_, v_, u_ and the parameters."""
        model = self.model
        result: dict[str, Any] = {"t": self.known["t"], "T": self.T}
        tree = model.system.tree
        for prefix, labels, values in (
            ("q", [c.label for c in tree.q], self.q),
            ("v", [c.label for c in tree.v], self._moving["v"]),
            ("u", model.drive_labels, self.blocks["u"]),
        ):
            found = identifiers(labels)
            result |= {f"{prefix}_{found[label]}": values[k] for k, label in enumerate(labels)}
        result |= (
            {f"{name}_{axis}": at[k] for name, at in self.points.items() for k, axis in enumerate("xyz")}
            if model.system.mechanism.points
            else {}
        )
        return result | self.parameters

    @property
    def parameters(self) -> dict[str, Any]:
        """Parameters that are inputs, by name."""
        return {name: self.known["p"][k] for k, name in enumerate(self.model.parameter_names)}
