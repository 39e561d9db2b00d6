"""States at which nodes are compared and pivots are chosen: consistent with the loops, and the same on every machine.

random q near the reference --closed--> loops closed --random rates in the null space--> (q, v, a)
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from symscrew.algebra import least_norm
from symscrew.kinematics.closure_jacobian import ClosureJacobian
from symscrew.kinematics.recursion import rates, twists
from symscrew.kinematics.structure import Structure

Array = np.ndarray[Any, Any]
States = tuple[Array, Array, Array]

SAMPLES = 5
"""Random states beside the reference configuration. What is zero by accident at one of them is not at all six; more
of them make every constant folding and every choice of a pivot slower and change no decision."""

SEED = 20230811
"""Another seed gives other sample states, and so perhaps another order of elimination, in what is generated."""

SPREAD = 0.15
"""How far q is away from the reference [rad, or of the characteristic length]: far enough that nothing special
is left of it, near enough that the loops can be closed from there."""

LARGEST_STEP = 0.3
"""A Newton step is shortened to that [rad, or of the characteristic length]: a longer one may leave the branch."""

MOST_STEPS = 60
"""Newton steps, of which few are used; a state whose loops are still open then is replaced by one that closed."""

CLOSED = 1e-14
"""Residual [m, rad] below which no further step is taken: rounding noise for mechanisms of up to a metre, and relative
to the characteristic length of larger ones."""

GOOD = 1e-11
"""Residual up to which a state counts as closed: rounding is far below it, and a state that did not close far above."""


class SampleStates:
    """Consistent states of a structure; `closure` is its closure at the inputs of the tree."""

    def __init__(self, structure: Structure, closure: ClosureJacobian) -> None:
        self.structure, self.closure = structure, closure
        self._known: dict[tuple[int, int], States] = {}

    @cached_property
    def chosen(self) -> States:
        """(q, v, a): first the reference configuration, then others near it; shapes (samples, n).

        The same bits on every machine: they choose pivots and stand in what is generated.
        """
        return self.states(SAMPLES, SEED)

    def states(self, count: int, seed: int) -> States:
        """The reference configuration and `count` random ones near it with consistent v, a; shapes (1 + count, n).

        Found once: every function that is printed in single precision asks for its errors at the same ones. The arrays
        are the caller's own.
        """
        if (count, seed) not in self._known:
            self._known[count, seed] = self._consistent(count, seed)
        q, v, a = self._known[count, seed]
        return q.copy(), v.copy(), a.copy()

    def _consistent(self, count: int, seed: int) -> States:
        random = np.random.default_rng(seed)
        structure = self.structure
        start = structure.reference[None, :]
        q = np.repeat(start, count, axis=0)
        q = structure.advance(q, SPREAD * structure.scales * random.uniform(-1, 1, (count, len(structure.scales))))
        if self.closure.cuts:
            q = self.closed(q)
        q = np.concatenate([start, q])
        v, a = self._rates(q, random)
        return q, v, a

    def closed(self, q: Array) -> Array:
        """Gauss-Newton onto the closure manifold from q (samples, n); states that do not get there become others."""
        structure, closure = self.structure, self.closure
        scales, size = structure.scales, max(1.0, structure.length)
        q, n = np.array(q), len(scales)
        count = len(closure.residual)
        left = np.arange(len(q))
        for _ in range(MOST_STEPS):
            both = structure.numeric([*closure.residual, *closure.dense()], (structure.inputs.q, q[left]))
            open_still = np.abs(both[:, :count]).max(axis=1) >= CLOSED * size
            left, both = left[open_still], both[open_still]
            if not len(left):
                break
            steps = np.array([least_norm(row[count:].reshape(-1, n) * scales, -row[:count]) for row in both])
            limits = np.maximum(1.0, np.abs(steps).max(axis=1) / LARGEST_STEP)
            q[left] = structure.advance(q[left], scales * steps / limits[:, None])
        residual = structure.numeric(closure.residual, (structure.inputs.q, q))
        good = np.abs(residual).max(axis=1) < GOOD * size
        if not good.any():
            return np.repeat(structure.reference[None, :], len(q), axis=0)
        return q[np.resize(np.flatnonzero(good), len(q))]

    def _rates(self, q: Array, random: np.random.Generator) -> tuple[Array, Array]:
        """Random rates in the null space of the closure, and accelerations that fit them."""
        structure, closure = self.structure, self.closure
        inputs, scales, linkage = structure.inputs, structure.scales, closure.linkage
        n = len(scales)
        w = random.uniform(-1, 1, (len(q), n)) * scales
        gain = random.uniform(-1, 1, (len(q), n)) * scales
        if not closure.cuts:
            return w, gain
        jacobian = structure.numeric(closure.dense(), (inputs.q, q)).reshape(len(q), -1, n)
        for i, j in enumerate(jacobian):
            w[i] -= scales * least_norm(j * scales, (j * w[i]).sum(axis=1))
        v = structure.numeric(linkage.tree_rates(inputs.v), (inputs.q, q), (inputs.v, w))
        still = rates(linkage, inputs.v, [structure.tape.zero] * n)
        opening = closure.bias(twists(linkage, inputs.v), still, inputs.v)
        bias = structure.numeric(opening, (inputs.q, q), (inputs.v, v))
        for i, j in enumerate(jacobian):
            gain[i] -= scales * least_norm(j * scales, (j * gain[i]).sum(axis=1) + bias[i])
        a = structure.numeric(linkage.tree_rates(inputs.v), (inputs.q, q), (inputs.v, gain))
        return v, a

    def keep(self, regular: Array) -> None:
        """Let some states, and the reference, stand for the others; `regular` (samples,) says which."""
        places = np.resize(np.flatnonzero(regular[1:]) + 1, len(regular) - 1)
        q, v, a = (array[[0, *places]] for array in self.chosen)
        self.chosen = (q, v, a)
        self.use()

    def use(self) -> None:
        """Give the tape's inputs their values at the chosen states."""
        structure = self.structure
        q, v, a = self.chosen
        values = {}
        for nodes, array in ((structure.inputs.q, q), (structure.inputs.v, v), (structure.inputs.a, a)):
            values.update({node: array[:, k] for k, node in enumerate(nodes)})
        for node, value in zip(structure.parameters, structure.parameter_values, strict=True):
            values[node] = np.full(len(q), value)
        structure.tape.set_samples(values)
