"""What a robot's file says and a mechanism does not hold is in the account of its import, or refused in a sentence."""

from __future__ import annotations

from pathlib import Path

import pytest

from symscrew import catalogue
from symscrew.errors import DescriptionError
from symscrew.formats import import_file, save_as

INERTIAL = '<inertial pos="0.1 0 0" mass="1" diaginertia="0.1 0.2 0.2"/>'
BALL = f'<mujoco><worldbody><body name="A"><joint name="a" type="ball" {{}}/>{INERTIAL}</body></worldbody>{{}}</mujoco>'
LINK = (
    '<link name="{}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    "</link>"
)
ARM = (
    f'<robot name="arm"><link name="base"/>{LINK.format("A")}<joint name="a" type="revolute"><parent link="base"/>'
    '<child link="A"/><axis xyz="0 1 0"/><limit effort="1" velocity="1"{}/></joint>{}</robot>'
)
SKIN = '<deformable><skin name="s"/></deformable>'
FLEX = '<deformable><flex name="f" dim="1" body="A A" element="0 1"/></deformable>'
COUPLING = '<coupling name="k"><predecessor link="base"/><successor link="A"/><ratio value="2"/></coupling>'


def gazebo(text: str) -> str:
    return f"<gazebo>{text}</gazebo>"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (BALL.format('range="0 40"', ""), "left out, without influence: range of a ball joint"),
        (BALL.format("", SKIN), "left out, without influence: <deformable>"),
        (ARM.format(' acceleration="3"', ""), "attributes of <limit> that a URDF does not have: acceleration"),
        (ARM.format("", gazebo("<static>true</static>")), "changed: the robot moves, which <gazebo> calls static"),
        (
            ARM.format("", gazebo('<plugin name="wing" filename="libLiftDragPlugin.so"/>')),
            "changed: no forces of the plugin 'wing' in <gazebo> act",
        ),
        (
            ARM.format("", '<mujoco><compiler settotalmass="3"/><option gravity="0 0 -1"/></mujoco>'),
            "changed: MuJoCo's own settotalmass, gravity in <mujoco> is not taken",
        ),
    ],
)
def test_what_is_left_out_is_said(tmp_path: Path, text: str, said: str) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(text)
    assert said in "\n".join(import_file(path).account.lines())


@pytest.mark.parametrize(
    "text",
    [
        BALL.format("", ""),
        BALL.format('limited="true"', ""),
        ARM.format("", gazebo("<static>false</static>")),
        ARM.format("", gazebo('<plugin name="eye" filename="libgazebo_ros_camera.so"/>')),
        ARM.format("", '<mujoco><compiler discardvisual="false" balanceinertia="true"/></mujoco>'),
    ],
)
def test_what_changes_nothing_is_not(tmp_path: Path, text: str) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(text)
    assert not import_file(path).account.changed


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (BALL.format("", FLEX), r"would be left out: <deformable>.*--accept"),
        (ARM.format("", COUPLING), r"would be left out: <coupling>.*--accept"),
        (BALL.format("", "").replace("</worldbody>", '<flexcomp name="f"/></worldbody>'), r"<flexcomp.*bends.*rigid"),
        (BALL.format("", "").replace("</body>", "<composite/></body>"), r"<composite>: bends.*rigid"),
    ],
)
def test_what_numbers_depend_on_is_refused(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(text)
    with pytest.raises(DescriptionError, match=message):
        import_file(path)


@pytest.mark.parametrize(
    ("suffix", "left"),
    [
        (".toml", []),
        (".xml", ["formulas of the parameters (d1, a2, a3, d4, d5, d6)", "names of limbs (arm)"]),
        (
            ".urdf",
            [
                "formulas of the parameters (d1, a2, a3, d4, d5, d6)", "names of limbs (arm)", "named points (flange)",
                "the platform (wrist_3_link)",
            ],
        ),
    ],
)  # fmt: skip
def test_what_a_written_file_does_not_hold_is_said(tmp_path: Path, suffix: str, left: list[str]) -> None:
    assert save_as(catalogue.load("ur5"), tmp_path / f"ur5{suffix}") == left
