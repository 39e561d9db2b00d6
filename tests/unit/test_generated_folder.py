"""The folder that is generated: written whole or not at all, and never over what others wrote."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest
from support import handmade
from support.model_states import pendulum

from symscrew.export.manifest_file import OutputError
from symscrew.export.readme import print_readme
from symscrew.generation.folder import generate
from symscrew.model import derive
from symscrew.program.straight_line import Instruction


@pytest.fixture(scope="module")
def model():
    return handmade.model()


@pytest.fixture(scope="module")
def generated(model, tmp_path_factory) -> Path:
    directory = tmp_path_factory.mktemp("export") / "handmade"
    generate(model, directory)
    return directory


def test_no_place_or_time_in_the_output(generated):
    home = str(Path(__file__).parents[2])
    for path in generated.iterdir():
        content = path.read_bytes()
        assert home.encode() not in content, path
        assert not re.search(rb"\b20\d\d-\d\d-\d\d\b", content), path


def test_generating_again_changes_nothing_and_removes_what_is_stale(model, tmp_path):
    directory = tmp_path / "out"
    generate(model, directory)
    (directory / "build").mkdir()
    (directory / "notes.txt").write_text("mine")
    before = {path.name: path.read_bytes() for path in directory.iterdir() if path.is_file()}
    generate(model, directory)
    assert before == {path.name: path.read_bytes() for path in directory.iterdir() if path.is_file()}
    generate(model, directory, targets=("c",))
    names = {path.name for path in directory.iterdir()}
    assert "handmade_numpy.py" not in names
    assert {"handmade_support.c", "notes.txt", "build"} <= names


def test_files_of_others_are_not_overwritten(model, tmp_path):
    (tmp_path / "full").mkdir()
    (tmp_path / "full/thesis.tex").write_text("all I have")
    with pytest.raises(OutputError, match="did not write"):
        generate(model, tmp_path / "full")
    assert [path.name for path in tmp_path.rglob("*")] == ["full", "thesis.tex"]
    generate(model, tmp_path / "out", targets=("numpy",))
    (tmp_path / "out/handmade_support.c").write_text("/* by hand */")
    with pytest.raises(OutputError, match=r"handmade_support\.c was not written by this tool"):
        generate(model, tmp_path / "out")
    assert (tmp_path / "out/handmade_support.c").read_text() == "/* by hand */"


def test_what_is_no_manifest_any_more_has_a_way_out(model, tmp_path):
    (tmp_path / "manifest.json").write_text("torn")
    with pytest.raises(OutputError, match=r"not valid JSON.*; remove the directory, or use another one"):
        generate(model, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["manifest.json"]


def test_a_manifest_cannot_name_files_elsewhere(model, tmp_path):
    generate(model, tmp_path / "out")
    (tmp_path / "precious.txt").write_text("keep")
    manifest = json.loads((tmp_path / "out/manifest.json").read_text())
    manifest["files"] += ["../precious.txt", "/precious.txt"]
    (tmp_path / "out/manifest.json").write_text(json.dumps(manifest))
    generate(model, tmp_path / "out")
    assert (tmp_path / "precious.txt").read_text() == "keep"


def test_nothing_is_half_written(model, tmp_path, monkeypatch):
    broken = handmade.guarded()
    broken = replace(broken, instructions=(*broken.instructions[:-1], Instruction(4, "mul", (1, float("inf")))))
    with pytest.raises(ValueError, match="finite"):
        generate(handmade.model(broken=broken), tmp_path / "out")
    assert list(tmp_path.iterdir()) == []
    write, written = Path.write_bytes, []

    def full_disk(path: Path, data: bytes) -> int:
        written.append(path)
        if len(written) > 4:
            raise OSError("no space left")
        return write(path, data)

    monkeypatch.setattr(Path, "write_bytes", full_disk)
    with pytest.raises(OutputError, match=r"out: cannot be written \(no space left\); nothing was, use another place"):
        generate(model, tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_functions_without_a_number_to_print_have_no_example() -> None:
    """An open chain has no loops whose margins could change: their derivatives have no entries."""
    model = derive(pendulum().mechanism, second_derivatives=True).only(["limb_margins_hessian"])
    text = print_readme(model, {"c": "C", "numpy": "NumPy", "javascript": "JavaScript"})
    assert "`limb_margins_hessian`" in text and "int main" not in text
