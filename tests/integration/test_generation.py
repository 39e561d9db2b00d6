"""Generated output of real mechanisms, from description to checked files; and that `check` finds changes."""

from __future__ import annotations

import dataclasses
import json
import tempfile
from pathlib import Path

import numpy as np
import pytest
from support.model_states import body_states, model, relative

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description import MechanismBuilder, toml_file
from symscrew.effects.external_wrench import ExternalWrench
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.export.manifest_file import OutputError
from symscrew.export.numpy import print_numpy
from symscrew.generation import numpy_target
from symscrew.generation.folder import generate
from symscrew.model import derive
from symscrew.reference.newton_euler_method import newton_euler
from symscrew.runtime.compiled import load
from symscrew.verification.regeneration import check


@pytest.fixture(scope="module")
def four_bar():
    return model("four_bar")


def failures(directory: Path) -> list[str]:
    result = check(directory)
    failed = [line for line in result.lines if ": FAILED: " in line]
    assert result.ok == (not failed)
    return failed


@pytest.mark.slow
def test_check_covers_every_target(four_bar, tmp_path):
    """What `check` does for those that `test_odd_names_in_every_target` leaves out: one that is reduced has its own."""
    some = four_bar.only(["assemble", "energy", "forward_dynamics"])
    generate(some, tmp_path / "loop", ["fmu", "modes", "markdown"])
    generate(model("ur5").only(["body_poses"]), tmp_path / "arm", ["urdf"])
    results = [check(folder) for folder in sorted(tmp_path.iterdir())]
    said = "\n".join(line for result in results for line in result.lines)
    assert all(result.ok for result in results), said
    for what in ("FMU: accelerations agree", "FMU: a step", "certified in Python", "arm: ok: URDF read back"):
        assert what in said


@pytest.mark.skipif(not Path("/dev/shm").is_dir(), reason="needs a second file system")
def test_a_directory_on_another_file_system(four_bar, tmp_path):
    """A mounted folder, or a link to one: what is written is moved within it, and nothing is left beside."""
    with tempfile.TemporaryDirectory(dir="/dev/shm") as elsewhere:
        assert Path(elsewhere).stat().st_dev != tmp_path.stat().st_dev
        (tmp_path / "out").symlink_to(elsewhere)
        for _ in range(2):
            generate(four_bar, tmp_path / "out", ["numpy"])
        written = {"README.md", "four_bar_numpy.py", "manifest.json", "mechanism.toml", "ops.json", "test_vectors.json"}
        assert {path.name for path in Path(elsewhere).iterdir()} == written
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


def test_a_format_that_cannot_hold_the_mechanism_leaves_nothing(four_bar, tmp_path):
    with pytest.raises(DescriptionError, match="a URDF is a tree"):
        generate(four_bar, tmp_path / "out", ["c", "urdf"])
    assert not list(tmp_path.iterdir())


def test_a_compiler_that_fails_or_is_missing_is_named(four_bar, tmp_path, monkeypatch, capsys):
    """Nothing half written, one line of error, and what to install."""
    tools = tmp_path / "tools"
    tools.mkdir()
    for tool in ("cc", "gcc", "clang"):
        (tools / tool).write_text("#!/bin/sh\necho 'internal compiler error: killed' >&2\nexit 4\n")
        (tools / tool).chmod(0o755)
    generate(four_bar.only(["energy"]), tmp_path / "out", ["c", "javascript"])
    monkeypatch.setenv("PATH", str(tools))
    assert main(["fmu", "four_bar", "--out", str(tmp_path / "four_bar.fmu")]) == 1
    said = capsys.readouterr().err
    assert "cc refused four_bar.c: internal compiler error" in said and "Traceback" not in said
    assert main(["check", str(tmp_path / "out")]) == 1
    assert "internal compiler error" in "".join(capsys.readouterr())
    monkeypatch.setenv("PATH", str(tmp_path))
    assert main(["check", str(tmp_path / "out")]) == 0
    said = capsys.readouterr().out
    assert ": skipped: no C compiler here (apt install gcc)" in said
    assert ": skipped: no Node here (apt install nodejs)" in said
    assert "were skipped" in said and "all checks passed" not in said
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out", "tools"]


def test_other_effects_and_coordinates_are_regenerated(tmp_path):
    effects = (Gravity((0, 0, "-1.62")), ExternalWrench("coupler_middle"))
    generate(derive(catalogue.load("four_bar"), effects, independent=["B"]), tmp_path / "moon", targets=("numpy",))
    manifest = json.loads((tmp_path / "moon/manifest.json").read_text())
    assert manifest["independent"] == ["B"]
    assert manifest["effects"][1].items() >= {"type": "ExternalWrench", "point": "coupler_middle"}.items()
    assert failures(tmp_path / "moon") == []


def test_the_description_is_kept(four_bar, tmp_path):
    generate(four_bar.only(["energy"]), tmp_path, ["numpy"])
    assert toml_file.load_description(tmp_path / "mechanism.toml") == four_bar.mechanism


@pytest.mark.slow
def test_changed_bytes_and_values_are_found(four_bar, tmp_path):
    """One changed byte in each of five files, an operation less and a value off by 1e-10 in what is recorded."""
    output = tmp_path / "out"
    generate(four_bar.only(["inverse_dynamics", "momentum_screws"]), output, ["c", "numpy"])
    names = ["four_bar_momentum.c", "four_bar.h", "four_bar_numpy.py", "example.c", "CMakeLists.txt"]
    for name in names:
        content = bytearray((output / name).read_bytes())
        content[len(content) // 2] ^= 1
        (output / name).write_bytes(content)
    operations = json.loads((output / "ops.json").read_text())
    operations["inverse_dynamics"]["mul"] -= 1
    operations["inverse_dynamics"]["total"] -= 1
    before = operations["inverse_dynamics"]["total"]
    (output / "ops.json").write_text(json.dumps(operations))
    vectors = json.loads((output / "test_vectors.json").read_text())
    vectors["inverse_dynamics"]["outputs"]["u"][0][0] *= 1 + 1e-10
    (output / "test_vectors.json").write_text(json.dumps(vectors))
    failed = failures(output)
    for name in names:
        assert len([f for f in failed if f"{name} differs from what is generated today, line " in f]) == 1
    assert [f for f in failed if f"operations of inverse_dynamics rose from {before} to {before + 1}" in f]
    value = [f for f in failed if "test_vectors.json agrees with the evaluator to" in f]
    assert len(value) == 1 and "inverse_dynamics, u" in value[0]
    assert len(failed) == len(names) + 3  # ops.json differs in bytes, too


@pytest.mark.slow
def test_code_that_holds_declared_parameters_is_found(tmp_path, monkeypatch):
    """A target that takes the declared number in place of the run-time parameter that it is given."""
    made = MechanismBuilder("swing", platform="arm")
    made.parameter("l", "0.4", "m", run_time=True)
    made.body("arm", mass=1, com=["l", 0, 0], inertia=["1/100", "1/50", "3/100"])
    made.joint("hinge", "R", parent="base", child="arm", axes=[[0, 1, 0]], point=[0, 0, 0])
    swing = derive(made.build()).only(["energy"])
    generate(swing, tmp_path / "right", ["numpy"])
    assert failures(tmp_path / "right") == []

    def held(of):
        return {
            name: text.replace(") = entries\n", ") = entries\n    l_p = 0.4\n")
            for name, text in print_numpy(of).items()
        }

    monkeypatch.setattr(numpy_target, "print_numpy", held)
    generate(swing, tmp_path / "wrong", ["numpy"])
    (found,) = failures(tmp_path / "wrong")
    assert "NumPy module agrees with the evaluator to" in found and "energy" in found


@pytest.mark.slow
def test_casadi_files_may_be_left_out(four_bar, tmp_path):
    generate(four_bar.only(["energy"]), tmp_path, targets=("casadi", "numpy"))
    (tmp_path / "energy.casadi").unlink()
    assert failures(tmp_path) == []


def test_a_missing_file_is_found(four_bar, tmp_path):
    generate(four_bar, tmp_path, targets=("numpy",))
    (tmp_path / "four_bar_numpy.py").unlink()
    assert [f for f in failures(tmp_path) if "four_bar_numpy.py is missing" in f]


def test_nothing_to_check_is_an_error(tmp_path):
    with pytest.raises(OutputError, match="generate first"):
        check(tmp_path)
    (tmp_path / "manifest.json").write_text('{"tool": "other"}')
    with pytest.raises(OutputError, match="written by symscrew"):
        check(tmp_path)


def test_the_seed_from_its_name_to_compiled_code(tmp_path):
    """The manifest is enough to call the code, whose drives are those of Newton and Euler's equations of every body."""
    one = ["--target", "c", "--functions", "inverse_dynamics"]
    assert main(["generate", "three_ups_upu_s", *one, "--out", str(tmp_path / "seed")]) == 0
    manifest = json.loads((tmp_path / "seed/manifest.json").read_text())
    entry = manifest["functions"]["inverse_dynamics"]
    assert [port["name"] for port in entry["inputs"]] == ["q", "v", "a"]
    assert [port["name"] for port in entry["outputs"]] == ["u"]
    for port in (*entry["inputs"], *entry["outputs"]):
        assert len(port["labels"]) == int(np.prod(port["shape"]))
        assert isinstance(port["unit"], str) or len(port["unit"]) == len(port["labels"])
    compiled, seed = load(tmp_path / "seed", trusted=True, vectorised=False), model("three_ups_upu_s")
    states = seed.test_inputs["inverse_dynamics"]
    u = compiled.inverse_dynamics(*states)
    (expected,), _ = seed("inverse_dynamics", *states)
    assert u == pytest.approx(expected, rel=1e-12)
    gravity = (0.0, 0.0, -9.81)
    assert relative(u, newton_euler(seed.mechanism, body_states(seed, *states), gravity=gravity).drives) < 1e-10


@pytest.fixture(scope="module")
def triangle():
    """Three bars that hold each other: a loop, and no freedom, so that y has no entries."""
    builder = MechanismBuilder("triangle", platform="left")
    for body, x in (("left", 0), ("right", 1)):
        builder.body(body, mass=1, com=[x, 0, "1/2"], inertia=["0.01", "0.02", "0.03"])
    bars = (("A", "base", "left", [0, 0, 0]), ("B", "left", "right", [0, 0, 1]), ("C", "base", "right", [1, 0, 0]))
    for name, parent, child, point in bars:
        builder.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 1, 0]])
    return derive(builder.build(), second_derivatives=True)


@pytest.mark.slow
def test_a_mechanism_without_freedom_is_served_by_every_language(triangle, tmp_path):
    """Arrays without entries: NumPy, JAX and Node cannot tell the number of states from them, C++ warns of loops."""
    few = triangle.only(["assemble", "velocity", "null_space", "forward_dynamics", "body_poses"])
    generate(few, tmp_path, ["numpy", "javascript", "jax", "cuda"])
    result = check(tmp_path)
    assert result.ok, result.lines


@pytest.mark.parametrize("target", ["reduced", "linuxcnc", "st_drives", "ros2"])
def test_a_mechanism_without_freedom_has_no_drives(triangle, target, tmp_path):
    with pytest.raises(DescriptionError, match="no freedom"):
        generate(triangle, tmp_path / "out", [target])
    assert not (tmp_path / "out").exists()
    assert not any("independent_hessian" in name for name in triangle.programs)


@pytest.mark.parametrize(
    ("target", "most"), [("linuxcnc", 57), ("ros2", 57), ("external", 54), ("external_hessians", 54)]
)
def test_names_that_get_longer_say_how_long_they_may_be(four_bar, target, most, tmp_path):
    """The limit is that of names; what is said is of the mechanism's own."""
    mechanism = dataclasses.replace(four_bar.mechanism, name="a" * (most + 1))
    with pytest.raises(DescriptionError, match=f"at most {most} letters.*got {most + 1}"):
        generate(dataclasses.replace(four_bar, mechanism=mechanism, name=mechanism.name), tmp_path / "out", [target])
