"""Drawings: names off joints, bars and each other; the base and the axes of arms; planar mechanisms seen flat."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from symscrew import catalogue
from symscrew.description import load_description, write_template
from symscrew.description.builder import MechanismBuilder
from symscrew.display.drawing import drawn_in, mechanism_figure, usual_view
from symscrew.display.label_places import label_places
from symscrew.display.shape import drawn_points


def free_of(boxes: np.ndarray, sizes: np.ndarray, joints: np.ndarray) -> bool:
    for k, (box, size) in enumerate(zip(boxes, sizes, strict=True)):
        gap = np.maximum(np.abs(joints[:, :2] - box) - size / 2, 0.0)
        if (np.linalg.norm(gap, axis=1) < joints[:, 2]).any():
            return False
        for other, more in zip(boxes[:k], sizes[:k], strict=True):
            if (np.abs(box - other) < (size + more) / 2).all():
                return False
    return True


@pytest.mark.parametrize("seed", range(6))
def test_names_stand_off_joints_and_other_names(seed: int) -> None:
    random = np.random.default_rng(seed)
    points = random.uniform(0, 250, (10, 2))
    sizes = np.stack([random.uniform(6, 40, 10), np.full(10, 9.5)], axis=1)
    joints = np.column_stack([points, np.full(10, 4.0)])
    found = label_places(points, sizes, bars=[(points[0], points[1])], joints=joints, middle=points.mean(axis=0))
    assert free_of(found, sizes, joints)
    assert (np.abs(found - points) < sizes / 2 + 25).all()  # beside what they name


def test_a_name_is_not_put_on_a_bar_where_there_is_room() -> None:
    bars = [(np.array([-50.0, 0.0]), np.array([50.0, 0.0])), (np.array([0.0, -50.0]), np.array([0.0, 50.0]))]
    size = np.array([[8.0, 8.0]])
    (box,) = label_places(np.zeros((1, 2)), size, bars=bars, joints=np.zeros((0, 3)), middle=np.array([1.0, 0.0]))
    assert (np.abs(box) > 4.0).all()  # in a quadrant, on neither bar


@pytest.mark.parametrize(
    ("name", "view"), [("four_bar", (0.0, -90.0)), ("planar_3rrr", (90.0, -90.0)), ("delta", (20.0, -62.0))]
)
def test_planar_mechanisms_are_seen_along_their_axes(name: str, view: tuple[float, float]) -> None:
    assert usual_view(catalogue.load(name)) == view


@pytest.mark.parametrize("name", ["agile-eye", "orthoglide", "gough"])
def test_no_plate_is_seen_by_its_edge(name: str, tmp_path: Path) -> None:
    """The base of the first two holds the usual view; they are looked at from elsewhere."""
    made = load_description(write_template("m", name, tmp_path / "m.toml"))
    assert (usual_view(made) == (20.0, -62.0)) == (name == "gough")
    for patch in mechanism_figure(made).axes[0].patches:  # plates
        corners = patch.get_path().vertices
        across = np.linalg.svd(corners - corners.mean(axis=0), compute_uv=False)
        assert across[1] > 0.15 * across[0], name


def test_names_of_axes_are_off_joints_and_driven_joints_are_seen(tmp_path: Path) -> None:
    """The x axis of a delta ends at a joint; a driven slide of an Orthoglide stands under a hinge."""
    axes = mechanism_figure(catalogue.load("delta")).axes[0]
    to_pixels = axes.transData.transform
    (name,) = [text for text in axes.texts if text.get_text() == "$x$"]
    middle = to_pixels(name.xy) + np.array(name.xyann) * axes.figure.dpi / 72
    marks = [line for line in axes.lines if line.get_marker() not in ("None", ".", "")]
    far = [np.linalg.norm(to_pixels(line.get_xydata()[0]) - middle) * 72 / axes.figure.dpi for line in marks]
    assert len(marks) == 15 and min(far) > 8  # points of type: half a letter and half a mark

    made = load_description(write_template("m", "orthoglide", tmp_path / "m.toml"))
    marks = [line for line in mechanism_figure(made).axes[0].lines if line.get_marker() in ("s", "o")]
    driven = [mark for mark in marks if mark.get_markerfacecolor() != "white"]
    assert len(driven) == 3 and driven == marks[-3:], "drawn last, above others"
    for mark in driven:
        below = [m for m in marks[:-3] if np.allclose(m.get_xydata(), mark.get_xydata(), atol=1e-9)]
        assert below and all(m.get_markersize() > mark.get_markersize() + 2 for m in below)


def test_an_arm_has_its_axes_and_its_base() -> None:
    lines = {name: len(mechanism_figure(catalogue.load(name)).axes[0].lines) for name in ("ur5", "four_bar")}
    assert lines["ur5"] >= 6 + 6 + 6 + 1  # bodies, axes, marks, base


def test_a_pendulum_reaches_to_its_centre_of_mass() -> None:
    builder = MechanismBuilder("pendulum")
    builder.body("rod", mass=1, com=[0, 0, "-1/2"])
    builder.joint("pivot", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    assert drawn_points(builder.build())["rod"].tolist() == [[0, 0, 0], [0, 0, -0.5]]


def test_bodies_are_drawn_in_their_poses() -> None:
    mechanism = catalogue.load("four_bar")
    shift = {body: (np.eye(3), np.array([5.0, 0.0, 0.0])) for body in mechanism.bodies if body != mechanism.ground}
    still, moved = (drawn_in(mechanism, poses, labels=False).axes[0] for poses in ({}, shift))
    assert np.ptp(moved.dataLim.intervalx) > np.ptp(still.dataLim.intervalx) + 3
