"""What a robot's file says and a mechanism does not hold is in the account of its import, or refused in a sentence."""

from __future__ import annotations

from pathlib import Path

import pytest

from symscrew import catalogue
from symscrew.errors import DescriptionError
from symscrew.formats import JointLimits, import_file, save_as
from symscrew.scene import load_robot, save_robot

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
            ["formulas of the parameters (d1, a2, a3, d4, d5, d6)", "names of limbs (arm)", "named points (flange)"],
        ),
    ],
)  # fmt: skip
def test_what_a_written_file_does_not_hold_is_said(tmp_path: Path, suffix: str, left: list[str]) -> None:
    assert save_as(catalogue.load("ur5"), tmp_path / f"ur5{suffix}") == left


LEG = (
    '<mujoco><compiler angle="radian"/><worldbody><body name="A"><joint name="hip.0" axis="1 0 0" range="-1 1"/>'
    f'<joint name="hip.1" axis="0 1 0" range="-2 2" actuatorfrcrange="-3 3"/>{INERTIAL}</body></worldbody></mujoco>'
)


@pytest.mark.parametrize("suffix", [".xml", ".urdf"])
def test_limits_of_a_joint_with_several_freedoms_stay_apart(tmp_path: Path, suffix: str) -> None:
    """They were the last one's, on the first freedom."""
    path = tmp_path / "leg.xml"
    path.write_text(LEG)
    robot = load_robot(path, stops=True)
    assert robot.limits == {"hip.0": JointLimits(-1, 1), "hip.1": JointLimits(-2, 2, effort=3)}
    assert [effect.stops()[0][1:2] for effect in robot.effects if effect.stops()] == [(0,), (1,)]
    assert not save_robot(robot.mechanism, tmp_path / f"again{suffix}", robot.effects[:1], limits=robot.limits)
    assert load_robot(tmp_path / f"again{suffix}").limits == robot.limits


def test_what_acts_on_the_slide_of_a_screw_acts_about_it(tmp_path: Path) -> None:
    """By the pitch of -1/50 m/rad, where 0.1 m and 0.4 rad belong together; it was taken as if about the hinge."""
    slide = 'range="-0.1 0.3" damping="2" armature="3" frictionloss="5" stiffness="700" springref="0.2" ref="0.1"'
    path = tmp_path / "screw.xml"
    body = f'<body name="A"><joint name="s" type="slide" axis="0 0 1" {slide}/>'
    body += f'<joint name="h" axis="0 0 1" ref="0.4" range="-30 8"/>{INERTIAL}</body>'
    tie = '<equality><joint joint1="s" joint2="h" polycoef="0 -0.02 0 0 0"/></equality>'
    path.write_text(f'<mujoco><compiler angle="radian"/><worldbody>{body}</worldbody>{tie}</mujoco>')
    found = import_file(path)
    assert [*found.mechanism.joints] == ["h"]
    assert found.limits["h"].lower == pytest.approx(-9.6, rel=1e-12) and found.limits["h"].upper == 8
    about = {force["kind"]: force for force in found.forces}
    values = [about[kind][key] for kind, key in (("damping", "coefficient"), ("armature", "inertia"))]
    assert values == pytest.approx([2 * 4e-4, 3 * 4e-4], rel=1e-12)
    assert about["friction"]["coulomb"] == pytest.approx(0.1, rel=1e-12)
    assert about["spring"]["stiffness"] == pytest.approx(0.28, rel=1e-12)
    assert about["spring"]["rest"] == pytest.approx(0.4 - 0.1 / 0.02, rel=1e-12)


def test_limits_that_a_file_does_not_hold_are_said(tmp_path: Path) -> None:
    arm = catalogue.load("ur5")
    joint, limits = next(iter(arm.joints)), JointLimits(lower=-1, velocity=2)
    left = save_robot(arm, tmp_path / "arm.xml", [], limits={joint: limits})
    assert left[:2] == [f"greatest rates ({joint})", f"reaches with one end ({joint})"]
    save_robot(arm, tmp_path / "arm.urdf", [], limits={joint: limits}, accept=True)
    found = load_robot(tmp_path / "arm.urdf").limits[joint]
    assert (found.lower, found.upper, found.velocity) == (-1, None, 2)
