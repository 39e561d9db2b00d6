"""Hubs on seats and tips on hinges: every way of the balance asks for the drives that method B has."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from support.model_states import relative
from support.rod_mechanisms import hung_platform, rotary_hexapod

from symscrew import catalogue
from symscrew.description import Mechanism
from symscrew.dynamics import hinged_tips, seats, thin_rods, with_end_masses
from symscrew.effects import BaseMotion, Effect, ExternalWrench, Gravity
from symscrew.functions.dynamic import Equations
from symscrew.kinematics import System

PULLED = ExternalWrench("tool", wrench=(3, -2, 5, "0.4", "-0.3", "0.2"))
LEANING = Gravity((2, "-1.5", -9))


def equations_of(mechanism: Mechanism, effects: Sequence[Effect]) -> Equations:
    system = System(mechanism)
    system.use_samples()
    return Equations(system, effects)


def drives_by_all_ways(found: Equations) -> list[np.ndarray]:
    """The first where the coordinates are."""
    unseated, seated = found._ways_with_bars(thin_rods(found.system, found.forces))
    ways = [*found._plain_ways, *unseated, *seated]
    return [np.array([found.system.tape.sample(u) for u in found.drives(way).u]) for way in ways]


@pytest.mark.parametrize(
    ("mechanism", "effects", "on", "tips"),
    [
        (rotary_hexapod(base="stand", cranks=2, arm=True), (LEANING, PULLED), {"base", "stand"}, 2),
        (rotary_hexapod(base="stand", cranks=1), (LEANING, BaseMotion()), {"base", "stand"}, 0),  # its axis moves
        (rotary_hexapod(cranks=2, arm=True), (LEANING, PULLED), {"base"}, 0),
        (catalogue.load("delta"), (LEANING,), {"base"}, 0),  # several rods of an arm, more of them than freedoms
        (hung_platform(), (LEANING,), set(), 0),
    ],
)
def test_all_ways_ask_for_the_same_drives(
    mechanism: Mechanism, effects: Sequence[Effect], on: set[str], tips: int
) -> None:
    found = equations_of(mechanism, effects)
    first, *others = drives_by_all_ways(found)
    assert np.abs(first).max() > 0.1
    for other in others:
        assert relative(other, first) < 1e-9
    rods = thin_rods(found.system, found.forces)
    seated = {found.system.tree.part(seat.on) for seat in seats(found.setting, found.rates, rods)}
    assert seated == on
    inertia = with_end_masses(found.system, list(rods.values()), found.forces.inertia)
    left_out = {link.index for rod in rods.values() for link in rod.links}
    assert len(hinged_tips(found.system, found.forces, inertia, found.rates, left_out=left_out)) == tips
