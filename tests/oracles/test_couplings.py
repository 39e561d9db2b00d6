"""Couplings of coordinates: textbook gears, method B, mobility, derivatives, and what is refused."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from support.model_states import model
from support.optimal_problems import rest_to_rest

from oracles.pseudospectral import least_effort
from symscrew import catalogue
from symscrew.description import MechanismBuilder, parse_description, to_toml
from symscrew.effects import Gravity
from symscrew.errors import DescriptionError
from symscrew.formats import difference, load_format, save_as, text_of
from symscrew.mobility import analyse_mobility
from symscrew.model import derive
from symscrew.optimisation.problem import TrajectoryProblem, Transcription
from symscrew.optimisation.solution import solve
from symscrew.program import RankRevealing
from symscrew.reference import newton_euler, numeric

EXACT = 1e-11


def shafts(coupling: dict[str, object], *more: dict[str, object]) -> MechanismBuilder:
    """Two shafts about z, the first driven, and an arm on the second."""
    builder = MechanismBuilder("shafts")
    builder.body("a", mass=1, com=[0, 0, 0], inertia=["0.02", "0.02", "0.03"])
    builder.body("b", mass=2, com=["0.5", "0.1", 0], inertia=["0.01", "0.04", "0.05"])
    builder.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True, reference=["0.2"])
    builder.joint("B", "R", parent="base", child="b", point=["0.4", 0, 0], axes=[[0, 1, 0]], reference=["0.3"])
    for k, terms in enumerate((coupling, *more)):
        builder.coupling(f"tie_{k}", terms=terms)
    return builder


def test_gears_by_hand() -> None:
    """12 to 1 in two stages: the motor sees its inertia, the layshaft's / 16, the arm's / 144, and the weight / 12."""
    found, rng = model("gear_train"), np.random.default_rng(3)
    q1, v1, a1 = rng.normal(size=3)
    ratio = np.array([1, -1 / 4, 1 / 12])
    q, v, a = ratio * q1, ratio * v1, ratio * a1
    weight = -0.6 * 9.81 * 0.2 * np.cos(q[2])  # about y: the arm's centre is 0.2 m from its axis along x
    inertia = 1 / 600_000 + 1 / 20_000 / 16 + (9e-3 + 0.6 * 0.2**2) / 144
    u = found("inverse_dynamics", q, v, a)[0][0][0]
    assert u == pytest.approx(inertia * a1 + weight / 12, rel=EXACT, abs=1e-14)
    first, second = found("coupling_forces", q, v, a)[0][0]
    assert first == pytest.approx(a1 / 600_000 - u, rel=EXACT)  # what the teeth exert on the motor, as on `input`
    arm = (9e-3 + 0.6 * 0.2**2) * a[2] + weight
    assert second * 45 / 15 == pytest.approx(arm, rel=EXACT)
    assert analyse_mobility(found.mechanism).dof == 1


@pytest.mark.parametrize("seed", range(3))
def test_gears_alone_have_no_second_path(seed: int) -> None:
    """Pivots that are numbers are never small: C of a way that nobody takes would be a warning of compilers."""
    teeth = [int(n) for n in np.random.default_rng(seed).integers(11, 90, 2)]
    found = derive(shafts({"A": f"{teeth[0]}/{teeth[1]}", "B": 1}).build())
    seconds = [p for p in (*found.programs.values(), *model("gear_train").programs.values()) if hasattr(p, "dense")]
    assert "forward_dynamics" in found.programs and not seconds
    with_loop = model("four_bar").programs["forward_dynamics"]
    assert isinstance(with_loop, RankRevealing) and with_loop.guards


def test_differential_turns_or_swings() -> None:
    found = model("differential")
    for rates, carrier, tool in (((1, 1), 1, 0), ((1, -1), 0, 1.5)):
        v = found("velocity", np.zeros(4), np.array(rates, dtype=float))[0][0]
        assert v == pytest.approx([*rates, carrier, tool], abs=1e-14)
    mobility = analyse_mobility(found.mechanism)
    assert (mobility.dof, mobility.dof_drives_locked, mobility.finite.proved) == (2, 0, True)


@pytest.mark.parametrize("terms", [{"A": 1, "B": ["0.5", "0.3", "-0.2"]}, {"A": ["1", "0.1"], "B": "0.7"}])
def test_polynomials_obey_the_equations_of_motion(terms: dict[str, object]) -> None:
    """M a + h = J^T m + u, drives equal to method B's, derivatives to differences, forward and inverse dynamics."""
    found = derive(shafts(terms).build(), derivatives=True)
    q, v, a = found.system.states(4, 11)
    (u,), (m,) = found("inverse_dynamics", q, v, a)[0], found("coupling_forces", q, v, a)[0]
    mass = found("mass_matrix", q)[0][0].reshape(-1, 2, 2)
    row = found("closure_jacobian", q)[0][0].reshape(-1, 2)
    need = np.einsum("kij,kj->ki", mass, a) + found("bias", q, v)[0][0] - row * m
    assert np.abs(need - np.stack([u[:, 0], 0 * u[:, 0]], axis=1)).max() < EXACT
    assert np.abs(found("forward_dynamics", q, v, u)[0][0] - a).max() < 1e-9
    assert np.abs(found("closure", q)[0][0]).max() < EXACT
    step, y = 1e-6, q[:, :1]

    def at(shift: float) -> np.ndarray:
        moved = found("assemble", y + shift, q)[0][0]
        return found("inverse_dynamics_independent", moved, v[:, :1], a[:, :1])[0][0]

    difference = (at(step) - at(-step)) / (2 * step)
    derivative = found("inverse_dynamics_independent_derivatives", q, v[:, :1], a[:, :1])[0][0]
    assert np.abs(derivative.reshape(difference.shape) - difference).max() < 1e-7


def test_least_effort_through_gears() -> None:
    """A constant inertia seen by the motor, J: the integral of u^2 is 12 J^2 way^2 / time^3, u = J way (6 - 12 t)."""
    inertia = 1 / 600_000 + 1 / 20_000 / 16 + (9e-3 + 0.6 * 0.2**2) / 144
    motion = rest_to_rest({"input": 0.0}, {"input": 6.0})
    found = solve(
        TrajectoryProblem(catalogue.load("gear_train"), (), **motion, transcription=Transcription(intervals=4))
    )
    assert found.ok and found.cost == pytest.approx(12 * (inertia * 6) ** 2, rel=1e-9)
    at = found.sample(np.array([0.0, 0.3, 1.0]))
    assert at.u[:, 0] == pytest.approx(inertia * 6 * (6 - 12 * at.t), abs=1e-9 * inertia)
    turned = dict(zip((c.label for c in model("gear_train").system.tree.q), at.q[-1], strict=True))
    assert turned == pytest.approx({"input": 6.0, "middle": -1.5, "output": 0.5}, abs=1e-9)


@pytest.mark.slow
def test_least_effort_along_a_polynomial() -> None:
    """A bead on the parabola z = x^2 / 2 under gravity, a drive along x: against a transcription of its own."""

    def slope(x: list[ca.SX], u: ca.SX) -> ca.SX:
        return ca.vertcat(x[1], (u - x[0] * x[1] ** 2 - 9.81 * x[0]) / (1 + x[0] ** 2))

    ends = [-0.5, 0.0], [1.0, 0.0]
    known, coarser = (least_effort(slope, *ends, 1.0, degree=n, pieces=2) for n in (20, 16))
    builder = MechanismBuilder("wire")
    builder.body("carriage")
    builder.body("bead", mass=1, com=[0, 0, 0])
    builder.joint("x", "P", parent="base", child="carriage", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    builder.joint("z", "P", parent="carriage", child="bead", point=[0, 0, 0], axes=[[0, 0, 1]])
    builder.coupling("wire", terms={"z": 1, "x": [0, "-1/2"]})
    motion = rest_to_rest({"x": -0.5}, {"x": 1.0})
    found = solve(TrajectoryProblem(builder.build(), (Gravity((0, 0, "-9.81")),), **motion))
    assert abs(known - coarser) < 1e-7
    assert found.ok and found.cost == pytest.approx(known, abs=1e-6)
    at = found.sample(np.linspace(0, 1, 7))
    assert np.abs(at.q[:, 1] - at.q[:, 0] ** 2 / 2).max() < 1e-9


def test_method_b_knows_couplings() -> None:
    """A state that a coupling explains leaves nothing unbalanced, and one more drive would: with polynomials, too."""
    from support.model_states import body_states

    found = derive(shafts({"A": 1, "B": ["0.5", "0.3"]}).build())
    q, v, a = found.system.states(3, 5)
    expected = newton_euler(numeric(found.mechanism), body_states(found, q, v, a))
    assert expected.residual.max() < EXACT
    assert np.abs(found("inverse_dynamics", q, v, a)[0][0] - expected.drives).max() < EXACT


def test_a_coupling_twice_is_redundant() -> None:
    once, twice = ({"A": 1, "B": "0.5"}, {"A": 2, "B": 1})
    mobility = analyse_mobility(shafts(once, twice).build())
    assert (mobility.dof, mobility.overconstraints, mobility.finite.dof) == (1, 1, 1)
    still = analyse_mobility(shafts(once, {"A": 1, "B": "0.6"}).build())
    assert (still.dof, still.overconstraints) == (0, 0)
    found = derive(shafts(once, twice).build())
    q, v, a = found.system.states(2, 1)
    plain = derive(shafts(once).build())
    assert np.abs(found("inverse_dynamics", q, v, a)[0][0] - plain("inverse_dynamics", q, v, a)[0][0]).max() < EXACT


def test_units_and_order_do_not_matter() -> None:
    """A rack: the same in millimetres' factor, and with its terms in another order."""

    def rack(terms: dict[str, object]) -> MechanismBuilder:
        builder = MechanismBuilder("rack").body("pinion", mass=1, com=[0, 0, 0], inertia=[1, 1, 2])
        builder.body("bar", mass=3, com=[0, 0, 0]).joint(
            "turn", "R", parent="base", child="pinion", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True
        )
        builder.joint("slide", "P", parent="base", child="bar", point=[0, "0.1", 0], axes=[[1, 0, 0]])
        return builder.coupling("teeth", terms=terms)

    values = []
    for terms in ({"slide": 1, "turn": "-0.05"}, {"slide": 1000, "turn": -50}, {"turn": -50, "slide": 1000}):
        found = derive(rack(terms).build())
        v, a = np.array([2.0, 0.1]), np.array([4.0, 0.2])
        values.append(found("inverse_dynamics", np.zeros(2), v, a)[0][0][0])
    assert values == pytest.approx([4 * (2 + 3 * 0.05**2)] * 3, rel=EXACT)


def test_text_and_back() -> None:
    for name in ("gear_train", "differential"):
        assert parse_description(to_toml(catalogue.load(name))) == catalogue.load(name)
    bent = shafts({"A": ["1", "0.25"], "B": "-2"}).build()
    assert parse_description(to_toml(bent)) == bent


def test_files_keep_couplings(tmp_path: Path) -> None:
    """A URDF what it can hold, a joint that mimics one other, MJCF also polynomials and sums; the rest is refused."""
    bent = {"A": 1, "B": ["0.5", "0.3", "-0.2"]}
    for suffix, written in ((".urdf", catalogue.load("gear_train")), (".xml", shafts(bent).build())):
        path = tmp_path / f"model{suffix}"
        save_as(written, path)
        assert difference(written, load_format(path)) is None
        without = dataclasses.replace(load_format(path), couplings={})
        assert "coupling" in str(difference(written, without))
    for terms in ({"A": ["1", "0.2"], "B": ["1", "0.1"]}, {"A": 1, "B": [0, 0, 0, 0, 0, 1]}):
        with pytest.raises(DescriptionError, match="MJCF holds sums of joints"):
            text_of(shafts(terms).build(), ".xml")
    with pytest.raises(DescriptionError, match="joints that mimic one other joint"):
        text_of(catalogue.load("differential"), ".urdf")


@pytest.mark.parametrize(
    ("terms", "message"),
    [
        ({}, "expected coordinates with their factors"),
        ({"a": 1}, "there is no coordinate 'a'; known: A, B"),
        ({"A": 0}, "the factor of 'A' is 0"),
        ({"A": [1] * 9}, "expected 1 to 8 coefficients of A, got 9"),
        ({"A": "x"}, "unknown name"),
        ({"B": ["-0.6", 1]}, "all its slopes are 0"),
    ],
)
def test_what_is_no_coupling_is_refused(terms: dict[str, object], message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        shafts(terms).build()
