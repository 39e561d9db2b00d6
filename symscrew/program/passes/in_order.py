"""The table of passes over the nodes of a function: what `symscrew.program.lower` does before it writes instructions.

    roots (results and guarded pivots) --pass--> roots --pass--> ... --> instructions

A pass takes the roots and gives as many nodes of the same values, on the same tape. A new one is a file in this folder
and a line here. What holds whatever a function reads (0 x = 0, equal nodes are one) the tape does when a node is made;
a pass is for what can only be judged when all results are known: what else reads a node.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from symscrew.algebra import Node
from symscrew.program.passes.common_factors import factored
from symscrew.program.passes.complements import complemented
from symscrew.program.passes.reciprocals import shared_reciprocals

Pass = Callable[[Sequence[Node]], list[Node]]

PASSES: tuple[Pass, ...] = (
    complemented,  # before the digits that it saves are multiplied into something
    shared_reciprocals,  # first: the products that it makes may have factors in common
    factored,
)
