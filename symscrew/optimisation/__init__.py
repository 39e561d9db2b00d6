"""Trajectory optimisation on generated models.

problem file --> TrajectoryProblem --guess--> PointModel --transcription--> nonlinear program --solution--> Trajectory
             --built_problem--> the same program with numbers as parameters, compiled, solved again and again
             --joined_program--> phases and load cases in one program, solved by `solve_joined` --> JoinedPlan
             --mesh_errors, refinement--> finer mesh;   Trajectory --followed_motion--> replay --plan_file--> files
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.optimisation.built_problem import OptimisationProblem, optimisation_problem
    from symscrew.optimisation.followed_motion import replay
    from symscrew.optimisation.joined_file import load_problem_file
    from symscrew.optimisation.joined_plan import JoinedPlan
    from symscrew.optimisation.joined_problem import JoinedProblem, Link
    from symscrew.optimisation.joined_solution import solve_joined
    from symscrew.optimisation.plan_file import write_joined, write_plan
    from symscrew.optimisation.plan_picture import plot_plan
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
    from symscrew.optimisation.result import Replay, Statistics, Trajectory
    from symscrew.optimisation.solution import Prepared, prepare, solve

__all__ = [
    "Bounds",
    "Conditions",
    "Distance",
    "JoinedPlan",
    "JoinedProblem",
    "Link",
    "Objective",
    "Obstacle",
    "OptimisationProblem",
    "Prepared",
    "Replay",
    "Solver",
    "Statistics",
    "Trajectory",
    "TrajectoryProblem",
    "Transcription",
    "load_problem",
    "load_problem_file",
    "optimisation_problem",
    "plot_plan",
    "prepare",
    "replay",
    "solve",
    "solve_joined",
    "tables_of_keys",
    "write_joined",
    "write_plan",
]

__getattr__ = doors(__name__)
