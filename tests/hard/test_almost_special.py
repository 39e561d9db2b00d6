"""What is special to many digits, not as typed: change points, axes far away, hinges all but through one point."""

from __future__ import annotations

from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy
from support.further_mechanisms import Z, loop
from support.reference_mechanisms import ENTRIES, build
from support.reposed import posed

from symscrew import MechanismBuilder
from symscrew.algebra import CONTEXT
from symscrew.mobility import (
    Mobility,
    WholeMotion,
    analyse_mobility,
    mobility_text,
    mobility_values,
    motion_lines,
    motion_values,
    screw_class,
    verify,
)
from symscrew.mobility.findings.typeset import shown

pytestmark = pytest.mark.slow

COUPLERS = ("1.3", "1.3000000000001", "1.2999999999")


@cache
def four_bar(end: str) -> Mobility:
    """A parallelogram where the coupler ends at 1.3, and none elsewhere."""
    builder = MechanismBuilder("almost", platform="coupler")
    for body in ("crank", "coupler", "rocker"):
        builder.body(body)
    places = {"A": [0, 0, 0], "B": ["3/10", "4/10", 0], "C": [end, "4/10", 0], "D": [1, 0, 0]}
    ends = ("base", "crank", "coupler", "rocker", "base")
    for k, (name, point) in enumerate(places.items()):
        builder.joint(name, "R", parent=ends[k], child=ends[k + 1], point=point, axes=[[0, 0, 1]], driven=k == 0)
    return analyse_mobility(builder.build())


def along(found: Mobility) -> WholeMotion:
    result = found.along
    assert isinstance(result, WholeMotion)
    return result


def folds(end: str) -> bool:
    """Whether all four pins can be in line: two lengths are as long as the other two (Grashof)."""
    with mpmath.workdps(60):
        c = mpmath.mpf(end)
        lengths = sorted([mpmath.mpf(1) / 2, c - mpmath.mpf(3) / 10, mpmath.sqrt((c - 1) ** 2 + mpmath.mpf(16) / 100),
                          mpmath.mpf(1)])  # fmt: skip
        return abs(lengths[0] + lengths[3] - lengths[1] - lengths[2]) < mpmath.mpf(10) ** -50


@pytest.mark.parametrize("end", COUPLERS)
def test_a_change_point_is_one_only_where_the_lengths_are_so(end: str) -> None:
    found = four_bar(end)
    poses = along(found).singular
    lost = [pose for pose in poses if "closure" in pose.kinds]
    assert len(lost) == (2 if folds(end) else 0)
    if folds(end):
        assert [pose.branches for pose in lost] == [(1, 1)] * 2 and not any(pose.almost for pose in poses)
        return
    assert poses and all(0 < pose.almost["closure"] < 1e-7 for pose in poses)
    lines = "\n".join(motion_lines(along(found), found.network, found.mechanism, "coupler"))
    assert "almost, and not as typed" in lines and "no singular pose was found" in lines
    values = motion_values(along(found), found.network, found.mechanism)
    assert all(pose["kinds"] == [] and pose["almost"] for pose in values["singular_poses"])


@pytest.mark.parametrize("end", COUPLERS)
def test_tables_of_one_report_do_not_contradict_each_other(end: str) -> None:
    """The coupler turns about an axis at 1e10 m, which is no translation: in the freedoms, the branch, the motion."""
    found = four_bar(end)
    expected = "1T" if end == "1.3" else "1R"
    assert found.branches is not None
    row = found.branches.rows[0]
    assert row.platform is not None and found.platform.type == row.platform.type == expected
    assert [c.type for c in along(found).classes] == [expected]
    assert ("1T" in row.almost) == (expected == "1R")


def test_classes_of_60_digits() -> None:
    tiny = CONTEXT.mpf(10) ** -11
    twist = np.array([[0 * tiny, 0 * tiny, tiny, 1 + 0 * tiny, 0 * tiny, 0 * tiny]], dtype=object)
    assert screw_class(twist.astype(float), 1.0).type == "1T" and screw_class(twist, 1.0).type == "1R"
    random = np.random.default_rng(3)
    for _ in range(20):
        given = random.integers(-1, 2, size=(int(random.integers(1, 6)), 6))
        rough, precise = (screw_class(np.array(given, dtype=kind) * one, 1.3)
                          for kind, one in ((float, 1.0), (object, CONTEXT.one)))  # fmt: skip
        assert (rough.type, rough.name) == (precise.type, precise.name)
        assert rough.pitches == pytest.approx(precise.pitches, abs=1e-9)


def apart(size: sympy.Rational) -> Any:
    """Joints' points moved by multiples of `size`."""
    return lambda joints: [
        {**j, "point": [c + size * ((7 * i + 3 * k) % 5 - 2) for k, c in enumerate(j["point"])]}
        for i, j in enumerate(joints)
    ]


@pytest.mark.parametrize("power", [8, 12, 15])
def test_hinges_all_but_through_one_point(power: int) -> None:
    """Rounding sets them apart; that is no linkage of a nanometre's size that nothing is next to."""
    found = analyse_mobility(build(ENTRIES["spherical_4r"], apart(sympy.Rational(1, 10**power))))
    assert (found.dof, found.finite.dof) == (0, 0) and found.near is not None
    assert found.near.meant.finite.dof == 1 and found.near.distance < 4 * 10.0**-power


@pytest.mark.slow
def test_terms_that_are_all_rounding_are_no_power() -> None:
    """A constraint through O on a screw through O, displaced: 1e-62 beside nothing was once called all of its terms."""
    move = [sympy.Rational(-c, 10**8) for c in (5, 8, 4)]
    change = lambda joints: [  # noqa: E731
        {**j, "point": [c + d for c, d in zip(j["point"], move, strict=True)]} if j["name"] == "A0" else j
        for j in joints
    ]
    found = analyse_mobility(build(ENTRIES["agile_eye-self_motion"], change))
    assert [check.claim for check in verify(found) if not check.holds] == []
    assert found.near is not None and found.near.meant.finite.dof == 3


@pytest.mark.slow
def test_ball_joints_alone_move() -> None:
    """No joint of one freedom: the coordinates are their rotations, and none rests; the other bar's spin is held."""
    found = analyse_mobility(loop(*(("S", point, None) for point in ([0, 0, 0], [1, 0, 0], [1, 2, 0]))))
    moving = along(found)
    assert moving.idle == () and moving.classes and len(moving.columns) == found.finite.dof - 1 == 2


@pytest.mark.slow
def test_what_is_lost_all_along_a_line_is_no_list_of_poses() -> None:
    """With the coupler's pins of a five-bar on one another the drives never hold it."""
    found = analyse_mobility(build(ENTRIES["planar_5bar-type2"]))
    moving = along(found)
    assert [kind for _, kind in moving.lost] == ["drives"]
    column = moving.lost[0][0]
    assert not any("drives" in pose.kinds for pose in moving.singular if pose.column == column)
    assert "all along the line of" in "\n".join(motion_lines(moving, found.network, found.mechanism, "x"))


def test_long_numbers_are_shown_without_their_factors() -> None:
    long = sympy.Rational(10**44 + 31, 10**44 + 3)
    numbers = shown((long, 2 * long, sympy.Integer(0), sympy.sqrt(3) * long, sympy.Integer(0), sympy.Integer(1)))
    size = float(long) * 5**0.5
    expected = [float(long) / size, 2 * float(long) / size, 0, 3**0.5 * float(long) / size, 0, 1 / size]
    assert [float(c) for c in numbers] == pytest.approx(expected, rel=1e-5)


def test_a_loop_of_screws_that_are_not_quite_parallel_has_its_verdict_without_margins() -> None:
    """Of such a loop no joint can be cut, so that margins are not known: no reason to refuse the rest."""
    change = lambda joints: posed(joints, seed=1, digits="double", unit="m")  # noqa: E731
    found = analyse_mobility(build(ENTRIES["delassus_4h"], change))
    assert found.singularities.margins is None and "whole turns" in found.singularities.unknown
    assert mobility_values(found)["dof"] == found.dof and "Margins are not known" in mobility_text(found)


def screws(pitches: list[str]) -> Mobility:
    """A parallelogram of screw joints: opposite ones turn alike, neighbours back; h1 - h2 + h3 - h4 = 0 moves."""
    places = ([0, 0, 0], ["1.7", "0.4", 0], ["2.6", "2.3", 0], ["0.9", "1.9", 0])
    joints = [("H", [sympy.Rational(c) for c in place], Z) for place in places]
    return analyse_mobility(loop(*joints, pitches={k: sympy.Rational(h) for k, h in enumerate(pitches)}))


def test_pitches_that_are_almost_those_of_a_linkage_that_moves_are_named() -> None:
    """E. Delassus 1922; places and axes alone do not make it move: the pitches have to change, and are to be typed."""
    typed = screws(["0.3", "-0.2", "0.1", "0.600000004"])
    assert typed.finite.dof == 0 and typed.near is not None
    assert typed.near.meant.finite.dof == 1 and 1e-10 < typed.near.distance < 1e-8
    pitches = [place[2] for place in typed.near.places().values()]
    again = screws([pitch for pitch in pitches if pitch is not None])
    assert again.finite.dof == 1 and again.near is None
    assert mobility_values(typed)["near"]["type_instead"]["J1"]["pitch"] == pitches[0]
    assert f"pitch {pitches[0]}" in mobility_text(typed, full=True)


@pytest.mark.parametrize("off", [sympy.Rational(1, 10**40), sympy.Integer(0)])
def test_limbs_that_are_almost_stretched_have_fewer_constraints_over_the_field(off: sympy.Expr) -> None:
    """The rank of the constraints is smaller there, not larger, since that of the limb is larger."""
    limbs = {"one": [[0, 0, 0], [1, off, 0], [3, 0, 0]], "two": [[0, 1, 0], [2, 4, 0], [3, 2, 0]]}
    builder = MechanismBuilder("stretched", platform="plate").body("plate")
    for name, places in limbs.items():
        bodies = ["base", f"{name}1", f"{name}2", "plate"]
        for body in bodies[1:3]:
            builder.body(body)
        for k, place in enumerate(places):
            builder.joint(f"{name}{k}", "R", parent=bodies[k], child=bodies[k + 1], point=place, axes=[Z])
        builder.limb(name, joints=[f"{name}{k}" for k in range(3)])
    found = analyse_mobility(builder.build())
    exact = {rank.claim: (rank.numeric, rank.exact) for rank in found.decisions.ranks}
    assert exact["rank of the limbs' constraints"] == ((4, 3) if off else (4, 4))
    assert [check.claim for check in verify(found) if not check.holds] == []


def test_what_rests_is_not_all_that_is_named_where_newton_solves_short_steps_alone() -> None:
    """P. G. Altmann 1954, in six digits: a step of 0.2 is not solved, and geometry with the ranks alone rests."""
    joints = [
        ("-0.339465 -0.227676 0.596856", "-0.982104 -0.147667 0.116903"),
        ("-0.479174 0.0771909 -0.191747", "-0.094301 0.922838 0.373468"),
        ("-0.479174 0.0771909 -0.191747", "0.99137 0.121361 -0.04956"),
        ("-0.612133 0.690843 -1.34869", "0.0835608 -0.876327 -0.474415"),
        ("-0.558744 0.287603 -0.594431", "0.994553 0.103104 -0.0152761"),
        ("-0.558744 0.287603 -0.594431", "-0.0878769 0.908275 0.409041"),
    ]
    read = lambda text: [sympy.Rational(c) for c in text.split()]  # noqa: E731
    found = analyse_mobility(loop(*(("R", read(point), read(axis)) for point, axis in joints)))
    moves = found.near is not None and found.near.meant.finite.dof == 1
    assert found.finite.dof == 0 and (moves or any("special geometry" in text for text in found.not_tried))
