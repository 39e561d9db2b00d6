"""What holds at one point of a motion, as a function of the unknowns there.

PointModel --unknowns--> MotionQuantities --constraints, objectives--> PointFunction (rows, integrand)
"""

from __future__ import annotations

from symscrew.optimisation.constraints import bound_rows, closure_rows, condition_rows, dynamic_rows, rule_rows
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.objectives import integrand
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions
from symscrew.optimisation.rows import PointFunction


def collocation_point(model: PointModel) -> PointFunction:
    """A point at which the equations of motion hold."""
    blocks = model.blocks(moving=True)
    at = MotionQuantities(model, blocks)
    rows = [*closure_rows(at), *dynamic_rows(at), *rule_rows(at), *bound_rows(at)]
    cost, needed = integrand(at)
    return PointFunction(blocks, (*rows, *needed), cost)


def observation_point(model: PointModel, conditions: Conditions, where: str) -> PointFunction:
    """A point at which conditions hold that are not linear in y and its rates."""
    blocks = model.blocks(moving=False)
    at = MotionQuantities(model, blocks)
    return PointFunction(blocks, (*closure_rows(at, where), *condition_rows(at, conditions, where)))
