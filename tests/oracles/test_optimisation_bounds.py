"""Bounds and conditions one by one: each on the smallest mechanism that shows it, seen by the test's own formulas."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from support.optimal_problems import MINIMUM_TIME, bead, pendulum, rest_to_rest, seed

from symscrew.effects import DcMotor
from symscrew.effects.gravity import Gravity
from symscrew.optimisation.followed_motion import replay
from symscrew.optimisation.planned_motion import Samples
from symscrew.optimisation.problem import Bounds, Conditions, Distance, TrajectoryProblem, Transcription
from symscrew.optimisation.solution import solve

pytestmark = pytest.mark.slow

SWING = rest_to_rest({"hinge": -1.0}, {"hinge": 1.0})
STEEP = Conditions(coordinates={"x": 0.0, "z": 0.0}, at_rest=True)


def swinging(**settings) -> TrajectoryProblem:  # type: ignore[no-untyped-def]
    """1 kg at 1 m from -1 rad to 1 rad in 0.8 s."""
    return TrajectoryProblem(
        pendulum(), **{"duration": 0.8, "transcription": Transcription(intervals=20), **SWING, **settings}
    )


def test_brachistochrone() -> None:
    """A bead whose guides do no work: the cycloid from rest, T = pi sqrt(r / g), r the radius of the rolling circle.

    Gauss points: their quadrature sums the work of an interval exactly, so that none hides between the points.
    """
    radius, g = 0.5, 9.81
    problem = TrajectoryProblem(
        bead(),
        (Gravity((0, 0, "-9.81")),),
        duration=(0.3, 2.0),
        start=STEEP,
        end=Conditions(coordinates={"x": math.pi * radius, "z": -2 * radius}),
        bounds=Bounds(expressions={"u_x*v_x + u_z*v_z": (0.0, 0.0)}),
        objectives=MINIMUM_TIME["objectives"],
        transcription=Transcription("gauss", 4, 12),
    )
    found = solve(problem)
    assert found.ok and found.duration == pytest.approx(math.pi * math.sqrt(radius / g), abs=1e-9)
    at = found.sample(count=21)
    turn = at.t * math.sqrt(g / radius)
    cycloid = radius * np.column_stack([turn - np.sin(turn), np.cos(turn) - 1])
    assert at.y == pytest.approx(cycloid, abs=1e-6)
    assert replay(found).end_error < 1e-6


@pytest.mark.parametrize("arm", [0.0, 0.2])
def test_a_bounded_reaction(arm: float) -> None:
    """The hinge carries the bob, m (g + acceleration), and beside the hinge its arm's moment."""

    def carried(at: Samples) -> np.ndarray:
        y, rate, second = at.y[:, 0], at.y_dot[:, 0], at.y_ddot[:, 0]
        return np.hypot(rate**2 + 9.81 * np.cos(y), second + 9.81 * np.sin(y))

    problem = replace(swinging(), mechanism=pendulum(arm))
    free = solve(problem)
    most = 0.95 * carried(free.sample()).max()
    limit = (None, arm * most) if arm else (most, None)
    kept = solve(replace(problem, bounds=Bounds(reactions={"hinge": limit})))
    assert kept.ok and kept.cost > free.cost * (1 + 1e-6)
    inside = kept.points.reshape(-1, 3)[:, :2].ravel()
    assert most * 0.999 < carried(kept.sample(inside)).max() < most * (1 + 1e-6)
    assert carried(kept.sample()).max() < most * (1 + 1e-3)  # between the points


def test_a_distance_is_kept() -> None:
    """Around a post: without it the way is straight."""
    motion = rest_to_rest({"x": -1.0, "z": 0.0}, {"x": 1.0, "z": 0.0})
    problem = TrajectoryProblem(
        bead(), (), **motion, transcription=Transcription(intervals=30),
        guess={"x": (-1.0, 0.0, 1.0), "z": (0.0, 0.4, 0.0)},
    )  # fmt: skip
    free = solve(problem)
    kept = solve(replace(problem, bounds=Bounds(distances=(Distance("bead", "post", (0.3, math.inf)),))))
    assert free.cost == pytest.approx(48.0, abs=1e-6) and kept.ok and kept.cost > 48.5
    at = kept.sample(count=301)
    apart = np.hypot(at.y[:, 0], at.y[:, 1] - 0.1)
    assert 0.2995 < apart.min() < 0.301
    assert at.y[150, 1] == pytest.approx(0.4, abs=2e-3)  # over it, where the guess leads


def test_positions_and_points_within_bounds() -> None:
    motion = rest_to_rest({"x": -1.0, "z": 0.0}, {"x": 1.0, "z": 0.0})
    via = (Conditions(points={"bead": (None, None, 0.5)}, time=0.5),)
    problem = TrajectoryProblem(bead(), (), **motion, via=via, transcription=Transcription(intervals=20))
    found = solve(replace(problem, bounds=Bounds(points={("bead", 2): (-0.05, 0.5)}, speeds={"z": (-2.0, 2.0)})))
    at = found.sample(count=201)
    assert found.ok and at.y[100, 1] == pytest.approx(0.5, abs=1e-9)
    assert at.y[:, 1].max() < 0.5 + 1e-6 and np.abs(at.y_dot[:, 1]).max() < 2.0 + 1e-3


@pytest.mark.parametrize(
    "end, angle",
    [
        (Conditions(platform_rotation=(0.0, 0.7, 0.0), at_rest=True), 0.7),
        (Conditions(platform_normal=(1.0, 0.0, 1.0), at_rest=True), math.pi / 4),
    ],
)
def test_rotations_of_the_platform(end: Conditions, angle: float) -> None:
    found = solve(replace(swinging(), end=end))
    assert found.ok and found.sample(np.array([found.duration])).y[0, 0] == pytest.approx(angle, abs=1e-8)


def test_the_position_of_the_platform() -> None:
    end = Conditions(platform_position=(0.3, 0.0, -0.2), at_rest=True)
    found = solve(TrajectoryProblem(bead(), (), start=STEEP, end=end, transcription=Transcription(intervals=5)))
    assert found.ok and found.cost == pytest.approx(12 * (0.3**2 + 0.2**2), abs=1e-6)


def test_the_normal_of_the_seed() -> None:
    goal = np.array([0.1, -0.15, 1.0])
    end = Conditions(platform_normal=tuple(goal), at_rest=True)
    found = solve(seed(end=end, transcription=Transcription(intervals=8)))
    poses = found.of_tree("body_poses", found.sample(np.array([found.duration])))[0]
    turned = [poses[12 * k : 12 * k + 9].reshape(3, 3, order="F")[:, 2] for k in range(len(poses) // 12)]
    assert found.ok
    assert min(np.abs(n - goal / np.linalg.norm(goal)).max() for n in turned) < 1e-8


def test_states_of_effects_take_part() -> None:
    """A motor beside the drive, its current lagging behind a constant voltage: L di/dt = U - R i - k rate."""
    motor = DcMotor("hinge", torque_constant="0.5", resistance="1", inductance="0.05")
    settings = {"inputs": {"voltage_hinge": (3.0,)}, "transcription": Transcription("radau", 5, 40)}
    found = solve(swinging(effects=(Gravity(), motor), **settings))
    assert found.ok
    played = replay(found)
    assert played.end_error < 1e-6 and played.integration < 1e-8
    at = found.sample(count=801)
    y, rate, second, current = at.y[:, 0], at.y_dot[:, 0], at.y_ddot[:, 0], at.x[:, 0]
    assert at.u[:, 0] + 0.5 * current == pytest.approx(second + 9.81 * np.sin(y), abs=1e-4)
    assert abs(current[0]) < 1e-15 and np.abs(current).max() > 0.5  # 0 but for the rounding of a sum
    slope = (current[2:] - current[:-2]) / (at.t[2:] - at.t[:-2])
    assert slope == pytest.approx((3 - current - 0.5 * rate)[1:-1] / 0.05, abs=2e-2)


def test_whole_turns_of_a_periodic_motion() -> None:
    """Without weight the pendulum turns on by itself; with it the drive lifts it once and is given it back."""
    turning = TrajectoryProblem(
        pendulum(), (), duration=2.0, start=Conditions(coordinates={"hinge": 0.0}), periodic=True, turns={"hinge": -2},
        transcription=Transcription(intervals=6),
    )  # fmt: skip
    found = solve(turning)
    at = found.sample(count=9)
    assert found.ok and found.cost == pytest.approx(0, abs=1e-9)
    assert at.y[:, 0] == pytest.approx(-2 * math.pi * at.t, abs=1e-6)
    heavy = solve(replace(turning, effects=(Gravity(),), turns={"hinge": 1}, transcription=Transcription(intervals=20)))
    at = heavy.sample(np.array([0.0, 2.0]))
    assert heavy.ok and at.y[1, 0] == pytest.approx(2 * math.pi, abs=1e-9)
    assert at.y_dot[0] == pytest.approx(at.y_dot[1], abs=1e-8)


@pytest.mark.slow
def test_a_crank_turns_round_in_a_closed_chain() -> None:
    """Once around and on: the other joints are where they were, whole turns aside, and the replay agrees."""
    from symscrew import catalogue

    problem = TrajectoryProblem(
        catalogue.load("four_bar"), duration=1.0, start=Conditions(coordinates={"A": 0.1}), periodic=True,
        turns={"A": 1}, transcription=Transcription(intervals=40),
    )  # fmt: skip
    found = solve(problem)
    q = found.sample(np.array([0.0, 1.0])).q
    assert found.ok and q[1, 0] - q[0, 0] == pytest.approx(2 * math.pi, abs=1e-9)
    apart = (q[1] - q[0]) / (2 * math.pi)
    assert apart == pytest.approx(np.round(apart), abs=1e-8) and replay(found).end_error < 1e-6
