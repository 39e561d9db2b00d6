"""The documentation: links lead somewhere, blocks of code run, names of the reference exist."""

from __future__ import annotations

import re
import shlex
from importlib import import_module
from pathlib import Path

import pytest
from support.documentation import DOCS, PAGES, ROOT, identity

from symscrew.cli.parser import COMMANDS, main, parser

BLOCK = re.compile(r"^```(\w+)(?: title=\"([\w.]+)\")?\n(.*?)^```", re.M | re.S)
CODE = [p for p in PAGES if BLOCK.search(p.read_text())]


@pytest.mark.parametrize("page", PAGES, ids=identity)
def test_links(page: Path) -> None:
    text = BLOCK.sub("", page.read_text())
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if not target.startswith(("http://", "https://", "#")):
            assert (page.parent / target.partition("#")[0]).resolve().is_file(), target


def test_every_page_is_in_the_navigation() -> None:
    listed = re.findall(r"[\w/]+\.md", (ROOT / "mkdocs.yml").read_text())
    assert sorted(listed) == sorted(identity(p) for p in PAGES)


SLOW = (
    "tutorial.md",
    "theory.md",
    "how_to/arrays.md",
    "how_to/casadi.md",
    "how_to/drives.md",
    "how_to/own_effect.md",
    "how_to/results.md",
    "how_to/robots.md",
    "how_to/which_function.md",
    "how_to/workspace.md",
    "how_to/own_mechanism.md",
    "how_to/many_runs.md",
    "how_to/linuxcnc.md",
    "how_to/modelica.md",
    "how_to/plc.md",
    "how_to/ros2_control.md",
    "how_to/optimise.md",
    "how_to/assembly_modes.md",
    "reference/coordinates.md",
)


@pytest.mark.parametrize(
    "page", [pytest.param(p, marks=[pytest.mark.slow] * (identity(p) in SLOW), id=identity(p)) for p in CODE]
)
def test_code_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Blocks in order, in one empty folder: those with a title are files, sh are commands, python a program."""
    monkeypatch.chdir(tmp_path)
    for language, title, code in BLOCK.findall(page.read_text()):
        if language == "toml" and title:
            Path(title).write_text(code)
        elif language == "sh":
            for line in code.splitlines():
                words = shlex.split(line)
                assert words[0] == "symscrew", line
                assert main(words[1:]) == 0, line
        elif language == "python" and title:
            Path(title).write_text(code)  # what else it needs says the test that runs it
        elif language == "python":
            exec(compile(code, f"{identity(page)}", "exec"), {"__name__": "__main__"})


@pytest.mark.parametrize("page", sorted((DOCS / "reference").glob("*.md")), ids=identity)
def test_reference_names_exist_and_are_documented(page: Path) -> None:
    text = page.read_text()
    found = re.findall(r"^::: ([\w.]+)(?:\n    options: \{members: \[([^\]]*)\]\})?", text, re.M)
    assert found
    for name, members in found:
        try:
            item = import_module(name)
        except ModuleNotFoundError:
            module, _, attribute = name.rpartition(".")
            item = getattr(import_module(module), attribute)
        assert item.__doc__
        for member in filter(None, members.split(", ")):
            assert getattr(item, member).__doc__


def commands() -> dict:
    return next(a for a in parser()._actions if a.choices and "list" in a.choices).choices


@pytest.mark.parametrize("verb", sorted(commands()))
def test_help_has_examples_that_parse(verb: str) -> None:
    examples = import_module(f"symscrew.cli.{COMMANDS[verb][0]}").EXAMPLES
    assert examples
    assert "examples:\n  " + examples[0] in commands()[verb].format_help()
    for line in examples:
        words = shlex.split(line.partition(" | ")[0].partition(" && ")[0])
        assert words[:2] == ["symscrew", verb]
        parser().parse_args(words[1:])
