"""What a finite-mobility result rests on, kept so that it can be checked again by another route.

The result is found with finite displacements by exponentials; it is checked with power series by screw brackets
(`tangent_cone`), and isolated configurations, which are found with brackets or a definite form, by finite
displacements: there must be no zero of the reduced closure around them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.finite.local_solutions import CLOSED, flatten, local_at
from symscrew.mobility.finite.reduced_closure import ReducedClosure, is_zero
from symscrew.mobility.finite.tangent_cone import continued
from symscrew.mobility.finite.variety import DIGITS_60, Array, ClosureVariety, moved
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import null_space

ORDERS = 4
"""Order up to which power series must close; the evidence says so. A redundant equation that fails at a higher order
only would have been seen by the finite motions, by which the claim was found."""
RADIUS = 0.02
"""Of the sphere on which an isolated configuration must have no zeros: the smaller one of the search for branches."""
CLOSED_IN_DOUBLE = 1e-13
"""Closure residual of a zero in double precision."""
MOTIONS = 2
"""Random motions whose power series are looked at."""
STARTS, STARTS_PER_FREEDOM = 24, 8
"""Random directions, each with its opposite, from which zeros around an isolated configuration are looked for."""


@dataclass(frozen=True)
class Witness:
    """A claim about one block of the mechanism (its passive spins left out).

    `kind`: `smooth` (the configuration space is a manifold of `dimension` here), `isolated`, or `branch` (a manifold
    of `dimension` at the displacements `point`, 60 digits, to which a branch through this configuration leads;
    `instantaneous` freedoms there, more than `dimension` on a branch that is shaky all along).
    """

    network: Network
    kind: str
    dimension: int
    instantaneous: int
    point: Array | None = None

    def __repr__(self) -> str:
        return f"<Witness: {self.kind}, dimension {self.dimension}, of {self.network!r}>"


def recheck(witness: Witness) -> tuple[str, bool, str]:
    """(claim, whether it holds, evidence)."""
    if witness.kind == "isolated":
        return _isolated(witness)
    network, closed = witness.network, ""
    if witness.point is not None:
        fine = ClosureVariety(network, DIGITS_60)
        residual = float(np.linalg.norm(fine.evaluate(witness.point[None])[0][0].astype(float)))
        # a zero on a branch that is shaky all along is a double one: Newton's method does not refine it
        if residual > (CLOSED if witness.dimension == witness.instantaneous else CLOSED_IN_DOUBLE):
            return "a point of the branch closes all loops", False, f"residual {residual:.0e}"
        network, closed = moved(network, fine, witness.point), f"closed to {residual:.0e} by exponentials; "
    claim = f"a {witness.kind} of dimension {witness.dimension}" if closed else f"smooth, dimension {witness.dimension}"
    if witness.dimension < witness.instantaneous:
        return claim, True, f"{closed}{witness.instantaneous} instantaneous freedoms, shaky all along, so sampled"
    motions = null_space(network.loop_rows(), network.freedoms).basis
    if len(motions) != witness.instantaneous:
        return claim, False, f"{closed}{len(motions)} instantaneous freedoms instead of {witness.instantaneous}"
    matrix = np.array(motions, dtype=object)
    for weights in flatten(len(motions), MOTIONS) if motions else ():
        rates = np.array([CONTEXT.mpf(float(w)) for w in weights], dtype=object) @ matrix
        arc = continued(network, rates, ORDERS)
        if arc.order is not None:
            return claim, False, f"{closed}a motion stops at order {arc.order}"
    return (
        claim,
        True,
        f"{closed}power series of {min(MOTIONS, len(motions))} motions by brackets close up to order {ORDERS}",
    )


def _isolated(witness: Witness) -> tuple[str, bool, str]:
    variety = ClosureVariety(witness.network)
    motions = null_space(witness.network.loop_rows(), witness.network.freedoms).basis
    here = local_at(variety, np.zeros(variety.columns), motions=motions)
    reduced = ReducedClosure(variety, here)
    starts = np.array([d * sign for d in flatten(here.dof, STARTS + STARTS_PER_FREEDOM * here.dof) for sign in (1, -1)])
    values = reduced.evaluate(RADIUS * starts)
    scale = float(np.median(np.abs(values.g[values.solved]).max(axis=1)))
    ends = reduced.zeros_on_sphere(RADIUS * starts, RADIUS, scale)
    found = len(is_zero(ends, RADIUS, scale))
    text = f"{found} zeros of the reduced closure from {len(starts)} starts on a sphere of radius {RADIUS}"
    return "the configuration is isolated", found == 0, text
