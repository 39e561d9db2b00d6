"""The whole story of a configuration: its branches, and what the platform does along them.

Mobility --germs, branch_table--> branches with tangents, screw systems (screw_classes), joints at rest
         --branch_words--> lines and JSON values
"""

from symscrew.mobility.motions.branch_table import BranchRow, BranchTable, branches_through
from symscrew.mobility.motions.branch_words import branch_lines, branch_values
from symscrew.mobility.motions.screw_classes import ScrewClass, screw_class

__all__ = [
    "BranchRow",
    "BranchTable",
    "ScrewClass",
    "branch_lines",
    "branch_values",
    "branches_through",
    "screw_class",
]
