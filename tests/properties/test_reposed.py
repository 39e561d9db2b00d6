"""Mechanisms turned at random and typed with few digits keep their verdict, or the result says why not."""

from __future__ import annotations

import pytest
from support.reference_mechanisms import ENTRIES
from support.reposed import DIGITS, UNITS, generic_posed, reference

from symscrew.mobility import sections

BESIDE = (
    "parallelogram", "slider_crank-dead_centre", "planar_3rrr-type1", "threebar_parallel_equal", "bricard_box",
    "sarrus-stretched", "3upu_tsai-constraint_sing_cylinder",
)  # fmt: skip
"""Of every kind: a type, a drive's hold, a motion, a group of loops, twelve conditions, branches, a rank of limbs."""
NOT_FOUND = {"6": {"double_watt_cusp", "delta_4s-parallel_forearms"}}
"""What rounding to six digits hides: singular points of second order, where only the almost lost rank is said."""


@pytest.mark.parametrize("digits", DIGITS)
def test_generic_mechanisms_keep_their_verdict(digits: str) -> None:
    for seed in range(2):
        posed = generic_posed(seed, digits=digits, unit="m")
        assert (posed.verdict, posed.failed) == ("kept", ())


@pytest.mark.slow
@pytest.mark.parametrize("digits", DIGITS)
@pytest.mark.parametrize("unit", UNITS)
def test_every_generic_mechanism_keeps_its_verdict(digits: str, unit: str) -> None:
    """A third of the thirty in each, all of them in every unit; `python -m tests.benchmarks reposed` runs all."""
    for seed in range(list(DIGITS).index(digits) % 3, 30, 3):
        assert generic_posed(seed, digits=digits, unit=unit).verdict == "kept"


@pytest.mark.parametrize("name", BESIDE)
def test_of_special_mechanisms_in_doubles_what_was_meant_is_found(name: str) -> None:
    posed = reference(name, seed=list(ENTRIES).index(name), digits="double", unit="m")
    assert posed.verdict == "explained" and posed.found is not None and posed.found.near is not None
    assert posed.found.near.distance < 1e-14 * float(posed.found.network.length)
    assert any("as typed" in line for _, lines in sections(posed.found) for line in lines)


@pytest.mark.slow
@pytest.mark.parametrize("digits", ["double", "6"])
def test_every_special_mechanism_keeps_its_verdict_or_says_what_was_meant(digits: str) -> None:
    for k, name in enumerate(ENTRIES):
        verdict = reference(name, seed=k, digits=digits, unit="mm").verdict
        assert verdict in (("warned",) if name in NOT_FOUND.get(digits, ()) else ("kept", "explained")), name


@pytest.mark.parametrize("digits", DIGITS)
@pytest.mark.parametrize("name", ["bennett", "slider_crank"])
def test_special_geometry_is_found_beside_what_was_typed(name: str, digits: str) -> None:
    posed = reference(name, seed=3, digits=digits, unit="m")
    assert posed.verdict == "explained" and posed.found is not None
    near = posed.found.near
    assert near is not None and posed.found.dof == 0 and near.meant.finite.dof == 1
    rounding = {"double": 1e-14, "12": 1e-10, "9": 1e-7, "6": 1e-4}[digits]
    assert 0 < near.distance < rounding * float(posed.found.network.length)
    assert {name for name, _ in near.changes} == set(near.places())
