"""Branches through the reference configuration, none missing: by what exact algebra finds there.

    components through the reference --each smooth there--> how many branches of each dimension
    BranchTable --as many were seen--> complete, proved
    loops' polynomials --smooth parts, combinations that show them--> evidence that a proof file carries

Variables that settle all joints are a chart of the configuration space, so that its branches through the reference are
those of the components through it. A component that is smooth there is one branch, real as the reference is. Nothing is
concluded where one is singular there, where exact algebra did not end, where joints are not among the variables, or
where other branches were seen.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from symscrew.mobility.analysis import Mobility
from symscrew.mobility.components import UNCHECKED, ConfigurationSpace
from symscrew.mobility.motion_verdicts import confirmed, why_complete, with_proof
from symscrew.mobility.proofs import motion_proof, with_parts

SMOOTH = "each component through the reference is smooth there, which is one branch, or a point alone"


def with_rechecked_parts(found: Mobility) -> Mobility:
    """The result with the branches by smooth parts whose evidence is in its proof file; as it was where there is none.

    Of the reference as typed, in exact numbers; needs the program of exact algebra, and seconds.
    """
    if not found.in_reference or found.taken is not None or found.finite.dof is None:
        return found
    numbers, before = found.evidence
    evidence = with_parts(numbers, before)
    proof = motion_proof(numbers, evidence)
    if evidence["blocks"] == before["blocks"] or proof is None:
        return found
    finite, table = confirmed(found.network, found.finite, proof), found.branches
    complete = why_complete(finite, proof)
    result = replace(found, finite=finite)
    vars(result).update({name: value for name, value in vars(found).items() if name not in vars(result)})  # as it was
    if table is not None and not table.complete and complete:
        table = with_proof(replace(table, complete=complete, open=""), finite, proof)
    vars(result).update(branches=table, evidence=(numbers, evidence), motion_proof=proof)
    return result


def with_components(found: Mobility, space: ConfigurationSpace | str) -> Mobility:
    """The result with the branches that components prove; as it was where they prove nothing of it."""
    typed = found.in_reference and found.taken is None
    table = found.branches if typed else None
    if table is None or isinstance(space, str) or not (space.settles and space.proved):
        return found
    through, free = [part for part in space.parts if part.through], _outside(found)
    if not through or any(part.multiplicity != 1 for part in through):
        return found
    proved, seen = (Counter(d) for d in ((p.dimension + free for p in through), (r.dimension for r in table.rows)))
    highest = max(proved)
    agrees = seen == proved if highest else not seen  # a configuration alone is no branch
    finite, dimensions = found.finite, tuple(sorted(seen))
    if not agrees or (finite.dof, finite.branches) not in ((highest, None), (highest, dimensions)):
        return found
    how = f"exact algebra over {space.field}, {UNCHECKED}: {SMOOTH}"
    if not finite.proved:
        finite = replace(finite, proved=True, evidence=(*finite.evidence, f"proved: {how}"))
    result = replace(found, finite=finite)
    vars(result).update({name: value for name, value in vars(found).items() if name not in vars(result)})  # as it was
    vars(result)["branches"] = table if table.complete else replace(table, complete=how, open="")
    return result


def _outside(found: Mobility) -> int:
    """Freedoms of joints that are in no loop, which move on every branch."""
    network = found.network
    looped = {name for loop in network.loops() for name, _ in loop}
    return sum(len(edge.screws) for name, edge in network.edges.items() if name not in looped)
