"""Paths that a singular place on the way stops: they are no ends, and another way gets past it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.linkages import joined
from support.platforms import hexapod

import symscrew
from symscrew.assembly import target_roots as target
from symscrew.assembly.all_modes import known_zero, structure_of
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.families import AllNumbers
from symscrew.assembly.start_system import StartSystem, searched, start_system
from symscrew.assembly.what_is_held import held_by

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


BASE = [["0.571", "0.028", "0.005"], ["0.573", "-0.072", "0.005"], ["-0.42", "0.476", "0.052"],
        ["-0.338", "0.534", "0.052"], ["-0.281", "-0.564", "0.056"], ["-0.367", "-0.512", "0.056"]]  # fmt: skip
TIPS = [["0.119", "0.051", "-0.728"], ["0.121", "-0.049", "-0.728"], ["-0.111", "0.068", "-0.663"],
        ["-0.029", "0.126", "-0.663"], ["-0.019", "-0.129", "-0.693"], ["-0.105", "-0.077", "-0.693"]]  # fmt: skip


def test_a_path_that_passes_infinity_before_its_end_does_not_end_there(monkeypatch: pytest.MonkeyPatch) -> None:
    """The ninth of forty stops far out on one way, with more of it left than those have that end at infinity."""
    held = held_by(hexapod(BASE, TIPS, ("0", "0", "0")), {}, {})
    family = AllNumbers(BatchEquations(structure_of(held)))
    start = start_system(family, known_zero(family.equations))
    start = replace(start, zeros=start.zeros[8:9])
    monkeypatch.setattr(target, "BENDS", (-0.4, 0.8))
    found = target.target_roots(family, start, family.member({}))
    assert (found.count("infinity"), found.count("lost"), found.again) == (0, 0, 1)
    monkeypatch.setattr(target, "PASSING", 1.0)
    assert target.target_roots(family, start, family.member({})).count("infinity") == 1
