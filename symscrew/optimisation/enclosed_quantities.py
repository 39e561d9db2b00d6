"""Quantities of a plan on enclosures, over pieces of time in which it was followed.

expressions of the unknowns at a point, boxes of the branch --> enclosures of their values, two derivatives with them
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from symscrew.optimisation.enclosed_functions import EnclosedFunction
from symscrew.optimisation.enclosures import Arithmetic, Number
from symscrew.optimisation.followed_branch import Boxes, Branch
from symscrew.optimisation.planned_motion import PlannedMotion


class EnclosedQuantities:
    """Expressions in `symbols` (see `point_symbols`) along a plan."""

    def __init__(self, motion: PlannedMotion, branch: Branch, symbols: Mapping[str, ca.SX], values: ca.SX) -> None:
        self.motion, self.branch = motion, branch
        self.names = list(symbols)
        needed = ca.vertcat(*ca.symvar(values)) if values.numel() else ca.SX(0, 1)
        self.used = {name for name, s in symbols.items() if s.numel() and ca.depends_on(needed, s)}
        self.function = EnclosedFunction(ca.Function("quantities", list(symbols.values()), [values]))

    def over(self, boxes: Boxes) -> list[Number]:
        """An enclosure of every expression over the pieces of the boxes; a number where it is one."""
        pieces, motion = boxes.pieces, self.motion
        inputs: list[list[Number]] = []
        for name in self.names:
            if name not in self.used:
                inputs.append([0.0] * 1_000)
            elif name == "z":
                inputs.append(list(self.branch.enclosed(boxes)))
            elif name == "tau":
                inputs.append(self.branch.polynomials.time(pieces))
            elif name in ("T", "p"):
                given = motion.arrays[name] if name == "p" else np.array([motion.duration])
                inputs.append([float(v) for v in given])
            else:
                inputs.append(list(self.branch.polynomials.enclosed(name, pieces)))
        return self.function(Arithmetic(pieces.radius), inputs)[0]
