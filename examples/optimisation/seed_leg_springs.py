"""Design: springs in the legs of the pointing platform that make a periodic scan nearly free.

With the right stiffness the scan is a free oscillation: the drives have almost nothing left to do.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import sympy

from symscrew.description import Parameter
from symscrew.effects import Gravity, JointSpring
from symscrew.optimisation import Trajectory, TrajectoryProblem, load_problem, solve

HERE = Path(__file__).parent
LEGS = ("limb1_P", "limb2_P", "limb3_P", "limb4_P")


def problem() -> TrajectoryProblem:
    """The scan with a spring of stiffness k_leg beside every drive, unstretched in the reference pose."""
    scan = load_problem(HERE / "seed_periodic_scan.toml")
    stiffness = Parameter("k_leg", sympy.Integer(100), "N/m", "stiffness of a leg's spring", run_time=True)
    mechanism = replace(scan.mechanism, parameters={**scan.mechanism.parameters, "k_leg": stiffness})
    springs = tuple(JointSpring(leg, stiffness="k_leg", rest="0.3") for leg in LEGS)
    return replace(scan, mechanism=mechanism, effects=(Gravity(), *springs), design={"k_leg": (0.0, 5000.0)})


def main() -> tuple[Trajectory, Trajectory]:
    """The scan without springs and with the best ones."""
    best = solve(problem())
    bare = solve(replace(problem(), design={}, parameters={"k_leg": 0.0}))
    return bare, best


if __name__ == "__main__":
    bare, best = main()
    print(f"effort without springs {bare.cost:.6g} N^2 s")
    print(f"with springs of {best.parameters['k_leg']:.4g} N/m {best.cost:.3g} N^2 s")
