"""Joints that carry whole loops: with and without what cancels in these they are asked for the same forces."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from support.marks import slow
from support.model_states import body_states, relative
from support.operation_counts import rise
from support.rod_mechanisms import braced_arm, model, rotary_hexapod
from sympy import Rational

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.dynamics import balances, carried_wrenches
from symscrew.dynamics.carried_loops import carriers
from symscrew.effects import Effect, ExternalWrench, Gravity
from symscrew.functions.dynamic import Equations
from symscrew.kinematics import System
from symscrew.model import derive
from symscrew.reference.newton_euler_method import newton_euler

PULLED = ExternalWrench("tool", wrench=(3, -2, 5, "0.4", "-0.3", "0.2"))


def carried_bars(carrier: str = "stand", *, free: bool = False) -> Mechanism:
    """A four-bar of thick links on a stand that turns on a post that turns; its last joint on the `carrier`."""
    builder = MechanismBuilder("carried_bars", platform="coupler")
    weights = {"post": 2, "stand": 3, "crank": 1, "coupler": 2, "rocker": 1}
    for k, (name, mass) in enumerate(weights.items()):
        inertia = [["1/20", "1/90", "1/80"], ["1/90", "1/30", "-1/99"], ["1/80", "-1/99", "1/25"]]
        builder.body(name, mass=mass, com=[f"{k}/10", "1/20", f"{k}/30"], inertia=inertia)
    axis, across = [0, "3/5", "4/5"], [1, 0, 0]
    kind = {"axes": [[0, 0, 1]], "driven": True} if not free else {}
    builder.joint("A", "free" if free else "R", parent="base", child="post", point=[0, 0, 0], **kind)
    builder.joint("B", "R", parent="post", child="stand", point=["1/10", 0, 0], axes=[axis], driven=True)
    places = {"C": [0, 0, 0], "D": [0, "1/5", "1/4"], "E": [0, "1/2", "3/10"], "F": [0, "2/5", 0]}
    ends = (("stand", "crank"), ("crank", "coupler"), ("coupler", "rocker"), ("rocker", carrier))
    for (name, point), (parent, child) in zip(places.items(), ends, strict=True):
        letter = {"E": "S", "F": "U"}.get(name, "R") if carrier != "stand" else "R"
        axes = {"S": [], "U": [across, [0, 1, 0]], "R": [across]}[letter]
        builder.joint(name, letter, parent=parent, child=child, point=point, axes=axes, driven=name == "C")
    builder.point("tool", body="coupler", at=[0, "1/3", "2/5"])
    return builder.build()


def forces(mechanism: Mechanism, effects: Sequence[Effect]) -> tuple[list[np.ndarray], set[str]]:
    """Drives at the sample states, by every way of the balance, and the joints that carry loops."""
    system = System(mechanism)
    system.use_samples()
    equations = Equations(system, effects)
    setting, loads, wrench = equations.setting, equations.forces.loads, equations.inertial_wrenches(equations.inertia)
    carried = carried_wrenches(setting, wrench, loads)
    ways = [
        way
        for known in ({}, carried)
        for last in (False, True)
        for way in balances(setting, wrench, loads, drives_last=last, carried=known)
    ]
    found = [np.array([system.tape.sample(u) for u in equations.drives(way).u]) for way in ways]
    return found, {system.tree.links[k].joint for k in carriers(setting)}


@pytest.mark.parametrize(
    ("mechanism", "effects", "joints"),
    [
        (carried_bars, (Gravity(), PULLED), {"A", "B"}),
        (lambda: carried_bars(free=True), (Gravity(), PULLED), {"A", "B"}),
        (lambda: carried_bars("post"), (Gravity(),), {"A"}),  # the stand has one end of the loop
        (lambda: braced_arm(Rational(1, 100)), (Gravity(),), {"R0"}),
        slow(lambda: rotary_hexapod(base="stand"), (Gravity(),), {"R"}),
    ],
)
def test_all_ways_ask_for_the_same_drives(
    mechanism: Callable[[], Mechanism], effects: tuple[Effect, ...], joints: set[str]
) -> None:
    (first, *others), carrying = forces(mechanism(), effects)
    assert carrying == joints and np.abs(first).max() > 0.1
    for other in others:
        assert relative(other, first) < 1e-9


@pytest.mark.slow
def test_operations_of_a_carried_hexapod_do_not_rise() -> None:
    assert rise("rods", "turning_hexapod", model("turning_hexapod")) == {}


def test_drives_and_reactions_of_carried_bars_by_method_b() -> None:
    found = derive(carried_bars())
    q, v, a = found.system.states(4, 3)
    (u, _), status = found("joint_reactions", q, v, a)
    expected = newton_euler(found.mechanism, body_states(found, q, v, a), gravity=(0.0, 0.0, -9.81))
    assert np.all(status == 0) and relative(u, expected.drives) < 1e-10
    (back,), _ = found("forward_dynamics", q, v, u)
    assert relative(back, a) < 1e-9
