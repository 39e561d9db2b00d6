"""Nothing is concluded from rounding: bodies at rest, withdrawn statements, proofs told from samples."""

from __future__ import annotations

import warnings

import pytest
from support.further_mechanisms import CASES, loop
from support.reference_mechanisms import ENTRIES, build
from support.reposed import reference

from symscrew import catalogue
from symscrew.algebra import CONTEXT
from symscrew.description.builder import MechanismBuilder
from symscrew.mobility import analyse_mobility, mobility_values, verify
from symscrew.mobility.screw_systems import combine, eliminate, unit_rows
from symscrew.mobility.singularities import as_lines
from symscrew.mobility.symbols import SymbolicLoops


def test_a_sum_that_is_rounding_against_its_terms_is_zero() -> None:
    third = CONTEXT.one / 3
    noise = combine([[third, -third * (1 + CONTEXT.mpf(10) ** -50)]], [CONTEXT.one, CONTEXT.one])
    kept = combine([[third, -third * (1 + CONTEXT.mpf(10) ** -20)]], [CONTEXT.one, CONTEXT.one])
    assert noise == (0,) and kept[0] != 0


def test_ranks_do_not_depend_on_the_length_of_rows() -> None:
    rows = [[CONTEXT.mpf(10) ** 80, CONTEXT.zero], [CONTEXT.zero, CONTEXT.mpf(10) ** -5]]
    assert eliminate(rows, 2).rank == 1 and eliminate(unit_rows(rows), 2).rank == 2


def test_what_a_check_does_not_confirm_is_not_said() -> None:
    found = analyse_mobility(catalogue.load("three_ups_upu_s"))
    assert found.symbolic is not None and found.finite.judgement == "proved"
    less = found.without({"symbols", "finite"})
    assert less.symbolic is None and less.without_symbols is not None and "withheld" in less.without_symbols
    assert less.finite.dof is None and mobility_values(less)["judgement"] == "undecided"


def test_planar_loops_are_proved_by_their_group_others_by_an_arc_and_others_sampled() -> None:
    planar = analyse_mobility(build(ENTRIES["planar_4bar"]))
    assert planar.decisions.groups == (3,) and planar.finite.judgement == "proved"
    bennett = analyse_mobility(build(ENTRIES["bennett"]))
    assert bennett.decisions.groups == (6,) and bennett.finite.judgement == "proved"
    assert "order 16" in bennett.finite.evidence[-1]
    folded = analyse_mobility(build(ENTRIES["sarrus-spin_mode"]))
    assert (folded.dof, folded.finite.dof, folded.finite.judgement) == (2, 2, "sampled")


def test_a_change_point_in_doubles_moves_as_typed_and_is_beside_a_singular_point() -> None:
    posed = reference("parallelogram-change_point", seed=3, digits="double", unit="m")
    assert posed.failed == () and posed.found is not None and posed.found.near is not None
    assert posed.found.finite.dof == 1 and posed.found.finite.judgement == "proved"
    meant = posed.found.near.meant
    assert (meant.dof, meant.finite.branches) == (2, (1,)) and posed.found.near.distance < 1e-14


def test_margins_carry_the_ranks_beside_them() -> None:
    found = analyse_mobility(build(ENTRIES["sarrus-flat_folded"]))
    margins = found.singularities.margins
    assert margins is not None
    lost = [m for m in margins if m.kind == "limb" and m.note]
    assert len(lost) == 2 and all(m.singular and m.note.startswith("2 of 3 screws") for m in lost)


def test_rates_of_a_planar_joint_across_no_absolute_axis_are_not_given() -> None:
    """Its coordinates are along unit directions, which are roots: symbols along others were caught by their check."""
    slanted = loop(("E", [1, 2, 3], [1, 2, 2]), ("S", [0, 0, 0], None))
    found = analyse_mobility(slanted)
    assert found.loops == "no symbols: unit directions in the plane of J1, across no absolute axis, are roots"
    assert [check.claim for check in verify(found) if not check.holds] == []
    upright = analyse_mobility(loop(("E", [1, 2, 3], [0, 0, 1]), ("S", [0, 0, 0], None)))
    assert isinstance(upright.loops, SymbolicLoops) and all(check.holds for check in verify(upright))


def test_axes_perpendicular_in_doubles_are_rigid_without_a_division_by_nothing() -> None:
    """Three hinges through a point, in a plane but for rounding: what is not zero in 60 digits is in doubles."""
    flat = [["-1", "0", "2e-17"], ["0.6", "0.8", "0"], ["-0.8", "0.6", "0"]]
    builder = MechanismBuilder("flat").body("a").body("b")
    for k, (parent, child) in enumerate([("base", "a"), ("a", "b"), ("b", "base")]):
        builder.joint(f"J{k}", "R", parent=parent, child=child, point=[0, 0, 0], axes=[flat[k]])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = analyse_mobility(builder.build())
        assert (found.dof, found.finite.dof) == (0, 0) and found.branches is not None and found.branches.rows == ()


@pytest.mark.parametrize("digits, said", [("double", "almost SINGULAR"), (None, "SINGULAR here")])
def test_a_closure_that_almost_loses_rank_has_no_margin_that_is_clear_of_it(digits: str | None, said: str) -> None:
    """Typed in doubles the change point keeps its rank by 1e-16, and the margin said that it is lost."""
    found = analyse_mobility(build(ENTRIES["parallelogram-change_point"]))
    if digits is not None:
        result = reference("parallelogram-change_point", seed=2, digits=digits, unit="mm").found
        assert result is not None and result.dof == 1
        found = result
    assert found.singularities.margins is not None
    (line,) = [line for line in as_lines(found.singularities) if line.startswith("constraint")]
    assert said in line and "no zero found" not in line, line
    (margin,) = [m for m in found.singularities.margins if m.kind == "constraint"]
    assert margin.singular == (digits is None) and bool(margin.almost) == (digits is not None)


@pytest.mark.parametrize("name", ["3S, collinear", "hexagon", "collinear_3R", "parallelogram-change_point"])
def test_constraint_margins_agree_with_a_closure_that_has_lost_its_rank(name: str) -> None:
    """Shaky all along, the margin was the volume of what is left; of a point alone, 1e-15 with no zero in sight."""
    found = analyse_mobility(build(ENTRIES[name]) if name in ENTRIES else CASES[name].make())
    assert found.finite.dof is not None and found.finite.dof < found.dof and found.singularities.margins is not None
    margins = [m for m in found.singularities.margins if m.kind == "constraint"]
    assert margins and all(m.singular for m in margins)
    lines = [line for line in as_lines(found.singularities) if line.startswith("constraint")]
    assert lines and all("SINGULAR" in line and "no zero found" not in line for line in lines)


def test_a_constraint_margin_of_a_smooth_point_is_no_singularity() -> None:
    margins = analyse_mobility(build(ENTRIES["planar_4bar"])).singularities.margins
    assert margins is not None and not any(m.singular for m in margins if m.kind == "constraint")
