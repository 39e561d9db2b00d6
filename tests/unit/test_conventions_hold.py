"""What header, manifest and the page of conventions say of numbers, held against the numbers of the seed at a state."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from support.model_states import model

Array = np.ndarray
SEED = "three_ups_upu_s"
ROUNDING = 1e-12


@cache
def state() -> tuple[Array, Array, Array]:
    q, v, a = (x[3:4] for x in model(SEED).test_inputs["inverse_dynamics"])
    return q, v, a


def named(function: str, *arguments: Array, output: int = 0) -> dict[str, float]:
    results, _ = model(SEED)(function, *arguments)
    return dict(zip(model(SEED).programs[function].outputs[output].labels, results[output][0], strict=True))


def vector(found: dict[str, Any], *labels: str) -> Array:
    return np.array([found[label] for label in labels])


def turned_by(quaternion: Array) -> Array:
    w, x, y, z = quaternion
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def test_quaternions_are_w_x_y_z_from_child_to_parent() -> None:
    q, _, _ = state()
    poses = named("body_poses", q)
    rotation = np.array([[poses[f"platform.R{i}{j}"] for j in "xyz"] for i in "xyz"])
    np.testing.assert_allclose(rotation, turned_by(q[0, 12:]), atol=ROUNDING)


def test_rates_of_a_ball_are_in_the_child_s_axes_and_joint_rates_in_the_parent_s() -> None:
    q, v, _ = state()
    omega = vector(named("body_twists", q, v), *(f"platform.w{i}" for i in "xyz"))
    np.testing.assert_allclose(omega, turned_by(q[0, 12:]) @ v[0, 12:], atol=ROUNDING)
    np.testing.assert_allclose(omega, vector(named("joint_rates", q, v), *(f"limb5_S.{i}" for i in "xyz")))
    assert abs(omega - v[0, 12:]).max() > 1e-4  # the axes differ here


def test_the_force_of_a_slider_acts_on_the_line_through_its_joint_s_point() -> None:
    """Balance of a leg's upper part: rate of momentum = weight + reaction + drive - what it hands to the platform."""
    q, v, a = state()
    found, reactions = model(SEED), named("joint_reactions", q, v, a, output=1)
    parts = ("fx", "fy", "fz", "mx", "my", "mz")
    wrenches = {j: vector(reactions, *(f"{j}.{c}" for c in parts)) for j in ("limb1_P", "limb1_U2")}
    axis = vector(named("joint_screws", q), *(f"limb1_P.{c}" for c in ("vx", "vy", "vz")))
    point = vector(named("joint_points", q), *(f"limb1_P.{i}" for i in "xyz"))
    drive = named("joint_reactions", q, v, a)["limb1_P"] * np.array([*axis, *np.cross(point, axis)])
    body, poses = found.mechanism.bodies["limb1_upper"], named("body_poses", q)
    mass, com = float(found.mechanism.number(body.mass)), [float(found.mechanism.number(x)) for x in body.com]
    rotation = np.array([[poses[f"limb1_upper.R{i}{j}"] for j in "xyz"] for i in "xyz"])
    centre = rotation @ com + vector(poses, *(f"limb1_upper.{i}" for i in "xyz"))
    weight = np.array([0, 0, -9.81 * mass])
    rates = named("momentum_rates", q, v, a)
    rate = np.array([rate for label, rate in rates.items() if label.startswith("limb1_upper.")])
    loads = np.array([*weight, *np.cross(centre, weight)]) + wrenches["limb1_P"] + drive - wrenches["limb1_U2"]
    np.testing.assert_allclose(rate, loads, atol=ROUNDING)


def test_drives_work_by_their_rates() -> None:
    """u > 0 lengthens a slider: the energy grows by u times its rate, v . (M a + bias) of all that moves."""
    q, v, a = state()
    drives = vector(named("inverse_dynamics", q, v, a), *model(SEED).programs["inverse_dynamics"].outputs[0].labels)
    rates = np.array(list(named("drive_rates", q, v).values()))
    (mass,), _ = model(SEED)("mass_matrix", q)
    (bias,), _ = model(SEED)("bias", q, v)
    np.testing.assert_allclose(drives @ rates, v[0] @ (mass[0].reshape(15, 15) @ a[0] + bias[0]), rtol=1e-10)
