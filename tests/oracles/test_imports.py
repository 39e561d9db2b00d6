"""What files of robots say beside bodies and joints: forces, limits, couplings, loops, meshes; nothing is lost.

Files are small and written for these tests; MuJoCo says what they mean.
"""

from __future__ import annotations

import struct
from pathlib import Path

import mujoco
import numpy as np
import pytest
import sympy

from symscrew.cli import main
from symscrew.effects import Effect, effect_to_table, load_effects
from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, import_file, load_format
from symscrew.formats.physical_inertias import _nearest
from symscrew.mobility import analyse_mobility
from symscrew.model import derive
from symscrew.reference import rotation_about
from symscrew.scene import load_robot, load_scene

INERTIAL = '<inertial pos="0.1 0 0.02" mass="1.5" diaginertia="0.01 0.02 0.025"/>'
GRIPPER = f"""<mujoco model="gripper"><compiler angle="radian"/><option gravity="0 0 -1.6"/>
<default><joint armature="0.02" damping="0.3"/><position kp="40" kv="2" forcerange="-5 5"/></default>
<worldbody><body name="palm"><joint name="lift" type="slide" axis="0 0 1" range="-1 2" armature="0.5"/>{INERTIAL}
<body name="left" pos="0 0.1 0">
<joint name="l" axis="1 0 0" stiffness="3" springref="0.2" frictionloss="0.1"/>{INERTIAL}
</body><body name="right" pos="0 -0.1 0"><joint name="r" axis="1 0 0.2" ref="0.3"/>{INERTIAL}</body>
<body name="thumb" pos="0.1 0 0"><joint name="t" axis="0 1 0"/><geom size="0.05" mass="0.3" pos="0 0 0.1"/></body>
</body></worldbody>
<tendon><fixed name="both"><joint joint="l" coef="0.5"/><joint joint="t" coef="-1.25"/></fixed></tendon>
<equality><joint joint1="r" joint2="l" polycoef="0 -1 0.2 0 0"/><tendon tendon1="both" polycoef="0"/></equality>
<actuator><position joint="l" gear="2"/><motor joint="lift" gear="30" ctrlrange="-2 2"/></actuator>
<keyframe><key name="open" qpos="0.1 0.2 0.3 0.4"/></keyframe></mujoco>"""


def saved(text: str, folder: Path, name: str = "robot.xml") -> Path:
    path = folder / name
    path.write_text(text)
    return path


def test_forces_and_couplings_of_an_mjcf(tmp_path: Path) -> None:
    """Mass matrix with armatures and passive forces are MuJoCo's; the fingers have the freedom that the file gives."""
    robot = load_robot(saved(GRIPPER, tmp_path))
    assert analyse_mobility(robot.mechanism).dof == 2
    model = derive(robot.mechanism, robot.effects)
    assert model.system.tree.q[0].label == "lift"
    q, v, _ = model.system.states(3, 2)
    engine = mujoco.MjModel.from_xml_string(GRIPPER)
    data = mujoco.MjData(engine)
    servo = {port.name: np.zeros((len(q), port.size)) for port in model.programs["bias"].inputs[2:]}
    mass, bias = model("mass_matrix", q)[0][0].reshape(-1, 4, 4), model("bias", q, v, *servo.values())[0][0]
    order = [engine.joint(c.label).dofadr[0] for c in model.system.tree.v]
    for k in range(len(q)):
        data.qpos[order], data.qvel[order] = q[k], v[k]
        mujoco.mj_forward(engine, data)
        full = np.zeros((4, 4))
        mujoco.mj_fullM(engine, data, full)
        assert mass[k] == pytest.approx(full[np.ix_(order, order)], rel=1e-12, abs=1e-14)
        expected = (data.qfrc_bias - data.qfrc_passive - data.qfrc_actuator)[order]
        friction = 0.1 * v[k] / np.sqrt(v[k] ** 2 + 1e-6) * [c.label == "l" for c in model.system.tree.v]
        assert bias[k] == pytest.approx(expected + friction, rel=1e-10, abs=1e-11)
    assert np.abs(model("closure", q)[0][0]).max() < 1e-12
    left, right, thumb = (q[:, order.index(engine.joint(n).dofadr[0])] for n in ("l", "r", "t"))
    assert right - 0.3 == pytest.approx(-left + 0.2 * left**2, abs=1e-11)
    assert 0.5 * left - 1.25 * thumb == pytest.approx(0 * left, abs=1e-11)


def test_limits_keyframes_and_the_account(tmp_path: Path) -> None:
    found = import_file(saved(GRIPPER, tmp_path))
    assert (found.limits["lift"].lower, found.limits["lift"].upper, found.limits["lift"].effort) == (-1, 2, 60)
    assert found.configurations == {"open": (0.1, 0.2, 0.3, 0.4)}
    account = found.account
    assert account.taken["couplings"] == 2 and account.effects["armature"] == 4 and not account.influence
    assert found.gravity == (0.0, 0.0, -1.6)
    servo = next(force for force in found.forces if force["kind"] == "servo")
    assert (servo["stiffness"], servo["damping"], servo["limit"]) == (160.0, 8.0, 10.0)
    less = load_robot(tmp_path / "robot.xml", without=("dry_friction", "gravity"))
    assert {type(effect).__name__ for effect in less.effects} == {
        "RotorInertia", "ViscousFriction", "JointSpring", "PositionServo",
    }  # fmt: skip


def numbers_of(effect: Effect) -> dict[str, object]:
    """The table of an effect, its numbers as doubles, whether they are texts or not."""

    def number(value: object) -> object:
        try:
            return float(value)  # type: ignore[arg-type]
        except (TypeError, ValueError):
            return [number(part) for part in value] if isinstance(value, list | tuple) else value

    return {key: number(value) for key, value in effect_to_table(effect).items()}


def test_convert_writes_the_scene_beside_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    saved(GRIPPER, tmp_path)
    arguments = [str(tmp_path / "robot.xml"), "--out", str(tmp_path / "robot.toml")]
    assert main(["convert", *arguments, "--scene", str(tmp_path / "acts.toml")]) == 0
    text = capsys.readouterr().err
    assert "taken over: bodies (4)" in text and "turned into effects and limits: gravity, armature (4)" in text
    scene, robot = load_scene(tmp_path / "acts.toml"), load_robot(tmp_path / "robot.xml")
    assert tuple(scene.effects) == load_effects(tmp_path / "acts.toml")
    assert [numbers_of(effect) for effect in scene.effects] == [numbers_of(effect) for effect in robot.effects]
    assert scene.mechanism == robot.mechanism


def test_what_numbers_depend_on_is_not_left_out_unasked(tmp_path: Path) -> None:
    path = saved(GRIPPER.replace('gravity="0 0 -1.6"/>', '/><extension><plugin plugin="p"/></extension>'), tmp_path)
    with pytest.raises(DescriptionError, match="would be left out: <extension>; accept that with --accept"):
        load_format(path)
    assert import_file(path, ImportOptions(accept=True)).account.influence == {"<extension>": 1}


ROUND = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
LINK = '<link name="{0}">' + ROUND + "</link>"
HINGE = (
    '<joint name="{0}" type="revolute"><parent link="{1}"/><child link="{2}"/><origin xyz="0 0 0.5"/>'
    '<axis xyz="0 1 0"/>{3}</joint>'
)


def arm(*more: str, end: str = "", foot: str = "") -> str:
    links = "".join(LINK.format(name) for name in ("base", "one", "two"))
    first = HINGE.format("A", "base", "one", '<limit lower="-1" upper="2" effort="30" velocity="4"/>')
    return f'<robot name="arm">{links}{first}{HINGE.format("B", "one", "two", end)}{foot}{"".join(more)}</robot>'


def test_mimic_joints_are_couplings(tmp_path: Path) -> None:
    """With an offset the reference configuration obeys it: the second link is turned."""
    mimic = '<mimic joint="A" multiplier="-2" offset="0.25"/><dynamics damping="0.5" friction="0.125"/>'
    found = import_file(saved(arm(end=mimic), tmp_path, "robot.urdf"))
    assert found.mechanism.joints["B"].reference == (sympy.Rational(1, 4),) and found.mechanism.joints["B"].driven == ()
    assert analyse_mobility(found.mechanism).dof == 1
    model = derive(found.mechanism)
    q, status = model("assemble", [0.3], [0.0, 0.25])
    assert status == 0 and q[0] == pytest.approx([0.3, 0.25 - 2 * 0.3], abs=1e-14)
    assert [force["kind"] for force in found.forces] == ["damping", "friction"]
    assert (found.limits["A"].effort, found.limits["A"].velocity, found.limits["A"].lower) == (30, 4, -1)


def test_transmissions_and_unknown_elements(tmp_path: Path) -> None:
    drive = (
        '<transmission name="t"><joint name="A"/><actuator name="m"><mechanicalReduction>"50"</mechanicalReduction>'
        "<rotorInertia>1e-5</rotorInertia></actuator></transmission><weather/><gazebo><plugin/></gazebo>"
    )
    found = import_file(saved(arm(drive), tmp_path, "robot.urdf"))
    assert found.forces == ({"kind": "armature", "joint": "A", "inertia": 1e-5, "ratio": 50.0},)
    assert found.account.harmless["<weather>"] == 1 and found.account.harmless["<gazebo>"] == 1


def test_xacro_output_as_it_comes_and_its_source_by_name(tmp_path: Path) -> None:
    """What xacro writes: its banner, its namespace, comments, numbers of Python. Macros left in a file are an error:
    it would be read as a robot without what they stand for."""
    banner = "<!-- ===== -->\n<!-- | This document was autogenerated by xacro from arm.urdf.xacro | -->\n"
    inertial = '<inertial><mass value="1"/><origin xyz="0.1 0 0"/><inertia ixx="1e-05" iyy="0.1" izz="0.1"/></inertial>'
    joint = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/><origin rpy="-0.0 0 0"/></joint>'
    body = f'<!-- {{}} --><link name="a"/>{joint}<link name="b">{inertial}</link>'
    space = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    start = f'<?xml version="1.0" ?>\n{banner}<robot name="arm" {space}>'
    found = load_format(saved(f"{start}{body}</robot>", tmp_path, "arm.urdf"))
    assert list(found.joints) == ["j"] and found.bodies["b"].mass == 1
    for left in (
        "<xacro:gripper parent='b'/>",
        '<xacro:include filename="x.xacro"/>',
        "<xacro:if value='1'><link/></xacro:if>",
    ):
        with pytest.raises(DescriptionError, match=r"<xacro:.*: it is the source of a URDF.*xacro FILE > robot.urdf"):
            load_format(saved(f"{start}{body}{left}</robot>", tmp_path, "arm.urdf.xacro"))
    with pytest.raises(DescriptionError, match="expected links, found none"):
        load_format(saved(f"{start}</robot>", tmp_path, "arm.urdf"))
    unused = (
        '<xacro:property name="w" value="${2*pi}"/><xacro:macro name="m"><link name="${x}"/><xacro:n/></xacro:macro>'
    )
    account = import_file(saved(f"{start}{unused}{body}</robot>", tmp_path, "arm.urdf")).account
    assert account.harmless["definitions of xacro that nothing uses"] == 2
    for used in (body.replace('"a"', '"${w}"'), f"{body}<xacro:m/>", body.replace("0.1 0 0", "${w} 0 0")):
        with pytest.raises(DescriptionError, match="it is the source of a URDF"):
            load_format(saved(f"{start}{unused}{used}</robot>", tmp_path, "arm.urdf"))


def test_a_floating_base(tmp_path: Path) -> None:
    path = saved(arm(), tmp_path, "robot.urdf")
    free = import_file(path, ImportOptions(floating=True)).mechanism
    assert analyse_mobility(free).dof == 8 and free.bodies["base"].mass == 1
    assert analyse_mobility(load_format(path)).dof == 2


def test_loops_of_urdf_files(tmp_path: Path) -> None:
    """URDF+ and Gazebo close the two links to a triangle with the base; what does not meet is refused."""
    side = '<{0} link="{1}"><origin xyz="{2}"/></{0}>'
    loop = '<loop name="close" type="spherical">' + side.format("predecessor", "base", "0 0 {0}")
    loop += side.format("successor", "two", "0 0 0.5") + "</loop>"
    found = load_format(saved(arm(loop.format("1.5")), tmp_path, "robot.urdf"))
    assert found.joints["close"].type == "S" and found.joints["close"].point == (0, 0, sympy.Rational(3, 2))
    near = import_file(saved(arm(loop.format("1.5000004")), tmp_path, "robot.urdf"))
    assert "open by 4.0e-7 m" in near.account.changed[0]
    path = saved(arm(loop.format("1.501")), tmp_path, "robot.urdf")
    with pytest.raises(DescriptionError, match=r"sides are 0.001 m or rad apart.*--snap 0.001"):
        load_format(path)
    assert import_file(path, ImportOptions(snap=0.0011)).mechanism.joints["close"].point[2] == pytest.approx(1.5005)


SPACE = '<robot name="arm" xmlns:drake="http://drake.mit.edu">'


def test_loops_as_sdf_and_drake_write_them(tmp_path: Path) -> None:
    """A frame for both links, of the child or of a named link, turned; points of two bodies; other joints of a tree."""
    turned = '<gazebo><joint name="g" type="{0}"><parent>base</parent><child>two</child>{1}</joint></gazebo>'
    axis, shift = "<axis><xyz>0 0 1</xyz></axis>", "<pose{0}>0.1 0 0.2 1.5707963267948966 0 0</pose>"
    for pose, height in ((shift.format(""), "1.2"), (shift.format(' relative_to="one"'), "0.7"), ("", "1")):
        path = saved(arm(turned.format("revolute", pose + axis)), tmp_path, "robot.urdf")
        joint = load_format(path).joints["g"]
        assert (joint.type, joint.parent, joint.child) == ("R", "base", "two")
        assert joint.point == (sympy.Rational(1, 10) if pose else 0, 0, sympy.Rational(height))
        assert joint.axes == (((0, -1, 0),) if pose else ((0, 0, 1),))
    for frame, wanted in (("", (0, -1, 0)), ("__model__", (0, 0, 1)), ("one", (0, 0, 1)), ("g", (0, -1, 0))):
        seen = axis.replace("<xyz>", f'<xyz expressed_in="{frame}">' if frame else "<xyz>")
        path = saved(arm(turned.format("revolute", shift.format("") + seen)), tmp_path, "robot.urdf")
        assert load_format(path).joints["g"].axes == (wanted,)
    with pytest.raises(DescriptionError, match="there is no link 'tow'"):
        load_format(saved(path.read_text().replace('"g"><p', '"g"').replace('in="g"', 'in="tow"'), tmp_path, path.name))
    damped = axis.replace("</xyz>", "</xyz><dynamics><damping>0.1</damping><friction>0</friction></dynamics>")
    with pytest.raises(DescriptionError, match="left out: damping of a joint that closes a loop; accept"):
        load_format(saved(arm(turned.format("revolute", damped)), tmp_path, "robot.urdf"))
    ball = (
        '<drake:ball_constraint><drake:ball_constraint_body_A name="base"/>'
        '<drake:ball_constraint_p_AP value="0 0 {0}"/><drake:ball_constraint_body_B name="two"/>'
        '<drake:ball_constraint_p_BQ value="0 0 0.5"/></drake:ball_constraint>'
    )
    made = arm(ball.format("1.5")).replace('<robot name="arm">', SPACE)
    joint = load_format(saved(made, tmp_path, "robot.urdf")).joints["ball_constraint"]
    assert (joint.type, joint.point) == ("S", (0, 0, sympy.Rational(3, 2)))
    with pytest.raises(DescriptionError, match=r"sides are 0.1 m or rad apart"):
        load_format(saved(made.replace("0 0 1.5", "0 0 1.6"), tmp_path, "robot.urdf"))
    with pytest.raises(DescriptionError, match="there is no link 'tow'; did you mean 'two'"):
        load_format(saved(made.replace('_B name="two"', '_B name="tow"'), tmp_path, "robot.urdf"))
    tail = LINK.format("three") + LINK.format("four")
    for k, (kind, ends) in enumerate((("ball", ("two", "three")), ("universal", ("three", "four")))):
        tail += HINGE.format(f"D{k}", *ends, "").replace("joint", "drake:joint").replace("revolute", kind)
    found = load_format(saved(arm(tail).replace('<robot name="arm">', SPACE), tmp_path, "robot.urdf"))
    assert [found.joints[name].type for name in ("D0", "D1")] == ["S", "U"]
    assert found.joints["D1"].axes == ((1, 0, 0), (0, 1, 0))
    bushing = made.replace("</robot>", "<drake:linear_bushing_rpy/></robot>")
    with pytest.raises(DescriptionError, match="would be left out: <linear_bushing_rpy>"):
        load_format(saved(bushing, tmp_path, "robot.urdf"))


FRAMES = (
    '<link name="tip"/><joint name="tip_frame" type="fixed"><parent link="two"/><child link="tip"/>'
    '<origin xyz="0 0 0.5"/></joint><link name="anchor"/><joint name="anchor_frame" type="fixed">'
    '<parent link="base"/><child link="anchor"/><origin xyz="0.3 0 1.2"/></joint>'
)


def test_a_frame_that_is_turned_round_is_found(tmp_path: Path) -> None:
    """Two frames half a turn apart, where the sine of the turn is zero: the joints go half a turn."""
    frames = FRAMES.replace('<origin xyz="0.3 0 1.2"/>', '<origin xyz="0 0 0.5" rpy="0 3.141592653589793 0"/>')
    path = saved(arm(frames.replace('"0 0 0.5"/>', '"0 0 -0.5"/>', 1)), tmp_path, "robot.urdf")
    (tmp_path / "robot.yaml").write_text("closed_loop: [['tip_frame', 'anchor_frame']]\ntype: ['6d']\n")
    joints = load_format(path).joints
    turned = sum(float(joints[name].reference[0]) for name in "AB")
    assert np.cos(turned) == pytest.approx(-1, abs=1e-12)


@pytest.mark.parametrize(("kind", "closes"), [("3d", True), ("6d", False)])
def test_loops_of_a_file_beside_the_urdf(tmp_path: Path, kind: str, closes: bool) -> None:
    """As Gepetto's models have them: open in the URDF's pose, the joints go where they close, drives by name.

    A ball closes at the corner of a triangle by the cosine rule; two turns do not reach a given direction as well.
    """
    path = saved(arm(FRAMES), tmp_path, "robot.urdf")
    (tmp_path / "robot.yaml").write_text(
        f"closed_loop: [['tip_frame', 'anchor_frame']] # one\ntype: ['{kind}']\nname_mot:\n  [\n    \"A\",\n  ]\n"
    )
    found = import_file(path)
    if not closes:  # one thing that the file may mean closes it: said, not asked
        assert found.mechanism.joints["closing_1"].type == "S"
        assert "with type 3d in place of 6d for closing_1 they do, and with nothing else" in found.account.changed[0]
        return
    joints = found.mechanism.joints
    bend = float(joints["B"].reference[0])
    assert np.cos(bend) == pytest.approx((0.3**2 + 0.7**2 - 2 * 0.25) / (2 * 0.25), abs=1e-12)
    assert joints["closing_1"].type == "S" and [float(c) for c in joints["closing_1"].point] == pytest.approx(
        [0.3, 0, 1.2]
    )
    assert (joints["A"].driven, joints["B"].driven) == ((0,), ())
    assert "joints moved from the file's pose" in found.account.changed[0]
    middle = [float(c) for c in joints["B"].point]
    assert np.hypot(middle[0], middle[2] - 0.5) == pytest.approx(0.5, abs=1e-12)
    centre = [float(c) for c in found.mechanism.bodies["two"].com]
    assert centre == pytest.approx(middle, abs=1e-12)  # at the link's own origin, as the file has it


def test_the_joints_that_close_a_loop_as_balls_are_named(tmp_path: Path) -> None:
    """A frame beside the plane of two turns is out of reach by its distance; with a ball it is not, which is tried."""
    frames = FRAMES.replace('"0.3 0 1.2"', '"0.3 0.1 1.2"')
    text = arm(frames).replace('name="B"', 'name="spherical_B"').replace("<limit", "<dynamics/><limit")
    path, beside = saved(text, tmp_path, "robot.urdf"), tmp_path / "robot.yaml"
    beside.write_text("closed_loop: [['tip_frame', 'anchor_frame']]\ntype: ['3d']\n")
    loose = import_file(path)
    with beside.open("a") as file:
        file.write("joint_name: ['spherical_B']\njoint_type: ['SPHERICAL']\n")
    asked = load_format(path)
    assert asked.joints["closing_1"].point[1] == pytest.approx(0.1) and asked.joints == loose.mechanism.joints
    said = "with joint_type SPHERICAL for the 1 turns called 'spherical': spherical_B they do, and with nothing else"
    assert loose.account.changed[0] == f"loops that close in no pose: {said} that such a file may mean"


def test_of_several_things_that_close_a_loop_none_is_taken_unasked(tmp_path: Path) -> None:
    """Two turns reach the place alone; as balls they hold a frame as well that is turned about the second link."""
    tilt = np.arctan2(0.3, 0.7) + np.arccos(np.hypot(0.3, 0.7))
    turn = rotation_about(np.array([0, tilt, 0])) @ rotation_about(np.array([0, 0, 0.5]))
    rpy = np.arctan2(turn[2, 1], turn[2, 2]), -np.arcsin(turn[2, 0]), np.arctan2(turn[1, 0], turn[0, 0])
    frames = FRAMES.replace('"0.3 0 1.2"', f'"0.3 0 1.2" rpy="{" ".join(map(str, rpy))}"')
    text = arm(frames).replace('name="A"', 'name="spherical_A"').replace('name="B"', 'name="spherical_B"')
    path = saved(text, tmp_path, "robot.urdf")
    (tmp_path / "robot.yaml").write_text("closed_loop: [['tip_frame', 'anchor_frame']]\ntype: ['6d']\n")
    cures = r"alone, too.*; with type 3d .*; with joint_type SPHERICAL for the 2 turns .*; take the first .* --loosen"
    with pytest.raises(DescriptionError, match=cures):
        load_format(path)
    assert import_file(path, ImportOptions(loosen=True)).mechanism.joints["closing_1"].type == "S"


def test_a_loop_is_closed_from_another_start(tmp_path: Path) -> None:
    """Two turns whose links are stretched towards a frame that lies on their line: no derivative leads away from it."""
    path = saved(arm(FRAMES.replace('"0.3 0 1.2"/>', '"0 0 0.9"/>')), tmp_path, "robot.urdf")
    (tmp_path / "robot.yaml").write_text("closed_loop: [['tip_frame', 'anchor_frame']]\ntype: ['3d']\n")
    bend = float(load_format(path).joints["B"].reference[0])
    assert np.cos(bend) == pytest.approx((0.4**2 - 2 * 0.25) / (2 * 0.25), abs=1e-12)


def test_a_file_beside_that_is_no_list_is_refused(tmp_path: Path) -> None:
    path = saved(arm(FRAMES), tmp_path, "robot.urdf")
    for text, message in (
        ("closed_loop: [['a', 'anchor_frame']]\n", "there is no frame 'a'"),
        ("closed_loop: [[[[['a']]]]]\n", "expected a list of words"),
        ("closed_loop: ['tip_frame']\n", "expected two frames"),
        ("closed_loop: ]\n", "closes that none has opened"),
        ("closed_loop: [" + "x " * 60_000 + "]", "more than 100000 bytes"),
    ):
        (tmp_path / "robot.yaml").write_text(text)
        with pytest.raises(DescriptionError, match=message):
            load_format(path)


def test_inertias_that_no_body_has(tmp_path: Path) -> None:
    text = arm().replace('izz="1"', 'izz="2.3"', 1).replace('izz="1"', 'izz="2.06"', 1)
    path = saved(text, tmp_path, "robot.urdf")
    with pytest.raises(
        DescriptionError, match=r"bodies.one: no body has the principal moments 1.0, 1.0, 2.06.*--repair"
    ):
        load_format(path)
    found = import_file(path, ImportOptions(repair=True))
    moments = [float(found.mechanism.bodies["one"].inertia[k][k]) for k in range(3)]
    assert moments == pytest.approx([1.02, 1.02, 2.04], rel=1e-12)
    assert "nearest possible ones, by 0.02 kg m^2" in found.account.changed[0]
    a, b, c = (float(x) for x in _nearest(-0.5, 0.2, 3))
    assert a + b == pytest.approx(c) and a >= 0


def box(folder: Path, turned: bool = False) -> None:
    """A box of 0.2 x 0.4 x 0.6 m about (0.1, 0, 0.3): twelve triangles, binary STL; and as an OBJ of quadrilaterals."""
    corners = np.array([[x, y, z] for x in (0, 0.2) for y in (-0.2, 0.2) for z in (0, 0.6)])
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [corners[[f[0], f[k], f[k + 1]]] for f in faces for k in (1, 2)]
    data = b"".join(struct.pack("<12fH", 0, 0, 0, *t.ravel(), 0) for t in triangles)
    (folder / "box.stl").write_bytes(bytes(80) + struct.pack("<I", len(triangles)) + data)
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    lines += ["f " + " ".join(f"{k + 1}/1/1" for k in face) for face in faces]
    (folder / "box.obj").write_text("\n".join(lines))


@pytest.mark.parametrize("kind", ["stl", "obj"])
def test_meshes_have_the_inertia_of_their_volume(tmp_path: Path, kind: str) -> None:
    box(tmp_path)
    text = f"""<mujoco><compiler angle="radian"/><asset><mesh name="m" file="box.{kind}" inertia="exact"/></asset>
    <worldbody><body><joint name="j"/><geom type="mesh" mesh="m" density="500" pos="0 0 1" euler="0 0 0.3"/></body>
    </worldbody></mujoco>"""
    body = next(b for b in load_format(saved(text, tmp_path)).bodies.values() if b.mass)
    assert float(body.mass) == pytest.approx(500 * 0.048, rel=1e-6)
    centre = [0.1 * np.cos(0.3), 0.1 * np.sin(0.3), 1.3]
    assert [float(c) for c in body.com] == pytest.approx(centre, rel=1e-6)
    assert float(body.inertia[2][2]) == pytest.approx(24 * (0.2**2 + 0.4**2) / 12, rel=1e-6)
    engine = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    moments = np.linalg.eigvalsh(np.array(body.inertia, dtype=float))
    assert moments == pytest.approx(np.sort(engine.body_inertia[1]), rel=1e-5)


def test_included_files_stay_in_their_folder(tmp_path: Path) -> None:
    part = saved(
        f'<mujocoinclude><body name="b"><joint name="j"/>{INERTIAL}</body></mujocoinclude>', tmp_path, "part.xml"
    )
    path = saved('<mujoco><worldbody><include file="part.xml"/></worldbody></mujoco>', tmp_path)
    assert list(load_format(path).joints) == ["j"]
    part.write_text('<mujocoinclude><include file="part.xml"/></mujocoinclude>')
    with pytest.raises(DescriptionError, match="includes itself"):
        load_format(path)
    inner = tmp_path / "inner"
    inner.mkdir()
    outside = saved('<mujoco><worldbody><include file="../part.xml"/></worldbody></mujoco>', inner)
    with pytest.raises(DescriptionError, match="outside of the model's folder"):
        load_format(outside)
