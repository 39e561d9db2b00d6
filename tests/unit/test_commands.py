"""The command line: a command is one file and one line; files and libraries are read when somebody asks for them."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from symscrew import cli
from symscrew.cli import parser as table
from symscrew.cli.parser import COMMANDS, main

HEAVY = ("sympy", "casadi", "numpy", "scipy", "matplotlib", "rich")
COMMAND = """
import argparse

EXAMPLES = ("symscrew turns 720",)


def add_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("degrees", type=float, metavar="DEGREES", help="an angle")
    command.add_argument("--backwards", action="store_true", help="against the clock")


def run(options: argparse.Namespace) -> int:
    print(f"{options.degrees / (-360 if options.backwards else 360):g} turns")
    return 1 if options.degrees < 0 else 0
"""


@pytest.fixture
def another(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A further command, `symscrew turns`: one file, one line of the table."""
    (tmp_path / "turns_command.py").write_text(COMMAND)
    monkeypatch.setattr(cli, "__path__", [*cli.__path__, str(tmp_path)])
    monkeypatch.setitem(COMMANDS, "turns", ("turns_command", "how many turns an angle is"))
    yield
    sys.modules.pop("symscrew.cli.turns_command", None)


@pytest.mark.usefixtures("another")
def test_a_further_command_is_a_file_and_a_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["turns", "720", "--backwards"]) == 0
    assert capsys.readouterr().out == "-2 turns\n"
    assert main(["turns", "--backward", "-90"]) == 1
    assert capsys.readouterr().out == "0.25 turns\n"


@pytest.mark.usefixtures("another")
def test_a_further_command_has_help_and_errors_like_the_others(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["--help"])
    assert "    turns     how many turns an angle is\n" in capsys.readouterr().out
    with pytest.raises(SystemExit):
        main(["turns", "--help"])
    shown = capsys.readouterr().out
    assert "How many turns an angle is.\n" in shown and shown.endswith("examples:\n  symscrew turns 720\n")
    assert main(["turns", "1", "--backword"]) == 2
    assert "unknown option '--backword'; did you mean '--backwards'? See symscrew turns" in capsys.readouterr().err
    assert main(["turn"]) == 2 and "did you mean 'turns'?" in capsys.readouterr().err


def modules_after(*arguments: str) -> set[str]:
    """Modules that are there after a command line that ends with help or version, in a process of its own."""
    program = (
        "import sys, symscrew.cli.parser as c\n"
        f"for words in {[list(a.split()) for a in arguments]!r}:\n"
        "    try: c.main(words)\n"
        "    except SystemExit as end: assert not end.code\n"
        "print('modules:', *sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    return set(done.stdout.rpartition("modules:")[2].split())


def test_only_the_file_of_the_chosen_command_is_read() -> None:
    files = {f"symscrew.cli.{file}" for file, _ in COMMANDS.values()}
    assert len(files) == len(COMMANDS)
    assert not files & modules_after("--help", "--version")
    assert files & modules_after("check --help") == {"symscrew.cli.check_command"}


def test_help_of_no_command_waits_for_libraries() -> None:
    loaded = modules_after(*(f"{name} --help" for name in COMMANDS))
    assert {f"symscrew.cli.{file}" for file, _ in COMMANDS.values()} <= loaded
    assert not set(HEAVY) & loaded


def completions(line: str) -> set[str]:
    """What the shell offers after a line: candidates come on descriptor 8, messages on 9."""
    asked = {"_ARGCOMPLETE": "1", "COMP_LINE": line, "COMP_POINT": str(len(line)), "_ARGCOMPLETE_IFS": "\n"}
    code = "import sys, symscrew.cli.parser as c; sys.exit(c.main([]))"
    program = f'{sys.executable} -c "{code}" 8>&1 9>/dev/null >/dev/null'
    done = subprocess.run(["bash", "-c", program], env={**os.environ, **asked}, capture_output=True, text=True)
    return {word.strip() for word in done.stdout.split("\n") if word.strip()}


def test_completion_knows_commands_options_and_choices() -> None:
    pytest.importorskip("argcomplete", reason='not installed: pip install "symscrew[completion]"')
    assert {"draw", "doctor", "demo", "drives"} == completions("symscrew d")
    assert completions("symscrew generate --reg") == {"--regressor"}
    assert completions("symscrew generate four_bar --target cas") == {"casadi"}


def test_the_table_is_the_parser() -> None:
    commands = next(a for a in table.parser()._actions if a.choices and "list" in a.choices).choices
    assert list(commands) == list(COMMANDS)  # type: ignore[arg-type]


def test_help_of_assemble_tells_the_two_names_in_python_apart(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["assemble", "--help"])
    text = " ".join(capsys.readouterr().out.split())
    assert "symscrew.assembly_modes(mechanism) gives them all" in text
    assert "symscrew.assemble(model, {...}) is another thing: the one configuration near a guess" in text


def test_a_matplotlib_that_cannot_be_imported_is_said_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Installed, but built for another NumPy: a sentence with the cure, exit code 2; a page in 3-D needs none."""
    (tmp_path / "matplotlib").mkdir()
    (tmp_path / "matplotlib" / "__init__.py").write_text('raise ImportError("numpy.core.multiarray failed to import")')
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    drawn = subprocess.run(
        [sys.executable, "-m", "symscrew", "draw", "four_bar", "--out", str(tmp_path / "a.png")],
        env=environment, capture_output=True, text=True,
    )  # fmt: skip
    assert drawn.returncode == 2 and drawn.stderr.count("\n") == 1
    assert "cannot be imported ('numpy.core.multiarray failed to import'): pip install" in drawn.stderr
    imported = "from symscrew.cli.view_command import run; from symscrew.display import Progress, open_made, write_made"
    page = subprocess.run([sys.executable, "-c", imported], env=environment, capture_output=True, text=True)
    assert page.returncode == 0, page.stderr


OF_SEVERAL = [
    (name, action.option_strings[-1], action.choices)
    for name, command in table.parser()._subparsers._group_actions[0].choices.items()  # type: ignore[union-attr]
    for action in (command.read_command() or command)._actions
    if action.nargs == "+" and action.option_strings
]


@pytest.mark.parametrize(("name", "option", "choices"), OF_SEVERAL)
def test_what_is_given_twice_is_not_lost(name: str, option: str, choices: tuple[str, ...] | None) -> None:
    """Values of both times, and none of the default's."""
    first, second = list(choices)[:2] if choices else ("a=1", "b=2")
    made = table.parser()._subparsers._group_actions[0].choices[name]  # type: ignore[union-attr,index]
    made.read_command()
    for action in made._actions:
        action.required = False
    found, _ = made.parse_known_args([option, first, option, second])
    assert getattr(found, option.strip("-").replace("-", "_")) == [first, second]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("draw four_bar --out=--", "argument --out: expected a value, got '--'"),
        ("new a --limbs=--", "argument --limbs: expected a value, got '--'"),
        ("drives four_bar --motion A=t --motion A=2*t --duration 1", "--motion: A is given twice"),
        ("optimise own.toml --out a.npz --rate=inf", "--rate: expected samples per second above 0, got inf"),
        ("mobility four_bar --expect -1", "--expect: expected a number from 0 on, got -1"),
        ("assemble four_bar --expect -1", "--expect: expected a number from 0 on, got -1"),
        ("mobility four_bar --proof own.toml", "--proof: expected a file name that ends in .json, got 'own.toml'"),
        ("generate four_bar --out nowhere/in", "--out: a link that leads nowhere: "),
    ],
)
def test_options_that_cannot_be(
    line: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "own.toml").write_text("mine")
    (tmp_path / "nowhere").symlink_to("none")
    assert main(line.split()) == 2
    told = capsys.readouterr()
    assert said in told.err and told.err.count("\n") == 1 and not told.out
    assert (tmp_path / "own.toml").read_text() == "mine"
