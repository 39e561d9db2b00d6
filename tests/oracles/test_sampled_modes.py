"""Operation modes that random configurations show, against publications; the same in another place and unit."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support.further_mechanisms import CASES
from support.marks import slow
from support.parallel_mechanisms import snu
from support.reference_mechanisms import ENTRIES, build

from symscrew.description.mechanism import Mechanism
from symscrew.mobility.components import SampledModes, mode_lines, mode_values, sampled_modes
from symscrew.mobility.components.mode_sampling import _null, _pairs
from symscrew.mobility.joint_network import network_of


def mechanism(name: str) -> Mechanism:
    return snu() if name == "snu" else build(ENTRIES[name])


@cache
def modes(name: str) -> SampledModes:
    made = mechanism(name)
    assert made.platform is not None
    return sampled_modes(network_of(made), made.platform)


@pytest.mark.parametrize(
    "name, expected",
    [
        # Hunt 1978: the plate goes up and down; with the plate on the base both knees turn about its hinges
        ("sarrus", [(2, 0, True), (1, 1, True)]),
        # Kim and Tsai 2002; Gosselin and Kong 2002: translations only
        slow("tripteron_cpm", [(3, 3, True)]),
        # Schadlbauer, Walter and Husty 2014
        slow("3rps", [(3, 3, "x0"), (3, 3, "x3")]),
    ],
)
def test_published_modes(name: str, expected: list[tuple[int, int, object]]) -> None:
    found = modes(name)
    assert [(m.dimension, m.poses) for m in found.modes] == [e[:2] for e in expected]
    for mode, (_, _, linear) in zip(found.modes, expected, strict=True):
        if isinstance(linear, str):
            assert " ".join(mode.equations) == linear
    assert sum(mode.count for mode in found.modes) > found.found / 2


@pytest.mark.slow
def test_modes_of_the_3_upu_of_seoul() -> None:
    """Walter, Husty and Pfurner 2009: translations upright and half a turn about the vertical, planar ones, others."""
    found = modes("snu")
    assert {(m.dimension, m.poses) for m in found.modes if m.count > 1} == {(3, 3)}
    assert {("x1", "x2", "x3", "y0"), ("x0", "x1", "x2", "y3")} <= {m.equations for m in found.modes}


def test_forms_that_are_small_where_a_walk_stays_do_not_vanish() -> None:
    """On a small patch of a surface quadrics are as small as 1e-9, and none vanishes but the one that makes it."""
    random = np.random.default_rng(3)
    patch = np.zeros((60, 8))
    patch[:, 0] = 1.0
    patch[:, 1:3] = 5e-2 * random.uniform(-1, 1, size=(60, 2))
    patch[:, 3] = patch[:, 1] ** 3 + patch[:, 2] ** 3 + patch[:, 1] * patch[:, 2]
    patch[:, 4] = -(patch[:, 1:4] ** 2).sum(axis=1)
    monomials = _pairs(patch)
    values = np.linalg.svd(monomials, compute_uv=False)
    assert 1e-12 < values[13] / values[0] < 1e-7  # of 15 monomials in five unknowns
    assert len(_null(monomials)) == 36 - 15 + 1


def test_in_words_and_json() -> None:
    found = modes("sarrus")
    lines, values = mode_lines(found), mode_values(found)
    assert "sampled" in lines[0] and "others may be missing" in lines[0] and len(lines) == 3
    assert values["judgement"] == "sampled" and [m["dimension"] for m in values["modes"]] == [2, 1]


@slow
def test_configurations_that_cannot_move_are_no_modes_and_no_error() -> None:
    """A bar to the centre of curvature of a coupler point's path stops a four-bar: all its configurations are alone."""
    made = CASES["coupler point"].make()
    found = sampled_modes(network_of(made), "coupler")
    assert found.found > 10 and not found.modes
