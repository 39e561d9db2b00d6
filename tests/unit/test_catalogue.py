"""The catalogue: every mechanism loads, reads back from its own text, and keeps the published facts."""

import json
from pathlib import Path

import numpy as np
import pytest
import sympy

from symscrew import catalogue
from symscrew.description.joints import JOINT_TYPES
from symscrew.description.toml_file import load_description, parse_description, to_toml
from symscrew.errors import DescriptionError

DATA = Path(__file__).parents[1] / "data"

EXPECTED = {
    # name: (moving bodies, joints, loops, drives, warnings)
    "andrews": (7, 10, 3, 1, 1),
    "bennett": (3, 4, 1, 1, 0),
    "delta": (10, 15, 5, 3, 0),
    "differential": (4, 4, 0, 2, 0),
    "five_bar": (4, 5, 1, 2, 0),
    "four_bar": (3, 4, 1, 1, 0),
    "gear_train": (3, 3, 0, 1, 0),
    "panda": (7, 7, 0, 7, 4),
    "planar_3rrr": (7, 9, 2, 3, 0),
    "sarrus": (5, 6, 1, 1, 0),
    "slider_crank": (3, 4, 1, 1, 0),
    "stewart_6ups": (13, 18, 5, 6, 0),
    "three_ups_upu_s": (9, 13, 4, 4, 9),
    "three_ups_upu_s_physical": (9, 13, 4, 4, 0),
    "ur5": (6, 6, 0, 6, 0),
}


@pytest.fixture(scope="session")
def mechanisms():
    return {name: catalogue.load(name) for name in catalogue.names()}


def numbers(mechanism, vector):
    return np.array([float(mechanism.number(entry)) for entry in vector])


def test_names(mechanisms):
    assert set(catalogue.names()) == set(EXPECTED)
    assert all(mechanism.name == name for name, mechanism in mechanisms.items())


@pytest.mark.parametrize("name", EXPECTED)
def test_counts(mechanisms, name):
    m = mechanisms[name]
    moving, joints = len(m.bodies) - 1, len(m.joints)
    drives = sum(len(joint.driven) for joint in m.joints.values())
    assert (moving, joints, joints - moving, drives, len(m.warnings)) == EXPECTED[name]


@pytest.mark.parametrize("name", EXPECTED)
def test_every_moving_body_has_inertia(mechanisms, name):
    for body in mechanisms[name].bodies.values():
        assert (body.mass is None) == (body.name == "base")


@pytest.mark.parametrize("name", EXPECTED)
def test_text_reads_back_exactly(mechanisms, name):
    assert parse_description(to_toml(mechanisms[name])) == mechanisms[name]


@pytest.mark.parametrize("name", EXPECTED)
def test_no_floating_point(mechanisms, name):
    m = mechanisms[name]
    entries = [e for j in m.joints.values() for v in (j.point, *j.axes) for e in v]
    entries += [e for b in m.bodies.values() if b.inertia for v in (b.com, *b.inertia) for e in v]
    assert not any(sympy.sympify(entry).has(sympy.Float) for entry in entries)


@pytest.mark.parametrize("name", EXPECTED)
def test_axes_are_exactly_unit(mechanisms, name):
    m = mechanisms[name]
    for joint in m.joints.values():
        assert len(joint.axes) == JOINT_TYPES[joint.type].axes
        for axis in joint.axes:
            square = sum(m.number(entry) ** 2 for entry in axis)
            assert square == 1 or abs(sympy.N(square, 60) - 1) < 1e-55


def test_seed_geometry_is_exact(mechanisms):
    for name in ("three_ups_upu_s", "three_ups_upu_s_physical"):
        m = mechanisms[name]
        for k in range(1, 5):
            a, c = m.points[f"A{k}"].at, m.points[f"C{k}"].at
            leg = [m.number(q - p) for p, q in zip(a, c, strict=True)]
            assert sympy.sqrt(sum(x**2 for x in leg)) == sympy.Rational(3, 5)
            axis = [m.number(x) for x in m.joints[f"limb{k}_P"].axes[0]]
            assert axis == [x / sympy.Rational(3, 5) for x in leg]
            assert axis[2] == sympy.cos(sympy.pi / 6)  # leans by 30 degrees
            inwards = m.number(axis[0] * a[0] + axis[1] * a[1])
            assert inwards == -m.number(m.parameters["R"].symbol) / 2
            assert m.joints[f"limb{k}_P"].driven == (0,)
        assert m.joints["limb5_S"].point == (0, 0, 0)
        assert [limb.joints for limb in m.limbs.values()][4] == ("limb5_S",)
        fourth, fifth = m.joints["limb1_U2"].axes
        half = sympy.Rational(1, 2)
        assert [m.number(x) for x in fourth] == [sympy.sqrt(3) / 2, 0, -half] and fifth == (0, 1, 0)


def test_seed_inertias(mechanisms):
    printed, physical = mechanisms["three_ups_upu_s"], mechanisms["three_ups_upu_s_physical"]
    for m, trace in ((printed, "2.3556"), (physical, "0.023556")):
        for k in range(1, 5):
            for part in ("lower", "upper"):
                body = m.bodies[f"limb{k}_{part}"]
                assert m.number(body.mass) == sympy.Rational("1.42")
                assert m.number(sum(body.inertia[i][i] for i in range(3))) == sympy.Rational(trace)
                leg = [m.number(x) for x in m.joints[f"limb{k}_P"].axes[0]]
                axial = sum(leg[i] * m.number(body.inertia[i][j]) * leg[j] for i in range(3) for j in range(3))
                assert sympy.expand(axial) == sympy.Rational("0.0556" if m is printed else "5.56e-4")
    assert any("bodies.platform: the radius of gyration" in text for text in printed.warnings)
    assert any("bodies.limb1_lower: the radius of gyration" in text for text in printed.warnings)
    assert physical.warnings == ()


def test_stewart_leg_lengths_against_the_reference(mechanisms):
    """Leg lengths at the initial pose of the reference problem."""
    reference = json.loads((DATA / "catalogue_facts.json").read_text())["stewart"]
    m = mechanisms["stewart_6ups"]
    a, b, c = reference["euler"]
    about_x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    about_y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    about_z = np.array([[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]])
    centre = numbers(m, m.points["E"].at)
    for k, length in enumerate(reference["lengths"], 1):
        arm = about_x @ about_y @ about_z @ (numbers(m, m.points[f"C{k}"].at) - centre)
        leg = np.array(reference["p"]) + arm - numbers(m, m.points[f"A{k}"].at)
        assert np.linalg.norm(leg) == pytest.approx(length, rel=1e-14)
        reach = numbers(m, m.points[f"C{k}"].at) - numbers(m, m.points[f"A{k}"].at)
        assert float(m.number(m.joints[f"leg{k}_P"].reference[0])) == pytest.approx(np.linalg.norm(reach), rel=1e-15)


def test_delta_rods_have_their_length(mechanisms):
    m = mechanisms["delta"]
    for k in (1, 2, 3):
        for side in "ab":
            ends = [m.joints[f"rod{k}{side}_{letter}"].point for letter in "US"]
            square = sum(m.number(q - p) ** 2 for p, q in zip(*ends, strict=True))
            assert sympy.nsimplify(sympy.expand(square)) == sympy.Rational("0.49")
            assert np.linalg.norm(numbers(m, m.joints[f"arm{k}_R"].axes[0])[:2]) == pytest.approx(1)


def test_spatial_loops_against_the_reference(mechanisms):
    facts = json.loads((DATA / "catalogue_facts.json").read_text())
    for name in ("bennett", "sarrus"):
        m = mechanisms[name]
        for joint in facts[name]:
            built = m.joints[joint["name"]]
            assert [str(x) for x in built.point] == joint["point"]
            assert [str(x) for x in built.axes[0]] == joint["axis"]
            assert (built.parent, built.child) == (joint["parent"], joint["child"])


def test_andrews_links_close(mechanisms):
    m = mechanisms["andrews"]
    place = {name: [m.number(x) for x in joint.point] for name, joint in m.joints.items()}

    def distance(a, b):
        return sympy.sqrt(sum((p - q) ** 2 for p, q in zip(place[a], place[b], strict=True)))

    exact = {("O", "F"): "0.007", ("F", "E3"): "0.028", ("A5", "G"): "0.04", ("A7", "H"): "0.04"}
    for ends, length in exact.items():
        assert distance(*ends) == sympy.Rational(length)
    closing = {("B", "E3"): "0.035", ("G", "E4"): "0.02", ("H", "E6"): "0.02"}
    for ends, length in closing.items():
        assert abs(sympy.N(distance(*ends) - sympy.Rational(length), 40)) < 1e-30
    angles = {"O": "beta", "B": "gamma", "A5": "delta", "G": "phi", "H": "omega", "A7": "epsilon"}
    for joint, angle in angles.items():
        assert m.joints[joint].reference == (m.parameters[angle].symbol,)
    beta = m.parameters["beta"].value
    assert abs(sympy.N(m.parameters["c_beta"].value - sympy.cos(beta), 40)) < 1e-31


@pytest.mark.parametrize(("name", "flange"), [("ur5", (-0.81725, -0.19145, -0.005491)), ("panda", (0.088, 0, 0.926))])
def test_arms_in_zero_configuration(mechanisms, name, flange):
    m = mechanisms[name]
    assert numbers(m, m.points["flange"].at) == pytest.approx(flange, abs=1e-15)
    # Sums of the published link masses: 3.7 + 8.393 + 2.33 + 2 x 1.219 + 0.1879, and Gaz et al. links 1 to 7.
    total = {"ur5": "17.0489", "panda": "16.062132"}[name]
    assert sum(b.mass for b in m.bodies.values() if b.mass) == sympy.Rational(total)
    assert m.source


def test_find(tmp_path):
    assert catalogue.find("ur5").name == "ur5"
    file = tmp_path / "mine.toml"
    file.write_text(to_toml(catalogue.load("four_bar")))
    assert catalogue.find(file) == catalogue.load("four_bar") == load_description(file)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        (
            "fourbar",
            "'fourbar' is neither a mechanism of the catalogue nor a .toml, .urdf, .xml or .mjcf file; "
            "did you mean 'four_bar'",
        ),
        ("nothing/here.toml", "there is no file 'nothing/here.toml'"),
        ("../../etc/passwd\0", "is neither"),
        ("", "is neither"),
        ("x" * 300, "is neither"),
        ("x" * 300 + ".toml", "there is no file"),
    ],
)
def test_find_refuses(name, message):
    with pytest.raises(DescriptionError, match=message):
        catalogue.find(name)


def test_load_refuses_paths():
    with pytest.raises(DescriptionError, match=r"the catalogue has no mechanism '../catalogue/ur5'"):
        catalogue.load("../catalogue/ur5")
