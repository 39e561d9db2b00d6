"""MJCF files made of parts: what MuJoCo makes of replicated elements and attached models."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, import_file
from symscrew.formats.file_names import safe_names

GEOM = '<geom type="box" size="0.1 0.05 0.02" pos="0.1 0 0"/>'
ROW = f"""<mujoco><compiler eulerseq="zyx"/><worldbody><body name="base" pos="0.1 0 0">{GEOM}
<replicate count="COUNT" offset="0.3 0.1 0" euler="30 0 20" sep="_"><body name="arm" pos="0 0 0.5">
  <joint name="j" axis="0 1 0" damping="0.5"/>{GEOM}<site name="s"/>
  <replicate count="2" offset="0 0 0.4" euler="0 0 90"><body name="tip"><joint name="t" axis="1 0 0"/>{GEOM}</body>
  </replicate></body></replicate></body></worldbody>
<equality><joint name="tie" joint1="t0" joint2="j" polycoef="0 0.5 0 0 0"/></equality>
<tendon><fixed name="cord"><joint joint="j" coef="2"/></fixed></tendon>
<actuator><motor joint="t1"/><motor tendon="cord"/></actuator></mujoco>"""
LEG = f"""<mujoco model="leg"><compiler angle="radian" autolimits="true" meshdir="parts"/><option gravity="0 0 -1"/>
<default><joint damping="3"/><geom density="500"/><default class="light"><joint armature="0.1" damping="1"/></default>
</default><worldbody><body name="hip" pos="0 0.2 0.5" euler="0.5 0 0.1"><joint name="h" class="light" ref="0.2"/>
{GEOM}<body name="shin" pos="0.2 0 0" childclass="light"><joint name="k" axis="0 1 0" range="-1 1"/>{GEOM}</body></body>
<frame name="outer" pos="0 0 1" euler="0.1 0 0"><frame name="inner" pos="0 0.3 0" euler="0 0 0.5">
<body name="other" pos="0 -1 0"><joint name="o" axis="1 0 0"/>{GEOM}</body></frame></frame></worldbody>
<actuator><motor joint="k" name="m"/><motor joint="o"/></actuator>
<equality><joint joint1="h" joint2="k" polycoef="0 2 0 0 0"/><joint joint1="h" joint2="o"/></equality></mujoco>"""
MAIN = f"""<mujoco><default><joint damping="7"/></default><asset><model name="leg" file="parts/leg.xml"/></asset>
<worldbody><body name="base" pos="1 0 0" euler="90 0 0">{GEOM}<joint name="z"/><frame pos="0 0 2" euler="0 45 0">
ATTACHED</frame></body></worldbody></mujoco>"""


OWN = f"""<mujoco><default><joint damping="7"/><default class="light"><joint damping="1"/></default></default>
<worldbody><body name="hip" pos="0 0.2 0.5" euler="30 0 10" childclass="light">{GEOM}<joint name="h"/>
<frame name="f" pos="0 0 1" euler="0 20 0">
<body name="shin" pos="0.2 0 0"><joint name="k" axis="0 1 0"/>{GEOM}<site name="s"/></body></frame>
 <body name="toe" pos="0.3 0 0"><joint name="t" class="main" axis="0 1 0"/>{GEOM}ABOVE</body></body>
<body name="base" pos="1 0 0" euler="90 0 0">{GEOM}<joint name="z"/><frame pos="0 0 2" euler="0 45 0">BELOW
</frame></body></worldbody><tendon><fixed name="cord"><joint joint="t" coef="2"/></fixed></tendon>
<equality><joint joint1="h" joint2="k" polycoef="0 2 0 0 0"/></equality>
<actuator><motor joint="k" name="m"/><motor tendon="cord"/><motor joint="z"/></actuator></mujoco>"""


def written(folder: Path, main: str) -> Path:
    (folder / "parts").mkdir(exist_ok=True)
    (folder / "parts" / "leg.xml").write_text(LEG)
    path = folder / "main.xml"
    path.write_text(main)
    return path


def agrees(path: Path) -> None:
    """Bodies, axes, damping, drives and couplings are those of MuJoCo, under its names."""
    found = import_file(path)
    engine = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    mechanism = found.mechanism
    names = safe_names(engine.body(i).name for i in range(engine.nbody))
    for i in range(1, engine.nbody):
        body = mechanism.bodies[names[engine.body(i).name]]
        com = [float(mechanism.number(c)) for c in body.com]
        assert com == pytest.approx(data.xipos[i], abs=1e-12)
        inertia = np.array([[float(mechanism.number(c)) for c in row] for row in body.inertia])
        turn = data.ximat[i].reshape(3, 3)
        assert np.abs(turn @ np.diag(engine.body_inertia[i]) @ turn.T - inertia).max() < 1e-12
        assert float(mechanism.number(body.mass)) == pytest.approx(engine.body_mass[i], rel=1e-12)
    assert len(mechanism.bodies) == engine.nbody
    damping = {force["joint"]: float(force["coefficient"]) for force in found.forces if force["kind"] == "damping"}
    names = safe_names(engine.joint(i).name for i in range(engine.njnt))
    driven = {engine.joint(k).name for k in engine.actuator_trnid[:, 0][engine.actuator_trntype == 0]}
    driven |= {engine.joint(engine.wrap_objid[k]).name for k in range(engine.nwrap)}
    for i in range(engine.njnt):
        name = names[engine.joint(i).name]
        axis = [float(mechanism.number(c)) for c in mechanism.joints[name].axes[0]]
        assert axis == pytest.approx(data.xaxis[i], abs=1e-12)
        assert damping.get(name, 0.0) == pytest.approx(engine.dof_damping[i])
        assert bool(mechanism.joints[name].driven) == (engine.joint(i).name in driven)
    assert len(mechanism.couplings) == engine.neq


@pytest.mark.parametrize("count", [1, 11])
def test_replicated_elements(tmp_path: Path, count: int) -> None:
    agrees(written(tmp_path, ROW.replace("COUNT", str(count))))


@pytest.mark.parametrize(
    ("above", "below"),
    [
        ("", '<attach body="hip" prefix="l_"/>'),
        ("", '<attach body="shin" prefix="l_"/><attach body="toe" prefix="r_"/>'),
        ("", '<attach frame="f" prefix="l_"/>'),
        ('<frame pos="0 1 0"><attach body="shin" prefix="l_"/></frame>', '<attach body="shin" prefix="r_"/>'),
        ("", '<replicate count="3" euler="0 0 40" sep="-"><attach body="hip" prefix="l_"/></replicate>'),
    ],
)
def test_parts_of_the_model_itself_once_more(tmp_path: Path, above: str, below: str) -> None:
    agrees(written(tmp_path, OWN.replace("ABOVE", above).replace("BELOW", below)))


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize(
    "attached",
    [
        '<attach model="leg" body="hip" prefix="l_"/>',
        '<attach model="leg" prefix="l_"/><attach model="leg" body="shin" prefix="r_"/>',
        '<attach model="leg" prefix=""/>',
        '<attach model="leg" frame="outer" prefix="l_"/><attach model="leg" frame="inner" prefix="r_"/>',
        '<replicate count="3" euler="0 0 40" sep="-"><attach model="leg" prefix="l_"/></replicate>',
    ],
)
def test_attached_models(tmp_path: Path, attached: str) -> None:
    """With their own units, classes and prefixes; of one body without what refers to others."""
    agrees(written(tmp_path, MAIN.replace("ATTACHED", attached)))


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_a_model_is_called_as_its_own_file_says(tmp_path: Path) -> None:
    """Where the file that takes it gives it no name."""
    agrees(written(tmp_path, MAIN.replace('name="leg" ', "").replace("ATTACHED", '<attach model="leg" prefix="l_"/>')))


def test_files_beside_the_model_are_read_where_whoever_imports_says_so(tmp_path: Path) -> None:
    """Attached and included ones, below the folder that is named and nowhere else."""
    written(tmp_path, "")
    scene = MAIN.replace("ATTACHED", '<attach model="leg"/>').replace("parts/leg", "../parts/leg")
    (tmp_path / "scenes").mkdir()
    path = tmp_path / "scenes" / "main.xml"
    path.write_text(scene)
    for text in (scene, '<mujoco><include file="../parts/leg.xml"/></mujoco>'):
        path.write_text(text)
        with pytest.raises(DescriptionError, match=r"outside of the model's folder.*--folder DIR"):
            import_file(path)
        with pytest.raises(DescriptionError, match="outside"):
            import_file(path, ImportOptions(folder=tmp_path / "scenes"))
        assert {"hip", "shin"} <= set(import_file(path, ImportOptions(folder=tmp_path)).mechanism.bodies)


@pytest.mark.parametrize(
    ("main", "message"),
    [
        (ROW.replace("COUNT", "20000"), "expected a count from 1 to 10000"),
        (ROW.replace("COUNT", "1.5"), "expected a count"),
        (ROW.replace("COUNT", "10000"), "at most 100000 elements in all copies, got 10000 copies of"),
        (OWN.replace("ABOVE", '<attach body="hip"/>'), "a body of the model itself that ends above"),
        (OWN.replace("ABOVE", '<attach body="base"/>'), "a body of the model itself that ends above"),
        (OWN.replace("BELOW", '<attach prefix="l_"/>'), "without a model, expected a body or a frame"),
        (MAIN.replace("ATTACHED", '<attach model="lag"/>'), "did you mean 'leg'"),
        (MAIN.replace("ATTACHED", '<attach model="leg" body="foot"/>'), "no body 'foot'"),
        (MAIN.replace("ATTACHED", '<attach model="leg" frame="hip"/>'), "no frame 'hip'"),
        (MAIN.replace("ATTACHED", '<attach model="leg" frame="inner" body="hip"/>'), "a body or a frame of the model"),
        (MAIN.replace("ATTACHED", '<attach model="leg"/>').replace("parts/leg", "../leg"), "outside of the model's"),
        (MAIN.replace("ATTACHED", '<attach model="leg"/>').replace("parts/leg", "main"), "attaches itself"),
    ],
)
def test_what_cannot_be_composed(tmp_path: Path, main: str, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        import_file(written(tmp_path, main))


FUSED = (
    '<mujoco><compiler fusestatic="true" {0}/><worldbody><body name="a" gravcomp="0.5"><joint axis="0 1 0"/>'
    '<geom size="0.1"/><body name="b" pos="0.3 0 0" gravcomp="0.5">'
    '<inertial pos="0 0 0.1" mass="2" diaginertia="0.1 0.1 0.1"/></body></body></worldbody></mujoco>'
)


def test_inertials_that_the_engine_loses_by_fusing_are_said(tmp_path: Path) -> None:
    """Where geoms are to say the mass, those of the fused body alone do."""
    for given in ("", 'inertiafromgeom="true"'):
        text = FUSED.format(given)
        fused, apart = (mujoco.MjModel.from_xml_string(t) for t in (text, text.replace('fusestatic="true"', "")))
        (tmp_path / "main.xml").write_text(text)
        assert (sum(fused.body_mass) < sum(apart.body_mass) - 1) == bool(given)
        if given:
            with pytest.raises(DescriptionError, match="the engine takes the geoms alone of b and a for mass"):
                import_file(tmp_path / "main.xml")
        else:
            assert not import_file(tmp_path / "main.xml").account.influence
