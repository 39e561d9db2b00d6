"""The evidence of a proof file, and what it shows of the real motion.

Mechanism --described--> exact numbers --block_entry--> proof of every part --facts_of, as the checker--> facts
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from symscrew.description import Mechanism
from symscrew.mobility.joint_network import Network
from symscrew.mobility.proofs.motion_proofs import accepted, block_entry
from symscrew.mobility.proofs.parts_proof import SECONDS, parts_proof
from symscrew.mobility.proofs.proof_checker import Block, facts_of
from symscrew.mobility.proofs.proof_numbers import ProofNumbers, described

Evidence = tuple[ProofNumbers, dict[str, Any]]
"""The description in exact numbers, and the evidence for the motion of every part, as the file has it."""
METHODS = {
    "none": "no instantaneous motion of it",
    "groups": "every loop moves in a group of displacements, and the rank is the sum of their dimensions",
    "limbs": "each limb reaches all of a group of displacements, and groups meet in a group",
    "stopped": "a self-stress does work on the only motion",
    "endless": "the only motion of the loop keeps it shut to order 16, which no isolated one of six joints does",
    "tied": "parts that are smooth without couplings, and couplings that are independent of them",
    "nested": "smooth in the loops of some joints alone, and all other loops are independent of these",
    "rigid": "joints with independent screws in loops of their own are at rest",
    "parts": "near the configuration the loops' polynomials are zero on smooth parts and nowhere else, multiplied out",
    "form": "the one redundant equation, or a combination of them, has a quadratic form that is not degenerate",
}
"""Kind of a proof -> how it shows the real motion, in words."""


@dataclass(frozen=True)
class MotionProof:
    """What is proved of the real motion in the reference configuration.

    `dof`, `smooth`, `branches` as in `FiniteMobility`; `count`: how many branches there are; `how`: in words;
    `resting`: joints in loops that move on none of them.
    """

    dof: int
    smooth: bool
    branches: tuple[int, ...] | None
    count: int
    how: str
    resting: tuple[str, ...] = ()


def gathered(mechanism: Mechanism, network: Network, body: str) -> Evidence:
    """The description in exact numbers, and the evidence for the motion of every part."""
    numbers = described(mechanism, network, body)
    return numbers, {"blocks": [block_entry(numbers, k) for k in range(len(numbers.read.blocks))], "ranks": {}}


def with_parts(numbers: ProofNumbers, values: dict[str, Any], seconds: float = SECONDS) -> dict[str, Any]:
    """Evidence with that of smooth parts, by exact algebra, wherever there was none of all branches before.

    The program of exact algebra has so many seconds of the processor for each block; the checker judges every proof.
    """
    blocks = []
    for k, entry in enumerate(values["blocks"]):
        name = ("block", str(k))
        block = Block(numbers.read, name, entry)
        if block.dimensions[2] is None:
            proof = parts_proof(numbers, block, seconds)
            if proof is not None and accepted(numbers, name, {**entry, "proof": proof}):
                entry = {**entry, "proof": proof}
        blocks.append(entry)
    return {**values, "blocks": blocks}


def motion_proof(numbers: ProofNumbers, values: dict[str, Any]) -> MotionProof | None:
    """The real motion in the reference configuration, where evidence proves it as a whole; else None."""
    facts = facts_of(numbers.read, values)
    if "finite mobility" not in facts or "branches" not in facts:
        return None
    kinds, count = list[str](), 1
    for k, whole in enumerate(values["blocks"]):
        entry = whole
        while entry["proof"]["kind"] == "rigid":
            kinds.append(METHODS["rigid"])
            entry = entry["proof"]["rest"]
        kind = entry["proof"]["kind"]
        kinds.append(METHODS[kind])
        motions = len(entry["rank"].get("null", ()))
        if kind == "form" and facts["branches"] and motions == 2 and _moves(numbers, k, whole):
            count *= 2  # two lines; from three motions on the cone of a form is one
        elif kind == "parts":
            count *= len(entry["proof"]["parts"])
    branches = None if facts["branches"] is None else tuple(facts["branches"])
    how = "; ".join(dict.fromkeys(kinds)) or "no loops"
    resting = tuple(facts.get("joints at rest", ()))
    return MotionProof(facts["finite mobility"], facts["smooth"], branches, count, how, resting)


def _moves(numbers: ProofNumbers, index: int, entry: dict[str, Any]) -> bool:
    """Whether a part is not isolated."""
    return Block(numbers.read, ("block", str(index)), entry).dimensions[0] > 0
