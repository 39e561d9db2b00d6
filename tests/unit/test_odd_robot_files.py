"""Files of robots that contradict themselves or say what has no effect: an error, or a line in the account."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from symscrew.errors import DescriptionError
from symscrew.formats import Account, import_file

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
