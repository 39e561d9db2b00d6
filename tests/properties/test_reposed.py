"""Mechanisms turned at random and typed with few digits keep their verdict, or the result says why not."""

from __future__ import annotations

import pytest
from support.reposed import DIGITS, UNITS, generic_posed, reference

KEPT = ("planar_4bar", "general_6r", "stewart_6ups", "sarrus", "parallelogram-change_point")


@pytest.mark.parametrize("digits", DIGITS)
def test_generic_mechanisms_keep_their_verdict(digits: str) -> None:
    for seed in range(2):
        posed = generic_posed(seed, digits=digits, unit="m")
        assert (posed.verdict, posed.failed) == ("kept", ())


@pytest.mark.slow
@pytest.mark.parametrize("digits", DIGITS)
@pytest.mark.parametrize("unit", UNITS)
def test_every_generic_mechanism_keeps_its_verdict(digits: str, unit: str) -> None:
    for seed in range(30):
        assert generic_posed(seed, digits=digits, unit=unit).verdict == "kept"


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
