"""Drag of a box in a wind against its formulas and the laws of Newton and Euler, typed here."""

from __future__ import annotations

import numpy as np
import pytest

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects import FluidDrag
from symscrew.effects.effect import Effect
from symscrew.effects.registry import check_effects
from symscrew.errors import DescriptionError
from symscrew.model import derive

J = np.array([[0.5, 0.05, 0.02], [0.05, 0.4, 0.03], [0.02, 0.03, 0.3]])
COM, SIDES, RHO, MU, WIND = np.array([0.1, 0.2, -0.3]), (0.3, 0.2, 0.1), 800.0, 2.0, np.array([0.5, -1.0, 0.2])
AXES = np.array([[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])


def box() -> Mechanism:
    b = MechanismBuilder("box")
    b.body("box", mass=2, com=[str(c) for c in COM], inertia=[[str(x) for x in row] for row in J])
    b.joint("F", "free", parent="base", child="box", point=[0, 0, 0])
    return b.build()


def drag(axes: object = (("0.6", "0.8", 0), ("-0.8", "0.6", 0), (0, 0, 1))) -> Effect:
    return FluidDrag("box", SIDES, RHO, MU, tuple(WIND), axes)  # type: ignore[arg-type]


@pytest.mark.parametrize("axes", [drag().axes, ((3, 4, 0), (-8, 6, 0), (0, 0, "1/7"))])  # type: ignore[attr-defined]
def test_a_box_slows_down_as_its_faces_say(axes: object) -> None:
    """Axes of any length are directions; lengths came into the forces squared and more."""
    found = derive(box(), [drag(axes)])
    q, v, _ = found.system.sample_states
    (a, *_), status = found("forward_dynamics", q, v)
    assert not status.any()
    (poses,), _ = found("body_poses", q)
    (twists,), _ = found("body_twists", q, v)
    (rates,), _ = found("body_twist_rates", q, v, a)
    (powers,), _ = found("effect_power", q, v)
    for pose, twist, rate, power in zip(poses, twists, rates, powers, strict=True):
        rotation, (omega, speed), (alpha, gain) = pose[:9].reshape(3, 3).T, twist.reshape(2, 3), rate.reshape(2, 3)
        com = rotation @ COM + pose[9:12]
        centre = speed + np.cross(omega, com)
        along = rotation @ AXES.T
        u, w, size = along.T @ (centre - WIND), along.T @ omega, sum(SIDES) / 3
        force, moment = np.zeros(3), np.zeros(3)
        for i in range(3):
            one, two, three = (SIDES[(i + k) % 3] for k in range(3))
            force[i] = -3 * np.pi * size * MU * u[i] - RHO * two * three * abs(u[i]) * u[i] / 2
            moment[i] = -np.pi * size**3 * MU * w[i] - RHO * one * (two**4 + three**4) * abs(w[i]) * w[i] / 64
        force, moment, turned = along @ force, along @ moment, rotation @ J @ rotation.T
        moved = gain + np.cross(alpha, com) + np.cross(omega, centre)  # of the centre: the twist rate is that at O
        assert 2 * moved == pytest.approx(force, rel=1e-10, abs=1e-10)
        assert turned @ alpha + np.cross(omega, turned @ omega) == pytest.approx(moment, rel=1e-10, abs=1e-10)
        assert power == pytest.approx([force @ centre + moment @ omega], rel=1e-10)


@pytest.mark.parametrize("axes", [((1, 0, 0), (1, 0, 0), (0, 0, 1)), ((0, 0, 0), (0, 1, 0), (0, 0, 1))])
def test_what_is_no_box_is_refused(axes: object) -> None:
    with pytest.raises(DescriptionError, match="three perpendicular directions"):
        check_effects(box(), [drag(axes)])
