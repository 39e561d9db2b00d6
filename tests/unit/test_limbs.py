"""Limbs by letters and mechanism strings."""

import pytest
import sympy

from symscrew.description.builder import MechanismBuilder
from symscrew.description.limb_letters import parse_limb_string, parse_mechanism_string
from symscrew.errors import DescriptionError


@pytest.mark.parametrize(
    ("text", "marked"),
    [
        ("3UPS-UPU-S", ["UP*S", "UP*S", "UP*S", "UP*U", "S"]),
        ("6-UPS", ["UP*S"] * 6),
        ("3-PRRR", ["P*RRR"] * 3),
        ("3-RRR", ["R*RR"] * 3),
        ("2-UPS+RRR-S", ["UP*S", "UP*S", "R*RR", "S"]),
        ("6-UP*S", ["UP*S"] * 6),
        ("3PUS*", ["PUS*"] * 3),
        ("3 UPS - UPU", ["UP*S", "UP*S", "UP*S", "UP*U"]),
        ("C**R+U*SE", ["C**R", "U*SE"]),
        ("HRRR", ["H*RRR"]),
    ],
)
def test_mechanism_string(text, marked):
    assert [limb.marked for limb in parse_mechanism_string(text)] == marked


def test_freedoms_of_the_seed():
    limbs = parse_mechanism_string("3UPS-UPU-S")
    assert [limb.freedom for limb in limbs] == [6, 6, 6, 5, 3]
    assert sum(len(d) for limb in limbs for d in limb.driven) == 4


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "expected limbs such as '3UPS-UPU-S'"),
        ("3", "the count 3 at the end of '3' has no limb after it"),
        ("3-", "cannot read ''"),
        ("3-6-UPS", "two counts in a row"),
        ("3XPS", "unknown joint letter 'X'"),
        ("3ups", "unknown joint letter 'u' in 'ups'; write 'U'"),
        ("0-UPS", "expected a count from 1 to 100, got 0"),
        ("999999999UPS", "expected a count from 1 to 100"),
        ("99UPS-99UPS", "198 limbs; at most 100"),
        ("UP**S", "2 stars after 'P' in 'UP\\*\\*S', but this joint has 1 freedom"),
        ("*UPS", "expected the letters of the joints"),
        ("3(UPS)", r"cannot read '3\(UPS\)'"),
        ("UPS\n__import__", "cannot read"),
        ("R" * 31, "a limb of 31 joints; at most 30"),
        ("UPS-" * 200, "expected limbs such as"),
        (3, "expected limbs such as .*, got 3"),
    ],
)
def test_bad_mechanism_string(text, message):
    with pytest.raises(DescriptionError, match=message):
        parse_mechanism_string(text)


def test_limb_string_alone():
    limb = parse_limb_string("PRRU")
    assert (limb.letters, limb.driven, limb.freedom) == ("PRRU", ((0,), (), (), ()), 5)


def pendulum():
    return MechanismBuilder("m", platform="platform").body("platform")


U_AXES = [[1, 0, 0], [0, 1, 0]]


def test_ups_makes_bodies_and_joints():
    built = pendulum().limb("leg", "UPS", points=[[0, 0, 0], [3, 0, 4]], axes=[U_AXES, [], []]).build()
    assert list(built.bodies) == ["base", "platform", "leg_1", "leg_2"]
    assert list(built.joints) == ["leg_U1", "leg_P2", "leg_S3"] == list(built.limbs["leg"].joints)
    slider = built.joints["leg_P2"]
    assert slider.axes == ((sympy.Rational(3, 5), 0, sympy.Rational(4, 5)),)
    assert slider.point == (sympy.Rational(3, 2), 0, 2)
    assert (slider.parent, slider.child, slider.driven) == ("leg_1", "leg_2", (0,))
    assert built.joints["leg_U1"].driven == () == built.joints["leg_S3"].axes


def test_explicit_names_drive_and_inertia():
    built = (
        pendulum()
        .limb(
            "leg", "UPS", joints=["u", "p", "s"], bodies=["low", "high"], driven=[0],
            points=[[0, 0, 0], [0, 0, 1]], axes=[U_AXES, [], []], mass=[1, "2"],
            com=[[0, 0, "1/4"], [0, 0, "3/4"]], reference=[[], ["0.5"], []],
            inertia=[["0.01", "0.01", 0], [[0, 0, 0], [0, 0, 0], [0, 0, 0]]],
        )
        .build()
    )  # fmt: skip
    assert built.bodies["high"].mass == 2 and built.bodies["low"].inertia[0][0] == sympy.Rational(1, 100)
    assert built.joints["u"].driven == (0,) and built.joints["p"].driven == ()
    assert built.joints["p"].reference == (sympy.Rational(1, 2),)


def test_passive_limb_and_bare_axis():
    built = pendulum().limb(
        "arm", "RR", driven=False, points=[[0, 0, 0], [1, 0, 0]], axes=[[0, 0, 1], [[0, 0, 1]]]
    ).build()  # fmt: skip
    assert all(joint.driven == () and joint.axes == ((0, 0, 1),) for joint in built.joints.values())


def test_leading_slider_sits_at_its_neighbour():
    built = pendulum().limb(
        "leg", "PRS", points=[[1, 0, 0], [1, 0, 1]], axes=[[1, 0, 0], [0, 1, 0], []]
    ).build()  # fmt: skip
    assert built.joints["leg_P1"].point == (1, 0, 0) and built.joints["leg_P1"].driven == (0,)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "limbs.leg: the key 'points' is missing"),
        (
            {"points": [[0, 0, 0]]},
            r"one point per joint of UPS \(3\) or one per joint other than P \(2\), got 1",
        ),
        ({"points": "abc"}, "expected a list of points"),
        ({"points": [[0, 0, 0], [0, 0, 1]]}, r"joint 1 of UPS \(U\) needs 2 axes; none is given"),
        ({"points": [[0, 0, 0], [0, 0, 0]], "axes": [U_AXES, [], []]}, "two points that coincide"),
        (
            {"points": [[0, 0, 0], [0, 0, 1]], "axes": [U_AXES]},
            "expected one entry per joint of UPS, that is 3, got 1",
        ),
        ({"points": [[0, 0, 0], [0, 0, 1]], "axes": [U_AXES, [], []], "mass": [1]}, "one entry per body"),
        (
            {"points": [[0, 0, 0], [0, 0, 1]], "axes": [U_AXES, [], []], "driven": [3]},
            "joints from 0 to 2, got 3",
        ),
        (
            {"points": [[0, 0, 0], [0, 0, 1]], "axes": [U_AXES, [], []], "mas": [1]},
            "unknown key 'mas'; did you mean 'mass'",
        ),
        (
            {"points": [[0, 0, 0], [0, 0, 1]], "axes": [U_AXES, [], []], "tip_point": [0, 0, "1.25"]},
            "joints.leg_S3: the loop does not close .* 0.25 m away from its place on 'leg_2'",
        ),
    ],
)
def test_bad_limbs(options, message):
    with pytest.raises(DescriptionError, match=message):
        pendulum().limb("leg", "UPS", **options).build()


def test_limb_needs_a_tip():
    with pytest.raises(DescriptionError, match="no 'tip' body given and the mechanism has no platform"):
        MechanismBuilder("m").limb("leg", "S", points=[[0, 0, 0]])
