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


def least_apart(a: np.ndarray, b: np.ndarray) -> float:
    """Least distance of two segments, of 301 points on each: not more than 0.4 % of their lengths above."""
    s, t = np.meshgrid(*[np.linspace(0, 1, 301)] * 2)
    one, other = (p[0] + r[..., None] * (p[1] - p[0]) for p, r in ((a, s), (b, t)))
    return float(np.linalg.norm(one - other, axis=-1).min())


def test_values_of_segments_are_distances() -> None:
    """In general position, in a plane, parallel, almost so, crossing; and slopes are numbers everywhere."""
    ends = [ca.SX.sym(f"p{k}", 3) for k in range(4)]
    value = SHAPES["capsule"].between(ends[:2], ends[2:])  # type: ignore[misc]
    both = ca.Function("apart", ends, [value, ca.gradient(value, ca.vertcat(*ends))])
    random = np.random.default_rng(5)
    for k in range(40):
        places = random.uniform(-1, 1, (4, 3))
        if k % 4 == 0:
            places[3] = places[2] + random.uniform(-2, 2) * (places[1] - places[0])
        if k % 4 == 1:
            places[:, 1] = 0.0
        if k % 4 == 2:
            places[3] = places[2] + places[1] - places[0] + 1e-7 * random.standard_normal(3)
        square, slope = both(*places)
        apart = least_apart(places[:2], places[2:])
        assert np.isfinite(np.array(slope)).all()
        assert -1e-9 <= apart - np.sqrt(max(float(square), 0.0)) <= 0.012, k
    at, bar = PLACES["sphere"], np.array([[-0.3, 0.2, 0.1], [0.5, 0.1, 0.0]])
    bounded = [SHAPES[kind].between(*[[ca.SX(ca.DM(p)) for p in part] for part in (PLACES[kind], bar)])  # type: ignore[misc]
               for kind in ("sphere", "plane")]  # fmt: skip
    sphere, plane = (float(ca.DM(ca.evalf(v))) for v in bounded)
    assert np.sqrt(sphere) == pytest.approx(least_apart(np.repeat(at, 2, 0), bar), abs=1e-3)
    assert plane == pytest.approx(min(nearest("plane", p) for p in bar), abs=1e-12)


@pytest.mark.parametrize("direction", [pytest.param((0.2, 0.1, 0.15), marks=pytest.mark.slow), (0.25, 0.0, 0.0)])
def test_a_bar_is_led_around_a_bar(direction: tuple[float, float, float]) -> None:
    """Bodies as capsules: askew, and parallel all the time, where lines have no nearest points of their own."""
    made = MechanismBuilder("bars")
    made.body("carriage")
    made.body("bead", mass=1, com=[0, 0, 0])
    made.joint("x", "P", parent="base", child="carriage", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    made.joint("z", "P", parent="carriage", child="bead", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    bar = 0.25 * np.array([[-1.0, 0, 0], [1, 0, 0]])
    post = np.array([[-1.0], [1.0]]) * direction
    for name, body, ends in (("b", "bead", bar), ("p", "base", post)):
        for k, place in enumerate(ends):
            made.point(f"{name}{k}", body=body, at=[str(c) for c in place])
    kept = Obstacle("capsule", ("p0", "p1"), (), 0.1, (("b0", "b1"),))
    problem = TrajectoryProblem(
        made.build(), (), **rest_to_rest({"x": -1.0, "z": 0.0}, {"x": 1.0, "z": 0.0}), bounds=Bounds(obstacles=(kept,)),
        guess={"x": (-1.0, 0.0, 1.0), "z": (0.0, 0.4, 0.0)}, transcription=Transcription(intervals=14), violation=1e-2,
        accuracy=(1e-3, 1e-6),
    )  # fmt: skip
    found = solve(problem)
    y = found.sample(count=201).y
    apart = [least_apart(post, bar + np.array([x, 0, z])) for x, z in y[::8]]
    assert found.ok, found.status
    assert 0.1 * (1 - 0.006) < min(apart) < 0.105 and y[100, 1] > 0.09


def test_segments_are_checked() -> None:
    for given, said in (
        (Obstacle("box", ("p0", "p1", "p2", "p3"), (), 0.1, (("bead", "p0"),)), "how far a segment is from a box"),
        (Obstacle("capsule", ("p0", "p1"), (), 0.1, (("bead", "p0"),)), "p0 is an end of both"),
        (Obstacle("capsule", ("p0", "p1"), (), 0.1, (("bead", "bead"),)), "pairs of different points"),
        (Obstacle("capsule", ("p0", "p1"), (), 0.1), "or segments"),
        (Obstacle("sphere", ("p0",), (), 0.1, (("bead", "bed"),)), "unknown name 'bed'"),
    ):
        with pytest.raises(DescriptionError, match=said):
            solve(TrajectoryProblem(bead_beside("box"), (), bounds=Bounds(obstacles=(given,))))


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
