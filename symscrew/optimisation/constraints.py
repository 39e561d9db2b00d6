"""Constraints at one time of a motion: closed loops, equations of motion, bounds, conditions.

quantities at a point --> rows  lower <= value <= upper  with labels that a person understands
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError, did_you_mean
from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.motion_coordinates import bounded, coordinate, coordinate_rate, pose_conditions, poses_of
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.obstacles import SHAPES, Kept
from symscrew.optimisation.problem import Conditions, Obstacle, Range, TrajectoryProblem
from symscrew.optimisation.problem_numbers import Get
from symscrew.optimisation.rows import INFINITY, Row
from symscrew.optimisation.terms import expression

# Range of a cosine that is 1 where a direction is met and -1 at its opposite, which has the same zero sines: wide, so
# that it holds with slack where the sines are zero and does not disturb the solver.
FORWARDS = (0.5, 1.5)


def closure_rows(at: MotionQuantities, where: str = "") -> list[Row]:
    """The loops are closed, quaternions have unit length."""
    values = at.opening
    suffix = f" at {where}" if where else ""
    return [Row(f"closure of the loops, row {k + 1}{suffix}", values[k]) for k in range(values.numel())]


def dynamic_rows(at: MotionQuantities) -> list[Row]:
    """Equations of motion and of the effects' states."""
    rows, x_dot = FORMULATIONS[at.model.problem.transcription.formulation](at)
    for k, name in enumerate(at.model.states):
        value = at.blocks["x_1"][k] - at.T * x_dot[k]
        rows.append(Row(f"rate of the state {name}", value, scale=float(at.model.scales.x[k])))
    return rows


def _inverse(at: MotionQuantities) -> tuple[list[Row], Any]:
    """N^T (M a + bias - forces) = 0 with the drives as unknowns, and x_dot."""
    scale = at.model.scales.force
    found = symbolic_outputs(at.model.equations.dynamics, at.known)
    residual = found["residual"]
    rows = [Row(f"equation of motion {k + 1}", residual[k], scale=float(scale[k])) for k in range(at.model.d)]
    return rows, found["x_dot"]


def _forward(at: MotionQuantities) -> tuple[list[Row], Any]:
    """y_ddot = what forward dynamics gives for the drives, and x_dot; times T^2, so that a row has the size of y."""
    scale = at.model.scales.y
    found = symbolic_outputs(at.model.equations.forward, at.known)
    error = (at.y_ddot - found["y_ddot"]) * at.T**2
    labels = at.model.equations.labels
    rows = [Row(f"equation of motion along {label}", error[k], scale=float(scale[k])) for k, label in enumerate(labels)]
    return rows, found["x_dot"]


FORMULATIONS: Mapping[str, Callable[[MotionQuantities], tuple[list[Row], Any]]] = {
    "inverse": _inverse,
    "forward": _forward,
}


def rule_rows(at: MotionQuantities) -> list[Row]:
    """Redundant drives by least squares about the preload: u - preload lies in the range of the drives' rates."""
    model = at.model
    if model.problem.drive_rule != "least_squares":
        return []
    u = at.blocks["u"]
    residual = symbolic_outputs(model.equations.dynamics, at.known)["residual"]
    matrix = ca.jacobian(residual, u)

    def of(label: str) -> Get:
        return lambda problem: problem.preload.get(label, 0.0)

    about = [model.number(f"preload of {label}", of(label)) for label in model.drive_labels]
    values = u - ca.vertcat(ca.SX(0, 1), *about) - matrix.T @ at.blocks["distribution"]
    return [
        Row(f"least-squares rule of drive {label}", values[k], scale=float(model.scales.u[k]))
        for k, label in enumerate(model.drive_labels)
    ]


def bound_rows(at: MotionQuantities) -> list[Row]:
    """Bounds that are not those of an unknown itself."""
    problem, scales = at.model.problem, at.model.scales
    bounds, length = problem.bounds, at.model.system.length
    rows = []

    def add(what: str, value: Any, limits: Callable[[TrajectoryProblem], Range], scale: float = 1.0) -> None:
        rows.append(Row(what, value, *limits(problem), scale, limits))

    rows += [_travel_row(at, label) for label in bounds.joints]
    for label in bounds.speeds:
        add(f"speed of {label}", coordinate_rate(at, label), _bound("speeds", label), 1.0 / scales.duration)
    for name in bounds.margins:
        if name not in at.margins:
            raise DescriptionError(f"bounds.margins: unknown margin {name!r}; {did_you_mean(name, at.margins)}")
        add(f"margin {name}", at.margins[name], _bound("margins", name))
    for name, axis in bounds.points:
        limits = _bound("points", (name, axis))
        add(f"{'xyz'[axis]} of point {name}", at.points[name][axis], limits, length)
    for k, d in enumerate(bounds.distances):
        apart = at.points[d.first] - at.points[d.second]
        what = f"distance of {d.first} and {d.second}"
        low, high = max(d.range[0], 0.0), d.range[1]
        bound = low if low > 0 else high  # a small post is to be kept as well as a large one: parts of the bound
        measure = bound * bound if 0 < bound < INFINITY else length * length
        limits = _squared_distance(k)
        rows.append(Row(what, ca.dot(apart, apart), *limits(problem), length * length, limits, measure))
    for k, obstacle in enumerate(bounds.obstacles):
        rows += _obstacle_rows(at, k, obstacle)
    for text in bounds.expressions:
        value = expression(text, at.names, where="bounds.expressions")
        add(text, value, _bound("expressions", text))
    return rows + _reaction_rows(at)


def _travel_row(at: MotionQuantities, label: str) -> Row:
    value, risen, size = bounded(at, label, at.model.problem.bounds.joints[label])

    def limits(problem: TrajectoryProblem) -> Range:
        return risen(problem.bounds.joints[label])

    return Row(f"travel of {label}", value, *limits(at.model.problem), 1.0, limits, size)


def _obstacle_rows(at: MotionQuantities, k: int, obstacle: Obstacle) -> list[Row]:
    shape, length = SHAPES[obstacle.type], at.model.system.length

    def limits(problem: TrajectoryProblem) -> Range:
        return shape.least(problem.bounds.obstacles[k].distance), INFINITY

    places = [at.points[name] for name in obstacle.at]
    unit, least = length * length if shape.squared else length, limits(at.model.problem)[0]
    kept = [(name, Kept(shape.value(places, at.points[name]))) for name in obstacle.points]
    for pair in obstacle.segments:
        kept.append((f"the segment {' to '.join(pair)}", shape.between(places, [at.points[name] for name in pair])))
    for box in obstacle.boxes:
        parts = shape.boxes(places, [at.points[name] for name in box])
        kept += [(f"the box at {', '.join(box)}, part {i + 1}", value) for i, value in enumerate(parts)]
    return [
        Row(
            f"{obstacle.type} at {', '.join(obstacle.at)} kept off by {name}", value, *limits(at.model.problem), unit,
            limits, least if least > 0 else unit, between,
        )
        for name, (value, between) in kept
    ]  # fmt: skip


def _bound(group: str, key: object) -> Callable[[TrajectoryProblem], Range]:
    """A range of a problem's bounds."""
    return lambda problem: getattr(problem.bounds, group)[key]


def _squared_distance(k: int) -> Callable[[TrajectoryProblem], Range]:
    """Range of the square of a distance."""

    def limits(problem: TrajectoryProblem) -> Range:
        low, high = problem.bounds.distances[k].range
        return max(low, 0.0) ** 2, high**2

    return limits


def _reaction_rows(at: MotionQuantities) -> list[Row]:
    """Squares of reactions, which are smooth where the reaction is zero; moments about the joint's own point."""
    bounds, names, rows = at.model.problem.bounds.reactions, list(at.model.system.mechanism.joints), []
    if not bounds:
        return []
    points = at.of_tree("joint_points")["points"]
    for joint, (force, moment) in bounds.items():
        k = names.index(joint)
        f, m = at.reactions[6 * k : 6 * k + 3], at.reactions[6 * k + 3 : 6 * k + 6]
        if force is not None:
            limits = _largest(joint, 0)
            rows.append(Row(f"reaction force of {joint}", ca.dot(f, f), -INFINITY, force**2, force**2, limits))
        if moment is not None:
            own = m - ca.cross(points[3 * k : 3 * k + 3], f)
            limits = _largest(joint, 1)
            rows.append(Row(f"reaction moment of {joint}", ca.dot(own, own), -INFINITY, moment**2, moment**2, limits))
    return rows


def _largest(joint: str, part: int) -> Callable[[TrajectoryProblem], Range]:
    """Range of the square of a joint's reaction force (0) or moment (1)."""
    return lambda problem: (-INFINITY, (problem.bounds.reactions[joint][part] or 0.0) ** 2)


def condition_rows(at: MotionQuantities, conditions: Conditions, where: str) -> list[Row]:
    """Conditions that need the configuration."""
    rows, length = [], at.model.system.length
    linear = set(at.model.equations.labels)

    def add(what: str, value: Any, target: Callable[[Conditions], float | None], scale: float = 1.0) -> None:
        def limits(problem: TrajectoryProblem) -> Range:
            wanted = target(problem.conditions[where])
            assert wanted is not None  # of the same shape
            return wanted, wanted

        wanted = target(conditions)
        assert wanted is not None
        rows.append(Row(what, value, wanted, wanted, scale, limits))

    poses = poses_of(at.model.system.mechanism, conditions.coordinates, set(at.model.coordinate_labels))
    of_poses = {typed for parts in poses.values() for typed in parts.values()}
    for label in conditions.coordinates:
        if label not in linear and label not in of_poses:
            add(f"{label} at {where}", coordinate(at, label), _target("coordinates", label))
    for body, parts in poses.items():
        for what, value, of_parts, is_length in pose_conditions(at, body, parts):
            add(f"{what} at {where}", value, _of_coordinates(of_parts), length if is_length else 1.0)
    for label in conditions.rates:
        if label not in linear:
            add(f"rate of {label} at {where}", coordinate_rate(at, label), _target("rates", label))
    for name, places in conditions.points.items():
        for axis, place in enumerate(places):
            if place is not None:
                what = f"{'xyz'[axis]} of point {name} at {where}"
                add(what, at.points[name][axis], _target("points", name, axis), length)
    if conditions.platform_normal is not None:
        rows += _normal_rows(at, np.array(conditions.platform_normal, dtype=float), where)
    if conditions.platform_position is not None:
        for axis in range(3):
            what = f"{'xyz'[axis]} of the platform at {where}"
            add(what, at.platform_pose[1][axis], _target("platform_position", axis), length)
    if conditions.platform_rotation is not None:
        goal = _rotation(np.array(conditions.platform_rotation, dtype=float))
        off = ca.DM(goal).T @ at.platform_pose[0]
        for k, (i, j) in enumerate(((2, 1), (0, 2), (1, 0))):
            rows.append(Row(f"rotation {'xyz'[k]} of the platform at {where}", (off[i, j] - off[j, i]) / 2))
        rows.append(Row(f"sense of the platform's rotation at {where}", (ca.trace(off) - 1) / 2, *FORWARDS))
    return rows


def _of_coordinates(goal: Callable[[Mapping[str, float]], float]) -> Callable[[Conditions], float | None]:
    """A value that follows from several coordinates that conditions ask for."""
    return lambda conditions: goal(conditions.coordinates)


def _target(group: str, *keys: object) -> Callable[[Conditions], float | None]:
    """A value that conditions ask for."""

    def found(conditions: Conditions) -> float | None:
        value = getattr(conditions, group)
        for key in keys:
            value = value[key]
        return None if value is None else float(value)

    return found


def starting_rows(at: MotionQuantities) -> list[Row]:
    """States at the start: their initial values, and what the motion there gives them."""
    carried = symbolic_outputs(at.model.equations.carried, at.known)["carried"]
    states, scales, initials = at.model.equations.acting.states, at.model.scales.x, at.model.initials
    return [
        Row(f"state {state.name} at the start", at.known["x"][k] - carried[k], initials[k], initials[k], scales[k])
        for k, state in enumerate(states)
        if state.carried is not None
    ]


def _normal_rows(at: MotionQuantities, normal: np.ndarray, where: str) -> list[Row]:
    size = np.linalg.norm(normal)
    if not size > 0:
        raise DescriptionError(f"{where}.platform_normal: expected a direction, got {normal.tolist()}")
    normal = normal / size
    least = np.eye(3)[np.argmin(np.abs(normal))]
    one = np.cross(normal, least)
    one /= np.linalg.norm(one)
    two = np.cross(normal, one)
    up = at.platform_pose[0][:, 2]
    rows = [Row(f"platform normal, part {k + 1}, at {where}", ca.dot(ca.DM(e), up)) for k, e in enumerate((one, two))]
    return [*rows, Row(f"sense of the platform normal at {where}", ca.dot(ca.DM(normal), up), *FORWARDS)]


def _rotation(vector: np.ndarray) -> np.ndarray:
    """Rotation matrix of a rotation vector."""
    angle = float(np.linalg.norm(vector))
    if angle == 0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)
