"""Places behind a hole of the workspace: those that an arm of two lengths reaches are an annulus, by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.studies.workspace import Axis, Plan, Results, around_holes, sweep_summary, sweep_summary_text
from symscrew.studies.workspace.evaluation import evaluate

UPPER, FORE = 0.5, 0.3  # [m]: the hand's joint is 0.2 m to 0.8 m from the shoulder


def arm() -> Mechanism:
    """Bent by a right angle; its hand, whose joint is what is looked at, turns for nothing."""
    made = MechanismBuilder("arm", platform="hand")
    made.body("upper").body("fore").body("hand")
    for name, parent, child, point in (
        ("A", "base", "upper", [0, 0, 0]),
        ("B", "upper", "fore", [UPPER, 0, 0]),
        ("C", "fore", "hand", [UPPER, 0, FORE]),
    ):
        made.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 1, 0]])
    return made.build()


def swept(plan: Plan) -> Results:
    pieces = [evaluate(plan, k) for k in range(plan.chunks)]
    return around_holes(plan, {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]})


def test_an_annulus_is_reached_whole_however_it_is_cut() -> None:
    """Straight ways alone leave out what is behind its hole."""
    axes = Axis("hand.x", -1.32, 0.32, 7), Axis("hand.z", -1.11, 0.51, 7)
    plan = Plan(arm(), (), axes, engine="casadi", steps=8)
    found = swept(plan)
    x, z = UPPER + found["hand.x"], FORE + found["hand.z"]
    far = np.hypot(x, z)
    assert np.array_equal(found["reached"] > 0, (far >= UPPER - FORE) & (far <= UPPER + FORE))
    shadow = found["around"] > 0
    assert shadow.sum() >= 4 and (found["allowed"][shadow] == 1).all() and (found["status"][shadow] == 0).all()
    turned = found["A"] + found["B"]
    tip = np.stack(
        [UPPER * np.cos(found["A"]) + FORE * np.sin(turned), FORE * np.cos(turned) - UPPER * np.sin(found["A"])]
    )
    there = found["reached"] > 0
    assert np.abs(tip - (x, z))[:, there].max() < 1e-10
    assert (np.cos(found["B"][there]) > 0).all()  # the elbow as in the reference, never stretched on the way
    again = swept(replace(plan, chunk=10))
    assert all(np.array_equal(values, again[name], equal_nan=True) for name, values in found.items())
    summary = sweep_summary(plan, found, {})
    assert summary["around"] == shadow.sum() and summary["reached"] == there.sum()
    assert f"{(there & ~shadow).sum()} are reached straight from the start, {shadow.sum()} more round holes" in (
        sweep_summary_text(summary)
    )
