"""The same scene in MuJoCo: its soft loops approach our closed ones as its step shrinks."""

from __future__ import annotations

import numpy as np
import pytest

from symscrew import catalogue
from symscrew.formats.by_suffix import text_of
from symscrew.scene.scene_file import parse_scene
from symscrew.simulation.motion import simulate

mujoco = pytest.importorskip("mujoco")
SCENE = """
[scene]
mechanism = "four_bar"
duration = 0.4
rate = 50
[[effects]]
type = "gravity"
[integrator]
tolerance = 1e-9
"""


def swung(step: float, duration: float) -> np.ndarray:
    """The crank's angle at every 0.02 s, the loop held by MuJoCo's stiffest stable settings."""
    text = text_of(catalogue.load("four_bar"), ".xml")
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.timestep = step
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    model.opt.gravity[:] = (0, 0, -9.81)
    model.opt.tolerance, model.opt.iterations = 0.0, 200
    model.eq_solref[:] = (2 * step, 1.0)
    model.eq_solimp[:] = (0.9999, 0.9999, 1e-6, 0.5, 2)
    data = mujoco.MjData(model)
    address = model.jnt_qposadr[model.joint("A").id]
    every, angles = round(0.02 / step), [data.qpos[address]]
    for k in range(round(duration / step)):
        mujoco.mj_step(model, data)
        if (k + 1) % every == 0:
            angles.append(data.qpos[address])
    return np.array(angles)


@pytest.mark.slow
def test_mujoco_with_small_steps_converges_to_the_run() -> None:
    run = simulate(parse_scene(SCENE))
    ours = run.q[:, [c.label for c in run.model.system.tree.q].index("A")]
    errors = [np.abs(swung(step, 0.4) - ours).max() for step in (1e-3, 2.5e-4, 6.25e-5)]
    assert np.abs(ours).max() > 0.3
    assert errors[0] > errors[1] > errors[2]
    assert errors[2] < 1e-8
