"""Assembly modes of the reference, and what leads from one to another: found by a road map, then judged by tubes.

    Mobility --assembly_connections--> modes, ways in doubles --way_evidence--> certified, or sampled with the reason
             --connection_lines, connection_values--> words, JSON;  `entry` --> the proof file, for `way_checker`

That there are no other modes is sampled. So is what no certificate was found for; what a certificate contradicts is
withdrawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from symscrew.mobility.analysis import Mobility
from symscrew.mobility.components import Mode, ModeConnections, SampledModes, assembly_connections
from symscrew.mobility.joint_network import Network
from symscrew.mobility.proofs import CONNECTED, SEPARATED, WayEvidence, certified_modes, described, way_evidence

DISPLACED = "the displaced configuration has no exact coordinates"
CERTIFIED, SAMPLED = "certified", "sampled"


@dataclass(frozen=True, eq=False)
class Connections:
    """The modes with the ways from the reference that were found, and what is certified of them."""

    network: Network
    found: ModeConnections
    evidence: WayEvidence

    def judgement(self, k: int) -> tuple[str | None, str, str]:
        """("connected", "separated" or None of a mode against the reference, "certified" or "sampled", the reason)."""
        mode, why = self.found.modes[k], self.evidence.why.get(k, "")
        if k in self.evidence.proved:
            return self.evidence.proved[k], CERTIFIED, ""
        if mode.trail is not None:
            return CONNECTED, SAMPLED, why
        signs = self.evidence.signs
        opposite = mode.sign * self.found.modes[0].sign < 0 and not (0 in signs and k in signs)
        return (SEPARATED if opposite else None), SAMPLED, why


def judged_connections(found: Mobility, drives: Sequence[int] = ()) -> Connections | str:
    """The assembly modes at the drives of the reference, what is certified of ways between them; or why there are none.

    Args:
        found: of the mechanism.
        drives: columns of what is driven; the mechanism's own drives by default.
    """
    modes = assembly_connections(found.network, drives)
    if isinstance(modes, str):
        return modes
    if not found.in_reference:
        return Connections(
            found.network, modes, WayEvidence(None, why=dict.fromkeys(range(len(modes.modes)), DISPLACED))
        )
    numbers = described(found.mechanism, found.network, found.platform.body)
    return Connections(found.network, modes, way_evidence(numbers, found.network, modes))


def judged_modes(found: Mobility, modes: SampledModes) -> SampledModes:
    """Sampled operation modes, with what is certified of them."""
    return certified_modes(described(found.mechanism, found.network, found.platform.body), found.network, modes)


def connection_lines(found: Connections | str) -> list[str]:
    """A line for each assembly mode."""
    if isinstance(found, str):
        return [found]
    count = len(found.found.modes)
    held = ", ".join(_names(found))
    head = (
        f"{count} assembly mode{'s' * (count != 1)} with {held} as in the reference, sampled by random starts: others "
        "may be missing; certified are ways in tubes that Krawczyk's operator maps into themselves, and signs of "
        "determinants in intervals"
    )
    lines = [f"{k + 1}: smallest singular value {mode.smallest:.2g}" for k, mode in enumerate(found.found.modes)]
    lines[0] += ", the reference"
    texts = [_words(found, k, mode) for k, mode in enumerate(found.found.modes)][1:]
    return [head, lines[0], *(line + text for line, text in zip(lines[1:], texts, strict=True))]


def _words(found: Connections, k: int, mode: Mode) -> str:
    between, judged, why = found.judgement(k)
    if between == CONNECTED:
        by = f"{judged} by {found.evidence.pieces[k]} tubes" if judged == CERTIFIED else f"{judged} ({why})"
        places = (", ".join(f"{corner[c]:.3f}" for c in found.found.drives) for corner in mode.corners or ())
        through = "".join(f", ({place})" for place in places)
        return (
            f", connected with the reference, {by}; at its points at least {mode.margin:.2g}"
            f"{'; drives there' * bool(through)}{through}"
        )
    if between == SEPARATED:
        reason = "" if judged == CERTIFIED else f" ({why})"
        return (
            f", a singularity on every way from the reference, {judged}{reason}: the determinants have opposite signs"
        )
    return ", not decided: no way from the reference was found"


def connection_values(found: Connections | str) -> dict[str, Any]:
    """The same as JSON values: displacements of all joints at the corners [rad, sizes of the mechanism]."""
    if isinstance(found, str):
        return {"decided": False, "why": found}
    return {
        "decided": True, "judgement": SAMPLED, "drives": list(_names(found)),
        "modes": [_value(found, k, mode) for k, mode in enumerate(found.found.modes)],
    }  # fmt: skip


def _value(found: Connections, k: int, mode: Mode) -> dict[str, Any]:
    between, judged, why = found.judgement(k) if k else ("reference", SAMPLED, "")
    return {
        "smallest_singular_value": mode.smallest, "sign": mode.sign, "to_reference": between or "not found",
        "to_reference_judgement": judged, "why": why, "tubes": found.evidence.pieces.get(k),
        "margin_on_the_way": mode.margin,
        "corners": None if mode.corners is None else [list(map(float, c)) for c in mode.corners],
    }  # fmt: skip


def _names(found: Connections) -> Iterator[str]:
    """The drives by joint and index."""
    edges = found.network.edges.values()
    for c in found.found.drives:
        edge = next(e for e in edges if c in e.columns)
        yield edge.name if len(edge.screws) == 1 else f"{edge.name}.{c - edge.start}"
