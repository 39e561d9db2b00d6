"""The table of targets: a further one is a file and a line, and everybody who walks the table has it."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest
from support.model_states import model

from symscrew.cli.parser import main
from symscrew.export import OutputError
from symscrew.generation import TARGETS, USUAL, generate, printable, render, with_brought
from symscrew.generation.targets import Target
from symscrew.verification import check

COUNTS = '''
"""Target "counts": operations of every function, as a table."""

import csv
import io


def files(order):
    """<name>_counts.csv."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\\n")
    rows.writerow(("function", "operations"))
    rows.writerows((name, p.operations["total"]) for name, p in order.model.programs.items())
    return {f"{order.model.name}_counts.csv": text.getvalue()}


def section(order):
    """How to read it."""
    return ["### Counts", "", f"`column -s, -t {order.model.name}_counts.csv`"]


def compare(case):
    """The sum of the column is that of the programs."""
    rows = (case.fresh / f"{case.model.name}_counts.csv").read_text().splitlines()[1:]
    found = sum(int(row.split(",")[1]) for row in rows)
    yield found == sum(p.operations["total"] for p in case.model.programs.values()), f"{found} operations in the table"
'''


@pytest.fixture
def counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The target "counts": one file, one line."""
    place = tmp_path / "modules"
    place.mkdir()
    (place / "counts_target.py").write_text(COUNTS)
    monkeypatch.syspath_prepend(str(place))
    monkeypatch.delitem(sys.modules, "counts_target", raising=False)
    monkeypatch.setitem(TARGETS, "counts", Target("counts_target", "`{0}_counts.csv`: operations"))


def test_a_further_target_is_written_listed_and_checked(counts: None, tmp_path: Path) -> None:
    written = generate(model("four_bar"), tmp_path / "out", ["counts"])
    assert tmp_path / "out/four_bar_counts.csv" in written
    text = (tmp_path / "out/four_bar_counts.csv").read_text()
    assert f"inverse_dynamics,{model('four_bar').programs['inverse_dynamics'].operations['total']}\n" in text
    manifest = json.loads((tmp_path / "out/manifest.json").read_text())
    assert manifest["targets"] == ["counts"] and "four_bar_counts.csv" in manifest["files"]
    readme = (tmp_path / "out/README.md").read_text()
    assert "- `four_bar_counts.csv`: operations" in readme and "### Counts" in readme
    total = sum(p.operations["total"] for p in model("four_bar").programs.values())
    found = check(tmp_path / "out")
    assert found.ok and f"four_bar: ok: {total} operations in the table".replace("four_bar", "out") in found.lines


def test_a_further_target_whose_numbers_are_off_fails(counts: None, tmp_path: Path) -> None:
    changed = tmp_path / "modules/counts_target.py"
    changed.write_text(COUNTS.replace("int(row", "2 * int(row"))
    generate(model("four_bar"), tmp_path / "out", ["counts"])
    failed = [line for line in check(tmp_path / "out").lines if "FAILED" in line]
    assert len(failed) == 1 and "operations in the table" in failed[0]


def test_the_command_line_knows_a_further_target(
    counts: None, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = str(tmp_path / "out")
    assert main(["generate", "four_bar", "--target", "counts", "--functions", "body_poses", "--out", place]) == 0
    assert (tmp_path / "out/four_bar_counts.csv").read_text().splitlines()[1].startswith("body_poses,")
    assert "write counts to" in capsys.readouterr().err


@pytest.mark.parametrize("name", list(TARGETS))
def test_every_target_has_its_file(name: str) -> None:
    module = import_module(TARGETS[name].module)
    assert callable(module.files) and name in (module.__doc__ or "")
    assert set(TARGETS[name].brings) <= set(TARGETS) and "double" in TARGETS[name].precisions


def test_what_the_table_says_of_precisions_and_of_targets_that_come_along() -> None:
    assert printable("single") == ("c", "rust", "cuda", "markdown") and printable("double") == tuple(TARGETS)
    assert with_brought(["external"]) == ("c", "external")
    assert with_brought(["numpy", "c", "numpy"]) == ("c", "numpy")
    assert set(USUAL) <= set(TARGETS)
    with pytest.raises(ValueError, match=r"expected targets among c, casadi, .*, got 'fortran'"):
        render(model("four_bar"), ["fortran"])
    with pytest.raises(
        ValueError, match="expected targets among c, rust, cuda, markdown in single precision, got 'numpy'"
    ):
        render(model("four_bar"), ["c", "numpy"], precision="single")


def test_the_command_line_starts_without_what_makes_the_files() -> None:
    code = (
        "import sys, symscrew.cli.parser, symscrew.cli.generate_command; "
        "print(*(m for m in sys.modules if m.split('.')[0] in ('symscrew', 'numpy', 'sympy', 'casadi')))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = done.stdout.split()
    assert "symscrew.generation.targets" in loaded
    assert not [m for m in loaded if m.startswith(("numpy", "sympy", "casadi", "symscrew.export", "symscrew.fmu"))]
    assert not [m for m in loaded if m.endswith(("_target", "target_file", "value_comparison"))]


@pytest.mark.parametrize(("targets", "named"), [
    (("ros2", "c"), "targets c and ros2"), (("simulink", "ros2"), r"targets c \(brought by simulink\) and ros2"),
])  # fmt: skip
def test_targets_that_no_folder_holds_are_told_before_deriving(
    targets: tuple[str, ...],
    named: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr("symscrew.model.derive", lambda *_, **__: pytest.fail("derived for nothing"))
    assert main(["generate", "four_bar", "--out", str(tmp_path / "out"), "--no-cache", "--target", *targets]) == 2
    said = capsys.readouterr().err
    assert re.search(f"{named} both write CMakeLists.txt; use a directory for each", said), said
    assert not (tmp_path / "out").exists()
    with pytest.raises(OutputError, match=named):
        render(model("four_bar"), targets)
