"""Generated code with effects: checked in every target, and nothing of an effect that is not asked for."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import symscrew
from symscrew import catalogue
from symscrew import effects as known
from symscrew.cli.parser import main
from symscrew.effects.effect import Effect
from symscrew.effects.gravity import Gravity
from symscrew.effects.registry import known_effects
from symscrew.generation.folder import generate
from symscrew.model import derive
from symscrew.verification.regeneration import check

PACKAGE = Path(symscrew.__file__).parent
CRANK = "slider_crank"


def effect(name: str, *args: object, **fields: object) -> Effect:
    return getattr(known, name)(*args, **fields)


PRINT = """
import sys
from symscrew import catalogue
from symscrew.effects.registry import known_effects, effect_from_table
from symscrew.export.c import print_c
from symscrew.model import derive
scenes = [None, [{"type": "gravity"}, {"type": "viscous_friction", "joint": "A", "coefficient": "0.2"}]]
for scene in scenes:
    effects = () if scene is None else ([effect_from_table(t) for t in scene],)
    found = derive(catalogue.load("four_bar"), *effects)
    for name, text in print_c(found.only(["inverse_dynamics", "forward_dynamics", "energy"])).items():
        sys.stdout.write(text)
sys.stderr.write(" ".join(known_effects()))
"""


def printed(package: Path) -> tuple[str, set[str]]:
    """What the package in a folder prints, and the effects that it knows."""
    result = subprocess.run(
        [sys.executable, "-c", PRINT], cwd=package, env={"PYTHONPATH": str(package)}, capture_output=True, text=True
    )
    assert result.returncode == 0, result.stderr[-2000:]
    return result.stdout, set(result.stderr.split())


@pytest.mark.slow
def test_nothing_asked_nothing_paid(tmp_path: Path) -> None:
    """With the files of all other effects taken away the C is the same, byte for byte."""
    shutil.copytree(PACKAGE, tmp_path / "symscrew", ignore=shutil.ignore_patterns("*.pyc.*", "page"))
    expected, every = printed(tmp_path)
    assert every == set(known_effects()) and len(expected) > 10_000
    gone = every - {"gravity", "viscous_friction"}
    for name in gone:
        (tmp_path / "symscrew" / "effects" / f"{name}.py").unlink()
    text, left = printed(tmp_path)
    assert text == expected and not left & gone


@pytest.mark.slow
def test_generated_code_with_effects_is_checked(tmp_path: Path) -> None:
    """States, time, exp, further inputs and a payload, through C, CasADi and NumPy and back from the manifest."""
    effects = [
        Gravity(input="switch"),
        effect("ExternalWrench", "piston", ("10*exp(-t)", "sin(t)", 0, 0, 0, "t")),
        effect("DcMotor", "crank_R", "0.05", "1.2", "0.0008", 50),
        effect("EndStop", "slider_P", upper=1, stiffness=1000, damping="0.4"),
        effect("DryFriction", "slider_P", load="0.1", velocity="0.01"),
        effect("Payload", "rod", "0.5", (0, 0, "0.1")),
    ]
    found = derive(catalogue.load(CRANK), effects)
    forced = [name for name in found.programs if re.search("dynamics|reactions|energy", name)]
    assert len(forced) == 8  # the others know of no effect
    some = ["inverse_dynamics", "forward_dynamics", "joint_reactions", "energy"]
    assert set(some) <= set(forced)
    generate(found.only(some), tmp_path / "loaded")
    result = check(tmp_path / "loaded")
    assert result.ok, "\n".join(result.lines)


def test_generate_takes_the_effects_of_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text('[[effects]]\ntype = "viscous_friction"\njoint = "A"\ncoefficient = 0.25\n')
    arguments = ["generate", "four_bar", "--target", "numpy", "--out", str(tmp_path / "out"), "--effects", str(scene)]
    assert main(arguments) == 0
    manifest = json.loads((tmp_path / "out" / "manifest.json").read_text())
    assert manifest["effects"] == [{"type": "ViscousFriction", "joint": "A", "coefficient": "0.25"}]
    assert check(tmp_path / "out").ok
    capsys.readouterr()
    assert main([*arguments, "--no-gravity"]) == 2
    assert "leave --gravity" in capsys.readouterr().err
    scene.write_text('[[effects]]\ntype = "viscous_friction"\njoint = "a"\ncoefficient = -1\n')
    assert main(arguments) == 2
    error = capsys.readouterr().err.splitlines()[-1]
    assert ("expected a joint" in error and "did you mean 'A'" in error) or "known: A" in error
    scene.write_text("x = 1\n")
    assert main(arguments) == 2
    assert "expected tables [[effects]]" in capsys.readouterr().err
