"""Rules of the house for every function and number: few positional arguments, no number without its reason."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import symscrew

PACKAGE = Path(symscrew.__file__).parent
FILES = sorted(PACKAGE.rglob("*.py"))
POSITIONAL = 4  # more than these cannot be read at the place of a call
LINES = 65  # of a function; most have fewer than 20


def name_of(path: Path) -> str:
    return str(path.relative_to(PACKAGE))


def functions(path: Path) -> Iterator[ast.FunctionDef]:
    yield from (node for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.FunctionDef))


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_functions_take_few_positional_arguments_and_fit_a_screen(path: Path) -> None:
    for node in functions(path):
        taken = [a.arg for a in (*node.args.posonlyargs, *node.args.args) if a.arg not in ("self", "cls")]
        assert len(taken) <= POSITIONAL, f"{name_of(path)}: {node.name}({', '.join(taken)}): what can be a keyword?"
        assert (node.end_lineno or 0) - node.lineno < LINES, f"{name_of(path)}: {node.name} is several functions"


def is_number(node: ast.expr | None) -> bool:
    if isinstance(node, ast.UnaryOp):
        return is_number(node.operand)
    if isinstance(node, ast.BinOp):
        return is_number(node.left) and is_number(node.right)
    return isinstance(node, ast.Constant) and type(node.value) in (int, float)


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_every_number_has_its_reason_beside_it(path: Path) -> None:
    """A constant of a module, one number or several at once, has a comment on its line or a text below it.

    Or a comment stands above it, or above the lines of constants that it is one of.
    """
    lines = path.read_text().splitlines()
    body = ast.parse(path.read_text()).body
    for node, below in zip(body, [*body[1:], None], strict=True):
        if not isinstance(node, ast.Assign | ast.AnnAssign):
            continue
        values = node.value.elts if isinstance(node.value, ast.Tuple) else [node.value]
        if not values or not all(is_number(value) for value in values):
            continue
        if not isinstance(node.targets[0] if isinstance(node, ast.Assign) else node.target, ast.Name | ast.Tuple):
            continue
        above = node.lineno - 2
        while re.match(r"[A-Z_0-9]+ = ", lines[above]):
            above -= 1
        said = "#" in lines[(node.end_lineno or 0) - 1] or lines[above].startswith("#")
        text = (
            isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant) and isinstance(below.value.value, str)
        )
        assert said or text, f"{name_of(path)}, line {node.lineno}: {lines[node.lineno - 1]}  (why this number?)"
