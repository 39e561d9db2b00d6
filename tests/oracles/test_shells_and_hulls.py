"""Bodies of thin walls, and of points whose hull they are: mass, centre and inertia are those of MuJoCo."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

from symscrew.errors import DescriptionError
from symscrew.formats import load_format

from .test_import_details import saved

POINTS = "0 0 0 0.3 0 0.02 0.05 0.2 0 0 0.01 0.25 0.2 0.2 0.2 0.1 0.1 0.1 0.25 0.1 0.15"
GEOMS = {
    "shell of a sphere": ("", 'type="sphere" size="0.2"'),
    "shell of a capsule": ("", 'type="capsule" size="0.1" fromto="0 0 0 0.2 0.3 0.4"'),
    "shell of a cylinder": ("", 'type="cylinder" size="0.1 0.3"'),
    "shell of a box": ("", 'type="box" size="0.1 0.2 0.35" mass="1.3"'),
    "shell of an ellipsoid": ("", 'type="ellipsoid" size="0.1 0.2 0.35"'),
    "points without faces": (f'vertex="{POINTS}" scale="1 2 -1"', 'type="mesh" mesh="m"'),
    "points as a shell": (f'vertex="{POINTS}" inertia="shell"', 'type="mesh" mesh="m"'),
    "faces that are asked for as their hull": (
        f'vertex="{POINTS}" face="0 1 2 0 2 3 1 2 4 2 3 4 0 5 1" inertia="convex"',
        'type="mesh" mesh="m"',
    ),
    "points of a file": ('file="points.obj"', 'type="mesh" mesh="m"'),
    "ground that a body carries": ("", 'type="hfield" hfield="h" pos="0.1 0.2 0.3"'),
    "a capsule fitted to points": (f'vertex="{POINTS}"', 'type="capsule" mesh="m"'),
}


@pytest.mark.parametrize("name", GEOMS)
def test_inertia_is_that_of_mujoco(tmp_path: Path, name: str) -> None:
    mesh, geom = GEOMS[name]
    numbers = POINTS.split()
    lines = [f"v {' '.join(numbers[k : k + 3])}" for k in range(0, len(numbers), 3)]
    (tmp_path / "points.obj").write_text("\n".join(lines))
    field = '<hfield name="h" nrow="2" ncol="2" size="1 2 3 4"/>' if "hfield" in geom else ""
    asset = f'<asset>{field}<mesh name="m" {mesh}/></asset>' if mesh else f"<asset>{field}</asset>"
    shell = 'shellinertia="true"' if name.startswith("shell") else ""
    path = saved(
        f'<mujoco>{asset}<worldbody><body name="b"><joint/><geom {geom} {shell}/></body></worldbody></mujoco>', tmp_path
    )
    engine = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    body = load_format(path).bodies["b"]
    assert body.com is not None and body.inertia is not None
    turn = data.ximat[1].reshape(3, 3)
    found = np.array([[float(c) for c in row] for row in body.inertia])
    wanted = turn @ np.diag(engine.body_inertia[1]) @ turn.T
    # the engine keeps a mesh in single precision after it has moved it to its centre
    near = 1e-6 if mesh else 1e-10
    assert float(body.mass or 0) == pytest.approx(engine.body_mass[1], rel=near)
    assert np.abs(found - wanted).max() < near * wanted.max()
    assert [float(c) for c in body.com] == pytest.approx(list(data.xipos[1]), rel=near, abs=near)


@pytest.mark.parametrize(
    ("mesh", "message"),
    [
        ('vertex="0 0 0 1 0 0 0 1 0 1 1 0"', "no convex hull with a volume"),
        ('vertex="0 0 0 1 0 0"', "no convex hull with a volume"),
        (f'vertex="{POINTS}" maxhullvert="5"', "maxhullvert of a hull that gives inertia"),
    ],
)
def test_what_has_no_hull_is_refused(tmp_path: Path, mesh: str, message: str) -> None:
    geom = '<geom type="mesh" mesh="m"/>'
    text = f'<mujoco><asset><mesh name="m" {mesh}/></asset><worldbody><body><joint/>{geom}</body></worldbody></mujoco>'
    with pytest.raises(DescriptionError, match=message):
        load_format(saved(text, tmp_path))
