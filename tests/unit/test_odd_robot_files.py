"""Files of robots that contradict themselves or say what has no effect: an error, or a line in the account."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from symscrew.cli.parser import main
from symscrew.errors import DescriptionError
from symscrew.formats import Account, ImportOptions, import_file
from symscrew.mobility import analyse_mobility

HINGE = """<robot name="r"><link name="a"/><link name="b"/>
<joint name="j" type="{type}"><parent link="a"/><child link="b"/>
<axis xyz="{axis}"/><limit lower="{lower}" upper="1" effort="1" velocity="1"/><dynamics damping="{damping}"/></joint>
<transmission name="t"><joint name="j"/><actuator name="m"/></transmission></robot>"""
ARM = """<mujoco>{default}<worldbody>
<body name="a"><joint name="j" {joint}/><geom size="0.1" {geom}/></body></worldbody>
{rest}</mujoco>"""
TWICE = '<default><default class="x"/><default class="y"><default class="x"/></default></default>'


def account(folder: Path, text: str, suffix: str) -> Account:
    path = folder / f"odd.{suffix}"
    path.write_text(text)
    return import_file(path).account


def urdf(folder: Path, **keys: str) -> Account:
    usual = {"type": "revolute", "axis": "0 0 1", "lower": "-1", "damping": "0"}
    return account(folder, HINGE.format(**{**usual, **keys}), "urdf")


def mjcf(folder: Path, **keys: str) -> Account:
    return account(folder, ARM.format(**{**dict.fromkeys(("default", "joint", "geom", "rest"), ""), **keys}), "xml")


def test_contradictions_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match="joint 'j', damping: expected a number of at least 0, got -2"):
        urdf(tmp_path, damping="-2")
    for joint, what in (("armature='-1'", "armature"), ("damping='-1'", "damping"), ("frictionloss='-1'", "friction")):
        with pytest.raises(DescriptionError, match=f"joint 'j', {what}: expected a number of at least 0, got -1"):
            mjcf(tmp_path, joint=joint)
    with pytest.raises(DescriptionError, match="expected one orientation, got quat and euler"):
        mjcf(tmp_path, geom='quat="1 0 0 0" euler="1 2 3"')
    with pytest.raises(DescriptionError, match="there are two classes 'x'"):
        mjcf(tmp_path, default=TWICE)


def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "mesh.stl")
    mesh = '<asset><mesh name="m" file="mesh.stl"/></asset>'
    with pytest.raises(DescriptionError, match=r"mesh.stl' is no file"):
        mjcf(tmp_path, default=mesh, geom='type="mesh" mesh="m"')


def test_what_has_no_effect_is_in_the_account(tmp_path: Path) -> None:
    assert (
        "limits of j: the lower one, 2, is above the upper one, 1; neither is taken"
        in urdf(tmp_path, lower="2").changed
    )
    assert "neither is taken" in mjcf(tmp_path, joint='range="1 -1"').changed[0]
    assert not urdf(tmp_path).harmless
    assert urdf(tmp_path, axis="0 0 5").harmless == {"lengths of axes, which are directions": 1}
    assert "lengths of axes, which are directions" in mjcf(tmp_path, joint='axis="0 1 1"').harmless
    drives = "drives of joints that have not one freedom or mimic another"
    assert urdf(tmp_path, type="floating").harmless == {drives: 1}
    idle = mjcf(tmp_path, rest='<equality><weld body1="a" active="false"/></equality>')
    assert idle.harmless["equality constraints that are not active"] == 1 and "loop_0" not in idle.taken


MESH = """<asset><mesh name="m" {0}/></asset>"""
CORNERS = 'vertex="0 0 0 1 0 0 0 1 0 0 0 1"'


@pytest.mark.parametrize(
    ("mesh", "message"),
    [
        (f'{CORNERS} face="0 2 1 0 1 3 0 3 2 1 2 3" scale="1e200 1 1"', "expected vertices within 1e.30 m"),
        (f'{CORNERS} face="0 2.5 1"', "face: expected numbers of vertices from 0 to 3"),
        (f'{CORNERS} face="0 1e300 1"', "face: expected numbers of vertices from 0 to 3"),
        ('vertex="0 0" face="0 1 2"', "vertex: expected three numbers each, got 2 in all"),
        ('vertex="1 1 1 1 1 1 1 1 1" face="0 1 2"', "encloses no volume"),
        ('file="short.obj"', "expected three numbers after 'v', got 2"),
        ('file="none.obj"', "a face has a vertex that is none of the 1"),
    ],
)
def test_meshes_that_are_none(tmp_path: Path, mesh: str, message: str) -> None:
    (tmp_path / "short.obj").write_text("v 1 2\nf 1 1 1\n")
    (tmp_path / "none.obj").write_text("v 1 2 3\nf 1 0 1\n")
    with pytest.raises(DescriptionError, match=message):
        mjcf(tmp_path, default=MESH.format(mesh), geom='type="mesh" mesh="m"')


def test_numbers_beyond_doubles_and_names_of_two(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match=r"odd\.xml: products of its numbers go beyond"):
        mjcf(tmp_path, rest='<actuator><position joint="j" kp="3" gear="1e200"/></actuator>')
    for section, element in (("tendon", '<fixed name="n"><joint joint="j" coef="{0}"/></fixed>'), ("keyframe", "{0}")):
        twice = element.format(1) + element.format(2) if section == "tendon" else '<key name="n" qpos="0"/>' * 2
        with pytest.raises(DescriptionError, match=f"two elements of <{section}> have this name"):
            mjcf(tmp_path, rest=f"<{section}>{twice}</{section}>")
    yielding = '<tendon><fixed name="t" stiffness="2" springyield="0.1"><joint joint="j" coef="1"/></fixed></tendon>'
    with pytest.raises(DescriptionError, match="left out: springyield of a tendon"):
        mjcf(tmp_path, rest=yielding)


def test_a_body_that_is_fixed_has_a_mobility(tmp_path: Path) -> None:
    path = tmp_path / "fixed.xml"
    path.write_text("<mujoco><worldbody><body/></worldbody></mujoco>")
    assert analyse_mobility(import_file(path).mechanism).dof == 0


def test_a_body_of_many_points_is_read(tmp_path: Path) -> None:
    """Its extent is that of all of them, found in a time that does not grow with their square in 50 digits."""
    path, sites = tmp_path / "points.xml", "".join(f'<site name="s{k}" pos="{k / 1000} 0 0"/>' for k in range(200))
    body = '<joint name="j"/><inertial pos="0.1 0 0" mass="1" diaginertia="{0} {0} {0}"/>' + sites
    for inertia, warned in ((0.039, False), (0.04, True)):
        path.write_text(f"<mujoco><worldbody><body>{body.format(inertia)}</body></worldbody></mujoco>")
        warnings = " ".join(import_file(path).mechanism.warnings)
        assert ("the radius of gyration 0.2 m exceeds the body's extent 0.199 m" in warnings) is warned
        assert warned or "gyration" not in warnings


WEIGHED = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<link name="a"><visual><xacro:grey/></visual></link>
<link name="b"><collision><xacro:box/></collision><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0.1" ixz="0" iyz="0" {0}/></inertial></link>
<joint name="j" type="{1}"><parent link="a"/><child link="b"/><axis xzy="0 0 1"/></joint></robot>"""


@pytest.mark.parametrize("mirrored", ['iyx="0.1"', 'izx="0.0" izy="0"'])
def test_what_says_nothing_more_is_passed_over(tmp_path: Path, mirrored: str) -> None:
    """Mirror images in an inertia, macros that draw, the axis of a fixed joint."""
    inertia = account(tmp_path, WEIGHED.format(mirrored, "fixed"), "urdf")
    assert inertia.taken == {"bodies": 1, "joints": 1} and not inertia.influence


def test_what_says_something_else_is_said_or_refused(tmp_path: Path) -> None:
    found = account(tmp_path, WEIGHED.format('iyx="0.2"', "fixed"), "urdf")
    assert "iyx is 0.2, its mirror image ixy 0.1, which counts" in found.changed[0]
    with pytest.raises(DescriptionError, match="the attribute 'xyz' is missing"):
        account(tmp_path, WEIGHED.format("", "continuous"), "urdf")


def test_a_world_that_the_file_does_not_have_is_the_ground(tmp_path: Path) -> None:
    text = HINGE.format(type="revolute", axis="0 0 1", lower="-1", damping="0").replace('<link name="a"/>', "")
    found = account(tmp_path, text.replace('link="a"', 'link="world"'), "urdf")
    assert found.taken["joints"] == 1 and "as for Drake" in found.changed[0]
    with pytest.raises(DescriptionError, match="no parent link 'a'"):
        account(tmp_path, text, "urdf")


SPRUNG = """<mujoco><option gravity="0 0 -3"/><worldbody><body name="a"><joint name="j" armature="2" damping="1"/>
<geom size="0.1" pos="0.2 0 0"/></body></worldbody></mujoco>"""


def test_commands_say_what_of_a_file_they_leave_out_or_have_otherwise(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "arm.xml").write_text(SPRUNG)
    assert main(["generate", str(tmp_path / "arm.xml"), "--target", "numpy", "--out", str(tmp_path / "out")]) == 0
    assert "beside the mechanism the file has gravity 0 0 -3, armature, damping, which" in capsys.readouterr().err
    text = HINGE.format(type="revolute", axis="0 0 1", lower="-1", damping="0").replace('<link name="a"/>', "")
    (tmp_path / "arm.urdf").write_text(text.replace('link="a"', 'link="world"'))
    assert main(["mobility", str(tmp_path / "arm.urdf")]) == 0
    assert "note: joints hang on a link 'world' that the file does not have" in capsys.readouterr().err


def test_reductions_that_are_no_numbers_matter_to_rotors_alone(tmp_path: Path) -> None:
    said = HINGE.format(type="revolute", axis="0 0 1", lower="-1", damping="0")
    odd = said.replace(
        '<actuator name="m"/>', '<actuator name="m"><mechanicalReduction>{0}</mechanicalReduction>{1}</actuator>'
    )
    assert (
        account(tmp_path, odd.format("ratio", ""), "urdf").harmless["reductions of transmissions that are no numbers"]
        == 1
    )
    rotor = "<motorInertia>1e-4</motorInertia>"
    assert account(tmp_path, odd.format("'7.5'", rotor), "urdf").effects["rotor inertia of a transmission"] == 1
    with pytest.raises(DescriptionError, match="mechanicalReduction: expected decimal numbers, got 'ratio'"):
        account(tmp_path, odd.format("ratio", rotor), "urdf")


def test_a_mass_without_moments_is_a_point(tmp_path: Path) -> None:
    text = HINGE.format(type="revolute", axis="0 0 1", lower="-1", damping="0")
    path = tmp_path / "point.urdf"
    inertial = '<inertial><origin xyz="0.5 0 0"/><mass value="2"/></inertial>'
    path.write_text(text.replace('<link name="b"/>', f'<link name="b">{inertial}</link>'))
    found = import_file(path)
    assert found.mechanism.bodies["b"].mass == 2 and not any(map(any, found.mechanism.bodies["b"].inertia))
    assert "<link name='b'>: a mass without <inertia>: a point, as for ROS" in found.account.changed
    path.write_text(path.read_text().replace('<mass value="2"/>', ""))
    with pytest.raises(DescriptionError, match="inertial: expected one <mass>, found 0"):
        import_file(path)


def test_bodies_and_joints_without_names_get_none_that_others_have(tmp_path: Path) -> None:
    one = '<body {0}><joint {1}/><geom size="0.1"/></body>'
    path = tmp_path / "named.xml"
    named = one.format('name="body"', 'name="joint"')
    path.write_text(f"<mujoco><worldbody>{one.format('', '')}{named}</worldbody></mujoco>")
    found = import_file(path).mechanism
    assert list(found.bodies) == ["world", "body_2", "body"] and list(found.joints) == ["joint_2", "joint"]


@pytest.mark.parametrize(
    ("suffix", "right", "wrong", "said"),
    [
        ("urdf", "<dynamics", "<dynamic", "element 'dynamic' of <joint>, which is not read: did you mean 'dynamics'?"),
        ("urdf", "lower=", "lowers=", "attribute 'lowers' of <limit>, which is not read: did you mean 'lower'?"),
        ("urdf", "type=", "types=", "attribute 'types' of <loop>, which is not read: did you mean 'type'?"),
        ("xml", "scale=", "scales=", "attribute 'scales' of <mesh>, which is not read: did you mean 'scale'?"),
        ("xml", "data=", "datas=", "attribute 'datas' of <text>, which is not read: did you mean 'data'?"),
    ],
)
def test_words_that_are_nearly_read_are_not_left_out_silently(
    suffix: str, right: str, wrong: str, said: str, tmp_path: Path
) -> None:
    """A loop whose type is misspelt was a fixed one, a limit none, a mesh a thousand times as large."""
    tie = '<loop name="l" type="spherical"><predecessor link="a"/><successor link="b"/></loop></robot>'
    hinge = HINGE.format(type="revolute", axis="0 0 1", lower="-1", damping="2").replace("</robot>", tie)
    rest = '<asset><mesh name="m" vertex="0 0 0 1 0 0 0 1 0 0 0 1" scale="0.1 0.1 0.1"/></asset>'
    rest += '<custom><text name="t" data="d"/></custom>'
    whole = hinge if suffix == "urdf" else ARM.format(default="", joint="", geom="", rest=rest)
    assert not account(tmp_path, whole, suffix).influence
    at = whole.index("<loop") if wrong == "types=" else 0
    path = tmp_path / f"odd.{suffix}"
    path.write_text(whole[:at] + whole[at:].replace(right, wrong, 1))
    assert said in import_file(path, ImportOptions(accept=True)).account.influence
    with pytest.raises(DescriptionError, match="what numbers depend on would be left out"):
        import_file(path)


def test_other_words_are_left_out(tmp_path: Path) -> None:
    """MuJoCo's `frictionloss` is no misspelt friction of a URDF; a word beside the one that it is near adds nothing."""
    hinge = HINGE.format(type="revolute", axis="0 0 1", lower="-1", damping="2")
    for more in ("frictionloss", "dampings"):
        found = account(tmp_path, hinge.replace("<dynamics", f'<dynamics {more}="1"'), "urdf")
        assert not found.influence
        assert f"attributes of <dynamics> that a URDF does not have: {more}" in found.harmless
