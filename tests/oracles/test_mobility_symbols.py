"""Mobility in symbols beyond limbs in their reference pose: loops, displaced limbs, planar joints, constant angles."""

from __future__ import annotations

import pytest
import sympy
from support.analysed import analysed, of_catalogue
from support.further_mechanisms import CASES
from support.seed_limbs import inclined

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import findings
from symscrew.mobility.analysis import analyse_mobility
from symscrew.mobility.checks import verify
from symscrew.mobility.symbols.limb_poses import LimbPose, limb_pose
from symscrew.mobility.symbols.loop_motions import SymbolicLoops, symbolic_loops

pytestmark = pytest.mark.slow

R, L, theta = sympy.symbols("R L theta", real=True)


def parallelogram() -> Mechanism:
    """Crank (a, h), coupler b, rocker (a + c, h): a parallelogram for c = 0."""
    builder = MechanismBuilder("loop", platform="coupler")
    for name, value in (("a", "3/10"), ("b", "1/2"), ("c", "1/5"), ("h", "2/5")):
        builder.parameter(name, value, "m")
    for body in ("crank", "coupler", "rocker"):
        builder.body(body)
    z = [0, 0, 1]
    builder.joint("A", "R", parent="base", child="crank", point=[0, 0, 0], axes=[z])
    builder.joint("B", "R", parent="crank", child="coupler", point=["a", "h", 0], axes=[z])
    builder.joint("C", "R", parent="coupler", child="rocker", point=["a+b", "h", 0], axes=[z])
    builder.joint("D", "R", parent="rocker", child="base", point=["b-c", 0, 0], axes=[z])
    return builder.build()


def test_rates_of_a_four_bar_in_its_parameters() -> None:
    """The coupler turns about the pole, where the lines of crank and rocker meet; with c = -a ... it translates."""
    found = analyse_mobility(parallelogram())
    loops = found.loops
    assert isinstance(loops, SymbolicLoops)
    a, b, c, h = sympy.symbols("a b c h", real=True)
    (rates,), (twist,) = loops.rates, loops.freedoms
    points = {"A": (0, 0), "B": (a, h), "C": (a + b, h), "D": (b - c, 0)}
    assert sympy.expand(sum(rates)) == 0
    for k in range(2):
        assert sympy.expand(sum(rate * points[joint][k] for joint, rate in zip(loops.joints, rates, strict=True))) == 0
    # the pole: v_O = -omega x r, on the lines A B and C D
    x, y = -twist[4] / twist[2], twist[3] / twist[2]
    assert sympy.simplify(x * h - y * a) == 0 and sympy.simplify((x - b + c) * h - y * (a + c)) == 0
    assert all(check.holds for check in verify(found))


def test_andrews_begins_at_a_dead_point() -> None:
    """Crank and rod are aligned (Theta = 0): they turn with rates d : rr - d while all other bodies rest."""
    found = of_catalogue("andrews")
    loops = found.loops
    assert isinstance(loops, SymbolicLoops) and (found.dof, found.platform.dof) == (1, 0)
    d, rr = sympy.symbols("d rr", real=True)
    (rates,) = loops.rates
    moving = {joint: rate for joint, rate in zip(loops.joints, rates, strict=True) if rate != 0}
    assert moving.pop("O") == d and moving.pop("F") == rr - d and set(moving.values()) == {-rr}
    turned = analyse_mobility(catalogue.load("andrews"), at={"O": "0.1"})
    assert (turned.dof, turned.platform.type, turned.internal_freedoms) == (1, "1R", 0)


def test_the_papers_limb_at_any_angle() -> None:
    """(13) with L + d_3 for L and theta + theta_2 for theta; the fourth angle turns the force about the leg's end."""
    pose = limb_pose(inclined(), "limb1")
    assert isinstance(pose, LimbPose) and pose.carried_by.startswith("limb1_U")
    second, slider, fourth = pose.displacements
    (wrench,) = (tuple(c.xreplace({fourth: sympy.S.Zero}) for c in w) for w in pose.constraints)
    angle = sympy.sin(theta + second)
    expected = (0, angle, 0, 0, 0, L + slider - R * angle)
    ratio = sympy.simplify(sympy.expand_trig(wrench[1] / expected[1]))
    assert ratio in (1, -1)
    difference = [sympy.simplify(sympy.expand_trig(w - ratio * e)) for w, e in zip(wrench, expected, strict=True)]
    assert difference == [0] * 6
    assert [locus.expression for locus in pose.loci if locus.kind == "limb"] == [L + slider]


def test_horizontal_axis_at_any_angle() -> None:
    """The variant's couple about z is lost as soon as the leg turns about its second axis."""
    pose = limb_pose(inclined(fourth=(1, 0, 0)), "limb1")
    assert isinstance(pose, LimbPose)
    at_rest = dict.fromkeys(pose.displacements, sympy.S.Zero)
    (wrench,) = ([c.xreplace(at_rest) for c in w] for w in pose.constraints)
    assert wrench[:5] == [0] * 5 and wrench[5] != 0
    assert pose.constraints[0][1] != 0


@pytest.mark.parametrize("name", ["three_ups_upu_s", "planar_3rrr", "sarrus", "five_bar", "slider_crank", "four_bar"])
def test_symbols_are_checked(name: str) -> None:
    found = of_catalogue(name)
    checks = verify(found)
    assert all(check.holds for check in checks)
    assert any("displacements" in check.claim or "symbols" in check.claim for check in checks)


def test_seed_limb_in_its_own_parameters() -> None:
    pose = limb_pose(catalogue.load("three_ups_upu_s"), "limb1")
    assert isinstance(pose, LimbPose)
    H, big, r = sympy.symbols("H R r", real=True)
    second, slider = pose.displacements
    force = H * sympy.sin(second) + (big - r) * sympy.cos(second)
    assert sympy.expand(pose.constraints[0][1] - force) == 0
    leg = sympy.sqrt((big - r) ** 2 + H**2)
    moment = leg * (leg + slider) - big * force
    difference = sympy.expand(pose.constraints[0][5] - sympy.expand(moment))
    assert abs(sympy.N(difference.subs({H: 0.52, big: 0.8, r: 0.5, second: 0.3, slider: 0.1}))) < 1e-14


def test_constant_angles_have_symbols() -> None:
    found = of_catalogue("stewart_6ups")
    assert found.symbolic is not None and not found.symbolic.constraints and len(found.symbolic.freedoms) == 6


def planar_pair() -> Mechanism:
    builder = MechanismBuilder("planar", platform="plate").body("plate").parameter("h", "1/3", "m")
    builder.limb("plane", "E", points=[[0, 0, "h"]], axes=[[["3/5", 0, "4/5"]]])
    builder.limb("ball", "S", points=[["h", 0, "h"]])
    return builder.build()


def test_planar_joints_have_symbols() -> None:
    """On a plane with one point held only the rotation about the normal through that point is left."""
    found = analyse_mobility(planar_pair())
    assert found.symbolic is not None and found.platform.type == "1R"
    h = sympy.Symbol("h", real=True)
    (twist,) = found.symbolic.freedoms
    expected = sympy.Matrix([3, 0, 4, 0, -h, 0])
    assert sympy.Matrix.hstack(sympy.Matrix(twist), expected).rank() == 1
    assert all(check.holds for check in verify(found))


def test_what_is_not_of_reasonable_size_is_said_so() -> None:
    found = of_catalogue("delta")
    assert isinstance(found.loops, str) and "not of reasonable size" in found.loops


@pytest.mark.parametrize("name", ["two bennetts", "waldron hybrid", "miura folded", "peaucellier"])
def test_rates_of_loops_are_exact(name: str) -> None:
    """Without parameters the rates are exact numbers, and close the loops to the last of 60 digits."""
    mechanism = CASES[name].make()
    loops = symbolic_loops(mechanism, analysed(name).platform.body)
    assert isinstance(loops, SymbolicLoops) and len(loops.rates) == 1
    assert all(check.holds for check in verify(analysed(name)))


def test_report_begins_with_its_figures() -> None:
    found = of_catalogue("three_ups_upu_s")
    assert dict(findings.key_figures(found))["freedoms of platform"] == "2 (2R)"
    assert "## Limbs limb2, limb3, limb4" in findings.mobility_markdown(found)
    plain = findings.mobility_text(found)
    assert "H*sin(theta_2) + (R - r)*cos(theta_2) = 0" in plain and "\\" not in plain
    assert "<mtable>" in findings.mobility_page(found) and "$" not in findings.mobility_page(found)
