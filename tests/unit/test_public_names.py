"""What `import symscrew` gives: every public name is explained on the package's page, resolves, and has its type."""

from __future__ import annotations

import ast
import inspect
import pydoc
import re
from pathlib import Path

import pytest

import symscrew

PACKAGE = Path(symscrew.__file__).parent


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
