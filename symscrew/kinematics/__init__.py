"""Kinematics over a spanning tree: frames, screws and their rates, momentum screws, cut joints.

Mechanism --tree--> links, joints to be cut --link_frames--> frames --structure--> linkage at q --recursion--> rates
          --cut_joints--> reciprocal wrenches --loop_closure, closure_jacobian--> rows of the loops
`System` holds them at nodes for q, v, a, with `sample_states`

What an elementary motion does with nodes is in `pairs`, a file each.
"""

from symscrew.kinematics.body_pose import (
    Doubles,
    PoseRow,
    body_centre,
    half_turn,
    pose_read,
    pose_rows,
    rotation_vector,
)
from symscrew.kinematics.closure_jacobian import ClosureJacobian
from symscrew.kinematics.coordinate_names import (
    BODY_PARTS,
    SPHERICAL_PARTS,
    angle_notices,
    check_apart,
    coordinate_units,
    full_name,
    given_coordinates,
    given_parameter,
    identifiers,
    nearest_names,
    quaternion_entry,
    tree_label,
    typable_names,
)
from symscrew.kinematics.coupled_coordinates import Relation
from symscrew.kinematics.cut_joints import Cut, Row, drive_row, on_hub, universal_axes
from symscrew.kinematics.joint_displacements import cut_displacement, tree_displacement, whole_rotation_vector
from symscrew.kinematics.link_inertias import combined, regrouped, without_gyroscopic_moment
from symscrew.kinematics.link_quantities import NO_SPREAD, Frame, Inertia, Placement, Rates, Wrench
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.loop_closure import closure_bias, closure_rate, turns_are_lost
from symscrew.kinematics.momentum_screws import MassProperties, momentum_rate, momentum_screw
from symscrew.kinematics.pairs import (
    ROUNDED,
    LowerPair,
    Turn,
    pair_of,
    quaternion_matrix,
    squared_length,
    unit_quaternion,
)
from symscrew.kinematics.recursion import acceleration_matrix, inertial_wrench, own_screws, rates, twists
from symscrew.kinematics.rolling import Rolling
from symscrew.kinematics.screws_at_origin import BodyMotion, body_motions, displacement, joint_screws, motion_screws
from symscrew.kinematics.sloped_poses import pose_rates
from symscrew.kinematics.system import System
from symscrew.kinematics.tree import GROUND, Link, Tree, spanning_tree, virtual_joint

__all__ = [
    "BODY_PARTS",
    "GROUND",
    "NO_SPREAD",
    "ROUNDED",
    "SPHERICAL_PARTS",
    "BodyMotion",
    "ClosureJacobian",
    "Cut",
    "Doubles",
    "Frame",
    "Inertia",
    "Link",
    "Linkage",
    "LowerPair",
    "MassProperties",
    "Placement",
    "PoseRow",
    "Rates",
    "Relation",
    "Rolling",
    "Row",
    "System",
    "Tree",
    "Turn",
    "Wrench",
    "acceleration_matrix",
    "angle_notices",
    "body_centre",
    "body_motions",
    "check_apart",
    "closure_bias",
    "closure_rate",
    "combined",
    "coordinate_units",
    "cut_displacement",
    "displacement",
    "drive_row",
    "full_name",
    "given_coordinates",
    "given_parameter",
    "half_turn",
    "identifiers",
    "inertial_wrench",
    "joint_screws",
    "momentum_rate",
    "momentum_screw",
    "motion_screws",
    "nearest_names",
    "on_hub",
    "own_screws",
    "pair_of",
    "pose_rates",
    "pose_read",
    "pose_rows",
    "quaternion_entry",
    "quaternion_matrix",
    "rates",
    "regrouped",
    "rotation_vector",
    "spanning_tree",
    "squared_length",
    "tree_displacement",
    "tree_label",
    "turns_are_lost",
    "twists",
    "typable_names",
    "unit_quaternion",
    "universal_axes",
    "virtual_joint",
    "whole_rotation_vector",
    "without_gyroscopic_moment",
]
