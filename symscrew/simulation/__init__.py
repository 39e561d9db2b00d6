"""Simulation of a scene: from its programs to a run, its report and its files.

Scene --prepare--> state programs --native (C) or portable (NumPy)--> Run --run_file, picture--> files
Scene, arrays of starts --given_starts--> Starts --many_runs, loops in threads--> Runs --many_file--> file
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.simulation.cuda_steps import ManySteps, load_steps, print_steps, write_steps
    from symscrew.simulation.initial import initial_state, initial_states
    from symscrew.simulation.kept_model import derived_model
    from symscrew.simulation.linking import Linker, Operand
    from symscrew.simulation.many_file import runs_numbers, runs_summary, write_runs
    from symscrew.simulation.many_runs import Runs, simulate_many
    from symscrew.simulation.motion import ON_NUMPY, prepare, simulate
    from symscrew.simulation.native import NATIVE_FLAGS, NATIVE_METHODS, Library, RunLog, run_natively
    from symscrew.simulation.picture import plot_run
    from symscrew.simulation.real_time_loop import REAL_TIME, loop_plant, loop_source, started_anywhere, write_loop
    from symscrew.simulation.run_file import FORMATS, run_summary, write_run
    from symscrew.simulation.run_source import NO_TABLES, kernel_text, table_code
    from symscrew.simulation.scene_functions import PlantFunctions, RunError
    from symscrew.simulation.state_programs import Plant
    from symscrew.simulation.sundials import whole_run

__all__ = [
    "FORMATS",
    "NATIVE_FLAGS",
    "NATIVE_METHODS",
    "NO_TABLES",
    "ON_NUMPY",
    "REAL_TIME",
    "Library",
    "Linker",
    "ManySteps",
    "Operand",
    "Plant",
    "PlantFunctions",
    "RunError",
    "RunLog",
    "Runs",
    "derived_model",
    "initial_state",
    "initial_states",
    "kernel_text",
    "load_steps",
    "loop_plant",
    "loop_source",
    "plot_run",
    "prepare",
    "print_steps",
    "run_natively",
    "run_summary",
    "runs_numbers",
    "runs_summary",
    "simulate",
    "simulate_many",
    "started_anywhere",
    "table_code",
    "whole_run",
    "write_loop",
    "write_run",
    "write_runs",
    "write_steps",
]

__getattr__ = doors(__name__)
