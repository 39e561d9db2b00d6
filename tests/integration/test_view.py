"""The page of `symscrew view` and the JavaScript it is made of: data, functions, screws, motions, bad files."""

from __future__ import annotations

import base64
import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.model_states import model
from support.recorded_motion import recorded
from support.samples import some_quickly

from symscrew.cli.parser import main
from symscrew.description import MechanismBuilder, toml_file
from symscrew.display import film, show_page
from symscrew.display.view import page_data
from symscrew.display.view.motion_file import read_motion
from symscrew.display.view.page import make_page
from symscrew.display.view.page_data import MAX_FRAMES, page_scene
from symscrew.display.view.reaches import joint_limits
from symscrew.display.view.run_time_shape import with_outline
from symscrew.effects import effect_from_table
from symscrew.errors import DescriptionError
from symscrew.export.javascript import print_javascript
from symscrew.export.listing import live_instructions
from symscrew.kinematics import coordinate_units
from symscrew.model import derive
from symscrew.program.straight_line import Iteration
from symscrew.studies.workspace import start_margins

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


def test_margins_have_the_scale_of_maps_and_reports() -> None:
    """Parts of the volumes in the reference configuration, which are those that maps divide by."""
    found = model("three_ups_upu_s")
    known = start_margins(found, lambda name, *arrays: found(name, *arrays))
    page = {m["name"]: m["start"] for m in page_scene(found)["margins"]}
    assert page.keys() == {"limb1", "limb2", "limb3", "limb4", "limb5", "constraint", "actuation"}
    for name, value in known.items():
        kind, _, of = name.partition(" ")
        assert page[of if kind == "limb" else kind] == value != 0


@pytest.mark.parametrize("name", NAMES)
def test_coordinates_are_shown_as_they_are_typed(name: str) -> None:
    found = model(name)
    data, known = page_scene(found), coordinate_units(found.mechanism)
    for entry in data["independent"]:
        assert known[entry["name"]] == ("m" if entry["kind"] == "length" else "rad")
    panel = Path(page_data.__file__).parent / "page"
    assert not any(
        "_" in found for file in panel.glob("*.js") for found in re.findall(r"\.replace\w*\([^)]*\)", file.read_text())
    )


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
        got = np.frombuffer(base64.b64decode(motion["arrays"][name]), "<f8").reshape(41, -1)
        assert (got == arrays[name].reshape(41, -1)).all()  # the very numbers of the file
    assert [p.name for p in (tmp_path / "new").iterdir()] == ["run.html"]
    capsys.readouterr()


def test_a_long_motion_keeps_its_ends_and_every_peak(tmp_path: Path) -> None:
    """A blow between two even times is in the page; all states are, where they are asked for."""
    arrays = recorded(3)
    count = 5 * MAX_FRAMES
    for name in ("q", "v", "u"):
        arrays[name] = np.repeat(arrays[name][:1], count, axis=0)
    arrays["u"][4321, 2], arrays["v"][1234, 5] = -777.0, 55.0
    np.savez(tmp_path / "run.npz", **{**arrays, "t": np.linspace(0.0, 9.0, count)})
    read = read_motion(tmp_path / "run.npz")
    for frames, least, most in ((None, MAX_FRAMES - 8, MAX_FRAMES), (50, 42, 58), (count, count, count)):
        motion = page_scene(model("three_ups_upu_s"), replace(read, frames=frames))["motion"]
        t, u, v = (np.frombuffer(base64.b64decode(motion["arrays"][name]), "<f8") for name in ("t", "u", "v"))
        assert least <= len(t) == motion["frames"] <= most and motion["recorded"] == count
        assert (t[0], t[-1]) == (0.0, 9.0) and np.diff(t).max() < 3 * 9.0 / least
        assert u.min() == -777.0 and v.max() == 55.0 and read.t[4321] in t


@pytest.mark.parametrize(
    ("frames", "said"), [("1", "at least 2, or all"), ("x", "at least 2, or all"), ("9", "RUN.npz")]
)
def test_states_that_a_page_cannot_hold(
    frames: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    np.savez(tmp_path / "run.npz", **recorded(3))
    given = "four_bar" if frames == "9" else str(tmp_path / "run.npz")
    assert main(["view", given, "--out", str(tmp_path / "a.html"), "--frames", frames]) == 2
    assert said in capsys.readouterr().err and not (tmp_path / "a.html").exists()


BAD_MOTIONS = {
    "no_q": ({"q": None}, "missing: q"),
    "no_mechanism": ({"mechanism": None}, "missing: mechanism"),
    "objects": ({"mechanism": np.array({"a": 1}, dtype=object)}, "must hold real numbers or texts, got 'object'"),
    "unknown": ({"mechanism": np.array("[mechanism]\nname = 1")}, "name"),
    "backwards": ({"t": np.linspace(2.0, 0.0, 41)}, "increasing times"),
    "rows": ({"v": np.zeros((40, 15))}, "`v` must hold numbers, 41 x any"),
    "nan": ({"q": np.full((41, 16), np.nan)}, "not finite"),
    "texts": ({"u": np.full((41, 4), "x")}, "`u` must hold numbers"),
    "columns": ({"u": np.zeros((41, 3)), "u_labels": np.array(list("abc"))}, "needs 4"),
    "labels": ({"q_labels": np.array([f"q{k}" for k in range(16)])}, "record the motion again"),
    "other": ({"mechanism": np.array("ur5")}, "record the motion again"),
}


@pytest.mark.parametrize("case", some_quickly(BAD_MOTIONS, every=3))
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


# -- limits, run-time parameters, films ----------------------------------------------------------------


def test_limits_are_those_of_end_stops_and_those_given() -> None:
    stop = {"type": "end_stop", "joint": "A", "upper": "pi/4", "stiffness": 1e3, "exponent": 1}
    found = derive(model("four_bar").mechanism, [effect_from_table(stop)])
    (row,) = joint_limits(found, {})
    assert (row["label"], row["low"], row["start"]) == ("A", None, 0.0) and row["high"] == pytest.approx(np.pi / 4)
    rows = {row["label"]: row for row in joint_limits(found, {"B": (-1.0, 1.0), "A": (0.0, 0.5)})}
    assert (rows["A"]["low"], rows["A"]["high"], rows["B"]["low"]) == (0.0, 0.5, -1.0)
    displaced = found.programs["joint_displacements"].outputs[0].labels
    assert all(displaced[row["at"]] == label for label, row in rows.items())


def test_limits_in_python_are_in_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("webbrowser.open", lambda place: True)
    (row,) = data_of(show_page(model("four_bar"), limits={"A": (-0.5, None)}).text)["limits"]
    assert (row["label"], row["low"], row["high"]) == ("A", -0.5, None)


@pytest.mark.parametrize(("limits", "text"), [({"A": (1.0, 1.0)}, "lower < upper"), ({"a": (0.0, 1.0)}, "no joint")])
def test_limits_that_are_none(limits: dict[str, tuple[float, float]], text: str) -> None:
    with pytest.raises(DescriptionError, match=text):
        joint_limits(model("four_bar"), limits)


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--limit", "A=1"], "JOINT=LOW:HIGH"),
        (["--limit", "A=:"], "JOINT=LOW:HIGH"),
        (["--limit", "A=0mm:3mm"], "an angle"),
        (["--limit", "AA=0:1"], "no joint"),
        (["--gif", "a.png"], "ends in .gif"),
        (["--run-time", "nothing"], "nothing"),
    ],
)
def test_bad_options_of_view(words: list[str], text: str, tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["view", "four_bar", "--out", "a.html", *words]) == 2
    assert text in capsys.readouterr().err and not list(tmp_path.iterdir())


def test_a_shape_follows_its_parameters() -> None:
    text = PENDULUM.format(text='"a rod"').replace('"-1/4"', '"-l/2"').replace("at = [0, 0, -1]", 'at = [0, 0, "-l"]')
    head = '[parameters]\nl = { value = 1, unit = "m", run_time = true }\n'
    found = with_outline(derive(toml_file.parse_description(text.replace("[bodies.rod]", f"{head}[bodies.rod]"))))
    data = page_scene(found)
    assert data["tunable"] == [{"name": "l", "value": 1.0, "unit": "m", "description": "", "low": 0.5, "high": 1.5}]
    for length in (1.0, 1.4):
        points = found("outline", np.array([length]))[0][0].reshape(-1, 3)
        rod = next(body for body in data["bodies"] if body["name"] == "rod")
        assert sorted(points[k][2] for k in rod["outline"]["bar"]) == pytest.approx([-length, 0])
        assert points[rod["outline"]["com"]][2] == pytest.approx(-length / 2)
        assert points[data["points"][0]["outline"]][2] == pytest.approx(-length)


def test_a_film_shows_the_motion(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("PIL")
    from PIL import Image

    monkeypatch.setattr(film, "RATE", 2)
    place = film.write_film(model("four_bar"), tmp_path / "four_bar.gif")
    with Image.open(place) as made:
        assert made.n_frames == 2 * film.SWEEP and made.info["duration"] == 500
        first = np.asarray(made.convert("RGB")).astype(int)
        made.seek(2)
        assert (np.abs(np.asarray(made.convert("RGB")) - first).max(axis=2) > 60).sum() > 500
    _, q = film.sweep(model("four_bar"))
    assert np.abs(model("four_bar")("closure", q)[0][0]).max() < 1e-9 and np.ptp(q[:, 0]) > 0.1
    with pytest.raises(DescriptionError, match=r"ends in \.gif"):
        film.write_film(model("four_bar"), tmp_path / "a.avi")
    monkeypatch.setattr("shutil.which", lambda name: None)
    with pytest.raises(DescriptionError, match="apt install ffmpeg"):
        film.write_film(model("four_bar"), tmp_path / "a.mp4")


# -- JavaScript --------------------------------------------------------------------------------------------


def test_javascript_has_every_function_and_instruction() -> None:
    found = model("four_bar")
    (name, text), *rest = print_javascript(found).items()
    assert name == "four_bar.js" and not rest and text == print_javascript(found)["four_bar.js"]
    for function, program in found.programs.items():
        start = text.index(f"function {function}{'_step' * isinstance(program, Iteration)}(...given)")
        body = text[start : text.index("return finish(", start)]
        straight = program.step if isinstance(program, Iteration) else program
        live, _ = live_instructions(straight)
        statements = re.findall(r"^    const (?!guard|total|status).*?;", body, re.MULTILINE | re.DOTALL)
        code = re.sub(r"\s+", " ", "".join(statements))
        for constant in re.findall(r"^    (\w+) = [-\d.e]+[,;]", text, re.MULTILINE):
            code = re.sub(rf"\(-{constant}\b", "(0", code)  # the negative of a number is none
        assert len(re.findall(r"(?<= )[-+*/?](?= )|Math\.|(?<=[(= ])-(?=[A-Za-z(])", code)) == len(live)


def test_a_word_of_javascript_is_no_constant() -> None:
    made = derive(toml_file.parse_description(PENDULUM.format(text='"a rod"')))
    assert "const window_ = (" in print_javascript(made)["window.js"]


# -- screws in the page ------------------------------------------------------------------------------------


def test_a_page_is_made_once_and_again_where_anything_differs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second time nothing is derived; other gravity, other coordinates and a motion ask for another page."""
    monkeypatch.setenv("SYMSCREW_CACHE", str(tmp_path / "cache"))
    made: list[str] = []

    def counted(mechanism: Any, *more: Any, **ways: Any) -> Any:
        made.append(mechanism.name)
        return derive(mechanism, *more, **ways)

    monkeypatch.setattr("symscrew.model.derive", counted)

    def page(*options: str) -> bytes:
        out = tmp_path / "page.html"
        assert main(["view", "four_bar", "--out", str(out), *options]) == 0
        return out.read_bytes()

    first = page()
    assert page() == first and len(made) == 1
    assert page("--gravity", "1", "0", "0") != first and len(made) == 2
    assert page("--independent", "B") != first and len(made) == 3
    assert page("--limit", "A=0:1") != first and len(made) == 4
    assert page() == first and len(made) == 4


def test_a_chooser_of_all_modes_has_configurations_that_close_the_loops(tmp_path: Path) -> None:
    assert main(["view", "four_bar", "--modes", "--out", str(tmp_path / "modes.html")]) == 0
    data = data_of((tmp_path / "modes.html").read_text())
    assert [mode["name"] for mode in data["modes"]] == ["home", "-1"]
    for mode in data["modes"]:
        (opening,), _ = model("four_bar")("closure", np.array(mode["q"]))
        assert np.abs(opening).max() < 1e-12
    home, other = (np.array(mode["q"]) for mode in data["modes"])
    assert np.array_equal(home, data["reference"]) and np.abs(home - other).max() > 0.1
    assert page_scene(model("four_bar"))["modes"] == []


def test_a_run_under_effects_that_keep_another_joint_is_shown(tmp_path: Path) -> None:
    """A rotor in the joint that is cut without it: the run's coordinates are those of its own tree."""
    scene = tmp_path / "fall.toml"
    scene.write_text(
        '[scene]\nmechanism = "four_bar"\nduration = 0.02\nrate = 100\n[[effects]]\ntype = "gravity"\n'
        '[[effects]]\ntype = "rotor_inertia"\njoint = "C"\ninertia = 0.01\n'
    )
    run, page = tmp_path / "fall.npz", tmp_path / "page.html"
    assert main(["simulate", str(scene), "--out", str(run)]) == 0
    assert "C" in read_motion(run).q_labels
    assert main(["view", str(run), "--out", str(page)]) == 0 and '"C"' in page.read_text()


def test_sliders_of_a_free_body_say_their_axes() -> None:
    """Of a free joint that was described, too, as of the one on which a platform hangs."""
    builder = MechanismBuilder("flyer").body("trunk", mass=1, com=[0, 0, 1], inertia=[1, 1, 1])
    builder.body("foot", mass=1, com=[0, 0, "1/2"], inertia=[1, 1, 1])
    builder.joint("flight", "free", parent="base", child="trunk", point=[0, 0, 1])
    builder.joint("leg", "P", parent="trunk", child="foot", point=[0, 0, 1], axes=[[0, 0, 1]], driven=True)
    sliders = page_scene(derive(builder.build()))["independent"]
    assert [entry["axis"] for entry in sliders] == ["x", "y", "z", "x", "y", "z", None]
