"""Actuators, weights and rotors of robots' files: what classes, ratios, flags and loops make of them, beside MuJoCo."""

from __future__ import annotations

import random
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from benchmarks.robot_engines import Ours, place, with_mujoco

from symscrew.effects import PositionServo
from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, load_format
from symscrew.formats.draft import Draft
from symscrew.formats.mjcf_gains import ARRAYS, OWN
from symscrew.formats.mjcf_settings import settings
from symscrew.model import derive
from symscrew.scene import load_robot, save_robot

from .test_import_details import INERTIAL, saved

pytestmark = pytest.mark.slow

ONE = '<worldbody><body><joint name="a" axis="0 1 0"/><geom size="0.1"/></body></worldbody>'
KINDS = tuple(OWN)
TYPES = {"fixed": 0, "none": 0, "affine": 1, "integrator": 1, "filter": 2, "filterexact": 3}


def actuator(chance: random.Random, tag: str, more: str = "") -> str:
    def some(text: str, share: float = 0.4) -> str:
        return f" {text.format(chance.randint(1, 9), chance.randint(1, 9))}" if chance.random() < share else ""

    if tag == "general":
        more += some('gainprm="{0}"') + some('biastype="affine"') + some('biasprm="0 -{0} -{1}"')
        more += some(f'dyntype="{chance.choice(("filter", "filterexact", "integrator"))}"', 0.2)
    elif tag in ("position", "intvelocity"):
        more += some('kp="{0}"') + (some('kv="{0}"') or some('dampratio="{0}"', 0.2))
        more += some(f'timeconst="{chance.choice((0, 0.3))}"', 0.2) if tag == "position" else ""
    elif tag == "velocity":
        more += some('kv="{0}"', 0.5)
    more += some('gear="{0}"', 0.2)
    return f"<{tag}{more}/>"


def classes(seed: int) -> str:
    """Three classes, one inside the other, each with actuators of several kinds, and an actuator of one of them."""
    chance = random.Random(seed)
    inner = [
        "".join(actuator(chance, tag) for tag in chance.sample(KINDS, chance.choice((0, 1, 1, 2, 3)))) for _ in "123"
    ]
    used = actuator(chance, chance.choice(KINDS), f' joint="a" class="{chance.choice("AB")}"')
    nested = f'<default class="A">{inner[1]}<default class="B">{inner[2]}</default></default>'
    return f"<mujoco><default>{inner[0]}{nested}</default>{ONE}<actuator>{used}</actuator></mujoco>"


def test_gains_are_those_of_the_class_that_the_engine_takes() -> None:
    """Gains that an actuator leaves to its class, of 300 files, a tenth of them through a class of another kind."""
    for seed in range(300):
        text = classes(seed)
        engine = mujoco.MjModel.from_xml_string(text)
        root = ElementTree.fromstring(text)
        given = settings(root, Draft("m", "world", "")).actuator(root.find("actuator")[0])  # type: ignore[index,arg-type]

        def entries(key: str, given: dict[str, str] = given) -> list[float]:
            return [*map(float, given.get(key, " ".join(ARRAYS[key])).split()), 0.0, 0.0][:3]

        for key, kind, arrays, number in (
            ("gainprm", "gaintype", engine.actuator_gainprm, engine.actuator_gaintype),
            ("biasprm", "biastype", engine.actuator_biasprm, engine.actuator_biastype),
        ):
            count = 2 if "dampratio" in given else 3  # a ratio has become a damping there
            assert entries(key)[:count] == pytest.approx(arrays[0][:count]), text
            assert TYPES[given.get(kind, "fixed")] == number[0], text
        assert TYPES[given.get("dyntype", "none")] == engine.actuator_dyntype[0], text
        assert float(given.get("gear", 1)) == engine.actuator_gear[0][0], text


def hinges(names: str, more: str = "", weight: str = "") -> str:
    """A chain of hinges, one in the other."""
    text = ""
    for k, name in reversed(list(enumerate(names))):
        axis = ("0 1 0", "1 0.3 0", "0 0.2 1")[k % 3]
        text = (
            f'<body name="B{name}" pos="0.2 0 0.1"{weight}><joint name="{name}" axis="{axis}" {more}/>{INERTIAL}'
            f'<site name="s{name}" pos="0.1 0 0"/>{text}</body>'
        )
    return text


def file(bodies: str, rest: str = "") -> str:
    return f'<mujoco><compiler angle="radian"/><worldbody>{bodies}</worldbody>{rest}</mujoco>'


PULLED = (
    '<tendon><fixed name="t" armature="0.31"><joint joint="a" coef="-1.2"/>'
    '<joint joint="{0}" coef="0.3"/></fixed></tendon>'
)
RATIO = '<actuator><position {0} kp="20" dampratio="0.7"/></actuator>'
LIGHT = ' gravcomp="-0.3"'
ACTING = {
    "a ratio beside a tendon's armature": file(hinges("abc"), PULLED.format("b") + RATIO.format('joint="c"')),
    "a ratio on that tendon": file(hinges("abc"), PULLED.format("c") + RATIO.format('tendon="t"')),
    "gains through another kind": file(
        hinges("ab"),
        '<default><position kp="7" kv="2"/><default class="s"><motor gear="3"/></default></default>'
        '<actuator><position joint="b" class="s"/></actuator>',
    ),
    "springs and dampers by a time": file(
        hinges("ab", 'springdamper="0.3 0.7" springref="0.2" stiffness="9" damping="8"'),
        '<tendon><fixed name="t" armature="0.31"><joint joint="a" coef="-1.2"/><joint joint="b" coef="0.3"/></fixed>'
        '</tendon><actuator><motor joint="b" gear="2" armature="0.1"/></actuator>',
    ),
    "weights below zero": file(hinges("ab", weight=LIGHT)),
    "weights of which one is above": file(hinges("ab", weight=LIGHT).replace("-0.3", "0.4", 1)),
    "weights through actuators": file(
        hinges("ab", 'actuatorgravcomp="true"', ' gravcomp="0.3"'), '<actuator><motor joint="a"/></actuator>'
    ),
}


@pytest.mark.parametrize("name", ACTING)
def test_accelerations_are_those_of_mujoco(tmp_path: Path, name: str) -> None:
    robot = load_robot(saved(ACTING[name], tmp_path))
    made = derive(robot.mechanism, robot.effects)
    engine = mujoco.MjModel.from_xml_string(ACTING[name])
    data = mujoco.MjData(engine)
    q, v, _ = made.system.states(2, 2)
    labels = [c.label for c in made.system.tree.v]
    order = [labels.index(engine.joint(k).name) for k in range(engine.njnt)]
    ports = made.programs["forward_dynamics"].inputs
    found = made("forward_dynamics", *({"q": q, "v": v}.get(port.name, np.zeros(port.shape)) for port in ports))[0][0]
    for k in range(len(q)):
        data.qpos[:], data.qvel[:] = q[k][order], v[k][order]
        mujoco.mj_forward(engine, data)
        assert found[k][order] == pytest.approx(data.qacc, rel=1e-9, abs=1e-9)


FOLLOWS = '<equality><joint joint1="b" joint2="a" polycoef="{} 0.5 0 0 0"/></equality>'
TIED = {
    "a tendon of which one joint follows the other": (PULLED.format("b"), 'tendon="t"', "0", 1.05),
    "joints off their own places by a coupling's constant": ("", 'joint="a"', "0.4", 1.0),
}


@pytest.mark.parametrize("name", TIED)
def test_a_ratio_is_of_the_inertia_without_couplings(tmp_path: Path, name: str) -> None:
    """As the engine's compiler takes it: in the file's own pose, along the tendon as it is written."""
    tendon, target, constant, factor = TIED[name]
    text = file(hinges("ab"), tendon + FOLLOWS.format(constant) + RATIO.format(target))
    (servo,) = (force for force in load_robot(saved(text, tmp_path)).effects if isinstance(force, PositionServo))
    engine = mujoco.MjModel.from_xml_string(text)
    assert servo.damping == pytest.approx(-engine.actuator_biasprm[0][2] * factor**2, rel=1e-9)


REFUSED = {
    "actuatorfrcrange of b, on which a tendon over several joints pulls": file(
        hinges("ab").replace('name="b"', 'name="b" actuatorfrcrange="-1 2"'),
        PULLED.format("b") + '<actuator><position tendon="t" kp="3"/></actuator>',
    ),
    "actuatorgravcomp without actuators": file(hinges("ab", 'actuatorgravcomp="true"', ' gravcomp="0.3"')),
    "actuatorgravcomp of a within its actuatorfrcrange": file(
        hinges("ab", 'actuatorgravcomp="true" actuatorfrcrange="-1 1"', ' gravcomp="0.3"'),
        '<actuator><motor joint="a"/></actuator>',
    ),
}


@pytest.mark.parametrize("message", REFUSED)
def test_what_the_engine_limits_further_is_said(tmp_path: Path, message: str) -> None:
    with pytest.raises(DescriptionError, match=f"left out: .*{message}"):
        load_format(saved(REFUSED[message], tmp_path))


def test_a_tendon_over_branches_is_said(tmp_path: Path) -> None:
    """The engine's mass matrix has no entries between branches, where armature of a tendon couples them."""
    text = file(hinges("a") + hinges("b"), PULLED.format("b"))
    engine = mujoco.MjModel.from_xml_string(text)
    data, full = mujoco.MjData(engine), np.zeros((2, 2))
    mujoco.mj_forward(engine, data)
    mujoco.mj_fullM(engine, data, full)
    assert full[0, 1] == 0
    said = " ".join(load_robot(saved(text, tmp_path)).account.lines())
    assert "over branches" in said
    chain = load_robot(saved(file(hinges("ab"), PULLED.format("b")), tmp_path))
    assert "over branches" not in " ".join(chain.account.lines())


@pytest.mark.parametrize("loop", ['<connect site1="sf" site2="o"/>', '<weld site1="sf" site2="o"/>'])
def test_no_loop_is_cut_where_a_rotor_turns(tmp_path: Path, loop: str) -> None:
    """A loop of seven hinges whose class has armature, closed where the file closes it."""
    engine = mujoco.MjModel.from_xml_string(file(hinges("abcdefg")))
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    turn = np.zeros(4)
    mujoco.mju_mat2Quat(turn, data.site_xmat[engine.site("sf").id])
    place = [" ".join(map(repr, map(float, values))) for values in (data.site_xpos[engine.site("sf").id], turn)]
    far = f'<site name="o" pos="{place[0]}" quat="{place[1]}"/>'
    text = file(far + hinges("abcdefg", 'armature="0.1"'), f"<equality>{loop}</equality>")
    worst, what = with_mujoco(saved(text, tmp_path), ImportOptions())
    assert worst < 1e-9, what


BALL = (
    '<mujoco><compiler angle="radian"/><worldbody><body name="A" pos="0.2 0 0.1" quat="{0}">{1}'
    '<inertial pos="0.1 0.03 0.02" mass="1.5" diaginertia="0.01 0.02 0.025"/></body></worldbody>'
    '<actuator><motor {2} gear="{3}"/></actuator></mujoco>'
)
SKEW, BALLS = "0.9 0.1 0.3 0.2", ('<joint name="a" type="ball" pos="0.1 0 0"/>', '<freejoint name="a"/>')
DRIVES = {
    "a ball, as the parent carries its axes": ("1 0 0 0", BALLS[0], 'jointinparent="a"', "0 2 0"),
    "a body turned about that axis": ("0.8 0 0.6 0", BALLS[0], 'jointinparent="a"', "0 2 0"),
    "a force on a free body": (SKEW, BALLS[1], 'joint="a"', "0 2 0 0 0 0"),
    "a moment on a free body": (SKEW, BALLS[1], 'jointinparent="a"', "0 0 0 0 2 0"),
}


@pytest.mark.parametrize("name", DRIVES)
def test_drives_of_balls_and_free_bodies(tmp_path: Path, name: str) -> None:
    """A command times its gear, as a drive here: the same power along the motion, so the same acceleration."""
    path = saved(BALL.format(*DRIVES[name]), tmp_path)
    ours = Ours(path, ImportOptions())
    ours.q, ours.v, _ = ours.system.states(2, 1)
    made = derive(ours.mechanism)
    engine = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    home, start = data.xmat.reshape(-1, 3, 3).copy(), data.xpos.copy()
    found = made("forward_dynamics", ours.q, ours.v, np.full((len(ours.q), 1), 1.4))[0][0]
    for k in range(len(ours.q)):
        data.qvel[:] = place(engine, data, {"a": 0}, (*ours.joints(ours.v), k), home, start)
        data.ctrl[:] = 0.7
        mujoco.mj_forward(engine, data)
        assert home[1].T @ found[k][-3:] == pytest.approx(data.qacc[-3:], rel=1e-9)


@pytest.mark.parametrize(
    ("ball", "where", "gear"),
    [
        (BALLS[0], 'joint="a"', "0 2 0"),
        (BALLS[0], 'jointinparent="a"', "0 2 0"),
        (BALLS[1], 'joint="a"', "0 0 0 0 2 0"),
    ],
)
def test_moments_about_other_axes_are_said(tmp_path: Path, ball: str, where: str, gear: str) -> None:
    with pytest.raises(DescriptionError, match="about axes that no drive of a ball or free joint has"):
        load_format(saved(BALL.format(SKEW, ball, where, gear), tmp_path))


def test_a_driven_ball_is_written_as_its_parent_carries_it(tmp_path: Path) -> None:
    path = saved(BALL.format(*DRIVES["a body turned about that axis"]), tmp_path)
    save_robot(load_robot(path).mechanism, tmp_path / "again.xml", ())
    assert load_format(tmp_path / "again.xml").joints["a"].driven == (1,)
    engine = mujoco.MjModel.from_xml_path(str(tmp_path / "again.xml"))
    assert engine.actuator_trntype[0] == mujoco.mjtTrn.mjTRN_JOINTINPARENT
