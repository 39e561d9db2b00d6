"""The proof file of a mobility verdict: what is claimed, what shows it, and what is sampled.

    Mobility --described, rank_entry, block_entry--> evidence --checker's facts--> claims | not proved --> JSON

Before a file is written, the checker judges it; a claim that the evidence contradicts stays there, and is refused.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from symscrew.mobility.analysis import Mobility
from symscrew.mobility.motion_verdicts import STOPPED
from symscrew.mobility.proofs import (
    COUPLED,
    FORMAT,
    Verdict,
    check_proof,
    check_ways,
    digest,
    facts_of,
    rank_entry,
)
from symscrew.whole_files import write_text

AS_MEANT = "with differences below 1e-27 taken for rounding, "
"""What the package takes for rounding (`screw_systems.ZERO_BELOW`) is a difference in exact numbers."""
OF_MOTION = ("finite mobility", "smooth", "branches")
SAMPLED = "sampled: no proof was found"


def mobility_proof(found: Mobility) -> dict[str, Any]:
    """The proof file's content, JSON values: exact numbers, claims, evidence; see `proof_checker`.

    Claims without a proof stand under `not proved`, with the reason: real motion that is sampled, ranks decided in 60
    digits only, and all of a displaced configuration, which has no exact coordinates.
    """
    numbers, evidence = found.evidence
    values: dict[str, Any] = {
        "format": COUPLED if "couplings" in numbers.values else FORMAT,
        "mechanism": numbers.values,
        "digest": digest(numbers.values),
    }
    names = ["closure twist", "closure turning", *(["closure drives"] if found.network.driven else [])]
    names += [f"limb {name}" for name, limb in found.mechanism.limbs.items() if limb.joints]
    values["blocks"] = evidence["blocks"]
    values["ranks"] = {name: rank_entry(numbers, numbers.read.matrix(name.split(" ", 1))) for name in names}
    facts = facts_of(numbers.read, values)
    claims, open_claims = [], []
    rounded = any(d.exact not in (None, d.numeric) for d in found.decisions.ranks)
    for claim, value in _statements(found):
        if not found.in_reference:
            open_claims.append((f"displaced, {claim}", value, "the displaced configuration has no exact coordinates"))
        elif claim not in facts:
            open_claims.append((claim, value, numbers.why or _why(found, claim)))
        elif facts[claim] != value and (rounded or (claim in OF_MOTION and _closed(found))):
            claims.append({"claim": claim, "value": facts[claim]})
            open_claims.append((AS_MEANT + claim, value, found.decisions.why or STOPPED))
        else:
            claims.append({"claim": claim, "value": value})
    if "joints at rest" in facts and found.in_reference:
        claims.append({"claim": "joints at rest", "value": facts["joints at rest"]})
    for bound in ("finite mobility at least", "finite mobility at most"):
        if "finite mobility" not in facts or not found.in_reference:
            claims.append({"claim": bound, "value": facts[bound]})
    if not claims:
        claims.append({"claim": "joint freedoms", "value": facts["joint freedoms"]})
    values["claims"] = claims
    values["not proved"] = [{"claim": c, "value": v, "why": why} for c, v, why in open_claims]
    return values


def _statements(found: Mobility) -> Iterator[tuple[str, Any]]:
    """What the result says, in the checker's words."""
    yield "joint freedoms", found.network.freedoms
    yield "independent loops", len(found.network.chords)
    yield "Kutzbach-Gruebler", found.kutzbach
    yield "instantaneous mobility", found.dof
    yield "redundant constraints", found.overconstraints
    yield f"freedoms of {found.platform.body}", found.platform.dof
    yield f"rotations of {found.platform.body}", found.platform.rotations
    yield "internal freedoms", found.internal_freedoms
    if found.dof_drives_locked is not None:
        yield "freedoms with the drives locked", found.dof_drives_locked
    for limb in found.limbs:
        yield f"constraints of {limb.name}", len(limb.constraints.basis)
    if found.finite.dof is not None:
        yield "finite mobility", found.finite.dof
        yield "smooth", found.finite.smooth
        yield "branches", None if found.finite.branches is None else list(found.finite.branches)


def _closed(found: Mobility) -> bool:
    """Whether the motion was seen to close all loops, up to what counts as rounding, and nothing beyond that."""
    return found.finite.smooth and not found.finite.proved


def _why(found: Mobility, claim: str) -> str:
    if claim in OF_MOTION:
        return SAMPLED
    return found.decisions.why or "the numbers of the elimination over the field grow too long"


def write_proof(found: Mobility, path: Path, ways: dict[str, Any] | None = None) -> Verdict:
    """Writes the proof file and returns what the checkers say of it.

    Args:
        found: whose claims are written.
        path: of the file.
        ways: evidence of ways between assembly modes, for `way_checker`.

    Raises:
        OSError: the file cannot be written.
    """
    values = mobility_proof(found)
    if ways is not None:
        values["ways"] = ways
    text = json.dumps(values, separators=(",", ":"))
    verdict = check_proof(json.loads(text))
    if ways is not None:
        beside = check_ways(json.loads(text))
        verdict = Verdict(
            verdict.mechanism, verdict.proved + beside.proved, verdict.refused + beside.refused,
            verdict.not_proved + beside.not_proved,
        )  # fmt: skip
    write_text(path, text + "\n")
    return verdict
