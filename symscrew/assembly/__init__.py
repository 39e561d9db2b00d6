"""Every assembly mode: the closure as forms in Study's parameters, all its zeros, certified, with names.

Mechanism, values of drives --what_is_held, elementary_graph, held_structure--> unknowns, forms (dual_forms), numbers
structure --root_bounds--> a bound on isolated zeros;  --start_system--> all zeros of a general member, kept
--batch_equations, path_tracking, target_roots--> ends of all paths at the given numbers (families)
--certified_roots--> a box with one zero;  --joint_angles, mode_signs, mode_names--> modes --all_modes--> result
structure, start system --modes_c, closed_zeros--> C that finds all modes, and leads one (modes_library calls it)
result --configurations_in_modes--> where a run, a map or a plan in a mode begins
result --mode_texts--> words, JSON;  --followed_mode--> a mode led along a motion, every step proved
result --mode_ways--> of each pair a way without a singularity, or that there is none, or that none was found
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.assembly.all_modes import AssemblyMode, AssemblyModes, assembly_modes
    from symscrew.assembly.configurations_in_modes import configuration_in_mode, tree_coordinates
    from symscrew.assembly.followed_mode import FollowedMode, follow_mode
    from symscrew.assembly.mode_texts import mode_lines, mode_values, reach_lines
    from symscrew.assembly.mode_ways import Connection, reachable_modes
    from symscrew.assembly.modes_c import ModesModel, has_level_modes, modes_model, print_modes
    from symscrew.assembly.modes_library import CompiledModes, compiled_modes
    from symscrew.assembly.ways_to_solve import WaysToSolve

__all__ = [
    "AssemblyMode",
    "AssemblyModes",
    "CompiledModes",
    "Connection",
    "FollowedMode",
    "ModesModel",
    "WaysToSolve",
    "assembly_modes",
    "compiled_modes",
    "configuration_in_mode",
    "follow_mode",
    "has_level_modes",
    "mode_lines",
    "mode_values",
    "modes_model",
    "print_modes",
    "reach_lines",
    "reachable_modes",
    "tree_coordinates",
]

__getattr__ = doors(__name__)
