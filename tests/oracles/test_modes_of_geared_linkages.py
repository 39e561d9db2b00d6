"""Assembly modes of mechanisms whose coordinates are coupled, against circles that are cut by hand."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.linkages import COMPLETE

import symscrew
from symscrew.assembly import AssemblyMode, CompiledModes, compiled_modes, follow_mode, modes_model, print_modes

CRANKS = ((0.0, 0.0), (1.2, 0.0))
ELBOWS = ((-0.1, 0.6), (1.1, 0.5))
TIP = (0.5, 1.3)


def geared_five_bar(terms: dict[str, Any], driven: str = "A") -> symscrew.Mechanism:
    """Two cranks A and B about y, coupled, with rods that meet at D."""
    builder = symscrew.MechanismBuilder("geared_five_bar")
    for body in ("left", "right", "rod", "other"):
        builder.body(body)
    ends = {"A": ("base", "left", CRANKS[0]), "B": ("base", "right", CRANKS[1]), "C": ("left", "rod", ELBOWS[0]),
            "E": ("right", "other", ELBOWS[1]), "D": ("rod", "other", TIP)}  # fmt: skip
    for name, (parent, child, (x, z)) in ends.items():
        builder.joint(name, "R", parent=parent, child=child, point=[x, 0, z], axes=[[0, 1, 0]], driven=name in driven)
    return builder.coupling("gears", terms=terms).build()


def tips(a: float, b: float) -> list[tuple[float, float]]:
    """Where the rods meet, with the cranks at these angles: two circles."""
    one, two = (_turned(elbow, crank, angle) for elbow, crank, angle in zip(ELBOWS, CRANKS, (a, b), strict=True))
    radii = [math.dist(TIP, elbow) for elbow in ELBOWS]
    gap = math.dist(one, two)
    along = (radii[0] ** 2 - radii[1] ** 2 + gap**2) / (2 * gap)
    if abs(along) > radii[0]:
        return []
    aside = math.sqrt(radii[0] ** 2 - along**2)
    x, z = (two[0] - one[0]) / gap, (two[1] - one[1]) / gap
    return [(one[0] + along * x + side * aside * z, one[1] + along * z - side * aside * x) for side in (1, -1)]


def _turned(point: tuple[float, float], centre: tuple[float, float], angle: float) -> tuple[float, float]:
    """About y, which takes z to x."""
    x, z, c, s = point[0] - centre[0], point[1] - centre[1], math.cos(angle), math.sin(angle)
    return centre[0] + c * x + s * z, centre[1] - s * x + c * z


def tip_of(mode: AssemblyMode) -> tuple[float, float]:
    turn, shift = mode.poses["rod"]
    place = turn @ np.array([TIP[0], 0, TIP[1]]) + shift
    return float(place[0]), float(place[2])


@pytest.mark.parametrize(
    ("terms", "follower", "drive"),
    [
        ({"A": 30, "B": 20}, lambda a: -1.5 * a, 2.0),
        ({"A": 1, "B": "-1/3"}, lambda a: 3 * a, -0.7),
        ({"A": ["1", "1/5"], "B": 1}, lambda a: -a - a * a / 5, 0.3),
        ({"A": "sqrt(2)", "B": 1}, lambda a: -math.sqrt(2) * a, -0.7),
    ],
)
def test_cranks_with_gears_have_the_modes_of_two_circles(terms, follower, drive):
    found = symscrew.assembly_modes(geared_five_bar(terms), {"A": drive})
    wanted = tips(drive, follower(drive))
    assert found.complete in COMPLETE and len(found.modes) == len(wanted)
    for tip in wanted:
        assert min(math.dist(tip, tip_of(mode)) for mode in found.modes) < 1e-12
    assert all(mode.certified and abs(mode.values["B"] - follower(drive)) < 1e-12 for mode in found.modes)


def test_a_mode_is_led_along_a_polynomial_coupling():
    start = symscrew.assembly_modes(geared_five_bar({"A": ["1", "1"], "B": 1}), {"A": "-0.6"})
    led = follow_mode(start, "home", {"A": "-0.4"})  # B has the same value at both ends, and another one between
    assert led.reached == 1.0 and not led.refused and led.held == pytest.approx({"A": -0.4})
    again = symscrew.assembly_modes(start.mechanism, {"A": "-0.4"}).mode("home")
    assert np.abs(led.q - again.q).max() < 1e-9


@pytest.mark.parametrize(
    ("name", "drives", "values"),
    [
        ("gear_train", {"input": 0.4}, {"middle": -0.1, "output": 1 / 30}),
        ("differential", {"A": 0.4}, {"B": 0.0, "C": 0.2, "D": 0.3}),
        ("differential", {"A": 40.0, "B": "-40"}, {"C": 0.0, "D": 60.0}),
    ],
)
def test_gears_alone_have_one_mode(name, drives, values):
    (mode,) = symscrew.assembly_modes(symscrew.load_catalogue(name), drives).modes
    assert mode.residual < 1e-15
    assert all(abs(mode.values[key] - value) < 1e-14 for key, value in values.items())


@pytest.mark.parametrize(
    ("ratio", "at", "why"),
    [
        ("sqrt(2)", {"C": 0.2}, "the coupling gears ties A and B, which nothing held settles"),
        (1, {"A": 0.2, "B": 0.3}, "the coupling gears does not hold with these values of A and B"),
    ],
)
def test_what_couplings_leave_open_or_contradict_is_refused(ratio, at, why):
    with pytest.raises(symscrew.DescriptionError, match=why):
        symscrew.assembly_modes(geared_five_bar({"A": ratio, "B": 1}), at=at)


def test_what_is_held_is_said_by_name_whatever_its_order():
    mechanism = symscrew.load_catalogue("five_bar")
    one, two = (name for name, joint in mechanism.joints.items() if joint.driven)
    start = symscrew.assembly_modes(mechanism, at={two: "1/10", one: "-1/20"})
    led = follow_mode(start, start.modes[0].name, {one: "-1/10"})
    assert led.reached == 1.0 and led.held == {one: -0.1, two: 0.1}
    assert {name: led.q[c] for name, c in zip(led.held, start.columns, strict=True)} == pytest.approx(led.held)


@pytest.mark.slow
def test_a_way_of_several_turns_keeps_the_name():
    four_bar = symscrew.load_catalogue("four_bar")
    found, again = (symscrew.assembly_modes(four_bar, {"A": value}) for value in ("-12*pi + pi/3", "pi/3"))
    assert [m.name for m in found.modes] == [m.name for m in again.modes]
    assert all(m.certified for m in found.modes) and found.modes[0].name == "home"


def written(mechanism: symscrew.Mechanism, folder: Path) -> CompiledModes:
    model = modes_model(mechanism)
    for file, text in print_modes(model).items():
        (folder / file).write_text(text)
    return compiled_modes(model, folder, ["-O0"])


def test_c_takes_what_couplings_settle_along_its_motions_as_well(tmp_path):
    """B = - A - A^2: modes are those of the circles; led from A = -0.6 to -0.4 B turns back on the way."""
    compiled = written(geared_five_bar({"A": ["1", "1"], "B": 1}), tmp_path)
    assert [name for name, *_ in compiled.model.drives] == ["A"]
    assert "A [rad]. Couplings settle B." in (tmp_path / "geared_five_bar_modes.h").read_text()

    def tip(mode: Any) -> tuple[float, float]:
        place = np.array(mode.pose[:9]).reshape(3, 3).T @ np.array([TIP[0], 0, TIP[1]]) + np.array(mode.pose[9:])
        return float(place[0]), float(place[2])

    counts = set()
    for a in (-3.0, -2.7, -0.6, 0.0, 0.45, 2.5):
        wanted, (status, modes) = tips(a, -a - a * a), compiled.modes([a])
        assert status == 0 and len(modes) == len(wanted) and all(mode.certified for mode in modes)
        assert compiled.model.held.body in ("rod", "other")
        for one in wanted:
            assert min(math.dist(one, tip(mode)) for mode in modes) < 1e-12
        counts.add(len(modes))
    assert counts == {0, 2}
    start = compiled.modes([-0.6])[1]
    for mode in start:
        before = tip(mode)
        for a in np.linspace(-0.6, -0.4, 9)[1:]:
            assert compiled.led(mode, [a]) == 0
            assert math.dist(tip(mode), before) < 0.1
            before = tip(mode)
            assert min(math.dist(one, before) for one in tips(a, -a - a * a)) < 1e-12


def test_c_of_drives_that_a_coupling_ties_is_refused():
    with pytest.raises(symscrew.DescriptionError, match="the coupling gears ties its arguments"):
        modes_model(geared_five_bar({"A": 1, "B": 1}, driven="AB"))
