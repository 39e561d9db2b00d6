"""What of robots' files takes more than a word to take over: tendons, ratios, meshes, rigid groups; MuJoCo is asked."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, import_file, load_format
from symscrew.formats.rigid_displacements import CONTEXT, UNITS, about, dot
from symscrew.model import derive
from symscrew.scene import load_robot, save_robot

INERTIAL = '<inertial pos="0.1 0 0.02" mass="1.5" diaginertia="0.01 0.02 0.025"/>'
HAND = f"""<mujoco model="hand"><compiler angle="radian"/>
<default><joint armature="0.05"/><default class="soft"><tendon stiffness="3" damping="0.4"/></default></default>
<worldbody><body name="palm" gravcomp="0.5"><joint name="wrist" axis="0 1 0" ref="0.2"/>{INERTIAL}
<body name="near" pos="0.2 0 0"><joint name="n" axis="0 1 0"/>{INERTIAL}
<body name="far" pos="0.2 0 0"><joint name="f" axis="0 1 0.2"/>{INERTIAL}
<body name="tip" pos="0.1 0 0"><joint name="t" axis="0 0 1"/>{INERTIAL}</body></body></body></body>
<body name="slider"><joint name="s" type="slide" axis="0 0 1"/>{INERTIAL}</body></worldbody>
<tendon><fixed name="cord" class="soft"><joint joint="n" coef="0.5"/><joint joint="f" coef="-1.25"/></fixed>
<fixed name="one"><joint joint="t" coef="2"/></fixed></tendon>
<actuator><position tendon="cord" kp="40" dampratio="0.7" gear="2"/><motor tendon="one" gear="3"/>
<general joint="wrist" biastype="affine" gainprm="5" biasprm="0 -20 -1.5"/>
<position joint="s" kp="30" dampratio="1"/></actuator></mujoco>"""


def saved(text: str, folder: Path, name: str = "robot.xml") -> Path:
    path = folder / name
    path.write_text(text)
    return path


def test_drives_on_tendons_and_damping_by_ratio(tmp_path: Path) -> None:
    """Accelerations under drives, tendon forces, servos and carried weight are MuJoCo's."""
    robot = load_robot(saved(HAND, tmp_path))
    assert not robot.account.influence and {j.name: j.driven for j in robot.mechanism.joints.values()} == {
        "wrist": (0,), "n": (), "f": (), "t": (0,), "s": (0,), "cord": (0,),
    }  # fmt: skip
    model = derive(robot.mechanism, robot.effects)
    engine = mujoco.MjModel.from_xml_string(HAND)
    data = mujoco.MjData(engine)
    q, v, _ = model.system.states(3, 2)
    labels = [c.label for c in model.system.tree.v]
    names = ("wrist", "n", "f", "t", "s")
    order = [labels.index(name) for name in names]
    program = model.programs["forward_dynamics"]
    commands = {"wrist": 0.3, "cord": -0.2, "s": 0.1}
    target = {f"servo_{name}": np.array([value, 0.0]) for name, value in commands.items()}
    torque = {"t": 1.7}
    drives = next(port for port in program.inputs if port.name == "u")
    u = np.array([torque.get(label, 0.0) for label in drives.labels])
    given = [{"q": q, "v": v, "u": u, **target}[port.name] for port in program.inputs]
    found, status = model("forward_dynamics", *given)
    assert not np.any(status)
    for k in range(len(q)):
        data.qpos[:], data.qvel[:] = q[k][order], v[k][order]
        # a servo's command is a displacement here: that of the tendon is geared, that of the general one scaled
        data.ctrl[:] = 2 * commands["cord"], torque["t"] / 6, commands["wrist"] * 20 / 5, commands["s"]
        mujoco.mj_forward(engine, data)
        assert found[0][k][order] == pytest.approx(data.qacc, rel=1e-9, abs=1e-10)


L_SHAPE = np.array([(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)], dtype=float)


def l_shaped(folder: Path) -> None:
    """A block with an L as its base, in tenths of metres; quadrilaterals, and one corner raised: not all are flat."""
    lines = [f"v {x} {y} {z}" for z in (0, 1) for x, y in L_SHAPE]
    lines[9] = "v 1 1 1.4"
    lines += ["f 1 4 3 2", "f 1 6 5 4", "f 7 8 9 10", "f 7 10 11 12"]
    lines += [f"f {k + 1} {(k + 1) % 6 + 1} {(k + 1) % 6 + 7} {k + 7}" for k in range(6)]
    (folder / "l.obj").write_text("\n".join(lines))


def test_a_compiler_of_before_asks_for_exact_meshes(tmp_path: Path) -> None:
    """The engine has the setting no more, and the word at the mesh in its place."""
    l_shaped(tmp_path)
    text = """<mujoco>{}<asset><mesh file="l.obj"{}/></asset><worldbody><body name="b"><joint/>
    <geom type="mesh" mesh="l"/></body></worldbody></mujoco>"""
    now, before = text.format("", ' inertia="exact"'), text.format('<compiler exactmeshinertia="true"/>', "")
    masses = [load_format(saved(given, tmp_path)).bodies["b"].mass for given in (now, before, text.format("", ""))]
    assert masses[0] == masses[1] != masses[2]


@pytest.mark.parametrize(
    ("shape", "kind"),
    [
        ("mesh", "legacy"),
        ("mesh", "exact"),
        ("mesh", "shell"),
        ("capsule", "legacy"),
        ("cylinder", "exact"),
        ("box", "shell"),
    ],
)
def test_meshes_that_are_not_convex(tmp_path: Path, kind: str, shape: str) -> None:
    """Of every kind that MuJoCo has, with the scale of a default class; and what is fitted to a mesh."""
    l_shaped(tmp_path)
    text = f"""<mujoco><default><mesh scale="0.1 0.1 0.1"/></default>
    <asset><mesh file="l.obj" inertia="{kind}"/></asset>
    <worldbody><body name="b"><joint/><geom type="{shape}" mesh="l" pos="0.3 0 0" euler="20 30 40"/></body></worldbody>
    </mujoco>"""
    path = saved(text, tmp_path)
    engine = mujoco.MjModel.from_xml_path(str(path))
    body = load_format(path).bodies["b"]
    assert body.com is not None and body.inertia is not None
    assert float(body.mass or 0) == pytest.approx(engine.body_mass[1], rel=1e-6)
    assert [float(c) for c in body.com] == pytest.approx(list(engine.body_ipos[1]), rel=1e-6)
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, engine.body_iquat[1])
    whole = turn.reshape(3, 3) @ np.diag(engine.body_inertia[1]) @ turn.reshape(3, 3).T
    assert np.array(body.inertia, dtype=float) == pytest.approx(whole, rel=1e-5, abs=1e-6 * np.abs(whole).max())


CORNERS = np.array([[0, 0, 0], [0.3, 0, 0], [0, 0.2, 0], [0, 0, 0.25], [0.05, 0.04, 0.05]], "<f4")
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], "<i4")


@pytest.mark.parametrize("faces", [FACES, FACES[:0]], ids=["faces", "points"])
def test_the_engines_own_mesh_files(tmp_path: Path, faces: np.ndarray) -> None:
    parts = [np.array([len(CORNERS), 5, 5, len(faces)], "<i4"), CORNERS, CORNERS, CORNERS[:, :2], faces]
    content = b"".join(np.ascontiguousarray(part).tobytes() for part in parts)
    (tmp_path / "m.msh").write_bytes(content)
    text = """<mujoco><asset><mesh file="m.msh" inertia="exact"/></asset><worldbody><body name="b"><joint/>
    <geom type="mesh" mesh="m"/></body></worldbody></mujoco>"""
    path = saved(text, tmp_path)
    engine, body = mujoco.MjModel.from_xml_path(str(path)), load_format(path).bodies["b"]
    assert float(body.mass or 0) == pytest.approx(engine.body_mass[1], rel=1e-6)
    assert float(np.trace(np.array(body.inertia, dtype=float))) == pytest.approx(engine.body_inertia[1].sum(), rel=1e-6)
    for cut, says in ((content[:-4], "expected .* bytes for"), (content[:12], "no valid .msh file")):
        (tmp_path / "m.msh").write_bytes(cut)
        with pytest.raises(DescriptionError, match=says):
            load_format(path)


@pytest.mark.slow
def test_armature_and_friction_of_a_ball(tmp_path: Path) -> None:
    text = f"""<mujoco><worldbody><body name="b"><joint name="j" type="ball" armature="0.3" frictionloss="0.2"/>
    {INERTIAL}</body></worldbody></mujoco>"""
    robot = load_robot(saved(text, tmp_path))
    model = derive(robot.mechanism, robot.effects)
    bare = derive(robot.mechanism, robot.effects[:1])
    q, v, _ = model.system.states(2, 1)
    added = (model("mass_matrix", q)[0][0] - bare("mass_matrix", q)[0][0]).reshape(-1, 3, 3)
    assert added == pytest.approx(np.broadcast_to(0.3 * np.eye(3), added.shape), abs=1e-14)
    lost = model("bias", q, v)[0][0] - bare("bias", q, v)[0][0]
    rates = model("joint_rates", q, v)[0][0]  # in the parent's axes, the coordinates' in the child's
    friction = 0.2 * rates / np.sqrt(rates**2 + 1e-6)
    assert np.linalg.norm(lost, axis=1) == pytest.approx(np.linalg.norm(friction, axis=1), rel=1e-12)
    assert (lost * v).sum(axis=1) == pytest.approx((friction * rates).sum(axis=1), rel=1e-12)
    engine = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    full = np.zeros((3, 3))
    mujoco.mj_fullM(engine, data, full)
    assert model("mass_matrix", [1.0, 0, 0, 0])[0][0].reshape(3, 3) == pytest.approx(full, abs=1e-14)


TWO_LEGS = f"""<mujoco><worldbody><body name="a"><joint type="ball"/>{INERTIAL}
<body name="b" pos="1 0 0"><joint type="ball"/>{INERTIAL}</body>
<body name="c" pos="0 1 0"><joint type="ball" armature="0.4"/>{INERTIAL}</body>
</body></worldbody><equality><connect body1="c" body2="b" anchor="0.2 0.1 -0.1"/></equality></mujoco>"""


def test_armature_of_a_ball_in_a_loop(tmp_path: Path) -> None:
    """Accelerations and drives' forces are in axes of their own: MuJoCo's equations of motion hold at moving states."""
    robot = load_robot(saved(TWO_LEGS, tmp_path))
    model = derive(robot.mechanism, robot.effects)
    q, v, _ = model.system.states(3, 1)
    (a,), status = model("forward_dynamics", q, v)
    assert not np.any(status)
    engine = mujoco.MjModel.from_xml_string(TWO_LEGS)
    engine.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    data = mujoco.MjData(engine)
    for k in range(1, len(q)):  # the first state is the reference, where all axes are the same
        data.qpos[:], data.qvel[:] = q[k], v[k]
        mujoco.mj_forward(engine, data)
        assert data.efc_pos == pytest.approx(np.zeros(3), abs=1e-12)
        full = np.zeros((9, 9))
        mujoco.mj_fullM(engine, data, full)
        free = np.linalg.svd(data.efc_J.reshape(3, 9))[2][3:]
        assert free @ (full @ a[k] + data.qfrc_bias) == pytest.approx(np.zeros(6), abs=1e-12)


def test_masses_as_the_compiler_wants_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Least masses and moments, balanced moments, a total: bodies as MuJoCo has them."""
    monkeypatch.chdir(tmp_path)  # where the engine writes that it deprecates one of them
    text = f"""<mujoco><compiler boundmass="0.5" boundinertia="0.012" balanceinertia="true" settotalmass="7"/>
    <worldbody><body name="a"><joint name="j"/>{INERTIAL}<body name="b" pos="0 0 1"><joint name="k"/>
    <inertial pos="0 0 0.1" mass="0.2" diaginertia="0.01 0.02 0.07" euler="20 0 0"/></body></body></worldbody>
    </mujoco>"""
    found = import_file(saved(text, tmp_path))
    engine = mujoco.MjModel.from_xml_string(text)
    for k, name in ((1, "a"), (2, "b")):
        body = found.mechanism.bodies[name]
        assert float(body.mass or 0) == pytest.approx(engine.body_mass[k], rel=1e-12)
        moments = np.linalg.eigvalsh(np.array(body.inertia, dtype=float))
        assert moments == pytest.approx(np.sort(engine.body_inertia[k]), rel=1e-9)
    assert {"boundmass", "boundinertia", "balanceinertia"} < set(found.account.effects)


def test_forces_at_sites_are_inputs_and_mocap_bodies_stand(tmp_path: Path) -> None:
    text = f"""<mujoco><worldbody><body name="hull"><freejoint/>{INERTIAL}<site name="rotor" pos="0.2 0 0.1"/></body>
    <body name="goal" mocap="true" pos="1 0 0"/></worldbody>
    <actuator><motor site="rotor" gear="0 0 1 0 0 0.1"/></actuator></mujoco>"""
    robot = load_robot(saved(text, tmp_path))
    model = derive(robot.mechanism, robot.effects)
    assert "load_rotor" in [port.name for port in model.programs["forward_dynamics"].inputs]
    assert "motion of mocap bodies, which stand still here" in robot.account.harmless


ODD = '<inertia ixx="{0}" ixy="0" ixz="0" iyy="{1}" iyz="0" izz="{2}"/>'
LINK = '<link name="{0}"><inertial><origin xyz="{1}"/><mass value="{2}"/>{3}</inertial></link>'
JOINT = (
    '<joint name="{0}" type="{1}"><parent link="{2}"/><child link="{3}"/><origin xyz="0.3 0 0.5"/>{4}'
    '<axis xyz="0 1 0"/></joint>'
)


MEDIUM = """<mujoco><compiler angle="radian"/><option MEDIUM/><worldbody><body name="a" quat="0.8 0.2 0.5 0.1">
<joint name="j" axis="0 1 0.3"/><inertial pos="0.1 0.2 0" mass="2" diaginertia="0.03 0.02 0.04" quat="0.6 0.3 0.2 0.1"/>
<body name="b" pos="0.3 0 0"><joint name="k" axis="1 0 0.2"/><joint name="s" type="slide" axis="0 0.6 0.8"/>
<geom type="cylinder" size="0.05 0.1" euler="0.3 0.2 0.1"/><body name="c" pos="0 0 0.1"><inertial pos="0 0.1 0" mass="1"
fullinertia="0.02 0.03 0.025 0.004 -0.002 0.001"/></body></body></body></worldbody></mujoco>"""


@pytest.mark.parametrize(
    ("given", "bodies"),
    [('density="900" viscosity="3" wind="0.3 -0.2 0.5"', "abc"), ('viscosity="0.1"', "a"), ('density="1.2"', "a")],
)
def test_a_medium_is_drag_of_every_body(tmp_path: Path, given: str, bodies: str) -> None:
    """Accelerations are MuJoCo's, also where moments are alike and only the file has their axes; writers refuse it.

    One of the two alone acts on one body: what is left of its formulas does not depend on the others.
    """
    text = MEDIUM.replace("MEDIUM", given)
    if bodies == "a":
        text = text.partition('<body name="b"')[0] + "</body></worldbody></mujoco>"
    robot = load_robot(saved(text, tmp_path))
    assert not robot.account.influence
    model = derive(robot.mechanism, robot.effects)
    engine = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(engine)
    q, v, _ = model.system.states(3, 2)
    order = [[c.label for c in model.system.tree.v].index(name) for name in ("j", "k", "s")[: len(bodies)]]
    a = model("forward_dynamics", q, v)[0][0]
    for k in range(len(q)):
        data.qpos[:], data.qvel[:] = q[k][order], v[k][order]
        mujoco.mj_forward(engine, data)
        assert a[k][order] == pytest.approx(data.qacc, rel=1e-10, abs=1e-10)
    with pytest.raises(DescriptionError, match=f"does not hold {', '.join(f'drag of {name}' for name in bodies)}"):
        save_robot(robot.mechanism, tmp_path / "again.xml", robot.effects)
    twins = text.replace(
        'pos="0.1 0.2 0" mass="2" diaginertia="0.03 0.02 0.04" quat="0.6 0.3 0.2 0.1"',
        'pos="0 0 0" mass="2" fullinertia="3 2 3 0 0 0"',
    )
    assert "two of its principal moments are equal" in " ".join(import_file(saved(twins, tmp_path)).account.changed)
    shaped = MEDIUM.replace("MEDIUM", given).replace('type="cylinder"', 'type="cylinder" fluidshape="ellipsoid"')
    with pytest.raises(DescriptionError, match="fluidshape"):
        load_robot(saved(shaped, tmp_path))


def test_what_is_rigid_together_has_one_inertia(tmp_path: Path) -> None:
    """A camera with moments that no body has, a pad without mass: both fixed. The arm has the sum of all three."""
    arm = LINK.format("arm", "0 0 0.1", 2, ODD.format(0.3, 0.3, 0.1))
    camera = LINK.format("camera", "0.1 0 0", 0.5, ODD.format(0.01, 0.01, 0.05))
    pad = LINK.format("pad", "0 0 0", 0, ODD.format(0.02, 0.02, 0.02))
    joints = JOINT.format("A", "revolute", "base", "arm", "") + JOINT.format("c", "fixed", "arm", "camera", "")
    joints += JOINT.format("p", "fixed", "camera", "pad", "")
    text = f'<robot name="r"><link name="base"/>{arm}{camera}{pad}{joints}</robot>'
    found = import_file(saved(text, tmp_path, "robot.urdf"))
    bodies = found.mechanism.bodies
    assert bodies["camera"].mass is None and bodies["pad"].mass is None and len(found.account.changed) == 2
    masses, places = (2, 0.5), (np.array([0, 0, 0.1]), np.array([0.4, 0, 0.5]))
    about_axis = sum(m * (p[0] ** 2 + p[2] ** 2) for m, p in zip(masses, places, strict=True)) + 0.3 + 0.01 + 0.02
    assert derive(found.mechanism)("mass_matrix", [0.7])[0][0] == pytest.approx([about_axis], rel=1e-13)
    turning = text.replace('name="c" type="fixed"', 'name="c" type="continuous"')
    with pytest.raises(DescriptionError, match=r"bodies\.camera: no body has the principal moments"):
        load_format(saved(turning.replace('name="p" type="fixed"', 'name="p" type="prismatic"'), tmp_path, "r.urdf"))


def test_names_of_nothing_and_single_bodies(tmp_path: Path) -> None:
    ends = '<mimic joint="gone"/>'
    link = LINK.format("arm", "0 0 0.1", 2, ODD.format(0.3, 0.3, 0.1))
    text = f'<robot name="r"><link name="base"/>{link}{JOINT.format("A", "revolute", "base", "arm", ends)}</robot>'
    path = saved(text, tmp_path, "robot.urdf")
    with pytest.raises(DescriptionError, match=r"<mimic> of 'A', which names no joint of the file: 'gone'"):
        load_format(path)
    assert not import_file(path, ImportOptions(accept=True)).mechanism.couplings
    drive = '<transmission name="t"><joint name="gone"/></transmission></robot>'
    path = saved(text.replace(ends, "").replace("</robot>", drive), tmp_path, "robot.urdf")
    with pytest.raises(DescriptionError, match="drive of 'gone', which is no joint of the file"):
        load_format(path)
    assert not import_file(path, ImportOptions(accept=True)).mechanism.joints["A"].driven
    both = drive.replace("</transmission>", '<joint name="A"/></transmission>')  # no joint is left that may be meant
    found = import_file(saved(text.replace(ends, "").replace("</robot>", both), tmp_path, "robot.urdf"))
    assert (
        found.mechanism.joints["A"].driven
        and "drive of 'gone', which is no joint of the file" in found.account.harmless
    )
    alone = import_file(saved(f'<robot name="r">{link}</robot>', tmp_path, "robot.urdf"))
    assert [joint.type for joint in alone.mechanism.joints.values()] == ["free"]


@pytest.mark.parametrize("angle", ["1e-7", "3e-8", "5e-9", "1.5707963", "1e-17"])
def test_rotations_by_small_angles_stay_rotations(angle: str) -> None:
    """A cosine is one to 15 digits long before its sine is nothing."""
    turn = about(UNITS[0], CONTEXT.mpf(angle))
    assert all(abs(dot(row, row) - 1) < 1e-40 for row in turn)


def test_a_body_outside_of_the_world_is_none_as_in_mujoco(tmp_path: Path) -> None:
    hand = f'<body name="hand"><joint name="thumb"/>{INERTIAL}</body>'
    ball = f'<worldbody><body name="ball"><freejoint/>{INERTIAL}</body></worldbody>'
    path = saved(f"<mujoco>{hand}{ball}</mujoco>", tmp_path)
    found = import_file(path)
    engine = mujoco.MjModel.from_xml_path(str(path))
    assert [*found.mechanism.bodies] == [engine.body(k).name for k in range(engine.nbody)] == ["world", "ball"]
    assert found.account.changed == ("<body name='hand'> outside <worldbody>: left out, as MuJoCo leaves it out",)
