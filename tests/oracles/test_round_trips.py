"""Robots at random, written as MJCF and URDF and read again: the same mechanism, scene and numbers; MuJoCo's, too.

What a file does not hold is named by whoever writes it, and the rest is what comes back.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from benchmarks.robot_engines import with_mujoco, with_pinocchio
from support.random_robots import CLOSED, IN_MJCF, IN_URDF, random_robot

from symscrew.description import MechanismBuilder
from symscrew.effects import effect_from_table, effects_of_file, forces_of_effects
from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, difference, mjcf_effects, urdf_effects
from symscrew.model import Model, derive
from symscrew.scene import load_robot, save_robot

EXACT, RAISED = 1e-10, 1e-6  # of numbers; where bodies got 1e-9 of the mass
HELD = {".xml": mjcf_effects.held, ".urdf": urdf_effects.held}


def apart(one: Model, other: Model) -> float:
    """The largest relative difference of mass matrix, bias and accelerations, ports by their labels."""
    q, v, _ = one.system.states(3, 1)
    random, worst = np.random.default_rng(1), 0.0
    for name in ("mass_matrix", "bias", "forward_dynamics"):
        programs = one.programs[name], other.programs[name]
        given = {}
        for port in programs[0].inputs:
            values = {"q": q, "v": v}.get(port.name)
            values = random.uniform(-2, 2, (len(q), len(port.labels))) if values is None else values
            given[port.name] = dict(zip(port.labels, values.T, strict=True))
        found = []
        for model, program in zip((one, other), programs, strict=True):
            ports = [np.array([given[p.name][x] for x in p.labels]).reshape(-1, len(q)).T for p in program.inputs]
            (values, *_), status = model(name, *ports)
            assert not np.any(status)
            by_label = zip(program.outputs[0].labels, np.reshape(values, (len(q), -1)).T, strict=True)
            found.append(np.array([column for _, column in sorted(by_label, key=lambda pair: pair[0])]))
        worst = max(worst, float(np.abs(found[0] - found[1]).max() / max(np.abs(found[0]).max(), 1e-9)))
    return worst


CASES = [
    (IN_MJCF, ".xml", 6), (IN_MJCF, ".xml", 8), (IN_URDF, ".urdf", 2), (IN_URDF, ".urdf", 5), (CLOSED, ".xml", 4),
]  # fmt: skip


@pytest.mark.parametrize(("kinds", "suffix", "seed"), CASES)
def test_robots_come_back(tmp_path: Path, kinds: tuple[str, ...], suffix: str, seed: int) -> None:
    path = tmp_path / f"robot{suffix}"
    given = random_robot(seed, kinds, forms=("two",) if suffix == ".urdf" else ("two", "three", "polynomial"))
    mechanism = given.mechanism
    forces, field, others = forces_of_effects(mechanism, given.effects)
    kept = HELD[suffix](mechanism, forces)
    left = [f"{f['kind']} of {f['joint']}" for f in forces if f not in kept]
    unusual = suffix == ".urdf" and tuple(field) != (0, 0, -9.81)
    if left or unusual:
        with pytest.raises(DescriptionError, match="does not hold"):
            save_robot(mechanism, path, given.effects, limits=given.limits)
    said = save_robot(mechanism, path, given.effects, limits=given.limits, accept=True)
    assert not others and said == [*left, *([f"gravity {field}"] if unusual else [])]
    again = load_robot(path)
    assert difference(mechanism, again.mechanism) is None and not again.account.influence
    for joint, limits in given.limits.items():
        found = again.limits[joint]
        assert (found.lower, found.upper) == (limits.lower, limits.upper)
        assert limits.effort in (None, found.effort)
    effects = effects_of_file(kept, None if unusual else field)
    raised = "raised to" in path.read_text()
    assert apart(derive(mechanism, effects), derive(again.mechanism, again.effects)) < (RAISED if raised else EXACT)
    engine = with_pinocchio if suffix == ".urdf" else with_mujoco
    assert engine(path, ImportOptions())[0] < 1e-9
