"""URDF: what is written means the same to MuJoCo and Pinocchio, what others write is read, the round trip closes."""

from __future__ import annotations

import re
from pathlib import Path

import mujoco
import numpy as np
import pytest
from support.model_states import model, output, relative

from oracles.mechanisms import body, joint, mechanism
from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description.mechanism import Mechanism
from symscrew.errors import DescriptionError
from symscrew.formats import by_suffix
from symscrew.model import Model, derive
from symscrew.reference.maximal_coordinates import numeric

EXACT = 1e-10


def load(text: str, folder: Path) -> Mechanism:
    (folder / "robot.urdf").write_text(text)
    return by_suffix.load_format(folder / "robot.urdf")


def tree() -> Mechanism:
    """An open chain with a planar, a universal, a cylindrical joint, branches, and one joint passed backwards."""
    matrix = [[0.3, 0.01, -0.02], [0.01, 0.4, 0.03], [-0.02, 0.03, 0.5]]
    bodies = [body(f"b{k}", 1 + k, (0.1 * k, 0.2, -0.1), matrix) for k in range(5)]
    joints = [
        joint("table", "E", "ground", "b0", (0, 0, 0), (0, 0.6, 0.8), driven=(0, 1, 2)),
        joint("hip", "U", "b0", "b1", (0.1, 0.2, 0.3), (0.6, 0.8, 0), (0, 0, 1), driven=(1,)),
        joint("tube", "C", "b1", "b2", (0.3, 0.1, 0.5), (0, 1, 0)),
        joint("back", "U", "b3", "b1", (0.4, 0.4, 0.1), (1, 0, 0), (0, 0.8, 0.6)),
        joint("pin", "R", "b3", "b4", (0.5, 0.4, 0.1), (0, 0, 1), driven=(0,)),
    ]
    return mechanism("tree", bodies, joints)


def with_references() -> Mechanism:
    """Joints whose coordinates are not zero in the reference configuration."""
    from symscrew.description.builder import MechanismBuilder

    builder = MechanismBuilder("shifted")
    for k in range(3):
        builder.body(f"b{k}", mass=1 + k, com=[0.1, 0.2 * k, 0.3], inertia=[0.1, 0.2, 0.25])
    builder.joint("a", "R", parent="base", child="b0", point=[0, 0, 0], axes=[[0, 0.6, 0.8]], reference=[0.7])
    builder.joint("b", "P", parent="b0", child="b1", point=[0.1, 0, 0], axes=[[1, 0, 0]], reference=["0.25"])
    builder.joint("c", "R", parent="b1", child="b2", point=[0.3, 0, 0.1], axes=[[0, 1, 0]], reference=[-2])
    return builder.build()


MODELS = {"tree": tree, "with_references": with_references}


def found_model(name: str) -> Model:
    return derive(MODELS[name]()) if name in MODELS else model(name)


def forces(found: Model, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> np.ndarray:
    mass = output(found, "mass_matrix", "mass_matrix", q).reshape(len(q), v.shape[1], -1)
    return np.einsum("sij,sj->si", mass, a) + output(found, "bias", "bias", q, v)


@pytest.mark.parametrize("name", ["ur5", "panda", "with_references"])
def test_the_forces_are_those_of_mujoco(name):
    found = found_model(name)
    compiled = mujoco.MjModel.from_xml_string(by_suffix.text_of(found.mechanism, ".urdf"))
    data = mujoco.MjData(compiled)
    q, v, a = found.system.sample_states
    labels = [mujoco.mj_id2name(compiled, mujoco.mjtObj.mjOBJ_JOINT, k) for k in range(compiled.njnt)]
    order = [labels.index(c.label) for c in found.system.tree.q]
    got = np.empty_like(v)
    for k in range(len(q)):
        data.qpos[order], data.qvel[order], data.qacc[order] = q[k], v[k], a[k]
        mujoco.mj_inverse(compiled, data)
        got[k] = data.qfrc_inverse[order]
    assert relative(got, forces(found, q, v, a)) < EXACT


@pytest.mark.parametrize("name", ["ur5", "panda", "with_references", "tree"])
def test_the_forces_are_those_of_pinocchio(name):
    """Chains over links without inertia too, which Pinocchio takes as they are."""
    pinocchio = pytest.importorskip("pinocchio", reason="needs Pinocchio: pip install pin")
    found = found_model(name)
    built = pinocchio.buildModelFromXML(by_suffix.text_of(found.mechanism, ".urdf"))
    data = built.createData()
    q, v, a = found.system.sample_states
    got = np.empty_like(v)
    for k in range(len(q)):
        arrays = [np.zeros(built.nq), np.zeros(built.nv), np.zeros(built.nv)]
        places = []
        for i, entry in enumerate(found.system.tree.q):
            index = built.getJointId(entry.label)
            in_q, in_v = built.joints[index].idx_q, built.joints[index].idx_v
            value = q[k, i]
            arrays[0][in_q : in_q + built.joints[index].nq] = (
                value if built.joints[index].nq == 1 else [np.cos(value), np.sin(value)]
            )
            arrays[1][in_v], arrays[2][in_v] = v[k, i], a[k, i]
            places.append(in_v)
        got[k] = pinocchio.rnea(built, data, *arrays)[places]
    assert relative(got, forces(found, q, v, a)) < EXACT


@pytest.mark.parametrize("name", ["ur5", "panda", "tree", "with_references"])
def test_round_trip(name, tmp_path):
    """The same functions of the same coordinates, drives and joints of several freedoms included."""
    found = found_model(name)
    again = derive(load(by_suffix.text_of(found.mechanism, ".urdf"), tmp_path))
    labels = [c.label for c in found.system.tree.q]
    other = [c.label.replace("back_", "back.") for c in again.system.tree.q]
    assert sorted(labels) == sorted(other)
    if "back.0" not in labels:
        for joint_name, one in found.mechanism.joints.items():
            assert again.mechanism.joints[joint_name].type == one.type
            assert again.mechanism.joints[joint_name].driven == one.driven
    order = [labels.index(label) for label in other]
    q, v, a = found.system.sample_states
    moved = [x[:, order] for x in (q, v, a)]
    assert relative(forces(again, *moved), forces(found, q, v, a)[:, order]) < EXACT


def test_a_spherical_joint_becomes_three_turns(tmp_path):
    """The same kinetic energy for the same turning of the body."""
    matrix = [[0.3, 0.01, -0.02], [0.01, 0.4, 0.03], [-0.02, 0.03, 0.5]]
    given = mechanism("ball", [body("tip", 2, (0.1, 0.2, 0.3), matrix)], [joint("s", "S", "ground", "tip", (0, 0, 1))])
    again = load(by_suffix.text_of(given, ".urdf"), tmp_path)
    assert [j.type for j in again.joints.values()] == ["R", "R", "R"]
    found, chained = derive(given), derive(again)
    angles, rates = np.random.default_rng(3).uniform(-1, 1, (2, 4, 3))
    turns = [
        np.array([np.cos(x / 2), *(np.sin(x / 2) * e)]) for row in angles for x, e in zip(row, np.eye(3), strict=True)
    ]
    expected, got = [], output(chained, "energy", "energy", angles, rates)
    for k in range(len(angles)):
        q = np.array([1.0, 0, 0, 0])
        omega = np.zeros(3)
        for i in range(3):
            product, back = np.zeros(4), np.zeros(4)
            mujoco.mju_mulQuat(product, q, turns[3 * k + i])
            mujoco.mju_negQuat(back, turns[3 * k + i])
            turned = np.zeros(3)
            mujoco.mju_rotVecQuat(turned, omega, back)
            q, omega = product, turned + rates[k, i] * np.eye(3)[i]
        expected.append(output(found, "energy", "energy", q[None], omega[None])[0])
    assert relative(got, np.array(expected)) < EXACT


# -- files that others wrote ---------------------------------------------------------------------------

ROBOT = """<?xml version="1.0"?>
<robot name="arm-1">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base_link"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="upper-arm">
    <inertial><origin xyz="0 0.1 0.2" rpy="0.1 0.2 0.3"/><mass value="2.5"/>
      <inertia ixx="0.02" ixy="0.001" ixz="0" iyy="0.03" iyz="-0.002" izz="0.04"/></inertial>
  </link>
  <link name="tool"/>
  <link name="sled"><inertial><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="mount"/>
  <joint name="shoulder" type="revolute">
    <origin xyz="0.1 0 0.3" rpy="1.5707963267948966 0 -0.7"/>
    <parent link="base_link"/><child link="upper-arm"/><axis xyz="0 1 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/><dynamics damping="0.1" friction="0"/>
  </joint>
  <joint name="flange" type="fixed"><origin xyz="0 0 0.5"/><parent link="upper-arm"/><child link="tool"/></joint>
  <joint name="rail" type="prismatic"><origin rpy="0 0 3.14159265358979"/>
    <parent link="upper-arm"/><child link="sled"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
  <joint name="puck" type="planar"><parent link="base_link"/><child link="mount"/><axis xyz="0 0 2"/></joint>
  %s
</robot>
"""


def test_a_foreign_file_means_the_same_as_to_mujoco(tmp_path):
    text = re.sub(r'<link name="mount"/>|<joint name="puck".*?</joint>', "", ROBOT % "")
    found = load(text, tmp_path)
    compiled = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(compiled)
    mujoco.mj_forward(compiled, data)
    numbers = numeric(found)
    for name, ours in (("upper-arm", "upper_arm"), ("sled", "sled")):
        k, i = mujoco.mj_name2id(compiled, mujoco.mjtObj.mjOBJ_BODY, name), numbers.bodies.index(ours)
        axes = data.ximat[k].reshape(3, 3)
        assert numbers.com[i] == pytest.approx(data.xipos[k], abs=1e-12)
        inertia = axes @ np.diag(compiled.body_inertia[k]) @ axes.T
        assert numbers.inertia[i] == pytest.approx(inertia, abs=1e-9 * np.abs(inertia).max())
    for name in ("shoulder", "rail"):
        k, i = mujoco.mj_name2id(compiled, mujoco.mjtObj.mjOBJ_JOINT, name), numbers.joints.index(name)
        assert numbers.axes[numbers.freedoms[i]][0] == pytest.approx(data.xaxis[k], abs=1e-12)
        assert numbers.points[i] == pytest.approx(data.xanchor[k], abs=1e-12)
    assert found.ground == "base_link" and found.platform is None
    assert found.joints["flange"].type == "fixed"
    assert "damping, limits (2)" in found.source and "friction" not in found.source
    assert "upper-arm -> upper_arm" in found.source


def test_right_angles_of_a_file_are_exact(tmp_path):
    """pi/2 and pi in 15 or 16 digits give axes with zeros that are zero: less code, nothing changed."""
    text = ROBOT.replace("-0.7", "3.141592653589793").replace("0 1 1", "0 1 0") % ""
    assert load(text, tmp_path).joints["shoulder"].axes == ((0, 0, 1),)


def test_what_rounding_leaves_of_no_inertia_is_none(tmp_path):
    """As published files have it: one product of inertia of 1.4e-20 kg m^2 beside zeros, which no body has."""
    moments = re.search(r"<inertia [^>]*>", ROBOT)[0]
    text = ROBOT.replace(moments, '<inertia ixx="0" ixy="0" ixz="1.35525e-20" iyy="0" iyz="0" izz="0"/>', 1) % ""
    found = load(text, tmp_path)
    name = next(n for n in found.bodies if n != "sled" and found.bodies[n].mass)
    assert found.bodies[name].mass > 0 and not any(x for row in found.bodies[name].inertia for x in row)
    with pytest.raises(DescriptionError, match="no body has the principal moments"):
        load(text.replace("1.35525e-20", "1.35525e-8"), tmp_path)


def test_driven_joints(tmp_path):
    assert {n for n, j in load(ROBOT % "", tmp_path).joints.items() if j.driven} == {"shoulder", "rail"}
    drive = '<transmission name="t"><joint name="rail"/></transmission>'
    found = load(ROBOT % drive, tmp_path)
    assert {n for n, j in found.joints.items() if j.driven} == {"rail"}
    assert found.joints["puck"].type == "E"
    found = load(ROBOT % drive.replace("rail", "puck"), tmp_path)
    assert not any(j.driven for j in found.joints.values())
    assert "drives of joints that have not one freedom: puck" in found.source
    control = '<ros2_control><joint name="shoulder"><command_interface/></joint><joint name="rail"/></ros2_control>'
    assert {n for n, j in load(ROBOT % control, tmp_path).joints.items() if j.driven} == {"shoulder"}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (('type="planar"', 'type="screw"'), "joints of type 'screw' are not supported"),
        (('<axis xyz="0 0 2"/>', '<mimic joint="rail"/>'), "'puck' has not one coordinate"),
        (('<axis xyz="0 0 2"/>', '<axis xyz="0 0 0"/>'), "expected a direction"),
        (('<axis xyz="0 0 2"/>', '<axis xyz="0 0 ${x}"/>'), "expand the file with xacro"),
        (('<child link="mount"/>', '<child link="sled"/>'), "a URDF is a tree"),
        (('<child link="mount"/>', '<child link="mont"/>'), "no child link 'mont'; did you mean 'mount'"),
        (
            ('<parent link="base_link"/><child link="mount"/>', '<parent link="mount"/><child link="mount"/>'),
            "no chain",
        ),
        (('<joint name="rail"', '<joint name="shoulder"'), "two joints have this name"),
        (('<link name="mount"/>', '<link name="tool"/>'), "two links have this name"),
        (('value="2.5"', 'value="heavy"'), "expected decimal numbers, got 'heavy'"),
        (('value="2.5"', 'value="-1"'), "expected a mass of at least 0 kg"),
        (("%s", "<loop_joint/>"), "expected the two links of a loop"),
        (("%s", '<transmission><joint name="rial"/></transmission>'), "did you mean 'rail'"),
        (("</robot>", ""), "not a valid XML file"),
    ],
)
def test_what_is_not_supported_is_refused_by_name(change, message, tmp_path):
    with pytest.raises(DescriptionError, match=re.escape(message)):
        load(ROBOT.replace(*change).replace("%s", ""), tmp_path)


BOMB = '<!DOCTYPE r [<!ENTITY a "aaaaaaaaaa">%s]><robot name="&%s;"><link name="b"/></robot>'
LEVELS = "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefgh", "bcdefghi", strict=True))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("content", "message"),
    [
        (BOMB % (LEVELS, "i"), "document types and entities are refused"),
        ('<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="&x;"/>', "entities are refused"),
        ('<!DOCTYPE robot SYSTEM "http://localhost/x.dtd"><robot/>', "document types"),
        ("<a>" * 5000 + "</a>" * 5000, "nested at most 300 deep"),
        ("<robot>" + "<link/>" * 200_000 + "</robot>", "at most 100000 elements"),
        ('<robot name="a"><link name="a"/></robot>', "it has no joints"),
        ("<robot/>", "expected links, found none"),
        ("\0\0", "not a valid XML file"),
        ("", "not a valid XML file"),
    ],
)
def test_hostile_files_end_in_one_error(content, message, tmp_path, capsys):
    path = tmp_path / "hostile.urdf"
    path.write_text(content)
    assert main(["convert", str(path), "--out", str(tmp_path / "out.toml")]) == 2
    printed = capsys.readouterr().err
    assert message in printed and printed.count("\n") == 1 and "Traceback" not in printed
    assert not (tmp_path / "out.toml").exists()


def test_convert(tmp_path, capsys):
    """From the catalogue to URDF, to MJCF, to TOML: the same mobility, the same points."""
    files = [tmp_path / name for name in ("ur5.urdf", "ur5.xml", "ur5.toml")]
    source = "ur5"
    for file in files:
        assert main(["convert", source, "--out", str(file)]) == 0
        source = str(file)
    assert sorted(tmp_path.iterdir()) == sorted(files)
    assert main(["mobility", str(files[0]), "--json"]) == 0
    first, last = numeric(catalogue.load("ur5")), numeric(catalogue.find(files[-1]))
    assert last.points == pytest.approx(first.points, abs=1e-15)
    assert last.inertia == pytest.approx(first.inertia, abs=1e-15)


def test_convert_refuses_what_a_format_cannot_hold(tmp_path, capsys):
    assert main(["convert", "four_bar", "--out", str(tmp_path / "x.urdf")]) == 2
    assert "loops close at D; write MJCF" in capsys.readouterr().err
    assert main(["convert", "ur5", "--out", str(tmp_path / "x.stl")]) == 2
    assert "ends in .urdf, .xml, .mjcf, .toml" in capsys.readouterr().err
    assert main(["convert", str(tmp_path / "none.urdf"), "--out", str(tmp_path / "x.toml")]) == 2
    assert "there is no file" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
