"""Operation modes and components of the configuration space: closure as polynomials, taken apart.

Mechanism --limb_equations, closure_equations--> polynomials over an exact field (polynomials)
          --exact_parts--> irreducible components, proved --configuration_space--> result --component_texts--> words
"""

from symscrew.mobility.components.algebraic_closure import ClosureEquations, NotAlgebraicError, closure_equations
from symscrew.mobility.components.all_components import ConfigurationSpace, configuration_space
from symscrew.mobility.components.component_texts import space_lines, space_values
from symscrew.mobility.components.exact_parts import Part

__all__ = [
    "ClosureEquations",
    "ConfigurationSpace",
    "NotAlgebraicError",
    "Part",
    "closure_equations",
    "configuration_space",
    "space_lines",
    "space_values",
]
