"""What robots from files have and hand-made mechanisms seldom have: welds in loops, springs far from the drives."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.effects import Gravity, effect_from_table
from symscrew.export.c_lanes import in_order
from symscrew.kinematics import System
from symscrew.mobility import analyse_mobility
from symscrew.program.lanes.signed_operations import Operation
from symscrew.simulation.kept_model import derived_model


def builder(names: str) -> MechanismBuilder:
    made = MechanismBuilder("leg")
    for k, name in enumerate(names.split()):
        made.body(name, mass=1, com=[f"{k}/10", 0, "1/5"], inertia=["1/50", "1/40", "1/60"])
    return made


def rod_leg() -> Mechanism:
    """A rod from the base to the third link of a chain: breadth first, that link hangs on the rod."""
    made = builder("one two three rod")
    made.joint("A", "R", parent="base", child="one", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    made.joint("B", "R", parent="one", child="two", point=["1/2", 0, 0], axes=[[1, 0, 0]], driven=True)
    made.joint("C", "R", parent="two", child="three", point=["1/2", 0, "-2/5"], axes=[["3/5", "4/5", 0]])
    made.joint("S1", "S", parent="base", child="rod", point=["-1/5", "1/10", 0])
    made.joint("S2", "S", parent="rod", child="three", point=["3/10", "1/10", "-1/2"])
    return made.build()


def test_a_simulation_has_the_tree_of_its_effects() -> None:
    """A spring far from the drives asks for whole turns, for which the loop is cut elsewhere: in both, or in none."""
    leg = rod_leg()
    effects = (Gravity(), effect_from_table({"type": "joint_spring", "joint": "C", "stiffness": 30}))
    kept = derived_model(leg, effects)
    assert "C" in kept.system.tree.joints and "C" not in System(leg).tree.joints
    assert kept.programs["forward_dynamics"].inputs[0].size == len(kept.system.tree.q)


def test_welds_in_a_loop_that_is_almost_special() -> None:
    """A link of two halves in a flat loop whose axes are parallel but for 1e-9: what was meant has the freedom."""
    made = builder("crank coupler more rocker")
    tilted = [0, "1 - 1/2*10^(-18)", "10^(-9)"]
    made.joint("A", "R", parent="base", child="crank", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    made.joint("B", "R", parent="crank", child="coupler", point=[0, 0, "3/20"], axes=[[0, 1, 0]])
    made.joint("half", "fixed", parent="coupler", child="more", point=["1/5", 0, "3/10"])
    made.joint("C", "R", parent="more", child="rocker", point=["2/5", 0, "9/20"], axes=[tilted])
    made.joint("D", "R", parent="base", child="rocker", point=["16/25", 0, 0], axes=[[0, 1, 0]])
    found = analyse_mobility(made.build())
    assert found.near is not None and found.near.meant.finite.dof == 1


def test_a_constant_like_the_number_of_a_slot() -> None:
    """1250.0 N/m is not slot 1250: what it is multiplied by waits for nothing."""
    operations = {4: Operation("mul", ((5.0, 1), (0, 1))), 5: Operation("mul", ((4, 1), (1, 1)))}
    packing = cast(Any, SimpleNamespace(operations=operations, items=(4, 5)))
    assert in_order(packing) == [4, 5]
