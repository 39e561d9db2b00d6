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

pytestmark = pytest.mark.slow

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
    """Least distance of two segments, of 301 points of the first one: not more than 0.2 % of its length above."""
    places = a[0] + np.linspace(0, 1, 301)[:, None] * (a[1] - a[0])
    along = b[1] - b[0]
    part = np.clip((places - b[0]) @ along / (along @ along or 1.0), 0, 1)
    return float(np.linalg.norm(b[0] + part[:, None] * along - places, axis=1).min())


def test_values_of_segments_are_distances() -> None:
    """In general position, in a plane, parallel, almost so, crossing; and slopes are numbers everywhere."""
    ends = [ca.SX.sym(f"p{k}", 3) for k in range(4)]
    value = SHAPES["capsule"].between(ends[:2], ends[2:]).value
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
    bounded = [
        SHAPES[kind].between(*[[ca.SX(ca.DM(p)) for p in part] for part in (PLACES[kind], bar)]).value
        for kind in ("sphere", "plane")
    ]
    sphere, plane = (float(ca.DM(ca.evalf(v))) for v in bounded)
    assert np.sqrt(sphere) == pytest.approx(least_apart(np.repeat(at, 2, 0), bar), abs=1e-3)
    assert plane == pytest.approx(min(nearest("plane", p) for p in bar), abs=1e-12)


def random_box(random: np.random.Generator) -> np.ndarray:
    """A corner and its neighbours (4, 3)."""
    turned, _ = np.linalg.qr(random.normal(size=(3, 3)))
    corner = random.normal(size=3)
    return np.stack(
        [corner, *(corner + size * edge for size, edge in zip(random.uniform(0.1, 1, 3), turned, strict=True))]
    )


def from_box(box: np.ndarray, points: np.ndarray) -> np.ndarray:
    """What is nearest to each of the points (n, 3) in a box."""
    edges = box[1:] - box[0]
    sizes = np.linalg.norm(edges, axis=1)
    return box[0] + np.clip((points - box[0]) @ (edges / sizes[:, None]).T, 0, sizes) @ (edges / sizes[:, None])


def test_values_of_segments_beside_boxes_are_distances() -> None:
    """In general position, along an edge, along a side, almost so; through the box less than zero."""
    places = [ca.SX.sym(f"p{k}", 3) for k in range(6)]
    value, between = SHAPES["box"].between(places[:4], places[4:])
    every = ca.Function("apart", places, [value, ca.gradient(value, ca.vertcat(*places)), between])
    random, through = np.random.default_rng(6), 0
    for k in range(150):
        box = random_box(random)
        start, end = box[0] + random.normal(size=(2, 3))
        steps = random.normal(size=2) @ (box[1:3] - box[0])
        end = {0: start + steps, 1: start + (box[3] - box[0]), 2: start + steps + 1e-9 * random.normal(size=3)}.get(
            k % 5, end
        )
        along = start + np.linspace(0, 1, 2001)[:, None] * (end - start)
        apart = np.linalg.norm(from_box(box, along) - along, axis=1).min()
        found, slope, other = (np.array(part).ravel() for part in every(*box, start, end))
        assert np.isfinite(slope).all()
        if found[0] <= 1e-12:
            through += 1
            assert apart < 2e-3
        else:  # no place that was tried is nearer, and one is almost as near
            assert -1e-9 <= apart - np.sqrt(found[0]) < 2e-3 and other[0] == pytest.approx(found[0], abs=1e-9)
    assert through > 5


def test_boxes_keep_off_each_other_on_the_safe_side() -> None:
    """Distances by going to and fro between two boxes; boxes above each other exactly, parallel edges and all."""
    places = [ca.SX.sym(f"p{k}", 3) for k in range(8)]
    ((value, _),) = SHAPES["box"].boxes(places[:4], places[4:])
    both = ca.Function("apart", places, [value, ca.gradient(value, ca.vertcat(*places))])
    random, close = np.random.default_rng(7), 0
    for k in range(30):
        one, other = random_box(random), random_box(random)
        if k % 4 == 0:  # the same directions
            other = one + random.normal(size=3)
        point = other.mean(axis=0)[None]
        for _ in range(200):
            near = from_box(one, point)
            point = from_box(other, near)
        apart = float(np.linalg.norm(near - point))
        found, slope = (np.array(part).ravel() for part in both(*one, *other))
        assert np.isfinite(slope).all()
        assert (found[0] > 0) == (apart > 1e-4) and found[0] <= apart**2 + 1e-6
        close += bool(found[0] > 0.9 * apart**2 > 0)
    assert close > 5
    above = PLACES["box"] + [0.05, 0.02, 0.4]
    assert float(both(*PLACES["box"], *above)[0]) == pytest.approx((0.4 - 0.22) ** 2, rel=1e-12)
    inside = PLACES["box"] + [0.05, 0.0, 0.0]
    assert float(both(*PLACES["box"], *inside)[0]) == pytest.approx(-(0.22**2), rel=1e-12)
    bead, plane = PLACES["sphere"], PLACES["plane"]
    for kind, at in (("sphere", bead), ("plane", plane), ("capsule", PLACES["capsule"] + [0, 0, 0.4])):
        values = [float(ca.DM(ca.evalf(kept.value))) for kept in SHAPES[kind].boxes(
            [ca.SX(ca.DM(p)) for p in at], [ca.SX(ca.DM(p)) for p in PLACES["box"] + [0, 0, 0.6]])]  # fmt: skip
        if kind == "plane":
            corners = (
                PLACES["box"][0]
                + [0, 0, 0.6]
                + np.array(np.meshgrid(*[(0, 1)] * 3)).reshape(3, -1).T @ (PLACES["box"][1:] - PLACES["box"][0])
            )
            assert min(values) == pytest.approx(min(nearest("plane", p) for p in corners))
        else:
            along = at[0] + np.linspace(0, 1, 501)[:, None] * (at[-1] - at[0])
            known = np.linalg.norm(from_box(PLACES["box"] + [0, 0, 0.6], along) - along, axis=1).min()
            assert np.sqrt(values) == pytest.approx([known], abs=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("what", ["segment", "box"])
def test_a_body_is_led_around_a_box(what: str) -> None:
    made = MechanismBuilder("bodies")
    made.body("carriage")
    made.body("bead", mass=1, com=[0, 0, 0])
    made.joint("x", "P", parent="base", child="carriage", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    made.joint("z", "P", parent="carriage", child="bead", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    own = np.array([[-0.1, -0.1, -0.05], [0.1, -0.1, -0.05], [-0.1, 0.1, -0.05], [-0.1, -0.1, 0.05]])
    own = own @ np.array([[0.8, 0, -0.6], [0, 1, 0], [0.6, 0, 0.8]])
    for name, body, places in (("b", "bead", own), ("p", "base", PLACES["box"])):
        for k, place in enumerate(places):
            made.point(f"{name}{k}", body=body, at=[str(c) for c in place])
    box, post = (tuple(f"{name}{k}" for k in range(4)) for name in "bp")
    given = {"segments": (("b0", "b1"),)} if what == "segment" else {"boxes": (box,)}
    kept = Obstacle("box", post, (), 0.05, **given)  # type: ignore[arg-type]
    found = solve(TrajectoryProblem(
        made.build(), (), **rest_to_rest({"x": -1.0, "z": 0.0}, {"x": 1.0, "z": 0.0}), bounds=Bounds(obstacles=(kept,)),
        guess={"x": (-1.0, 0.0, 1.0), "z": (0.0, 0.5, 0.0)}, transcription=Transcription(intervals=14), violation=1e-2,
        accuracy=(1e-3, 1e-6),
    ))  # fmt: skip
    assert found.ok, found.status
    apart = []
    for x, z in found.sample(count=201).y:
        moved = own + np.array([x, 0, z])
        point = (
            moved.mean(axis=0)[None]
            if what == "box"
            else moved[0] + np.linspace(0, 1, 301)[:, None] * (moved[1] - moved[0])
        )
        near = from_box(PLACES["box"], point)
        for _ in range(200 if what == "box" else 0):
            point = from_box(moved, near)
            near = from_box(PLACES["box"], point)
        apart.append(np.linalg.norm(near - point, axis=1).min())
    assert 0.05 * (1 - 0.006) < min(apart) < 0.058


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
        (
            Obstacle("box", ("p0", "p1", "p2", "p3"), (), 0.1, (), (("bead", "p0"),)),
            "a corner and its three neighbours",
        ),
        (Obstacle("box", ("p0", "p1", "p2", "p3"), (), 0.1, (), (("p1", "p0", "p2", "p3"),)), "is the obstacle itself"),
        (Obstacle("sphere", ("p0",), (), 0.1, (), (("bead", "p1", "p2", "bed"),)), "unknown name 'bed'"),
        (Obstacle("capsule", ("p0", "p1"), (), 0.1, (("bead", "p0"),)), "p0 is an end of both"),
        (Obstacle("capsule", ("p0", "p1"), (), 0.1, (("bead", "bead"),)), "pairs of different points"),
        (Obstacle("capsule", ("p0", "p1"), (), 0.1), "or segments"),
        (Obstacle("sphere", ("p0",), (), 0.1, (("bead", "bed"),)), "unknown name 'bed'"),
    ):
        with pytest.raises(DescriptionError, match=said):
            solve(TrajectoryProblem(bead_beside(PLACES["box"]), (), bounds=Bounds(obstacles=(given,))))


def test_a_solid_that_is_no_box_is_refused() -> None:
    """In place of taking the box that its edges' lengths would make."""
    askew = PLACES["box"].copy()
    askew[3] += [0.05, 0, 0]
    flat = PLACES["box"].copy()
    flat[2] = flat[0]
    for places, said in ((askew, r"got 77.2 degrees at p0 between p1 and p3"), (flat, "has no edge from p0 to p2")):
        made = MechanismBuilder("bead")
        made.body("bead", mass=1, com=[0, 0, 0])
        made.joint("x", "P", parent="base", child="bead", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
        made.point("bead", body="bead", at=[0, 0, 0])
        for k, place in enumerate(places):
            made.point(f"p{k}", body="base", at=[str(c) for c in place])
        box = tuple(f"p{k}" for k in range(4))
        for given in (Obstacle("box", box, ("bead",), 0.1), Obstacle("sphere", ("bead",), (), 0.1, (), (box,))):
            with pytest.raises(DescriptionError, match=said):
                solve(TrajectoryProblem(made.build(), (), bounds=Bounds(obstacles=(given,))))


def bead_beside(places: np.ndarray | list[list[float]]) -> Mechanism:
    """1 kg on two driven slides in the x-z plane, and the points of a shape on the base."""
    made = MechanismBuilder("bead")
    made.body("carriage")
    made.body("bead", mass=1, com=[0, 0, 0])
    made.joint("x", "P", parent="base", child="carriage", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    made.joint("z", "P", parent="carriage", child="bead", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    made.point("bead", body="bead", at=[0, 0, 0])
    for k, place in enumerate(places):
        made.point(f"p{k}", body="base", at=[str(c) for c in place])
    return made.build()


def around(kind: str, distance: float) -> TrajectoryProblem:
    names = tuple(f"p{k}" for k in range(len(PLACES[kind])))
    return TrajectoryProblem(
        bead_beside(PLACES[kind]), (), **rest_to_rest({"x": -1.0, "z": 0.2}, {"x": 1.0, "z": 0.2}),
        bounds=Bounds(obstacles=(Obstacle(kind, names, ("bead",), distance),)),
        guess={"x": (-1.0, 0.0, 1.0), "z": (0.2, 0.5, 0.2)}, transcription=Transcription(intervals=30),
    )  # fmt: skip


@pytest.mark.parametrize("kind, distance", [
    pytest.param("capsule", 0.2, marks=pytest.mark.slow), pytest.param("box", 0.15, marks=pytest.mark.slow),
    ("plane", 0.05),
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


@pytest.mark.parametrize("kind", ["sphere", "capsule", "box"])
def test_a_post_exactly_on_the_way_is_passed_on_one_side(kind: str) -> None:
    """Of the best way the cost is known: 48 along x; 192 distance^2 for the drive across, to the middle and back.

    From the straight guess the solver ended at costs of thousands, or nowhere: there all slopes point along the way.
    """
    half = 0.1  # [m] of the box
    places = {
        "sphere": [[0, 0, 0]], "capsule": [[0, -1, 0], [0, 1, 0]],
        "box": [[-half, -1, -half], [half, -1, -half], [-half, 1, -half], [-half, -1, half]],
    }[kind]  # fmt: skip
    names = tuple(f"p{k}" for k in range(len(places)))
    problem = TrajectoryProblem(
        bead_beside(places), (), **rest_to_rest({"x": -1.0, "z": 0.0}, {"x": 1.0, "z": 0.0}), accuracy=(1e-3, 1e-6),
        bounds=Bounds(obstacles=(Obstacle(kind, names, ("bead",), 0.4),)), transcription=Transcription(intervals=10),
    )  # fmt: skip
    found, again = solve(problem), solve(problem)
    y = found.sample(count=2001).y
    if kind == "box":
        away = np.maximum(np.abs(y) - half, 0.0)
        assert 48 + 192 * 0.4**2 < found.cost < 48 + 192 * 0.6**2
    else:
        away = y
        assert found.cost == pytest.approx(48 + 192 * 0.4**2, rel=2e-3)
    assert found.ok and np.hypot(*away.T).min() > 0.4 * (1 - 1e-5)
    assert found.cost == again.cost and found.statistics.iterations == again.statistics.iterations


def test_names_and_types_are_checked() -> None:
    with pytest.raises(DescriptionError, match="unknown type 'ball'"):
        TrajectoryProblem(bead_beside(PLACES["sphere"]), bounds=Bounds(obstacles=(Obstacle("ball", (), (), 1),)))
    lost = Bounds(obstacles=(Obstacle("sphere", ("p0",), ("bed",), 0.1),))
    with pytest.raises(DescriptionError, match=r"bounds.obstacles: unknown name 'bed'"):
        solve(TrajectoryProblem(bead_beside(PLACES["sphere"]), (), bounds=lost))
