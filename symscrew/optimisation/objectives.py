"""Objectives: what the cost integrates along a motion, and what else each of them adds to the program.

    cost = sum_j weight_j * (integral of term_j dt  or  an unknown of the whole motion),    dt = T dtau

A type of objective is an entry of `OBJECTIVE_TYPES` (its name stands in `symscrew.optimisation.problem.OBJECTIVES`).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from symscrew.optimisation.linear_rows import LinearRows
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Objective
from symscrew.optimisation.problem_numbers import Get
from symscrew.optimisation.rows import INFINITY, Row
from symscrew.optimisation.terms import expression
from symscrew.optimisation.unknowns import UnknownGroup

Term = tuple[Any, list[Row]]  # a share of the integrand, constraints at the point that it needs


@dataclass(frozen=True)
class WholeUnknown:
    """An unknown that a motion has once: its typical size, and its value at a guess with drives u (points, drives)."""

    name: str
    label: str
    size: Callable[[PointModel, Objective], float]
    start: Callable[[PointModel, Objective, np.ndarray], float]


def _nothing(at: MotionQuantities, objective: Objective, where: str) -> Term:
    return ca.SX(0), []


@dataclass(frozen=True)
class ObjectiveType:
    """What a type of objective adds to the program; a part that it does not need is left out.

    `term`: what the cost integrates at a point. `cost_on`: the unknown of the whole motion that the cost counts:
    the duration "T", or `whole`, an unknown of its own. `unknowns`: further unknowns at the points. `derived`: blocks
    of a point that are linear in unknowns ("y_3", which has d entries). `linear`: adds linear constraints. `shooting`:
    whether multiple shooting can have it. `pointwise`: whether the cost of the drives at a time does not depend on
    those at other times, so that they minimise the Hamiltonian there.
    """

    term: Callable[[MotionQuantities, Objective, str], Term] = _nothing
    cost_on: str = ""
    whole: WholeUnknown | None = None
    unknowns: Callable[[PointModel], tuple[UnknownGroup, ...]] = lambda model: ()
    derived: tuple[str, ...] = ()
    linear: Callable[[LinearRows, Objective], None] = lambda rows, objective: None
    shooting: bool = True
    pointwise: bool = True


def objectives_by_type(model: PointModel) -> list[tuple[ObjectiveType, Objective]]:
    """The types of a problem's objectives, each with the first objective of the type."""
    first: dict[str, Objective] = {}
    for objective in model.problem.objectives:
        first.setdefault(objective.type, objective)
    return [(made, first[name]) for name, made in OBJECTIVE_TYPES.items() if name in first]


def integrand(at: MotionQuantities) -> Term:
    """What the cost integrates over relative time, and the constraints that its terms need."""
    total, rows = ca.SX(0), list[Row]()
    for k, objective in enumerate(at.model.problem.objectives):
        value, needed = OBJECTIVE_TYPES[objective.type].term(at, objective, f"objectives[{k}]")
        if not ca.SX(value).is_zero():  # "time" and "peak" count unknowns of the whole motion
            total = total + at.model.number(f"weight of objective {k}", _weight_of(k)) * value
        rows += needed
    return total * at.T, rows


def _weight_of(k: int) -> Get:
    return lambda problem: problem.objectives[k].weight


def _weights(at: MotionQuantities, objective: Objective, usual: float = 1.0) -> list[Any]:
    k = at.model.problem.objectives.index(objective)

    def of(label: str) -> Get:
        return lambda problem: problem.objectives[k].weights.get(label, usual)

    return [at.model.number(f"weight of {label} in objective {k}", of(label)) for label in at.model.drive_labels]


def _squares(weights: list[Any], values: list[Any]) -> Any:
    return sum((w * value**2 for w, value in zip(weights, values, strict=True)), start=ca.SX(0))


def _drives(at: MotionQuantities) -> list[Any]:
    return [at.blocks["u"][k] for k in range(len(at.model.drive_labels))]


def _effort(at: MotionQuantities, objective: Objective, where: str) -> Term:
    return _squares(_weights(at, objective), _drives(at)), []


def _preload(at: MotionQuantities, objective: Objective, where: str) -> Term:
    k = at.model.problem.objectives.index(objective)

    def of(label: str) -> Get:
        return lambda problem: problem.objectives[k].preload.get(label, problem.preload.get(label, 0.0))

    about = [at.model.number(f"preload of {label} in objective {k}", of(label)) for label in at.model.drive_labels]
    return _squares(_weights(at, objective), [u - a for u, a in zip(_drives(at), about, strict=True)]), []


def _electrical(at: MotionQuantities, objective: Objective, where: str) -> Term:
    """Copper losses and mechanical power; the power that flows back is gained."""
    losses = _squares(_weights(at, objective, 0.0), _drives(at))
    return losses + ca.dot(at.blocks["u"], at.drive_rates), []


def _energy(at: MotionQuantities, objective: Objective, where: str) -> Term:
    """Unknowns P_k >= 0, P_k >= u_k rate_k: at the optimum max(0, u_k rate_k), without a kink."""
    model, power, rows = at.model, at.blocks["positive_power"], []
    for k, label in enumerate(model.drive_labels):
        scale = float(model.scales.u[k]) * model.system.length / model.scales.duration
        surplus = power[k] - at.blocks["u"][k] * at.drive_rates[k]
        rows.append(Row(f"positive power of {label}", surplus, 0.0, INFINITY, scale))
    return ca.sum1(power), rows


def _jerk(at: MotionQuantities, objective: Objective, where: str) -> Term:
    jerk = at.blocks["y_3"] / at.T**3
    return ca.dot(jerk, jerk), []


def _expression(at: MotionQuantities, objective: Objective, where: str) -> Term:
    return expression(objective.expression, at.names, where=f"{where}.expression"), []


def _positive_power(model: PointModel) -> tuple[UnknownGroup, ...]:
    labels = [f"positive power of {label}" for label in model.drive_labels]
    size = model.scales.u * model.system.length / model.scales.duration
    return (UnknownGroup("positive_power", labels, size, lower=0.0),)


def _continuous_second_rates(rows: LinearRows, objective: Objective) -> None:
    """Continuous second rates, where their slope is what the cost looks at."""
    scheme, y_2 = rows.grid.scheme, rows.unknowns.index["y_2"]
    assert scheme is not None  # no shooting
    at = scheme.basis(np.array([0.0, 1.0]))
    labels = [f"continuity of the second rate of {label}" for label in rows.model.equations.labels]
    new = rows.new(labels, rows.grid.mesh[1:-1])
    for j in range(scheme.degree):
        rows.terms.add(new, y_2[:-1, j], at[1, j] / (4 * rows.model.scales.y))
        rows.terms.add(new, y_2[1:, j], -at[0, j] / (4 * rows.model.scales.y))


def _largest_drive(model: PointModel, objective: Objective) -> float:
    sizes = zip(model.drive_labels, model.scales.u, strict=True)
    return float(max(size / objective.weights.get(label, 1.0) for label, size in sizes))


def _largest_guessed(model: PointModel, objective: Objective, u: np.ndarray) -> float:
    weights = objective.weights
    sizes = [np.abs(u[:, k]).max() / weights.get(label, 1.0) for k, label in enumerate(model.drive_labels)]
    return float(max(sizes, default=1.0))


def _below_the_peak(rows: LinearRows, objective: Objective) -> None:
    """w_j peak >= |u_j| at all points."""
    model, index = rows.model, rows.unknowns.index
    tau = rows.grid.point_tau.ravel()
    for k, label in enumerate(model.drive_labels):
        u, size = index["u"][..., k].ravel(), 1.0 / model.scales.u[k]
        weight = objective.weights.get(label, 1.0)
        for sign in (1.0, -1.0):
            row = rows.new([f"peak of drive {label}"], tau, 0.0, np.inf)
            rows.terms.add(row, index["peak"], weight * size)
            rows.terms.add(row[:, 0], u, -sign * size)


OBJECTIVE_TYPES: Mapping[str, ObjectiveType] = {
    "effort": ObjectiveType(_effort),
    "time": ObjectiveType(cost_on="T"),
    "energy": ObjectiveType(_energy, unknowns=_positive_power, shooting=False),
    "electrical": ObjectiveType(_electrical),
    "peak": ObjectiveType(
        cost_on="peak",
        whole=WholeUnknown("peak", "peak of the drives", _largest_drive, _largest_guessed),
        linear=_below_the_peak,
        pointwise=False,
    ),
    "jerk": ObjectiveType(_jerk, derived=("y_3",), linear=_continuous_second_rates, shooting=False),
    "preload": ObjectiveType(_preload),
    "expression": ObjectiveType(_expression),
}
