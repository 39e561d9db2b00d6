"""C of modes of loops that close by the axis of a hinge: against Newton's method on exponentials of the screws."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.linkages import by_many_starts, single_loop

from oracles.test_modes_of_linkages import SEVEN, TURNS
from symscrew import Mechanism
from symscrew.assembly import CompiledModes, compiled_modes, modes_model, print_modes
from symscrew.assembly.mode_signs import ModeSigns
from symscrew.mobility import ClosureVariety

pytestmark = pytest.mark.slow

OK, REFUSED = 0, 101
LOOPS = {
    "RCCC": lambda: single_loop("RCCC", SEVEN[:4], TURNS[:4]),
    "spherical": lambda: single_loop("RRRR", [[0, 0, 0]] * 4, TURNS[:4]),
    "7R": lambda: single_loop("RRRRRRR", SEVEN, TURNS),
}


def written(mechanism: Mechanism, folder: Path) -> CompiledModes:
    model = modes_model(mechanism)
    for file, text in print_modes(model).items():
        (folder / file).write_text(text)
    return compiled_modes(model, folder, ["-O0"])


def held(compiled: CompiledModes, drive: float) -> dict[int, float]:
    """Column -> displacement from the reference."""
    return {compiled.model.held.chosen[0]: drive - compiled.model.drives[0][1]}


def turn_of(compiled: CompiledModes, q: np.ndarray) -> np.ndarray:
    model = compiled.model
    rotation, shift = (
        ModeSigns(model.held.network, model.held.mechanism, model.held.chosen).look(q).pose(model.held.body)
    )
    return np.concatenate([rotation.T.ravel(), shift])


def followed(compiled: CompiledModes, q: np.ndarray, goal: float) -> np.ndarray:
    """Newton's method in small steps of the drive."""
    variety = ClosureVariety(compiled.model.held.network)
    (column,) = compiled.model.held.chosen
    free = [c for c in range(variety.columns) if c != column]
    for value in np.linspace(q[column], goal - compiled.model.drives[0][1], 40)[1:]:
        q = q.copy()
        q[column] = value
        for _ in range(4):
            left, slopes = variety.evaluate(q[None])
            q[free] -= np.linalg.lstsq(slopes[0][:, free], left[0], rcond=None)[0]
    return q


def walked(compiled: CompiledModes, mode: Any, q: np.ndarray, random: np.random.Generator) -> tuple[int, int]:
    """(accepted, refused) steps of a walk."""
    drive, counts = mode.drives[0], [0, 0]
    for _ in range(8):
        goal, kept = drive + random.normal() * 10 ** random.uniform(-2, 0.4), bytes(mode)
        status = compiled.led(mode, [goal])
        counts[status != OK] += 1
        if status != OK:
            assert status == REFUSED and bytes(mode) == kept
            continue
        q, drive = followed(compiled, q, goal), goal
        assert np.abs(np.array(mode.pose) - turn_of(compiled, q)).max() < 1e-7
    return counts[0], counts[1]


@pytest.mark.parametrize("name", ["RCCC", *(pytest.param(n, marks=pytest.mark.slow) for n in ("spherical", "7R"))])
def test_all_modes_and_steps_along_one_of_loops_that_a_hinge_closes(name: str, tmp_path: Path) -> None:
    mechanism = LOOPS[name]()
    compiled, random, steps = written(mechanism, tmp_path), np.random.default_rng(3), np.zeros(2, dtype=int)
    status, modes = compiled.modes([0.2])
    known = by_many_starts(mechanism, held(compiled, 0.2), 100)
    places = np.array([turn_of(compiled, q) for q in known])
    assert status == OK and len(modes) == len(known) and all(m.certified and m.error < 1e-9 for m in modes)
    for mode in modes:
        off = np.abs(places - np.array(mode.pose)).max(axis=1, initial=0.0)
        assert off.min() < 1e-8
        steps += walked(compiled, mode, known[int(off.argmin())], random)
    assert steps[0] > 3
    if name == "7R":  # Lee and Liang 1988: a polynomial of degree 16
        start = compiled.model.start
        assert start.bound is not None and start.bound.count == 16 == len(start.zeros)
        # at -0.3 a path takes 430 steps, at -2.135 one comes to a singular place on the straight way
        for drive, count in ((0.2, 4), (-0.3, 4), (-2.135042323682198, 0), (1.521, 0)):
            status, modes = compiled.modes([drive])
            assert (status, len(modes)) == (OK, count) and all(mode.certified for mode in modes)
