"""Trajectory optimisation on generated models.

problem file --> TrajectoryProblem --guess--> PointModel --transcription--> nonlinear program --solution--> Trajectory
             --built_problem--> the same program with numbers as parameters, compiled, solved again and again
             --mesh_errors, refinement--> finer mesh;   Trajectory --followed_motion--> replay --plan_file--> files
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.optimisation.built_problem import OptimisationProblem, optimisation_problem
    from symscrew.optimisation.followed_motion import replay
    from symscrew.optimisation.plan_file import plot_plan, write_plan
    from symscrew.optimisation.problem import (
        Bounds,
        Conditions,
        Distance,
        Objective,
        Obstacle,
        Solver,
        TrajectoryProblem,
        Transcription,
    )
    from symscrew.optimisation.problem_file import load_problem
    from symscrew.optimisation.problem_keys import tables_of_keys
    from symscrew.optimisation.result import Replay, Trajectory
    from symscrew.optimisation.solution import Prepared, prepare, solve

__all__ = [
    "Bounds",
    "Conditions",
    "Distance",
    "Objective",
    "Obstacle",
    "OptimisationProblem",
    "Prepared",
    "Replay",
    "Solver",
    "Trajectory",
    "TrajectoryProblem",
    "Transcription",
    "load_problem",
    "optimisation_problem",
    "plot_plan",
    "prepare",
    "replay",
    "solve",
    "tables_of_keys",
    "write_plan",
]

__getattr__ = doors(__name__)
