"""Results by name: wrenches of joints, and what happens over time as columns that pandas, xarray and files take."""

from symscrew.results.named_reactions import JointWrench, JointWrenches, joint_wrenches, wrenches_of
from symscrew.results.over_time import Columns

__all__ = ["Columns", "JointWrench", "JointWrenches", "joint_wrenches", "wrenches_of"]
