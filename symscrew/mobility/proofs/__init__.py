"""Proofs of a mobility verdict that others can check: the evidence in exact numbers, and the checker of a proof file.

    Mechanism --proof_numbers--> exact numbers --rank_proofs, motion_proofs, evidence--> evidence
              exact algebra --parts_proof--> combinations of polynomials that are multiplied out
    ModeConnections --way_proofs--> tubes around ways between assembly modes
    JSON      --proof_checker, way_checker--> every claim proved, refused, or said to be sampled

The file itself is written by `symscrew/mobility/proof_file.py`, from a whole verdict.

`proof_checker` imports nothing else of the package and needs Python alone; it is run as

    python -m symscrew.mobility.proofs.proof_checker FILE

and beside it `way_checker`, of ways between assembly modes, which needs it and nothing else.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.mobility.proofs.evidence import Evidence, MotionProof, gathered, motion_proof, with_parts
    from symscrew.mobility.proofs.proof_checker import COUPLED, FORMAT, Verdict, check_proof, digest, facts_of
    from symscrew.mobility.proofs.proof_numbers import described
    from symscrew.mobility.proofs.rank_proofs import rank_entry
    from symscrew.mobility.proofs.way_checker import CONNECTED, SEPARATED, check_ways
    from symscrew.mobility.proofs.way_proofs import WayEvidence, certified_modes, way_evidence

__all__ = [
    "CONNECTED",
    "COUPLED",
    "FORMAT",
    "SEPARATED",
    "Evidence",
    "MotionProof",
    "Verdict",
    "WayEvidence",
    "certified_modes",
    "check_proof",
    "check_ways",
    "described",
    "digest",
    "facts_of",
    "gathered",
    "motion_proof",
    "rank_entry",
    "way_evidence",
    "with_parts",
]

__getattr__ = doors(__name__)
