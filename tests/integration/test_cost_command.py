"""`symscrew cost`: the bill of effects from the command line."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from support.cranked_scene import SCENE
from support.effect_oracles import CRANK, effect

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.model import derive
from symscrew.reporting.blocks import Text
from symscrew.reporting.sections import _size
from symscrew.runtime.compiled import find_compiler
from symscrew.studies import Times
from symscrew.studies.bill_of_effects import bill, bill_figure, bill_table


@pytest.mark.slow
@pytest.mark.skipif(find_compiler() is None, reason="no C compiler: nothing is timed")
def test_timed_side_by_side() -> None:
    found = bill(catalogue.load(CRANK), [Gravity(), effect("ViscousFriction", "slider_P", 2)])
    assert all(value is not None and value > 0 for value in found.nanoseconds.values())
    assert all(np.isfinite(value) for item in found.items for value in item.nanoseconds.values())


@pytest.mark.slow
def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "cranked.toml"
    scene.write_text(SCENE)
    assert main(["cost", str(scene), "--no-timing", "--json", "--plot", str(tmp_path / "bill.png")]) == 0
    values = json.loads(capsys.readouterr().out)
    assert values["items"][0]["operations"] == {"inverse_dynamics": 1, "forward_dynamics": 1}
    assert (tmp_path / "bill.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["nowhere.toml"], "cannot be read"),
        (["empty.toml"], "names no effects"),
        (["scene.toml", "--plot", "bill.pdf"], ".png"),
        (["scene.toml", "--plot", "nowhere/bill.png"], "no folder"),
    ],
)
def test_bad_input_ends_in_one_line(
    arguments: list[str],
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("empty.toml").write_text(SCENE[: SCENE.index("[[effects]]")])
    Path("scene.toml").write_text(SCENE)
    assert main(["cost", *arguments]) == 2
    error = capsys.readouterr().err.splitlines()[-1]
    assert error.startswith("symscrew: error: ") and message in error
    assert sorted(p.name for p in tmp_path.iterdir()) == ["empty.toml", "scene.toml"]


def test_a_table_and_a_picture_without_times() -> None:
    found = bill(catalogue.load(CRANK), [Gravity()], timed=False)
    assert any(row[0].startswith("gravity") for row in bill_table(found)[1]) and len(bill_figure(found).axes) == 2
    with pytest.raises(DescriptionError, match="did you mean"):
        bill(catalogue.load(CRANK), [effect("ViscousFriction", "slidr_P", 1)], timed=False)


def test_without_a_compiler_it_is_said_why_nothing_is_timed(monkeypatch: pytest.MonkeyPatch) -> None:
    """By the bill of a scene and by a report that was asked for times; one that was not says nothing."""
    monkeypatch.setattr("symscrew.studies.bill_of_effects.find_compiler", lambda: None)
    mechanism = catalogue.load("slider_crank")
    said = "there is no C compiler here (apt install gcc)"
    assert any(said in note for note in bill(mechanism, [Gravity()]).notes)
    assert not any(said in note for note in bill(mechanism, [Gravity()], timed=False).notes)
    model = derive(mechanism)
    for times, told in (({}, True), (None, False), ({"energy": Times(1, 2, 1, 3, 41)}, False)):
        (text,) = [block.text for block in _size(model, times) if isinstance(block, Text)]
        assert (said in text) == told
