"""Margins and ranks of one report agree: a margin says what the ranks of the configuration say that it does not."""

from __future__ import annotations

from dataclasses import dataclass, replace

from symscrew.mobility.instantaneous import LimbMobility
from symscrew.mobility.singularities import MarginValue


@dataclass(frozen=True)
class Ranks:
    """What is known by ranks: limbs with their screws, freedoms left with all drives locked.

    `alone`: how many of these are of links that move alone between two joints; `pairs`: all such pairs of joints;
    `smooth`: whether the closure keeps its rank around the configuration; `almost`: its smallest singular value that
    is not zero as typed, where that is almost zero; `freedoms`: instantaneous ones and real ones where these are fewer;
    `without_drive`: by how many there are more freedoms than drives.
    """

    limbs: tuple[LimbMobility, ...]
    left: int | None
    alone: int
    pairs: tuple[tuple[str, str], ...]
    smooth: bool
    almost: float | None
    freedoms: tuple[int, int] | None = None
    without_drive: int = 0


def with_rank(margin: MarginValue, ranks: Ranks) -> MarginValue:
    """The margin as regular where the rank is full, else with the freedoms that are lost all along."""
    if margin.kind == "limb":
        for limb in (limb for limb in ranks.limbs if limb.name == margin.name):
            most = min(6, len(limb.screws))
            if limb.constraints.rank == most:
                return replace(margin, regular=True)
            inside = [f"{a} and {b}" for a, b in ranks.pairs if {a, b} <= set(limb.joints)]
            why = f" (a passive freedom between {', '.join(inside)})" if inside else ""
            return replace(margin, note=f"{limb.constraints.rank} of {most} screws are independent here{why}")
    if margin.kind == "actuation" and margin.name == "all drives" and ranks.left is not None:
        if ranks.left <= ranks.alone:
            return replace(margin, regular=True)
        if ranks.left == ranks.without_drive:  # every drive holds one: there are too few of them
            more = margin.meaning.replace("a freedom is left", "a freedom more is left")
            count = f"{ranks.left} freedom{'s' * (ranks.left > 1)} without a drive"
            return replace(margin, note=count, underactuated=True, meaning=more)
        text = f"{ranks.left} freedom{'s' * (ranks.left > 1)} left with all drives locked here"
        return replace(margin, note=f"{text}, {ranks.alone} of them of links that move alone" if ranks.alone else text)
    if margin.kind == "constraint":
        if ranks.freedoms is not None and not margin.vanishes:  # the volume is of the rank that there is all along
            instantaneous, real = ranks.freedoms
            return replace(
                margin,
                note=f"{instantaneous} instantaneous freedom{'s' * (instantaneous > 1)} for {real} of real motion",
            )
        text = "" if ranks.almost is None else f"a singular value of the closure is {ranks.almost:.1e} as typed"
        return replace(margin, regular=ranks.smooth, almost=text)
    return margin
