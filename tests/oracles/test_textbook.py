"""Closed-form mechanics typed by hand, against the model's own functions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.model_states import model, output, run

from symscrew.description.builder import MechanismBuilder
from symscrew.model import derive


@pytest.mark.parametrize("theta", [0.0, 0.7, -1.4, 2.9])
def test_crank_torque_of_the_slider_crank(theta: float) -> None:
    """Slender crank (a, m1) and rod (b, m2), slider m3: one equation of Lagrange in the crank's angle phi."""
    a, b, m1, m2, m3, g = 0.15, 0.37, 0.5, 0.8, 1.5, 9.81
    theta_dot, theta_ddot = 1.3, -2.1
    # The model's angle turns about +y, phi from x to z.
    phi, w, e = math.atan2(0.12, 0.09) - theta, -theta_dot, -theta_ddot
    s, c = math.sin(phi), math.cos(phi)
    beta = math.asin(-a * s / b)
    sb, cb = math.sin(beta), math.cos(beta)
    b1 = -a * c / (b * cb)
    b2 = (a * s + b * sb * b1**2) / (b * cb)
    x1, x2 = -a * s - b * sb * b1, -a * c - b * cb * b1**2 - b * sb * b2
    u1, u2 = -a * s - b / 2 * sb * b1, -a * c - b / 2 * (cb * b1**2 + sb * b2)
    z1, z2 = a * c + b / 2 * cb * b1, -a * s + b / 2 * (cb * b2 - sb * b1**2)
    torque = (
        m1 * a**2 / 3 * e
        + m2 * (u1 * (u1 * e + u2 * w**2) + z1 * (z1 * e + z2 * w**2))
        + m2 * b**2 / 12 * b1 * (b1 * e + b2 * w**2)
        + m3 * x1 * (x1 * e + x2 * w**2)
        + g * (m1 * a / 2 * c + m2 * z1)
    )
    found = model("slider_crank")
    labels = found.programs["velocity"].inputs[1].labels
    assert labels == ("crank_R",)
    guess = found.system.reference
    for step in np.linspace(0, theta, 8):
        (guess,), status = found("assemble", np.array([step]), guess)
        assert status == 0
    got = run("slider_crank", "inverse_dynamics_independent", guess, np.array([theta_dot]), np.array([theta_ddot]))
    assert got == pytest.approx([-torque], rel=1e-11)
    position = output(found, "forward_kinematics", "positions", guess)
    assert position[0] == pytest.approx(a * c + b * cb + 0.04, rel=1e-13)


def test_double_pendulum() -> None:
    """Two point masses on massless rods, in the plane of gravity: the textbook's equations."""
    builder = MechanismBuilder("double_pendulum")
    builder.body("upper", mass=2, com=[0, 0, "-7/10"])
    builder.body("lower", mass=1, com=[0, 0, "-6/5"])
    builder.joint("first", "R", parent="base", child="upper", point=[0, 0, 0], axes=[[0, -1, 0]], driven=True)
    builder.joint("second", "R", parent="upper", child="lower", point=[0, 0, "-7/10"], axes=[[0, -1, 0]], driven=True)
    found = derive(builder.build())
    l1, l2, m1, m2, g = 0.7, 0.5, 2.0, 1.0, 9.81
    q, v, a = np.array([0.4, -1.1]), np.array([1.2, 0.5]), np.array([-0.3, 2.0])
    t1, t2 = q[0], q[0] + q[1]
    w1, w2, e1, e2 = v[0], v[0] + v[1], a[0], a[0] + a[1]
    lower = m2 * l2 * (l2 * e2 + l1 * math.cos(t1 - t2) * e1 + l1 * math.sin(t1 - t2) * w1**2 * -1 + g * math.sin(t2))
    upper = (
        (m1 + m2) * l1**2 * e1
        + m2 * l1 * l2 * (math.cos(t1 - t2) * e2 + math.sin(t1 - t2) * w2**2)
        + (m1 + m2) * g * l1 * math.sin(t1)
    )
    (u,), status = found("inverse_dynamics", q, v, a)
    assert status == 0
    assert u == pytest.approx([upper + lower, lower], rel=1e-13)


def test_torque_free_top_in_space() -> None:
    """A free body at rest in translation: forces of Euler's equations, drives on all freedoms."""
    builder = MechanismBuilder("satellite")
    builder.body("hub", mass=4, com=[0, 0, 0], inertia=["1/2", "3/4", "1"])
    builder.joint("space", "free", parent="base", child="hub", point=[0, 0, 0], driven=[0, 1, 2, 3, 4, 5])
    found = derive(builder.build(), ())
    w, e = np.array([0.3, -0.8, 1.1]), np.array([0.2, 0.5, -0.4])
    inertia = np.diag([0.5, 0.75, 1.0])
    (u,), status = found("inverse_dynamics", np.r_[0, 0, 0, 1, 0, 0, 0], np.r_[0, 0, 0, w], np.r_[1.0, 2.0, 3.0, e])
    assert status == 0
    assert u == pytest.approx(np.r_[4.0, 8.0, 12.0, inertia @ e + np.cross(w, inertia @ w)], rel=1e-13)


def test_a_loop_of_four_helical_joints() -> None:
    """Delassus' 4H loop: parallel screws of equal pitch move like a planar four-bar and rise together."""
    builder = MechanismBuilder("delassus")
    corners = [(0, 0), (1, 2), (4, 2), (5, 0)]
    for name in ("crank", "coupler", "rocker"):
        builder.body(name, mass=1, com=[1, 1, 0], inertia=["1/10"] * 3)
    chain = ["base", "crank", "coupler", "rocker", "base"]
    for k, (x, y) in enumerate(corners):
        builder.joint(
            f"h{k + 1}",
            "H",
            parent=chain[k],
            child=chain[k + 1],
            point=[x, y, 0],
            axes=[[0, 0, 1]],
            pitch="1/5",
            driven=k == 0,
        )
    found = derive(builder.build())
    y_dot = np.array([0.7])
    (q,), status = found("assemble", np.array([0.3]), found.system.reference)
    assert status == 0
    (v,), status = found("velocity", q, y_dot)
    assert status == 0
    rates = output(found, "joint_rates", "rates", q, v)
    assert abs(rates.sum()) < 1e-12  # the angles of a closed chain of parallel axes add up to nothing
    displacements = output(found, "joint_displacements", "displacements", q)
    assert abs(displacements.sum()) < 1e-12
    planar = derive(_four_bar(corners))
    (flat,), status = planar("assemble", np.array([0.3]), planar.system.reference)
    assert status == 0
    assert displacements == pytest.approx(output(planar, "joint_displacements", "displacements", flat), abs=1e-12)


def _four_bar(corners: list[tuple[int, int]]):
    builder = MechanismBuilder("planar")
    for name in ("crank", "coupler", "rocker"):
        builder.body(name)
    chain = ["base", "crank", "coupler", "rocker", "base"]
    for k, (x, y) in enumerate(corners):
        builder.joint(
            f"r{k + 1}", "R", parent=chain[k], child=chain[k + 1], point=[x, y, 0], axes=[[0, 0, 1]], driven=k == 0
        )
    return builder.build()
