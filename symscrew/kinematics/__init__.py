"""Kinematics over a spanning tree: frames, screws and their rates, momentum screws, cut joints.

Mechanism --tree--> links, cut joints --link_frames--> frames --recursion--> twists and their rates
          --cut_joints--> rows of the loops; `System` holds them with a tape and sample states
"""

from symscrew.kinematics.cut_joints import (
    Cut,
    Row,
    acceleration_across,
    carry,
    carry_across,
    carry_before,
    carry_point,
    closure_bias,
    closure_rate,
    drive_row,
    on_hub,
    seen_before,
    universal_axes,
    velocity_across,
)
from symscrew.kinematics.joint_displacements import cut_displacement, tree_displacement
from symscrew.kinematics.link_frames import Frame
from symscrew.kinematics.momentum_screws import MassProperties, momentum_rate, momentum_screw
from symscrew.kinematics.recursion import (
    Inertia,
    Placement,
    Rates,
    acceleration_matrix,
    combined,
    inertial_wrench,
    own_screws,
    placements,
    quaternion_matrix,
    rates,
    regrouped,
    twists,
)
from symscrew.kinematics.screws_at_origin import BodyMotion, body_motions, displacement, joint_screws
from symscrew.kinematics.system import System, Wrench, characteristic_length
from symscrew.kinematics.tree import GROUND, Link, Tree, spanning_tree

__all__ = [
    "GROUND",
    "BodyMotion",
    "Cut",
    "Frame",
    "Inertia",
    "Link",
    "MassProperties",
    "Placement",
    "Rates",
    "Row",
    "System",
    "Tree",
    "Wrench",
    "acceleration_across",
    "acceleration_matrix",
    "body_motions",
    "carry",
    "carry_across",
    "carry_before",
    "carry_point",
    "characteristic_length",
    "closure_bias",
    "closure_rate",
    "combined",
    "cut_displacement",
    "displacement",
    "drive_row",
    "inertial_wrench",
    "joint_screws",
    "momentum_rate",
    "momentum_screw",
    "on_hub",
    "own_screws",
    "placements",
    "quaternion_matrix",
    "rates",
    "regrouped",
    "seen_before",
    "spanning_tree",
    "tree_displacement",
    "twists",
    "universal_axes",
    "velocity_across",
]
