"""A place among the parameters where something degenerates."""

from __future__ import annotations

from dataclasses import dataclass

import sympy


@dataclass(frozen=True)
class Locus:
    """Parameter values where something degenerates: `expression` = 0.

    `kind`: limb, constraint, couple, through O; actuation (`where` are the drives), closure.
    """

    kind: str
    where: str
    expression: sympy.Expr
    meaning: str
