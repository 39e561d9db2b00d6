"""A place among the parameters where something degenerates."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

AT_ONCE = "where several conditions on the parameters hold at once: degenerations there are not listed"
"""What common factors of minors do not tell, after whose minors they are."""


@dataclass(frozen=True)
class Locus:
    """Parameter values where something degenerates: `expression` = 0.

    `kind`: limb, constraint, couple, through O; actuation (`where` are the drives), closure.
    """

    kind: str
    where: str
    expression: sympy.Expr
    meaning: str
