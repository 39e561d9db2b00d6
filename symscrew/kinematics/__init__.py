"""Kinematics over a spanning tree: frames, screws and their rates, momentum screws, cut joints.

Mechanism --tree--> links, cut joints --link_frames--> frames --recursion--> twists and their rates
          --cut_joints--> rows of the loops; `System` holds them with a tape and sample states

What an elementary motion does with nodes is in `pairs`, a file each.
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
from symscrew.kinematics.link_inertias import combined, regrouped
from symscrew.kinematics.link_quantities import NO_SPREAD, Frame, Inertia, Placement, Rates
from symscrew.kinematics.momentum_screws import MassProperties, momentum_rate, momentum_screw
from symscrew.kinematics.pairs import LowerPair, pair_of, quaternion_matrix
from symscrew.kinematics.recursion import acceleration_matrix, inertial_wrench, own_screws, placements, rates, twists
from symscrew.kinematics.screws_at_origin import BodyMotion, body_motions, displacement, joint_screws, motion_screws
from symscrew.kinematics.system import System, Wrench, characteristic_length
from symscrew.kinematics.tree import GROUND, Link, Tree, spanning_tree

__all__ = [
    "GROUND",
    "NO_SPREAD",
    "BodyMotion",
    "Cut",
    "Frame",
    "Inertia",
    "Link",
    "LowerPair",
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
    "motion_screws",
    "on_hub",
    "own_screws",
    "pair_of",
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
