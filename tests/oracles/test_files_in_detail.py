"""Robots' files, word by word: what classes, flags, constants and limits do to numbers is what MuJoCo makes of them."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

from symscrew.description import Mechanism, slope
from symscrew.errors import DescriptionError
from symscrew.formats import difference, import_file, load_format, text_of
from symscrew.functions import Motion, kinematic_functions
from symscrew.functions.closing import jacobian_in_v
from symscrew.kinematics import System
from symscrew.model import derive
from symscrew.program import evaluate, lower
from symscrew.scene import load_robot, load_scene, save_robot, scene_text

from .test_import_details import INERTIAL, saved


def hinge(name: str, inner: str = "", more: str = 'axis="0 1 0"') -> str:
    return f'<body name="B{name}" pos="0.2 0 0.1"><joint name="{name}" {more}/>{INERTIAL}{inner}</body>'


def model(body: str, rest: str = "") -> str:
    return f'<mujoco><compiler angle="radian"/>{rest}<worldbody>{body}</worldbody></mujoco>'


TWO = hinge("a", hinge("b", more='axis="1 0 0"'))
GENERAL = '<general biastype="affine" biasprm="0 -7 -1" gainprm="7" gear="2"/>'
TENDON = '<tendon><fixed name="t" stiffness="7"><joint joint="a" coef="2"/>{0}</fixed></tendon>'
OWN = hinge("a", hinge("b"), 'axis="0 1 0" ref="0.5" springref="0.2"')
BOTH = '<body gravcomp="0.6" pos="0 0 1">{0}<joint name="b" axis="0 1 0.3"/>{1}<body pos="0.3 0 0"/></body>'
BOTH = BOTH.format('<joint name="a" type="slide" axis="1 2 3"/>', INERTIAL + "{0}")
HALF = '<equality><joint joint1="b" joint2="a" polycoef="0 0.5"/><connect body1="Bb" anchor="0 0 0"/></equality>'
ACTING = {
    "least masses": model(BOTH.format(""), '<compiler boundmass="2.7" boundinertia="0.5"/>'),
    "least masses of tendons": model(
        TWO,
        '<compiler boundmass="7"/>' + '<tendon><fixed name="t" stiffness="7"><joint joint="a" coef="2"/>'
        '<joint joint="b" coef="-3"/></fixed></tendon>',
    ),
    "inertia of no geom": model(BOTH.format('<geom size="0.2" mass="0"/>'), '<compiler inertiafromgeom="true"/>'),
    "classes": model(
        TWO,
        f'<default><motor gear="7"/><default class="s">{GENERAL}</default></default>'
        '<actuator><position joint="a" kp="20"/><position joint="b" class="s" kp="30"/></actuator>',
    ),
    "replaced": model(
        TWO,
        '<default><position kp="50" kv="3"/></default><actuator><velocity joint="a"/><general joint="b"/></actuator>',
    ),
    "two sizes": model(
        TWO,
        '<actuator><position joint="a" kp="900" forcerange="-0.1 5" gear="-2"/>'
        '<position joint="b" kp="900" forcerange="-0.1 0.1" forcelimited="false"/></actuator>',
    ),
    "of the joint": model(
        hinge("a", hinge("b"), 'axis="0 1 0" actuatorfrcrange="-0.3 0.1"'),
        '<actuator><position joint="a" kp="900"/><intvelocity joint="b" kp="3"/></actuator>',
    ),
    "ratio": model(
        TWO, '<actuator><general joint="a" gear="3" biastype="affine" gainprm="7" biasprm="0 -7 0.6"/></actuator>'
    ),
    "groups": model(
        TWO,
        '<option actuatorgroupdisable="2"/><actuator><position joint="a" kp="200" group="2"/>'
        '<position joint="b" kp="3" group="1"/></actuator>',
    ),
    "flags": model(
        hinge("a", hinge("b"), 'axis="0 1 0" stiffness="3" damping="2"'),
        '<option><flag spring="disable" damper="disable"/></option>' + TENDON.format(""),
    ),
    "nothing passive": model(
        hinge("a", hinge("b"), 'axis="0 1 0" stiffness="3" damping="2"').replace("<body ", '<body gravcomp="0.7" ', 1),
        '<option density="900" viscosity="3"><flag spring="disable" damper="disable"/></option>',
    ),
    "no equality": model(TWO, f'<option><flag equality="disable"/></option>{HALF}'),
    "no constraint": model(
        hinge("a", hinge("b"), 'axis="0 1 0" frictionloss="3"'), f'<option><flag constraint="disable"/></option>{HALF}'
    ),
    "no actuation": model(
        hinge("a", hinge("b")).replace("<body ", '<body gravcomp="0.7" ', 1),
        '<option><flag actuation="disable"/></option>'
        '<actuator><position joint="a" kp="200" armature="0.3"/></actuator>',
    ),
    "weightless": model(TWO, '<option gravity="1 2 3"><flag gravity="disable"/></option>'),
    "one joint's tendon": model(OWN, TENDON.format("")),
    "several on one joint": model(
        TWO,
        '<actuator><position joint="a" kp="20"/><velocity joint="a" kv="3" forcerange="-0.1 0.2"/>'
        '<motor joint="a" gear="7"/><position joint="b"/></actuator>',
    ),
    "a tendon's own reach": model(
        TWO,
        '<tendon><fixed name="t" actuatorfrcrange="-0.2 0.1"><joint joint="a" coef="2"/></fixed><fixed name="s" '
        'actuatorfrcrange="-0.1 0.3"><joint joint="a" coef="1"/><joint joint="b" coef="-3"/></fixed></tendon>'
        '<actuator><position tendon="t" kp="90" gear="-2"/><position tendon="s" kp="90"/></actuator>',
    ),
    "two joints' tendon": model(OWN, TENDON.format('<joint joint="b" coef="-3"/>')),
}


@pytest.mark.parametrize("name", ACTING)
def test_forces_are_those_of_mujoco(tmp_path: Path, name: str) -> None:
    """Accelerations, with all commands at zero, at states where limits act."""
    robot = load_robot(saved(ACTING[name], tmp_path))
    assert not robot.account.influence
    made = derive(robot.mechanism, robot.effects)
    engine = mujoco.MjModel.from_xml_string(ACTING[name])
    data = mujoco.MjData(engine)
    q, v, _ = made.system.states(2, 2)
    labels = [c.label for c in made.system.tree.v]
    order = [labels.index(joint) for joint in "ab"]
    ports = made.programs["forward_dynamics"].inputs
    given = [{"q": q, "v": v}.get(port.name, np.zeros(port.shape)) for port in ports]
    found = made("forward_dynamics", *given)[0][0]
    for k in range(len(q)):
        data.qpos[:], data.qvel[:] = q[k][order], v[k][order]
        mujoco.mj_forward(engine, data)
        assert found[k][order] == pytest.approx(data.qacc, rel=1e-9, abs=1e-9)


THREE = hinge("a", hinge("b", hinge("c", more='axis="1 0 0" ref="0.2"')))
FIXED = '<tendon><fixed name="t"><joint joint="a" coef="2"/><joint joint="b" coef="-3"/></fixed></tendon>'
TIES = {
    "a chain": '<joint joint1="c" joint2="b" polycoef="0.1 2 0.3"/><joint joint1="b" joint2="a" polycoef="0.2 0.5"/>',
    "a tendon": '<tendon tendon1="t" polycoef="0.3 0 0 0 0"/>',
    "one number": '<joint joint1="b" joint2="a" polycoef="0.1"/>',
    "carried": '<joint joint1="a" joint2="b" polycoef="0.3 -1"/><weld body1="Bb" body2="Bc"/>',
}


@pytest.mark.parametrize("name", TIES)
def test_constants_of_couplings_hold_together(tmp_path: Path, name: str) -> None:
    """In our reference configuration MuJoCo's constraints hold, its bodies are there, and its rows have our slopes."""
    text = model(THREE, f"{FIXED}<equality>{TIES[name]}</equality>")
    mechanism = load_format(saved(text, tmp_path))
    engine = mujoco.MjModel.from_xml_string(text)
    engine.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    data = mujoco.MjData(engine)
    values = [mechanism.joints[joint].reference for joint in "abc"]
    data.qpos[:] = [float(mechanism.number(given[0])) if given else 0.0 for given in values]
    mujoco.mj_forward(engine, data)
    assert np.abs(data.qpos - engine.qpos0).max() > 0.05
    assert data.efc_pos == pytest.approx(np.zeros(data.nefc), abs=1e-12)
    for body in "abc":
        com = mechanism.bodies[f"B{body}"].com
        assert com is not None
        assert [float(c) for c in com] == pytest.approx(list(data.body(f"B{body}").xipos), abs=1e-12)
    rows = data.efc_J.reshape(data.nefc, 3)
    for coupling in mechanism.couplings.values():
        slopes = np.zeros(3)
        for term in coupling.terms:
            slopes["abc".index(term.joint)] = float(mechanism.number(slope(mechanism, term)))
        assert min(np.linalg.norm(np.cross(slopes, row)) for row in rows) < 1e-12 * np.linalg.norm(slopes)


FOUR = hinge("a", hinge("b", hinge("c", hinge("d"), 'axis="0 1 0" ref="0.3"'))) + '<site name="w" pos="0.9 0 0.4"/>'
HELD = {
    "the world": '<weld body1="Bd" anchor="0.1 0.2 0.3" torquescale="0"/>',
    "a body": '<weld body1="Bd" body2="Ba" anchor="0.1 0.2 0.3" torquescale="0"/>',
    "a place": '<weld body1="Bd" body2="Ba" anchor="0.1 0.2 0.3" relpose="-0.5 0.2 0 1 0 0 0" torquescale="0"/>',
    "sites": '<weld site1="s" site2="w" torquescale="0"/>',
    "whole": '<weld body1="Bd" body2="Ba" anchor="0.1 0.2 0.3" relpose="-0.5 0.2 0 1 0 0 0"/>',
}


@pytest.mark.parametrize("name", HELD)
def test_a_weld_without_torque_holds_a_point(tmp_path: Path, name: str) -> None:
    """As many freedoms as the rows of MuJoCo leave, which hold in the file's pose."""
    text = model(FOUR, f"<equality>{HELD[name]}</equality>").replace(
        '<joint name="d"', '<site name="s" pos="0.1 0 0" euler="0.3 0 0"/><joint name="d"'
    )
    mechanism = load_format(saved(text, tmp_path))
    engine = mujoco.MjModel.from_xml_string(text)
    engine.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    assert data.efc_pos == pytest.approx(np.zeros(data.nefc), abs=1e-12)
    rows = data.efc_J.reshape(data.nefc, 4)
    system = System(mechanism)
    columns = jacobian_in_v(system)
    entries = system.numeric([x for c in columns for x in c], (system.inputs.q, system.reference[None]))
    ours = len(columns) - np.linalg.matrix_rank(entries.reshape(len(columns), -1), tol=1e-9)
    assert 4 - np.linalg.matrix_rank(rows, tol=1e-9) == ours == 2  # the four are in line, where a whole weld leaves two
    kinds = sorted(joint.type for joint in mechanism.joints.values())
    assert kinds == ["R"] * 4 + (["fixed"] if name == "whole" else ["S"])


@pytest.mark.parametrize(
    ("ties", "message"),
    [
        ('<joint joint1="c" joint2="b" polycoef="0.1"/><joint joint1="c" joint2="a" polycoef="0.2"/>', "hold by 0.1"),
        ('<joint joint1="a" joint2="a" polycoef="0 2"/>', "expected two joints, got 'a' twice"),
        ('<joint joint1="a" joint2="b" polycoef="0.3 -1"/><weld body1="Ba"/>', "does not close"),
        ('<weld body1="Bc" body2="Ba" anchor="0.1 0 0" relpose="-0.4 0 -0.2 1 0 0 0"/>', "sides are 0.1 m"),
        ('<weld body1="Bc" active="True"/>', "active: expected true or false, got 'True'"),
        ('<joint joint1="b" polycoef="0.3"/><connect body1="Bb" body2="Z" anchor="0.3 0 0"/>', "does not close"),
    ],
)
def test_constants_that_do_not_hold_together_are_refused(tmp_path: Path, ties: str, message: str) -> None:
    slider = f'<body name="Z" pos="0.9 0 0.3"><joint name="z" type="slide" axis="1 0 0"/>{INERTIAL}</body>'
    with pytest.raises(DescriptionError, match=message):
        load_format(saved(model(THREE + slider, f"<equality>{ties}</equality>"), tmp_path))


def test_an_own_orientation_is_in_the_place_of_the_class_one(tmp_path: Path) -> None:
    text = model(
        '<body name="b"><joint axis="1 2 3"/><geom class="c" quat="0.7 0.1 0.2 0.3"/></body>',
        '<default><default class="c"><geom type="box" size=".1 .2 .3" euler="0.3 0.1 0.2"/></default></default>',
    )
    body = load_format(saved(text, tmp_path)).bodies["b"]
    engine = mujoco.MjModel.from_xml_string(text)
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, engine.body_iquat[1])
    whole = turn.reshape(3, 3) @ np.diag(engine.body_inertia[1]) @ turn.reshape(3, 3).T
    assert np.array(body.inertia, dtype=float) == pytest.approx(whole, rel=1e-9)


def test_first_numbers_of_an_array_leave_the_others_to_the_class(tmp_path: Path) -> None:
    """Sizes of geoms and gears of balls as MuJoCo fills them; powers of damping that a class has are not lost."""
    text = model(
        '<body name="b"><joint name="j" type="ball"/><geom class="c" size="0.2"/></body>',
        '<default><default class="c"><geom type="box" size=".1 .3 .4"/><motor gear="0 0 3"/></default></default>'
        '<actuator><motor joint="j" gear="2" class="c"/></actuator>',
    )
    engine = mujoco.MjModel.from_xml_string(text)
    assert engine.geom_size[0] == pytest.approx([0.2, 0.3, 0.4]) and engine.actuator_gear[0][:3] @ [1, 0, 1] == 5
    with pytest.raises(DescriptionError, match="gear: expected one entry that is not zero, got 2"):
        load_format(saved(text, tmp_path))
    idle = text.replace('<motor joint="j" gear="2" class="c"/>', "")
    body = load_format(saved(idle, tmp_path)).bodies["b"]
    assert np.diag(np.array(body.inertia, dtype=float)) == pytest.approx(engine.body_inertia[1], rel=1e-12)
    bent = model(hinge("a", more='damping="2" class="c"'), '<default><default class="c"><joint damping="1 2"/>'
                 '</default></default>')  # fmt: skip
    assert mujoco.MjModel.from_xml_string(bent).dof_dampingpoly[0][0] == 2
    with pytest.raises(DescriptionError, match="powers of damping or stiffness above the first"):
        load_format(saved(bent, tmp_path))


def test_two_places_of_a_geom_are_told(tmp_path: Path) -> None:
    text = model('<body><joint/><geom type="capsule" size="0.1" fromto="0 0 0 1 0 0" pos="1 2 3"/></body>')
    assert "pos of geoms whose fromto says where they are" in import_file(saved(text, tmp_path)).account.harmless


@pytest.mark.parametrize("given", ['adhesion="3"', 'castshadow="false"', 'surfacevel="1 0 0"'])
def test_what_geoms_say_of_contacts_and_pictures_is_listed(tmp_path: Path, given: str) -> None:
    text = model(f'<body><joint/><geom size="0.1" {given}/></body>')
    plain, engine = mujoco.MjModel.from_xml_string(text.replace(given, "")), mujoco.MjModel.from_xml_string(text)
    assert engine.body_inertia == pytest.approx(plain.body_inertia)
    assert import_file(saved(text, tmp_path)).account.harmless[f"{given.partition('=')[0]} of geoms"] == 1


def test_a_free_joint_has_armature_and_damping(tmp_path: Path) -> None:
    """The same number in every direction and about every axis; a written file has them, too."""
    text = model(
        f'<body name="b"><joint name="f" type="free"/>{INERTIAL}</body>',
        '<default><joint armature="0.3" damping="0.2"/></default>',
    )
    robot = load_robot(saved(text, tmp_path))
    made, bare = derive(robot.mechanism, robot.effects), derive(robot.mechanism, robot.effects[:1])
    q, v, _ = made.system.states(2, 1)
    added = (made("mass_matrix", q)[0][0] - bare("mass_matrix", q)[0][0]).reshape(-1, 6, 6)
    assert added == pytest.approx(np.broadcast_to(0.3 * np.eye(6), added.shape), abs=1e-14)
    assert made("bias", q, v)[0][0] - bare("bias", q, v)[0][0] == pytest.approx(0.2 * v, abs=1e-13)
    assert save_robot(robot.mechanism, tmp_path / "again.xml", robot.effects) == []
    engine = mujoco.MjModel.from_xml_path(str(tmp_path / "again.xml"))
    assert engine.dof_armature == pytest.approx(np.full(6, 0.3)) and engine.dof_damping == pytest.approx(
        np.full(6, 0.2)
    )


FLYING = f"""<mujoco><worldbody><body pos="1 2 3" euler="30 40 50"><freejoint name="base"/>{INERTIAL}
<body pos="0.3 0 0" quat="0.6 0 0.8 0"><joint name="ball" type="ball"/>{INERTIAL}<body pos="0 0 0.2">
<joint name="hinge" axis="1 2 0" ref="20"/>{INERTIAL}<site name="tooth" pos="0.1 0.1 0.1"/></body></body></body>
</worldbody>
<keyframe><key name="bite" qpos="0.1 0.2 0.3 0.5 -0.5 0.7 0.1 0.3 0.4 -0.5 0.7 0.8" qvel="1 2 3 4 5 6 7 8 9 10"/>
<key name="still" qvel="0 0 0 0 0 0 0 0 0 0" ctrl=""/></keyframe></mujoco>"""


def test_keyframes_have_rates(tmp_path: Path) -> None:
    """A point moves as MuJoCo's site, and a scene begins so; a keyframe at rest has none."""
    path = saved(FLYING, tmp_path)
    robot = load_robot(path)
    system = System(robot.mechanism)
    q = np.array([[robot.starts["bite"][c.label] for c in system.tree.q]])
    v = np.array([[robot.start_rates["bite"][c.label] for c in system.tree.v]])
    points = next(f for f in kinematic_functions(system, Motion(system)) if f.name == "point_motion")
    velocity = evaluate(lower(points), [q, v, 0 * v])[0][1]
    engine = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(engine)
    mujoco.mj_resetDataKeyframe(engine, data, 0)
    mujoco.mj_forward(engine, data)
    found = np.zeros(6)
    mujoco.mj_objectVelocity(engine, data, mujoco.mjtObj.mjOBJ_SITE, 0, found, 0)
    assert velocity.ravel() == pytest.approx(found[3:], rel=1e-12)
    assert set(robot.start_rates) == {"bite"} and robot.starts["still"] == {}
    (tmp_path / "robot.toml").write_text(text_of(robot.mechanism, ".toml"))
    (tmp_path / "scene.toml").write_text(scene_text(robot, "robot.toml", "bite"))
    assert load_scene(tmp_path / "scene.toml").initial.rates == pytest.approx(robot.start_rates["bite"])
    fewer = saved(FLYING.replace(" 9 10", " 9"), tmp_path)
    assert system.tree.v[-1].label not in load_robot(fewer).start_rates["bite"]
    assert mujoco.MjModel.from_xml_path(str(fewer)).key_qvel[0][-1] == 0
    with pytest.raises(DescriptionError, match="qvel: expected 10 numbers, got 11"):
        load_format(saved(FLYING.replace(" 9 10", " 9 10 11"), tmp_path))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (model(TWO, '<default class="robot"><joint armature="1"/></default>'), "outermost default is of the class"),
        (model(TWO, '<option><flag springs="disable"/></option>'), "attribute 'springs' is not supported"),
        (model(TWO, '<option><flag spring="off"/></option>'), "expected spring='enable' or 'disable'"),
        (model('<joint name="w"/>' + TWO), "the world stands still and has no <joint>"),
        (model(f'<body name="b"><joint/>{INERTIAL}{INERTIAL}</body>'), "expected one <inertial>, got 2"),
        (model('<body><joint/><inertial mass="-1" pos="0 0 0" diaginertia="1 1 1"/></body>'), "at least 0 kg, got -1"),
        (
            model('<body><joint/><inertial mass="1" pos="0 0 0" fullinertia="1 1 1 0 0 0" euler="1 0 0"/></body>'),
            "expected euler or fullinertia, got both",
        ),
        (
            model(
                hinge("a", more='actuatorfrcrange="-1 1"'),
                '<actuator><position joint="a"/><position joint="a"/></actuator>',
            ),
            "actuatorfrcrange of a, which several actuators drive",
        ),
        (model(TWO, '<actuator><motor joint="a" delay="0.1" nsample="3"/></actuator>'), "left out: delay of actuators"),
        (model(hinge("a", more='range="-1 1" limited="True"')), "limited: expected true, false or auto, got 'True'"),
        (model(hinge("a", more='range="-1 1"')).replace("<compiler ", '<compiler autolimits="false" '), "add limited="),
        (
            model(TWO, '<actuator><motor joint="a" ctrlrange="0 1"/></actuator>').replace(
                "<compiler ", '<compiler autolimits="false" '
            ),
            "add ctrllimited=",
        ),
        (model(hinge("a", more='limited="true"')), "limited: is true, where range is missing"),
        (model(hinge("a", more='range="1 1" limited="true"')), "limited: is true, where range is '1 1'"),
    ],
)
def test_what_was_passed_over_is_refused(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        load_format(saved(text, tmp_path))


@pytest.mark.parametrize("automatic", ["true", "false"])
@pytest.mark.parametrize("switch", ["", 'limited="auto"', 'limited="true"', 'limited="false"'])
@pytest.mark.parametrize("reach", ["", 'range="-1 2"', 'range="0 0"', 'range="2 -1"', 'range="1 1"'])
def test_a_range_limits_where_it_does_in_mujoco(tmp_path: Path, automatic: str, switch: str, reach: str) -> None:
    text = model(hinge("a", more=f'axis="0 1 0" {reach} {switch}')).replace(
        "<compiler ", f'<compiler autolimits="{automatic}" '
    )
    try:
        wanted = bool(mujoco.MjModel.from_xml_string(text).jnt_limited[0])
    except ValueError:
        with pytest.raises(DescriptionError, match="limited"):
            load_robot(saved(text, tmp_path))
        return
    limits = load_robot(saved(text, tmp_path)).limits.get("a")
    assert wanted == (limits is not None and limits.lower is not None)


def test_included_files_name_what_is_beside_them(tmp_path: Path) -> None:
    """Files and meshes of an included file: below the main folder first, then below its own."""
    (tmp_path / "parts").mkdir()
    (tmp_path / "t.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    files = {
        "one": '<body name="A"><joint name="a"/><geom type="mesh" mesh="t"/><include file="two.xml"/></body>',
        "two": f'<body name="B"><joint name="b"/>{INERTIAL}</body>',
        "assets": '<asset><mesh file="../t.obj"/></asset>',
    }
    for name, inner in files.items():
        (tmp_path / "parts" / f"{name}.xml").write_text(f"<mujoco>{inner}</mujoco>")
    text = '<mujoco><include file="parts/assets.xml"/><worldbody><include file="parts/one.xml"/></worldbody></mujoco>'
    path = saved(text, tmp_path)
    body = load_format(path).bodies["A"]
    engine = mujoco.MjModel.from_xml_path(str(path))
    assert float(body.mass or 0) == pytest.approx(engine.body_mass[1], rel=1e-9) and engine.nbody == 3
    (tmp_path / "t.obj").write_text("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 7\n")
    with pytest.raises(DescriptionError, match="its pointer of Git LFS"):
        load_format(path)


LINKS = "".join(
    f'<link name="{name}"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    "</inertial></link>"
    for name in ("base", "one", "two")
)
JOINT = '<joint name="{0}" type="{1}"><parent link="{2}"/><child link="{3}"/><axis xyz="0 1 0"/>{4}</joint>'


def robot_of(first: str = "", *, kind: str = "continuous", rest: str = "", space: str = "") -> str:
    joints = JOINT.format("a", kind, "base", "one", first) + JOINT.format("b", "continuous", "one", "two", "")
    return f'<robot {space} name="r">{LINKS}{joints}{rest}</robot>'


def test_of_elements_that_occur_twice_the_first_counts(tmp_path: Path) -> None:
    """As in ROS' own parser; it is said."""
    twice = '<dynamics damping="1" K="7"/><dynamics damping="3"/><axis xyz="1 0 0"/><limit effort="-3" velocity="2"/>'
    found = import_file(saved(robot_of(twice), tmp_path, "robot.urdf"))
    assert [force["coefficient"] for force in found.forces] == [1.0]
    assert found.limits["a"].effort is None and found.limits["a"].velocity == 2
    assert found.account.changed == ("limits of a: effort -3 is below 0; it is not taken",)
    for what in (
        "a second <dynamics> of a joint: the first one counts",
        "a second <axis> of a joint: the first one counts",
        "attributes of <dynamics> that a URDF does not have: K",
    ):
        assert found.account.harmless[what] == 1


def test_what_gazebo_and_dialects_say_of_forces(tmp_path: Path) -> None:
    section = (
        '<gazebo reference="a"><springStiffness>3</springStiffness><springReference>0.2</springReference></gazebo>'
        '<gazebo reference="two"><turnGravityOff>true</turnGravityOff></gazebo>'
        '<gazebo reference="two"><inertial><mass>5</mass></inertial></gazebo>'
    )
    text = robot_of('<dynamics armature="0.5" damping="0"/>', rest=section, space='xmlns="http://drake.mit.edu"')
    found = import_file(saved(text, tmp_path, "robot.urdf"))
    assert [{**force} for force in found.forces] == [
        {"kind": "armature", "joint": "a", "inertia": 0.5},
        {"kind": "spring", "joint": "a", "stiffness": 3.0, "rest": 0.2},
    ]
    assert found.account.changed == (
        "gravity acts on two, from which <gazebo> takes it",
        "two has the inertia of its <link>, not that of <gazebo>",
    )


MIMIC = "<joint>a</joint><mimicJoint>b</mimicJoint><multiplier>-2</multiplier><offset>0.3</offset>"
FOLLOWING = {
    "drake": '<drake:mimic joint="a" multiplier="-2" offset="0.3"/>',
    "ros2_control": '<ros2_control name="r" type="system"><joint name="b"><param name="mimic">a</param>'
    '<param name="multiplier">-2</param><param name="offset">0.3</param></joint></ros2_control>',
    "gazebo": f'<gazebo><plugin name="p" filename="libmimic.so">{MIMIC}</plugin></gazebo>',
}


@pytest.mark.parametrize("name", FOLLOWING)
def test_joints_that_others_say_to_follow_are_coupled(tmp_path: Path, name: str) -> None:
    """As a <mimic> of the joint would, which counts where there is one as well."""
    own = FOLLOWING["drake"].replace("drake:", "")
    space, said = 'xmlns:drake="http://drake.mit.edu"', FOLLOWING[name]

    def read(of_joint: str, rest: str) -> Mechanism:
        text = robot_of(rest=rest, space=space).replace('<axis xyz="0 1 0"/></joint></robot>', "</joint></robot>")
        joint = f'<parent link="one"/>{of_joint}'
        return load_format(saved(text.replace('<parent link="one"/>', joint), tmp_path, "robot.urdf"))

    inside = name == "drake"
    plain = read(own, "")
    found = read(said if inside else "", "" if inside else said)
    assert found.couplings == plain.couplings and len(found.couplings) == 1
    assert {j.name: (j.driven, j.reference) for j in found.joints.values()}["b"] == ((), plain.joints["b"].reference)
    if not inside:
        both = read(own.replace("-2", "0.5"), said)
        assert both.couplings == read(own.replace("-2", "0.5"), "").couplings != plain.couplings


def test_reductions_are_those_of_the_actuators(tmp_path: Path) -> None:
    """An actuator's own before its joint's, every actuator for itself; an orientation may be a quaternion."""
    motor = (
        "<actuator name='{0}'><mechanicalReduction>{1}</mechanicalReduction><motorInertia>{2}</motorInertia></actuator>"
    )
    joint = (
        '<transmission name="t"><joint name="a"><mechanicalReduction>5</mechanicalReduction></joint>{0}</transmission>'
    )
    rest = joint.format(motor.format("m", 10, 1e-3) + motor.format("n", 20, 2e-3))
    robot = load_robot(saved(robot_of(rest=rest), tmp_path, "robot.urdf"))
    made = derive(robot.mechanism, robot.effects)
    plain = derive(robot.mechanism, robot.effects[:1])
    q, v, a = made.test_inputs["inverse_dynamics"][:3]
    more = made("inverse_dynamics", q, v, a)[0][0][:, 0] - plain("inverse_dynamics", q, v, a)[0][0][:, 0]
    assert more == pytest.approx((100 * 1e-3 + 400 * 2e-3) * a[:, 0], rel=1e-12)
    turned = '<parent link="base"/><origin xyz="1 2 3" {0}/>'
    texts = [robot_of().replace('<parent link="base"/>', turned.format(by))
             for by in ('rpy="0 0 1.5707963267948966"', 'quat_xyzw="0 0 0.3 0.3"')]  # fmt: skip
    one, other = (load_format(saved(text, tmp_path, "robot.urdf")) for text in texts)
    assert one.joints == other.joints and one.joints["a"].axes[0][0] == -1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            robot_of().replace(
                '<parent link="base"/>', '<parent link="base"/><origin rpy="0 0 1" quat_xyzw="0 0 0 1"/>'
            ),
            "expected one orientation, got rpy and quat_xyzw",
        ),
        (robot_of('<dynamics damping="1"/>', kind="floating"), "left out: damping of a floating joint"),
        (robot_of(rest='<include filename="arm.urdf"/>'), "left out: <include>"),
        (
            robot_of(
                rest='<transmission name="t"><joint name="a"/><actuator name="m"><rotorInertia>1</rotorInertia>'
                "<mechanicalReduction>0</mechanicalReduction></actuator></transmission>"
            ),
            "expected a reduction that is not 0",
        ),
    ],
)
def test_what_a_urdf_cannot_mean_is_refused(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        load_format(saved(text, tmp_path, "robot.urdf"))


def test_a_written_urdf_keeps_the_constant_of_a_mimic_joint(tmp_path: Path) -> None:
    """Its joints follow by factor and offset, also where limits are given in part; ROS' parser wants them whole."""
    tie = '<equality><joint joint1="b" joint2="a" polycoef="0.1 0.5"/></equality>'
    text = model(hinge("a", hinge("b"), 'axis="0 1 0" range="-1 2"'), f'{tie}<actuator><motor joint="a"/></actuator>')
    robot = load_robot(saved(text, tmp_path))
    assert save_robot(robot.mechanism, tmp_path / "again.urdf", robot.effects, limits=robot.limits) == []
    written = (tmp_path / "again.urdf").read_text()
    assert '<mimic joint="a" multiplier="0.5" offset="0.1" />' in written
    assert '<limit effort="1000000" velocity="1000000" lower="-1" upper="2" />' in written
    again = load_robot(tmp_path / "again.urdf")
    assert again.limits == robot.limits and difference(robot.mechanism, again.mechanism) is None
    (tmp_path / "other.urdf").write_text(written.replace('offset="0.1"', ""))
    assert difference(robot.mechanism, load_format(tmp_path / "other.urdf")) is not None


SDF = (
    '<robot name="r"><link name="base"/>{0}'
    '<joint name="h" type="continuous"><parent link="base"/><child link="nut"/><axis xyz="0 0 1"/></joint>'
    '<joint name="s" type="prismatic"><parent link="base"/><child link="rod"/><axis xyz="0 0 1"/></joint>'
    '<gazebo><joint name="thread" type="screw"><parent>{1}</parent><child>nut</child><axis><xyz>0 0 1</xyz></axis>{2}'
    "</joint></gazebo></robot>"
)
MASS = '<inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1"/></inertial>'
THREADED = "".join(f'<link name="{name}">{MASS}</link>' for name in ("nut", "rod"))


@pytest.mark.parametrize(
    ("said", "pitch"),
    [
        ("<screw_thread_pitch>0.004</screw_thread_pitch>", 0.004 / (2 * np.pi)),
        ("<thread_pitch>-500</thread_pitch>", 0.002),
        ("", -1.0),
    ],
)
def test_screws_of_sdf_close_loops(tmp_path: Path, said: str, pitch: float) -> None:
    """The nut turns about the rod on which it does not slide: SDF's pitch is m per turn, the older one rad per m."""
    path = tmp_path / "robot.urdf"
    path.write_text(SDF.format(THREADED, "rod", said))
    mechanism = load_format(path)
    assert float(mechanism.number(mechanism.joints["thread"].pitch)) == pytest.approx(pitch, rel=1e-14)
    model = derive(mechanism)
    q, status = model("assemble", [0.3], [0.0, 0.3 * abs(pitch)])
    assert status == 0 and abs(q[0][1]) == pytest.approx(0.3 * abs(pitch), rel=1e-12)


def test_a_loop_of_gazebo_with_a_link_that_is_not_there_needs_a_word(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text(SDF.format(THREADED, "rode", ""))
    with pytest.raises(DescriptionError, match=r"'thread'> in <gazebo>: there is no link 'rode'.*--accept"):
        load_format(path)
    path.write_text(SDF.format(THREADED, "rod", "<thread_pitch>0</thread_pitch>"))
    with pytest.raises(DescriptionError, match="a thread_pitch that is not 0"):
        load_format(path)


@pytest.mark.parametrize(
    ("extension", "actuator", "influence"),
    [
        ('<plugin plugin="mujoco.sensor.touch_grid"/>', '<adhesion body="a" ctrlrange="0 1"/>', ""),
        ('<plugin plugin="mujoco.pid"/>', "", "<extension>"),
    ],
)
def test_what_holds_contacts_and_makes_sensors_has_no_influence(
    tmp_path: Path, extension: str, actuator: str, influence: str
) -> None:
    """And a weld may be called as a joint is, a motor have a class of muscles."""
    path = tmp_path / "robot.xml"
    path.write_text(
        f"<mujoco><extension>{extension}</extension><default><muscle scale='9' range='0.5 1'/></default><worldbody>"
        "<body name='a'><joint name='j'/><geom size='1'/><body name='b' pos='1 0 0'><joint name='k'/>"
        f"<geom size='1'/></body></body></worldbody><equality><connect name='j' body1='b' anchor='0 0 0'/></equality>"
        f"<actuator>{actuator}<motor joint='k'/></actuator></mujoco>"
    )
    if influence:
        with pytest.raises(DescriptionError, match=f"would be left out: {influence}"):
            load_format(path)
        return
    found = import_file(path)
    assert list(found.mechanism.joints) == ["j", "k", "j_2"] and found.mechanism.joints["k"].driven
    assert {"<extension>", "<adhesion>, which holds contacts"} <= set(found.account.harmless)
