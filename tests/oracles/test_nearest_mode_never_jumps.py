"""Random motions of the nearest mode in C against small steps by points alone: accepted steps are on the branch."""

from __future__ import annotations

import numpy as np
import pytest
from support import rods_followed
from support.platforms import planar_3rpr

import symscrew
from symscrew.assembly import CompiledModes, compiled_modes, modes_model, print_modes

pytestmark = pytest.mark.slow

BASE, PLATFORM, SHIFT = (
    [[0, 0], ["1.7", "0.3"], ["0.4", "1.9"]],
    [[0, 0], ["0.9", "0.1"], ["0.35", "0.75"]],
    (0.55, 0.35),
)
REFUSED = 101


def rods_of(name: str) -> tuple[symscrew.Mechanism, rods_followed.Rods]:
    if name == "delta":
        return symscrew.load_catalogue(name), rods_followed.delta()
    base, tips = (np.c_[np.array(p, dtype=float), np.zeros(3)] for p in (BASE, PLATFORM))
    rods = rods_followed.Rods(lambda d: (base, d), tips + np.array([*SHIFT, 0]), planar=True)
    return planar_3rpr(BASE, PLATFORM, tuple(map(str, SHIFT))), rods


def pose(mode) -> tuple[np.ndarray, np.ndarray]:
    return np.array(mode.pose[:9]).reshape(3, 3).T, np.array(mode.pose[9:])


def walked(compiled: CompiledModes, rods: rods_followed.Rods, seed: int) -> tuple[int, int]:
    """(accepted, refused) steps of a walk: of all sizes, along singular directions, whole turns, and back."""
    random = np.random.default_rng(seed)
    drives = start = np.array([d[1] for d in compiled.model.drives])
    slides = any(d[3] for d in compiled.model.drives)
    _, modes = compiled.modes(start)
    mode, accepted, refused = modes[random.integers(len(modes))], 0, 0
    for step in range(24):
        size = 10 ** random.uniform(-4, 0.1 if slides else 0.5)
        way = random.normal(size=len(drives)) / len(drives) ** 0.5
        goal = drives + size * way
        if step % 4 == 1:
            goal = drives + size * random.choice([-1, 1]) * rods.worst(*pose(mode), drives)
        elif step % 4 == 2:
            goal = start + 0.1 * way
        elif step % 8 == 3 and not slides:
            goal = drives + 2 * np.pi * np.eye(len(drives))[random.integers(len(drives))]
        before, kept = pose(mode), bytes(mode)
        if compiled.led(mode, goal) != 0:
            assert bytes(mode) == kept
            refused += 1
            continue
        turn, shift, whole = rods.follow(*before, drives, goal)
        assert whole and max(np.abs(pose(mode)[0] - turn).max(), np.abs(pose(mode)[1] - shift).max()) < 1e-7
        again = type(mode).from_buffer_copy(bytes(mode))
        if compiled.led(again, drives) == 0:
            assert max(np.abs(a - b).max() for a, b in zip(pose(again), before, strict=True)) < 1e-7
        drives, accepted = goal, accepted + 1
    return accepted, refused


@pytest.mark.parametrize("name", ["planar_3rpr", "delta"])
def test_accepted_steps_are_on_the_branch_that_small_steps_follow(name, tmp_path):
    mechanism, rods = rods_of(name)
    model = modes_model(mechanism)
    for file, text in print_modes(model).items():
        (tmp_path / file).write_text(text)
    compiled = compiled_modes(model, tmp_path, ["-O0"])
    totals = np.sum([walked(compiled, rods, seed) for seed in range(2)], axis=0)
    assert totals.min() > 1  # of both kinds
