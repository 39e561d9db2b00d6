"""A cut joint's rows as the system has them: the power of every reciprocal wrench per unit joint rate."""

from __future__ import annotations

from symscrew.kinematics import Cut, System
from symscrew.loops.formulations.cut_rows import CutRows, unit_scales


def plain_rows(system: System, cut: Cut) -> CutRows:
    """The rows of the closure Jacobian in joint rates; every cut joint has them."""
    return CutRows(cut=cut, rows=tuple(system.closure.cut_rows(cut)), scales=unit_scales(system, cut))
