"""Balls turned far from the reference: rates are in their own axes, and Newton's steps follow these."""

from __future__ import annotations

from functools import cache

import numpy as np
from scipy.spatial.transform import Rotation

import symscrew
from symscrew.description import Mechanism, MechanismBuilder
from symscrew.studies.given_motion import drives
from symscrew.studies.workspace import Axis, Plan
from symscrew.studies.workspace.evaluation import evaluate

ANGLES = 2 * np.pi * np.arange(3) / 3
FEET = np.stack([3 * np.cos(ANGLES), 3 * np.sin(ANGLES), -np.ones(3)], axis=1)
TIPS = np.stack([0.3 * np.cos(ANGLES + 1), 0.3 * np.sin(ANGLES + 1), np.full(3, 0.4)], axis=1)
"""[m]: three legs with long strokes turn a body about a ball at the origin."""
LENGTHS = np.linalg.norm(TIPS - FEET, axis=1)


@cache
def wrist(legs: int) -> Mechanism:
    made = MechanismBuilder("wrist", platform="body")
    made.body("body", mass=2, com=[0, 0, 0.1], inertia=[0.1, 0.12, 0.11])
    made.joint("B", "S", parent="base", child="body", point=[0, 0, 0], driven=() if legs else (0, 1, 2))
    for k in range(legs):
        along = (TIPS[k] - FEET[k]) / LENGTHS[k]
        first = np.cross([0, 0, 1], along)
        first /= np.linalg.norm(first)
        made.body(f"foot{k}", mass=1, com=list(FEET[k])).body(f"tip{k}", mass=1, com=list(TIPS[k]))
        axes = [list(first), list(np.cross(along, first))]
        made.joint(f"U{k}", "U", parent="base", child=f"foot{k}", point=list(FEET[k]), axes=axes)
        made.joint(
            f"P{k}", "P", parent=f"foot{k}", child=f"tip{k}", point=list(FEET[k]), axes=[list(along)], driven=True
        )
        made.joint(f"S{k}", "S", parent=f"tip{k}", child="body", point=list(TIPS[k]))
    return made.build()


def test_rates_are_those_of_the_closure_jacobian() -> None:
    model = symscrew.derive(wrist(3))
    system = model.system
    size = len(system.scales)
    ball = system.tree.velocity_indices("B")
    turned = np.zeros((1, size))
    turned[0, ball] = 1.1, -0.7, 1.6
    q = system.samples.closed(system.advance(system.reference[None], turned))
    (jacobian,), _ = model("closure_jacobian", q[0])
    step = 1e-6
    ends = [system.moved(np.repeat(q, size, 0), sign * step * np.eye(size)) for sign in (1, -1)]
    opening = [model("closure", end)[0][0] for end in ends]
    rates = ((opening[0] - opening[1]) / (2 * step)).T
    assert np.abs(rates - np.reshape(jacobian, (size, -1)).T).max() < 1e-8


def test_a_motion_that_turns_on_where_a_ball_is_turned_is_followed() -> None:
    wanted = {"body.rx": "2*cos(3*t)", "body.ry": "2*sin(3*t)", "body.rz": "1"}
    for legs in (0, 3):
        found = drives(wrist(legs), wanted, duration=0.5, rate=10, backend="casadi")
        quaternions = np.stack([found.columns[f"q.B.{part}"] for part in ("qx", "qy", "qz", "qw")], axis=1)
        t = found.t
        given = Rotation.from_rotvec(np.stack([2 * np.cos(3 * t), 2 * np.sin(3 * t), np.ones_like(t)], axis=1))
        assert (given * Rotation.from_quat(quaternions).inv()).magnitude().max() < 1e-8


def by_hand(strokes: np.ndarray) -> bool:
    """Whether a straight way of all drives from the reference ends at these strokes: Newton's method on rotations."""

    def of(rotation: Rotation) -> np.ndarray:
        return np.linalg.norm(rotation.apply(TIPS) - FEET, axis=1) - LENGTHS

    at = Rotation.identity()
    for part in np.linspace(0, 1, 33)[1:]:
        for _ in range(20):
            miss = of(at) - part * strokes
            if np.abs(miss).max() < 1e-10:
                break
            lever = np.cross(at.apply(TIPS), (at.apply(TIPS) - FEET) / (of(at) + LENGTHS)[:, None])
            step = -np.linalg.lstsq(lever, miss, rcond=None)[0]
            at = Rotation.from_rotvec(step * min(1.0, 0.3 / np.linalg.norm(step))) * at
        else:
            return False
    return True


def test_places_over_drives_are_reached_however_far_the_ball_is_turned() -> None:
    plan = Plan(wrist(3), (), tuple(Axis(f"P{k}", -0.4, 0.4, 3) for k in range(3)), engine="casadi")
    straight = np.concatenate([evaluate(plan, k)["reached"] for k in range(plan.chunks)]) > 0
    strokes = np.stack(np.meshgrid(*[np.linspace(-0.4, 0.4, 3)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    own = np.array([by_hand(goal) for goal in strokes])
    assert own.sum() > 10 and np.array_equal(straight, own)
