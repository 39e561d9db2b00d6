"""Dynamics: from momentum rates and effects to drives, reactions and accelerations.

System, Acting --equilibrium--> balance of every link --drives, reactions--> wrenches at every joint
               --tree_dynamics, articulated, projection, coriolis--> `Admissible`: accelerations of free motion
"""

from symscrew.dynamics.carried_loops import carried_wrenches
from symscrew.dynamics.coriolis import long_branches
from symscrew.dynamics.derivatives import (
    Direction,
    Variation,
    closure_changes,
    inertial_derivatives,
    power_changes,
    three,
)
from symscrew.dynamics.drives import DriveSolution, solve_drives, solve_symmetric
from symscrew.dynamics.equilibrium import Balance, balance, balances
from symscrew.dynamics.free_motion import Admissible, by_articulated_bodies
from symscrew.dynamics.hinge_powers import hinged_tips
from symscrew.dynamics.hub_seats import seats
from symscrew.dynamics.reactions import (
    Reactions,
    about_point,
    at_origin,
    joint_wrenches,
    numeric_multipliers,
    solve_reactions,
)
from symscrew.dynamics.rod_settings import RodSettings
from symscrew.dynamics.rods import Rod, thin_rods, with_end_masses
from symscrew.dynamics.setting import ONE, Setting, Wrench
from symscrew.dynamics.tree_dynamics import applied_forces, generalised_forces, mass_matrix
from symscrew.dynamics.turning_rods import TurningRod, heavier

__all__ = [
    "ONE",
    "Admissible",
    "Balance",
    "Direction",
    "DriveSolution",
    "Reactions",
    "Rod",
    "RodSettings",
    "Setting",
    "TurningRod",
    "Variation",
    "Wrench",
    "about_point",
    "applied_forces",
    "at_origin",
    "balance",
    "balances",
    "by_articulated_bodies",
    "carried_wrenches",
    "closure_changes",
    "generalised_forces",
    "heavier",
    "hinged_tips",
    "inertial_derivatives",
    "joint_wrenches",
    "long_branches",
    "mass_matrix",
    "numeric_multipliers",
    "power_changes",
    "seats",
    "solve_drives",
    "solve_reactions",
    "solve_symmetric",
    "thin_rods",
    "three",
    "with_end_masses",
]
