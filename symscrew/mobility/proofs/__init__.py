"""Proofs of a mobility verdict that others can check: a file of exact numbers, and its checker.

    Mobility --proof_numbers--> exact numbers of the mechanism --rank_proofs, motion_proofs, evidence--> evidence
             --proof_file--> JSON --proof_checker--> every claim proved, refused, or said to be sampled

`proof_checker` imports nothing else of the package and needs Python alone; it is run as

    python -m symscrew.mobility.proofs.proof_checker FILE
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.mobility.proofs.evidence import Evidence, MotionProof, gathered, motion_proof
    from symscrew.mobility.proofs.proof_checker import Verdict, check_proof
    from symscrew.mobility.proofs.proof_file import mobility_proof, write_proof

__all__ = [
    "Evidence",
    "MotionProof",
    "Verdict",
    "check_proof",
    "gathered",
    "mobility_proof",
    "motion_proof",
    "write_proof",
]

__getattr__ = doors(__name__)
