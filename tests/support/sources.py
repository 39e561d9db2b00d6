"""The package's own source, each file parsed once in a process, for tests of its rules."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

import symscrew

PACKAGE = Path(symscrew.__file__).parent
FILES = tuple(sorted(PACKAGE.rglob("*.py")))


@cache
def parsed(path: Path) -> ast.Module:
    """The syntax tree of a file."""
    return ast.parse(path.read_text())


@cache
def nodes(path: Path) -> tuple[ast.AST, ...]:
    """Every node of a file."""
    return tuple(ast.walk(parsed(path)))


def name_of(path: Path) -> str:
    """A file's path within the package."""
    return str(path.relative_to(PACKAGE))
