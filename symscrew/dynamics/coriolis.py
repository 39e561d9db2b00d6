"""Forces of the tree at rest accelerations, branch by branch in the cheaper of two ways.

The recursion of Newton and Euler takes every link's acceleration. Where the mass matrix is at hand anyway, the terms
in the rates also follow from its derivatives (Christoffel symbols of the first kind),

    h_i = sum over j, k of (dM_ij / dq_k - 1/2 dM_jk / dq_i) v_j v_k,

and only gravity and what acts are left for the recursion. For a short limb with few entries that is less work: a leg
on a universal joint has a diagonal mass matrix, with three derivatives that are not zero. Which way is shorter is
decided for every branch by itself; what the branches share with the rest of a function is for the caller to count.
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import ZERO, Node, add, cost, differentiate, is_zero
from symscrew.dynamics.tree_dynamics import balanced_forces, generalised_forces
from symscrew.effects import Acting
from symscrew.kinematics import NO_SPREAD, Inertia, System, inertial_wrench, rates

SHORT = 6
"""Freedoms of a branch up to which both ways are built and counted. A branch of n freedoms has n^2 (n + 1) / 2
Christoffel symbols, the recursion's work grows with n: of longer branches only the recursion is built."""


def still_forces(system: System, acting: Acting, inertia: Sequence[Sequence[Node]]) -> list[Node]:
    """Generalised forces (for v) that the tree needs without accelerations, less what acts; `inertia` is its matrix."""
    tree, tape = system.tree, system.tape
    still = [tape.zero] * len(tree.v)
    result = generalised_forces(system, acting, still)
    given = all(q.op == "symbol" for q in system.inputs.q)  # else angles may stand in their cosines and sines only
    if not given or not acting.keeps_motion or acting.bendings or any(not is_zero(c) for c in acting.ground.omega):
        return result
    lean = acting.lean_inertia()
    resting = rates(system.linkage, still, still, ground=acting.ground)
    weights = {k: inertial_wrench(lean[k], resting[k]) for k in range(1, len(lean))}
    if not acting.keeps_gyroscopic_moments:  # the derivatives of the mass matrix have these moments in them
        moving = acting.link_rates(still)
        for k, (pull, moment) in weights.items():
            _, couple = inertial_wrench(Inertia(tape.zero, ZERO, NO_SPREAD, lean[k].still), moving[k])
            weights[k] = pull, add(moment, couple)
    weighed = balanced_forces(system, acting, still, weights)
    for places in _branches(system):
        centrifugal = _christoffel(system, places, inertia)
        other = [weighed[k] + force for k, force in zip(places, centrifugal, strict=True)]
        known = [inertia[i][j] for i in places for j in places]
        present = cost([*known, *(result[k] for k in places)])
        if cost([*known, *other]) < present:
            for k, force in zip(places, other, strict=True):
                result[k] = force
    return result


def _branches(system: System) -> list[list[int]]:
    """Rates of the branches on the ground that are short and have coordinates for rates."""
    return [places for places in _plain_branches(system) if 0 < len(places) <= SHORT]


def long_branches(system: System) -> int:
    """How many branches of a system are too long for the derivatives of their mass matrix, see `SHORT`."""
    return sum(len(places) > SHORT for places in _plain_branches(system))


def _plain_branches(system: System) -> list[list[int]]:
    """Rates of the branches on the ground that have coordinates for rates: no spherical motions."""
    places: dict[int, list[int]] = {}
    plain: dict[int, bool] = {}
    for link in system.tree.links[1:]:
        root = system.tree.path(link.index)[-1]
        places.setdefault(root, []).extend(range(link.v.start, link.v.stop))
        plain[root] = plain.get(root, True) and not link.motion.spherical
    return [places[root] for root in places if plain[root]]


def _christoffel(system: System, places: Sequence[int], inertia: Sequence[Sequence[Node]]) -> list[Node]:
    tape, v, half = system.tape, system.inputs.v, system.tape.reciprocal(system.tape.node(2))
    coordinate = {
        k: system.inputs.q[link.q.start] for link in system.tree.links[1:] for k in range(link.v.start, link.v.stop)
    }
    pairs = [(i, j) for n, i in enumerate(places) for j in places[: n + 1] if inertia[i][j].value is None]
    names = [str(k) for k in places]
    seeds = {coordinate[k]: {str(k): tape.one} for k in places}
    found = differentiate(tape, [inertia[i][j] for i, j in pairs], seeds, names, order="forward")
    result = dict.fromkeys(places, tape.zero)
    for (i, j), row in zip(pairs, found, strict=True):
        for k, by in zip(places, row, strict=True):
            if by is tape.zero:
                continue
            if i == j:
                part = half * by
                result[k] = result[k] - part * (v[i] * v[i])
                result[i] = result[i] + (2 * part) * (v[i] * v[k])
                continue
            result[k] = result[k] - by * (v[i] * v[j])
            result[i] = result[i] + by * (v[j] * v[k])
            result[j] = result[j] + by * (v[i] * v[k])
    return [result[k] for k in places]
