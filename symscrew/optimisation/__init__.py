"""Trajectory optimisation on generated models: problem, transcriptions, solver, result."""

from symscrew.optimisation.problem import (
    Bounds,
    Conditions,
    Distance,
    Objective,
    Solver,
    TrajectoryProblem,
    Transcription,
)
from symscrew.optimisation.result import Trajectory
from symscrew.optimisation.solve import prepare, solve

__all__ = [
    "Bounds",
    "Conditions",
    "Distance",
    "Objective",
    "Solver",
    "Trajectory",
    "TrajectoryProblem",
    "Transcription",
    "prepare",
    "solve",
]
