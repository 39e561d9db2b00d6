"""All assembly modes against numbers of others, against elimination, and of singular and movable platforms."""

from __future__ import annotations

import numpy as np
import pytest
from support.platforms import SHIFT, hexapod, lengths, planar_3rpr, published, three_rps

import symscrew
from symscrew.assembly import AssemblyModes, follow_mode

Array = np.ndarray


def farthest(found: AssemblyModes, modes: list[dict], shift: Array) -> float:
    """The largest distance of a published posture from the nearest mode; the reference stands at `shift`."""
    worst = 0.0
    for known in modes:
        q = np.array([float(c) for c in known["quaternion_wxyz"]])
        t = np.array([float(c) for c in known["translation"]])
        worst = max(worst, min(
            min(np.abs(m.quaternion - q).max(), np.abs(m.quaternion + q).max())
            + np.abs(m.translation + m.rotation @ shift - t).max() for m in found.modes
        ))  # fmt: skip
    return worst


@pytest.mark.slow
def test_all_forty_postures_of_dietmaier_are_found_and_proved_to_be_all():
    given = published("dietmaier_1998_40_postures")
    mechanism = hexapod(given["base_points"], given["platform_points"])
    found = symscrew.assembly_modes(mechanism, lengths(given["leg_lengths"]))
    assert found.bound is not None and found.bound.count == len(found.modes) == given["real_solutions"] == 40
    assert found.complete == "bounded" and all(mode.certified for mode in found.modes)
    assert farthest(found, given["assembly_modes"], np.array([float(c) for c in SHIFT])) < 1e-12
    assert max(mode.residual for mode in found.modes) < 1e-13


@pytest.mark.slow
def test_the_modes_of_linuxcncs_hexapod_are_eight_of_sixteen_solutions():
    given = published("linuxcnc_genhexkins")
    shift = ("3.1", "-1.7", "21.3")
    mechanism = hexapod(given["base_points"], given["platform_points"], shift)
    one = given["cases"][3]
    found = symscrew.assembly_modes(mechanism, lengths(one["leg_lengths"]))
    assert found.bound is not None and found.bound.count == one["finite_complex_solutions"] == 16
    assert len(found.modes) == one["real_solutions"]
    assert farthest(found, one["assembly_modes"], np.array([float(c) for c in shift])) < 1e-12
    assert found.complete == "bounded" and max(mode.residual for mode in found.modes) < 1e-13


def by_elimination(base: Array, platform: Array, squares: Array) -> Array:
    """Angles of a planar 3-RPR: the position is linear in differences, what is left is a polynomial in tan(a/2)."""

    def left(tangent: complex) -> complex:
        c, s = (1 - tangent**2) / (1 + tangent**2), 2 * tangent / (1 + tangent**2)
        turned = platform @ np.array([[c, s], [-s, c]])
        u = turned - base  # |x + u|^2 = squares
        rows = 2 * (u[1:] - u[0])
        right = squares[1:] - squares[0] - (u[1:] ** 2).sum(axis=1) + (u[0] ** 2).sum()
        determinant = rows[0, 0] * rows[1, 1] - rows[0, 1] * rows[1, 0]
        x = np.array([right[0] * rows[1, 1] - right[1] * rows[0, 1], rows[0, 0] * right[1] - rows[1, 0] * right[0]])
        return ((x + determinant * u[0]) ** 2).sum() - squares[0] * determinant**2

    # (1 + t^2)^4 times this has degree 8 with (1 + t^2) as a factor: sampled on the unit circle, where it is smooth
    nodes = 2.0 * np.exp(2j * np.pi * np.arange(16) / 16)
    values = np.array([left(t) * (1 + t**2) ** 4 for t in nodes])
    coefficients = np.fft.fft(values) / 16 / 2.0 ** np.arange(16)
    roots = np.roots(coefficients[8::-1].real)
    real = roots[(np.abs(roots.imag) < 1e-7)].real
    return np.sort(2 * np.arctan(real))


def test_planar_platforms_have_the_modes_that_elimination_finds():
    random = np.random.default_rng(2)
    base = np.array([[0, 0], [2, 0], [1, 2]]) + random.uniform(-0.3, 0.3, (3, 2)).round(3)
    platform = np.array([[0, 0], [1, 0], [0.4, 0.8]]) + random.uniform(-0.2, 0.2, (3, 2)).round(3)
    legs = random.uniform(1.0, 1.6, 3).round(3)
    found = symscrew.assembly_modes(planar_3rpr(base.tolist(), platform.tolist()), lengths(legs.tolist()))
    angles = np.sort([np.arctan2(m.rotation[1, 0], m.rotation[0, 0]) for m in found.modes])
    expected = by_elimination(base, platform, legs**2)
    assert found.bound is not None and found.bound.count == 6 and found.complete == "proved"
    assert angles.shape == expected.shape and np.abs(angles - expected).max(initial=0.0) < 1e-6


def test_merlets_planar_platform_has_two_modes():
    given = published("alias_planar_3rpr")
    found = symscrew.assembly_modes(
        planar_3rpr(given["base_points"], given["platform_points"]),
        lengths([f"sqrt({c})" for c in given["squared_lengths"]]),
    )
    shift = np.array([0.3, 1.1, 0.0])
    seen = sorted([*(m.translation + m.rotation @ shift)[:2], np.arctan2(m.rotation[1, 0], m.rotation[0, 0])]
                  for m in found.modes)  # fmt: skip
    assert found.complete == "proved"
    assert np.allclose(seen, given["own_computation"]["solutions"], atol=1e-12)


@pytest.mark.slow
def test_two_modes_that_meet_are_reported_as_a_double_one():
    # all three circles touch: legs on one line with the platform turned by nothing, the middle of a change of mode
    base, platform = [["0", "0"], ["4", "0"], ["1", "3"]], [["0", "0"], ["1", "0"], ["0", "1"]]
    mechanism = planar_3rpr(base, platform)
    # the platform at (1, 0) unturned: leg lines meet where its legs 1 and 2 lie on one line and leg 3 goes through it
    found = symscrew.assembly_modes(mechanism, lengths(["1", "2", "2"]))
    double = [m for m in found.modes if m.paths > 1 or m.smallest < 1e-6]
    assert double and not any(m.certified for m in double)
    place = double[0].translation + double[0].rotation @ np.array([0.3, 1.1, 0.0])
    assert np.abs(place - [1, 0, 0]).max() < 1e-5


@pytest.mark.slow
def test_a_platform_like_its_base_with_legs_alike_moves_and_is_said_to():
    corners = [["0", "0"], ["2", "0"], ["0.5", "1.5"]]
    found = symscrew.assembly_modes(planar_3rpr(corners, corners), lengths(["1", "1", "1"]))
    assert found.curves == 4 and found.complete == "tracked"  # four of six: a circle of translations, twice over
    assert all(mode.certified for mode in found.modes)  # the other two are isolated
    assert len(found.modes) == 2


@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("four_bar", 2),
        ("five_bar", 2),
        ("slider_crank", 2),
        ("andrews", 4),
        pytest.param("planar_3rrr", 2, marks=pytest.mark.slow),
        pytest.param("three_ups_upu_s", 1, marks=pytest.mark.slow),
    ],
)
def test_mechanisms_of_the_catalogue_have_their_known_modes(name, count):
    found = symscrew.assembly_modes(symscrew.load_catalogue(name))
    assert len(found.modes) == count and found.modes[0].name == "home"
    assert all(mode.certified and mode.residual < 1e-12 for mode in found.modes)
    assert np.abs(found.modes[0].rotation - np.eye(3)).max() < 1e-12
    assert found.complete == "proved"


@pytest.mark.slow
def test_a_mode_is_led_on_and_refused_where_it_ends():
    base, platform = [[0, 0], [2, 0], [1, 2]], [[0, 0], [1, 0], ["0.4", "0.8"]]
    mechanism = planar_3rpr(base, platform, ("0.7", "0.2"))
    start = symscrew.assembly_modes(mechanism)
    longer, shorter = start.held["leg1"] + 0.05, start.held["leg1"] - 0.15
    led = follow_mode(start, "home", {"leg1": longer})
    assert led.reached == 1.0 and not led.refused and led.residual < 1e-13
    refused = follow_mode(start, "home", {"leg1": shorter})  # there the modes have met and are gone
    assert refused.refused and 0.0 < refused.reached < 1.0 and refused.smallest < 0.01
    corners = (np.array([[float(c) for c in point] for point in points]) for points in (base, platform))
    assert not len(by_elimination(*corners, np.array([shorter, start.held["leg2"], start.held["leg3"]]) ** 2))


def test_a_mode_that_is_led_arrives_at_the_mode_of_its_name():
    mechanism = symscrew.load_catalogue("four_bar")
    start = symscrew.assembly_modes(mechanism)
    end = symscrew.assembly_modes(mechanism, {"A": 0.2})
    for name in ("home", "-1"):
        led = follow_mode(start, name, {"A": 0.2})
        assert led.reached == 1.0 and led.held == {"A": pytest.approx(0.2)}
        assert np.abs(led.q - end.mode(name).q).max() < 1e-9


def by_many_starts(corners: Array, tips: Array, height: float, legs: Array) -> Array:
    """Tips of a 3-RPS by Newton's method for the three angles of its legs from 300 starts: N x 9, one of each."""
    along = tips - corners
    along = along / np.linalg.norm(along, axis=1, keepdims=True)
    ends = np.column_stack([tips, np.full(3, height)])
    pairs = [(0, 1), (1, 2), (2, 0)]
    squares = np.array([((ends[i] - ends[j]) ** 2).sum() for i, j in pairs])

    def places(angles: Array) -> tuple[Array, Array]:
        c, s = np.cos(angles)[..., None], np.sin(angles)[..., None]
        flat = np.concatenate([along, np.zeros((3, 1))], axis=1)
        up = np.array([0.0, 0.0, 1.0])
        start = np.concatenate([corners, np.zeros((3, 1))], axis=1)
        return start + legs[:, None] * (c * flat + s * up), legs[:, None] * (c * up - s * flat)

    angles = np.random.default_rng(0).uniform(-np.pi, np.pi, (300, 3))
    for _ in range(60):
        at, rate = places(angles)
        left = np.stack([((at[:, i] - at[:, j]) ** 2).sum(axis=1) for i, j in pairs], axis=1) - squares
        slopes = np.zeros((len(angles), 3, 3))
        for row, (i, j) in enumerate(pairs):
            slopes[:, row, i] = 2 * ((at[:, i] - at[:, j]) * rate[:, i]).sum(axis=1)
            slopes[:, row, j] = -2 * ((at[:, i] - at[:, j]) * rate[:, j]).sum(axis=1)
        step = (np.linalg.pinv(slopes) @ left[..., None])[..., 0]
        angles = angles - step * np.minimum(1.0, 0.5 / np.maximum(np.abs(step).max(axis=1), 1e-300))[:, None]
    at = places(angles[np.abs(left).max(axis=1) < 1e-12])[0].reshape(-1, 9)
    return np.unique(at.round(6), axis=0)


@pytest.mark.slow
def test_a_3_rps_has_the_modes_that_newton_finds_from_many_starts():
    corners = np.array([[1.0, 0.0], [-0.5, 0.8], [-0.6, -0.9]])
    tips = np.array([[0.5, 0.1], [-0.25, 0.5], [-0.4, -0.4]])
    found = symscrew.assembly_modes(three_rps(corners.tolist(), tips.tolist(), "0.9"))
    assert found.complete == "proved" and found.bound is not None and found.bound.count == 16
    ends = np.column_stack([tips, np.full(3, 0.9)])
    legs = np.linalg.norm(ends - np.column_stack([corners, np.zeros(3)]), axis=1)
    expected = by_many_starts(corners, tips, 0.9, legs)
    got = np.array([(ends @ m.rotation.T + m.translation).ravel() for m in found.modes])
    assert len(got) == len(expected) >= 4
    assert all(np.abs(expected - row).max(axis=1).min() < 1e-5 for row in got)
