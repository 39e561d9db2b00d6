"""What a platform carries is no limb; couplings of a whole limb leave its platform on it; gears are no screws."""

from __future__ import annotations

import numpy as np
import pytest

import symscrew
from symscrew.description import Mechanism, MechanismBuilder
from symscrew.kinematics import System, spanning_tree
from symscrew.mobility import analyse_mobility, limb_margins, mobility_text, mobility_values

Y = [[0, 1, 0]]


def five_bar(*, jaws: int, level: bool) -> MechanismBuilder:
    """A planar five-bar whose hand carries jaws, perhaps kept level by a belt along its left limb."""
    builder = MechanismBuilder("picker", platform="hand")
    for side, sign in (("left", -1), ("right", 1)):
        builder.body(f"crank_{side}", mass=1, com=[f"{sign}/7", 0, "1/12"], inertia=["1/100", "1/90", "1/80"])
        builder.body(f"rod_{side}", mass=1, com=[f"{sign}/9", 0, "3/10"], inertia=["1/100", "1/90", "1/80"])
    builder.body("hand", mass=1, com=[0, 0, "1/2"], inertia=["1/100", "1/90", "1/80"])
    for side, sign in (("left", -1), ("right", 1)):
        crank, rod = f"crank_{side}", f"rod_{side}"
        builder.joint(f"base_{side}", "R", parent="base", child=crank, point=[f"{sign}/10", 0, 0], axes=Y, driven=True)
        builder.joint(f"elbow_{side}", "R", parent=crank, child=rod, point=[f"{sign}/5", 0, "1/6"], axes=Y)
        builder.joint(f"wrist_{side}", "R", parent=rod, child="hand", point=[0, 0, "9/20"], axes=Y)
    for k in range(jaws):
        builder.body(f"jaw{k}", mass="1/10", com=[0, 0, "11/20"], inertia=["1/1000", "1/1000", "1/1000"])
        builder.joint(
            f"grip{k}", "P", parent="hand", child=f"jaw{k}", point=[0, 0, "1/2"], axes=[[1, 0, 0]], driven=True
        )
    if level:
        builder.coupling("level", terms={"base_left": 1, "elbow_left": 1, "wrist_left": 1})
    return builder


def drives_agree(mechanism: Mechanism) -> None:
    """Accelerations under the drives of an inverse dynamics are those that it was asked for."""
    model = symscrew.derive(mechanism)
    q, v, a = model.test_inputs["inverse_dynamics"][:3]
    u = model("inverse_dynamics", q, v, a)[0][0]
    assert model("forward_dynamics", q, v, u)[0][0] == pytest.approx(a, abs=1e-9 * np.abs(a).max())


@pytest.mark.parametrize("jaws", [0, 1, 2])
def test_what_a_platform_carries_is_no_limb(jaws: int) -> None:
    """Its tree is that of the five-bar without jaws; a belt along a limb is no reason to refuse it."""
    assert spanning_tree(five_bar(jaws=jaws, level=False).build()).virtual is None
    mechanism = five_bar(jaws=jaws, level=True).build()
    assert [joint.name for joint in spanning_tree(mechanism).cut] == ["wrist_right"]
    assert analyse_mobility(mechanism).dof == 2 + jaws
    drives_agree(mechanism)


def test_a_limb_whose_joints_must_all_stay_carries_its_platform() -> None:
    """A third limb makes the hand a hub; the belt along the left one keeps all its joints."""
    builder = five_bar(jaws=0, level=False)
    builder.body("crank_third", mass=1, com=[0, 0, "1/8"], inertia=["1/100", "1/90", "1/80"])
    builder.body("rod_third", mass=1, com=["1/20", 0, "1/3"], inertia=["1/100", "1/90", "1/80"])
    builder.joint("base_third", "R", parent="base", child="crank_third", point=["1/50", 0, 0], axes=Y)
    builder.joint("elbow_third", "R", parent="crank_third", child="rod_third", point=["3/10", 0, "1/4"], axes=Y)
    builder.joint("wrist_third", "R", parent="rod_third", child="hand", point=["1/30", 0, "1/2"], axes=Y)
    assert spanning_tree(builder.build()).virtual == "hand_pose"
    builder.coupling("level", terms={"base_left": 1, "elbow_left": 1, "wrist_left": 1})
    mechanism = builder.build()
    found = spanning_tree(mechanism)
    assert found.virtual is None and {"base_left", "elbow_left", "wrist_left"} <= set(found.joints)
    drives_agree(mechanism)


def test_gears_are_no_limb_and_too_few_drives_no_singularity() -> None:
    mechanism = five_bar(jaws=0, level=True).build()
    system = System(mechanism)
    system.use_samples()
    assert "level" not in {margin.name for margin in limb_margins(system)}
    builder = five_bar(jaws=1, level=False)
    found = analyse_mobility(builder.build())
    assert found.dof == 4 and found.dof_drives_locked == 1
    (every,) = (m for m in mobility_values(found)["singularities"]["actuation"] if m["name"] == "all drives")
    assert not every["singular"] and "a freedom more is left" in every["meaning"]
    assert "underactuated, 1 freedom without a drive" in mobility_text(found, full=True)


def test_drives_that_leave_more_than_too_few_must_are_singular() -> None:
    """Two drives on one shaft and none elsewhere: one freedom without a hold for want of place, not of drives."""
    builder = MechanismBuilder("cranks", platform="rocker")
    places = {"A": (0, 0), "B": (0, "1/5"), "C": ("1/2", "2/5"), "D": ("1/2", 0)}
    for body in ("crank", "coupler", "rocker"):
        builder.body(body, mass=1, com=["1/4", 0, "1/5"], inertia=["1/100", "1/90", "1/80"])
    chain = ("base", "crank", "coupler", "rocker", "base")
    for (name, (x, z)), parent, child in zip(places.items(), chain, chain[1:], strict=False):
        builder.joint(name, "R", parent=parent, child=child, point=[x, 0, z], axes=Y)
    builder.body("flag", mass=1, com=[1, 0, 0], inertia=["1/100", "1/90", "1/80"])
    builder.body("pole", mass=1, com=[1, 0, 0], inertia=["1/100", "1/90", "1/80"])
    builder.joint("slide", "P", parent="base", child="pole", point=[1, 0, 0], axes=[[1, 0, 0]], driven=True)
    builder.joint("back", "P", parent="base", child="pole", point=[1, 0, 0], axes=[[1, 0, 0]], driven=True)
    builder.joint("free", "R", parent="pole", child="flag", point=[1, 0, 0], axes=Y)
    found = analyse_mobility(builder.build())
    assert found.dof == 3 and found.dof_drives_locked == 2
    assert "underactuated" not in mobility_text(found, full=True)
