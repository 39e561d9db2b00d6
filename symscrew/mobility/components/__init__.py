"""Operation modes and components of the configuration space: closure as polynomials, taken apart.

Mechanism --limb_equations, closure_parts, several_bodies, algebraic_closure--> polynomials over an exact field
          --exact_parts--> irreducible components, proved; real_configurations lie on them --all_components--> result
          --parallel_axes, modes_of_poses--> where the whole does not end: sets of poses, proved, with real witnesses
          --numerical_decomposition--> where exact algebra does not end: components by their points on a section,
            from witness_sets by moving_sections of polynomials at many_points, and certified_points
          --zero_parameters--> of these all with some parameters zero, one_root, exact_parts again
Network   --mode_sampling--> modes that random configurations show, where exact algebra does not end
both      --component_texts--> words, JSON
all of these --allowed_time--> seconds of the processor that are left
what does not close --over_joints, counted_poses--> components over given coordinates
polynomials --algebra_program--> what Singular says of them; plane_sections --> what is irreducible
Network   --mode_connections--> assembly modes of the reference, paths between them without a singularity
"""

from symscrew.mobility.components.algebra_program import ALGEBRA_PROGRAM, algebra_answer
from symscrew.mobility.components.algebraic_closure import closure_equations
from symscrew.mobility.components.all_components import ConfigurationSpace, configuration_space
from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.closure_parts import ClosureEquations, NotAlgebraicError
from symscrew.mobility.components.component_parts import Part
from symscrew.mobility.components.component_texts import (
    UNCHECKED,
    mode_lines,
    mode_values,
    numerical_lines,
    numerical_values,
    pose_lines,
    pose_values,
    space_lines,
    space_values,
    zero_lines,
    zero_values,
)
from symscrew.mobility.components.mode_connections import (
    Mode,
    ModeConnections,
    assembly_connections,
    regular_ways,
)
from symscrew.mobility.components.mode_sampling import SampledMode, SampledModes, sampled_modes
from symscrew.mobility.components.modes_of_poses import PoseModes, pose_modes
from symscrew.mobility.components.numerical_decomposition import (
    NumericalComponent,
    NumericalSpace,
    numerical_components,
)
from symscrew.mobility.components.zero_parameters import ZeroParameters, with_zero_parameters

__all__ = [
    "ALGEBRA_PROGRAM",
    "UNCHECKED",
    "AllowedTime",
    "ClosureEquations",
    "ConfigurationSpace",
    "Mode",
    "ModeConnections",
    "NotAlgebraicError",
    "NumericalComponent",
    "NumericalSpace",
    "Part",
    "PoseModes",
    "SampledMode",
    "SampledModes",
    "ZeroParameters",
    "algebra_answer",
    "assembly_connections",
    "closure_equations",
    "configuration_space",
    "mode_lines",
    "mode_values",
    "numerical_components",
    "numerical_lines",
    "numerical_values",
    "pose_lines",
    "pose_modes",
    "pose_values",
    "regular_ways",
    "sampled_modes",
    "space_lines",
    "space_values",
    "with_zero_parameters",
    "zero_lines",
    "zero_values",
]
