"""Random robots through the targets that run here, at hostile states: numbers, statuses and NaN of the evaluator."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.marks import slow
from support.random_robots import CLOSED, IN_MJCF, random_robot
from support.target_sweep import differences, row_differences

from symscrew.model import Model, derive

FORMS = ("two", "polynomial", "three")
QUICK = ("casadi", "numpy", "javascript", "st")


def robot(seed: int, kinds: tuple[str, ...]) -> Model:
    made = random_robot(seed, kinds, forms=(FORMS[seed % 3],))
    return derive(made.mechanism, made.effects)


SOME = ("body_poses", "closure", "assemble", "velocity", "forward_dynamics", "coupling_forces", "constraint_margin")


@pytest.mark.parametrize(
    ("seed", "kinds", "targets"),
    [(2, IN_MJCF, QUICK), slow(3, CLOSED, ("numpy", "rust", "cuda"))],
)
def test_targets_of_random_robots(seed: int, kinds: tuple[str, ...], targets: tuple[str, ...], tmp_path: Path) -> None:
    pytest.importorskip("tree_sitter_iec61131_3_st", reason="needs the extra 'plc'")
    assert differences(robot(seed, kinds).only(SOME), targets, tmp_path, seed=seed) == []


def test_what_the_sweep_sees() -> None:
    """Another status, another number in one row beside a large one, and NaN in place of a number."""
    found = robot(2, IN_MJCF).only(["mass_matrix"])
    (given,) = found("mass_matrix", *found.test_inputs["mass_matrix"])[:1]
    arrays, status = given, np.zeros(len(given[0]), dtype=int)
    large = arrays[0].copy()
    large[0] *= 1e12
    off, lost = large.copy(), large.copy()
    off[1] *= 1 + 1e-10
    lost[1, 0] = np.nan
    for other, codes, said in ((large, status + 5, "status 5"), (off, status, "row 1: 1.0e-10"), (lost, status, "inf")):
        assert said in " ".join(row_differences(found, "mass_matrix", ((large,), status), ((other,), codes)))
    assert not list(row_differences(found, "mass_matrix", ((large,), status), ((large,), status)))
