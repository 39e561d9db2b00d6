"""Joints whose coordinates would have one name: `joint.2`, of a free joint, and a joint that is called `joint_2`."""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.robot_engines import with_mujoco

from symscrew.formats import ImportOptions

from .test_import_details import INERTIAL, saved

FILES = {
    "unnamed joints of a floating arm": ("<freejoint/>", '<joint axis="0 1 0"/>'),
    "a ball": ('<joint name="b" type="ball"/>', '<joint name="b_wx" axis="0 1 0"/>'),
}


@pytest.mark.parametrize("name", FILES)
def test_each_has_a_coordinate_of_its_own(tmp_path: Path, name: str) -> None:
    outer, inner = FILES[name]
    text = (
        f'<mujoco><worldbody><body pos="0 0 1">{outer}{INERTIAL}<body pos="0.3 0 0">{inner}{INERTIAL}</body></body>'
        "</worldbody></mujoco>"
    )
    worst, what = with_mujoco(saved(text, tmp_path), ImportOptions())
    assert worst < 1e-9, what
