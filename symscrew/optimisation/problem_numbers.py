"""Numbers of a problem that may change from one solve to the next: what is compiled once holds symbols for them.

problem --number(name, get)--> symbol in the functions of a point;    values(problem) --> what the symbols stand for
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import casadi as ca
import numpy as np

from symscrew.optimisation.problem import TrajectoryProblem

Get = Callable[[TrajectoryProblem], float]


@dataclass
class ProblemNumbers:
    """Symbols of numbers by name, in the order in which the functions of a point asked for them."""

    symbols: dict[str, ca.SX] = field(default_factory=dict)
    getters: list[Get] = field(default_factory=list)

    def __call__(self, name: str, get: Get) -> ca.SX:
        """The symbol of a number; `get` finds its value in a problem."""
        if name not in self.symbols:
            self.symbols[name] = ca.SX.sym(name)
            self.getters.append(get)
        return self.symbols[name]

    @property
    def vector(self) -> ca.SX:
        """All symbols in one vector."""
        return ca.vertcat(ca.SX(0, 1), *self.symbols.values())

    def values(self, problem: TrajectoryProblem) -> np.ndarray:
        """What the symbols stand for in a problem of the same shape."""
        return np.array([get(problem) for get in self.getters], dtype=float)
