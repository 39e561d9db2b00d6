"""Paths that a singular place on the way stops: they are no ends, and another way gets past it."""

from __future__ import annotations

import numpy as np
import pytest
from support.linkages import joined

import symscrew
from symscrew.assembly import target_roots as target
from symscrew.assembly.all_modes import known_zero
from symscrew.assembly.start_system import StartSystem, searched

pytestmark = pytest.mark.slow

SHORT = [
    ("R", "ground", "a", ["0", "0"], None), ("R", "a", "b", ["1", "0"], None), ("R", "b", "c", ["2", "1.5"], None),
    ("R", "c", "ground", ["4.2", "0"], None),
]  # fmt: skip
"""A four-bar whose crank cannot turn all round: at half a turn its two modes are complex."""


def test_two_paths_that_meet_on_the_way_are_led_around(monkeypatch: pytest.MonkeyPatch) -> None:
    """Straight from a real crank angle to one out of reach both stop where they meet, and one more way is enough."""
    found = symscrew.assembly_modes(joined(SHORT))
    assert len(found.modes) == 2 and found.family is not None
    zeros = np.array([mode.z for mode in found.modes], dtype=complex)
    start = StartSystem(tuple(found.family.member({})), zeros, found.bound)
    column = found.chosen[0]
    there = target.target_roots(found.family, start, found.family.member({column: 3.0}))
    assert (there.count("complex"), there.count("lost"), there.again) == (2, 0, 1)
    one, two = (end.z for end in there.ends)
    assert abs(np.vdot(one, np.conj(two))) > (1 - 1e-9) * np.linalg.norm(one) * np.linalg.norm(two)
    monkeypatch.setattr(target, "BENDS", (0.0,))
    straight = target.target_roots(found.family, start, found.family.member({column: 3.0}))
    assert (straight.count("complex"), straight.count("lost")) == (0, 2)


def test_a_start_system_is_found_from_a_singular_reference() -> None:
    """With the rocker held at its dead centre no path leads away: Newton's method finds a general member's zero."""
    ends = [["0", "0"], ["1", "0"], ["3", "0"], ["2.5", "-2"]]
    stretched = joined([(*edge[:3], end, None) for edge, end in zip(SHORT, ends, strict=True)])
    found = symscrew.assembly_modes(stretched, at={"j3": "0.2"})
    assert len(found.modes) in (0, 2) and found.family is not None
    other = symscrew.assembly_modes(stretched, at={"j3": "-0.2"})
    assert {len(found.modes), len(other.modes)} == {0, 2}
    start = searched(found.family, known_zero(found.family.equations))
    assert start.bound is not None and len(start.zeros) == start.bound.count == 2
