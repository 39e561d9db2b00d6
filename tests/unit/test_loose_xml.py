"""Files that XML refuses and that other readers of robots take: the same numbers, or the error as before."""

from __future__ import annotations

from pathlib import Path

import mujoco
import pytest

from symscrew.errors import DescriptionError
from symscrew.formats import import_file

BODY = '<body name="b"><joint name="j"/><geom type="box"size="0.1 0.2 0.3" mass="2"/></body>'
LOOSE = {
    "no space": f"<mujoco><worldbody>{BODY}</worldbody></mujoco>",
    "dashes": f"<mujoco><!-- a -- b --><worldbody>{BODY}</worldbody></mujoco>",
    "signs": f'<mujoco model="a & b < c &amp; d"><worldbody>{BODY}</worldbody></mujoco>',
    "blank lines": f'\n\n<?xml version="1.0"?>\n<mujoco><worldbody>{BODY}</worldbody></mujoco>',
    "a comment in another encoding": f"<mujoco><!-- 90\xb0 --><worldbody>{BODY}</worldbody></mujoco>",
}


@pytest.mark.parametrize("name", LOOSE)
def test_what_mujoco_reads(tmp_path: Path, name: str) -> None:
    path = tmp_path / "loose.xml"
    path.write_bytes(LOOSE[name].encode("latin-1"))
    mechanism = import_file(path).mechanism
    engine = mujoco.MjModel.from_xml_path(str(path))
    inertia = [float(mechanism.number(mechanism.bodies["b"].inertia[k][k])) for k in range(3)]
    assert sorted(inertia) == pytest.approx(sorted(engine.body_inertia[1]), rel=1e-12)


def test_prefixes_that_nobody_declares(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    joint = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    camera = '<gazebo><sensor:camera name="c"><body:x/></sensor:camera></gazebo>'
    path.write_text(f'<robot name="r"><link name="a"/><link name="b"/>{joint}{camera}</robot>')
    assert import_file(path).account.taken["joints"] == 1


@pytest.mark.parametrize(
    "text",
    [
        "<mujoco><worldbody>",
        '<mujoco a="1" a="2"/>',
        "<mujoco model=a/>",
        "<mujoco/><mujoco/>",
        "<mujoco a='1' b/>",
        "text <mujoco/>",
        "<mujoco><![CDATA[ & ]]> & </mujoco>",
    ],
)
def test_everything_else_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "loose.xml"
    path.write_text(text)
    with pytest.raises(DescriptionError, match="not a valid XML file"):
        import_file(path)


def test_document_types_stay_refused(tmp_path: Path) -> None:
    path = tmp_path / "loose.xml"
    path.write_text('\n<?xml version="1.0"?><!DOCTYPE m [<!ENTITY e "x">]><mujoco model="&e;"/>')
    with pytest.raises(DescriptionError, match=r"DOCTYPE|not a valid XML file"):
        import_file(path)
