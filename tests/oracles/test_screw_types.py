"""R, H and T of systems of screws, against the rotations (screws of pitch zero) that are found in them one by one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support.analysed import analysed
from support.further_mechanisms import loop

from symscrew.mobility import analyse_mobility, mobility_text, mobility_values, screw_class

SWAPPED = np.roll(np.eye(6), 3, axis=0)
Array = np.ndarray[Any, Any]


def turned_without_pitch(basis: Array, random: np.random.Generator) -> int:
    """Dimension of the angular velocities of a system's screws of pitch zero: zeros of the reciprocal form."""
    values, vectors = np.linalg.eigh(basis @ SWAPPED @ basis.T)
    ahead, behind, none = (vectors[:, chosen] for chosen in (values > 1e-9, values < -1e-9, abs(values) <= 1e-9))
    found = [*none.T]
    for _ in range(40 if ahead.shape[1] and behind.shape[1] else 0):
        a, b, c = (part @ random.normal(size=part.shape[1]) for part in (ahead, behind, none))
        b *= np.sqrt(-_square(a, basis) / _square(b, basis))
        found += [a + b + c, a - b + c]
    turns = np.array([(x @ basis)[:3] for x in found]).reshape(-1, 3)
    return int(np.linalg.matrix_rank(turns, tol=1e-7)) if len(turns) else 0


def _square(x: Array, basis: Array) -> float:
    screw = x @ basis
    return float(screw @ SWAPPED @ screw)


def test_freedoms_are_rotations_where_rotations_span_them() -> None:
    random = np.random.default_rng(22)
    seen = set()
    for _ in range(400):
        given = random.integers(-1, 2, size=(int(random.integers(1, 6)), 6)).astype(float)
        given[1 if random.random() < 0.5 else len(given) :, :3] = 0  # translations among them
        _, s, vt = np.linalg.svd(given)
        basis = vt[: int((s > 1e-9).sum())]
        found = screw_class(given, 1.3)
        assert found.rotations - found.helical == (turned_without_pitch(basis, random) if len(basis) else 0), given
        seen.add(found.motion_type)
    assert {"1H", "1R1H", "2H", "1H1T", "1H2T", "2R", "1R1T", "1R2T", "1R3T"} <= seen


def test_a_coupler_that_screws_is_not_said_to_turn() -> None:
    bennett = analysed("bennett")
    assert (bennett.platform.type, bennett.platform.motion_type) == ("1R", "1H")  # a direction; and what moves about it
    text, values = mobility_text(bennett), mobility_values(bennett)
    assert "type 1H, H being a screw motion" in text and "l2 1H, 1-system of class IIA" in text and "1R" not in text
    assert values["platform"]["motion_type"] == values["branch_table"]["branches"][0]["platform"]["motion_type"] == "1H"
    assert analysed("rssr").platform.motion_type == "1R" and "H being" not in mobility_text(analysed("rssr"))


@pytest.mark.parametrize(
    "kinds, pitches, group",
    [
        ("RRRR", (), "G, planar"),
        ("HHHH", (2, 2, 2, 2), "Y, planar with a pitch"),
        ("HHHH", (2, 2, 2, 1), "X, Schoenflies"),
        ("HPHP", (2, 0, 2, 0), "Y, planar with a pitch"),
    ],
)
def test_groups_with_a_pitch_are_told_from_those_without(kinds: str, pitches: tuple[int, ...], group: str) -> None:
    """J. M. Herve 1978: screws of one pitch along parallel axes and translations across them make the group Y."""
    points, along = ([0, 0, 0], [1, 0, 0], [1, 2, 0], [-1, 2, 0]), {"P": [1, 2, 0]}
    joints = [(kind, point, along.get(kind, [0, 0, 1])) for kind, point in zip(kinds, points, strict=True)]
    made = analyse_mobility(loop(*joints, pitches=dict(enumerate(pitches))))
    assert [one.group for one in made.counts.loops] == [group]
