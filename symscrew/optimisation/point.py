"""What holds at one point of a motion, as a function of the unknowns there.

PointModel --unknowns--> MotionQuantities --constraints, objectives--> PointFunction (rows, integrand)
"""

from __future__ import annotations

import casadi as ca

from symscrew.optimisation.constraints import (
    bound_rows,
    closure_rows,
    condition_rows,
    dynamic_rows,
    rule_rows,
    starting_rows,
)
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.objectives import integrand, objectives_by_type
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions
from symscrew.optimisation.rows import PointFunction


def point_symbols(model: PointModel, *, moving: bool) -> dict[str, ca.SX]:
    """Symbols of a point's unknowns; those of drives, effects and objectives only where it is `moving`."""
    d, nx = model.d, len(model.states)
    sizes = {"y": d, "y_1": d, "z": len(model.equations.layout.z)}
    if moving:
        types = [made for made, _ in objectives_by_type(model)]
        sizes |= {"y_2": d, "u": len(model.drive_labels), "x": nx, "x_1": nx}
        sizes |= {name: d for made in types for name in made.derived}
        sizes |= {group.name: len(group.labels) for made in types for group in made.unknowns(model)}
        if model.problem.drive_rule == "least_squares":
            sizes["distribution"] = d
    else:
        sizes["y_2"] = 0
    sizes |= {"T": int(model.problem.free_duration), "p": len(model.design), "tau": 1}
    return {name: ca.SX.sym(name, size) for name, size in sizes.items()}


def collocation_point(model: PointModel) -> PointFunction:
    """A point at which the equations of motion hold."""
    blocks = point_symbols(model, moving=True)
    at = MotionQuantities(model, blocks)
    rows = [*closure_rows(at), *dynamic_rows(at), *rule_rows(at), *bound_rows(at)]
    cost, needed = integrand(at)
    return PointFunction(blocks, (*rows, *needed), cost)


def observation_point(
    model: PointModel, conditions: Conditions, where: str, *, starting: bool = False
) -> PointFunction:
    """A point at which conditions hold that are not linear in y and its rates; `starting`: the states' values too."""
    blocks = point_symbols(model, moving=False)
    if starting:
        common = {name: blocks.pop(name) for name in ("T", "p", "tau")}
        blocks |= {"x": ca.SX.sym("x", len(model.states)), **common}
    at = MotionQuantities(model, blocks)
    started = starting_rows(at) if starting else []
    return PointFunction(blocks, (*closure_rows(at, where), *condition_rows(at, conditions, where), *started))
