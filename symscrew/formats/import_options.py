"""What whoever imports a file allows beside what is read without asking."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class ImportOptions:
    """How a file is read.

    Attributes:
        snap: gap [m, rad] up to which open loops are closed, beside what rounding explains.
        repair: inertias that no body can have become the nearest that one can.
        accept: what is left out although numbers depend on it is left out all the same.
        floating: the root of a tree that stands on nothing moves freely in space.
        exact: digits that mean an angle, a zero or a short decimal are that (`exact_digits`).
        bars: rods between two balls do not spin and have their mass on the line between these (`idle_spins`).
        loosen: loops of a file beside a URDF that close in no pose hold less: places alone, or balls in place of turns
            that are called so.
        folder: below which files that the file names may be; by default the file's own folder.
    """

    snap: float = 0.0
    repair: bool = False
    accept: bool = False
    floating: bool = False
    exact: bool = False
    folder: Path | None = None
    bars: bool = False
    loosen: bool = False
