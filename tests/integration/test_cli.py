"""The command line: what it prints, what it writes, and that bad input ends in one line and exit code 2."""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from symscrew import catalogue
from symscrew.cli.drives_command import motion_of_options
from symscrew.cli.parser import main
from symscrew.functions import PRESETS, preset, selected

GOOD = """
[mechanism]
name = "pendulum"
[bodies.rod]
mass = 1
com = [0, 0, "-1/4"]
inertia = ["1/48", "1/48", 0]
[joints.pivot]
type = "R"
parent = "base"
child = "rod"
point = [0, 0, 0]
axes = [[0, 1, 0]]
driven = true
"""

BAD_FILES = {
    "not_toml": "[mechanism",
    "empty": "",
    "unknown_key": GOOD.replace("mass", "mas"),
    "unknown_section": GOOD + "\n[body.x]\nmass = 1\n",
    "negative_mass": GOOD.replace("mass = 1", "mass = -1"),
    "triangle": GOOD.replace('["1/48", "1/48", 0]', "[1, 1, 9]"),
    "zero_axis": GOOD.replace("[[0, 1, 0]]", "[[0, 0, 0]]"),
    "missing_body": GOOD.replace('child = "rod"', 'child = "stick"'),
    "python": GOOD.replace('"-1/4"', "\"__import__('os').system('touch hacked')\""),
    "lambda": GOOD.replace('"-1/4"', '"(lambda: 1)()"'),
    "attribute": GOOD.replace('"-1/4"', '"().__class__"'),
    "tower": GOOD.replace('"-1/4"', '"9^9^9^9"'),
    "nan": GOOD.replace("mass = 1", "mass = nan"),
    "quote_in_name": GOOD.replace('"pendulum"', '"pen\\"dulum"'),
    "newline_in_name": GOOD.replace('"pendulum"', '"pen\\ndulum"'),
    "path_in_name": GOOD.replace('"pendulum"', '"../pendulum"'),
    "keyword": GOOD.replace('"pendulum"', '"while"'),
    "circle": GOOD + '\n[parameters.a]\nvalue = "b"\n[parameters.b]\nvalue = "a"\n',
    "nesting": GOOD + "\nx = " + "[" * 100_000,
    "large": GOOD + "#" * 10_000_000,
    "disconnected": GOOD + "\n[bodies.island]\nmass = 1\ncom = [0, 0, 0]\n",
}


def run(*arguments: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    code = main(list(arguments))
    out, err = capsys.readouterr()
    return code, out, err


def assert_one_clear_line(code: int, out: str, err: str) -> None:
    errors = [line for line in err.splitlines() if " s " not in line[:12]]
    assert code == 2
    assert out == ""
    assert len(errors) == 1 and errors[0].startswith("symscrew: error: "), err
    assert "Traceback" not in err
    assert 20 < len(errors[0]) < 700


@pytest.mark.parametrize("name", BAD_FILES)
@pytest.mark.parametrize("command", ["generate", "mobility"])
def test_bad_file(name: str, command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad.toml").write_text(BAD_FILES[name])
    more = ["--out", "made"] if command == "generate" else []
    assert_one_clear_line(*run(command, "bad.toml", *more, capsys=capsys))
    assert sorted(os.listdir(tmp_path)) == ["bad.toml"]


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ([], "expected a command"),
        (["genrate"], "did you mean 'generate'?"),
        (["generate", "four_bar", "--ouput", "made"], "unknown option '--ouput'; did you mean '--out'? See symscrew"),
        (["generate", "four_bar"], "--out"),
        (["generate", "four_bra", "--out", "made"], "did you mean 'four_bar'"),
        (["generate", "nothing.toml", "--out", "made"], "there is no file"),
        (["generate", "four_bar", "--out", "made", "--target", "cobol"], "unknown 'cobol'"),
        (["generate", "four_bar", "--out", "made", "--gravity", "0", "0", "heavy"], "finite numbers"),
        (["generate", "four_bar", "--out", "made", "--gravity", "0", "0", "inf"], "finite numbers"),
        (["generate", "four_bar", "--out", "made", "--no-gravity", "--gravity", "0", "0", "1"], "not allowed with"),
        (["generate", "four_bar", "--out", "made", "--load", "E"], "no point 'E'"),
        (["generate", "four_bar", "--out", "made", "--independent", "X"], "expected labels of q"),
        (["generate", "four_bar", "--out", "taken"], "did not write"),
        (["generate", "four_bar", "--out", "taken/file"], "found a file"),
        (["check", "taken"], "generate first"),
        (["check", "nowhere"], "generate first"),
        (["mobility", "x\x1b[31my"], "neither a mechanism"),
        (["draw", "four_bar", "--out", "four_bar.gif"], "ends in .png or .pdf or .svg"),
        (["demo", "--out", "taken/file"], "taken/file"),
    ],
)
def test_bad_use(arguments: list[str], text: str, tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "taken").mkdir()
    (tmp_path / "taken" / "file").write_text("mine")
    code, out, err = run(*arguments, capsys=capsys)
    assert_one_clear_line(code, out, err)
    assert text in err
    assert "\x1b" not in err
    assert sorted(p.name for p in tmp_path.rglob("*")) == ["file", "taken"]


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="a place where nobody can write, root included")
@pytest.mark.parametrize("command", ["generate", "demo", "draw"])
def test_place_where_nothing_can_be_written(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    mechanism = [] if command == "demo" else ["four_bar"]
    place = "/proc/nowhere/made" + (".png" if command == "draw" else "")
    code, out, err = run(command, *mechanism, "--out", place, capsys=capsys)
    assert_one_clear_line(code, out, err)
    assert len(err.splitlines()) == 1 and "/proc" in err  # before anything is read or derived


@pytest.mark.slow
def test_list_names_the_whole_catalogue(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """Names are whole, as a table or as paragraphs."""
    code, out, _ = run("list", "--json", capsys=capsys)
    rows = {row["name"]: row for row in json.loads(out)}
    assert code == 0 and tuple(rows) == catalogue.names()
    assert (rows["three_ups_upu_s"]["joints"], rows["three_ups_upu_s"]["driven"]) == (13, 4)
    monkeypatch.setenv("COLUMNS", "80")
    _, table, _ = run("list", capsys=capsys)
    named = [line.split("|")[1].strip() for line in table.splitlines()[2:]]
    assert [name for name in named if name] == list(rows)
    monkeypatch.setenv("COLUMNS", "60")
    _, paragraphs, _ = run("list", capsys=capsys)
    assert [line for line in paragraphs.splitlines() if not line.startswith(" ")] == list(rows)


@pytest.mark.slow
def test_generate_then_check(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    description, made = tmp_path / "pendulum.toml", tmp_path / "made"
    description.write_text(GOOD)
    some = ["--target", "c", "numpy", "--functions", "momentum_screws", "inverse_dynamics"]
    code, out, err = run("generate", str(description), "--out", str(made), *some, capsys=capsys)
    assert code == 0 and "inverse_dynamics" in out and "derive pendulum" in err
    manifest = json.loads((made / "manifest.json").read_text())
    assert manifest["mechanism"] == "pendulum" and manifest["targets"] == ["c", "numpy"]
    assert not list(made.glob("*.casadi"))
    code, out, _ = run("check", str(made), "--json", capsys=capsys)
    assert code == 0 and json.loads(out)["ok"]
    other = tmp_path / "other"
    some = ["--target", "numpy", "--functions", "momentum_screws", "inverse_dynamics"]
    assert run("generate", str(description), "--out", str(other), *some, capsys=capsys)[0] == 0
    source = other / "pendulum_numpy.py"
    assert "0.25" in source.read_text()
    source.write_text(source.read_text().replace("0.25", "0.75"))
    manifest = json.loads((other / "manifest.json").read_text())
    (other / "manifest.json").write_text(json.dumps(manifest | {"selected": False}))
    code, out, _ = run("check", str(other), capsys=capsys)
    assert code == 1 and f"{source.name} differs from what is generated today" in out
    assert "operations of energy changed from None" in out  # which was not selected


@pytest.mark.slow
def test_functions_that_are_asked_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Only these are written, and a check knows them, the independent coordinates that were chosen and derivatives."""
    made = tmp_path / "made"
    wanted = ["linearisation", "velocity"]
    more = ["--independent", "D", "--derivatives", "--target", "numpy"]
    code, out, _ = run("generate", "four_bar", "--functions", *wanted, *more, "--out", str(made), capsys=capsys)
    assert code == 0 and out.startswith("four_bar: 2 functions, ")
    manifest = json.loads((made / "manifest.json").read_text())
    assert sorted(manifest["functions"]) == wanted and manifest["independent"] == ["D"]
    assert "\ndef velocity(" in (made / "four_bar_numpy.py").read_text()
    assert "\ndef acceleration(" not in (made / "four_bar_numpy.py").read_text()
    code, out, _ = run("check", str(made), capsys=capsys)
    assert code == 0, out


def test_a_function_that_does_not_exist(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = str(tmp_path / "made")
    code, out, err = run("generate", "four_bar", "--functions", "velocitty", "--out", made, capsys=capsys)
    assert_one_clear_line(code, out, err)
    assert "--functions: no 'velocitty' in four_bar; did you mean 'velocity'" in err
    assert not os.listdir(tmp_path)


@pytest.mark.parametrize("command", [
    ("generate", "nosuch", "--out", "made"), ("draw", "nosuch", "--out", "made/a.png"),
    ("assemble", "nosuch", "--picture", "made/a.png"), ("view", "nosuch", "--out", "made/a.html"),
    ("drives", "planar_3rrr", "--motion", "nosuch.csv", "--out", "made"), ("accuracy", "nosuch", "--out", "made"),
    ("convert", "nosuch", "--out", "made/a.toml"), ("report", "nosuch", "--out", "made/a.html"),
    ("formulas", "nosuch", "--out", "made/a.tex"), ("new", "x", "--limbs", "9-XXX", "--out", "made/a.toml"),
])  # fmt: skip
def test_no_folder_is_made_for_what_cannot_be_read(
    command: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert_one_clear_line(*run(*command, capsys=capsys))
    assert not os.listdir(tmp_path)


def test_functions_by_preset(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """They are named with their size, and can be had together with others; `all` is all, with nothing to choose."""
    more = ("--target", "numpy", "--out")
    code, out, _ = run("generate", "four_bar", *more, str(tmp_path / "every"), capsys=capsys)
    told = {name: int(n) for name, n in re.findall(r"--functions (\w+) \((\d+) functions, \d+ operations\)", out)}
    every = list(json.loads((tmp_path / "every" / "manifest.json").read_text())["functions"])
    assert code == 0 and told == {name: len(preset(name, every)) for name in PRESETS}
    assert {"assemble", "drive_rates", "inverse_dynamics", "mass_matrix"} <= set(preset("control", every))
    assert not re.search("dynamics|mass|momen|energy|reaction", " ".join(preset("kinematics", every)))
    assert preset("all", every) == tuple(every) == selected(["all", "energy"], every)
    some = ("--functions", "control", "energy", *more, str(tmp_path / "both"))
    code, out, _ = run("generate", "four_bar", *some, capsys=capsys)
    both = list(json.loads((tmp_path / "both" / "manifest.json").read_text())["functions"])
    assert code == 0 and both == [f for f in every if f in preset("control", every) or f == "energy"]
    assert "--functions" not in out
    code, _, err = run("generate", "four_bar", "--functions", "controll", "--out", str(tmp_path / "x"), capsys=capsys)
    assert code == 2 and "did you mean 'control'" in err


def test_effects_reach_the_functions(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run("generate", "four_bar", "--out", str(tmp_path / "a"), "--target", "numpy", "--no-gravity",
        "--load", "coupler_middle", capsys=capsys)  # fmt: skip
    manifest = json.loads((tmp_path / "a" / "manifest.json").read_text())
    assert [effect["type"] for effect in manifest["effects"]] == ["ExternalWrench"]
    assert [p["name"] for p in manifest["functions"]["inverse_dynamics"]["inputs"]] == [
        "q",
        "v",
        "a",
        "load_coupler_middle",
    ]


def test_draw_writes_a_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from matplotlib import image

    path = tmp_path / "delta.png"
    assert run("draw", "delta", "--out", str(path), capsys=capsys)[0] == 0
    assert image.imread(path)[..., :3].std() > 0.05


@pytest.mark.parametrize(
    ("suffix", "begins", "ends"), [(".pdf", b"%PDF-", b"%%EOF\n"), (".svg", b"<?xml", b"</svg>\n")]
)
def test_pictures_for_papers_have_the_same_bytes_again(suffix: str, begins: bytes, ends: bytes, tmp_path: Path) -> None:
    paths = [tmp_path / f"{k}{suffix}" for k in range(2)]
    for path in paths:
        assert main(["draw", "four_bar", "--out", str(path)]) == 0
    one, other = (path.read_bytes() for path in paths)
    assert one == other and one.startswith(begins) and one.endswith(ends) and len(one) > 5000


@pytest.mark.parametrize("command", ["simulate", "optimise"])
def test_a_mechanism_is_no_scene_and_no_problem(command: str, tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('[mechanism]\nname = "mine"\n')
    code, out, err = run(command, str(path), "--out", str(tmp_path / "out.npz"), capsys=capsys)
    assert_one_clear_line(code, out, err)
    assert "mine.toml: this file describes a mechanism; expected one with [" in err


@pytest.mark.parametrize(("command", "section", "words"), [
    (["mobility"], "scene", "describes a scene; expected a mechanism, with [mechanism]"),
    (["draw", "--out", "a.png"], "problem", "describes an optimal motion; expected a mechanism"),
    (["simulate"], "problem", "describes an optimal motion; expected one with [scene], which names a mechanism by"),
    (["optimise", "--out", "a.npz"], "motion", "describes a given motion; expected one with [problem]"),
])  # fmt: skip
def test_files_of_another_kind_are_called_what_they_are(
    command: list[str],
    section: str,
    words: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("mine.toml").write_text(f'[{section}]\nmechanism = "four_bar"\n')
    code, out, err = run(command[0], "mine.toml", *command[1:], capsys=capsys)
    assert_one_clear_line(code, out, err)
    assert words in err


def test_doctor_names_the_parts(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run("doctor", capsys=capsys)
    assert code == 0 and "sympy" in out and "valgrind" in out


def test_version_starts_fast_without_heavy_libraries() -> None:
    program = (
        "import sys, symscrew.cli.parser as c\ntry: c.main(['--version'])\nexcept SystemExit: pass\nprint(*sys.modules)"
    )
    shown = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert shown.startswith("symscrew ")
    assert not {"sympy", "casadi", "numpy", "matplotlib"} & set(shown.split())


def test_the_package_is_a_command_too() -> None:
    command = [sys.executable, "-m", "symscrew", "--version"]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.startswith("symscrew ")


@pytest.mark.slow
def test_output_into_a_closed_pipe_ends_quietly() -> None:
    command = f"set -o pipefail; {sys.executable} -m symscrew list | head -1"
    shown = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=True)
    assert shown.stderr == ""


@pytest.mark.parametrize("words", [
    ("simulate", "nowhere.toml", "--emit-cuda", ""), ("simulate", "nowhere.toml", "--emit-c="),
    ("generate", "four_bar", "--out", " "), ("mobility", ""),
])  # fmt: skip
def test_what_a_shell_makes_of_an_unset_variable_is_refused(
    words: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    assert_one_clear_line(*run(*words, capsys=capsys))
    assert main(list(words)) == 2 and "got an empty text" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    [
        ("generate", "four_bar", "--out", "{file}/x"), ("view", "four_bar", "--out", "{file}/x/y.html"),
        ("mobility", "four_bar", "--out", "{file}/x.md"), ("mobility", "four_bar", "--proof", "{file}/x.json"),
        ("convert", "four_bar", "--out", "{file}/x.toml"), ("draw", "four_bar", "--out", "{file}/x.png"),
        ("workspace", "four_bar", "--over", "A=0:1:2", "--out", "{file}/x"),
        ("simulate", "nowhere.toml", "--emit-c", "{file}/x"),
    ],
)  # fmt: skip
def test_places_to_write_to_are_looked_at_before_anything_is_derived(
    words: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file stands where a folder should be: said before the mechanism is read, which would fail here."""
    file = tmp_path / "taken"
    file.write_text("kept")
    monkeypatch.setattr(catalogue, "find", lambda *_, **__: pytest.fail("the mechanism was read"))
    assert main([word.format(file=file) for word in words]) == 2
    said = capsys.readouterr().err
    assert "taken" in said and ("expected a folder" in said or "no folder" in said)
    assert file.read_text() == "kept" and [p.name for p in tmp_path.iterdir()] == ["taken"]


@pytest.mark.parametrize(
    ("words", "read"),
    [
        (("drives", "four_bar", "--motion", "{there}/motion.csv", "--out", "{there}"), "motion.csv"),
        (
            ("simulate", "nowhere.toml", "--many", "{there}/starts.npz", "--out", "{there}/../b/starts.npz"),
            "starts.npz",
        ),
    ],
)
def test_what_is_read_is_not_written_over(
    words: tuple[str, ...], read: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A motion in the folder of the tables, starts that are also the runs: refused before the work."""
    there = tmp_path / "b"
    there.mkdir()
    (there / read).write_text("t,A\n0,0\n1,0.1\n2,0.15\n3,0.1\n")
    before = (there / read).read_bytes()
    assert main([word.format(there=there) for word in words]) == 2
    assert "is what is read" in capsys.readouterr().err
    assert (there / read).read_bytes() == before and [path.name for path in there.iterdir()] == [read]


def test_an_expression_may_be_longer_than_the_name_of_a_file() -> None:
    terms = "+".join(["t/200"] * 200)
    given = argparse.Namespace(motion=[f"A=0.2*sin({terms})"], duration=1.0, rate=None)
    wanted = motion_of_options(given, catalogue.load("four_bar"))
    assert wanted.t[-1] == 1.0
