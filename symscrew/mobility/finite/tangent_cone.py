"""Higher-order closure by screw brackets: the kinematic tangent cone, order by order.

    V(t) = sum of S_k(t) u_k(t) before the joint,  dS/dt = [V, S],  closure: sum of signed S_k(t) u_k(t) = 0

A joint screw is carried by the bodies before it, dS/dt = [V, S], so along rates given as power series in t all
screws, twists and closures follow as power series with brackets only: no differences, any arithmetic.
(A. Mueller, Higher-order local analysis of kinematic loops, J. Mechanisms Robotics 8, 2016, 021016.)

Second order: an instantaneous motion x goes on only if the self-stresses do no work on the brackets that it makes,
lambda . Q(x, x) = 0. Order k: the equation for the k-th coefficient of the rates must have a solution.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.coupled_rates import Tie
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import null_space

Array = np.ndarray[Any, Any]

NO_WORK = 1e-25
"""Work of a unit self-stress, relative to what it acts on, that counts as none: the coefficients are solved to 1e-56
and pass through a few orders of brackets. A real obstruction is a number of the geometry, of order one."""
CUT_OFF = 1e-11
"""Singular values below this, relative, are left out of the inverse in double precision: the rank has been decided
in 60 digits, and the redundant rows have values of 1e-16. A well-posed closure has none between."""
SOLVED = 1e-56
"""Residual of a linear system that is rounding of 60 digits: further steps gain nothing."""
STEPS = 6
"""Steps of refinement with an inverse in double precision: each adds about 14 digits, so five give 60."""


@dataclass(frozen=True)
class Arc:
    """How far an instantaneous motion can be continued, in powers of t.

    `order`: the first order at which the loops cannot stay closed, None if they could up to the last one tried;
    `obstruction`: work of unit self-stresses on what is left there (0 without one).
    """

    order: int | None
    obstruction: float


def second_order(
    network: Network, screws: Array, stresses: Array, motions: Array, *, displaced: Array | None = None
) -> Array:
    """One symmetric matrix per self-stress: stress . (second derivative of the closure) on the motions.

    Args:
        network: the graph.
        screws: n x 6, of all freedoms at O.
        stresses: k x rows; row 6 l + i belongs to component i of loop l, those of couplings follow.
        motions: n x d, columns are instantaneous motions.
        displaced: displacements (n,) at which the screws are, for the couplings; by default none.

    Returns:
        k x d x d; the work of stress k on the closure's acceleration along rates u is u . Q_k . u.
    """
    carried = _carriers(network)
    count, dof = len(screws), motions.shape[1]
    twists = _zeros(screws.dtype, count, 6, dof)
    for column, before in enumerate(carried):
        for other, sign in before:
            twists[column] = twists[column] + sign * np.outer(screws[other], motions[other])
    rates = np.stack([_brackets(twists[c], screws[c]) for c in range(count)]) if count else twists
    forms = _zeros(screws.dtype, len(stresses), dof, dof)
    for k, stress in enumerate(stresses):
        for l, loop in enumerate(network.loops()):
            part = stress[6 * l : 6 * l + 6]
            for name, sign in loop:
                for column in network.edges[name].columns:
                    forms[k] = forms[k] + sign * np.outer(part @ rates[column], motions[column])
        for pull, tie in zip(stress[6 * len(network.chords) :], network.ties, strict=True):
            for term in tie.terms:
                column = network.tied_column(term.joint, term.motion)
                bend = term.bend(0 if displaced is None else displaced[column])
                bend = bend if screws.dtype == object else float(bend)
                forms[k] = forms[k] + pull * bend * np.outer(motions[column], motions[column])
    return np.asarray((forms + np.swapaxes(forms, 1, 2)) / 2)


def continued(network: Network, direction: Sequence[Any], orders: int = 5) -> Arc:
    """Continues the motion that starts along `direction`, an instantaneous motion in 60 digits.

    With one instantaneous freedom the answer does not depend on choices; with more, corrections are made without
    new instantaneous motions, which is enough to confirm a manifold whose tangent space they are.
    """
    rows = network.loop_rows()
    if not rows:
        return Arc(None, 0.0)
    jacobian = np.array(rows, dtype=object)
    stresses = np.array(null_space(jacobian.T.tolist(), len(rows)).basis, dtype=object)
    inverse = np.linalg.pinv(jacobian.astype(float), rcond=CUT_OFF)
    series = _Series(network, np.array(direction, dtype=object))
    for order in range(2, orders + 1):
        known = series.advance()
        work = 0.0
        for stress in stresses:
            size = CONTEXT.sqrt(sum(c * c for c in stress))
            work = max(work, float(abs(stress @ known) / size))
        if work > NO_WORK * max(1.0, max(float(abs(c)) for c in known)):
            return Arc(order, work)
        series.correct(_solved(jacobian, inverse, -known))
    return Arc(None, 0.0)


class _Series:
    """Power series of rates, screws and twists, one more coefficient at a time."""

    def __init__(self, network: Network, rates: Array) -> None:
        self.network = network
        self.rates = [rates]
        self.screws = [np.array(network.screws, dtype=object)]
        self.carriers = _carriers(network)

    def advance(self) -> Array:
        """The next coefficient of the closure velocities, without the next rates."""
        m = len(self.rates)
        twists = [self._carried(a) for a in range(m)]
        total = _total(_crossed(twists[a], self.screws[m - 1 - a]) for a in range(m))
        self.screws.append(total / CONTEXT.mpf(m))
        return self._closure(_total(self.screws[m - b] * self.rates[b][:, None] for b in range(m)))

    def correct(self, rates: Array) -> None:
        """Sets the next rates."""
        self.rates.append(rates)

    def _carried(self, order: int) -> Array:
        """Coefficient `order` of the twist that carries each screw."""
        flow = _total(self.screws[order - b] * self.rates[b][:, None] for b in range(order + 1))
        result = _zeros(object, *flow.shape)
        for column, before in enumerate(self.carriers):
            for other, sign in before:
                result[column] = result[column] + flow[other] if sign > 0 else result[column] - flow[other]
        return result

    def _closure(self, flow: Array) -> Array:
        result = []
        for loop in self.network.loops():
            total = _zeros(object, 6)
            for name, sign in loop:
                for column in self.network.edges[name].columns:
                    total = total + sign * flow[column]
            result.append(total)
        return np.concatenate([*result, np.array([self._tied(tie) for tie in self.network.ties], dtype=object)])

    def _tied(self, tie: Tie) -> Any:
        """The next coefficient of a coupling's velocity, without the next rates: of its powers from the second on."""
        m = len(self.rates)
        total = CONTEXT.zero
        for term in tie.terms:
            column = self.network.tied_column(term.joint, term.motion)
            d = [CONTEXT.zero, *(self.rates[k][column] / (k + 1) for k in range(m)), CONTEXT.zero]
            power = d
            for c in term.coefficients[1:]:
                power = [sum(power[i] * d[k - i] for i in range(k + 1)) for k in range(m + 2)]
                total = total + c * power[m + 1]
        return (m + 1) * total


def _carriers(network: Network) -> list[list[tuple[int, int]]]:
    """For each column the (column, sign) of the freedoms that move its screw: those before its joint, and in it."""
    result: list[list[tuple[int, int]]] = [[] for _ in range(network.freedoms)]
    for edge in network.edges.values():
        before = [(column, sign) for name, sign in network.path(edge.parent) for column in network.edges[name].columns]
        for motion, first in edge.motions:
            columns = range(first, first + motion.freedom)
            for column in columns:
                result[column] = list(before)
            before += [(column, 1) for column in columns]
    return result


def _brackets(twists: Array, screw: Array) -> Array:
    """[V, S] for every column V of a 6 x d matrix."""
    return _crossed(twists.T, np.broadcast_to(screw, (twists.shape[1], 6))).T


def _crossed(twists: Array, screws: Array) -> Array:
    """[V, S] = (omega x s ; omega x s_O + v x s) row by row."""
    angular = _cross(twists[:, :3], screws[:, :3])
    linear = _cross(twists[:, :3], screws[:, 3:]) + _cross(twists[:, 3:], screws[:, :3])
    return np.concatenate([angular, linear], axis=1)


def _cross(a: Array, b: Array) -> Array:
    x = a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1]
    y = a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2]
    z = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return np.stack([x, y, z], axis=1)


def _total(terms: Iterable[Array]) -> Array:
    return reduce(add, terms)


def _zeros(dtype: Any, *shape: int) -> Array:
    result = np.empty(shape, dtype=dtype)
    result[...] = CONTEXT.zero if np.dtype(dtype).hasobject else 0.0
    return result


def _solved(jacobian: Array, inverse: Array, right: Array) -> Array:
    """x with jacobian x = right, which has a solution; every step of the double-precision inverse adds 14 digits."""
    x = _zeros(object, jacobian.shape[1])
    for _ in range(STEPS):
        left = (right - jacobian @ x).astype(float)
        if np.abs(left).max() < SOLVED:
            break
        x = x + np.array([CONTEXT.mpf(float(c)) for c in inverse @ left], dtype=object)
    return x
