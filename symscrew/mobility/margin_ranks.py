"""Margins and ranks of one report agree: a margin says what the ranks of the configuration say that it does not."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from symscrew.mobility.instantaneous import LimbMobility
from symscrew.mobility.singularities import MarginValue


@dataclass(frozen=True)
class Ranks:
    """What is known by ranks: limbs with their screws, types of joints, freedoms left with all drives locked, spins.

    `smooth`: whether the closure keeps its rank around the configuration; `almost`: its smallest singular value that is
    not zero as typed, where that is almost zero; `freedoms`: instantaneous ones and real ones where these are fewer.
    """

    limbs: tuple[LimbMobility, ...]
    types: Mapping[str, str]
    left: int | None
    spins: int
    smooth: bool
    almost: float | None
    freedoms: tuple[int, int] | None = None


def with_rank(margin: MarginValue, ranks: Ranks) -> MarginValue:
    """The margin as regular where the rank is full, else with the freedoms that are lost all along."""
    if margin.kind == "limb":
        for limb in (limb for limb in ranks.limbs if limb.name == margin.name):
            most = min(6, len(limb.screws))
            if limb.constraints.rank == most:
                return replace(margin, regular=True)
            spinning = [ranks.types[name] for name in limb.joints].count("S") > 1
            why = " (a passive spin between its spherical joints)" if spinning else ""
            return replace(margin, note=f"{limb.constraints.rank} of {most} screws are independent here{why}")
    if margin.kind == "actuation" and margin.name == "all drives" and ranks.left is not None:
        if ranks.left <= ranks.spins:
            return replace(margin, regular=True)
        text = f"{ranks.left} freedom{'s' * (ranks.left > 1)} left with all drives locked here"
        return replace(margin, note=f"{text}, {ranks.spins} of them passive spins" if ranks.spins else text)
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
