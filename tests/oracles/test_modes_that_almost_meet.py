"""Two modes that almost meet are two, or none, as closed forms of a five-bar in many digits say."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from support.linkages import COMPLETE

import symscrew

pytestmark = pytest.mark.slow

DIGITS = mpmath.mp.clone()
DIGITS.dps = 60


def five_bar() -> symscrew.Mechanism:
    """Cranks of length 1 at (0, 0) and (2, 0), couplers of 1/2 that meet above (1, 4/5)."""
    builder = symscrew.MechanismBuilder("five_bar_of_tests", ground="ground")
    for body in ("left", "right", "first", "second"):
        builder.body(body)
    pins = {
        "A": ("ground", "left", ["0", "0", "0"]), "B": ("ground", "right", ["2", "0", "0"]),
        "C": ("left", "first", ["3/5", "4/5", "0"]), "D": ("right", "second", ["7/5", "4/5", "0"]),
        "E": ("first", "second", ["1", "11/10", "0"]),
    }  # fmt: skip
    for name, (parent, child, point) in pins.items():
        driven = name in "AB"
        builder.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 0, 1]], driven=driven)
    return builder.build()


def stretched() -> mpmath.mpf:
    """The right crank at which the pins of the couplers are 1 apart: 2.8 cos - 1.6 sin = -2.6, from 126.87 degrees."""
    m = DIGITS
    phase, size = m.atan2(m.mpf("1.6"), m.mpf("2.8")), m.sqrt(m.mpf("2.8") ** 2 + m.mpf("1.6") ** 2)
    return m.acos(m.mpf("-2.6") / size) - phase - m.atan2(m.mpf("0.8"), m.mpf("-0.6"))


def between(turn: mpmath.mpf) -> mpmath.mpf:
    """The angle between both ways to hold the first coupler, 2 acos(d) with d the distance of pins; 0: none."""
    m = DIGITS
    angle = turn + m.atan2(m.mpf("0.8"), m.mpf("-0.6"))
    d = m.hypot(2 + m.cos(angle) - m.mpf("0.6"), m.sin(angle) - m.mpf("0.8"))
    return 2 * m.acos(d) if d < 1 else m.mpf(0)


@pytest.mark.parametrize(
    "gap", [*(pytest.param(f"1e-{k}", marks=pytest.mark.slow) for k in (2, 4, 6, 8, 9, 10, 14)), "1e-12"]
)
def test_both_sides_of_a_stretched_elbow(gap):
    seen = []
    for sign in (1, -1):
        turn = stretched() + sign * DIGITS.mpf(gap)
        found = symscrew.assembly_modes(five_bar(), {"B": DIGITS.nstr(turn, 55)})
        apart = between(turn)
        assert found.complete in COMPLETE and all(m.certified and m.paths == m.ways == 1 for m in found.modes)
        assert len(found.modes) == (2 if apart else 0) and len({m.name for m in found.modes}) == len(found.modes)
        if apart:
            one, two = (m.values["C"] for m in found.modes)
            assert np.isclose(abs(one - two), float(apart), rtol=1e-6, atol=1e-14)
            assert max(m.radius for m in found.modes) < float(apart)
        seen.append(len(found.modes))
    assert sorted(seen) == [0, 2]


def test_a_stretched_elbow_is_one_mode_without_a_certificate():
    found = symscrew.assembly_modes(five_bar(), {"B": DIGITS.nstr(stretched(), 58)})
    (mode,) = found.modes
    assert mode.paths == 2 and not mode.certified and found.complete == "tracked"
