"""Examples of the README.md beside generated code: their text, how they are run, what they print."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from support.model_states import model
from symscrew.export.readme import SHOWN


def example(directory: Path, title: str) -> tuple[str, str]:
    """The code under a title of README.md, and the command beside it."""
    text = (directory / "README.md").read_text()
    section = re.search(rf"^### {re.escape(title)}\n(.*?)(?=^### |\Z)", text, re.MULTILINE | re.DOTALL)
    assert section, title
    code = re.search(r"```\w+\n(.*?)```", section[1], re.DOTALL)
    command = re.search(r"^`([^`]+)`$", section[1], re.MULTILINE)
    return code[1], command[1] if command else ""


def expected(directory: Path) -> float:
    """The first result of the function that the examples show."""
    found = model(directory.name)
    known = [name for name in SHOWN if name in found.programs]
    name = min(known, key=lambda n: sum(port.size for port in found.programs[n].inputs))
    return float(found(name, *(array[:1] for array in found.test_inputs[name]))[0][0].ravel()[0])


def run(command: str, folder: Path) -> str:
    """The last output of commands that are joined by `&&`, without a shell, and compiled in a quarter of the time."""
    for part in command.replace(" -O2 ", " -O0 ").split(" && "):
        done = subprocess.run(part.split(), cwd=folder, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
    return done.stdout


def printed(text: str) -> float:
    return float(text.split(":")[-1])
