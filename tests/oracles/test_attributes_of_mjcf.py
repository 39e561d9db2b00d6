"""Every attribute that MuJoCo's own schema lists: what changes its accelerations changes what is read, or is said.

The attributes are the engine's, so that a newer one brings its new ones along. Values are tried until one compiles
and changes accelerations; what nothing here changes (rendering, contacts, solvers) is passed over.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest

from symscrew.errors import DescriptionError
from symscrew.formats import Imported, import_file
from symscrew.model import derive
from symscrew.scene import load_robot

from .test_import_details import INERTIAL, saved

MODEL = f"""<mujoco><compiler angle="radian"/><option gravity="1 -2 -9"/><worldbody>
<body name="A" pos="0.2 0 0.1" euler="0.3 0.2 0.1"><joint name="a" axis="0 1 0.2" ref="0.2" stiffness="2"/>{INERTIAL}
<geom type="box" size=".1 .2 .3" pos=".2 0 0"/><site name="s" pos=".1 .2 .3"/><body name="B" pos="0.2 0.1 0.1">
<joint name="b" type="slide" axis="1 0 0.2"/><geom type="capsule" size=".1 .2" density="5e2"/></body></body></worldbody>
<tendon><fixed name="t" stiffness="5"><joint joint="a" coef="0.5"/><joint joint="b" coef="-1.5"/></fixed></tendon>
<actuator><position joint="a" kp="20" gear="2"/><velocity joint="b" kv="3"/><motor joint="a" gear="3"/><general
joint="b" gainprm="7" biastype="affine" biasprm="0 -7 -1"/><intvelocity joint="a"/></actuator></mujoco>"""
VALUES = (
    "0.37", "2", "true", "false", "disable", "0.1 0.2 0.3", "0.8 0.1 0.2 0.3", "0.1 0.3 0.2 0.4 0.2 0.1", "affine",
    "integrator", "slide", "sphere", "ZYX", "degree", "a", "t", "0.6 0.5 0.4 0.05 0.02 0.01", "0 0.4",
)  # fmt: skip
PASSED = re.compile(
    "name|user|class|sol.*|rgba|group|material|.*dir|o_.*|.*iterations|.*tolerance|nsample|interp|.*range"
)
"""Attributes that say how an engine computes or shows, or that limit: none of them is tried."""
TURNS = ("quat", "euler", "axisangle", "xyaxes", "zaxis")


def schema() -> Iterator[tuple[tuple[str, ...], list[str]]]:
    """(path of tags, attributes) of every element that MuJoCo knows."""
    found: list[tuple[tuple[str, ...], list[str]]] = []
    way: list[str] = []
    for line in mujoco.mj_printSchema(False, False).splitlines():
        begun = re.match(r"^( *)([\w()]+) \(.\)\s*(.*)$", line)
        if begun:
            way = [*way[: len(begun[1]) // 3], begun[2]]
            found.append((tuple(way[1:]), begun[3].split()))
        elif line.strip() and found:
            found[-1][1].extend(line.split())
    yield from found


def places(root: ElementTree.Element, path: tuple[str, ...]) -> list[ElementTree.Element]:
    """The elements of the model at a path of the schema; settings are made where there are none."""
    if path[:1] == ("(world)body",):
        bodies = list(root.iter("body"))
        return bodies if len(path) == 1 else [e for body in bodies for e in body.findall(path[1])] * (len(path) == 2)
    there = root.findall("/".join(path)) if path else []
    if there or path not in (("compiler",), ("option",), ("option", "flag")):
        return there
    return [ElementTree.SubElement(root.find("option"), "flag")]  # type: ignore[arg-type]


def accelerations(text: str) -> np.ndarray | None:
    """MuJoCo's at one state; None for a file that it refuses."""
    try:
        engine = mujoco.MjModel.from_xml_string(text)
    except ValueError:
        return None
    bits = mujoco.mjtDisableBit
    engine.opt.disableflags |= int(bits.mjDSBL_CONTACT | bits.mjDSBL_LIMIT | bits.mjDSBL_FRICTIONLOSS)
    data = mujoco.MjData(engine)
    if engine.nq != 2:
        return None
    data.qpos[:], data.qvel[:] = (0.3, -0.2), (0.7, 0.4)
    mujoco.mj_forward(engine, data)
    return np.array(data.qacc)


def changed(path: tuple[str, ...], key: str, base: np.ndarray) -> Iterator[str]:
    """A file in which the attribute of the first element at the path has a value that changes accelerations."""
    for value in VALUES if places(ElementTree.fromstring(MODEL), path) else ():
        root = ElementTree.fromstring(MODEL)
        element = places(root, path)[0]
        if element.get(key) == value:
            continue
        for turn in TURNS if key in TURNS else ():
            element.attrib.pop(turn, None)
        if key == "fullinertia":
            element.attrib.pop("diaginertia", None)
        element.set(key, value)
        text = ElementTree.tostring(root, encoding="unicode")
        found = accelerations(text)
        if found is not None and np.abs(found - base).max() > 1e-9:
            yield text
            return


def read(path: Path) -> tuple[object, ...]:
    """All that an import says."""
    found: Imported = import_file(path)
    return found.mechanism, found.forces, found.gravity, found.limits, found.account


@pytest.mark.slow
def test_no_attribute_that_changes_accelerations_is_dropped(tmp_path: Path) -> None:
    base = accelerations(MODEL)
    assert base is not None
    as_it_is, tried = read(saved(MODEL, tmp_path)), 0
    for path, attributes in schema():
        if path and path[0] in ("default", "visual", "statistic", "size", "contact", "deformable", "sensor"):
            continue
        for key in attributes:
            for text in changed(path, key, base) if not PASSED.fullmatch(key) else ():
                tried += 1
                try:
                    assert read(saved(text, tmp_path)) != as_it_is, f"{'/'.join(path)}, {key}"
                except DescriptionError:
                    continue
    assert tried > 60


ROTORS = MODEL.partition("<actuator>")[0] + (
    '<actuator><position joint="a" kp="20" dampratio="0.7" gear="2" armature="0.3" damping="0.2"/><motor joint="b" '
    'gear="-3" armature="0.1" damping="0.4" group="3"/><motor tendon="t" gear="2" damping="0.7"/></actuator></mujoco>'
)


@pytest.mark.parametrize("off", ["", 'actuatorgroupdisable="3"'])
def test_rotors_and_dampers_of_actuators(tmp_path: Path, off: str) -> None:
    """Times the square of the gear, in ratios of damping too, and also of actuators whose group is off."""
    text = ROTORS.replace("<option", f"<option {off}")
    robot = load_robot(saved(text, tmp_path))
    model = derive(robot.mechanism, robot.effects)
    labels = [c.label for c in model.system.tree.v]
    place, rate = {"a": 0.3, "b": -0.2}, {"a": 0.7, "b": 0.4}
    place["t"], rate["t"] = (0.5 * v["a"] - 1.5 * v["b"] for v in (place, rate))
    given = {"q": [place[name] for name in labels], "v": [rate[name] for name in labels]}
    ports = model.programs["forward_dynamics"].inputs
    found, status = model("forward_dynamics", *(given.get(port.name, np.zeros(port.shape)) for port in ports))
    assert not np.any(status)
    assert [found[0][labels.index(name)] for name in "ab"] == pytest.approx(accelerations(text), rel=1e-9)


@pytest.mark.parametrize(
    ("actuator", "message"),
    [
        ('<position joint="a" tendon="t"/>', "expected one thing to act on, got joint and tendon"),
        ('<motor joint="a" surprise="1"/>', "attribute 'surprise' is not supported"),
        ('<motor joint="a" damping="0 2"/>', "powers of damping of actuators above the first"),
    ],
)
def test_what_else_actuators_say_is_refused(tmp_path: Path, actuator: str, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        import_file(saved(f"{MODEL.partition('<actuator>')[0]}<actuator>{actuator}</actuator></mujoco>", tmp_path))
