"""What is proved of the motion and what was sampled: by the ranks, by a proof of its own, of the table of branches.

ranks as they were decided --judged--> finite mobility, proved or sampled
finite mobility, proof --confirmed--> finite mobility, proved
table of branches, proof --why_complete, with_proof--> complete, or what is open
"""

from __future__ import annotations

from dataclasses import replace

from symscrew.mobility.finite import FiniteMobility, finite_mobility, kind_of, smooth_mobility
from symscrew.mobility.instantaneous import Instantaneous
from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions import BranchTable
from symscrew.mobility.proofs import MotionProof
from symscrew.mobility.rank_evidence import Decisions

WELL_ABOVE = 1e-20
"""A pivot above this, relative to the largest entry, is none that rounding of 60 digits could make: a full rank that
has been found with such pivots stands without an exact field. Below it a full rank counts as sampled."""

STOPPED = (
    "the decimals of the description, taken as exact, stop the motion by less than that: differences below 1e-27 are "
    "taken for rounding"
)


def judged(network: Network, first_order: Instantaneous, decisions: Decisions) -> FiniteMobility:
    """The finite mobility: proved where the ranks that a proof rests on were decided, else as sampled."""
    rank, dof = first_order.closure.rank, first_order.dof
    full = rank in (len(first_order.rows), network.freedoms)
    if decisions.closure_exact and not full and decisions.groups is not None and sum(decisions.groups) == rank:
        dimensions = " + ".join(map(str, decisions.groups))
        text = (
            f"each loop moves in a group of displacements (dimensions {dimensions}, by brackets over "
            f"{decisions.field}), and the closure has that rank: smooth (implicit functions)"
        )
        return smooth_mobility(network, dof, text)
    found = finite_mobility(network)
    if not found.proved or decisions.closure_exact or not first_order.rows:
        return found
    if full and first_order.closure.smallest_pivot > WELL_ABOVE:  # no rounding of 60 digits makes such a pivot
        return found
    text = "sampled: the rank of the closure, on which this rests, was decided in 60 digits, which is no proof"
    return replace(found, proved=False, evidence=(*found.evidence, text))


def confirmed(network: Network, finite: FiniteMobility, proof: MotionProof | None) -> FiniteMobility:
    """What was sampled, as proved where evidence that a checker can judge shows the same.

    What was not decided by finite motions, such as singular configurations with couplings, or screws that are dependent
    but for a difference of 1e-11, is what is proved. Decimals that stop a motion which was seen to close up to rounding
    are said to do so.
    """
    if proof is not None and finite.dof is None and proof.smooth:
        smooth = smooth_mobility(network, proof.dof, f"proved: {proof.how}")
        return replace(smooth, evidence=(*finite.evidence, *smooth.evidence))
    if proof is not None and finite.dof is None and proof.branches is not None:
        kind, evidence = kind_of(proof.branches), (*finite.evidence, f"proved: {proof.how}")
        return FiniteMobility(proof.dof, False, proof.branches, kind, evidence, True)
    if proof is not None and finite.smooth and not proof.smooth:
        return replace(finite, evidence=(*finite.evidence, STOPPED))
    if proof is None or (proof.dof, proof.smooth, proof.branches) != (finite.dof, finite.smooth, finite.branches):
        return finite
    return replace(finite, proved=True, evidence=(*finite.evidence, f"proved: {proof.how}"))


def why_complete(finite: FiniteMobility, proof: MotionProof | None) -> str:
    """Why no branch can be missing; empty where one may."""
    if finite.smooth and finite.proved:
        return "a smooth point has one branch" if finite.dof else "nothing moves"
    if proof is not None and (proof.dof, proof.branches) == (finite.dof, finite.branches):
        return proof.how
    return ""


def with_proof(table: BranchTable, finite: FiniteMobility, proof: MotionProof | None) -> BranchTable:
    """The table, open again where other branches were seen than are proved."""
    if not table.complete or proof is None or finite.smooth:
        return table
    count = proof.count if proof.dof else 0
    if len(table.rows) == count:
        return table
    return replace(table, complete="", open=f"{count} branches are proved, {len(table.rows)} were seen")
