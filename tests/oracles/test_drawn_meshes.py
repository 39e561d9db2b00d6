"""What bodies look like: triangles of a file's meshes where MuJoCo has them, packages, what is not there."""

from __future__ import annotations

import base64
import struct
from pathlib import Path

import mujoco
import numpy as np
import pytest
from support.model_states import model

from symscrew.display.view import page_scene
from symscrew.formats import ImportOptions, import_file, mesh_pictures
from symscrew.formats.drawn_meshes import MOST_TRIANGLES, _thinned

Array = np.ndarray
CORNERS = np.array([[0, 0, 0], [0.3, 0, 0], [0, 0.2, 0], [0, 0, 0.1]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
BODY = """<body name="arm" pos="0.1 0.2 0.3" euler="10 20 30">
<joint name="j" axis="0 1 0" ref="25"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
<geom type="mesh" mesh="part" pos="0.5 0 0" euler="40 0 70"/></body>"""
LINK = """<robot name="r"><link name="a"/><link name="b"><visual><origin xyz="0 0 1" rpy="0 0 0.5"/><geometry>
<mesh filename="{visual}" scale="2 2 2"/></geometry></visual><collision><geometry><mesh filename="{hit}"/></geometry>
</collision></link><joint name="j" type="revolute"><parent link="a"/><child link="b"/><origin xyz="3 0 0"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>"""


def stl(path: Path, triangles: Array) -> None:
    rows = b"".join(struct.pack("<12fH", *np.zeros(3), *triangle.ravel(), 0) for triangle in triangles)
    path.write_bytes(b" " * 80 + struct.pack("<I", len(triangles)) + rows)


def test_meshes_are_where_mujoco_has_them(tmp_path: Path) -> None:
    stl(tmp_path / "part.stl", CORNERS[FACES])
    mesh = '<mesh name="part" file="part.stl" scale="1 2 0.5" refpos="0.1 0 0" refquat="0.8 0.6 0 0"/>'
    path = tmp_path / "robot.xml"
    path.write_text(f"<mujoco><asset>{mesh}</asset><worldbody>{BODY}</worldbody></mujoco>")
    engine = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    expected = engine.mesh_vert @ data.geom_xmat[0].reshape(3, 3).T + data.geom_xpos[0]
    found = mesh_pictures(path)
    corners = found.triangles["arm"].reshape(-1, 3)
    assert corners.shape == (12, 3) and not found.missing
    apart = np.linalg.norm(corners[:, None] - expected[None], axis=2)
    assert max(apart.min(axis=0).max(), apart.min(axis=1).max()) < 1e-6  # singles, as MuJoCo stores vertices


@pytest.mark.parametrize("name", ["package://pack/meshes/part.stl", "package://elsewhere/meshes/part.stl"])
def test_meshes_of_packages(tmp_path: Path, name: str) -> None:
    """NAME/rest or rest below the folder that is named; not found below the file's own, which is said."""
    for folder in ("pack/meshes", "pack/urdf"):
        (tmp_path / folder).mkdir(parents=True)
    stl(tmp_path / "pack/meshes/part.stl", CORNERS[FACES])
    path = tmp_path / "pack/urdf/robot.urdf"
    path.write_text(LINK.format(visual=name, hit="none.stl"))
    corners = mesh_pictures(path, ImportOptions(folder=tmp_path)).triangles["b"].reshape(-1, 3)
    turn = np.array([[np.cos(0.5), -np.sin(0.5), 0], [np.sin(0.5), np.cos(0.5), 0], [0, 0, 1]])
    assert corners == pytest.approx(2 * CORNERS[FACES].reshape(-1, 3) @ turn.T + [3, 0, 1], abs=1e-6)
    alone = mesh_pictures(path)
    assert not alone.triangles and "no such file below urdf; name its folder with --folder" in alone.missing[0]
    path.write_text(LINK.format(visual="part.dae", hit=name))
    assert len(mesh_pictures(path, ImportOptions(folder=tmp_path)).triangles["b"]) == len(FACES)
    path.write_text(LINK.format(visual="../../../etc/passwd.stl", hit="part.dae"))
    assert "outside of the model's folder" in mesh_pictures(path).missing[0]


def test_pictures_that_cannot_be_made_do_not_keep_a_robot_from_being_read(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    for name, said in (("x" * 5000 + ".stl", "File name too long"), ("part.stl", "the mesh has no extent")):
        stl(tmp_path / "part.stl", np.ones((MOST_TRIANGLES + 1, 3, 3)))
        path.write_text(LINK.format(visual=name, hit="none.dae"))
        assert import_file(path).mechanism.joints and said in mesh_pictures(path).missing[0]
    path.write_text(LINK.format(visual="part.stl", hit="").replace("0 0 0.5", "a b c"))
    assert import_file(path).mechanism.joints and "expected decimal numbers" in mesh_pictures(path).missing[0]


def test_large_meshes_are_thinned_on_their_surface() -> None:
    """A sphere of 20,000 triangles: few enough are left, and each corner is within a cell of the sphere."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 101), np.linspace(0, np.pi, 101))
    grid = np.stack([np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)], axis=-1)
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    fine = np.concatenate([np.stack(t, axis=2).reshape(-1, 3, 3) for t in ((a, b, c), (a, c, d))])
    few = _thinned(fine)
    assert 500 < len(few) <= MOST_TRIANGLES < len(fine)
    assert abs(np.linalg.norm(few, axis=2) - 1).max() < 0.1


def test_the_page_draws_them_for_outlines() -> None:
    made, triangles = model("four_bar"), CORNERS[FACES].astype(np.float32)
    name = list(made.mechanism.bodies)[-1]
    bodies = {body["name"]: body for body in page_scene(made, pictures={name: triangles})["bodies"]}
    assert [body for body in bodies if "picture" in bodies[body]] == [name]
    assert np.array_equal(np.frombuffer(base64.b64decode(bodies[name]["picture"]), "<f4"), triangles.ravel())
