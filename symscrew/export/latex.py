"""LaTeX and Markdown of SymPy matrices in the paper's notation: screws as columns (omega ; v) or (f ; m)."""

from __future__ import annotations

from collections.abc import Mapping

import sympy


def screw_latex(screw: sympy.MatrixBase, names: Mapping[sympy.Symbol, str] | None = None) -> str:
    r"""A screw of six entries as (omega ; v), the vector parts apart by a semicolon.

    >>> screw_latex(sympy.Matrix([0, 1, 0, sympy.Symbol("L"), 0, 0]))
    '\\begin{pmatrix} 0 & 1 & 0 & ; & L & 0 & 0 \\end{pmatrix}^{T}'
    """
    if screw.rows * screw.cols != 6:
        raise ValueError(f"expected a screw of 6 entries, got a matrix of {screw.rows} x {screw.cols}")
    entries = [_entry(entry, names) for entry in screw]
    parts = " & ".join([*entries[:3], ";", *entries[3:]])
    return rf"\begin{{pmatrix}} {parts} \end{{pmatrix}}^{{T}}"


def matrix_latex(matrix: sympy.MatrixBase, names: Mapping[sympy.Symbol, str] | None = None) -> str:
    """A matrix; one of six rows gets a line between the two vector parts of its screws."""
    rows = [" & ".join(_entry(matrix[i, j], names) for j in range(matrix.cols)) for i in range(matrix.rows)]
    lines = [row + r" \\" for row in rows[:-1]] + rows[-1:]
    if matrix.rows == 6:
        lines[2] += r" \hline"
    columns = "c" * matrix.cols
    return "\n".join([rf"\left(\begin{{array}}{{{columns}}}", *lines, r"\end{array}\right)"])


def markdown(name: str, latex: str) -> str:
    """An equation `name = latex` as a block of Markdown."""
    return f"$$\n{name} = {latex}\n$$\n"


def _entry(entry: sympy.Expr, names: Mapping[sympy.Symbol, str] | None) -> str:
    return str(sympy.latex(entry, symbol_names=dict(names or {})))
