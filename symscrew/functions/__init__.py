"""The functions of a model, by subject: each module turns a `System` into `Function`s with named ports."""

from symscrew.functions.checked import SUFFIX, checked_functions
from symscrew.functions.closing import (
    THRESHOLD,
    Assembly,
    assembly,
    closure_functions,
    jacobian_in_v,
    loop_notes,
    moved_by,
)
from symscrew.functions.coupling_forces import coupling_functions, rolling_functions
from symscrew.functions.derivative import derivative_functions
from symscrew.functions.dynamic import NO_DRIVE, Equations, all_reactions, dynamic_functions
from symscrew.functions.effect_outputs import effect_functions
from symscrew.functions.forward import (
    REASONS,
    SecondPath,
    accelerates,
    closing_functions,
    driven,
    forward_functions,
    left_out,
    moves_mass,
    second_paths,
)
from symscrew.functions.identifiable import base_parameters, inertial_parameters
from symscrew.functions.kinematic import (
    Motion,
    acceleration_at,
    ball_notes,
    joint_freedom_labels,
    kinematic_functions,
    moving_bodies,
)
from symscrew.functions.loop_choice import fewest_in_mode, fewest_operations
from symscrew.functions.margin import margin_functions
from symscrew.functions.momenta import mass_properties, momentum_functions
from symscrew.functions.platform import platform_functions
from symscrew.functions.ports import (
    TWIST_LABELS,
    TWIST_UNITS,
    WRENCH_LABELS,
    WRENCH_UNITS,
    a_port,
    columns_port,
    function,
    q_port,
    u_port,
    v_port,
    y_port,
)
from symscrew.functions.presets import ALL, PRESETS, known_function, preset, selected
from symscrew.functions.quantities import Quantities, Quantity
from symscrew.functions.regressor import regressor_functions
from symscrew.functions.second_order import HESSIAN, PRODUCT, second_order_functions
from symscrew.functions.untried import untried_notes

__all__ = [
    "ALL",
    "HESSIAN",
    "NO_DRIVE",
    "PRESETS",
    "PRODUCT",
    "REASONS",
    "SUFFIX",
    "THRESHOLD",
    "TWIST_LABELS",
    "TWIST_UNITS",
    "WRENCH_LABELS",
    "WRENCH_UNITS",
    "Assembly",
    "Equations",
    "Motion",
    "Quantities",
    "Quantity",
    "SecondPath",
    "a_port",
    "accelerates",
    "acceleration_at",
    "all_reactions",
    "assembly",
    "ball_notes",
    "base_parameters",
    "checked_functions",
    "closing_functions",
    "closure_functions",
    "columns_port",
    "coupling_functions",
    "derivative_functions",
    "driven",
    "dynamic_functions",
    "effect_functions",
    "fewest_in_mode",
    "fewest_operations",
    "forward_functions",
    "function",
    "inertial_parameters",
    "jacobian_in_v",
    "joint_freedom_labels",
    "kinematic_functions",
    "known_function",
    "left_out",
    "loop_notes",
    "margin_functions",
    "mass_properties",
    "momentum_functions",
    "moved_by",
    "moves_mass",
    "moving_bodies",
    "platform_functions",
    "preset",
    "q_port",
    "regressor_functions",
    "rolling_functions",
    "second_order_functions",
    "second_paths",
    "selected",
    "u_port",
    "untried_notes",
    "v_port",
    "y_port",
]
