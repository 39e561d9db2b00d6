"""Objectives: what the cost integrates along a motion, and the constraints that this needs.

cost = sum_j weight_j * integral of term_j dt,    dt = T dtau
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import casadi as ca

from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.problem import Objective
from symscrew.optimisation.rows import INFINITY, Row
from symscrew.optimisation.terms import expression

Term = tuple[Any, list[Row]]  # a share of the integrand, constraints at the point that it needs


def integrand(at: MotionQuantities) -> Term:
    """What the cost integrates over relative time, and the constraints that its terms need."""
    total, rows = ca.SX(0), list[Row]()
    for k, objective in enumerate(at.model.problem.objectives):
        value, needed = TERMS[objective.type](at, objective, f"objectives[{k}]")
        total = total + objective.weight * value
        rows += needed
    return total * at.T, rows


def _weights(at: MotionQuantities, objective: Objective, usual: float = 1.0) -> list[float]:
    return [objective.weights.get(label, usual) for label in at.model.drive_labels]


def _squares(weights: list[float], values: list[Any]) -> Any:
    return sum((w * value**2 for w, value in zip(weights, values, strict=True)), start=ca.SX(0))


def _drives(at: MotionQuantities) -> list[Any]:
    return [at.blocks["u"][k] for k in range(len(at.model.drive_labels))]


def _effort(at: MotionQuantities, objective: Objective, where: str) -> Term:
    return _squares(_weights(at, objective), _drives(at)), []


def _preload(at: MotionQuantities, objective: Objective, where: str) -> Term:
    usual = at.model.problem.preload
    about = [objective.preload.get(label, usual.get(label, 0.0)) for label in at.model.drive_labels]
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


def _of_the_whole_motion(at: MotionQuantities, objective: Objective, where: str) -> Term:
    """Nothing at a point: the cost is linear in one unknown of the whole motion."""
    return ca.SX(0), []


TERMS: Mapping[str, Callable[[MotionQuantities, Objective, str], Term]] = {
    "effort": _effort,
    "time": _of_the_whole_motion,
    "energy": _energy,
    "electrical": _electrical,
    "jerk": _jerk,
    "peak": _of_the_whole_motion,
    "preload": _preload,
    "expression": _expression,
}
