"""Where motions begin whose effects have states that the motion moves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.marks import slow
from sympy import Integer

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism, Parameter
from symscrew.effects import DcMotor, FlexibleLink
from symscrew.errors import DescriptionError
from symscrew.optimisation.problem import Conditions, TrajectoryProblem
from symscrew.optimisation.solution import solve


def swinging_rod() -> Mechanism:
    """A rod of 1 m on a driven hinge, with points at its ends."""
    made = MechanismBuilder("swinging_rod")
    made.body("rod", mass="0.5", com=["1/2", 0, 0], inertia=[0, "1/20", "1/20"])
    made.joint("hinge", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    made.point("near", body="rod", at=[0, 0, 0])
    made.point("far", body="rod", at=[1, 0, 0])
    return made.build()


@pytest.mark.parametrize("rates, rate", [({"hinge": 2.0}, 2.0), ({}, None), slow({"hinge": 0.0}, 0.0)])
def test_a_flexible_link_that_starts_in_motion_starts_without_bending_rates(rates: dict, rate: float | None) -> None:
    """Its state is the rate with the rod's own velocity: at the start the latter alone, omega integral of phi_1 x dx by
    that of phi_1^2 = 2 omega L/pi for phi_1 = sin(pi x/L); whether the start's rate is given or found."""
    bends = FlexibleLink("near", "far", (0, 0, 1), "2", "0.5", modes=1, damping="0.1")
    problem = TrajectoryProblem(
        swinging_rod(), effects=(bends,), duration=0.5, start=Conditions(coordinates={"hinge": 0.0}, rates=rates),
        end=Conditions(coordinates={"hinge": 1.0}, at_rest=True), accuracy=None,
    )  # fmt: skip
    found = solve(problem)
    assert found.ok, found.status
    start = found.blocks(np.array([0.0]))
    turning = float(start["y_1"][0, 0]) / found.duration
    assert rate is None or turning == pytest.approx(rate, abs=1e-9)
    assert rate is not None or abs(turning) > 0.1
    assert float(start["x"][0, 0]) == pytest.approx(0.0, abs=1e-9)
    assert float(start["x"][0, 1]) == pytest.approx(2 * turning / np.pi, abs=1e-8)


def test_states_begin_at_the_parameters_of_the_problem() -> None:
    """The current of a motor, 2 A for the problem and none in the description, at which the plan began."""
    current = Parameter("I", Integer(0), "A", run_time=True)
    rod = replace(swinging_rod(), parameters={"I": current})
    problem = TrajectoryProblem(
        rod, effects=(DcMotor("hinge", 1, 1, "1/10", current="I"),), duration=0.5, parameters={"I": 2.0},
        start=Conditions(coordinates={"hinge": 0.0}, at_rest=True), accuracy=None,
        end=Conditions(coordinates={"hinge": 1.0}, at_rest=True),
    )  # fmt: skip
    found = solve(problem)
    assert found.ok, found.status
    assert float(found.blocks(np.array([0.0]))["x"][0, 0]) == pytest.approx(2.0, abs=1e-9)
    with pytest.raises(DescriptionError, match=r"design\.I: the state current_hinge begins with it"):
        solve(replace(problem, parameters={}, design={"I": (0.0, 3.0)}))
