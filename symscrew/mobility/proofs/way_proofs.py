"""Evidence for ways between assembly modes: tubes around what a road map has found, as small as closes them.

    ModeConnections --displacements as numbers of motions--> points
    points --tubes that Krawczyk's operator maps into themselves, halved until it does--> pieces
           --way_checker--> connected or separated, proved; or why it stays sampled

Doubles only propose: what is called proved has been judged by the checker, in integers, from what the file will hold.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from symscrew.mobility.components import ModeConnections, SampledMode, SampledModes
from symscrew.mobility.finite import ClosureVariety
from symscrew.mobility.joint_network import Network
from symscrew.mobility.proofs.motion_proofs import group_of
from symscrew.mobility.proofs.proof_checker import RefusedError
from symscrew.mobility.proofs.proof_numbers import ProofNumbers
from symscrew.mobility.proofs.way_checker import CONNECTED, FORMAT, PLACES, POINT, SEPARATED, Motion, Tubes, Ways

Array = np.ndarray[Any, Any]

SMALL = 1 << 20
"""Radius 2^-30 of the tube that is tried first, and of a mode's: far above the rounding of doubles, and far below the
distance of modes."""
WIDER = 1.5
"""A tube's radius over the least with which it would hold its image, did the image not grow with it."""
INSIDE = 1.01
"""The same, of a radius with which a tube is taken."""
AIM, MOST = 0.75, 0.88
"""Of the tube the part to which the operator may map it: aimed at, and at most. It grows as the length of the piece."""
LONGER, SMALLEST = 2.0, 0.01
"""Piece over the one before at most; the part from which its length is no more foreseen."""
MOST_PIECES = 1500
"""Of all ways together: those of the tests have about a hundred each."""
NEWTON = 4
"""Steps back to the closure from the middle of a piece."""
NEAR = 1e-9
"""Relative singular value below which Newton's method takes equations for redundant."""


@dataclass(frozen=True)
class WayEvidence:
    """What is proved of the modes against the reference, with what a file holds of it.

    `entry`: JSON values, None where nothing is judged; `proved`: mode -> "connected" or "separated"; `pieces`: of each
    way that is proved; `why`: mode -> why what is said of it is only sampled; `signs`: of determinants, of modes that
    are certified to be configurations.
    """

    entry: dict[str, Any] | None
    proved: Mapping[int, str] = field(default_factory=dict)
    pieces: Mapping[int, int] = field(default_factory=dict)
    why: Mapping[int, str] = field(default_factory=dict)
    signs: Mapping[int, int] = field(default_factory=dict)


def way_evidence(numbers: ProofNumbers, network: Network, found: ModeConnections) -> WayEvidence:
    """Tubes around the ways from the reference to the other modes, and signs of determinants, judged by the checker."""
    others = range(1, len(found.modes))
    names = _freedoms(network)
    read = numbers.read
    entry: dict[str, Any] = {
        "format": FORMAT, "drives": [list(names[c]) for c in found.drives],
        "groups": [group_of(numbers, [s for _, s in read.factors(k)]) for k in range(len(read.loops))],
        "scales": [1 << POINT] * read.freedoms, "modes": [], "claims": [], "not proved": [],
    }  # fmt: skip
    try:
        proposed = _Proposed(numbers, network, entry)
    except RefusedError as error:
        return WayEvidence(None, why=dict.fromkeys(others, str(error)))
    entry["scales"] = proposed.tubes.scales = proposed.scales()
    points = [proposed.point(mode.q) for mode in found.modes]
    entry["modes"] = [{"point": point, "radius": SMALL} for point in points]
    ways = Ways(read, entry)
    proved, pieces, why = dict[int, str](), dict[int, int](), dict[int, str]()
    for k in others:
        trail, claim = found.modes[k].trail, dict[str, Any]()
        try:
            if ways.sign(0) * ways.sign(k) < 0:
                proved[k] = SEPARATED
            elif trail is None:
                why[k] = "no way from the reference was found"
                continue
            else:
                claim["way"] = proposed.way(points[0], [*trail[1:-1], found.modes[k].q])
                ways.connected((0, k), claim["way"])
                proved[k], pieces[k] = CONNECTED, len(claim["way"]["radii"])
        except RefusedError as error:
            why[k] = str(error)
            continue
        entry["claims"].append({"kind": proved[k], "modes": [0, k], **claim})
    entry["not proved"] = [f"modes 1 and {k + 1}: {text}" for k, text in why.items()]
    return WayEvidence(entry, proved, pieces, why, ways.signs)


def certified_modes(numbers: ProofNumbers, network: Network, found: SampledModes) -> SampledModes:
    """The same, with what intervals show of a configuration of each mode: it closes, and is regular.

    With as many freedoms held as the mode has dimensions, Krawczyk's operator maps a box around the others into itself:
    there is a configuration with these values, the matrix of the others is regular, and around it configurations are
    those of so many parameters.
    """
    return replace(found, modes=tuple(replace(m, certified=_regular(numbers, network, m)) for m in found.modes))


def _regular(numbers: ProofNumbers, network: Network, mode: SampledMode) -> bool:
    if mode.witness is None or not 0 < mode.dimension < network.freedoms:
        return False
    _, _, vt = np.linalg.svd(ClosureVariety(network).evaluate(mode.witness[None])[1][0])
    motions, held, names = vt[-mode.dimension :], list[int](), _freedoms(network)
    for _ in range(mode.dimension):  # freedoms that move most, one after another
        held.append(int((motions**2).sum(axis=0).argmax()))
        along = motions[:, held[-1]] / np.linalg.norm(motions[:, held[-1]])
        motions = motions - np.outer(along, along @ motions)
    read = numbers.read
    entry = {
        "drives": [list(names[c]) for c in held], "scales": [1 << POINT] * read.freedoms,
        "groups": [group_of(numbers, [s for _, s in read.factors(k)]) for k in range(len(read.loops))],
    }  # fmt: skip
    try:
        proposed = _Proposed(numbers, network, entry)
        proposed.tubes.scales = proposed.scales()
        point = proposed.point(proposed.settled(mode.witness))
        proposed.tubes.shown(point, point, SMALL)
    except RefusedError:
        return False
    return True


def _freedoms(network: Network) -> dict[int, tuple[str, int]]:
    """Column -> joint and index of its freedom."""
    return {c: (edge.name, c - edge.start) for edge in network.edges.values() for c in edge.columns}


@dataclass(frozen=True)
class _Counted:
    """A motion of the checker with its first column in the network and the length of its axis, negative if opposite."""

    motion: Motion
    column: int
    size: float


class _Proposed:
    """Points and pieces, in doubles."""

    def __init__(self, numbers: ProofNumbers, network: Network, entry: dict[str, Any]) -> None:
        self.tubes, self.variety, self.length = (
            Tubes(numbers.read, entry),
            ClosureVariety(network),
            float(network.length),
        )
        self.counted = [self._counted(numbers, network, motion) for motion in self.tubes.motions]
        there = {self.counted[k].column + i: motion.columns[i]
                 for k, motion in enumerate(self.tubes.motions) for i in range(len(motion.columns))}  # fmt: skip
        held = set(self.tubes.passive)
        self.passive = [c for c in range(self.variety.columns) if there[c] in held]
        self.left = MOST_PIECES

    def _counted(self, numbers: ProofNumbers, network: Network, motion: Motion) -> _Counted:
        joint, edge = numbers.read.joints[motion.joint], network.edges[motion.joint]
        first = motion.columns.start - joint.first
        if motion.kind == "S":
            return _Counted(motion, edge.start + first, 1.0)
        own = np.array([numbers.value(c) for c in joint.screws[first]])
        unit = np.array([float(c) for c in edge.screws[first]])
        part = slice(0, 3) if motion.kind == "R" else slice(3, 6)
        size = float(np.linalg.norm(own[part]) * np.sign(own[part] @ unit[part]))
        return _Counted(motion, edge.start + first, size)

    def scales(self) -> list[int]:
        """Of every freedom: a radian of a hinge, the mechanism's size of a slide."""
        result = [1 << POINT] * self.tubes.mechanism.freedoms
        for own in self.counted:
            if own.motion.kind != "S":
                unit = 1.0 if own.motion.kind == "R" else self.length / 2
                result[own.motion.columns[0]] = max(1, int(unit / abs(own.size) * 2.0**POINT))
        return result

    def numbers(self, q: Array) -> list[Array]:
        """The numbers of every motion."""
        result = []
        for own in self.counted:
            moved = q[own.column]
            if own.motion.kind == "S":
                vector = q[own.column : own.column + 3]
                angle = float(np.linalg.norm(vector))
                result.append(np.array([np.cos(angle / 2), *(np.sinc(angle / 2 / np.pi) / 2 * vector)]))
            elif own.motion.kind == "R":
                result.append(np.array([np.cos(moved / 2), np.sin(moved / 2) / own.size]))
            else:
                result.append(np.array([1.0, moved * self.length / (2 * own.size)]))
        return result

    def displacements(self, numbers: Sequence[Array]) -> Array:
        """The other way round."""
        q = np.zeros(self.variety.columns)
        for own, x in zip(self.counted, numbers, strict=True):
            if own.motion.kind == "S":
                turned = x if x[0] >= 0 else -x
                size = float(np.linalg.norm(turned[1:]))
                angle = 2 * np.arctan2(size, turned[0])
                q[own.column : own.column + 3] = turned[1:] * (angle / size if size else 2 / turned[0])
            elif own.motion.kind == "R":
                q[own.column] = 2 * np.arctan2(x[1] * own.size, x[0])
            else:
                q[own.column] = x[1] / x[0] * 2 * own.size / self.length
        return q

    def point(self, q: Array) -> list[list[int]]:
        """A point of the file."""
        return self._integers(self.numbers(q))

    def way(self, first: list[list[int]], trail: Sequence[Array]) -> dict[str, Any]:
        """Pieces of a way along a trail, each about as long as its tube allows.

        Raises:
            RefusedError: there are too many of them.
        """
        track = [self.numbers(np.zeros(self.variety.columns))]
        for q in trail:
            track.append(_like(self.numbers(q), track[-1]))
        points, radii, at, step, guess = [first], list[int](), 0.0, 1.0, SMALL
        while at < len(track) - 1:
            self.left -= 1
            if self.left < 0:
                raise RefusedError("a way of too many pieces")
            end = min(at + step, len(track) - 1.0)
            there = self._integers(track[-1] if end == len(track) - 1 else self._between(track, end))
            radius, share = self._radius(points[-1], there, guess)
            longer = min(LONGER, AIM / share)
            step, guess = (end - at) * longer, SMALL + int((radius or guess) * longer**2)
            if radius is not None:
                at = end
                points.append(there)
                radii.append(radius)
        return {"points": points[1:], "radii": radii}

    def _between(self, track: Sequence[Sequence[Array]], at: float) -> list[Array]:
        """A place of the track, between two of its points, closed again with the drives as they are."""
        k = min(int(at), len(track) - 2)
        guess = [a + (at - k) * (b - a) for a, b in zip(track[k], track[k + 1], strict=True)]
        return _like(self.numbers(self.settled(self.displacements(guess))), guess)

    def _integers(self, numbers: Sequence[Array]) -> list[list[int]]:
        return [[int(c) for c in np.rint(x * 2.0**POINT)] for x in numbers]

    def _radius(self, one: list[list[int]], two: list[list[int]], guess: int) -> tuple[int | None, float]:
        """(a radius for the tube of a piece, None where it is too long; the largest part of it that is its image)."""
        share = MOST
        for _ in range(2):
            try:
                moved, wide, _ = self.tubes.images(one, two, guess)
            except RefusedError:
                return None, 2.0
            unit = [scale << PLACES >> 2 * POINT for scale in (self.tubes.scales[c] for c in self.tubes.passive)]
            shares = [spread / (guess * u) for spread, u in zip(wide, unit, strict=True)]
            share = max([*shares, SMALLEST])
            if share > MOST:
                break
            least = max(m / u / (1 - s) for m, u, s in zip(moved, unit, shares, strict=True))
            if least * INSIDE < guess:
                return guess, share
            guess = SMALL + int(WIDER * least)
        return None, max(share, MOST)

    def settled(self, q: Array) -> Array:
        """Closed again with the drives as they are."""
        for _ in range(NEWTON):
            residuals, jacobians = self.variety.evaluate(q[None])
            q = q.copy()
            q[self.passive] -= np.linalg.pinv(jacobians[0][:, self.passive], rcond=NEAR) @ residuals[0]
        return q


def _like(numbers: Sequence[Array], others: Sequence[Array]) -> list[Array]:
    """The same displacements with numbers whose signs are those of the others."""
    return [x if float(x @ z) >= 0 else -x for x, z in zip(numbers, others, strict=True)]
