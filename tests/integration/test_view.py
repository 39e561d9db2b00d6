"""The page of `symscrew view` and the JavaScript it is made of: data, functions, screws, motions, bad files."""

from __future__ import annotations

import base64
import json
import re
import shutil
import subprocess
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.model_states import model
from support.recorded_motion import recorded

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description import toml_file
from symscrew.display.view.motion_file import read_motion
from symscrew.display.view.page import make_page
from symscrew.display.view.page_data import MAX_FRAMES, page_scene
from symscrew.errors import DescriptionError
from symscrew.export.javascript import print_javascript
from symscrew.export.listing import live_instructions
from symscrew.model import derive
from symscrew.program.straight_line import Iteration

Array = np.ndarray
NAMES = ("three_ups_upu_s", "four_bar", "sarrus", "ur5")
HOSTILE = '</script><script>alert(1)</script><!-- <script> & "quotes" \''
PENDULUM = """
[mechanism]
name = "window"
description = {text}
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
[points.tip]
body = "rod"
at = [0, 0, -1]
"""


def data_of(page: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    assert found
    return json.loads(found.group(1))


@pytest.mark.parametrize("name", NAMES)
def test_page_is_one_file_that_asks_for_nothing(name: str) -> None:
    page = make_page(model(name))
    assert 600_000 < len(page.encode()) < 3_000_000
    assert "default-src 'none'" in page
    assert not re.search(r"<!-- insert \w+ -->", page)
    markup = re.sub(r"<script[^>]*>.*?</script>", "", page, flags=re.DOTALL)
    assert re.findall(r"""(?:src|href|url)\s*[=(]\s*["']?([^"')> ]+)""", markup) == ["data:,"]
    assert "Permission is hereby granted" in page  # the licences of what is bundled travel with it


@pytest.mark.parametrize("name", NAMES)
def test_data_names_what_the_functions_return(name: str) -> None:
    found = model(name)
    data = page_scene(found)
    screws = found.programs["joint_screws"].outputs[0].labels
    for joint in data["joints"]:
        for k in range(len(joint["kinds"])):
            assert screws[6 * (joint["screws"] + k)].startswith(joint["name"])
    assert [b["name"] for b in data["bodies"][1:]] == list(
        dict.fromkeys(label.split(".")[0] for label in found.programs["body_poses"].outputs[0].labels)
    )
    labels = [data["q_labels"][entry["q"]] for entry in data["independent"]]
    assert labels == list(next(p for p in found.programs["velocity"].inputs if p.name == "y_dot").labels)
    for entry in data["independent"]:
        assert (entry["quaternion"] is None) == (".q" not in entry["label"])
    assert [d["label"] for d in data["drives"]] == list(found.programs["inverse_dynamics"].outputs[0].labels)
    assert {m["function"] for m in data["margins"]} <= set(data["functions"])
    json.dumps(data, allow_nan=False)


@pytest.mark.parametrize("name", NAMES)
def test_outlines_meet_in_the_joints(name: str) -> None:
    data = page_scene(model(name))
    for joint in data["joints"]:
        for k in (joint["parent"], joint["child"]):
            body = data["bodies"][k]
            corners = [*body["plate"], *body["bar"], *(end for strut in body["struts"] for end in strut)]
            inside = body["plate"] and _in_plane(np.array(joint["point"]), np.array(body["plate"]))
            nearest = min(np.linalg.norm(np.subtract(c, joint["point"])) for c in corners)
            assert nearest < 1e-12 or inside, (joint["name"], body["name"])


def _in_plane(point: Array, corners: Array) -> bool:
    return np.linalg.matrix_rank(np.vstack([corners[1:] - corners[0], point - corners[0]]), tol=1e-9) == 2


def test_which_margins_are_squared_is_read_from_the_functions() -> None:
    squared = {m["name"]: m["squared"] for m in page_scene(model("three_ups_upu_s"))["margins"]}
    assert squared == {
        "limb1": False, "limb2": False, "limb3": False, "limb4": False, "limb5": False, "constraint": False,
        "actuation": True,
    }  # fmt: skip


def test_hostile_texts_stay_texts() -> None:
    harmless, hostile = (
        make_page(derive(toml_file.parse_description(PENDULUM.format(text=json.dumps(text)))))
        for text in ("a rod", HOSTILE)
    )
    assert _tags(hostile) == _tags(harmless)
    assert hostile.count("</script") == harmless.count("</script") and "<!-- <script>" not in hostile
    assert data_of(hostile)["description"] == HOSTILE


def _tags(page: str) -> list[str]:
    """Start tags of a page as a parser of HTML finds them."""
    parser, tags = HTMLParser(), []  # type: ignore[var-annotated]
    parser.handle_starttag = lambda tag, attributes: tags.append(tag)  # type: ignore[method-assign]
    parser.feed(page)
    return tags


# -- recorded motions -----------------------------------------------------------------------------------


@pytest.mark.slow
def test_motion_is_in_the_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arrays = recorded()
    np.savez(tmp_path / "run.npz", **arrays)
    assert main(["view", str(tmp_path / "run.npz"), "--out", str(tmp_path / "new" / "run.html")]) == 0
    motion = data_of((tmp_path / "new" / "run.html").read_text())["motion"]
    assert motion["frames"] == motion["recorded"] == 41
    for name in ("t", "q", "v", "u"):
        got = np.frombuffer(base64.b64decode(motion["arrays"][name]), "<f4").reshape(41, -1)
        assert np.abs(got - arrays[name].reshape(41, -1)).max() < 1e-6 * max(1.0, np.abs(arrays[name]).max())
    assert [p.name for p in (tmp_path / "new").iterdir()] == ["run.html"]
    capsys.readouterr()


def test_long_motion_is_thinned_with_both_ends(tmp_path: Path) -> None:
    arrays = recorded(3)
    count = 5 * MAX_FRAMES
    for name in ("q", "v", "u"):
        arrays[name] = np.repeat(arrays[name][:1], count, axis=0)
    np.savez(tmp_path / "run.npz", **{**arrays, "t": np.linspace(0.0, 9.0, count)})
    motion = page_scene(model("three_ups_upu_s"), read_motion(tmp_path / "run.npz"))["motion"]
    t = np.frombuffer(base64.b64decode(motion["arrays"]["t"]), "<f4")
    assert len(t) == motion["frames"] == MAX_FRAMES and motion["recorded"] == count
    assert (t[0], t[-1]) == (0.0, 9.0) and np.diff(t).max() < 1.5 * np.diff(t).min()


BAD_MOTIONS = {
    "no_q": ({"q": None}, "missing: q"),
    "no_mechanism": ({"mechanism": None}, "missing: mechanism"),
    "objects": ({"mechanism": np.array({"a": 1}, dtype=object)}, "expected an archive"),
    "unknown": ({"mechanism": np.array("[mechanism]\nname = 1")}, "name"),
    "backwards": ({"t": np.linspace(2.0, 0.0, 41)}, "increasing times"),
    "rows": ({"v": np.zeros((40, 15))}, "`v` must hold numbers, 41 x any"),
    "nan": ({"q": np.full((41, 16), np.nan)}, "not finite"),
    "texts": ({"u": np.full((41, 4), "x")}, "`u` must hold numbers"),
    "columns": ({"u": np.zeros((41, 3)), "u_labels": np.array(list("abc"))}, "needs 4"),
    "labels": ({"q_labels": np.array([f"q{k}" for k in range(16)])}, "record the motion again"),
    "other": ({"mechanism": np.array("ur5")}, "record the motion again"),
}


@pytest.mark.parametrize("case", BAD_MOTIONS)
def test_bad_motion_is_one_clear_error(case: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change, text = BAD_MOTIONS[case]
    arrays = {name: array for name, array in {**recorded(), **change}.items() if array is not None}
    np.savez(tmp_path / "run.npz", **arrays)
    assert main(["view", str(tmp_path / "run.npz"), "--out", str(tmp_path / "run.html")]) == 2
    err = capsys.readouterr().err.splitlines()
    assert err[-1].startswith("symscrew: error: ") and text in err[-1]
    assert not (tmp_path / "run.html").exists()


@pytest.mark.parametrize("content", [b"", b"not an archive", b"PK\x03\x04 cut off"])
def test_file_that_is_no_archive(content: bytes, tmp_path: Path) -> None:
    (tmp_path / "run.npz").write_bytes(content)
    with pytest.raises(DescriptionError, match="expected an archive"):
        read_motion(tmp_path / "run.npz")


def test_page_must_end_in_html(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["view", "four_bar", "--out", "four_bar.pdf"]) == 2
    assert "ends in .html" in capsys.readouterr().err and not list(tmp_path.iterdir())


def test_place_that_is_a_directory(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "four_bar.html").mkdir()
    assert main(["view", "four_bar", "--out", str(tmp_path / "four_bar.html")]) == 2
    assert "four_bar.html: Is a directory" in capsys.readouterr().err
    assert [p.name for p in tmp_path.rglob("*")] == ["four_bar.html"]


def test_without_out_the_page_is_opened(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch) -> None:
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    assert main(["view", "four_bar"]) == 0
    place = Path(capsys.readouterr().out.strip())
    assert opened == [place.as_uri()] and place.parent.parent == tmp_path and data_of(place.read_text())


# -- JavaScript --------------------------------------------------------------------------------------------


def test_javascript_has_every_function_and_instruction() -> None:
    found = model("four_bar")
    (name, text), *rest = print_javascript(found).items()
    assert name == "four_bar.js" and not rest and text == print_javascript(found)["four_bar.js"]
    for function, program in found.programs.items():
        start = text.index(f"function {function}{'_step' * isinstance(program, Iteration)}(...given)")
        body = text[start : text.index("return finish(", start)]
        straight = program.step if isinstance(program, Iteration) else program
        live, read = live_instructions(straight)
        loads = [slot for slot in read if slot < sum(p.size for p in straight.inputs)]
        assert body.count("  const $") == len(live) + len(loads)


def test_a_word_of_javascript_is_no_constant() -> None:
    made = derive(toml_file.parse_description(PENDULUM.format(text='"a rod"')))
    assert "const window_ = (" in print_javascript(made)["window.js"]


def node(tmp_path: Path, page: str | None, calls: list, **task: Any) -> list:
    program = shutil.which("node")
    if program is None:
        pytest.skip("needs node (Debian: nodejs)")
    (tmp_path / "task.json").write_text(json.dumps({"calls": calls, **task}))
    (tmp_path / "page.html").write_text(page or "")
    command = [program, str(Path(__file__).parents[1] / "support" / "view_check.cjs"), "page.html", "task.json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def numbers(values: Any) -> Array:
    return np.array([float(x) for x in np.ravel(np.array(values, dtype=object))])


@pytest.mark.tools
@pytest.mark.parametrize("name", catalogue.names())
def test_javascript_equals_the_evaluator(name: str, tmp_path: Path) -> None:
    found = model(name)
    ((file, text),) = print_javascript(found).items()
    (tmp_path / file).write_text(text)
    calls, expected = [], []
    for function in found.programs:
        inputs = found.test_inputs[function]
        results, status = found(function, *inputs)
        for k in range(len(status)):
            calls.append(["function", function, *(array[k].tolist() for array in inputs)])
            expected.append((function, [r[k] for r in results], int(status[k])))
    answers = node(tmp_path, None, calls, script=file, constant=name)
    for (function, results, status), answer in zip(expected, answers, strict=True):
        assert answer["status"] == status, function
        for port, result in zip(found.programs[function].outputs, results, strict=True):
            if status == 0:
                difference = np.abs(numbers(answer[port.name]) - result).max(initial=0.0)
                assert difference < 1e-12 * max(1.0, np.abs(result).max(initial=0.0)), (function, port.name)
            else:
                assert np.isnan(numbers(answer[port.name])).all()


@pytest.mark.tools
def test_javascript_reports_failures_like_the_evaluator(tmp_path: Path) -> None:
    found = model("four_bar")
    ((file, text),) = print_javascript(found).items()
    (tmp_path / file).write_text(text)
    guess = found.system.reference
    cases = [("assemble", [[float(y)], guess.tolist()]) for y in (0.3, 2.5, 40.0)]
    cases += [("assemble", [["nan"], guess.tolist()]), ("velocity", [["inf", 0.0, 0.0], [1.0]])]
    answers = node(tmp_path, None, [["function", f, *given] for f, given in cases], script=file, constant="four_bar")
    for (function, given), answer in zip(cases, answers, strict=True):
        (result, *_), status = found(function, *[np.array([float(x) for x in array]) for array in given])
        assert answer["status"] == int(status)
        got = numbers(answer["q" if function == "assemble" else "v"])
        assert np.allclose(got, result, rtol=0, atol=1e-11, equal_nan=True)
    assert {a["status"] for a in answers} >= {0, 2}


# -- screws in the page ------------------------------------------------------------------------------------


def pairing(wrench: Array, twist: Array) -> float:
    return float(wrench[:3] @ twist[3:] + wrench[3:] @ twist[:3])


@pytest.mark.tools
def test_reciprocal_and_principal_screws(tmp_path: Path) -> None:
    random = np.random.default_rng(3)
    page = make_page(model("four_bar"))
    systems = [random.normal(size=(n, 6)) for n in (1, 2, 3, 4, 5)]
    near = [0.3, -0.2, 0.5]
    calls: list = [["screws", "reciprocal", s.tolist(), 0.7] for s in systems]
    calls += [["screws", "principal", s.tolist(), near, 0.7] for s in systems[:3]]
    answers = node(tmp_path, page, calls)
    for system, found in zip(systems, answers[:5], strict=True):
        assert len(found) == 6 - len(system)
        assert np.linalg.matrix_rank(np.array(found)) == len(found)
        assert max(abs(pairing(np.array(w), twist)) for w in found for twist in system) < 1e-12
    for system, found in zip(systems[:3], answers[5:], strict=True):
        assert len(found) == len(system)
        lines = [_line(f) for f in found]
        assert np.linalg.matrix_rank(np.vstack([system, lines]), tol=1e-9) == len(system)
        for i, f in enumerate(found):
            assert abs(np.linalg.norm(f["direction"]) - 1) < 1e-12
            assert abs(np.dot(np.subtract(f["point"], near), f["direction"])) < 1e-9
            for g in found[:i]:
                assert abs(np.dot(f["direction"], g["direction"])) < 1e-9
        # Ball: the principal pitches are extreme over the system
        mixed = random.normal(size=(2000, len(system))) @ system
        pitch = (mixed[:, :3] * mixed[:, 3:]).sum(axis=1) / (mixed[:, :3] ** 2).sum(axis=1)
        pitches = [f["pitch"] for f in found]
        assert min(pitches) - 1e-9 <= pitch.min() and pitch.max() <= max(pitches) + 1e-9


def _line(found: dict) -> Array:
    direction, point = np.array(found["direction"]), np.array(found["point"])
    return np.concatenate([direction, np.cross(point, direction) + found["pitch"] * direction])


@pytest.mark.tools
def test_couples_and_coincident_forces_are_told_apart(tmp_path: Path) -> None:
    centre = np.array([0.2, 0.1, -0.4])
    ball = [[*d, *np.cross(centre, d)] for d in np.eye(3)]  # three rotations about a point
    planar = [[0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0]]
    mixed = np.array([[1.0, 2, 3], [0, 1, 1], [2, 0, 1]])
    calls = [["screws", "principal", (mixed @ np.array(s)).tolist(), [1.0, 1.0, 1.0], 1.0] for s in (ball, planar)]
    spherical, flat = node(tmp_path, make_page(model("four_bar")), calls)
    assert [f["pitch"] for f in spherical] == [0, 0, 0]
    for f in spherical:  # every axis meets the centre
        assert np.linalg.norm(np.cross(np.subtract(f["point"], centre), f["direction"])) < 1e-9
    assert sorted(str(f["pitch"]) for f in flat) == ["0", "Infinity", "Infinity"]
    assert np.allclose(next(f for f in flat if f["pitch"] == 0)["direction"], [0, 0, 1], atol=1e-12)


@pytest.mark.tools
@pytest.mark.parametrize(("name", "count"), [("three_ups_upu_s", 2), ("delta", 3), ("sarrus", 1), ("ur5", 6)])
def test_freedoms_of_the_platform_in_the_page(name: str, count: int, tmp_path: Path) -> None:
    found = model(name)
    q = found.test_inputs["body_poses"][0][2]
    (twists,) = node(tmp_path, make_page(found), [["model", "freedoms", q.tolist()]])
    (jacobian,), _ = found("platform_jacobian", q)
    (null,), _ = found("null_space", q)
    expected = jacobian.reshape(-1, 6).T @ null.reshape(-1, len(found.system.tree.v)).T
    assert np.linalg.matrix_rank(np.array(twists), tol=1e-9) == count
    assert np.linalg.matrix_rank(np.vstack([np.array(twists), expected.T]), tol=1e-7) == count


@pytest.mark.tools
def test_sliders_and_sweeps_stay_on_the_closure(tmp_path: Path) -> None:
    found = model("three_ups_upu_s")
    (ranges,) = node(tmp_path, make_page(found), [["model", "reach"]])
    assert all(low < -0.3 and high > 0.3 for low, high in ranges)
    calls: list = [
        ["model", "sweep", -1, ranges],
        ["model", "sweep", 1, ranges],
        ["model", "assemble", [0.2, -0.1], found.system.reference.tolist()],
    ]
    both, one, q = node(tmp_path, make_page(found), calls)
    half = np.array([0.2, -0.1]) * np.sin(np.hypot(0.2, 0.1) / 2) / np.hypot(0.2, 0.1)
    start = found.programs["assemble"].independent  # type: ignore[union-attr]
    assert np.allclose(np.array(q)[list(start)], half, atol=1e-12)  # a rotation vector's components on the sliders
    for motion in (both, one):
        q, v, a, u = (np.array([numbers(f[name]) for f in motion["frames"]]) for name in "qvau")
        (residual,), status = found("closure", q)
        assert not status.any() and np.abs(residual).max() < 1e-12
        (jacobian,), _ = found("closure_jacobian", q)
        rows = jacobian.reshape(len(q), v.shape[1], -1)
        assert np.abs(np.einsum("nkr,nk->nr", rows, v)).max() < 1e-9
        h = motion["t"][1] - motion["t"][0]
        slope = (8 * (v[3:-1] - v[1:-3]) - (v[4:] - v[:-4])) / (12 * h)
        assert np.abs(slope - a[2:-2]).max() < 5e-3 * np.abs(a).max()
        (drives,), _ = found("inverse_dynamics", q, v, a)
        assert np.abs(drives - u).max() < 1e-9 * np.abs(drives).max()
