"""Rooms whose parts are imported when somebody first asks for them: heavy libraries are paid for by who uses them.

from typing import TYPE_CHECKING
if TYPE_CHECKING:
    from symscrew.display.plots import save_figure     # what editors and type checkers see ...
__all__ = ["save_figure"]
__getattr__ = doors(__name__)                          # ... is what opens at run time
"""

from __future__ import annotations

import ast
import importlib.util
from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any


def doors(room: str) -> Callable[[str], Any]:
    """The `__getattr__` of a folder (PEP 562): a name is imported from the part that holds it.

    Where it is, the imports under `TYPE_CHECKING` in the folder's own `__init__` say, and nothing else.

    Args:
        room: `__name__` of the folder.
    """

    def opened(name: str) -> Any:
        of = _imports(room)
        if name not in of:
            raise AttributeError(f"module {room!r} has no attribute {name!r}; known: {', '.join(sorted(of))}")
        module, inside = of[name]
        return getattr(import_module(module), inside)

    return opened


@cache
def _imports(room: str) -> dict[str, tuple[str, str]]:
    """Module and name inside it of every name that a folder's `__init__` imports for type checkers."""
    spec = importlib.util.find_spec(room)
    source = getattr(spec.loader, "get_source", lambda _: None)(room) if spec else None
    assert source is not None, f"{room}: its source is needed to find its parts"
    blocks = [node for node in ast.parse(source).body if isinstance(node, ast.If)]
    found = [node for block in blocks for node in block.body if isinstance(node, ast.ImportFrom)]
    return {alias.asname or alias.name: (str(node.module), alias.name) for node in found for alias in node.names}
