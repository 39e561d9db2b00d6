"""Keyframes of an MJCF are starts of scenes: sites are where MuJoCo has them."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

from symscrew.cli import main
from symscrew.errors import DescriptionError
from symscrew.formats import import_file
from symscrew.functions import Motion, kinematic_functions
from symscrew.kinematics import System
from symscrew.program import evaluate, lower
from symscrew.scene import load_robot, load_scene

from .test_import_details import INERTIAL, saved

FLYING = f"""<mujoco model="flying"><worldbody><body name="hull" pos="1 2 3" euler="30 40 50"><freejoint name="base"/>
{INERTIAL}<site name="nose" pos="0.5 0 0.1"/>
<body name="neck" pos="0.3 0 0" quat="0.6 0 0.8 0"><joint name="ball" type="ball"/>
{INERTIAL}<site name="eye" pos="0 0.2 0.1"/><body name="jaw" pos="0 0 0.2"><joint name="hinge" axis="1 2 0" ref="20"/>
{INERTIAL}<site name="tooth" pos="0.1 0.1 0.1"/></body></body></body></worldbody>
<keyframe><key name="bite" qpos="0.1 0.2 0.3 0.5 -0.5 0.7 0.1 0.3 0.4 -0.5 0.7 0.8"/>
<key qpos="0 0 0 1 0 0 0 1 0 0 0 0"/><key name="few" qpos="0.1 0.2 0.3 0"/>
</keyframe></mujoco>"""


def test_sites_are_where_the_engine_has_them(tmp_path: Path) -> None:
    path = saved(FLYING, tmp_path)
    found = import_file(path)
    system = System(found.mechanism)
    points = next(f for f in kinematic_functions(system, Motion(system)) if f.name == "point_motion")
    engine = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(engine)
    labels = [c.label for c in system.tree.q]
    assert list(found.starts) == ["bite", "key_1", "few"] and set(found.starts["bite"]) == set(labels)
    for k, values in enumerate(found.starts.values()):
        q = np.array([values[name] for name in labels])
        places = evaluate(lower(points), [q, 0 * q[:-2], 0 * q[:-2]])[0][0].reshape(-1, 3)
        mujoco.mj_resetDataKeyframe(engine, data, k)
        mujoco.mj_forward(engine, data)
        names = list(found.mechanism.points)
        assert places == pytest.approx(np.array([data.site(name).xpos for name in names]), abs=1e-12)


def test_a_scene_begins_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = saved(FLYING, tmp_path)
    command = ["convert", str(path), "--out", str(tmp_path / "flying.toml"), "--scene", str(tmp_path / "scene.toml")]
    assert main([*command, "--start", "bit"]) == 2
    assert "no keyframe 'bit'; did you mean 'bite'" in capsys.readouterr().err
    assert not (tmp_path / "scene.toml").exists()
    assert main([*command, "--replace", "--start", "bite"]) == 0
    assert load_scene(tmp_path / "scene.toml").initial.coordinates == pytest.approx(import_file(path).starts["bite"])
    assert main([*command[:4], "--replace", "--start", "bite"]) == 2
    long = FLYING.replace(" 0.7 0.8", " 0.7 0.8 0.9")
    with pytest.raises(DescriptionError, match="qpos: expected 12 numbers, got 13"):
        import_file(saved(long, tmp_path))


CLOSED = f"""<mujoco><worldbody><body name="A" pos="0 0 0.3"><joint name="a" axis="0 1 0"/>
<joint name="s" type="slide" axis="1 0 0.3"/>{INERTIAL}<body name="B" pos="0.4 0 0.2">
<joint name="b" type="ball"/>{INERTIAL}</body></body></worldbody>
<equality><connect body1="B" anchor="0.3 0 0"/></equality><actuator><motor jointinparent="b" gear="0 2 0"/></actuator>
<keyframe><key name="k" qpos="0.2 0.1 0.9 0.3 0.2 0.1" qvel="1 0 0.3 0.4 0.5"/></keyframe></mujoco>"""


def test_a_ball_that_is_reached_from_its_child_starts_where_the_file_has_it(tmp_path: Path) -> None:
    """Its coordinates are the parent's against the child then: A turns against B as MuJoCo has it, from a B at rest."""
    path = saved(CLOSED, tmp_path)
    robot = load_robot(path)
    system = System(robot.mechanism)
    links = {link.joint: link for link in system.tree.links}
    assert links["b"].inverted and system.tree.links[links["b"].parent].joint == "loop_0"
    q, v = system.reference.copy(), np.zeros(len(system.tree.v))
    for values, places, known in ((q, system.tree.q, robot.starts), (v, system.tree.v, robot.start_rates)):
        for k, coordinate in enumerate(places):
            values[k] = known["k"].get(coordinate.label, values[k]) if coordinate.joint == "b" else values[k]
    index = links["b"].index
    nodes = [*(entry for row in system.pose[index].rotation for entry in row), *system.twist[index].angular]
    found = system.numeric(list(map(system.tape.node, nodes)), (system.inputs.q, q[None]), (system.inputs.v, v[None]))
    engine = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(engine)
    mujoco.mj_resetDataKeyframe(engine, data, 0)
    mujoco.mj_forward(engine, data)
    turns = [data.body(name).xmat.reshape(3, 3) for name in "AB"]
    rates = np.zeros((2, 6))
    for k, name in enumerate("AB"):
        mujoco.mj_objectVelocity(engine, data, mujoco.mjtObj.mjOBJ_XBODY, data.body(name).id, rates[k], 0)
    turn = found[0][:9].reshape(3, 3)
    assert turn == pytest.approx(turns[1].T @ turns[0], abs=1e-12)
    assert turn @ found[0][9:] == pytest.approx(turns[1].T @ (rates[0] - rates[1])[:3], abs=1e-12)
