"""Formulas for a paper: of limbs, constraints, inverse kinematics, Jacobians and statics, in names an author writes.

mechanism --named_lengths, limb_formulas, platform_formulas--> formulas --paper--> LaTeX
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.paper_formulas.formula import Formula, Part
    from symscrew.paper_formulas.paper import Paper, paper_formulas, write_formulas

__all__ = ["Formula", "Paper", "Part", "paper_formulas", "write_formulas"]

__getattr__ = doors(__name__)
