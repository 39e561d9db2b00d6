"""Phases of a closed chain against rigid bodies by themselves: impacts, caught masses, posts beside the seam.

The five-bar is written again in its bodies' own coordinates (x, z, angle; every joint two constraints), where
an impact is

    M (v' - v) = C^T impulses,    J v' = 0,    S v' = -e S v,    C = [J; S].
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.optimal_problems import bead

from symscrew.description import load_description
from symscrew.effects import Payload
from symscrew.optimisation.joined_problem import JoinedProblem, Link
from symscrew.optimisation.joined_solution import solve_joined
from symscrew.optimisation.problem import Bounds, Conditions, Obstacle, TrajectoryProblem, Transcription
from symscrew.optimisation.result import Trajectory

pytestmark = pytest.mark.slow

RISE = float(np.sqrt(13) / 20)
BODIES = {  # mass [kg], inertia about y [kg m^2], centre of mass [m], joints of the way from the base
    "proximal_left": (0.4, 1 / 480, (-0.225, 0.1), ("base_left",)),
    "distal_left": (0.5, 0.005, (-0.15, 0.2 + RISE / 2), ("base_left", "elbow_left")),
    "proximal_right": (0.4, 1 / 480, (0.225, 0.1), ("base_right",)),
    "distal_right": (0.5, 0.005, (0.15, 0.2 + RISE / 2), ("base_right", "elbow_right")),
}
JOINTS = {
    "base_left": ("", "proximal_left", (-0.15, 0.0)), "elbow_left": ("proximal_left", "distal_left", (-0.3, 0.2)),
    "base_right": ("", "proximal_right", (0.15, 0.0)), "elbow_right": ("proximal_right", "distal_right", (0.3, 0.2)),
    "tip": ("distal_right", "distal_left", (0.0, 0.2 + RISE)),
}  # fmt: skip
TOOL, LOAD = (0.0, 0.2 + RISE), 0.7  # [m], [kg] of what is caught there


def at_point(body: str, point: tuple[float, float], angles: Mapping[str, float]) -> np.ndarray:
    """Rate of a point of a body by the rates of all bodies: (2, 12)."""
    phi = sum(angles[name] for name in BODIES[body][3])
    arm = np.subtract(point, BODIES[body][2])
    rows, k = np.zeros((2, 12)), 3 * list(BODIES).index(body)
    rows[:, k : k + 2] = np.eye(2)
    rows[:, k + 2] = np.array([[-np.sin(phi), np.cos(phi)], [-np.cos(phi), -np.sin(phi)]]) @ arm
    return rows


def turning(joint: str) -> np.ndarray:
    """Rate of a joint's angle by the rates of all bodies: (12,)."""
    row = np.zeros(12)
    for body, sign in zip(JOINTS[joint][:2], (-1, 1), strict=True):
        if body:
            row[3 * list(BODIES).index(body) + 2] = sign
    return row


def behind(plan: Trajectory, before: np.ndarray, link: Link) -> tuple[np.ndarray, float]:
    """Rates of the driven joints behind an impact at the end of a plan, and the energy it takes."""
    q = plan.sample(np.array([plan.duration])).q[0]
    angles = {c.label: float(v) for c, v in zip(plan.model.system.tree.q, q, strict=True)}
    closed = np.vstack([
        sum(sign * at_point(body, point, angles) for body, sign in ((a, 1), (b, -1)) if body)
        for a, b, point in JOINTS.values()
    ])  # fmt: skip
    driven = np.array([turning("base_left"), turning("base_right")])
    v = np.linalg.lstsq(np.vstack([closed, driven]), np.concatenate([np.zeros(10), before]), rcond=None)[0]
    mass = np.diag([m for body in BODIES.values() for m in (body[0], body[0], body[1])])
    tool = at_point("distal_left", TOOL, angles)
    later = mass + LOAD * tool.T @ tool if link.catches else mass
    hit = np.array([turning(name) for name in link.impact])
    rows = np.vstack([closed, hit])
    wanted = np.concatenate([mass @ v, np.zeros(10), -np.array(list(link.impact.values())) * (hit @ v)])
    system = np.block([[later, rows.T], [rows, np.zeros((len(rows), len(rows)))]])
    after = np.linalg.lstsq(system, wanted, rcond=None)[0][:12]
    assert np.abs(rows @ after - wanted[12:]).max() < 1e-9  # redundant impacts fit each other
    return driven @ after, float(v @ mass @ v - after @ later @ after) / 2


@pytest.mark.parametrize("link", [
    Link({"elbow_left": 0.0}),
    pytest.param(Link({"tip": 1.0}), marks=pytest.mark.slow),
    # more than there are freedoms: rates have to fit them
    pytest.param(Link({"base_left": 0.0, "base_right": 0.9, "tip": 0.1}), marks=pytest.mark.slow),
    Link({"elbow_left": 0.2}, catches=True),
])  # fmt: skip
def test_an_impact_keeps_the_momentum_of_the_bodies(link: Link) -> None:
    home = Conditions(coordinates={"base_left": 0.0, "base_right": 0.0}, at_rest=True)
    first = TrajectoryProblem(
        load_description(Path(__file__).parents[1] / "data" / "short_five_bar.toml"), (), duration=0.3, start=home,
        end=Conditions(coordinates={"base_left": 0.3, "base_right": 0.2}), transcription=Transcription(intervals=4),
        accuracy=(1e-2, 1e-4), independent=("base_left", "base_right"),
    )  # fmt: skip
    loads = (Payload("distal_left", str(LOAD), ("0", 0, repr(TOOL[1]))),) if link.catches else ()
    second = replace(first, start=Conditions(), end=home, duration=(0.2, 0.4), effects=loads)
    found = solve_joined(JoinedProblem((first, second), (link,)))
    (passed,) = found.links
    assert found.ok and passed is not None, found.reasons
    rates, lost = behind(found.parts[0], passed.before, link)
    assert np.abs(passed.before).max() > 0.3 and np.abs(passed.behind - passed.before).max() > 0.2
    assert passed.behind == pytest.approx(rates, abs=1e-8) and passed.lost == pytest.approx(lost, abs=1e-8)
    start = found.parts[1].blocks(np.zeros(1))["y_1"][0] / found.parts[1].duration
    assert start == pytest.approx(rates, abs=1e-7)


@pytest.mark.slow
def test_a_post_thinner_than_an_interval_beside_the_seam_is_seen() -> None:
    """2 mm behind the end of the first phase, where the second passes it in a hundredth of its first interval."""

    def posts(at: float) -> JoinedProblem:
        first = TrajectoryProblem(
            bead(), (), duration=0.5, start=Conditions(coordinates={"x": -0.5 - at, "z": 0.1}, at_rest=True),
            end=Conditions(coordinates={"x": -at, "z": 0.1}), transcription=Transcription(intervals=6),
            accuracy=(1e-3, 1e-5),
            bounds=Bounds(obstacles=(Obstacle("sphere", ("post",), ("bead",), 0.002),)),
        )  # fmt: skip
        second = replace(first, start=Conditions(), end=Conditions(coordinates={"x": 0.5 - at, "z": 0.1}, at_rest=True))
        return JoinedProblem((first, second), (Link(),))

    for at, broken in ((0.0021, 1), (0.001, 0)):
        found = solve_joined(posts(at))
        least = []
        for part in found.parts:
            y = part.sample(count=20001).y
            least.append(np.hypot(y[:, 0], y[:, 1] - 0.1).min())
        assert not found.ok or min(least) > 0.002 * (1 - 1e-5)
        assert found.ok or f"phase {broken + 1}" in found.status or "infeasible" in found.status
