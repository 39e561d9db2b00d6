"""Obstacles: values against distances to many points of the shapes, and motions led around each of them."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
from support.optimal_problems import rest_to_rest

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.errors import DescriptionError
from symscrew.optimisation.obstacles import SHAPES
from symscrew.optimisation.problem import Bounds, Obstacle, TrajectoryProblem, Transcription
from symscrew.optimisation.solution import solve

PLACES = {
    "sphere": np.array([[0.1, 0.0, 0.05]]),
    "plane": np.array([[0.0, 0.0, -0.06], [0.1, 0.0, 0.5]]),
    "capsule": np.array([[-0.3, 0.05, 0.02], [0.2, 0.0, 0.1]]),
    "box": np.array([[-0.2, -0.1, -0.1], [0.2, -0.1, -0.1], [-0.2, 0.3, -0.1], [-0.2, -0.1, 0.12]]),
}
GRID = np.array(np.meshgrid(*[np.linspace(0, 1, 41)] * 3)).reshape(3, -1).T


def nearest(kind: str, point: np.ndarray) -> float:
    """Least distance of a point to many points of a shape; of a plane, the height of a parallelepiped on it."""
    at = PLACES[kind]
    if kind == "plane":
        across = np.linalg.svd((at[1] - at[0])[None])[2][1:]
        return abs(float(np.linalg.det([*across, point - at[0]])))
    return float(np.linalg.norm(members(kind) - point, axis=1).min())


def members(kind: str) -> np.ndarray:
    """Many points of a shape."""
    at = PLACES[kind]
    if kind == "sphere":
        return at
    if kind == "capsule":
        return at[0] + GRID[:, :1] * (at[1] - at[0])
    return at[0] + GRID @ (at[1:] - at[0])


@pytest.mark.parametrize("kind", SHAPES)
def test_values_are_distances(kind: str) -> None:
    shape, at = SHAPES[kind], PLACES[kind]
    random = np.random.default_rng(4)
    for point in random.uniform(-0.6, 0.6, (30, 3)):
        value = float(ca.DM(ca.evalf(shape.value([ca.SX(ca.DM(p)) for p in at], ca.SX(ca.DM(point))))))
        apart = nearest(kind, point)
        inside = kind == "box" and apart < 0.02 and value <= 0  # no member is nearer than the grid is wide
        side = np.sign((point - at[0]) @ (at[-1] - at[0])) if kind == "plane" else 1.0
        if not inside:
            assert value == pytest.approx(side * apart if kind == "plane" else apart**2, abs=0.01)


def bead_beside(kind: str) -> Mechanism:
    """1 kg on two driven slides in the x-z plane, and the points of a shape on the base."""
    made = MechanismBuilder("bead")
    made.body("carriage")
    made.body("bead", mass=1, com=[0, 0, 0])
    made.joint("x", "P", parent="base", child="carriage", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    made.joint("z", "P", parent="carriage", child="bead", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    made.point("bead", body="bead", at=[0, 0, 0])
    for k, place in enumerate(PLACES[kind]):
        made.point(f"p{k}", body="base", at=[str(c) for c in place])
    return made.build()


def around(kind: str, distance: float) -> TrajectoryProblem:
    names = tuple(f"p{k}" for k in range(len(PLACES[kind])))
    return TrajectoryProblem(
        bead_beside(kind), (), **rest_to_rest({"x": -1.0, "z": 0.2}, {"x": 1.0, "z": 0.2}),
        bounds=Bounds(obstacles=(Obstacle(kind, names, ("bead",), distance),)),
        guess={"x": (-1.0, 0.0, 1.0), "z": (0.2, 0.5, 0.2)}, transcription=Transcription(intervals=30),
    )  # fmt: skip


@pytest.mark.parametrize("kind, distance", [
    pytest.param("sphere", 0.25, marks=pytest.mark.slow), pytest.param("capsule", 0.2, marks=pytest.mark.slow),
    pytest.param("box", 0.15, marks=pytest.mark.slow), ("plane", 0.05),
])  # fmt: skip
def test_a_bead_is_led_around_and_touches(kind: str, distance: float) -> None:
    problem = around(kind, distance)
    if kind == "plane":  # a straight way never crosses one from the same side, one that begins downwards does
        problem = replace(problem, start=replace(problem.start, at_rest=False, rates={"x": 0.0, "z": -2.0}), guess={})
    found = solve(problem)
    y = found.sample(count=801).y
    places = np.column_stack([y[:, 0], np.zeros(len(y)), y[:, 1]])
    apart = np.array([nearest(kind, p) for p in places[::4]])
    assert found.ok and found.cost > 48.01  # 48 is straight
    assert apart.min() > distance * (1 - 1e-4) - 1e-9 and apart.min() < distance + 0.02


def test_names_and_types_are_checked() -> None:
    with pytest.raises(DescriptionError, match="unknown type 'ball'"):
        around("sphere", 0.1).__class__(bead_beside("sphere"), bounds=Bounds(obstacles=(Obstacle("ball", (), (), 1),)))
    lost = Bounds(obstacles=(Obstacle("sphere", ("p0",), ("bed",), 0.1),))
    with pytest.raises(DescriptionError, match=r"bounds.obstacles: unknown name 'bed'"):
        solve(TrajectoryProblem(bead_beside("sphere"), (), bounds=lost))
