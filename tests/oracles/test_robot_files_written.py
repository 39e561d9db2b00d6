"""What acts on a robot in the files that are written: read back it is the same, and MuJoCo sees the same forces."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

from symscrew import catalogue
from symscrew.cli import main
from symscrew.effects import Effect, effect_from_table, effect_to_table, load_effects
from symscrew.errors import DescriptionError
from symscrew.model import derive
from symscrew.scene import Robot, load_robot, save_robot

from .test_import_details import INERTIAL
from .test_imports import GRIPPER, arm, saved

MORE = GRIPPER.replace('<body name="thumb"', '<body name="thumb" gravcomp="0.25"').replace(
    '<motor joint="lift"', '<position joint="r" kp="7"/><motor joint="lift"'
)


def tables(robot: Robot) -> list[tuple[str, ...]]:
    """The effects of a robot, numbers as doubles, in an order of their own."""

    def plain(value: object) -> str:
        if isinstance(value, list | tuple):
            return " ".join(map(plain, value))
        try:
            return f"{float(value):.12g}"  # type: ignore[arg-type]
        except ValueError:
            return str(value)

    def table(effect: Effect) -> tuple[str, ...]:
        return tuple(f"{key}={plain(value)}" for key, value in sorted(effect_to_table(effect).items()))

    return sorted(map(table, robot.effects))


def test_an_mjcf_keeps_effects_couplings_and_limits(tmp_path: Path) -> None:
    robot = load_robot(saved(MORE, tmp_path))
    assert save_robot(robot.mechanism, tmp_path / "again.xml", robot.effects, limits=robot.limits) == []
    again = load_robot(tmp_path / "again.xml")
    assert tables(again) == tables(robot) and again.limits == robot.limits
    assert len(again.mechanism.couplings) == len(robot.mechanism.couplings) == 2
    engines = [mujoco.MjModel.from_xml_path(str(tmp_path / name)) for name in ("robot.xml", "again.xml")]
    found = []
    for engine in engines:
        data = mujoco.MjData(engine)
        data.qpos[:], data.qvel[:] = np.add(engine.qpos0, [0.1, 0.2, 0.3, 0.4]), [0.5, -0.6, 0.7, -0.8]
        mujoco.mj_forward(engine, data)
        full = np.zeros((4, 4))
        mujoco.mj_fullM(engine, data, full)
        found.append((full, data.qfrc_bias.copy(), data.qfrc_passive.copy(), data.qfrc_actuator.sum()))
    for one, other in zip(*found, strict=True):
        assert other == pytest.approx(one, rel=1e-7, abs=1e-7)


def test_a_urdf_keeps_what_it_holds(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    drive = (
        '<transmission name="t"><joint name="A"/><actuator name="m"><mechanicalReduction>50</mechanicalReduction>'
        "<rotorInertia>1e-5</rotorInertia></actuator></transmission>"
    )
    text = arm(drive, end='<mimic joint="A" multiplier="-2"/><dynamics damping="0.5" friction="0.125"/>')
    robot = load_robot(saved(text, tmp_path, "robot.urdf"))
    save_robot(robot.mechanism, tmp_path / "again.urdf", robot.effects, limits=robot.limits)
    again = load_robot(tmp_path / "again.urdf")
    assert tables(again) == tables(robot) and again.limits["A"] == robot.limits["A"]
    assert list(again.mechanism.couplings) == ["B_mimic"]
    saved(MORE, tmp_path)
    arguments = ["convert", str(tmp_path / "robot.xml"), "--out", str(tmp_path / "less.urdf")]
    assert main([*arguments, "--bare"]) == 2  # a polynomial coupling is no mimic joint
    plain = MORE.replace("0 -1 0.2 0 0", "0 -1 0 0 0").replace('<tendon tendon1="both" polycoef="0"/>', "")
    plain = plain.replace('<position joint="r" kp="7"/>', "")
    saved(plain, tmp_path)
    assert main(arguments) == 2
    assert "a .urdf file does not hold" in capsys.readouterr().err and not (tmp_path / "less.urdf").exists()
    assert main([*arguments, "--accept"]) == 0
    assert "left out of less.urdf: spring of l" in capsys.readouterr().err


@pytest.mark.slow
def test_effects_of_a_scene_go_into_the_file(tmp_path: Path) -> None:
    scene = tmp_path / "acts.toml"
    effects = (
        ("rotor_inertia", 'joint = "A"\ninertia = "2e-3"\nratio = 4'),
        ("viscous_friction", 'joint = "D"\ncoefficient = 0.3'),
        ("gravity", "acceleration = [0, 0, -1.6]"),
    )
    scene.write_text("".join(f'[[effects]]\ntype = "{kind}"\n{keys}\n' for kind, keys in effects))
    out = tmp_path / "four_bar.xml"
    assert main(["convert", "four_bar", "--effects", str(scene), "--out", str(out)]) == 0
    robot = load_robot(out)
    gathered = {type(effect).__name__ for effect in robot.effects}
    assert gathered == {"Gravity", "RotorInertia", "ViscousFriction"}
    first, second = derive(catalogue.load("four_bar"), load_effects(scene)), derive(robot.mechanism, robot.effects)
    rotor = next(effect for effect in second.effects if type(effect).__name__ == "RotorInertia")
    assert float(rotor.inertia) == pytest.approx(2e-3 * 16)  # MJCF's armature is reflected already
    assert len(first.system.drives) == len(second.system.drives) == 1
    start = np.array([float(second.system.reference[k]) for k in range(len(second.system.tree.q))])
    drive = [
        m("inverse_dynamics", m.system.reference, 0 * m.system.reference, 0 * m.system.reference)[0][0]
        for m in (first, second)
    ]
    assert start.size == 3 and drive[1] == pytest.approx(drive[0], rel=1e-6)  # weights under the moon's gravity
    motor = effect_from_table(
        {"type": "dc_motor", "joint": "A", "torque_constant": 1, "resistance": 1, "inductance": 1}
    )
    with pytest.raises(DescriptionError, match=r"does not hold dc_motor.*--accept"):
        save_robot(catalogue.load("four_bar"), out, [motor])


def test_joints_of_one_body_stay_its_own(tmp_path: Path) -> None:
    """Nothing is raised, and MuJoCo has the same numbers from the written file to rounding."""
    joints = (
        '<joint name="x" axis="1 0.2 0" pos="0.1 0 0" ref="0.2"/><joint name="y" type="slide" axis="0 1 0.3"/>'
        '<joint name="z" axis="0 0.1 1" pos="0 0.2 0" armature="0.1"/>'
    )
    inertial = '<inertial pos="0.1 0.03 0.02" mass="1.5" diaginertia="0.01 0.02 0.025"/>'
    text = (
        '<mujoco><compiler angle="radian"/><worldbody>'
        f'<body name="hip" pos="0.1 0 1" euler="0.3 0.2 0.1">{joints}{inertial}'
        f'<body name="knee" pos="0.3 0 0"><joint name="k"/>{inertial}</body></body></worldbody></mujoco>'
    )
    robot = load_robot(saved(text, tmp_path))
    assert save_robot(robot.mechanism, tmp_path / "again.xml", robot.effects, limits=robot.limits) == []
    again = load_robot(tmp_path / "again.xml")
    assert set(again.mechanism.joints) == set(robot.mechanism.joints) and tables(again) == tables(robot)
    assert list(again.mechanism.bodies) == list(robot.mechanism.bodies)
    found = []
    for name in ("robot.xml", "again.xml"):
        engine = mujoco.MjModel.from_xml_path(str(tmp_path / name))
        assert (engine.nbody, engine.njnt) == (3, 4)
        data = mujoco.MjData(engine)
        data.qpos[:], data.qvel[:] = np.add(engine.qpos0, [0.1, 0.2, 0.3, 0.4]), [0.5, -0.6, 0.7, -0.8]
        mujoco.mj_forward(engine, data)
        full = np.zeros((4, 4))
        mujoco.mj_fullM(engine, data, full)
        found.append((full, data.qfrc_bias.copy()))
    for one, other in zip(*found, strict=True):
        assert other == pytest.approx(one, rel=1e-12, abs=1e-12)


def test_tendons_are_written_as_tendons(tmp_path: Path) -> None:
    """No body for the pulley, no soft constraint: MuJoCo has the accelerations of the file that was read."""
    inertial = '<inertial pos="0.1 0.03 0.02" mass="1.5" diaginertia="0.01 0.02 0.025"/>'
    text = (
        '<mujoco><compiler angle="radian"/><worldbody>'
        f'<body name="A"><joint name="a" axis="0 1 0" ref="0.2"/>{inertial}'
        f'<body name="B" pos="0.2 0 0"><joint name="b" axis="1 0 0"/>{inertial}</body></body></worldbody><tendon>'
        '<fixed name="t" stiffness="3" damping="0.4" armature="0.1" springlength="0.7"><joint joint="a" coef="2"/>'
        '<joint joint="b" coef="-3"/></fixed><fixed name="s" damping="0.2"><joint joint="a" coef="0.3"/>'
        '<joint joint="b" coef="0.5"/></fixed></tendon><actuator>'
        '<position tendon="t" kp="70" kv="0.3" gear="2" forcerange="-3 4"/>'
        '<motor name="m" tendon="s"/></actuator></mujoco>'
    )
    robot = load_robot(saved(text, tmp_path))
    assert save_robot(robot.mechanism, tmp_path / "again.xml", robot.effects, limits=robot.limits) == []
    again = load_robot(tmp_path / "again.xml")
    assert tables(again) == tables(robot) and again.mechanism.couplings == robot.mechanism.couplings
    assert {j.name: j.driven for j in again.mechanism.joints.values()} == {
        j.name: j.driven for j in robot.mechanism.joints.values()
    }
    found = []
    for name in ("robot.xml", "again.xml"):
        engine = mujoco.MjModel.from_xml_path(str(tmp_path / name))
        assert (engine.nbody, engine.neq, engine.ntendon) == (3, 0, 2)
        data = mujoco.MjData(engine)
        data.qpos[:], data.qvel[:] = np.add(engine.qpos0, [0.1, 0.2]), [0.5, -0.6]
        mujoco.mj_forward(engine, data)
        found.append(data.qacc.copy())
    assert found[1] == pytest.approx(found[0], rel=1e-12)


def table(kind: str, **keys: object) -> Effect:
    return effect_from_table({"type": kind, "joint": "A", **keys})


def test_two_rotors_of_one_joint_are_one_of_a_urdf(tmp_path: Path) -> None:
    """A transmission has one reduction: 0.5 at 3 to 1 and 0.1 at 2 to 1 are 4.9 together."""
    mechanism = load_robot(saved(arm(), tmp_path, "robot.urdf")).mechanism
    rotors = [table("rotor_inertia", inertia=0.5, ratio=3), table("rotor_inertia", inertia=0.1, ratio=2)]
    save_robot(mechanism, tmp_path / "again.urdf", rotors, accept=True)
    (again,) = (
        effect_to_table(e) for e in load_robot(tmp_path / "again.urdf").effects if getattr(e, "joint", "") == "A"
    )
    assert float(again["inertia"]) * float(again.get("ratio", 1)) ** 2 == pytest.approx(4.9, rel=1e-14)


def test_what_damps_without_a_spring_and_what_creeps_otherwise(tmp_path: Path) -> None:
    mechanism = load_robot(saved(arm(), tmp_path, "robot.urdf")).mechanism
    damper = effect_from_table({"type": "joint_spring", "joint": "A", "damping": 0.5})
    assert save_robot(mechanism, tmp_path / "again.xml", [damper]) == []
    assert mujoco.MjModel.from_xml_path(str(tmp_path / "again.xml")).dof_damping.max() == 0.5
    creeping = table("dry_friction", coulomb=0.5, velocity=0.05)
    for suffix in ("xml", "urdf"):
        with pytest.raises(DescriptionError, match="does not hold friction of A"):
            save_robot(mechanism, tmp_path / f"creeping.{suffix}", [creeping])


PULLED = f"""<mujoco><compiler angle="radian"/><worldbody><body><joint name="a" axis="0 1 0"/>{INERTIAL}
<body pos="0.2 0 0"><joint name="b" axis="0 1 0"/>{INERTIAL}</body></body></worldbody>
<tendon><fixed name="t"><joint joint="a" coef="2"/><joint joint="b" coef="-3"/></fixed></tendon>
<actuator><motor joint="a" forcerange="-1 1"/><position tendon="t" kp="90"/></actuator></mujoco>"""


def test_the_reach_of_a_drive_does_not_hold_a_tendon_back(tmp_path: Path) -> None:
    robot = load_robot(saved(PULLED, tmp_path))
    assert save_robot(robot.mechanism, tmp_path / "again.xml", robot.effects, limits=robot.limits) == []
    assert load_robot(tmp_path / "again.xml").limits == robot.limits
    found = []
    for name, commands in (("robot.xml", {"a": 5.0, "t": 2.0}), ("again.xml", {"a": 5.0, "t": 2.0})):
        engine = mujoco.MjModel.from_xml_path(str(tmp_path / name))
        data = mujoco.MjData(engine)
        for k in range(engine.nu):
            tendon = engine.actuator_trntype[k] == mujoco.mjtTrn.mjTRN_TENDON
            data.ctrl[k] = commands["t" if tendon else "a"]
        mujoco.mj_forward(engine, data)
        found.append(data.qacc.copy())
    assert found[1] == pytest.approx(found[0], rel=1e-9) and np.abs(found[0]).max() > 100
