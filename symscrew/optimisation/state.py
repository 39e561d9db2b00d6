"""Quantities of a motion at one time as CasADi expressions, and the constraints and costs made of them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError, did_you_mean
from symscrew.functions import moving_bodies
from symscrew.optimisation.casadi_graph import run
from symscrew.optimisation.problem import Conditions, Objective
from symscrew.optimisation.rows import INFINITY, Row
from symscrew.optimisation.terms import expression

if TYPE_CHECKING:
    from symscrew.optimisation.point import PointModel

FORWARDS = (0.5, 1.5)  # of a cosine that is 1 where a direction is met: it tells the direction from its opposite


class State:
    """Expressions at one point, made when they are asked for."""

    def __init__(self, model: PointModel, blocks: Mapping[str, ca.SX]) -> None:
        self.model, self.blocks = model, blocks
        problem = model.problem
        fixed = problem.duration if isinstance(problem.duration, int | float) else None
        self.T = ca.SX(float(fixed)) if fixed is not None else blocks["T"]
        self.y, self.z = blocks["y"], blocks["z"]
        self.y_dot = blocks["y_1"] / self.T
        self.y_ddot = blocks["y_2"] / self.T**2 if "y_2" in blocks else ca.SX(0, 1)
        self.known: dict[str, Any] = {
            "y": self.y, "z": self.z, "y_dot": self.y_dot, "y_ddot": self.y_ddot, "t": blocks["tau"] * self.T,
            "u": blocks.get("u", ca.SX(0, 1)), "x": blocks.get("x", ca.SX(0, 1)), "p": self._parameters(),
        }  # fmt: skip
        for port, _ in model.equations.acting.own_inputs:
            self.known[port.name] = ca.DM(problem.inputs.get(port.name, (0.0,) * port.size))

    def _parameters(self) -> ca.SX:
        model, values = self.model, []
        defaults = {p.name: float(p.value) for p in model.system.mechanism.parameters.values()}
        for name in model.parameter_names:
            if name in model.design:
                values.append(self.blocks["p"][model.design.index(name)])
            else:
                values.append(ca.SX(model.problem.parameters.get(name, defaults[name])))
        return ca.vertcat(ca.SX(0, 1), *values)

    # -- quantities ---------------------------------------------------------------------------------------------

    @cached_property
    def _closed(self) -> dict[str, ca.SX]:
        return run(self.model.equations.closure, self.known)

    @property
    def q(self) -> ca.SX:
        """Configuration of the tree."""
        return self._closed["q"]

    @cached_property
    def _moving(self) -> dict[str, ca.SX]:
        known = dict(self.known)
        if known["y_ddot"].numel() == 0:
            known["y_ddot"] = ca.SX.zeros(self.model.d)
        return run(self.model.equations.motion, known)

    def of_tree(self, name: str) -> dict[str, ca.SX]:
        """Outputs of a kinematic function of the model."""
        program = self.model.equations.tree_function(name)
        wanted = {port.name for port in program.inputs}
        known = {**self.known, "q": self.q} | ({**self._moving} if wanted & {"v", "a"} else {})
        return run(program, known)

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
    def _points(self) -> dict[str, ca.SX]:
        values = self.of_tree("forward_kinematics")["positions"]
        return {name: values[3 * k : 3 * k + 3] for k, name in enumerate(self.model.system.mechanism.points)}

    @cached_property
    def reactions(self) -> ca.SX:
        """Wrenches (f ; m_O) of all joints."""
        return run(self.model.equations.reactions, {**self.known, "q": self.q, **self._moving})["reactions"]

    @cached_property
    def margins(self) -> dict[str, Any]:
        """Singularity margins by name."""
        result: dict[str, Any] = {}
        for program in self.model.equations.margins:
            values = run(program, {**self.known, "q": self.q})["margins"]
            result |= {label: values[k] for k, label in enumerate(program.outputs[0].labels)}
        return result

    @cached_property
    def _pose(self) -> tuple[ca.SX, ca.SX]:
        """Rotation and translation of the platform from the reference configuration."""
        platform = self.model.system.mechanism.platform
        if platform is None:
            raise DescriptionError("conditions on the platform: this mechanism names no platform")
        at = moving_bodies(self.model.system).index(platform)
        values = self.of_tree("body_poses")["poses"][12 * at : 12 * at + 12]
        return ca.reshape(values[:9], 3, 3), values[9:]

    # -- rows -----------------------------------------------------------------------------------------------------

    def closure_rows(self, where: str = "") -> list[Row]:
        """The loops are closed, quaternions have unit length."""
        values = self._closed["closure"]
        suffix = f" at {where}" if where else ""
        return [Row(f"closure of the loops, row {k + 1}{suffix}", values[k]) for k in range(values.numel())]

    def dynamic_rows(self) -> list[Row]:
        """Equations of motion and of the effects' states."""
        model, scales = self.model, self.model.scales
        labels = model.equations.labels
        if model.problem.transcription.formulation == "forward":
            found = run(model.equations.forward, self.known)
            # times T^2, so that the row has the size of y
            error = (self.y_ddot - found["y_ddot"]) * self.T**2
            rows = [
                Row(f"equation of motion along {label}", error[k], scale=float(scales.y[k]))
                for k, label in enumerate(labels)
            ]
        else:
            found = run(model.equations.dynamics, self.known)
            rows = [
                Row(f"equation of motion {k + 1}", found["residual"][k], scale=float(scales.force[k]))
                for k in range(model.d)
            ]
            self.residual = found["residual"]
        for k, name in enumerate(model.states):
            value = self.blocks["x_1"][k] - self.T * found["x_dot"][k]
            rows.append(Row(f"rate of the state {name}", value, scale=float(scales.x[k])))
        return rows

    def rule_rows(self) -> list[Row]:
        """Redundant drives by least squares about the preload: u - preload lies in the range of the drives' rates."""
        model = self.model
        if model.problem.drive_rule != "least_squares":
            return []
        u = self.blocks["u"]
        residual = run(model.equations.dynamics, self.known)["residual"]
        matrix = ca.jacobian(residual, u)
        about = ca.DM([model.problem.preload.get(label, 0.0) for label in model.drive_labels])
        values = u - about - matrix.T @ self.blocks["distribution"]
        return [
            Row(f"least-squares rule of drive {label}", values[k], scale=float(model.scales.u[k]))
            for k, label in enumerate(model.drive_labels)
        ]

    def bound_rows(self) -> list[Row]:
        """Bounds that are not those of an unknown itself."""
        bounds, scales = self.model.problem.bounds, self.model.scales
        length = self.model.system.length
        rows = []
        for label, (low, high) in bounds.joints.items():
            rows.append(Row(f"travel of {label}", self.coordinates[label], low, high))
        for label, (low, high) in bounds.speeds.items():
            rows.append(Row(f"speed of {label}", self.rate(label), low, high, 1.0 / scales.duration))
        for name, (low, high) in bounds.margins.items():
            if name not in self.margins:
                raise DescriptionError(f"bounds.margins: unknown margin {name!r}; {did_you_mean(name, self.margins)}")
            rows.append(Row(f"margin {name}", self.margins[name], low, high))
        for (name, axis), (low, high) in bounds.points.items():
            rows.append(Row(f"{'xyz'[axis]} of point {name}", self._points[name][axis], low, high, length))
        for d in bounds.distances:
            apart = self._points[d.first] - self._points[d.second]
            low, high = max(d.range[0], 0.0), d.range[1]
            what = f"distance of {d.first} and {d.second}"
            rows.append(Row(what, ca.dot(apart, apart), low * low, high * high, length * length))
        for text, (low, high) in bounds.expressions.items():
            value = expression(text, self.names, where="bounds.expressions")
            rows.append(Row(text, value, low, high))
        return rows + self._reaction_rows()

    def _reaction_rows(self) -> list[Row]:
        names, rows = list(self.model.system.mechanism.joints), []
        points = self.of_tree("joint_points")["points"] if self.model.problem.bounds.reactions else None
        for joint, (force, moment) in self.model.problem.bounds.reactions.items():
            at = names.index(joint)
            f, m = self.reactions[6 * at : 6 * at + 3], self.reactions[6 * at + 3 : 6 * at + 6]
            if force is not None:
                rows.append(Row(f"reaction force of {joint}", ca.dot(f, f), -INFINITY, force**2, force**2))
            if moment is not None:
                r = points[3 * at : 3 * at + 3]  # type: ignore[index]
                own = m - ca.cross(r, f)
                rows.append(Row(f"reaction moment of {joint}", ca.dot(own, own), -INFINITY, moment**2, moment**2))
        return rows

    def condition_rows(self, conditions: Conditions, where: str) -> list[Row]:
        """Conditions that need the configuration."""
        rows, length = [], self.model.system.length
        linear = set(self.model.equations.labels)
        for label, value in conditions.coordinates.items():
            if label not in linear:
                rows.append(Row(f"{label} at {where}", self.coordinates[label], value, value))
        for label, value in conditions.rates.items():
            if label not in linear:
                rows.append(Row(f"rate of {label} at {where}", self.rate(label), value, value))
        for name, target in conditions.points.items():
            for axis, place in enumerate(target):
                if place is not None:
                    what = f"{'xyz'[axis]} of point {name} at {where}"
                    rows.append(Row(what, self._points[name][axis], place, place, length))
        if conditions.platform_normal is not None:
            rows += self._normal_rows(np.array(conditions.platform_normal, dtype=float), where)
        if conditions.platform_position is not None:
            for axis, shift in enumerate(conditions.platform_position):
                what = f"{'xyz'[axis]} of the platform at {where}"
                rows.append(Row(what, self._pose[1][axis], shift, shift, length))
        if conditions.platform_rotation is not None:
            goal = _rotation(np.array(conditions.platform_rotation, dtype=float))
            off = ca.DM(goal).T @ self._pose[0]
            for k, (i, j) in enumerate(((2, 1), (0, 2), (1, 0))):
                rows.append(Row(f"rotation {'xyz'[k]} of the platform at {where}", (off[i, j] - off[j, i]) / 2))
            rows.append(Row(f"sense of the platform's rotation at {where}", (ca.trace(off) - 1) / 2, *FORWARDS))
        return rows

    def _normal_rows(self, normal: np.ndarray, where: str) -> list[Row]:
        size = np.linalg.norm(normal)
        if not size > 0:
            raise DescriptionError(f"{where}.platform_normal: expected a direction, got {normal.tolist()}")
        normal = normal / size
        least = np.eye(3)[np.argmin(np.abs(normal))]
        one = np.cross(normal, least)
        one /= np.linalg.norm(one)
        two = np.cross(normal, one)
        up = self._pose[0][:, 2]
        rows = [
            Row(f"platform normal, part {k + 1}, at {where}", ca.dot(ca.DM(e), up)) for k, e in enumerate((one, two))
        ]
        return [*rows, Row(f"sense of the platform normal at {where}", ca.dot(ca.DM(normal), up), *FORWARDS)]

    # -- cost -----------------------------------------------------------------------------------------------------

    def integrand(self, rows: list[Row]) -> Any:
        """What the cost integrates over relative time; rows that an objective needs are appended to `rows`."""
        total = ca.SX(0)
        for k, objective in enumerate(self.model.problem.objectives):
            total = total + objective.weight * self._term(objective, rows, k)
        return total * self.T

    def _term(self, objective: Objective, rows: list[Row], index: int) -> Any:
        model, u = self.model, self.blocks["u"]
        labels = model.drive_labels
        usual = 0.0 if objective.type == "electrical" else 1.0
        weights = [objective.weights.get(label, usual) for label in labels]
        if objective.type == "effort":
            return sum((w * u[k] ** 2 for k, w in enumerate(weights)), start=ca.SX(0))
        if objective.type == "preload":
            about = [objective.preload.get(label, model.problem.preload.get(label, 0.0)) for label in labels]
            return sum((w * (u[k] - about[k]) ** 2 for k, w in enumerate(weights)), start=ca.SX(0))
        if objective.type == "electrical":
            losses = sum((w * u[k] ** 2 for k, w in enumerate(weights)), start=ca.SX(0))
            return losses + ca.dot(u, self.drive_rates)
        if objective.type == "energy":
            power = self.blocks["positive_power"]
            for k, label in enumerate(labels):
                scale = float(model.scales.u[k]) * model.system.length / model.scales.duration
                surplus = power[k] - u[k] * self.drive_rates[k]
                rows.append(Row(f"positive power of {label}", surplus, 0.0, INFINITY, scale))
            return ca.sum1(power)
        if objective.type == "jerk":
            jerk = self.blocks["y_3"] / self.T**3
            return ca.dot(jerk, jerk)
        if objective.type == "expression":
            return expression(objective.expression, self.names, where=f"objectives[{index}].expression")
        return ca.SX(0)

    @property
    def names(self) -> dict[str, Any]:
        """What an expression of a user may name: t, T, q_, v_, u_ and the parameters."""
        model = self.model
        result: dict[str, Any] = {"t": self.known["t"], "T": self.T}
        tree = model.system.tree
        result |= {f"q_{_plain(c.label)}": self.q[k] for k, c in enumerate(tree.q)}
        result |= {f"v_{_plain(c.label)}": self._moving["v"][k] for k, c in enumerate(tree.v)}
        result |= {f"u_{_plain(label)}": self.blocks["u"][k] for k, label in enumerate(model.drive_labels)}
        result |= (
            {f"{name}_{axis}": at[k] for name, at in self._points.items() for k, axis in enumerate("xyz")}
            if model.system.mechanism.points
            else {}
        )
        return result | {name: self.known["p"][k] for k, name in enumerate(model.parameter_names)}


def _plain(label: str) -> str:
    return label.replace(".", "_")


def _rotation(vector: np.ndarray) -> np.ndarray:
    """Rotation matrix of a rotation vector."""
    angle = float(np.linalg.norm(vector))
    if angle == 0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
