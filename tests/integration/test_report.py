"""`symscrew report`: one self-contained document whose numbers are those of the model, in HTML and Markdown."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from support.model_states import model as derived

from symscrew.cli.parser import main
from symscrew.reporting.blocks import Document, Picture, Section, Table, Text, page, write_document
from symscrew.reporting.sections import _unit_screws, document
from symscrew.studies.given_motion import drives
from symscrew.studies.timing import Times
from symscrew.studies.workspace import workspace

PLATFORM = "planar_3rrr"  # of what is written of a spatial one the tutorial makes a report
VOID = {"meta", "br", "img", "mspace", "link", "input", "path", "use", "rect", "circle", "line", "mprescripts"}


class Reader(HTMLParser):
    """Elements that are balanced, tables by caption, sources of pictures."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.sources: list[str] = []
        self.ids: set[str] = set()
        self.links: list[str] = []

    def handle_starttag(self, tag: str, attributes) -> None:
        given = dict(attributes)
        self.sources += [given[k] for k in ("src", "xlink:href") if k in given]
        if "id" in given:
            self.ids.add(given["id"])
        if tag == "a":
            self.links.append(given["href"])
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag not in VOID:
            assert self.open.pop() == tag


def read(text: str) -> Reader:
    reader = Reader()
    reader.feed(text)
    assert reader.open == []
    return reader


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("report") / "planar.html"
    model = derived(PLATFORM)
    write_document(document(model, times={"inverse_dynamics": Times(90.0, 100.0, 110.0, 130.0, 41)}), path)
    return path


@pytest.mark.slow
def test_page_asks_for_nothing_and_is_sound(report: Path) -> None:
    text = report.read_text()
    reader = read(text)
    assert all(s.startswith(("data:", "#")) for s in reader.sources)
    assert "http://" not in re.sub(
        r'xmlns(:\w+)?="[^"]*"|<metadata>.*?</metadata>|<!DOCTYPE[^>]*>', "", text, flags=re.S
    )
    assert "<script" not in text and "default-src 'none'" in text
    assert {link.removeprefix("#") for link in reader.links} <= reader.ids
    assert len(text) < 1_500_000 and "$" not in re.sub(r"<svg.*?</svg>|<style>.*?</style>", "", text, flags=re.S)


@pytest.mark.slow
def test_numbers_are_those_of_the_model(report: Path) -> None:
    text = report.read_text()
    model = derived(PLATFORM)
    for name, program in model.programs.items():
        row = re.search(rf"<tr><td>{name}\(.*?</tr>", text)
        assert row is not None and f">{program.operations['total']}" in row.group()
    assert "110 (100 … 130) ns" in text
    assert (
        "<td>finite mobility</td><td>3 (proved)</td>" in text
        and "<td>freedoms of platform</td><td>3 (1R2T)</td>" in text
    )
    margins, _ = model("limb_margins", model.system.reference[None, :])
    assert f"{float(margins[0][0, 0]):.5g}" in text


def test_markdown_has_its_pictures_beside_it(tmp_path: Path) -> None:
    files = write_document(document(derived("four_bar")), tmp_path / "four_bar.md")
    text = (tmp_path / "four_bar.md").read_text()
    names = re.findall(r"!\[.*?\]\((.*?)\)", text)
    assert names and all((tmp_path / name).stat().st_size > 1000 for name in names)
    assert sorted(p.name for p in files) == sorted(p.name for p in tmp_path.iterdir())
    for table in re.findall(r"(?:^\|.*\n)+", text, re.M):
        assert len({len(re.findall(r"(?<!\\)\|", line)) for line in table.splitlines()}) == 1


@pytest.mark.parametrize("name", ["three_ups_upu_s", "planar_3rrr", "ur5", "bennett"])
def test_unit_screws_are_those_of_the_model(name: str) -> None:
    model = derived(name)
    mechanism = model.mechanism
    found = model("joint_screws", model.system.reference[None, :])[0][0].reshape(-1, 6)
    shown = [s for joint in mechanism.joints.values() for s in _unit_screws(joint)]
    labels = model.programs["joint_screws"].outputs[0].labels[::6]
    order = [f"{n}" for n in mechanism.joints]
    assert sorted(dict.fromkeys(label.split(".")[0] for label in labels)) == sorted(order)
    by_joint = {n: [found[k] for k, label in enumerate(labels) if label.split(".")[0] == n] for n in order}
    expected = np.array([s for n in order for s in by_joint[n]])
    got = np.array([[float(mechanism.number(c)) for c in s] for s in shown])
    assert got == pytest.approx(expected, abs=1e-12)


def test_text_is_escaped() -> None:
    section = Section("A <b>", (Text("<script>alert(1)</script>"), Table(("<i>",), (("a & b",),))))
    text = page(Document("<x>", "&", (section,)))
    read(text)
    assert "<script" not in text and "&lt;x&gt;" in text and "a &amp; b" in text


def test_picture_in_a_page_is_data() -> None:
    text = page(Document("t", "", (Section("s", (Picture("p", b"\x89PNG", "c", ".png"),)),)))
    assert 'src="data:image/png;base64,iVBORw=="' in text


@pytest.mark.slow
def test_studies_are_included(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    point = {"curve": "C99", "setting": "double", "error": 1.25e-15, "failure": "",
             "cost": {"lower": 1e-7, "median": 1.2e-7, "upper": 1.5e-7, "repeats": 9}, "facts": {}}  # fmt: skip
    study = {"name": "precision", "title": "Precision of inverse dynamics", "points": [point],
             "error_label": "relative",
             "cost_label": "time of a call", "cost_unit": "ns", "reference": "60 digits",
             "reference_error": 1e-50,
             "preparation": {}, "left_out": ["quad: no compiler"], "notes": [], "tables": {}}  # fmt: skip
    content = {"subject": "ur5", "machine": {"cpu": "x"}, "studies": [study]}
    (tmp_path / "accuracy.json").write_text(json.dumps(content))
    out = tmp_path / "r.md"
    arguments = ["report", "four_bar", "--out", str(out), "--no-timing", "--accuracy", str(tmp_path)]
    assert main(arguments) == 0
    text = out.read_text()
    assert "| C99 | double | 1.2e-15 | 120 (100 … 150) |" in text and "quad: no compiler" in text
    (tmp_path / "accuracy.json").write_text('{"studies": 3}')
    out.unlink()
    assert main(arguments) == 2
    assert "not a result of symscrew accuracy" in capsys.readouterr().err and not out.exists()


@pytest.mark.parametrize(
    "arguments, text",
    [
        (["--out", "a.pdf"], "ends in .html or .md"),
        (["--out", "nowhere/a.html"], "no folder"),
        (["--out", "a.html", "--accuracy", "nowhere"], "no accuracy.json"),
        (["--out", "a.html", "--scene", "nowhere.toml"], "nowhere.toml"),
    ],
)
def test_bad_input(arguments: list[str], text: str, tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["report", "four_bar", "--no-timing", *arguments]) == 2
    assert text in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_numbers_along_a_motion_and_of_the_workspace(tmp_path: Path) -> None:
    mechanism = derived("four_bar").mechanism
    motion = drives(mechanism, {"A": "0.3*sin(2*t)"}, duration=1.0, rate=50)
    sweep = workspace(mechanism, {"A": "-20deg:20deg:5"}, processes=1)
    made = document(derived("four_bar"), motion=motion, sweep=sweep)
    text = write_document(made, tmp_path / "r.md")[-1].read_text()
    assert f"| A | N m | {np.abs(motion.u[:, 0]).max():.4g} | {np.sqrt(np.mean(motion.u[:, 0] ** 2)):.4g} |" in text
    turned = motion.displacements[:, motion.labels["joint"].index("A")]
    assert f"| A | {turned.min():.4g} | {turned.max():.4g} | rad |" in text
    assert "5 cases over A in 5 steps" in text and (tmp_path / "r_workspace.png").stat().st_size > 5000
    assert (tmp_path / "r_motion_drives.png").stat().st_size > 5000


@pytest.mark.parametrize("words", [["--over", "A"], ["--motion", "A=t"], ["--motion", "B.q=t", "--duration", "1"]])
def test_a_motion_or_map_that_is_none(words: list[str], tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["report", "four_bar", "--no-timing", "--out", "a.html", *words]) == 2
    assert "error: " in capsys.readouterr().err and not list(tmp_path.iterdir())
