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


CASES = [(IN_MJCF, ".xml", 3), (IN_MJCF, ".xml", 11), (IN_URDF, ".urdf", 3), (IN_URDF, ".urdf", 6), (CLOSED, ".xml", 8)]


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


def ball_and_bar() -> MechanismBuilder:
    """A ball on the ground, and a bar that hangs on it and on the ground in a loop with a slide."""
    made = MechanismBuilder("loop")
    for k, name in enumerate(("one", "two", "three")):
        made.body(name, mass=1, com=[f"{k}/5", "1/10", 0], inertia=["1/50", "1/40", "1/60"])
    made.joint("S", "S", parent="base", child="one", point=[0, 0, 0])
    made.joint("A", "R", parent="base", child="two", point=["1/2", 0, 0], axes=[[0, 1, 0]], driven=True)
    made.joint("B", "R", parent="two", child="three", point=["1/2", 0, "1/2"], axes=[[0, 1, 0]])
    made.joint("C", "P", parent="base", child="three", point=["3/2", 0, 0], axes=[[1, 0, 0]], driven=True)
    return made


@pytest.mark.parametrize("levels", [(0.0, 0.4, 0.0), (0.4, 0.0, 0.0), (0.4, 0.4, 0.5), (0.4, 0.4, 0.4)])
def test_a_ball_has_one_friction_in_an_mjcf(tmp_path: Path, levels: tuple[float, ...]) -> None:
    """One that differs from freedom to freedom is left out and named, not dropped or taken for all."""
    tables = [{"freedom": k, "coulomb": level} for k, level in enumerate(levels) if level]
    common = {"type": "dry_friction", "joint": "S", "velocity": 1e-3}
    effects = [effect_from_table({"type": "gravity", "acceleration": [0, 0, "-9.81"]})]
    effects += [effect_from_table({**common, **table}) for table in tables]
    mechanism, path = ball_and_bar().build(), tmp_path / "ball.xml"
    said = save_robot(mechanism, path, effects, accept=True)
    again = forces_of_effects(mechanism, load_robot(path).effects)[0]
    if len(set(levels)) == 1:
        assert not said and [force["coulomb"] for force in again] == list(levels)
    else:
        assert said == ["friction of S"] * len(tables) and not again


def test_springs_of_one_joint_are_one(tmp_path: Path) -> None:
    """9 (x - 0.2) + 3 (x + 0.4) = 12 (x - 0.05)."""
    springs = [{"stiffness": 9, "rest": 0.2, "damping": 1}, {"stiffness": 3, "rest": -0.4}, {"damping": 0.5}]
    effects = [effect_from_table({"type": "joint_spring", "joint": "A", **table}) for table in springs]
    mechanism, path = ball_and_bar().build(), tmp_path / "springs.xml"
    assert save_robot(mechanism, path, effects) == []
    found = {force["kind"]: force for force in forces_of_effects(mechanism, load_robot(path).effects)[0]}
    assert found["spring"]["stiffness"] == 12 and found["spring"]["rest"] == pytest.approx(0.05, rel=1e-15)
    assert found["damping"]["coefficient"] == 1.5


def test_joints_that_close_loops_and_that_fix_keep_value_and_name(tmp_path: Path) -> None:
    made = ball_and_bar().body("tool", mass=1, com=[1, 0, 0], inertia=["1/50"] * 3)
    made.joint("flange", "fixed", parent="one", child="tool", point=[0, 0, 0])
    made.joint("D", "R", parent="base", child="four", point=[1, 0, 1], axes=[[0, 1, 0]])
    made.body("four", mass=1, com=[1, 0, 0], inertia=["1/50"] * 3)
    made.joint("E", "R", parent="four", child="three", point=[1, 0, "1/2"], axes=[[0, 1, 0]], reference="1/3")
    mechanism, path = made.build(), tmp_path / "loop.xml"
    save_robot(mechanism, path, [])
    again = load_robot(path).mechanism
    assert float(again.number(again.joints["E"].reference[0])) == pytest.approx(1 / 3, rel=1e-15)
    assert again.joints["flange"].type == "fixed" and difference(mechanism, again) is None
