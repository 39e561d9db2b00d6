"""Mobility in symbols, in other configurations, its report and command line."""

from __future__ import annotations

import dataclasses

import pytest
import sympy
from support.analysed import analysed, of_catalogue
from support.reference_mechanisms import ENTRIES, build
from support.seed_limbs import inclined

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.errors import DescriptionError
from symscrew.mobility.analysis import analyse_mobility
from symscrew.mobility.checks import verify
from symscrew.mobility.finite.finite_motion import finite_mobility
from symscrew.mobility.joint_network import network_of

SEED = "three_ups_upu_s"
R, L, theta = sympy.symbols("R L theta", real=True)


def test_the_papers_constraint_in_symbols() -> None:
    """Eqs. (11)-(18): (0, sin, 0; 0, 0, L - R sin) without a pole, and the loci that follow from it."""
    found = analyse_mobility(inclined()).symbolic
    assert found is not None
    ((wrench,), (), forces) = (limb.constraints for limb in found.limbs)
    assert wrench == (0, sympy.sin(theta), 0, 0, 0, L - R * sympy.sin(theta))
    assert [tuple(f) for f in forces] == [(1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0), (0, 0, 1, 0, 0, 0)]
    assert [tuple(t) for t in found.freedoms] == [(1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0)]
    (singular,) = (locus.expression for locus in found.loci if locus.kind == "constraint")
    assert sympy.expand(singular + L - R * sympy.sin(theta)) == 0 or singular == L - R * sympy.sin(theta)
    assert [locus.expression for locus in found.loci if locus.kind == "couple"] == [sympy.sin(theta)]


def test_couple_of_the_upright_limb() -> None:
    found = analyse_mobility(inclined("0"))
    assert [[float(c) for c in w] for w in found.limbs[0].constraints.basis] == [[0, 0, 0, 0, 0, 1]]
    assert all(check.holds for check in verify(found))


def test_horizontal_fourth_axis_gives_a_couple_at_every_inclination() -> None:
    found = analyse_mobility(inclined(fourth=(1, 0, 0))).symbolic
    assert found is not None and found.limbs[0].constraints == ((0, 0, 0, 0, 0, 1),)


def test_seed_in_its_own_parameters() -> None:
    found = of_catalogue(SEED)
    r, H = sympy.symbols("r H", real=True)
    assert found.symbolic is not None
    (wrench,) = found.symbolic.limbs[0].constraints
    assert [sympy.expand(c) for c in wrench] == [0, R - r, 0, 0, 0, H**2 - R * r + r**2]
    assert all(check.holds for check in verify(found))


def test_constraint_singularity_of_the_seed() -> None:
    """At L = R sin(theta) the platform has a third freedom, but only two are real."""
    found = analyse_mobility(catalogue.load(SEED), at={"r": "1/5", "H": "sqrt(3)/5"})
    assert (found.dof, found.platform.type, found.finite.dof, found.finite.branches) == (3, "3R", 2, (2,))
    assert found.overconstraints == 1 and all(check.holds for check in verify(found))


@pytest.mark.parametrize(
    "left_out, locked",
    [((), 0), (("limb2",), 0), (("limb3",), 0), (("limb4",), 0), (("limb2", "limb3"), 0), (("limb2", "limb4"), 1)],
)
def test_limbs_that_may_be_left_out(left_out: tuple[str, ...], locked: int) -> None:
    """Without limbs 2 and 4 nothing holds the rotation about x; any other limbs may go."""
    mechanism = catalogue.load(SEED)
    fewer = dataclasses.replace(
        mechanism,
        joints={n: j for n, j in mechanism.joints.items() if not left_out or not n.startswith(left_out)},
        bodies={n: b for n, b in mechanism.bodies.items() if not left_out or not n.startswith(left_out)},
        limbs={n: limb for n, limb in mechanism.limbs.items() if n not in left_out},
    )
    found = analyse_mobility(fewer)
    assert (found.platform.type, found.dof_drives_locked) == ("2R", locked)


def test_another_configuration_by_a_joint_coordinate() -> None:
    found = analyse_mobility(catalogue.load("bennett"), at={"J1": "2/5"})
    assert (found.dof, found.finite.dof, found.overconstraints) == (1, 1, 3)
    with pytest.raises(DescriptionError, match="no parameter, joint or body"):
        analyse_mobility(catalogue.load("bennett"), at={"J9": 1})
    with pytest.raises(DescriptionError, match="cannot be assembled"):
        analyse_mobility(catalogue.load(SEED), at={"limb2_P": 5})


def test_folding_a_parallelogram_by_its_coordinate_reaches_the_change_point() -> None:
    folded = analysed("parallelogram-change_point")
    assert folded.finite.branches == (1,)


def test_overconstraints_and_their_cure() -> None:
    """A cure for each redundant constraint; freeing the named joints' constraints leaves the mobility."""
    found = of_catalogue("bennett")
    assert found.redundant.count == 3 == len(found.redundant.cure)
    assert set(found.redundant.statically_indeterminate) == set(found.mechanism.joints)
    assert of_catalogue(SEED).redundant.count == 0


def test_independent_blocks_multiply() -> None:
    """A change point beside a shaky truss: motion of one dimension, three instantaneous freedoms."""
    builder = MechanismBuilder("blocks")
    for name in ("parallelogram-change_point", "threebar_parallel_unequal"):
        joints = build(ENTRIES[name]).joints.values()
        for body in dict.fromkeys(b for j in joints for b in (j.parent, j.child) if b != "base"):
            builder.body(f"{name[:3]}_{body}")
        for joint in joints:
            parent, child = (b if b == "base" else f"{name[:3]}_{b}" for b in (joint.parent, joint.child))
            options = {"point": list(joint.point), "axes": [list(a) for a in joint.axes]}
            builder.joint(f"{name[:3]}_{joint.name}", joint.type, parent=parent, child=child, **options)
    found = finite_mobility(network_of(builder.build()))
    assert (found.dof, found.branches, found.smooth) == (1, (1,), False)


def test_a_singular_pose_is_met_exactly() -> None:
    """Coordinates that the walk leaves at their reference stay there exactly: H^2 = R r - r^2 is met in 60 digits."""
    report = analyse_mobility(catalogue.load("three_ups_upu_s"), at={"limb1_P": "sqrt(3)/5 - 3/10"})
    assert report.dof == 3
