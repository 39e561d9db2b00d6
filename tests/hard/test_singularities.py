"""What mobility analysis says about the three kinds of singularity: margins at a configuration, loci in symbols."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import pytest
import sympy

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.mobility import findings
from symscrew.mobility.analysis import Mobility, analyse_mobility

R, RP, H = sympy.symbols("R r H", real=True)


def values(found: Mobility, kind: str) -> dict[str, float]:
    assert found.singularities.margins is not None
    return {m.name: m.value for m in found.singularities.margins if m.kind == kind}


def zeros(found: Mobility, kind: str, where: str) -> list[sympy.Expr]:
    return [locus.expression for locus in found.loci if (locus.kind, locus.where) == (kind, where)]


def test_loci_of_the_seed_are_found_in_its_parameters() -> None:
    found = analyse_mobility(catalogue.load("three_ups_upu_s"))
    (constraint,) = zeros(found, "constraint", "platform")
    # L = R sin(theta) with L^2 = (R - r)^2 + H^2 and L sin(theta) = R - r
    assert sympy.expand(constraint - ((R - RP) ** 2 + H**2 - R * (R - RP))) == 0
    assert set(zeros(found, "actuation", "all drives")) == {H, R}
    assert zeros(found, "limb", "limb2")[0] == H


def test_limbs_that_may_be_left_out_in_the_reference_pose() -> None:
    """Drives 1 and 3, or 2 and 4, alone never hold the platform there; every other pair does."""
    found = analyse_mobility(catalogue.load("three_ups_upu_s"))
    never = {locus.where for locus in found.loci if locus.kind == "actuation" and locus.expression == 0}
    assert never == {"limb1_P limb3_P", "limb2_P limb4_P"}
    held = {name for name, value in values(found, "actuation").items() if abs(value) > 0.1}
    assert held == {"all drives", "limb1_P limb2_P", "limb1_P limb4_P", "limb2_P limb3_P", "limb3_P limb4_P"}


@pytest.mark.slow
def test_constraint_singularity_by_a_parameter_and_by_a_coordinate() -> None:
    """On the locus the margin is zero, and the mechanism has a freedom more; the margin is signed around it."""
    seed = catalogue.load("three_ups_upu_s")
    found = analyse_mobility(seed, at={"H": "sqrt(3/20)"})
    assert abs(values(found, "constraint")["platform"]) < 1e-12 and found.dof == 3
    at, around = "sqrt(3)/5 - 3/10", []  # the leg is R sin(theta) = 0.2 sqrt(3) long
    for offset in ("0", "1/1000", "-1/1000"):
        found = analyse_mobility(seed, at={"limb1_P": f"{at} + {offset}"})
        around.append(values(found, "constraint")["platform"])
        assert found.singularities.margins[0].kind == "limb" and not found.singularities.margins[0].singular
    assert abs(around[0]) < 1e-12 and min(map(abs, around[1:])) > 1e-4
    assert len({value > 0 for value in around[1:]}) == 2, around


@pytest.mark.slow
def test_margin_agrees_with_the_freedoms_left_by_locked_drives() -> None:
    straight = analyse_mobility(catalogue.load("stewart_6ups"))
    assert straight.dof_drives_locked == 0 and abs(values(straight, "actuation")["all drives"]) > 1
    bar = analyse_mobility(catalogue.load("four_bar"))
    assert bar.dof_drives_locked == 0 and set(values(bar, "limb")) == {"rocker"}


def test_json_keeps_the_kinds_apart(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mobility", "ur5", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["singularities"]
    assert found["constraint"] == [] and found["actuation"] == []
    (arm,) = found["limb"]
    assert arm["name"] == "arm" and arm["singular"] and arm["form"] == "signed volume"
    assert main(["mobility", "ur5", "--json", "--at", "elbow_joint=1", "wrist_2_joint=0.5"]) == 0
    found = json.loads(capsys.readouterr().out)["singularities"]
    assert not found["limb"][0]["singular"] and abs(found["limb"][0]["margin"]) > 1e-3


def test_the_report_names_what_is_singular() -> None:
    found = analyse_mobility(catalogue.load("ur5"))
    assert "limb (arm): SINGULAR here" in findings.mobility_text(found)
    assert "limb (arm): SINGULAR here" in findings.mobility_markdown(found)


def test_margins_do_not_depend_on_the_coordinate_by_which_the_configuration_is_given() -> None:
    """By the crank, by the joint that closes the loop, by a pose of the rocker: one configuration, the same margins."""
    mechanism = catalogue.load("four_bar")
    first = analyse_mobility(mechanism, at={"A": "20deg"})
    assert first.reached is not None and first.singularities.margins
    for name in ("C", "rocker.pitch", "rocker.x"):
        other = analyse_mobility(mechanism, at={name: first.reached.values[name]}).singularities.margins
        assert other is not None
        for one, same in zip(first.singularities.margins, other, strict=True):
            assert abs(one.value - same.value) < 1e-12 * one.size
    reference = analyse_mobility(mechanism).singularities.margins
    assert reference is not None and abs(reference[0].value - first.singularities.margins[0].value) > 1e-3


def test_the_nearest_zero_of_a_margin_is_where_the_rank_is_lost() -> None:
    """The slider-crank's slider rests for an instant where crank and rod are in line: by ranks in 60 digits as well."""
    found = analyse_mobility(catalogue.load("slider_crank"))
    assert found.singularities.margins is not None and found.platform.dof == 1
    (limb,) = [m for m in found.singularities.margins if m.kind == "limb"]
    near = limb.nearest
    assert near is not None and near.coordinate == "crank_R" and near.value < 1e-9 and near.closure < 1e-9
    assert not limb.singular and abs(near.by - math.atan2(4, 3)) < 1e-6
    there = analyse_mobility(catalogue.load("slider_crank"), at={"crank_R": "atan(4/3)"})
    assert (there.dof, there.platform.dof) == (1, 0)
    lines = "\n".join(findings.in_words.as_lines(found.singularities))
    assert f"0 along its gradient with crank_R displaced by {near.size}" in lines and "deg" in near.size


def test_where_three_arms_fold_at_once_a_triple_zero_is_followed_to_its_end() -> None:
    """Arms of 0.3 on rods of 0.7 lie over them where 0.2 - 0.4 cos = 0.05: all three at once, as they are equal."""
    found = analyse_mobility(catalogue.load("delta")).singularities.margins
    assert found is not None
    near = next(m for m in found if m.kind == "limb" and m.name == "platform").nearest
    assert near is not None and abs(near.by + math.acos(0.375)) < 1e-5


def test_a_margin_of_full_rank_is_almost_singular_whatever_its_size() -> None:
    found = analyse_mobility(catalogue.load("planar_3rrr"))
    assert found.singularities.margins is not None
    margin = next(m for m in found.singularities.margins if m.kind == "actuation")
    small = replace(margin, value=1e-12 * margin.size)
    assert small.vanishes and not small.singular and small.regular
    assert replace(small, regular=False).singular
