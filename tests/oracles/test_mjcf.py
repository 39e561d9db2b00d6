"""MJCF: what is written means the same to MuJoCo, what MuJoCo means is read, and the round trip closes."""

from __future__ import annotations

import re
from pathlib import Path

import mujoco
import numpy as np
import pytest
import sympy
from support.marks import slow
from support.model_states import body_states, model, output, relative

from oracles.mechanisms import joint, mechanism, pendulum
from oracles.mujoco_engine import PlacedModel
from symscrew import catalogue
from symscrew.description.mechanism import Body
from symscrew.errors import DescriptionError
from symscrew.formats import by_suffix
from symscrew.model import Model, derive
from symscrew.reference.maximal_coordinates import BodyState, numeric

EXACT = 1e-9
RAISED = 1e-8  # bodies without inertia are raised to 1e-9 of the whole; the lightest parts feel that more


def quickly(name: str) -> object:
    """A mechanism of the catalogue, the large one whose like is small marked slow."""
    return slow(name) if name == "stewart_6ups" else name


CLOSED = ("four_bar", "slider_crank", "planar_3rrr", "delta", "three_ups_upu_s", "spatial_loop", "mixed_loop")


def load(text: str, folder: Path) -> object:
    (folder / "model.xml").write_text(text)
    return by_suffix.load_format(folder / "model.xml")


def placed(text: str, found: Model) -> tuple[PlacedModel, dict[str, str]]:
    """The exported model in MuJoCo; copies of bodies are placed with the body that they are welded to."""
    compiled = mujoco.MjModel.from_xml_string(text)
    compiled.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    data = mujoco.MjData(compiled)
    mujoco.mj_forward(compiled, data)
    names = [mujoco.mj_id2name(compiled, mujoco.mjtObj.mjOBJ_BODY, k) for k in range(1, compiled.nbody)]
    assert np.abs(data.xmat[1:].reshape(-1, 3, 3) - np.eye(3)).max() < 1e-14
    home = {name: data.xpos[k + 1].copy() for k, name in enumerate(names)}
    return PlacedModel(compiled, found.mechanism.ground, home), {
        n: n if n in found.mechanism.bodies else n.removesuffix("_copy") for n in names
    }


def states_at(found: Model, originals: dict[str, str], *arrays: np.ndarray) -> list[dict[str, BodyState]]:
    states = body_states(found, *arrays)
    return [
        {
            name: BodyState(*(getattr(states[o], key)[k] for key in ("rotation", "translation", "twist", "twist_rate")))
            for name, o in originals.items()
        }
        for k in range(len(arrays[0]))
    ]


def matrix(found: Model, function: str, port: str, *arguments: np.ndarray) -> np.ndarray:
    """An output (states, rows, columns), which comes column by column."""
    shape = next(p.shape for p in found.programs[function].outputs if p.name == port)
    return output(found, function, port, *arguments).reshape(-1, *shape[::-1]).transpose(0, 2, 1)


def null_space(rows: np.ndarray) -> np.ndarray:
    _, values, right = np.linalg.svd(rows)
    return right[int((values > 1e-9 * values.max(initial=0.0)).sum()) :].T


def agreement(found: Model, text: str) -> tuple[float, float]:
    """Largest relative differences of mass matrix and forces, both in the directions that the loops leave free.

    Also asserts: MuJoCo's equalities have the rank of our closure and leave the same directions free.
    """
    engine, originals = placed(text, found)
    q, v, a = found.system.sample_states
    mass = matrix(found, "mass_matrix", "mass_matrix", q)
    force = np.einsum("sij,sj->si", mass, a) + output(found, "bias", "bias", q, v)
    closed = "closure_jacobian" in found.programs
    masses, forces = [], []
    for k, states in enumerate(states_at(found, originals, q, v, a)):
        rows = matrix(found, "closure_jacobian", "jacobian", q)[k] if closed else np.zeros((0, v.shape[1]))
        free = null_space(rows) if closed else np.eye(v.shape[1])
        engine.set_state(states)
        mapped = []
        for direction in free.T:
            moving = states_at(found, originals, q[k : k + 1], direction[None], a[k : k + 1])[0]
            mapped.append(engine.velocity(moving))
        mapped = np.array(mapped).T
        compiled, data = engine.model, engine.data
        acceleration = data.qacc.copy()
        mujoco.mj_fwdPosition(compiled, data)
        equalities = data.efc_J.reshape(-1, compiled.nv)[: data.ne]
        assert np.abs(data.efc_pos[: data.ne]).max(initial=0.0) < 1e-9
        assert compiled.nv - null_space(equalities).shape[1] == compiled.nv - free.shape[1]
        assert np.abs(equalities @ mapped).max(initial=0.0) < 1e-9 * max(1.0, np.abs(mapped).max())
        full = np.zeros((compiled.nv, compiled.nv))
        mujoco.mj_fullM(compiled, data, full)
        data.qacc[:] = acceleration
        mujoco.mj_inverse(compiled, data)
        masses.append((mapped.T @ full @ mapped, free.T @ mass[k] @ free))
        forces.append((mapped.T @ data.qfrc_inverse, free.T @ force[k]))
    return tuple(relative(*map(np.array, zip(*pairs, strict=True))) for pairs in (masses, forces))


@pytest.mark.parametrize("name", [*CLOSED, "panda"])
def test_mass_matrix_forces_and_constraints_are_those_of_mujoco(name):
    found = model(name)
    text = by_suffix.text_of(found.mechanism, ".xml")
    raised = "Masses or moments raised" in text
    assert max(agreement(found, text)) < (RAISED if raised else EXACT)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["three_ups_upu_s", "mixed_loop"])
def test_what_is_read_back_is_exactly_what_mujoco_has(name, tmp_path):
    """Whatever was raised is read back: model and MuJoCo then agree to rounding."""
    text = by_suffix.text_of(model(name).mechanism, ".xml")
    assert max(agreement(derive(load(text, tmp_path)), text)) < EXACT


@pytest.mark.parametrize("name", [*map(quickly, catalogue.names()), "spatial_loop"])
def test_round_trip(name, tmp_path):
    """Same names, types, places, inertias: numbers to the rounding of doubles, raised ones to 1e-9 of the whole."""
    first = model(name).mechanism if name == "spatial_loop" else catalogue.load(name)
    second = load(by_suffix.text_of(first, ".xml"), tmp_path)
    extra = {body for body in second.bodies if body.endswith("_copy")}
    assert set(second.bodies) - extra == set(first.bodies)
    assert second.ground == first.ground and second.description == first.description
    assert first.platform in (None, second.platform)
    a, b = numeric(first), numeric(second)
    scale = a.mass.sum() or 1.0
    for name_, body in first.bodies.items():
        i, j = a.bodies.index(name_), b.bodies.index(name_)
        if name_ != first.ground and body.mass is not None:
            assert b.mass[j] == pytest.approx(a.mass[i], abs=1.1e-9 * scale)
            assert b.com[j] == pytest.approx(a.com[i], abs=1e-15)
            assert b.inertia[j] == pytest.approx(a.inertia[i], abs=1.1e-9 * scale * a.length**2)
    for name_, one in first.joints.items():
        other = second.joints[name_]
        if {other.parent, other.child} & extra:
            continue
        assert (one.type, one.driven) == (other.type, other.driven)
        assert (one.parent, one.child) in ((other.parent, other.child), (other.child, other.parent))
        i, j = a.joints.index(name_), b.joints.index(name_)
        assert b.points[j] == pytest.approx(a.points[i], abs=1e-15)
        turned = 1 if one.parent == other.parent or one.type not in "RP" else -1
        assert b.axes[b.freedoms[j]] == pytest.approx(turned * a.axes[a.freedoms[i]], abs=1e-15)
    assert {n: (p.body, p.at) for n, p in first.points.items()}.keys() == second.points.keys()


def test_screw_and_driven_joints_of_several_freedoms_keep_type_and_drive(tmp_path):
    rod = pendulum(1, 2, 0.1).bodies["rod"]
    screw = joint("nut", "H", "ground", "rod", (0.1, 0.2, 0.3), (0.6, 0, 0.8), driven=(0,), pitch=sympy.Rational(1, 50))
    ball = Body("tip", rod.mass, rod.com, rod.inertia)
    wrist = joint("wrist", "S", "rod", "tip", (0, 0, -1), driven=(1, 2))
    given = mechanism("screw", [rod, ball], [screw, wrist])
    found = derive(given)
    text = by_suffix.text_of(given, ".xml")
    assert max(agreement(found, text)) < EXACT
    again = load(text, tmp_path)
    assert again.joints["nut"].type == "H" and again.joints["nut"].driven == (0,)
    assert float(again.joints["nut"].pitch) == pytest.approx(0.02, rel=1e-15)
    assert again.joints["wrist"].type == "S" and again.joints["wrist"].driven == (1, 2)


# -- files that others wrote ---------------------------------------------------------------------------

FOREIGN = """
<mujoco model="two-arm robot">
  <compiler angle="degree" eulerseq="zyx"/>
  <default>
    <joint axis="0 1 0" ref="10"/>
    <geom density="500" contype="0" conaffinity="0"/>
    <default class="heavy"><geom density="3000"/><joint axis="1 0 0" ref="0"/></default>
  </default>
  <worldbody>
    <geom type="plane" size="1 1 1"/>
    <frame pos="0 0 1" euler="0 90 0">
      <body name="upper-arm" pos="0.1 0.2 0.3" euler="30 20 10">
        <joint name="shoulder"/>
        <joint name="slide.r" type="slide" axis="1 2 2" ref="0.2"/>
        <geom type="capsule" fromto="0 0 0 0.3 0.1 0.2" size="0.04"/>
        <geom type="box" size="0.1 0.05 0.02" pos="0.1 0 0" zaxis="1 1 0"/>
        <site name="tool" pos="0.3 0.1 0.2"/>
        <body name="fore-arm" pos="0.3 0.1 0.2" axisangle="0 1 1 40" childclass="heavy">
          <joint name="elbow" pos="0 0 0.01"/>
          <geom type="cylinder" size="0.03 0.2" quat="1 2 3 4"/>
          <frame pos="0 0 0.3" xyaxes="0 1 0 -1 0 1"><geom type="ellipsoid" size="0.1 0.05 0.03" mass="0.7"/></frame>
          <body name="hand" pos="0 0 0.5">
            <joint name="wrist" type="ball" pos="0 0.02 0"/>
            <inertial pos="0.01 0.02 0.03" mass="0.3" fullinertia="0.002 0.003 0.004 0.0001 -0.0002 0.0003"/>
          </body>
        </body>
      </body>
    </frame>
    <body name="ball" pos="1 0 0" quat="1 1 0 0">
      <freejoint/>
      <geom type="box" fromto="0 0 0 0.1 0.2 0.3" size="0.02"/>
      <geom size="0.05" pos="0 0.1 0"/>
    </body>
  </worldbody>
  <actuator><motor joint="elbow"/></actuator>
</mujoco>
"""


def test_a_foreign_file_means_the_same_as_to_mujoco(tmp_path):
    """Masses, centres, inertias, points and axes in the reference configuration, from MuJoCo's own compiler."""
    found = load(FOREIGN, tmp_path)
    compiled = mujoco.MjModel.from_xml_string(FOREIGN)
    data = mujoco.MjData(compiled)
    mujoco.mj_forward(compiled, data)
    numbers = numeric(found)
    for name in ("upper-arm", "fore-arm", "hand", "ball"):
        k = mujoco.mj_name2id(compiled, mujoco.mjtObj.mjOBJ_BODY, name)
        i = numbers.bodies.index(name.replace("-", "_"))
        assert numbers.mass[i] == pytest.approx(compiled.body_mass[k], rel=1e-12)
        assert numbers.com[i] == pytest.approx(data.xipos[k], abs=1e-12)
        axes = data.ximat[k].reshape(3, 3)
        inertia = axes @ np.diag(compiled.body_inertia[k]) @ axes.T
        assert numbers.inertia[i] == pytest.approx(inertia, abs=1e-9 * np.abs(inertia).max())
    for name, ours in (("shoulder", "shoulder"), ("slide.r", "slide_r"), ("elbow", "elbow"), ("wrist", "wrist")):
        k = mujoco.mj_name2id(compiled, mujoco.mjtObj.mjOBJ_JOINT, name)
        i = numbers.joints.index(ours)
        if ours != "wrist":
            assert numbers.axes[numbers.freedoms[i]][0] == pytest.approx(data.xaxis[k], abs=1e-12)
            assert float(found.joints[ours].reference[0] if found.joints[ours].reference else 0) == pytest.approx(
                compiled.qpos0[compiled.jnt_qposadr[k]], rel=1e-12
            )
        assert numbers.points[i] == pytest.approx(data.xanchor[k], abs=1e-12)
    assert found.joints["elbow"].driven == (0,) and found.joints["wrist"].driven == ()
    assert found.joints["shoulder"].driven == () and found.joints["joint"].type == "free"
    assert np.array([float(c) for c in found.points["tool"].at]) == pytest.approx(data.site_xpos[0], abs=1e-12)
    assert "upper-arm -> upper_arm" in found.source


def test_motion_of_a_foreign_file_is_that_of_mujoco(tmp_path):
    """Forces of the tree at random states: the joints are chained in the file's order with its reference values."""
    found = derive(load(FOREIGN, tmp_path))
    compiled = mujoco.MjModel.from_xml_string(FOREIGN)
    data = mujoco.MjData(compiled)
    q, v, a = found.system.sample_states
    labels = [c.label for c in found.system.tree.q]
    order = ["shoulder", "slide_r", "elbow", "wrist", "joint"]
    q_index = [k for name in order for k, label in enumerate(labels) if label.split(".")[0] == name]
    rates = [c.label for c in found.system.tree.v]
    v_index = [k for name in order for k, label in enumerate(rates) if label.split(".")[0] == name]
    mass, bias = matrix(found, "mass_matrix", "mass_matrix", q), output(found, "bias", "bias", q, v)
    force = np.einsum("sij,sj->si", mass, a) + bias
    for k in range(len(q)):
        data.qpos[:] = q[k, q_index]
        data.qpos[7:10] = q[k, q_index][7:10] + np.array([1, 0, 0])  # a free joint of ours counts from the reference
        turn = np.zeros(4)
        mujoco.mju_mulQuat(turn, q[k, q_index][10:], compiled.qpos0[10:14])
        data.qpos[10:14] = turn
        rate, change = v[k, v_index].copy(), a[k, v_index].copy()
        home = np.zeros(9)
        mujoco.mju_quat2Mat(home, compiled.qpos0[10:14])
        for vector in (rate, change):  # and turns in axes that are absolute in the reference configuration
            vector[-3:] = home.reshape(3, 3).T @ vector[-3:]
        wrist = slice(3, 6)
        mujoco.mj_resetData(compiled, mujoco.MjData(compiled))
        rest = mujoco.MjData(compiled)
        mujoco.mj_forward(compiled, rest)
        hand = rest.xmat[mujoco.mj_name2id(compiled, mujoco.mjtObj.mjOBJ_BODY, "hand")].reshape(3, 3)
        for vector in (rate, change):
            vector[wrist] = hand.T @ vector[wrist]
        relative_turn = np.zeros(4)
        mujoco.mju_mat2Quat(relative_turn, hand.ravel())
        middle, back, both = np.zeros(4), np.zeros(4), np.zeros(4)
        mujoco.mju_negQuat(back, relative_turn)
        mujoco.mju_mulQuat(middle, back, q[k, q_index][3:7])
        mujoco.mju_mulQuat(both, middle, relative_turn)
        data.qpos[3:7] = both
        data.qvel[:], data.qacc[:] = rate, change
        mujoco.mj_inverse(compiled, data)
        expected = force[k, v_index].copy()
        expected[wrist], expected[-3:] = hand.T @ expected[wrist], home.reshape(3, 3).T @ expected[-3:]
        assert data.qfrc_inverse == pytest.approx(expected, abs=1e-8 * np.abs(expected).max())


LOOP = """
<mujoco><worldbody>
  <body name="a"><joint axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 1" size="0.1"/>
    <body name="b" pos="0 0 1"><joint axis="0 1 0"/><geom size="0.1"/><site name="end" pos="1 0 0"/></body></body>
  <body name="c" pos="1 0 0"><joint axis="0 1 0"/><geom size="0.1"/><site name="top" pos="0 0 1"/>
    <body name="d" pos="0 0 1"><geom size="0.1"/></body></body>
</worldbody><equality>%s</equality></mujoco>
"""


def test_loops_of_a_foreign_file(tmp_path):
    connect = '<connect name="loop" body1="b" body2="c" anchor="1 0 0"/>'
    found = load(LOOP % connect, tmp_path)
    assert (found.joints["loop"].type, found.joints["loop"].parent, found.joints["loop"].child) == ("S", "b", "c")
    assert found.joints["loop"].point == (1, 0, 1)
    found = load(LOOP % '<connect site1="end" site2="top"/>', tmp_path)
    assert found.joints["loop_0"].point == (1, 0, 1)
    twice = connect + '<connect name="more" body1="b" body2="c" anchor="1 2 0"/>'
    found = load(LOOP % twice, tmp_path)
    assert found.joints["loop"].type == "R" and found.joints["loop"].axes == ((0, 1, 0),)
    found = load(LOOP % '<weld name="glue" body1="b" body2="d" relpose="1 0 0 1 0 0 0"/>', tmp_path)
    assert found.joints["glue"].type == "fixed"
    found = load(LOOP % '<connect body1="b" anchor="1 0 0"/>', tmp_path)
    assert (found.joints["loop_0"].parent, found.joints["loop_0"].child) == ("world", "b")
    assert found.joints["d_fixed"].type == "fixed"


BODY = '<mujoco>%s<worldbody><body name="a"><joint name="j"/>%s<geom size="0.1"/></body></worldbody>%s</mujoco>'


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (BODY % ("", '<plugin plugin="x"/>', ""), "<plugin> of MJCF is not supported"),
        (BODY % ("", "<composite count='3'/>", ""), "<composite>: bends, and bodies of a mechanism are rigid"),
        (BODY % ('<include file="/etc/passwd"/>', "", ""), "outside of the model's folder"),
        (BODY % ("", "", "<equality><tendon tendon1='t'/></equality>"), "no fixed tendon"),
        (BODY % ("", "", "<equality><joint joint1='x' joint2='j'/></equality>"), "a hinge or slide joint, got 'x'"),
        (BODY % ("", "", "<equality><connect body1='z' anchor='0 0 0'/></equality>"), "there is no body 'z'"),
        (BODY % ("", "", "<actuator><motor tendon='t'/></actuator>"), "there is no tendon 't'"),
        (BODY % ("", "", "<actuator><motor body='a'/></actuator>"), "they drive no joint of their own"),
        (BODY % ("", "", "<actuator><motor joint='nope'/></actuator>"), "there is no joint 'nope'"),
        (BODY % ('<compiler coordinate="global"/>', "", ""), "coordinate='global' is not supported"),
        (BODY % ('<compiler settotalmass="much"/>', "", ""), "settotalmass: expected decimal numbers"),
        (BODY % ('<compiler eulerseq="abc"/>', "", ""), "eulerseq of three of xyzXYZ"),
        (BODY % ("", '<geom type="mesh" mesh="m"/>', ""), "there is no mesh 'm'"),
        (BODY % ("", '<geom size="0.1" class="no"/>', ""), "no default class 'no'"),
        (BODY % ("", '<joint name="j"/>', ""), "two joints have this name"),
        (BODY % ("", '<joint axis="0 0 0"/>', ""), "expected a direction"),
        (BODY % ("", '<joint axis="0 nan 0"/>', ""), "expected decimal numbers, got 'nan'"),
        (BODY % ("", '<joint stifness="1"/>', ""), "did you mean 'stiffness'"),
        (BODY % ("", '<body quat="0 0 0 0"/>', ""), "quaternion, got one of length zero"),
        (BODY % ("", '<body euler="0 0 0" zaxis="1 0 0"/>', ""), "expected one orientation"),
        (LOOP % '<connect site1="end" site2="end2"/>', "there is no site 'end2'"),
        (LOOP % '<weld body1="b" body2="d" relpose="9 0 0 1 0 0 0"/>', "does not close"),
        ("<mujoco/>", "it has no joints"),
        ("<svg/>", "expected the root element <robot> or <mujoco>, got <'svg'>"),
    ],
)
def test_what_is_not_supported_is_refused_by_name(text, message, tmp_path):
    with pytest.raises(DescriptionError, match=re.escape(message)):
        load(text, tmp_path)


def test_forces_are_named(tmp_path):
    text = BODY % ('<option gravity="0 0 -1.6"/>', '<joint name="k" axis="1 0 0" damping="2" range="-1 1"/>', "")
    found = load(text, tmp_path)
    assert "turned into effects and limits: gravity, damping, range" in found.source
    assert "left out, without influence: contacts of geoms" in found.source
