"""Folders with hashes in place of their long files: written, checked, refused by who wants the code."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest
from support.model_states import model

import symscrew
from symscrew.cli.parser import main
from symscrew.export import OutputError, read_hashes
from symscrew.generation import generate, render
from symscrew.verification import check

pytestmark = pytest.mark.slow

LEFT = {"README.md", "four_bar_numpy.py", "test_vectors.json"}
KEPT = {"manifest.json", "mechanism.toml", "ops.json", "hashes.json"}
GENERATED = Path(__file__).parents[2] / "generated"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    generate(model("four_bar"), tmp_path / "out", ["numpy"], hashes_only=True)
    return tmp_path / "out"


def names(directory: Path) -> set[str]:
    return {path.name for path in directory.iterdir()}


def failures(directory: Path) -> list[str]:
    return [line for line in check(directory).lines if ": FAILED: " in line]


def test_what_is_kept_and_what_is_hashed(folder: Path) -> None:
    whole = render(model("four_bar"), ["numpy"])
    assert names(folder) == KEPT and set(read_hashes(folder)) == LEFT
    for name in KEPT - {"hashes.json"}:
        assert (folder / name).read_bytes() == whole[name]
    for name, found in read_hashes(folder).items():
        assert (found.sha256, found.size) == (hashlib.sha256(whole[name]).hexdigest(), len(whole[name]))


def test_headers_stay_and_files_that_a_library_writes_have_no_hash(tmp_path: Path) -> None:
    generate(model("four_bar"), tmp_path / "out", ["c", "casadi"], hashes_only=True)
    assert names(tmp_path / "out") == KEPT | {"four_bar.h"}
    hashed = set(read_hashes(tmp_path / "out"))
    assert "four_bar_loops.c" in hashed and not [name for name in hashed if name.endswith(".casadi")]


def test_check_regenerates_and_compares_hashes_and_numbers(folder: Path) -> None:
    lines = check(folder).lines
    assert not failures(folder)
    assert "out: ok: 6 of 6 files have the same bytes, 3 of them by hash" in lines
    assert any("NumPy module agrees with the evaluator" in line for line in lines)


@pytest.mark.parametrize("change", ["sha256", "bytes"])
def test_a_hash_that_differs_is_one_line_with_the_file_and_the_cure(folder: Path, change: str) -> None:
    table = json.loads((folder / "hashes.json").read_text())
    table["four_bar_numpy.py"][change] = {"sha256": "0" * 64, "bytes": 1}[change]
    (folder / "hashes.json").write_text(json.dumps(table))
    text = "four_bar_numpy.py differs from what is generated today by its hash in hashes.json; generate again"
    assert failures(folder) == [f"out: FAILED: {text}"]


def test_files_that_are_not_in_the_table_or_no_longer_generated_are_found(folder: Path) -> None:
    table = json.loads((folder / "hashes.json").read_text())
    table["four_bar.f90"] = table.pop("README.md")
    (folder / "hashes.json").write_text(json.dumps(table))
    missing, old = failures(folder)
    assert missing.endswith("README.md is missing; generate again")
    assert old.endswith("four_bar.f90 is in hashes.json, but is not generated today; generate again")


@pytest.mark.parametrize("content", ["[]", "{}", '{"a.c": 1}', '{"a.c": {"sha256": "12", "bytes": 3}}', "{"])
def test_a_table_that_is_none_is_refused(folder: Path, content: str) -> None:
    (folder / "hashes.json").write_text(content)
    for read in (check, symscrew.load):
        with pytest.raises(OutputError, match=r"hashes\.json: .*generate"):
            read(folder)


def test_loading_it_is_one_clear_error(folder: Path) -> None:
    with pytest.raises(OutputError, match=r"holds hashes in place of its code \(hashes.json\); generate it without"):
        symscrew.load(folder)


def test_from_hashes_to_files_and_back(folder: Path) -> None:
    generate(model("four_bar"), folder, ["numpy"])
    assert names(folder) == LEFT | KEPT - {"hashes.json"}
    generate(model("four_bar"), folder, ["numpy"], hashes_only=True)
    assert names(folder) == KEPT


def test_a_file_of_the_user_by_a_hashed_name_stays(folder: Path) -> None:
    (folder / "four_bar_numpy.py").write_text("mine")
    with pytest.raises(OutputError, match=r"four_bar_numpy\.py was not written by this tool"):
        generate(model("four_bar"), folder, ["numpy"])
    generate(model("four_bar"), folder, ["numpy"], hashes_only=True)
    assert (folder / "four_bar_numpy.py").read_text() == "mine"


def test_a_table_of_the_user_is_not_taken_for_ours(tmp_path: Path) -> None:
    generate(model("four_bar"), tmp_path, ["numpy"])
    (tmp_path / "hashes.json").write_text("mine")
    with pytest.raises(OutputError, match="hashes"):
        generate(model("four_bar"), tmp_path, ["numpy"], hashes_only=True)
    assert (tmp_path / "hashes.json").read_text() == "mine" and (tmp_path / "README.md").is_file()


def test_from_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = str(tmp_path / "out")
    assert main(["generate", "four_bar", "--target", "numpy", "--hashes-only", "--out", out]) == 0
    assert names(tmp_path / "out") == KEPT
    assert main(["check", out]) == 0
    assert "3 of them by hash" in capsys.readouterr().out


def test_the_repository_holds_two_mechanisms_whole_and_hashes_of_the_others() -> None:
    whole = {"four_bar", "three_ups_upu_s"}
    found = {path.parent.name for path in GENERATED.glob("*/manifest.json")}
    assert found >= {*whole, "delta", "stewart_6ups", "three_ups_upu_s_physical", "ur5"}
    for name in found:
        hashed = read_hashes(GENERATED / name)
        assert (GENERATED / name / f"{name}.h").is_file()
        assert bool(hashed) == (name not in whole)
        support = f"{name}_support.c"
        assert (support in hashed) != (GENERATED / name / support).is_file()
