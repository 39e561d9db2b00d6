"""What is called optimal is a valley of the cost: summits and saddles on which a solver starts, tolerances too wide."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
from support.optimal_problems import pendulum, slider

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.errors import DescriptionError
from symscrew.optimisation import (
    Bounds,
    Conditions,
    JoinedProblem,
    Objective,
    Solver,
    TrajectoryProblem,
    Transcription,
    optimisation_problem,
    solve,
    solve_joined,
)
from symscrew.optimisation.optimality import SLOPE, looked_at
from symscrew.optimisation.sparse import NonlinearProgram
from symscrew.optimisation.unknowns import Unknowns

REST = Conditions(coordinates={"slide": 0.0}, at_rest=True)
FORCE = 100.0


def away(expression: str, **settings: object) -> TrajectoryProblem:
    """1 kg on a slide, at rest at 0 at both ends of a second, within 1 m and 100 N."""
    usual = {
        "effects": (), "start": REST, "end": REST, "transcription": Transcription(intervals=10),
        "bounds": Bounds(joints={"slide": (-1.0, 1.0)}, drives={"slide": (-FORCE, FORCE)}),
        "objectives": (Objective("expression", expression=expression),), "accuracy": None,
    }  # fmt: skip
    return TrajectoryProblem(slider(), **{**usual, **settings})  # type: ignore[arg-type]


def farthest() -> float:
    """Integral of q^2 of the motion by hand: to 1 m by full force forwards and back in 0.2 s, and home again."""
    half = 0.1  # [s] for half a metre at 100 m/s^2
    out = 50**2 * half**5 / 5 + (half - 2 * 50 * half**3 / 3 + 50**2 * half**5 / 5)
    return 1.0 - 4 * half + 2 * out


@pytest.mark.parametrize("cost", ["-q_slide^2", "q_slide^4 - 2*q_slide^2"])
def test_a_summit_of_the_cost_is_left_for_the_motion_by_hand(cost: str) -> None:
    """Staying is where the costs have no slope, and is the worst of all motions; full force is best for both."""
    found = solve(away(cost))
    assert found.ok, found.status
    assert found.cost < -0.7
    if cost == "-q_slide^2":
        assert found.cost == pytest.approx(-farthest(), abs=1e-4)  # switches fall on ends of the intervals


def test_problems_that_are_built_once_and_joined_ones_look_as_well() -> None:
    problem = away("-q_slide^2", accuracy=(1e-4, 1e-6))
    built = optimisation_problem(problem).solve(judge=True)
    assert built.solved and built.ok is False and "costs" in built.status and "less" in built.status
    plan = solve_joined(JoinedProblem((problem, problem), (None,)))
    assert plan.ok and plan.cost < -2 * 0.7


def test_a_motion_on_a_slope_is_not_called_optimal() -> None:
    wide = {f"{name}tol": 1e10 for name in ("", "dual_inf_", "compl_inf_", "constr_viol_")}
    problem = TrajectoryProblem(
        pendulum(), start=Conditions({"hinge": 0.0}, at_rest=True), end=Conditions({"hinge": 1.0}, at_rest=True),
        bounds=Bounds(drives={"hinge": (-30.0, 30.0)}), transcription=Transcription(intervals=20), accuracy=None,
    )  # fmt: skip
    right = solve(problem)
    loose = solve(replace(problem, solver=Solver(options=wide)))
    assert right.ok and right.look is not None and right.look.slope < 1e-6
    assert loose.solved and not loose.ok and "slope" in loose.status and loose.cost > 1.2 * right.cost


# -- the look by itself, against eigenvalues in a basis of what constraints leave free ------------------------------


def quadratic(seed: int, *, indefinite: bool) -> tuple[NonlinearProgram, Unknowns, np.ndarray]:
    """f = x H x / 2 with equations A x = 0 and bounds, at 0: a valley or a saddle along what A leaves free."""
    random = np.random.default_rng(seed)
    n, m = int(random.integers(4, 12)), int(random.integers(1, 4))
    rows = random.standard_normal((m, n))
    basis = np.linalg.svd(rows)[2][m:].T
    values = random.uniform(0.5, 2.0, n - m)
    values[0] *= -1.0 if indefinite else 1.0
    off = random.standard_normal((n, m))  # across the constraints anything, downwards too
    turn = np.linalg.qr(random.standard_normal((n - m, n - m)))[0]
    free = basis @ turn @ np.diag(values) @ turn.T @ basis.T
    hessian = free - rows.T @ rows + (off @ rows + rows.T @ off.T)
    x, p, sigma, lam = (ca.MX.sym(*shape) for shape in (("x", n), ("p", 0), ("s",), ("l", m)))
    f, g = ca.bilin(ca.DM(hessian), x, x) / 2, ca.mtimes(ca.DM(rows), x)
    upper = ca.DM(np.triu(hessian))
    program = NonlinearProgram(
        x, p, f, g, ca.Function("gradient", [x, p], [f, ca.gradient(f, x)]), ca.Function("jacobian", [x, p], [g, rows]),
        ca.Function("hessian", [x, p, sigma, lam], [sigma * ca.sparsify(upper)]), np.zeros(m), np.zeros(m),
        ("row",) * m, np.zeros(m),
    )  # fmt: skip
    unknowns = Unknowns()
    unknowns.add("x", np.array([0.0]), [f"x{k}" for k in range(n)], np.ones(n))
    unknowns.bound(np.arange(n), -10.0, 10.0)
    return program, unknowns, rows


@pytest.mark.parametrize("seed", range(12))
def test_saddles_are_told_from_valleys_as_by_eigenvalues(seed: int) -> None:
    for indefinite in (False, True):
        program, unknowns, rows = quadratic(seed, indefinite=indefinite)
        n, m = unknowns.size, len(rows)
        look = looked_at(program, unknowns, (np.zeros(n), np.zeros(m), np.zeros(n)))
        assert look.level and look.curved
        assert (look.better is not None) == indefinite
        if look.better is not None:
            assert np.abs(rows @ look.better).max() < 1e-6  # on the constraints
            assert look.gain > 0 and float(program.gradient(look.better, [])[0]) == pytest.approx(-look.gain)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_curvature_that_is_not_finite_is_not_judged(bad: float) -> None:
    program, unknowns, rows = quadratic(1, indefinite=False)
    x, p, sigma, lam = (ca.MX.sym(*shape) for shape in (("x", unknowns.size), ("p", 0), ("s",), ("l", len(rows))))
    upper = np.triu(np.ones((unknowns.size, unknowns.size)))
    upper[0, 0] = bad
    program = replace(program, hessian=ca.Function("hessian", [x, p, sigma, lam], [ca.sparsify(ca.DM(upper))]))
    look = looked_at(program, unknowns, (np.zeros(unknowns.size), np.zeros(len(rows)), np.zeros(unknowns.size)))
    assert look.level and not look.curved and look.better is None


@pytest.mark.parametrize(("slope", "level"), [(0.9 * SLOPE, True), (1.1 * SLOPE, False)])
def test_slopes_on_both_sides_of_the_threshold(slope: float, level: bool) -> None:
    program, unknowns, rows = quadratic(1, indefinite=False)
    pressure = np.zeros(unknowns.size)
    pressure[0] = slope
    look = looked_at(program, unknowns, (np.zeros(unknowns.size), np.zeros(len(rows)), pressure))
    assert look.level == level and look.slope == pytest.approx(slope)


# -- values of parameters ------------------------------------------------------------------------------------------


def weighed(text: str = "m") -> Mechanism:
    made = MechanismBuilder("weighed").parameter("m", 1, "kg").parameter("l", 1, "m")
    made.body("mass", mass=text, com=[0, 0, "-l"])
    made.joint("hinge", "R", parent="base", child="mass", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    return made.point("tip", body="mass", at=[0, 0, "-2*l"]).build()


SWING = {"start": Conditions({"hinge": 0.0}, at_rest=True), "end": Conditions({"hinge": 0.5}, at_rest=True)}


@pytest.mark.parametrize("text", ["m", "m - 3/10", "2*m*m - 1"])
def test_bodies_have_masses_that_bodies_can_have(text: str) -> None:
    """A mass of -2 kg was called optimal."""
    mechanism, mesh = weighed(text), Transcription(intervals=4)
    with pytest.raises(DescriptionError, match=r"bodies\.mass\.mass: expected a mass of at least 0"):
        solve(TrajectoryProblem(mechanism, **SWING, parameters={"m": -0.5}, transcription=mesh))
    with pytest.raises(DescriptionError, match=r"design\.m: the range reaches -0\.5: bodies\.mass\.mass"):
        solve(TrajectoryProblem(mechanism, **SWING, design={"m": (-0.5, 2.0)}, transcription=mesh))
    built = optimisation_problem(TrajectoryProblem(mechanism, **SWING, parameters={"m": 1.5}, transcription=mesh))
    assert built.solve(parameters={"m": 1.2}).solved
    with pytest.raises(DescriptionError, match="expected a mass of at least 0"):
        built.solve(parameters={"m": -0.5})


@pytest.mark.parametrize("size", [1e-3, 3.0, 1e3])
def test_another_size_is_derived_for_what_it_is(size: float) -> None:
    """What lengths are divided by is that of the values; moments of a mass go with the square of its arm."""
    problem = TrajectoryProblem(
        weighed(), (), **SWING, parameters={"l": size}, transcription=Transcription(intervals=8), accuracy=None
    )
    found, usual = solve(problem), solve(replace(problem, parameters={"l": 1.0}))
    derived = size if not 0.25 <= size <= 4 else 1.0
    assert found.ok and found.model.system.length == pytest.approx(derived * usual.model.system.length)
    assert found.cost == pytest.approx(usual.cost * size**4, rel=1e-5, abs=0)


@pytest.mark.parametrize("low", [0.5, 0.7, 1 / 3])
@pytest.mark.parametrize("kind", ["effort", "time"])
def test_designs_and_durations_are_within_their_ranges(low: float, kind: str) -> None:
    """Not 8e-9 outside: the lightest mass takes least effort, the shortest way the least time."""
    lengths = {"duration": (low, 3.0)} if kind == "time" else {"duration": 1.0}
    found = solve(TrajectoryProblem(
        weighed(), **SWING, **lengths, objectives=(Objective(kind),), design={"m": (low, 2.0)}, accuracy=None,
        transcription=Transcription(intervals=4),
    ))  # fmt: skip
    value, end = (found.duration, low) if kind == "time" else (found.parameters["m"], low)
    assert found.ok and end <= value <= end + 1e-6
    assert low <= found.parameters["m"] <= 2.0
