"""Known optima: closed forms, and problems whose value an independent transcription gives."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest
from support.optimal_problems import (
    KELLY,
    MINIMUM_TIME,
    cart_pole_problem,
    pendulum,
    rest_to_rest,
    slider,
)

from oracles.pseudospectral import least_effort
from symscrew.effects.gravity import Gravity
from symscrew.optimisation.followed_motion import replay
from symscrew.optimisation.problem import Bounds, Objective, Solver, TrajectoryProblem, Transcription
from symscrew.optimisation.result import Trajectory
from symscrew.optimisation.solution import solve

ALL = [
    Transcription("radau", 3, 20),
    Transcription("gauss", 2, 20),
    Transcription("radau", 3, 20, second_order=False),
    Transcription("gauss", 3, 20, formulation="forward"),
]


def sliding(**settings) -> TrajectoryProblem:  # type: ignore[no-untyped-def]
    """A mass of 1 kg over 1 m from rest to rest."""
    return TrajectoryProblem(slider(), effects=(), **{**rest_to_rest({"slide": 0.0}, {"slide": 1.0}), **settings})


@pytest.mark.parametrize("transcription", ALL, ids=lambda t: f"{t.method}{t.degree}{t.second_order}{t.formulation}")
def test_least_effort_of_the_double_integrator(transcription: Transcription) -> None:
    """u = 6 - 12 t, cost 12: quadratic in the states, exact for every scheme of enough degree."""
    found = solve(sliding(transcription=transcription))
    assert found.ok
    assert found.cost == pytest.approx(12.0, abs=1e-9)
    at = found.sample(np.linspace(0, 1, 11))
    assert at.u[:, 0] == pytest.approx(6 - 12 * at.t, abs=1e-7)
    assert at.y[:, 0] == pytest.approx(3 * at.t**2 - 2 * at.t**3, abs=1e-8)


def test_shooting_with_constant_drives_has_its_own_optimum() -> None:
    """Piecewise constant drives: the discrete problem has the closed form 12 n^2 / (n^2 - 1)."""
    n = 20
    found = solve(sliding(transcription=Transcription("shooting", 1, n)))
    assert found.cost == pytest.approx(12 * n**2 / (n**2 - 1), rel=1e-8)


def test_least_time_of_the_double_integrator() -> None:
    """Full force forwards, then backwards: T = 2 sqrt(distance / force)."""
    limits = Bounds(drives={"slide": (-1.0, 1.0)})
    found = solve(sliding(**MINIMUM_TIME, bounds=limits, transcription=Transcription(intervals=30)))
    assert found.duration == pytest.approx(2.0, abs=1e-6)
    assert replay(found).end_error < 1e-8


def test_least_time_with_unequal_bounds() -> None:
    """Forwards 2 N, backwards 1 N: T^2 = 2 d (1/2 + 1), the switching at a third of the time."""
    limits = Bounds(drives={"slide": (-1.0, 2.0)})
    found = solve(sliding(**MINIMUM_TIME, bounds=limits, transcription=Transcription("radau", 3, 30)))
    assert found.duration == pytest.approx(math.sqrt(3.0), abs=1e-6)
    at = found.sample(found.duration * np.array([0.1, 0.3, 0.4, 0.9]))
    assert at.u[:, 0] == pytest.approx([2.0, 2.0, -1.0, -1.0], abs=1e-4)


def test_least_jerk_and_least_peak_of_the_double_integrator() -> None:
    """Third rate -60 t (1 - t), zero at the ends because the second is free there; its square integrates to 120."""
    found = solve(sliding(objectives=(Objective("jerk"),), transcription=Transcription("radau", 4, 10)))
    assert found.cost == pytest.approx(120.0, abs=1e-7)
    found = solve(sliding(objectives=(Objective("peak"),), transcription=Transcription(intervals=20)))
    assert found.cost == pytest.approx(4.0, rel=1e-6)  # 4 distance / duration^2


def test_bounded_rate_of_a_drive_holds_between_the_points() -> None:
    limits = Bounds(drives={"slide": (-1.0, 1.0)}, drive_rates={"slide": (-2.0, 2.0)})
    found = solve(sliding(**MINIMUM_TIME, bounds=limits, transcription=Transcription(intervals=20)))
    at = found.sample(count=2001)
    slopes = np.diff(at.u[:, 0]) / np.diff(at.t)
    full = (math.sqrt(1 + 10 / 3) - 1) / 2  # how long the force is full at either end; the ramp between takes 1 s
    assert found.ok and 0 <= found.duration - (2 * full + 1) < 2e-3
    assert np.abs(slopes).max() < 2.0 + 1e-5 and np.abs(at.u).max() < 1.0 + 1e-7


def pendulum_slope(x: list, u: ca.SX) -> ca.SX:
    """1 kg at 1 m: theta'' = u - g sin(theta)."""
    return ca.vertcat(x[1], u - 9.81 * ca.sin(x[0]))


def cart_pole_slope(x: list, u: ca.SX) -> ca.SX:
    """Kelly 2017, eqs. (6.1) and (6.2), with m1, m2, l, g of his table 3."""
    m1, m2, l, g = (KELLY[name] for name in ("cart", "pole", "length", "gravity"))
    _, angle, v, w = x
    s, c = ca.sin(angle), ca.cos(angle)
    below = m1 + m2 * (1 - c**2)
    a = (l * m2 * s * w**2 + u + m2 * g * c * s) / below
    alpha = -(l * m2 * c * s * w**2 + u * c + (m1 + m2) * g * s) / (l * below)
    return ca.vertcat(v, w, a, alpha)


def test_pendulum_against_an_independent_transcription() -> None:
    """Swing of pi/2 in 1 s with least effort; the oracle's own error is the change under doubling."""
    ends = [0.0, 0.0], [math.pi / 2, 0.0]
    known, coarser = (least_effort(pendulum_slope, *ends, 1.0, degree=n, pieces=2) for n in (20, 10))
    error = abs(known - coarser)
    assert error < 1e-7
    motion = rest_to_rest({"hinge": 0.0}, {"hinge": math.pi / 2})
    found = solve(TrajectoryProblem(pendulum(), (Gravity((0, 0, "-9.81")),), **motion, independent=("hinge",)))
    assert found.cost == pytest.approx(known, abs=1e-6 + error)


@pytest.fixture(scope="module")
def kelly() -> tuple[float, float]:
    """Cost of the cart-pole's swing-up by the oracle, and what the last steps in mesh and degree changed in it."""
    ends = [0.0, 0.0, 0.0, 0.0], [KELLY["goal"], math.pi, 0.0, 0.0]
    sizes = {"fine": (16, 12), "fewer pieces": (16, 8), "lower degree": (12, 12)}
    costs = {k: least_effort(cart_pole_slope, *ends, 2.0, degree=n, pieces=m) for k, (n, m) in sizes.items()}
    return costs["fine"], max(abs(cost - costs["fine"]) for cost in costs.values())


@pytest.mark.slow
def test_cart_pole_swing_up(kelly: tuple[float, float]) -> None:
    known, error = kelly
    assert error < 2e-6
    found = solve(cart_pole_problem(Transcription("radau", 5, 60)))
    assert found.ok
    assert found.cost == pytest.approx(known, abs=1e-6 + error)
    assert found.cost == pytest.approx(58.8076674, abs=1e-6)
    assert replay(found).end_error < 1e-6
    assert np.abs(found.sample().y[:, 0]).max() < KELLY["travel"]


def test_the_reported_error_covers_what_halving_the_mesh_changes() -> None:
    cases = {n: solve(cart_pole_problem(Transcription("radau", 3, n))) for n in (20, 40, 80)}
    for n in (20, 40):
        assert abs(cases[n].cost - cases[2 * n].cost) < cases[n].errors.cost
    assert cases[80].errors.cost < cases[20].errors.cost / 50


def test_refinement_reaches_the_asked_accuracy() -> None:
    problem = cart_pole_problem(Transcription("radau", 4, 12))
    from dataclasses import replace

    found = solve(replace(problem, accuracy=(1e-6, 1e-9)))
    assert found.ok and found.refinements > 0
    assert found.errors.drift < 1e-6
    steps = np.diff(found.mesh)
    assert steps.max() > 1.5 * steps.min()  # finer where it is needed
    assert replay(found).end_error < found.errors.drift  # as the errors on the way grow: the pole stands on its head


def test_warm_start_needs_fewer_iterations() -> None:
    problem = cart_pole_problem(Transcription("radau", 3, 40))
    cold = solve(problem)
    warm = solve(problem, warm=cold)
    assert warm.ok and warm.cost == pytest.approx(cold.cost, rel=1e-9)
    assert warm.statistics.iterations < cold.statistics.iterations / 2


def test_another_solver_by_name() -> None:
    settings = Solver(
        "sqpmethod", options={"qpsol": "qrqp", "qpsol_options": {"print_iter": False, "print_header": False}}
    )
    found = solve(sliding(transcription=Transcription(intervals=5), solver=settings))
    assert found.ok and found.cost == pytest.approx(12.0, abs=1e-6)


def gradient_error(found: Trajectory) -> float:
    """Largest difference of the assembled derivatives and central differences of the program itself."""
    from symscrew.optimisation.sparse import assemble

    t = found.transcribed
    program = assemble(t.families, t.linear, t.cost, 1.0)
    value = ca.Function("value", [program.x], [program.f, program.g])
    random = np.random.default_rng(3)
    x = found.x + 1e-3 * random.standard_normal(len(found.x))
    lam = random.standard_normal(len(program.labels))
    way, h = random.standard_normal(len(x)), 1e-5

    def lagrangian_slope(at: np.ndarray) -> np.ndarray:
        slope = np.array(program.gradient(at, [])[1]).ravel()
        return slope + np.array(program.jacobian(at, [])[1].T @ lam).ravel()

    up, down = (value(x + s * h * way) for s in (1, -1))
    along = (float(up[0]) - float(down[0])) / (2 * h), np.array(up[1] - down[1]).ravel() / (2 * h)
    exact = (
        float(np.array(program.gradient(x, [])[1]).ravel() @ way),
        np.array(program.jacobian(x, [])[1] @ way).ravel(),
    )
    upper = np.array(program.hessian(x, [], 1.0, lam))
    full = upper + upper.T - np.diag(np.diag(upper))
    second = (lagrangian_slope(x + h * way) - lagrangian_slope(x - h * way)) / (2 * h)
    pairs = [(along[0], exact[0]), (along[1], exact[1]), (second, full @ way)]
    return max(float(np.abs(np.subtract(a, b)).max() / (1 + np.abs(b).max())) for a, b in pairs)


@pytest.mark.parametrize("method", [("radau", 2), ("gauss", 3), ("shooting", 1)])
def test_derivatives_of_the_program_are_exact(method: tuple[str, int]) -> None:
    problem = cart_pole_problem(Transcription(*method, 6))
    assert gradient_error(solve(problem)) < 1e-7


def test_study_of_transcriptions_falls_with_the_mesh() -> None:
    from symscrew.studies.accuracy.transcription_study import study

    motion = rest_to_rest({"hinge": 0.0}, {"hinge": math.pi / 2})
    found = study(TrajectoryProblem(pendulum(), **motion, independent=("hinge",)), meshes=(4, 8))
    assert found.reference_error < 1e-7 and not found.left_out
    errors = {(p.scheme, p.intervals): p.error for p in found.points}
    assert len(errors) == 18
    for scheme in ("Radau 2, second order", "Radau 3, second order", "shooting"):
        assert errors[scheme, 8] < errors[scheme, 4] / 3
    assert "| Radau 5, second order" in found.markdown()
