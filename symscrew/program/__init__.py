"""Straight-line programs: what a function of the model computes, instruction by instruction, for any target.

nodes of the tape --lower (passes)--> Program: instructions, ports, counts, hash --lanes--> packs of equal limbs
"""

from symscrew.program.jacobians import Jacobian, jacobian
from symscrew.program.lanes import Pack, Packing, Vector, packed
from symscrew.program.rank_revealing import RANK, SWITCH, RankRevealing, evaluate_rank_revealing, second_path
from symscrew.program.straight_line import (
    COUNTED,
    STATUS,
    Function,
    Instruction,
    Iteration,
    Port,
    Program,
    evaluate,
    evaluate_iteration,
    lower,
    roots_of,
    with_roots,
)

__all__ = [
    "COUNTED",
    "RANK",
    "STATUS",
    "SWITCH",
    "Function",
    "Instruction",
    "Iteration",
    "Jacobian",
    "Pack",
    "Packing",
    "Port",
    "Program",
    "RankRevealing",
    "Vector",
    "evaluate",
    "evaluate_iteration",
    "evaluate_rank_revealing",
    "jacobian",
    "lower",
    "packed",
    "roots_of",
    "second_path",
    "with_roots",
]
