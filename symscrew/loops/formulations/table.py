"""The table of formulations: a further one is its file, its line and the choices in which it is preferred."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from symscrew.kinematics import Cut, System
from symscrew.loops.formulations.contact_rows import contact_rows
from symscrew.loops.formulations.cut_rows import CutRows
from symscrew.loops.formulations.plain_rows import plain_rows
from symscrew.loops.formulations.rod_rows import rod_rows
from symscrew.loops.formulations.seen_rows import seen_rows

FORMULATIONS: Mapping[str, Callable[[System, Cut], CutRows | None]] = {
    "plain": plain_rows,
    "seen": seen_rows,
    "contacts": contact_rows,
    "rods": rod_rows,
}
"""Name -> the rows of a cut joint in this formulation, None where it has none; every cut joint has plain ones."""

CHOICES = (("seen", "plain"), ("seen", "contacts", "plain"), ("rods", "seen", "plain"))
"""Closures to try: in each, a cut joint takes the first formulation that it has. The first is tried always."""
