"""Thresholds and sizes by which finite motions are decided: what comes out on either side of each."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support.reference_mechanisms import ENTRIES, build

from symscrew import catalogue
from symscrew.algebra import CONTEXT
from symscrew.mobility.finite import (
    branches,
    closure_residual,
    finite_motion,
    local_solutions,
    passive_spins,
    quadric_cone,
    reduced_closure,
    tangent_cone,
    witnesses,
)
from symscrew.mobility.finite.branches import UndecidedError, find_branches
from symscrew.mobility.finite.finite_motion import finite_mobility
from symscrew.mobility.finite.reduced_closure import ReducedClosure, Values, is_zero
from symscrew.mobility.finite.variety import DIGITS_60, ClosureVariety
from symscrew.mobility.finite.witnesses import Witness, recheck
from symscrew.mobility.joint_network import Network, network_of
from symscrew.mobility.screw_systems import null_space

pytestmark = pytest.mark.slow

CHANGE_POINT = "parallelogram-change_point"


@cache
def network(name: str) -> Network:
    return network_of(build(ENTRIES[name]) if name in ENTRIES else catalogue.load(name))


def local(name: str) -> tuple[ClosureVariety, ClosureVariety, local_solutions.Local]:
    coarse, fine = ClosureVariety(network(name)), ClosureVariety(network(name), DIGITS_60)
    motions = null_space(network(name).loop_rows(), network(name).freedoms).basis
    return coarse, fine, local_solutions.local_at(coarse, np.zeros(coarse.columns), motions=motions)


# -- one configuration -----------------------------------------------------------------------------------


def test_a_motion_that_could_not_be_solved_is_not_taken_for_one_that_stops(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bennett's linkage moves; where no step can be solved nothing is known, which is said."""
    assert finite_mobility(network("bennett")).dof == 1
    monkeypatch.setattr(local_solutions, "CONVERGED", 0.0)
    monkeypatch.setattr(local_solutions, "RESIDUAL", 0.0)
    found = finite_mobility(network("bennett"))
    assert (found.dof, found.kind, found.proved) == (None, "undecided", False)
    assert "could not be solved for the dependent coordinates, down to a size of 0.0002" in found.evidence[0]


@pytest.mark.parametrize(
    "values, rank",
    [([1, 2e-5, 1e-9], 2), ([1, 5e-8, 1e-9], 1), ([1, 1e-6, 9e-7, 1e-8], 1), ([1, 1e-6, 1e-14], 2)],
    ids=["above both limits", "below both", "between, no gap below it", "between, a gap below it"],
)
def test_ranks_between_the_limits_of_doubt_are_decided_by_the_gap(values: list[float], rank: int) -> None:
    assert local_solutions._rank(np.array(values)) == rank


def test_singular_values_of_rounding_are_not_distinct(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse, _, here = local("bennett")
    assert int(local_solutions.coarse_rank(coarse, here.q)) == here.rank == 3
    monkeypatch.setattr(local_solutions, "DISTINCT", 0.0)
    assert int(local_solutions.coarse_rank(coarse, here.q)) > 3


def test_definite_forms_are_found_within_their_rounds(monkeypatch: pytest.MonkeyPatch) -> None:
    forms = np.array([np.diag([1.0, -0.2]), np.diag([-0.2, 1.0])])
    weights = local_solutions.definite_stress(forms)
    assert weights is not None and np.linalg.eigvalsh(np.tensordot(weights, forms, axes=1)).min() > 0
    assert local_solutions.definite_stress(np.array([np.diag([1.0, -1.0])])) is None
    for name, value in (("DEFINITE", 10.0), ("ROUNDS", 0)):
        with monkeypatch.context() as changed:
            changed.setattr(local_solutions, name, value)
            assert local_solutions.definite_stress(forms) is None


def test_a_motion_without_gain_ends_the_search_for_a_definite_form(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both forms vanish on the third motion but for 1e-12, so none is definite: ended at once, or after all rounds."""
    forms = np.array([np.diag([1.0, 0.5, -1e-12]), np.diag([0.5, 1.0, -1e-12])])
    rounds: list[int] = []
    original = np.linalg.eigh
    monkeypatch.setattr(np.linalg, "eigh", lambda a: rounds.append(1) or original(a))
    assert local_solutions.definite_stress(forms) is None and len(rounds) < 5
    rounds.clear()
    monkeypatch.setattr(local_solutions, "NO_GAIN", 1e-15)
    assert local_solutions.definite_stress(forms) is None and len(rounds) == local_solutions.ROUNDS


def test_rounding_of_quadratic_forms_is_zero(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse, _, here = local("kinematotropic_double_fold-transition")
    forms = local_solutions.quadratic_forms(coarse, here)
    small = np.abs(forms)[forms != 0].min()
    assert small > 1e-4 and (forms == 0).any()
    monkeypatch.setattr(local_solutions, "ROUNDING", -1.0)
    rounded = local_solutions.quadratic_forms(coarse, here)
    assert 0 < np.abs(rounded[forms == 0]).max() < 1e-13
    monkeypatch.setattr(local_solutions, "ROUNDING", 2.0)
    assert not local_solutions.quadratic_forms(coarse, here).any()


def test_refinement_reaches_sixty_digits(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse, fine, here = local("bennett")
    near = here.q + 0.01 * here.kernel[:, 0]
    near = local_solutions.solve_dependent(coarse, here, near)
    assert near is not None and local_solutions.refine(coarse, fine, near, 3)[1] < local_solutions.EXACT
    monkeypatch.setattr(local_solutions, "REFINEMENTS", 1)
    assert local_solutions.EXACT < local_solutions.refine(coarse, fine, near, 3)[1] < 1e-12
    monkeypatch.setattr(local_solutions, "CONVERGED", 0.0)
    monkeypatch.setattr(local_solutions, "RESIDUAL", 0.0)
    assert local_solutions.solve_dependent(coarse, here, here.q + 0.01 * here.kernel[:, 0]) is None


def test_a_pivot_that_is_rounding_proves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The shaky three-bar: its one self-stress does the same sign of work on its one motion."""
    name = "threebar_parallel_unequal"
    coarse, _, here = local(name)
    motions = null_space(network(name).loop_rows(), network(name).freedoms).basis
    forms = local_solutions.quadratic_forms(coarse, here)
    weights = local_solutions.definite_stress(forms)
    assert weights is not None
    stress = finite_motion._about_origin(coarse, weights @ here.stresses)
    assert local_solutions.proved_definite(network(name), motions, stress) > 0.1
    monkeypatch.setattr(local_solutions, "POSITIVE", 2)
    assert local_solutions.proved_definite(network(name), motions, stress) is None


def test_a_form_that_is_zero_is_not_definite() -> None:
    """Forces across the plane do no work on motions in it, whatever doubles leave of it."""
    motions = null_space(network("parallelogram").loop_rows(), network("parallelogram").freedoms).basis
    across = np.array([0, 0, 0, 0, 0, 1.0])
    assert local_solutions.proved_definite(network("parallelogram"), motions, across) is None


# -- series ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name, value, stops",
    [("NO_WORK", 1e9, {"collinear_3R": None}), ("STEPS", 0, {"bennett": 3}), ("SOLVED", 1.0, {"bennett": 3})],
)
def test_thresholds_of_the_series(
    monkeypatch: pytest.MonkeyPatch, name: str, value: float, stops: dict[str, int | None]
) -> None:
    """Three revolute joints in a line stop at second order, Bennett's linkage never."""

    def order(mechanism: str) -> int | None:
        motions = null_space(network(mechanism).loop_rows(), network(mechanism).freedoms).basis
        return tangent_cone.continued(network(mechanism), motions[0], 4).order

    assert [order("collinear_3R"), order("bennett")] == [2, None]
    monkeypatch.setattr(tangent_cone, name, value)
    for mechanism, expected in stops.items():
        found = order(mechanism)
        assert found is None if expected is None else found is not None and found <= expected


def test_singular_values_that_are_cut_off_do_not_help_the_series(monkeypatch: pytest.MonkeyPatch) -> None:
    motions = null_space(network("bennett").loop_rows(), network("bennett").freedoms).basis
    monkeypatch.setattr(tangent_cone, "CUT_OFF", 0.9)  # all but the largest
    assert tangent_cone.continued(network("bennett"), motions[0], 4).order is not None


def test_without_orders_the_finite_displacement_decides(monkeypatch: pytest.MonkeyPatch) -> None:
    assert "at order 2 of the kinematic tangent cone" in finite_mobility(network("collinear_3R")).evidence[0]
    monkeypatch.setattr(finite_motion, "ORDERS", 1)
    found = finite_mobility(network("collinear_3R"))
    assert found.branches == () and "an analytic function of one variable" in found.evidence[0]


def test_fixed_point_integers_hold_sixty_digits(monkeypatch: pytest.MonkeyPatch) -> None:
    fine = ClosureVariety(network("bennett"), DIGITS_60)
    q = np.array([CONTEXT.mpf(k + 1) / 7 for k in range(fine.columns)], dtype=object)

    def error() -> float:
        return float(max(abs(a - b) for a, b in zip(fine.residual(q), fine.evaluate(q[None])[0][0], strict=True)))

    assert error() < 1e-56
    one = 1 << 64
    monkeypatch.setattr(closure_residual, "BITS", 64)
    monkeypatch.setattr(closure_residual, "ONE", one)
    monkeypatch.setattr(closure_residual, "IDENTITY", [[one, 0, 0], [0, one, 0], [0, 0, one]])
    fine = ClosureVariety(network("bennett"), DIGITS_60)
    assert 1e-24 < error() < 1e-15


# -- zeros of the reduced closure -------------------------------------------------------------------------


def values(g: float, u: float) -> Values:
    one = np.ones((1, 1))
    return Values(one * u, one, one * g, one[None], one[None], np.array([True]))


@pytest.mark.parametrize(
    "g, u, zero",
    [(3e-16, 0.1, True), (6e-16, 0.1, False), (0.0, 0.1 * (1 + 5e-7), True), (0.0, 0.1 * (1 + 2e-6), False)],
    ids=["rounding", "not rounding", "on the sphere", "off the sphere"],
)
def test_what_counts_as_a_zero_on_a_sphere(g: float, u: float, zero: bool) -> None:
    assert len(is_zero(values(g, u), 0.1, 1e-8)) == zero


@pytest.mark.parametrize("name, value", [("STEPS", 0), ("SOLVES", 1), ("SOLVED", 0.0), ("DAMPING", 0.0)])
def test_zeros_on_a_sphere_need_their_steps(monkeypatch: pytest.MonkeyPatch, name: str, value: float) -> None:
    coarse, _, here = local(CHANGE_POINT)
    starts = np.array(list(local_solutions.flatten(here.dof, 12)))

    def found() -> int:
        reduced = ReducedClosure(coarse, here)
        return len(is_zero(reduced.zeros_on_sphere(0.1 * starts, 0.1, 1e-3), 0.1, 1e-3))

    assert found() >= 6
    monkeypatch.setattr(reduced_closure, name, value)
    assert found() == 0


# -- branches --------------------------------------------------------------------------------------------


def through_the_change_point() -> branches.Branches:
    coarse, fine, here = local(CHANGE_POINT)
    return find_branches(coarse, fine, here, local_solutions.quadratic_forms(coarse, here))


def test_branches_through_a_change_point() -> None:
    found = through_the_change_point()
    assert found.dimensions == (1,) and len(found.evidence) == 3
    assert "radius 0.1 " in found.evidence[0] and "radius 0.02 " in found.evidence[1]


def test_a_sphere_on_which_double_precision_sees_nothing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse, _, here = local(CHANGE_POINT)
    starts = np.array(list(local_solutions.flatten(here.dof, 12)))
    sizes = [branches._scale(ReducedClosure(coarse, here), starts, radius) for radius in branches.RADII]
    assert sizes[0] > 5 * sizes[1]
    monkeypatch.setattr(branches, "SIGNAL", 2 * sizes[1])
    found = through_the_change_point()
    assert found.dimensions == (1,)
    assert any("no zeros were looked for on a sphere of radius 0.02" in text for text in found.evidence)
    monkeypatch.setattr(branches, "SIGNAL", 1.0)
    with pytest.raises(UndecidedError, match="too small on all spheres"):
        through_the_change_point()


def test_a_zero_that_was_not_classified_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    real = branches._dimensions
    lost = branches.BranchPoint(branches.UNDECIDED, 2, np.zeros(1), "a zero on it could not be classified")
    kind = (branches.UNDECIDED, True)

    def with_one_lost(*given: object, **named: object) -> dict[tuple[int, bool], branches.BranchPoint]:
        return {**real(*given, **named), kind: lost}  # type: ignore[arg-type]

    monkeypatch.setattr(branches, "_dimensions", with_one_lost)
    found = through_the_change_point()
    assert found.dimensions == (1,)
    assert "another zero could not be classified: a branch of a further dimension is not excluded" in found.evidence
    monkeypatch.setattr(branches, "_dimensions", lambda *given, **named: {kind: lost})
    with pytest.raises(UndecidedError, match="dimension cannot be told"):
        through_the_change_point()


@pytest.mark.parametrize(
    "name, value, text",
    [("INWARDS", 0, "followed down to 1.0e-01"), ("KEPT", 1, "1 kept for their variety"),
     ("APART", 10.0, "1 kept for their variety"), ("ASTRAY", -1.0, "0 of them lead to the configuration")],
)  # fmt: skip
def test_how_zeros_are_chosen_and_followed(monkeypatch: pytest.MonkeyPatch, name: str, value: float, text: str) -> None:
    assert text not in through_the_change_point().evidence[0]
    monkeypatch.setattr(branches, name, value)
    assert text in through_the_change_point().evidence[0]


def test_only_some_zeros_of_a_kind_are_classified(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse, fine, here = local(CHANGE_POINT)
    asked: list[object] = []
    point = branches.BranchPoint(1, 1, np.zeros(1), "")
    monkeypatch.setattr(branches, "_dimension_at", lambda *given, **named: asked.append(given) or point)
    groups = {1: [here.q] * 8}
    branches._dimensions(coarse, fine, groups, radius=0.1, known=set())
    branches._dimensions(coarse, fine, groups, radius=0.1, known={1})
    assert len(asked) == branches.CLASSIFIED + 1


def test_neighbours_span_a_dimension_only_beyond_rounding() -> None:
    _, _, here = local(CHANGE_POINT)
    u = np.array([[1.0, 0.02], [-1.0, 0.02], [1.0, -0.02], [-1.0, -0.02]])
    assert branches._spanned(here.q + 0.01 * u @ here.kernel.T, here, 0.01) == 1
    u[:, 1] *= 5
    assert branches._spanned(here.q + 0.01 * u @ here.kernel.T, here, 0.01) == 2
    assert branches._spanned(np.zeros((0, len(here.q))), here, 0.01) == 0


def test_a_zero_where_branches_meet_hands_over_to_a_neighbour(monkeypatch: pytest.MonkeyPatch) -> None:
    """The change point itself: a neighbour shows a branch of dimension 1; without asking it, nothing is known."""
    coarse, fine, here = local(CHANGE_POINT)
    assert branches._dimension_at(coarse, fine, here.q, 0.1).dimension == 1
    monkeypatch.setattr(branches, "DEPTH", 0)
    assert branches._dimension_at(coarse, fine, here.q, 0.1).dimension != 1
    monkeypatch.setattr(branches, "SHAKY", 0.0)
    monkeypatch.setattr(reduced_closure, "NEGLIGIBLE", 0.0)
    monkeypatch.setattr(branches, "LEAST_SCALE", 1.0)
    assert branches._dimension_at(coarse, fine, here.q, 0.1).dimension == branches.UNDECIDED


@pytest.mark.parametrize(
    "name, value, directions",
    [("PER_KIND", 1, 2), ("PER_KIND", 10, 4), ("STEPS", 0, 0), ("ZERO", 0.0, 0), ("APART", 9.0, 2), ("RANK", 9.0, 4),
     ("STARTS_PER_DIMENSION", 0, 0)],
)  # fmt: skip
def test_directions_of_a_cone(monkeypatch: pytest.MonkeyPatch, name: str, value: float, directions: int) -> None:
    """x^2 = y^2 has two lines, each in both senses."""
    monkeypatch.setattr(quadric_cone, name, value)
    found = quadric_cone.cone_directions(np.array([np.diag([1.0, -1.01])]), np.random.default_rng(1))
    assert len(found) == directions
    assert np.abs(np.einsum("ni,ij,nj->n", found, np.diag([1.0, -1.01]), found)).max(initial=0) < 1e-9


# -- witnesses, spins -------------------------------------------------------------------------------------


def test_witnesses_say_how_far_they_looked(monkeypatch: pytest.MonkeyPatch) -> None:
    smooth = finite_mobility(network("bennett")).witnesses[0]
    shaky = finite_mobility(network("collinear_3R")).witnesses[0]
    branch = through_the_change_point().witnesses[0]
    assert recheck(smooth)[1:] == (True, "power series of 1 motions by brackets close up to order 4")
    assert recheck(shaky)[2] == "0 zeros of the reduced closure from 64 starts on a sphere of radius 0.02"
    assert recheck(branch)[1]
    for name, value in (("ORDERS", 2), ("MOTIONS", 0), ("RADIUS", 0.05), ("STARTS", 2), ("STARTS_PER_FREEDOM", 0)):
        monkeypatch.setattr(witnesses, name, value)
    assert recheck(smooth)[2] == "power series of 0 motions by brackets close up to order 2"
    assert recheck(shaky)[2] == "0 zeros of the reduced closure from 4 starts on a sphere of radius 0.05"
    monkeypatch.setattr(witnesses, "CLOSED", 0.0)
    assert not recheck(branch)[1]


def test_a_wrong_claim_does_not_hold() -> None:
    assert not recheck(Witness(network("bennett"), "smooth", 2, 2))[1]
    assert not recheck(Witness(network("bennett"), "isolated", 0, 0))[1]


def test_spherical_joints_at_one_point_have_no_line_to_spin_about(monkeypatch: pytest.MonkeyPatch) -> None:
    legs = network("stewart_6sps")
    assert passive_spins.without_spins(legs)[1] == 6
    monkeypatch.setattr(passive_spins, "COINCIDE", 100)
    assert passive_spins.without_spins(legs) == (legs, 0)
