"""Certified regions against closed forms: every point of what is proved, and what a grid of samples does not see."""

from __future__ import annotations

import json
import math
from functools import cache
from typing import Any

import numpy as np
import pytest

from symscrew import catalogue, derive
from symscrew.description import Mechanism, MechanismBuilder
from symscrew.studies.certificate import Certificate, certify, check_certificate
from symscrew.studies.certificate.certificate_checker import Equations, tubes
from symscrew.studies.workspace import Axis, Plan

DEG = math.pi / 180
RNG = np.random.default_rng(20261123)

# -- a thin tongue -----------------------------------------------------------------------------------------

GAP, ARM, ROD = 0.001, 1.0, 1.0009
"""Half the distance of the pivots, the driven arms, the rods to the tool [m]: stretched arms are just too long."""
START = np.array([2.55, 0.35])
WIDE = (Axis("left", -0.1, 0.7, 17), Axis("right", -0.7616, 0.0384, 17))


def elbows(left: np.ndarray, right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Places (n, 2) at the displacements of both arms from the start."""
    first, second = START[0] + left, START[1] + right
    return (
        np.stack([-GAP + ARM * np.cos(first), ARM * np.sin(first)], axis=-1),
        np.stack([GAP + ARM * np.cos(second), ARM * np.sin(second)], axis=-1),
    )


def tool(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Where both rods meet, above the line of the elbows; NaN where these are too far apart."""
    a, b = elbows(np.asarray(left, float), np.asarray(right, float))
    between = b - a
    half = np.linalg.norm(between, axis=-1) / 2
    with np.errstate(invalid="ignore"):
        height = np.sqrt(ROD**2 - half**2)
    normal = np.stack([-between[..., 1], between[..., 0]], axis=-1) / (2 * half[..., None])
    return (a + b) / 2 + height[..., None] * normal


@cache
def tongue() -> Mechanism:
    """A five-bar with a thin region of drive angles in which its rods do not reach each other."""
    builder = MechanismBuilder("tongue", platform="left_rod")
    for name in ("left_arm", "right_arm", "left_rod", "right_rod"):
        builder.body(name, mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    (a, b), t = elbows(np.zeros(()), np.zeros(())), tool(np.zeros(()), np.zeros(()))
    parts = (
        ("left", "base", "left_arm", (-GAP, 0.0)), ("left_elbow", "left_arm", "left_rod", a),
        ("right", "base", "right_arm", (GAP, 0.0)), ("right_elbow", "right_arm", "right_rod", b),
        ("tip", "right_rod", "left_rod", t),
    )  # fmt: skip
    for name, parent, child, (x, y) in parts:
        at = [float(x), float(y), 0]
        driven = name in ("left", "right")
        builder.joint(name, "R", parent=parent, child=child, point=at, axes=[[0, 0, 1]], driven=driven)
    return builder.build()


@cache
def of_tongue() -> Certificate:
    return certify(Plan(tongue(), (), WIDE))


def points_of(found: Certificate, each: int) -> tuple[np.ndarray, np.ndarray]:
    """Random points (k, n) of joined boxes, and which box each is of."""
    boxes = [box for box in found.root.leaves if box.joined]
    z = [box.low + (box.high - box.low) * RNG.random(len(box.low)) for box in boxes for _ in range(each)]
    return np.array(z).T, np.repeat(np.arange(len(boxes)), each)


def test_a_grid_misses_a_thin_tongue_and_the_certificate_does_not() -> None:
    """Elbows further apart than both rods: known by their distance alone. None of 11 x 11 samples is in it."""
    grid = np.meshgrid(*(np.linspace(a.low, a.high, 11) for a in WIDE), indexing="ij")
    assert np.isfinite(tool(*grid)).all()
    fine = np.stack([g.ravel() for g in np.meshgrid(*(np.linspace(a.low, a.high, 401) for a in WIDE), indexing="ij")])
    lost = np.isnan(tool(*fine)[..., 0])
    assert 100 < lost.sum() < 0.05 * lost.size
    found = of_tongue()
    assert found.ok and not found.summary["whole"] and found.summary["share"] > 0.5
    assert "closure" in found.summary["undecided"]
    for box in found.root.leaves:
        inside = ((box.low[:, None] <= fine) & (fine <= box.high[:, None])).all(axis=0)
        assert box.state == "undecided" or not (inside & lost).any()
    # the other side of the tongue has configurations, but no chain of proved boxes leads there
    proved = [box for box in found.root.leaves if box.state == "certified"]
    near = [START[0] + box.high[0] - START[1] - box.low[1] < math.pi for box in proved]
    assert all(side for box, side in zip(proved, near, strict=True) if box.joined)
    assert sum(not side for side in near) > 10


def test_tubes_hold_the_configurations_of_the_closed_form() -> None:
    found = of_tongue()
    z, box = points_of(found, 3)
    equations = Equations.read(found.values["equations"])
    boxes = [b for b in found.root.leaves if b.joined]
    low, high, centre = (np.stack([getattr(b, n) for b in boxes], axis=1) for n in ("low", "high", "centre"))
    tube = tubes(equations, low, high, centre)
    a, b = elbows(*z)
    t = tool(*z)
    start = [elbows(np.zeros(()), np.zeros(()))[0], tool(np.zeros(()), np.zeros(()))]
    turned = [np.arctan2(*(t - e)[:, ::-1].T) - np.arctan2(*(start[1] - e0)[::-1]) for e, e0 in
              ((a, start[0]), (b, elbows(np.zeros(()), np.zeros(()))[1]))]  # fmt: skip
    exact = {"left_elbow": turned[0] - z[0], "right_elbow": turned[1] - z[1]}
    labels = [c.label for c in model_of_tongue().system.tree.q]
    half = (high - low)[:, box] / 2
    d = (z - (low + high)[:, box] / 2) / half
    for row, k in enumerate(equations.dependent):
        wanted = exact[labels[k]]
        held = tube.centre[row, box] + (tube.slope[row][:, box] * d).sum(axis=0)
        off = (wanted - held + math.pi) % (2 * math.pi) - math.pi
        assert (np.abs(off) <= tube.tight[row, box] + 1e-12).all()


@cache
def model_of_tongue() -> Any:
    return derive(tongue())


@pytest.mark.slow
def test_limits_are_proved_and_passed_where_they_are() -> None:
    """A limit of an elbow's angle, which the closed form gives: proved boxes are inside, boxes outside it outside."""
    low, high = -0.1, 0.12
    limits = (("left_elbow", low, high),)
    found = certify(Plan(tongue(), (), (Axis("left", -0.2, 0.2, 9), Axis("right", -0.2, 0.2, 9)), limits=limits))
    states = {box.state for box in found.root.leaves}
    assert found.ok and {"outside", "certified", "undecided"} <= states
    at, there = elbows(np.zeros(()), np.zeros(()))[0], tool(np.zeros(()), np.zeros(()))
    for box in found.root.leaves:
        z = box.low + (box.high - box.low) * RNG.random((20, 2))
        a, t = elbows(*z.T)[0], tool(*z.T)
        turn = np.arctan2(*(t - a)[:, ::-1].T) - np.arctan2(*(there - at)[::-1]) - z[:, 0]
        turn = (turn + math.pi) % (2 * math.pi) - math.pi
        inside = (low <= turn) & (turn <= high)
        if box.state in ("certified", "outside"):
            assert (inside == (box.state == "certified")).all()


# -- mechanisms of the catalogue ---------------------------------------------------------------------------


@pytest.mark.slow
def test_the_proof_of_the_seed_ends_at_its_constraint_singularity() -> None:
    """|d| = R sin(theta) at azimuth 270 degrees, solved by itself: what is proved ends just below, never above.

    Section 3.2 of the source paper asks for ten degrees in every direction.
    """
    low, high = 15 * DEG, 25 * DEG
    for _ in range(60):
        middle = (low + high) / 2
        height = 0.3 * math.sqrt(3)
        x = 0.8 - 0.5 * math.cos(middle) - height * math.sin(middle)
        z = height * math.cos(middle) - 0.5 * math.sin(middle)
        low, high = (middle, high) if x**2 + z**2 > 0.8 * x else (low, middle)
    axes = (Axis("tilt", 0.0, 22 * DEG, 33), Axis("azimuth", 0.0, 2 * math.pi, 2))
    found = certify(Plan(catalogue.load("three_ups_upu_s"), (), axes))
    proved = found.summary["tilt"]["every_direction"]
    assert found.ok and 10 * DEG < low - 0.6 * DEG < proved < low
    assert found.summary["shares"]["not joined"] > 0.005


FEW = 15
SMALL = {
    "delta": (
        ("platform_pose.0", -0.008, 0.008), ("platform_pose.1", -0.008, 0.008), ("platform_pose.2", -0.542, -0.530),
    ),
    "planar_3rrr": (("limb1_R1", -0.1, 0.1), ("limb2_R1", -0.1, 0.1), ("limb3_R1", -0.1, 0.1)),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", SMALL)
def test_boxes_are_free_of_singularities_at_random_points(name: str) -> None:
    """Assembled by the model, drives to platform by singular values: the same sign of the determinant everywhere."""
    axes = tuple(Axis(n, low, high, 17) for n, low, high in SMALL[name])
    plan = Plan(catalogue.load(name), (), axes)
    found = certify(plan)
    assert found.ok and found.summary["whole"] and found.summary["boxes"] < FEW  # 8 and 35 where tubes are intervals
    if name == "planar_3rrr":
        verdict = check_certificate(json.loads(json.dumps(found.values)))  # as it is read again
        assert verdict.holds and verdict.facts["whole"]
    made = derive(plan.mechanism, plan.effects, independent=plan.independent)
    z, _ = points_of(found, 40)
    z = z[:, RNG.permutation(z.shape[1])[:40]]
    guess = np.repeat(made.system.reference[None, :], z.shape[1], 0)
    (q,), status = made("assemble", z.T, guess)
    assert (status == 0).all()
    null, status = made("null_space", q)
    assert (status == 0).all()
    columns = null[0].reshape(len(q), z.shape[0], -1)
    rates = np.stack([made("drive_rates", q, np.ascontiguousarray(columns[:, k]))[0][0] for k in range(z.shape[0])], 2)
    signs = np.sign(np.linalg.det(rates))
    assert (signs == signs[0]).all() and signs[0] != 0
