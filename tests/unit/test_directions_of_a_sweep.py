"""When a grid of tilts and azimuths may speak of every direction."""

from __future__ import annotations

import numpy as np
import pytest

import symscrew
from symscrew.studies.workspace import Axis, Plan, all_around, sweep_summary, sweep_summary_text

DEG = np.pi / 180


def plan_over(tilts: tuple[float, float, int], azimuths: tuple[float, float, int]) -> Plan:
    (low, high, count), (first, last, number) = tilts, azimuths
    over = Axis("tilt", low * DEG, high * DEG, count), Axis("azimuth", first * DEG, last * DEG, number)
    return Plan(symscrew.load_catalogue("three_ups_upu_s"), (), over)


@pytest.mark.parametrize(
    "tilts, azimuths, every",
    [
        ((0, 10, 3), (0, 360, 9), True),
        ((0, 10, 3), (-180, 180, 9), True),
        ((0, 10, 3), (0, 315, 8), True),  # its last step closes the turn
        ((0, 10, 3), (0, 240, 3), True),
        ((-10, 10, 5), (0, 180, 5), True),  # tilts of both signs look at the opposite azimuths
        ((0, 10, 3), (0, 90, 4), False),
        ((0, 10, 3), (0, 180, 5), False),
        ((0, 10, 3), (0, 300, 11), False),  # 60 degrees are missing, a step has 30
        ((0, 10, 3), (0, 360, 2), False),  # the same direction twice
        ((0, 10, 3), (0, 360, 3), False),  # two opposite ones
        ((0, 10, 3), (0, 0, 1), False),
        ((-10, 10, 5), (0, 90, 3), False),
        ((-5, 10, 4), (0, 180, 5), False),
        ((5, 10, 3), (0, 360, 9), False),  # limits may be passed below
    ],
)
def test_only_what_goes_all_around_says_so(
    tilts: tuple[float, float, int], azimuths: tuple[float, float, int], every: bool
) -> None:
    plan = plan_over(tilts, azimuths)
    assert all_around(plan) is every
    ones = np.ones(plan.count)
    found = sweep_summary(plan, {"reached": ones, "regular": ones, "allowed": ones}, {})
    assert ("every_direction" in found["tilt"]) is every
    assert ("reached in every direction" in sweep_summary_text(found)) is every


@pytest.mark.parametrize(
    "tilts, failed, reach",
    [
        ((0, 10, 3), (), 10),
        ((0, 10, 3), (2,), 5),
        ((0, 10, 3), (0,), None),  # not even upright, which counted as a tilt of 0 reached
        ((0, 10, 3), (1,), 0),
        ((-10, 10, 5), (3,), 0),  # +5 degrees fails: -5 alone counted as 5 degrees in every direction
        ((-10, 10, 5), (1,), 0),
        ((-10, 10, 5), (0, 4), 5),
        ((-10, 10, 5), (2,), None),
    ],
)
def test_a_tilt_is_reached_where_all_up_to_it_are_allowed(
    tilts: tuple[float, float, int], failed: tuple[int, ...], reach: float | None
) -> None:
    """At one azimuth the tilts of these numbers are not allowed."""
    plan = plan_over(tilts, (0, 180, 5) if tilts[0] < 0 else (0, 360, 9))
    allowed = np.ones((plan.axes[0].count, plan.axes[1].count))
    allowed[list(failed), 1] = 0
    found = sweep_summary(plan, {"reached": allowed * 0 + 1, "regular": allowed, "allowed": allowed.ravel()}, {})
    every = found["tilt"]["every_direction"]
    assert (every is None) is (reach is None) and (reach is None or abs(every - reach * DEG) < 1e-12)
    said = "not even upright is allowed at azimuth 45 deg" if reach is None else f"tilt of {reach} degrees reached in"
    assert said in sweep_summary_text(found)
