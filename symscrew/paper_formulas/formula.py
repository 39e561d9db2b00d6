"""What is printed: a name, what it is equal to in LaTeX, and what the code calls the same."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy
from sympy.printing.latex import LatexPrinter

DIGITS = 12  # of a number that is no short fraction or root: more than a page has, fewer than rounding leaves
DEGREE = 57.29577951308232  # of a radian
WHOLE = 1e-6  # of a degree by which an angle may be off a whole number: rounding of doubles
LONG_NUMBER = 24  # letters of an exact number that is still read at a glance


@dataclass(frozen=True)
class Formula:
    r"""An equation `name = latex`.

    `latex` holds numbers, symbols, names of formulas printed before it, sums, products, fractions, roots, powers,
    \times of vectors, and vectors as pmatrix; nothing else, so that a test can read it back. `code` says what the
    package calls the same: (kind, names).
    """

    name: str
    latex: str
    code: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The equation."""
        return f"{self.name} = {self.latex}"


@dataclass(frozen=True)
class Part:
    """A heading, a sentence or two, and equations below it."""

    title: str
    words: str
    formulas: tuple[Formula, ...] = ()
    symbols: Mapping[str, str] = field(default_factory=dict)
    """LaTeX of symbols that appear here first -> what they are, with units."""


class PositiveFirst(LatexPrinter):  # type: ignore[misc]
    r"""LaTeX of sums that begin with a term without a minus where they have one: `R - r`, as one writes it.

    >>> R, r = sympy.symbols("r_a r_b")
    >>> PositiveFirst().doprint(r - R)
    'r_{b} - r_{a}'
    """

    def _as_ordered_terms(self, expression: sympy.Expr, order: str | None = None) -> list[sympy.Expr]:
        terms = list(super()._as_ordered_terms(expression, order=order))
        first = next((k for k, term in enumerate(terms) if not term.could_extract_minus_sign()), 0)
        return [terms[first], *terms[:first], *terms[first + 1 :]]


def latex_of(expression: sympy.Expr, names: Mapping[sympy.Symbol, str]) -> str:
    """LaTeX of an expression; numbers of many digits as decimals."""
    shown = expression
    numbers = {n: _decimal(n) for n in _numbers(shown) if len(str(n)) > LONG_NUMBER}
    printer = PositiveFirst({"symbol_names": dict(names), "fold_short_frac": False, "full_prec": False})
    return str(printer.doprint(shown.xreplace(numbers)))


def _numbers(expression: sympy.Expr) -> set[sympy.Expr]:
    """Largest parts without symbols."""
    if expression.is_number:
        return {expression}
    return {number for arg in expression.args for number in _numbers(arg)}


def _decimal(number: sympy.Expr) -> sympy.Expr:
    return sympy.Float(str(sympy.N(number, DIGITS + 3)), DIGITS)


def degrees(angle: float) -> str:
    """An angle [degrees] from 0 to 360 as text.

    >>> degrees(-120.0000000001), degrees(12.5)
    ('240', '12.500000000')
    """
    whole = round(angle) % 360
    return str(whole) if abs(angle - round(angle)) < WHOLE else f"{angle % 360:.9f}"


def index_of(limb: int, k: int) -> str:
    """The index of the k-th freedom (from 0) of a limb, in braces.

    >>> index_of(1, 2), index_of(1, 9), index_of(12, 0)
    ('{13}', '{1,10}', '{12,1}')
    """
    return f"{{{limb}{k + 1}}}" if k < 9 and limb < 10 else f"{{{limb},{k + 1}}}"


def vector_latex(vector: sympy.MatrixBase, names: Mapping[sympy.Symbol, str]) -> str:
    """A column of three, or of six with its parts apart."""
    rows = [latex_of(entry, names) for entry in vector]
    return r"\begin{pmatrix} " + r" \\ ".join(rows) + r" \end{pmatrix}"
