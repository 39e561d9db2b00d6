"""What `import symscrew` gives: every public name is explained on the package's page, resolves, and has its type."""

from __future__ import annotations

import ast
import inspect
import os
import pydoc
import re
import subprocess
import sys
from pathlib import Path

import pytest

import symscrew

PACKAGE = Path(symscrew.__file__).parent
USER = """
import symscrew

mechanism = symscrew.load_catalogue("four_bar")
model = symscrew.derive(mechanism)
reveal_type(model)
reveal_type(mechanism)
reveal_type(symscrew.load(model))
reveal_type(symscrew.simulate(symscrew.load_scene("scene.toml")))
reveal_type(symscrew.analyse_mobility(mechanism))
symscrew.derive("four_bar")
"""


def explained() -> dict[str, str]:
    """Name -> how it is written, of every name that the docstring of the package explains in a line."""
    text = (inspect.getdoc(symscrew) or "").partition("The names")[2].partition("The map:")[0]
    lines = re.findall(r"^    ((\w+)(?:\(.*?\))?) {2,}\S", text, re.M)
    assert len({name for _, name in lines}) == len(lines), "a name is explained twice"
    return {name: written for written, name in lines}


def test_every_public_name_is_explained_and_nothing_else() -> None:
    assert sorted(explained()) == sorted(symscrew.__all__) == sorted(dir(symscrew))


@pytest.mark.parametrize("name", symscrew.__all__)
def test_public_names_resolve_to_what_documents_itself(name: str) -> None:
    found = getattr(symscrew, name)
    if name == "__version__":
        assert re.fullmatch(r"\d+\.\d+\.\d+", found)
    else:
        assert len(inspect.getdoc(found) or "") > 20


@pytest.mark.parametrize("name", [name for name, written in explained().items() if "(" in written])
def test_names_can_be_called_as_the_page_shows(name: str) -> None:
    call = ast.parse(explained()[name], mode="eval").body
    assert isinstance(call, ast.Call) and not call.keywords
    inspect.signature(getattr(symscrew, name)).bind(*call.args)


def test_the_page_shows_the_flow_the_names_and_the_map() -> None:
    page = pydoc.plain(pydoc.render_doc(symscrew))
    for part in (
        "model = symscrew.derive(mechanism) ",
        'load_catalogue("four_bar")        -> Mechanism',
        "    kinematics      spanning tree",
    ):
        assert part in page
    assert page.index("symscrew.generate(") < page.index("The names") < page.index("The map:") < page.index("FUNCTIONS")


def test_an_unknown_name_is_said_with_those_that_exist() -> None:
    with pytest.raises(AttributeError, match=r"no attribute 'derrive'; known: .*derive"):
        symscrew.derrive  # type: ignore[attr-defined]  # noqa: B018


@pytest.mark.slow
def test_type_checkers_see_what_the_names_are(tmp_path: Path) -> None:
    pytest.importorskip("mypy", reason='not installed: pip install "symscrew[lint]"')
    (tmp_path / "user.py").write_text(USER)
    command = [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", "--cache-dir=cache", "user.py"]
    environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    notes = re.findall(r'^user.py:\d+: note: Revealed type is "symscrew[\w.]*\.(\w+)"', done.stdout, re.M)
    assert notes == ["Model", "Mechanism", "CompiledModel", "Run", "Mobility"], done.stdout
    errors = re.findall(r"^user.py:(\d+): error: .*\[([\w-]+)\]$", done.stdout, re.M)
    assert errors == [(str(len(USER.splitlines())), "arg-type")], done.stdout  # a text is no mechanism; all else fits
