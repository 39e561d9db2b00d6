"""Pulses and peaks that are shorter than the intervals of a mesh: found wherever they are, or said not to be seen."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad
from support.optimal_problems import bead, rest_to_rest

from symscrew.effects import ExternalWrench, JointSpring
from symscrew.optimisation import Objective, TrajectoryProblem, Transcription, optimisation_problem, solve
from symscrew.optimisation.result import Trajectory

pytestmark = pytest.mark.slow

WIDTH, HEIGHT = 5e-4, 1000.0  # [s], [N] of a bell: 0.886 N s
PLACES = (0.0203, 0.51, 0.9787)  # far from the Gauss and Radau points of ten intervals


def sliding(**settings) -> TrajectoryProblem:  # type: ignore[no-untyped-def]
    """1 kg by 1 m in 1 s, on ten intervals."""
    ends = rest_to_rest({"x": 0.0, "z": 0.0}, {"x": 1.0, "z": 0.0})
    return TrajectoryProblem(
        bead(), **{"duration": 1.0, "transcription": Transcription(intervals=10), **ends, **settings}
    )


def pushed(at: float) -> TrajectoryProblem:
    """The same under a pulse."""
    push = f"{HEIGHT}*exp(-((t - {at})/{WIDTH})^2)"
    return sliding(effects=(ExternalWrench("bead", wrench=(push, 0, 0, 0, 0, 0)),))


def end_of(found: Trajectory, at: float) -> np.ndarray:
    """Place and rate of 1 kg at the end: integrals of the drive, a polynomial in every interval, and of the pulse."""
    scheme = found.transcribed.scheme
    assert scheme is not None
    s, weights = np.polynomial.legendre.leggauss(8)
    total = np.zeros(2)
    for low, high, nodal in zip(found.mesh[:-1], found.mesh[1:], found.nodal_drives, strict=True):
        t = (low + high) / 2 + (high - low) / 2 * s
        u = scheme.basis((t - low) / (high - low)) @ nodal[:, 0] * weights * (high - low) / 2
        total += [u @ (1.0 - t), u.sum()]

    def push(t: float) -> float:
        return HEIGHT * math.exp(-(((t - at) / WIDTH) ** 2))

    ends = max(0.0, at - 20 * WIDTH), min(1.0, at + 20 * WIDTH)
    parts = (lambda t: push(t) * (1.0 - t), push)
    return total + [quad(f, *ends, points=[at], epsabs=1e-13)[0] for f in parts]


@pytest.mark.parametrize("at", PLACES)
def test_a_pulse_between_the_points_is_found(at: float) -> None:
    """It throws a plan of the first mesh 0.886 m/s off its goal: no point, no Gauss point and no replay saw it."""
    found = solve(replace(pushed(at), accuracy=(1e-5, 1e-8)))
    assert found.ok, found.status
    assert end_of(found, at) == pytest.approx([1.0, 0.0], abs=2e-5)


def test_a_mesh_that_does_not_see_a_pulse_is_not_confirmed() -> None:
    """A problem that is built once keeps its mesh."""
    found = optimisation_problem(pushed(0.51)).solve(judge=True)
    assert found.solved and not found.ok
    assert np.abs(end_of(found, 0.51) - [1.0, 0.0]).max() > 0.4
    assert found.status.startswith("not confirmed: what acts or counts there changes within")
    assert "near 51.0 % of the duration" in found.status


def test_a_peak_of_a_cost_between_the_points_is_counted() -> None:
    """Against the cost of its motion by an adaptive rule that is told where the peak is."""
    peak = "1e5*exp(-((t - 0.51)/0.0005)^2)*(q_x - 0.2)^2"
    found = solve(sliding(objectives=(Objective("effort"), Objective("expression", expression=peak))))
    assert found.ok, found.status

    t = np.linspace(0.505, 0.515, 401)  # the trapezoidal rule of a bell is exact
    counted = float((1e5 * np.exp(-(((t - 0.51) / WIDTH) ** 2)) * (found.sample(t).q[:, 0] - 0.2) ** 2).sum() * 2.5e-5)
    s, w = np.polynomial.legendre.leggauss(4)
    half = np.diff(found.mesh)[:, None] / 2
    u = found.sample((found.mesh[:-1, None] + half * (1 + s)).ravel()).u
    squares = float((u**2).sum(axis=1) @ (half * w).ravel())
    assert counted > 0.5
    assert found.cost == pytest.approx(counted + squares, abs=max(1e-6, 2 * found.errors.cost))


def test_a_thin_hill_of_a_springs_energy_is_seen_along_the_motion() -> None:
    """A hill of 2.5 J over a millimetre stops a bead that has 1.1 J: a plan went through it without a word."""
    hill = JointSpring("x", energy="2.5*exp(-((x - 0.4949)/0.0005)^2)")
    found = optimisation_problem(sliding(effects=(hill,))).solve(judge=True)
    assert found.solved and not found.ok and "changes within" in found.status


def test_what_changes_slowly_cuts_nothing() -> None:
    waves = ExternalWrench("bead", wrench=("3*sin(4*t) + 1", 0, 0, 0, 0, 0))
    found = solve(sliding(effects=(waves,), accuracy=None))
    assert not len(found.errors.unseen.cuts) and not found.errors.unseen.forces


def test_what_changes_too_fast_to_be_followed_is_not_confirmed() -> None:
    """Waves of a microsecond, whose mean every rule of points takes for something else."""
    waves = ExternalWrench("bead", wrench=("1e3*sin(6e6*t)", 0, 0, 0, 0, 0))
    found = optimisation_problem(sliding(effects=(waves,))).solve(judge=True)
    assert found.solved and not found.ok
    assert "what effects do changes too fast between the points" in " ".join((found.status, *found.reasons))


def test_a_cost_that_changes_too_fast_to_be_followed_is_not_confirmed() -> None:
    """Its integral is a guess of the rule's points: the motion is optimal for what they see alone."""
    costs = (Objective("effort"), Objective("expression", expression="1e3*(1 + sin(6e6*t))*q_x^2"))
    found = optimisation_problem(sliding(objectives=costs)).solve(judge=True)
    assert found.solved and not found.ok
    assert "the cost changes too fast between the points" in " ".join((found.status, *found.reasons))
