"""How the Python targets, NumPy and JAX, write constants and long statements."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from symscrew.export.constants import Writing
from symscrew.export.listing import LINE, code_lines, decimal, wrapped

BEHIND = "  # "  # what begins a comment behind a statement


def python_writing(taken: Collection[str]) -> Writing:
    """Constants of a module, each an assignment; `taken`: names that the module has for something else."""
    return Writing(decimal, "{name} = {number}  ", ("# ", "# ", ""), taken=taken)


def python_lines(statements: Iterable[str], indent: str) -> list[str]:
    """Assignments, each perhaps with a comment behind it, and headings; long ones in parentheses over several lines.

    >>> python_lines([f"total = {'mass * ' * 20}height  # arm"], "    ")[::2]
    ['    total = (', '    )  # arm']
    """
    found = []
    for text in statements:
        if len(indent) + len(text) <= LINE:
            found.append(indent + text)
        elif text.startswith("#"):
            found += wrapped(text, first=indent, later=f"{indent}# ", width=LINE)
        else:
            code, mark, said = text.partition(BEHIND)
            name, _, value = code.partition(" = ")
            inner = code_lines(value, first=f"{indent}    ", later="")
            found += [f"{indent}{name} = (", *inner, f"{indent}){mark}{said}"]
    return found
