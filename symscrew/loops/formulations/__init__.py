"""The formulations of a cut joint's rows, one file each: how the loops are written before they are solved.

    system, cut --FORMULATIONS[name]--> CutRows: rows, definitions, scales, bias; None where the cut has none

A further formulation is a file with such a function and its lines in `symscrew.loops.formulations.table`.
"""

from symscrew.loops.formulations.cut_rows import CutRows
from symscrew.loops.formulations.rod_rows import RodRows
from symscrew.loops.formulations.seen_rows import SeenRows
from symscrew.loops.formulations.table import CHOICES, FORMULATIONS

__all__ = ["CHOICES", "FORMULATIONS", "CutRows", "RodRows", "SeenRows"]
