"""Names of coordinates and values as they are typed: units, notices, turns in every form, and what was meant."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy
from scipy.spatial.transform import Rotation

from symscrew import catalogue
from symscrew.algebra import CONTEXT
from symscrew.description import given_value
from symscrew.errors import DescriptionError
from symscrew.kinematics import (
    angle_notices,
    coordinate_units,
    full_name,
    given_coordinates,
    half_turn,
    nearest_names,
    pose_rates,
    pose_read,
    pose_rows,
    quaternion_entry,
    tree_label,
)

HEXAPOD = "stewart_6ups"


class Doubles:
    """NumPy under the names that poses use."""

    sqrt, atan2 = np.sqrt, np.arctan2


@pytest.mark.parametrize(
    "text, value, unit",
    [
        ("10mm", sympy.Rational(1, 100), "m"), ("-2.5e1 cm", sympy.Rational(-1, 4), "m"),
        ("30deg", sympy.pi / 6, "rad"),
        ("pi/6 rad", sympy.pi / 6, "rad"), ("2 N m/deg", 360 / sympy.pi, "N m/rad"),
        ("1e-3", sympy.Rational(1, 1000), ""), ("1e6", sympy.Integer(10**6), ""),
        ("sqrt(3)/5", sympy.sqrt(3) / 5, ""), (".5", sympy.Rational(1, 2), ""), (0.25, sympy.Rational(1, 4), ""),
    ],
)  # fmt: skip
def test_values_are_read_with_their_units(text: object, value: sympy.Expr, unit: str) -> None:
    found = given_value(text)
    assert found.unit == unit and sympy.simplify(found.value - value) == 0


@pytest.mark.parametrize("text", ["10furlong", "30deg deg x", "mm", "1/0", "", "2 R", "__import__('os')"])
def test_what_is_no_value_is_refused(text: str) -> None:
    with pytest.raises(DescriptionError):
        given_value(text, {"R": sympy.Integer(1)})


def test_a_unit_of_another_kind_and_a_coordinate_given_twice_are_refused() -> None:
    mechanism = catalogue.load(HEXAPOD)
    for given, text in (
        ({"platform.z": "30deg"}, r"at platform\.z: expected a length \[m, mm\], got one in rad"),
        ({"tilt": "30mm"}, r"at tilt: expected an angle \[rad, deg\], got one in m"),
        ({"leg5_S.qy": "5deg"}, r"at leg5_S\.qy: expected a number without unit, got one in rad"),
        ({"tilt": "acos(2)"}, r"at tilt: expected a real finite number, got 'acos\(2\)'"),
        ({"z": 0, "platform.z": 0}, r"platform\.z is given twice"),
        ({"rx": 0, "turn": "1deg about 1,0,0"}, r"platform\.rx is given twice"),
        ({"turn": "30deg"}, "an angle about an axis such as"),
        ({"turn": "30deg about 0,0,0"}, "an angle about an axis such as"),
        ({"turn": "30mm about 0,0,1"}, "expected an angle"),
    ):
        with pytest.raises(DescriptionError, match=text):
            given_coordinates(mechanism, given)


def test_bare_angles_beyond_half_a_turn_are_noticed_and_others_not() -> None:
    mechanism = catalogue.load(HEXAPOD)
    given = {"tilt": "30", "leg1_U.0": -7, "platform.roll": "3.1", "yaw": "30deg", "z": 30, "leg1_P": "400"}
    assert angle_notices(mechanism, given) == [
        "tilt is in rad: 30 are 1719 degrees; 30deg are 30 degrees",
        "leg1_U.0 is in rad: -7 are -401 degrees; -7deg are -7 degrees",
    ]


@pytest.mark.parametrize(
    "typed, meant",
    [
        ("leg5 S.qy", "leg5_S.qy"), ("Leg5_s.rx", "leg5_S.rx"), ("limb5_S.qy", "leg5_S.qy"),
        ("platfrm.z", "platform.z"),
        ("platform_z", "platform.z"), ("leg3U.1", "leg3_U.1"), ("platform.tlt", "platform.tilt"),
    ],
)  # fmt: skip
def test_the_name_that_was_meant_is_found(typed: str, meant: str) -> None:
    assert meant in nearest_names(typed, coordinate_units(catalogue.load(HEXAPOD)))


def test_an_entry_of_a_quaternion_says_what_it_is_in_degrees() -> None:
    assert quaternion_entry("leg5_S.qy", 0.05) == "an entry of a quaternion: alone, a turn by 5.73 deg about y"
    assert quaternion_entry("leg5_S.ry", 0.05) == quaternion_entry("leg5_S.qy", 1.5) == ""


def test_poses_in_every_form_are_what_another_library_says() -> None:
    """Roll, pitch, yaw and rotation vectors by SciPy; a tilt about (cos a, sin a, 0) after a torsion about z by it."""
    random = np.random.default_rng(5)
    turns = Rotation.from_rotvec(random.normal(size=(50, 3)))
    r = np.moveaxis(turns.as_matrix(), 0, -1)
    read = pose_read(r, random.normal(size=(3, 50)), Doubles())
    assert np.allclose([read["rx"], read["ry"], read["rz"]], turns.as_rotvec().T, atol=1e-12)
    assert np.allclose([read["roll"], read["pitch"], read["yaw"]], turns.as_euler("xyz").T, atol=1e-12)
    axis = np.array([np.cos(read["azimuth"]), np.sin(read["azimuth"]), 0 * read["tilt"]])
    made = Rotation.from_rotvec((read["tilt"] * axis).T) * Rotation.from_euler("z", read["torsion"][:, None])
    assert np.allclose(made.as_matrix(), turns.as_matrix(), atol=1e-12)


def test_rows_of_a_pose_are_zero_at_what_is_read_from_it() -> None:
    """In sixty digits, for whole poses given in each of the three ways; elsewhere a row is not."""
    for vector in ((0.3, -0.2, 0.5), (0.0, 0.0, 0.0), (0.0, 1e-8, 0.0)):
        r = [[CONTEXT.mpf(c) for c in row] for row in Rotation.from_rotvec(vector).as_matrix()]
        t = [CONTEXT.mpf(c) for c in (0.1, 0.2, -0.3)]
        read = pose_read(r, t, CONTEXT)
        for parts in (("roll", "pitch", "yaw"), ("rx", "ry", "rz"), ("tilt", "azimuth", "torsion"), ("x", "y", "z")):
            rows = pose_rows({p: read[p] for p in parts}, CONTEXT, CONTEXT.tan)
            assert len(rows) == 3 and all(abs(row.of(r, t) - row.goal) < 1e-15 for row in rows)
            other = [
                [CONTEXT.mpf(c) for c in row] for row in Rotation.from_rotvec((vector[0] + 0.1, 0.1, 0.2)).as_matrix()
            ]
            assert max(abs(row.of(other, [2 * c for c in t]) - row.goal) for row in rows) > 1e-3
    for given, text in (({"azimuth": 1.0}, "give the tilt too"), ({"tilt": 3.2}, "less than half a turn")):
        with pytest.raises(DescriptionError, match=text):
            pose_rows(given, CONTEXT, CONTEXT.tan)


@pytest.mark.parametrize("size", [0.0, 1e-12, 1e-3, 1.0, 3.0])
def test_rates_of_poses_are_slopes_along_the_motion(size: float) -> None:
    """Against central differences, of every part; an upright body's tilt and azimuth have none."""
    random, step = np.random.default_rng(2), 1e-6
    vector, t, omega, velocity = (random.normal(size=3) for _ in range(4))
    turn = Rotation.from_rotvec(size * vector / np.linalg.norm(vector))

    def read(time: float) -> dict[str, float]:
        r = (Rotation.from_rotvec(time * omega) * turn).as_matrix()
        parts = dict(zip(("qx", "qy", "qz"), half_turn(r, Doubles()), strict=True))
        return parts | pose_read(r, t + time * velocity, Doubles())

    rates = pose_rates(turn.as_matrix(), t, np.stack([omega, 2 * omega]), np.stack([velocity, 2 * velocity]))
    before, after = read(-step), read(step)
    lost = {part for part, rate in rates.items() if not np.isfinite(rate).all()}
    assert lost == ({"tilt", "azimuth"} if size < 1e-10 else set()) and set(rates) == set(after)
    for part in set(rates) - lost - ({"tilt", "azimuth"} if size < 1e-2 else set()):
        slope = (after[part] - before[part]) / (2 * step)
        assert rates[part] == pytest.approx([slope, 2 * slope], rel=1e-7, abs=1e-8), part


@pytest.mark.parametrize(("name", "typed", "label"), [
    ("delta", "z", "platform_pose.2"), ("delta", "platform.x", "platform_pose.0"), ("delta", "qy", "platform_pose.qy"),
    ("planar_3rrr", "y", "platform_pose.1"), ("planar_3rrr", "yaw", "platform_pose.2"), ("delta", "arm2_R", "arm2_R"),
    ("planar_3rrr", "rz", "platform_pose.2"), ("planar_3rrr", "z", ""), ("delta", "tilt", ""), ("delta", "rx", ""),
    ("four_bar", "x", ""),
])  # fmt: skip
def test_names_of_coordinates_of_the_tree(name: str, typed: str, label: str) -> None:
    mechanism = catalogue.load(name)
    labels = ["arm2_R", *(f"platform_pose.{part}" for part in ("0", "1", "2", "qx", "qy", "qz"))]
    if label:
        assert tree_label(mechanism, labels, typed) == label
    else:
        with pytest.raises(DescriptionError, match=f"expected labels of q among arm2_R, .*, got '{typed}'"):
            tree_label(mechanism, labels, typed)


def test_columns_of_runs_are_names_of_coordinates() -> None:
    """`q.joint`, as a run's columns are called, is `joint` wherever a name is typed, but for an owner called `q`."""
    mechanism = catalogue.load("four_bar")
    assert full_name(mechanism, "q.A") == "A"
    assert full_name(mechanism, "q.x") == full_name(mechanism, "x") == full_name(mechanism, "platform.x") == "rocker.x"
    assert given_coordinates(mechanism, {"q.A": "20deg"}) == given_coordinates(mechanism, {"A": "20deg"})
    with pytest.raises(DescriptionError, match="A is given twice"):
        given_coordinates(mechanism, {"q.A": "20deg", "A": "20deg"})
    own = replace(mechanism, joints={**mechanism.joints, "q": replace(mechanism.joints["A"], name="q")})
    assert full_name(own, "q.x") == "q.x"
