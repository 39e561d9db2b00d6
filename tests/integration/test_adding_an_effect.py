"""An effect is one file: added to a copy of the package, named in a scene, and used from there to the results."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from support.magnetic_brake import MAGNETIC_BRAKE

import symscrew

SLOW_INERTIA = '''
"""A simplification of one's own: accelerations count, centrifugal and gyroscopic moments of spin do not."""

from dataclasses import dataclass
from typing import ClassVar

from symscrew.effects.effect import Effect


@dataclass(frozen=True, repr=False)
class SlowInertia(Effect):
    """No gyroscopic moments, by another name."""

    simplifies: ClassVar[str] = "slow inertia"
    keeps_gyroscopic_moments: ClassVar[bool] = False
'''

SCENE = """
[scene]
name = "braked"
mechanism = "four_bar"
duration = 0.5
rate = 100

[initial]
rates = { A = 4 }

[[effects]]
type = "magnetic_brake"
joint = "A"
c = 0.5
"""

SCRIPT = """
import json, sys
from pathlib import Path
import numpy as np
import symscrew
from symscrew.effects import check_effects, simplifications
from symscrew.studies import bill_of_effects

folder = Path(sys.argv[1])
scene = symscrew.load_scene(folder / "braked.toml")
check_effects(scene.mechanism, scene.effects)
braked, plain = symscrew.derive(scene.mechanism, scene.effects), symscrew.derive(scene.mechanism, ())
states = plain.test_inputs["inverse_dynamics_independent"]
forces = [m("inverse_dynamics_independent", *states)[0][0].tolist() for m in (braked, plain)]
run = symscrew.simulate(scene)
symscrew.generate(braked.only(["inverse_dynamics"]), folder / "out", ["numpy"])
print(json.dumps({
    "rate": [x.tolist() for x in states], "forces": forces, "q": run.q.tolist(), "v": run.v.tolist(),
    "ok": run.ok, "simplifications": list(simplifications()),
    "checked": symscrew.check(folder / "out").lines, "manifest": json.loads((folder / "out/manifest.json").read_text()),
}))
"""


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> dict:
    """What the script prints with the copy of the package."""
    folder = tmp_path_factory.mktemp("own_effect")
    package = folder / "symscrew"
    shutil.copytree(Path(symscrew.__file__).parent, package, ignore=shutil.ignore_patterns("*.pyc.*"))
    (package / "effects/magnetic_brake.py").write_text(MAGNETIC_BRAKE)
    (package / "effects/slow_inertia.py").write_text(SLOW_INERTIA)
    (folder / "braked.toml").write_text(SCENE)
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(folder)],
        env={**os.environ, "PYTHONPATH": str(folder)}, cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.slow
def test_its_force_is_that_of_the_formula(found: dict) -> None:
    rate = np.array(found["rate"][1])[:, 0]
    braked, plain = (np.array(forces)[:, 0] for forces in found["forces"])
    assert braked - plain == pytest.approx(0.5 * rate / (1 + (rate / 3) ** 2), rel=1e-12)


@pytest.mark.slow
def test_it_slows_the_simulated_scene_down(found: dict) -> None:
    assert found["ok"]
    rates = np.array(found["v"])[:, 0]
    assert rates[0] == pytest.approx(4)
    assert abs(rates[-1]) < 3


@pytest.mark.slow
def test_it_is_written_to_the_manifest_and_read_back_by_check(found: dict) -> None:
    assert found["manifest"]["effects"] == [{"type": "MagneticBrake", "joint": "A", "c": "0.5"}]
    assert any("same bytes" in line for line in found["checked"])
    assert not [line for line in found["checked"] if "FAILED" in line]


@pytest.mark.slow
def test_a_simplification_is_found_by_what_it_says_of_itself(found: dict) -> None:
    assert found["simplifications"] == ["massless limbs", "no gyroscopic terms", "quasi-static", "slow inertia"]
