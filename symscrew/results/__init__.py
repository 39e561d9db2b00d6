"""Results by name: configurations, wrenches of joints, columns over time that pandas, xarray and files take."""

from symscrew.results.assembled_state import AssembledConfiguration, assemble
from symscrew.results.named_reactions import JointWrench, JointWrenches, joint_wrenches, wrenches_of
from symscrew.results.over_time import Columns

__all__ = [
    "AssembledConfiguration",
    "Columns",
    "JointWrench",
    "JointWrenches",
    "assemble",
    "joint_wrenches",
    "wrenches_of",
]
