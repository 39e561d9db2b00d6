"""`symscrew assemble`: words, JSON, picture, errors in one line."""

from __future__ import annotations

import json

import pytest

from symscrew.cli import main


def test_json_says_what_words_say(capsys, tmp_path):
    assert main(["assemble", "four_bar", "--json", "--picture", str(tmp_path / "modes.png")]) == 0
    values = json.loads(capsys.readouterr().out)
    assert main(["assemble", "four_bar"]) == 0
    words = capsys.readouterr().out
    assert values["complete"] == "proved" and "complete, proved: as many certified" in words
    assert [mode["name"] for mode in values["modes"]] == ["home", "-1"]
    assert all(mode["certified"] and mode["residual"] < 1e-13 for mode in values["modes"])
    assert values["modes"][1]["signs"] == {"drives locked": "-"}
    assert (tmp_path / "modes.png").read_bytes()[:4] == b"\x89PNG"


def test_what_is_expected_decides_on_the_exit_code():
    assert main(["assemble", "four_bar", "--expect", "2"]) == 0
    assert main(["assemble", "four_bar", "--expect", "3"]) == 1


def test_drives_that_cannot_be_reached_have_no_modes(capsys):
    assert main(["assemble", "slider_crank", "--at", "slider_P=9", "--json"]) == 0
    values = json.loads(capsys.readouterr().out)
    assert values["modes"] == [] and values["paths"]["complex"] == 2


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["four_bar", "--drives", "crank=1"], "no driven coordinate of this name"),
        (["four_bar", "--at", "A=0.1", "--drives", "A=0.2"], "A is given twice"),
        (["four_bar", "--drives", "A"], "expected KEY=VALUE"),
        (["four_bar", "--at", "nothing=1"], "no parameter or coordinate of this name"),
        (["differential", "--at", "C=0.1"], "can still move"),
        (["five_bar", "--at", "base_left=0"], "can still move"),
        (["four_bar", "--picture", "modes.txt"], "expected a file name that ends in"),
    ],
)
def test_bad_input_is_one_line(words, text, capsys):
    assert main(["assemble", *words]) == 2
    error = capsys.readouterr().err
    assert text in error and len(error.splitlines()) == 1
