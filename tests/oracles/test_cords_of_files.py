"""Tendons in space and springs in balls of MJCF files: MuJoCo's accelerations, and what is written reads back so."""

from __future__ import annotations

from pathlib import Path

import mujoco
import pytest

from symscrew.errors import DescriptionError
from symscrew.model import derive
from symscrew.scene import Robot, load_robot, save_robot

ARM = """<mujoco><compiler angle="radian"/><worldbody><site name="g" pos="0.4 0.1 1"/><geom name="pin" size="0.1"/>
<body name="a" pos="0 0 1"><joint name="j" axis="0 1 0" {0}/><geom size="0.1" pos="0.2 0 0"/>
<site name="s" pos="0.1 0 0.1"/>
<body name="b" pos="0.3 0 0"><joint name="k" axis="1 0 0.2"/><geom size="0.07" pos="0 0.1 0"/>
<site name="t" pos="0 0.2 0"/><site name="u" pos="0.1 0.2 0.1"/></body></body></worldbody>
<tendon><spatial {1}></tendon></mujoco>"""
OVER = {
    "two bodies": ("", 'stiffness="30"><site site="s"/><site site="t"/></spatial'),
    "a damper": ("", 'damping="3"><site site="g"/><site site="t"/></spatial'),
    "over a third one": ("", 'stiffness="30" damping="2" springlength="0.1"><site site="g"/><site site="s"/>'
                         '<site site="t"/></spatial'),
    "that only pulls": ("", 'stiffness="30" springlength="0 0.9"><site site="g"/><site site="t"/><site site="u"/>'
                        "</spatial"),
    "with slack": ("", 'stiffness="30" springlength="0.8 1.1"><site site="g"/><site site="t"/><site site="s"/>'
                   "</spatial"),
}  # fmt: skip
BALL = """<mujoco><worldbody><body><joint type="ball" stiffness="3" damping="0.2"/>
<inertial pos="0.1 0.2 0" mass="2" diaginertia="0.1 0.2 0.25"/></body></worldbody></mujoco>"""


def accelerations(robot: Robot, text: str) -> None:
    """Ours are those of MuJoCo at random states."""
    made = derive(robot.mechanism, robot.effects)
    q, v, _ = made.system.states(3, 1)
    found = made("forward_dynamics", q, v)[0][0]
    engine = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(engine)
    for k in range(len(q)):
        data.qpos[:], data.qvel[:] = q[k], v[k]
        mujoco.mj_forward(engine, data)
        assert found[k] == pytest.approx(data.qacc, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("text", [*(ARM.format(*given) for given in OVER.values()), BALL], ids=[*OVER, "a ball"])
def test_accelerations_are_those_of_mujoco(tmp_path: Path, text: str) -> None:
    path = tmp_path / "arm.xml"
    path.write_text(text)
    robot = load_robot(path)
    accelerations(robot, text)
    save_robot(robot.mechanism, tmp_path / "again.xml", robot.effects)
    again = load_robot(tmp_path / "again.xml")
    assert sorted(map(repr, again.effects)) == sorted(map(repr, robot.effects))


@pytest.mark.parametrize(
    ("joint", "tendon", "says"),
    [
        ("", 'stiffness="3"><site site="g"/><geom geom="pin"/><site site="t"/></spatial', "around geoms or by pulleys"),
        ("", 'damping="3"><site site="g"/><site site="t"/><pulley divisor="2"/><site site="g"/><site site="s"/>'
             "</spatial", "damping of a tendon in space, around geoms"),
        ("", 'frictionloss="3"><site site="g"/><site site="t"/></spatial', "frictionloss of a tendon in space"),
        ('springref="0.3"', 'stiffness="3"><site site="g"/><site site="t"/></spatial', "where joints with springref"),
        ("", 'stiffness="3 1"><site site="g"/><site site="t"/></spatial', "powers of stiffness"),
        ("", 'stiffness="3"><site site="g"/><site site="x"/></spatial', "there is no site 'x'"),
    ],
)  # fmt: skip
def test_what_no_effect_has_is_refused_by_name(tmp_path: Path, joint: str, tendon: str, says: str) -> None:
    path = tmp_path / "arm.xml"
    path.write_text(ARM.format(joint, tendon))
    with pytest.raises(DescriptionError, match=says):
        load_robot(path)
