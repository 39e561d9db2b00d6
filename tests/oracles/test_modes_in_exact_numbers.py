"""Modes that no interval proves: exactly double ones, and those of overconstrained loops; against closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support.linkages import COMPLETE

import symscrew
from symscrew.assembly import AssemblyModes, mode_lines

pytestmark = pytest.mark.slow

NORMAL = [[0, 0, 1]]


def four_bar(*points: tuple[Any, Any]) -> symscrew.Mechanism:
    """Pins A, B, C, D of crank, coupler, rocker; A is driven."""
    builder = symscrew.MechanismBuilder("four_bar_of_tests", ground="ground")
    for body in ("crank", "coupler", "rocker"):
        builder.body(body)
    bodies = [("ground", "crank"), ("crank", "coupler"), ("coupler", "rocker"), ("ground", "rocker")]
    for name, (parent, child), point in zip("ABCD", bodies, points, strict=True):
        builder.joint(name, "R", parent=parent, child=child, point=[*point, 0], axes=NORMAL, driven=name == "A")
    return builder.build()


def three_rpr(base: Any, tip: Any) -> symscrew.Mechanism:
    builder = symscrew.MechanismBuilder("rpr_of_tests", ground="ground", platform="platform")
    builder.body("platform")
    for k, (a, b) in enumerate(zip(base, tip, strict=True)):
        builder.body(f"cylinder{k}")
        builder.body(f"rod{k}")
        way = [f"({q})-({p})" for p, q in zip(a, b, strict=True)]
        size = f"sqrt(({way[0]})^2+({way[1]})^2)"
        axis = [f"({c})/{size}" for c in way]
        builder.joint(f"R{k}", "R", parent="ground", child=f"cylinder{k}", point=[*a, 0], axes=NORMAL)
        builder.joint(
            f"P{k}", "P", parent=f"cylinder{k}", child=f"rod{k}", point=[*a, 0], axes=[[*axis, 0]], driven=True
        )
        builder.joint(f"T{k}", "R", parent=f"rod{k}", child="platform", point=[*b, 0], axes=NORMAL)
    return builder.build()


def only(found: AssemblyModes) -> Any:
    """The one mode, of which every solution is."""
    (mode,) = found.modes
    assert found.complete in COMPLETE and mode.certified and mode.exact
    return mode


@pytest.mark.parametrize(
    "points",
    [
        ((0.0, 0.0), (0.1, 0.7), (1.1, 0.4), (3.1, -0.2)),  # coupler and rocker in line, decimals
        (("0", "0"), ("1", "2"), ("1+sqrt(3)", "3"), ("1+3*sqrt(3)", "5")),
    ],
)
def test_a_four_bar_at_its_dead_centre_has_one_mode_that_is_two(points: Any) -> None:
    mode = only(symscrew.assembly_modes(four_bar(*points)))
    assert (mode.name, mode.meeting, mode.paths) == ("home", 2, 2) and mode.smallest < 1e-12


def test_a_dead_centre_that_the_crank_is_turned_to() -> None:
    """Pins B and D are apart by coupler and rocker, 2 + sqrt(5): by the law of cosines, with new square roots."""
    turned = "acos((9 + 16 - (2 + sqrt(5))^2)/24)"
    bars = four_bar(("0", "0"), ("3", "0"), ("3", "2"), ("4", "0"))
    mode = only(symscrew.assembly_modes(bars, {"A": turned}))
    assert mode.meeting == 2
    b, c, d = (mode.values[n] for n in "BCD")
    angle = np.arccos((25 - (2 + 5**0.5) ** 2) / 24)
    pin = 3 * np.array([np.cos(angle), np.sin(angle)])
    tip = pin + 2 * np.array([np.cos(angle + b + np.pi / 2), np.sin(angle + b + np.pi / 2)])
    assert np.allclose(tip - pin, (np.array([4, 0]) - pin) * 2 / (2 + 5**0.5), atol=1e-12)
    assert np.isclose(np.sin(b + c - d + angle), 0, atol=1e-12)
    beside = symscrew.assembly_modes(bars, {"A": f"{turned} - 1/10^9"})
    assert len(beside.modes) == 2 and not any(m.exact for m in beside.modes)
    assert not symscrew.assembly_modes(bars, {"A": f"{turned} + 1/10^9"}).modes


def test_legs_that_meet_in_a_point_are_a_double_mode() -> None:
    """In (-1, 0); with a third mode so near that both are in one circle around the end of the paths."""
    base, tip = [("10", "18"), ("-19", "-15"), ("12", "17")], [("7.8", "14.4"), ("-13.6", "-10.5"), ("2.9", "5.1")]
    found = symscrew.assembly_modes(three_rpr(base, tip))
    assert found.complete in COMPLETE and found.bound is not None and found.bound.count == 6
    assert [(m.name, m.meeting) for m in found.modes if m.exact] == [("home", 2)]
    assert sum(not m.exact for m in found.modes) == 2


@pytest.mark.slow
def test_a_delta_at_the_limit_of_its_reach_is_eight_modes_in_one() -> None:
    """All rods level: the two level modes meet, and six that are turned; 20 complex ones are left of the bound."""
    mode = only(found := symscrew.assembly_modes(symscrew.load_catalogue("delta"), at={"rods": "0.45"}))
    assert mode.meeting == 8 and found.bound is not None and found.bound.count == 28


def bennett_ratio(found: AssemblyModes) -> float:
    """tan(J1 / 2) and tan(J2 / 2), counted from where links are in line, have one ratio in a Bennett linkage."""
    (mode,) = found.modes
    assert found.complete in COMPLETE and mode.certified and abs(mode.values["J1"] + mode.values["J3"]) % np.pi < 1e-9
    return float(mode.values["J2"])


def test_bennett_is_proved_in_exact_numbers_and_by_its_motion() -> None:
    """At a part of a turn by exact numbers, at a fraction [rad] by the proved motion through the reference."""
    bennett = symscrew.load_catalogue("bennett")
    exact, led = (symscrew.assembly_modes(bennett, {"J1": drive}) for drive in ("pi/10", "0.3141592653589793"))
    assert exact.modes[0].exact and not led.modes[0].exact
    assert abs(bennett_ratio(exact) - bennett_ratio(led)) < 1e-9


def test_every_regular_mode_of_sarrus_is_proved() -> None:
    """The platform at one height, held in two ways by the limb that is not driven; folded legs turn without end."""
    found = symscrew.assembly_modes(symscrew.load_catalogue("sarrus"))
    (mode,) = found.modes
    assert found.complete == "regular" and mode.exact and mode.ways == 2
    assert found.bound is not None and found.bound.count == 2 and "without end" in found.why
    assert found.account.count("real") == found.account.paths == 1  # to the other one no path leads
    assert "1 path: 1 to real solutions; to 1 further solution Newton's method from random places" in mode_lines(found)
