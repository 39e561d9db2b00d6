"""A flat delta: all rods in the platform's plane, where the closure and the drives lose rank."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support.model_states import relative

from hard import precise
from hard.mechanisms import catalogue_text, changed
from symscrew.model import Model, derive


@cache
def flat() -> Model:
    """A delta whose rods are in the platform's plane in the reference configuration."""
    return derive(
        changed(catalogue_text("delta"), ('[parameters.rods]\nvalue = "0.7"', '[parameters.rods]\nvalue = "0.45"'))
    )


@pytest.mark.slow
def test_flat_delta() -> None:
    """All rods in the platform's plane: six lines of rank 3. Accelerations with status -2, drives refused.

    Samples that are not finite at this reference configuration must not choose pivots (`elimination.magnitude`):
    when they did, twelve-digit accelerations of the states around it became 20 % wrong with status 0.
    """
    found = flat()
    assert any("the reference configuration is singular" in note for note in found.notes)
    q, v, _ = found.system.sample_states
    u = np.array([1.0, -2.0, 3.0])
    still = np.zeros_like(v[0])
    for function in ("forward_dynamics", "forward_dynamics_reactions"):
        results, status = found(function, q[0], still, u)
        assert status == -2 and all(np.isfinite(x).all() for x in results)
    results, _ = found("forward_dynamics", q[0], still, u)
    expected = precise.doubles(precise.accelerations(found, q[0], still, u))
    assert relative(results[0], expected) < 1e-13
    for function in ("inverse_dynamics", "velocity", "acceleration", "null_space"):
        results, status = found(function, *(x[0] for x in found.test_inputs[function]))
        assert status == 1 and np.isnan(results[0]).all()
    for k in (1, 2):  # around it
        (a,), status = found("forward_dynamics", q[k], v[k], u)
        assert status <= 0
        assert relative(a, precise.doubles(precise.accelerations(found, q[k], v[k], u, 18))) < 1e-12


def passing(angle: float, rate: float) -> tuple[np.ndarray, np.ndarray]:
    """q, v of the flat delta whose arms all turn alike: arms of 0.3 m at `angle`, rods of 0.45 m at phi to the plane.

    0.15 + 0.3 cos(angle) = 0.45 cos(phi), so that sin(phi/2) = sqrt(2/3) sin(angle/2): smooth through the plane.
    """
    found, slope = flat(), np.sqrt(2 / 3)
    phi = 2 * np.arcsin(slope * np.sin(angle / 2))
    turning = slope * np.cos(angle / 2) / np.cos(phi / 2) * rate
    q, v = np.array(found.system.reference), np.zeros(len(found.system.tree.v))
    height = {"q": 0.45 * np.sin(phi) - 0.3 * np.sin(angle)}
    height["v"] = 0.45 * np.cos(phi) * turning - 0.3 * np.cos(angle) * rate
    for key, values, arm, rod in (("q", q, angle, phi - angle), ("v", v, rate, turning - rate)):
        for k, coordinate in enumerate(getattr(found.system.tree, key)):
            if coordinate.label.startswith("arm"):
                values[k] = arm
            elif coordinate.label.startswith("rod") and coordinate.label.endswith(".0"):
                values[k] = rod
            elif coordinate.label == "platform_pose.2":
                values[k] = height[key]
    return q, v


@pytest.mark.slow
def test_flat_delta_from_both_sides() -> None:
    """All rods pass the platform's plane at speed: accelerations lose eps/angle and have one limit."""
    found, u = flat(), np.array([3.0, 3.0, 3.0])
    for angle in (1e-2, 1e-6):
        sides = []
        for sign in (1, -1):
            q, v = passing(sign * angle, 2.0)
            (residual,), _ = found("closure", q)
            with np.errstate(all="ignore"):  # the first path, whose pivot is too small
                (a,), status = found("forward_dynamics", q, v, u)
            assert np.abs(residual).max() < 1e-15 and status in (0, -1)
            expected = precise.doubles(precise.accelerations(found, q, v, u, 18))
            assert relative(a, expected) < 3e-15 / angle
            sides.append(a)
        assert np.abs(sides[0] - sides[1]).max() < angle + 1e-12 / angle
    (a,), status = found("forward_dynamics", *passing(0.0, 2.0), u)
    assert status == -2 and np.abs(a).max() < 300
