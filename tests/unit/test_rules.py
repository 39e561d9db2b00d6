"""Rules of the house for every function and number: few positional arguments, no number without its reason."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from support.sources import FILES, name_of, nodes, parsed

POSITIONAL = 4  # more than these cannot be read at the place of a call
LINES = 65  # of a function; most have fewer than 20


def test_functions_take_few_positional_arguments_and_fit_a_screen() -> None:
    assert [fault for path in FILES for fault in faults_of_functions(path)] == []


def faults_of_functions(path: Path) -> Iterator[str]:
    for node in nodes(path):
        if not isinstance(node, ast.FunctionDef):
            continue
        taken = [a.arg for a in (*node.args.posonlyargs, *node.args.args) if a.arg not in ("self", "cls")]
        if len(taken) > POSITIONAL:
            yield f"{name_of(path)}: {node.name}({', '.join(taken)}): what can be a keyword?"
        if (node.end_lineno or 0) - node.lineno >= LINES:
            yield f"{name_of(path)}: {node.name} is several functions"


def is_number(node: ast.expr | None) -> bool:
    if isinstance(node, ast.UnaryOp):
        return is_number(node.operand)
    if isinstance(node, ast.BinOp):
        return is_number(node.left) and is_number(node.right)
    return isinstance(node, ast.Constant) and type(node.value) in (int, float)


def test_every_number_has_its_reason_beside_it() -> None:
    assert [number for path in FILES for number in numbers_without_a_reason(path)] == []


def numbers_without_a_reason(path: Path) -> Iterator[str]:
    """A constant of a module, one number or several at once, has a comment on its line or a text below it.

    Or a comment stands above it, or above the lines of constants that it is one of.
    """
    lines = path.read_text().splitlines()
    body = parsed(path).body
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
        if not (said or text):
            yield f"{name_of(path)}, line {node.lineno}: {lines[node.lineno - 1]}  (why this number?)"
