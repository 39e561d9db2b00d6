"""Modes of mechanisms whose couplings tie what is free: against zeros of one function along the gears' common turn."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.linkages import COMPLETE

import symscrew
from oracles.test_modes_of_geared_linkages import CRANKS, ELBOWS, TIP, geared_five_bar, tip_of, written
from symscrew.assembly import follow_mode

Place = tuple[float, float]


def turned(point: Place, centre: Place, angle: float) -> Place:
    """About y, which takes z to x."""
    x, z, c, s = point[0] - centre[0], point[1] - centre[1], math.cos(angle), math.sin(angle)
    return centre[0] + c * x + s * z, centre[1] - s * x + c * z


def zeros_of(function: Callable[[float], float]) -> list[float]:
    """Of a function of period two pi, by signs and bisection."""
    places = np.linspace(0, 2 * np.pi, 4001) + 0.123456  # no mode lies on one
    values = [function(t) for t in places]
    found = []
    for a, b, u, v in zip(places, places[1:], values, values[1:], strict=False):
        if u * v < 0:
            for _ in range(60):
                middle = (a + b) / 2
                a, b = (middle, b) if function(middle) * u > 0 else (a, middle)
            found.append((a + b) / 2)
    return found


def tips(a: float, p: int, q: int, known: float = 0.0) -> list[Place]:
    """Where the rods meet with the left crank at `a` and p C + q E = known (p and q have no common factor)."""
    bezout = next((i, j) for i in range(abs(q) + 1) for j in range(-abs(p), abs(p) + 1) if i * p + j * q == 1)

    def tip(t: float) -> Place:
        return turned(turned(TIP, ELBOWS[0], q * t + bezout[0] * known), CRANKS[0], a)

    def off(t: float) -> float:
        there = turned(TIP, ELBOWS[1], bezout[1] * known - p * t)
        return math.dist(tip(t), CRANKS[1]) - math.dist(there, CRANKS[1])

    return [tip(t) for t in zeros_of(off)]


@pytest.mark.parametrize(
    ("terms", "p", "q", "known"),
    [
        ({"C": 1, "E": 1}, 1, 1, 0.0),
        ({"C": 30, "E": -20}, 3, -2, 0.0),
        ({"C": "sqrt(2)", "E": "-3*sqrt(2)"}, 1, -3, 0.0),
        ({"C": 2, "E": 1, "A": "1/2"}, 2, 1, -0.2),
        ({"C": 1, "E": 2, "A": ["1", "1"]}, 1, 2, -0.56),
    ],
)
def test_gears_that_turn_freely_have_the_modes_of_their_common_turn(terms: Any, p: int, q: int, known: float) -> None:
    found = symscrew.assembly_modes(geared_five_bar(terms), {"A": "2/5"})
    wanted = tips(0.4, p, q, known)
    assert found.complete in COMPLETE and len(found.modes) == len(wanted) > 0
    for tip in wanted:
        assert min(math.dist(tip, tip_of(mode)) for mode in found.modes) < 1e-9
    for mode in found.modes:  # as they are counted, not up to whole turns
        assert mode.certified and mode.residual < 1e-13
        assert abs(p * mode.values["C"] + q * mode.values["E"] - known) < 1e-13


def test_a_mode_of_gears_is_led_and_arrives_at_the_mode_of_its_name() -> None:
    mechanism = geared_five_bar({"C": 3, "E": -2, "A": 1})
    start, goal = (symscrew.assembly_modes(mechanism, {"A": a}) for a in (0, "1/5"))
    led = follow_mode(start, "home", {"A": "1/5"})
    assert led.reached == 1.0 and np.abs(led.q - goal.mode("home").q).max() < 1e-9


def test_c_of_gears_that_turn_freely(tmp_path: Path) -> None:
    compiled = written(geared_five_bar({"C": 3, "E": -2, "A": 1}), tmp_path)
    assert [name for name, *_ in compiled.model.drives] == ["A"]

    def tip(mode: Any) -> Place:
        turn = np.array(mode.pose[:9]).reshape(3, 3).T
        place = turn @ np.array([TIP[0], 0, TIP[1]]) + np.array(mode.pose[9:])
        return float(place[0]), float(place[2])

    for a in (0.0, 0.5, -1.0, 2.0):
        wanted, (status, modes) = tips(a, 3, -2, -a), compiled.modes([a])
        assert status == 0 and len(modes) == len(wanted) and all(mode.certified for mode in modes)
        for one in wanted:
            assert min(math.dist(one, tip(mode)) for mode in modes) < 1e-9
    _, (mode, *_) = compiled.modes([0.0])
    for a in np.linspace(0.0, 0.3, 7)[1:]:
        assert compiled.led(mode, [a]) == 0
        assert min(math.dist(one, tip(mode)) for one in tips(a, 3, -2, -a)) < 1e-9


def test_couplings_of_the_same_angles_hold_at_once() -> None:
    """2 B + C = 0 and C = 2 E leave B = t, C = -2 t, E = -t, not E = pi - t as well, whose sums are whole turns too."""
    points = [(0.0, 0.0), (-0.5, 0.8), (0.1, 1.5), (0.9, 1.6), (1.4, 0.8), (1.0, 0.0)]
    builder = symscrew.MechanismBuilder("six_bar")
    for k in range(1, 6):
        builder.body(f"b{k}")
    for k, (x, z) in enumerate(points):
        ends = ("base", "b5") if k == 5 else (f"b{k}" if k else "base", f"b{k + 1}")
        builder.joint("ABCDEF"[k], "R", parent=ends[0], child=ends[1], point=[str(x), 0, str(z)], axes=[[0, 1, 0]],
                      driven=k == 0)  # fmt: skip
    builder.coupling("one", terms={"B": 2, "C": 1}).coupling("two", terms={"C": 1, "E": -2})
    found = symscrew.assembly_modes(builder.build(), {"A": "1/10"})

    def off(t: float) -> float:
        there = points[3]
        for centre, angle in zip(points[2::-1], (-2 * t, t, 0.1), strict=True):
            there = turned(there, centre, angle)
        return math.dist(there, points[5]) - math.dist(turned(points[3], points[4], t), points[5])

    wanted = zeros_of(off)
    assert found.complete in COMPLETE and len(found.modes) == len(wanted) == 2
    for mode in found.modes:
        b, c, e = (mode.values[name] for name in "BCE")
        assert abs(2 * b + c) + abs(c - 2 * e) < 1e-12
        assert min(abs(math.remainder(b - t, 2 * np.pi)) for t in wanted) < 1e-9


def test_a_wheel_that_hangs_on_a_gear_has_a_mode_for_each_tooth_of_the_ratio() -> None:
    builder = symscrew.MechanismBuilder("wheel")
    for body in ("crank", "rod", "rocker", "wheel"):
        builder.body(body)
    for name, parent, child, (x, z) in (
        ("A", "base", "crank", (0, 0)), ("B", "crank", "rod", (-0.2, 0.7)), ("C", "rod", "rocker", (1.1, 0.9)),
        ("D", "base", "rocker", (1, 0)), ("W", "rod", "wheel", (0.5, 1)),
    ):  # fmt: skip
        builder.joint(name, "R", parent=parent, child=child, point=[str(x), 0, str(z)], axes=[[0, 1, 0]],
                      driven=name == "A")  # fmt: skip
    found = symscrew.assembly_modes(builder.coupling("gears", terms={"W": 2, "B": -3}).build(), {"A": "1/5"})
    angles = sorted((round(math.remainder(m.values["B"], 2 * np.pi), 9), m.values["W"]) for m in found.modes)
    assert found.complete in COMPLETE and [a[0] for a in angles] == [angles[0][0]] * 2 + [angles[2][0]] * 2
    for (_, one), (_, two) in (angles[:2], angles[2:]):
        assert abs(math.remainder(one - two - np.pi, 2 * np.pi)) < 1e-9


def test_slides_that_a_coupling_ties() -> None:
    """Rods from a slide along x and one along z = x / 3 that meet; the angle of the first is held."""
    builder = symscrew.MechanismBuilder("slides")
    for body in ("left", "right", "rod", "other"):
        builder.body(body)
    foot, head, tip = ("0", "0"), ("1", "1/5"), ("3/5", "4/5")
    for name, kind, parent, child, (x, z), axis in (
        ("X", "P", "base", "left", foot, [1, 0, 0]), ("Z", "P", "base", "right", head, [0, 0, 1]),
        ("A", "R", "left", "rod", foot, [0, 1, 0]), ("B", "R", "right", "other", head, [0, 1, 0]),
        ("T", "R", "rod", "other", tip, [0, 1, 0]),
    ):  # fmt: skip
        builder.joint(name, kind, parent=parent, child=child, point=[x, 0, z], axes=[axis], driven=name == "A")
    found = symscrew.assembly_modes(builder.coupling("rack", terms={"X": 1, "Z": -3}).build(), {"A": "3/10"})
    x, z = turned((0.6, 0.8), (0.0, 0.0), 0.3)  # (x + 3 s - 1)^2 + (z - 1/5 - s)^2 = 0.4^2 + 0.6^2
    roots = np.roots([10, 6 * (x - 1) - 2 * (z - 0.2), (x - 1) ** 2 + (z - 0.2) ** 2 - 0.52]).real
    assert found.complete in COMPLETE and len(found.modes) == 2
    assert np.allclose(sorted(m.values["Z"] for m in found.modes), np.sort(roots), atol=1e-12)
    assert all(m.certified and abs(m.values["X"] - 3 * m.values["Z"]) < 1e-13 for m in found.modes)


@pytest.mark.parametrize(
    ("terms", "why"),
    [
        ({"C": 1, "E": "sqrt(2)"}, "ratio that is no fraction have no polynomials; hold C"),
        ({"C": 1, "E": ["1", "1"]}, "a power of what is free has no polynomials here"),
        ({"C": 41, "E": 1}, "42 turns together are more than 40"),
        ({"B": 1, "C": 1, "D": 1, "E": 1}, "ties all joints of a loop"),
    ],
)
def test_what_is_not_algebraic_is_refused(terms: Any, why: str) -> None:
    with pytest.raises(symscrew.DescriptionError, match=why):
        symscrew.assembly_modes(geared_five_bar(terms), {"A": "2/5"})
