"""Limbs that end at other bodies than the platform: what they forbid is not what the platform may not do."""

from __future__ import annotations

import pytest

from symscrew import formulas
from symscrew.description import Mechanism, MechanismBuilder
from symscrew.mobility import analyse_mobility, mobility_text, verify

pytestmark = pytest.mark.slow

UP = [[0, 0, 1]]


def on_a_bar() -> Mechanism:
    """A five-bar of two limbs in the plane, the first of which carries a bar on which the platform turns."""
    builder = MechanismBuilder("on_a_bar", platform="top")
    builder.parameter("a", "1/2", unit="m")
    for body in ("left", "bar", "right", "top"):
        builder.body(body)
    builder.joint("A", "R", parent="base", child="left", point=[0, 0, 0], axes=UP, driven=[0])
    builder.joint("B", "R", parent="left", child="bar", point=["-a", "2*a", 0], axes=UP)
    builder.joint("C", "R", parent="bar", child="top", point=[0, "4*a", 0], axes=UP)
    builder.joint("D", "R", parent="base", child="right", point=["4*a", 0, 0], axes=UP, driven=[0])
    builder.joint("E", "R", parent="right", child="top", point=["5*a", "3*a", 0], axes=UP)
    builder.limb("first", joints=["A", "B"])
    return builder.limb("second", joints=["D", "E"]).build()


def test_its_freedoms_are_those_of_the_closure_and_no_check_fails() -> None:
    found = analyse_mobility(on_a_bar())
    assert (found.dof, found.platform.type, found.dof_drives_locked) == (2, "1R1T", 0)
    assert found.constraints is None and found.counts.by_limbs is None
    assert [len(limb.constraints.basis) for limb in found.limbs] == [4, 4]
    assert all(check.holds for check in verify(found))
    assert "in symbols (omega ; v)" not in mobility_text(found)
    assert "no symbols: other bodies or loops than its limbs" in mobility_text(found)
    assert not any(locus.kind in ("constraint", "actuation") for locus in found.loci)


def test_papers_do_not_give_it_the_freedoms_that_its_limbs_would_leave() -> None:
    names = [part.title for part in formulas(on_a_bar()).parts]
    assert "Constraints" in names and "Freedoms of the platform" not in names
