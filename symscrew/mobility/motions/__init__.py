"""The whole story of a configuration: its branches, and what the platform does along them.

Mobility --germs, branch_table--> branches with tangents, screw systems (screw_classes), joints at rest
         --branch_words--> lines and JSON values
"""

from symscrew.mobility.motions.branch_table import BranchRow, BranchTable, branches_through
from symscrew.mobility.motions.branch_words import branch_lines, branch_values
from symscrew.mobility.motions.loop_components import (
    Component,
    Components,
    component_lines,
    component_values,
    components_of,
)
from symscrew.mobility.motions.motion_words import motion_lines, motion_values
from symscrew.mobility.motions.seen_poses import Closures, seen_at
from symscrew.mobility.motions.singular_poses import SingularPose
from symscrew.mobility.motions.whole_branch import CommonGroup, common_group
from symscrew.mobility.motions.whole_motion import WholeMotion, motion_along
from symscrew.mobility.screw_classes import ScrewClass, class_of_motions, screw_class

__all__ = [
    "BranchRow",
    "BranchTable",
    "Closures",
    "CommonGroup",
    "Component",
    "Components",
    "ScrewClass",
    "SingularPose",
    "WholeMotion",
    "branch_lines",
    "branch_values",
    "branches_through",
    "class_of_motions",
    "common_group",
    "component_lines",
    "component_values",
    "components_of",
    "motion_along",
    "motion_lines",
    "motion_values",
    "screw_class",
    "seen_at",
]
