"""What commands made before of the same input is there at once, and nothing else is taken for it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from symscrew import mobility
from symscrew import model as pipeline
from symscrew.cli import kept_outcomes, same_files
from symscrew.cli.kept_outcomes import once
from symscrew.cli.parser import main
from symscrew.cli.same_files import Outcome
from symscrew.optimisation import solution
from symscrew.runtime import cache_state

pytestmark = pytest.mark.slow

CRANE = """
[mechanism]
name = "crane"
platform = "load"
[parameters]
l = { value = "0.5", unit = "m" }
[bodies]
trolley = { mass = 4, com = [0, 0, 0] }
load = { mass = "2.5", com = [0, 0, "-l"] }
[joints]
rail = { type = "P", parent = "base", child = "trolley", point = [0, 0, 0], axes = [[1, 0, 0]], driven = true }
hook = { type = "R", parent = "trolley", child = "load", point = [0, 0, 0], axes = [[0, 1, 0]], driven = true }
"""
PROBLEM = """
[problem]
mechanism = "crane.toml"
duration = 1
[start]
coordinates = { rail = 0, hook = 0 }
at_rest = true
[end]
coordinates = { rail = GOAL, hook = 0 }
at_rest = true
[transcription]
intervals = 6
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder with a mechanism and a problem, and an empty cache."""
    monkeypatch.setenv("SYMSCREW_CACHE", str(tmp_path / "cache"))
    monkeypatch.delenv("SYMSCREW_NO_CACHE", raising=False)
    (tmp_path / "crane.toml").write_text(CRANE)
    (tmp_path / "move.toml").write_text(PROBLEM.replace("GOAL", "1"))
    yield tmp_path


def content(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_generated_again(folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """The same bytes and words without deriving; whatever changes derives."""
    derived: list[str] = []
    derive = pipeline.derive

    def counted(mechanism, *rest, **more):
        derived.append(mechanism.name)
        return derive(mechanism, *rest, **more)

    monkeypatch.setattr(pipeline, "derive", counted)

    def made(*more: str) -> tuple[int, dict[str, bytes], str]:
        """How often it was derived by now, what was written, what was said."""
        out = folder / f"made{len(list(folder.iterdir()))}"
        command = ["generate", str(folder / "crane.toml"), "--out", str(out), "--target", "numpy", *more]
        assert main(command) == 0
        return len(derived), content(out), capsys.readouterr().out.replace(str(out), "OUT")

    first, again = made(), made()
    assert first == again and first[0] == 1
    ways = [("--no-cache",), ("--no-gravity",), ("--gravity", "0", "0", "-1.62"), ("--functions", "control")]
    ways += [("--length", "2"), ("--checked",), ("--derivatives",)]
    counts = [made(*way)[0] for way in ways]
    assert counts == list(range(2, 2 + len(ways)))
    (folder / "crane.toml").write_text(CRANE.replace('"0.5"', '"0.6"'))
    count, changed, _ = made()
    assert count == 2 + len(ways) and b"0.6" in changed["mechanism.toml"] and changed != first[1]
    monkeypatch.setattr(kept_outcomes, "LIBRARIES", ("pytest",))  # another version of what it is computed with
    assert made()[0] == 3 + len(ways)


def test_a_motion_found_again(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its file and numbers are those of the first time, and it is said; another goal, rate or limit is solved."""
    solved: list[str] = []
    transcribe = solution.transcribe

    def counted(model):
        solved.append(model.problem.name)
        return transcribe(model)

    monkeypatch.setattr(solution, "transcribe", counted)

    def found(*more: str) -> tuple[bool, bytes, str, str]:
        """Whether it was solved, the file, what was said."""
        before, out = len(solved), folder / "move.npz"
        assert main(["optimise", str(folder / "move.toml"), "--out", str(out), *more]) == 0
        said = capsys.readouterr()
        return len(solved) > before, out.read_bytes(), said.out, said.err

    first, again = found("--json"), found("--json")
    assert first[0] and not again[0] and first[1:3] == again[1:3] and json.loads(again[2])["ok"]
    assert "earlier run" in again[3] and "earlier run" not in first[3]
    assert not found()[0], "the same in words"
    for way in (("--no-cache",), ("--rate", "50"), ("--time-limit", "100"), ("--time-limit", "100")):
        assert found(*way)[0], way
    (folder / "move.toml").write_text(PROBLEM.replace("GOAL", "0.5"))
    assert found()[0]
    with np.load(folder / "move.npz") as plan:
        assert plan["q"][-1][0] == pytest.approx(0.5)
    (folder / "crane.toml").write_text(CRANE.replace("mass = 4", "mass = 5"))
    assert found()[0]


def test_mobility_found_again(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same words, code and report without an analysis, after `new` as well; whatever changes is analysed."""
    analysed: list[str] = []
    analyse = mobility.analyse_mobility

    def counted(mechanism, *rest, **more):
        analysed.append(mechanism.name)
        return analyse(mechanism, *rest, **more)

    monkeypatch.setattr(mobility, "analyse_mobility", counted)

    def found(*more: str, code: int = 0) -> tuple[int, str, bytes]:
        """How often it was analysed by now, what was said and written."""
        assert main(["mobility", str(folder / "crane.toml"), "--out", str(folder / "said.md"), *more]) == code
        return len(analysed), capsys.readouterr().out, (folder / "said.md").read_bytes()

    first, again = found(), found()
    assert first == again and first[0] == 1 and "mobility 2" in first[1] and b"# " in first[2]
    assert found("--json")[0] == 2 and json.loads(found("--json")[1])["verified"]
    ways = [("--at", "hook=30deg"), ("--body", "trolley"), ("--proof", str(folder / "p.json"))]
    assert [found(*way)[0] for way in [*ways, ways[-1]]] == [3, 4, 5, 6], "a proof is judged each time"
    assert found("--expect", "3", code=1)[0] == found("--expect", "3", code=1)[0] == 7
    (folder / "crane.toml").write_text(CRANE.replace('"0.5"', '"0.6"'))
    assert found()[0] == 8

    for k in range(2):  # the warning names each file
        path = folder / f"arm{k}.toml"
        assert main(["new", "arm", "--limbs", "2-UPS", "--out", str(path)]) == 0
        said = capsys.readouterr()
        assert "mobility 6" in said.out and f"symscrew mobility {path} says why" in said.err
    assert len(analysed) == 9


def test_what_is_not_good_or_cannot_be_written_is_not_kept(folder: Path) -> None:
    made = [0]

    def make(*, good: bool) -> Outcome:
        made[0] += 1
        return Outcome({"count": made[0]}, {"file": b"\x00\xff"}, good=good)

    for _ in range(2):
        once("x", ("bad",), lambda: make(good=False))
        once("x", (object(),), lambda: make(good=True))
    assert made[0] == 4
    for _ in range(3):
        found = once("x", ("good",), lambda: make(good=True))
    assert made[0] == 5 and found.earlier and found.files == {"file": b"\x00\xff"} and found.facts == {"count": 5}
    assert once("y", ("good",), lambda: make(good=True)).facts == {"count": 6}, "another command"
    for entry in (folder / "cache").iterdir():  # spoiled on the disk: made anew
        if not entry.name.startswith("lock"):
            entry.write_bytes(entry.read_bytes()[:-3] + b"}}}")
    assert once("x", ("good",), lambda: make(good=True)).facts == {"count": 7} and cache_state().entries == 2


@pytest.mark.parametrize(
    "text", [b"[]", b"1", b'{"facts": 1}', b'{"facts": {}, "files": {"a": "*"}}', b"\xff", b"[" * 9999]
)
def test_nothing_else_is_read(text: bytes) -> None:
    assert same_files._read(text) is None
