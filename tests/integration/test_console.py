"""What the command line shows where: colours on a terminal, Markdown in a pipe, what to do about what is missing."""

from __future__ import annotations

import io
import json
import os
import random
import re
import shlex
import shutil
import subprocess
import sys

import pytest

from symscrew.cli.help import UsageError
from symscrew.cli.parser import main
from symscrew.cli.shared_options import settings
from symscrew.display import terminal
from symscrew.studies.workspace import sweep_summary_text

HEADER, ROWS = ("part", "n"), [["seed", "2"], ["tool", "not found"]]


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def shown(monkeypatch: pytest.MonkeyPatch, **environment: str) -> str:
    stream = Terminal()
    monkeypatch.setattr(sys, "stdout", stream)
    for name in ("NO_COLOR", "TERM", "COLUMNS"):
        monkeypatch.delenv(name, raising=False)
    for name, value in {"TERM": "xterm-256color", "COLUMNS": "60", **environment}.items():
        monkeypatch.setenv(name, value)
    terminal.print_table(HEADER, ROWS)
    return stream.getvalue()


def test_terminal_has_colours(monkeypatch: pytest.MonkeyPatch) -> None:
    text = shown(monkeypatch)
    assert "\x1b[31mnot found" in text
    plain = re.sub(r"\x1b\[[\d;]*m", "", text)
    assert [line.split() for line in plain.splitlines() if "seed" in line] == [["seed", "2"]]


@pytest.mark.parametrize("environment", [{"NO_COLOR": "1"}, {"TERM": "dumb"}])
def test_no_colours_where_they_are_not_wanted(environment: dict[str, str], monkeypatch: pytest.MonkeyPatch) -> None:
    assert shown(monkeypatch, **environment) == terminal.aligned_table(HEADER, ROWS) + "\n"


def test_a_narrow_terminal_breaks_no_name_and_no_command(monkeypatch: pytest.MonkeyPatch) -> None:
    header = ("part", "found", "for", "to get it")
    rows = [
        ["three_ups_upu_s_physical", "not found", "a tool that is needed now and then, in words", 'pip install "a[b]"']
    ]
    for columns in (40, 60, 79, 120):
        stream = Terminal()
        monkeypatch.setattr(sys, "stdout", stream)
        for name, value in {"TERM": "xterm-256color", "COLUMNS": str(columns)}.items():
            monkeypatch.setenv(name, value)
        monkeypatch.delenv("NO_COLOR", raising=False)
        terminal.print_table(header, rows)
        plain = re.sub(r"\x1b\[[\d;]*m", "", stream.getvalue())
        assert max(map(len, plain.splitlines())) <= columns and "\u2026" not in plain
        assert "three_ups_upu_s_physical" in plain and 'pip install "a[b]"' in plain


@pytest.mark.parametrize("command", [["list"], pytest.param(["doctor"], marks=pytest.mark.slow)])
def test_tables_fit_sixty_columns(command: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    stream = Terminal()
    monkeypatch.setattr(sys, "stdout", stream)
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.setenv("COLUMNS", "60")
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert main(command) == 0
    assert max(len(line) for line in re.sub(r"\x1b\[[\d;]*m", "", stream.getvalue()).splitlines()) <= 60


@pytest.mark.parametrize("columns", ["no number", "120"])
def test_a_pipe_gets_plain_text_in_sixty_columns_or_as_many_as_there_are(
    columns: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Markdown where it fits; else paragraphs, in which names are whole."""
    monkeypatch.setenv("COLUMNS", columns)
    monkeypatch.setattr(os, "get_terminal_size", _no_terminal)
    assert main(["list"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "\x1b" not in "".join(lines)
    assert max(map(len, lines)) <= (120 if columns == "120" else 60)
    assert lines[0].startswith("| name ") == (columns == "120")
    assert columns == "120" or "three_ups_upu_s_physical" in lines


def test_a_pager_has_the_width_of_the_terminal_that_shows_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """The standard output of `symscrew list | less` is no terminal, but that of errors is."""
    monkeypatch.delenv("COLUMNS", raising=False)
    screen = sys.__stderr__.fileno()
    monkeypatch.setattr(
        os, "get_terminal_size", lambda of: os.terminal_size((97, 30)) if of == screen else _no_terminal()
    )
    assert terminal.console_width() == 97


def _no_terminal(*_: object) -> os.terminal_size:
    raise OSError("no terminal")


@pytest.mark.parametrize("seed", range(30))
def test_a_fitting_table_loses_no_word_and_breaks_none(seed: int) -> None:
    draw = random.Random(seed)
    header, *rows = [
        [" ".join("x" * draw.randint(1, 9) + str(draw.randint(0, 99)) for _ in range(draw.randint(k == 0, 4)))
         for k in range(4)] for _ in range(6)]  # fmt: skip
    wide = draw.randint(50, 130)
    text = terminal.fitting_table(header, rows, wide)
    words = sorted(re.sub(r"[|:,]|--+", " ", text).split())
    assert max(map(len, text.splitlines())) <= wide
    if text.startswith("|"):
        assert words == sorted(" ".join(" ".join(row) for row in (header, *rows)).split())
    else:
        assert set(" ".join(" ".join(row) for row in rows).split()) <= set(words)


def test_a_map_in_sixty_columns_has_no_noise_and_stays_a_table(monkeypatch: pytest.MonkeyPatch) -> None:
    """Rounding beside the largest value of its unit is zero; the head of the first column is broken before names."""
    values = {
        "point E.x": (-6.759e-33, 1.757e-31, "m"), "point E.y": (0, 0.547767, "m"), "margin": (1e-14, 0.5, "1"),
        "drive limb1_P2": (-1.83756e-16, 1.02602e-16, "N"), "drive limb2_P2": (-158.535, -9.6e-16, "N"),
    }  # fmt: skip
    ranges = {name: {"least": a, "largest": b, "unit": unit} for name, (a, b, unit) in values.items()}
    monkeypatch.setenv("COLUMNS", "60")
    found = {"mechanism": "a", "cases": 3, "reached": 3, "regular": 3, "allowed": 3, "axes": {}, "ranges": ranges}
    lines = sweep_summary_text(found).splitlines()[3:]  # of the table
    assert max(map(len, lines)) <= 60 and not any("e-" in line for line in lines)
    assert [cell.strip() for cell in lines[-2].split("|")] == ["", "drive limb1_P2", "0", "0", "0", "N", ""]
    assert lines[-1].split("|")[2].strip() == "-158.535"


def test_a_map_says_angles_as_they_are_typed_and_no_rounding() -> None:
    """Axes with units; forces of a mechanism that carries none are compared with its weight, spans with their ends."""
    ranges = {"drive a": {"least": -1.1e-15, "largest": 2e-15, "unit": "N"},
              "slide": {"least": 0.3 - 2e-16, "largest": 0.3 + 2e-16, "unit": "m"}}  # fmt: skip
    axes = {"tilt": [0, 0.3490658503988659, 5], "R": [0.75, 0.85, 3], "ratio": [1, 2, 2]}
    found = {"mechanism": "a", "cases": 30, "reached": 30, "regular": 30, "allowed": 30, "weight": 100.0, "axes": axes,
             "axis_units": {"tilt": "rad", "R": "m", "ratio": "1"}, "ranges": ranges}  # fmt: skip
    lines = sweep_summary_text(found).splitlines()
    assert lines[0] == "a: 30 cases: tilt 0 to 20 deg (5), R 0.75 to 0.85 m (3), ratio 1 to 2 (2)"
    cells = [[cell.strip() for cell in line.split("|")[2:5]] for line in lines if line.startswith(("| drive", "| sli"))]
    assert cells == [["0", "0", "0"], ["0.3", "0.3", "0"]]


def test_settings_stand_apart_or_between_commas() -> None:
    assert settings("at", ["tilt=10deg,azimuth = 30deg", "turn=30deg about 1,1,0", "limb1_P=-1mm, x=2"]) == {
        "tilt": "10deg", "azimuth": "30deg", "turn": "30deg about 1,1,0", "limb1_P": "-1mm", "x": "2",
    }  # fmt: skip
    for given, said in (
        (["z=1", "z=2"], "'z' is given twice"),
        (["z"], "expected KEY=VALUE"),
        (["z=1,y="], "KEY=VALUE"),
    ):
        with pytest.raises(UsageError, match=f"--at: .*{said}"):
            settings("at", given)


def test_doctor_says_what_to_do(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    real = shutil.which
    monkeypatch.setattr(shutil, "which", lambda name: None if name == "valgrind" else real(name))
    assert main(["doctor", "--json"]) == 0
    rows = {row["part"]: row for row in json.loads(capsys.readouterr().out)}
    assert rows["valgrind"]["found"] == "not found" and rows["valgrind"]["to get it"] == "apt install valgrind"
    assert rows["casadi: ipopt"]["found"] == "yes" and rows["sympy"]["to get it"] == ""
    for row in rows.values():
        assert (row["found"] in terminal.MISSING) == bool(row["to get it"])


def test_completion() -> None:
    pytest.importorskip("argcomplete", reason='not installed: pip install "symscrew[completion]"')
    asked = {"_ARGCOMPLETE": "1", "COMP_LINE": "symscrew gen", "COMP_POINT": "12", "_ARGCOMPLETE_IFS": "\n"}
    code = "import sys, symscrew.cli.parser as c; sys.exit(c.main([]))"
    # the shell's side of the protocol: candidates come on descriptor 8, messages on 9
    line = f'{sys.executable} -c "{code}" 8>&1 9>/dev/null >/dev/null'
    done = subprocess.run(["bash", "-c", line], env={**os.environ, **asked}, capture_output=True, text=True)
    assert "generate" in done.stdout.split()


def test_words_are_folded_where_somebody_reads_them(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """At blanks, deeper than they began, no word lost; whole in a pipe, where programs search them."""
    monkeypatch.delenv("COLUMNS", raising=False)
    assert main(["mobility", "four_bar"]) == 0
    whole = capsys.readouterr().out
    assert max(map(len, whole.splitlines())) > 100
    monkeypatch.setenv("COLUMNS", "60")
    assert main(["mobility", "four_bar"]) == 0
    told = capsys.readouterr().out
    assert max(map(len, told.splitlines())) <= 60 and told.split() == whole.split()
    assert "\n      equations follow from the others" in told
    assert terminal.folded("| a b c d e |\n\n    aaaaaaaa bb", 6) == "| a b c d e |\n\n    aaaaaaaa\n      bb"


@pytest.mark.parametrize(("words", "code"), [("list >&-", 0), ("draw nothing --out a.png 2>&-", 2)])
def test_streams_that_are_closed_lead_nowhere(words: str, code: int) -> None:
    """A traceback came of a closed output, and errors among results of a closed error stream."""
    ran = subprocess.run(["sh", "-c", f"{shlex.quote(sys.executable)} -m symscrew {words}"], capture_output=True)
    assert (ran.returncode, ran.stdout, ran.stderr) == (code, b"", b"")
