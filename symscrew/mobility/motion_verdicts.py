"""What a proof of the motion adds to what was sampled: a finite mobility proved, a table of branches complete.

finite mobility, proof --confirmed--> finite mobility, proved
table of branches, proof --why_complete, with_proof--> complete, or what is open
"""

from __future__ import annotations

from dataclasses import replace

from symscrew.mobility.finite import FiniteMobility
from symscrew.mobility.motions import BranchTable
from symscrew.mobility.proofs import MotionProof


def confirmed(finite: FiniteMobility, proof: MotionProof | None) -> FiniteMobility:
    """What was sampled, as proved where evidence that a checker can judge shows the same."""
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
