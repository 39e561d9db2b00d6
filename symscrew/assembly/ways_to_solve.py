"""The same closure solved in several ways, for a study of what each finds: Newton's method, paths, paths and boxes.

All give real zeros [count x coordinates], groups of length one, of a mechanism at its reference.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from symscrew.assembly.all_modes import DIGITS_60, known_zero, structure_of
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import certified
from symscrew.assembly.families import AllNumbers
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.rectangles import read
from symscrew.assembly.slot_numbers import Displacements
from symscrew.assembly.start_system import start_system, together
from symscrew.assembly.target_roots import realised, target_roots
from symscrew.assembly.what_is_held import held_by
from symscrew.description import Mechanism

Array = np.ndarray[Any, Any]

STEPS = 40
"""Of Newton's method from a guess: what has not converged by then wanders."""
CONVERGED = 1e-12
"""Step at which it has; guesses are of length one."""


class WaysToSolve:
    """Of a mechanism whose equations are as many as its unknowns, `square`."""

    def __init__(self, mechanism: Mechanism) -> None:
        held = held_by(mechanism, {}, {})
        structure = structure_of(held)
        if structure.equations > structure.unknowns:
            held = held.fewer()
            structure = structure_of(held)
        self.square = structure.unknowns == structure.equations and bool(structure.groups)
        if not self.square:
            return
        self.held, self.equations = held, BatchEquations(structure)
        self.family = AllNumbers(self.equations)
        self.goal = self.equations.coefficients(self.family.member({}))
        fine = Displacements(structure, DIGITS_60, held.exact).slots()
        self.boxes = [read(s) if np.ndim(s) == 0 else [read(c) for c in s] for s in fine]
        self.start = start_system(self.family, known_zero(self.equations))

    def by_newton(self, guesses: int, seed: int) -> Array:
        """From random guesses; those that do not converge give nothing."""
        z = self.equations.scaled(np.random.default_rng(seed).normal(size=(guesses, self.equations.width)) + 0j)
        tracker, last = Tracker(self.equations), np.ones(guesses)
        with np.errstate(all="ignore"):
            for _ in range(STEPS):
                step = tracker.newton(z, self.goal[None])
                z, last = self.equations.scaled(z + step), np.linalg.norm(step, axis=1)
        good = (last < CONVERGED) & (self.equations.norms(z).min(axis=1) > CONVERGED**0.5)
        return self.apart(z[good])

    def by_paths(self) -> Array:
        """Paths from a general mechanism in doubles."""
        account = target_roots(self.family, self.start, self.family.member({}))
        return self.apart(np.array([end.z for end in account.ends if end.kind == "real"]))

    def by_paths_and_boxes(self) -> Array:
        """The same, each with Krawczyk's test in integers and refined there."""
        found = [certified(self.equations, self.boxes, z) for z in self.by_paths()]
        return self.apart(np.array([box.z for box in found if box is not None]))

    def apart(self, zeros: Array) -> Array:
        """One of each, real."""
        kept = np.zeros((0, self.equations.width), dtype=complex)
        for z in self.equations.scaled(zeros.reshape(-1, self.equations.width) + 0j):
            if not together(self.equations, kept, z).any():
                kept = np.concatenate([kept, realised(self.equations, z)[None]])
        return np.asarray(kept.real)

    def distance(self, zeros: Array, known: Array) -> float:
        """The largest distance of a zero from the nearest known one, across the groups."""
        worst = 0.0
        for z in self.equations.scaled(zeros + 0j):
            gaps = [np.zeros(0)]
            for k in self.equations.scaled(known + 0j):
                parts = [min(np.abs(z[p] - k[p]).max(), np.abs(z[p] + k[p]).max()) for p in self.equations.parts]
                gaps.append(np.array([max(parts)]))
            worst = max(worst, float(np.concatenate(gaps).min(initial=np.inf)))
        return worst
