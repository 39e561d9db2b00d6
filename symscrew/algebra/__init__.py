"""Algebra of the field: screws, and the tape on which every derived quantity is defined once.

    numbers, symbols --Tape--> nodes --differentiation, elimination, rank volumes--> nodes --> functions of a model

screws              twists, wrenches and momentum screws at O; bracket, transforms, products
nodes               the tape: hash-consed nodes with their values at sample states
operations          what each operation means: in NumPy, in SymPy and with 60 digits
elementary          sines, cosines and the like with the same bits on every machine
from_text           expressions of a description as nodes
sympy_form          nodes as SymPy expressions
origins, naming     where nodes come from: quantity of the theory, body or joint, component
traversal           what stands behind nodes: operations, inputs, counts; substitution
differentiation     analytic derivatives
elimination         linear systems in an order fixed by sparsity, with guarded pivots
rank_volumes        where the rank of a grid of nodes falls
least_squares       shortest solutions of linear equations, with the same bits on every machine
"""

from symscrew.algebra.differentiation import differentiate
from symscrew.algebra.elementary import cos, sin
from symscrew.algebra.elimination import (
    NEGLIGIBLE,
    SAFE,
    Affine,
    Column,
    Elimination,
    Guard,
    Pivot,
    choose_pivot,
    combine,
    divides,
    eliminate,
    insert_solution,
    magnitude,
    pair,
    solve_block,
    solve_for,
)
from symscrew.algebra.from_text import expression_node
from symscrew.algebra.least_squares import least_norm
from symscrew.algebra.naming import (
    handed_on,
    named,
    named_entries,
    named_matrix,
    named_twist,
    named_vector,
    named_wrench,
)
from symscrew.algebra.nodes import Node, Tape, in_sixty_digits, is_zero
from symscrew.algebra.operations import ARITHMETIC, CONTEXT, apply_high_precision, apply_numpy, high_precision
from symscrew.algebra.origins import QUANTITIES, Origin
from symscrew.algebra.rank_volumes import (
    Grid,
    TooLargeError,
    Volume,
    most_independent,
    rank_of,
    reciprocal_factors,
    sampled,
    trimmed,
    vanishes,
    volume,
    zeroed,
)
from symscrew.algebra.screws import (
    IDENTITY,
    ZERO,
    Matrix,
    Momentum,
    Pose,
    Scalar,
    Twist,
    Vector,
    Wrench,
    add,
    as_vector,
    cross,
    dot,
    helical,
    prismatic,
    product,
    revolute,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.algebra.sympy_form import sympy_expression
from symscrew.algebra.tape_marks import TapeMark, tape_as_at, tape_mark
from symscrew.algebra.traversal import (
    LEAVES,
    cost,
    count_operations,
    evaluation_order,
    inputs_of,
    needed,
    remade,
    substitute,
    uses,
)

__all__ = [
    "ARITHMETIC",
    "CONTEXT",
    "IDENTITY",
    "LEAVES",
    "NEGLIGIBLE",
    "QUANTITIES",
    "SAFE",
    "ZERO",
    "Affine",
    "Column",
    "Elimination",
    "Grid",
    "Guard",
    "Matrix",
    "Momentum",
    "Node",
    "Origin",
    "Pivot",
    "Pose",
    "Scalar",
    "Tape",
    "TapeMark",
    "TooLargeError",
    "Twist",
    "Vector",
    "Volume",
    "Wrench",
    "add",
    "apply_high_precision",
    "apply_numpy",
    "as_vector",
    "choose_pivot",
    "combine",
    "cos",
    "cost",
    "count_operations",
    "cross",
    "differentiate",
    "divides",
    "dot",
    "eliminate",
    "evaluation_order",
    "expression_node",
    "handed_on",
    "helical",
    "high_precision",
    "in_sixty_digits",
    "inputs_of",
    "insert_solution",
    "is_zero",
    "least_norm",
    "magnitude",
    "most_independent",
    "named",
    "named_entries",
    "named_matrix",
    "named_twist",
    "named_vector",
    "named_wrench",
    "needed",
    "pair",
    "prismatic",
    "product",
    "rank_of",
    "reciprocal_factors",
    "remade",
    "revolute",
    "sampled",
    "scale",
    "sin",
    "solve_block",
    "solve_for",
    "substitute",
    "subtract",
    "sympy_expression",
    "tape_as_at",
    "tape_mark",
    "transform",
    "transpose",
    "trimmed",
    "uses",
    "vanishes",
    "volume",
    "zeroed",
]
