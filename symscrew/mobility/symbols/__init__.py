"""Mobility without rounding: exact numbers, and formulas in the description's parameters.

    expressions --exact_field--> numbers in which zero is decidable --exact_screws, exact_ranks--> proved ranks
                                            --loop_groups--> groups in which loops move
    expressions --generators--> polynomials --polynomial_screws--> constraints, freedoms and loci of limbs
                                            --loop_motions--> joint rates of closed loops
                                            --limb_poses--> constraints of a limb in its own displacements
                                            --drive_loci--> where drives lose their hold

What is not of reasonable size is given up with a sentence (`EliminationTooLongError`, `FormulaTooLargeError`,
`NotPolynomialError`, `NotDecidableError`), which the result repeats.
"""

from symscrew.mobility.symbols.drive_loci import ActuationLoci, actuation_loci
from symscrew.mobility.symbols.exact_field import Field
from symscrew.mobility.symbols.exact_numbers import Exact, Generator, NotDecidableError, generator_itself, terms_of
from symscrew.mobility.symbols.exact_numbers import inverse as exact_inverse
from symscrew.mobility.symbols.exact_numbers import value as exact_value
from symscrew.mobility.symbols.exact_ranks import exact_rank, null_vectors, reduced
from symscrew.mobility.symbols.exact_screws import (
    ExactSystem,
    ExactTie,
    Row,
    across,
    coupled_lengths,
    exact_system,
    exact_ties,
    loop_rows,
    tie_row,
)
from symscrew.mobility.symbols.limb_poses import LimbPose, limb_pose, rounded_axis
from symscrew.mobility.symbols.locus import Locus
from symscrew.mobility.symbols.loop_groups import group_dimensions, screw_algebra
from symscrew.mobility.symbols.loop_motions import SymbolicLoops, symbolic_loops
from symscrew.mobility.symbols.polynomial_screws import (
    SymbolicMobility,
    SymbolicScrews,
    Vector,
    numbers_at,
    screws_of_limbs,
    symbolic_mobility,
    why_no_symbols,
)
from symscrew.mobility.symbols.short_loci import condition, conditions

__all__ = [
    "ActuationLoci",
    "Exact",
    "ExactSystem",
    "ExactTie",
    "Field",
    "Generator",
    "LimbPose",
    "Locus",
    "NotDecidableError",
    "Row",
    "SymbolicLoops",
    "SymbolicMobility",
    "SymbolicScrews",
    "Vector",
    "across",
    "actuation_loci",
    "condition",
    "conditions",
    "coupled_lengths",
    "exact_inverse",
    "exact_rank",
    "exact_system",
    "exact_ties",
    "exact_value",
    "generator_itself",
    "group_dimensions",
    "limb_pose",
    "loop_rows",
    "null_vectors",
    "numbers_at",
    "reduced",
    "rounded_axis",
    "screw_algebra",
    "screws_of_limbs",
    "symbolic_loops",
    "symbolic_mobility",
    "terms_of",
    "tie_row",
    "why_no_symbols",
]
